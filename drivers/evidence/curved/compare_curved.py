#!/usr/bin/env python3
"""How often the library's stated total error covers the difference to curved contact.

Draws frictionless left wheels at random: all built-in profiles, cants of 1:40 and 1:20, 20 to 110 kN,
half of them on the tread, a quarter each at the gauge corner and on the flange. Each is solved along
the mean curve of both bodies (curved_contact.py) on two grids; the finer one is the truth, the
difference of the two its own error. The library solves it with accuracy of forces and of pressures,
and so finely that only the errors of its planes are left. All contacts of a wheel are on one curve.

    PYTHONPATH=build/release/python drivers/evidence/curved/compare_curved.py --write truth.json
    PYTHONPATH=build/release/python drivers/evidence/curved/compare_curved.py --truth truth.json

The second command solves by the library alone. Errors, relative: lateral force, and sum of the
patches' normal forces, over that sum; depth; moment about x over the force and the lateral semi-axis
of the pressures; pmax. A stated error covers a wheel if it is at least the largest of these (pmax
only with accuracy of pressures). The vertical force is prescribed, the longitudinal one 0.
"""
from __future__ import annotations

import argparse
import json
import sys
import warnings
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np

from curved_contact import Array, Contact, Rail, Wheel, solve_for_load

POISSON, YOUNG = 0.3, 210e3
MODULUS = YOUNG / (2 * (1 - POISSON**2))
RADIUS, GAUGE, GAUGE_HEIGHT, TAPE_OFFSET = 460.0, 1435.0, 14.0, 70.0
GRIDS = ((216, 33), (432, 49))  # odd: an element is where the pressure is largest along the rail
PLANE_ACCURACY = 1e-4  # leaves the error of the library's planes
PLACES = {"tread": (0.0, 0.15), "gauge corner": (0.15, 0.8), "flange": (0.8, 1.6)}
SHARES = {"tread": 0.5, "gauge corner": 0.25, "flange": 0.25}
QUANTITIES = ("lateral force", "normal force", "depth", "moment", "pmax")


def draw(random: np.random.Generator, wheels: list[str], rails: list[str]) -> dict[str, Any]:
    wheel = str(random.choice(wheels))
    return {"wheel": wheel, "rail": str(random.choice(rails)),
            "back_to_back": 1360.0 if wheel == "S1002" else 1353.0,
            "cant": str(random.choice(["1:40", "1:20"])), "lateral": random.uniform(-7, 9),
            "load_vertical": random.uniform(20e3, 110e3), "yaw": 0.0}


def place_of(wheel: Any) -> str:
    """By the direction of the force."""
    angle = abs(np.arctan2(wheel.pressure_force.y, wheel.pressure_force.z))
    return next((name for name, (low, high) in PLACES.items() if low <= angle < high), "none")


def library_figures(keys: dict[str, Any], accuracy_of: str, accuracy: float,
                    curved: str = "no") -> tuple[Any, Any]:
    import wrcontact

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wrcontact.ContactWarning)
        result = wrcontact.solve(**keys, side="left", accuracy_of=accuracy_of, accuracy=accuracy,
                                 poisson=POISSON, youngs_modulus=YOUNG, curved=curved)
        return result, result.left


def reference_of(patch: Any) -> Array:
    return np.array([patch.x, patch.y, patch.z])


def curved_contact(rail: Rail, wheel: Wheel, patches: Sequence[Any], grid: tuple[int, int], *,
                   height: float, modulus: float = MODULUS) -> Contact:
    """Around patches that the library has found, on the mean curve at this height."""
    wheel.vertical = height
    angles = [patch.plane_angle for patch in patches]
    angle = 0.5 * (min(angles) + max(angles))
    origin = np.array([0.0, *reference_of(patches[0])[1:]])
    u = np.concatenate([(patch.field("y").ravel() - origin[1]) * np.cos(angle)
                        + (patch.field("z").ravel() - origin[2]) * np.sin(angle)
                        for patch in patches])
    return Contact(rail, wheel, origin, angle, (u.min() - 1, u.max() + 1), grid, modulus)


def bodies(keys: dict[str, Any]) -> tuple[Rail, Wheel]:
    import wrcontact

    rail = Rail.placed(wrcontact.Profile(keys["rail"]), np.arctan(1 / float(keys["cant"][2:])),
                       GAUGE, GAUGE_HEIGHT)
    wheel = Wheel.placed(wrcontact.Profile(keys["wheel"]), RADIUS, 0.5 * keys["back_to_back"] + TAPE_OFFSET,
                         keys["lateral"], keys["yaw"], keys["roll"])
    return rail, wheel


