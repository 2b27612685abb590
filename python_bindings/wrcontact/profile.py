"""Profiles of wheels and rails."""
from __future__ import annotations

import hashlib
import os
import weakref
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._handle import Handle, encoded
from ._interface import ffi
from ._library import Array, doubles, lib, pointer, string
from .errors import InvalidArgument
from .measures import Comparison, Dimensions, comparison_of, dimensions_of

if TYPE_CHECKING:
    from .conicity import Conicity

_KINDS = {"wheel": lib.WRC_WHEEL, "rail": lib.WRC_RAIL}
_ORIGINS = {"auto": 0, "tape": lib.WRC_ORIGIN_TAPE, "flange-back": lib.WRC_ORIGIN_FLANGE_BACK}
_SMOOTHINGS = {"none": -1, "auto": -2}  # WRC_SMOOTHING_NONE, WRC_SMOOTHING_AUTO
_TAPE_OFFSET = 70.0  # mm, flange back to taping line
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


def files_of(*profiles: Profile) -> list[str]:
    """What was read for them."""
    return [os.fsdecode(name) for made, arguments, options in (profile._made for profile in profiles)
            for name in (*(arguments if made == Profile.from_file else ()), options.get("align_to")) if name]


def refuse_overwriting(path: str | os.PathLike[str], files: Sequence[str]) -> None:
    """InvalidArgument if a file to be written is one of those that are read."""
    for file in files:
        if os.path.exists(path) and os.path.exists(file) and os.path.samefile(path, file):
            raise InvalidArgument(f"path is {os.fspath(path)}, which is read as {file}; must be another file")


def _made_by(function: Any, arguments: tuple[Any, ...], options: dict[str, Any]) -> Profile:
    made: Profile = function(*arguments, **options)
    return made


class Profile(Handle):
    """A wheel or rail: built in (`Profile("60E1")`) or from a file (`Profile("worn.prr")`).

    >>> wheel = Profile.from_file("worn.prw").align("S1002")
    >>> wheel.dimensions["flange_height"]            # mm
    >>> wheel.compare(Profile("S1002")).largest      # mm
    >>> wheel.conicity(Profile("60E1")).value        # at an amplitude of 3 mm

    Files are columns, Simpack .prr/.prw, MiniProf .ban/.whl and slices .slcs/.slcw. Options, as in
    wrc_read_options of wrcontact.h: kind ("wheel", "rail"), mirror_lateral and mirror_height (-1, 0,
    1), strict, scale (mm per unit of the file), smoothing_wavelength (mm, 0: none; "auto": as the
    noise of the points needs), origin ("auto", "tape", "flange-back"), slice, tape_offset (mm),
    lateral_shift (mm), rotation (rad), align_to (a built-in name or file). Lateral is positive to
    the field side; heights of a wheel towards larger radius, of a rail upwards. UnknownName,
    FileUnreadable, FileMalformed.
    """

    _kind = "profile"
    _digest = "not known"  # SHA-256 of the file as it was read

    def __init__(self, name: str | os.PathLike[str], **options: Any) -> None:
        super().__init__()
        self._made: tuple[Any, ...] = (Profile, (os.fspath(name),), options)
        if options or lib.wrc_profile_load_standard(self._handle, encoded(name)) != 0:
            self._made = (Profile.from_file, (os.fspath(name),), options)
            self._load(name, options)

    @classmethod
    def from_file(cls, path: str | os.PathLike[str], **options: Any) -> Profile:
        """A profile from a file, also if its name is that of a built-in one; options as above."""
        profile = cls.__new__(cls)
        Handle.__init__(profile)
        profile._made = (Profile.from_file, (os.fspath(path),), options)
        profile._load(path, options)
        return profile

    def _load(self, path: str | os.PathLike[str], options: dict[str, Any]) -> None:
        self._check(lib.wrc_profile_load_file(self._handle, encoded(path), _read_options(options)))
        if os.path.isfile(path):  # a pipe cannot be read again
            with open(path, "rb") as file:
                self._digest = hashlib.sha256(file.read()).hexdigest()

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

    @property
    def dimensions(self) -> Dimensions:
        """Dimensions by name: flange height, thickness, qR, conicity; or head widths, crown radius. mm.

        The flange back is at the `tape_offset` that the profile was read with, 70 mm if none was given.
        """
        return self._dimensions_of(self)

    def _dimensions_of(self, profile: Profile) -> Dimensions:
        """With the flange back of this one."""
        return dimensions_of(profile, self._made[2].get("tape_offset") or _TAPE_OFFSET)

    def compare(self, other: Profile | str) -> Comparison:
        """Normal distance to another profile, or a name of one, both in their own frame: `align` lays one on the other first.

        Dimensions of both are measured with the `tape_offset` of this one, as wrc_profile does.
        """
        beside = other if isinstance(other, Profile) else Profile(other)

        def differences() -> Dimensions:
            own, others = self.dimensions, self._dimensions_of(beside)
            own.update({name: value - others[name] for name, value in own.items()})
            return own

        return comparison_of(self, beside, differences)

    def conicity(self, rail: Profile | str, amplitudes: Sequence[float] | Array | None = None,
                 **keys: Any) -> Conicity:
        """Equivalent conicity of a wheelset with this wheel on a track with a rail, as EN 15302 has it.

        amplitudes: mm, 0.5 to 12 if not given. keys: of the scene, such as track_gauge=1437, inclination="1:20". Takes
        0.2 s; of measured profiles, whose noise makes it uncertain, some seconds.
        """
        from .conicity import conicity_of

        rail = rail if isinstance(rail, Profile) else Profile(rail)
        if (self.kind, rail.kind) != ("wheel", "rail"):
            raise InvalidArgument(f"{self.name} is a {self.kind}, {rail.name} a {rail.kind}; must be a wheel, and a rail")
        return conicity_of(self, rail, amplitudes, keys)

    def smooth(self, wavelength: float | str) -> Profile:
        """The points smoothed: waves of this length, mm, are halved; 0: not at all, "auto": as their noise needs."""
        return self._again(smoothing_wavelength=wavelength)

    def align(self, to: str | os.PathLike[str] | Profile) -> Profile:
        """The points laid on another profile, built in or of a file, where they are not worn."""
        if isinstance(to, Profile):
            if to._made[0] == Profile.from_points or to._made[2]:
                raise InvalidArgument(f"to is {to.name}, made from points or with options; must be a built-in name or "
                                      "a file: Profile.write makes one")
            to = to._made[1][0]
        return self._again(align_to=to)

    def _again(self, **options: Any) -> Profile:
        made, arguments, before = self._made
        if made == Profile:
            raise InvalidArgument(f"{self.name} is built in; only points of a file or of your own are smoothed and aligned")
        return _made_by(made, arguments, {**before, **options})

    def write(self, path: str | os.PathLike[str], spacing: float = 0.1) -> None:
        """Writes two columns, or .prr/.prw, of points `spacing` mm apart, to a file that it was not read from. FileUnreadable."""
        refuse_overwriting(path, files_of(self))
        self._check(lib.wrc_profile_write(self._handle, encoded(path), spacing))

    def plot(self, path: str | os.PathLike[str] | None = None, *, ax: Any = None) -> Any:
        """Draws the curve, on the axes `ax` if given; returns the Figure, saved to `path` if given."""
        from . import plot

        return plot.draw_profile(self, path, ax)

    def __repr__(self) -> str:
        return f"<wrcontact.Profile {self.name}: {self.kind}, {self.length:.1f} mm along the curve>"
