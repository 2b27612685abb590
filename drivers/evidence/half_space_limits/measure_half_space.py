#!/usr/bin/env python3
"""How far rail head and wheel rim are from half-spaces, where contacts are and over which distances.

    drivers/evidence/half_space_limits/measure_half_space.py --write influence.json
    drivers/evidence/half_space_limits/measure_half_space.py --read influence.json [--picture half_space.png]

The first command computes the influence of 60E1 and S1002 (prismatic_body.py); it takes some minutes on one core and needs numpy and
scipy. The second one prints the tables of docs/evidence/half-space.md, with three contacts from contacts.json, which commit be745a05
solved; it needs numpy, its picture matplotlib.

A patch is 2 mm wide and 10 mm long. Errors are those of the displacement by which a patch moves towards or away from another one when a unit
of force goes from one to the other, less the same of the operator, over the half-space's displacement A(d) at their distance d:
    e = (D - D') / A(d),    D = B(I, J) - (B(I, I) + B(J, J)) / 2,    D' likewise of the operator.
This decides how patches share a load; what moves both alike, a part of the body's rigid motion, does not enter. Positive: the operator
couples them too little. Operators: A, the half-space along the arc, and "curved", A times the cosine of the angle between both normals.
"""
from __future__ import annotations

import argparse
import json
import sys
import warnings
from pathlib import Path
from typing import Any

import numpy as np

Array = np.ndarray[Any, np.dtype[Any]]
HERE = Path(__file__).resolve().parent
CONTACTS = HERE / "contacts.json"
WIDTH, LENGTH = 2.0, 10.0  # mm, of a patch
EDGES = (2, 3, 4)  # of elements per strip: two refinements
WAVE_NUMBERS_PER_DECADE = 6
WHEEL_LESS_RAIL = -2.5  # mm: lateral coordinates of wheel and rail where they touch, S1002 on 60E1 at y = 5.5 mm
PAIRS = {"two lobes, 8 mm apart": (-18.0, -26.0), "tread and gauge corner, 12 mm": (-14.7, -26.5),
         "tread and flange root, 17 mm, 0.5 rad": (-14.0, -29.7)}


def solved(section: Any, edges: int, poisson: float = 0.3, smallest: float = 1e-3) -> Any:
    from prismatic_body import LARGEST_K, Body

    body = Body(section, edges, poisson)
    count = int(np.ceil(WAVE_NUMBERS_PER_DECADE * np.log10(LARGEST_K / smallest)))
    body.solve(np.geomspace(smallest, LARGEST_K, count))
    return body


def real_body(section: Any, edges: int) -> Any:
    """Solved, without the errors that the same elements have on a half-space."""
    from sections import sector

    body, width = solved(section, edges), float(np.diff(section.strips)[0])
    body.correct(solved(sector(np.pi, 20000.0, -3.5 * width, 3.5 * width, width), edges))
    return body


def half_space_error(edges: int, radius: float = 20000.0) -> dict[str, float]:
    """Largest relative difference to A, by distance, in the middle of a half disc clamped at the radius."""
    from sections import sector

    body = solved(sector(np.pi, radius, -6.0, 6.0, 1.0), edges, smallest=2e-5)
    x = np.arange(0.0, 16.0, 5.0)
    difference = body.influence(x, relative=False, less="A") * np.pi * body.modulus
    strip = np.arange(12.0)
    distance = np.hypot(np.subtract.outer(strip, strip), x[:, None, None])
    return {f"{d} mm": float(np.max(abs(difference * distance)[abs(distance - d) < 0.6])) for d in (2, 3, 5, 10, 15)}


def quarter_space_factor(edges: int, poisson: float, radius: float = 10000.0) -> float:
    """Displacement at a distance from a force on the edge, over that of the half-space, by two strips next to the edge."""
    from sections import sector

    body = solved(sector(0.5 * np.pi, radius, 0.0, 10.0, 0.5), edges, poisson, smallest=2e-5)
    difference = body.influence(np.array([0.0]), relative=False, less="A")[0, -1, :2] * np.pi * body.modulus
    near, far = 1 + difference * (9.5 - 0.5 * np.arange(2))
    return float(near + 0.5 * (near - far))


