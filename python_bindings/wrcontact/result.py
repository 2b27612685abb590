"""Results of a scene, by name."""
from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np

from ._handle import encoded
from ._interface import ffi
from ._library import Array, lib, pointer, string
from ._warnings import GRADES, Graded, graded_warnings_of, warnings_of
from ._meanings import MEANINGS
from .errors import NoResult, UnknownName

if TYPE_CHECKING:
    from ._names import ResultNames
    from .scene import Scene
else:
    ResultNames = object

# Which fields are on which grid (docs/results.md, "Fields"); all others on that of pressures.
_ON_CREEP_GRID = ("creep_", "traction_", "slip_", "frictional_")

_COUNTS = re.compile(r"(.*\.)?(\w+_count|grade|state|solutions|iterations|(creep_)?convolutions|regions|lobes"
                     r"|(creep_)?grid\.(lateral|longitudinal))")

# Lists, which may have no entries.
_LISTS = re.compile(r"corrections|warning_classes|warning_grades"
                    r"|(left|right)\.(warnings|near_contacts|patches(\.\d+\.parts)?)")


def is_count(name: str) -> bool:
    """Whether a result is a whole number."""
    return _COUNTS.fullmatch(name) is not None


def long_name_of(name: str) -> str:
    """What a result is, for labels: "left pmax: largest pressure of all patches"; the name if nobody has said it."""
    plain = re.sub(r"\.parts\.\d+\.", ".", re.sub(r"^right\.", "left.", name))
    general = re.sub(r"\.\d+(?=\.|$)", ".N", plain)
    meaning = MEANINGS.get(general) or MEANINGS.get(general.replace("patches.N.", ""))
    return f"{name.replace('.', ' ')}: {meaning}" if meaning else name.replace(".", " ")


class Group:
    """Results whose names begin alike: `result.left`, `result.left.patches[0]`.

    Attributes and `group["patches.0.pmax"]` give numbers (float; int if they count), texts (str), fields
    (arrays), or further groups; a list such as `left.patches` has a length, 0 without contact, and can be gone through. dir() names
    what there is but fields, which docs/results.md lists. Fields of a patch are two-dimensional,
    rows across the rail from the track centre to the field side, columns along it; those of stresses
    have a row for each depth. Each access copies a field out of the library once. Of a patch, x, y
    and z are its reference; those of the elements are `field("x")` and so on. A number that has
    derivatives is the number; they are `patch["creep_force.longitudinal.by.friction"]` and so on.
    """

    __slots__ = ("_result", "_prefix")
    _result: Result
    _prefix: str

    def __init__(self, result: Result, prefix: str) -> None:
        self._result = result
        self._prefix = prefix

    def __getitem__(self, name: str | int) -> Any:
        result, full = self._result, self._prefix + str(name)
        number = result._number_or_none(full)
        if number is not None:
            return number
        if result._is_group(full):
            return Group(result, full + ".")
        parent = full.rpartition(".")[0]
        if _LISTS.fullmatch(full) and (not parent or result._is_group(parent)):
            return []
        if isinstance(name, int) and not 0 <= name < (len(self) or name + 1):
            raise IndexError(f"{self._prefix[:-1]} has {len(self)} entries, there is no {name}")
        return result._value(full)

    if not TYPE_CHECKING:  # _names.pyi lists them
        def __getattr__(self, name: str) -> Any:
            if not name.startswith("_"):
                try:
                    return self[name]
                except UnknownName as error:
                    raise AttributeError(str(error)) from None
            raise AttributeError(name)

    def __reduce__(self) -> tuple[Any, ...]:
        """With all of its result, if that is frozen."""
        return Group, (self._result, self._prefix)

    def field(self, name: str) -> Array:
        """A field by name, also where a number has the same one. UnknownName, NoResult."""
        full = self._prefix + name
        return self._result._field(full, encoded(full))

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self._children()]

    def _children(self) -> list[str]:
        start = len(self._prefix)
        return list(dict.fromkeys(name[start:].partition(".")[0] for name in self._result._names
                                  if name.startswith(self._prefix)))

    def __len__(self) -> int:
        return sum(child.isdigit() for child in self._children())

    def __bool__(self) -> bool:
        return True

    def __iter__(self) -> Iterator[Any]:
        if not len(self):
            raise TypeError(f"{self._prefix[:-1]} is not a list; it has {', '.join(self._children())}")
        return (self[index] for index in range(len(self)))

    def __repr__(self) -> str:
        values = [f"{child}: {self[child]!r}" for child in self._children()
                  if self._prefix + child not in self._result._groups]
        groups = [child for child in self._children() if self._prefix + child in self._result._groups]
        lines = values + ([f"and {', '.join(groups)}"] if groups else [])
        return f"<{self._prefix[:-1]}\n  " + "\n  ".join(lines) + ">"


