#!/usr/bin/env python3
"""Compares README.md, docs and pages beside the code with the sources, without building anything.

Usage: scripts/check_docs.py [--update]

 * links lead somewhere, paths in code spans exist, docs/index.md knows every page;
 * a text in <!-- quoted: docs/page.md "text" --> is on that page: figures beside it are taken from there;
 * the tables between <!-- f77 --> or <!-- module --> and <!-- end --> in docs/fortran-calls.md hold every
   subroutine and procedure with its arguments (--update rewrites them; what they do is kept);
 * docs/build.md holds every build option with its default, and every preset;
 * CHANGELOG.md has every removed name of cxx_core/keys/removed_names.hpp;
 * the rooms of docs/architecture.md include what scripts/check_layers.sh lets them; what it and
   docs/extending.md say to stand in a file stands there, and members are those of their struct.
"""
import json
import re
import sys
from pathlib import Path

PROJECT = Path(__file__).resolve().parent.parent
PAGES = ["README.md", "CONTRIBUTING.md",
         *sorted(str(page.relative_to(PROJECT)) for folder in ("docs", "cxx_core", "drivers")
                 for page in (PROJECT / folder).rglob("*.md"))]
FOLDERS = ("c_api|cxx_core|docs|drivers|fortran_bindings|octave_bindings|packaging|profiles|"
           "python_bindings|scripts|tests")
failures = []


def text_of(name):
    return (PROJECT / name).read_text(encoding="utf-8")


def fail(page, text):
    failures.append(f"{page}: {text}")


def anchors_of(text):
    return {re.sub(r"[^\w\- ]", "", head.lower()).strip().replace(" ", "-")
            for head in re.findall(r"^#+ (.*)$", text, re.M)}


def check_links():
    for page in PAGES:
        text = text_of(page)
        folder = (PROJECT / page).parent
        for target in re.findall(r"\]\(([^)\s]+)\)", text):
            path, _, anchor = target.partition("#")
            if re.match(r"[a-z]+:", path):
                continue
            file = folder / path if path else PROJECT / page
            if not file.exists():
                fail(page, f"link to {target}: there is no such file")
            elif anchor and anchor not in anchors_of(file.read_text(encoding="utf-8")):
                fail(page, f"link to {target}: there is no such heading")
        for path in re.findall(rf"`((?:{FOLDERS})/[\w./-]*[\w/])[^`]*`", text):
            if path.split("/")[-1].isupper() or re.search(r"NAME", path):
                continue  # a placeholder
            if not any((PROJECT / (path + ending)).exists() for ending in ("", ".hpp", ".cpp")):
                fail(page, f"{path} does not exist")


def check_quotations():
    """<!-- quoted: docs/page.md "text" -->: the text, from which figures nearby are taken, is on that page."""
    for page in PAGES:
        for source, text in re.findall(r"<!-- quoted: (\S+) \"(.*)\" -->", text_of(page)):
            if text not in text_of(source):
                fail(page, f"figures are from {source}, which no longer says: {text}")


def check_index():
    index = text_of("docs/index.md")
    for page in PAGES:
        if page.startswith("docs/") and page != "docs/index.md":
            if f"]({page[5:]}" not in index:
                fail("docs/index.md", f"does not lead to {page}")


def check_rooms():
    rooms = {line.split()[1]: set(line.split()[2:])
             for line in text_of("scripts/check_layers.sh").splitlines() if line.startswith("room ")}
    told, above = {}, []
    for line in text_of("docs/architecture.md").splitlines():
        row = re.match(r"\| `(\w+)` \|[^|]*\|([^|]*)\|$", line)
        if row and row.group(1) in rooms:
            name, allowed = row.groups()
            named = set(re.findall(r"`(\w+)`", allowed))
            told[name] = set(above) - named if "all of the above" in allowed else named
            above.append(name)
    for name, allowed in rooms.items():
        if told.get(name) != allowed:
            fail("docs/architecture.md", f"room {name}: scripts/check_layers.sh lets it include "
                 f"{sorted(allowed)}, the table says {sorted(told.get(name, []))}")


