"""The evidence about bodies that are no half-spaces (drivers/evidence/half_space_limits): its elements, and what it says."""
import json
import sys

import pytest

from conftest import PROJECT

numpy = pytest.importorskip("numpy", reason="the evidence about half-spaces needs numpy")
pytest.importorskip("scipy", reason="the evidence about half-spaces needs scipy")
sys.path.insert(0, str(PROJECT / "drivers/evidence/half_space_limits"))
import measure_half_space  # noqa: E402
from prismatic_body import Body  # noqa: E402
from sections import rail_60e1, rim_s1002, sector  # noqa: E402

STORED = PROJECT / "drivers/evidence/half_space_limits/influence.json"
# Of a force on the edge of a quarter-space with a Poisson's ratio of 1/2: prismatic_body.py.
EDGE_FACTOR = 2 * numpy.pi**2 / (numpy.pi**2 - 4)


@pytest.fixture(scope="module")
def stored():
    return json.loads(STORED.read_text())


@pytest.fixture(scope="module")
def half_space():
    return measure_half_space.solved(sector(numpy.pi, 20000.0, -3.5, 3.5, 1.0), 3, smallest=2e-5)


def test_the_middle_of_a_thick_block_is_a_half_space(half_space):
    for x, first in ((0.0, 3), (5.0, 0)):  # mm along; strips of 1 mm across
        difference = half_space.influence(numpy.array([x]), relative=False, less="A")[0, 0] * numpy.pi * half_space.modulus
        assert abs(difference * numpy.hypot(numpy.arange(7), x))[first:].max() < 1e-3


def test_its_influence_is_symmetric_and_positive(half_space):
    table = half_space.whole
    assert abs(table - table.transpose(0, 2, 1)).max() < 1e-10 * abs(table).max()
    assert numpy.linalg.eigvalsh(table).min() > 0


def test_an_incompressible_quarter_space_has_the_displacement_of_the_closed_form():
    assert measure_half_space.quarter_space_factor(2, 0.499, 8000.0) == pytest.approx(EDGE_FACTOR, rel=5e-3)


def test_sections_have_the_area_of_the_standard():
    outline = rail_60e1(0.0, -10.0, 2.0).outline
    following = numpy.roll(outline, -1, axis=0)
    area = 0.5 * numpy.sum(outline[:, 0] * following[:, 1] - outline[:, 1] * following[:, 0])
    assert area == pytest.approx(7670, rel=0.015)  # EN 13674-1: 76.70 cm^2; fillets are straight here


@pytest.mark.parametrize("name, section", [("rail", rail_60e1(-18.0, -28.1, 2.0)), ("wheel", rim_s1002(-20.0, -30.2, 2.0))])
def test_a_coarse_mesh_finds_the_stored_influence(stored, name, section):
    body = measure_half_space.real_body(section, 2)
    figures = measure_half_space.body_figures(body)
    fine = stored[name][str(measure_half_space.EDGES[-1])]
    table = numpy.array(fine["less curved"])
    place = numpy.interp(-numpy.array(figures["lateral"]), -numpy.array(fine["lateral"]), numpy.arange(len(table)))
    for i, j in ((0, 2), (0, 3), (1, 4)):
        k, m = int(place[i]), int(place[j])
        one, other = (numpy.array([1 - part, part]) for part in (place[i] - k, place[j] - m))
        # In 1/mm: A at 8 mm is 0.125.
        assert figures["less curved"][i][j] == pytest.approx(one @ table[k:k + 2, m:m + 2] @ other, abs=1.5e-3)


def test_a_rigid_motion_of_the_head_is_found():
    body = Body(rail_60e1(-18.0, -28.1, 2.0), 2)
    assert body.moments @ body.modes == pytest.approx(numpy.eye(3), abs=1e-9)


def test_stored_figures_are_what_the_page_says(stored):
    finest = stored["half-space"][str(measure_half_space.EDGES[-1])]
    assert max(value for distance, value in finest.items() if distance != "15 mm") < 1e-3
    for edges in map(str, measure_half_space.EDGES):
        assert stored["quarter-space"][edges]["0.499"] == pytest.approx(EDGE_FACTOR, rel=5e-3)
    bodies = [stored[name][str(measure_half_space.EDGES[-1])] for name in ("rail", "wheel")]
    rail, wheel, both = measure_half_space.pair_row(bodies, "less curved", -18.0, -26.0)
    assert rail > 0.01 and wheel < -0.01 and abs(both) < 0.005
    for scenes in json.loads(measure_half_space.CONTACTS.read_text()).values():
        for kinds in scenes.values():
            real = kinds["real bodies"]
            assert kinds["curved"]["pmax"] == pytest.approx(real["pmax"], rel=0.02)
            assert kinds["curved"]["share of corner"] == pytest.approx(real["share of corner"], abs=0.007)
            assert 0.1 < 1 - real["depth"] / kinds["curved"]["depth"] < 0.18
