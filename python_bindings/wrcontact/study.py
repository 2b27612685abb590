"""Studies: many scenes as an xarray Dataset."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import dropwhile
from typing import TYPE_CHECKING, Any, Union

import numpy as np

from ._handle import encoded
from ._interface import ffi
from ._library import lib, pointer, refuse_masked, string
from ._warnings import GRADES, Graded, warn_of_many, worst_of
from .errors import Error, InvalidArgument
from .profile import Profile
from .scene import Scene, key_of, keys, ranked, refuse_doubled, values_of
from .result import long_name_of, unit_of
from .solver import solve_without_warning, warnings_of_outcome

if TYPE_CHECKING:
    import xarray

    from ._names import study as study

Progress = Union[Callable[[float], object], None]

# Scenes that are solved in one call and hold their results at the same time.
_SCENES_AT_ONCE = 512
_SCENES_A_REPORT = 64  # of them between two reports of progress


def _study(parameters: Mapping[str, Any], results: Sequence[str] | str = ("left.pmax", "right.pmax"), *,
           threads: int = 1, separator: str = ".", progress: Progress = None, **values: Any) -> xarray.Dataset:
    """Solves every combination of the values of keys; results by name as an xarray Dataset.

    >>> data = study({"lateral": range(-6, 7), "rail": ["60E1", "56E1"]}, ["left.pmax"], threads=2)
    >>> data["left.pmax"].sel({"track.rail": "60E1"}).plot()

    parameters: values by key or keyword (key_of). Each has a dimension of its own, with the key as
    its name; ("case", values) puts it on the dimension "case" instead, shared with others of equal
    length, for scenes drawn at random. results: names of numbers (docs/results.md); not-a-number
    without contact. separator: what stands for the points in names of the Dataset; with "_" they are
    attributes: `data.left_pmax.sel(track_rail="60E1")`. progress: called with the fraction that is done. Further
    keywords are keys with one value; they are set behind those of `parameters`: `load_left` holds against values of
    "load.both". All in the units of `values`, mm, N, MPa, rad by default.

    Every variable has a `long_name`, and `units` if it is a number. The
    Dataset has besides `status` and `message` of each scene (0: solved; an exception's status and text),
    `grade` (0 fine, 1 a little over, 2 do not use), `warning_count` and `warnings` (texts, separated by " | "), and all keys that do not vary as
    attributes. A scene that fails or whose values are refused is not raised, unless the values of all are
    refused; each kind of warnings is a ContactWarning with the number of its scenes. Results do not depend on `threads`; each scene is solved by itself, as by
    Scene.solve.
    """
    import xarray

    refuse_doubled([*parameters, *values])
    arrays = {key_of(word): _column(key_of(word), column) for word, column in parameters.items()}
    grid = xarray.broadcast(*arrays.values()) if arrays else ()
    return _dataset(arrays, grid, results, threads, separator, progress, ranked({**parameters, **values}))


def solve_arrays(varied: Iterable[str], outputs: Sequence[str] | str, progress: Progress, values: Mapping[str, Any]) -> Any:
    """scene.solve of values of which those of `varied` are arrays."""
    given = ranked(values)
    columns = {key_of(word): values[word] for word in varied}
    count = int(given.pop("solve.threads", len(os.sched_getaffinity(0))))
    labelled = {key for key, value in columns.items() if hasattr(value, "to_xarray") or hasattr(value, "dims")}
    if labelled and len(labelled) < len(columns):
        raise InvalidArgument(f"{', '.join(sorted(labelled))} has dimensions with names, "
                              f"{', '.join(sorted(columns.keys() - labelled))} has none; either all must have them, or none")
    try:
        import xarray
    except ImportError:
        plain = {key: _as_column(value) for key, value in columns.items()}
        shape, flat = _flat(plain)
        return {name: array for name, (_, array, _) in _variables(
            (), shape, flat, outputs, count, progress, given).items()} | dict(zip(plain, _broadcast(plain)))
    if labelled:
        arrays = {key: value if hasattr(value, "dims") else value.to_xarray() for key, value in columns.items()}
        try:
            arrays = dict(zip(arrays, xarray.align(*arrays.values(), join="exact")))
        except ValueError as error:
            raise InvalidArgument(f"{', '.join(arrays)} do not have the same coordinates: {error}") from error
        arrays = {key: array.copy(data=_as_column(array.values)) for key, array in arrays.items()}
    else:
        plain = {key: _as_column(value) for key, value in columns.items()}
        full = _broadcast(plain)
        dims = (([next(iter(plain))] if len(plain) == 1 else ["case"]) if full[0].ndim == 1
                else [f"axis_{axis}" for axis in range(full[0].ndim)])
        arrays = {key: xarray.DataArray(array, dims=dims) for key, array in zip(plain, full)}
    return _dataset(arrays, xarray.broadcast(*arrays.values()), outputs, count, ".", progress, given)


def _broadcast(plain: Mapping[str, Any]) -> list[Any]:
    try:
        return list(np.broadcast_arrays(*plain.values()))
    except ValueError:
        shapes = ", ".join(f"{key} has the shape {array.shape}" for key, array in plain.items())
        raise InvalidArgument(f"{shapes}; they must fit as NumPy broadcasts them (study combines all with all)") from None


def _flat(plain: Mapping[str, Any]) -> tuple[tuple[int, ...], dict[str, Any]]:
    full = _broadcast(plain)
    return full[0].shape, {key: array.ravel() for key, array in zip(plain, full)}


def _as_column(values: Any) -> Any:
    """Numbers as float, everything else as objects."""
    refuse_masked(values)
    array = np.asarray(values)
    return array.astype(float) if np.issubdtype(array.dtype, np.number) else np.asarray(values, dtype=object)


def _variables(dims: Any, shape: tuple[int, ...], columns: Mapping[str, Any], results: Sequence[str] | str, threads: int,
               progress: Progress, given: Mapping[str, Any]) -> dict[str, tuple[Any, Any, dict[str, Any]]]:
    """Results, statuses and warnings by name: dimensions, values, attributes."""
    results = [results] if isinstance(results, str) else list(results)
    table, statuses, messages, warned = _solve_all(columns, int(np.prod(shape)), results, threads, progress, given)
    plain = _common(given, columns)

    def variable(column: Any, long_name: str, **attributes: Any) -> tuple[Any, Any, dict[str, Any]]:
        return dims, column.reshape(shape), {"long_name": long_name, **attributes}

    found = {name: variable(table[:, index], long_name_of(name), units=unit_of(plain, name))
             for index, name in enumerate(results)}
    found["status"] = variable(statuses, "status: 0 solved, otherwise that of the exception", units="1")
    found["message"] = variable(messages, "text of the exception")
    counts = np.array([len(texts) for texts in warned], dtype=np.int32)
    found.setdefault("warning_count", variable(counts, "number of warnings", units="1"))
    grades = np.array([worst_of(graded) for graded in warned], dtype=np.int32)
    found.setdefault("grade", variable(
        grades, "how far the numbers can be used", units="1", flag_values=list(range(len(GRADES))),
        flag_meanings=" ".join(name.replace(" ", "_") for name in GRADES)))
    found["warnings"] = variable(np.array([" | ".join(text for _, text in graded) for graded in warned], dtype=object),
                                 "warnings")
    warn_of_many(warned)
    return found


def _dataset(arrays: Mapping[str, Any], grid: Sequence[Any], results: Sequence[str] | str, threads: int, separator: str,
             progress: Progress, given: Mapping[str, Any]) -> xarray.Dataset:
    """All scenes of a grid of values; `arrays` as they are given, `grid` all with the same dimensions."""
    import xarray

    columns = {key: array.values.ravel() for key, array in zip(arrays, grid)}
    dims, shape = (grid[0].dims, grid[0].shape) if grid else ((), ())
    plain = _common(given, columns)
    variables = _variables(dims, shape, columns, results, threads, progress, given)
    coordinates: dict[str, Any] = {}
    for array in arrays.values():
        coordinates.update(getattr(array, "coords", {}))
    coordinates.update({key: (array.dims, np.reshape(_labels(array.values.ravel()), array.shape),
                              {"long_name": keys()[key].meaning if key in keys() else key, **_units(key, plain, array.values)})
                        for key, array in arrays.items()})
    attributes = {"source": f"wrcontact {string(lib.wrc_version())}", **_constant(arrays, given)}
    data = xarray.Dataset(variables, coordinates, attributes)
    names = {str(name) for name in [*data.variables, *data.dims] if "." in str(name)}
    return data.rename({name: name.replace(".", separator) for name in names if separator != "."})


def _units(key: str, scene: Scene, values: Any) -> dict[str, str]:
    """The attribute `units` of a key, in the scene's units; none for texts and lists."""
    if not np.issubdtype(values.dtype, np.number):
        return {}
    unit = ffi.new("const char **")
    scene._check(lib.wrc_scene_key_unit(scene._handle, encoded(key), unit))
    return {"units": string(unit[0])} if string(unit[0]) else {}


def _column(key: str, values: Any) -> Any:
    """The values of a key and their dimension: numbers, or objects that Scene takes."""
    import xarray

    shared = isinstance(values, tuple) and len(values) == 2 and isinstance(values[0], str)
    dim, column = values if shared and not isinstance(values[1], str) else (key, values)
    refuse_masked(column)
    if isinstance(column, (str, bytes, Mapping)) or not isinstance(column, Iterable) or getattr(column, "ndim", 1) == 0:
        raise InvalidArgument(f"{key} is {column!r}; study takes a list of values here, and one value as a keyword: "
                              f"{key.replace('.', '_')}={column!r}")
    items = list(column)
    array = _objects(items)
    if all(isinstance(item, (int, float, np.number)) for item in items):
        array = array.astype(float)
    return xarray.DataArray(array, dims=[dim])


def _labels(values: Sequence[Any]) -> list[Any]:
    """What a coordinate says of values: numbers, texts, names of profiles, with options where names do not tell them apart."""
    profiles = [value for value in values if isinstance(value, Profile)]
    ways = {(profile.name, str(profile._made[2])) for profile in profiles}
    names = [name for name, _ in ways]

    def label(value: Any) -> Any:
        if isinstance(value, Profile):
            options = "".join(f"; {option} = {one}" for option, one in value._made[2].items())
            return value.name + (options if names.count(value.name) > 1 else "")
        return value if isinstance(value, (float, str)) else str(value)

    return [label(value) for value in values]


def _constant(arrays: Mapping[str, Any], given: Mapping[str, Any]) -> dict[str, Any]:
    """All keys that no varied one changes, with their values: "track.rail" changes those of the sides."""
    columns = {key: array.values.ravel() for key, array in arrays.items()}
    found: dict[str, Any] = dict(values_of(_common(given, columns)))
    for key, column in columns.items():
        alone = {name: one for name, one in given.items() if name == key or name not in columns}
        for row in _differing(column):
            probe = _common(given, columns)
            try:
                _set_row(probe, {key: column}, alone, row)
            except Error:  # the status of its scenes tells
                continue
            others: dict[str, Any] = dict(values_of(probe))
            found = {name: one for name, one in found.items()
                     if name != key and name in others
                     and np.array_equal(one, others[name])}
    return found


def _differing(column: Any) -> Iterable[int]:
    """Rows that together show every key that the column changes."""
    try:  # of numbers and lists of them: the least and the greatest
        numbers = np.array(list(column), dtype=float)
        rows = np.flatnonzero(np.isfinite(numbers.reshape(len(numbers), -1)).all(axis=1))
        if rows.size and numbers[rows].size and (rows.size == len(numbers) or column.dtype == float):
            return {*rows[np.ravel(numbers[rows].argmin(axis=0))], *rows[np.ravel(numbers[rows].argmax(axis=0))]}
    except (TypeError, ValueError):
        pass
    return {value if isinstance(value, (str, float)) else id(value): row for row, value in enumerate(column)}.values()


def _common(given: Mapping[str, Any], columns: Mapping[str, Any]) -> Scene:
    """The scene of all keys that do not vary."""
    return Scene(**{key: value for key, value in given.items() if key not in columns})


def _set_row(scene: Scene, columns: Mapping[str, Any], given: Mapping[str, Any], row: int) -> None:
    """Sets the keys of a row in the order given; constants behind a varied key are set again, as it may set them too."""
    for key in dropwhile(lambda key: key not in columns, given):
        scene[key] = columns[key][row] if key in columns else given[key]


def _solve_all(columns: Mapping[str, Any], count: int, results: Sequence[str], threads: int,
               progress: Progress, given: Mapping[str, Any]) -> tuple[Any, Any, Any, list[list[Graded]]]:
    """A row of results, a status, a text and warnings for each scene."""
    for key in columns:
        if key.startswith("convention."):
            raise InvalidArgument(f"{key} takes one value for all scenes, as the results of all have the same units and axes")
    table = np.full((count, len(results)), np.nan)
    statuses, messages = np.zeros(count, dtype=np.int32), np.full(count, "", dtype=object)
    warned: list[list[Graded]] = [[] for _ in range(count)]
    at_once = _SCENES_AT_ONCE if progress is None else _SCENES_A_REPORT
    scenes = [_common(given, columns) for _ in range(min(count, at_once))]
    result_ids = _ids(results)
    refused: list[Error] = []
    for start in range(0, count, at_once):
        part = []
        for row, scene in zip(range(start, count), scenes):
            try:
                _set_row(scene, columns, given, row)
                part.append((row, scene))
            except Error as error:
                statuses[row], messages[row] = error.status, str(error)
                refused.append(error)
        for (row, scene), outcome in zip(part, solve_without_warning(
                [scene for _, scene in part], threads)):
            warned[row] = warnings_of_outcome(outcome)
            if isinstance(outcome, Error):
                statuses[row], messages[row] = outcome.status, str(outcome)
                if outcome.result is None:
                    continue
            scene._check(lib.wrc_scene_numbers_by_id(
                scene._handle, pointer(result_ids, "int32_t"), pointer(table[row]), len(results)))
        if progress is not None:
            progress(min(1.0, (start + at_once) / count))
    if refused and len(refused) == count:
        raise refused[0]
    return table, statuses, messages, warned


def _objects(items: Sequence[Any]) -> Any:
    array = np.empty(len(items), dtype=object)
    for index, item in enumerate(items):
        array[index] = item
    return array


def _ids(names: Sequence[str]) -> Any:
    """Integers that stand for names of results in every scene."""
    scene, number = Scene(), ffi.new("int32_t *")
    found = np.empty(len(names), dtype=np.int32)
    for index, name in enumerate(names):
        scene._check(lib.wrc_scene_number_id(scene._handle, encoded(name), number))
        found[index] = number[0]
    return found


if not TYPE_CHECKING:  # _names.pyi lists the keywords
    study = _study
    study.__name__ = study.__qualname__ = "study"
