"""The evidence by finite elements in contact (drivers/evidence/finite_elements): its elements, and what it says."""
import json
import shutil
import sys

import pytest

from conftest import PROJECT

numpy = pytest.importorskip("numpy", reason="the evidence by finite elements needs numpy")
pytest.importorskip("scipy", reason="the evidence by finite elements needs scipy")
FOLDER = PROJECT / "drivers/evidence/finite_elements"
sys.path.insert(0, str(FOLDER))
import compare_contacts  # noqa: E402
import compare_yielding  # noqa: E402
import hertz  # noqa: E402
from scenes import ALL_CASES, CASES, MATERIALS, blocks_of  # noqa: E402

# Errors of the coarse mesh halve where they are largest, those of the area; so the last change is the error that is left.
FIRST_ORDER = 1.25
# Points 10 mm deep in blocks of 50 mm approach each other 0.7 to 0.9 % more than in half-spaces, at either mesh.
FINITE_BLOCKS = 0.015
SMALLEST_RADIUS = 5.0  # mm, of lines of nodes: 4 mm below the gauge corner's 13 mm, where the lines inwards begin to bend


@pytest.fixture(scope="module")
def results():
    return json.loads((FOLDER / "results.json").read_text())


@pytest.mark.skipif(shutil.which("ccx") is None, reason="needs ccx (Debian package calculix-ccx)")
def test_crossed_cylinders_have_the_pressures_of_hertz(tmp_path):
    truth = hertz.closed_form()
    coarse, fine = (hertz.finite_elements(mesh, tmp_path / str(mesh)) for mesh in (1, 2))
    for key in ("pmax", "area"):
        assert abs(fine[key] - truth[key]) < FIRST_ORDER * abs(fine[key] - coarse[key]), key
        assert abs(fine[key] - coarse[key]) < 0.05 * truth[key], key  # measured: 1.8 and 4.5 %
    for found in (coarse, fine):
        assert found["approach 10 mm deep"] == pytest.approx(truth["approach 10 mm deep"], rel=FINITE_BLOCKS)
        assert found["Fz"] == pytest.approx(hertz.LOAD, rel=1e-6)
    # On the coarse mesh contact reaches the edge of the core, whose nodes count for half an element.
    assert fine["contact force"] == pytest.approx(hertz.LOAD, rel=1e-3)


def test_the_closed_form_is_that_of_a_sphere_if_radii_are_equal(monkeypatch):
    monkeypatch.setattr(hertz, "WHEEL", 100.0)
    monkeypatch.setattr(hertz, "RAIL", 100.0 - 1e-4)
    found = hertz.closed_form()
    half_width = (0.75 * hertz.LOAD * 100.0 / hertz.MODULUS)**(1 / 3)
    assert found["area"] == pytest.approx(numpy.pi * half_width**2, rel=1e-3)
    assert found["depth"] == pytest.approx(half_width**2 / 100.0, rel=1e-3)


@pytest.mark.parametrize("name", ALL_CASES)
def test_nodes_lie_on_the_profile_and_no_element_is_folded(name):
    scene, blocks = blocks_of(name, 1, "elastic")
    assert blocks.lower.worst_corner() > 0.1 and blocks.upper.worst_corner() > 0.3
    surface = blocks.lower.nodes[:, 0, 0, 1:]
    dense = scene.section.at(numpy.linspace(0, scene.section.arc[-1], 200001))
    assert max(numpy.min(numpy.hypot(*(dense - point).T)) for point in surface) < 1e-3  # half of the points' distance
    # The wheel's nodes on its own surface: their radius about the axle is that of the profile.
    centre = numpy.array([0.0, blocks.wheel.lateral, blocks.wheel.vertical])
    c, s = numpy.cos(blocks.wheel.roll), numpy.sin(blocks.wheel.roll)
    axle = (blocks.upper.nodes[:, :, 0] - centre) @ numpy.array([[1, 0, 0], [0, c, s], [0, -s, c]]).T
    radius = blocks.wheel.radius_at(axle[..., 1])[0]
    assert abs(numpy.hypot(axle[..., 0], axle[..., 2]) - radius).max() < 1e-8


def test_nodes_between_larger_elements_move_with_the_place_they_are_at():
    _, blocks = blocks_of("corner", 1, "elastic")
    for body in (blocks.lower, blocks.upper):
        for node, masters, weights in body.hanging:
            assert sum(weights) == pytest.approx(1.0)
            corners = body.points[masters]
            length = max(numpy.linalg.norm(corners - corners[0], axis=-1))
            off = numpy.linalg.norm(body.points[node] - numpy.array(weights) @ corners)
            assert off < length**2 / (8 * SMALLEST_RADIUS)  # the sagitta of a curved face


def test_stored_results_belong_to_the_meshes_and_materials_of_the_program(results):
    for key, run in results.items():
        name, material, mesh = key.split()
        assert material in MATERIALS and int(mesh) in compare_contacts.MESHES
        assert f"--case {name} --mesh {mesh} --material {material}" in run["command"]
    _, blocks = blocks_of("corner", 1, "elastic")
    assert len(blocks.model.nodes) == results["corner elastic 1"]["nodes"]
@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("material", MATERIALS)
def test_three_meshes_are_stored_of_each_contact_at_all_loads(results, name, material):
    runs = compare_contacts.stored(results, name, material)
    assert len(runs) >= 3
    loads = [80e3] if material == "elastic" else [20e3, 40e3, 60e3, 80e3]
    for steps in runs.values():
        assert [step["Fz"] for step in steps] == pytest.approx(loads, abs=1.0)


def test_steel_that_does_not_yield_changes_nothing(results):
    """Below 900 MPa, on the tread: what yields there is the error of both calculations."""
    yielding, without = (compare_contacts.stored(results, "tread", material) for material in ("plastic", "unyielding"))
    for mesh, steps in yielding.items():
        for step, other in zip(steps, without[mesh], strict=True):
            assert step["pmax"] == pytest.approx(other["pmax"], rel=5e-3)


def test_yielding_lessens_pmax_of_each_stored_contact_at_its_load():
    cases = compare_yielding.cases()
    assert {case["contact"] for case in cases} == set(ALL_CASES)
    for case in cases:
        plastic, elastic = case["plastic"], case["unyielding"]
        assert plastic["Fz"] == pytest.approx(case["load"], abs=1.0) and elastic["Fz"] == pytest.approx(case["load"], abs=1.0)
        assert 0.3 * elastic["pmax"] < plastic["pmax"] < 1.005 * elastic["pmax"]
