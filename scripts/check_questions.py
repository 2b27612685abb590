#!/usr/bin/env python3
"""Checks that a first-time reader finds answers within two clicks of README.md.

Usage: scripts/check_questions.py [--clicks]

Of each question: a word that the reader looks for, the link beside it, and words of the answer. The word and the link
must be in one line of README.md (one click), or of docs/index.md, which README.md links to (two clicks); the answer
must be on the page, below the heading if the link names one.
"""
import re
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
QUESTIONS = [
    ("where is y positive, and which way does a force act?", "sign", "docs/glossary.md", "forces to the left"),
    ("which setting is CONTACT's D_COMB, N = 1, T = 3?", "CONTACT", "docs/glossary.md#coming-from-contact", "D_COMB"),
    ("can each wheel have friction of its own?", "friction", "docs/vehicle.md#friction-per-wheel", "friction.left"),
    ("where do Kalker's coefficients come from?", "Kalker", "docs/creep.md#cheaper-models", "Kalker's coefficients"),
    ("how accurate is the result for my worn wheel?", "worn", "docs/accuracy.md#what-the-error-estimate-includes",
     "left.spread.pmax"),
    ("can it read MiniProf and Simpack files?", "MiniProf", "docs/profiles.md", "MiniProf `.ban`, `.whl`"),
    ("how do I run it on a cluster?", "cluster", "docs/studies.md#interrupted-or-on-a-cluster", "wrc_sweep_mpi"),
    ("how do I install it without root?", "without root", "docs/build.md#without-root", "W=$HOME"),
    ("how do I cite it?", "cite", "CITATION.cff", "cff-version"),
    ("may I use it in a closed program?", "commercial", "README.md#licence", "MIT licence"),
    ("what does a time step cost?", "what it costs", "docs/accuracy.md#cost-of-a-step", "time, ms"),
    ("which derivatives does an implicit integrator get?", "derivatives", "docs/vehicle.md#derivatives", "dfdq"),
    ("what happens when a wheel lifts?", "lifts", "docs/vehicle.md#states-of-a-wheel", "wrc_lifted"),
    ("can a vehicle stop and park on a slope?", "park", "docs/vehicle.md#standstill-reversal-full-sliding", "slope"),
    ("are pressures above 1 GPa real?", "1 GPa", "docs/accuracy.md#what-the-error-estimate-includes", "yields"),
]


def section(target):
    page, _, anchor = target.partition("#")
    text = (PROJECT / page).read_text(encoding="utf-8")
    for head in re.finditer(r"^(#+) (.*)$", text, re.M) if anchor else []:
        if re.sub(r"[^\w\- ]", "", head.group(2).lower()).replace(" ", "-") == anchor:
            end = re.search(rf"^#{{1,{len(head.group(1))}}} ", text[head.end():], re.M)
            return text[head.end():][:end.start() if end else None]
    return "" if anchor else text


def leads(page, word, link):
    lines = (PROJECT / page).read_text(encoding="utf-8").splitlines()
    return any(word.lower() in line.lower() and f"]({link})" in line for line in lines)


failures = 0
for question, word, target, answer in QUESTIONS:
    from_index = target[5:] if target.startswith("docs/") else "../" + target
    one, two = leads("README.md", word, target), leads("docs/index.md", word, from_index)
    if answer not in section(target) or not (one or two):
        failures += 1
        print(f"{question} No line with \"{word}\" leads to {target}, or it does not say \"{answer}\"")
    elif sys.argv[1:] == ["--clicks"]:
        print(f"{1 if one else 2}  {question}  {target}")
sys.exit(1 if failures else 0)
