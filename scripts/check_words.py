#!/usr/bin/env python3
"""Finds words and idioms that a native engineer would not write, in docs, code, bindings and names of tests.

Usage: scripts/check_words.py [FILE ...]

Each entry of WORDS is a pattern and what to write instead. Code blocks, code spans and links in Markdown are
skipped; in C++ and Fortran only comments and strings are searched. Of tests in C++ only the names are
searched, as words: AFailedStepChangesNothing is "A failed step changes nothing". A line that must keep such a
word ends in "words: keep". CHANGELOG.md and the files of EXCLUDED are not searched.
"""
import re
import subprocess
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
WORDS = [
    (r"\btold\b", "reported, named, given"),
    (r"\banew\b", "again, or: is rebuilt, is recomputed"),
    (r"(?<!times )(?<!half )(?<!twice )(?<!at least )(?<![0-9] )\bas many\b", "the number of ..., one ... for each ..."),
    (r"\b(?:of|by|with) what\b", "name the thing"),
    (r"\bturns? (?:by \S+ )?at once\b", "has a kink"),
    (r"\bin the mean\b(?! plane)", "on average, mean"),
    (r"\bkey away\b", "is selected with one key"),
    (r"\bknows? (?:nothing )?of\b", "does not include, does not handle"),
    (r"\bstands? (?:in(?! for)|at|beside|there|here|once|with)\b", "is in, is beside"),
    (r"\bthere and back\b", "forward and inverse, both ways"),
    (r"(?<!half )\bways? out\b", "output"),
    (r"\bbut for\b", "except, except for"),
    (r"\bin silence\b", "silently, without a warning"),
    (r"\bmend(?:s|ed|ing)?\b", "fix, correct"),
    (r"\bhears? of\b", "is told about, must know"),
    (r"\ba share of\b", "a fraction of, part of"),
    (r"\ball else\b", "everything else"),
    (r"\bsome \d", "about"),
    (r"\bto be had\b", "available"),
    (r"\bgiven up\b", "released, dropped"),
    (r"\bto a page\b", "say what the page answers"),
    (r"\bread ratios\b", "compare ratios"),
    (r"^(?:#+ )?read again\b", "say what was found"),
    (r"\bis taken for (?:none|zero)\b", "is treated as"),
    (r"\bsays? of what\b", "selects which results"),
    (r"\bwhatever it looks like\b", "whatever its shape"),
    (r"\b(?:what|all) (?:it|they) (?:has|have) left\b", "what remains of"),
    (r"\bstrangers?\b", "name the reader"),
    (r"\bas told\b|\buntold\b", "without a warning, unreported"),
    (r"\bso many\b(?! that)", "this number of, n"),
    (r"\bfrom which on\b", "above which, below which"),
    (r"\bwithout a word\b", "without a warning"),
    (r"\bto tell (?:apart|from)\b|\btells? apart\b|\btold from\b", "distinguish"),
    (r"\bhas? to give\b", "allows"),
    (r"\bwill do\b", "suffices"),
    (r"\ballowed (?:is|are)\b(?! read)", "must be"),
]
NAMES = [
    (r"\b(?:is|are) said\b|\bsays? so\b", "is reported, warns"),
    (r"\basked(?: for)?\b", "requested"),
    (r"\bas (?:it|they) (?:is|are|was|were)\b", "unchanged"),
    (r"\bthere are none\b|\bthose of none\b", "there is no ..., is absent"),
    (r"\bas any other\b", "like any other"),
    (r"\bof (?:its|their) own\b", "separate"),
    (r"\bby (?:itself|themselves)\b", "separately"),
]  # further patterns for names of tests
SEARCHED = ["README.md", "CONTRIBUTING.md", "SECURITY.md", "docs/*.md", "docs/evidence/*.md",
            "cxx_core/*/README.md", "drivers/evidence/README.md", "tests/README.md",
            "c_api/*.hpp", "c_api/*.cpp", "c_api/include/*", "fortran_bindings/*", "octave_bindings/*.m",
            "octave_bindings/*.c", "python_bindings/wrcontact/*.py", "python_bindings/examples/*.py",
            "drivers/*.cpp", "drivers/*.hpp", "drivers/*.f90", "drivers/*.f", "drivers/*.toml", "cxx_core/*.hpp",
            "cxx_core/*.cpp", "tests/*.cpp"]
EXCLUDED = []  # patterns of paths whose texts are rewritten later


def files():
    if sys.argv[1:]:
        return [Path(name).resolve() for name in sys.argv[1:]]
    listed = subprocess.run(["git", "ls-files", "--", *SEARCHED], cwd=PROJECT, capture_output=True,
                            text=True, check=True).stdout.split()
    return [PROJECT / name for name in listed if not re.search("|".join(EXCLUDED) or "^$", name)]


def prose_of(path):
    """Lines to search, with their numbers; of Markdown those outside code."""
    fenced = False
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if path.suffix == ".md":
            if line.startswith("```"):
                fenced = not fenced
            if fenced or line.startswith(("```", "<!--")):
                continue
            line = re.sub(r"\]\([^)]*\)", "]", re.sub(r"`[^`]*`", "`", line))
        elif line.endswith("words: keep"):
            continue
        elif "/tests/" in path.as_posix():
            test = re.match(r"TEST\w*\(\w+, *(\w+)\)", line)
            line = re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", test.group(1)) if test else ""
        elif path.suffix in (".cpp", ".hpp", ".c", ".f90", ".f", ".inc"):
            comment = r"//.*" if path.suffix in (".cpp", ".hpp", ".c") else r"!.*"
            if not (path.suffix == ".f" and line[:1] in "Cc*!" and line[:1]):
                line = " ".join(re.findall(rf"{comment}|\"[^\"]*\"|'[^']*'", line))
        yield number, line


def main():
    found = 0
    for path in files():
        is_test = "/tests/" in path.as_posix() and path.suffix == ".cpp"
        for number, line in prose_of(path):
            for pattern, better in WORDS + (NAMES if is_test else []):
                match = re.search(pattern, line, re.I)
                if match:
                    found += 1
                    print(f"{path.relative_to(PROJECT)}:{number}: \"{match.group(0)}\": {better}\n"
                          f"    {line.strip()}")
    return 1 if found else 0


sys.exit(main())
