"""The contacts, their meshes and materials, and the figures that finite elements and the library have of them."""
from __future__ import annotations

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import calculix  # noqa: E402
from contact_mesh import LENGTH, RATIO, Body, Section, Sizes, rail_body, wheel_body, zone_and_outside  # noqa: E402
from profile_surfaces import GAUGE, GAUGE_HEIGHT, RADIUS, TAPE_OFFSET, Rail, Wheel, library_figures  # noqa: E402

Array = Any
LOAD = 80e3  # N
MARGIN = 1.8  # mm across, between the contact that the library finds and the edge of the core
CANT = float(np.arctan(1 / 40))


@dataclass(frozen=True)
class Case:
    """Of the finest mesh; the others have 1.41 and 2 times as large elements. `across`: size by y, linear between."""

    title: str
    lateral: float
    across: tuple[tuple[float, float], ...]
    sizes: Sizes
    reach: float  # mm along the normal, of the control points of the lines inwards in the rail
    depth: float  # mm, of the fine zone
    corner: float  # mm: y below which elements count for the gauge corner
    wider: float = 1.7  # mm: how much farther across the core reaches if steel yields
    start: float = 0.4  # of the depth: where contact begins then; does not change the result, but whether the iteration converges


CASES = {
    "tread": Case("tread, y = 0", 0.0, ((740.0, 0.35), (744.0, 0.35), (747.0, 0.9), (756.0, 0.9), (759.0, 0.6)),
                  Sizes(0.45, 0.5, 1.35, 14.0), 16.0, 5.0, -np.inf),
    "lobes": Case("two lobes, y = 5 mm", 5.0, ((728.5, 0.2), (731.0, 0.7), (741.0, 0.55)), Sizes(0.5, 0.35, 1.35, 14.0), 9.0, 3.5, 731.0, 0.0,
                  0.2),
    "corner": Case("gauge corner, y = 6.2 mm", 6.2, ((0.0, 0.35),), Sizes(0.6, 0.35, 1.35, 14.0), 9.0, 4.0, np.inf, 0.0),
}
# And those with yielding steel alone, of meshes 0 and 1 (yield_stresses.json).
ALL_CASES = {
    **CASES,
    "inner": Case("tread, y = 3 mm", 3.0, ((0.0, 0.45),), Sizes(0.5, 0.45, 1.35, 14.0), 14.0, 5.0, -np.inf, 0.8),
    "field": Case("tread, y = -5 mm", -5.0, ((0.0, 0.55),), Sizes(0.45, 0.5, 1.35, 14.0), 16.0, 5.0, -np.inf, 0.8),
}
# Yield stress and linear hardening, MPa. `unyielding` is `plastic` with the same elements and steps, and a yield stress that nothing
# reaches: what is left between both is the steel's.
HARDENING = 210e3 * 21e3 / (210e3 - 21e3)
MATERIALS = {"elastic": None, "plastic": (500.0, HARDENING), "unyielding": (1e5, HARDENING)}
SHARES = (0.25, 0.5, 0.75, 1.0)  # of the load, the steps with plasticity
COARSER = {0: 2.8284, 1: 2.0, 2: 1.4142, 3: 1.0}


@dataclass
class Scene:
    keys: dict[str, Any]
    left: Any
    rail: Rail | None  # none: no rail of the library
    section: Section
    zone: tuple[float, float]  # arc of the rail
    half_length: float


def scene_of(lateral: float, **changes: Any) -> Scene:
    keys: dict[str, Any] = {"wheel": "S1002", "rail": "60E1", "back_to_back": 1360.0, "inclination": "1:40", "lateral": lateral,
            "load_both": LOAD, "yaw": 0.0, **changes}
    result, left = library_figures(keys, "pressures", 1e-3)
    keys["roll"] = float(result["roll"])
    import wrcontact

    rail = Rail.placed(wrcontact.Profile(keys["rail"]), CANT, GAUGE, GAUGE_HEIGHT)
    section = Section(rail.y, rail.z, rail.angle)
    y, z, x = (np.concatenate([p.field(name)[p.field("pressure") > 0] for p in left.patches]) for name in "yzx")
    ends = section.arc_of(np.array([[y[i], z[i]] for i in (int(np.argmax(y)), int(np.argmin(y)))]))
    return Scene(keys, left, rail, section, (float(ends.min()), float(ends.max())), float(abs(x).max()))


