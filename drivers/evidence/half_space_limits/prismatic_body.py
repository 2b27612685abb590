"""Influence coefficients of a prismatic elastic body by finite elements, one wave number along it at a time.

The body has the cross-section Omega in the (y, z) plane and is infinite along x. Loads and displacements are
    u = (U sin kx, V cos kx, W cos kx),   U, V, W functions of y and z,
so that each wave number k needs one plane problem (semi-analytic finite elements):
    (K0 + k K1 + k^2 K2) (U, V, W) = f,
with quadratic triangles, curved along the boundary. A strip is a piece of the boundary, as wide as a few elements, which a uniform pressure
presses inwards along the local normals; its displacement is the mean inward one. With the force of 1 N/mm of
strip I, B(k; I, J) is the displacement of J. A unit force at x = 0, spread over strip I, then displaces J at x by
    B(x; I, J) = 1/pi int_0^inf B(k; I, J) cos(kx) dk.
The half-space has A(k; s) = 2/(pi E*) K0(k s) at the distance s from a line, and A(x; s) = 1/(pi E* r), E* = E/(1 - nu^2).

Displacements are relative to the mean rigid motion of a part of the section (a rail's head, a wheel's rim) at x = 0, least squares over
its area: how rail and wheel move and turn as beams belongs to the model of track and vehicle.

A quarter-space with nu = 1/2 and a force P on its edge, along one of its faces, has Kelvin's displacements of a point force F, whose stress is
radial and leaves both faces free: M F = (0, P), M = 3/(4 pi) int n n dOmega over the quarter sphere, with 1/4 on its diagonal and 1/(2 pi)
beside it. At a distance c across the edge, u = F_z/(8 pi G c) = 2 pi^2/(pi^2 - 4) = 3.363 times the half-space's.

Units mm, N, MPa. Not covered: curvature along x (a wheel's radius), friction, plasticity, lengths of body that end.
"""
from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.interpolate import CubicSpline
from scipy.sparse import coo_matrix, csc_matrix
from scipy.sparse.linalg import splu
from scipy.spatial import Delaunay, cKDTree
from scipy.special import k0

Array = np.ndarray[Any, np.dtype[Any]]

YOUNG, POISSON = 210e3, 0.3
COARSER_PER_MM = 0.15  # growth of the elements with the distance from the strips
SMALLEST_K, LARGEST_K = 1e-3, 8.0  # 1/mm: below, the body's displacements are constant; above, local to a strip (faded from the half on)
SMOOTHING_STEPS = 2
# Degree 4 on triangles (Dunavant 1985).
TRIANGLE = [(0.445948490915965, 0.223381589678011), (0.091576213509771, 0.109951743655322)]


def gauss(count: int) -> tuple[Array, Array]:
    points, weights = np.polynomial.legendre.leggauss(count)  # type: ignore[no-untyped-call]
    return points, weights


@dataclass
class Section:
    """Closed outline, anticlockwise, as a dense polygon that begins at a corner.

    `strips`: arc lengths where the strips begin and end; `clamped`, `part`: whether points are held, and whether
    they belong to the part whose mean rigid motion is subtracted."""

    outline: Array
    corners: Array  # indices of the outline that nodes must keep
    strips: Array
    clamped: Callable[[Array], Array]
    part: Callable[[Array], Array]
    coarsest: float = 8.0

    def __post_init__(self) -> None:
        closed = np.vstack([self.outline, self.outline[:1]])
        self.arc = np.concatenate([[0.0], np.cumsum(np.hypot(*np.diff(closed, axis=0).T))])
        self.closed = closed

    def at(self, arc: Array) -> Array:
        return np.stack([np.interp(arc, self.arc, self.closed[:, i]) for i in (0, 1)], -1)

    def size(self, points: Array, finest: float, near: cKDTree) -> Array:
        return np.asarray(np.minimum(finest + COARSER_PER_MM * near.query(points)[0], self.coarsest))


