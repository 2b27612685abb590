#!/usr/bin/env python3
"""Does what a tutorial says, in an empty folder, and compares what the commands print with what the page shows.

Usage: run_tutorial.py PAGE PREFIX FOLDER [PACKAGES]

PREFIX is the installation, $W of the page; its programs are on the path, its Python package is importable. In PAGE

<!-- file: NAME -->
    before a block: its text becomes this file;
```sh
    begins a block of commands, which bash runs until one fails;
<!-- prints -->
    before a block: its lines are among those that the commands before it printed, in this order; numbers are
    rounded to the digits shown, or differ by one in the last of them, and "..." stands for any lines and any end of a line;
<!-- writes: NAME ... -->
    these files are there, and not empty.
"""
import os
import re
import subprocess
import sys
from pathlib import Path

STEP = re.compile(r"^<!-- (file|prints|writes)(?:: ([^\n]+?))? -->(?:\n```\w*\n(.*?)^```)?|^```sh\n(.*?)^```",
                  re.S | re.M)
NUMBER = re.compile(r"[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?")


def unit_of(shown):
    digits, _, exponent = shown.lower().partition("e")
    return 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))


def same(shown, printed):
    open_end = shown.endswith("...")
    words, others = NUMBER.sub(" # ", shown.removesuffix("...")).split(), NUMBER.sub(" # ", printed).split()
    if words != (others[:len(words)] if open_end else others):
        return False
    return all(abs(float(one) - float(other)) <= (1.001 if unit_of(one) == unit_of(other) else 0.501) * unit_of(one)
               for one, other in zip(NUMBER.findall(shown), NUMBER.findall(printed)))


def missing_line(shown, printed):
    """The first line of shown that is not in printed, after those before it."""
    rest = iter(printed.splitlines())
    for line in shown.splitlines():
        if line.strip() not in ("", "...") and not any(same(line, other) for other in rest):
            return line
    return None


def main():
    page, prefix, folder = Path(sys.argv[1]), Path(sys.argv[2]), Path(sys.argv[3])
    packages = Path(sys.argv[4]) if len(sys.argv) > 4 else prefix / "lib/python3/dist-packages"
    if folder.exists():
        subprocess.run(["rm", "-r", folder], check=True)
    folder.mkdir(parents=True)
    interpreter = folder / ".bin"
    interpreter.mkdir()
    (interpreter / "python3").symlink_to(sys.executable)
    environment = {**os.environ, "W": str(prefix), "LC_ALL": "C.UTF-8", "MPLCONFIGDIR": str(interpreter),
                   "PATH": f"{interpreter}:{prefix / 'bin'}:{os.environ['PATH']}", "PYTHONPATH": str(packages),
                   "PYTHONDONTWRITEBYTECODE": "1"}
    printed, commands, compared = "", 0, 0
    for kind, argument, block, shell in STEP.findall(page.read_text(encoding="utf-8")):
        if kind == "file":
            (folder / argument).write_text(block, encoding="utf-8")
        elif kind == "prints":
            line = missing_line(block, printed)
            compared += 1
            if line is not None:
                print(f"{page.name} shows\n{line}\nbut the commands print\n{printed}")
                return 1
        elif kind == "writes":
            for name in argument.split():
                if not (folder / name).is_file() or not (folder / name).stat().st_size:
                    print(f"{page.name}: there is no {name}")
                    return 1
        else:
            done = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", shell], cwd=folder, env=environment,
                                  stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
            commands += 1
            printed = done.stdout
            if done.returncode:
                print(f"{page.name}: exit code {done.returncode} of\n{shell}{printed}")
                return 1
    if not commands or not compared:
        print(f"{page.name}: {commands} blocks of commands, {compared} of what they print")
        return 1
    print(f"{page.name}: {commands} blocks of commands, what {compared} of them print is as shown")
    return 0


sys.exit(main())
