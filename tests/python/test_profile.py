"""Profiles: built in, from files and from points."""
import numpy as np
import pytest

import wrcontact


def test_built_in_profiles_are_those_of_the_library():
    assert "S1002" in wrcontact.standard_profiles("wheel")
    rail = wrcontact.Profile("60E1")
    assert (rail.kind, rail.name, rail.corrections, rail.warnings) == ("rail", "60E1", [], [])
    assert "60E1" in repr(rail) and rail.title and rail.source and rail.confidence
    curve = rail.at(rail.nodes)
    assert np.all(np.diff(rail.nodes) > 0.0) and np.isclose(rail.nodes[-1], rail.length)
    length = np.hypot(np.diff(curve.lateral), np.diff(curve.height)).sum()
    assert length <= rail.length and np.isclose(length, rail.length, rtol=1e-2)
    assert rail.at(10.0).lateral.shape == () and rail.at([[1.0, 2.0]]).height.shape == (1, 2)
    with pytest.raises(wrcontact.InvalidArgument, match="wheel, rail"):
        wrcontact.standard_profiles("axle")


def test_a_file_and_its_points_give_one_scene(tmp_path):
    wrcontact.Profile("60E1").write(tmp_path / "rail.prr", spacing=0.2)
    file = wrcontact.Profile(tmp_path / "rail.prr", kind="rail", strict=True)
    points = wrcontact.Profile.from_points("rail", *file.points(), name="mine")
    assert points.name == "mine" and points.points("dropped")[0].size == 0
    found = [wrcontact.solve(rail=rail).left.pmax for rail in (file, tmp_path / "rail.prr", points)]
    assert found[0] == found[1] and np.isclose(found[2], found[0], rtol=1e-6)


def test_a_tilted_wheel_is_turned(tmp_path):
    curve = wrcontact.Profile("S1002").at(np.arange(0.5, 170.0, 0.5))
    y, z = curve.lateral, curve.height
    tilted = y - 0.02 * z, z + 0.02 * y
    np.savetxt(tmp_path / "tilted.txt", np.transpose(tilted))
    (warning,) = wrcontact.Profile(tmp_path / "tilted.txt", kind="wheel").warnings
    assert "turned by -1.1" in warning
    for options in ({"rotation": -0.02}, {"align_to": "S1002"}):
        straight = wrcontact.Profile.from_points("wheel", *tilted, strict=True, **options)
        assert np.allclose(straight.at(0.0).height, z[0], atol=0.03), options
    assert not wrcontact.Profile(tmp_path / "tilted.txt", kind="wheel", rotation=0.0).warnings


def test_the_name_of_a_file_is_drawn_as_it_is(tmp_path):
    pytest.importorskip("matplotlib")
    name = r"a$\frac{b$_^%.txt"
    wrcontact.Profile("60E1").write(tmp_path / "rail.txt", spacing=0.5)
    (tmp_path / "rail.txt").rename(tmp_path / name)
    profile = wrcontact.Profile(tmp_path / name, kind="rail")
    figure = profile.plot(tmp_path / "rail.png")
    assert figure.axes[0].get_title() == profile.title
    assert (tmp_path / "rail.png").stat().st_size > 0


def test_what_is_wrong_is_told(tmp_path):
    with pytest.raises(TypeError, match="smoothing_wavelength"):
        wrcontact.Profile("rail.prr", smoothing=3)
    with pytest.raises(wrcontact.InvalidArgument, match="shape"):
        wrcontact.Profile.from_points("rail", [0, 1], [0])
    with pytest.raises(wrcontact.InvalidArgument):
        wrcontact.Scene(rail=wrcontact.Profile("S1002"))


def test_noise_is_smoothed_unless_told_otherwise():
    wheel = wrcontact.Profile("S1002")
    curve = wheel.at(np.arange(0.0, wheel.length, 0.25))
    noise = np.random.default_rng(1).normal(0.0, 0.02, curve.lateral.size)
    points = (curve.lateral, curve.height + noise)
    results = {}
    for word in ("auto", 5.0, 0):
        profile = wrcontact.Profile.from_points("wheel", *points, smoothing_wavelength=word)
        assert any("MPa to flatten" in text for text in profile.warnings)
        with pytest.warns(wrcontact.ContactWarning, match="MPa to flatten"):
            results[word] = wrcontact.solve(wheel=profile, accuracy=1e-2)
    default = wrcontact.Profile.from_points("wheel", *points)
    assert np.array_equal(default.at(default.nodes), wrcontact.Profile.from_points(
        "wheel", *points, smoothing_wavelength="auto").at(default.nodes))
    left = results["auto"].left
    assert abs(left.pmax - 898.0) < left.spread.pmax < 300.0
    assert results[5.0].left.spread.pmax > 0.0
    assert results[0].left.pmax > 5000.0
    with pytest.raises(wrcontact.InvalidArgument, match="none, auto"):
        wrcontact.Profile.from_points("wheel", *points, smoothing_wavelength="much")
