"""Equivalent conicity of a wheelset on a track (EN 15302:2021), with its uncertainty.

As drivers/reports/conicity.hpp, which has equations and sources: from rolling radius differences, linear
between positions, the free wheelset's wave in closed form. mm; amplitude is half the distance of the turning points.
"""
from __future__ import annotations

import math
import re
import warnings
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np

from ._library import Array
from .errors import ContactWarning, Error, InvalidArgument
from .scene import Scene, key_of
from .solver import Solver

if TYPE_CHECKING:
    from .profile import Profile

STANDARD = 3.0  # mm, the amplitude at which conicities are compared
_REACH, _STEP, _SPREAD_STEP = 9.0, 0.05, 0.25  # mm
_ZERO = 1e-9  # mm, differences that count as none
_ROUNDING = 1e-9
_OWN = {"wheelset.wheel", "track.rail", "pose.lateral", "solve.side", "solve.until", "convention.units", "convention.frame"}
_DEVIATIONS, _LEAST_CURVES = 2.228, 7  # 95 of 100 cases, by ten curves


@dataclass(frozen=True)
class Conicity:
    """Equivalent conicity over the amplitude, and what it follows from, over the lateral position.

    `spread`: half of the range in which it lies in 95 of 100 cases, as far as noise and short waves of measured
    profiles go; 0 with profiles that are built in. Not-a-number where there is no conicity; `reasons` says why.
    """

    amplitude: Array
    conicity: Array
    spread: Array
    lateral: Array
    rolling_radius_difference: Array
    angle_difference: Array  #: tan of the left contact angle minus tan of the right one
    reasons: tuple[str, ...]
    standard_spread: float  #: that of `value`, at 3 mm, whatever the amplitudes
    units: dict[str, str] = field(default_factory=lambda: {
        "amplitude": "mm", "conicity": "1", "spread": "1", "lateral": "mm", "rolling_radius_difference": "mm",
        "angle_difference": "1"})
    long_name: dict[str, str] = field(default_factory=lambda: {
        "amplitude": "amplitude of the wheelset", "conicity": "equivalent conicity",
        "spread": "uncertainty of the conicity, 95 of 100 cases", "lateral": "lateral displacement, to the left",
        "rolling_radius_difference": "rolling radius difference, left less right",
        "angle_difference": "contact angle difference, left less right"})

    @property
    def value(self) -> float:
        """At an amplitude of 3 mm; not-a-number if there is none."""
        return self.at(STANDARD)

    @property
    def nonlinearity(self) -> float:
        """Half of the difference of conicities at 4 and 2 mm, 1/mm (Polach 2010)."""
        return 0.5 * (self.at(4.0) - self.at(2.0))

    def at(self, amplitude: float) -> float:
        """The conicity at an amplitude, mm; not-a-number if there is none."""
        return equivalent_conicity(self.lateral, self.rolling_radius_difference, amplitude)[0]

    def plot(self, path: Any = None, *, ax: Any = None) -> Any:
        """Draws it over the amplitude, with its spread; returns the Figure, saved to `path` if given."""
        from . import plot

        return plot.draw_conicity(self, path, ax)

    def __repr__(self) -> str:
        more = f" ± {self.standard_spread:.4f}" if self.standard_spread > 0.0 else ""
        return f"<wrcontact.Conicity {self.value:.4f}{more} at an amplitude of 3 mm>"


def over_defaults(defaults: Mapping[str, Any], keys: Mapping[str, Any], own: str) -> dict[str, Any]:
    """Keys of a caller over defaults. InvalidArgument for those that `own` sets itself, also of one side or an option."""
    for word in keys:
        key = re.sub(r"\.(left|right)\b", "", key_of(word).lower())
        if not _OWN.isdisjoint((key, key.rpartition(".")[0])):
            raise InvalidArgument(f"{word}: {own} sets {key_of(word)} itself")
    named = set(map(key_of, keys))
    return {**{word: value for word, value in defaults.items() if key_of(word) not in named}, **keys}


def conicity_of(wheel: Profile, rail: Profile, amplitudes: Sequence[float] | Array | None,
                keys: dict[str, Any]) -> Conicity:
    """Of a wheelset with this wheel on both sides on a track with this rail, without roll."""
    at = np.arange(0.5, 12.01, 0.25) if amplitudes is None else np.asarray(amplitudes, dtype=float).ravel()
    values = over_defaults({"roll": "en15302"}, keys, "the conicity")
    scene, solver = Scene(**values, wheel=wheel, rail=rail, until="geometry"), Solver()
    count = round(2.0 * _REACH / _STEP) + 1
    lateral = _STEP * (np.arange(count) - 0.5 * (count - 1))
    difference, angle = np.full((2, count), np.nan)
    for index, place in enumerate(lateral):
        result = _solved(solver, scene, place)
        if result is not None:
            difference[index] = result["rolling_radius_difference"]
            angle[index] = (math.tan(result["left.rigid_contact.angle"])
                            + math.tan(result["right.rigid_contact.angle"]))
    found = [equivalent_conicity(lateral, difference, one) for one in at]
    known = lateral[~np.isnan(difference)]
    spread = _spread_of(solver, scene, known, np.append(at, STANDARD)) if known.size else np.zeros(at.size + 1)
    return Conicity(at, np.array([value for value, _ in found]), spread[:-1], lateral, difference, angle,
                    tuple(reason for _, reason in found), float(spread[-1]))


