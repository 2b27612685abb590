#!/usr/bin/env python3
"""Draws docs/images/frames.svg: the frames and signs of wrcontact.

Usage: docs/images/frames.py. Outlines are those of profiles/S1002.toml and profiles/60E1.toml, at
their places in the scene of wrc_case without options. Needs python 3.11 and nothing else.
"""
import math
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
PROFILES = HERE.parent.parent / "profiles"
WIDTH, HEIGHT = 1060, 1010
# As in drivers/support/gnuplot.hpp.
WHEEL, RAIL, SIGN, FAINT, WHEEL_BODY, RAIL_BODY = "#1f4e9e", "#8b5a2b", "#c00000", "#909090", "#e9eff8", "#f3ebe3"
AXIS = TEXT = "#222222"
CANT = math.atan(1 / 40)

parts = []


def outline(name):
    """Points of a profile: lateral to the field side, height as the profile defines it."""
    data = tomllib.loads((PROFILES / f"{name}.toml").read_text(encoding="utf-8"))
    sign = 1.0 if data["height_axis"] == "up" else -1.0
    points = []
    for segment in data["segment"]:
        steps = 24
        if segment["type"] == "arc":
            (cx, cy), r = segment["centre"], segment["radius"]
            a, b = (math.atan2(p[1] - cy, p[0] - cx) for p in (segment["start"], segment["end"]))
            turn = math.remainder(b - a, 2 * math.pi)
            points += [(cx + r * math.cos(a + turn * i / steps), cy + r * math.sin(a + turn * i / steps))
                       for i in range(steps + 1)]
        elif segment["type"] == "line":
            points += [segment["start"], segment["end"]]
        else:
            begin, end, at = segment["from"], segment["to"], segment.get("expansion_point", 0.0)
            for i in range(steps + 1):
                s = begin + (end - begin) * i / steps
                points.append((s, sum(c * (s - at) ** k for k, c in enumerate(segment["coefficients"]))))
    points = [(s, sign * w) for s, w in points]
    if data["mirror"]:
        points = [(-s, w) for s, w in reversed(points)] + points
    return points


def placed_rail():
    """The left rail in the track frame, gauge 1435 mm measured 14 mm below its top."""
    turned = [(t * math.cos(CANT) - v * math.sin(CANT), t * math.sin(CANT) + v * math.cos(CANT))
              for t, v in outline("60E1")]
    top = max(z for _, z in turned)
    face = next((a[0] + (b[0] - a[0]) * (-14 - a[1] + top) / (b[1] - a[1])
                 for a, b in zip(turned, turned[1:])
                 if (a[1] - top + 14) * (b[1] - top + 14) <= 0 and a[1] != b[1]))
    return [(y - face + 717.5, z - top) for y, z in turned], (717.5 - face, -top)


def tag(text):
    parts.append(text)


def line(a, b, colour=AXIS, width=1.5, arrow=False, dash=""):
    tag(f'<line x1="{a[0]:.1f}" y1="{a[1]:.1f}" x2="{b[0]:.1f}" y2="{b[1]:.1f}" stroke="{colour}" '
        f'stroke-width="{width}"' + (f' stroke-dasharray="{dash}"' if dash else "")
        + (f' marker-end="url(#{"red" if colour == SIGN else "black"})"' if arrow else "") + "/>")


def label(at, text, colour=TEXT, anchor="middle", size=15, weight="normal", style="normal"):
    tag(f'<text x="{at[0]:.1f}" y="{at[1]:.1f}" fill="{colour}" text-anchor="{anchor}" '
        f'font-size="{size}" font-weight="{weight}" font-style="{style}">{text}</text>')


def curve(points, colour, fill="none", width=2.0):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    tag(f'<polyline points="{path}" fill="{fill}" stroke="{colour}" stroke-width="{width}"/>')


