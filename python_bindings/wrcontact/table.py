"""Tables of contact forces that state their error (docs/table.md)."""
from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from ._handle import Handle, encoded
from ._interface import ffi
from ._library import Array, lib, pointer, string
from .scene import Scene
from .solver import Equilibrium, Solver, Step, _Arguments, _numbers, kind_and_loads


class TableFacts(NamedTuple):
    """What a table reaches, and what held-out random states say of it (wrc_table_facts).

    Errors are those of a wheel's force over its vertical force, or over half of `load` if that is more.
    """

    lateral: float
    roll: float
    yaw: float
    load: float
    tolerance: float
    states: int
    beyond: int
    beyond_at_most: float
    median_error: float
    error_99: float
    worst_error: float
    exact_share: float
    bytes: int
    beyond_likely: int
    derivatives_error: float


class Table(Handle):
    """Contact forces of a wheelset from a table, in microseconds, with their error.

    >>> table = wrcontact.Table()
    >>> table.build(scene, threads=2, progress=print)     # minutes
    >>> table.save("s1002.table")
    >>> step, error = table.step(position, velocity)
    """

    _kind = "table"
    _instead = "send the file that Table.save writes"

    def build(self, scene: Scene, *, lateral: float = 0.0, roll: float = 0.0, yaw: float = 0.0,
              load: float = 0.0, tolerance: float = 0.0, fineness: float = 0.0, threads: int = 1,
              progress: Callable[[float], Any] | None = None,
              resume_file: str | os.PathLike[str] | None = None) -> None:
        """Makes it of a scene's profiles, track and materials (wrc_table_build); 0: the default.

        progress: called now and then with the finished fraction; what it raises ends the build.
        resume_file: keeps what is finished, so that the next build goes on; remove it once the table is saved.
        """
        kept = ffi.NULL if resume_file is None else ffi.new("char[]", encoded(resume_file))
        options = ffi.new("wrc_table_options*", {
            "struct_size": ffi.sizeof("wrc_table_options"), "lateral": lateral, "roll": roll,
            "yaw": yaw, "load": load, "tolerance": tolerance, "fineness": fineness,
            "threads": threads, "resume_file": kept})
        raised: list[BaseException] = []

        def call(_context: Any, fraction: float) -> int:
            try:
                if progress is not None:
                    progress(fraction)
            except BaseException as error:  # pylint: disable=broad-except
                raised.append(error)
            return len(raised)

        called = ffi.callback("int32_t(void *, double)", call)
        status = lib.wrc_table_build(self._handle, scene._handle, options,
                                     ffi.NULL if progress is None else called, ffi.NULL)
        if raised:
            raise raised[0]
        self._check(status)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Writes a file of tens of MB."""
        self._check(lib.wrc_table_save(self._handle, encoded(path)))

    def load(self, path: str | os.PathLike[str]) -> None:
        """Reads a file, which is checked. FileMalformed, FileUnreadable."""
        self._check(lib.wrc_table_load(self._handle, encoded(path)))

    def share(self) -> Table:
        """Another one of the same numbers, for another thread."""
        other = Table()
        self._check(lib.wrc_table_share(self._handle, other._handle))
        return other

    @staticmethod
    def output_names() -> list[str]:
        """Of Step.outputs, in their order."""
        return [string(lib.wrc_table_output_name(i)) for i in range(lib.WRC_TABLE_OUTPUTS)]

    def lines(self) -> list[str]:
        """What it is of: profiles, dimensions, units and axes of steps, reach; empty without a table."""
        return self._lines(lib.wrc_table_line)

    def facts(self) -> TableFacts:
        """Its ranges and errors."""
        known = ffi.new("wrc_table_facts*")
        known.struct_size = ffi.sizeof("wrc_table_facts")
        self._check(lib.wrc_table_get_facts(self._handle, known))
        counts = ("states", "beyond", "beyond_likely", "bytes")
        return TableFacts(**{name: int(getattr(known, name)) if name in counts else getattr(known, name)
                             for name in TableFacts._fields})

    def step(self, position: ArrayLike, velocity: ArrayLike, *, solver: Solver | None = None,
             scene: Scene | None = None, rails: ArrayLike | None = None, derivatives: bool = False,
             rail_velocities: ArrayLike | None = None, curvature: float | None = None,
             friction: ArrayLike | None = None) -> tuple[Step, Array]:
        """Forces as Solver.step, and how far those of each wheel may be off, over its load.

        solver, scene: for the exact solution outside the table and where it errs too much; without
        them a step outside is InvalidArgument. Arguments that are None are 0, the friction is that of
        the table.
        """
        q, v = _numbers(position, "position", 6), _numbers(velocity, "velocity", 6)
        arguments = _Arguments(derivatives, rails, rail_velocities, curvature, friction, of_table=True)
        error = np.empty(2)
        self._check(lib.wrc_table_step(
            self._handle, ffi.NULL if solver is None else solver._handle,
            ffi.NULL if scene is None else scene._handle, pointer(q), pointer(v), arguments.passed,
            pointer(arguments.force), pointer(error)))
        return arguments.step(), error

    def equilibrium(self, position: ArrayLike, *, wheels: ArrayLike | None = None, axle: ArrayLike | None = None,
                    velocity: ArrayLike | None = None, derivatives: bool = False, rails: ArrayLike | None = None,
                    rail_velocities: ArrayLike | None = None, curvature: float | None = None,
                    friction: ArrayLike | None = None) -> tuple[Equilibrium, Array]:
        """Where the wheelset carries given loads, as Solver.equilibrium, with the errors of step.

        wheels: the vertical forces of the left and the right wheel; or axle: the axle's, and the moment about x.
        """
        kind, loads = kind_and_loads(wheels, axle)
        q = _numbers(position, "position", 6).copy()
        v = None if velocity is None else _numbers(velocity, "velocity", 6)
        arguments = _Arguments(derivatives, rails, rail_velocities, curvature, friction, of_table=True)
        error = np.empty(2)
        self._check(lib.wrc_table_equilibrium(self._handle, kind, pointer(loads), ffi.NULL if v is None else pointer(v),
                                              arguments.passed, pointer(q), pointer(arguments.force), pointer(error)))
        return Equilibrium(q, arguments.step()), error
