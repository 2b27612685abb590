"""Programs of earlier versions: what they read is still there, or missed with a clear error."""
import numpy as np
import pytest

import wrcontact

MOTION = {"lateral": 3, "yaw": 1e-3, "speed": 2e4, "accuracy": 1e-2}


def test_pairs_are_read_by_index_and_taken_apart():
    patch = wrcontact.solve(**MOTION).left.patches[0]
    across, along = patch.element_size
    assert (across, along) == (patch.element_size.lateral, patch.element_size.longitudinal)
    assert tuple(patch.grid) == (patch.grid.lateral, patch.grid.longitudinal) == patch.pressure.shape
    assert patch.semi_axes[0] == patch.semi_axes.longitudinal != patch.semi_axes[1]
    assert patch.radii[1] == patch["radii.1"] == patch.radii.lateral
    assert len(patch.creep_grid) == 2
    with pytest.raises(IndexError):
        patch.grid[2]


def test_other_names():
    result = wrcontact.solve(**MOTION)
    left, patch = result.left, result.left.patches[0]
    assert patch.closeness == patch.coupling_weight == 0.0
    assert left.moment.x == left.pressure_moment.x == result["left.moment.x"]
    assert left.sensitivities.lateral_force.roll == left.sensitivities.pressure_force.y.roll
    assert left.sensitivities.at_load.lateral_force.roll != 0.0
    assert not any("closeness" in name or ".grid.0" in name for name in result.to_dict())
    with pytest.raises(AttributeError, match="left.moment.w"):
        left.moment.w


def test_plain_forces_are_totals():
    left = wrcontact.solve(**MOTION).left
    assert left.lateral_force == left.total.force.y > 5e3 > 0 > left.pressure_force.y


def test_members_of_patches():
    table = wrcontact.solve(**MOTION).patch_table()
    for old, now in (("largest_pressure", "pmax"), ("contact_angle", "angle"),
                     ("longitudinal_creep_force", "creep_force_longitudinal"),
                     ("lateral_semi_axis", "semi_axes_lateral"), ("spin_creepage", "creepage_spin")):
        assert np.array_equal(table[old], table[now])


def test_rolling_contact_and_solver():
    contact = wrcontact.RollingContact(np.full((4, 4), 100.0), 1.0, 1.0, longitudinal_creepage=-1e-3)
    contact.solve()
    assert contact.longitudinal_force == contact.creep_force.longitudinal > 0.0
    assert contact.lateral_force == contact["creep_force.lateral"]
    with pytest.raises(AttributeError, match="creep_force.vertical"):
        contact.creep_force.vertical
    wrcontact.Solver().forget()


def test_a_study_by_old_names():
    pytest.importorskip("xarray")
    data = wrcontact.study({"lateral": [0.0, 1.0]}, ["left.grid.0", "left.grid.lateral"], accuracy=1e-2)
    assert np.array_equal(data["left.grid.0"], data["left.grid.lateral"])


def test_removed_keys_name_their_successors():
    for words, successor in (({"load_vertical": 8e4}, "use load.both"), ({"cant": 0.025}, "use track.inclination"),
                             ({"total_left": 8e4}, 'use load.left with load.of = "total"')):
        with pytest.raises(wrcontact.UnknownName, match=successor):
            wrcontact.solve(**words)
    with pytest.raises(wrcontact.UnknownName, match="use load.both"):
        wrcontact.Scene()["load.vertical"] = 8e4
