#!/usr/bin/env python3
"""Writes fortran_bindings/wrcontact_c.inc, the functions and structures of wrcontact.h for Fortran.

Usage: write_fortran_interface.py [--check] [HEADERS BINDINGS]

With --check it writes nothing and fails if the file is not what it would write, if the module's
constants are not those of the headers, or if the module never calls a function. The tables below hold
what the headers do not say of an argument. Types that are not known are refused. Needs pycparser.
"""
import pathlib
import re
import sys

from pycparser import c_ast, c_parser

HEAD = """\
! The C interface, wrcontact.h with wrcontact_grid.h, as Fortran sees it; part of the module
! wrcontact, where all of it is private, and of the F77 layer. Written by
! scripts/write_fortran_interface.py: do not edit.
!
! Texts are passed to C null-terminated and come back as addresses of such. Arguments
! that C may leave untouched are intent(inout); optional ones are NULL for C if absent.
"""
# The name in Fortran, and what the structure is.
TYPES = {
    "wrc_step_arguments": ("wrc_step_arguments", "Further arguments of a step"),
    "wrc_patch": ("contact_patch, public", "A contact patch, in the scene's convention"),
    "wrc_table_options": ("wrc_table_options", "Range and fineness of a table"),
    "wrc_table_facts": ("table_facts, public", "What a table is and how accurate it is"),
    "wrc_read_options": ("wrc_read_options", "How the file of a profile is read"),
}
VALUES = {"int32_t": "integer(c_int32_t)", "wrc_status": "integer(c_int32_t)", "int64_t": "integer(c_int64_t)",
          "uint64_t": "integer(c_int64_t)", "double": "real(c_double)"}
# Addresses of one number, in functions where they are not arrays; and arguments that may be absent.
SCALARS = {"count", "id", "kind", "length", "sheets", "value"}
POINTS = {"place", "lateral", "height", "angle", "curvature"}
OPTIONAL = {
    "wrc_scene_get_numbers": {"values"}, "wrc_scene_field": {"values"}, "wrc_normal_field": {"values"},
    "wrc_rolling_field": {"values"}, "wrc_solver_creep": {"by_creepage"}, "wrc_table_step": {"error"},
    "wrc_table_equilibrium": {"velocity", "error"},
    "wrc_solver_step": {"rails", "by_position", "by_velocity", "states"},
    "wrc_step_batch": {"rails", "by_positions", "by_velocities", "states"},
    "wrc_solver_equilibrium": {"velocity"}, "wrc_profile_points": {"lateral", "height"},
    "wrc_profile_nodes": {"arcs"}, "wrc_profile_at": POINTS, "wrc_profile_surface_at": POINTS,
}
RESULTS = {"const char*": "text", "wrc_status": "status", "int64_t": "count"}
COVERED = {"wrc_solver_step", "wrc_step_batch"}  # by others with more arguments, which the module calls
HEADERS = ("wrcontact.h", "wrcontact_grid.h")


