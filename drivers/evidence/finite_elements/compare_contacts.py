#!/usr/bin/env python3
"""Three contacts of S1002 and 60E1 by finite elements (CalculiX), compared with the library: elastic, and with yielding steel.

    PYTHONPATH=build/release/python drivers/evidence/finite_elements/compare_contacts.py [--picture pressures.png]
    PYTHONPATH=build/release/python drivers/evidence/finite_elements/compare_contacts.py --case tread --mesh 1 --write results.json

The first command prints the tables of docs/evidence/half-space.md: it solves the scenes by the library and compares them with the
stored results of the finite elements (results.json beside this file). The second one computes one of these with CalculiX (ccx,
Debian package calculix-ccx) and replaces it in the file: cases tread, lobes, corner, inner, field; meshes 0 to 3 (coarse to fine);
--material elastic, plastic or unyielding (as plastic, without yield). Of inner and field yield_stresses.json has the figures. Needs numpy and scipy, the picture matplotlib. Methods: scenes.py, contact_mesh.py, figures.py.
"""
from __future__ import annotations

import argparse
import json
import platform
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
import calculix  # noqa: E402
from figures import finite_element_figures, library_measures  # noqa: E402
from scenes import ALL_CASES, CASES, LOAD, MATERIALS, SHARES, Scene, blocks_of, scene_of  # noqa: E402

MESHES = (0, 1, 2, 3)
# Name, in the finite elements and in the library, unit, digits, factor; differences are relative unless in %.
QUANTITIES = (("pmax", "pmax", "MPa", 0, 1.0), ("pmax of tread", "pmax of the tread", "MPa", 0, 1.0),
              ("share of corner", "share of the gauge corner", "%", 2, 100.0), ("area", "area", "mm^2", 1, 1.0),
              ("area of corner", "area at the gauge corner", "mm^2", 1, 1.0),
              ("width", "width", "mm", 2, 1.0), ("length", "length", "mm", 2, 1.0), ("Fy", "Fy", "kN", 2, 1e-3),
              ("von Mises at 2 mm", "von Mises stress, 2 mm deep", "MPa", 0, 1.0), ("von Mises at 3 mm", "3 mm deep", "MPa", 0, 1.0),
              ("von Mises at 2 mm of tread", "tread, 2 mm deep", "MPa", 0, 1.0),
              ("von Mises at 3 mm of tread", "tread, 3 mm deep", "MPa", 0, 1.0),
              ("depth", "depth", "um", 1, 1e3), ("approach 10 mm deep", "approach 10 mm deep", "um", 1, 1e3))


