#!/usr/bin/env python3
"""Runs the commands of docs/jobs.md in empty folders and compares what they draw with docs/images.

Usage: docs/images/draw_gallery.py [--update] [--few] [BIN]

BIN holds the programs, build/release/bin if it is missing. Without --update a picture fails that differs in more than
five pixels of ten thousand (as committed, noise is below one), or in size; with it, it is replaced. With --few every fourth of the
pictures below is drawn, and the jobs are left out. A command follows <!-- picture -->, its picture the
command; after <!-- picture: PROGRAM --> the picture is skipped where there is no such program, and a line says so.
The jobs are run as a tutorial (tests/readme/run_tutorial.py), which draws the other pictures. Needs gnuplot and python3-matplotlib.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from matplotlib.image import imread

PROJECT = Path(__file__).resolve().parents[2]
ENTRY = re.compile(r"<!-- picture(?:: (\w+))? -->\n```\n(.*?)\n```\n!\[[^\]]*\]\(images/([\w.]+)\)", re.S)
# A pixel differs if a colour does by more than this: contours and letters are smoothed by rounding of results.
COLOUR = 0.1
PIXELS = 5e-4


def difference(one, other):
    """What tells two pictures apart, or nothing."""
    one, other = imread(one)[:, :, :3], imread(other)[:, :, :3]
    if one.shape != other.shape:
        return f"is {one.shape[1]} x {one.shape[0]} pixels instead of {other.shape[1]} x {other.shape[0]}"
    share = (numpy.abs(one - other).max(axis=2) > COLOUR).mean()
    return f"differs in {100 * share:.2g} % of its pixels" if share > PIXELS else ""


def compared(drawn, picture, update):
    """Whether a picture is as committed, or was replaced; says so if not."""
    target = PROJECT / "docs/images" / picture
    found = difference(drawn, target) if target.exists() else "is not in docs/images"
    if found and update:
        shutil.copyfile(drawn, target)
        found += "; replaced"
    if found:
        print(f"{picture}: {found}")
    return not found or update


def check_jobs(programs, others, update):
    """Pictures of the jobs, and how many of them are as committed; `others` are those below <!-- picture -->."""
    page = PROJECT / "docs/jobs.md"
    pictures = [name for name in re.findall(r"\]\(images/([\w.]+)\)", page.read_text(encoding="utf-8")) if name not in others]
    with tempfile.TemporaryDirectory() as name:
        prefix, folder = Path(name) / "prefix", Path(name) / "jobs"
        examples = prefix / "share/wrcontact/examples"
        examples.mkdir(parents=True)
        (prefix / "bin").symlink_to(programs)
        (examples / "measured_wheel.txt").symlink_to(PROJECT / "tests/reference/profiles/Car7216_0001r.txt")
        subprocess.run([sys.executable, PROJECT / "tests/readme/run_tutorial.py", page, prefix, folder], check=True)
        good = 0
        for picture in pictures:
            drawn = next(folder.rglob(picture), None)
            if drawn:
                good += compared(drawn, picture, update)
            else:
                print(f"{picture}: not drawn by a command of docs/jobs.md")
    return len(pictures), good


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--update", action="store_true", help="replace pictures that differ")
    parser.add_argument("--few", action="store_true", help="every fourth picture, and no job")
    parser.add_argument("bin", nargs="?", default=PROJECT / "build/release/bin", type=Path)
    options = parser.parse_args()
    page = (PROJECT / "docs/jobs.md").read_text(encoding="utf-8")
    entries = ENTRY.findall(page)
    if not entries or len(entries) != page.count("<!-- picture"):
        print(f"docs/jobs.md: {page.count('<!-- picture')} pictures, {len(entries)} of them below their command")
        return 1
    others = {picture for _, _, picture in entries}
    if options.few:
        entries = entries[1::4]
    good = skipped = 0
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "build/release").mkdir(parents=True)
        for link, target in (("build/release/bin", options.bin.resolve()), ("drivers", PROJECT / "drivers"),
                             ("docs", PROJECT / "docs")):
            (folder / link).symlink_to(target)
        interpreter = Path(sys.executable).parent  # scripts start with the Python that has matplotlib
        path = f"{options.bin.resolve()}:{interpreter}:{os.environ['PATH']}"
        for needed, command, picture in entries:
            if needed and not shutil.which(needed):
                skipped += 1
                print(f"Skipped: {needed} is not installed: {picture} is not compared")
                continue
            done = subprocess.run(["bash", "-ec", command], cwd=folder, capture_output=True, text=True, check=False,
                                  env={**os.environ, "PATH": path, "LC_ALL": "C.UTF-8", "SOURCE_DATE_EPOCH": "1767225600",
                                       "MPLCONFIGDIR": str(folder)})
            drawn = next((p for p in folder.rglob(picture) if "docs" not in p.relative_to(folder).parts), None)
            if done.returncode or not drawn:
                print(f"{picture}: not drawn: {done.stderr.strip()[-500:]}")
            else:
                good += compared(drawn, picture, options.update)
    count, good_jobs = (0, 0) if options.few else check_jobs(options.bin.resolve(), others, options.update)
    print(f"{good} of {len(entries)} pictures of docs/jobs.md and {good_jobs} of {count} of its jobs are as committed")
    return 1 if good + skipped < len(entries) or good_jobs < count else 0


sys.exit(main())
