#!/usr/bin/env python3
"""Compares derivatives of forces with differences of whole solutions, on rails and wheels that vary.

Random wheels as a vehicle simulation has them: position and height prescribed, creep forces from the
motion of the wheelset. Drawn are a slices file of the folders or a wheel S1002 with waves of its
radius (order 1, 3 or 20), the position along the track, the angle of the axle, the lateral position
(-8 to 8 mm), yaw (-20 to 20 mrad), roll (-1 to 1 mrad), the load that fixes the height (1 to 150 kN)
and the velocities (5 to 60 m/s, creepages up to 0.3 %, and a vertical velocity along the slope of the
contact). A rail's list carries a wheel S1002 of 460 mm, a wheel's list runs on 60E1. With --constant
S1002 and LMA run on standard rails instead.

Each column of dfdq of a step is compared with central differences over two lengths, the shorter a
tenth of the longer. The longer one moves the contact by 10 um (angles: that length over the arm), or,
if that is less, by a twentieth of its depth along the normal. Their distance from each other, `differences`
in the table, is how uncertain the reference is. The error is taken from the nearer one, as in
compare_jacobian: an element that changes sides within a step shows in one of them. Differences are
solved at the finer of the accuracy and 1e-3 (--reference). dfdq has differences for `along` and
`pitch` too (over 5 um, at the accuracy of the scene); the table then tells whether their length and
their accuracy suffice.

The error of a column is that of its largest deviation, moments over 750 mm, over
  column    the largest entry of the column itself;
  no slip   the larger of that and the same entry with the linear theory (solve.creep = "linear"):
            what the column would be if the contact stuck. A wheel that slides has hardly any slope by
            yaw, and an error over hardly anything says little;
  1 mrad    for `along` and `pitch`, the larger of that and the largest entry of the column `vertical`
            times 1 mrad. On a rail whose height changes by e mm per mm, a step along it changes the
            overlap as e steps of height do, so the column is about e times that of the height. It is 0
            where the rail is level, and its error over itself then means nothing. 1 mrad is the slope
            of ordinary track irregularities (1 mm over 6 m of a half wave); a simulation that puts up
            with an error E of its stiffness does not notice E mrad of slope. For `pitch` the step is
            that of the circumference.
Contacts that an end of the rail or of the wheel cuts, as the end of a part of a crossing, have a table of
their own: elements count there by their centres, and a row that passes the end carries the largest
pressures, so forces jump and have no derivatives in the strict sense.
Forces in N, lengths in mm. The same seed gives the same positions. Positions without contact, or at
which a solution does not converge, are counted and left out.

  compare_derivatives.py FOLDER... [--positions N] [--seed N] [--accuracy A] [--worst K]
  compare_derivatives.py --constant [...]          on profiles that are the same everywhere
  compare_derivatives.py FOLDER... --only 17       one position: forces, columns, differences
"""
import argparse
import collections
import dataclasses
import math
import pathlib
import random
import sys
import warnings

import numpy as np
import wrcontact
from numpy.typing import NDArray
from random_positions import KEYS, stretch_of

Array = NDArray[np.float64]
ARM = 750.0  # mm, from the wheelset's centre to the contacts
SHORTER = 0.1  # of the longer step
LONGER = 1e-2  # mm, at the contact
OF_DEPTH = 0.05  # of the penetration, at most
ORDINARY_SLOPE = 1e-3
BEYOND = 500.0  # mm, more than any distance of rail and wheel
COLUMNS = {"along": 0, "lateral": 1, "vertical": 2, "roll": 3, "pitch": 4, "yaw": 5}
ORDER = ("lateral", "vertical", "roll", "yaw", "along", "pitch")  # of the table
WAVES = {1: 0.5, 3: 0.1, 20: 0.05}  # order and largest amplitude, mm
STANDARD = {"S1002": 1360.0, "LMA": 1353.0}  # wheels, back to back in mm
RAILS = ("60E1", "CHN60", "54E1", "60E2")


@dataclasses.dataclass
class Place:
    """A wheel at a prescribed position."""

    scene: wrcontact.Scene
    name: str
    wheel: int  # 0 left, 1 right
    position: Array
    velocity: Array
    depth: float
    normal: Array
    varying: tuple[str, ...]  # columns that are not 0: along, pitch


