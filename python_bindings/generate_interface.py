#!/usr/bin/env python3
"""Writes the declarations of wrcontact.h and wrcontact_grid.h as a Python module for cffi.

Usage: generate_interface.py INCLUDE_FOLDER OUTPUT.py

The module holds no machine code: one file serves all versions of Python (cffi's ABI mode, "out of
line"). Whatever the headers declare can be called; nothing is declared a second time.
"""
import re
import sys
from pathlib import Path

import cffi


def declarations_of(text: str) -> str:
    """A header without comments, conditions, linkage, removed functions and macros but integers."""
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.S)
    constants = re.findall(r"^#define (WRC_\w+) (\d+)\s*$", text, flags=re.M)
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    body = re.sub(r"\bWRC_API\b|\bWRC_REMOVED[^;]*;", "", "\n".join(lines))
    body = re.sub(r'^extern "C" \{$|^\}$', "", body, flags=re.M)
    return "".join(f"#define {name} {value}\n" for name, value in constants) + body


def main(include_folder: str, output: str) -> None:
    builder = cffi.FFI()
    for header in ("wrcontact.h", "wrcontact_grid.h"):
        builder.cdef(declarations_of((Path(include_folder) / header).read_text(encoding="utf-8")))
    builder.set_source("wrcontact._interface", None)
    builder.emit_python_code(output)


if __name__ == "__main__":
    main(*sys.argv[1:])