def inside(points: Array, polygon: Array) -> Array:
    """Even number of crossings: outside."""
    a, b = polygon, np.roll(polygon, -1, axis=0)
    result = np.zeros(len(points), bool)
    for first in range(0, len(points), 4000):
        y, z = points[first:first + 4000, :1], points[first:first + 4000, 1:]
        crosses = (a[:, 1] > z) != (b[:, 1] > z)
        with np.errstate(divide="ignore", invalid="ignore"):
            where = a[:, 0] + (z - a[:, 1]) / (b[:, 1] - a[:, 1]) * (b[:, 0] - a[:, 0])
        result[first:first + 4000] = np.sum(crosses & (y < where), axis=1) % 2 == 1
    return result


class Mesh:
    """Quadratic triangles whose edges along each strip have equal lengths."""

    def __init__(self, section: Section, edges_per_strip: int) -> None:
        self.section = section
        widths = np.diff(section.strips)
        finest = float(np.min(widths)) / edges_per_strip
        near = cKDTree(section.at(np.linspace(section.strips[0], section.strips[-1], 4000)))
        arcs = self._boundary_arcs(finest, near, edges_per_strip)
        boundary = section.at(arcs)
        points = self._smoothed(boundary, self._interior(boundary, finest, near))
        triangles = self._triangles(points, len(boundary))
        self._add_middles(points, triangles, arcs)

    def _boundary_arcs(self, finest: float, near: cKDTree, edges_per_strip: int) -> Array:
        section, length = self.section, self.section.arc[-1]
        begin, end = section.strips[0], section.strips[-1]
        inner = [a + (b - a) * np.arange(edges_per_strip) / edges_per_strip
                 for a, b in zip(section.strips, section.strips[1:])]
        corners = section.arc[section.corners]
        breaks = [0.0, *corners[(corners > 0) & (corners < begin - 1e-9)], begin, end,
                  *corners[corners > end + 1e-9], length]
        result = []
        for a, b in zip(breaks, breaks[1:]):
            if b - a < 1e-9:
                continue
            if a == begin:
                result.append(np.concatenate(inner))
                continue
            s = np.linspace(a, b, 2000)
            count = np.concatenate([[0.0], np.cumsum(np.diff(s) / section.size(
                section.at(0.5 * (s[1:] + s[:-1])), finest, near))])
            number = int(np.ceil(count[-1]))
            result.append(np.interp(np.arange(number) * count[-1] / number, count, s))
        return np.asarray(np.concatenate(result))

    def _interior(self, boundary: Array, finest: float, near: cKDTree) -> Array:
        """Hexagonal lattices of growing size, where the sizes of elements are theirs."""
        section, kept, spacing = self.section, [boundary], finest
        while spacing < 1.25 * section.coarsest:
            reach = (1.25 * spacing - finest) / COARSER_PER_MM if 1.25 * spacing <= section.coarsest else np.inf
            low = np.maximum(boundary.min(0), near.mins - reach)
            high = np.minimum(boundary.max(0), near.maxes + reach)
            y, z = np.meshgrid(np.arange(low[0], high[0], spacing),
                               np.arange(low[1], high[1], spacing * np.sqrt(0.75)))
            y = y + 0.5 * spacing * (np.arange(len(y)) % 2)[:, None]
            points = np.stack([y.ravel(), z.ravel()], -1)
            size = section.size(points, finest, near)
            points = points[(size >= spacing) & (size < 1.25 * spacing)]
            points = points[inside(points, boundary)]
            distance = cKDTree(np.concatenate(kept)).query(points)[0]
            kept.append(points[distance > 0.75 * spacing])
            spacing *= 1.25
        return np.asarray(np.concatenate(kept[1:]))

    @staticmethod
    def _triangles(points: Array, boundary: int) -> Array:
        triangles = Delaunay(points).simplices
        corner = points[triangles]
        one, other = corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0]
        area = 0.5 * (one[:, 0] * other[:, 1] - one[:, 1] * other[:, 0])
        longest = np.max(np.sum((corner - np.roll(corner, 1, axis=1))**2, -1), -1)
        triangles = np.where(area[:, None] > 0, triangles, triangles[:, ::-1])
        keep = (abs(area) > 1e-3 * longest) & inside(corner.mean(1), points[:boundary])
        return np.asarray(triangles[keep])

    def _smoothed(self, boundary: Array, interior: Array) -> Array:
        """Each node moved to the mean of its neighbours, several times."""
        points = np.concatenate([boundary, interior])
        for _ in range(SMOOTHING_STEPS):
            t = self._triangles(points, len(boundary))
            i, j = t[:, [0, 1, 2, 1, 2, 0]].ravel(), t[:, [1, 2, 0, 0, 1, 2]].ravel()
            total = np.stack([np.bincount(i, points[j, a], len(points)) for a in (0, 1)], -1)
            count = np.bincount(i, minlength=len(points))
            if np.min(count) == 0:
                raise ValueError("a node belongs to no triangle")
            points[len(boundary):] = (total / count[:, None])[len(boundary):]
        return np.asarray(points)

    def _add_middles(self, points: Array, triangles: Array, arcs: Array) -> None:
        count, boundary = len(points), len(arcs)
        ends = np.sort(triangles[:, [[0, 1], [1, 2], [2, 0]]], axis=-1).reshape(-1, 2)
        edges, which = np.unique(ends, axis=0, return_inverse=True)
        middles = points[edges].mean(1)
        number = {(int(a), int(b)): i for i, (a, b) in enumerate(edges)}
        following = np.append(arcs[1:], self.section.arc[-1])
        self.boundary_edges = np.empty((boundary, 3), int)
        for i in range(boundary):
            j = (i + 1) % boundary
            edge = number.get((min(i, j), max(i, j)))
            if edge is None:
                raise ValueError(f"the mesh leaves the outline near {points[i]}")
            middles[edge] = self.section.at(np.array([0.5 * (arcs[i] + following[i])]))[0]
            self.boundary_edges[i] = i, j, count + edge
        self.points = np.concatenate([points, middles])
        self.elements = np.hstack([triangles, count + which.reshape(-1, 3)])
        strips = self.section.strips
        place = 0.5 * (arcs + following)
        self.strip_of_edge = np.where((place > strips[0]) & (place < strips[-1]),
                                      np.searchsorted(strips, place) - 1, -1)


