"""The evidence about curved contact (drivers/evidence/curved): its solver, and what it says."""
import json
import sys
from copy import deepcopy

import pytest

import wrcontact
from conftest import PROJECT

numpy = pytest.importorskip("numpy", reason="the evidence about curved contact needs numpy")
sys.path.insert(0, str(PROJECT / "drivers/evidence/curved"))
compare_curved = pytest.importorskip("compare_curved")
from curved_contact import Contact, solve_for_load  # noqa: E402

TRUTHS = PROJECT / "drivers/evidence/curved/truths.json"
FORCE_DIRECTION = PROJECT / "tests/reference/force_direction.json"
GRID = (96, 32)


def scene_at(lateral, rail="UIC60-Manchester", cant="1:40", load=80e3):
    keys = {"wheel": "S1002", "rail": rail, "back_to_back": 1360.0, "cant": cant,
            "lateral": lateral, "load_vertical": load, "yaw": 0.0}
    result, left = compare_curved.library_figures(keys, "pressures", 1e-3)
    return {**keys, "roll": float(result["roll"])}, left


@pytest.mark.filterwarnings("ignore::wrcontact.ContactWarning")
@pytest.mark.parametrize("lateral", [0, 5, 6.5])
def test_without_angles_it_is_the_librarys_plane(lateral):
    keys, left = scene_at(lateral)
    height = left.vertical - left.depth
    plane = wrcontact.solve(**keys, side="left", vertical=height, grid=[96, 32], tolerance=1e-9).left
    patch = plane.patches[0]
    along = numpy.array([0, numpy.cos(patch.plane_angle), numpy.sin(patch.plane_angle)])
    places = numpy.stack([patch.field(axis) for axis in "xyz"], -1)
    origin = numpy.array([0, patch.y, patch.z])
    contact = Contact(*compare_curved.bodies(keys), origin, patch.plane_angle, (0, 0), GRID,
                      compare_curved.MODULUS, plane=((places[:, 0] - origin) @ along, places[0, :, 0]))
    contact.solve(height)
    near = patch.undeformed_distance < 1
    assert abs(contact.gap - patch.undeformed_distance)[near].max() < 1e-6  # mm: where a step is closed
    # Rows that are inclined to the plane: docs/method.md.
    contact.gap = contact.gap * patch.row_scale
    contact.solve_gap(1e-9)
    contact.pressure = contact.pressure * patch.row_scale
    assert abs(contact.pressure - patch.pressure).max() < 2e-5 * patch.pressure.max()
    force = contact.force("rail")
    assert abs(force[1] - plane.pressure_force.y) < 2e-6 * plane.normal_force
    assert abs(force[2] - plane.pressure_force.z) < 2e-6 * plane.normal_force


@pytest.mark.parametrize("lateral, rail", [(0, "UIC60-Manchester"), (6, "60E1"), (8, "60E1")])
def test_the_force_is_the_derivative_of_the_energy(lateral, rail):
    keys, left = scene_at(lateral, rail)

    def solved(sideways, upwards):
        contact = compare_curved.curved_contact(
            *compare_curved.bodies({**keys, "lateral": lateral + sideways}), left.patches, (160, 48),
            height=left.vertical - left.depth + upwards)
        contact.solve(left.vertical - left.depth + upwards, 1e-9)
        return contact

    def derivative(direction, step=4e-3):
        def difference(by):
            moved = [solved(*(sign * by * component for component in direction)).energy()
                     for sign in (1, -1)]
            return (moved[0] - moved[1]) / (2 * by)
        return (4 * difference(step) - difference(2 * step)) / 3

    force = solved(0, 0).force()
    size = numpy.linalg.norm(force)
    assert abs(force[0]) < 1e-9 * size
    # The rail's normals alone are off by 1e-4 on the flange: the curve moves with both bodies.
    assert abs(force[1] + derivative((1, 0))) < 3e-5 * size
    assert abs(force[2] + derivative((0, 1))) < 3e-5 * size


