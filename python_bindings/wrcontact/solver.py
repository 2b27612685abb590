"""Solvers, which keep data from one scene to the next, and many scenes in one call."""
from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._handle import Handle
from ._interface import ffi
from ._library import Array, doubles, lib, pointer
from ._warnings import warn_of_many, warnings_of
from .errors import Error, InvalidArgument, error_of
from .result import Result
from .scene import Scene


class Step(NamedTuple):
    """Forces of both wheels at a position and velocity (wrc_solver_step).

    force: [2, 6], of the left and the right wheel: force x, y, z (N) and moment x, y, z (N mm) about
    the wheelset's centre. by_position, by_velocity: [2, 6, 6] or None: [wheel, k, i] is the
    derivative of component i by coordinate k. states: [2], flags of left.state.
    """

    force: Array
    by_position: Array | None
    by_velocity: Array | None
    states: NDArray[np.int32]


def _six(values: ArrayLike, name: str) -> Array:
    numbers = doubles(values)
    if numbers.size != 6:
        raise InvalidArgument(f"{name} has {numbers.size} values; it takes 6")
    return numbers


class Solver(Handle):
    """Keeps profiles, tables, plans and memory between solutions; changes no bit of a result.

    One for each wheelset of a vehicle simulation; it serves one thread at a time.
    """

    _kind = "solver"

    def solve(self, scene: Scene) -> Result:
        """As Scene.solve, bit for bit, in less time after the first."""
        return scene._solved(lib.wrc_solver_solve(self._handle, scene._handle))

    def clear(self) -> None:
        """Drops everything it keeps, so that profile files are read again."""
        self._check(lib.wrc_solver_clear(self._handle))

    forget = clear  # its old name

    def step(self, scene: Scene, position: ArrayLike, velocity: ArrayLike, *,
             rails: ArrayLike | None = None, derivatives: bool = False) -> Step:
        """One evaluation of a wheelset: forces of both wheels at its position and velocity.

        position: x, y, z, roll, pitch angle, yaw of its centre, z above the rail tops; velocity:
        their rates. rails: lateral, vertical, roll of the left and of the right rail; otherwise as
        in the scene. In the scene's convention (docs/vehicle.md). Does not warn; scene.result.warnings
        has what it would. NotConverged, NoContact.
        """
        q, v = _six(position, "position"), _six(velocity, "velocity")
        r = ffi.NULL if rails is None else pointer(_six(rails, "rails"))
        force, states = np.empty((2, 6)), np.empty(2, dtype=np.int32)
        by_position = np.empty((2, 6, 6)) if derivatives else None
        by_velocity = np.empty((2, 6, 6)) if derivatives else None
        scene._solved(lib.wrc_solver_step(
            self._handle, scene._handle, pointer(q), pointer(v), r, pointer(force),
            ffi.NULL if by_position is None else pointer(by_position),
            ffi.NULL if by_velocity is None else pointer(by_velocity), pointer(states, "int32_t")),
            warns=False)
        return Step(force, by_position, by_velocity, states)

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


def warnings_of_outcome(outcome: Result | Error) -> list[str]:
    """Those of the result, if there is one."""
    result = outcome.result if isinstance(outcome, Error) else outcome
    return [] if result is None else warnings_of(result._live())


def solve_without_warning(scenes: Sequence[Scene], threads: int) -> list[Result | Error]:
    """As solve_batch."""
    handles = ffi.new("wrc_scene *[]", [scene._handle for scene in scenes])
    untouched = -1
    statuses = ffi.new("wrc_status[]", [untouched] * len(scenes))
    status = lib.wrc_solve_batch(handles, len(scenes), threads, statuses)
    if status != 0 and untouched in statuses:
        raise error_of(status, "" if status != lib.WRC_INVALID_ARGUMENT else
                       f"threads is {threads}; allowed is 1 to 1024, and scenes that all differ")
    return [_outcome(scene, one) for scene, one in zip(scenes, statuses)]


def _outcome(scene: Scene, status: int) -> Result | Error:
    try:
        return scene._solved(status, warns=False)
    except Error as error:
        return error
