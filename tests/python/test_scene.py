"""Scenes and their results: the bits of the C interface."""
import copy
import subprocess

import numpy as np
import pytest

import wrcontact
from conftest import BUILD, PROJECT, SCENES


@pytest.mark.parametrize("name", SCENES)
def test_all_numbers_and_texts_are_those_of_the_c_interface(name, wrc_case):
    values = SCENES[name]
    expected = wrc_case({wrcontact.key_of(word): value for word, value in values.items()})
    found = wrcontact.solve(**values).to_dict()
    names = {one for one in found.keys() & expected.keys() if not one.startswith("time_ms")}
    assert len(names) > 50
    assert [one for one in names if found[one] != expected[one]] == []


def test_fields_are_those_of_the_c_interface(tmp_path):
    subprocess.run([BUILD / "bin/wrc_case", "--set", "pose.lateral=5", "--field",
                    tmp_path / "field.csv"], check=True, capture_output=True)
    table = np.genfromtxt(tmp_path / "field.csv", delimiter=",", names=True,
                          dtype=None, encoding="utf-8")
    for side, wheel in (("left", (result := wrcontact.solve(lateral=5)).left), ("right", result.right)):
        rows = table[table["side"] == side]
        patch = wheel.patches[0]
        for name in ("x", "y", "z", "undeformed_distance", "pressure", "displacement"):
            assert np.array_equal(patch.field(name).ravel(), rows[name])
        assert patch.pressure.shape == (patch.grid.lateral, patch.grid.longitudinal)
        assert np.array_equal(wheel.field("pressure"), patch.pressure)


def test_fields_have_rows_across_and_columns_along():
    result = wrcontact.solve(**SCENES["motion"])
    patch = result.left.patches[0]
    assert np.ptp(patch.field("x"), axis=0).max() == 0.0
    assert np.all(np.diff(patch.field("y")[:, 0]) > 0.0)  # the left wheel's field side
    assert patch.traction_x.shape == (patch.creep_grid.lateral, patch.creep_grid.longitudinal)
    assert patch.traction_x.shape == patch.frictional_energy.shape
    depth = patch.stress_depth
    assert depth.shape[0] > 1 and np.ptp(depth, axis=1).max() == 0.0 and np.all(np.diff(depth[:, 0]) > 0)
    assert np.isclose(patch.stress_von_mises.max(), patch.stress.von_mises_max, rtol=0.1)
    assert patch.wear_depth.ndim == 1


def test_a_number_with_derivatives_is_the_number():
    patch = wrcontact.solve(**{**SCENES["creep forces"], "derivatives": True}).left.patches[0]
    assert isinstance(patch.creep_force.longitudinal, float)
    assert patch["creep_force.longitudinal.by.friction"] != 0.0
    assert "and creepage" not in repr(patch.creep_force) and "longitudinal: " in repr(patch.creep_force)


def test_keywords_stand_for_the_keys_of_the_library():
    keys = wrcontact.keys()
    assert list(keys)[0] == "convention.units" and keys["pose.lateral"].default == "0.0"
    forms = [name.replace(".", "_") for name in keys]
    assert len(set(forms)) == len(forms)
    for name, form in zip(keys, forms):
        assert wrcontact.key_of(form) == wrcontact.key_of(name) == name
    for word, name in {"lateral": "pose.lateral", "rail": "track.rail", "poisson": "material.poisson",
                       "wheel_poisson": "material.wheel.poisson", "accuracy": "solve.accuracy",
                       "radius": "wheelset.radius", "speed": "motion.speed"}.items():
        assert wrcontact.key_of(word) == name
    with pytest.raises(wrcontact.UnknownName, match="load_left or friction_left"):
        wrcontact.key_of("left")
    with pytest.raises(wrcontact.UnknownName, match="unknown key latral; nearest: pose.lateral"):
        wrcontact.Scene(latral=3)


def test_case_of_keys_does_not_matter():
    scene = wrcontact.Scene(Lateral=3, LOAD_Left=7e4)
    assert (scene["pose.lateral"], scene["Load.LEFT"]) == (3, 7e4)
    with pytest.raises(wrcontact.InvalidArgument, match="load.left is given twice"):
        wrcontact.Scene(load_left=7e4, LOAD_Left=7e4)