def curved_figures(keys: dict[str, Any], left: Any, grid: tuple[int, int],
                   height: float | None = None) -> dict[str, Any]:
    """Of the wheel, as the library reports them; the moment is about the first patch's reference."""
    rail, wheel = bodies(keys)
    patches = list(left.patches)
    first = left.vertical - left.depth if height is None else height
    contact = curved_contact(rail, wheel, patches, grid, height=first)
    height = solve_for_load([contact], keys["load_vertical"], first, left.depth)
    places, forces = contact.on_rail, contact.row_forces()
    references = np.array([reference_of(patch) for patch in patches])
    nearest = np.argmin(np.linalg.norm(places[:, None, 1:] - references[:, 1:], axis=-1), axis=1)
    by_patch = [np.sum(forces[nearest == k], 0) for k in range(len(patches))]
    arms = places - references[0]
    total, amounts = np.sum(forces, 0), np.linalg.norm(forces, axis=1)
    spread = places - np.average(places, axis=0, weights=amounts)
    semi_axis = np.sqrt(5 * np.average(np.sum(spread**2, 1), weights=amounts))
    normal = float(sum(np.linalg.norm(force) for force in by_patch))
    bodies_differ = contact.force("rail") - contact.force("wheel")
    return {"lateral force": float(total[1]), "normal force": normal,
            "depth": left.vertical - height, "semi-axis": float(semi_axis), "height": height,
            "moment": float(np.sum(arms[:, 1] * forces[:, 2] - arms[:, 2] * forces[:, 1])),
            "pmax": float(contact.pressure.max()),
            "about": [float(value) for value in references[0][1:]],
            "bodies differ": float(np.linalg.norm(bodies_differ) / normal)}


def errors(found: dict[str, float], truth: dict[str, Any]) -> dict[str, float]:
    scales = {"lateral force": truth["normal force"], "normal force": truth["normal force"],
              "depth": truth["depth"], "pmax": truth["pmax"],
              "moment": truth["normal force"] * truth["semi-axis"]}
    return {name: (found[name] - truth[name]) / scales[name] for name in QUANTITIES}


def true_scene(keys: dict[str, Any], accuracy: float) -> dict[str, Any]:
    """A scene with its truth, and what the coarser grid has else."""
    result, left = library_figures(keys, "pressures", accuracy)
    keys = {**keys, "roll": float(result["roll"])}
    coarse = curved_figures(keys, left, GRIDS[0])
    truth = curved_figures(keys, left, GRIDS[1], coarse["height"])
    return {"keys": keys, "place": place_of(left), "truth": truth, "grid": errors(coarse, truth)}


def judge(scene: dict[str, Any], accuracy: float, curved: str = "no") -> None:
    """Adds what the library finds and states, by kind of accuracy."""
    keys, truth = scene["keys"], scene["truth"]
    for kind, of, sought in (("forces", "forces", accuracy), ("pressures", "pressures", accuracy),
                             ("planes", "pressures", min(accuracy, PLANE_ACCURACY))):
        _, left = library_figures(keys, of, sought, curved)
        first = left.patches[0]
        arm = [first.y - truth["about"][0], first.z - truth["about"][1]]
        force = left.pressure_force
        found = {"lateral force": force.y, "normal force": left.normal_force,
                 "depth": truth["depth"] + truth["height"] - (left.vertical - left.depth),
                 "moment": left.pressure_moment.x + arm[0] * force.z - arm[1] * force.y,
                 "pmax": left.pmax}
        scene[kind] = {"stated": left.error_estimate, "discretisation": left.discretisation_error,
                       "model": left.model_error, "errors": errors(found, truth)}
    scene["turn"] = max(patch.turn for patch in left.patches)
    scene["patches"], scene["lobes"] = len(left.patches), int(sum(p.lobes for p in left.patches))


def draw_scenes(count: int, seed: int, accuracy: float) -> list[dict[str, Any]]:
    import wrcontact

    random = np.random.default_rng(seed)
    wheels, rails = (wrcontact.standard_profiles(kind) for kind in ("wheel", "rail"))
    wanted = {place: round(share * count) for place, share in SHARES.items()}
    scenes: list[dict[str, Any]] = []
    while any(wanted.values()):
        keys = draw(random, wheels, rails)
        try:
            place = place_of(library_figures(keys, "forces", 1e-2)[1])
        except wrcontact.Error:  # off the rail
            continue
        if wanted.get(place, 0) == 0:
            continue
        wanted[place] -= 1
        try:
            scenes.append(true_scene(keys, accuracy))
        except ValueError as error:
            scenes.append({"keys": keys, "place": place, "failed": str(error)})
        print(f"{len(scenes)} of {count}", file=sys.stderr, flush=True)
    return scenes


def largest(scene: dict[str, Any], kind: str) -> tuple[float, str]:
    """The greatest error that the stated one has to cover, and of which quantity."""
    covered = QUANTITIES if kind == "pressures" else QUANTITIES[:-1]
    return max((abs(float(scene[kind]["errors"][name])), name) for name in covered)


