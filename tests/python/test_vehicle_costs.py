"""The program behind the first table of docs/vehicle.md, on few states."""
import sys

import pytest

from conftest import PROJECT

numpy = pytest.importorskip("numpy", reason="the costs of a vehicle's step need numpy")
sys.path.insert(0, str(PROJECT / "drivers/evidence"))
costs = pytest.importorskip("compare_vehicle_costs")


def test_errors_fall_with_the_accuracy_and_not_with_that_of_fastsim():
    states = costs.drawn_states(12, 1)
    truth, _ = costs.forces(states, costs.solved_step("full", 3e-4))

    def error(creep, accuracy):
        return numpy.abs(costs.forces(states, costs.solved_step(creep, accuracy))[0] - truth).mean()

    assert error("full", 1e-2) < 0.5 * error("full", 1e-1)
    assert error("fastsim", 1e-3) > 0.9 * error("fastsim", 1e-2) > error("full", 1e-1)
