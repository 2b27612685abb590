"""Solvers, which keep data from one scene to the next, and many scenes in one call."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._handle import Handle, encoded
from ._interface import ffi
from ._library import Array, doubles, lib, pointer
from ._warnings import Graded, graded_warnings_of, warn_of_many
from .errors import Error, InvalidArgument, NoResult, error_of
from .result import Result
from .scene import Scene


class Step(NamedTuple):
    """Forces of both wheels at a position and velocity (wrc_solver_step).

    force: [2, 6], of the left and the right wheel: force x, y, z (N) and moment x, y, z (N mm) about
    the wheelset's centre. states: [2], flags of left.state. Derivatives are None unless they were asked for.
    jacobian() has them in the usual order, a row for each component. Of Table.step only: likely_errors: [2, 2],
    the error that 99 % of forces keep, over the load, and that of derivatives, each over itself; outputs,
    output_errors: [2, 8], in the order of Table.output_names.
    """

    force: Array
    by_position: Array | None
    by_velocity: Array | None
    states: NDArray[np.int32]
    by_rail: Array | None = None
    by_rail_velocity: Array | None = None
    likely_errors: Array | None = None
    outputs: Array | None = None
    output_errors: Array | None = None

    def jacobian(self) -> Array:
        """[2, 6, 12], [wheel, component, coordinate]: derivatives of `force` by x, y, z, roll, pitch, yaw and their rates.

        NoResult without derivatives: step(..., derivatives=True).
        """
        if self.by_position is None or self.by_velocity is None:
            raise NoResult("this step has no derivatives; step(..., derivatives=True) computes them")
        both: Array = np.concatenate([self.by_position, self.by_velocity], axis=1)
        return both.transpose(0, 2, 1)


# The docstrings that editors and help() show.
for _name, _text in (
        ("by_position", "[2, 6, 6], [wheel, coordinate, component]: derivative of the force by x, y, z, roll, pitch, yaw."),
        ("by_velocity", "[2, 6, 6], [wheel, coordinate, component]: derivative of the force by their rates."),
        ("by_rail", "[2, 3, 6], [wheel, coordinate, component]: by lateral, vertical, roll of the wheel's own rail."),
        ("by_rail_velocity", "[2, 3, 6], [wheel, coordinate, component]: by their rates.")):
    getattr(Step, _name).__doc__ = _text


class Equilibrium(NamedTuple):
    """Where a wheelset carries given loads (wrc_solver_equilibrium): position [6], and the step there."""

    position: Array
    step: Step


class History(Handle):
    """What the contacts of a wheelset remember from one step of time to the next (wrc_history).

    Each step with it starts from the state last accepted, and may be repeated or left.
    """

    _kind = "history"
    _instead = "send the positions and velocities of its steps, and take them again there; copy.copy copies it here"

    def accept(self) -> None:
        """Lets later steps start from the state after the last one."""
        self._check(lib.wrc_history_accept(self._handle))

    def clear(self) -> None:
        """Back to a contact without displacements, as a new history has it."""
        self._check(lib.wrc_history_clear(self._handle))

    def copy(self) -> History:
        """Another one with the same state."""
        other = History()
        other._check(lib.wrc_history_copy(other._handle, self._handle))
        return other

    __copy__ = copy

    def __deepcopy__(self, memo: dict[int, Any]) -> History:
        return self.copy()


def _numbers(values: ArrayLike, name: str, count: int) -> Array:
    numbers = doubles(values)
    if numbers.size != count:
        raise InvalidArgument(f"{name} has {numbers.size} values; it takes {count}")
    return numbers


def kind_and_loads(wheels: ArrayLike | None, axle: ArrayLike | None) -> tuple[int, Array]:
    """Of an equilibrium: one of both."""
    if wheels is not None and axle is None:
        return lib.WRC_LOADS_OF_WHEELS, _numbers(wheels, "wheels", 2)
    if axle is not None and wheels is None:
        return lib.WRC_LOAD_OF_AXLE, _numbers(axle, "axle", 2)
    raise InvalidArgument("give either wheels, the loads of both, or axle, its load and moment")


class _Arguments:
    """Further arguments of a step (wrc_step_arguments), and the arrays that it fills."""

    def __init__(self, derivatives: bool, rails: ArrayLike | None, rail_velocities: ArrayLike | None,
                 curvature: float | None, friction: ArrayLike | None, of_table: bool = False) -> None:
        self.passed = ffi.new("wrc_step_arguments*")
        self.passed.struct_size = ffi.sizeof("wrc_step_arguments")
        self._inputs = {}  # kept while C has their addresses
        for name, values, count in (("rails", rails, 6), ("rail_velocities", rail_velocities, 6),
                                    ("curvature", curvature, 1), ("friction", friction, 2)):
            if values is not None:
                self._inputs[name] = _numbers(values, name, count)
                if count == 6 and np.ndim(values) == 2 and np.shape(values) != (2, 3):
                    raise InvalidArgument(f"{name} has the shape {np.shape(values)}; it takes (2, 3): "
                                          "a row for each rail")
                setattr(self.passed, name, pointer(self._inputs[name]))
        self.force, self.states = np.empty((2, 6)), np.empty(2, dtype=np.int32)
        self.passed.states = pointer(self.states, "int32_t")
        self._rates: list[Array | None] = [None] * 4
        self._of_table: list[Array | None] = [None] * 3
        if of_table:
            self._of_table = [np.empty((2, count)) for count in (2, lib.WRC_TABLE_OUTPUTS, lib.WRC_TABLE_OUTPUTS)]
            for name, array in zip(("likely_errors", "outputs", "output_errors"), self._of_table):
                setattr(self.passed, name, pointer(array))
        if derivatives:
            self._rates = [np.empty((2, columns, 6)) for columns in (6, 6, 3, 3)]
            names = ("by_position", "by_velocity", "by_rail", "by_rail_velocity")
            for name, rate in zip(names, self._rates):
                setattr(self.passed, name, pointer(rate))

    def step(self) -> Step:
        by_position, by_velocity, by_rail, by_rail_velocity = self._rates
        return Step(self.force, by_position, by_velocity, self.states, by_rail, by_rail_velocity, *self._of_table)


class Solver(Handle):
    """Keeps profiles, tables, plans and memory between solutions; changes no bit of a result.

    One for each wheelset of a vehicle simulation; it serves one thread at a time. Options change no
    result by more than its tolerance: planner, "estimate" or "measure" (FFTW times its algorithms
    once for each size); precision of the iteration, "mixed" or "double". UnknownName, InvalidArgument.
    """

    _kind = "solver"

    def __init__(self, **options: str) -> None:
        super().__init__()
        self.set(**options)

    def set(self, **options: str) -> Solver:
        """Sets options by name, from the next solution on, and returns the solver."""
        for key, value in options.items():
            if not isinstance(value, str):
                raise InvalidArgument(f"{key} = {value!r}: a text; see help(wrcontact.Solver)")
            self._check(lib.wrc_solver_set_text(self._handle, encoded(key), encoded(value)))
        return self

    def solve(self, scene: Scene) -> Result:
        """As Scene.solve, bit for bit, in less time after the first."""
        return scene._solved(lib.wrc_solver_solve(self._handle, scene._handle))

    def clear(self) -> None:
        """Drops what it keeps but its options, so that profile files are read again."""
        self._check(lib.wrc_solver_clear(self._handle))

    def step(self, scene: Scene, position: ArrayLike, velocity: ArrayLike, *,
             rails: ArrayLike | None = None, derivatives: bool = False,
             rail_velocities: ArrayLike | None = None, curvature: float | None = None,
             friction: ArrayLike | None = None, history: History | None = None,
             dt: float = 0.0) -> Step:
        """One evaluation of a wheelset: forces of both wheels at its position and velocity.

        position: x, y, z, roll, pitch angle, yaw of its centre, z above the rail tops; velocity:
        their rates. rails, rail_velocities: lateral, vertical, roll of the left and of the right rail,
        and their rates; curvature of the track; friction of the left and of the right wheel; each
        stays as in the scene if it is None. history, dt: creep forces of a step of this time, s, from
        the history, instead of steady rolling. In the scene's convention (docs/vehicle.md). Does not
        warn; scene.result.warnings has what it would. NotConverged, NoContact.
        """
        q, v = _numbers(position, "position", 6), _numbers(velocity, "velocity", 6)
        arguments = _Arguments(derivatives, rails, rail_velocities, curvature, friction)
        arguments.passed.time_step = dt
        if history is not None:
            handles = ffi.new("wrc_history *[]", [history._handle])  # kept during the call
            arguments.passed.histories = handles
        scene._solved(lib.wrc_solver_step_with(
            self._handle, scene._handle, pointer(q), pointer(v), arguments.passed,
            pointer(arguments.force)), warns=False)
        return arguments.step()

    def equilibrium(self, scene: Scene, position: ArrayLike, *, wheels: ArrayLike | None = None,
                    axle: ArrayLike | None = None, velocity: ArrayLike | None = None,
                    rails: ArrayLike | None = None, derivatives: bool = False,
                    rail_velocities: ArrayLike | None = None, curvature: float | None = None,
                    friction: ArrayLike | None = None) -> Equilibrium:
        """Height and roll at which a wheelset carries given loads (wrc_solver_equilibrium).

        wheels: vertical forces on the left and the right wheel, N; or axle: the vertical force on the
        axle, N, and the moment about x on it. position: as in step, of which y and yaw are used;
        velocity: as in the scene if it is None. The others as in step. NotConverged, NoContact.
        """
        kind, loads = kind_and_loads(wheels, axle)
        q = _numbers(position, "position", 6).copy()
        v = None if velocity is None else _numbers(velocity, "velocity", 6)
        arguments = _Arguments(derivatives, rails, rail_velocities, curvature, friction)
        scene._solved(lib.wrc_solver_equilibrium(
            self._handle, scene._handle, kind, pointer(loads), ffi.NULL if v is None else pointer(v),
            arguments.passed, pointer(q), pointer(arguments.force)), warns=False)
        return Equilibrium(q, arguments.step())

    def creep(self, scene: Scene, patch: int, creepages: ArrayLike) -> tuple[Array, Array]:
        """Creep forces of a patch at creepages of the caller's own (wrc_solver_creep).

        patch: from 0, in the order of Result.patch_table; creepages: longitudinal, lateral, spin
        (1/mm). Returns [longitudinal force, lateral force (N), spin moment (N mm)] and their [3, 3]
        derivatives, a row for each force.
        """
        values, forces, derivatives = doubles(creepages), np.empty(3), np.empty((3, 3))
        if values.size != 3:
            raise InvalidArgument(f"creepages has {values.size} values; it takes 3")
        scene._check(lib.wrc_solver_creep(self._handle, scene._handle, patch, pointer(values),
                                          pointer(forces), pointer(derivatives)))
        return forces, derivatives


def solve_batch(scenes: Sequence[Scene], *, threads: int = 1) -> list[Result | Error]:
    """Solves scenes, each by itself, on up to `threads` threads; others of Python run meanwhile.

    Bit for bit the same for any number of threads. Returns for each scene its result, or the
    exception that Scene.solve would have raised. Warns of each kind of warnings once, with the number
    of scenes that have it.
    """
    outcomes = solve_without_warning(scenes, threads)
    warn_of_many([warnings_of_outcome(outcome) for outcome in outcomes])
    return outcomes


def warnings_of_outcome(outcome: Result | Error) -> list[Graded]:
    """Those of the result, if there is one."""
    result: Result | None = outcome.result if isinstance(outcome, Error) else outcome
    return [] if result is None else result._graded()


def solve_without_warning(scenes: Sequence[Scene], threads: int) -> list[Result | Error]:
    """As solve_batch."""
    if len(set(map(id, scenes))) < len(scenes):
        raise error_of(lib.WRC_INVALID_ARGUMENT, "scenes: one is given twice; all must differ")
    handles = ffi.new("wrc_scene *[]", [scene._handle for scene in scenes])
    untouched = -1
    statuses = ffi.new("wrc_status[]", [untouched] * len(scenes))
    status = lib.wrc_solve_batch(handles, len(scenes), threads, statuses)
    if status != 0 and untouched in statuses:
        raise error_of(status, "" if status != lib.WRC_INVALID_ARGUMENT else
                       f"threads is {threads}; must be between 1 and 1024")
    return [_outcome(scene, one) for scene, one in zip(scenes, statuses)]


def _outcome(scene: Scene, status: int) -> Result | Error:
    try:
        return scene._solved(status, warns=False)
    except Error as error:
        return error
