"""Profiles of wheels and rails."""
from __future__ import annotations

import os
import weakref
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._handle import Handle, encoded
from ._interface import ffi
from ._library import Array, doubles, lib, pointer, string
from .errors import InvalidArgument

_KINDS = {"wheel": lib.WRC_WHEEL, "rail": lib.WRC_RAIL}
_ORIGINS = {"auto": 0, "tape": lib.WRC_ORIGIN_TAPE, "flange-back": lib.WRC_ORIGIN_FLANGE_BACK}
_SMOOTHINGS = {"none": -1, "auto": -2}  # WRC_SMOOTHING_NONE, WRC_SMOOTHING_AUTO
_kept_alive: weakref.WeakKeyDictionary[Any, Any] = weakref.WeakKeyDictionary()  # texts of structs


class ProfilePoint(NamedTuple):
    """Arrays of the shape of the arc lengths: mm, rad, 1/mm (wrc_profile_at)."""

    lateral: Array
    height: Array
    angle: Array
    curvature: Array


def standard_profiles(kind: str) -> list[str]:
    """Names of the built-in profiles of a kind, "wheel" or "rail"."""
    names: list[str] = []
    while name := lib.wrc_profile_standard_name(_number_of(kind, _KINDS, "kind"), len(names)):
        names.append(string(name))
    return names


def _number_of(word: str, words: dict[str, int], argument: str) -> int:
    if word not in words:
        raise InvalidArgument(f"{argument} is {word!r}; must be one of {', '.join(words)}")
    return words[word]


def _read_options(options: dict[str, Any]) -> Any:
    """The struct of wrcontact.h, from arguments with the names of its members."""
    members = {name for name, _ in ffi.typeof("wrc_read_options").fields}
    members -= {"struct_size", "kind_given", "rotation_given", "reserved", "reserved_2"}
    struct = ffi.new("wrc_read_options *")
    struct.struct_size = ffi.sizeof("wrc_read_options")
    for name, value in options.items():
        if name not in members:
            raise TypeError(f"{name}: no such option; must be one of {', '.join(sorted(members))}")
        if name == "kind":
            value, struct.kind_given = _number_of(value, _KINDS, name), 1
        elif name == "origin":
            value = _number_of(value, _ORIGINS, name)
        elif name == "smoothing_wavelength" and (isinstance(value, str) or value == 0):
            value = _number_of(value or "none", _SMOOTHINGS, name)
        elif name == "rotation":
            struct.rotation_given = 1
        elif name == "align_to":
            value = _kept_alive[struct] = ffi.new("char[]", encoded(value))
        setattr(struct, name, value)
    return struct


def _made_by(function: Any, arguments: tuple[Any, ...], options: dict[str, Any]) -> Profile:
    made: Profile = function(*arguments, **options)
    return made