def test_a_key_that_is_named_twice_is_refused():
    with pytest.raises(wrcontact.InvalidArgument, match="pose.lateral is given twice, as lateral and as pose_lat"):
        wrcontact.solve(lateral=4, pose_lateral=3)
    scene = wrcontact.Scene(lateral=1)
    with pytest.raises(wrcontact.InvalidArgument):
        scene.set(pose_lateral=2, lateral=3)
    assert scene["lateral"] == 1.0
    with pytest.raises(wrcontact.InvalidArgument):
        wrcontact.study({"lateral": [1.0]}, pose_lateral=2)


def test_an_unknown_result_is_reported_with_the_nearest_names():
    result = wrcontact.solve(accuracy=0.1)
    for word, nearest in {"left.pmx": "left.pmax", "modl": "model",
                          "left.patches.0.nomal_force": "left.patches.0.normal_force"}.items():
        with pytest.raises(wrcontact.UnknownName, match=f'is named "{word}"; nearest: {nearest}'):
            result[word]
    with pytest.raises(AttributeError, match="nearest: left.pmax"):
        result.left.pmx
    with pytest.raises(wrcontact.UnknownName, match="known, but this solution has no such number"):
        result["left.patches.9.pmax"]


def test_every_key_takes_the_value_it_gives():
    scene, other = wrcontact.Scene(), wrcontact.Scene()
    for key in scene:
        other[key] = scene[key]
    assert repr(other) == repr(scene) == "wrcontact.Scene()"


def test_values_of_all_kinds(tmp_path):
    scene = wrcontact.Scene(lateral=np.float32(2), derivatives=True, grid=(64, 32), rail_yield_stress=None,
                            track_left_displacement=np.array([1, 0, 0.01]), threads=np.int64(2))
    assert scene["lateral"] == 2.0 and scene["solve.derivatives"] == "yes"
    assert list(scene["grid"]) == [64, 32] and list(scene["track.left.displacement"]) == [1, 0, 0.01]
    assert scene["material.rail.yield_stress"] == "none" and scene["solve.threads"] == 2
    assert repr(wrcontact.Scene(lateral=3, rail="CHN60")) == (
        "wrcontact.Scene(track.rail='CHN60', pose.lateral=3.0)")
    scene.write(tmp_path / "scene.toml")
    assert 'derivatives = "yes"' in (tmp_path / "scene.toml").read_text()
    wrcontact.Profile("60E1").write(tmp_path / "rail.prr")
    assert wrcontact.solve(rail=tmp_path / "rail.prr").left.pmax > 0.0
    for wrong in ("60E1\0", [1.0, np.nan, 2.0], object()):
        with pytest.raises((wrcontact.InvalidArgument, TypeError)):
            wrcontact.Scene(rail=wrong)


def test_the_convention_comes_first_and_holds_for_numbers():
    mm, metres = wrcontact.solve(lateral=3), wrcontact.solve(lateral=0.003, units="SI")
    assert np.isclose(metres.left.pmax, 1e6 * mm.left.pmax, rtol=1e-12)
    assert "centre 0.4599" in repr(metres) and "pmax, Pa" in repr(metres)


def test_a_result_shows_itself_and_its_names():
    result = wrcontact.solve(lateral=6.15, rail="56E1")
    text = repr(result)
    assert f"{result.left.patches[1].pmax:.6g}" in text and "half-space" in text
    assert len(result.left.patches) == result.left.patch_count == 2 == len(list(result.left.patches))
    assert {"left", "right", "roll"} <= set(dir(result)) and "pmax" in dir(result.left)
    assert "centroid" in repr(result.left.patches[0])
    table = result.patch_table()
    assert sorted(table["pmax"][:2]) == sorted(one.pmax for one in result.left.patches)
    assert not hasattr(result.left, "no_such_result")
    with pytest.raises(IndexError):
        result.left.patches[2]
    lifted = wrcontact.solve(vertical=461, side="left")
    assert "no patches" in repr(lifted)
    assert lifted.left.patches == lifted["left.patches"] == result.left.patches[0].parts == []
    assert lifted.freeze().left.patches == [] and not hasattr(lifted, "right")
    with pytest.raises(wrcontact.UnknownName):
        lifted["left.patches.0.parts"]
    assert "geometry" not in repr(wrcontact.solve(until="geometry"))


def test_a_result_ends_with_the_next_solution_of_its_scene():
    scene = wrcontact.Scene()
    with pytest.raises(wrcontact.NoResult):
        scene.result
    first = scene.solve()
    kept = first.to_dict()
    second = scene.set(lateral=4).solve()
    with pytest.raises(wrcontact.NoResult, match="solved again"):
        first.left.pmax
    assert second.left.pmax != kept["left.pmax"] and scene.result.left.pmax == second.left.pmax