def _solved(solver: Solver, scene: Scene, lateral: float) -> Any:
    scene["pose.lateral"] = lateral
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ContactWarning)  # positions near the ends have many
        try:
            return solver.solve(scene)
        except Error:  # off the rail: there is none
            return None


def _spread_of(solver: Solver, scene: Scene, known: Array, amplitudes: Array) -> Array:
    steps = max(1, math.ceil((known[-1] - known[0]) / _SPREAD_STEP - 1e-9))
    lateral = known[0] + (known[-1] - known[0]) * np.arange(steps + 1) / steps
    centre = np.full(lateral.size, np.nan)
    lines: list[list[Array]] = [[], []]  # of likely and of smoothed curves, a row for each position
    for index, place in enumerate(lateral):
        result = _solved(solver, scene, place)
        rows = [np.empty(0), np.empty(0)]
        if result is not None:
            rows = [result.field(f"spread.{kind}_radius_differences") for kind in ("likely", "smoothed")]
            centre[index] = result["rolling_radius_difference"]
            if rows[0].size == 0:  # built in, or points too far apart to tell
                return np.full(amplitudes.size, result["spread.rolling_radius_difference"])
        for kind, row in zip(lines, rows):
            kind.append(row)
    likely, smoothed = (_as_table(kind) for kind in lines)
    return np.array([_spread_at(lateral, centre, likely, smoothed, one) for one in amplitudes])


def _as_table(rows: list[Array]) -> Array:
    table = np.full((len(rows), max(row.size for row in rows)), np.nan)
    for index, row in enumerate(rows):
        table[index, :row.size] = row
    return table.T


def _spread_at(lateral: Array, centre: Array, likely: Array, smoothed: Array, amplitude: float) -> float:
    middle = equivalent_conicity(lateral, centre, amplitude)[0]
    noise, waves = ([value for value in ((equivalent_conicity(lateral, line, amplitude)[0] - middle) ** 2
                                         for line in lines) if not math.isnan(value)] for lines in (likely, smoothed))
    if len(noise) < _LEAST_CURVES or (not waves and len(smoothed)):
        return math.nan
    return _DEVIATIONS * math.sqrt(sum(noise) / len(noise) + max(waves, default=0.0))


