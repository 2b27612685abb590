"""What mypy and editors know of keys and results."""
import pickle
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest

import wrcontact
from conftest import BUILD, PROJECT

# Each line that mypy must refuse, with a word of what it says; all others it must accept.
MISTAKES = '''
import numpy as np
import wrcontact
scene, result = wrcontact.Scene(lateral=3, rail="60E1"), wrcontact.solve(lateral=np.float64(3), yaw=1e-3)
wrcontact.solve(laterl=3)                                   # No overload variant
result.left.pmx                                             # has no attribute "pmx"
for patch in result.left.patches:
    patch.presure                                           # has no attribute "presure"
scene.set(accurcy=1e-2)                                     # Unexpected keyword argument "accurcy"
wrcontact.Scene(yaw=[1e-3, 2e-3])                           # incompatible type "List[float]"
text: str = result.left.patch_count                         # expression has type "int"
step = wrcontact.Solver().step(scene, [0.0] * 6, [0.0] * 6)
step.by_position.sum()                                      # Item "None"
wrcontact.Profile("S1002").conicity()                       # Missing positional argument "rail"
wrcontact.study({"lateral": [0]}, "left.pmax", railz="60E1")  # Unexpected keyword argument "railz"
pmax: float = result.right.patches[0].pmax + wrcontact.Profile("S1002").dimensions["qr"] + step.jacobian()[0, 1, 1]
data = wrcontact.solve(lateral=np.linspace(0.0, 1.0, 3), rail=["60E1", "54E1", "56E1"], outputs=["left.pmax"])
data["left.pmax"].plot()
'''


def checked(*files, folder):
    """Lines of mypy by file and number."""
    answer = subprocess.run(
        ["mypy", "--strict", "--ignore-missing-imports", "--hide-error-context", "--no-error-summary", "--cache-dir",
         PROJECT / "build/mypy",
         *files], cwd=folder, capture_output=True, text=True, env={"PATH": "/usr/bin:/bin", "MYPYPATH": str(BUILD / "python")})
    return {(name, int(line)): text for name, line, text in re.findall(r"^(.*?):(\d+): error: (.*)$", answer.stdout, re.M)}


@pytest.mark.skipif(shutil.which("mypy") is None, reason="mypy is not installed")
def test_mypy_refuses_mistakes_and_accepts_the_examples(tmp_path):
    (tmp_path / "mistakes.py").write_text(MISTAKES, encoding="utf-8")
    found = checked("mistakes.py", *sorted((PROJECT / "python_bindings/examples").glob("*.py")), folder=tmp_path)
    expected = {("mistakes.py", number): line.partition("  # ")[2] for number, line in
                enumerate(MISTAKES.splitlines(), 1) if "  # " in line}
    assert found.keys() == expected.keys() and len(expected) > 5
    assert not [key for key in found if expected[key] not in found[key]]


def test_the_lists_of_names_are_up_to_date():
    answer = subprocess.run([sys.executable, "-B", PROJECT / "scripts/write_python_names.py", "--check"],
                            capture_output=True, text=True)
    assert answer.returncode == 0, answer.stdout + answer.stderr


def test_the_list_of_names_has_those_of_results():
    text = (PROJECT / "python_bindings/wrcontact/_names.pyi").read_text(encoding="utf-8")
    result = wrcontact.solve(accuracy=1e-2)
    for child in result.left.patches[0]._children() + result.left._children() + result._children():
        assert child.isdigit() or f"\n    {child}: " in text, child


def test_a_step_has_a_jacobian_in_the_usual_order():
    scene, solver = wrcontact.Scene(accuracy=1e-2, accuracy_of="forces"), wrcontact.Solver()
    position, velocity = np.array([0.0, 1.0, 459.7, 0.0, 0.0, 0.001]), np.array([20e3, 1.0, 0, 0, 20e3 / 460, 0])
    step = solver.step(scene, position, velocity, derivatives=True)
    jacobian = step.jacobian()
    assert jacobian.shape == (2, 6, 12) and (jacobian[:, 2, 2] != 0.0).all()
    for wheel, component, coordinate in ((0, 1, 1), (1, 2, 3), (0, 5, 2)):
        assert jacobian[wheel, component, coordinate] == step.by_position[wheel, coordinate, component]
        assert jacobian[wheel, component, 6 + coordinate] == step.by_velocity[wheel, coordinate, component]
    change = 1e-4
    later = solver.step(scene, position + [0, 0, change, 0, 0, 0], velocity).force
    assert np.isclose((later - step.force)[0, 2] / change, jacobian[0, 2, 2], rtol=0.02)
    for name in ("by_position", "by_velocity"):
        assert getattr(wrcontact.Step, name).__doc__.startswith("[2, 6, 6], [wheel, coordinate, component]")
    with pytest.raises(wrcontact.NoResult, match="derivatives=True"):
        solver.step(scene, position, velocity).jacobian()


def test_what_can_be_sent_is_pickled_and_the_rest_says_what_to_send(tmp_path):
    scene, solver = wrcontact.Scene(accuracy=1e-2), wrcontact.Solver()
    step = solver.step(scene, [0, 1, 459.8, 0, 0, 0], [20e3, 0, 0, 0, 43.0, 0], derivatives=True)
    sent = pickle.loads(pickle.dumps(step))
    assert np.array_equal(sent.jacobian(), step.jacobian()) and np.array_equal(sent.states, step.states)
    profile = wrcontact.Profile("S1002")
    for one in (profile, wrcontact.Profile.from_points("wheel", *profile.at(np.arange(0, 150, 0.5))[:2])):
        assert np.array_equal(pickle.loads(pickle.dumps(one)).at(40.0), one.at(40.0))
    one.write(tmp_path / "wheel.txt")
    file = wrcontact.Profile.from_file(tmp_path / "wheel.txt", kind="wheel").smooth(5.0)
    assert pickle.loads(pickle.dumps(file)).length == file.length
    comparison = profile.compare(one)
    assert pickle.loads(pickle.dumps(comparison)).rms == comparison.rms
    dimensions = pickle.loads(pickle.dumps(profile.dimensions))
    assert dimensions == profile.dimensions and dimensions.units == profile.dimensions.units
    result = wrcontact.solve(accuracy=1e-2)
    assert pickle.loads(pickle.dumps(result.freeze().left)).pmax == result.left.pmax
    for refused, instead in ((result, "freeze"), (result.left.patches[0], "freeze"), (wrcontact.History(), "send the positions"),
                             (wrcontact.Table(), "Table.save"), (solver, "make another one")):
        with pytest.raises(TypeError, match=instead):
            pickle.dumps(refused)
