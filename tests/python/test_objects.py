"""Objects in the hands of Python: copies, pickles, other processes, masks."""
import copy
import multiprocessing
import pickle

import numpy as np
import pytest

import wrcontact

SCENE = {"lateral": 3, "accuracy": 1e-2}


def solved(lateral):
    return wrcontact.solve(**{**SCENE, "lateral": lateral})


def frozen(lateral):
    return solved(lateral).freeze(["left.pressure"])


def test_a_frozen_result_is_read_as_the_result():
    result = wrcontact.solve(**SCENE, load_left=1e6)
    for kept in (result.freeze(["left.pressure"]), pickle.loads(pickle.dumps(result.freeze(["left.pressure"])))):
        assert kept.to_dict() == result.to_dict() and repr(kept) == repr(result)
        assert kept.left.patches[0].pmax == result.left.patches[0].pmax and len(kept.left.patches) == len(result.left.patches)
        assert np.array_equal(kept.left.pressure, result.left.pressure)
        assert kept.warnings == result.warnings and kept["units"] == result["units"]
        with pytest.raises(wrcontact.UnknownName, match="freeze"):
            kept["right.pressure"]
        for needs_scene in (kept.patch_table, kept.patch_frame, kept.plot):
            with pytest.raises(wrcontact.NoResult, match="no scene"):
                needs_scene()
    with pytest.raises(wrcontact.UnknownName):
        result.freeze(["left.nothing"])
    result.scene.solve()
    assert kept.left.pmax == result.scene.result.left.pmax


def test_results_of_other_processes_come_frozen_or_not_at_all():
    with multiprocessing.Pool(2) as pool:
        assert [one.left.pmax for one in pool.map(frozen, [0, 1])] == [solved(y).left.pmax for y in (0, 1)]
        with pytest.raises(multiprocessing.pool.MaybeEncodingError, match="freeze"):
            pool.map_async(solved, [0, 1]).get(timeout=60)


def test_an_error_is_sent_without_its_result():
    error = wrcontact.NotConverged("not converged")
    error.status, error.result = 8, solved(0)
    sent = pickle.loads(pickle.dumps(error))
    assert type(sent) is wrcontact.NotConverged and str(sent) == "not converged"
    assert sent.status == 8 and sent.result is None


def test_handles_are_copied_or_refused_never_shared():
    scene, solver, history = wrcontact.Scene(**SCENE), wrcontact.Solver(), wrcontact.History()
    position, velocity = [0, 1.0, 459.8, 0, 0, 0], np.array([0, 2.0, 0, 0, 0, 0])

    def lateral_force(of):
        return solver.step(scene, position, velocity, history=of, dt=1e-3).force[0][1]

    lateral_force(history)
    history.accept()
    kept, expected = [copy.copy(history), copy.deepcopy(history)], lateral_force(history)
    history.accept()
    assert lateral_force(history) != expected
    assert [lateral_force(one) for one in kept] == [expected, expected]
    gap = wrcontact.NormalContact([[0.0]], 1, 1, normal_load=1.0)
    slip = wrcontact.RollingContact([[1.0]], 1, 1)
    for one in (solver, gap, slip, wrcontact.Table(), scene.solve(), history):
        for act in (copy.copy, copy.deepcopy, pickle.dumps):
            if one is history and act is not pickle.dumps:
                continue
            with pytest.raises(TypeError, match="cannot be copied or pickled"):
                act(one)


def test_masks_are_not_dropped():
    y = np.linspace(-60, 60, 241)
    mask = abs(y) < 1
    points = [np.ma.masked_array(y, mask), np.ma.masked_array(-y**2 / 600, mask)]
    with pytest.raises(wrcontact.InvalidArgument, match="masked values"):
        wrcontact.Profile.from_points("rail", *points)
    with pytest.raises(wrcontact.InvalidArgument, match="masked values"):
        wrcontact.NormalContact(np.ma.masked_less(np.eye(3) - 1.0, 0.0), 1, 1)
    wrcontact.Profile.from_points("rail", *(values[~values.mask] for values in points))