class _Motion:
    """y'' = -f(y) with f half the rolling radius difference, linear between samples, and its potential."""

    def __init__(self, lateral: Array, difference: Array) -> None:
        force = np.where(np.abs(difference) <= _ZERO, 0.0, 0.5 * difference)
        crossed = np.flatnonzero(force[:-1] * force[1:] < 0.0)
        share = force[crossed] / (force[crossed] - force[crossed + 1])
        self.y = np.insert(lateral, crossed + 1, lateral[crossed] + share * np.diff(lateral)[crossed])
        self.force = np.insert(force, crossed + 1, 0.0)
        self._find_rest()
        if self.rests:
            self.slope = np.diff(self.force) / np.diff(self.y)
            steps = 0.5 * (self.force[1:] + self.force[:-1]) * np.diff(self.y)
            self.potentials = np.concatenate([[0.0], np.cumsum(steps)])
            self.potentials -= self.potentials[self.rest]

    def _find_rest(self) -> None:
        """The rest closest to the centre: samples without a force, with forces that lead there on both sides."""
        y, force, closest = self.y, self.force, math.inf
        self.rests = False
        for begin in np.flatnonzero((force == 0.0) & (np.concatenate([[-1.0], force[:-1]]) < 0.0)):
            others = np.flatnonzero(force[begin:] != 0.0)
            end = begin + others[0] - 1 if others.size else y.size - 1
            middle = begin + int(np.argmin(np.abs(y[begin:end + 1])))
            if (end + 1 == y.size or force[end + 1] > 0.0) and abs(y[middle]) < closest:
                closest, self.rests = abs(y[middle]), True
                self.rest, self.band = middle, (y[begin], y[end])

    def potential(self, y: Any) -> Any:
        i = np.clip(np.searchsorted(self.y, y, side="right") - 1, 0, self.y.size - 2)
        part = y - self.y[i]
        return self.potentials[i] + part * (self.force[i] + 0.5 * self.slope[i] * part)

    def barrier(self, y: float) -> float:
        """The greatest potential between the rest and a position to the right of it."""
        between = self.potentials[self.rest:int(np.searchsorted(self.y, y))]
        return max(float(self.potential(y)), float(between.max(initial=-math.inf)))

    def opposite(self, level: float) -> float | None:
        """The first position left of the rest with this potential; None if the samples end before."""
        above = np.flatnonzero(self.potentials[:self.rest] >= level)
        if above.size == 0:
            return float(self.y[0]) if self.potentials[0] >= (1.0 - _ROUNDING) * level else None
        i = above[-1]
        over, force = self.potentials[i] - level, -self.force[i]
        root = math.sqrt(max(force * force - 2.0 * self.slope[i] * over, 0.0))
        return float(self.y[i] + (2.0 * over / (force + root) if over > 0.0 else 0.0))

    def half_wave(self, left: float, right: float) -> float:
        """Way x from one turning point to the other."""
        y = np.concatenate([[left], self.y[(self.y > left) & (self.y < right)], [right]])
        i = np.clip(np.searchsorted(self.y, y[:-1], side="right") - 1, 0, self.y.size - 2)
        speed = np.sqrt(2.0 * np.maximum(self.potential(right) - self.potential(y), 0.0))
        speed[[0, -1]] = 0.0  # at rest for an instant
        with np.errstate(all="ignore"):
            even = 2.0 * np.diff(y) / (speed[:-1] + speed[1:])  # constant force
            c = self.slope[i]
            rate = np.sqrt(np.abs(c))
            zero = self.y[i] - self.force[i] / c
            a, b = rate * (y[:-1] - zero), rate * (y[1:] - zero)
            sine = (np.arctan2(b, speed[1:]) - np.arctan2(a, speed[:-1])) / rate
            growing = np.log((speed[1:] + b) / (speed[:-1] + a)) / rate
            falling = np.log((speed[:-1] - a) / (speed[1:] - b)) / rate
        curved = np.where(c > 0.0, sine, np.where(a + b > 0.0, growing, falling))
        return float(np.where(rate * even > 1e-5, curved, even).sum())


def _around_centre(lateral: Array, difference: Array) -> tuple[Array, Array]:
    """The samples around the centre, up to the first one without a difference on either side."""
    runs = np.split(np.arange(lateral.size), np.flatnonzero(np.diff(np.isnan(difference).astype(int))) + 1)
    runs = [run for run in runs if run.size and not np.isnan(difference[run[0]])]
    if not runs:
        return lateral[:0], difference[:0]
    run = min(runs, key=lambda one: float(np.abs(lateral[one]).min()))
    return lateral[run], difference[run]


def _halved(low: float, high: float, is_low: Callable[[float], bool]) -> tuple[float, float]:
    for _ in range(100):
        middle = 0.5 * (low + high)
        if middle in (low, high):
            break
        low, high = (middle, high) if is_low(middle) else (low, middle)
    return low, high


def equivalent_conicity(lateral: Array, difference: Array, amplitude: float) -> tuple[float, str]:
    """The conicity at an amplitude about the rest closest to the centre, or not-a-number and why.

    lateral: ascending positions, mm; difference: of rolling radii there, not-a-number where there is none.
    """
    y, known = _around_centre(lateral, difference)
    if y.size < 2 or not amplitude > 0.0:
        return math.nan, "no rolling radius difference is known"
    motion = _Motion(y, known)
    if not motion.rests:
        return math.nan, f"the wheelset is led back to no position between y = {y[0]:g} and {y[-1]:g} mm"
    width, (band_begin, band_end) = 2.0 * amplitude, motion.band
    if width <= band_end - band_begin:
        return 0.0, ""

    def is_too_narrow(right: float, share: float = 1.0) -> bool:
        left = motion.opposite(motion.barrier(right))
        return left is not None and right - left < share * width

    most = min(float(y[-1]), band_begin + width)
    if most == y[-1] and (most == band_end or is_too_narrow(most, 1.0 - _ROUNDING)):
        return math.nan, f"the rolling radius difference is not known beyond y = {most:g} mm"
    least, most = _halved(band_end, most, is_too_narrow)
    barrier = motion.barrier(least)
    left = motion.opposite(barrier)
    if (left is None or abs(least - left - width) > _ROUNDING * width
            or motion.potential(least) < (1.0 - _ROUNDING) * barrier):
        if motion.opposite(motion.barrier(most)) is None:
            return math.nan, f"the rolling radius difference is not known beyond y = {y[0]:g} mm"
        return math.nan, (f"no motion about y = {motion.y[motion.rest]:.2f} mm is that wide: the wheelset runs away "
                          "to another position of rest")
    return (math.pi / motion.half_wave(left, least)) ** 2, ""
