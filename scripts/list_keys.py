#!/usr/bin/env python3
"""Compares docs/keys.md with the key table of the library.

Usage: scripts/list_keys.py [--update] [LIBRARY]

LIBRARY is build/release/lib/libwrcontact.so if it is missing. Without --update any difference is a failure;
with it the tables of the page are rewritten.
"""
import ctypes
import difflib
import re
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
PAGE = PROJECT / "docs/keys.md"
GROUPS = {
    "convention": "Units and frame",
    "track": "Track",
    "wheelset": "Wheelset",
    "material": "Material",
    "pose": "Position of the wheelset",
    "load": "Load",
    "motion": "Motion",
    "creepage": "Creepages",
    "friction": "Friction",
    "solve": "Solution",
    "stress": "Stresses",
    "wear": "Wear",
    "fatigue": "Fatigue",
}
HEAD = """# All keys of a scene

Every input of a scene is a key with a default. Scene files hold a key as `pose.lateral = 3.0` or in the table `[pose]`, programs set it
by name, and `wrc_case --help` prints this list. Units are mm, N, MPa, rad, frame y left, z up, unless `convention.*` selects others.
`scripts/list_keys.py --update` writes this page from the key table of the library.
"""


def keys_of(library):
    library = ctypes.CDLL(str(library))
    library.wrc_scene_key_count.restype = ctypes.c_int64
    library.wrc_scene_key.argtypes = [ctypes.c_int64] + 4 * [ctypes.POINTER(ctypes.c_char_p)]
    for index in range(library.wrc_scene_key_count()):
        texts = [ctypes.c_char_p() for _ in range(4)]
        if library.wrc_scene_key(index, *map(ctypes.byref, texts)) != 0:
            raise RuntimeError(f"key {index} cannot be read")
        yield [text.value.decode() for text in texts]


def page_of(keys):
    groups = {}
    for name, default, allowed, meaning in keys:
        if re.match(r"(its|the same|instead|likewise|of)\b", meaning):
            raise RuntimeError(f"the meaning of {name} refers to another key: {meaning}")
        row = [f"`{name}`", f"`{default}`", allowed, meaning]
        groups.setdefault(name.partition(".")[0], []).append(
            "| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |")
    unknown = groups.keys() - GROUPS.keys()
    if unknown:
        raise RuntimeError(f"scripts/list_keys.py has no heading for {', '.join(sorted(unknown))}")
    text = HEAD
    for group, heading in GROUPS.items():
        if group in groups:
            text += f"\n## {heading}\n| key | default | allowed | meaning |\n|---|---|---|---|\n"
            text += "\n".join(groups[group]) + "\n"
    return text


def main():
    arguments = sys.argv[1:]
    update = arguments[:1] == ["--update"]
    rest = arguments[update:]
    if len(rest) > 1 or (rest and rest[0].startswith("-")):
        print(__doc__, file=sys.stderr)
        return 2
    new = page_of(keys_of(Path(rest[0]) if rest else PROJECT / "build/release/lib/libwrcontact.so"))
    old = PAGE.read_text(encoding="utf-8") if PAGE.exists() else ""
    if update:
        PAGE.write_text(new, encoding="utf-8")
    elif new != old:
        print("docs/keys.md is not that of the library; scripts/list_keys.py --update rewrites it")
        print("\n".join(difflib.unified_diff(old.splitlines(), new.splitlines(), "page", "library", lineterm="", n=0)))
        return 1
    return 0


sys.exit(main())
