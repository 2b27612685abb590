"""The shakedown map: its limits against closed forms, and contacts on it."""
import math

import numpy as np
import pytest

import wrcontact
from wrcontact import shakedown


def test_limits_without_friction_are_those_of_hertz():
    elastic, limit = shakedown.limits(0.0)
    # The greatest von Mises stress on the axis of a circular contact, nu = 0.3 (Johnson 1985, eqs. 3.45).
    z = np.linspace(0.01, 2.0, 2000)
    across = -1.3 * (1.0 - z * np.arctan(1.0 / z)) + 0.5 / (1.0 + z**2)
    assert elastic == pytest.approx(math.sqrt(3.0) / (1.0 / (1.0 + z**2) + across).max(), rel=1e-3)
    # 4.7 k is where the greatest shear along the surface is k: 0.214 p0 (Lundberg & Palmgren 1947: 0.215).
    of_p, _ = shakedown._stresses()
    assert limit == pytest.approx(1.0 / np.abs(of_p[3]).max(), rel=0.01)


def test_with_much_friction_the_surface_yields_first():
    for friction in (0.4, 0.8):
        elastic, limit = shakedown.limits(friction)
        # At the trailing edge, where p = 0 (Johnson 1985, eqs. 3.43 and 3.91).
        along = 0.4 / 3.0 + friction * math.pi * 4.3 / 8.0
        across = -0.4 / 3.0 + friction * 3.0 * math.pi * 0.3 / 8.0
        edge = math.sqrt(3.0 / (along**2 + across**2 - along * across))
        assert limit == 1.0 / friction
        assert 0.95 * edge < elastic <= edge * (1.0 + 1e-12) and elastic < limit


def test_sums_below_the_surface_are_equal_to_closed_forms():
    of_p, of_q = shakedown._stresses()
    surface, columns = 201, 49
    # On the axis at z = 0.5.
    at = surface + 8 * columns + columns // 2
    across = -1.3 * (1.0 - 0.5 * math.atan(2.0)) + 0.4
    assert of_p[:, at] == pytest.approx([across, across, -0.8, 0.0], abs=1e-6)
    # xz of the traction is xx of the pressure of a line, but zz of the traction is xz of the pressure in any contact.
    assert of_q[2] == pytest.approx(of_p[3], abs=1e-9)


def test_contacts_are_red_beyond_a_limit():
    pytest.importorskip("matplotlib")
    result = wrcontact.solve(lateral=3, side="left", accuracy=1e-2, creepage_longitudinal=0.005, solve_results="fatigue").left.fatigue
    assert (result.surface_index > 0.0) == (result.pressure_ratio > 1.0 / result.friction) == True  # noqa: E712
    axes = wrcontact.shakedown_map([result.friction, 0.1, np.nan], [result.pressure_ratio, 2.0, 3.0]).axes[0]
    points = {line.get_label(): line for line in axes.lines}
    assert points["contacts beyond the limit"].get_xdata() == [result.friction]
    assert points["contacts beyond the limit"].get_color() == "#c00000"
    assert points["contacts"].get_ydata() == [2.0]
    assert wrcontact.shakedown_map(0.1, 2.0, ax=axes) is axes.figure


def test_mistakes_are_named():
    with pytest.raises(wrcontact.InvalidArgument, match="friction = 2.5: must be between 0 and 2"):
        shakedown.limits(2.5)
    with pytest.raises(wrcontact.InvalidArgument, match="pressure_ratio has 1 values; must have 2, one for each friction"):
        wrcontact.shakedown_map([0.1, 0.2], [3.0])
    with pytest.raises(wrcontact.InvalidArgument, match="must be 0 or more"):
        wrcontact.shakedown_map(-0.1, 3.0)
