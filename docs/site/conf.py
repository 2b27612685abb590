"""The pages of the repository as a site (scripts/site.sh): Sphinx reads this file from a copy of the pages.

Two pages are written here first: thumbnails of the pictures of docs/jobs.md, and each notebook with what its cells show.
Cells are run where WRC_PYTHON names the folder of the Python package; otherwise stored outputs are shown.
"""
import ast
import contextlib
import io
import json
import os
import re
import sys
from pathlib import Path

from pygments.lexers.fortran import FortranFixedLexer
from sphinx.highlighting import lexers

HERE = Path(__file__).resolve().parent
PAGES = HERE.parents[1]

project = "wrcontact"
html_title = "wrcontact"
version = re.search(r"^Version ([\d.]+),", (PAGES / "README.md").read_text(encoding="utf-8"), re.M).group(1)
root_doc = "README"
extensions = ["myst_parser"]
myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
html_theme = "furo"
html_static_path = ["site.css"]
html_css_files = ["site.css"]
html_extra_path = ["../../extra"]  # the reference of the interfaces
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
# Blocks of output and of file formats have no language.
highlight_language = "none"
lexers["f77"] = FortranFixedLexer()


def slug(heading):
    return re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-")


def write_gallery():
    text = "# Gallery\n\nEach picture leads to the command that draws it.\n\n::::{container} gallery\n"
    heading = ""
    for line in (PAGES / "docs/jobs.md").read_text(encoding="utf-8").splitlines():
        if found := re.match(r"#+ (.*)", line):
            heading = found.group(1)
        elif found := re.match(r"!\[(.*)\]\((images/.*)\)", line):
            text += (f":::{{figure}} docs/{found.group(2)}\n:target: docs/jobs.html#{slug(heading)}\n"
                     f":alt: \"{found.group(1)}\"\n\n{found.group(1)}\n:::\n")
    (PAGES / "gallery.md").write_text(text + "::::\n", encoding="utf-8")


def shown(value, folder, name):
    """A value as the page shows it: a picture, a table, or its text."""
    if hasattr(value, "savefig"):
        value.savefig(folder / f"{name}.png", dpi=90, bbox_inches="tight")
        return f"![Output of this cell]({name}.png)\n\n"
    if hasattr(value, "to_html"):
        return value.to_html(border=0) + "\n\n"
    return "" if value is None else f"```\n{value!r}\n```\n\n"


def stored(cell):
    return "".join(f"```\n{''.join(output.get('text', output.get('data', {}).get('text/plain', [])))}\n```\n\n"
                   for output in cell.get("outputs", []))


def run(source, names, folder, name):
    """What a cell prints, and the value of its last line."""
    code = ast.parse(source)
    last = code.body.pop() if code.body and isinstance(code.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.chdir(folder), contextlib.redirect_stdout(printed), contextlib.redirect_stderr(printed):
        exec(compile(code, name, "exec"), names)
        value = eval(compile(ast.Expression(last.value), name, "eval"), names) if last else None
    text = re.sub(r"^.*/(?=[^/\s]+:\d+: )", "", printed.getvalue(), flags=re.M).strip()
    return (f"```\n{text}\n```\n\n" if text else "") + shown(value, folder, name)


def write_notebook(path, runs):
    names, page = {}, ""
    for index, cell in enumerate(json.loads(path.read_text(encoding="utf-8"))["cells"]):
        source = "".join(cell["source"])
        if cell["cell_type"] == "markdown":
            page += source + "\n\n"
        elif cell["cell_type"] == "code":
            page += f"```python\n{source}\n```\n\n"
            page += run(source, names, path.parent, f"{path.stem}-{index}") if runs else stored(cell)
    path.with_suffix(".md").write_text(page, encoding="utf-8")


write_gallery()
package = os.environ.get("WRC_PYTHON")
if package:
    sys.path.insert(0, package)
for notebook in sorted(PAGES.rglob("*.ipynb")):
    write_notebook(notebook, bool(package))
