"""Pictures, by matplotlib, which is loaded when the first one is drawn."""
from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from ._library import Array
from .errors import InvalidArgument

if TYPE_CHECKING:
    from .conicity import Conicity
    from .profile import Profile
    from ._names import Patch
    from .result import Result

_RAIL, _WHEEL, _PLANE = "#8b5a2b", "#1f4e9e", "#c00000"
_RAIL_BODY, _WHEEL_BODY = "#f3ebe3", "#e9eff8"
_ADHESION, _SLIP = "#cfe2f3", "#f6c7b6"
_HALF_PLANE = 9.0  # mm, drawn of the plane of a patch
_AROUND = (45.0, 26.0, 34.0)  # mm beside, below and above the first touch
_AROUND_PATCH = 15.0  # mm around its reference
_ARROW = 20.0  # mm, of the largest force of a wheel
_MOST_ARROWS = 14  # along and across a patch
_ON_BOUND = 1.0 - 1e-6  # share of friction times pressure from which an element slips


def picture_style() -> dict[str, Any]:
    """Settings of matplotlib with which figures look like the pictures of the programs.

    >>> with matplotlib.rc_context(wrcontact.picture_style()): ...

    The colours are those of drivers/support/gnuplot.cpp.
    """
    from cycler import cycler

    sizes = ("font.size", "axes.titlesize", "axes.labelsize", "legend.fontsize", "xtick.labelsize", "ytick.labelsize",
             "figure.titlesize")
    return {"axes.prop_cycle": cycler(color=["#0060ad", "#d55e00", "#009e73", "#7030a0", "#a08000", "#404040"]),
            "axes.grid": True, "axes.axisbelow": True, "axes.edgecolor": "#404040", "grid.color": "#d8d8d8",
            "legend.frameon": False, "font.family": "DejaVu Sans", **dict.fromkeys(sizes, 10.0)}


def _figure(rows: int, columns: int, size: tuple[float, float]) -> tuple[Any, Any]:
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


def _save(figure: Any, path: str | os.PathLike[str] | None) -> Any:
    if path is not None:
        figure.savefig(path, dpi=110, bbox_inches="tight")
    return figure


def draw_profile(profile: Profile, path: str | os.PathLike[str] | None, ax: Any = None) -> Any:
    if ax is None:
        figure, ((axes,),) = _figure(1, 1, (8.0, 4.5))
    else:
        figure, axes = ax.figure, ax
    curve = profile.at(np.arange(0.0, profile.length, 0.1))
    axes.plot(curve.lateral, curve.height, color=_RAIL if profile.kind == "rail" else _WHEEL)
    if profile.kind == "wheel":
        axes.invert_yaxis()  # the flange points down
    axes.set_title(profile.title, parse_math=False)  # a file's name may hold $
    axes.set(aspect="equal", xlabel="lateral, mm (to the field side)",
             ylabel="height, mm" if profile.kind == "rail" else "larger radius, mm (downwards)")
    return _save(figure, path)


def draw_conicity(conicity: Conicity, path: str | os.PathLike[str] | None, ax: Any = None) -> Any:
    if ax is None:
        figure, ((axes,),) = _figure(1, 1, (7.0, 4.0))
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
    return _save(figure, path)


def draw_result(result: Result, path: str | os.PathLike[str] | None) -> Any:
    """Profiles, pressures and, where there are creep forces, tractions of each wheel."""
    sides = [side for side in ("left", "right") if side in result._groups]
    names = result._names
    pressures = any(result[side].pmax != 0.0 for side in sides)  # not a number of a contact that is cut
    tractions = any(name.endswith(".traction_max") for name in names)
    figure, axes = _figure(1 + pressures + tractions, len(sides), (6.2, 4.6))
    units = str(result["units"]).split(", ")
    for column, side in enumerate(sides):
        _draw_outlines(axes[0, column], result, side, units)
        if pressures:
            _draw_pressures(figure, axes[1, column], result, side, units)
        if tractions:
            _draw_tractions(axes[2, column], result, side, units)
    _same_scale(axes[1:].flat, turned=_direction(result) > 0.0)
    return _save(figure, path)


