#!/usr/bin/env python3
"""Time of this library beside that of CONTACT, at equal error: the table of docs/evidence/performance.md#beside-contact.

Usage: drivers/evidence/contact_times.py [--instructions]

CONTACT's times and errors are those of tests/reference/contact_times.json; ours are measured here, processor time of one
core, the median of repetitions: normal contact of an ellipse on 256 x 128 constant elements; creep forces of eight
ellipses with the fewest elements whose error is not above CONTACT's, against 192 x 192 elements; three wheels on rails with
creep forces at an accuracy of 1e-2. --instructions counts the first with valgrind's callgrind. PYTHONPATH and
WRCONTACT_BUILD as docs/python.md has them.
"""
from __future__ import annotations

import json
import re
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import wrcontact

CASES = json.loads((Path(__file__).resolve().parents[2] / "tests/reference/contact_times.json").read_text(encoding="utf-8"))
STEEL = {"shear_modulus": 82000.0, "poisson": 0.28}
MODULUS = 82000.0 / (1.0 - 0.28)  # E* of two such bodies, MPa
FEWEST, FINE = (6, 8, 12, 16, 24, 32, 48, 64), 192


def time_of(solve: Callable[[], Any], repetitions: int = 25) -> float:
    """Milliseconds."""
    times = []
    for _ in range(repetitions):
        start = time.process_time()
        solve()
        times.append(time.process_time() - start)
    return 1e3 * statistics.median(times)


def normal_contact() -> wrcontact.NormalContact:
    case = CASES["normal_256x128"]
    step = case["element_mm"]
    x = step * (np.arange(256) - 127.5)
    y = step * (np.arange(128) - 63.5)
    gap = case["gap_x2"] * x**2 + case["gap_y2"] * y[:, None] ** 2
    return wrcontact.NormalContact(gap, step, step, combined_modulus=MODULUS, normal_load=case["load_N"],
                                   elements="constant", tolerance=1e-4)


def instructions(repetitions: int) -> float:
    program = (f"import sys; sys.path[:0] = {sys.path!r}\nfrom contact_times import normal_contact\n"
               f"contact = normal_contact()\nfor _ in range({repetitions}): contact.solve()")
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            ["valgrind", "--tool=callgrind", f"--callgrind-out-file={folder}/out", sys.executable, "-c", program],
            capture_output=True, text=True, check=True)
    return float(re.findall(r"Collected : (\d+)", done.stderr)[-1])


def rolling_contact(case: dict[str, float], count: int, tolerance: float) -> wrcontact.RollingContact:
    """As `count` elements over each axis of the ellipse, with four more."""
    a, b = case["a_mm"], case["b_mm"]
    places = (np.arange(count + 4) - 0.5 * (count + 3)) / (0.5 * count)
    height = np.maximum(1.0 - places[:, None] ** 2 - places**2, 0.0)
    pressure = 1.5 * case["Fn_N"] / (np.pi * a * b) * np.sqrt(height)
    return wrcontact.RollingContact(  # CONTACT has y to the right, and rail minus wheel
        pressure, 2 * b / count, 2 * a / count, friction=case["mu"], tolerance=tolerance, **STEEL,
        longitudinal_creepage=-case["cksi"], lateral_creepage=case["ceta"], spin_creepage=case["cphi_per_mm"])


def forces(contact: wrcontact.RollingContact, case: dict[str, float]) -> np.ndarray:
    radius = np.sqrt(case["a_mm"] * case["b_mm"])
    return np.array([contact.creep_force.longitudinal, contact.creep_force.lateral,
                     contact.spin_moment / radius]) / (case["mu"] * case["Fn_N"])


def print_rolling() -> None:
    print("creep forces: case, CONTACT's elements, ms, error; ours; ratio")
    for entry in CASES["rolling_hertz"]:
        case = entry["input"]
        exact = forces(rolling_contact(case, FINE, 1e-6).solve(), case)
        for elements, milliseconds, allowed in entry["contact"]:
            for count in FEWEST:
                contact = rolling_contact(case, count, 1e-2 if count <= 16 else 1e-3)
                error = np.abs(forces(contact.solve(), case) - exact).max()
                if error <= allowed:
                    own = time_of(contact.solve)
                    print(f"  {entry['id']} {elements}, {milliseconds:.3g}, {allowed:.1e}; {count}, {own:.3f}, {error:.1e}; "
                          f"{milliseconds / own:.0f}")
                    break


def print_wheels() -> None:
    print("wheel on rail with creep forces: case, CONTACT's ms at 0.4 mm, error; ours at 1e-2; ratio")
    for entry in CASES["wheel_rail"]:
        solver = wrcontact.Solver()
        scene = wrcontact.Scene(wheel="S1002", rail="UIC60-Manchester", lateral=entry["y_mm_left"], accuracy=1e-2)
        scene.set(**{"solve.side": "right", "solve.accuracy_of": "forces", "motion.speed": 2e4, "load.of": "total"})
        milliseconds, error = entry["contact_0.4mm_ms_error"]
        own = time_of(lambda solver=solver, scene=scene: solver.solve(scene))
        print(f"  {entry['id']} {milliseconds:.0f}, {error:.1e}; {own:.2f}; {milliseconds / own:.0f}")


def main() -> None:
    print("CONTACT", CASES["contact_version"], "and wrcontact", wrcontact.__version__)
    case, contact = CASES["normal_256x128"], normal_contact()
    own = time_of(contact.solve)
    print(f"normal contact, 256 x 128: {case['contact_ms']} ms; {own:.2f} ms, pmax of elements "
          f"{contact.pmax_element:.1f} (CONTACT {case['contact_pmax_MPa']}) MPa; {case['contact_ms'] / own:.0f}")
    if "--instructions" in sys.argv:
        millions = 1e-6 * (instructions(6) - instructions(1)) / 5
        print(f"  million instructions: {case['contact_M_instructions']}; {millions:.1f}; "
              f"{case['contact_M_instructions'] / millions:.0f}")
    print_rolling()
    print_wheels()


if __name__ == "__main__":
    main()