def check_places(name_of_page):
    page = text_of(name_of_page)
    for name, path in re.findall(r"`([\w:]+)` in `([\w./]+\.(?:cpp|hpp))`", page):
        file = PROJECT / path
        if file.exists() and not re.search(rf"\b{name.split('::')[-1]}\b",
                                           file.read_text(encoding="utf-8")):
            fail(name_of_page, f"{name} is not in {path}")
    headers = [path.read_text(encoding="utf-8") for path in (PROJECT / "cxx_core").glob("*/*.hpp")]
    for struct, member in set(re.findall(r"`([A-Z]\w+)::(\w+)`", page)):
        bodies = [match.group(1) for text in headers for match in re.finditer(
            rf"^(?:struct|class) {struct}\b[^;]*?\{{\n(.*?)^\}};", text, re.M | re.S)]
        inherited = [base for text in headers for base in re.findall(
            rf"^struct {struct} : (\w+)", text, re.M)]
        bodies += [match.group(1) for base in inherited for text in headers for match in re.finditer(
            rf"^struct {base}\b[^;]*?\{{\n(.*?)^\}};", text, re.M | re.S)]
        if not any(re.search(rf"\b{member}\b", body) for body in bodies):
            fail(name_of_page, f"{struct} has no {member}")


def check_removed_names():
    removed = text_of("CHANGELOG.md").partition("### Removed")[2].partition("\n### ")[0]
    for name in re.findall(r'RemovedName\{NameOf::\w+, "([^"]+)"', text_of("cxx_core/keys/removed_names.hpp")):
        if f"`{name}`" not in removed:
            fail("CHANGELOG.md", f'"Removed" does not have {name}')


def check_build_options():
    page = text_of("docs/build.md")
    listed = dict(re.findall(r"^\| `(WRCONTACT_\w+)` \| `?([^|`]*?)`? \|", page, re.M))
    sources = "".join(text_of(str(path.relative_to(PROJECT))) for path in
                      [PROJECT / "CMakeLists.txt", *PROJECT.glob("*/CMakeLists.txt")])
    options = dict(re.findall(r"^\s*option\((WRCONTACT_\w+) \"[^\"]*\" (\w+)\)", sources, re.M))
    for name, value in re.findall(r"^\s*set\((WRCONTACT_\w+) ([^\n]*?)\s+CACHE (?:STRING|PATH)",
                                  sources, re.M):
        options[name] = value.strip('"') or "empty"
    for name in options.keys() | listed.keys():
        if options.get(name) != listed.get(name):
            fail("docs/build.md", f"{name}: the default is {options.get(name)}, the page says "
                 f"{listed.get(name)}")
    presets = {preset["name"] for preset in json.loads(text_of("CMakePresets.json"))["configurePresets"]
               if not preset.get("hidden")}
    told = set(re.findall(r"^\| `([a-z]+)` \|", page, re.M))
    if presets != told:
        fail("docs/build.md", f"presets are {sorted(presets)}, the page says {sorted(told)}")


class Procedure:
    def __init__(self, name, arguments, result):
        self.name, self.arguments, self.result = name, arguments, result
        self.types = {}  # of an argument: type, intent, whether optional

    def signature(self, name, prefix="", hidden=()):
        shown = [a for a in self.arguments if a not in hidden]
        required = [a for a in shown if not self.types[a][2]]
        optional = [a for a in shown if self.types[a][2]]
        if shown[:len(required)] != required:
            raise ValueError(f"{self.name}: optional arguments stand before others")
        inner = ", ".join(required)
        if optional:
            inner += f"[{', ' if required else ''}{', '.join(optional)}]"
        return f"{prefix}{name}({inner})"

    def result_type(self):
        return self.types[self.result][0] if self.result else ""


def statements(text):
    """Lines of free form without comments, continued ones joined."""
    joined = ""
    for line in text.splitlines():
        line = re.sub(r"(^|\s)!.*", "", line).strip()
        if line.endswith("&"):
            joined += line[:-1].strip() + " "
            continue
        if joined + line:
            yield joined + line
        joined = ""


