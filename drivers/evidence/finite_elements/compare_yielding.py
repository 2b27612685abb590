"""The law of yielding against finite elements, as ratios to the elastic contact of the same mesh.

    PYTHONPATH=build/release/python drivers/evidence/finite_elements/compare_yielding.py

results.json has three contacts with a yield stress of 500 MPa on three meshes (compare_contacts.py), yield_stresses.json those with other
yield stresses on the coarsest one, and two further contacts on two meshes. The library has the pose of the unyielding finite elements,
and its default accuracy.
"""
from __future__ import annotations

import json
import math
import sys
import warnings
from pathlib import Path
from typing import Any

import wrcontact

HERE = Path(__file__).resolve().parent
AREA = "area"  # from the ends of pressures; counted in nodes it is nearer to the law


def step_at(run: Any, load: float) -> Any:
    return min(run["steps"], key=lambda step: abs(float(step["Fz"]) - load))


def cases() -> list[dict[str, Any]]:
    runs = json.loads((HERE / "results.json").read_text())
    found = []
    for contact in ("tread", "lobes", "corner"):
        for mesh in range(3):
            for load in (20e3, 40e3, 60e3, 80e3):
                found.append({"contact": contact, "mesh": mesh, "yield stress": 500, "load": load,
                              "plastic": step_at(runs[f"{contact} plastic {mesh}"], load),
                              "unyielding": step_at(runs[f"{contact} unyielding {mesh}"], load)})
    others: list[dict[str, Any]] = json.loads((HERE / "yield_stresses.json").read_text())["cases"]
    return others + found


def solve(case: dict[str, Any], **steel: Any) -> Any:
    pose = case["unyielding"]["pose"]
    return wrcontact.Scene(lateral=pose["lateral"], roll=pose["roll"], load_both=case["load"], side="left", curved="auto", **steel).solve().left


def rms(values: list[float]) -> float:
    return math.sqrt(sum(value * value for value in values) / len(values))


def worst(values: list[float]) -> float:
    return max(abs(value) for value in values)


def main() -> int:
    warnings.simplefilter("ignore")
    print("| contact | mesh | yield stress, MPa | load, kN | elastic pmax over it | pmax over elastic, finite elements | law | error "
          "| change of area, finite elements | law | of Fy over Fz, finite elements | law |\n" + "|---" * 12 + "|")
    pmax: list[float] = []
    far: list[float] = []
    area: list[float] = []
    force: list[float] = []
    for case in cases():
        plastic, elastic, stress = case["plastic"], case["unyielding"], case["yield stress"]
        before, after = solve(case), solve(case, wheel_yield_stress=stress, rail_yield_stress=stress)
        beyond = before.pmax / stress
        if beyond < 1.44:
            continue
        ratios = plastic["pmax"] / elastic["pmax"], after.pmax / before.pmax
        areas = plastic[AREA] / elastic[AREA] - 1, after.area / before.area - 1
        forces = (plastic["Fy"] - elastic["Fy"]) / case["load"], (after.pressure_force.y - before.pressure_force.y) / case["load"]
        (pmax if beyond <= 5.0 else far).append(ratios[1] / ratios[0] - 1)
        area.append(areas[1] - areas[0])
        force.append(forces[1] - forces[0])
        print(f"| {case['contact']} | {case['mesh']} | {stress:.0f} | {case['load'] / 1e3:.0f} | {beyond:.2f} | {ratios[0]:.3f} | {ratios[1]:.3f} "
              f"| {100 * (ratios[1] / ratios[0] - 1):+.1f} % | {100 * areas[0]:+.0f} % | {100 * areas[1]:+.0f} % "
              f"| {100 * forces[0]:+.2f} % | {100 * forces[1]:+.2f} % |")
    print(f"\n{len(area)} contacts; pmax {100 * rms(pmax + far):.1f} % rms, worst {100 * worst(pmax):.1f} % up to an elastic pmax of 5 yield "
          f"stresses, {100 * worst(far):.1f} % beyond; area {100 * rms(area):.1f} points rms, worst {100 * worst(area):.1f}; "
          f"Fy over Fz {100 * worst(force):.2f} points")
    return 0


if __name__ == "__main__":
    sys.exit(main())