def body_figures(body: Any) -> dict[str, Any]:
    """Influence over the half-space's scale 1/(pi E*), in 1/mm; x in mm."""
    scale = np.pi * body.modulus
    middle = body.section.at(0.5 * (body.section.strips[1:] + body.section.strips[:-1]))
    zero = np.array([0.0])
    result = {"lateral": middle[:, 0], "angle": body.angles(), "nodes": len(body.mesh.points)}
    for name, less in (("less A", "A"), ("less curved", "curved")):
        result[name] = body.influence(zero, less=less, window=LENGTH)[0] * scale
    x = np.arange(0.0, 41.0, 5.0)
    result["along"] = np.einsum("xii->xi", body.influence(x, less="A", window=LENGTH)) * scale
    result["with all motion, less A"] = body.influence(zero, relative=False, less="A", window=LENGTH)[0] * scale
    return {name: np.round(value, 5).tolist() for name, value in result.items()}


def half_space_pair(distance: Array) -> Array:
    """pi E* A of two patches: mean over the length of one of them."""
    return np.asarray(2 / LENGTH * np.arcsinh(0.5 * LENGTH / np.maximum(distance, 1e-9)))


def coupling_errors(figures: dict[str, Any], kind: str) -> tuple[Array, Array]:
    """D - D' of all pairs, in 1/mm, and the distances."""
    table = np.array(figures[kind])
    table = 0.5 * (table + table.T)
    count = np.arange(len(table))
    return (table - 0.5 * np.add.outer(np.diag(table), np.diag(table)),
            WIDTH * abs(np.subtract.outer(count, count)))


def at_places(figures: dict[str, Any], kind: str, one: float, other: float) -> tuple[float, float]:
    """Between two lateral coordinates, linear between strips; and the distance."""
    from scipy.interpolate import RegularGridInterpolator

    lateral, (error, distance) = np.array(figures["lateral"])[::-1], coupling_errors(figures, kind)
    return tuple(float(RegularGridInterpolator((lateral, lateral), values[::-1, ::-1])((one, other)))
                 for values in (error, distance))  # type: ignore[return-value]


def compute() -> dict[str, Any]:
    from sections import above, rail_60e1, rim_s1002

    found: dict[str, Any] = {name: {} for name in ("half-space", "quarter-space", "rail", "wheel")}
    for edges in EDGES[::-1]:
        print(f"{edges} edges per strip", file=sys.stderr, flush=True)
        sections = {"rail": (rail_60e1(20.0, -36.0, WIDTH), -30.0), "wheel": (rim_s1002(20.0, -41.0, WIDTH), -40.0)}
        for body, (section, part) in sections.items():
            found[body][edges] = body_figures(real_body(section, edges))
            if edges == EDGES[0]:
                section.part = above(part)
                found[body]["smaller part"] = body_figures(real_body(section, edges))
        found["half-space"][edges] = half_space_error(edges)
        found["quarter-space"][edges] = {nu: quarter_space_factor(edges, nu) for nu in (0.3, 0.499)}
    return found


def pair_row(bodies: list[dict[str, Any]], kind: str, one: float, other: float) -> Array:
    """Errors of rail, wheel and both."""
    pairs = [at_places(body, kind, one + shift, other + shift) for body, shift in zip(bodies, (0.0, WHEEL_LESS_RAIL))]
    ratio = [error / float(half_space_pair(np.array(distance))) for error, distance in pairs]
    return np.array([*ratio, np.mean(ratio)])


def percent(values: Array) -> str:
    return " | ".join(f"{100 * v:+.1f} %" for v in values)


