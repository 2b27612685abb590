"""What is measured on a profile: dimensions, and the distance to another profile.

As drivers/reports/profile_measures.hpp defines them, in the frame of the profile; mm.
"""
from __future__ import annotations

from collections.abc import Callable, Mapping
from html import escape
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from ._library import Array
from .errors import InvalidArgument

if TYPE_CHECKING:
    from .profile import Profile, ProfilePoint

_POINTS_A_PIECE = 8
_HALVINGS = 60
_GOLDEN_STEPS, _GOLDEN = 40, 0.61803398874989485
_SPACING = 0.1  # mm, of comparisons

# Name, unit and definition, in the order of wrc_profile.
_OF_WHEELS = {
    "flange_height": ("mm", "flange height Sh: tip above the taping line"),
    "flange_thickness": ("mm", "flange thickness Sd: flange back to flank, 10 mm above the taping line"),
    "qr": ("mm", "qR: across, from 2 mm below the flange tip to the flank 10 mm above the taping line"),
    "slope": ("1", "slope at the taping line: height over lateral; a cone falls outwards"),
    "conicity": ("1", "conicity of the cone tangent at the taping line")}
_OF_RAILS = {
    "head_width_14": ("mm", "head width 14 mm below the top"),
    "head_width_16": ("mm", "head width 16 mm below the top"),
    "crown_radius": ("mm", "crown radius: circle through the top and the points 5 mm beside it")}


class Dimensions(dict[str, float]):
    """Dimensions by name; not-a-number if the profile does not have one. `units`, `long_name` by name."""

    def __init__(self, values: Mapping[str, float], kinds: Mapping[str, tuple[str, str]]) -> None:
        super().__init__(values)
        self.units = {name: unit for name, (unit, _) in kinds.items()}
        self.long_name = {name: meaning for name, (_, meaning) in kinds.items()}

    def __repr__(self) -> str:
        return "\n".join(f"{name:<17} {value:10.4f} {self.units[name]:<3} {self.long_name[name]}"
                         for name, value in self.items())

    def _repr_html_(self) -> str:
        rows = (f"<tr><td>{escape(self.long_name[name])}</td><td>{value:.4f}</td><td>{self.units[name]}</td></tr>"
                for name, value in self.items())
        return f"<table>{''.join(rows)}</table>"


class Comparison(NamedTuple):
    """A profile beside another, each in its own frame: nothing is shifted or turned to fit. mm, mm^2.

    distance: normal distance at each of `lateral` and `height`, positive where the other one is higher,
    not-a-number beyond its ends; largest: the one of largest amount, at largest_at (lateral, height); rms: over the
    arc that has a counterpart, `compared` long; missing_area, added_area: between both, where the other one is
    higher, and lower; differences: dimensions less those of the other.
    """

    lateral: Array
    height: Array
    distance: Array
    largest: float
    largest_at: tuple[float, float]
    rms: float
    compared: float
    missing_area: float
    added_area: float
    differences: Dimensions


class _Curve:
    """A profile at points of each piece, from its begin to its end, with places between them."""

    def __init__(self, profile: Profile) -> None:
        nodes = profile.nodes
        parts = np.linspace(0.0, 1.0, _POINTS_A_PIECE + 1)
        arcs = nodes[:-1, None] + np.diff(nodes)[:, None] * parts
        arcs[:, -1] = np.nextafter(nodes[1:], nodes[:-1])  # a node counts to the piece that begins there
        self.profile, self.arcs = profile, arcs.ravel()
        self.points = profile.at(self.arcs)

    def at(self, arc: float) -> ProfilePoint:
        return self.profile.at(arc)

    def crossings(self, of: str, value: float) -> list[float]:
        """Arc lengths at which a coordinate passes a value, in ascending order."""
        below = getattr(self.points, of) < value
        arcs = []
        for i in np.flatnonzero(below[1:] != below[:-1]):
            before, after = self.arcs[i], self.arcs[i + 1]
            for _ in range(_HALVINGS):
                middle = 0.5 * (before + after)
                if (getattr(self.at(middle), of) < value) == below[i]:
                    before = middle
                else:
                    after = middle
            arcs.append(float(after))
        return arcs

    def top(self) -> float:
        """The arc length of the highest point."""
        best = int(np.argmax(self.points.height))
        first, last = self.arcs[max(best - 1, 0)], self.arcs[min(best + 1, self.arcs.size - 1)]
        for _ in range(_HALVINGS):
            third = (last - first) / 3.0
            if self.at(first + third).height < self.at(last - third).height:
                first += third
            else:
                last -= third
        return float(max(0.5 * (first + last), self.arcs[best], key=lambda arc: float(self.at(arc).height)))


def _first_after(arcs: list[float], arc: float) -> float | None:
    return next((one for one in arcs if one > arc), None)


def _last_before(arcs: list[float], arc: float) -> float | None:
    return next((one for one in reversed(arcs) if one < arc), None)


def dimensions_of(profile: Profile, tape_offset: float) -> Dimensions:
    curve = _Curve(profile)
    if profile.kind == "rail":
        return Dimensions(_of_rail(curve), _OF_RAILS)
    return Dimensions(_of_wheel(curve, tape_offset), _OF_WHEELS)