def placed_wheel(keys: dict[str, Any], vertical: float) -> Wheel:
    import wrcontact

    wheel = Wheel.placed(wrcontact.Profile(keys["wheel"]), RADIUS, 0.5 * keys["back_to_back"] + TAPE_OFFSET, keys["lateral"], 0.0,
                         keys["roll"])
    wheel.vertical = vertical
    return wheel


@dataclass
class Blocks:
    model: calculix.Model
    lower: Body
    upper: Body
    wheel: Wheel


def build(case: Case, scene: Scene, mesh: float, *, overlap: float, plastic: dict[str, str], increments: tuple[float, ...],
          wider: tuple[float, float] = (0.0, 0.0), **options: Any) -> Blocks:
    """`mesh`: factor of the sizes; `overlap`: how far the wheel is below its first touch at the beginning, mm; `wider`: how much farther
    the core reaches across and along, mm."""
    s = case.sizes
    sizes = Sizes(s.along * mesh, s.depth * mesh, s.growth**mesh**0.7, s.largest)
    zone = np.linspace(scene.zone[0] - MARGIN - wider[0], scene.zone[1] + MARGIN + wider[0], 2001)
    wanted = mesh * np.interp(scene.section.at(zone)[:, 0], *np.array(case.across).T)
    done = np.append(0.0, np.cumsum(np.diff(zone) / (0.5 * (wanted[1:] + wanted[:-1]))))
    count = RATIO * int(np.ceil(done[-1] / RATIO - 0.2))
    arcs = np.interp(np.linspace(0.0, done[-1], count + 1), done, zone)
    along = zone_and_outside((0.0, scene.half_length + 1.5 + wider[1]), sizes.along, sizes, (0.0, LENGTH))
    lines = [zone_and_outside((0.0, case.depth), sizes.depth, sizes, (0.0, end)) for end in (50.0, 60.0)]
    keys = scene.keys
    wheel = placed_wheel(keys, scene.left.vertical - overlap)
    lower = rail_body(scene.section, arcs, along, lines[0], sizes, CANT, case.reach)
    upper = wheel_body(wheel, scene.section, arcs, along, lines[1], sizes, 16.0, float(wheel.radius_at.place[-1]) - 6.0)
    return Blocks(model_of(lower, upper, 0.5 * LOAD, plastic, increments, options), lower, upper, wheel)


def model_of(lower: Body, upper: Body, load: float, plastic: dict[str, str], increments: tuple[float, ...],
             options: dict[str, Any]) -> calculix.Model:
    """Elements may touch on the core's surface, without its outermost row, whose nodes hang."""
    shift, first = len(lower.points), len(lower.elements)
    numbers = [lower.number, np.where(upper.number < 0, -1, upper.number + shift)]

    def used(table: Array) -> Array:
        return np.asarray(table[table >= 0])

    rows, columns = (max(key[a] for key in lower.surface) for a in (0, 1))
    slave = [e for (i, j), e in lower.surface.items() if 0 < i < rows and j < columns]
    hanging = lower.hanging + [(n + shift, [m + shift for m in masters], weights) for n, masters, weights in upper.hanging]
    fixed = {n for n, _, _ in hanging}
    no_x = np.concatenate([used(n[:, j, :-1]) for n in numbers for j in (0, -1)])
    return calculix.Model(
        nodes=np.concatenate([lower.points, upper.points]), elements=np.concatenate([lower.elements, upper.elements + shift]),
        lower_elements=first, clamped=used(numbers[0][:, :, -1]), moved=used(numbers[1][:, :, -1]),
        no_x=np.array([n for n in no_x if n not in fixed]), slave=np.array(slave),
        master=np.array([first + e for e in upper.surface.values()]), hanging=hanging, load=load, plastic=plastic,
        increments=increments, **options)


def blocks_of(name: str, mesh: int, material: str) -> tuple[Scene, Blocks]:
    """A calculation: wheel and rail have the same material. With a yield stress contact begins with a part of the depth, and elements have no
    incompatible modes, with which the iteration of CalculiX does not converge then."""
    case = ALL_CASES[name]
    scene = scene_of(case.lateral)
    law = MATERIALS[material]
    if law is None:
        return scene, build(case, scene, COARSER[mesh], overlap=scene.left.depth, plastic={}, increments=(1.0,))
    card = f"*PLASTIC, HARDENING=KINEMATIC\n{law[0]:.8g},0.\n{law[0] + 0.1 * law[1]:.8g},0.1"
    return scene, build(case, scene, COARSER[mesh], overlap=case.start * scene.left.depth, plastic={"LOWER": card, "UPPER": card},
                        increments=SHARES, wider=(case.wider, 2.72), kind="C3D8")
