"""The shakedown map of rolling contact: which pressures and frictions steel bears without yielding in every cycle."""
from __future__ import annotations

import functools
import os
from typing import Any

import numpy as np

from ._library import Array
from .errors import InvalidArgument
from .plot import LETTER, LINES, MARKED, NOTE, new_figure, saved

# Elastic shakedown limit of a point contact without friction, p0/k: Ponter, Hearle & Johnson, J. Mech. Phys. Solids 33, 1985.
# It is where the greatest shear stress along the surface, 0.214 p0 below a circular contact, is k (Melan; Johnson 1985, 9.2).
POINT_LIMIT = 4.7
_POISSON = 0.3
_MOST_FRICTION = 2.0


@functools.lru_cache(maxsize=1)
def _stresses() -> tuple[Array, Array]:
    """Of p = p0 sqrt(1 - r^2/a^2) and of the traction q = p along x: xx, yy, zz and xz over p0, at points of y = 0.

    On the surface in closed form (Johnson 1985, eqs. 3.43 and 3.91), below it as sums of point forces (eqs. 3.19 and 3.76).
    x is where the traction points on the body; sigma < 0 presses.
    """
    nu = _POISSON
    x = np.linspace(-1.0, 1.0, 201)
    root = np.sqrt(1.0 - x**2)
    square = np.maximum(x**2, 1e-12)
    bend = (1.0 - 2.0 * nu) / 3.0 * np.where(x**2 < 1e-4, 1.5, (1.0 - root**3) / square)
    zero = np.zeros_like(x)
    of_p = [np.array([bend - root, -bend - 2.0 * nu * root, -root, zero])]
    of_q = [np.array([-np.pi * (4.0 + nu) / 8.0 * x, -3.0 * np.pi * nu / 8.0 * x, zero, -root])]

    gauss: Any = np.polynomial.legendre
    nodes, weights = gauss.leggauss(32)
    tilt = 0.25 * np.pi * (nodes + 1.0)  # radius sin(tilt), pressure cos(tilt)
    turn = (np.arange(64) + 0.5) * np.pi / 64  # one half: the other one is the same
    force = 2.0 * (0.25 * np.pi * weights * np.cos(tilt) ** 2 * np.sin(tilt))[:, None] * np.full(turn.size, np.pi / 64)
    from_x, y = np.sin(tilt)[:, None] * np.cos(turn), np.sin(tilt)[:, None] * np.sin(turn)
    for z in np.linspace(0.1, 1.2, 23):
        x = np.linspace(-1.2, 1.2, 49)[:, None, None] - from_x
        square, distance = x**2 + y**2, np.sqrt(x**2 + y**2 + z**2)
        share = (1.0 - z / distance) / square
        third, fifth = distance**-3, 3.0 * distance**-5
        across = (1.0 - 2.0 * nu) / square
        once, twice = 1.0 / (distance * (distance + z) ** 2), 2.0 / (distance**2 * (distance + z) ** 3)
        inner = once / distance**2 + twice
        of_p.append(np.array([np.sum(force * one, axis=(1, 2)) / (2.0 * np.pi) for one in (
            across * (share * (x**2 - y**2) + z * y**2 * third) - fifth * z * x**2,
            across * (share * (y**2 - x**2) + z * x**2 * third) - fifth * z * y**2,
            -fifth * z**3, -fifth * x * z**2)]))
        of_q.append(np.array([np.sum(force * one, axis=(1, 2)) / (2.0 * np.pi) for one in (
            -fifth * x**3 + (1.0 - 2.0 * nu) * x * (third - 3.0 * once + x**2 * inner),
            -fifth * x * y**2 + (1.0 - 2.0 * nu) * x * (third - once + y**2 * inner),
            -fifth * x * z**2, -fifth * x**2 * z)]))
    return np.concatenate(of_p, axis=1), np.concatenate(of_q, axis=1)


def limits(friction: float) -> tuple[float, float]:
    """p0/k at which yield begins (von Mises), and up to which rolling shakes down, of a circular contact that slides.

    The second is the smaller one of 4.7 and of the yield of the surface, 1/friction: an upper bound between.
    """
    if not 0.0 <= friction <= _MOST_FRICTION:
        raise InvalidArgument(f"friction = {friction}: must be between 0 and {_MOST_FRICTION:g}")
    of_p, of_q = _stresses()
    xx, yy, zz, xz = of_p + friction * of_q
    invariant = ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) / 6.0 + xz**2
    return float(1.0 / np.sqrt(invariant.max())), min(POINT_LIMIT, 1.0 / friction if friction > 0.0 else POINT_LIMIT)


def shakedown_map(friction: Any, pressure_ratio: Any, path: str | os.PathLike[str] | None = None, *, ax: Any = None) -> Any:
    """Draws contacts on the shakedown map of point contact; returns a matplotlib Figure, saved to `path`.

    friction, pressure_ratio: numbers or arrays of the same shape, results `fatigue.friction` (T/N) and
    `fatigue.pressure_ratio` (p0/k) of wheels or patches; those that are not numbers are left out. Red contacts are beyond a
    limit. The limits are those of full slip along the rail, of steel that does not harden: docs/damage.md. InvalidArgument.
    """
    f, ratio = (np.ravel(np.asarray(one, dtype=float)) for one in (friction, pressure_ratio))
    if f.shape != ratio.shape:
        raise InvalidArgument(f"pressure_ratio has {ratio.size} values; must have {f.size}, one for each friction")
    known = np.isfinite(f) & np.isfinite(ratio)
    f, ratio = f[known], ratio[known]
    if f.size and not (f.min() >= 0.0 and ratio.min() >= 0.0):
        raise InvalidArgument("friction, pressure_ratio: must be 0 or more")
    beyond = np.array([one > limits(min(at, _MOST_FRICTION))[1] for at, one in zip(f, ratio)], dtype=bool)
    if ax is None:
        figure, ((axes,),) = new_figure(1, 1, (7.0, 4.5))
    else:
        figure, axes = ax.figure, ax
    right, top = max(0.6, 1.1 * f.max(initial=0.0)), max(6.0, 1.1 * ratio.max(initial=0.0))
    along = np.linspace(0.0, min(right, _MOST_FRICTION), 241)
    elastic, shakedown = np.array([limits(one) for one in along]).T
    axes.plot(along, shakedown, color=LINES[-1], linewidth=2, label="shakedown, upper bound: 4.7, surface 1/friction")
    axes.plot(along, elastic, color=LINES[0], linewidth=1.5, linestyle="--", label="elastic limit")
    for kind, colour, label in ((~beyond, LINES[0], "contacts"), (beyond, MARKED, "contacts beyond the limit")):
        if kind.any():
            axes.plot(f[kind], ratio[kind], "o", color=colour, markersize=4, label=label, zorder=3)
    for at, height, text in ((0.01, 1.2, "elastic"), (0.01, 3.6, "elastic shakedown"), (0.01, 5.2, "yield below the surface"),
                             (0.4, 3.6, "yield of the surface")):
        axes.text(at, height, text, color=NOTE, fontsize=LETTER, zorder=1)
    axes.set(xlim=(0.0, right), ylim=(0.0, top), xlabel="utilised friction T/N", ylabel="p$_\\mathrm{max}$/k")
    axes.legend(loc="lower center", bbox_to_anchor=(0.5, 1.0), ncols=2, frameon=False)
    return saved(figure, path)
