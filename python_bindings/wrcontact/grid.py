"""Contact on a grid of the caller's: pressures of a gap, tractions of pressures (wrcontact_grid.h)."""
from __future__ import annotations

import os
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike

from ._handle import Handle, encoded
from ._interface import ffi
from ._library import Array, doubles, lib, pointer, string
from ._warnings import GRADES, warn
from .errors import InvalidArgument, NotConverged, UnknownName

Self = TypeVar("Self", bound="GridContact")


class _Part:
    """Results whose names begin alike: `contact.creep_force`."""

    __slots__ = ("_contact", "_prefix")

    def __init__(self, contact: GridContact, prefix: str) -> None:
        self._contact = contact
        self._prefix = prefix

    def __getattr__(self, name: str) -> Any:
        return getattr(self._contact, self._prefix + name)


class GridContact(Handle):
    """Common to both kinds of contact: settings by key, results by name.

    Results are attributes or `contact["residuals.least_gap"]`; fields are arrays of the grid's shape.
    They are those of the last solve.
    """

    _parts: tuple[str, ...] = ()
    _shown: tuple[str, ...] = ()
    _shape: tuple[int, ...] = ()

    def _set_grid(self, values: Array, lateral_step: float, longitudinal_step: float) -> None:
        if values.ndim != 2:
            raise InvalidArgument(f"the values have {values.ndim} dimensions; must be 2, rows "
                                  "across and columns along")
        self._check(self._function("set_grid")(self._handle, *values.shape, lateral_step,
                                               longitudinal_step))
        self._shape = values.shape

    def _function(self, name: str) -> Any:
        return getattr(lib, f"wrc_{self._kind}_{name}")

    def set(self: Self, **settings: Any) -> Self:
        """Sets numbers and texts by key (wrcontact_grid.h); returns the contact.

        UnknownName, InvalidArgument.
        """
        for key, value in settings.items():
            if isinstance(value, (str, os.PathLike)):
                status = self._function("set_text")(self._handle, encoded(key), encoded(value))
            else:
                status = self._function("set_number")(self._handle, encoded(key), value)
            self._check(status)
        return self

    def solve(self: Self) -> Self:
        """Solves the problem and returns the contact. NotConverged holds it as `result`."""
        try:
            self._check(self._function("solve")(self._handle))
        except NotConverged as error:
            error.result = self
            raise
        return self

    def __getitem__(self, name: str) -> Any:
        code, number = encoded(name), ffi.new("double *")
        status = self._function("number")(self._handle, code, number)
        if status == 0:
            return number[0]
        if status == lib.WRC_UNKNOWN_NAME:
            text = ffi.new("const char **")
            if self._kind == "normal" and lib.wrc_normal_text(self._handle, code, text) == 0:
                return string(text[0])
            if "any more" in string(self._error(self._handle)):  # the successor of a number
                self._check(status)
            values = self._copied(self._function("field"), code)
            return values.reshape(self._shape if values.size == np.prod(self._shape) else (3, 3))
        return self._check(status)

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in self._parts:
            return _Part(self, name + ".")
        try:
            return self[name]
        except UnknownName as error:
            raise AttributeError(str(error)) from None

    def __repr__(self) -> str:
        size = " x ".join(map(str, self._shape))
        try:
            values = ", ".join(f"{name} {self[name]:.6g}" for name in self._shown)
        except Exception as error:  # noqa: BLE001, a repr tells instead
            values = str(error)
        return f"<wrcontact.{type(self).__name__} on {size}: {values}>"


