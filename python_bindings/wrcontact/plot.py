"""Pictures, by matplotlib, which is loaded when the first one is drawn."""
from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._library import Array
from ._warnings import GRADES, lines_of, worst_of
from .errors import InvalidArgument

if TYPE_CHECKING:
    from .conicity import Conicity
    from .profile import Profile
    from ._names import Patch
    from .result import Result

# Colours and dimensions of drivers/support/gnuplot.hpp and drivers/reports/scene_picture.cpp.
_RAIL, _WHEEL, MARKED = "#8b5a2b", "#1f4e9e", "#c00000"
_RAIL_BODY, _WHEEL_BODY = "#f3ebe3", "#e9eff8"
_ADHESION, _SLIP = "#cfe2f3", "#f6c7b6"
_CONTOUR, _ARROW_COLOUR, NOTE = "#404040", "#303030", "#606060"
LINES = ("#0060ad", "#d55e00", "#009e73", "#7030a0", "#a08000", "#404040")
_HALF_PLANE = 9.0  # mm, drawn of the plane of a patch
_AROUND = (45.0, 26.0, 34.0)  # mm beside, below and above the first touch
_AROUND_PATCH = 15.0  # mm around its reference
_ARROW = (14.0, 3.0)  # mm, of the largest force of a wheel, and at least
_PIXELS = 96  # to the inch, of those of the programs
_PANEL = (650 / _PIXELS, 450 / _PIXELS)  # inches
_RATIO, _SHARES = 1.5, (0.78, 0.62)  # of axes: width to height, and what patches take of them
LETTER = 10.0  # points
_MOST_WARNINGS, _LETTERS = 6, 100  # lines, in the width of a panel
_MOST_ARROWS = 14  # along and across a patch
_WAYS = ("lateral", "longitudinal")
_ON_BOUND = 1.0 - 1e-6  # share of friction times pressure from which an element slips


def picture_style() -> dict[str, Any]:
    """Settings of matplotlib with which figures look like the pictures of the programs.

    >>> with matplotlib.rc_context(wrcontact.picture_style()): ...

    The colours are those of drivers/support/gnuplot.cpp.
    """
    from cycler import cycler

    sizes = ("font.size", "axes.titlesize", "axes.labelsize", "legend.fontsize", "xtick.labelsize", "ytick.labelsize",
             "figure.titlesize")
    return {"axes.prop_cycle": cycler(color=LINES),
            "axes.grid": True, "axes.axisbelow": True, "axes.edgecolor": _CONTOUR, "grid.color": "#d8d8d8",
            "legend.frameon": False, "axes.unicode_minus": False, "font.family": "DejaVu Sans", **dict.fromkeys(sizes, LETTER)}


def new_figure(rows: int, columns: int, size: tuple[float, float]) -> tuple[Any, Any]:
    """A figure without a window, independent of the global state of matplotlib."""
    import matplotlib
    from matplotlib.figure import Figure

    with matplotlib.rc_context(picture_style()):
        figure = Figure(figsize=(size[0] * columns, size[1] * rows), layout="constrained")
        return figure, figure.subplots(rows, columns, squeeze=False)


def _pressure_colours() -> Any:
    """Those of the pictures of the programs (drivers/support/gnuplot.cpp)."""
    from matplotlib.colors import LinearSegmentedColormap

    stops = ((0.0, "#fdf3c8"), (0.25, "#fcc75a"), (0.5, "#f28934"), (0.75, "#cc3d3d"), (1.0, "#6b1446"))
    return LinearSegmentedColormap.from_list("pressure", stops)


def saved(figure: Any, path: str | os.PathLike[str] | None) -> Any:
    if path is not None:
        figure.savefig(path, dpi=_PIXELS)
    return figure


def draw_profile(profile: Profile, path: str | os.PathLike[str] | None, ax: Any = None) -> Any:
    if ax is None:
        figure, ((axes,),) = new_figure(1, 1, (8.0, 4.5))
    else:
        figure, axes = ax.figure, ax
    curve = profile.at(np.arange(0.0, profile.length, 0.1))
    axes.plot(curve.lateral, curve.height, color=_RAIL if profile.kind == "rail" else _WHEEL)
    if profile.kind == "wheel":
        axes.invert_yaxis()  # the flange points down
    axes.set_title(profile.title, parse_math=False)  # a file's name may hold $
    axes.set(aspect="equal", xlabel="lateral, mm (to the field side)",
             ylabel="height, mm" if profile.kind == "rail" else "larger radius, mm (downwards)")
    return saved(figure, path)


