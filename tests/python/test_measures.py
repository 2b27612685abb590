"""Dimensions, comparison and conicity of profiles are those of the programs."""
import csv
import json
import subprocess

import numpy as np
import pytest

import wrcontact
from conftest import BUILD, PROJECT
from wrcontact.conicity import equivalent_conicity
from wrcontact.report import _add_profile, _Page

MEASURED = PROJECT / "tests/reference/profiles/Car7216_0001r.txt"


def told(*arguments):
    answer = subprocess.run([BUILD / "bin/wrc_profile", *map(str, arguments), "--json"], check=True,
                            capture_output=True, text=True)
    return json.loads(answer.stdout)


@pytest.mark.parametrize("name", ["S1002", "LM", "60E1", "CHN60", MEASURED])
def test_dimensions_are_those_of_wrc_profile(name):
    profile = wrcontact.Profile(name)
    expected = told(name)["dimensions"]
    assert profile.dimensions.keys() == expected.keys()
    for key, value in profile.dimensions.items():
        assert np.isclose(value, np.nan if expected[key] is None else expected[key], rtol=1e-9, equal_nan=True), key
        assert profile.dimensions.units[key] and profile.dimensions.long_name[key]
        assert key in repr(profile.dimensions)
    assert f"{value:.4f}" in profile.dimensions._repr_html_()


def test_a_dimension_that_a_profile_does_not_have_is_not_a_number():
    y, z = wrcontact.Profile("S1002").at(np.arange(80.0, 160.0, 0.5))[:2]
    half = wrcontact.Profile.from_points("wheel", y, z).dimensions
    assert np.isnan(half["flange_thickness"])


def test_a_comparison_is_that_of_wrc_profile():
    found = wrcontact.Profile("60E1").compare(wrcontact.Profile("54E1"))
    expected = told("60E1", "--compare", "54E1")["comparison"]
    for mine, name in (("largest", "largest"), ("rms", "rms"), ("compared", "compared_length"),
                       ("missing_area", "missing_area"), ("added_area", "added_area")):
        assert np.isclose(getattr(found, mine), expected[name], rtol=1e-9, atol=1e-9), name
    assert np.isclose(found.largest_at[0], expected["largest_at"]["lateral"])
    for name, value in expected["differences"].items():
        assert np.isclose(found.differences[name], value, atol=1e-9)
    with pytest.raises(wrcontact.InvalidArgument, match="must be a rail"):
        wrcontact.Profile("60E1").compare("S1002")


def test_both_wheels_of_a_comparison_have_the_tape_offset_of_the_compared_one():
    expected = told(MEASURED, "--kind", "wheel", "--tape-offset", "72", "--compare", "S1002")["comparison"]["differences"]
    wheel = wrcontact.Profile(MEASURED, kind="wheel", tape_offset=72)
    assert np.isclose(wheel.compare("S1002").differences["flange_thickness"], expected["flange_thickness"], atol=1e-9)
    page = _Page("")
    _add_profile(page, wheel, wrcontact.Profile("S1002"))
    row = next(part for part in "".join(page.parts).split("<tr>") if "flange thickness" in part)
    assert f">{expected['flange_thickness']:.3f}<" in row


def conicities_of(wheel, rail, folder):
    subprocess.run([BUILD / "bin/wrc_sweep", "conicity", "--wheels", wheel, "--rails", rail, "--out", folder, "--quiet",
                    "--no-pictures", "--digits", "17"], check=True, capture_output=True)
    with open(folder / "conicity_by_amplitude.csv", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def test_conicity_of_a_cone_is_its_slope_and_none_has_a_reason():
    y = np.linspace(-9, 9, 361)
    for slope in (0.05, 0.3):
        for amplitude in (0.5, 3.0, 8.9):
            assert np.isclose(equivalent_conicity(y, 2 * slope * y, amplitude)[0], slope, rtol=1e-12)
    assert equivalent_conicity(y, 0 * y, 3.0) == (0.0, "")
    assert "not known beyond" in equivalent_conicity(y, y, 9.5)[1]
    assert "led back to no position" in equivalent_conicity(y, -y, 3.0)[1]
    assert "runs away" in equivalent_conicity(y, y * (9 - y * y) / 9, 5.0)[1]


@pytest.mark.parametrize("wheel", ["S1002", MEASURED])
def test_conicity_is_that_of_the_shipped_study(wheel, tmp_path):
    rows = conicities_of(wheel, "60E1", tmp_path)[2::8]
    found = wrcontact.Profile(wheel).conicity("60E1", [float(row["amplitude"]) for row in rows])
    for row, *mine, reason in zip(rows, found.conicity, found.spread, found.reasons):
        for value, column in zip(mine, ("equivalent_conicity", "spread")):
            assert np.isclose(value, float(row[column] or "nan"), rtol=1e-6, atol=1e-9, equal_nan=True), row
        assert reason == row["message"]
    assert found.value == found.at(3.0) and f"{found.value:.4f}" in repr(found)
    for amplitudes in ([6.0, 2.0], []):
        other = wrcontact.Profile(wheel).conicity("60E1", amplitudes)
        assert repr(other) == repr(found) and other.standard_spread == found.spread[found.amplitude == 3.0]
    with pytest.raises(wrcontact.InvalidArgument, match="must be a wheel, and a rail"):
        wrcontact.Profile("60E1").conicity("60E1")


def test_profiles_are_smoothed_and_aligned_as_they_are_read(tmp_path):
    measured = wrcontact.Profile.from_file(MEASURED, kind="wheel")
    again = measured.smooth(8.0)
    assert np.array_equal(again.at(50.0), wrcontact.Profile(MEASURED, kind="wheel", smoothing_wavelength=8.0).at(50.0))
    aligned = measured.align("S1002")
    assert np.array_equal(aligned.at(50.0), wrcontact.Profile(MEASURED, kind="wheel", align_to="S1002").at(50.0))
    assert np.array_equal(aligned.at(50.0), measured.align(wrcontact.Profile("S1002")).at(50.0))
    with pytest.raises(wrcontact.InvalidArgument, match="60E1 is built in"):
        wrcontact.Profile("60E1").smooth(5.0)
    with pytest.raises(wrcontact.InvalidArgument, match="made from points"):
        measured.align(wrcontact.Profile.from_points("wheel", *measured.points()))
    (tmp_path / "S1002").write_text(MEASURED.read_text(encoding="utf-8"), encoding="utf-8")
    assert wrcontact.Profile.from_file(tmp_path / "S1002", kind="wheel").length == measured.length