class Result(Group, ResultNames):
    """The solution of a scene: `result["left.pmax"]` or `result.left.pmax`.

    Names, units and signs: docs/results.md. A result is read from its scene, which it keeps alive;
    once the scene is solved again, it is refused (NoResult): `freeze()` copies what is to be kept, or
    sent to another process.
    """

    __slots__ = ("scene", "_number", "_of_names", "_of_groups")

    def __init__(self, scene: Scene) -> None:
        self._prefix = ""
        self.scene = scene
        self._number = scene._solutions
        self._of_names: dict[str, None] | None = None
        self._of_groups: set[str] | None = None

    @property
    def _result(self) -> Result:  # type: ignore[override]
        """Not kept: a result that held itself would wait for the collector of cycles."""
        return self

    def _live(self) -> Any:
        if self._number != self.scene._solutions:
            raise NoResult("the scene has been solved again, so this earlier result cannot be read")
        return self.scene._handle

    def _number_or_none(self, name: str) -> float | None:
        number = ffi.new("double *")
        found: bool = lib.wrc_scene_number(self._live(), encoded(name), number) == 0
        return _as_counted(name, number[0]) if found else None

    def _value(self, name: str) -> Any:
        handle, code = self._live(), encoded(name)
        number = ffi.new("double *")
        status = lib.wrc_scene_number(handle, code, number)
        if status == 0:
            return _as_counted(name, number[0])
        if status == lib.WRC_UNKNOWN_NAME:
            text = ffi.new("const char **")
            if lib.wrc_scene_text(handle, code, text) == 0:
                return string(text[0])
            if lib.wrc_scene_field(handle, code, ffi.NULL, 0, ffi.new("int64_t *")) == 0:
                return self._field(name, code)
            status = lib.wrc_scene_number(handle, code, number)  # for its text
        self.scene._check(status)

    def _field(self, name: str, code: bytes) -> Array:
        self._live()
        values = self.scene._copied(lib.wrc_scene_field, code)
        prefix, _, last = name.rpartition(".")
        if last.startswith("stress_"):
            depth = self.scene._copied(lib.wrc_scene_field, encoded(f"{prefix}.stress_depth"))
            return values.reshape(-1, max(1, np.count_nonzero(depth == depth[:1])))
        grid = "creep_grid" if last.startswith(_ON_CREEP_GRID) else "grid"
        shape = [int(self._number_or_none(f"{prefix}.{grid}.{direction}") or 0)
                 for direction in ("lateral", "longitudinal")]
        return values.reshape(shape) if shape[0] * shape[1] == values.size else values

    @property
    def _names(self) -> dict[str, None]:
        """All numbers and texts."""
        if self._of_names is None:
            handle = self._live()
            self._of_names = {}
            for kind in ("number", "text"):
                name_at = getattr(lib, f"wrc_scene_{kind}_name")
                for index in range(getattr(lib, f"wrc_scene_{kind}_count")(handle)):
                    self._of_names[string(name_at(handle, index))] = None
        return self._of_names

    def _is_group(self, name: str) -> bool:
        if name in ("left", "right"):  # spares the list of all names, as long as a small solution
            return self._number_or_none(name + ".vertical") is not None
        return name in self._groups

    @property
    def _groups(self) -> set[str]:
        if self._of_groups is None:
            found: set[str] = set()
            for name in self._names:
                while (name := name.rpartition(".")[0]) and name not in found:
                    found.add(name)
            self._of_groups = found - self._names.keys()
        return self._of_groups

    @property
    def warnings(self) -> list[str]:
        """All warnings, each beginning with its subject: profiles, then the left and the right wheel.

        `result["warnings.0"]` is the first of them, of the class `result["warning_classes.0"]` and
        the grade `result["warning_grades.0"]`; `result["grade"]` is the worst as a number;
        `left.warnings` are those of the left wheel.
        """
        return warnings_of(self._live())

    def _graded(self) -> list[Graded]:
        return graded_warnings_of(self._live())

    def freeze(self, fields: Iterable[str] | str = ()) -> FrozenResult:
        """A copy of all numbers, texts and warnings, and of the fields named, without the scene.

        It stays when the scene is solved again, and can be copied, pickled and sent to another
        process. UnknownName.
        """
        if isinstance(fields, str):
            fields = [fields]
        kept = {name: self[name] for name in fields}
        for values in kept.values():
            values.setflags(write=False)
        return FrozenResult(self.to_dict(), kept, self._graded())

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError("a wrcontact.Result is read from its scene and cannot be copied or pickled; "
                        "result.freeze() can: send that")

    def to_dict(self) -> dict[str, float | str]:
        """All numbers and texts by name: a copy, which stays when the scene is solved again."""
        return {name: self._value(name) for name in self._names}

    def patch_table(self) -> Any:
        """All patches as a structured array with the members of wrc_patch (wrcontact.h).

        Those of the left wheel, then of the right one, each wheel's from the flange on, an order
        that stays from step to step.
        """
        count = ffi.new("int64_t *")
        members = [(name, "f8") for name, _ in ffi.typeof("wrc_patch").fields]
        size, handle = ffi.sizeof("wrc_patch"), self._live()
        self.scene._check(lib.wrc_scene_patches(handle, ffi.NULL, size, 0, count))
        table = np.zeros(count[0], dtype=members)
        if table.size:
            self.scene._check(lib.wrc_scene_patches(handle, pointer(table, "wrc_patch"), size,
                                                    table.size, count))
        return table

    def patch_frame(self) -> Any:
        """All patches as a pandas DataFrame: rows (wheel, patch), columns by the names of results.

        Patches are those of `left.patches` and `right.patches`, in their order; a result that a patch
        does not have is not-a-number. `frame.attrs["units"]` holds the unit of each column,
        `frame.attrs["long_name"]` what it is.
        """
        import pandas

        self._live()
        rows: dict[tuple[str, int], dict[str, float]] = {}
        for name in self._names:
            side, *rest = name.split(".", 3)
            if len(rest) == 3 and rest[0] == "patches" and rest[1].isdigit():
                value = self._number_or_none(name)
                if value is not None:
                    rows.setdefault((side, int(rest[1])), {})[rest[2]] = value
        index = pandas.MultiIndex.from_tuples(rows, names=("wheel", "patch"))
        frame = pandas.DataFrame(list(rows.values()), index=index)
        frame.attrs["units"] = {column: unit_of(self.scene, f"left.patches.0.{column}")
                                for column in frame.columns}
        frame.attrs["long_name"] = {column: long_name_of(f"left.patches.0.{column}").partition(": ")[2]
                                    for column in frame.columns}
        return frame

    def plot(self, path: str | os.PathLike[str] | None = None, *, ax: Any = None,
             panel: str = "pressures", side: str = "left") -> Any:
        """Draws profiles, pressures and tractions; returns a matplotlib Figure, saved to `path`.

        With `ax`, axes of your own, it draws one panel of one wheel on them: "outlines",
        "pressures" or "tractions". InvalidArgument for another panel or side.
        """
        from . import plot

        self._live()
        if ax is not None:
            return plot.draw_panel(self, ax, panel, side)
        return plot.draw_result(self, path)

    def _ipython_key_completions_(self) -> list[str]:
        return list(self._names)

    def __repr__(self) -> str:
        return summary_of(self)

    def _repr_html_(self) -> str:
        units = str(self["units"]).split(", ")
        head = ("wheel", "patch", f"pmax, {units[2]}", f"area, {units[0]}²", f"normal force, {units[1]}",
                f"angle, {units[3]}")
        rows = [head, *_patch_rows(self)]
        table = "".join(f"<tr>{''.join(f'<td>{escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
        warnings = "".join(f"<li>{GRADES[grade]}: {escape(text)}</li>"
                           for grade, text in self._graded())
        return (f"<p>{escape(_first_line(self))}</p><table>{table}</table>"
                + (f"<p>Warnings:</p><ul>{warnings}</ul>" if warnings else ""))


class FrozenResult(Result):
    """What Result.freeze() keeps of a result: its numbers, texts and fields are read in the same way.

    What needs the scene is refused (NoResult): plot, patch_table, patch_frame.
    """

    __slots__ = ("_kept", "_fields", "_warnings")

    def __init__(self, kept: dict[str, float | str], fields: dict[str, Array], warnings: list[Graded]) -> None:
        self._prefix = ""
        self._kept, self._fields, self._warnings = kept, fields, warnings
        self._of_names = dict.fromkeys(kept)
        self._of_groups = None

    def __reduce__(self) -> tuple[Any, ...]:
        return FrozenResult, (self._kept, self._fields, self._warnings)

    def freeze(self, fields: Iterable[str] | str = ()) -> FrozenResult:
        """Itself, if it has the fields. UnknownName."""
        for name in [fields] if isinstance(fields, str) else fields:
            self._field(name, b"")
        return self

    def _live(self) -> Any:
        raise NoResult("a frozen result has no scene: this needs the result itself")

    def _number_or_none(self, name: str) -> float | None:
        value = self._kept.get(name)
        return None if isinstance(value, str) else value

    def _value(self, name: str) -> Any:
        return self._kept[name] if name in self._kept else self._field(name, b"")

    def _field(self, name: str, code: bytes) -> Array:
        if name not in self._fields:
            raise UnknownName(f"this frozen result has no {name}; its fields are those given to freeze()")
        return self._fields[name]

    def _graded(self) -> list[Graded]:
        return self._warnings

    @property
    def warnings(self) -> list[str]:
        """As those of the result."""
        return [text for _, text in self._warnings]


def _as_counted(name: str, value: float) -> float:
    return int(value) if np.isfinite(value) and is_count(name) else value


def unit_of(scene: Scene, name: str) -> str:
    """Unit of the result of that name."""
    unit = ffi.new("const char **")
    scene._check(lib.wrc_scene_number_unit(scene._handle, encoded(name), unit))
    return string(unit[0])


def _first_line(result: Result) -> str:
    length = str(result["units"]).partition(",")[0]
    return (f"wrcontact.Result, {result['model']}: roll {result['roll']:.6g} rad, centre "
            f"{result['vertical']:.8g} {length} above the rail tops")


def _patch_rows(result: Result) -> list[tuple[str, ...]]:
    """Wheel, patch, and some of its numbers; a row as well for a wheel without patches."""
    rows: list[tuple[str, ...]] = []
    for side in ("left", "right"):
        if side not in result._groups:
            continue
        patches = result[side].patches
        for index, patch in enumerate(patches):
            values = [f"{patch[name]:{form}}" if f"{patch._prefix}{name}" in result._names else "-"
                      for name, form in (("pmax", ".6g"), ("area", ".6g"), ("normal_force", ".8g"),
                                         ("angle", ".5f"))]
            rows.append((side, str(index), *values))
        if not patches:
            rows.append((side, "no patches"))
    return rows


def summary_of(result: Result) -> str:
    """The result in a few lines: wheelset, wheels and patches, in the scene's units."""
    length, force, pressure = str(result["units"]).split(", ")[:3]
    lines = [f"<{_first_line(result)}",
             f"  wheel  patch   pmax, {pressure:<4} area, {length}2  normal force, {force:<3} "
             "angle, rad"]
    for row in _patch_rows(result):
        form = "  {:<6} {:>5} {:>12} {:>10} {:>16} {:>11}" if len(row) > 2 else "  {:<6} {}"
        lines.append(form.format(*row))
    lines += [f"  {GRADES[grade]}: {text}" for grade, text in result._graded()]
    return "\n".join(lines) + ">"
