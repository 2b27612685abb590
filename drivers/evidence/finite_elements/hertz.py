#!/usr/bin/env python3
"""The finite elements of the three contacts on one that has a closed form: a cylinder of 460 mm on one of 80 mm, crossed, elastic.

    drivers/evidence/finite_elements/hertz.py

Two meshes, the finer one with half as large elements, less than a minute together; needs ccx (Debian package calculix-ccx), numpy
and scipy. Prints pmax, area and the approach of points 10 mm deep against Hertz. The latter takes the displacement at the depth from
the point force (Boussinesq) summed over Hertz's pressures, so that it does not depend on how the bodies are held.
"""
from __future__ import annotations

import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import calculix  # noqa: E402
from contact_mesh import LENGTH, RATIO, Section, Sizes, rail_body, wheel_body, zone_and_outside  # noqa: E402
from figures import DEEP, finite_element_figures  # noqa: E402
from scenes import Blocks, Case, Scene, model_of  # noqa: E402
from profile_surfaces import Graph, Wheel  # noqa: E402

Array = Any
WHEEL, RAIL, LOAD = 460.0, 80.0, 40e3  # mm, mm, N
MODULUS = calculix.YOUNG / (2 * (1 - calculix.POISSON**2))
SIZES = {1: 2.0, 2: 1.0}  # factors of the elements


def closed_form() -> dict[str, float]:
    """Johnson, Contact Mechanics, 4.2: A, B and the depth from pmax and both half-axes, a >= b; a along the rail."""
    one, other = 0.5 / WHEEL, 0.5 / RAIL

    def ratio_error(e2: float) -> float:
        k2 = 1 - e2
        return float(other / one - (ellipe(e2) / k2 - ellipk(e2)) / (ellipk(e2) - ellipe(e2)))

    e2 = brentq(ratio_error, 1e-6, 1 - 1e-9)
    k = np.sqrt(1 - e2)

    def curvature(length: float) -> float:
        p0 = 1.5 * LOAD / (np.pi * length * k * length)
        return float(p0 * k / (MODULUS * length * e2) * (ellipk(e2) - ellipe(e2)) - one)

    a = brentq(curvature, 0.1, 50.0)
    b, p0 = k * a, 1.5 * LOAD / (np.pi * k * a * a)
    depth = p0 * b / MODULUS * float(ellipk(e2))
    # Displacement DEEP below the middle, by rings of the ellipse with equal polar angle.
    r, w = np.polynomial.legendre.leggauss(60)  # type: ignore[no-untyped-call]
    r, w = 0.5 * (1 + r), 0.5 * w
    t = (np.arange(64) + 0.5) * np.pi / 128
    place = np.multiply.outer(r**2, a**2 * np.cos(t)**2 + b**2 * np.sin(t)**2)
    force = np.multiply.outer(p0 * np.sqrt(1 - r**2) * a * b * r * w, np.full(64, 2 * np.pi / 64))
    away = np.sqrt(place + DEEP**2)
    deep = np.sum(force * (2 * (1 - calculix.POISSON) / away + DEEP**2 / away**3)) * (1 + calculix.POISSON) / (2 * np.pi * calculix.YOUNG)
    return {"pmax": p0, "area": float(np.pi * a * b), "approach 10 mm deep": depth - 2 * float(deep), "a": a, "b": b, "depth": depth}


def finite_elements(mesh: int, folder: Path) -> dict[str, Any]:
    truth = closed_form()
    turn = np.linspace(-0.42, 0.42, 2001)
    section = Section(-RAIL * np.sin(turn), RAIL * (np.cos(turn) - 1), turn)
    wheel = Wheel(Graph(np.linspace(-40, 40, 81), np.full(81, WHEEL), np.zeros(81)), 0.0, 0.0, 0.0, WHEEL - truth["depth"])
    factor = SIZES[mesh]
    sizes = Sizes(0.9 * factor, 0.6 * factor, 1.45**factor**0.7, 14.0)
    middle = 0.5 * section.arc[-1]
    reach = truth["b"] + 1.2
    count = 2 * RATIO * int(2 / factor)  # a row in the middle goes on outside of the core
    core = np.linspace(middle - reach, middle + reach, count + 1)
    along = zone_and_outside((0.0, truth["a"] + 1.5), sizes.along, sizes, (0.0, LENGTH))
    lines = [zone_and_outside((0.0, 4.0), sizes.depth, sizes, (0.0, end)) for end in (50.0, 60.0)]
    lower = rail_body(section, core, along, lines[0], sizes, 0.0, 16.0)
    upper = wheel_body(wheel, section, core, along, lines[1], sizes, 16.0, 40.0)
    blocks = Blocks(model_of(lower, upper, 0.5 * LOAD, {}, (1.0,), {}), lower, upper, wheel)
    solution = calculix.run(blocks.model, folder)[-1]
    case = Case("Hertz", 0.0, ((0.0, 0.55 * factor),), sizes, 16.0, 4.0, -np.inf)
    scene = Scene({"roll": 0.0}, None, None, section, (float(core[0]), float(core[-1])), truth["a"])
    return finite_element_figures(case, scene, blocks, solution)


def main() -> None:
    truth = closed_form()
    print("| mesh | nodes | pmax | area | approach 10 mm deep | processor time, s |\n" + "|---" * 6 + "|")
    for mesh in SIZES:
        with tempfile.TemporaryDirectory() as scratch:
            found = finite_elements(mesh, Path(scratch))
        print(f"| {mesh} | {found['nodes']} | " + " | ".join(
            f"{found[key]:.4g} ({100 * (found[key] / truth[key] - 1):+.1f} %)" for key in ("pmax", "area", "approach 10 mm deep"))
            + f" | {found['seconds']:.0f} |")
    print("| Hertz | | " + " | ".join(f"{truth[key]:.4g}" for key in ("pmax", "area", "approach 10 mm deep")) + " | |")


if __name__ == "__main__":
    main()