class NormalContact(GridContact):
    """Pressures of bodies that are `distance` apart before they press on each other.

    >>> contact = NormalContact(distance, 0.1, 0.2, normal_load=80e3, tolerance=1e-6).solve()
    >>> contact.pmax, contact.approach, contact.pressure

    distance: mm at the centres of the elements, two-dimensional, rows across and columns along;
    copied once, by the library. Steps: sides of an element, mm. Settings: combined_modulus (MPa),
    normal_load (N) or approach (mm), tolerance, maximum_iterations, solver, elements, precision,
    planner. Results: approach, normal_force, area (mm^2), pmax, pmax_element (MPa), fill, iterations,
    residuals..., stop_reason, warnings; fields pressure (MPa), displacement (mm). solve() gives each
    of its warnings as a ContactWarning.
    """

    _kind = "normal"
    _parts = ("residuals",)
    _shown = ("approach", "normal_force", "pmax", "area")

    def __init__(self, distance: ArrayLike, lateral_step: float, longitudinal_step: float,
                 **settings: Any) -> None:
        super().__init__()
        values = doubles(distance)
        self._set_grid(values, lateral_step, longitudinal_step)
        self._check(lib.wrc_normal_set_distance(self._handle, pointer(values), values.size))
        self.set(**settings)

    def solve(self: Self) -> Self:
        """As GridContact.solve, with its warnings."""
        try:
            super().solve()
        except NotConverged:
            self._warn()
            raise
        self._warn()
        return self

    def _warn(self) -> None:
        warn([(GRADES.index(self[f"warning_grades.{index}"]), text)
              for index, text in enumerate(self.warnings)])

    @property
    def warnings(self) -> list[str]:
        """What is doubtful of the result: contact at the grid's edge, or on too few elements."""
        return [self[f"warnings.{i}"] for i in range(int(self["warning_count"]))]


class RollingContact(GridContact):
    """Tractions and creep forces of given pressures, with Coulomb friction (Kalker's problem).

    >>> contact = RollingContact(pressure, 0.1, 0.2, longitudinal_creepage=-1e-3).solve()
    >>> contact.creep_force.longitudinal, contact.slip_area, contact.traction_x

    pressure: MPa, two-dimensional, rows with growing y (to the left), columns with growing x
    (forward); copied once, by the library. Creepages are wheel minus rail, forces those on the
    wheel. Settings: shear_modulus (MPa), poisson, friction, longitudinal_creepage, lateral_creepage,
    spin_creepage (1/mm), tolerance, difference_parameter, derivatives, maximum_iterations, model,
    contact, difference. Results: creep_force.longitudinal, creep_force.lateral (N), spin_moment
    (N mm), slip_area, adhesion_area (mm^2), friction_power, numerical_loss, iterations, convolutions,
    residual, converged; fields traction_x, traction_y (MPa), slip_x, slip_y, normal_displacement
    (mm), and creepage_derivatives, [3, 3] with a row for each of Fx, Fy, Mz.
    """

    _kind = "rolling"
    _parts = ("creep_force",)
    _shown = ("creep_force.longitudinal", "creep_force.lateral", "spin_moment", "slip_area")

    def __init__(self, pressure: ArrayLike, lateral_step: float, longitudinal_step: float,
                 **settings: Any) -> None:
        super().__init__()
        values = doubles(pressure)
        self._set_grid(values, lateral_step, longitudinal_step)
        self._check(lib.wrc_rolling_set_pressure(self._handle, pointer(values), values.size))
        self.set(**settings)

    def set_slip(self, slip_x: ArrayLike, slip_y: ArrayLike) -> RollingContact:
        """Rigid slip of each element in addition to that of the creepages; two empty lists: none."""
        x, y = doubles(slip_x), doubles(slip_y)
        if x.shape != y.shape:
            raise InvalidArgument(f"slip_x has shape {x.shape}, slip_y {y.shape}; must be equal")
        self._check(lib.wrc_rolling_set_slip(self._handle, pointer(x), pointer(y), x.size))
        return self

    def set_previous(self, traction_x: ArrayLike, traction_y: ArrayLike) -> RollingContact:
        """The tractions (MPa, on the wheel) before a step or shift; two empty lists: none."""
        x, y = doubles(traction_x), doubles(traction_y)
        if x.shape != y.shape:
            raise InvalidArgument(f"traction_x has shape {x.shape}, traction_y {y.shape}; must be "
                                  "equal")
        self._check(lib.wrc_rolling_set_previous(self._handle, pointer(x), pointer(y), x.size))
        return self

    def advance(self) -> RollingContact:
        """Makes the tractions of the result the previous ones, for the next step or shift."""
        self._check(lib.wrc_rolling_advance(self._handle))
        return self
