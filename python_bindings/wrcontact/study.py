"""Studies: many scenes as an xarray Dataset."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._handle import encoded
from ._interface import ffi
from ._library import doubles, lib, pointer, string
from ._warnings import GRADES, Graded, warn_of_many, worst_of
from .errors import Error
from .scene import Scene, key_of, keys, refuse_doubled, values_of
from .result import unit_of
from .solver import solve_without_warning, warnings_of_outcome

if TYPE_CHECKING:
    import xarray

# Scenes that are solved in one call and hold their results at the same time.
_SCENES_AT_ONCE = 512


def study(parameters: Mapping[str, Any], results: Sequence[str] = ("left.pmax", "right.pmax"), *,
          threads: int = 1, separator: str = ".", **values: Any) -> xarray.Dataset:
    """Solves every combination of the values of keys; results by name as an xarray Dataset.

    >>> data = study({"lateral": range(-6, 7), "rail": ["60E1", "56E1"]}, ["left.pmax"], threads=2)
    >>> data["left.pmax"].sel({"track.rail": "60E1"}).plot()

    parameters: values by key or keyword (key_of). Each has a dimension of its own, with the key as
    its name; ("case", values) puts it on the dimension "case" instead, shared with others of equal
    length, for scenes drawn at random. results: names of numbers (docs/results.md); not-a-number
    without contact. separator: what stands for the points in names of the Dataset; with "_" they are
    attributes: `data.left_pmax.sel(track_rail="60E1")`. Further keywords are keys with one value. All in the units of `values`, mm, N,
    MPa, rad by default.

    Each result has its unit as attribute `units`, each key that varies as well (if it is one number), and its meaning as
    `long_name`. The
    Dataset has besides `status` and `message` of each scene (0: solved; an exception's status and text),
    `grade` (0 fine, 1 a little over, 2 do not use), `warning_count` and `warnings` (texts, separated by " | "), and all keys that do not vary as
    attributes. A scene that fails is not raised; each kind of warnings is a ContactWarning with the
    number of its scenes. Results do not depend on `threads`; each scene is solved by itself, as by
    Scene.solve.
    """
    import xarray

    refuse_doubled([*parameters, *values])
    varied = {key_of(word): column for word, column in parameters.items()}
    arrays = {key: _column(key, column) for key, column in varied.items()}
    grid = xarray.broadcast(*arrays.values()) if arrays else ()
    shape = grid[0].shape if grid else ()
    columns = {key: array.values.ravel() for key, array in zip(arrays, grid)}
    table, statuses, messages, warned = _solve_all(columns, int(np.prod(shape)), results, threads, values)
    dims = grid[0].dims if grid else ()
    plain = Scene(**values)
    variables: dict[str, Any] = {
        name: (dims, table[:, index].reshape(shape), {"units": unit_of(plain, name)})
        for index, name in enumerate(results)}
    variables["status"] = (dims, statuses.reshape(shape))
    variables["message"] = (dims, messages.reshape(shape))
    counts = np.array([len(texts) for texts in warned], dtype=np.int32)
    variables.setdefault("warning_count", (dims, counts.reshape(shape)))
    grades = np.array([worst_of(graded) for graded in warned], dtype=np.int32)
    variables.setdefault("grade", (dims, grades.reshape(shape), {
        "flag_values": list(range(len(GRADES))),
        "flag_meanings": " ".join(name.replace(" ", "_") for name in GRADES)}))
    texts = np.array([" | ".join(text for _, text in graded) for graded in warned], dtype=object)
    variables["warnings"] = (dims, texts.reshape(shape))
    warn_of_many(warned)
    coordinates = {key: (array.dims, [_told(value) for value in array.values],
                         {"long_name": keys()[key].meaning if key in keys() else key, **_units(key, plain, array.values)})
                   for key, array in arrays.items()}
    attributes = {"source": f"wrcontact {string(lib.wrc_version())}", **_constant(arrays, values)}
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
    items = list(column)
    array = np.empty(len(items), dtype=object)
    for index, item in enumerate(items):
        array[index] = item
    if all(isinstance(item, (int, float, np.number)) for item in items):
        array = array.astype(float)
    return xarray.DataArray(array, dims=[dim])


def _told(value: Any) -> Any:
    """What a coordinate says of a value: a number, a text, or the name of a profile."""
    return value if isinstance(value, (float, str)) else getattr(value, "name", str(value))


def _constant(arrays: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """All keys that no varied one changes, with their values: "track.rail" changes those of the sides."""
    found: dict[str, Any] = dict(values_of(Scene(**values)))
    for key, array in arrays.items():
        for value in array.values[[0, -1]] if array.size else ():
            probe = Scene(**values)
            probe[key] = value
            others: dict[str, Any] = dict(values_of(probe))
            found = {name: one for name, one in found.items()
                     if name != key and name in others
                     and np.array_equal(one, others[name])}
    return found


def _solve_all(columns: Mapping[str, Any], count: int, results: Sequence[str], threads: int,
               values: Mapping[str, Any]) -> tuple[Any, Any, Any, list[list[Graded]]]:
    """A row of results, a status, a text and warnings for each scene."""
    table = np.full((count, len(results)), np.nan)
    statuses, messages = np.zeros(count, dtype=np.int32), np.full(count, "", dtype=object)
    warned: list[list[Graded]] = [[] for _ in range(count)]
    scenes = [Scene(**values) for _ in range(min(count, _SCENES_AT_ONCE))]
    result_ids = _ids(results, "number")
    set_row = _setter(columns)
    for start in range(0, count, _SCENES_AT_ONCE):
        part = list(zip(range(start, count), scenes))
        for row, scene in part:
            set_row(scene, row)
        for (row, scene), outcome in zip(part, solve_without_warning(
                [scene for _, scene in part], threads)):
            warned[row] = warnings_of_outcome(outcome)
            if isinstance(outcome, Error):
                statuses[row], messages[row] = outcome.status, str(outcome)
                if outcome.result is None:
                    continue
            scene._check(lib.wrc_scene_numbers_by_id(
                scene._handle, pointer(result_ids, "int32_t"), pointer(table[row]), len(results)))
    return table, statuses, messages, warned


def _ids(names: Sequence[str], kind: str) -> Any:
    """Integers that stand for keys or names of results in every scene."""
    scene, number = Scene(), ffi.new("int32_t *")
    function = lib.wrc_scene_key_id if kind == "key" else lib.wrc_scene_number_id
    found = np.empty(len(names), dtype=np.int32)
    for index, name in enumerate(names):
        scene._check(function(scene._handle, encoded(name), number))
        found[index] = number[0]
    return found


def _setter(columns: Mapping[str, Any]) -> Any:
    """What sets the keys of a row: by id if all are numbers, otherwise one by one.

    Options of profiles have no ids.
    """
    if not all(np.issubdtype(column.dtype, np.number) and key in keys() for key, column in columns.items()):
        def set_words(scene: Scene, row: int) -> None:
            for key, column in columns.items():
                scene[key] = column[row]

        return set_words
    ids = _ids(list(columns), "key")
    rows = doubles(np.stack(list(columns.values()), axis=-1)) if columns else np.empty((1, 0))

    def set_numbers(scene: Scene, row: int) -> None:
        scene._check(lib.wrc_scene_set_numbers_by_id(
            scene._handle, pointer(ids, "int32_t"), pointer(rows[row]), len(ids)))

    return set_numbers