def declarations(text):
    """Of a header: comments, directives and what only C++ sees go."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", text, flags=re.S).replace('extern "C" {', "").replace("\n}\n", "\n")
    text = re.sub(r"^#.*(\\\n.*)*", "", text, flags=re.M)
    return re.sub(r"WRC_REMOVED[^;]*;", "", text).replace("WRC_API", "")


def c_type(node):
    """As it is written: `const double*`."""
    if isinstance(node, c_ast.PtrDecl):
        if isinstance(node.type, c_ast.FuncDecl):
            return "procedure"
        return c_type(node.type) + "*" + (" const" if "const" in node.quals else "")
    return " ".join([*node.quals, *node.type.names])


def argument(function, name, kind):
    """Its declaration in Fortran."""
    array = not (name in SCALARS or (name in POINTS and function.endswith("_at")))
    optional = ", optional" if name in OPTIONAL.get(function, ()) else ""
    base = kind.removeprefix("const ").removesuffix("*")
    intent = "in" if kind.startswith("const ") else "inout"
    if kind == "procedure":
        return f"type(c_funptr), value :: {name}"
    if kind == "const char*":
        return f"character(kind=c_char), intent(in) :: {name}(*)"
    if kind in VALUES:
        return f"{VALUES[kind]}, value :: {name}"
    if base in TYPES:
        return f"type({TYPES[base][0].split(',')[0]}), intent({intent}) :: {name}" + "(*)" * (name == "patches")
    if base in VALUES:
        return f"{VALUES[base]}, intent({intent}){optional} :: {name}" + "(*)" * (array or intent == "in")
    if re.fullmatch(r"wrc_\w+\* const", base):
        return f"type(c_ptr), intent(in) :: {name}(*)"
    if re.fullmatch(r"(const char|wrc_\w+)\*\*", kind):
        return f"type(c_ptr), intent(inout) :: {name}"
    if re.fullmatch(r"void\*|(const )?wrc_\w+\*", kind):
        return f"type(c_ptr), value :: {name}"
    sys.exit(f"{function}: no Fortran for the type of {name}, {kind}")


def folded(line):
    """At most 100 columns, continued after a comma or a parenthesis."""
    if len(line) <= 100:
        return line
    cut = max(line.rfind(mark, 0, 98) for mark in (", ", ") ")) + 1
    return line[:cut] + " &\n" + folded("      " + line[cut + 1:])


def interface(name, result, arguments):
    lines = [argument(name, *pair) for pair in arguments]
    returned = RESULTS.get(result)
    if returned:
        lines.append(f"{VALUES.get(result, 'type(c_ptr)')} :: {returned}")
    elif result != "void":
        sys.exit(f"{name}: no Fortran for its result, {result}")
    word = "function" if returned else "subroutine"
    imports = sorted(set(re.findall(r"c_\w+|(?<=type\()\w+", "\n".join(line.split("::")[0] for line in lines))))
    head = f"    {word} {name}({', '.join(one for one, _ in arguments)}) bind(C)"
    return "\n".join([folded(head + f" result({returned})" * bool(returned)), f"      import :: {', '.join(imports)}",
                      *(f"      {line}" for line in lines), f"    end {word} {name}\n"])


def structure(name, members):
    fortran, meaning = TYPES[name]
    lines = [f"    {VALUES[kind]} :: {member} = 0" if kind in VALUES else f"    type(c_ptr) :: {member} = c_null_ptr"
             for member, kind in members]
    title = fortran.split(",")[0]
    return "\n".join([f"  !> {meaning}; see {name} in wrcontact.h.",
                      f"  type, bind(C){fortran.removeprefix(title)} :: {title}", *lines, f"  end type {title}\n"])


def include_file(headers):
    types, functions = [], []
    known = "".join(f"typedef int {name};" for name in ("int32_t", "int64_t", "uint64_t"))
    for node in c_parser.CParser().parse(known + "".join(declarations(text) for text in headers)).ext:
        if isinstance(node, c_ast.Decl):
            arguments = [(one.name, c_type(one.type)) for one in node.type.args.params]
            arguments = [one for one in arguments if one[1] != "void"]
            functions.append(interface(node.name, c_type(node.type.type), arguments))
        elif getattr(node.type.type, "decls", None):
            types.append(structure(node.name, [(one.name, c_type(one.type)) for one in node.type.type.decls]))
    functions.append("    function strlen(text) bind(C) result(length)\n      import :: c_ptr, c_size_t\n"
                     "      type(c_ptr), value :: text\n      integer(c_size_t) :: length\n    end function strlen\n")
    return "\n".join([HEAD, *types, "  interface"]) + "\n" + "\n".join(functions) + "  end interface\n"


def faults(headers, bindings, text):
    """What differs between the headers and the module."""
    if (bindings / "wrcontact_c.inc").read_text() != text:
        yield "wrcontact_c.inc is not that of the headers: run scripts/write_fortran_interface.py"
    module = (bindings / "wrcontact.f90").read_text()
    defined = re.findall(r"^#define (WRC_[A-Z_]+) (\d+)", "".join(headers), flags=re.M)
    lines = re.findall(r"parameter, public :: (.*)", module)
    known = [pair for line in lines for pair in re.findall(r"(wrc_\w+) = (\d+)", line)]
    for name, value in sorted({(name.lower(), value) for name, value in defined} ^ set(known)):
        yield f"{name} = {value}: a constant of wrcontact.h or of wrcontact.f90 only"
    calls = module + "".join(path.read_text() for path in bindings.glob("wrcontact_[!cf]*.inc"))
    bound = set(re.findall(r"end (?:function|subroutine) (wrc_\w+)", text)) - COVERED
    for name in sorted(bound - set(re.findall(r"(\w+)\(", calls))):
        yield f"{name}: the module never calls it"


def main():
    words = [word for word in sys.argv[1:] if word != "--check"]
    project = pathlib.Path(__file__).parent.parent
    folder, bindings = map(pathlib.Path, words or [project / "c_api/include", project / "fortran_bindings"])
    headers = [(folder / name).read_text() for name in HEADERS]
    text = include_file(headers)
    if "--check" not in sys.argv:
        (bindings / "wrcontact_c.inc").write_text(text)
        return 0
    found = list(faults(headers, bindings, text))
    for fault in found:
        print(fault)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
