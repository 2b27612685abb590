"""Structured hexahedra for a rail head and a wheel rim that touch: fine and with matching nodes where they do.

Half of each body, x >= 0. The rail head ends in a plane 51 mm below its top, the rim 62 mm inside of the running circle; both planes are
clamped or moved, and u_x = 0 on the ends x = 0 and x = LENGTH. Every node of a surface lies on the profile of the library
(profile_surfaces.py has it as cubic pieces). In the fine zone the wheel's nodes lie on the normals of the rail's nodes, so that facets
are parallel and the distance of both surfaces has no facets to first order. Lines of nodes leave the surface along its normal and end on
the plane: Bezier curves.

Track frame: x forward, y left, z up; left wheel; mm.
"""
from __future__ import annotations

import sys
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).resolve().parent))
from profile_surfaces import Graph, Rail, Wheel  # noqa: E402

Array = Any
HEAD_DEPTH, RIM_DEPTH = 51.0, 62.0  # mm: fishing plane of 60E1 (EN 13674-1), assumed rim, as in half_space_limits/sections.py
LENGTH = 80.0  # mm: half of the blocks along the rail
RATIO = 3  # of the elements next to the core to those of the core


@dataclass(frozen=True)
class Sizes:
    """Of elements in the core, mm: along the rail, into the depth; and how fast they grow outside, and up to which size."""

    along: float
    depth: float
    growth: float
    largest: float


@dataclass
class Body:
    """nodes[i, j, k]: i across, from the field side to the gauge side; j along the rail; k from the surface inwards. All of them are
    used in the core `fine`; outside of it those that lie on every RATIO-th line of the core."""

    nodes: Array
    fine: tuple[slice, slice, slice]
    number: Array = field(init=False)  # of the nodes that are used, else -1
    points: Array = field(init=False)
    elements: Array = field(init=False)  # in the order of CalculiX, nodes 5 to 8 outside
    surface: dict[tuple[int, int], int] = field(init=False)  # elements of the core on the surface, by i and j from the core's corner
    hanging: list[tuple[int, list[int], list[float]]] = field(init=False)  # node, its masters, their weights

    def __post_init__(self) -> None:
        lines = [np.concatenate([np.arange(zone.start), np.arange(zone.start, zone.stop, RATIO), np.arange(zone.stop, n)])
                 for zone, n in zip(self.fine, self.nodes.shape[:3])]
        core = tuple(np.arange(n)[zone] for zone, n in zip(self.fine, self.nodes.shape[:3]))
        used = np.zeros(self.nodes.shape[:3], bool)
        used[np.ix_(*lines)] = True
        used[np.ix_(*core)] = True
        self.number = np.where(used, np.cumsum(used).reshape(used.shape) - 1, -1)
        self.points = self.nodes[used]
        fine = self._hexahedra(core)
        self.surface = {(int(i), int(j)): e for e, (i, j, k) in enumerate(np.ndindex(*(len(c) - 1 for c in core))) if k == 0}
        coarse = self._hexahedra(lines)
        begin = np.stack(np.meshgrid(*(line[:-1] for line in lines), indexing="ij"), -1).reshape(-1, 3)
        inside = np.all([(begin[:, a] >= c[0]) & (begin[:, a] < c[-1]) for a, c in enumerate(core)], axis=0)
        self.elements = np.concatenate([fine, coarse[~inside]])
        self._hang(lines, core)

    def _hexahedra(self, lines: Any) -> Array:
        number = self.number[np.ix_(*lines)]
        a, b, c = number.shape
        corners = [number[i:a - 1 + i, j:b - 1 + j, k:c - 1 + k]
                   for i, j, k in ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1), (0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))]
        found = np.stack(corners, -1).reshape(-1, 8)
        edge = self.points[found[0]]
        if np.dot(edge[4] - edge[0], np.cross(edge[1] - edge[0], edge[3] - edge[0])) < 0:
            found = found[:, [3, 2, 1, 0, 7, 6, 5, 4]]
        return found

    def _hang(self, lines: Any, core: Any) -> None:
        """Nodes on the core's boundary that the elements outside do not have: bilinear between those that they have."""
        self.hanging = []
        ends = [[c[i] for i in (0, -1) if 0 < c[i] < n - 1] for c, n in zip(core, self.nodes.shape[:3])]
        for place in np.stack(np.meshgrid(*core, indexing="ij"), -1).reshape(-1, 3):
            if not any(place[a] in ends[a] for a in range(3)):
                continue
            choices = []
            for a in range(3):
                after = int(np.searchsorted(lines[a], place[a]))
                if lines[a][after] == place[a]:
                    choices.append([(int(place[a]), 1.0)])
                else:
                    one, other = int(lines[a][after - 1]), int(lines[a][after])
                    share = (place[a] - one) / (other - one)
                    choices.append([(one, 1 - share), (other, share)])
            if all(len(choice) == 1 for choice in choices):
                continue
            masters = [(int(self.number[i, j, k]), u * v * w) for i, u in choices[0] for j, v in choices[1] for k, w in choices[2]]
            self.hanging.append((int(self.number[tuple(place)]), [m for m, _ in masters], [float(w) for _, w in masters]))

    def worst_corner(self) -> float:
        """Smallest triple product of unit edges at a corner of an element; 1 for bricks, negative if one is folded."""
        points = self.points[self.elements]
        worst = np.inf
        for corner, others in enumerate(((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))):
            edges = points[:, others] - points[:, corner:corner + 1]
            edges = edges / np.linalg.norm(edges, axis=-1, keepdims=True)
            worst = min(worst, float(np.linalg.det(edges).min()))
        return worst