def draw_panel(result: Result, axes: Any, panel: str, side: str) -> Any:
    """One of the panels of draw_result, of one wheel."""
    panels: dict[str, Any] = {
        "outlines": _draw_outlines, "tractions": _draw_tractions,
        "pressures": lambda *arguments: _draw_pressures(axes.figure, *arguments)}
    if panel not in panels:
        raise InvalidArgument(f"panel is {panel!r}; must be one of {', '.join(sorted(panels))}")
    if side not in ("left", "right") or side not in result._groups:
        raise InvalidArgument(f"side is {side!r}; must be "
                              f"{' or '.join(one for one in ('left', 'right') if one in result._groups)}")
    panels[panel](axes, result, side, str(result["units"]).split(", "))
    if panel != "outlines":
        _same_scale([axes], turned=_direction(result) > 0.0)
    return axes.figure


def _same_scale(all_axes: Iterable[Any], turned: bool) -> None:
    """The same number of mm across and along in each, with a margin; y to the left is drawn on the left."""
    drawn = [axes for axes in all_axes if axes.has_data()]
    half = np.max([axes.dataLim.size for axes in drawn], axis=0, initial=0.0) * 0.5 * 1.15
    for axes in drawn:
        x, y = (axes.dataLim.min + axes.dataLim.max) / 2
        axes.set(xlim=(x - half[0], x + half[0]), ylim=(y - half[1], y + half[1]))
        if turned:
            axes.invert_xaxis()


def _patches(result: Result, side: str) -> list[Patch]:
    return list(result[side].patches) if f"{side}.patches" in result._groups else []


def _direction(result: Result) -> float:
    """+1 where y is positive to the left, which is drawn on the left, -1 otherwise."""
    return 1.0 if "y left" in str(result["frame"]) else -1.0


def _draw_outlines(axes: Any, result: Result, side: str, units: list[str]) -> None:
    wheel, touch, up = result[side], result[side].rigid_contact, _direction(result)
    mm = 1.0 if units[0] == "mm" else 1e-3
    for body, colour, fill, away in (("rail", _RAIL, _RAIL_BODY, -1e3), ("wheel", _WHEEL, _WHEEL_BODY, 1e3)):
        y, z = wheel[f"{body}_y"], wheel[f"{body}_z"]
        axes.fill_between(y, z, z + up * away * mm, color=fill, linewidth=0)
        axes.plot(y, z, color=colour, label=body)
    largest = max((patch.normal_force for patch in _patches(result, side)
                   if f"{patch._prefix}normal_force" in result._names), default=0.0)
    for index, patch in enumerate(_patches(result, side)):
        along = _HALF_PLANE * mm * np.array([np.cos(patch.plane_angle), np.sin(patch.plane_angle)])
        y, z = patch.y + along[0] * np.array([-1, 1]), patch.z + along[1] * np.array([-1, 1])
        label = f"patch {index}: {1e3 * patch.angle:.1f} mrad"
        if f"{patch._prefix}normal_force" in result._names:
            label += f", {patch.normal_force:.5g} {units[1]}"
            length = up * _ARROW * mm * patch.normal_force / (largest or 1.0)
            start = np.array([patch.centroid.y, patch.centroid.z])
            axes.annotate("", start + length * np.array([-np.sin(patch.angle), np.cos(patch.angle)]), start,
                          zorder=10, arrowprops={"arrowstyle": "-|>", "color": _PLANE, "linewidth": 1.5})
        axes.plot(y, z, color=_PLANE, linewidth=2.5, label=label)
    axes.plot(touch.y, touch.z, "o", color="black", fillstyle="none", label="first touch")
    beside, below, above = (mm * length for length in _AROUND)
    # To the left and upwards: around the first touch, and all patches.
    across = up * np.array([touch.y, *(patch.y for patch in _patches(result, side))])
    height = up * np.array([touch.z, *(patch.z for patch in _patches(result, side))])
    room = _AROUND_PATCH * mm
    axes.set(title=f"{side} wheel, seen in driving direction", aspect="equal",
             xlim=(up * max(across[0] + beside, across.max() + room), up * min(across[0] - beside, across.min() - room)),
             ylim=(up * min(height[0] - below, height.min() - room), up * max(height[0] + above, height.max() + room)),
             xlabel=f"track y, {units[0]}", ylabel=f"track z, {units[0]}")
    axes.legend(loc="upper left", frameon=True, facecolor="white", framealpha=1.0, edgecolor="none")


