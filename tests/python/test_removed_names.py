"""What programs of earlier versions read and set is refused with a text that names its successor."""
import numpy as np
import pytest

import wrcontact


@pytest.fixture(scope="module")
def result():
    return wrcontact.solve(lateral=3, yaw=1e-3, speed=2e4, accuracy=1e-2)


def test_removed_results_name_their_successors(result):
    patch = result.left.patches[0]
    for read, successor in ((lambda: patch.closeness, "use left.patches.0.coupling_weight"),
                            (lambda: result.left.moment, "use left.pressure_moment"),
                            (lambda: result["left.moment.x"], "use left.pressure_moment.x"),
                            (lambda: patch["semi_axes.0"], "use left.patches.0.semi_axes.longitudinal"),
                            (lambda: patch.grid[0], "use left.patches.0.grid.lateral")):
        with pytest.raises((wrcontact.UnknownName, AttributeError), match=f"is not a result any more: {successor}"):
            read()


def test_pairs_are_no_lists(result):
    """They were: across, along = patch.element_size."""
    patch = result.left.patches[0]
    assert tuple(map(int, (patch.grid.lateral, patch.grid.longitudinal))) == patch.pressure.shape
    for pair in (patch.element_size, patch.creep_grid):
        with pytest.raises(TypeError, match="is not a list; it has lateral, longitudinal"):
            list(pair)


def test_plain_forces_are_totals(result):
    left = result.left
    assert left.lateral_force == left.total.force.y > 5e3 > 0 > left.pressure_force.y


def test_members_of_patches_have_one_name(result):
    table = result.patch_table()
    assert len(set(table.dtype.names)) == len(table.dtype.names)
    for old in ("largest_pressure", "contact_angle", "lateral_semi_axis", "spin_creepage"):
        assert old not in table.dtype.names
    for name in ("pmax", "angle", "semi_axes_lateral", "creepage_spin"):
        assert table[name][0] == result["left.patches.0." + name.replace("_l", ".l").replace("_s", ".s")]


def test_rolling_contact_names_the_successor():
    contact = wrcontact.RollingContact(np.full((4, 4), 100.0), 1.0, 1.0, longitudinal_creepage=-1e-3)
    contact.solve()
    assert contact.creep_force.longitudinal > 0.0
    with pytest.raises(AttributeError, match="use creep_force.longitudinal"):
        contact.longitudinal_force
    with pytest.raises(AttributeError, match="creep_force.vertical"):
        contact.creep_force.vertical


def test_a_study_names_the_successor():
    pytest.importorskip("xarray")
    with pytest.raises(wrcontact.UnknownName, match="use left.grid.lateral"):
        wrcontact.study({"lateral": [0.0, 1.0]}, ["left.grid.0"], accuracy=1e-2)


def test_removed_keys_name_their_successors():
    for words, successor in (({"load_vertical": 8e4}, "use load.both"), ({"cant": 0.025}, "use track.inclination"),
                             ({"total_left": 8e4}, 'use load.left with load.of = "total"')):
        with pytest.raises(wrcontact.UnknownName, match=successor):
            wrcontact.solve(**words)
    with pytest.raises(wrcontact.UnknownName, match="use load.both"):
        wrcontact.Scene()["load.vertical"] = 8e4