def graded(first: float, size: float, growth: float, largest: float, end: float) -> Array:
    """Places from `first` to `end` (either direction), steps growing from `size`; the last one is 0 or whole."""
    length, places = abs(end - first), [0.0]
    step = size
    while places[-1] < length:
        step = min(step * growth, largest)
        places.append(places[-1] + step)
    scaled = np.array(places) * length / places[-1]
    return np.asarray(first + np.sign(end - first) * scaled)


def zone_and_outside(zone: tuple[float, float], size: float, sizes: Sizes, ends: tuple[float, float]) -> tuple[Array, slice]:
    """Places over `ends` with steps of at most `size` in the zone, a multiple of RATIO of them, and the zone's slice."""
    count = RATIO * max(int(np.ceil((zone[1] - zone[0]) / size / RATIO - 0.2)), 1)
    middle = np.linspace(*zone, count + 1)
    outside = RATIO * size
    before = graded(zone[0], outside, sizes.growth, sizes.largest, ends[0])[:0:-1] if zone[0] > ends[0] else np.zeros(0)
    after = graded(zone[1], outside, sizes.growth, sizes.largest, ends[1])[1:] if zone[1] < ends[1] else np.zeros(0)
    return np.concatenate([before, middle, after]), slice(len(before), len(before) + count + 1)


def spread(surface: Array, inside: Array, control: Array, depths: Array) -> Array:
    """Nodes along Bezier curves from points of the surface by control points to points inside; `depths` count along the curve near
    the surface and are stretched further inside to its length."""
    t = np.linspace(0, 1, 161)[:, None, None]
    curve = (1 - t)**2 * surface + 2 * t * (1 - t) * control + t**2 * inside
    arc = np.concatenate([np.zeros((1, len(surface))),
                          np.cumsum(np.linalg.norm(np.diff(curve, axis=0), axis=-1), axis=0)])
    result = np.empty((len(surface), len(depths), surface.shape[-1]))
    for i in range(len(surface)):
        length = arc[-1, i]
        wanted = depths / (1 + depths * (1 / length - 1 / depths[-1]))  # the same near the surface, `length` at the end
        at = np.interp(wanted, arc[:, i], t[:, 0, 0])[:, None]
        result[i] = (1 - at)**2 * surface[i] + 2 * at * (1 - at) * control[i] + at**2 * inside[i]
    return result