def draw_conicity(conicity: Conicity, path: str | os.PathLike[str] | None, ax: Any = None) -> Any:
    if ax is None:
        figure, ((axes,),) = new_figure(1, 1, (7.0, 4.0))
    else:
        figure, axes = ax.figure, ax
    known = np.isfinite(conicity.conicity)
    amplitude, value = conicity.amplitude[known], conicity.conicity[known]
    spread = np.nan_to_num(conicity.spread[known])
    axes.plot(amplitude, value, color=_WHEEL)
    if spread.any():
        axes.fill_between(amplitude, value - spread, value + spread, color=_ADHESION, label="95 of 100 cases")
        axes.legend()
    axes.set(xlabel="amplitude, mm", ylabel="equivalent conicity", xlim=(0.0, None), ylim=(0.0, None))
    return saved(figure, path)


def draw_result(result: Result, path: str | os.PathLike[str] | None) -> Any:
    """Profiles, pressures and, where there are creep forces, tractions of each wheel; warnings below."""
    sides = [side for side in ("left", "right") if side in result._groups]
    pressures = any(result[side].pmax != 0.0 for side in sides)  # not a number of a contact that is cut
    tractions = any(name.endswith(".traction_max") for name in result._names)
    figure, axes = new_figure(1 + pressures + tractions, len(sides), _PANEL)
    for column, side in enumerate(sides):
        _draw_outlines(axes[0, column], result, side, first=column == 0)
        if pressures:
            _draw_pressures(axes[1, column], result, side)
        if tractions:
            _draw_tractions(axes[-1, column], result, side, sides)
    _same_scale(axes[1:].flat, turned=_direction(result) > 0.0)
    _write_warnings(figure, result, len(sides))
    return saved(figure, path)


def draw_panel(result: Result, axes: Any, panel: str, side: str) -> Any:
    """One of the panels of draw_result, of one wheel."""
    panels: dict[str, Any] = {"outlines": _draw_outlines, "tractions": _draw_tractions, "pressures": _draw_pressures}
    if panel not in panels:
        raise InvalidArgument(f"panel is {panel!r}; must be one of {', '.join(sorted(panels))}")
    if side not in ("left", "right") or side not in result._groups:
        raise InvalidArgument(f"side is {side!r}; must be "
                              f"{' or '.join(one for one in ('left', 'right') if one in result._groups)}")
    panels[panel](axes, result, side)
    if panel != "outlines":
        _same_scale([axes], turned=_direction(result) > 0.0)
    return axes.figure


def _write_warnings(figure: Any, result: Result, columns: int) -> None:
    """Below the panels, as the programs print them."""
    graded = result._graded()
    lines = lines_of(graded)
    if len(lines) > _MOST_WARNINGS:
        lines[_MOST_WARNINGS - 1:] = [f"and {len(lines) - _MOST_WARNINGS + 1} more warnings"]
    most = _LETTERS * columns
    text = "\n".join(line if len(line) <= most else line[:most] + "..." for line in lines)
    if text:
        colour = MARKED if GRADES[worst_of(graded)] == "do not use" else NOTE
        figure.supxlabel(text, x=0.006, horizontalalignment="left", fontsize=LETTER, color=colour, parse_math=False)


def _set_extent(axes: Any, places: Sequence[Array]) -> None:
    """What is to be seen: elements in contact, as pairs of across and along."""
    joined = np.concatenate(places, axis=1)
    axes.dataLim.set_points(np.array([joined.min(axis=1), joined.max(axis=1)]))


def _same_scale(all_axes: Iterable[Any], turned: bool) -> None:
    """The same number of mm across and along in each, with room for labels; y to the left is drawn on the left."""
    drawn = [axes for axes in all_axes if axes.has_data()]
    if not drawn:
        return
    size = np.max([axes.dataLim.size for axes in drawn], axis=0)
    width = max(size[0] / _SHARES[0], size[1] / _SHARES[1] * _RATIO)
    half = 0.5 * np.array([width, width / _RATIO])
    for axes in drawn:
        x, y = (axes.dataLim.min + axes.dataLim.max) / 2
        axes.set(xlim=(x - half[0], x + half[0]), ylim=(y - half[1], y + half[1]))
        if turned:
            axes.invert_xaxis()


def _colour_of(index: int) -> str:
    """Of a patch."""
    return MARKED if index == 0 else LINES[(index + 1) % len(LINES)]