def _of_wheel(curve: _Curve, tape_offset: float) -> dict[str, float]:
    found = dict.fromkeys(_OF_WHEELS, np.nan)
    at_line, tip_at = curve.crossings("lateral", 0.0), curve.top()
    if at_line:
        line, tip = curve.at(at_line[-1]), curve.at(tip_at)
        found["flange_height"] = float(tip.height - line.height)
        found["slope"] = float(np.tan(line.angle))
        found["conicity"] = -found["slope"]
        flank = _first_after(curve.crossings("height", float(line.height) + 10.0), tip_at)
        below_tip = _first_after(curve.crossings("height", float(tip.height) - 2.0), tip_at)
        if flank is not None:
            across = float(curve.at(flank).lateral)
            found["flange_thickness"] = across + tape_offset
            if below_tip is not None:
                found["qr"] = across - float(curve.at(below_tip).lateral)
    return found


def _of_rail(curve: _Curve) -> dict[str, float]:
    found = dict.fromkeys(_OF_RAILS, np.nan)
    top_at = curve.top()
    top = curve.at(top_at)

    def beside(of: str, left: float, right: float) -> list[tuple[float, float]]:
        arcs = (_last_before(curve.crossings(of, left), top_at), _first_after(curve.crossings(of, right), top_at))
        return [(float(point.lateral), float(point.height)) for point in (curve.at(arc) for arc in arcs if arc is not None)]

    for depth in (14, 16):
        level = float(top.height) - depth
        sides = beside("height", level, level)
        if len(sides) == 2:
            found[f"head_width_{depth}"] = sides[1][0] - sides[0][0]
    sides = beside("lateral", float(top.lateral) - 5.0, float(top.lateral) + 5.0)
    if len(sides) == 2:
        (y1, z1), (y2, z2), (y0, z0) = *sides, (float(top.lateral), float(top.height))
        twice_area = (y0 - y1) * (z2 - z1) - (z0 - z1) * (y2 - y1)
        if twice_area != 0.0:
            found["crown_radius"] = (np.hypot(y0 - y1, z0 - z1) * np.hypot(y2 - y0, z2 - z0)
                                     * np.hypot(y2 - y1, z2 - z1) / (-2.0 * twice_area))
    return found


def _equal_arcs(profile: Profile) -> Array:
    parts = int(np.ceil(profile.length / _SPACING))
    return profile.length * (np.arange(parts + 1) / parts)


def distances_to(other: Profile, lateral: Array, height: Array) -> Array:
    """Normal distance from each point to a profile, positive where that is higher; not-a-number beyond its ends."""
    arcs = _equal_arcs(other)
    coarse = other.at(arcs)
    nearest = np.array([np.argmin((coarse.lateral - y) ** 2 + (coarse.height - z) ** 2)
                        for y, z in zip(lateral, height)])
    first, last = arcs[np.maximum(nearest - 1, 0)], arcs[np.minimum(nearest + 1, arcs.size - 1)]

    def distance(arc: Array) -> Array:
        foot = other.at(arc)
        return np.hypot(foot.lateral - lateral, foot.height - height)

    for _ in range(_GOLDEN_STEPS):
        reach = _GOLDEN * (last - first)
        before = distance(last - reach) < distance(first + reach)
        first, last = np.where(before, first, last - reach), np.where(before, first + reach, last)
    arc = 0.5 * (first + last)
    foot = other.at(arc)
    # Beyond an end the line to it is not normal: there is no counterpart.
    along = (lateral - foot.lateral) * np.cos(foot.angle) + (height - foot.height) * np.sin(foot.angle)
    beyond = ((arc < 0.5 * _SPACING) & (along < -1e-6)) | ((arc > arcs[-1] - 0.5 * _SPACING) & (along > 1e-6))
    normal = (foot.height - height) * np.cos(foot.angle) - (foot.lateral - lateral) * np.sin(foot.angle)
    return np.where(beyond, np.nan, normal)


def comparison_of(profile: Profile, other: Profile, differ: Callable[[], Dimensions]) -> Comparison:
    if profile.kind != other.kind:
        raise InvalidArgument(f"other is the {other.kind} {other.name}; must be a {profile.kind} as {profile.name} is")
    points = profile.at(_equal_arcs(profile))
    distance = distances_to(other, points.lateral, points.height)
    known = ~np.isnan(distance)
    if not known.any():
        raise InvalidArgument(f"other is {other.name}, which lies nowhere beside {profile.name}; "
                              "both must be in the same frame")
    step = profile.length / (distance.size - 1)
    worst = int(np.nanargmax(np.abs(distance)))
    return Comparison(
        points.lateral, points.height, distance, float(distance[worst]),
        (float(points.lateral[worst]), float(points.height[worst])), float(np.sqrt(np.mean(distance[known] ** 2))),
        float(profile.length * known.mean()), float(distance[known & (distance > 0.0)].sum() * step),
        float(-distance[known & (distance < 0.0)].sum() * step), differ())