def inner_places(widths: Array, first: float, last: float) -> Array:
    """Lateral places on the inner plane: steps that vary less than those of the surface."""
    steps = widths**0.45
    return np.asarray(first + (last - first) * np.append(0.0, np.cumsum(steps)) / np.sum(steps))


class Section:
    """A profile by its arc, from the field side to the gauge side."""

    def __init__(self, y: Array, z: Array, angle: Array) -> None:
        order = slice(None, None, -1) if y[0] < y[-1] else slice(None)
        self.points, self.angle = np.stack([y, z], -1)[order], angle[order]
        self.arc = np.append(0.0, np.cumsum(np.hypot(*np.diff(self.points, axis=0).T)))
        keep = np.append(True, np.diff(self.arc) > 1e-9)
        self.points, self.angle, self.arc = self.points[keep], self.angle[keep], self.arc[keep]
        self.graphs = [Graph(self.arc, self.points[:, 0], -np.cos(self.angle)), Graph(self.arc, self.points[:, 1], -np.sin(self.angle))]

    def at(self, arc: Array) -> Array:
        return np.stack([graph(arc)[0] for graph in self.graphs], -1)

    def angle_at(self, arc: Array) -> Array:
        return np.interp(arc, self.arc, self.angle)

    def arc_of(self, points: Array) -> Array:
        """Of the nearest points of the profile."""
        return np.array([self.arc[np.argmin(np.hypot(*(self.points - point).T))] for point in np.atleast_2d(points)])


Lines = tuple[Array, slice]  # places and the core's part of them


def rail_body(section: Section, core: Array, along: Lines, inwards_lines: Lines, sizes: Sizes, cant: float,
              reach: float) -> Body:
    """`core`: arcs of the core's lines along the rail."""
    (x, x_fine), (depths, deep) = along, inwards_lines
    before = graded(core[0], core[RATIO] - core[0], sizes.growth, sizes.largest, section.arc[0])[:0:-1]
    after = graded(core[-1], core[-1] - core[-1 - RATIO], sizes.growth, sizes.largest, section.arc[-1])[1:]
    arcs, fine = np.concatenate([before, core, after]), slice(len(before), len(before) + len(core))
    surface, angle = section.at(arcs), section.angle_at(arcs)
    inwards = np.stack([np.sin(angle), -np.cos(angle)], -1)
    across, down = np.array([np.cos(cant), np.sin(cant)]), np.array([np.sin(cant), -np.cos(cant)])
    top = section.points[np.argmax(section.points @ -down)]
    half = 0.5 * abs((section.points[0] - section.points[-1]) @ across) * 0.97
    middle = 0.5 * (section.points[0] + section.points[-1])
    middle = middle + down * (HEAD_DEPTH - (middle - top) @ down)
    inside = middle + np.outer(inner_places(np.diff(arcs), half, -half), across)
    control = surface + reach * inwards
    away = np.clip(np.maximum(arcs[fine][0] - arcs, arcs - arcs[fine][-1]) / 30.0, 0, 1)[:, None]
    side = 0.5 * (surface + inside)
    control = (1 - away) * control + away * side
    flat = spread(surface, inside, control, depths)
    nodes = np.empty((len(arcs), len(x), len(depths), 3))
    nodes[..., 0] = x[:, None]
    nodes[..., 1:] = flat[:, None]
    return Body(nodes, (fine, x_fine, deep))


