"""Input and output of CalculiX for two bodies in frictionless contact, one pressed on the other by a force. Units mm, N, MPa."""
from __future__ import annotations

import os
import re
import resource
import shutil
import subprocess
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

Array = Any
YOUNG, POISSON = 210e3, 0.3


@dataclass
class Model:
    """Nodes and hexahedra of both bodies, numbered from 0; `lower` is clamped, `upper` moves along z only."""

    nodes: Array
    elements: Array
    lower_elements: int  # the first ones
    clamped: Array
    moved: Array
    no_x: Array  # nodes on x = 0 and on the ends
    slave: Array  # elements whose outer face (nodes 5 to 8) may touch
    master: Array
    hanging: list[tuple[int, list[int], list[float]]]  # nodes between those of larger elements, with weights
    load: float  # N, on this half
    plastic: dict[str, str]  # cards of the materials LOWER and UPPER
    increments: tuple[float, ...] = (1.0,)  # of the load, one step each
    kind: str = "C3D8I"


def lines_of(numbers: Array) -> str:
    flat = [str(int(n) + 1) for n in np.ravel(numbers)]
    return "\n".join(",".join(flat[i:i + 12]) for i in range(0, len(flat), 12))


def deck(model: Model) -> str:
    nodes, elements, count = model.nodes, model.elements, model.lower_elements
    text = ["*NODE, NSET=ALL"]
    text += [f"{i + 1},{p[0]:.10f},{p[1]:.10f},{p[2]:.10f}" for i, p in enumerate(nodes)]
    for name, begin, end in (("LOWER", 0, count), ("UPPER", count, len(elements))):
        text.append(f"*ELEMENT, TYPE={model.kind}, ELSET={name}")
        text += [f"{i + 1}," + ",".join(str(n + 1) for n in elements[i]) for i in range(begin, end)]
    reference = int(model.moved[0])
    for name, members in (("CLAMPED", model.clamped), ("MOVED", model.moved), ("NO_X", model.no_x)):
        text.append(f"*NSET, NSET={name}\n{lines_of(members)}")
    for name, members in (("SLAVE", model.slave), ("MASTER", model.master)):
        text.append(f"*SURFACE, NAME={name}, TYPE=ELEMENT")
        text += [f"{e + 1},S2" for e in members]
    for name in ("LOWER", "UPPER"):
        text.append(f"*MATERIAL, NAME={name}\n*ELASTIC\n{YOUNG},{POISSON}")
        if name in model.plastic:
            text.append(model.plastic[name])
        text.append(f"*SOLID SECTION, ELSET={name}, MATERIAL={name}")
    text.append("*SURFACE INTERACTION, NAME=TOUCH\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD")
    text.append("*CONTACT PAIR, INTERACTION=TOUCH, TYPE=MORTAR\nSLAVE,MASTER")
    text.append("*BOUNDARY\nCLAMPED,1,3\nMOVED,1,2\nNO_X,1")
    for node in model.moved[1:]:
        text.append(f"*EQUATION\n2\n{node + 1},3,1.,{reference + 1},3,-1.")
    for node, masters, weights in model.hanging:
        for axis in (1, 2, 3):
            terms = [f"{node + 1},{axis},-1."] + [f"{m + 1},{axis},{w:.12g}" for m, w in zip(masters, weights)]
            text.append(f"*EQUATION\n{len(terms)}\n" + "\n".join(terms))
    for share in model.increments:
        text.append("*STEP, INC=100\n*STATIC, SOLVER=SPOOLES\n1.,1.,0.01,1.\n*CONTROLS, PARAMETERS=FIELD\n0.001,0.001")
        text.append(f"*CLOAD\n{reference + 1},3,{-model.load * share:.6f}")
        text.append("*NODE PRINT, NSET=CLAMPED, TOTALS=ONLY\nRF")
        text.append("*CONTACT FILE\nCDIS,CSTR\n*NODE FILE, NSET=ALL\nU")
        text.append("*EL FILE\nS" + (",PEEQ" if model.plastic else ""))
        text.append("*END STEP")
    return "\n".join(text) + "\n"


@dataclass
class Solution:
    displacement: Array
    stress: Array  # xx yy zz xy yz zx, by node
    plastic_strain: Array  # equivalent, by node
    pressure: Array  # by node; not-a-number at nodes that cannot touch
    reaction: Array  # of the clamped nodes
    iterations: int
    seconds: float  # of the processor


def frd_blocks(path: Path, count: int) -> list[dict[str, Array]]:
    """Blocks by name, of each step; values by node."""
    found: list[dict[str, Array]] = []
    with path.open(encoding="ascii", errors="replace") as file:
        name = ""
        rows: list[str] = []
        for line in file:
            code = line[:3]
            if code == " -4":
                name, rows = line[5:13].strip(), []
            elif code == " -1" and name:
                rows.append(line)
            elif code == " -3" and name:
                columns = (len(rows[0].rstrip("\n")) - 13) // 12
                values = np.full((count, columns), np.nan)
                for row in rows:
                    values[int(row[3:13]) - 1] = [float(row[13 + 12 * i:25 + 12 * i]) for i in range(columns)]
                if not found or name in found[-1]:
                    found.append({})
                found[-1][name] = values
                name = ""
    return found


def run(model: Model, folder: Path, *, timeout: float = 7200.0) -> list[Solution]:
    """Runs ccx on one processor in the folder; a solution of each step."""
    program = shutil.which("ccx")
    if program is None:
        raise FileNotFoundError("ccx is not installed (Debian package calculix-ccx)")
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "contact.inp").write_text(deck(model), encoding="ascii")
    environment = {**os.environ, "OMP_NUM_THREADS": "1", "CCX_NPROC_RESULTS": "1", "CCX_NPROC_EQUATION_SOLVER": "1"}
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([program, "-i", "contact"], cwd=folder, env=environment, capture_output=True, text=True,
                          check=False, timeout=timeout)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    (folder / "output.txt").write_text(done.stdout + done.stderr, encoding="utf-8")
    if done.returncode or "*ERROR" in done.stdout or "Job finished" not in done.stdout:
        raise RuntimeError(f"ccx failed: {folder}/output.txt ends with {done.stdout[-400:]}")
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    (folder / "seconds.txt").write_text(f"{seconds:.1f}\n", encoding="ascii")
    return read(model, folder)


def read(model: Model, folder: Path) -> list[Solution]:
    """What a finished run has left."""
    output = (folder / "output.txt").read_text(encoding="utf-8")
    seconds = float((folder / "seconds.txt").read_text(encoding="ascii"))
    iterations = len(re.findall(r"^ iteration\s+\d+", output, re.MULTILINE))
    sums = (folder / "contact.dat").read_text(encoding="ascii").split("total force")[1:]
    solutions = []
    for blocks, text in zip(frd_blocks(folder / "contact.frd", len(model.nodes)), sums):
        peeq = blocks.get("PE", np.zeros((len(model.nodes), 1)))
        reaction = np.array([float(v) for v in text.splitlines()[2].split()])
        solutions.append(Solution(blocks["DISP"], blocks["STRESS"], peeq[:, 0], blocks["CONTACT"][:, 3], reaction, iterations, seconds))
    return solutions
