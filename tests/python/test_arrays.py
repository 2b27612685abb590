"""wrcontact.solve over arrays of NumPy, xarray and pandas."""
import csv
import subprocess

import numpy as np
import pytest

import wrcontact
from conftest import BUILD

QUICK = {"accuracy": 1e-2, "model": "hertz"}


def single(**values):
    return wrcontact.solve(**QUICK, **values).left.pmax


def test_arrays_give_the_bits_of_single_scenes_and_of_the_program(tmp_path):
    (tmp_path / "s.toml").write_text(
        "[pose]\nlateral = {from = -5, to = 5, count = 41}\n[solve]\naccuracy = 1e-2\n"
        '[study]\nresults = ["left.pmax", "right.area", "rolling_radius_difference"]\n')
    subprocess.run([BUILD / "bin/wrc_sweep", "s.toml", "--quiet", "--no-pictures", "--digits", "17"], cwd=tmp_path, check=True)
    with open(tmp_path / "s.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    names = ["left.pmax", "right.area", "rolling_radius_difference"]
    lateral = np.array([float(row["pose.lateral"]) for row in rows])
    for threads in (1, 2):
        data = wrcontact.solve(lateral=lateral, accuracy=1e-2, outputs=names, threads=threads)
        for name in names:
            assert [float(row[name]) for row in rows] == list(data[name].values)
    assert data["left.pmax"].dims == ("pose.lateral",) and len(rows) == 41


def test_arrays_fit_as_numpy_broadcasts_them():
    y, yaw = np.array([0.0, 3.0]), np.array([0.0, 1e-3, 2e-3])
    data = wrcontact.solve(lateral=y[:, None], yaw=yaw, **QUICK)
    assert data["left.pmax"].shape == (2, 3) and set(data.data_vars) > {"right.area", "grade", "status"}
    assert float(data["left.pmax"][1, 2]) == single(lateral=3, yaw=2e-3)
    both = wrcontact.solve(lateral=y, rail=["60E1", "54E1"], **QUICK)
    assert both["left.pmax"].dims == ("case",)
    assert list(both["left.pmax"].values) == [single(lateral=0), single(lateral=3, rail="54E1")]
    with pytest.raises(wrcontact.InvalidArgument, match="study combines all with all"):
        wrcontact.solve(lateral=y, yaw=yaw)


def test_arrays_of_xarray_and_pandas_keep_their_dimensions():
    xarray, pandas = pytest.importorskip("xarray"), pytest.importorskip("pandas")
    y = xarray.DataArray([0.0, 3.0], dims=["place"], coords={"place": [10, 20]})
    yaw = xarray.DataArray([0.0, 1e-3, 2e-3], dims=["turn"])
    data = wrcontact.solve(lateral=y, yaw=yaw, **QUICK)
    assert dict(data.sizes) == {"place": 2, "turn": 3} and list(data["place"]) == [10, 20]
    assert float(data["left.pmax"].sel(place=20)[2]) == single(lateral=3, yaw=2e-3)
    frame = pandas.DataFrame({"lateral": [0.0, 3.0], "yaw": [0.0, 2e-3]}, index=pandas.Index([7, 9], name="run"))
    rows = wrcontact.solve(**frame, **QUICK)
    assert list(rows["run"]) == [7, 9] and float(rows["left.pmax"].sel(run=9)) == single(lateral=3, yaw=2e-3)
    with pytest.raises(wrcontact.InvalidArgument, match="either all must have them"):
        wrcontact.solve(lateral=y, yaw=[0.0, 1e-3])
    with pytest.raises(wrcontact.InvalidArgument, match="same coordinates"):
        wrcontact.solve(lateral=y, yaw=y.assign_coords(place=[10, 30]))


def test_everything_has_units_and_a_long_name():
    data = wrcontact.solve(lateral=[0.0, 1.0], **QUICK)
    for name, variable in data.variables.items():
        assert variable.attrs.get("long_name"), name
        assert variable.dtype == object or variable.attrs.get("units"), name
    assert data["left.pmax"].attrs["long_name"].startswith("left pmax: largest pressure")
    frame = wrcontact.solve(accuracy=1e-2).patch_frame()
    assert set(frame.columns) == set(frame.attrs["units"]) == set(frame.attrs["long_name"])
    assert not [name for name, words in frame.attrs["long_name"].items() if not words]


def test_progress_is_told_and_one_name_is_enough():
    told = []
    data = wrcontact.solve(lateral=np.zeros(130), until="geometry", outputs="roll", progress=told.append)
    assert told == [64 / 130, 128 / 130, 1.0] and data["roll"].shape == (130,)
    assert wrcontact.study({"lateral": [0]}, "roll", until="geometry")["roll"].shape == (1,)
    with pytest.raises(wrcontact.InvalidArgument, match="are for arrays"):
        wrcontact.solve(lateral=1, outputs=["roll"])


def test_an_array_without_dimension_is_one_value():
    xarray = pytest.importorskip("xarray")
    for value in (np.array(3.0), xarray.DataArray(3.0), np.float32(3.0), np.int64(3)):
        assert single(lateral=value) == single(lateral=3)
    assert wrcontact.Scene(rail=np.array("54E1"))["track.rail"] == "54E1"


def test_a_scene_that_takes_one_value_says_who_takes_more():
    with pytest.raises(wrcontact.InvalidArgument, match=r"pose.lateral has 2 values and takes one; wrcontact.solve"):
        wrcontact.Scene(lateral=[0.0, 1.0])


def test_without_xarray_arrays_come_in_a_dict(python):
    program = ("import sys; sys.modules['xarray'] = None\nimport wrcontact, numpy as np\n"
               "data = wrcontact.solve(lateral=np.array([0.0, 3.0]), model='hertz', outputs=['left.pmax'])\n"
               "print(type(data) is dict, data['left.pmax'].tolist() == [wrcontact.solve(lateral=y, model='hertz').left.pmax "
               "for y in (0, 3)], data['pose.lateral'].tolist())\n")
    assert python(program).stdout == "True True [0.0, 3.0]\n"


def test_counts_are_int():
    result = wrcontact.solve(lateral=5, accuracy=1e-2)
    patch = result.left.patches[0]
    for value in (result.grade, result.left.patch_count, result.left.state, patch.grid.lateral, patch.lobes,
                  result.freeze().left.patch_count, result.to_dict()["left.iterations"]):
        assert type(value) is int
    assert patch.pressure.shape == (patch.grid.lateral, patch.grid.longitudinal)
    assert type(result.left.pmax) is float


def test_a_file_is_read_once_and_again_when_it_changes(tmp_path):
    path = tmp_path / "rail.txt"
    found = {}
    for name in ("60E1", "54E1"):
        wrcontact.Profile(name).write(path, spacing=0.25)
        found[name] = [single(rail=path, lateral=2) for _ in range(2)]
        assert found[name][0] == found[name][1] == wrcontact.Solver().solve(
            wrcontact.Scene(rail=path, lateral=2, **QUICK)).left.pmax
    assert found["60E1"] != found["54E1"]
    times = wrcontact.solve(rail=path, until="geometry")["time_ms.profile"]
    assert times == 0.0  # it has been read before


def test_a_scene_of_a_study_that_fails_keeps_the_others():
    data = wrcontact.solve(lateral=[0.0, 100.0], roll="en15302", **QUICK)
    assert list(data["status"]) == [0, wrcontact.NoContact.status] and np.isnan(data["left.pmax"][1])


def test_values_hold_in_the_order_given(tmp_path):
    rails = ["60E1", "54E1"]
    for order in ({"rail": rails, "track_left_rail": "49E1"}, {"track_left_rail": "49E1", "rail": rails}):
        data = wrcontact.solve(**order, **QUICK)
        assert list(data["left.pmax"].values) == [
            single(**{word: rail if word == "rail" else value for word, value in order.items()}) for rail in rails]
        assert ("track.left.rail" in data.attrs) == (list(order)[0] == "rail")
    wrcontact.Profile("54E1").write(worn := tmp_path / "worn.txt")
    turned = wrcontact.study({"rail": [worn]}, ["left.pmax"], **{"track.rail.rotation": 0.005}, **QUICK)
    assert float(turned["left.pmax"][0]) == single(rail={"file": worn, "rotation": 0.005}) != single(rail=worn)
    loads = wrcontact.study({"load_both": [50e3, 80e3]}, ["left.pmax"], load_left=60e3, **QUICK)
    assert list(loads["left.pmax"].values) == [single(load_left=60e3)] * 2 and loads.attrs["load.left"] == 60e3
    with pytest.raises(wrcontact.InvalidArgument, match="convention.units takes one value"):
        wrcontact.solve(lateral=np.array([1.0, 0.001]), units=np.array(["mm", "SI"]))


def test_masked_values_are_refused():
    masked = np.ma.masked_array([1.0, 1000.0], [False, True])
    for call in (lambda: wrcontact.solve(lateral=masked), lambda: wrcontact.study({"lateral": masked}, ["roll"]),
                 lambda: wrcontact.study({"lateral": list(masked)}, ["roll"]), lambda: wrcontact.Scene(lateral=masked[1])):
        with pytest.raises(wrcontact.InvalidArgument, match="masked"):
            call()


def test_labelled_integers_stay_numbers():
    pandas = pytest.importorskip("pandas")
    for kind in (int, np.float32):
        data = wrcontact.solve(lateral=pandas.Series([1, 2, 3], dtype=kind), until="geometry", outputs="roll")
        assert data["pose.lateral"].dtype == float and list(data["pose.lateral"]) == [1, 2, 3]


def test_constant_keys_and_equal_names_of_a_study(tmp_path):
    data = wrcontact.solve(rail=["60E1", "54E1", "60E1"], until="geometry", outputs="roll")
    assert {"track.rail", "track.left.rail"}.isdisjoint(data.attrs) and data.attrs["pose.yaw"] == 0
    data = wrcontact.solve(load_both=[5e4, 8e4, np.nan, 5e4], until="geometry", outputs="roll")
    assert {"load.both", "load.left"}.isdisjoint(data.attrs)
    creepages = [[1e-3, 0, 0], [2e-3, 0, 0], [1e-3, 1e-3, 0], [1e-3, 0, 0]]
    data = wrcontact.study({"creepage_left": creepages}, "roll", until="geometry")
    assert {"creepage.left", "creepage.both"}.isdisjoint(data.attrs)
    wrcontact.Profile("60E1").write(tmp_path / "worn.prr")
    profiles = [wrcontact.Profile(tmp_path / "worn.prr", kind="rail", smoothing_wavelength=mm) for mm in (3.0, 5.0)]
    data = wrcontact.study({"rail": profiles}, "roll", until="geometry")
    assert list(data["track.rail"].values) == [f"worn; kind = rail; smoothing_wavelength = {mm}" for mm in (3.0, 5.0)]
    assert list(wrcontact.study({"rail": profiles[:1]}, "roll", until="geometry")["track.rail"].values) == ["worn"]


def test_a_row_that_is_refused_keeps_the_others():
    for one in (np.nan, 20000.0):
        data = wrcontact.solve(lateral=[0.0, one, 3.0], **QUICK)
        assert list(data["status"]) == [0, wrcontact.InvalidArgument.status, 0]
        assert "pose.lateral" in str(data["message"].values[1]) and np.isnan(data["left.pmax"][1])
        assert float(data["left.pmax"][2]) == single(lateral=3)
    with pytest.raises(wrcontact.InvalidArgument, match="pose.lateral"):
        wrcontact.solve(lateral=[np.nan, np.nan])


def test_mistakes_among_arrays_are_named():
    with pytest.raises(wrcontact.UnknownName, match="laterl"):
        wrcontact.solve(laterl=[1.0, 2.0], outputs=["roll"])
    mixed = wrcontact.solve(roll=["en15302", 0.001], until="geometry", outputs="roll")
    assert float(mixed["roll"][1]) == 0.001
    for values, size in (({"side": ["left", "right"]}, 2), ({"lateral": []}, 0), ({"lateral": [1, "2"]}, 2)):
        assert wrcontact.solve(**values, until="geometry", outputs="roll")["roll"].shape == (size,)
    for call, text in ((lambda: wrcontact.Scene(roll=["en15302", 0.0]), "pose.roll has 2 values"),
                       (lambda: wrcontact.Scene(lateral=[[1], [2, 3]]), "same length"),
                       (lambda: wrcontact.Scene(results=["stress", 3]), "solve.results is"),
                       (lambda: wrcontact.study({"rail": "60E1"}, ["roll"]), "track.rail is '60E1'; study takes a list"),
                       (lambda: wrcontact.study({"lateral": 3}, ["roll"]), "pose.lateral is 3; study takes a list")):
        with pytest.raises(wrcontact.InvalidArgument, match=text):
            call()
