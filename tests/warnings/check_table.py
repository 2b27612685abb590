#!/usr/bin/env python3
"""Every class of warnings reaches the user by every way out of the library.

Usage: WRCONTACT_BUILD=build/release PYTHONPATH=build/release/python
       tests/warnings/check_table.py [--update] [--octave OCTAVE-CLI] [--only CLASS] [--every N]

Each class of cxx_core/base/warning.hpp has a scene in classes.py. It is solved through each way out, and
the text that wrc_case --json gives for the class has to be there. The table of docs/evidence/limits.md is what
was found (--update rewrites it); --every N solves every Nth class and compares its row. Without Octave its column is that of the page, and this says so.
"""
import argparse
import csv
import html
import json
import os
import re
import subprocess
import sys
import tempfile
import warnings
from pathlib import Path

import wrcontact

from classes import CASES, scene_of

PROJECT = Path(__file__).resolve().parents[2]
PAGE = PROJECT / "docs/evidence/limits.md"
BIN = Path(os.environ["WRCONTACT_BUILD"]) / "bin"
BEGIN, END = "<!-- table of warnings -->", "<!-- end -->"
GRADES = ["fine", "a little over", "do not use"]
LEADS = ["Note", "A little over", "Do not use"]
NOTES = [" with notes", " a little over the accuracy", ": do not use"]
WAYS = ["wrc_profile", "wrc_case", "--json", "--csv", "--plot", "wrc_sweep", "CSV", "NetCDF", "picture",
        "--page", "C", "Fortran", "F77", "Python", "study", "Octave"]


def class_names():
    text = (PROJECT / "cxx_core/base/warning.hpp").read_text(encoding="utf-8")
    names = re.search(r"warning_class_names\{(.*?)\}", text, re.S).group(1)
    return re.findall(r'"(\w+)"', names)


def run(*command, folder, codes=(0, 3)):
    done = subprocess.run([str(word) for word in command], cwd=folder, capture_output=True, text=True)
    if done.returncode not in codes:
        sys.exit(f"{' '.join(map(str, command))}\nended with {done.returncode}: {done.stderr}")
    return done


def toml(value):
    return json.dumps(value)


def assignments(keys):
    return [f"{key}={value if isinstance(value, str) else json.dumps(value, separators=(',', ':'))}"
            for key, value in keys.items()]


def scene_lines(name, keys):
    """For the programs in C, Fortran and Octave."""
    lines = [f"scene {name}"]
    for key, value in keys.items():
        if isinstance(value, list):
            lines.append(f"list {key} {' '.join(map(repr, value))}")
        else:
            lines.append(f"{'text' if isinstance(value, str) else 'number'} {key} {value}")
    return lines + ["solve"]


def squeezed(text):
    """Without blanks, which pictures break lines at."""
    return re.sub(r"\s+", "", text)


def by_scene(output):
    found = {}
    for line in output.splitlines():
        name, _, text = line.partition("\t")
        found.setdefault(name, set()).add(text)
    return found


