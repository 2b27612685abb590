#!/usr/bin/env python3
"""What each thing that a scene can ask for costs, over a plain step: the table of docs/evidence/performance.md.

Runs step_costs under callgrind (Debian's valgrind) and counts the instructions of its steps alone: positions, reading of
profiles and plans are prepared before. Callgrind counts each byte that the instructions rep stosb and rep movsb set or
copy, in blocks of 2 kB and more: glibc leaves them out here. WRCONTACT_BUILD: the build folder (build/release), with
the target `evidence`.
Not covered: stresses, wear and spreads of measured profiles, which steps do not ask for.
"""
from __future__ import annotations

import argparse
import math
import os
import pathlib
import re
import subprocess
import tempfile

BUILD = pathlib.Path(os.environ.get("WRCONTACT_BUILD", "build/release")).resolve()
CROSSING = BUILD / "share/wrcontact/studies/crossing/crossing.slcs"
RADIUS, FLAT, SLICES = 460.0, 60.0, 81  # mm, mm along, number
NO_REPEATED_BYTES = ":".join(f"glibc.cpu.x86_rep_{name}_threshold={2**40}" for name in ("stosb", "movsb"))


def wheel_with_flat(folder: pathlib.Path) -> pathlib.Path:
    """S1002 with a flat of the length FLAT where the angle is 0."""
    points = folder / "s1002.txt"
    subprocess.run([BUILD / "bin/wrc_profile", "S1002", "--convert", points, "--spacing", "0.5"], check=True,
                   stdout=subprocess.DEVNULL)
    rows = [[float(word) for word in line.split()] for line in points.read_text().splitlines()
            if re.match(r"\s*[-+.\d]", line)]
    half = math.asin(0.5 * FLAT / RADIUS)
    lines = []
    for i in range(SLICES):
        angle = 1.5 * half * (2 * i / (SLICES - 1) - 1)
        depth = max(0.0, RADIUS - RADIUS * math.cos(half) / math.cos(angle)) if abs(angle) < half else 0.0
        (folder / f"slice{i}.txt").write_text("".join(f"{row[0]} {row[1] - depth:.9f}\n" for row in rows))
        lines.append(f"{angle} 'slice{i}.txt'\n")
    path = folder / "flat.slcw"
    path.write_text(f"0 1.0\n{SLICES}\n0 0 0\n1\n" + "".join(lines))
    return path


def count(steps: int, arguments: list[str]) -> float:
    """Millions of instructions of a step."""
    run = subprocess.run(
        ["valgrind", "--tool=callgrind", "--callgrind-out-file=/dev/null", "--collect-atstart=no",
         "--toggle-collect=counted_step", "--toggle-collect=counted_solution",
         BUILD / "bin/step_costs", "--steps", str(steps), *arguments], check=True, capture_output=True, text=True,
        env={**os.environ, "GLIBC_TUNABLES": NO_REPEATED_BYTES})
    found = re.search(r"Collected : (\d+)", run.stderr)
    assert found, run.stderr
    return int(found[1]) / steps / 1e6


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--steps", type=int, default=8, help="steps of the run over irregular track (default 8)")
    steps: int = parser.parse_args().steps
    full = ["--set", "solve.creep=full"]  # the last one counts
    waves = ["--set", "wheelset.harmonics=[1,0.3,0,12,0.02,0.5]"]
    crossing = ["--set", f"track.left.rail={CROSSING}"]
    with tempfile.TemporaryDirectory() as name:
        flat = ["--set", f"wheelset.wheel={wheel_with_flat(pathlib.Path(name))}; smoothing_along = 0"]
        cases: list[tuple[str, list[str]]] = [
            ("plain: position given, no creep forces", []),
            ("derivatives", ["--derivatives"]),
            ("loads given, roll and heights solved", ["--loaded"]),
            ("solve.accuracy_of = \"pressures\"", ["--set", "solve.accuracy_of=pressures"]),
            ("solve.curved = \"auto\"", ["--set", "solve.curved=auto"]),
            ("solve.model = \"hertz\"", ["--set", "solve.model=hertz"]),
            ("creep forces: linear", ["--set", "solve.creep=linear"]),
            ("creep forces: fastsim", ["--set", "solve.creep=fastsim"]),
            ("creep forces: full", full),
            ("the same with derivatives", [*full, "--derivatives"]),
            ("two waves around the wheels", waves),
            ("a flat in each wheel, away from the rail", [*flat, "--pitch", "2.5"]),
            ("the same on the rail", [*flat, "--pitch", "0.01"]),
            ("the left wheel on the wing of the shipped crossing", [*crossing, "--along", "-100"]),
            ("the same on its nose", [*crossing, "--along", "400"]),
        ]
        plain: dict[str, float] = {}
        print("| a step of both wheels with | 1e-2, M | over plain | 1e-3, M | over plain |\n|---|---|---|---|---|")
        for text, arguments in cases:
            cells = []
            for accuracy in ("1e-2", "1e-3"):
                cost = count(steps, ["--set", f"solve.accuracy={accuracy}", "solve.creep=none", *arguments])
                cells += [f"{cost:.3g}", f"{cost / plain.setdefault(accuracy, cost):.2g}"]
            print(f"| {text} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