def draw_scene(draw: random.Random, lists: dict[pathlib.Path, tuple[float, float]],
               constant: bool) -> tuple[wrcontact.Scene, str, tuple[str, ...]]:
    """Profiles, position and load, and which of the two columns it has."""
    scene = wrcontact.Scene()
    scene["wheelset.radius"] = 460.0
    varying: tuple[str, ...] = ()
    kind = "constant" if constant else draw.choice(["rail", "rail", "wheel"])
    files = [path for path in lists if KEYS[path.suffix] == "track.rail"]
    wheels: list[pathlib.Path | None] = [path for path in lists if path not in files]
    if kind == "constant":
        name = draw.choice(list(STANDARD))
        rail = draw.choice(RAILS)
        scene["wheelset.wheel"] = name
        scene["wheelset.back_to_back"] = STANDARD[name]
        scene["track.rail"] = rail
        name = f"{name} on {rail}"
    elif kind == "rail":
        path = draw.choice(files)
        name = path.name
        scene["track.rail"] = {"file": path, "origin": 750.0}
        scene["track.inclination"] = 0.0
        scene["pose.longitudinal"] = draw.uniform(*lists[path])
        varying = ("along",)
    else:
        wheel = draw.choice(wheels + [None] * max(1, len(wheels)))
        if wheel is None:
            order = draw.choice(list(WAVES))
            scene["wheelset.harmonics"] = [order, WAVES[order] * draw.uniform(0.1, 1.0),
                                           draw.uniform(-math.pi, math.pi)]
            name = f"order {order}"
        else:
            scene["wheelset.wheel"] = str(wheel)
            scene["wheelset.radius"] = 450.0
            name = wheel.name
        turn = (-math.pi, math.pi) if wheel is None else lists[wheel]
        scene["pose.pitch"] = draw.uniform(*turn)
        varying = ("pitch",)
    scene["pose.lateral"] = draw.uniform(-8.0, 8.0)
    scene["pose.yaw"] = draw.uniform(-0.02, 0.02)
    scene["pose.roll"] = draw.uniform(-1e-3, 1e-3)
    scene["load.both"] = 10.0 ** draw.uniform(3.0, 5.17)
    scene["solve.side"] = draw.choice(["left", "right"])
    return scene, name, varying


def draw_place(draw: random.Random, lists: dict[pathlib.Path, tuple[float, float]], constant: bool,
               accuracy: float, solver: wrcontact.Solver) -> Place:
    scene, name, varying = draw_scene(draw, lists, constant)
    scene["solve.accuracy_of"] = "forces"
    scene["solve.accuracy"] = accuracy
    speed = draw.uniform(5e3, 6e4)
    pitch_rate = speed / float(scene["wheelset.radius"]) * (1.0 + draw.uniform(-3e-3, 3e-3))
    velocity = np.array([speed, speed * draw.uniform(-3e-3, 3e-3), speed * draw.uniform(-1e-3, 1e-3),
                         draw.uniform(-0.05, 0.05), pitch_rate, draw.uniform(-0.05, 0.05)])
    result = solver.solve(scene)
    side = scene["solve.side"]
    force = np.array([result[f"{side}.pressure_force.{axis}"] for axis in "xyz"])
    normal = force / np.linalg.norm(force)
    velocity[2] -= speed * normal[0] / normal[2]  # up the slope
    position = np.array([scene["pose.longitudinal"], scene["pose.lateral"],
                         result[f"{side}.vertical"] - result[f"{side}.depth"],
                         result["roll"], scene["pose.pitch"], scene["pose.yaw"]])
    return Place(scene, name, 0 if side == "left" else 1, position, velocity,
                 result[f"{side}.depth"] * abs(normal[2]), normal, varying)


def arms(place: Place) -> Array:
    """How the contact moves by each position: mm a mm or a rad, along the track, across, up."""
    across = ARM if place.wheel == 0 else -ARM
    radius = place.scene["wheelset.radius"]
    return np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0],
                     [0.0, radius, across], [radius, 0.0, 0.0], [-across, 0.0, 0.0]])


def longer_step(place: Place, which: int) -> float:
    motion = arms(place)[which]
    along_normal = abs(float(motion @ place.normal))
    step = LONGER / float(np.linalg.norm(motion))
    if along_normal > 0.0:
        step = min(step, OF_DEPTH * place.depth / along_normal)
    return step


def over_arm(column: Array) -> Array:
    return np.concatenate([column[:3], column[3:] / ARM])


