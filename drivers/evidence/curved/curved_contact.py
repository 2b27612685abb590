"""Frictionless contact of a wheel and a rail along a curve, independent of the library's solver.

The library solves each contact in a plane. Here contact lies along the mean curve m(s) of both
sections, with the unit normal n(s) at the angle a(s), and the track's x axis:
  h = g_wheel - g_rail      distances where the ray m + x e_x + g n meets wheel and rail (Newton)
  h + u >= 0, p >= 0, p (h + u) = 0,   u = C K C p + S K S p,   C = cos a, S = sin a,
with K the displacements of a half-space under pressures that are constant on rectangles (Love),
where distances count along the arc, so that normals that differ by an angle interact by its cosine
(Blanco-Lorenzo et al., 2016). K is a convolution, so u = Re(exp(-i a) K (exp(i a) p)) takes one
transform. Constant pressures enter with -1/24 of their second differences, which makes p the values
at the centres. Conjugate gradients over p >= 0 (Polonsky & Keer, 1999, at a given position).
The force is the derivative of the elastic energy, sum of p dA dh/dq: an element pushes the wheel
with p dA n_b / (n . n_b), n_b the normal of a body. The sum with the rail's normals is the force,
that with the wheel's shows what elements leave.

Units mm, N, MPa, rad; track frame x forward, y left, z up; left wheel. Taken from the library:
profiles as points with tangents, and where to look. Not covered: friction, unlike bodies, bodies
that are not half-spaces, and a wheel
so steep under yaw that rays meet it twice. Needs numpy; no state, no threads.
"""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

Array = Any
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


def influence(rows: int, columns: int, height: float, length: float, modulus: float) -> Array:
    """Spectrum of K on a grid of twice the size: Love's rectangles, smooth between their centres."""
    y = height * (np.arange(-rows - 1, rows + 2) - 0.5)[:, None]
    x = length * (np.arange(-columns - 1, columns + 2) - 0.5)[None, :]
    corner = x * np.arcsinh(y / abs(x)) + y * np.arcsinh(x / abs(y))
    cell = np.diff(np.diff(corner, axis=0), axis=1) / (np.pi * modulus)
    middle = cell[1:-1, 1:-1]
    smooth = middle - (cell[2:, 1:-1] + cell[:-2, 1:-1] + cell[1:-1, 2:] + cell[1:-1, :-2]
                       - 4 * middle) / 24
    return np.fft.fft2(np.fft.ifftshift(smooth))