def wheel_body(wheel: Wheel, rail: Section, rail_arcs: Array, along: Lines, inwards_lines: Lines, sizes: Sizes, reach: float,
               field_side: float) -> Body:
    """`wheel` placed at its height; `rail_arcs` of the fine zone."""
    (x, x_fine), (depths, deep) = along, inwards_lines
    cr, sr = np.cos(wheel.roll), np.sin(wheel.roll)
    turn = np.array([[1, 0, 0], [0, cr, sr], [0, -sr, cr]])
    centre = np.array([0.0, wheel.lateral, wheel.vertical])
    graph = wheel.radius_at
    tip = float(graph.place[np.argmax(graph.value)])
    surface, angle = rail.at(rail_arcs), rail.angle_at(rail_arcs)
    start = np.zeros((len(rail_arcs), len(x), 3))
    start[..., 0], start[..., 1:] = x, surface[:, None]
    rays = np.stack([0 * angle, -np.sin(angle), np.cos(angle)], -1)[:, None] * np.ones((1, len(x), 1))
    to_wheel, _ = wheel.distance(start, rays, 0.5 + x**2 / 900 * np.ones((len(rail_arcs), 1)))
    if not np.all(np.isfinite(to_wheel)):
        raise ValueError("normals of the rail do not meet the wheel")
    hit = start + to_wheel[..., None] * rays
    axle = (hit - centre) @ turn.T  # x, along the axle, up
    # Outside of the zone: equal fractions of the arc that is left, at every x.
    dense = np.linspace(tip, field_side, 8001)
    arc = np.append(0.0, np.cumsum(np.hypot(np.diff(dense), np.diff(graph(dense)[0]))))
    first, last = np.interp(axle[0, :, 1], dense, arc), np.interp(axle[-1, :, 1], dense, arc)
    outer = graded(0.0, rail_arcs[RATIO] - rail_arcs[0], sizes.growth, sizes.largest, arc[-1] - first[0])
    inner = graded(0.0, rail_arcs[-1] - rail_arcs[-1 - RATIO], sizes.growth, sizes.largest, last[0])
    before = np.interp(first + np.outer(outer[:0:-1] / outer[-1], arc[-1] - first), arc, dense)
    after = np.interp(last * (1 - (inner[1:] / inner[-1])[:, None]), arc, dense)
    place = np.concatenate([before, axle[..., 1], after])
    fine = slice(len(before), len(before) + len(rail_arcs))
    radius, slope = graph(place)
    height = -np.sqrt(radius**2 - x**2)
    height[fine] = axle[..., 2]
    tread = -float(graph(np.array([wheel_tread(graph)]))[0][0])
    back, plane = tip - 14.0, tread + RIM_DEPTH
    nodes = np.empty((*place.shape, len(depths), 3))
    widths = np.hypot(np.diff(place[:, 0]), np.diff(height[:, 0]))
    inside = np.stack([inner_places(widths, field_side, back), np.full(len(place), plane)], -1)
    # Where the lines of the flange's tip and of the field side bend to.
    ends = np.array([[field_side, plane - 0.5 * RIM_DEPTH], [back, max(tread - 10.0, height[-1, 0] + 5.0)]])
    for j in range(len(x)):
        points = np.stack([place[:, j], height[:, j]], -1)
        length = np.append(0.0, np.cumsum(np.hypot(*np.diff(points, axis=0).T)))
        normal = np.stack([slope[:, j], np.ones(len(place))], -1)
        normal /= np.linalg.norm(normal, axis=-1, keepdims=True)
        control = points + reach * normal
        for end, distance, total in ((0, length[fine][0] - length, length[fine][0]),
                                     (1, length - length[fine][-1], length[-1] - length[fine][-1])):
            weight = np.clip(distance / total, 0, 1)[:, None]
            control = (1 - weight) * control + weight * ends[end]
        nodes[:, j, :, 1:] = spread(points, inside, control, depths)
        nodes[:, j, :, 0] = x[j]
    return Body(nodes @ turn + centre, (fine, x_fine, deep))


def wheel_tread(graph: Graph) -> float:
    """Place along the axle 70 mm from the flange's back, by the flange's tip: only to find the running circle's height."""
    tip = float(graph.place[np.argmax(graph.value)])
    return tip + 56.0