def procedures_of(text):
    found, current = {}, None
    for line in statements(text):
        head = re.match(r"(?:impure |elemental |pure )*(?:([\w()]+) )?(subroutine|function) (\w+)\(([^)]*)\)"
                        r"(?:\s*result\((\w+)\))?$", line)
        if head and not line.startswith("end"):
            result_type, kind, name, arguments, result = head.groups()
            result = (result or name) if kind == "function" else None
            current = Procedure(name, [a.strip() for a in arguments.split(",") if a.strip()], result)
            if result and result_type:
                current.types[result] = (result_type, "", False)
            found[name] = current
        elif current and "::" in line:
            left, right = (part.strip() for part in line.split("::", 1))
            words = re.findall(r"\w+(?:\([^()]*\))?", left)
            intent = next((w[7:-1] for w in words if w.startswith("intent(")), "")
            extra = ", allocatable" if "allocatable" in words else ""
            for entity in re.findall(r"(\w+)(\([^)]*\))?", re.sub(r"=.*", "", right)):
                if entity[0] in current.arguments or entity[0] == current.result:
                    shape = " " + entity[1] if entity[1] else ""
                    current.types[entity[0]] = (words[0] + extra + shape, intent, "optional" in words)
        elif current and re.match(r"end (subroutine|function)", line):
            current = None
    return found


def module_rows():
    """Rows of each table: (signature, result), by the type they belong to; types of arguments."""
    folder = PROJECT / "fortran_bindings"
    main = (folder / "wrcontact.f90").read_text(encoding="utf-8")
    whole = main + "".join((folder / f"wrcontact_{part}.inc").read_text(encoding="utf-8")
                           for part in ("library", "scene", "solver", "vehicle", "history", "table",
                                        "normal", "rolling", "profile", "namelist"))
    procedures = procedures_of(whole)
    rows, used = {}, []
    variables = {"contact_scene": "scene", "contact_solver": "solver", "contact_history": "history",
                 "contact_table": "table",
                 "contact_profile": "profile",
                 "normal_contact": "normal", "rolling_contact": "rolling"}

    def add(table, name, procedure, variable=""):
        hidden = (procedure.arguments[0],) if variable else ()
        prefix = ("" if procedure.result else "call ") + (variable + "%" if variable else "")
        row = (procedure.signature(name, prefix, hidden), procedure.result_type())
        if row not in rows.setdefault(table, []):  # those of a generic may look the same
            rows[table].append(row)
        used.append((procedure, hidden))

    for kind, variable in variables.items():
        block = re.search(rf"^  type, public :: {kind}\n(.*?)^  end type", main, re.M | re.S).group(1)
        own = {}
        for line in statements(block):
            bound = re.match(r"procedure(, private)? :: (\w+) => (\w+)", line)
            if bound:
                own[bound.group(2)] = (bound.group(3), bool(bound.group(1)))
        for line in statements(block):
            generic = re.match(r"generic :: (\w+) => (.*)", line)
            for name in (generic.group(2).split(",") if generic else []):
                add(variable, generic.group(1), procedures[own[name.strip()][0]], variable)
        for name, (implementation, private) in own.items():
            if not private:
                add(variable, name, procedures[implementation], variable)
    for names in re.findall(r"^  public :: (.*)$", main, re.M):
        for name in re.findall(r"\w+", names):
            if name in procedures:
                add("module", name, procedures[name])
    arguments = {}
    for procedure, hidden in used:
        for name in procedure.arguments:
            if name not in hidden:
                kind, intent, optional = procedure.types[name]
                entry = arguments.setdefault(name, ([], []))
                for place, value in zip(entry, (kind, intent)):
                    if value not in place:
                        place.append(value)
    rows["arguments"] = [(name, " or ".join(kinds), ", ".join(intents))
                         for name, (kinds, intents) in sorted(arguments.items())]
    return rows


