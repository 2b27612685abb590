"""Cross-sections for prismatic_body.py: rail, wheel rim, and the two bodies whose influence is known.

Lateral coordinates are those of the profiles, positive to the field side; heights are positive out of the body, so that the wheel is
upside down. Units mm.
"""
from __future__ import annotations

import math
import tomllib
from collections.abc import Callable
from pathlib import Path

import numpy as np

from prismatic_body import Array, Section

PROFILES = Path(__file__).resolve().parents[3] / "profiles"
STEPS = 400  # points of a segment of a profile


def profile_points(name: str) -> Array:
    """Points of a built-in profile from the field side to the gauge side, heights positive upwards from a rail, outwards from a wheel."""
    data = tomllib.loads((PROFILES / f"{name}.toml").read_text(encoding="utf-8"))
    points: list[tuple[float, float]] = []
    for segment in data["segment"]:
        t = np.linspace(0, 1, STEPS + 1)
        if segment["type"] == "arc":
            (cy, cz), radius = segment["centre"], segment["radius"]
            first, last = (math.atan2(p[1] - cz, p[0] - cy) for p in (segment["start"], segment["end"]))
            angle = first + math.remainder(last - first, 2 * math.pi) * t
            y, z = cy + radius * np.cos(angle), cz + radius * np.sin(angle)
        elif segment["type"] == "line":
            y, z = (a + (b - a) * t for a, b in zip(segment["start"], segment["end"]))
        else:
            y = segment["from"] + (segment["to"] - segment["from"]) * t
            z = sum(c * (y - segment.get("expansion_point", 0.0))**i for i, c in enumerate(segment["coefficients"]))
        points += list(zip(y.tolist(), z.tolist()))
    result = np.array(points) * [1.0, 1.0 if data["height_axis"] == "up" else -1.0]
    if data["mirror"]:
        result = np.vstack([result[::-1] * [-1.0, 1.0], result])
    result = result[::-1]
    return np.asarray(result[np.append(True, np.hypot(*np.diff(result, axis=0).T) > 1e-3)])


def strips_between(profile: Array, first: float, last: float, width: float) -> Array:
    """Arc lengths from the profile's beginning, between two lateral positions, first > last."""
    arc = np.append(0.0, np.cumsum(np.hypot(*np.diff(profile, axis=0).T)))
    begin, end = (float(np.interp(-lateral, -profile[:, 0], arc)) for lateral in (first, last))
    return np.asarray(begin + width * np.arange(int((end - begin) / width) + 1))


def above(height: float) -> Callable[[Array], Array]:
    return lambda points: np.asarray(points[:, 1] > height)


def below(height: float) -> Callable[[Array], Array]:
    return lambda points: np.asarray(points[:, 1] < height)


def rail_60e1(first: float, last: float, width: float) -> Section:
    """Head of profiles/60E1.toml; height 172, foot 150, web 16.5, fishing planes 1:2.75 at 51 below the top and 31.5 above
    the foot (EN 13674-1). Fillets are straight, the web's thickness is constant. Clamped at the underside."""
    profile = profile_points("60E1")
    right = np.array([[8.25, -56.0], [16.0, -51 + 16 / 2.75]])  # a straight line for the fillets
    foot = np.array([[75.0, -172.0], [75.0, -160.5], [50.1, -158.72], [16.0, -140.5 - 16 / 2.75], [8.25, -135.0]])
    left = np.vstack([right[::-1], foot[::-1]]) * [-1.0, 1.0]
    outline = np.vstack([profile, left, foot, right])
    count = len(profile)
    return Section(outline, np.array([0, *range(count - 1, len(outline))]), strips_between(profile, first, last, width),
                   below(-172 + 1e-6), above(-50.0))


def rim_s1002(first: float, last: float, width: float) -> Section:
    """profiles/S1002.toml on a rim of an assumed depth of 62 mm and a disc 28 mm thick, clamped 100 mm below the rim."""
    profile = profile_points("S1002")
    under = np.array([[-70.0, -62.0], [-14.0, -62.0], [-14.0, -162.0], [14.0, -162.0], [14.0, -62.0], [65.0, -62.0]])
    outline = np.vstack([profile, under])
    count = len(profile)
    corners = [0, int(np.argmin(abs(profile[:, 0] - 60.0))), *range(count - 1, len(outline))]
    return Section(outline, np.array(corners), strips_between(profile, first, last, width),
                   below(-162 + 1e-6), above(-62.0))


def sector(angle: float, radius: float, first: float, last: float, width: float) -> Section:
    """The flat surface z = 0, y < 0 next to the edge y = 0 of a quarter-space (angle pi / 2), or all of z = 0 of a half-space
    (angle pi); clamped at the radius. Strips lie between two distances from y = 0, negative ones at y > 0."""
    turn = np.linspace(math.pi, math.pi + angle, 400)
    arc = radius * np.stack([np.cos(turn), np.sin(turn)], -1)
    edge = arc[-1:] if angle > 3 else np.zeros((1, 2))
    outline = np.vstack([edge, arc[:-1] if angle > 3 else arc])
    corners = np.array([0, 1] if angle > 3 else [0, 1, len(outline) - 1])
    strips = abs(float(edge[0, 0])) + first + width * np.arange(int(round((last - first) / width)) + 1)
    return Section(outline, corners, strips, lambda p: np.asarray(np.hypot(*p.T) > radius * (1 - 1e-4)),
                   lambda p: np.asarray(np.hypot(*p.T) > radius * 0.5), coarsest=radius / 4)
