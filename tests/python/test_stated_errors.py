"""Whether stated errors cover the difference to contact along curves, of which 200 solutions are stored (docs/evidence/curved.md)."""
import json
import warnings
from copy import deepcopy

import pytest

import wrcontact
from conftest import PROJECT

numpy = pytest.importorskip("numpy", reason="the statistics of stated errors need numpy")
TRUTHS = PROJECT / "tests/reference/curved_contact.json"
FORCES = ("lateral force", "normal force", "depth", "moment")
QUANTITIES = {"forces": FORCES, "pressures": (*FORCES, "pmax")}


def solved(keys, accuracy_of):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wrcontact.ContactWarning)
        return wrcontact.solve(**keys, side="left", accuracy_of=accuracy_of, accuracy=1e-3, poisson=0.3, youngs_modulus=210e3,
                               curved="no").left


def largest_error(left, truth, accuracy_of):
    """Relative, of the quantities that this accuracy is of; the stored moment is about the point `about`."""
    first, force = left.patches[0], left.pressure_force
    moment = (left.pressure_moment.x + (first.y - truth["about"][0]) * force.z - (first.z - truth["about"][1]) * force.y)
    normal = truth["normal force"]
    errors = {"lateral force": (force.y - truth["lateral force"]) / normal,
              "normal force": (left.normal_force - normal) / normal,
              "depth": (truth["height"] - (left.vertical - left.depth)) / truth["depth"],
              "moment": (moment - truth["moment"]) / (normal * truth["semi-axis"]),
              "pmax": (left.pmax - truth["pmax"]) / truth["pmax"]}
    return max(abs(errors[name]) for name in QUANTITIES[accuracy_of])


@pytest.fixture(scope="module")
def scenes():
    return json.loads(TRUTHS.read_text())


@pytest.mark.parametrize("accuracy_of", QUANTITIES)
def test_stated_errors_cover_the_difference_to_curved_contact(scenes, accuracy_of):
    assert len(scenes) == 200
    wheels = [solved(scene["keys"], accuracy_of) for scene in scenes]
    stated = numpy.array([left.error_estimate for left in wheels])
    error = numpy.array([largest_error(left, scene["truth"], accuracy_of) for left, scene in zip(wheels, scenes)])
    assert numpy.mean(error <= stated) >= 0.95
    assert numpy.median(stated / error) <= 5
    for left, scene in zip(wheels[:20], scenes):
        truth = deepcopy(scene["truth"])
        truth["lateral force"] += 0.02 * truth["normal force"]
        assert largest_error(left, truth, accuracy_of) > left.error_estimate


# Tread and flange of S1002 on 56E1 on one curve, 80 kN: depth in mm, lateral and normal force in N.
FAR_APART = {6.1: (0.08415, -16427.0), 6.15: (0.07635, -21829.0)}


@pytest.mark.filterwarnings("ignore::wrcontact.ContactWarning")
@pytest.mark.parametrize("lateral", FAR_APART)
def test_patches_far_apart_displace_each_other(lateral):
    """Without interaction the depth is up to 9 % too small."""
    depth, lateral_force = FAR_APART[lateral]
    left = solved({"wheel": "S1002", "rail": "56E1", "back_to_back": 1360.0, "inclination": "1:40", "lateral": lateral,
                   "load_both": 80e3, "yaw": 0.0}, "pressures")
    assert left.patch_count == 2
    assert left.depth == pytest.approx(depth, rel=4e-3)
    assert left.pressure_force.y == pytest.approx(lateral_force, abs=3e-3 * left.normal_force)