def from_case(name, keys, folder):
    """The text of the class in wrc_case --json, and in which of its other outputs it stands."""
    case = [BIN / "wrc_case", "--set", *assignments(keys)]
    data = json.loads(run(*case, "--json", folder=folder).stdout)
    texts = [text for text, kind in zip(data["warnings"], data["warning_classes"]) if kind == name]
    if not texts or CASES[name].words not in texts[0]:
        sys.exit(f"{name}: its scene has no such warning, but {data['warnings']}")
    text, found = texts[0], {"--json"}
    if data["warning_count"] != len(data["warnings"]):
        sys.exit(f"{name}: warning_count is {data['warning_count']} for {len(data['warnings'])} texts")
    side = re.match("(left|right): ", text)
    of_wheel = text[side.end():] if side else text
    printed = run(*case, "--plot", "case.svg", folder=folder).stdout.splitlines()
    grades = data["warning_grades"]
    if data["grade"] != max(map(GRADES.index, grades)) or len(grades) != len(data["warnings"]):
        sys.exit(f"{name}: the grade is {data['grade']}, those of its warnings {grades}")
    grade = grades[data["warnings"].index(text)]
    if f"{LEADS[GRADES.index(grade)]}: {text}" in printed:
        found.add("wrc_case")
    if any(line.startswith("Corrected") and of_wheel in line for line in printed):
        sys.exit(f"{name}: a warning is told as a correction")
    rows = list(csv.DictReader(run(*case, "--csv", folder=folder).stdout.splitlines()))
    if any(of_wheel in row["warnings"].split(" | ") for row in rows):
        found.add("--csv")
    picture = html.unescape(re.sub("<[^>]*>", "", (folder / "case.svg").read_text(encoding="utf-8")))
    if squeezed(text[:80]).replace("'", "’") in squeezed(picture):  # as gnuplot draws it, cut
        found.add("--plot")
    if "wheelset.wheel" in keys and name.startswith("profile_") and not side:
        printed = run(BIN / "wrc_profile", keys["wheelset.wheel"], folder=folder).stdout
        body = text.partition(": ")[2]
        if re.search(rf"^  warning +{re.escape(body)}$", printed, re.M):
            found.add("wrc_profile")
    elif not name.startswith("profile_") or side:
        found.add("wrc_profile")  # has none of these to tell
    return text, found


def from_study(name, keys, text, folder):
    """In which outputs of wrc_sweep the text stands."""
    keys = {"pose.lateral": 0.0, **keys}
    lines = [f"{key} = {toml([value] if key == 'pose.lateral' else value)}"
             for key, value in keys.items()]
    lines += ['[study]', 'results = ["left.pmax"]', '[[picture]]', 'kind = "lines"',
              'file = "s.svg"', 'x = "pose.lateral"',
              'panels = [{y_label = "pmax", lines = [{result = "left.pmax", title = "left"}]}]']
    (folder / "s.toml").write_text("\n".join(lines) + "\n", encoding="utf-8")
    done = run(BIN / "wrc_sweep", "s.toml", "--out", "study", "--quiet", folder=folder)
    found = set()
    if any(line.endswith(f": 1 scene: {text}") for line in done.stderr.splitlines()) and "1 of 1 scene" in done.stderr:
        found.add("wrc_sweep")
    row = next(csv.DictReader((folder / "study/s.csv").read_text(encoding="utf-8").splitlines()))
    told = row["warnings"].split(" | ")
    grade = int(row["grade"])
    if text in told and int(row["warning_count"]) == len(told):
        found.add("CSV")
    texts = run(BIN / "netcdf_texts", "study/s.nc", "warnings", folder=folder).stdout
    if text in texts.rstrip("\n").split(" | "):
        found.add("NetCDF")
    picture = re.sub("<[^>]*>", "", (folder / "study/s.svg").read_text(encoding="utf-8"))
    if f"1 of 1 scene{NOTES[grade]}" in picture:
        found.add("picture")
    run(BIN / "wrc_sweep", "s.toml", "--page", "s.html", "--quiet", folder=folder)
    page = (folder / "s.html").read_text(encoding="utf-8")
    data = json.loads(re.search(r"^const data = (.*);$", page, re.M).group(1))
    if text in data["scenes"][0]["warnings"] and "warningsOf(scene)" in page:
        found.add("--page")
    return found


def from_python(keys, text):
    found = set()
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        scene = wrcontact.Scene()
        for key, value in keys.items():
            scene[key] = value
        try:
            result = scene.solve()
        except wrcontact.NotConverged as error:
            result = error.result
    told = [str(one.message).removeprefix("a little over: ") for one in caught
            if issubclass(one.category, wrcontact.ContactWarning)]
    if text in told and Path(caught[0].filename).name == "check_table.py":
        found.add("Python")
    keys = {"pose.lateral": 0.0, **keys}
    lateral = keys.pop("pose.lateral")
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        data = wrcontact.study({"lateral": [lateral]}, ["left.pmax"], **keys)
    if text in str(data["warnings"].values[0]).split(" | ") and int(data["warning_count"][0]) > 0 and \
            f"1 of 1 scenes: {text}" in [str(one.message).removeprefix("a little over: ")
                                         for one in caught]:
        found.add("study")
    return found


