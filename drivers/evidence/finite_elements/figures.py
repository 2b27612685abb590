"""What finite elements and the library find in a contact, by the same measures.

Pressures are those of the nodes of the rail. `pmax`: the pressure of each row of nodes along the rail in x = 0 is the square root of a
line in x^2 through p^2, which is exact for an ellipse, by least squares over the inner 60 % of the row; a parabola through the three
highest of these gives the greatest one. The length of a row is four times the square root of its second moment about x = 0 over its
force, exact for an ellipse, the area the integral of the lengths across; their square falls to 0 linearly at the ends. Counting the
nodes under pressure instead gives 5 to 15 % too large an area (hertz.py), since those at the ends carry pressure for a part of their
elements only; the effect of yielding is nevertheless the ratio of two such counts on one mesh, since rows are no ellipses then.

Rigid motion: mean displacement and rotation of the section x = 0 of head and rim, as in half-space.md. Rail and wheel then lie as in a
scene whose wheelset is moved by the difference. The library solves this scene at the same force.
"""
from __future__ import annotations

import warnings
from typing import Any

import numpy as np
from scipy.interpolate import PchipInterpolator

from calculix import POISSON, YOUNG, Solution
from contact_mesh import RATIO, Body
from scenes import Blocks, Case, Scene, placed_wheel
from profile_surfaces import library_figures

Array = Any
DEEP = 10.0  # mm: the depth of the points whose approach is compared
YIELDED = 2e-4  # equivalent plastic strain from which steel counts as yielded
DEPTHS = (2.0, 3.0)  # mm, of the von Mises stress compared


def section_motion(body: Body, displacement: Array) -> tuple[Array, Array, float]:
    """Centre, mean displacement and mean rotation in the plane x = 0: (y, z), (y, z), rad."""
    flat = abs(body.points[body.elements][..., 0]) < 1e-9
    chosen = body.elements[flat.sum(1) == 4]
    quads = chosen[flat[flat.sum(1) == 4]].reshape(-1, 4)
    corner = body.points[quads][..., 1:]
    middle = corner.mean(1, keepdims=True)
    turn = np.argsort(np.arctan2(*(corner - middle).transpose(2, 0, 1)[::-1]), axis=1)
    quads = np.take_along_axis(quads, turn, 1)
    corner, moved = body.points[quads][..., 1:], displacement[quads][..., 1:]
    sums = np.zeros(1), np.zeros(2), np.zeros(2)
    samples = []
    for r in (-1, 1):
        for s in (-1, 1):
            r0, s0 = r / np.sqrt(3), s / np.sqrt(3)
            value = 0.25 * np.array([(1 - r0) * (1 - s0), (1 + r0) * (1 - s0), (1 + r0) * (1 + s0), (1 - r0) * (1 + s0)])
            slope = 0.25 * np.array([[-(1 - s0), 1 - s0, 1 + s0, -(1 + s0)], [-(1 - r0), -(1 + r0), 1 + r0, 1 - r0]])
            area = abs(np.linalg.det(slope @ corner))
            place, shift = np.einsum("i,eij->ej", value, corner), np.einsum("i,eij->ej", value, moved)
            samples.append((area, place, shift))
            for total, amount in zip(sums, (area.sum(), area @ place, area @ shift)):
                total += amount
    centre, mean = sums[1] / sums[0], sums[2] / sums[0]
    polar = sum(area @ np.sum((place - centre)**2, 1) for area, place, _ in samples)
    turned = sum(area @ ((place - centre)[:, 0] * shift[:, 1] - (place - centre)[:, 1] * shift[:, 0]) for area, place, shift in samples)
    return centre, mean, float(turned / polar)


def pose_of(case: Case, scene: Scene, blocks: Blocks, solution: Solution) -> dict[str, float]:
    """The wheelset's lateral position, height and roll relative to the rail, without the bodies' own motion."""
    count = len(blocks.lower.points)
    (c0, u0, t0), (c1, u1, t1) = (section_motion(body, u) for body, u in (
        (blocks.lower, solution.displacement[:count]), (blocks.upper, solution.displacement[count:])))
    wheel = blocks.wheel
    axle = np.array([wheel.lateral, wheel.vertical])
    shift = [u + t * np.array([-(axle - c)[1], (axle - c)[0]]) for c, u, t in ((c0, u0, t0), (c1, u1, t1))]
    moved = shift[1] - shift[0]
    return {"lateral": case.lateral + float(moved[0]), "vertical": wheel.vertical + float(moved[1]),
            "roll": scene.keys["roll"] + t1 - t0}