def _units(result: Result) -> list[str]:
    return str(result["units"]).split(", ")


def _force_text(newtons: float) -> str:
    """With three digits, in N or kN."""
    value, unit = (1e-3 * newtons, "kN") if newtons >= 1e3 else (newtons, "N")
    return f"{value:.{2 if value < 10.0 else 1 if value < 100.0 else 0}f} {unit}"


def _pressure_text(value: float, unit: str) -> str:
    return f"{value:.0f} {unit}" if unit == "MPa" else f"{value:.4g} {unit}"


def _to_the_left(result: Result) -> str:
    return "to the left" if _direction(result) > 0.0 else "to the right"


def _direction(result: Result) -> float:
    """+1 where y is positive to the left, which is drawn on the left, -1 otherwise."""
    return 1.0 if "y left" in str(result["frame"]) else -1.0


def _draw_outlines(axes: Any, result: Result, side: str, first: bool = True) -> None:
    """first: the legend says what the lines are. It is on the field side: forces lean to the other one."""
    wheel, touch, up = result[side], result[side].rigid_contact, _direction(result)
    patches, unit = wheel.patches, _units(result)[0]
    mm = 1.0 if unit == "mm" else 1e-3
    beside, below, above = (mm * length for length in _AROUND)
    # To the left and upwards: around the first touch, and all patches. As high as its panel, with the room on top.
    across = up * np.array([touch.y, *(patch.y for patch in patches)])
    height = up * np.array([touch.z, *(patch.z for patch in patches)])
    room = _AROUND_PATCH * mm
    to_left, to_right = max(across[0] + beside, across.max() + room), min(across[0] - beside, across.min() - room)
    bottom = min(height[0] - below, height.min() - room)
    scale = (to_left - to_right) / (2.0 * beside)
    top = max(height[0] + above, height.max() + room, bottom + (to_left - to_right) / _RATIO)
    for body, colour, fill, away in (("rail", _RAIL, _RAIL_BODY, -1e3), ("wheel", _WHEEL, _WHEEL_BODY, 1e3)):
        y, z = wheel[f"{body}_y"], wheel[f"{body}_z"]
        axes.fill_between(y, z, z + up * away * mm, color=fill, linewidth=0)
        axes.plot(y, z, color=colour, label=body if first else None)
    forces = [patch["normal_force"] if f"{patch._prefix}normal_force" in result._names else None for patch in patches]
    largest = max((force for force in forces if force), default=1.0)
    for index, (patch, force) in enumerate(zip(patches, forces)):
        along = scale * _HALF_PLANE * mm * np.array([np.cos(patch.plane_angle), np.sin(patch.plane_angle)])
        y, z = patch.y + along[0] * np.array([-1, 1]), patch.z + along[1] * np.array([-1, 1])
        label = f"patch {index}: " + (f"{_force_text(force)}, " if force is not None else "") + f"{1e3 * patch.angle:.1f} mrad"
        if force is not None:
            length = up * mm * scale * max(_ARROW[0] * force / largest, _ARROW[1])
            start = np.array([patch.centroid.y, patch.centroid.z])
            axes.annotate("", start + length * np.array([-np.sin(patch.angle), np.cos(patch.angle)]), start, zorder=10,
                          arrowprops={"arrowstyle": "-|>", "color": _colour_of(index), "linewidth": 1.5, "shrinkA": 0,
                                      "shrinkB": 0})
        axes.plot(y, z, color=_colour_of(index), linewidth=2.5, label=label)
    axes.plot(touch.y, touch.z, "o", color="black", fillstyle="none", linestyle="none", label="first touch" if first else None)
    axes.set_title(f"{side} wheel, seen in driving direction", fontsize=LETTER)
    axes.set(aspect="equal", xlim=(up * to_left, up * to_right),
             ylim=(up * bottom, up * top), xlabel=f"track y, {unit} ({_to_the_left(result)})", ylabel=f"track z, {unit}")
    if axes.get_legend_handles_labels()[0]:
        axes.legend(loc=f"upper {side}", frameon=True, facecolor="white", framealpha=1.0, edgecolor="none", labelspacing=0.1,
                    borderpad=0.2)


