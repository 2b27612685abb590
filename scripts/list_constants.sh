#!/usr/bin/env bash
# Prints tables of the core's constants of behaviour, from the sources: room, file, name, value and
# origin. Their origins make three groups:
#   published or exact   "origin: published: ..." by a standard or an author, "derived" by mathematics
#   bounds               "origin: bound: ..." ends a loop, limits memory or work, or keeps numbers in
#                        range; no result that settles depends on it
#   tuned                "origin: measured (with what): ..." or "reasoned: ..."
# The origin is in the comment above the constant, or at the end of its line; constants that follow
# each other without a comment share the one above the first. Fails if one has no origin, or a word
# such as "reasoned" without the reason, or is outside constants.hpp and plausible_shapes.hpp.
# Left out are constants marked "not a tuning constant" (permitted ranges, units, quadrature tables,
# sizes of pictures) and the files listed below, which hold nothing else.
# Usage: scripts/list_constants.sh [ROOM...]
#        scripts/list_constants.sh --count   only how many there are in each group, room by room
set -euo pipefail
cd "$(dirname "$0")/.."
git ls-files 'cxx_core/*.hpp' 'cxx_core/*.cpp' | python3 -c '
import collections
import re
import sys

only_counts = sys.argv[1:2] == ["--count"]
rooms = sys.argv[1 + only_counts:]
groups = {
    "published or exact": {"published", "source", "derived"},
    "bounds": {"bound"},
    "tuned": {"measured", "reasoned"},
}
others = {
    "cxx_core/models/elliptic_integrals.cpp",  # published coefficients
    "cxx_core/profile/limits.hpp",  # permitted ranges
    "cxx_core/keys/convention.hpp",  # units
    "cxx_core/scene/damage_fields.cpp",  # tables of names
    "cxx_core/scene/damage_tables.hpp",
    "cxx_core/keys/load_keys.cpp",  # permitted ranges
    "cxx_core/scene/number_tables.hpp",
    "cxx_core/keys/removed_names.hpp",
    "cxx_core/scene/patch_summary.cpp",
    "cxx_core/scene/patch_summary.hpp",
    "cxx_core/scene/rate_tables.hpp",
    "cxx_core/scene/result_fields.cpp",
    "cxx_core/keys/scene_key_table.cpp",  # permitted ranges
    "cxx_core/keys/profile_keys.cpp",  # likewise
    "cxx_core/keys/profile_text.cpp",  # likewise
    "cxx_core/table/table_step.cpp",  # permitted ranges and signs
}
homes = {"constants.hpp", "plausible_shapes.hpp"}
# At namespace scope, or static in a class; not functions.
declaration = re.compile(
    r"^(?:inline |static |  static )*constexpr (?P<type>[^=({;]*?)\b(?P<name>\w+)(?:\[\w*\])?"
    r"\s*(?:=|\{)(?P<value>[^;]*);(?P<rest>.*)$", re.S)
origin = re.compile(
    r"origin:\s*(published|source|derived|bound|measured|reasoned)\b[:,]?\s*(.*)", re.S)
words = re.compile(r"string_view|char\b|Dimension")

rows = []
missing = []
misplaced = []
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
        # Another constant under a name of its own, or a number made of others, is none.
        if not re.search(r"\d", value) or "not a tuning constant" in text:
            continue
        known = origin.search(text)
        if not known or not re.search(r"\w", known[2]):
            missing.append(f"{path}:{first}: {found['"'name'"']} = {value}")
            continue
        short = path.split("/", 2)[2]
        if short not in homes:
            misplaced.append(f"{path}:{first}: {found['"'name'"']} = {value}")
        rows.append((known[1], room, short, found["name"], re.sub(r"\s+", " ", value),
                     f"{known[1]}: {known[2].strip()}"))

if missing:
    print(f"{len(missing)} of {len(missing) + len(rows)} constants have no origin or no reason for it:",
          file=sys.stderr)
    print("\n".join(missing), file=sys.stderr)
    sys.exit(1)
if misplaced:
    print("These constants belong into constants.hpp of their room:", file=sys.stderr)
    print("\n".join(misplaced), file=sys.stderr)
    sys.exit(1)
for group, tags in groups.items():
    members = [row for row in rows if row[0] in tags]
    print(f"{len(members)} {group}")
    if only_counts:
        for room, count in sorted(collections.Counter(row[1] for row in members).items()):
            print(f"  {count:3} {room}")
        continue
    print("\n| room | file | name | value | origin |\n|---|---|---|---|---|")
    for row in members:
        print("| " + " | ".join(cell.replace("|", "\\|") for cell in row[1:]) + " |")
    print()
' "$@"