class Contact:
    """One contact on one curve with its grid; `solve` gives pressures for a height of the wheel."""

    def __init__(self, rail: Rail, wheel: Wheel, origin: Array, angle: float,
                 reach: tuple[float, float], shape: tuple[int, int], modulus: float, *,
                 share_of_rail: float = 0.5, plane: tuple[Array, Array] | None = None) -> None:
        """The curve is a function over the line at `angle` through `origin`, looked for between
        the two places `reach` on it. `share_of_rail`: 1 and 0 put it on one of the bodies. `plane`:
        that line itself instead, with elements at these places across and along the rail."""
        self.wheel, self.origin = wheel, np.asarray(origin)
        self.lateral = np.array([0.0, np.cos(angle), np.sin(angle)])
        self.normal = np.array([0.0, -np.sin(angle), np.cos(angle)])
        self.share_of_rail = share_of_rail
        place = np.stack([0 * rail.y, rail.y, rail.z], -1) - self.origin
        u, v, turned = place @ self.lateral, place @ self.normal, rail.angle - angle
        # The stretch of the rail that is a function over the line, around the place next to it.
        hidden = np.flatnonzero(np.cos(turned) < 0.05)
        nearest = int(np.argmin(np.hypot(u, v)))
        part = slice(int(max(hidden[hidden < nearest], default=-1)) + 1,
                     int(min(hidden[hidden > nearest], default=len(u))))
        self.rail = Graph(u[part], v[part], np.tan(turned[part]))
        if plane is None:
            u, v, slope = self._mean_curve(reach, shape)
        else:
            u, self.x = plane
            v, slope = 0 * u, 0 * u
            self.height, self.length = u[1] - u[0], self.x[1] - self.x[0]
        turned = np.arctan(slope)
        self.turning = np.exp(1j * turned)[:, None]
        self.rays = np.outer(np.cos(turned), self.normal) - np.outer(np.sin(turned), self.lateral)
        self.start = self.origin + np.outer(u, self.lateral) + np.outer(v, self.normal)
        self._meet_rail(self.rail(u)[0] - v)
        self.spectrum = influence(len(u), len(self.x), self.height, self.length, modulus)
        self.pressure = np.zeros((len(u), len(self.x)))

    def _section(self, u: Array, x: float) -> tuple[Array, Array]:
        """The curve's height above the line, and its slope."""
        rail, rail_slope = self.rail(u)
        start = self.origin + np.outer(u, self.lateral) + np.array([x, 0.0, 0.0])
        wheel, normal = self.wheel.distance(start, np.broadcast_to(self.normal, start.shape), rail)
        w = self.share_of_rail
        return w * rail + (1 - w) * wheel, w * rail_slope - (1 - w) * (normal @ self.lateral)

    def _mean_curve(self, reach: tuple[float, float], shape: tuple[int, int]) -> tuple[Array, Array, Array]:
        """Rows of equal arc length over the overlap of the bodies, and columns."""
        rows, columns = shape
        u, x = np.linspace(*reach, 201), np.linspace(-40.0, 40.0, 161)
        start = self.origin + u[:, None, None] * self.lateral + x[:, None] * np.array([1.0, 0, 0])
        rail = np.broadcast_to(self.rail(u)[0][:, None], start.shape[:2])
        wheel, _ = self.wheel.distance(start, np.broadcast_to(self.normal, start.shape), rail)
        lines, places = np.nonzero(wheel < rail)
        if not len(lines):
            raise ValueError("no overlap")
        first, last = x[places.min()] - 0.5, x[places.max()] + 0.5
        self.length = (last - first) / columns
        self.x = first + self.length * (np.arange(columns) + 0.5)
        u = np.linspace(u[max(lines.min() - 1, 0)], u[min(lines.max() + 1, 200)], 4001)
        _, slope = self._section(u, 0.5 * (first + last))
        stretch = np.hypot(1, slope)
        arc = np.cumsum(np.diff(u) * 0.5 * (stretch[1:] + stretch[:-1]))
        self.height = arc[-1] / rows
        u = np.interp(self.height * (np.arange(rows) + 0.5), arc, u[1:])
        return u, *self._section(u, 0.5 * (first + last))

    def _meet_rail(self, g: Array) -> None:
        """The rail is prismatic: its distance along the rays is the same for a whole row."""
        for _ in range(30):
            place = self.start + g[:, None] * self.rays - self.origin
            value, slope = self.rail(place @ self.lateral)
            normal = self.normal - slope[:, None] * self.lateral
            step = (value - place @ self.normal) / np.sum(normal * self.rays, -1)
            g = g + step
        self.on_rail = place + self.origin
        if np.max(abs(step)) > 1e-9 or np.min(np.diff(place @ self.lateral)) <= 0:
            raise ValueError("rays cross or do not meet the rail")
        self.to_rail = g
        self.rail_push = normal / np.sum(normal * self.rays, -1)[:, None]

    def displacement(self, pressure: Array) -> Array:
        rows, columns = pressure.shape
        wide = np.fft.ifft2(self.spectrum * np.fft.fft2(self.turning * pressure,
                                                        (2 * rows, 2 * columns)))
        return np.real(np.conj(self.turning) * wide[:rows, :columns])

    def solve(self, vertical: float, tolerance: float = 1e-7) -> None:
        """Distances and pressures with the wheel's centre at the height `vertical`."""
        self.wheel.vertical = vertical
        start = self.start[:, None, :] + self.x[:, None] * np.array([1.0, 0.0, 0.0])
        rays = np.broadcast_to(self.rays[:, None, :], start.shape)
        rail = np.broadcast_to(self.to_rail[:, None], start.shape[:2])
        to_wheel, self.wheel_push = self.wheel.distance(start, rays, rail)
        if not np.all(np.isfinite(to_wheel)):
            raise ValueError("rays do not meet the wheel")
        self.gap = to_wheel - self.to_rail[:, None]
        self.solve_gap(tolerance)

    def solve_gap(self, tolerance: float) -> None:
        """Pressures, starting from those before, until no element overlaps by more than this
        share of the deepest overlap."""
        p = self.pressure
        residual = self.gap + self.displacement(p)
        scale = -np.min(self.gap)
        direction, before = np.zeros_like(p), 0.0
        for _ in range(2000):
            active = (p > 0) | (residual < 0)
            if np.max(abs(residual[active]), initial=0.0) < tolerance * scale:
                break
            contact = p > 0 if np.any(p > 0) else active
            now = float(np.sum(residual[contact] ** 2))
            direction = np.where(contact, -residual + (now / before if before else 0) * direction, 0)
            moved = self.displacement(direction)
            step = now / float(np.sum(direction * moved))
            p = p + step * direction
            fallen = p < 0
            p = np.maximum(p, 0.0)
            residual = residual + step * moved if not np.any(fallen) else (
                self.gap + self.displacement(p))
            new = (p == 0) & (residual < 0) & ~fallen
            before = now
            if np.any(new | fallen):
                p = np.where(new, -step * residual, p)
                if np.any(new):
                    residual = self.gap + self.displacement(p)
                before = 0.0
        else:
            raise ValueError("pressures have not converged")
        self.pressure = p

    def row_forces(self, pushed: str = "both") -> Array:
        """On the wheel, of each row: with the normals of one body, or the mean of both."""
        load = self.pressure * self.height * self.length
        rail = np.sum(load, 1)[:, None] * self.rail_push
        wheel = np.einsum("ij,ijk->ik", load, self.wheel_push)
        return {"rail": rail, "wheel": wheel, "both": 0.5 * (rail + wheel)}[pushed]

    def force(self, pushed: str = "both") -> Array:
        return np.sum(self.row_forces(pushed), 0)

    def energy(self) -> float:
        return float(-0.5 * self.height * self.length * np.sum(self.pressure * self.gap))


def solve_for_load(contacts: list[Contact], load: float, vertical: float, depth: float) -> float:
    """The height of the wheelset's centre at which the contacts carry the vertical load."""
    def missing(height: float) -> float:
        for contact in contacts:
            contact.solve(height)
        return float(sum(float(contact.force()[2]) for contact in contacts) - load)

    first, error = vertical, missing(vertical)
    slope = -1.5 * load / depth
    for _ in range(20):
        second = first - error / slope
        if abs(error) < 1e-7 * load:
            return first
        error_there = missing(second)
        slope = (error_there - error) / (second - first)
        first, error = second, error_there
    raise ValueError("no height found for the load")
