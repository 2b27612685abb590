"""Rail and wheel of a scene as surfaces through the points of the library's profiles, placed by code of their own, and the scene solved
by the library.

Units mm, N, MPa, rad; track frame x forward, y left, z up; left wheel. A wheel so steep under yaw that rays meet it twice is not
covered.
"""
from __future__ import annotations

import warnings
from dataclasses import dataclass
from typing import Any

import numpy as np

from calculix import POISSON, YOUNG

Array = Any
RADIUS, GAUGE, GAUGE_HEIGHT, TAPE_OFFSET = 460.0, 1435.0, 14.0, 70.0
STEP_CLOSED_OVER = 2.0  # mm on each side, as the library closes steps left by rounded coefficients


class Graph:
    """A function through points with slopes: cubic pieces, which follow arcs to 1e-8 mm."""

    def __init__(self, place: Array, value: Array, slope: Array) -> None:
        keep = np.concatenate([[True], np.diff(place) > 1e-10])
        self.place, self.value, self.slope = place[keep], value[keep], slope[keep]

    def __call__(self, at: Array) -> tuple[Array, Array]:
        """Value and slope."""
        i = np.clip(np.searchsorted(self.place, at) - 1, 0, len(self.place) - 2)
        width = self.place[i + 1] - self.place[i]
        t = (at - self.place[i]) / width
        chord = (self.value[i + 1] - self.value[i]) / width
        left, right = self.slope[i], self.slope[i + 1]
        bend, twist = 3 * chord - 2 * left - right, left + right - 2 * chord
        return (self.value[i] + width * t * (left + t * (bend + t * twist)),
                left + t * (2 * bend + 3 * t * twist))


def profile_points(profile: Any, spacing: float = 0.05) -> tuple[Array, Array, Array]:
    """Lateral, height and angle along a profile, on both sides of its nodes, with steps closed."""
    nodes = np.asarray(profile.nodes)
    pieces = [np.linspace(first + 1e-9, last - 1e-9, 2 + int((last - first) / spacing))
              for first, last in zip(nodes, nodes[1:])]
    arc = np.concatenate(pieces)
    lateral, height, angle, _ = profile.at(arc)
    points = np.array([lateral, height])
    closed = points.copy()
    for begin in np.cumsum([len(piece) for piece in pieces])[:-1]:
        step = points[:, begin] - points[:, begin - 1]
        if np.hypot(*step) > 1e-6:
            t = np.clip(1 - abs(arc - arc[begin]) / STEP_CLOSED_OVER, 0, 1)
            closed += np.outer(0.5 * step, np.where(arc < arc[begin], t * t * (3 - 2 * t), 0))
            closed -= np.outer(0.5 * step, np.where(arc < arc[begin], 0, t * t * (3 - 2 * t)))
    return closed[0], closed[1], angle


@dataclass
class Rail:
    """Points of the inclined and placed section."""

    y: Array
    z: Array
    angle: Array

    @staticmethod
    def placed(profile: Any, cant: float, gauge: float, gauge_height: float) -> Rail:
        """Highest point at z = 0, gauge face at gauge / 2 where it first falls below its height."""
        lateral, height, angle = profile_points(profile)
        y = lateral * np.cos(cant) - height * np.sin(cant)
        z = lateral * np.sin(cant) + height * np.cos(cant)
        top = int(np.argmax(z))
        fall = angle[top] + cant  # the vertex between points, by a parabola
        near = slice(max(top - 2, 0), top + 3)
        rate = np.polyfit(y[near] - y[top], angle[near] + cant, 1)[0]
        z = z - (z[top] - 0.5 * fall * fall / rate)
        face = int(np.flatnonzero(z[:top] <= -gauge_height)[-1])
        graph = Graph(z[face - 3:face + 5], y[face - 3:face + 5],
                      1 / np.tan(angle[face - 3:face + 5] + cant))
        y = y + 0.5 * gauge - float(graph(np.array([-gauge_height]))[0][0])
        return Rail(y, z, angle + cant)


@dataclass
class Wheel:
    """A surface of revolution about an axle with its centre at (0, lateral, vertical)."""

    radius_at: Graph  # of the axle's coordinate
    lateral: float
    yaw: float
    roll: float
    vertical: float = 0.0

    @staticmethod
    def placed(profile: Any, radius: float, taping_line: float, lateral: float, yaw: float,
               roll: float) -> Wheel:
        s, w, angle = profile_points(profile)
        order = np.maximum.accumulate(s) <= s  # the part seen from the axle
        slope = np.tan(angle)
        use = order & (np.cos(angle) > 1e-3)
        return Wheel(Graph(taping_line + s[use], radius + w[use], slope[use]), lateral, yaw, roll)

    def distance(self, origin: Array, direction: Array, first: Array) -> tuple[Array, Array]:
        """g where origin + g direction meets the wheel, from a first guess, and its outward normal
        n / (n . direction); not-a-number where they do not meet."""
        cy, sy, cr, sr = np.cos(self.yaw), np.sin(self.yaw), np.cos(self.roll), np.sin(self.roll)
        turn = np.array([[cy, sy, 0], [-cr * sy, cr * cy, sr], [sr * sy, -sr * cy, cr]])
        centre = np.array([0.0, self.lateral, self.vertical])
        start, along = (origin - centre) @ turn.T, direction @ turn.T
        g = first
        for _ in range(30):
            point = start + g[..., None] * along
            radius, slope = self.radius_at(point[..., 1])
            out = np.hypot(point[..., 0], point[..., 2])
            normal = np.stack([point[..., 0] / out, -slope, point[..., 2] / out], -1)
            rate = np.sum(normal * along, -1)
            step = np.clip((radius - out) / rate, -5.0, 5.0)
            g = g + step
            if np.max(abs(step)) < 1e-11:
                break
        return np.where(abs(step) < 1e-9, g, np.nan), normal @ turn / rate[..., None]


def library_figures(keys: dict[str, Any], accuracy_of: str, accuracy: float,
                    curved: str = "no") -> tuple[Any, Any]:
    import wrcontact

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wrcontact.ContactWarning)
        result = wrcontact.solve(**keys, side="left", accuracy_of=accuracy_of, accuracy=accuracy,
                                 poisson=POISSON, youngs_modulus=YOUNG, curved=curved)
        return result, result.left