class Profile(Handle):
    """A wheel or rail: built in (`Profile("60E1")`) or from a file (`Profile("worn.prr")`).

    Files are columns, Simpack .prr/.prw, MiniProf .ban/.whl and slices .slcs/.slcw. Options, as in
    wrc_read_options of wrcontact.h: kind ("wheel", "rail"), mirror_lateral and mirror_height (-1, 0,
    1), strict, scale (mm per unit of the file), smoothing_wavelength (mm, 0: none; "auto": as the
    noise of the points needs), origin ("auto", "tape", "flange-back"), slice, tape_offset (mm),
    lateral_shift (mm), rotation (rad), align_to (a built-in name or file). Lateral is positive to
    the field side; heights of a wheel towards larger radius, of a rail upwards. UnknownName,
    FileUnreadable, FileMalformed.
    """

    _kind = "profile"

    def __init__(self, name: str | os.PathLike[str], **options: Any) -> None:
        super().__init__()
        self._made: tuple[Any, ...] = (Profile, (os.fspath(name),), options)
        if options or lib.wrc_profile_load_standard(self._handle, encoded(name)) != 0:
            self._check(lib.wrc_profile_load_file(self._handle, encoded(name),
                                                  _read_options(options)))

    @classmethod
    def from_points(cls, kind: str, lateral: ArrayLike, height: ArrayLike, *, name: str = "points",
                    **options: Any) -> Profile:
        """A profile through points, mm, in either order; options as above. InvalidArgument."""
        profile = cls.__new__(cls)
        Handle.__init__(profile)
        y, z = doubles(lateral), doubles(height)
        profile._made = (Profile.from_points, (kind, y.copy(), z.copy()), {"name": name, **options})
        if y.shape != z.shape or y.ndim != 1:
            raise InvalidArgument(f"lateral has shape {y.shape}, height {z.shape}; must be two "
                                  "lists of the same length")
        profile._check(lib.wrc_profile_set_points(
            profile._handle, encoded(name), pointer(y), pointer(z), y.size,
            _read_options({**options, "kind": kind})))
        return profile

    def __reduce__(self) -> tuple[Any, ...]:
        """Pickled and copied as it was made; a file is read again, by its path."""
        return _made_by, self._made

    @property
    def kind(self) -> str:
        """"wheel" or "rail"."""
        number = ffi.new("int32_t *")
        self._check(lib.wrc_profile_kind(self._handle, number))
        return "wheel" if number[0] == lib.WRC_WHEEL else "rail"

    def _text(self, name: str) -> str:
        value = ffi.new("const char **")
        self._check(lib.wrc_profile_text(self._handle, encoded(name), value))
        return string(value[0])

    name = property(lambda self: self._text("name"), doc="What identifies it in messages.")
    title = property(lambda self: self._text("title"), doc="What it is.")
    source = property(lambda self: self._text("source"), doc="Where it comes from.")
    confidence = property(lambda self: self._text("confidence"), doc="How well it is known.")

    @property
    def corrections(self) -> list[str]:
        """Corrections made while reading, one line each."""
        return self._lines(lib.wrc_profile_correction)

    @property
    def warnings(self) -> list[str]:
        """What is doubtful about the profile, one line each."""
        return self._lines(lib.wrc_profile_warning)

    @property
    def length(self) -> float:
        """Arc length of the curve, mm."""
        value = ffi.new("double *")
        self._check(lib.wrc_profile_length(self._handle, value))
        return float(value[0])

    @property
    def nodes(self) -> Array:
        """Arc lengths of the curve's nodes, mm."""
        return self._copied(lib.wrc_profile_nodes)

    def points(self, which: str = "read") -> tuple[Array, Array]:
        """Lateral and height, mm, of points that were "read" or "dropped"; none if built in."""
        number = _number_of(which, {"read": lib.WRC_POINTS_READ,
                                    "dropped": lib.WRC_POINTS_DROPPED}, "which")
        count = ffi.new("int64_t *")
        self._check(lib.wrc_profile_points(self._handle, number, ffi.NULL, ffi.NULL, 0, count))
        lateral, height = np.empty((2, count[0]))
        if count[0]:
            self._check(lib.wrc_profile_points(self._handle, number, pointer(lateral),
                                               pointer(height), lateral.size, count))
        return lateral, height

    def at(self, arc: ArrayLike) -> ProfilePoint:
        """The curve at arc lengths, mm, clamped to the curve."""
        arcs = doubles(arc)
        values = np.empty((4, arcs.size))
        places = [ffi.cast("double *", ffi.from_buffer(row)) for row in values]
        for index, one in enumerate(arcs.ravel()):
            self._check(lib.wrc_profile_at(self._handle, one, *(place + index for place in places)))
        return ProfilePoint(*values.reshape(4, *np.shape(arc)))

    def write(self, path: str | os.PathLike[str], spacing: float = 0.1) -> None:
        """Writes two columns, or .prr/.prw, of points `spacing` mm apart. FileUnreadable."""
        self._check(lib.wrc_profile_write(self._handle, encoded(path), spacing))

    def plot(self, path: str | os.PathLike[str] | None = None, *, ax: Any = None) -> Any:
        """Draws the curve, on the axes `ax` if given; returns the Figure, saved to `path` if given."""
        from . import plot

        return plot.draw_profile(self, path, ax)

    def __repr__(self) -> str:
        return f"<wrcontact.Profile {self.name}: {self.kind}, {self.length:.1f} mm along the curve>"
