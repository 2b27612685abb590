#!/usr/bin/env python3
"""Draws docs/images/front.png: both lobes of a left wheel beside the page that a study writes for a browser.

Usage: docs/images/front.py [BIN [FOLDER]]. BIN holds wrc_case and wrc_sweep, build/release/bin if it is missing;
FOLDER, this one if it is missing, gets the picture. Needs gnuplot, chromium and python3-matplotlib. The page is shown
at the position of the two lobes, with which a browser would open it only after the slider was moved.
"""
import os
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy
from matplotlib.image import imread, imsave

HERE = Path(__file__).resolve().parent
LATERAL = 5.0          # mm
FIRST, STEP = -6.0, 0.5  # of drivers/studies/demonstration.toml
PAGE_WIDTH = 850


def run(*command):
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                   env={**os.environ, "LC_ALL": "C.UTF-8"})


def main():
    programs = Path(sys.argv[1] if len(sys.argv) > 1 else HERE.parents[1] / "build/release/bin").resolve()
    target = Path(sys.argv[2] if len(sys.argv) > 2 else HERE).resolve() / "front.png"
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        run(programs / "wrc_case", "--set", f"pose.lateral={LATERAL}", "--plot", folder / "lobes.png")
        run(programs / "wrc_sweep", HERE.parents[1] / "drivers/studies/demonstration.toml", "--out", folder,
            "--no-pictures", "--page", folder / "page.html")
        lobes = imread(folder / "lobes.png")[:, :, :3]
        lobes = lobes[:895, :lobes.shape[1] // 2]  # the left wheel, without the line of the warning
        with open(folder / "page.html", "a", encoding="utf-8") as page:
            page.write("<script>{ const slider = document.querySelector('input[type=range]'); "
                       f"slider.value = {round((LATERAL - FIRST) / STEP)}; "
                       "slider.dispatchEvent(new Event('input')); }</script>\n")
        run("chromium", "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
            f"--window-size={PAGE_WIDTH},{lobes.shape[0]}", "--virtual-time-budget=3000",
            f"--screenshot={folder / 'page.png'}", f"file://{folder / 'page.html'}")
        page = imread(folder / "page.png")[:, :, :3]
    line = numpy.full((lobes.shape[0], 2, 3), 0.7)
    imsave(target, numpy.concatenate([lobes, line, page], axis=1).clip(0, 1))
    print(target)


main()