def _developed(patches: list[Patch]) -> dict[str, float]:
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


def _frame(axes: Any, units: list[str], title: str) -> None:
    axes.set(title=title, aspect="equal", xlabel=f"along the planes of the patches, {units[0]}",
             ylabel=f"track x, {units[0]} (forward)")
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
    axes.contour(lateral, along, squares, levels=(highest * np.array([0.05, 0.2, 0.4, 0.6, 0.8])) ** 2, colors="#404040",
                 linewidths=0.8)


def _draw_pressures(figure: Any, axes: Any, result: Result, side: str, units: list[str]) -> None:
    wheel, patches = result[side], _patches(result, side)
    title = f"{side} wheel: no contact"
    places = _developed(patches)
    is_bounded = np.isfinite(wheel.pmax)
    highest = wheel.pmax if is_bounded else max((patch.pressure.max() for patch in patches), default=0.0)
    peak = f"{wheel.pmax:.5g} {units[2]}" if is_bounded else "without bound"
    for patch in patches:
        lateral = places[patch._prefix] + _in_plane(patch, patch.field("y"), patch.field("z"))
        lateral[:] = lateral.mean(axis=1, keepdims=True)  # without rounding, of which matplotlib warns
        _draw_map(axes, lateral, patch.field("x"), patch.pressure, highest)
        title = f"pmax {peak}, area {wheel.area:.4g} {units[0]}$^2$"
    if patches:
        figure.colorbar(_colour_scale(highest), ax=axes, label=f"pressure, {units[2]}")
    _frame(axes, units, title)


def _draw_tractions(axes: Any, result: Result, side: str, units: list[str]) -> None:
    title, arrows = f"{side} wheel: no tractions", []
    patches = _patches(result, side)
    places = _developed(patches)
    for patch in patches:
        parts = list(patch.parts) if f"{patch._prefix}parts" in result._groups else [patch]
        for part in parts:
            if f"{part._prefix}traction_max" not in result._names:
                continue
            lateral = places[patch._prefix] + _in_plane(patch, part.creep_y, part.creep_z)
            loaded = part.creep_pressure > 0.0
            traction = np.hypot(part.traction_x, part.traction_y)
            slips = traction >= _ON_BOUND * part.friction * part.creep_pressure
            if min(loaded.shape) > 1:
                squares = _squares(part.creep_pressure)
                for area, colour in ((squares, _ADHESION), (np.where(loaded & ~slips, -squares, squares), _SLIP)):
                    axes.contourf(lateral, part.creep_x, area, levels=[0.0, 2.0 * squares.max()], colors=[colour])
            steps = [slice(size // _MOST_ARROWS // 2, None, size // _MOST_ARROWS + 1)
                     for size in loaded.shape]
            shown = np.zeros_like(loaded)
            shown[steps[0], steps[1]] = True
            shown &= loaded
            arrows.append(np.array([lateral[shown], part.creep_x[shown], part.traction_y[shown],
                                    part.traction_x[shown]]))
    if arrows:
        lateral, x, to_left, forward = np.concatenate(arrows, axis=1)
        largest = np.hypot(to_left, forward).max(initial=0.0)
        spacing = (np.ptp(lateral) + np.ptp(x)) / _MOST_ARROWS
        axes.quiver(lateral, x, to_left, forward, angles="xy", scale_units="xy", width=0.003,
                    scale=(largest or 1.0) / spacing, color="#303030")
        title = (f"tractions on the wheel, arrows up to {largest:.4g} {units[2]}\n"
                 "blue: adhesion, red: slip")
    _frame(axes, units, title)
