#!/usr/bin/env python3
"""Shows what constants of behaviour decide: builds the sources with them as they are, smaller and
larger, and prints the figures of a fast sample that move, and the tests of their rooms that fail. Where nothing
moves, or everything by little, they lie in a flat neighbourhood. Sources are copied, and built in a
folder of their own, which is kept for the next call."""
import argparse
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDER = pathlib.Path(tempfile.gettempdir()) / f"wrcontact_vary_{os.getuid()}"
SOURCE = FOLDER / "source"
BUILD = FOLDER / "build"
ROUNDING = 1e-9  # relative: what counts as moved


def run(*command, check=True, cwd=None):
    """The output of a command; ends with its last lines if it fails."""
    done = subprocess.run([str(part) for part in command], cwd=cwd, text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if check and done.returncode:
        sys.exit("\n".join(done.stdout.splitlines()[-30:]))
    return done.stdout


def place_of(name):
    """Room and file of a constant in the list."""
    rows = re.findall(rf"^\| (\w+) \| ([\w.]+) \| {name} \|", run(ROOT / "scripts/list_constants.sh"),
                      re.M)
    if len(rows) != 1:
        sys.exit(f"{name}: {len(rows)} constants of this name in scripts/list_constants.sh")
    return rows[0][0], pathlib.Path("cxx_core", *rows[0])


def varied(text, name, factor):
    """The source with a constant multiplied, in its own type; whole numbers are rounded."""
    def multiplied(at):
        rounding = "" if at[2] == "double" else " + 0.5"
        return f"{at[1]}{at[2]}{at[3]}static_cast<{at[2]}>({factor} * ({at[4]}){rounding});"
    text, count = re.subn(rf"(constexpr )(std::size_t|int|double)( {name}\s*=\s*)([^;]*);", multiplied,
                          text)
    if count != 1:
        sys.exit(f"{name}: not a single number")
    return text


def update(path, content):
    """Writes a file of the copy if it differs, so that only what depends on it is built."""
    if not path.exists() or path.read_bytes() != content:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(content)


def copy_sources(changed):
    """All sources, some of them changed: text by path."""
    files = set(run("git", "ls-files", cwd=ROOT).split("\n")) - {""}
    for file in files:
        if (ROOT / file).is_file():
            text = changed.get(pathlib.Path(file))
            update(SOURCE / file, text.encode() if text else (ROOT / file).read_bytes())
    for path in [path for path in SOURCE.rglob("*") if path.is_file()]:
        if str(path.relative_to(SOURCE)) not in files:
            path.unlink()


def build(rooms):
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    run("cmake", "-S", SOURCE, "-B", BUILD, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
        "-DCMAKE_UNITY_BUILD=ON", "-DCMAKE_UNITY_BUILD_BATCH_SIZE=0", "-DWRCONTACT_BUILD_FORTRAN=OFF",
        "-DWRCONTACT_BUILD_PYTHON=OFF", *launcher)
    run("cmake", "--build", BUILD, "--target", "wrc_regression", "wrc_tradeoff",
        *(f"{room}_test" for room in rooms))


def figures_of(scenes):
    """Figures by name, and the milliseconds that all accuracies take together."""
    figures = {}
    milliseconds = 0.0
    own = re.compile(r"^own +(.+?)  +(\S+) +\S+ +(\S+) +[-+]", re.M)
    for case, key, value in own.findall(run(BUILD / "bin/wrc_regression", check=False)):
        figures[f"{case}: {key}"] = float(value)
    for options in (["--scenes", scenes], ["--creep", scenes // 4 + 1]):
        file = FOLDER / "sample.json"
        run(BUILD / "bin/wrc_tradeoff", *options, "--repeats", 3, "--json", file)
        found = json.loads(file.read_text())
        for row in found.get("asked", found.get("creep")):
            lead = f"{row.get('way', row.get('creep'))} {row.get('asked', row.get('accuracy'))}: "
            milliseconds += row.pop("ms", 0.0) + 1e-3 * row.pop("us", 0.0)
            for key, value in row.items():
                for i, number in enumerate(value if isinstance(value, list) else [value]):
                    if isinstance(number, (int, float)) and key not in ("asked", "accuracy"):
                        figures[f"{lead}{key}" + (f"[{i}]" if isinstance(value, list) else "")] = number
    return figures, milliseconds


def failed_tests(rooms):
    outputs = [run(BUILD / f"bin/{room}_test", "--gtest_brief=1", check=False) for room in rooms]
    return sorted(set(re.findall(r"^\[  FAILED  \] ([\w./]+)", "\n".join(outputs), re.M)))


def change(numbers):
    """The largest relative change of a figure from what it is."""
    now = numbers[1]
    size = max(abs(now), 1e-300)
    return max(abs(number - now) / size if number == number else 0.0 for number in numbers)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("names", nargs="+", metavar="NAME",
                        help="as scripts/list_constants.sh prints it; several are varied together")
    parser.add_argument("--by", type=float, default=0.3, help="share by which it is varied, 0.3 if not given")
    parser.add_argument("--scenes", type=int, default=40,
                        help="of wrc_tradeoff, and a fourth as many with creep forces; 40 if not given")
    options = parser.parse_args()
    places = [(name, *place_of(name)) for name in options.names]
    rooms = sorted({room for _, room, _ in places})
    factors = [1.0 - options.by, 1.0, 1.0 + options.by]
    samples = []
    times = []
    for factor in factors:
        print(f"times {factor:g}: building", file=sys.stderr)
        changed = {}
        for name, _, file in places:
            text = changed.get(file, (ROOT / file).read_text())
            changed[file] = varied(text, name, factor) if factor != 1.0 else text
        copy_sources(changed)
        build(rooms)
        figures, milliseconds = figures_of(options.scenes)
        samples.append(figures)
        times.append(milliseconds)
        failed = failed_tests(rooms)
        print(f"times {factor:g}: {len(failed)} tests of {' '.join(rooms)} fail {' '.join(failed)}")
    rows = [(change(numbers), key, numbers) for key in samples[1]
            if change(numbers := [sample.get(key, float("nan")) for sample in samples]) > ROUNDING]
    print(f"\n{len(rows)} of {len(samples[1])} figures move; largest changes first")
    print(f"{'figure':60}" + "".join(f"{f'times {factor:g}':>14}" for factor in factors))
    for _, key, numbers in sorted(rows, reverse=True)[:30]:
        print(f"{key:60}" + "".join(f"{number:14.6g}" for number in numbers))
    print(f"{'time, ms (of this machine)':60}" + "".join(f"{time:14.4g}" for time in times))


if __name__ == "__main__":
    main()
