#!/usr/bin/env python3
"""Writes what editors and mypy know of keys and results, from the library and docs/results.md.

Usage: PYTHONPATH=build/release/python scripts/write_python_names.py [--check]

python_bindings/wrcontact/_names.pyi: the keywords of scenes, and the results as classes. _meanings.py beside it: a few
words for each result, for labels. --check changes nothing and fails if one of them is not up to date.
"""
import json
import re
import sys
import textwrap
import warnings
from pathlib import Path

import wrcontact
from wrcontact.result import is_count

PROJECT = Path(__file__).resolve().parent.parent
FOLDER = PROJECT / "python_bindings/wrcontact"
PAGE = PROJECT / "docs/results.md"
HEAD = "Written by scripts/write_python_names.py, not by hand."
# Scenes that together have all results.
SCENES = (
    {"lateral": 6.15, "rail": "56E1", "speed": 2e4, "motion_yaw": 0.01, "derivatives": True, "accuracy": 1e-2,
     "results": ["stress", "wear", "fatigue", "groove", "kalker"]},
    {"lateral": 5, "creepage_left": [1e-3, 5e-4, 2e-4], "accuracy": 1e-2},
    {"model": "hertz"},
    {"accuracy": 1e-2, "rail": wrcontact.Profile.from_points("rail", *wrcontact.Profile("60E1").at(
        [0.25 * step for step in range(500)])[:2])},
)
TEXTS = {"solver", "model", "model_reason", "units", "frame", "stop_reason", "steels"}
LISTS = {"patches": "Patch", "parts": "Patch", "near_contacts": "NearContact", "warnings": "str",
         "warning_classes": "str", "warning_grades": "str", "corrections": "str"}
PLACES = {"Wheelset": "", "Wheel": "left.", "Contact": "left.patches.N.", "Creep forces": "left.patches.N.",
          "Damage": "left.patches.N."}


def keywords():
    """Each keyword of a key with its kind."""
    for key in wrcontact.keys().values():
        parts = key.name.split(".")
        for left_out in range(len(parts)):
            word = "_".join(parts[left_out:])
            try:
                if wrcontact.key_of(word) == key.name:
                    yield word, kind_of(key)
            except wrcontact.UnknownName:
                pass


def kind_of(key):
    if "profile file" in key.allowed:
        return "P"
    if key.allowed.startswith("["):
        return "L"
    if key.unit:
        return "N"
    return "B" if '"yes"' in key.allowed else "W" if "a list of them" in key.allowed else "T"


def arguments(many, without=()):
    """All keywords; with `many` numbers and profiles may be arrays of them."""
    words = (f"{word}:_{kind}{'s' if many and kind in 'NP' else ''}_=_...," for word, kind in keywords()
             if word not in without)
    lines = textwrap.wrap(" ".join(words), 130, break_long_words=False, break_on_hyphens=False)
    return "".join(f"        {line}\n" for line in lines).replace(":_", ": ").replace("_=_", " = ").rstrip(",\n")


def tree_of(names):
    """Names as nested dicts, whose leaves are kinds."""
    tree = {}
    for name in sorted(names):
        *groups, last = re.sub(r"\.\d+(?=\.|$)", ".#", name).split(".")
        node = tree
        for group in groups:
            child = node.setdefault(group, {})
            node[group] = child if isinstance(child, dict) else {"": child}  # a number with derivatives
            node = node[group]
        kind = "str" if last in TEXTS or last == "#" else "int" if is_count(name) else "float"
        if isinstance(node.get(last), dict):
            node[last][""] = kind
        else:
            node[last] = kind
    return tree


def class_of(tree, name, found, fields=()):
    """The name of the class of a tree; classes that it needs stand before it, equal ones only once."""
    lines = []
    for child, node in tree.items():
        if child in ("", "#"):
            continue
        if child in LISTS and isinstance(node, dict) and "#" in node:
            entry = LISTS[child]
            if entry != "str":
                entry = "Patch" if child == "parts" else class_of(node["#"], entry, found, FIELDS if entry == "Patch" else ())
            kind = f"Sequence[{entry}]"
        elif isinstance(node, dict) and "" not in node:
            own = {"left": "Wheel", "right": "Wheel"}.get(child, name.replace("ResultNames", "") + child.title().replace("_", ""))
            kind = class_of(node, own, found, FIELDS + OUTLINES if own == "Wheel" else ())
        else:
            kind = node[""] if isinstance(node, dict) else node
        lines.append(f"    {child}: {kind}")
    lines += [f"    {field}: Array" for field in fields if not any(line.startswith(f"    {field}:") for line in lines)]
    for known, its_lines in found.items():
        if its_lines == lines and name != "ResultNames":
            return known
    found[name] = lines
    return name


