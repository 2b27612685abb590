#!/usr/bin/env python3
"""Runs the notebook of the examples without Jupyter and compares its texts with those that it stores.

Usage: PYTHONPATH=build/release/python scripts/run_notebook.py [--update]

--update stores all outputs: texts, tables and pictures. The cells run in a folder of their own, below one with
measured_wheel.txt, as they lie where they are installed.
"""
import ast
import base64
import contextlib
import io
import json
import os
import shutil
import sys
import tempfile
import warnings
from pathlib import Path

from matplotlib.figure import Figure

PROJECT = Path(__file__).resolve().parent.parent
NOTEBOOK = PROJECT / "python_bindings/examples/contact.ipynb"
WHEEL = PROJECT / "tests/reference/profiles/Car7216_0001r.txt"


def shown(value):
    """What Jupyter stores of the value of a cell."""
    data = {"text/plain": [repr(value)]}
    if isinstance(value, Figure):
        file = io.BytesIO()
        value.savefig(file, format="png", dpi=70, bbox_inches="tight", metadata={"Software": None})
        data = {"text/plain": ["<Figure>"], "image/png": base64.b64encode(file.getvalue()).decode()}
    elif hasattr(value, "_repr_html_"):
        data["text/html"] = [value._repr_html_()]
    return data


def outputs_of(source, number, names):
    """What a cell prints and returns."""
    tree = ast.parse(source)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    printed, value = io.StringIO(), None
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, f"<cell {number}>", "exec"), names)
        if last is not None:
            value = eval(compile(ast.Expression(last.value), f"<cell {number}>", "eval"), names)
    outputs = []
    if printed.getvalue():
        outputs.append({"output_type": "stream", "name": "stdout", "text": printed.getvalue().splitlines(True)})
    if value is not None:
        outputs.append({"output_type": "execute_result", "execution_count": number, "metadata": {}, "data": shown(value)})
    return outputs


def texts_of(outputs):
    """Kinds and texts, which do not depend on matplotlib's version as pictures and tables do."""
    return [(one["output_type"], sorted(one.get("data", [])), one.get("text") or one["data"]["text/plain"]) for one in outputs]


def run(update):
    notebook, names, failures = json.loads(NOTEBOOK.read_text(encoding="utf-8")), {"__name__": "__main__"}, 0
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings():
        warnings.simplefilter("ignore")
        shutil.copy(WHEEL, Path(folder) / "measured_wheel.txt")
        (Path(folder) / "python").mkdir()
        before = Path.cwd()
        os.chdir(Path(folder) / "python")
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        for number, cell in enumerate(cells, 1):
            outputs = outputs_of("".join(cell["source"]), number, names)
            if not update and texts_of(outputs) != texts_of(cell["outputs"]):
                print(f"cell {number} shows\n{texts_of(outputs)}\nand stores\n{texts_of(cell['outputs'])}")
                failures += 1
            cell["outputs"], cell["execution_count"] = outputs, number
        os.chdir(before)
    if update:
        NOTEBOOK.write_text(json.dumps(notebook, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")
    return failures


if __name__ == "__main__":
    sys.exit(run(sys.argv[1:] == ["--update"]) > 0)