def difference(place: Place, which: int, step: float, solver: wrcontact.Solver) -> Array:
    ends = []
    for sign in (1.0, -1.0):
        position = place.position.copy()
        position[which] += sign * step
        ends.append(solver.step(place.scene, position, place.velocity).force[place.wheel])
    return over_arm((ends[0] - ends[1]) / (2.0 * step))


@dataclasses.dataclass
class Found:
    """Columns of one position, by name."""

    number: int
    place: Place
    column: dict[str, Array]
    no_slip: dict[str, Array]
    longer: dict[str, Array]
    shorter: dict[str, Array]
    is_cut: bool = False  # by an end of rail or wheel

    def names(self) -> list[str]:
        return [name for name in ORDER if name not in ("along", "pitch") or name in self.place.varying]

    def size(self, name: str) -> float:
        return float(np.max(np.abs(self.longer[name])))

    def deviation(self, name: str) -> float:
        return min(float(np.max(np.abs(self.column[name] - other[name])))
                   for other in (self.longer, self.shorter))

    def uncertainty(self, name: str) -> float:
        return float(np.max(np.abs(self.shorter[name] - self.longer[name])))

    def scales(self, name: str) -> dict[str, float]:
        size = self.size(name)
        scales = {"column": size, "no slip": max(size, float(np.max(np.abs(self.no_slip[name]))))}
        if name in ("along", "pitch"):
            arm = float(self.place.scene["wheelset.radius"]) if name == "pitch" else 1.0
            scales["1 mrad"] = max(size, ORDINARY_SLOPE * arm * self.size("vertical"))
        return scales


def is_cut(patch: wrcontact.result.Group) -> bool:
    """Whether an element under pressure lies beside one without a rail or a wheel."""
    without = patch.field("undeformed_distance") > BEYOND
    beside = np.zeros_like(without)
    beside[1:] |= without[:-1]
    beside[:-1] |= without[1:]
    beside[:, 1:] |= without[:, :-1]
    beside[:, :-1] |= without[:, 1:]
    return bool(np.any(beside & (patch.field("pressure") > 0.0)))


def compare(number: int, place: Place, reference: float, solver: wrcontact.Solver) -> Found:
    scene = place.scene

    def columns() -> dict[str, Array]:
        rates = solver.step(scene, place.position, place.velocity, derivatives=True).by_position
        assert rates is not None  # since they were requested
        return {name: over_arm(rates[place.wheel][which]) for name, which in COLUMNS.items()}

    found = Found(number, place, columns(), {}, {}, {})
    found.is_cut = any(is_cut(patch) for patch in scene.result[("left", "right")[place.wheel]].patches)
    scene["solve.creep"] = "linear"
    found.no_slip = columns()
    scene["solve.creep"] = "auto"
    accuracy = float(scene["solve.accuracy"])
    scene["solve.accuracy"] = min(accuracy, reference)
    for name in found.names():
        step = longer_step(place, COLUMNS[name])
        found.longer[name] = difference(place, COLUMNS[name], step, solver)
        found.shorter[name] = difference(place, COLUMNS[name], SHORTER * step, solver)
    scene["solve.accuracy"] = accuracy
    return found


def share_of(deviation: float, size: float) -> float:
    """A column that is 0 throughout, as on the round part of a wheel with a flat, has no error."""
    return deviation / size if size > 0.0 else 0.0 if deviation == 0.0 else math.inf


def quantiles(values: list[float]) -> str:
    return " ".join(f"{number:8.1e}" for number in np.quantile(values, [0.5, 0.95, 0.99, 1.0]))


def share_within(values: list[float], limit: float) -> float:
    return 100.0 * sum(value <= limit for value in values) / len(values)


def print_table(all_found: list[Found], accuracy: float) -> None:
    print(f"{'by':9s} {'over':8s} {'scenes':>6s} | {'median':>8s} {'95 %':>8s} {'99 %':>8s} {'worst':>8s} |"
          f" within {accuracy:g}, 1e-2 | differences: 95 %, worst; within of those that agree")
    for name in ORDER:
        known = [found for found in all_found if name in found.names()]
        for scale in known[0].scales(name) if known else ():
            sizes = [found.scales(name)[scale] for found in known]
            errors = [share_of(found.deviation(name), size) for found, size in zip(known, sizes)]
            apart = [share_of(found.uncertainty(name), size) for found, size in zip(known, sizes)]
            sure = [error for error, far in zip(errors, apart) if far <= 0.5 * accuracy]
            certain = f"{share_within(sure, accuracy):5.1f} % of {len(sure)}" if sure else "none"
            print(f"{name:9s} {scale:8s} {len(known):6d} | {quantiles(errors)} |"
                  f" {share_within(errors, accuracy):5.1f} % {share_within(errors, 1e-2):5.1f} % |"
                  f" {np.quantile(apart, 0.95):8.1e} {max(apart):8.1e}; {certain}")