def shape_functions(r: float, s: float) -> tuple[Array, Array]:
    """Values, and derivatives by r and s, of the six nodes."""
    t = 1 - r - s
    values = np.array([t * (2 * t - 1), r * (2 * r - 1), s * (2 * s - 1), 4 * r * t, 4 * r * s, 4 * s * t])
    return values, np.array([[1 - 4 * t, 4 * r - 1, 0, 4 * (t - r), 4 * s, -4 * s],
                             [1 - 4 * t, 0, 4 * s - 1, -4 * r, 4 * r, 4 * (t - s)]])


class Body:
    """The three matrices of a mesh, its strips, and what they displace."""

    def __init__(self, section: Section, edges_per_strip: int = 2, poisson: float = POISSON) -> None:
        self.section, self.mesh = section, Mesh(section, edges_per_strip)
        points, elements = self.mesh.points, self.mesh.elements
        nodes = points[elements]
        shear = YOUNG / (2 * (1 + poisson))
        stiffness = np.diag([2 * shear] * 3 + [shear] * 3)
        stiffness[:3, :3] += 2 * shear * poisson / (1 - 2 * poisson)
        self.modulus = YOUNG / (1 - poisson**2)
        parts = np.zeros((3, len(elements), 18, 18))
        moments = np.zeros((3, 3 * len(points)))  # mean V, mean W, turn
        chosen = section.part(nodes[:, :3].mean(1))
        rules = [(p, w) for a, w in TRIANGLE for p in ((a, a), (1 - 2 * a, a), (a, 1 - 2 * a))]
        samples = []
        for (r, s), weight in rules:
            value, slopes = shape_functions(r, s)
            jacobian = np.einsum("ij,ejk->eik", slopes, nodes)
            area = 0.5 * weight * np.linalg.det(jacobian)
            if np.min(area) <= 0:
                raise ValueError("an element is folded")
            gradient = np.linalg.solve(jacobian, np.broadcast_to(slopes, (len(nodes), 2, 6)))
            fixed, by_k = np.zeros((2, len(elements), 6, 18))
            fixed[:, 1, 1::3] = fixed[:, 3, 2::3] = fixed[:, 4, 0::3] = gradient[:, 0]
            fixed[:, 2, 2::3] = fixed[:, 3, 1::3] = fixed[:, 5, 0::3] = gradient[:, 1]
            by_k[:, 0, 0::3] = value
            by_k[:, 4, 1::3] = by_k[:, 5, 2::3] = -value
            stress = [area[:, None, None] * (stiffness @ b) for b in (fixed, by_k)]
            turned = fixed.transpose(0, 2, 1), by_k.transpose(0, 2, 1)
            parts[0] += turned[0] @ stress[0]
            parts[1] += turned[0] @ stress[1] + turned[1] @ stress[0]
            parts[2] += turned[1] @ stress[1]
            samples.append((value, area * chosen, np.einsum("i,eij->ej", value, nodes)))
        dofs = (3 * elements[:, :, None] + np.arange(3)).reshape(len(elements), 18)
        rows, columns = np.repeat(dofs, 18, axis=1).ravel(), np.tile(dofs, (1, 18)).ravel()
        free = np.repeat(~section.clamped(points), 3)
        self.free = np.flatnonzero(free)
        self.matrices = [csc_matrix(coo_matrix((part.ravel(), (rows, columns))))[self.free][:, self.free]
                         for part in parts]
        total = sum(np.sum(area) for _, area, _ in samples)
        centre = sum(area @ place for _, area, place in samples) / total
        polar = sum(area @ np.sum((place - centre)**2, 1) for _, area, place in samples)
        for value, area, place in samples:
            y, z = (place - centre).T
            for node in range(6):
                at, amount = 3 * elements[:, node], value[node] * area
                np.add.at(moments[0], at + 1, amount / total)
                np.add.at(moments[1], at + 2, amount / total)
                np.add.at(moments[2], at + 2, amount * y / polar)
                np.add.at(moments[2], at + 1, -amount * z / polar)
        self.moments, self.part_area = moments[:, self.free], total
        modes = np.zeros((3 * len(points), 3))
        modes[1::3, 0] = modes[2::3, 1] = 1
        modes[1::3, 2], modes[2::3, 2] = -(points - centre)[:, 1], (points - centre)[:, 0]
        loads = self._loads()
        self.loads, self.modes, self.rigid = loads[self.free], modes[self.free], loads.T @ modes

    def _loads(self) -> Array:
        """Nodal forces of 1 N/mm on each strip, inwards."""
        mesh, strips = self.mesh, self.section.strips
        loads = np.zeros((3 * len(mesh.points), len(strips) - 1))
        widths = np.zeros(len(strips) - 1)
        for t, weight in zip(*gauss(3)):
            value = np.array([0.5 * t * (t - 1), 0.5 * t * (t + 1), 1 - t * t])
            slope = np.array([t - 0.5, t + 0.5, -2 * t])
            for edge, strip in zip(mesh.boundary_edges, mesh.strip_of_edge):
                if strip >= 0:
                    tangent = slope @ mesh.points[edge]
                    loads[3 * edge + 1, strip] -= weight * value * tangent[1]
                    loads[3 * edge + 2, strip] += weight * value * tangent[0]
                    widths[strip] += weight * np.hypot(*tangent)
        return np.asarray(loads / widths)

    def solve(self, wave_numbers: Array) -> None:
        """B(k; I, J), and the part of it that is the mean rigid motion of the section's part."""
        self.wave_numbers, whole, rigid = wave_numbers, [], []
        for k in wave_numbers:
            matrix = self.matrices[0] + k * self.matrices[1] + k * k * self.matrices[2]
            found = splu(matrix, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0,
                         options={"SymmetricMode": True}).solve(self.loads)
            whole.append(found.T @ self.loads)
            rigid.append((self.rigid @ (self.moments @ found)).T)
        self.whole, self.motion = np.array(whole), np.array(rigid)

    def correct(self, flat: Body) -> None:
        """Subtracts the error that the same elements have on a half-space next to a strip: that of its middle strip."""
        middle = flat.loads.shape[1] // 2
        error = (flat.whole - flat.half_space(flat.wave_numbers, "A"))[:, middle, middle:]
        strip = np.arange(self.loads.shape[1])
        lag = abs(np.subtract.outer(strip, strip))
        near = lag < error.shape[1]
        self.whole[:, near] -= error[:, lag[near]]

    def angles(self) -> Array:
        """Inclination of each strip's surface."""
        middle = 0.5 * (self.section.strips[1:] + self.section.strips[:-1])
        ends = self.section.at(np.stack([middle - 0.05, middle + 0.05]))
        return np.asarray(np.arctan2(*(ends[0] - ends[1]).T[::-1]))  # the outline runs from right to left along the top

    def influence(self, x: Array, *, relative: bool = True, less: str = "", window: float = 0.0) -> Array:
        """B(x; I, J) for each x, `less` "A" or "curved": without the half-space's or the curved operator's.
        `window`: x is averaged over this length."""
        k = np.concatenate([np.geomspace(1e-7, 0.05, 300)[:-1], np.arange(0.05, LARGEST_K, 0.01)])
        known = np.log(self.wave_numbers)
        place = np.clip(np.log(k), known[0], None)
        values = CubicSpline(known, self.whole)(place)
        if less:
            values = values - self.half_space(k, less)
        spacing = np.gradient(k)
        spacing[[0, -1]] = 0.5 * np.diff(k)[[0, -1]]
        fading = np.cos(0.5 * np.pi * np.clip(2 * k / LARGEST_K - 1, 0, 1))**2
        kernel = np.cos(np.outer(x, k)) * np.sinc(k * window / (2 * np.pi)) * fading * spacing / np.pi
        found = np.asarray(np.einsum("xk,kij->xij", kernel, values))
        if relative:
            found -= np.einsum("k,kij->ij", spacing * fading / np.pi, CubicSpline(known, self.motion)(place))
        return found

    def half_space(self, k: Array, kind: str) -> Array:
        """A(k; I, J), times the cosine of the angles between for "curved"."""
        distance = self.section.strips
        widths = np.diff(distance)
        if np.ptp(widths) > 1e-9:
            raise ValueError("strips must be equally wide")
        lags = np.arange(len(widths)) * widths[0]
        points, weights = gauss(8)
        t = 0.5 * (1 + points)
        result = np.zeros((len(k), len(lags)))
        for one, weight in zip(t**3, 1.5 * weights * t**2):  # towards the singularity of s = s'
            # Mean over two strips: triangular weight of the difference v from -1 to 1.
            for v in (one, -one):
                result += weight * (1 - one) * k0(np.outer(k, abs(lags + v * widths[0])))
        lag = abs(np.subtract.outer(np.arange(len(lags)), np.arange(len(lags))))
        full = 2 / (np.pi * self.modulus) * result[:, lag]
        if kind == "curved":
            full = full * np.cos(np.subtract.outer(self.angles(), self.angles()))
        return np.asarray(full)