def crest_of(x: Array, pressure: Array) -> float:
    inner = (pressure > 0) & (x <= 0.6 * x[pressure > 0].max(initial=0.0))
    if inner.sum() < 3:
        return float(pressure[0])
    slope, level = np.polyfit(x[inner]**2, pressure[inner]**2, 1)
    return float(np.sqrt(max(level, 0.0)))


def half_lengths(x: Array, weight: Array, pressure: Array) -> Array:
    """Of rows, by the second moment of their pressures about x = 0, which is a^2 / 4 for an ellipse."""
    total = pressure @ weight
    return 2 * np.sqrt((pressure @ (weight * x**2)) / np.where(total > 0, total, 1.0))


def integral_between_ends(s: Array, root: Array) -> float:
    """Of sqrt(root) over s, where root falls to 0 linearly at both ends of each stretch under pressure."""
    total = 0.0
    for i in range(len(s) - 1):
        one, other = root[i], root[i + 1]
        if one > 0 and other > 0:
            total += (s[i + 1] - s[i]) * 0.5 * (np.sqrt(one) + np.sqrt(other))
        elif one > 0 or other > 0:
            near, before = (i, i - 1) if one > 0 else (i + 1, i + 2)
            step = abs(s[near] - s[before]) if 0 <= before < len(s) else s[i + 1] - s[i]
            fall = (root[before] - root[near]) / step if 0 <= before < len(s) else 0.0
            reach = min(root[near] / fall, s[i + 1] - s[i]) if fall > 0 else s[i + 1] - s[i]
            total += 2 / 3 * reach * np.sqrt(root[near])
    return float(total)


def width_of(s: Array, root: Array) -> float:
    """Of all stretches with root > 0, ends as above."""
    total = 0.0
    for i in range(len(s) - 1):
        one, other = root[i], root[i + 1]
        if one > 0 and other > 0:
            total += s[i + 1] - s[i]
        elif one > 0 or other > 0:
            near, before = (i, i - 1) if one > 0 else (i + 1, i + 2)
            fall = (root[before] - root[near]) / abs(s[near] - s[before]) if 0 <= before < len(s) else 0.0
            total += min(root[near] / fall, s[i + 1] - s[i]) if fall > 0 else s[i + 1] - s[i]
    return float(total)


def peak_of(s: Array, values: Array) -> tuple[float, float]:
    """Place and height of the highest point, by a parabola."""
    k = int(np.clip(np.argmax(values), 1, len(s) - 2))
    a, b, c = np.polyfit(s[k - 1:k + 2] - s[k], values[k - 1:k + 2], 2)
    if a >= 0:
        return float(s[k]), float(values[k])
    at = float(np.clip(-b / (2 * a), s[k - 1] - s[k], s[k + 1] - s[k]))
    return float(s[k] + at), float(a * at * at + b * at + c)


def patch_measures(case: Case, x: Array, s: Array, y: Array, angle: Array, pressure: Array) -> dict[str, Any]:
    """Of pressures[row, column] at x >= 0 and arcs s of the rail."""
    weight = np.gradient(x)
    weight[0] = 0.5 * (x[1] - x[0])
    across = np.gradient(s)
    across[[0, -1]] *= 0.5
    line = 2 * pressure @ weight  # N/mm
    crest = np.array([crest_of(x, row) for row in pressure])
    halves = half_lengths(x, weight, pressure)
    force = line * across
    total = float(np.hypot(np.sum(force * np.cos(angle)), np.sum(force * np.sin(angle))))
    corner = y < case.corner
    result: dict[str, Any] = {"contact force": total, "pmax": peak_of(s, crest)[1], "area": 2 * integral_between_ends(s, halves**2),
                              "width": width_of(s, crest**2), "length": 2 * float(halves.max()),
                              "nodes under pressure": 2 * float(np.sum((pressure > 0) * np.outer(across, weight)))}
    if 0 < corner.sum() < len(y):
        result["share of corner"] = float(force[corner].sum() / force.sum())
        result["pmax of tread"] = peak_of(s, np.where(corner, 0, crest))[1]
        result["area of corner"] = 2 * integral_between_ends(s, np.where(corner, halves, 0)**2)
        result["nodes under pressure of corner"] = 2 * float(np.sum((pressure > 0)[corner] * np.outer(across, weight)[corner]))
    result["rows"] = {"y": y.tolist(), "arc": s.tolist(), "crest": crest.tolist(), "line load": line.tolist(), "half length": halves.tolist()}
    return result