def expanded(cell):
    """The names of a cell of the page: `a.x`, `.y` are a.x and a.y, `a_x`, `_y` are a_x and a_y."""
    names = []
    for word in re.findall(r"`([^`]+)`", cell):
        word = word.replace(" ...", "").replace("...", "").strip()
        if word.startswith("_"):
            word = names[-1].rpartition("_")[0] + word
        elif word.startswith(".") and names:
            word = names[-1].rpartition(".")[0] + word
        names.append(word)
    return names


def rows():
    """Heading, names and meaning of each row of the page."""
    heading = ""
    for line in PAGE.read_text(encoding="utf-8").splitlines():
        if line.startswith("## "):
            heading = line[3:]
        cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
        if len(cells) > 1 and cells[0].startswith("`"):
            yield heading, expanded(cells[0]), cells[1]


FIELDS = [name for heading, names, _ in rows() if heading == "Fields"
          for name in names if "." not in name]
OUTLINES = ["rail_y", "rail_z", "wheel_y", "wheel_z"]


def short(meaning):
    """The first clause, without links and marks."""
    meaning = re.sub(r"\[([^]]+)\]\([^)]*\)", r"\1", meaning).replace("`", "")
    return re.split(r"[;:.](?= |$)| \(|, (?=since|which|with|accurate|as )", meaning)[0].strip()


def stub():
    names = set()
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for values in SCENES:
            names.update(wrcontact.solve(**values)._names)
    names |= {"corrections.0", "warnings.0", "warning_classes.0", "warning_grades.0", "left.warnings.0", "right.warnings.0"}
    names.add("left.patches.0.parts.0.x")
    names = {re.sub(r"^right\.", "left.", name) for name in names}
    tree, found = tree_of(names), {}
    del tree["warnings"]  # Result.warnings is a list
    tree["right"] = tree["left"]
    patch = tree["left"]["patches"]["#"]
    patch["parts"] = {"#": {}}  # patches as well
    class_of(tree, "ResultNames", found)
    text = f'''"""Keywords of scenes and names of results, for editors and mypy. {HEAD}"""
from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import Any, Protocol, TypeVar, Union, overload

import numpy as np
import xarray

from ._handle import Handle
from ._library import Array
from .profile import Profile
from .result import Group, Result

class _HasArray(Protocol):
    def __array__(self) -> Any: ...

_Self = TypeVar("_Self")
N = Union[float, "np.integer[Any]", "np.floating[Any]", str, None]  # a number, or its word
Ns = Union[N, Sequence[float], _HasArray]
L = Union[Sequence[float], _HasArray, str, None]  # a list of numbers
T = Union[str, None]
B = Union[bool, str, None]
W = Union[str, Sequence[str], None]
P = Union[str, "PathLike[str]", Profile, Mapping[str, Any]]
Ps = Union[P, Sequence[Union[str, Profile]], _HasArray]

class SceneKeywords(Handle):
    def __init__(self, *,
{arguments(False)}) -> None: ...
    def set(self: _Self, *,
{arguments(False)}) -> _Self: ...

@overload  # type: ignore  # without arguments both fit: the first one holds
def solve(*,
{arguments(False)}) -> Result: ...
@overload
def solve(*, outputs: Union[str, Sequence[str]] = ..., progress: Union[Callable[[float], object], None] = ...,
{arguments(True)}) -> xarray.Dataset: ...
def study(parameters: Mapping[str, Any], results: Union[str, Sequence[str]] = ..., *, threads: int = ..., separator: str = ...,
        progress: Union[Callable[[float], object], None] = ...,
{arguments(False, ("threads", "results"))}) -> xarray.Dataset: ...
'''
    for name, lines in found.items():
        base = "" if name == "ResultNames" else "(Group)"
        text += f"\nclass {name}{base}:\n" + "\n".join(lines) + "\n"
    return text


def meanings():
    text = f'"""What results are, in a few words, by name; N is a number. {HEAD}"""\n\nMEANINGS = {{\n'
    found = {}
    for heading, names, meaning in rows():
        if heading in PLACES:
            for name in names:
                whole = PLACES[heading] + re.sub(r"\.[NM]\b", ".N", name)
                if re.match("as above|likewise|the same|that of its", meaning) and heading != "Wheel":
                    found[whole.rstrip(".")] = found.get(whole.replace("patches.N.", ""), short(meaning))
                else:
                    found[whole.rstrip(".")] = short(meaning)
    return text + "".join(f"    {json.dumps(name)}: {json.dumps(meaning, ensure_ascii=False)},\n"
                          for name, meaning in found.items()) + "}\n"


def main(arguments):
    outdated = []
    for path, text in ((FOLDER / "_names.pyi", stub()), (FOLDER / "_meanings.py", meanings())):
        if not path.exists() or path.read_text(encoding="utf-8") != text:
            outdated.append(path.name)
            if arguments != ["--check"]:
                path.write_text(text, encoding="utf-8")
    if arguments == ["--check"] and outdated:
        print(f"not up to date: {', '.join(outdated)}; scripts/write_python_names.py writes them")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
