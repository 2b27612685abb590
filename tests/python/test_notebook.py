"""What editors, notebooks and other processes see of scenes, results and profiles."""
import copy
import inspect
import json
import pickle
import subprocess
import sys

import numpy as np
import pytest

import wrcontact
from conftest import BUILD, PROJECT


def test_a_scene_is_pickled_and_copied_by_value():
    y, z = wrcontact.Profile("54E1").at(np.linspace(0.0, 140.0, 400))[:2]
    scene = wrcontact.Scene(units="SI", lateral=0.003, rail=wrcontact.Profile.from_points("rail", y, z))
    scene["convention.units"] = "mm"  # the lateral position was set in m and stays what it is
    scene["pose.yaw"] = 0.002
    scene["pose.yaw"] = 0.001
    scene["track.left.displacement"] = moved = np.array([0.1, 0.0, 0.0])
    moved[0] = 5.0  # the scene has its own copy
    expected = scene.solve().to_dict()
    for other in (pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene)):
        assert repr(other) == repr(scene) and other["pose.lateral"] == 3.0
        found = other.solve().to_dict()
        assert [name for name in expected
                if not name.startswith("time_ms") and found[name] != expected[name]] == []
    copied = copy.copy(scene)
    copied["pose.yaw"] = 0.0
    assert scene["pose.yaw"] == 0.001


def test_a_profile_of_a_file_is_pickled_by_its_path(tmp_path):
    path = tmp_path / "rail.txt"
    wrcontact.Profile("60E1").write(path)
    profile = wrcontact.Profile(path, kind="rail", smoothing_wavelength=3.0)
    other = pickle.loads(pickle.dumps(profile))
    assert other.length == profile.length != wrcontact.Profile(path, kind="rail").length


def test_keywords_are_completed_from_the_keys_of_the_library():
    keys = {name.replace(".", "_"): key for name, key in wrcontact.keys().items()}
    for function in (wrcontact.Scene, wrcontact.Scene.set, wrcontact.solve):
        parameters = inspect.signature(function).parameters
        assert keys.keys() <= parameters.keys()
        assert parameters["pose_roll"].annotation == "float | str"
        assert parameters["track_rail"].annotation == "Profile | str"
        assert parameters["solve_grid"].annotation == "Sequence[float] | str"
        assert parameters["wear_scale"].default == "1.0"
    scene = wrcontact.Scene(until="geometry")
    assert "pose.yaw" in scene._ipython_key_completions_()
    assert "left.pmax" in scene.solve()._ipython_key_completions_()


def test_keys_have_units():
    units = {name: key.unit for name, key in wrcontact.keys().items()}
    for name, unit in {"pose.lateral": "mm", "pose.roll": "rad", "track.inclination": "rad", "load.both": "N",
                       "material.poisson": "1", "motion.torque": "N mm", "motion.pitch": "rad/s",
                       "motion.curvature": "1/mm", "friction.decay": "s/mm", "solve.threads": "1",
                       "wear.energy_coefficient": "mm2/N",
                       "track.rail": "", "creepage.left": "", "convention.units": ""}.items():
        assert units[name] == unit, name
    for name, key in wrcontact.keys().items():  # a key with a unit takes a number
        scene = wrcontact.Scene()
        if key.unit:
            scene[name] = 0.02 if name in ("solve.accuracy", "solve.tolerance") else {
                "track.gauge": 1435, "track.gauge_height": 14, "wheelset.back_to_back": 1360,
                "wheelset.tape_offset": 70, "wheelset.radius": 460, "wheelset.left.radius": 460,
                "wheelset.right.radius": 460, "solve.element_limit": 1000,
                "motion.standstill_speed": 1,
                "pose.vertical": 460}.get(name, 100 if "100 to" in key.allowed else 1 if "1 to" in key.allowed else 0)
        elif key.allowed.startswith('"'):
            with pytest.raises(wrcontact.Error):
                scene[name] = 12345.6


def test_patches_are_a_data_frame():
    result = wrcontact.solve(lateral=6.15, accuracy=1e-2)
    frame = result.patch_frame()
    assert frame.index.names == ["wheel", "patch"]
    assert len(frame) == result.left.patch_count + result.right.patch_count
    for side in ("left", "right"):
        for index, patch in enumerate(result[side].patches):
            assert frame.loc[side, index]["pmax"] == patch.pmax
            assert frame.loc[side, index]["semi_axes.longitudinal"] == patch.semi_axes.longitudinal
    assert frame.attrs["units"]["pmax"] == "MPa" and frame.attrs["units"]["angle"] == "rad"