def test_a_failed_solution_leaves_the_result():
    scene = wrcontact.Scene()
    result = scene.solve()
    scene.set(lateral=100, roll="en15302")
    with pytest.raises(wrcontact.NoContact):
        scene.solve()
    assert result.left.pmax == scene.result.left.pmax > 0.0


def test_a_solver_gives_the_bits_of_single_scenes():
    solver, scene = wrcontact.Solver(), wrcontact.Scene(accuracy=1e-2)
    for lateral in (0, 3, 6.5, -2):
        found = solver.solve(scene.set(lateral=lateral)).to_dict()
        alone = wrcontact.solve(lateral=lateral, accuracy=1e-2).to_dict()
        assert {name for name in alone if found[name] != alone[name]} <= {
            name for name in alone if name.startswith("time_ms")}
    solver.clear()
    assert solver.solve(scene).left.pmax == alone["left.pmax"]


def test_options_of_a_solver_change_results_within_their_tolerance():
    mixed = wrcontact.Solver().solve(wrcontact.Scene(accuracy=1e-2)).left.pmax
    solver = wrcontact.Solver(precision="double", planner="estimate")
    found = solver.solve(wrcontact.Scene(accuracy=1e-2)).left.pmax
    assert found != mixed and abs(found / mixed - 1) < 1e-3
    assert solver.set(precision="mixed").solve(wrcontact.Scene(accuracy=1e-2)).left.pmax == mixed
    with pytest.raises(wrcontact.InvalidArgument, match='must be "mixed" or "double"'):
        solver.set(precision="single")
    with pytest.raises(wrcontact.UnknownName, match="there are planner, precision"):
        wrcontact.Solver(threads="2")
    with pytest.raises(wrcontact.InvalidArgument, match="planner = 3: a text"):
        wrcontact.Solver(planner=3)


def test_a_step_gives_forces_and_derivatives_of_both_wheels():
    solver, scene = wrcontact.Solver(), wrcontact.Scene(accuracy_of="forces")
    position, velocity = [0, 3.0, 459.88, 1e-4, 0, 1e-3], [2e4, 15.0, 0, 0, 43.5, 0]
    step = solver.step(scene, position, velocity, derivatives=True)
    total = scene.result.left.total
    assert list(step.force[0]) == [*(total.force[one] for one in "xyz"),
                                   *(total.moment[one] for one in "xyz")]
    assert step.states[1] & 1 and not step.force[1].any()
    lowered = solver.step(scene, [0, 3.0, 459.88 - 1e-4, 1e-4, 0, 1e-3], velocity)
    difference = (lowered.force[0, 2] - step.force[0, 2]) / -1e-4
    assert np.isclose(step.by_position[0, 2, 2], difference, rtol=0.02)  # row: coordinate z
    assert lowered.by_position is None
    forces, by_creepage = solver.creep(scene, 0, [1e-4, 0, 0])
    more, _ = solver.creep(scene, 0, [1.001e-4, 0, 0])
    assert np.isclose(by_creepage[0, 0], (more[0] - forces[0]) / 1e-7, rtol=0.02)
    with pytest.raises(wrcontact.InvalidArgument, match="position has 5"):
        solver.step(scene, position[:5], velocity)


def test_a_step_takes_rails_curvature_and_friction():
    solver, scene = wrcontact.Solver(), wrcontact.Scene(accuracy_of="forces", creep="fastsim")
    position, velocity = [0, 3.0, 459.815, 1.8e-4, 0, 1e-3], [2e4, 15.0, 0, 0, 43.5, 0]
    step = solver.step(scene, position, velocity, derivatives=True, friction=[0.2, 0.4],
                       curvature=-2e-6, rail_velocities=[[3.0, 0, 0], [0, 0, 0]])
    assert scene["friction.right"] == 0.4 and scene["motion.curvature"] == -2e-6
    assert step.by_rail is not None and step.by_position is not None
    assert np.array_equal(step.by_rail[:, 1], -step.by_position[:, 2])
    with pytest.raises(wrcontact.InvalidArgument, match="friction has 1 values"):
        solver.step(scene, position, velocity, friction=[0.3])


