"""Tables of contact forces in Python."""
import pytest

numpy = pytest.importorskip("numpy")
wrcontact = pytest.importorskip("wrcontact")

VELOCITY = [2e4, 10, 0, 0, 43.5, 0]
SMALL = {"lateral": 1.0, "roll": 0.003, "yaw": 0.01, "load": 1.2e5, "fineness": 0.2, "threads": 2}


@pytest.fixture(scope="module", name="scene")
def scene_of_table():
    return wrcontact.Scene(accuracy=0.01, accuracy_of="forces")


@pytest.fixture(scope="module", name="table")
def small_table(scene):
    table = wrcontact.Table()
    shares = []
    table.build(scene, progress=shares.append, **SMALL)
    assert shares == sorted(shares) and shares[-1] <= 1
    return table


def test_a_step_is_the_exact_one_within_its_error(scene, table, tmp_path):
    solver = wrcontact.Solver()
    position, exact = solver.equilibrium(scene, [0, 0.2, 0, 0, 0, 2e-3], axle=[1.2e5, 0], velocity=VELOCITY)
    step, error = table.step(position, VELOCITY, derivatives=True)
    assert (abs(step.force[:, :3] - exact.force[:, :3]).max(axis=1) < 6e4 * error).all()
    assert step.by_position.shape == (2, 6, 6) and (step.states == 0).all()
    table.save(tmp_path / "small.table")
    read = wrcontact.Table()
    read.load(tmp_path / "small.table")
    for other in (read, table.share()):
        assert (other.step(position, VELOCITY)[0].force == step.force).all()
    assert read.facts() == table.facts()
    assert read.lines() == table.lines() and "track.rail = 60E1" in read.lines()
    assert not wrcontact.Table().lines()


def test_outputs_and_equilibrium(scene, table):
    (position, step), error = table.equilibrium([0, 0.2, 0, 0, 0, 2e-3], wheels=[5e4, 7e4], velocity=VELOCITY)
    assert abs(step.force[:, 2] - [5e4, 7e4]).max() < 0.1 and (step.likely_errors[:, 0] <= error).all()
    names = table.output_names()
    assert names[0] == "wear_number" and step.outputs.shape == (2, len(names))
    exact = wrcontact.Solver()
    exact.step(scene, position, VELOCITY)
    for side, name in enumerate(("left", "right")):
        for i in (0, 1, 2, 4):
            assert abs(step.outputs[side, i] - scene.result[f"{name}.{names[i]}"]) <= 2 * step.output_errors[side, i]
    assert exact.step(scene, position, VELOCITY).outputs is None


def test_outside_is_refused_or_solved(scene, table):
    solver = wrcontact.Solver()
    position, _ = solver.equilibrium(scene, [0, 0.2, 0, 0, 0, 0.02], axle=[1.2e5, 0], velocity=VELOCITY)
    with pytest.raises(wrcontact.InvalidArgument, match="yaw against the rail"):
        table.step(position, VELOCITY)
    step, error = table.step(position, VELOCITY, solver=solver, scene=scene)
    assert (error == 0).all() and (step.force == solver.step(scene, position, VELOCITY).force).all()


def test_what_progress_raises_ends_the_build(scene):
    def stop(share):
        if share > 0.2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        wrcontact.Table().build(scene, progress=stop, **SMALL)
