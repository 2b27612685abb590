"""A scene for each class of warnings (cxx_core/base/warning.hpp), with words of its text.

Profiles are files made from built-in ones, with the faults that measurements have. Keys are those of a
scene; values are numbers, lists of numbers or words.
"""
import random
import warnings
from pathlib import Path
from typing import NamedTuple

import wrcontact


class Case(NamedTuple):
    """`words` stand in the warning; `wheel` gives its points, `name` the file.

    `tries` are lateral positions, of which the first with the warning is taken: rounding decides.
    """

    words: str
    keys: dict = {}
    wheel: object = None
    name: str = ""
    remark: str = ""
    tries: tuple = ()


def points_of(name, spacing=0.5):
    profile = wrcontact.Profile(name)
    count = int(profile.length / spacing)
    at = profile.at([profile.length * i / count for i in range(count + 1)])
    return sorted(zip(at.lateral, at.height))


def s1002(change, keep=lambda y: True):
    return [change(y, z) for y, z in points_of("S1002") if keep(y)]


def noisy(amplitude):
    draw = random.Random(1955)
    return [(y + draw.uniform(-amplitude, amplitude), z + draw.uniform(-amplitude, amplitude))
            for y, z in points_of("S1002", 0.25)]


def merged_scans():
    """The second scan begins before the first one ends, and half a millimetre above it."""
    points = points_of("S1002")
    return ([p for p in points if p[0] < 5] +
            [(y, z + 0.5) for y, z in points if y > -15])


def many_outliers():
    points = points_of("S1002")
    return [(y, z + 4.0 if i % 5 == 2 and y > -20 else z) for i, (y, z) in enumerate(points)]


def swinging():
    """A hole with a point 0.07 mm above each of its ends, where the curve stands upright."""
    points = points_of("S1002", 2.0)
    before, after = [p for p in points if p[0] < 1], [p for p in points if p[0] > 12]
    return (before + [(before[-1][0], before[-1][1] + 0.07)] +
            [(after[0][0], after[0][1] + 0.07)] + after)


def conformal(wider=1.002):
    """A wheel that is the rail turned over and wider."""
    profile = wrcontact.Profile("60E1")
    at = profile.at([profile.length * i / 399 for i in range(400)])
    return [(wider * y, -wider * z) for y, z in zip(at.lateral, at.height)]


def write_wheel(points, path):
    """As columns, or as a file of Simpack, whose signs are not guessed."""
    rows = "".join(f"{y!r} {z!r}\n" for y, z in points)
    if path.suffix == ".prw":
        rows = ("header.begin\n version = 1\n type = 1\nheader.end\nspline.begin\n"
                " units.len.f = 1000\n point.begin\n" + rows + " point.end\nspline.end\n")
    Path(path).write_text(rows, encoding="ascii")


GEOMETRY = {"solve.until": "geometry"}
QUICK = {"solve.accuracy": 0.1}
LEFT = {"solve.side": "left"}
FLANGE_AND_TREAD = {"track.rail": "56E1", "pose.lateral": 6.15}

