#!/usr/bin/env python3
"""Compares contact on rails and wheels that vary with values of CONTACT.

Reads slices_cases.json (scenes, and what CONTACT finds in them by its two searches) and the folder of
profiles it names, solves each scene with the library, and prints a table: differences of the forces on
the wheel in percent of the vertical force, of its height in um, and both largest pressures. Both take
slip at three creepages of the patch (by the program solve_like_contact) and the wheelset does not move
vertically (motion.vertical = 0), as CONTACT has it. Lists by formula (set own_*) are written to a temporary folder.
Units mm, N, MPa. Not covered: cases whose rail CONTACT does not find.

  compare_varying.py SOLVE_LIKE_CONTACT CASES.json [--profiles FOLDER] [--set NAME ...] [--summary]
"""
import argparse
import json
import math
import pathlib
import statistics
import subprocess
import sys
import tempfile
import warnings
from collections.abc import Callable
from typing import Any

import wrcontact

FLAT_WHEEL = "flat_plane.txt"  # by formula, for CONTACT's flat_plane.prw
SMOOTHING = 9.4  # mm, the wavelength halved by CONTACT's smoothing of 5 mm: 2 pi 5^(1/4)


def write_own_list(folder: pathlib.Path, name: str) -> None:
    """The rails by formula of the cases' page: z(down) = zeta(u) + 300 - sqrt(300^2 - y^2)."""
    shapes: dict[str, tuple[float, Callable[[float], float]]] = {
        "const": (10.0, lambda u: 0.0),
        "slope100": (10.0, lambda u: -u / 100.0),
        "slope20": (10.0, lambda u: -u / 20.0),
        "corr": (1.0, lambda u: 0.02 * math.cos(2.0 * math.pi * u / 40.0)),
        "wave": (2.0, lambda u: 0.1 * math.cos(2.0 * math.pi * u / 100.0)),
    }
    step, zeta = shapes[name]
    half = int(200.0 / step)
    lines = [f"0 1\n{2 * half + 1}\n0 0 0\n1\n"]
    for i in range(-half, half + 1):
        u = i * step
        slice_name = f"{name}_{i + half}.prr"
        points = "".join(
            f"{0.5 * k} {zeta(u) + 300.0 - math.sqrt(300.0**2 - (0.5 * k) ** 2):.15g}\n"
            for k in range(-60, 61)
        )
        (folder / slice_name).write_text(
            "header.begin\nversion = 1\ntype = 1\nheader.end\nspline.begin\nunits.len.f = 1000\n"
            f"point.begin\n{points}point.end\nspline.end\n"
        )
        lines.append(f"{u} '{slice_name}'\n")
    (folder / f"own_{name}.slcs").write_text("".join(lines))


def scene_of(given: dict[str, Any], profiles: list[pathlib.Path], reference: dict[str, Any]) -> wrcontact.Scene:
    def path(name: str) -> str:
        return next((str(f / name) for f in profiles if (f / name).exists()), name)

    scene = wrcontact.Scene()
    scene["solve.side"] = "right"
    scene["pose.roll"] = given["roll_rad"]
    scene["pose.lateral"] = given["lateral_mm"]
    scene["pose.yaw"] = given["yaw_rad"]
    scene["pose.longitudinal"] = given["along_mm"]
    scene["pose.pitch"] = given["pitch_rad"]
    rail: dict[str, Any] = {"file": path(given["rail"])}
    wheel: dict[str, Any] = {
        "file": path(FLAT_WHEEL if given["wheel"] == "flat_plane.prw" else given["wheel"])
    }
    scene["wheelset.radius"] = given["nominal_radius_mm"]
    if not given["wheel"].endswith(".slcw"):
        wheel["smoothing"] = 0.0
    elif "wheel_smoothing_lambda" in given:
        wheel["smoothing"] = SMOOTHING
    if not given["rail"].endswith(".slcs"):
        rail["smoothing"] = 0.0
    if "cant_rad" in given:
        scene["track.inclination"] = given["cant_rad"]
        scene["track.gauge"] = given["gauge_mm"]
        scene["track.gauge_height"] = given["gauge_height_mm"]
    else:
        scene["track.inclination"] = 0.0
        rail["origin"] = 750.0  # where the wheel's taping line is
    scene["track.rail"], scene["wheelset.wheel"] = rail, wheel
    scene["material.youngs_modulus"] = 2.0 * given["G_MPa"] * (1.0 + given["nu"])
    scene["material.poisson"] = given["nu"]
    scene["friction.coefficient"] = given["friction"]
    scene["motion.speed"] = given["speed_mm_s"]
    scene["motion.pitch"] = given["pitch_rate_rad_s"]
    scene["motion.vertical"] = 0.0
    if "vertical_force_N" in given:
        scene["load.right"] = given["vertical_force_N"]
        scene["load.of"] = "total"
    else:
        scene["pose.vertical"] = given["nominal_radius_mm"] - reference["z_ws_down_mm"]
    return scene