def f77_rows():
    literals = {"kind0": "KIND(0)", "one": "1.0D0"}
    lines, types, current, calls = [], {}, None, []
    parts = ("handle", "scene", "table", "profile", "contact")
    sources = ["f77.f90", *(f"f77_{part}.inc" for part in parts)]
    whole = "".join(text_of(f"fortran_bindings/wrcontact_{source}") for source in sources)
    for line in whole.lower().splitlines():
        line = line.strip()
        if lines and lines[-1].endswith("&"):
            lines[-1] = lines[-1][:-1] + line
        elif line and not line.startswith("!"):
            lines.append(line)
    for line in lines:
        head = re.match(r"subroutine (wrc\w+)\((.*)\)", line)
        if head:
            current = [a.strip() for a in head.group(2).split(",")]
            shown = [literals.get(a, a.upper()) for a in current]
            calls.append((f"CALL {head.group(1).upper()}({', '.join(shown)})",))
        declared = re.match(r"(integer\*8|integer\*4|real\*8|character\*\(\*\)|type\(contact_patch\))"
                            r"(?:, target ::)? (.*)", line)
        if current and declared:
            # Integers of either width are all declared as arrays.
            kind = {"integer*4": "INTEGER", "type(contact_patch)": "REAL*8"}.get(
                declared.group(1), declared.group(1).upper())
            lists = {"ids": " (*)", "counts": " (*)", "istate": " (2)", "iopt": " (5)", "patch": " (22,*)"}
            for name, array in re.findall(r"(\w+)(\([^)]*\))?", declared.group(2)):
                if name in current and name not in literals:
                    shape = lists.get(name, "" if kind == "INTEGER" or not array else " " + array)
                    types.setdefault(name.upper(), set()).add(kind + shape)
    arguments = [(name, " or ".join(sorted(kinds))) for name, kinds in sorted(types.items())]
    return {"calls": calls, "arguments": arguments}


def check_tables(update):
    """Each table of a mark: rows in the order of the source, with what they do from the page."""
    page = "docs/fortran-calls.md"
    text = text_of(page)
    sources = {"module": module_rows(), "f77": f77_rows()}
    marks = re.compile(r"(<!-- (module|f77) (\w+) -->\n)(.*?)(<!-- end -->)", re.S)
    seen = set()

    def rewritten(match):
        mark, source, table, body, end = match.groups()
        seen.add((source, table))
        lines = body.strip("\n").split("\n")
        does = {}
        for line in lines[2:]:
            cells = [cell.strip() for cell in line.strip("|").split("|")]
            does[cells[0].strip("`")] = cells[-1]
        rows = []
        for row in sources[source].get(table, []):
            cells = [f"`{cell}`" if cell and " or " not in cell and i < 2 else cell
                     for i, cell in enumerate(row)]
            if table != "arguments":
                cells.append(does.get(row[0]) or "?")
                if cells[-1] == "?":
                    fail(page, f"{row[0]}: the page does not say what it does")
            rows.append("| " + " | ".join(cells) + " |")
        return mark + "\n".join([*lines[:2], *rows]) + "\n" + end

    new = marks.sub(rewritten, text)
    for source, tables in sources.items():
        for table in tables:
            if (source, table) not in seen:
                fail(page, f"there is no table <!-- {source} {table} -->")
    if new != text:
        if update:
            (PROJECT / page).write_text(new, encoding="utf-8")
        else:
            before, after = text.splitlines(), new.splitlines()
            for line in after:
                if line not in before:
                    fail(page, f"missing: {line}")
            for line in before:
                if line not in after:
                    fail(page, f"not in the source: {line}")


def main():
    if sys.argv[1:] not in ([], ["--update"]):
        print(f"scripts/check_docs.py {' '.join(sys.argv[1:])}: must be --update or nothing",
              file=sys.stderr)
        return 2
    check_tables(update=bool(sys.argv[1:]))
    check_links()
    check_quotations()
    check_index()
    check_rooms()
    check_places("docs/architecture.md")
    check_places("docs/extending.md")
    check_build_options()
    check_removed_names()
    print("\n".join(failures), end="\n" if failures else "")
    return 1 if failures else 0


sys.exit(main())