def test_html_holds_numbers_and_escaped_texts():
    result = wrcontact.solve(lateral=6.5)
    html = result._repr_html_()
    assert f"{result.left.pmax:.6g}" in html and "more than steel can carry" in html
    assert "&lt;text&gt;.prr" in wrcontact.Scene(rail="<text>.prr")._repr_html_()


def test_panels_are_drawn_on_axes_of_the_caller():
    figure_module = pytest.importorskip("matplotlib.figure")
    result = wrcontact.solve(lateral=1, creepage_longitudinal=1e-3, accuracy=1e-2)
    axes = figure_module.Figure().subplots(1, 4)
    for ax, panel in zip(axes, ("outlines", "pressures", "tractions")):
        assert result.plot(ax=ax, panel=panel, side="right") is ax.figure
        assert ax.has_data()
    assert not axes[3].has_data()
    wrcontact.Profile("S1002").plot(ax=axes[3])
    assert axes[3].has_data()
    with pytest.raises(wrcontact.InvalidArgument, match="panel is 'stress'; must be one of outlines"):
        result.plot(ax=axes[0], panel="stress")
    one = wrcontact.solve(side="left", accuracy=1e-2)
    with pytest.raises(wrcontact.InvalidArgument, match="side is 'right'; must be left"):
        one.plot(ax=axes[0], side="right")


def test_outlines_hold_all_patches():
    """On wing and nose of a crossing, 78 mm apart, in both frames."""
    figure_module = pytest.importorskip("matplotlib.figure")
    rail = str(BUILD / "share/wrcontact/studies/crossing/crossing.slcs")
    for frame in ("left-up", "right-down"):
        scene = wrcontact.Scene(accuracy=1e-2, side="left", longitudinal=180, frame=frame)
        scene["track.left.rail"] = rail
        result = scene.solve()
        assert len(result.left.patches) == 2
        ax = figure_module.Figure().subplots()
        result.plot(ax=ax, panel="outlines", side="left")
        assert (ax.get_xlim()[0] > ax.get_xlim()[1]) == (frame == "left-up")
        assert (ax.get_ylim()[0] < ax.get_ylim()[1]) == (frame == "left-up")
        for patch in result.left.patches:
            assert min(ax.get_xlim()) + 14 < patch.y < max(ax.get_xlim()) - 14
            assert min(ax.get_ylim()) + 14 < patch.z < max(ax.get_ylim()) - 14


def test_the_notebook_of_the_examples_shows_what_it_stores():
    pytest.importorskip("matplotlib")
    pytest.importorskip("pandas")
    done = subprocess.run([sys.executable, "-B", PROJECT / "scripts/run_notebook.py"], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    notebook = json.loads((PROJECT / "python_bindings/examples/contact.ipynb").read_text(encoding="utf-8"))
    cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert len(cells) == 10 and all(cell["outputs"] for cell in cells)
    assert sum("image/png" in output.get("data", {}) for cell in cells for output in cell["outputs"]) == 3


def test_a_contact_that_the_end_of_a_rail_cuts_is_drawn():
    figure_module = pytest.importorskip("matplotlib.figure")
    scene = wrcontact.Scene(accuracy=1e-2, side="left", longitudinal=999)
    scene["track.left.rail"] = str(BUILD / "share/wrcontact/studies/crossing/crossing.slcs")
    with pytest.warns(wrcontact.ContactWarning, match="no bound"):
        result = scene.solve()
    axes = figure_module.Figure().subplots()
    result.plot(ax=axes, panel="pressures", side="left")
    assert "without bound" in axes.get_title()


def test_a_picture_says_what_is_not_to_be_used():
    pytest.importorskip("matplotlib")
    with pytest.warns(wrcontact.ContactWarning):
        result = wrcontact.solve(rail="56E1", lateral=6.15)
    figure = result.plot()
    grades = [result[f"warning_grades.{i}"] for i in range(int(result["warning_count"]))]
    text = figure._supxlabel
    assert text.get_text().count("Do not use: left: ") == grades.count("do not use") >= 1
    assert text.get_color() == "#c00000"
    labels = [line.get_text() for line in figure.axes[0].get_legend().get_texts()]
    assert labels[:3] == ["rail", "wheel", "patch 0: 51.5 kN, 108.3 mrad"] and labels[-1] == "first touch"
    assert figure.axes[0].get_xlabel() == "track y, mm (to the left)"
    assert wrcontact.solve(lateral=3, side="left").plot()._supxlabel is None
