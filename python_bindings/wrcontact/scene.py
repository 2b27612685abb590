"""Scenes: inputs, by keys."""
from __future__ import annotations

import inspect
import os
import re
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from functools import lru_cache
from html import escape
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._handle import Handle, encoded
from ._interface import ffi
from ._library import Array, doubles, lib, pointer, refuse_masked, string
from ._warnings import graded_warnings_of, warn
from .errors import InvalidArgument, NoResult, UnknownName, error_of
from .profile import Profile
from .result import Result

if TYPE_CHECKING:
    from ._names import SceneKeywords, solve as solve
else:
    SceneKeywords = Handle

_WITH_RESULT = (0, lib.WRC_NOT_CONVERGED)


class Key(NamedTuple):
    """A key of a scene: its name, default, permitted values with their unit, and meaning."""

    name: str
    default: str
    allowed: str
    meaning: str
    unit: str  #: of the number that it holds, in mm, N, MPa, rad: "N mm", or "1"; empty for texts and lists


@lru_cache(maxsize=None)
def keys() -> Mapping[str, Key]:
    """All keys of a scene by name, in the order of a scene file; the list is the library's."""
    found = {}
    scene = Scene()
    texts = ffi.new("const char *[5]")
    for index in range(lib.wrc_scene_key_count()):
        lib.wrc_scene_key(index, texts, texts + 1, texts + 2, texts + 3)
        scene._check(lib.wrc_scene_key_unit(scene._handle, texts[0], texts + 4))
        key = Key(*(string(text) for text in texts))
        found[key.name] = key
    return found


@lru_cache(maxsize=1024)
def key_of(word: str) -> str:
    """The key that a keyword argument stands for.

    It is the key with `_` for each point, `track_rail` for "track.rail". Groups may be left out from
    the left: `rail`. Of several keys that end so, it is the one with fewest groups left out, and of
    those the one of the pose (`lateral` is "pose.lateral"); otherwise the keyword is refused. What
    is no keyword of a key goes to the library as it is. Case does not matter. UnknownName.
    """
    lower = word.lower()
    if lower in keys():
        return lower
    endings: dict[int, list[str]] = {}
    for name in keys():
        parts = name.split(".")
        for left_out in range(len(parts)):
            if "_".join(parts[left_out:]) == lower:
                endings.setdefault(left_out, []).append(name)
    if not endings:
        return word
    candidates = endings[min(endings)]
    posed = [name for name in candidates if name.startswith("pose.")]
    if len(candidates) > 1 and not posed:
        choices = " or ".join(name.replace(".", "_") for name in candidates)
        raise UnknownName(f"{word} may be {choices}; write one of these")
    return (posed or candidates)[0]


def refuse_doubled(words: Iterable[str]) -> None:
    """InvalidArgument if two words are the same key: `lateral` and `pose_lateral`."""
    found: dict[str, str] = {}
    for word in words:
        key = key_of(word)
        if key in found:
            raise InvalidArgument(f"{key} is given twice, as {found[key]} and as {word}")
        found[key] = word


_OPTIONS = {"smoothing", "smoothing_along", "origin", "shift", "rotation", "align_to"}


def _rank(key: str) -> int:
    """Conventions hold for the keys behind them, and a profile comes before its options."""
    return 0 if key.startswith("convention.") else 2 if key.rpartition(".")[2].lower() in _OPTIONS else 1


def ranked(values: Mapping[str, Any]) -> dict[str, Any]:
    """The values by key in the order in which they are set; InvalidArgument if two words are the same key."""
    refuse_doubled(values)
    named = [(key_of(word), value) for word, value in values.items()]
    return dict(sorted(named, key=lambda pair: _rank(pair[0])))


