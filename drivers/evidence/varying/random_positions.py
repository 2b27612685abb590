#!/usr/bin/env python3
"""Solves wheels at random positions on all slices files of a folder, and counts what fails.

A rail's list carries a wheel S1002 of 460 mm, a wheel's list runs on 60E1. Drawn are the position along the
track, or the angle of the wheel, lateral position (-8 to 8 mm), yaw (-20 to 20 mrad), load (1 to 150 kN)
and whether both wheels or one of them are solved, with creep forces at 20 m/s. As in bounded_scenes, a
scene may end with a result, without contact, not converged, or refused; these are counted. It fails if
anything else is reported, if a number is not finite, or if the load is not carried to 1 %. Accuracy
1e-2 of forces. The same seed gives the same scenes.

  random_positions.py FOLDER [--count N] [--seed N]
"""
import argparse
import collections
import math
import pathlib
import random
import sys
import time
import warnings

import wrcontact

KEYS = {".slcs": "track.rail", ".slcw": "wheelset.wheel"}


def stretch_of(path: pathlib.Path) -> tuple[float, float]:
    """From the first to the last slice: mm along the rail, or rad around the wheel."""
    lines = [line.split("%")[0] for line in path.read_text(errors="replace").splitlines()]
    offset, scale = (float(word) for word in " ".join(lines).split()[:2])
    places = [float(line.split()[0]) for line in lines if "'" in line]
    return scale * (offset + places[0]), scale * (offset + places[-1])


def scene_on(path: pathlib.Path, draw: random.Random, stretch: tuple[float, float]) -> wrcontact.Scene:
    is_rail = path.suffix == ".slcs"
    scene = wrcontact.Scene()
    scene["solve.accuracy_of"] = "forces"
    scene["solve.accuracy"] = 1e-2
    scene[KEYS[path.suffix]] = {"file": path, "origin": 750.0} if is_rail else path
    if is_rail:
        scene["track.inclination"] = 0.0
        scene["pose.longitudinal"] = draw.uniform(*stretch)
    else:
        scene["wheelset.radius"] = 450.0
        scene["pose.pitch"] = draw.uniform(*stretch)
    scene["pose.lateral"] = draw.uniform(-8.0, 8.0)
    scene["pose.yaw"] = draw.uniform(-0.02, 0.02)
    side = draw.choice(["left", "right", "both"])
    scene["solve.side"] = side
    if side != "both":
        scene["pose.roll"] = draw.uniform(-1e-3, 1e-3)
    scene["load.both"] = 10.0 ** draw.uniform(3.0, 5.17)
    scene["motion.speed"] = 2e4
    return scene


def outcome(scene: wrcontact.Scene, solver: wrcontact.Solver) -> str:
    try:
        result = solver.solve(scene)
    except wrcontact.NoContact:
        return "no contact"
    except wrcontact.NotConverged:
        return "not converged"
    except wrcontact.InvalidArgument:
        return "refused"
    except wrcontact.Error as error:
        return f"failed: {error}"
    load = scene["load.both"]
    for side in ("left", "right"):
        if scene["solve.side"] not in (side, "both"):
            continue
        vertical = result[f"{side}.pressure_force.z"]
        numbers = [vertical, result[f"{side}.pmax"], result[f"{side}.longitudinal_force"]]
        if not all(math.isfinite(number) for number in numbers):
            return "failed: a number is not finite"
        if abs(vertical / load - 1.0) > 1e-2:
            return f"failed: {vertical:.6g} N of {load:.6g} N are carried"
    return "ok"


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=pathlib.Path, help="with .slcs and .slcw files")
    parser.add_argument("--count", type=int, default=1000, help="scenes, default 1000")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    stretches = {}
    for path in sorted(options.folder.iterdir()):
        if path.suffix in KEYS:
            stretches[path] = stretch_of(path)
    if not stretches:
        parser.error(f"no .slcs or .slcw file in {options.folder}")
    draw = random.Random(options.seed)
    solver = wrcontact.Solver()
    counts: collections.Counter[str] = collections.Counter()
    slowest = (0.0, 0)
    for number in range(options.count):
        path = draw.choice(list(stretches))
        scene = scene_on(path, draw, stretches[path])
        begin = time.perf_counter()
        found = outcome(scene, solver)
        slowest = max(slowest, (time.perf_counter() - begin, number))
        counts["failed" if found.startswith("failed") else found] += 1
        if found.startswith("failed"):
            print(f"scene {number}, {path.name}: {found}", flush=True)
        if sys.stderr.isatty() and number % 100 == 0:
            print(f"\r{number} of {options.count}", end="", file=sys.stderr)
    text = ", ".join(f"{count} {name}" for name, count in sorted(counts.items()))
    print(f"{options.count} scenes on {len(stretches)} files, seed {options.seed}: {text}")
    print(f"slowest: {slowest[0]:.2f} s (scene {slowest[1]})")
    return 1 if counts["failed"] else 0


if __name__ == "__main__":
    sys.exit(main())
