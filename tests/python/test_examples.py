"""Examples, pictures, and the programs that README and docs show."""
import os
import re
import subprocess
import sys

import pytest

import wrcontact
from conftest import PROJECT

EXAMPLES = sorted((PROJECT / "python_bindings/examples").glob("*.py"))
# Those below <!-- file: ... --> are run by tests/readme.
PROGRAMS = {f"{page} {index}": program for page in ("README.md", "docs/python.md")
            for index, program in enumerate(re.findall(
                r"(?<!-->\n)```python\n(.*?)```", (PROJECT / page).read_text(encoding="utf-8"), re.S))}


@pytest.fixture(scope="module")
def run(tmp_path_factory):
    """Runs a program in a folder; matplotlib's list of fonts is made once."""
    fonts = {"MPLCONFIGDIR": str(tmp_path_factory.mktemp("fonts"))}
    subprocess.run([sys.executable, "-c", "import matplotlib.font_manager"], env={**os.environ, **fonts},
                   capture_output=True, check=True)

    def start(command, folder):
        done = subprocess.run([sys.executable, "-B", *command], cwd=folder, capture_output=True,
                              text=True, env={**os.environ, **fonts}, timeout=600)
        others = re.sub(r"^.*: ContactWarning: .*\n(  .*\n)?", "", done.stderr, flags=re.M)
        assert done.returncode == 0 and not others, done.stderr
        return done.stdout

    return start


def size_of(picture):
    """Width and height of a PNG that is not of one colour."""
    from matplotlib.image import imread

    pixels = imread(picture)
    assert pixels.reshape(-1, pixels.shape[2]).std(axis=0).max() > 0.05
    return pixels.shape[1], pixels.shape[0]


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda path: path.stem)
def test_examples_print_and_draw(example, run, tmp_path):
    assert run([example], tmp_path)
    pictures = list(tmp_path.glob("*.png"))
    assert pictures and all(min(size_of(picture)) > 300 for picture in pictures)


@pytest.mark.parametrize("name", PROGRAMS)
def test_programs_of_the_pages_run(name, run, wrc_case, tmp_path):
    printed = run(["-c", PROGRAMS[name]], tmp_path)
    assert printed
    for picture in tmp_path.glob("*.png"):
        size_of(picture)
    if name == "README.md 0":  # the pressure of the other languages
        expected = wrc_case({"pose.lateral": 3})["left.pmax"]
        assert float(re.search(r"pmax = (\S+) MPa", printed).group(1)) == expected


@pytest.mark.parametrize("values, rows", [
    ({"lateral": 6.15, "rail": "56E1"}, 2), ({"until": "geometry"}, 1), ({"until": "remesh"}, 1),
    ({"creepage_left": [1e-3, 0, 0]}, 3), ({"side": "left", "units": "SI", "frame": "right-down"}, 2),
    ({"vertical": 461}, 1)])
def test_every_result_can_be_drawn(values, rows, tmp_path):
    pytest.importorskip("matplotlib")
    figure = wrcontact.Scene(**values).plot(tmp_path / "scene.png")
    panels = [axes for axes in figure.axes if axes.get_label() != "<colorbar>"]
    assert len(panels) == rows * (1 if "side" in values else 2)
    assert min(size_of(tmp_path / "scene.png")) > 200


def test_profiles_can_be_drawn(tmp_path):
    for name in ("S1002", "60E1"):
        wrcontact.Profile(name).plot(tmp_path / "profile.png")
        assert min(size_of(tmp_path / "profile.png")) > 200
