"""Studies as xarray Datasets."""
import ctypes
import ctypes.util
import subprocess

import numpy as np
import pytest

import wrcontact
from conftest import BUILD


def test_a_study_has_the_numbers_of_single_scenes():
    data = wrcontact.study({"lateral": [-3, 0, 6.15], "rail": ["60E1", "56E1"]},
                           ["left.pmax", "left.patches.1.pmax"], threads=2, accuracy=1e-2)
    assert data["left.pmax"].dims == ("pose.lateral", "track.rail")
    for lateral in (-3, 0, 6.15):
        for rail in ("60E1", "56E1"):
            one = data.sel({"pose.lateral": lateral, "track.rail": rail})
            result = wrcontact.solve(lateral=lateral, rail=rail, accuracy=1e-2)
            assert float(one["left.pmax"]) == result.left.pmax
            second = result.left.patches[1].pmax if len(result.left.patches) > 1 else np.nan
            assert np.array_equal(float(one["left.patches.1.pmax"]), second, equal_nan=True)
    assert not data["status"].any() and data.attrs["solve.accuracy"] == 1e-2
    assert {"track.rail", "track.left.rail", "pose.lateral"}.isdisjoint(data.attrs)


def test_more_scenes_than_are_solved_at_once_do_not_depend_on_threads():
    random = np.random.default_rng(1)
    cases = {"lateral": ("case", random.uniform(-5, 5, 1100)),
             "yaw": ("case", random.uniform(-0.01, 0.01, 1100))}
    one, two = (wrcontact.study(cases, ["left.rigid_contact.angle", "roll"], threads=threads,
                                until="geometry") for threads in (1, 2))
    assert one.identical(two) and one["roll"].shape == (1100,)
    row = 1050
    expected = wrcontact.solve(lateral=cases["lateral"][1][row], yaw=cases["yaw"][1][row])
    assert float(one["roll"][row]) == expected.roll


def test_a_scene_that_fails_is_a_row_with_its_status():
    data = wrcontact.study({"lateral": [0, 100]}, ["left.pmax"], roll="en15302")
    assert list(data["status"]) == [0, wrcontact.NoContact.status]
    assert np.isnan(data["left.pmax"][1]) and "off the rail" in str(data["message"].values[1])
    with pytest.raises(wrcontact.UnknownName):
        wrcontact.study({"lateral": [0]}, ["left.none"])
    with pytest.raises(wrcontact.InvalidArgument):
        wrcontact.study({"lateral": [20000]})


def test_values_of_all_kinds_vary(tmp_path):
    rails = [wrcontact.Profile("60E1"), wrcontact.Profile("54E1")]
    data = wrcontact.study({"rail": rails, "roll": ["en15302", 1e-4]}, ["left.depth"], accuracy=1e-2)
    assert list(data["track.rail"].values) == ["60E1", "54E1"]
    assert float(data["left.depth"][1, 1]) == wrcontact.solve(rail="54E1", roll=1e-4,
                                                              accuracy=1e-2).left.depth
    moved = wrcontact.study({"track.left.displacement": [[0, 0, 0], [1, 0, 0]]}, ["roll"])
    assert moved["roll"][0] != moved["roll"][1]
    assert wrcontact.study({}, ["roll"])["roll"].shape == ()


def test_units_are_told():
    results = ["left.pmax", "left.depth", "roll", "left.patch_count", "right.patches.0.wear_number"]
    for convention, units in (("mm", ["MPa", "mm", "rad", "1", "N"]), ("SI", ["Pa", "m", "rad", "1", "N"])):
        data = wrcontact.study({"lateral": [0]}, results, until="geometry", units=convention)
        assert [data[name].attrs["units"] for name in results] == units
        assert data["pose.lateral"].attrs["long_name"] == wrcontact.keys()["pose.lateral"].meaning


def test_names_may_be_attributes_and_coordinates_have_units():
    data = wrcontact.study({"lateral": [0, 1], "rail": ["60E1", "54E1"]}, ["left.pmax"], separator="_",
                           until="geometry")
    assert data.left_pmax.sel(track_rail="60E1").dims == ("pose_lateral",)
    assert data.pose_lateral.attrs["units"] == "mm" and "units" not in data.track_rail.attrs
    assert data.attrs["pose.yaw"] == 0.0  # keys stay keys
    si = wrcontact.study({"track.gauge": [1.435]}, ["left.pmax"], units="SI", until="geometry")
    assert si["track.gauge"].attrs["units"] == "m"


def units_in(path, names):
    """Attributes `units` of a NetCDF file, by its own library: xarray needs a package for it."""
    netcdf = ctypes.CDLL(ctypes.util.find_library("netcdf"))
    file, variable, found = ctypes.c_int(), ctypes.c_int(), []
    assert netcdf.nc_open(str(path).encode(), 0, ctypes.byref(file)) == 0
    for name in names:
        text = ctypes.create_string_buffer(40)
        assert netcdf.nc_inq_varid(file, name.encode(), ctypes.byref(variable)) == 0
        assert netcdf.nc_get_att_text(file, variable, b"units", text) == 0
        found.append(text.value.decode())
    netcdf.nc_close(file)
    return found


@pytest.mark.parametrize("convention, units", [("mm", ["mm", "N", "MPa", "MPa"]), ("SI", ["m", "N", "Pa", "Pa"])])
def test_netcdf_files_of_wrc_sweep_have_the_units_of_the_study(tmp_path, convention, units):
    if ctypes.util.find_library("netcdf") is None:
        pytest.skip("the NetCDF library is not installed")
    (tmp_path / "s.toml").write_text(
        f"[convention]\nunits = \"{convention}\"\n[pose]\nlateral = [0, 0.001]\n[load]\nboth = [1e4, 8e4]\n"
        "[solve]\naccuracy = 1e-2\n[study]\nresults = [\"left.pmax\"]\nfields = [\"pressure\"]\n")
    subprocess.run([BUILD / "bin/wrc_sweep", "s.toml"], cwd=tmp_path, check=True, capture_output=True)
    names = ["pose.lateral", "load.both", "left.pmax", "field.pressure"]
    assert units_in(next(tmp_path.rglob("*.nc")), names) == units