class Scene(SceneKeywords):
    """Both wheels of a wheelset on their rails: inputs by key, solved by `solve`.

    >>> scene = Scene(lateral=3, rail="60E1")     # the rest as in the paper's Table 1
    >>> scene["pose.yaw"] = 0.01
    >>> scene.solve().left.pmax                   # MPa

    Keyword arguments are keys (see `key_of`; `wrcontact.keys()` lists them with defaults, ranges and
    units). Values are numbers, texts, lists, `True` and `False` for "yes" and "no", `None` for
    "none", and a Profile for a wheel or rail, or a dict of its file and options, as in
    `rail={"file": "worn.txt", "smoothing": 5}`, which is "worn.txt; smoothing = 5". Each option is
    also a key behind that of the profile, `scene["track.rail.smoothing"]`. mm, N, MPa, rad;
    x forward, y to the left, z up; the keys of `convention` change that, and are set first
    wherever they stand.

    A scene serves one thread at a time (Busy); different scenes are independent.
    """

    _kind = "scene"

    if not TYPE_CHECKING:  # _names.pyi lists the keywords
        def __init__(self, **values: Any) -> None:
            Handle.__init__(self)
            self._solutions = 0
            # What has been set, in this order, so that a copy is set to the same bits.
            self._given: dict[tuple[str, int], Any] = {}
            self.set(**values)

        def set(self, **values: Any) -> Scene:
            """Sets keys in the order given, those of `convention` first, options of profiles last; returns the scene.

            If one is refused, those before it stay set; a key named twice is refused before any is set.
            UnknownName, InvalidArgument.
            """
            for key, value in ranked(values).items():
                self[key] = value
            return self

    _solutions: int
    _given: dict[tuple[str, int], Any]

    def __reduce__(self) -> tuple[Any, ...]:
        """A scene is pickled and copied by the values of its keys, without its result."""
        return _scene_of, ([(key, value) for (key, _), value in self._given.items()],)

    def _ipython_key_completions_(self) -> list[str]:
        return list(keys())

    def __setitem__(self, key: str, value: Any) -> None:
        key = key_of(key)
        code, given = encoded(key), value
        if isinstance(value, Mapping):
            for name in sorted(value, key=lambda name: str(name).lower() != "file"):  # its options are behind it
                self[f"{key}.{name}"] = value[name]
            return
        if isinstance(value, (float, int, str)):
            pass  # most values
        elif getattr(value, "ndim", None) == 0 and not isinstance(value, np.generic):
            refuse_masked(value)
            value = given = np.asarray(value)[()]  # an array of one value without a dimension
        elif varies(key, value):
            raise InvalidArgument(f"{key} has {np.size(value)} values and takes one; wrcontact.solve takes arrays, "
                                  "and wrcontact.study all combinations")
        if value is None or isinstance(value, (bool, np.bool_)):
            value = "none" if value is None else "yes" if value else "no"
        if isinstance(value, (int, float, np.number)):
            status = lib.wrc_scene_set_number(self._handle, code, value)
        elif isinstance(value, (str, os.PathLike)):
            status = lib.wrc_scene_set_text(self._handle, code, encoded(value))
        elif isinstance(value, Profile):
            status = lib.wrc_scene_set_profile(self._handle, code, value._handle)
        elif isinstance(value, Sequence) and value and all(isinstance(word, str) for word in value):
            status = lib.wrc_scene_set_text(self._handle, code, encoded(" ".join(value)))
        else:
            try:
                numbers = doubles(value)
            except InvalidArgument:
                raise
            except (TypeError, ValueError) as error:
                raise InvalidArgument(f"{key} is {value!r}; must be a number, a text or a list of numbers") from error
            status = lib.wrc_scene_set_numbers(self._handle, code, pointer(numbers), numbers.size)
            given = numbers.copy()
        self._check(status)
        # Values are read in the convention of their time, so every change of it counts, and so do options
        # of the profile set before.
        adds = isinstance(given, str) and given.lstrip().startswith(";")
        times = len(self._given) + 1 if adds or key.startswith("convention.") else 0
        self._given.pop((key, times), None)
        self._given[key, times] = given

    def __getitem__(self, key: str) -> str | float | Array:
        """The value of a key: a text if it is a word, otherwise a number or an array."""
        code = encoded(key_of(key))
        text, number = ffi.new("const char **"), ffi.new("double *")
        status = lib.wrc_scene_get_text(self._handle, code, text)
        if status == 0:
            return string(text[0])
        if status != lib.WRC_INVALID_ARGUMENT:  # which says that the value is no text
            self._check(status)
        if lib.wrc_scene_get_number(self._handle, code, number) == 0:
            return float(number[0])
        return self._copied(lib.wrc_scene_get_numbers, code)

    def __iter__(self) -> Iterator[str]:
        return iter(keys())

    def solve(self) -> Result:
        """Solves geometry, remesh and mechanics, and returns the result.

        NotConverged holds the result that was reached. After any other failure the last result
        stays. The key solve.until stops after one of the three. What is doubtful about profiles or
        solution is a ContactWarning, and in Result.warnings; an error estimate up to twice the
        accuracy is an AccuracyNote.
        """
        return self._solved(lib.wrc_solver_solve(_kept_solver(self._given), self._handle))

    def _solved(self, status: int, warns: bool = True) -> Result:
        if status not in _WITH_RESULT:
            self._check(status)
        self._solutions += 1
        if warns:
            warn(graded_warnings_of(self._handle))
        result = Result(self)
        if status != 0:
            error = error_of(status, string(self._error(self._handle)))
            error.result = result
            raise error
        return result

    @property
    def result(self) -> Result:
        """The result of the last solution. NoResult."""
        if not self._solutions:
            raise NoResult("the scene has not been solved yet")
        return Result(self)

    def write(self, path: str | os.PathLike[str]) -> None:
        """Writes the scene as a TOML file, which `wrc_case` replays. FileUnreadable."""
        self._check(lib.wrc_scene_write(self._handle, encoded(path)))

    def tabulate(self, values: Mapping[str, ArrayLike], results: Sequence[str], *, threads: int = 1,
                 path: str | os.PathLike[str] = "") -> Array:
        """Results over all combinations of values of keys, for programs that interpolate.

        Returns an array with an axis for each key, in their order, and a last one for the results;
        not-a-number without contact. `path`: a text file of columns as well. The scene and its
        result stay. UnknownName, InvalidArgument, FileUnreadable.
        """
        columns = [doubles(column).ravel() for column in values.values()]
        counts = np.array([column.size for column in columns], dtype=np.int64)
        table = np.empty((*counts[::-1], len(results)))
        names = [encoded(" ".join(words)) for words in (map(key_of, values), results)]
        everything = np.concatenate(columns) if columns else np.empty(0)
        self._check(lib.wrc_scene_tabulate(
            self._handle, names[0], pointer(everything), pointer(counts, "int64_t"), names[1],
            threads, encoded(path), pointer(table)))
        return table.transpose(*range(len(columns))[::-1], len(columns))

    def plot(self, path: str | os.PathLike[str] | None = None) -> Any:
        """Draws the last result, solved if there is none; as Result.plot."""
        return (Result(self) if self._solutions else self.solve()).plot(path)

    def _repr_html_(self) -> str:
        rows = "".join(f"<tr><td>{escape(key)}</td><td>{escape(value)}</td></tr>"
                       for key, value in self._differing().items())
        return f"<p>wrcontact.Scene, keys that differ from their defaults:</p><table>{rows}</table>"

    def _differing(self) -> dict[str, str]:
        """Keys that are not at their default, with their values."""
        own, plain = ({key: repr(value) for key, value in values_of(scene).items()}
                      for scene in (self, Scene()))
        differing = own.items() - plain.items()
        # What both sides have in common is not repeated for each.
        return {key: value for key, value in own.items() if (key, value) in differing
                and (re.sub(r"\.(left|right)\b", "", key), value) not in differing - {(key, value)}}

    def __repr__(self) -> str:
        shown = [f"{key}={value}" for key, value in self._differing().items()]
        return f"wrcontact.Scene({', '.join(shown)})"