def von_mises(stress: Array) -> Array:
    xx, yy, zz, xy, yz, zx = np.moveaxis(stress, -1, 0)
    return np.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3 * (xy**2 + yz**2 + zx**2))


def finite_element_figures(case: Case, scene: Scene, blocks: Blocks, solution: Solution) -> dict[str, Any]:
    lower, upper = blocks.lower, blocks.upper
    fine = lower.number[lower.fine]
    places = lower.nodes[lower.fine]
    x = places[0, :, 0, 0]
    arcs = scene.section.arc_of(places[:, 0, 0, 1:])
    arcs = arcs[0] + np.append(0, np.cumsum(np.hypot(*np.diff(places[:, 0, 0, 1:], axis=0).T)))
    angle = scene.section.angle_at(arcs)
    pressure = np.nan_to_num(solution.pressure[fine[:, :, 0]])
    # CalculiX reports no pressure at nodes of x = 0 that come into contact after the first step, although they carry the load: with
    # their neighbour's pressure, the sum is that of the reaction.
    pressure[:, 0] = np.where(pressure[:, 0] > 0, pressure[:, 0], pressure[:, 1])
    found = patch_measures(case, x, arcs, places[:, 0, 0, 1], angle, pressure)
    found.update({"Fy": 2 * float(solution.reaction[1]), "Fz": 2 * float(solution.reaction[2])})
    found["pose"] = pose_of(case, scene, blocks, solution)
    # Stresses in the section x = 0, by their depth below the surface.
    flat = fine[:, 0, :]
    mises = von_mises(solution.stress[flat])
    depth = np.array([[np.min(np.hypot(*(scene.section.points - point).T)) for point in line] for line in places[:, 0, :, 1:]])
    for name, chosen in (("", np.ones(len(arcs), bool)), (" of tread", places[:, 0, 0, 1] >= case.corner)):
        if not np.any(chosen) or (name and np.all(chosen)):
            continue
        for level in DEPTHS:
            found[f"von Mises at {level:.0f} mm{name}"] = peak_of(arcs[chosen], np.array([np.interp(level, d, m) for d, m in zip(
                depth[chosen], mises[chosen])]))[1]
    found["von Mises"] = max(peak_of(d, m)[1] for d, m in zip(depth, mises))
    strain = solution.plastic_strain[lower.number[lower.number >= 0]]
    found["plastic strain of rail"] = float(strain.max())
    found["plastic strain of wheel"] = float(solution.plastic_strain[len(lower.points):].max())
    yielded = (solution.plastic_strain[:len(lower.points)] > YIELDED) & (abs(lower.points[:, 0]) < 1e-9)
    found["depth of yield"] = max((float(np.min(np.hypot(*(scene.section.points - point).T))) for point in lower.points[yielded][:, 1:]),
                                  default=0.0)
    found["rows"]["middle"] = pressure[:, 0].tolist()
    found["rows at the end"] = float(max(pressure[[0, 1, -2, -1]].max(), pressure[:, -2:].max()))
    # Approach of two points DEEP below the highest row whose nodes go on outside of the core, relative to where the surfaces just
    # touch there.
    crest = RATIO * int(np.argmax(found["rows"]["crest"][::RATIO]))
    normal = np.array([-np.sin(angle[crest]), np.cos(angle[crest])])
    found["crest"] = {"arc": float(arcs[crest]), "y": float(places[crest, 0, 0, 1]), "z": float(places[crest, 0, 0, 2])}
    motion = []
    for body, shift in ((lower, 0), (upper, len(lower.points))):
        zone = body.fine
        line = body.number[zone[0].start + crest, 0, :]
        used = line >= 0
        points = body.points[line[used]][:, 1:]
        away = abs((points - points[0]) @ normal)
        moved = solution.displacement[shift + line[used]][:, 1:] @ normal
        motion.append(float(PchipInterpolator(away, moved)(DEEP)))
    gap = (upper.nodes[upper.fine][crest, 0, 0, 1:] - places[crest, 0, 0, 1:]) @ normal
    found["approach 10 mm deep"] = float(-gap - (motion[1] - motion[0]))
    found.update({"nodes": len(blocks.model.nodes), "elements": len(blocks.model.elements), "iterations": solution.iterations,
                  "seconds": round(solution.seconds, 1)})
    return found


