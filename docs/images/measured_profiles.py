#!/usr/bin/env python3
"""Draws docs/images/measured_wheel.png and docs/images/whole_rail.png: how files are read.

Usage: docs/images/measured_profiles.py [BIN [FOLDER]]. BIN holds wrc_profile, build/release/bin if it
is missing; FOLDER, this one if it is missing, gets the pictures. The files are made here from S1002
and 60E1, as a measurement and a drawing would have them; they stay beside the pictures if FOLDER is
given.
"""
import json
import math
import random
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent


def points_of(program, name, spacing):
    text = subprocess.run([program, name, "--points", "--spacing", str(spacing), "--json"],
                          check=True, capture_output=True, text=True).stdout
    return [(p["lateral"], p["height"]) for p in json.loads(text)["points"]]


def measured_wheel(program):
    """From the flange back, semicolons and decimal commas, scatter, one spike, a gap on the flange back."""
    chance = random.Random(1955)
    rows = ["y [mm];z [mm]"]
    for y, z in points_of(program, "S1002", 0.3):
        if y < -60.0 and 14.0 < z < 19.0:
            continue
        y += 70.0 + chance.gauss(0.0, 0.015)
        z += 0.35 + chance.gauss(0.0, 0.015) + (9.0 if 104.9 < y < 105.2 else 0.0)
        rows.append(f"{y:.4f};{z:.4f}".replace(".", ","))
    return "\r\n".join(rows) + "\r\n"


def whole_rail(program):
    """60E1 with web and foot in straight lines, a closed outline, height downwards."""
    head = points_of(program, "60E1", 0.5)
    corners = [head[-1], (10.0, -47.0), (8.25, -60.0), (8.25, -140.0), (30.0, -155.0), (75.0, -161.0),
               (75.0, -172.0), (0.0, -172.0)]
    right = []
    for (y, z), (y1, z1) in zip(corners, corners[1:]):
        parts = math.ceil(math.hypot(y1 - y, z1 - z))
        right += [(y + (y1 - y) * k / parts, z + (z1 - z) * k / parts) for k in range(1, parts + 1)]
    left = [(-y, z) for y, z in reversed(right)]
    return "".join(f"{y:.4f} {-z:.4f}\n" for y, z in left + head + right[:-1])


def main():
    programs = Path(sys.argv[1] if len(sys.argv) > 1 else HERE.parents[1] / "build/release/bin")
    program = str(programs.resolve() / "wrc_profile")
    pictures = Path(sys.argv[2] if len(sys.argv) > 2 else HERE).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        folder = pictures if len(sys.argv) > 2 else Path(scratch)
        for name, text, options in (
                ("measured_wheel.csv", measured_wheel(program), ["--kind", "wheel"]),
                ("whole_rail.txt", whole_rail(program), ["--kind", "rail"])):
            (folder / name).write_text(text, newline="")
            picture = pictures / (Path(name).stem + ".png")
            subprocess.run([program, name, *options, "--plot", str(picture)], check=True, cwd=folder)


if __name__ == "__main__":
    main()