def test_a_step_with_a_history_holds_what_adhesion_holds():
    solver, scene, history = wrcontact.Solver(), wrcontact.Scene(accuracy_of="forces"), wrcontact.History()
    position, slow, at_rest = [0, 3.0, 459.815, 1.8e-4, 0, 1e-3], [1.0, 0.5, 0, 0, 0, 0], [0.0] * 6
    first = solver.step(scene, position, slow, history=history, dt=1e-3)
    again = solver.step(scene, position, slow, history=history, dt=1e-3)
    assert np.array_equal(first.force, again.force) and first.force[:, 0].sum() < -1e3
    history.accept()
    kept = history.copy()
    held = solver.step(scene, position, at_rest, history=history, dt=1e-3)
    assert np.isclose(held.force[:, 0].sum(), first.force[:, 0].sum(), rtol=1e-2)
    history.clear()
    assert abs(solver.step(scene, position, at_rest, history=history, dt=1e-3).force[:, 0].sum()) < 1.0
    assert np.array_equal(solver.step(scene, position, at_rest, history=kept, dt=1e-3).force, held.force)
    with pytest.raises(wrcontact.InvalidArgument, match="time_step = 0"):
        solver.step(scene, position, slow, history=history)


def test_equilibrium_finds_height_and_roll():
    solver, scene = wrcontact.Solver(), wrcontact.Scene(accuracy_of="forces", accuracy=1e-3)
    found = solver.equilibrium(scene, [0, 3.0, 0, 0, 0, 0], axle=[1.4e5, 2e6])
    assert np.isclose(found.step.force[:, 2].sum(), 1.4e5, rtol=1e-4)
    assert np.isclose(found.step.force[:, 3].sum(), -2e6, rtol=1e-2)
    assert 459 < found.position[2] < 461
    with pytest.raises(wrcontact.InvalidArgument, match="either wheels"):
        solver.equilibrium(scene, [0] * 6)


def test_a_table_has_an_axis_for_each_key():
    scene = wrcontact.Scene(accuracy=1e-2)
    table = scene.tabulate({"lateral": [0, 2, 4], "yaw": [0, 0.01]}, ["left.pmax", "roll"], threads=2)
    assert table.shape == (3, 2, 2)
    expected = wrcontact.solve(accuracy=1e-2, lateral=4, yaw=0.01)
    assert list(table[2, 1]) == [expected.left.pmax, expected.roll]


def test_the_version_is_that_of_the_project():
    version = (PROJECT / "CMakeLists.txt").read_text().split("project(wrcontact VERSION ")[1]
    assert version.startswith(wrcontact.__version__ + " ")


def test_options_of_profiles(tmp_path):
    file = tmp_path / "my, wheel = 1; b.txt"
    wrcontact.Profile("S1002").write(file)
    scene = wrcontact.Scene(wheel={"smoothing": 5, "file": file, "align_to": None}, load_both=0)
    before = wrcontact.Scene(**{"wheelset.wheel.smoothing": 5}, wheel={"align_to": "none", "File": file})
    assert before["wheelset.wheel.smoothing"] == 5.0, "options count wherever they stand"
    assert wrcontact.Scene(wheel={"smoothing": 5, "File": file})["wheelset.wheel.smoothing"] == 5.0
    scene["wheelset.left.wheel.origin"] = "tape"
    scene["track.rail"] = "; origin = 750"
    assert scene["wheelset.wheel.smoothing"] == 5.0
    assert scene["wheelset.left.wheel"] == f"{file}; smoothing = 5; origin = tape"
    assert scene["track.rail"] == "60E1; origin = 750"
    assert copy.copy(scene)["wheelset.left.wheel"] == scene["wheelset.left.wheel"]
    with pytest.raises(wrcontact.InvalidArgument, match=r'wheelset.wheel.smoothing = "500": must be "auto", or 0 to 100 mm'):
        scene["wheelset.wheel.smoothing"] = 500
    with pytest.raises(wrcontact.UnknownName, match="unknown option wheelset.wheel.slip"):
        wrcontact.Scene(wheel={"file": file, "slip": 2})
    data = wrcontact.study({"wheelset.wheel.smoothing": [0, 3.0]}, ["left.rigid_contact.angle"],
                           wheel={"file": file, "origin": "tape"}, load_both=0)
    assert list(data["wheelset.wheel.smoothing"].values) == [0.0, 3.0]
    assert data["wheelset.wheel.smoothing"].attrs["units"] == "mm"
    assert data["left.rigid_contact.angle"].shape == (2,)