def turn(centre, radius, begin, end, colour=SIGN):
    """An arc with an arrow; degrees on the page, anticlockwise."""
    a, b = ((centre[0] + radius * math.cos(math.radians(d)), centre[1] - radius * math.sin(math.radians(d)))
            for d in (begin, end))
    large, sweep = int(abs(end - begin) > 180), int(end < begin)
    tag(f'<path d="M {a[0]:.1f} {a[1]:.1f} A {radius} {radius} 0 {large} {sweep} {b[0]:.1f} {b[1]:.1f}" '
        f'fill="none" stroke="{colour}" stroke-width="2" marker-end="url(#red)"/>')


def dot(at, colour=AXIS):
    tag(f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="3.5" fill="{colour}"/>')


def title(at, letter, text):
    label(at, f"{letter}  {text}", anchor="start", size=17, weight="bold")


def seen_from_behind():
    title((20, 30), "A", "Track frame, seen in driving direction")
    left, right, top, axle = 90, 430, 250, 150
    middle = (left + right) / 2
    line((40, top), (485, top), FAINT, 1, dash="4 4")
    label((482, top - 6), "rail tops", FAINT, "start", 13)
    for x, outward in ((left, -1), (right, 1)):
        curve([(x - 14, top + 40), (x - 14, top + 8), (x - 10, top), (x + 10, top), (x + 14, top + 8),
               (x + 14, top + 40)], RAIL)
        inner, outer = x - outward * 22, x + outward * 24
        curve([(inner, top + 14), (inner, axle - 85), (outer, axle - 80), (outer, top - 2),
               (x - outward * 12, top), (x - outward * 16, top + 14), (inner, top + 14)], WHEEL, WHEEL_BODY)
    curve([(left + 22, axle - 6), (right - 22, axle - 6), (right - 22, axle + 6), (left + 22, axle + 6),
           (left + 22, axle - 6)], WHEEL, WHEEL_BODY)
    origin, centre = (middle, top), (middle - 20, axle)
    line((middle, top + 8), (middle, top - 195), AXIS, 1.5, True)
    label((middle + 8, top - 185), "z up", anchor="start")
    line((middle + 8, top), (middle - 85, top), AXIS, 1.5, True)
    label((middle - 88, top + 19), "y left")
    tag(f'<circle cx="{origin[0]}" cy="{origin[1]}" r="7" fill="white" stroke="{AXIS}"/>')
    line((origin[0] - 5, origin[1] - 5), (origin[0] + 5, origin[1] + 5))
    line((origin[0] - 5, origin[1] + 5), (origin[0] + 5, origin[1] - 5))
    label((middle + 12, top + 18), "x forward,", anchor="start", size=14)
    label((middle + 12, top + 35), "into the page", anchor="start", size=14)
    dot(centre, WHEEL)
    line((middle, axle + 24), (middle - 20, axle + 24), SIGN, 2, True)
    label((middle + 8, axle + 29), "pose.lateral &gt; 0", SIGN, "start", 14)
    turn(centre, 40, 160, 100)
    label((middle + 8, axle - 38), "roll &gt; 0 lifts", SIGN, "start", 14)
    label((middle + 8, axle - 21), "the left wheel", SIGN, "start", 14)
    label((left + 15, top + 62), "left wheel, y &gt; 0", size=14)
    label((right - 15, top + 62), "right wheel, y &lt; 0", size=14)


def seen_from_above():
    title((575, 30), "B", "Track frame, seen from above")
    cx, cy = 790, 170
    for x in (cx - 120, cx + 120):
        line((x, 60), (x, 290), RAIL, 4)
    line((cx, 290), (cx, 50), AXIS, 1.5, True)
    label((cx + 8, 62), "x forward", anchor="start")
    line((cx, cy), (cx - 200, cy), AXIS, 1.5, True)
    label((cx - 190, cy - 8), "y left")
    angle = math.radians(9)
    along = (math.cos(angle), -math.sin(angle))
    a, b = ((cx + d * along[0], cy + d * along[1]) for d in (-150, 150))
    line(a, b, WHEEL, 5)
    for d in (-120, 120):
        x, y = cx + d * along[0], cy + d * along[1]
        tag(f'<rect x="{x - 9:.1f}" y="{y - 36:.1f}" width="18" height="72" fill="{WHEEL_BODY}" stroke="{WHEEL}" '
            f'stroke-width="2" transform="rotate({-math.degrees(angle):.1f} {x:.1f} {y:.1f})"/>')
    turn((cx, cy), 70, 60, 100)
    label((cx + 20, cy - 78), "yaw &gt; 0", SIGN, "start", 14)
    label((cx + 10, cy + 90), "z to reader", anchor="start", size=14)
    label((cx, 318), "Right-handed. With convention.frame = \"right-down\" y points", size=13)
    label((cx, 335), "to the right and z down; lateral and vertical components change sign.", size=13)


def profile_frames():
    title((20, 385), "C", "Profile frames of the left wheel and rail")
    rail, axis = placed_rail()
    scale, y0, z0 = 2.9, 748.0, 660
    # y grows to the left of the page.
    def at(y, z):
        return (270 - scale * (y - y0), z0 - scale * z)
    taping = 1360 / 2 + 70
    wheel = [at(taping + s, -w) for s, w in outline("S1002")]
    curve([*wheel, (wheel[-1][0], at(0, 75)[1]), (wheel[0][0], at(0, 75)[1]), wheel[0]], WHEEL, WHEEL_BODY)
    curve([at(y, z) for y, z in rail], RAIL, RAIL_BODY)
    tape = at(taping, 0)
    line((tape[0], tape[1] - 190), (tape[0], tape[1] + 25), WHEEL, 1, dash="6 4")
    label((tape[0] - 6, tape[1] - 196), "taping line, s = 0, w = 0", WHEEL, "middle", 14)
    line((tape[0], tape[1] - 100), (tape[0] - 80, tape[1] - 100), AXIS, 1.5, True)
    label((tape[0] - 84, tape[1] - 108), "s, to the field side", anchor="middle", size=14)
    line((tape[0], tape[1] - 100), (tape[0], tape[1] - 45), AXIS, 1.5, True)
    label((tape[0] + 8, tape[1] - 58), "w, to larger radius", anchor="start", size=14)
    head = at(axis[0], axis[1])
    c, s = math.cos(CANT), math.sin(CANT)
    foot = (head[0] + 95 * s * -1, head[1] + 95 * c)
    line(foot, head, RAIL, 1, dash="6 4")
    line(foot, (foot[0] - 80 * c, foot[1] - 80 * s), AXIS, 1.5, True)
    label((foot[0] - 70, foot[1] + 18), "t, to the field side", size=14)
    line(foot, (foot[0] + 60 * s, foot[1] - 60 * c), AXIS, 1.5, True)
    label((foot[0] + 10, foot[1] - 38), "v, up", anchor="start", size=14)
    label((foot[0] + 60, foot[1] + 18), "(0, 0) is the rail's top on its axis", anchor="start", size=13)
    label((foot[0] + 60, foot[1] + 36), "inclination &gt; 0 leans the rail towards the track centre", SIGN, "start", 14)
    gauge = at(717.5, -14)
    dot(gauge, SIGN)
    line(gauge, (485, gauge[1]), SIGN, 1)
    label((490, gauge[1] + 5), "gauge face: y = gauge/2,", SIGN, "start", 14)
    label((490, gauge[1] + 22), "gauge_height below the top", SIGN, "start", 14)


def contact_plane():
    title((600, 385), "D", "Plane of a patch on the left rail")
    base, angle = (790, 590), math.radians(24)
    along = (-math.cos(angle), -math.sin(angle))  # to the field side, rising
    normal = (math.sin(angle), -math.cos(angle))
    def at(s, n):
        return (base[0] + s * along[0] + n * normal[0], base[1] + s * along[1] + n * normal[1])
    curve([at(s, -0.0016 * s * s) for s in range(-110, 150, 5)], RAIL)
    curve([at(s, 0.0022 * s * s - 9) for s in range(-110, 90, 5)], WHEEL)
    label(at(140, -52), "rail", RAIL)
    label(at(-100, 34), "wheel", WHEEL)
    line(at(-190, 0), at(205, 0), FAINT, 1, dash="5 4")
    line(at(0, 0), at(110, 0), AXIS, 2, True)
    label((at(110, 0)[0] + 4, at(110, 0)[1] - 36), "lateral,", size=14)
    label((at(110, 0)[0] + 4, at(110, 0)[1] - 19), "to the field side", size=14)
    line(at(0, 0), at(0, 120), AXIS, 2, True)
    label((at(0, 120)[0] + 12, at(0, 120)[1] - 2), "normal, rail to wheel", anchor="start", size=14)
    dot(at(0, 0))
    line(base, (base[0] - 40, base[1] + 70), FAINT, 1)
    label((base[0] - 40, base[1] + 86), "contact reference x, y, z; x, longitudinal,", size=14)
    label((base[0] - 40, base[1] + 103), "points into the page", size=14)
    line((base[0] - 190, base[1]), (base[0], base[1]), FAINT, 1)
    turn(base, 165, 180, 180 - 22)
    label((base[0] - 186, base[1] + 20), "angle &gt; 0:", SIGN, "start", 14)
    label((base[0] - 186, base[1] + 37), "rises to the left", SIGN, "start", 14)
    force = at(0, 70)
    line(at(0, 8), force, SIGN, 2.5, True)
    label((force[0] + 14, force[1] + 12), "force of the rail on the wheel:", SIGN, "start", 14)
    label((force[0] + 14, force[1] + 29), "vertical &gt; 0 up, lateral &lt; 0 here", SIGN, "start", 14)
    label((600, 745), "Undeformed distance and approach are measured along the normal.", anchor="start", size=13)
    label((600, 763), "Rows of a field go to the field side on both wheels.", anchor="start", size=13)


def depth_and_approach():
    title((20, 820), "E", "Depth and approach")
    base, angle = (250, 925), math.radians(24)
    along, normal = (-math.cos(angle), -math.sin(angle)), (math.sin(angle), -math.cos(angle))
    def at(s, n, down=0.0):
        return (base[0] + s * along[0] + n * normal[0], base[1] + s * along[1] + n * normal[1] + down)
    curve([at(s, -0.0012 * s * s) for s in range(-130, 150, 5)], RAIL)
    curve([at(s, 0.0022 * s * s) for s in range(-110, 130, 5)], FAINT)
    down = 40
    curve([at(s, 0.0022 * s * s, down) for s in range(-110, 130, 5)], WHEEL)
    line(at(0, 0), at(0, 0, down), SIGN, 2, True)
    label((base[0] + 122, base[1] + 30), "depth: vertical approach,", SIGN, "start", 14)
    label((base[0] + 122, base[1] + 47), "from the first touch", SIGN, "start", 14)
    approach = down * math.cos(angle)
    line((560, 900), (590, 900), FAINT, 2)
    label((600, 905), "wheel at the first touch", anchor="start", size=14)
    line((560, 925), (590, 925), WHEEL, 2)
    label((600, 930), "undeformed wheel at the depth: it has also slid along the", anchor="start", size=14)
    label((600, 948), "tangent, so distances are sampled here", anchor="start", size=14)
    line((560, 968), (590, 968), RAIL, 2)
    label((600, 973), "rail", anchor="start", size=14)
    line(at(0, 0), at(0, -approach), AXIS, 2, True)
    label((base[0] - 26, base[1] + 60), "approach: deepest overlap", anchor="end", size=14)
    label((base[0] - 26, base[1] + 77), "along the normal", anchor="end", size=14)


def main():
    seen_from_behind()
    seen_from_above()
    profile_frames()
    contact_plane()
    depth_and_approach()
    markers = "".join(
        f'<marker id="{name}" viewBox="0 0 10 10" refX="9" refY="5" markerWidth="9" markerHeight="9" '
        f'markerUnits="userSpaceOnUse" orient="auto"><path d="M 0 0 L 10 5 L 0 10 z" fill="{colour}"/></marker>'
        for name, colour in (("black", AXIS), ("red", SIGN)))
    (HERE / "frames.svg").write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" '
        f'height="{HEIGHT}" font-family="DejaVu Sans, Helvetica, sans-serif">\n<defs>{markers}</defs>\n'
        f'<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n",
        encoding="utf-8")


main()
