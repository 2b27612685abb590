"""Handles of the library as Python objects."""
from __future__ import annotations

import os
from typing import Any

import numpy as np

from ._interface import ffi
from ._library import Array, lib, pointer, string
from .errors import InvalidArgument, error_of


def encoded(text: str | os.PathLike[str]) -> bytes:
    """A text for the library. It must not contain a zero byte, where the library would end it."""
    code = os.fspath(text).encode("utf-8", "surrogateescape")
    if b"\0" in code:
        raise InvalidArgument(f"{text!r} has a zero byte; it must have none")
    return code


class Handle:
    """A handle of the library, destroyed with the object. `_kind` is its name in wrcontact.h."""

    _kind = ""
    _instead = "make another one where it is needed"

    def __init__(self) -> None:
        place = ffi.new(f"wrc_{self._kind} **")
        interface = "_0_4" if self._kind == "scene" else ""  # wrcontact.h
        status = getattr(lib, f"wrc_{self._kind}_create{interface}")(place)
        if status != 0:
            raise error_of(status)
        self._handle = ffi.gc(place[0], getattr(lib, f"wrc_{self._kind}_destroy"))
        self._error = getattr(lib, f"wrc_{self._kind}_error")

    def __reduce__(self) -> tuple[Any, ...]:
        """Not pickled, and copied by copy.copy only where a class says how: a copy would be an alias."""
        raise TypeError(f"a wrcontact.{type(self).__name__} cannot be copied or pickled: it holds a handle of the "
                        f"library; {self._instead}")

    def _check(self, status: int) -> None:
        if status != 0:
            raise error_of(status, string(self._error(self._handle)))

    def _copied(self, function: Any, *arguments: Any) -> Array:
        """Values that a function copies as wrc_scene_field does: first their number, then the values."""
        count = ffi.new("int64_t *")
        self._check(function(self._handle, *arguments, ffi.NULL, 0, count))
        values = np.empty(count[0])
        if values.size:
            self._check(function(self._handle, *arguments, pointer(values), values.size, count))
        return values

    def _lines(self, function: Any) -> list[str]:
        """Lines that a function returns one by one, until NULL."""
        lines: list[str] = []
        while line := function(self._handle, len(lines)):
            lines.append(string(line))
        return lines