def solve(program: pathlib.Path, scene: wrcontact.Scene, names: tuple[str, ...]) -> dict[str, float]:
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "scene.toml"
        scene.write(path)
        found = subprocess.run([program, path, *names], check=True, capture_output=True, text=True)
    return dict(zip(names, map(float, found.stdout.split())))


def compare(program: pathlib.Path, case: dict[str, Any], profiles: list[pathlib.Path]) -> dict[str, Any] | None:
    by_search = case["by_search"]
    reference = by_search.get("brute") or next(iter(by_search.values()))
    force = [reference["force_N"][axis] for axis in "xyz"]
    if not reference["patches"] or force[2] <= 0.0:
        return None
    given = case["input"]
    names = ("right.longitudinal_force", "right.lateral_force", "right.vertical_force", "right.vertical",
             "right.depth", "right.pmax")
    result = solve(program, scene_of(given, profiles, reference), names)
    found = [result[name] for name in names[:3]]
    height = result["right.vertical"] - result["right.depth"]
    return {
        "force": [100.0 * (a - b) / force[2] for a, b in zip(found, force)],
        "height": 1e3 * (given["nominal_radius_mm"] - reference["z_ws_down_mm"] - height),
        "pmax": result["right.pmax"],
        "pmax_contact": max(patch["pmax_MPa"] for patch in reference["patches"]),
    }


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("program", type=pathlib.Path, help="solve_like_contact")
    parser.add_argument("cases", type=pathlib.Path, help="slices_cases.json")
    parser.add_argument("--profiles", type=pathlib.Path, help="folder of slices; default: beside the cases")
    parser.add_argument("--set", nargs="+", default=[], help="sets or cases to solve")
    parser.add_argument("--summary", action="store_true", help="one line a set")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    cases = json.loads(options.cases.read_text())["cases"]
    found: dict[str, list[dict[str, Any]]] = {}
    print("| set | scene | Fx | Fy | Fz, % | height, um | pmax | CONTACT, MPa |\n" + "|---" * 8 + "|")
    with tempfile.TemporaryDirectory() as temporary:
        own = pathlib.Path(temporary)
        for name in ("const", "slope100", "slope20", "corr", "wave"):
            write_own_list(own, name)
        (own / FLAT_WHEEL).write_text("".join(f"{0.5 * k} 0\n" for k in range(-80, 81)))
        beside = options.profiles or options.cases.parent / "slices"
        for case in cases:
            if options.set and not {case["set"], case["id"]} & set(options.set):
                continue
            name = f"{case['set']} | {case['id']}"
            try:
                difference = compare(options.program, case, [own, beside, beside.parent])
            except subprocess.CalledProcessError as error:
                print(f"| {name} | {error.stderr.strip()} |")
                continue
            if difference is None:
                continue
            found.setdefault(case["set"], []).append(difference)
            if not options.summary:
                fx, fy, fz = difference["force"]
                print(
                    f"| {name} | {fx:.2f} | {fy:.2f} | {fz:.2f} | {difference['height']:.2f} | "
                    f"{difference['pmax']:.0f} | {difference['pmax_contact']:.0f} |"
                )
    print("\n| set | scenes | Fx median, worst | Fy median, worst, % | height worst, um |")
    print("|---" * 5 + "|")
    for name, differences in found.items():
        text = f"| {name} | {len(differences)} "
        for axis in (0, 1):
            values = [abs(difference["force"][axis]) for difference in differences]
            text += f"| {statistics.median(values):.2f}, {max(values):.2f} "
        print(text + f"| {max(abs(difference['height']) for difference in differences):.2f} |")
    return 0 if found else 1


if __name__ == "__main__":
    sys.exit(main())