def _developed(patches: Sequence[Patch]) -> dict[str, float]:
    """Positions at which the references of patches are drawn, by their distances from each other."""
    ordered = sorted(patches, key=lambda patch: float(patch.y))
    places, place = {}, 0.0
    for before, patch in zip([*ordered[:1], *ordered], ordered):
        place += np.hypot(patch.y - before.y, patch.z - before.z)
        places[patch._prefix] = place
    main = places[patches[0]._prefix] if patches else 0.0
    return {prefix: place - main for prefix, place in places.items()}


def _in_plane(patch: Patch, y: Array, z: Array) -> Array:
    """Along the plane of a patch, from its reference."""
    along: Array = (y - patch.y) * np.cos(patch.plane_angle) + (z - patch.z) * np.sin(patch.plane_angle)
    return along


def _frame(axes: Any, result: Result, title: str) -> None:
    unit = _units(result)[0]
    axes.set_title(title, fontsize=LETTER)
    axes.set(aspect="equal", xlabel=f"along the planes of the patches, {unit} ({_to_the_left(result)})",
             ylabel=f"track x, {unit} (forward)")
    axes.locator_params(steps=[1, 2, 5, 10])
    if not axes.has_data():
        axes.axis("off")


def _squares(pressure: Array) -> Array:
    """p^2, which is smooth up to the edge of the contact, and goes on below 0 along lines beside it."""
    squares = np.pad(np.maximum(pressure, 0.0) ** 2, 2)
    outside, around = squares[2:-2, 2:-2] == 0.0, []
    for axis in (0, 1):
        for step in (-1, 1):
            next_one, second = (np.roll(squares, step * k, axis)[2:-2, 2:-2] for k in (1, 2))
            around.append(np.where(next_one > 0.0, np.minimum(2.0 * next_one - second, 0.0), np.nan))
    known = ~np.all(np.isnan(around), axis=0) & outside
    beyond = np.full(pressure.shape, -np.inf)
    beyond[known] = np.nanmean(np.array(around)[:, known], axis=0)
    squares = np.where(outside, beyond, squares[2:-2, 2:-2])
    return np.where(np.isneginf(squares), squares[known].min(initial=0.0), squares)


def _colour_scale(highest: float) -> Any:
    from matplotlib.cm import ScalarMappable
    from matplotlib.colors import Normalize

    return ScalarMappable(Normalize(0.0, highest), _pressure_colours())


def _draw_map(axes: Any, lateral: Array, along: Array, pressure: Array, highest: float) -> None:
    """Colours between elements, with lines at the edge and at fifths of the highest pressure."""
    if min(pressure.shape) < 2 or not highest > 0.0:
        return
    squares = _squares(pressure)
    shares = np.linspace(0.0, 1.0, 65)
    levels = (highest * shares) ** 2
    levels[-1] = max(levels[-1], float(squares.max())) * (1.0 + 1e-9)
    colours = _pressure_colours()(0.5 * (shares[1:] + shares[:-1]))
    axes.contourf(lateral, along, squares, levels=levels, colors=colours)
    axes.contour(lateral, along, squares, levels=(highest * np.array([0.05, 0.2, 0.4, 0.6, 0.8])) ** 2, colors=_CONTOUR,
                 linewidths=0.8)


def _draw_pressures(axes: Any, result: Result, side: str) -> None:
    wheel, patches, units = result[side], result[side].patches, _units(result)
    title = f"{side} wheel: no contact"
    places = _developed(patches)
    is_bounded = np.isfinite(wheel.pmax)
    highest = wheel.pmax if is_bounded else max((patch.pressure.max() for patch in patches), default=0.0)
    peak = _pressure_text(wheel.pmax, units[2]) if is_bounded else "without bound"
    extent = []
    from_right = sorted(enumerate(patches), key=lambda entry: float(entry[1].y))
    for number, (index, patch) in enumerate(from_right):
        lateral = places[patch._prefix] + _in_plane(patch, patch.field("y"), patch.field("z"))
        lateral[:] = lateral.mean(axis=1, keepdims=True)  # without rounding, of which matplotlib warns
        x = patch.field("x")
        _draw_map(axes, lateral, x, patch.pressure, highest)
        loaded = patch.pressure > 0.0
        if loaded.any():  # labels of neighbours stand above and below in turn
            above = number % 2 == 0
            extent.append(np.array([lateral[loaded], x[loaded]]))
            axes.annotate(f"patch {index}\n{_force_text(patch.normal_force)}\n{1e3 * patch.angle:.1f} mrad",
                          (0.5 * (lateral[loaded].min() + lateral[loaded].max()), x[loaded].max() if above else x[loaded].min()),
                          xytext=(0, 9 if above else -9), textcoords="offset points", ha="center", color=_colour_of(index),
                          va="bottom" if above else "top", linespacing=1.0)
        area = f"{wheel.area:.1f}" if units[0] == "mm" else f"{wheel.area:.4g}"
        title = (f"p$_\\mathrm{{max}}$ {peak}, area {area} {units[0]}$^2$, vertical {_force_text(abs(wheel.vertical_force))}")
    if extent:
        _set_extent(axes, extent)
        axes.figure.colorbar(_colour_scale(highest), cax=axes.inset_axes((1.03, 0.0, 0.05, 1.0)), label=f"pressure, {units[2]}")
    _frame(axes, result, title)