def rounded(value: Any) -> Any:
    """To eight digits."""
    if isinstance(value, dict):
        return {name: rounded(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(one) for one in value]
    return float(f"{value:.8g}") if isinstance(value, float) else value


def version_of_ccx() -> str:
    done = subprocess.run(["ccx", "-v"], capture_output=True, text=True, check=False)
    return done.stdout.strip().split()[-1]


def compute(name: str, mesh: int, material: str, folder: Path) -> dict[str, Any]:
    scene, blocks = blocks_of(name, mesh, material)
    finished = (folder / "seconds.txt").exists()
    solutions = calculix.read(blocks.model, folder) if finished else calculix.run(blocks.model, folder)
    steps = [finite_element_figures(ALL_CASES[name], scene, blocks, solution) for solution in solutions]
    common = {key: steps[-1][key] for key in ("nodes", "elements", "iterations", "seconds")}
    steps = [{key: value for key, value in step.items() if key not in common} for step in steps]
    result: dict[str, Any] = rounded({**common, "command": f"compare_contacts.py --case {name} --mesh {mesh} --material {material} --write results.json",
                    "versions": f"ccx {version_of_ccx()}, Python {platform.python_version()}, numpy {np.__version__}",
                    "worst corner": [blocks.lower.worst_corner(), blocks.upper.worst_corner()], "steps": steps})
    return result


class Library:
    """The library's figures of the scenes that the stored results have."""

    def __init__(self) -> None:
        self.scenes: dict[str, Scene] = {}

    def of(self, name: str, step: dict[str, Any], curved: str = "yes") -> dict[str, Any]:
        if name not in self.scenes:
            self.scenes[name] = scene_of(CASES[name].lateral)
        return library_measures(CASES[name], self.scenes[name], step["pose"], step["Fz"], step["crest"], curved)


def value_of(step: dict[str, Any], library: dict[str, Any], name: str, factor: float) -> float:
    return factor * float(library["depth of the finite elements"] if name == "depth" else step[name])


def stored(found: dict[str, Any], name: str, material: str) -> dict[int, list[dict[str, Any]]]:
    """Steps of the meshes that are there, at the shares of the load: where the iteration does not converge ccx puts steps in between."""
    keys = {mesh: f"{name} {material} {mesh}" for mesh in MESHES}
    wanted = [LOAD] if MATERIALS[material] is None else [share * LOAD for share in SHARES]
    return {mesh: [step for step in found[key]["steps"] if min(abs(step["Fz"] - load) for load in wanted) < 1.0]
            for mesh, key in keys.items() if key in found}


def elastic_table(found: dict[str, Any], library: Library) -> None:
    """Figures of all meshes, and how far those of the finest are from the library's; by how much the last refinement changed this."""
    print("| contact | quantity | wrcontact | finite elements, mesh " + " | mesh ".join(map(str, MESHES))
          + " | difference | last refinement |\n" + "|---" * (5 + len(MESHES)) + "|")
    for name, case in CASES.items():
        steps = {mesh: runs[-1] for mesh, runs in stored(found, name, "elastic").items()}
        if len(steps) < 2:
            continue
        by = {mesh: library.of(name, step) for mesh, step in steps.items()}
        finest, before = sorted(steps)[-1], sorted(steps)[-2]
        title = case.title
        for key, text, unit, digits, factor in QUANTITIES:
            if key not in by[finest]:
                continue
            own = {mesh: value_of(step, by[mesh], key, factor) for mesh, step in steps.items()}
            there = {mesh: factor * by[mesh][key] for mesh in steps}
            off = {mesh: own[mesh] - there[mesh] if unit == "%" else 100 * (own[mesh] / there[mesh] - 1) for mesh in steps}
            cells = [f"{own[mesh]:.{digits}f}" if mesh in own else "-" for mesh in MESHES]
            print(f"| {title} | {text}, {unit} | {there[finest]:.{digits}f} | " + " | ".join(cells)
                  + f" | {off[finest]:+.1f} % | {off[finest] - off[before]:+.1f} % |")
            title = ""


def plastic_table(found: dict[str, Any], library: Library) -> None:
    """Against the same finite elements without yielding, at the same force. The area is that of the nodes under pressure."""
    meshes = MESHES[:-1]
    print("| contact | load, kN | pmax, wrcontact | change of pmax, mesh " + " | mesh ".join(map(str, meshes))
          + " | of the area | of Fy | plastic strain of the rail, mesh " + " | mesh ".join(map(str, meshes))
          + " |\n" + "|---" * (5 + 2 * len(meshes)) + "|")
    for name, case in CASES.items():
        runs, without = stored(found, name, "plastic"), stored(found, name, "unyielding")
        both = sorted(set(runs) & set(without))
        for k, share in enumerate(SHARES if both else ()):
            def change(mesh: int, key: str) -> float:
                return 100 * (float(runs[mesh][k][key]) / float(without[mesh][k][key]) - 1)

            pmax = [f"{change(m, 'pmax'):+.1f} %" if m in both else "-" for m in meshes]
            strain = [f"{100 * runs[m][k]['plastic strain of rail']:.2f} %" if m in both else "-" for m in meshes]
            area = [f"{change(both[-1], key):+.0f} %" for key in ("nodes under pressure", "nodes under pressure of corner")
                    if key in runs[both[-1]][k]]
            print(f"| {case.title if k == 0 else ''} | {80 * share:.0f} | {library.of(name, runs[both[-1]][k])['pmax']:.0f} | {' | '.join(pmax)} | "
                  f"{', corner '.join(area)} | {change(both[-1], 'Fy'):+.1f} % | {' | '.join(strain)} |")


def cost_table(found: dict[str, Any]) -> None:
    print("| calculation | nodes | elements | iterations | processor time, s | worst corner of an element |\n" + "|---" * 6 + "|")
    for key in sorted(found):
        run = found[key]
        print(f"| {key} | {run['nodes']} | {run['elements']} | {run['iterations']} | {run['seconds']:.0f} | {min(run['worst corner']):.2f} |")


def draw_yielding(axis: Any, found: dict[str, Any], library: Library) -> None:
    """pmax with yielding steel against the elastic one."""
    for marker, (name, case) in zip("osd", CASES.items()):
        runs = stored(found, name, "plastic")
        if runs:
            steps = runs[max(runs)]
            axis.plot([library.of(name, step)["pmax"] for step in steps], [step["pmax"] for step in steps], marker + "-", label=case.title)
    axis.plot([0, 2400], [0, 2400], color="0.6", linewidth=0.8, label="elastic")
    axis.set_title("pmax, 20 to 80 kN")
    axis.set_xlabel("elastic (wrcontact), MPa")
    axis.set_ylabel("finite elements, yielding, MPa")
    axis.set_xlim(left=0)
    axis.legend()


def draw(found: dict[str, Any], library: Library, path: str) -> None:
    """Pressures of the rows in x = 0, and what yielding leaves of the greatest."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    import wrcontact

    plt.rcParams.update(wrcontact.picture_style())
    yielding = any(stored(found, name, "plastic") for name in CASES)
    figure, panels = plt.subplots(2, 2, figsize=(11, 7.6)) if yielding else plt.subplots(1, 3, figsize=(12.5, 4))
    axes = list(panels.ravel())
    for axis, (name, case) in zip(axes, CASES.items()):
        elastic, plastic = stored(found, name, "elastic"), stored(found, name, "plastic")
        step = elastic[max(elastic)][-1]
        rows = library.of(name, step)["rows"]
        # Rows of several patches are drawn one after the other, with a gap where there is no pressure.
        axis.plot(rows["y"], np.where(np.array(rows["crest"]) > 0, rows["crest"], np.nan), color="C0", label="wrcontact")
        axis.plot(step["rows"]["y"], step["rows"]["crest"], "o", markersize=4, color="C1", label="finite elements, elastic")
        if plastic:
            step = plastic[max(plastic)][-1]
            axis.plot(step["rows"]["y"], step["rows"]["middle"], "s-", markersize=3, linewidth=0.8, color="C2", label="finite elements, yielding")
        axis.set_title(case.title)
        axis.set_xlabel("y, mm (gauge side to the left)")
        axis.set_ylabel("pressure at x = 0, MPa")
    axes[1].legend()
    if yielding:
        draw_yielding(axes[3], found, library)
    for axis in axes:
        axis.set_ylim(bottom=0)
    figure.tight_layout()
    figure.savefig(path, dpi=80)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--case", choices=list(ALL_CASES), help="compute this contact with CalculiX")
    parser.add_argument("--mesh", type=int, choices=MESHES, default=1)
    parser.add_argument("--material", choices=list(MATERIALS), default="elastic")
    parser.add_argument("--folder", metavar="DIR", type=Path, help="for the files of CalculiX; a finished calculation there is read instead")
    parser.add_argument("--write", metavar="FILE", type=Path, help="add the result to this file")
    parser.add_argument("--read", metavar="FILE", type=Path, default=HERE / "results.json", help="print the tables of stored results")
    parser.add_argument("--picture", metavar="PNG", help="draw stored results")
    options = parser.parse_args()
    if options.case:
        with tempfile.TemporaryDirectory() as scratch:
            result = compute(options.case, options.mesh, options.material, options.folder or Path(scratch))
        if options.write:
            found = json.loads(options.write.read_text(encoding="utf-8")) if options.write.exists() else {}
            found[f"{options.case} {options.material} {options.mesh}"] = result
            lines = [f"{json.dumps(key)}: {json.dumps(found[key])}" for key in sorted(found)]
            options.write.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
        for step in result["steps"]:
            print(json.dumps({key: value for key, value in step.items() if key != "rows"}))
        return
    found, library = json.loads(options.read.read_text(encoding="utf-8")), Library()
    elastic_table(found, library)
    print(f"\nYield stress and hardening modulus, MPa: {MATERIALS['plastic']}")
    plastic_table(found, library)
    print()
    cost_table(found)
    if options.picture:
        draw(found, library, options.picture)


if __name__ == "__main__":
    main()
