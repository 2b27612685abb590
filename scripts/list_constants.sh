#!/usr/bin/env bash
# Prints a table of the core's constants of behaviour, from the sources: room, file, name, value and
# origin. Fails if one has no origin: the comment above it, or at the end of its line, says
# "origin: derived|measured|source|reasoned: ...". Constants that follow each other without a comment
# share the one above the first.
# Left out are constants marked "not a tuning constant" (permitted ranges, units, quadrature tables)
# and the files listed below, which hold nothing else.
# Usage: scripts/list_constants.sh [ROOM...]
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files 'cxx_core/*.hpp' 'cxx_core/*.cpp' | python3 -c '
import re
import sys

rooms = sys.argv[1:]
others = {
    "cxx_core/models/elliptic_integrals.cpp",  # published coefficients
    "cxx_core/profile/read_options.hpp",  # permitted ranges
    "cxx_core/scene/convention.hpp",  # units
    "cxx_core/scene/damage_fields.cpp",  # tables of names
    "cxx_core/scene/damage_tables.hpp",
    "cxx_core/scene/load_keys.cpp",  # permitted ranges
    "cxx_core/scene/number_tables.hpp",
    "cxx_core/scene/old_names.hpp",
    "cxx_core/scene/patch_summary.cpp",
    "cxx_core/scene/patch_summary.hpp",
    "cxx_core/scene/rate_tables.hpp",
    "cxx_core/scene/result_fields.cpp",
    "cxx_core/scene/scene_key_table.cpp",  # permitted ranges
}
# At namespace scope, or static in a class; not functions.
declaration = re.compile(
    r"^(?:inline |static |  static )*constexpr (?P<type>[^=({;]*?)\b(?P<name>\w+)(?:\[\w*\])?"
    r"\s*(?:=|\{)(?P<value>[^;]*);(?P<rest>.*)$", re.S)
origin = re.compile(r"origin:\s*(derived|measured|source|reasoned)\b[:,]?\s*(.*)", re.S)
words = re.compile(r"string_view|char\b|Dimension")

rows = []
missing = []
for path in sys.stdin.read().split():
    room = path.split("/")[1]
    if path in others or (rooms and room not in rooms):
        continue
    lines = open(path).read().split("\n")
    comment = []  # of the declaration that comes next
    inherited = ""  # of the one just before
    number = 0
    while number < len(lines):
        line = lines[number]
        number += 1
        if line.lstrip().startswith("//"):
            comment.append(line.strip().lstrip("/").strip())
            continue
        if not re.match(r"(inline |static |  static )*constexpr ", line):
            comment = []
            inherited = ""
            continue
        first = number
        while ";" not in line and number < len(lines) and number < first + 20:
            line += " " + lines[number].strip()
            number += 1
        found = declaration.match(line)
        text = " ".join(comment) if comment else inherited
        comment = []
        inherited = text
        if not found or words.search(found["type"]):
            continue
        value = found["value"].strip()
        value = value[:-1].strip() if value.endswith("}") and "{" not in value else value
        text += " " + found["rest"].strip().lstrip("/<").strip()
        if not re.search(r"\d", value) or "not a tuning constant" in text:
            continue
        known = origin.search(text)
        if not known:
            missing.append(f"{path}:{first}: {found['"'name'"']} = {value}")
        said = f"{known[1]}: {known[2].strip()}" if known else "-"
        short = path.split("/", 2)[2]
        rows.append((room, short, found["name"], re.sub(r"\s+", " ", value), said))

print("| room | file | name | value | origin |\n|---|---|---|---|---|")
for row in rows:
    print("| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |")
if missing:
    print(f"{len(missing)} of {len(rows)} constants have no origin:", file=sys.stderr)
    print("\n".join(missing), file=sys.stderr)
    sys.exit(1)
' "$@"