def is_within(scene: dict[str, Any], kind: str) -> bool:
    return largest(scene, kind)[0] <= float(scene[kind]["stated"])


def table_of(scenes: list[dict[str, Any]]) -> str:
    """Markdown: shares and medians by place, and every scene that is not covered."""
    solved = [scene for scene in scenes if "failed" not in scene]
    rows = [("all", solved)] + [(place, [s for s in solved if s["place"] == place]) for place in PLACES]
    rows.append(("two lobes or more", [s for s in solved if s["lobes"] > 1]))
    lines = ["| accuracy of | place | scenes | within the stated error | stated / true, median | true, "
             "median | 95 % | worst | largest in |", "|---|---|---|---|---|---|---|---|---|"]
    for kind in ("forces", "pressures"):
        for name, some in rows:
            if not some:
                continue
            true = np.array([largest(s, kind)[0] for s in some])
            ratio = np.median([s[kind]["stated"] for s in some] / true)
            kinds = [largest(s, kind)[1] for s in some]
            most = max(QUANTITIES, key=kinds.count)
            share = 100 * np.mean([is_within(s, kind) for s in some])
            lines.append(f"| {kind} | {name} | {len(some)} | {share:.1f} % | {ratio:.1f} | {np.median(true):.1e} | "
                         f"{np.quantile(true, 0.95):.1e} | {true.max():.1e} | {most} |")
    lines += ["", "| error of | forces at the accuracy, median | 95 % | worst | planes alone, median | 95 % | "
              "worst | coarser grid, median | 95 % |", "|---|---|---|---|---|---|---|---|---|"]
    for quantity in QUANTITIES:
        cells = []
        for kind in ("forces", "planes"):
            values = np.abs([s[kind]["errors"][quantity] for s in solved])
            cells += [np.median(values), np.quantile(values, 0.95), values.max()]
        values = np.abs([s["grid"][quantity] for s in solved])
        cells += [np.median(values), np.quantile(values, 0.95)]
        lines.append(f"| {quantity} | " + " | ".join(f"{cell:.1e}" for cell in cells) + " |")
    lines += ["", "| not covered | scene | place | patches, lobes | turn | error | of | stated: discretisation, "
              "planes | grid |", "|---|---|---|---|---|---|---|---|---|"]
    for kind in ("forces", "pressures"):
        for scene in (s for s in solved if not is_within(s, kind)):
            error, name = largest(scene, kind)
            keys, of = scene["keys"], scene[kind]
            lines.append(
                f"| {kind} | {keys['wheel']} / {keys['rail']}, {keys['cant']}, y {keys['lateral']:.3f}, "
                f"{keys['load_vertical'] / 1e3:.1f} kN | {scene['place']} | {scene['patches']}, {scene['lobes']} | "
                f"{scene['turn']:.2f} | {error:.1e} | {name} | {of['discretisation']:.1e}, {of['model']:.1e} | "
                f"{abs(scene['grid'][name]):.1e} |")
    lines += [f"\nNot solved on a curve: {s['keys']}: {s['failed']}" for s in scenes if "failed" in s]
    return "\n".join(lines)


def text_of(scenes: list[dict[str, Any]]) -> str:
    """JSON, one scene a line, numbers to ten digits."""
    def short(value: Any) -> Any:
        if isinstance(value, dict):
            return {name: short(one) for name, one in value.items()}
        if isinstance(value, list):
            return [short(one) for one in value]
        return float(f"{value:.10g}") if isinstance(value, float) else value

    names = ("keys", "place", "truth", "grid", "failed")
    lines = [json.dumps(short({name: scene[name] for name in names if name in scene}))
             for scene in scenes]
    return "[\n" + ",\n".join(lines) + "\n]\n"


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--scenes", type=int, default=200)
    parser.add_argument("--seed", type=int, default=50)
    parser.add_argument("--accuracy", type=float, default=1e-3)
    parser.add_argument("--write", type=Path, help="file for the scenes and their truths, JSON")
    parser.add_argument("--curved", choices=("no", "yes", "auto"), default="no",
                        help="how the library solves the scenes (solve.curved)")
    parser.add_argument("--truth", type=Path, help="such a file, instead of solving along curves")
    options = parser.parse_args()
    if options.truth:
        scenes = json.loads(options.truth.read_text())
    else:
        scenes = draw_scenes(options.scenes, options.seed, options.accuracy)
    if options.write:
        options.write.write_text(text_of(scenes))
    for scene in scenes:
        if "failed" not in scene:
            judge(scene, options.accuracy, options.curved)
    print(table_of(scenes))
    return 0


if __name__ == "__main__":
    sys.exit(main())