def report(found: dict[str, Any]) -> None:
    print("| elements on a strip of 1 mm | half-space, at " + " | ".join(found["half-space"][str(EDGES[0])])
          + " | quarter-space, nu = 0.3 | nu = 0.499 |\n" + "|---" * 8 + "|")
    for edges in map(str, EDGES):
        print(f"| {edges} | " + " | ".join(f"{v:.1e}" for v in found["half-space"][edges].values()) + " | "
              + " | ".join(f"{v:.3f}" for v in found["quarter-space"][edges].values()) + " |")
    fine, coarse, smaller, coarsest = ([found[name][key] for name in ("rail", "wheel")]
                             for key in (str(EDGES[-1]), str(EDGES[-2]), "smaller part", str(EDGES[0])))
    print("\n| pair on the rail, t in mm | angle | operator | rail | wheel | both | last refinement | smaller part |\n" + "|---" * 8 + "|")
    for name, (one, other) in PAIRS.items():
        angle = float(np.diff(np.interp([-one, -other], -np.array(fine[0]["lateral"]), fine[0]["angle"]))[0])
        for kind in ("less A", "less curved", "with all motion, less A"):
            rows = [pair_row(bodies, kind, one, other) for bodies in (fine, coarse, smaller, coarsest)]
            print(f"| {name}: {one}, {other} | {angle:.2f} | {kind} | {percent(rows[0])} | "
                  f"{percent((rows[0] - rows[1])[2:])} | {percent((rows[2] - rows[3])[2:])} |")
    print("\n| along the rail, t in mm | distance | rail | wheel | both |\n" + "|---" * 5 + "|")
    for t in (0.0, -14.0, -26.0):
        for column, x in ((1, 5.0), (2, 10.0), (4, 20.0)):
            error = []
            for body, place in zip(fine, (t, t + WHEEL_LESS_RAIL)):
                values = [np.interp(-place, -np.array(body["lateral"]), np.array(body["along"])[i]) for i in (0, column)]
                error.append((values[1] - values[0]) * x)
            print(f"| {t} | {x:.0f} | {percent(np.array([*error, np.mean(error)]))} |")
    for variant, scenes in json.loads(CONTACTS.read_text(encoding="utf-8")).items():
        print(f"\n{variant}\n| contact | operator | pmax, MPa | depth, mm | area, mm^2 | Fy, kN | share of gauge corner | pmax of tread |\n"
              + "|---" * 8 + "|")
        for name, kinds in scenes.items():
            for kind, v in kinds.items():
                print(f"| {name} | {kind} | {v['pmax']:.0f} | {v['depth']:.4f} | {v['area']:.1f} | {v['lateral force'] / 1e3:.2f} | "
                      f"{100 * v['share of corner']:.1f} % | {v['pmax of tread']:.0f} |")


def draw(found: dict[str, Any], path: str) -> None:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import wrcontact

    plt.rcParams.update(wrcontact.picture_style())
    rail, wheel = (found[name][str(EDGES[-1])] for name in ("rail", "wheel"))
    figure, axes = plt.subplots(2, 3, figsize=(12, 6.6), sharex=True, sharey=True)
    for row, kind in enumerate(("less A", "less curved")):
        on_rail, on_wheel = (coupling_errors(body, kind)[0] for body in (rail, wheel))
        t, s = np.array(rail["lateral"])[::-1], np.array(wheel["lateral"])[::-1] - WHEEL_LESS_RAIL
        for column, title in enumerate(("rail 60E1", "wheel S1002", "both")):
            axis = axes[row, column]
            for colour, d in zip(("C0", "C1", "C2", "C3"), (4, 8, 12, 16)):
                lag, scale = int(d / WIDTH), 100 / float(half_space_pair(np.array(float(d))))
                curves = [(0.5 * (place[lag:] + place[:-lag]), scale * np.diagonal(error[::-1, ::-1], lag))
                          for place, error in ((t, on_rail), (s, on_wheel))]
                if column < 2:
                    place, value = curves[column]
                else:
                    place = curves[0][0]
                    value = 0.5 * (curves[0][1] + np.interp(place, *curves[1], left=np.nan, right=np.nan))
                axis.plot(place, value, color=colour, label=f"{d} mm apart")
            axis.axhline(0, color="0.6", linewidth=0.8)
            if row == 0:
                axis.set_title(title)
            else:
                axis.set_xlabel("middle of the pair: t on the rail, mm")
        axes[row, 0].set_ylabel(("half-space" if row == 0 else "curved operator") + "\nerror of the interaction, %")
    axes[0, 0].legend()
    axes[0, 0].set_xlim(-35, 20)
    figure.tight_layout()
    figure.savefig(path, dpi=90)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", metavar="FILE", help="compute all and store it")
    parser.add_argument("--read", metavar="FILE", default=str(HERE / "influence.json"), help="print the tables of stored results")
    parser.add_argument("--picture", metavar="PNG", help="draw stored results")
    options = parser.parse_args()
    if options.write:
        warnings.simplefilter("ignore")
        Path(options.write).write_text(json.dumps(compute()) + "\n", encoding="utf-8")
    found = json.loads(Path(options.write or options.read).read_text(encoding="utf-8"))
    report(found)
    if options.picture:
        draw(found, options.picture)


if __name__ == "__main__":
    main()
