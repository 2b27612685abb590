"""Programs and folders the tests compare with, and scenes of every kind."""
import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

PROJECT = Path(__file__).resolve().parents[2]
BUILD = Path(os.environ["WRCONTACT_BUILD"])

# Keyword arguments of real scenes, beside what wrc_case calls the same.
SCENES = {
    "two lobes": {"lateral": 5},
    "flange and tread": {"lateral": 6.15, "rail": "56E1"},
    "other sides": {"yaw": 0.01, "track_left_rail": "54E1", "load_left": 6e4, "inclination": "1:20"},
    "creep forces": {"creepage_left": [1e-3, 5e-4, 2e-4], "derivatives": "yes"},
    "motion": {"lateral": 2, "speed": 2e4, "motion_yaw": 0.01, "results": ["stress", "wear"]},
    "SI units": {"units": "SI", "frame": "right-down", "lateral": -0.003},
    "Hertz": {"model": "hertz", "side": "left"},
}


def text_of(value):
    if isinstance(value, list):
        return " ".join(value) if isinstance(value[0], str) else "[" + ",".join(map(repr, value)) + "]"
    return str(value)


@pytest.fixture(scope="session")
def wrc_case():
    """What the C++ program finds for the keys of a scene: all numbers and texts by name."""
    def solve(keys, *options):
        command = [BUILD / "bin/wrc_case", "--json", *options, "--set",
                   *(f"{key}={text_of(value)}" for key, value in keys.items())]
        answer = subprocess.run(command, check=True, capture_output=True, text=True)
        return flat(json.loads(answer.stdout))

    return solve


def flat(node, prefix=""):
    if not isinstance(node, (dict, list)):
        return {prefix[:-1]: node}
    children = node.items() if isinstance(node, dict) else enumerate(node)
    return {name: value for key, child in children
            for name, value in flat(child, f"{prefix}{key}.").items()}


@pytest.fixture
def python():
    """Runs a program in an interpreter of its own."""
    def run(program, **options):
        return subprocess.run([sys.executable, "-B", "-c", program], capture_output=True, text=True,
                              timeout=600, **options)

    return run