def _scene_of(given: Sequence[tuple[str, Any]]) -> Scene:
    """A scene in which these keys have been set one after the other."""
    scene = Scene()
    for key, value in given:
        scene[key] = value
    return scene


def values_of(scene: Scene) -> dict[str, str | float | Array]:
    """All keys with their values, except those whose sides have different ones."""
    values = {}
    for key in keys():
        try:
            values[key] = scene[key]
        except InvalidArgument:  # the keys of the sides tell
            pass
    return values


class _Kept(threading.local):
    """Of each thread: a solver, which keeps surfaces from one scene to the next, and the files it has read."""

    solver: Any = None
    files: dict[str, tuple[int, ...]] = {}


_kept = _Kept()


def _kept_solver(given: Mapping[tuple[str, int], Any]) -> Any:
    """The handle of this thread's solver, cleared if one of the scene's files is not what it was."""
    if _kept.solver is None:
        place = ffi.new("wrc_solver **")
        status = lib.wrc_solver_create(place)
        if status != 0:
            raise error_of(status)
        _kept.solver, _kept.files = ffi.gc(place[0], lib.wrc_solver_destroy), {}
    for (key, _), value in given.items():
        if key.endswith(("wheel", "rail", "align_to")) and isinstance(value, (str, os.PathLike)):
            for word in re.split(r";|=", os.fspath(value)):  # a file, and that of the option align_to
                path = word.strip()
                try:
                    facts = os.stat(path)
                except (OSError, ValueError):
                    continue
                now = (facts.st_mtime_ns, facts.st_size, facts.st_ino)
                if _kept.files.setdefault(path, now) != now:
                    lib.wrc_solver_clear(_kept.solver)
                    _kept.files = {path: now}
    return _kept.solver


