#!/usr/bin/env python3
"""Writes crossing.slcs and its slices: a common crossing 1:9 by formula, made for the study `crossing`.

Usage: make_crossing.py FOLDER

The build calls it. Creates the folder and replaces the files.

A left rail, as a train meets it that runs from the switches to the crossing: x forward from the theoretical
point of the nose, y to the field side from the axis of the plain rail, z up from its top; mm. Its head
is that of 60E1 (profiles/60E1.toml), H(y), with its sides at y = -36 and 36.
  rail, then wing   H(y - e(x)): e = 0, from the throat on e = x/N + flangeway, its bend a parabola
  nose              k^(3/4) H((y - m)/k) - d(x), k = w/72: the head made narrower, and rounder, to the width
                    w = x/N; its inner side at y = m - w/2 = b(x) - 36, set back by b; w grows to 72, d
                    and b sink to 0, where it is the plain rail
  flangeway         between the sides of nose and wing, a round floor
Features cut each slice into side, head, side of the nose, floor, side, head, side of the wing; the
nose begins at its practical point, the wing ends where no wheel is over it.
Not covered: the check rail, the other wing beside the wheel's back, wear, radii of machined noses.
"""
import math
import pathlib
import sys

N = 9.0             # the crossing's angle is 1:N
FLANGEWAY = 41.0
BEND = 100.0        # its length along the track
NOSE_BEGIN = 90.0   # where it is 10 mm wide
WING_END = 560.0
HEAD = 72.0         # width of 60E1
DEPTH = 37.5        # to which sides go
LOWERING = [(90.0, 4.0), (180.0, 2.4), (620.0, 0.0)]  # d at places, linear between, then 0
SET_BACK = [(90.0, 4.1), (500.0, 0.0)]                # b, likewise
ROUNDING = 60.0     # along the track, of the kinks of these and of the width
PLACES = [-800, -600, -500, -460, -430, -400, -370, -340, -300, -200, -100, 0, 90, 110, 130, 150, 170, 190, 210,
          230, 250, 270, 290, 310, 330, 360, 400, 450, 500, 560, 600, 630, 660, 690, 720, 800, 1000]


def ramp(x, width):
    """max(x, 0) with its corner rounded over `width`."""
    if abs(x) >= width / 2:
        return max(x, 0.0)
    return (x + width / 2) ** 2 / (2 * width)


def flare(x):
    return ramp(x + N * FLANGEWAY, BEND) / N


def width(x):
    return HEAD - ramp(N * HEAD - x, ROUNDING) / N


def course(places, x):
    """Linear between places, then 0: back from the end, with a ramp for each change of the slope."""
    total = slope = 0.0
    for (x0, d0), (x1, d1) in reversed(list(zip(places, places[1:]))):
        total += ((d0 - d1) / (x1 - x0) - slope) * ramp(x1 - x, ROUNDING)
        slope = (d0 - d1) / (x1 - x0)
    return total


def arc(centre, radius, begin, end, step):
    """Points by angles from the vertical, to the field side."""
    count = max(2, math.ceil(radius * abs(end - begin) / step))
    return [(centre[0] + radius * math.sin(a), centre[1] + radius * math.cos(a))
            for a in (begin + (end - begin) * i / count for i in range(count + 1))]


def rail():
    """H in three parts, side, head, side, that share their ends: arcs of 300, 80 and 13 mm and lines, as
    profiles/60E1.toml has them, z up."""
    angles = [0.0, math.asin(10.228 / 300.0), math.asin((26.0265 - 7.500533333333333) / 80.0),
              math.asin((35.99981082207864 - 23.016030416666666) / 13.0)]
    half = arc((0.0, -300.0), 300.0, angles[0], angles[1], 1.0)
    half += arc((7.500533333333333, -80.12789626759023), 80.0, angles[1], angles[2], 1.0)[1:]
    half += arc((23.016030416666666, -14.94914704472561), 13.0, angles[2], angles[3], 0.8)[1:]
    y, z = half[-1]
    side = [(y + (DEPTH + z) * i / 160, z - (DEPTH + z) * i / 8) for i in range(9)]  # 1:20

    def mirrored(points):
        return [(-y, z) for y, z in reversed(points)]

    return mirrored(side), mirrored(half)[:-1] + half, side


def moved(parts, narrower, lower, lateral, height):
    return [[(narrower * y + lateral, lower * z + height) for y, z in part] for part in parts]


def floor(left, right):
    """From the last two points of the nose to the first two of the wing: a cubic that goes on in both directions."""
    (p, q), (r, s) = left, right
    reach = 2.0 * (r[0] - q[0])

    def tangent(one, other):
        return [reach * (b - a) / math.dist(one, other) for a, b in zip(one, other)]

    begin, end = tangent(p, q), tangent(r, s)
    points = []
    for i in range(51):
        t = i / 50
        weights = ((1 + 2 * t) * (1 - t) ** 2, t * (1 - t) ** 2, t * t * (3 - 2 * t), t * t * (t - 1))
        points.append(tuple(weights[0] * q[j] + weights[1] * begin[j] + weights[2] * r[j] + weights[3] * end[j]
                            for j in range(2)))
    return points


def length(points):
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))


def slice_at(x):
    """Points from the track's middle outwards, and features: arc lengths, -1 for none."""
    nose, wing, way = [], [], []
    if x >= NOSE_BEGIN:
        k = width(x) / HEAD
        nose = moved(rail(), k, k**0.75, (width(x) - HEAD) / 2 + course(SET_BACK, x), -course(LOWERING, x))
    if x <= WING_END:
        wing = moved(rail(), 1.0, 1.0, flare(x), 0.0)
    if nose and wing:
        way = [floor(nose[2][-2:], wing[0][:2])]
    points, features = [], []
    for part in nose + way + wing:
        features.append(length(points))
        points += part if not points else part[1:]
    features.append(length(points))
    missing = [-1.0] * 4
    return points, (missing if not nose else []) + features + (missing if not wing else [])


def files():
    """Texts by names."""
    made, rows, table = {}, [], []
    for x in PLACES:
        points, features = slice_at(x)
        name = f"slice_{x:+05d}.txt".replace("+", "p").replace("-", "m")
        made[name] = "".join(f"{y:.6f} {z:.6f}\n" for y, z in points)
        rows.append(f"{x:6d}  '{name}'\n")
        table.append(f"{x:6d}" + "".join(f" {s:9.4f}" if s >= 0 else "        -1" for s in features) + "\n")
    made["crossing.slcs"] = (
        "% A crossing 1:9 by formula (make_crossing.py), y to the field side, z up, mm\n"
        "0 1  % offset and scale of positions\n"
        f"{len(PLACES)}  % slices\n"
        "8 0 0  % features, kinks, accelerations\n"
        "1  % through the slices\n" + "".join(rows)
        + "% nose: side, head, side; floor; wing: side, head, side\n" + "".join(table))
    return made


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    for name, text in files().items():
        (folder / name).write_text(text)


if __name__ == "__main__":
    main()
