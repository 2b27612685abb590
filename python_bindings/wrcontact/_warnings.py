"""Warnings of solutions, given to Python's own warnings."""
from __future__ import annotations

import os
import re
import sys
import warnings
from collections.abc import Iterable, Sequence
from types import FrameType
from typing import Any

from ._interface import ffi
from ._library import lib, string
from .errors import AccuracyNote, ContactWarning

_HERE = os.path.dirname(__file__)
_NUMBER = re.compile(r"(?<![^ (),;:])[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(?![^ (),;:])")
_MOST_KINDS = 20
GRADES = ("fine", "a little over", "do not use")
_LEADS = ("Note: ", "A little over: ", "Do not use: ")
_OVER = GRADES.index("a little over")

Graded = tuple[int, str]  # a warning: its grade, an index of GRADES, and its text


def warnings_of(handle: Any) -> list[str]:
    """All warnings of a solved scene, of its profiles, then of the left and the right wheel."""
    found: list[str] = []
    while text := lib.wrc_scene_warning(handle, len(found)):
        found.append(string(text))
    return found


def graded_warnings_of(handle: Any) -> list[Graded]:
    """All warnings of a solved scene with their grades."""
    graded: list[Graded] = []
    for index, text in enumerate(warnings_of(handle)):
        name = ffi.new("const char **")
        lib.wrc_scene_text(handle, f"warning_grades.{index}".encode(), name)
        graded.append((GRADES.index(string(name[0])), text))
    return graded


def worst_of(graded: Iterable[Graded]) -> int:
    """The worst grade."""
    return max((grade for grade, _ in graded), default=0)


def lines_of(graded: Sequence[Graded]) -> list[str]:
    """Lines to be read, as the programs print them: those a little over the accuracy once, unless others are not to be used."""
    over = [number for number, (grade, _) in enumerate(graded) if grade == _OVER]
    left_out = over[1:] if worst_of(graded) == _OVER else []
    return [_LEADS[grade] + " ".join(text.splitlines()) for number, (grade, text) in enumerate(graded) if number not in left_out]


def warn(graded: Sequence[Graded]) -> None:
    """Warns of each distinct text, at the line outside this package that called it.

    What is a little over the accuracy is one AccuracyNote, with the first text.
    """
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and _is_ours(frame):
        frame, level = frame.f_back, level + 1
    over = [text for grade, text in graded if grade == _OVER]
    for text in dict.fromkeys(text for grade, text in graded if grade != _OVER):
        warnings.warn(text, ContactWarning, stacklevel=level)
    if over:
        warnings.warn(f"a little over: {over[0]}", AccuracyNote, stacklevel=level)


def _is_ours(frame: FrameType) -> bool:
    return os.path.dirname(frame.f_code.co_filename) == _HERE


def warn_of_many(graded: Sequence[Sequence[Graded]]) -> None:
    """Warns of the warnings of many scenes: each kind once, by its first text, with its scenes.

    Warnings of a grade that differ only in their numbers are of one kind.
    """
    kinds: dict[Graded, list[Any]] = {}
    for of_scene in graded:
        for kind, text in {(grade, _NUMBER.sub("#", text) if grade != _OVER else ""): text
                           for grade, text in reversed(of_scene)}.items():
            kinds.setdefault(kind, [0, text])[0] += 1
    ordered = sorted(kinds.items(), key=lambda kind: (-kind[0][0], -int(kind[1][0])))
    lines = [(grade, f"{count} of {len(graded)} scenes: {text}")
             for (grade, _), (count, text) in ordered[:_MOST_KINDS]]
    if len(ordered) > _MOST_KINDS:
        lines.append((0, f"{len(ordered) - _MOST_KINDS} more kinds of warnings"))
    warn(lines)
