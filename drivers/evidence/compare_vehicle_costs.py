#!/usr/bin/env python3
"""Time and error of a step of a vehicle simulation by model and accuracy of creep forces: the first table of docs/vehicle.md.

Wheelsets of S1002 on 60E1 in motion: lateral position, yaw and the loads of both wheels are drawn at random, height and
roll follow from static equilibrium, and velocities are those of a hunting wheelset at 20 m/s. Each is solved at its
position by each model. The error of a wheel is that of its force, over the amount of the force or 60 kN, against the full
theory at an accuracy of 1e-4. Time is processor time of a wheel, microseconds.

TABLE is one by wrc_table; PYTHONPATH and WRCONTACT_BUILD as docs/python.md has them. Not covered:
derivatives, other profiles, forces under prescribed loads.
"""
from __future__ import annotations

import argparse
import time
import warnings
from collections.abc import Callable

import numpy as np
import wrcontact

LEAST_FORCE = 6e4  # N
SPEED, RADIUS = 2e4, 460.0  # mm/s, mm
CHOICES = [("fastsim", 1e-1), ("fastsim", 1e-2), ("fastsim", 1e-3),
           ("full", 1e-1), ("full", 3e-2), ("full", 1e-2), ("full", 1e-3)]

State = tuple[np.ndarray, list[float]]
Step = Callable[[np.ndarray, list[float]], wrcontact.Step]


def drawn_states(count: int, seed: int) -> list[State]:
    random = np.random.default_rng(seed)
    solver, scene = wrcontact.Solver(), wrcontact.Scene(accuracy_of="forces", accuracy=1e-3)
    states: list[State] = []
    while len(states) < count:
        place = [0, random.uniform(-6.3, 6.3), 0, 0, 0, random.uniform(-4e-3, 4e-3)]
        velocity = [SPEED, random.normal(0, 20), 0, 0,
                    SPEED / RADIUS * (1 + random.normal(0, 2e-4)), random.normal(0, 0.01)]
        loads = random.uniform(64e3, 96e3, 2)
        try:
            states.append((solver.equilibrium(scene, place, wheels=loads).position, velocity))
        except wrcontact.NotConverged:  # forces jump with their elements
            continue
    return states


def solved_step(creep: str, accuracy: float) -> Step:
    solver = wrcontact.Solver()
    scene = wrcontact.Scene(accuracy_of="forces", accuracy=accuracy, creep=creep)
    return lambda place, velocity: solver.step(scene, place, velocity)


def tabled_step(path: str) -> Step:
    table = wrcontact.Table()
    table.load(path)
    return lambda place, velocity: table.step(place, velocity)[0]


def forces(states: list[State], step: Step) -> tuple[np.ndarray, float]:
    """[state, wheel, x y z] in N, and microseconds a wheel."""
    step(*states[0])
    begin = time.process_time()
    found = [step(place, velocity).force[:, :3] for place, velocity in states]
    return np.array(found), (time.process_time() - begin) / len(states) / 2 * 1e6


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("states", nargs="?", type=int, default=300, metavar="STATES", help="default 300")
    parser.add_argument("seed", nargs="?", type=int, default=5, metavar="SEED", help="default 5")
    parser.add_argument("tables", nargs="*", metavar="TABLE")
    options = parser.parse_args()
    count, seed = options.states, options.seed
    warnings.simplefilter("ignore")
    states = drawn_states(count, seed)
    truth, _ = forces(states, solved_step("full", 1e-4))
    size = np.maximum(np.linalg.norm(truth, axis=2), LEAST_FORCE)
    print("creep    accuracy  us a wheel      rms    99 %   worst")
    choices = [(creep, f"{accuracy:g}", solved_step(creep, accuracy)) for creep, accuracy in CHOICES]
    choices += [("table", "", tabled_step(path)) for path in options.tables]
    for creep, accuracy, step in choices:
        found, spent = forces(states, step)
        error = np.linalg.norm(found - truth, axis=2) / size
        print(f"{creep:8} {accuracy:>8} {spent:11.0f} {np.sqrt(np.mean(error ** 2)):8.4f}"
              f"{np.quantile(error, 0.99):8.4f}{error.max():8.4f}")


if __name__ == "__main__":
    main()
