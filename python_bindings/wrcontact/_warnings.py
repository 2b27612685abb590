"""Warnings of solutions, given to Python's own warnings."""
from __future__ import annotations

import os
import re
import sys
import warnings
from collections.abc import Iterable, Sequence
from types import FrameType
from typing import Any

from ._library import lib, string
from .errors import ContactWarning

_HERE = os.path.dirname(__file__)
_NUMBER = re.compile(r"(?<![^ (),;:])[+-]?(\d+\.?\d*|\.\d+)([eE][+-]?\d+)?(?![^ (),;:])")
_MOST_KINDS = 20


def warnings_of(handle: Any) -> list[str]:
    """All warnings of a solved scene, of its profiles, then of the left and the right wheel."""
    found: list[str] = []
    while text := lib.wrc_scene_warning(handle, len(found)):
        found.append(string(text))
    return found


def warn(texts: Iterable[str]) -> None:
    """Warns of each distinct text, at the line outside this package that called it."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and _is_ours(frame):
        frame, level = frame.f_back, level + 1
    for text in dict.fromkeys(texts):
        warnings.warn(text, ContactWarning, stacklevel=level)


def _is_ours(frame: FrameType) -> bool:
    return os.path.dirname(frame.f_code.co_filename) == _HERE


def warn_of_many(texts: Sequence[Sequence[str]]) -> None:
    """Warns of the warnings of many scenes: each kind once, by its first text, with its scenes.

    Warnings that differ only in their numbers are of one kind.
    """
    kinds: dict[str, list[Any]] = {}
    for of_scene in texts:
        for kind, text in {_NUMBER.sub("#", text): text for text in reversed(of_scene)}.items():
            kinds.setdefault(kind, [0, text])[0] += 1
    ordered = sorted(kinds.values(), key=lambda kind: -int(kind[0]))
    lines = [f"{count} of {len(texts)} scenes: {text}" for count, text in ordered[:_MOST_KINDS]]
    if len(ordered) > _MOST_KINDS:
        lines.append(f"{len(ordered) - _MOST_KINDS} more kinds of warnings")
    warn(lines)