def varies(key: str, value: Any) -> bool:
    """Whether a value is many values for a key that takes one."""
    if key not in keys() or isinstance(value, (str, bytes, Mapping, Profile, os.PathLike)):
        return False
    try:
        if np.ndim(value) == 0:
            return False
    except ValueError:
        raise InvalidArgument(f"{key} is {value!r}; its lists must all have the same length") from None
    allowed = keys()[key].allowed
    return "list of them" not in allowed and not allowed.startswith("[")  # solve.results takes a list of words


#: What `solve` returns of arrays, unless its argument `outputs` names others.
USUAL_RESULTS = ("rolling_radius_difference", *(f"{side}.{name}" for side in ("left", "right") for name in (
    "pmax", "area", "vertical_force", "lateral_force", "rigid_contact.angle", "rigid_contact.rolling_radius",
    "patch_count", "error_estimate")))


if not TYPE_CHECKING:  # _names.pyi lists the keywords
    def solve(*, outputs: Sequence[str] | str | None = None, progress: Callable[[float], object] | None = None,
              **values: Any) -> Any:
        """Solves a scene with these keys: `wrcontact.solve(lateral=3, rail="60E1").left.pmax`.

        Numbers and profiles may be arrays: of NumPy and lists, which fit as NumPy broadcasts them, or of xarray and pandas
        by their dimensions. Then the result is an xarray Dataset (without xarray a dict of arrays) of `outputs`, names
        of numbers, as that of `study`, which combines all values with all:

        >>> data = wrcontact.solve(lateral=np.linspace(-5, 5, 101), outputs=["left.pmax"])
        >>> data["left.pmax"].plot()

        It uses all processors, or `threads` of them; results do not depend on the number. progress: called with the
        fraction that is done.
        """
        many = [word for word, value in values.items() if varies(key_of(word), value)]
        if many:
            from .study import solve_arrays

            return solve_arrays(many, USUAL_RESULTS if outputs is None else outputs, progress, values)
        scene = Scene(**values)
        if outputs is not None or progress is not None:
            raise InvalidArgument("outputs and progress are for arrays of values; of one scene all results can be read")
        return scene.solve()


def _signature_of_keys(*before: inspect.Parameter) -> inspect.Signature:
    """What editors and notebooks complete: all keys as keywords, with defaults and kinds of values."""
    def kind_of(key: Key) -> str:
        kinds = ["float"] if key.unit else []
        kinds += ["Sequence[float]"] if key.allowed.startswith("[") else []
        kinds += ["Profile"] if "profile file" in key.allowed else []
        kinds += ["str"] if '"' in key.allowed or "a text" in key.allowed else []
        return " | ".join(kinds)

    return inspect.Signature([*before, *(
        inspect.Parameter(key.name.replace(".", "_"), inspect.Parameter.KEYWORD_ONLY,
                          default=key.default, annotation=kind_of(key)) for key in keys().values()),
        inspect.Parameter("values", inspect.Parameter.VAR_KEYWORD)])


_self = inspect.Parameter("self", inspect.Parameter.POSITIONAL_OR_KEYWORD)
for _function, _before in ((Scene.__init__, (_self,)), (Scene.set, (_self,)), (solve, ())):
    setattr(_function, "__signature__", _signature_of_keys(*_before))
