#!/usr/bin/env python3
"""Compares the outputs and numbers that README.md and docs show with those of the programs.

Usage: scripts/check_outputs.py [--update] [BIN]

BIN holds the drivers; build/release/bin if it is missing. Without --update any difference is a
failure; with it the files are rewritten. What is compared stands in comments that Markdown hides:

<!-- run: wrc_case --set pose.lateral=5 -->
    before a code block: the block is what the command prints.
<!-- value "pmax = {}": left.pmax of wrc_case --set pose.lateral=3 -->
    before a paragraph: {} is this result, by its name in docs/results.md.
<!-- row "64 x 32": left.pmax of wrc_case --set solve.grid=[64,32] --set pose.lateral={} -->
    before a table: the row of this label; {} is the cell in the table's head, {+0.1} that and 0.1.
<!-- column "depth, um": left.depth * 1e3 of wrc_case --set pose.lateral={} -->
    likewise the column of this heading; {} is the label of the row.

A label followed by a number, as in: row "64 x 32" 2, means the second number of each cell. A result
may be followed by "* FACTOR".

A number agrees if the digits shown are those of the result, rounded; in a block, to one in the last
digit, since instruction sets differ by rounding, which may show where a result lies between two
numbers. Residuals in a block are rounding themselves: they may be ten times what is shown, or 1e-12.
Numbers of lines that begin with "Time" are not compared.
"""
import argparse
import difflib
import json
import math
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
PAGES = ["README.md", *sorted(str(p.relative_to(PROJECT)) for p in (PROJECT / "docs").rglob("*.md"))]
NUMBER = re.compile(r"(?<![\w.])[-+]?\d+(?:\.\d+)?(?:[eE][-+]?\d+)?(?![\w])")
RESIDUALS = re.compile(r"\s*(load balance|least gap|complementarity)")
ROUNDING = 1e-12
RELATIVE = 2e-6  # by which results on other instruction sets may differ
MARK = re.compile(r"<!--\s*(run|value|row|column)\b\s*(.*?)\s*-->", re.S)
PLACE = re.compile(r"^\"(.*?)\"\s*(\d+)?\s*:\s*(\S+)(?:\s*\*\s*(\S+))?\s+of\s+(.*)$", re.S)


class Programs:
    """Runs the drivers in an empty folder, each command once."""

    def __init__(self, folder):
        self.folder = Path(folder).resolve()
        self.done = {}

    def run(self, command):
        if command not in self.done:
            words = shlex.split(command)
            program = self.folder / words[0]
            if not words[0].startswith("wrc_") or not program.is_file():
                raise ValueError(f"no program {words[0]} in {self.folder}")
            with tempfile.TemporaryDirectory() as empty:
                done = subprocess.run([program, *words[1:]], cwd=empty, capture_output=True,
                                      text=True, check=False, env={**os.environ, "LC_ALL": "C"})
            if done.returncode:
                raise ValueError(f"{command}: exit code {done.returncode}: {done.stderr.strip()}")
            self.done[command] = done.stdout
        return self.done[command]

    def result(self, name, command):
        value = json.loads(self.run(command + " --json"))
        for part in name.split("."):
            value = value[int(part)] if isinstance(value, list) else value[part]
        return float(value)


def unit_of(shown):
    """The unit of the last digit shown."""
    digits, _, exponent = shown.lower().partition("e")
    return 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))


def agrees(shown, value):
    return abs(float(shown) - value) <= 0.5 * unit_of(shown) + RELATIVE * abs(value)


def written_like(shown, value):
    """A value with as many digits as the number shown."""
    digits, letter, _ = shown.replace("E", "e").partition("e")
    decimals = len(digits.partition(".")[2])
    if not letter:
        return f"{value:+.{decimals}f}" if shown.startswith("+") else f"{value:.{decimals}f}"
    mantissa, exponent = f"{value:.{decimals}e}".split("e")
    short = not re.search(r"[eE][-+]?\d\d", shown)
    exponent = str(int(exponent)) if short else exponent
    return f"{mantissa}{'E' if 'E' in shown else 'e'}{exponent}"


def same_line(shown, printed):
    if shown.startswith("Time") and printed.startswith("Time"):
        return NUMBER.sub("#", shown) == NUMBER.sub("#", printed)
    if NUMBER.sub("#", shown).split() != NUMBER.sub("#", printed).split():
        return False
    pairs = list(zip(NUMBER.findall(shown), NUMBER.findall(printed)))
    if RESIDUALS.match(shown):
        return all(abs(float(other)) <= max(10 * abs(float(one)), ROUNDING) for one, other in pairs)
    return all(unit_of(one) == unit_of(other)
               and abs(float(one) - float(other)) <= unit_of(one) * (1.0 + 1e-6)
               for one, other in pairs)