def from_octave(octave, input_file, folder):
    done = run(octave, "--no-init-file", "--no-history", "--path", BIN.parent / "octave",
               Path(__file__).parent / "warnings_octave.m", input_file, folder=folder)
    found, name = {}, None
    for line in done.stderr.splitlines():
        if line.startswith("scene "):
            name = line.split()[1]
        elif line.startswith("warning: "):
            found.setdefault(name, set()).add(line.removeprefix("warning: wrc_mex: "))
    return found


def table_of(cells):
    lines = ["| class | " + " | ".join(f"`{way}`" if way[0] in "w-" else way for way in WAYS) + " |",
             "|---" * (len(WAYS) + 1) + "|"]
    for name, found in cells.items():
        marks = ["-" if way == "wrc_profile" and not name.startswith("profile_") else
                 "yes" if way in found else "**no**" for way in WAYS]
        if name == "profile_end":
            marks[0] = "-"
        lines.append(f"| `{name}` | " + " | ".join(marks) + " |")
    return "\n".join(lines) + "\n"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--update", action="store_true")
    parser.add_argument("--octave")
    parser.add_argument("--only")
    parser.add_argument("--every", type=int, default=1)
    arguments = parser.parse_args()
    names = class_names()
    if set(names) != set(CASES):
        sys.exit(f"classes without a scene in classes.py, or scenes without a class: "
                 f"{sorted(set(names) ^ set(CASES))}")
    names = [arguments.only] if arguments.only else names[::arguments.every]
    page = PAGE.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as temporary:
        folder = Path(temporary)
        scenes = {name: scene_of(name, folder) for name in names}
        inputs = folder / "scenes.txt"
        inputs.write_text("\n".join(line for name in names
                                    for line in scene_lines(name, scenes[name])) + "\n")
        outputs = {way: by_scene(run(BIN / program, inputs, folder=folder).stdout) for way, program in
                   (("C", "warnings_c"), ("Fortran", "warnings_module"), ("F77", "warnings_f77"))}
        if arguments.octave:
            outputs["Octave"] = from_octave(arguments.octave, inputs, folder)
        cells = {}
        for name in names:
            text, cells[name] = from_case(name, scenes[name], folder)
            cells[name] |= from_study(name, scenes[name], text, folder)
            cells[name] |= from_python(scenes[name], text)
            cells[name] |= {way for way, found in outputs.items() if text in found.get(name, ())}
            if not arguments.octave:
                row = re.search(rf"^\| `{name}` \|.*\| (\S+) \|$", page.partition(BEGIN)[2], re.M)
                cells[name] |= {"Octave"} if row and row.group(1) == "yes" else set()
    if not arguments.octave:
        print("Skipped: built without Octave: its column of the table of warnings is not compared")
    table = table_of(cells)
    missing = [f"{name}: not by {way}" for name, found in cells.items() for way in WAYS
               if way not in found]
    if arguments.only:
        print(table)
    elif arguments.update:
        head, rest = page.split(BEGIN)
        page = head + BEGIN + "\n" + table + END + rest.partition(END)[2]
        PAGE.write_text(page, encoding="utf-8")
    elif arguments.every > 1:
        missing += [f"docs/evidence/limits.md: another row: {row}" for row in table.splitlines()
                    if row not in page]
    elif page.partition(BEGIN)[2].partition(END)[0].strip() != table.strip():
        missing.append("docs/evidence/limits.md: the table is another; --update rewrites it")
    if missing:
        sys.exit("\n".join(missing))
    print(f"{len(names)} classes by {len(WAYS)} ways out")


main()