def print_worst(all_found: list[Found], count: int) -> None:
    for name in ORDER:
        known = [found for found in all_found if name in found.names()]
        known.sort(key=lambda found: -share_of(found.deviation(name), found.size(name)))
        if known and count:
            print(f"\n{name}: position, profile, error over each scale, differences apart over the column,"
                  " column over 1 mrad of height")
        for found in known[:count]:
            errors = "  ".join(f"{scale} {share_of(found.deviation(name), size):.1e}"
                               for scale, size in found.scales(name).items())
            arm = float(np.linalg.norm(arms(found.place)[COLUMNS[name]]))
            slope = found.size(name) / (1e-3 * arm * found.size("vertical"))
            print(f"{found.number:5d} {found.place.name:22s} {errors}  apart"
                  f" {share_of(found.uncertainty(name), found.size(name)):.1e}  {slope:.2g}")


def print_one(found: Found) -> None:
    place = found.place
    print(f"position {found.number}, {place.name}, {('left', 'right')[place.wheel]}:"
          f" q = {place.position.tolist()}, v = {place.velocity.tolist()}, depth {place.depth:.4g} mm,"
          f" load {place.scene['load.both']:.4g} N")
    for name in found.names():
        print(f"{name}: Fx, Fy, Fz, Mx, My, Mz (moments over {ARM:g} mm)")
        for title, column in (("dfdq", found.column), ("longer", found.longer),
                              ("shorter", found.shorter), ("no slip", found.no_slip)):
            print(f"  {title:8s}" + " ".join(f"{entry:12.5g}" for entry in column[name]))


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=pathlib.Path, nargs="*", help="with .slcs and .slcw files")
    parser.add_argument("--positions", type=int, default=120, help="default 120")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--accuracy", type=float, default=1e-3, help="of forces, default 1e-3")
    parser.add_argument("--reference", type=float, default=1e-3,
                        help="accuracy of the differences, if finer; default 1e-3")
    parser.add_argument("--constant", action="store_true", help="profiles that do not vary")
    parser.add_argument("--worst", type=int, default=0, help="list so many positions of each column")
    parser.add_argument("--only", type=int, nargs="*", help="these positions, in detail")
    options = parser.parse_args()
    warnings.simplefilter("ignore")
    lists = {path: stretch_of(path) for folder in options.folder
             for path in sorted(folder.iterdir()) if path.suffix in KEYS}
    if not options.constant and not any(path.suffix == ".slcs" for path in lists):
        parser.error("give a folder with .slcs files, or --constant")
    solver = wrcontact.Solver()
    numbers = options.only if options.only is not None else range(options.positions)
    ended: collections.Counter[str] = collections.Counter()
    all_found: list[Found] = []
    for number in numbers:
        draw = random.Random(1000003 * options.seed + number)
        try:
            place = draw_place(draw, lists, options.constant, options.accuracy, solver)
            all_found.append(compare(number, place, options.reference, solver))
        except (wrcontact.NoContact, wrcontact.NotConverged, wrcontact.InvalidArgument) as error:
            ended[type(error).__name__] += 1
        print(f"\r{number} of {len(numbers)}", end="", file=sys.stderr)
    print(file=sys.stderr)
    if options.only is not None:
        for found in all_found:
            print_one(found)
    text = "".join(f", {count} {name}" for name, count in sorted(ended.items()))
    print(f"{len(all_found)} positions{text}; accuracy {options.accuracy:g}, seed {options.seed}")
    for cut, title in ((False, "contacts within rail and wheel"), (True, "cut by an end")):
        group = [found for found in all_found if found.is_cut == cut]
        if group:
            print(f"\n{len(group)} {title}")
            print_table(group, options.accuracy)
            print_worst(group, options.worst)
    return 0


if __name__ == "__main__":
    sys.exit(main())