class Page:
    def __init__(self, name, programs):
        self.name = name
        self.path = PROJECT / name
        self.text = self.path.read_text(encoding="utf-8")
        self.programs = programs
        self.failures = []
        self.edits = []  # (begin, end, replacement)
        self.count = 0

    def fail(self, position, text):
        line = self.text.count("\n", 0, position) + 1
        self.failures.append(f"{self.name}:{line}: {text}")

    def check(self):
        for mark in MARK.finditer(self.text):
            kind, rest = mark.groups()
            try:
                if kind == "run":
                    self.check_block(mark.end(), rest.lstrip(":").strip())
                    continue
                place = PLACE.match(rest)
                if not place:
                    raise ValueError(f"cannot be understood: {kind} {rest}")
                label, part, name, factor, command = place.groups()
                getter = (name, float(factor or 1.0), " ".join(command.split()))
                if kind == "value":
                    self.check_value(mark.end(), label, getter)
                else:
                    self.check_table(mark.end(), kind, label, int(part or 1), getter)
            except (ValueError, KeyError, IndexError, TypeError) as error:
                self.fail(mark.start(), repr(error) if isinstance(error, KeyError) else str(error))

    def check_block(self, begin, command):
        block = re.compile(r"\s*```\w*\n(.*?)```", re.S).match(self.text, begin)
        if not block:
            raise ValueError("no code block follows")
        self.count += 1
        shown = block.group(1).rstrip("\n").split("\n")
        printed = self.programs.run(command).strip("\n").split("\n")
        if len(shown) == len(printed) and all(map(same_line, shown, printed)):
            return
        timed = [line for line in shown if line.startswith("Time")]  # stay as they are
        new = [timed.pop(0) if line.startswith("Time") and timed else line for line in printed]
        self.edits.append((*block.span(1), "\n".join(new) + "\n"))
        if len(shown) == len(printed):  # no word of lines that agree
            printed = [one if same_line(one, other) else other for one, other in zip(shown, printed)]
        difference = difflib.unified_diff(shown, printed, "shown", "printed", lineterm="", n=0)
        self.fail(begin, command + "\n" + "\n".join(difference))

    def compare(self, match, offset, getter, position):
        name, factor, command = getter
        value = factor * self.programs.result(name, command)
        shown = match.group()
        self.count += 1
        if not (math.isfinite(value) and agrees(shown, value)):
            new = written_like(shown, value)
            self.edits.append((offset + match.start(), offset + match.end(), new))
            self.fail(position, f"{shown}, but {name} of {command} is {value:.8g}")

    def check_value(self, begin, pattern, getter):
        before, _, after = pattern.partition("{}")
        end = self.text.find("\n\n", begin)
        paragraph = self.text[begin:end if end > 0 else None]
        number = re.compile(re.escape(before) + f"({NUMBER.pattern})" + re.escape(after))
        found = number.search(paragraph)
        if not found:
            raise ValueError(f"no {pattern} in the paragraph that follows")
        digits = NUMBER.search(paragraph, found.start(1))
        self.compare(digits, begin, getter, begin)

    def rows_of_table(self, begin):
        """Cells of each line: (begin, end) in the text, without the row of dashes."""
        table = re.compile(r"(?:\s|<!--.*?-->)*((?:\|[^\n]*\n)+)", re.S).match(self.text, begin)
        if not table:
            raise ValueError("no table follows")
        rows, position = [], table.start(1)
        for line in table.group(1).splitlines(keepends=True):
            bars = [i for i, letter in enumerate(line) if letter == "|"]
            cells = [(position + a + 1, position + b) for a, b in zip(bars, bars[1:])]
            if not re.fullmatch(r"[-| :\n]+", line):
                rows.append(cells)
            position += len(line)
        return rows

    def cell(self, span):
        return self.text[slice(*span)].strip().replace("**", "").replace("`", "")

    def check_table(self, begin, kind, label, part, getter):
        rows = self.rows_of_table(begin)
        label = label.replace("`", "")
        if kind == "column":
            heads = [self.cell(span) for span in rows[0]]
            column = heads.index(label)
            cells = [(self.cell(row[0]), row[column]) for row in rows[1:]]
        else:
            named = [row for row in rows[1:] if self.cell(row[0]) == label]
            if not named:
                raise ValueError(f'no row "{label}"')
            cells = [(self.cell(head), span) for head, span in zip(rows[0][1:], named[0][1:])]
        name, factor, command = getter
        for head, span in cells:
            def filled(match, head=head):
                return f"{float(head) + float(match.group(1) or 0):.6g}" if match.group(1) else head
            own = re.sub(r"\{([-+][\d.]+)?\}", filled, command)
            numbers = list(NUMBER.finditer(self.text[slice(*span)]))
            self.compare(numbers[part - 1], span[0], (name, factor, own), span[0])

    def update(self):
        for begin, end, new in sorted(self.edits, reverse=True):
            self.text = self.text[:begin] + new + self.text[end:]
        self.path.write_text(self.text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--update", action="store_true", help="rewrite what is shown")
    parser.add_argument("bin", nargs="?", default=PROJECT / "build/release/bin")
    options = parser.parse_args()
    programs = Programs(options.bin)
    pages = [Page(name, programs) for name in PAGES]
    for page in pages:
        page.check()
    failures = [failure for page in pages for failure in page.failures]
    if options.update:
        for page in pages:
            if page.edits:
                page.update()
                print(f"{page.name}: {len(page.edits)} places updated")
        print("\n".join(failures))
        return 0
    print("\n".join(failures) if failures else
          f"{sum(page.count for page in pages)} outputs and numbers of README.md and docs are those "
          f"of {len(programs.done)} commands")
    return 1 if failures else 0


sys.exit(main())
