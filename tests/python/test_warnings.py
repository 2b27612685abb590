"""Warnings of profiles and solutions as those of Python."""
import warnings

import numpy as np
import pytest

import wrcontact

WARNED = {"lateral": 5, "accuracy": 0.0025, "side": "left"}
OVER = {**WARNED, "accuracy": 0.004}


def told(call):
    """What a call warns of, and what it returns."""
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = call()
    assert all(one.category is wrcontact.ContactWarning for one in caught)
    assert all(one.filename == __file__ for one in caught), "not a line of the package"
    return [str(one.message) for one in caught], result


def test_a_solution_warns_of_each_text():
    for call in (lambda: wrcontact.solve(**WARNED), lambda: wrcontact.Scene(**WARNED).solve(),
                 lambda: wrcontact.Solver().solve(wrcontact.Scene(**WARNED))):
        texts, result = told(call)
        assert texts == result.warnings and texts[0].startswith("left: the rail turns by")
        assert result["warnings.0"] == texts[0] and result["warning_classes.0"] == "patch_turn"
        assert result["warning_count"] == len(texts) and result.left.warning_count == 1
        assert f"do not use: {texts[0]}" in str(result)
        assert result["grade"] == result.left.grade == 2 and result["warning_grades.0"] == "do not use"
    assert told(lambda: wrcontact.solve(lateral=0))[0] == []


def test_a_little_over_the_accuracy_is_one_note():
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        result = wrcontact.solve(**OVER)
    assert [one.category for one in caught] == [wrcontact.AccuracyNote]
    assert str(caught[0].message) == f"a little over: {result.warnings[0]}"
    assert result["grade"] == 1 and result["warning_grades.0"] == "a little over"
    assert f"  a little over: {result.warnings[0]}" in str(result)
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        data = wrcontact.study({"lateral": [0, 5, 5.05, 6.5]}, accuracy=0.004, side="left")
    assert list(data["grade"].values) == [0, 1, 1, 2]
    notes = [str(one.message) for one in caught if one.category is wrcontact.AccuracyNote]
    assert len(notes) == 1 and notes[0].startswith("a little over: 2 of 4 scenes: left: the rail")


def test_a_warning_may_be_an_error():
    with warnings.catch_warnings():
        warnings.simplefilter("error", wrcontact.ContactWarning)
        with pytest.raises(wrcontact.ContactWarning):
            wrcontact.solve(**WARNED)


def test_steps_do_not_warn_but_have_warnings():
    scene, solver = wrcontact.Scene(lateral=6.5, accuracy=0.1), wrcontact.Solver()
    _, result = told(scene.solve)
    position = [0, 6.5, result.vertical - result.left.depth, result.roll, 0, 0]
    texts, _ = told(lambda: solver.step(scene, position, [2e4, 0, 0, 0, 2e4 / 460, 0]))
    assert texts == [] and "more than steel can carry" in scene.result.warnings[0]


def test_batches_and_studies_warn_of_each_kind_once():
    lateral = [0, 5, 5.05, 6.5]
    expected = ["2 of 4 scenes: left: the rail turns by 0.",
                "1 of 4 scenes: left: the largest pressure, 6"]
    scenes = [wrcontact.Scene(**{**WARNED, "lateral": one}) for one in lateral]
    texts, results = told(lambda: wrcontact.solve_batch(scenes))
    assert len(texts) == 2 and all(map(str.startswith, texts, expected))
    texts, data = told(lambda: wrcontact.study({"lateral": lateral}, accuracy=0.0025, side="left"))
    assert len(texts) == 2 and all(map(str.startswith, texts, expected))
    assert list(data["warning_count"].values) == [0, 1, 1, 1]
    assert list(data["warnings"].values) == [" | ".join(result.warnings) for result in results]
    texts, data = told(lambda: wrcontact.study({"lateral": lateral}, ["warning_count"], accuracy=0.0025,
                                               side="left"))
    assert np.array_equal(data["warning_count"].values, [0, 1, 1, 1])
