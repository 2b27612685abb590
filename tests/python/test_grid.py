"""Contact on grids of the caller's."""
import numpy as np
import pytest

import wrcontact


def sphere(count=64, half=8.0, radius=500.0):
    """The gap of a sphere on a plane, and the side of an element, mm."""
    step = 2.0 * half / count
    place = step * (np.arange(count) + 0.5) - half
    return np.add.outer(place**2, place**2) / (2.0 * radius), step


def test_a_sphere_presses_as_hertz_says():
    gap, step = sphere()
    load, modulus, radius = 8e4, 210e3 / (2 * (1 - 0.3**2)), 500.0
    contact = wrcontact.NormalContact(gap, step, step, normal_load=load, tolerance=1e-8).solve()
    half_axis = (0.75 * load * radius / modulus) ** (1 / 3)
    assert np.isclose(contact.pmax, 1.5 * load / (np.pi * half_axis**2), rtol=1e-3)
    assert np.isclose(contact.approach, half_axis**2 / radius, rtol=1e-3)
    assert np.isclose(contact.pressure.sum() * step**2, load, rtol=1e-12)
    assert contact.pressure.shape == contact.displacement.shape == gap.shape
    assert contact["residuals.load_balance"] < 1e-12 and contact.stop_reason == "tolerance_met"
    assert f"pmax {contact.pmax:.6g}" in repr(contact) and not hasattr(contact, "none")
    again = contact.set(approach=contact.approach).solve()
    assert again is contact and np.isclose(contact.normal_force, load, rtol=1e-6)


def test_an_array_is_read_where_it_lies():
    from wrcontact._interface import ffi
    from wrcontact._library import doubles, pointer

    gap, step = sphere()
    assert doubles(gap) is gap and int(ffi.cast("intptr_t", pointer(gap))) == gap.ctypes.data
    turned = wrcontact.NormalContact(gap.T[:, ::-1], step, step, normal_load=1e4)  # copied into order
    straight = wrcontact.NormalContact(gap, step, step, normal_load=1e4)
    assert np.array_equal(turned.solve().pressure, straight.solve().pressure)
    for wrong in (np.zeros(4), np.zeros((0, 3))):
        with pytest.raises(wrcontact.InvalidArgument):
            wrcontact.NormalContact(wrong, 1, 1)


def test_creep_forces_rise_as_kalker_says():
    """Linear theory at small creepages: F = -G c^2 C11 xi, C11 = 4.12 for a circle, nu = 0.25."""
    gap, step = sphere(128, 9.0)
    load = 8e4
    normal = wrcontact.NormalContact(gap, step, step, normal_load=load).solve()
    radius = np.sqrt(normal.area / np.pi)
    rolling = wrcontact.RollingContact(normal.pressure, step, step, poisson=0.25, friction=0.3,
                                       longitudinal_creepage=-1e-5, derivatives=1).solve()
    shear_modulus = 210000 / (2 * 1.28)
    assert np.isclose(rolling.creep_force.longitudinal, shear_modulus * radius**2 * 4.12 * 1e-5, rtol=0.02)
    assert np.isclose(rolling.creepage_derivatives[0, 0], rolling.creep_force.longitudinal / -1e-5, rtol=0.05)
    assert np.isclose(rolling.traction_x.sum() * step**2, rolling.creep_force.longitudinal, rtol=1e-9)
    slipping = rolling.set(longitudinal_creepage=-0.1).solve()
    assert np.isclose(slipping.creep_force.longitudinal, 0.3 * load, rtol=1e-3)


def test_slip_of_elements_is_added_to_that_of_creepages():
    gap, step = sphere(32)
    pressure = wrcontact.NormalContact(gap, step, step, normal_load=8e4).solve().pressure
    rolling = wrcontact.RollingContact(pressure, step, step, tolerance=1e-6,
                                       longitudinal_creepage=-1e-3).solve()
    force = rolling.creep_force.longitudinal
    nothing = np.zeros_like(pressure)
    rolling.set(longitudinal_creepage=0).set_slip(nothing - 1e-3, nothing).solve()
    assert np.isclose(rolling.creep_force.longitudinal, force, rtol=1e-5)
    assert rolling.set_slip([], []).solve().creep_force.longitudinal == 0
    with pytest.raises(wrcontact.InvalidArgument):
        rolling.set_slip(nothing, [])


def test_a_shift_starts_from_previous_tractions():
    gap, step = sphere(32)
    pressure = wrcontact.NormalContact(gap, step, step, normal_load=8e4).solve().pressure
    shift = wrcontact.RollingContact(pressure, step, step, contact="shift", longitudinal_creepage=-1e-3)
    first = shift.solve().creep_force.longitudinal
    tractions = shift.traction_x, shift.traction_y
    second = shift.advance().solve().creep_force.longitudinal
    assert first < second
    assert shift.set_previous(*tractions).solve().creep_force.longitudinal == second
    assert shift.set_previous([], []).solve().creep_force.longitudinal == first
    with pytest.raises(wrcontact.InvalidArgument):
        shift.set_previous(tractions[0], [])


def test_a_cut_contact_and_one_on_few_elements_warn():
    place = (np.arange(20) - 9.5) * 0.5
    gap = np.add.outer((place + 3.0) ** 2, place**2) / 600.0
    with pytest.warns(wrcontact.ContactWarning, match="edge of the grid"):
        cut = wrcontact.NormalContact(gap, 0.5, 0.5, normal_load=2e4).solve()
    assert len(cut.warnings) == 1 and cut["warning_classes.0"] == "grid_edge"
    place = np.arange(9) - 4.0
    gap = np.add.outer(place**2, place**2) / 200.0
    with pytest.warns(wrcontact.ContactWarning, match="covers 1 x 1 elements"):
        few = wrcontact.NormalContact(gap, 1.0, 1.0, normal_load=1.0, elements="constant").solve()
    assert few["warning_classes.0"] == "accuracy" and few["warning_grades.0"] == "do not use"
    assert few["grade"] == 2


def test_what_has_not_converged_warns_too():
    place = (np.arange(20) - 9.5) * 0.5
    contact = wrcontact.NormalContact(np.add.outer((place + 3.0) ** 2, place**2) / 600.0, 0.5, 0.5, normal_load=2e4,
                                      maximum_iterations=1)
    with pytest.warns(wrcontact.ContactWarning, match="edge of the grid"), pytest.raises(wrcontact.NotConverged):
        contact.solve()
