#!/usr/bin/env python3
"""What a table says of the wheels of a coach, against the full theory at an accuracy of 1e-3: the figures of docs/table.md.

STATES are files that `coach --states FILE --friction '0.2 0.5'` wrote on the wheel profile of --wheel, which is the
table's; forces are those at --friction. A third of the wheelsets is braked: they turn 0.03 to 1 % slower. Bands are those of the lateral position of
the wheel against its rail, towards the flange: tread to 5 mm, root to 7.5 mm, flange beyond.

For forces: errors over the load, as the table has them; how many are beyond the bound and beyond the likely error.
For outputs: the error that 99 % keep, and how many are beyond theirs. --save keeps the full theory's answers, which
take 15 ms of processor time a wheel; --load reads them. --time measures a step with and without derivatives instead.
"""
from __future__ import annotations

import argparse
import time
import warnings

import numpy as np
import wrcontact

RESULTS = ["wear_number", "centroid.t_rail", "centroid.s_wheel", "centroid.rolling_radius", "vertical_force"]
BANDS = [("tread", -np.inf, 5.0), ("root", 5.0, 7.5), ("flange", 7.5, np.inf)]


def drawn_states(paths: list[str], count: int, beyond: float) -> np.ndarray:
    """Rows of position, velocity, rails and curvature in mm and s; those with a wheel beyond a lateral position."""
    rows = np.vstack([np.loadtxt(path) for path in paths])
    rows = rows[1e3 * band_of(rows).max(axis=1) >= beyond]
    random = np.random.default_rng(7)
    rows = rows[random.choice(len(rows), min(count, len(rows)), replace=False)]
    braked = random.random(len(rows)) < 1 / 3
    rows[braked, 10] *= 1 - 10 ** random.uniform(-3.5, -2, braked.sum())
    rows[:, [0, 1, 2, 6, 7, 8, 12, 13, 15, 16]] *= 1e3
    rows[:, 18] *= 1e-3
    return rows


def arguments(row: np.ndarray) -> dict:
    return {"position": row[:6], "velocity": row[6:12], "rails": row[12:18], "curvature": row[18]}


def truth_of(rows: np.ndarray, wheel: str, friction: list[float]) -> dict[str, np.ndarray]:
    """Force [state, wheel, 3], and RESULTS [state, wheel, 5]; not-a-number where it is not solved."""
    scene = wrcontact.Scene(accuracy_of="forces", accuracy=1e-3, creep="full",
                            **{"friction.left": friction[0], "friction.right": friction[1], "wheelset.wheel": wheel})
    solver = wrcontact.Solver()
    force = np.full((len(rows), 2, 3), np.nan)
    results = np.full((len(rows), 2, len(RESULTS)), np.nan)
    for i, row in enumerate(rows):
        try:
            force[i] = solver.step(scene, **arguments(row)).force[:, :3]
        except wrcontact.Error as error:
            print(f"state {i}: {error}")
            continue
        for side, name in enumerate(("left", "right")):
            for k, result in enumerate(RESULTS):
                try:
                    results[i, side, k] = scene.result[f"{name}.{result}"]
                except wrcontact.Error:  # no contact
                    pass
    return {"rows": rows, "force": force, "results": results}


def band_of(rows: np.ndarray) -> np.ndarray:
    """[state, wheel]: towards the flange."""
    return np.stack([rows[:, 1] - rows[:, 12], rows[:, 15] - rows[:, 1]], axis=1)