CASES = {
    "profile_dimensions": Case("flange height 5", QUICK, lambda: s1002(lambda y, z: (y, 2 * z)),
                               "diameters.prw", "diameters given as radii"),
    "profile_origin": Case("the flange back is at lateral", QUICK,
                           lambda: s1002(lambda y, z: (y + 12, z)), "origin.prw",
                           "an origin off by 12 mm"),
    "profile_flange": Case("no flange found", {**QUICK, **LEFT},
                           lambda: s1002(lambda y, z: (y, z), lambda y: y < -28), "flange.wheel",
                           "a wheel that is only a flange"),
    "profile_signs": Case("the flange points to smaller radius", GEOMETRY,
                          lambda: s1002(lambda y, z: (y, -z)), "down.prw"),
    "profile_tilt": Case("turned by -1.00 degrees", QUICK,
                         lambda: s1002(lambda y, z: (y - 0.017455 * z, z + 0.017455 * y)),
                         "tilted.prw", "a wheel measured with a tilt of one degree"),
    "profile_gap": Case("gap of 13", QUICK,
                        lambda: s1002(lambda y, z: (y, z), lambda y: not -5 < y < 8), "hole.wheel",
                        "a hole of 13 mm under the contact"),
    "profile_step": Case("step of 2", QUICK,
                         lambda: s1002(lambda y, z: (y, z + (2 if y > 5 else 0))), "step.wheel"),
    "profile_overlap": Case("not single-valued", QUICK, merged_scans, "merged.wheel",
                            "two merged scans"),
    "profile_outliers": Case("points are off the line of their neighbours", QUICK, many_outliers,
                             "outliers.wheel"),
    "profile_noise": Case("the points scatter by", QUICK, lambda: noisy(0.05), "noise.wheel",
                          "noise of 0.05 mm"),
    "profile_swing": Case("the curve swings by", QUICK, swinging, "swing.wheel"),
    "profile_end": Case("contact at the end of a profile", {"pose.lateral": -82.2, **LEFT, **QUICK}),
    "flange_tip": Case("first touch is on the flange tip", {"pose.lateral": 45, **LEFT, **QUICK}),
    "chamfer": Case("first touch is on the wheel's chamfer",
                    {"track.gauge": 1600, "pose.roll": 0, **GEOMETRY}),
    "no_contact": Case("no contact at this height", {"pose.vertical": 470}),
    "no_load": Case("is treated as zero load", {"load.both": 1e-9}),
    "not_converged": Case("not converged: ", {
        "solve.grid": [256, 128], "solve.method": "paper", "solve.tolerance": 1e-13,
        **LEFT}),
    "not_settled": Case("not settled", {
        "track.inclination": 0, "pose.roll": 0, "solve.accuracy": 1e-2, **LEFT},
        lambda: conformal(1.004), "conformal.prw", "",
        tuple(3.3 + 0.04 * step for step in range(21))),
    "rounding": Case("the rounding of positions", {"load.both": 1e-6, **LEFT}),
    "accuracy": Case("not reached: estimated error", {"pose.lateral": -60, **LEFT, **QUICK}),
    "element_limit": Case("solve.element_limit = 1000 permits fewer", {
        "solve.element_limit": 1000, "solve.accuracy": 3e-4, **LEFT}),
    "ridge": Case("rad inside the contact", {
        "track.rail": "49E1", "wheelset.radius": 2175, "track.inclination": 0.138, "pose.lateral": -7.9,
        "load.both": 368e3, "solve.accuracy": 0.01, **LEFT}),
    "grid_edge": Case("contact reaches the edge of the grid", {"solve.grid": [4, 4], **LEFT}),
    "patch_turn": Case("the rail turns by", {"pose.lateral": 5, "solve.accuracy": 0.004, **LEFT}),
    "vertical_angle": Case("vertical distances at a contact angle", {
        "solve.method": "paper", "pose.lateral": 6, **LEFT, **QUICK}),
    "patch_left_out": Case("that patch is left out", {
        "solve.method": "paper", **FLANGE_AND_TREAD, **LEFT, **QUICK}),
    "close_patches": Case("patches almost touch", {
        "track.rail": "UIC60-Manchester", "pose.lateral": 6.2632, "pose.yaw": -0.01971,
        "track.inclination": 0.05, "load.both": 113710, **LEFT, "solve.joining_distance": 0.02,
        "solve.accuracy": 8e-4}),
    "model_validity": Case("pmax may be off by tens of per cent", {
        "solve.model": "hertz", "pose.lateral": 5, **LEFT}),
    "no_interaction": Case("known in part", {
        **FLANGE_AND_TREAD, **LEFT}),
    "pressure": Case("is more than steel can carry", {"pose.lateral": 6.5, **QUICK, **LEFT}),
    "first_pressing": Case("as at a first pressing", {
        "material.rail.yield_stress": 500, "load.both": 1.2e5, **QUICK, **LEFT}),
    "creep_accuracy": Case("creep forces: accuracy 0.001 not reached", {
        "creepage.longitudinal": 0.001, "solve.element_limit": 1000, **LEFT}),
    "steady_forces": Case("creep forces change within a few contact lengths", {
        "motion.speed": 2e4, "motion.pitch": 43.6, "motion.vertical": 100, "pose.vertical": 459.75,
        "solve.derivatives": "yes", "solve.accuracy": 0.01, **LEFT}),
    "unlike_materials": Case("creep forces of unlike materials", {
        "creepage.longitudinal": 0.001, "material.rail.youngs_modulus": 70000,
        "solve.creep": "linear", **LEFT, **QUICK}),
    "torque_exceeded": Case("more than friction can transmit", {
        "motion.speed": 2e4, "motion.pitch": "free", "motion.torque": 3e7, **QUICK}),
    "torque_ambiguous": Case("also balances the torque", {
        "motion.speed": 2e4, "motion.pitch": "free", "motion.torque": 12e6,
        "friction.limit_ratio": 0.3, "friction.decay": 0.001, **QUICK}),
    "unused_key": Case("load.left is not used: pose.vertical is set", {
        "load.left": 70000, "pose.vertical": 459.9, **QUICK, **LEFT}),
    "implausible_input": Case("is below 1 kN", {"load.both": 80, **QUICK, **LEFT}),
}


def scene_of(name, folder):
    """Keys of the scene of a class; its profile becomes a file."""
    case = CASES[name]
    keys = dict(case.keys)
    if case.wheel:
        path = folder / case.name
        if not path.exists():
            write_wheel(case.wheel(), path)
        keys = {"wheelset.wheel": str(path), **keys}
    for lateral in case.tries:
        keys["pose.lateral"] = lateral
        if any(case.words in text for text in texts_of(keys)):
            break
    return keys


def texts_of(keys):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            return wrcontact.solve(**keys).warnings
        except wrcontact.NotConverged as error:
            return error.result.warnings
        except wrcontact.NoContact:
            return []
