"""The wheel: made from the sources, installed without network, removed without a trace."""
import os
import subprocess
import sys
import zipfile

import pytest

from conftest import BUILD, PROJECT


def run(*command, **environment):
    done = subprocess.run(command, capture_output=True, text=True, timeout=600,
                          env={**os.environ, "PYTHONPATH": "", **environment})
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """A wheel, and the Python of an environment that has it beside Debian's packages."""
    folder = tmp_path_factory.mktemp("wheel")
    run(sys.executable, "-m", "pip", "wheel", "-q", "--no-build-isolation", "--no-deps", "--no-index",
        "-w", folder, PROJECT / "python_bindings", WRCONTACT_BUILD_FOLDER=str(BUILD))
    (wheel,) = folder.glob("*.whl")
    run(sys.executable, "-m", "venv", "--system-site-packages", "--without-pip", folder / "venv")
    python = folder / "venv/bin/python3"
    run(python, "-m", "pip", "install", "-q", "--no-index", wheel)
    return wheel, python


def test_its_name_says_any_python_on_this_system(installed):
    wheel, _ = installed
    version = run(BUILD / "bin/wrc_case", "--version").split()[-1]
    assert wheel.name.startswith(f"wrcontact-{version}-py3-none-linux_")
    names = zipfile.ZipFile(wheel).namelist()
    assert sum("libwrcontact.so" in name for name in names) == 1
    assert not [name for name in names if "__pycache__" in name]
    assert zipfile.ZipFile(wheel).getinfo("wrcontact/libwrcontact.so.0.4").file_size < 5e6  # stripped


def test_it_solves_to_the_same_bits_and_leaves_nothing(installed, wrc_case):
    _, python = installed
    program = ("import wrcontact; print(wrcontact.__file__); "
               "print(repr(wrcontact.solve(lateral=3).left.pmax))")
    place, pmax = run(python, "-c", program).split()
    assert "venv" in place and float(pmax) == wrc_case({"pose.lateral": 3})["left.pmax"]
    run(python, "-m", "pip", "uninstall", "-q", "-y", "wrcontact")
    assert not list(python.parents[1].rglob("*wrcontact*"))