def compare(table: wrcontact.Table, truth: dict[str, np.ndarray], friction: list[float]) -> None:
    rows, force = truth["rows"], truth["force"]
    found = np.full_like(force, np.nan)
    bound = np.full(force.shape[:2], np.nan)
    likely = np.full((*force.shape[:2], 2), np.nan)
    outputs = np.full((*force.shape[:2], 8), np.nan)
    errors = np.full((*force.shape[:2], 8), np.nan)
    for i, row in enumerate(rows):
        try:
            step, bound[i] = table.step(**arguments(row), friction=friction)
        except wrcontact.InvalidArgument:  # outside
            continue
        found[i], likely[i], outputs[i], errors[i] = (step.force[:, :3], step.likely_errors, step.outputs,
                                                      step.output_errors)
    inside = np.isfinite(found[..., 0]) & np.isfinite(force[..., 0])
    print(f"{2 * len(rows)} wheels, {inside.mean():.1%} of them in the table")
    error = np.linalg.norm(found - force, axis=2) / np.maximum(force[..., 2], table.facts().load / 2)
    place = band_of(rows)
    print("band     wheels  median    99 %   worst | likely: median  mean  over true 99 % | beyond likely  bound")
    for name, low, high in [*BANDS, ("all", -np.inf, np.inf)]:
        chosen = inside & (place >= low) & (place < high)
        if not chosen.any():
            continue
        e, stated = error[chosen], likely[..., 0][chosen]
        true = np.quantile(e, 0.99)
        print(f"{name:8} {chosen.sum():6} {np.median(e):7.2%} {true:7.2%} {e.max():7.2%} | {np.median(stated):14.2%} "
              f"{stated.mean():6.2%} {stated.mean() / true:12.1f}    | {np.mean(e > stated):10.2%} "
              f"{np.sum(e > bound[chosen]):8}")
    print("error of derivatives, likely: median "
          f"{np.median(likely[..., 1][inside]):.1%}, at the centre (1 mm) "
          f"{np.median(likely[..., 1][inside & (abs(place) < 1)]):.1%}")
    names = table.output_names()
    for column, result in [(0, 0), (1, 1), (2, 2), (4, 3)]:
        chosen = inside & (force[..., 2] > 1e3) & np.isfinite(truth["results"][..., result])
        difference = np.abs(outputs[..., column] - truth["results"][..., result])[chosen]
        print(f"{names[column]:24} 99 % {np.quantile(difference, 0.99):9.3f}, median {np.median(difference):9.4f}; "
              f"beyond its likely error {np.mean(difference > errors[..., column][chosen]):.2%}")
    chosen = inside & (force[..., 2] > 1e3)
    work, exact = outputs[..., 0][chosen].sum(), truth["results"][..., 0][chosen].sum()
    print(f"wear number, sum of all: {work / exact - 1:+.2%} of the full theory's")
    print("share of wheels that a tolerance sends to the solver:", ", ".join(
        f"{tolerance:.0%}: {np.mean(likely[..., 0][inside] > tolerance):.1%} (by the bound "
        f"{np.mean(bound[inside] > tolerance):.1%})" for tolerance in (0.03, 0.05, 0.1)))


def measure_time(table: wrcontact.Table, rows: np.ndarray) -> None:
    """Of a wheel, with what Python adds: that of a step that is refused."""
    for derivatives in (False, True):
        table.step(**arguments(rows[0]), derivatives=derivatives)
        begin = time.process_time()
        for row in rows:
            try:
                table.step(**arguments(row), derivatives=derivatives)
            except wrcontact.InvalidArgument:
                pass
        print(f"derivatives {derivatives}: {(time.process_time() - begin) / len(rows) / 2 * 1e6:.1f} us a wheel")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("table", metavar="TABLE")
    parser.add_argument("states", nargs="*", metavar="STATES")
    parser.add_argument("--wheel", default="S1002", help="profile, a name or a file [S1002]")
    parser.add_argument("--count", type=int, default=2500, help="of wheelsets [2500]")
    parser.add_argument("--beyond", metavar="MM", type=float, default=-np.inf,
                        help="of these only wheelsets with a wheel that far towards its flange [all]")
    parser.add_argument("--friction", metavar=("LEFT", "RIGHT"), type=float, nargs=2, default=[0.2, 0.5])
    parser.add_argument("--save", metavar="FILE")
    parser.add_argument("--load", metavar="FILE")
    parser.add_argument("--time", action="store_true")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    table = wrcontact.Table()
    table.load(options.table)
    if options.time:
        measure_time(table, drawn_states(options.states, options.count, options.beyond))
        return
    truth = (dict(np.load(options.load)) if options.load
             else truth_of(drawn_states(options.states, options.count, options.beyond), options.wheel,
                           options.friction))
    if options.save:
        np.savez(options.save, **truth)
    compare(table, truth, options.friction)


if __name__ == "__main__":
    main()