def test_its_operator_is_symmetric_and_positive():
    keys, left = scene_at(5.5)
    contact = compare_curved.curved_contact(*compare_curved.bodies(keys), left.patches, (24, 12),
                                            height=left.vertical - left.depth)
    assert numpy.ptp(numpy.angle(contact.turning)) > 0.1
    random = numpy.random.default_rng(1)
    one, other = random.normal(size=(2, 24, 12))
    energy = numpy.sum(one * contact.displacement(one))
    assert energy > 0
    assert numpy.sum(one * contact.displacement(other)) == pytest.approx(
        numpy.sum(other * contact.displacement(one)), abs=1e-12 * energy)


@pytest.mark.parametrize("lateral", [6.1, 6.15])
def test_patches_far_apart_displace_each_other(lateral):
    """Tread and flange on one curve. Without interaction the depth is up to 9 % too small."""
    keys, left = scene_at(lateral, "56E1")
    assert left.patch_count == 2
    truth = compare_curved.curved_figures(keys, left, GRID)
    assert left.depth == pytest.approx(truth["depth"], rel=4e-3)
    assert left.pressure_force.y == pytest.approx(truth["lateral force"], abs=3e-3 * truth["normal force"])


@pytest.mark.skipif(not FORCE_DIRECTION.exists(), reason=f"no {FORCE_DIRECTION.name}")
@pytest.mark.parametrize("number", range(0, 23, 4))
def test_it_agrees_with_the_reference_of_the_forces(number):
    case = json.loads(FORCE_DIRECTION.read_text())["cases"][number]
    keys, left = scene_at(case["lateral_mm"], case["rail"], load=case["vertical_load_N"])
    curved, load = case["curved"], case["vertical_load_N"]
    # Its heights are those of a Poisson's ratio of 0.28.
    contact = compare_curved.curved_contact(
        *compare_curved.bodies({**keys, "roll": case["roll_rad"]}), left.patches, GRID,
        height=curved["z"], modulus=210e3 / (2 * (1 - 0.28**2)))
    height = solve_for_load([contact], load, curved["z"], left.depth)
    assert height == pytest.approx(curved["z"], abs=2e-4)
    assert contact.force()[1] == pytest.approx(curved["Fy"], abs=1e-4 * load)
    assert contact.pressure.max() == pytest.approx(curved["pmax"], rel=4e-3)


@pytest.fixture(scope="module")
def scenes():
    return json.loads(TRUTHS.read_text())


def test_stored_truths_are_what_it_finds(scenes):
    for scene in (scenes[0], scenes[50], scenes[150]):
        _, left = compare_curved.library_figures(scene["keys"], "pressures", 1e-3)
        found = compare_curved.curved_figures(scene["keys"], left, GRID, scene["truth"]["height"])
        about, stored = found.pop("about"), scene["truth"]["about"]
        assert about == pytest.approx(stored, abs=1e-3)
        errors = compare_curved.errors(found, scene["truth"])
        assert max(abs(errors[name]) for name in ("lateral force", "normal force")) < 1e-4
        assert abs(errors["depth"]) < 1e-3
        assert abs(errors["pmax"]) < 5e-3


def test_stated_errors_cover_the_difference_to_curved_contact(scenes):
    assert len(scenes) == 200
    for scene in scenes:
        compare_curved.judge(scene, 1e-3)
    for kind in ("forces", "pressures"):
        covered = [compare_curved.is_within(scene, kind) for scene in scenes]
        assert numpy.mean(covered) >= 0.95
        ratio = [scene[kind]["stated"] / compare_curved.largest(scene, kind)[0] for scene in scenes]
        assert numpy.median(ratio) <= 5
    worse = deepcopy(scenes[:20])
    for scene in worse:
        scene["truth"]["lateral force"] += 0.02 * scene["truth"]["normal force"]
        compare_curved.judge(scene, 1e-3)
    assert not any(compare_curved.is_within(scene, "forces") for scene in worse)