def library_measures(case: Case, scene: Scene, pose: dict[str, float], force: float, crest: dict[str, float],
                     curved: str = "yes") -> dict[str, Any]:
    """The library's solution of the scene that the finite elements have."""
    import wrcontact

    keys: dict[str, Any] = {**scene.keys, "lateral": pose["lateral"], "roll": pose["roll"], "load_both": force}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wrcontact.ContactWarning)
        _, left = library_figures(keys, "pressures", 1e-3, curved)
        stresses = wrcontact.solve(**keys, side="left", accuracy_of="pressures", accuracy=1e-3, results="stress", stress_section="across").left
    found: dict[str, Any] = {
        "pmax": left.pmax, "area": left.area, "Fy": left.pressure_force.y, "Fz": left.pressure_force.z,
        "contact force": float(np.hypot(left.pressure_force.y, left.pressure_force.z)),
        "depth": left.depth, "depth of the finite elements": left.vertical - pose["vertical"],
        "von Mises": max(p.stress.von_mises_max for p in stresses.patches)}
    rows: list[tuple[float, float, float, float, float]] = []
    deep = 0.0
    spot = np.array([0.0, crest["y"], crest["z"]])
    angle = float(scene.section.angle_at(np.array([crest["arc"]]))[0])
    below = spot - DEEP * np.array([0.0, -np.sin(angle), np.cos(angle)])
    for patch in left.patches:
        p, px, py, pz = (patch.field(name) for name in ("pressure", "x", "y", "z"))
        sizes = patch.element_size
        height, length = float(sizes.lateral), float(sizes.longitudinal)
        for i in range(p.shape[0]):
            crest_here, line = float(p[i].max()), float(p[i].sum() * length)
            half = float(half_lengths(px[i] - px[i].mean(), np.full(p.shape[1], length), p[i]))
            rows.append((float(py[i, 0]), crest_here, line, half, height))
        distance = np.sqrt((px - below[0])**2 + (py - below[1])**2 + (pz - below[2])**2)
        amount = p * height * length
        deep += float(np.sum(amount * (2 * (1 - POISSON) / distance + DEEP**2 / distance**3))) * (1 + POISSON) / (2 * np.pi * YOUNG)
    rows.sort(reverse=True)
    table = np.array(rows)
    found["rows"] = {"y": table[:, 0].tolist(), "crest": table[:, 1].tolist(), "line load": table[:, 2].tolist(), "half length": table[:, 3].tolist()}
    found["length"] = 2 * float(table[:, 3].max())
    found["width"] = float(np.sum(table[table[:, 1] > 0, 4]))
    corner = table[:, 0] < case.corner
    force_of = table[:, 2] * table[:, 4]
    if 0 < corner.sum() < len(corner):
        found["share of corner"] = float(force_of[corner].sum() / force_of.sum())
        found["pmax of tread"] = float(table[~corner, 1].max())
        found["area of corner"] = float(np.sum(2 * table[corner, 3] * table[corner, 4]))
    # The overlap at the finite elements' crest less what both bodies yield below the depth.
    wheel = placed_wheel(keys, left.vertical - left.depth)
    ray = np.array([0.0, -np.sin(angle), np.cos(angle)])
    overlap = -float(wheel.distance(spot[None], ray[None], np.zeros(1))[0][0])
    found["approach 10 mm deep"] = overlap - 2 * deep
    for name in ("", " of tread"):
        for level in DEPTHS:
            values = []
            for patch in stresses.patches:
                mises, depth = patch.field("stress_von_mises"), patch.field("stress_depth")[:, 0]
                if not mises.size:
                    continue
                place = patch.field("stress_place")[0]
                lateral = patch.y + place * np.cos(patch.plane_angle)
                use = lateral >= case.corner if name else np.ones(len(place), bool)
                if np.any(use):
                    k = int(np.searchsorted(depth, level))
                    share = (level - depth[k - 1]) / (depth[k] - depth[k - 1])
                    values.append(float(np.max((1 - share) * mises[k - 1, use] + share * mises[k, use])))
            if values and not (name and not 0 < corner.sum() < len(corner)):
                found[f"von Mises at {level:.0f} mm{name}"] = max(values)
    return found