def _parts_with_tractions(result: Result, side: str) -> list[tuple[Patch, Patch]]:
    """Patches and their parts, themselves if they have none."""
    return [(patch, part) for patch in result[side].patches for part in (patch.parts or [patch])
            if f"{part._prefix}traction_max" in result._names]


def _strides(part: Patch) -> tuple[int, int]:
    """Elements from arrow to arrow, across and along."""
    across, along = (int(part[f"creep_grid.{way}"]) for way in _WAYS)
    return across // _MOST_ARROWS + 1, along // _MOST_ARROWS + 1


def _arrow_scale(result: Result, sides: Iterable[str]) -> tuple[float, float]:
    """Traction for each mm of an arrow, those of neighbours touching where it is largest, and a round one to be shown."""
    parts = [part for side in sides for _, part in _parts_with_tractions(result, side)]
    step = max(stride * float(part[f"creep_element_size.{way}"]) for part in parts for way, stride in zip(_WAYS, _strides(part)))
    largest = max(float(part["traction_max"]) for part in parts)
    return largest / (1.2 * step) or 1.0, float(f"{0.5 * largest:.0e}")


def _draw_tractions(axes: Any, result: Result, side: str, sides: Sequence[str] = ()) -> None:
    """sides: those whose arrows have the same scale."""
    units, arrows, extent, largest = _units(result), [], [], 0.0
    patches = result[side].patches
    places = _developed(patches)
    for patch, part in _parts_with_tractions(result, side):
        lateral = places[patch._prefix] + _in_plane(patch, part.creep_y, part.creep_z)
        loaded = part.creep_pressure > 0.0
        traction = np.hypot(part.traction_x, part.traction_y)
        slips = traction >= _ON_BOUND * part.friction * part.creep_pressure
        if min(loaded.shape) > 1:
            squares = _squares(part.creep_pressure)
            for area, colour in ((squares, _ADHESION), (np.where(loaded & ~slips, -squares, squares), _SLIP)):
                axes.contourf(lateral, part.creep_x, area, levels=[0.0, 2.0 * squares.max()], colors=[colour])
        across, along = _strides(part)
        shown = np.zeros_like(loaded)
        shown[across // 2::across, along // 2::along] = True
        shown &= loaded
        arrows.append(np.array([lateral[shown], part.creep_x[shown], part.traction_y[shown], part.traction_x[shown]]))
        extent.append(np.array([lateral[loaded], part.creep_x[loaded]]))
        largest = max(largest, float(traction.max()))
    title = f"{side} wheel: no tractions"
    if arrows:
        from matplotlib.patches import Patch as Area

        lateral, x, to_left, forward = np.concatenate(arrows, axis=1)
        scale, rounded = _arrow_scale(result, sides or [side])
        drawn = axes.quiver(lateral, x, to_left, forward, angles="xy", scale_units="xy", width=0.003, color=_ARROW_COLOUR,
                            scale=scale)
        _set_extent(axes, extent)
        axes.quiverkey(drawn, 0.08, 0.93, rounded, _pressure_text(rounded, units[2]), labelpos="E", color=_ARROW_COLOUR,
                       angle=180.0 if _direction(result) > 0.0 else 0.0)
        axes.legend(handles=[Area(color=_ADHESION, label="adhesion"), Area(color=_SLIP, label="slip")], loc="upper right",
                    labelspacing=0.1, borderpad=0.2, frameon=False)
        forces = [sum(patch[f"creep_force.{way}"] for patch in patches) for way in ("longitudinal", "lateral")]
        title = (f"tractions on the {side} wheel: {1e-3 * forces[0]:.2f} kN forward, {1e-3 * forces[1]:.2f} kN "
                 f"{_to_the_left(result)}, at most {_pressure_text(largest, units[2])}")
    _frame(axes, result, title)
