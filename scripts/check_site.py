#!/usr/bin/env python3
"""Checks a site that scripts/site.sh has built: links, anchors and pictures exist, and searches lead to their page.

Usage: scripts/check_site.py FOLDER

Searches are made in headless Chromium; the first page found must be one of those that answer. Pages by Doxygen and pydoc
are checked as targets only.
"""
from __future__ import annotations

import re
import subprocess
import sys
import tempfile
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import quote, unquote

SEARCHES = {
    "friction per wheel": ("docs/vehicle",),
    "cluster": ("docs/studies",),
    "Kalker": ("docs/creep", "docs/evidence/models"),
    "accuracy of my worn wheel": ("docs/accuracy", "docs/profiles"),
    "install without root": ("docs/build",),
    "Simpack": ("docs/profiles", "docs/other-programs"),
}


class Page(HTMLParser):
    def __init__(self, path: Path) -> None:
        super().__init__()
        self.anchors: set[str] = set()
        self.links: set[str] = set()
        self.feed(path.read_text(encoding="utf-8"))

    def handle_starttag(self, tag: str, attributes: list[tuple[str, str | None]]) -> None:
        for name, value in attributes:
            if name in ("id", "name") and value:
                self.anchors.add(value)
            elif name in ("href", "src") and value and not re.match(r"[a-z]+:|//", value):
                self.links.add(value)


def broken_links(site: Path) -> list[str]:
    pages = {path: Page(path) for path in site.rglob("*.html") if "reference" not in path.relative_to(site).parts[:1]}
    faults = []
    for path, page in pages.items():
        for link in sorted(page.links):
            file, _, anchor = unquote(link.partition("?")[0]).partition("#")
            target = (path.parent / file).resolve() if file else path
            if not target.exists():
                faults.append(f"{path.relative_to(site)}: {link}: there is no such file")
            elif anchor and target in pages and anchor not in pages[target].anchors:
                faults.append(f"{path.relative_to(site)}: {link}: there is no such place")
    return faults


def found(site: Path, words: str) -> list[str]:
    with tempfile.TemporaryDirectory() as profile:
        dom = subprocess.run(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={profile}",
             "--virtual-time-budget=8000", "--dump-dom", f"file://{site}/search.html?q={quote(words)}"],
            capture_output=True, text=True, check=True).stdout
    results = dom.partition('id="search-results"')[2]
    return [link.partition(".html")[0] for link in re.findall(r'<li[^>]*><a href="([^"]*)"', results)]


def main() -> int:
    site = Path(sys.argv[1]).resolve()
    faults = broken_links(site)
    for words, wanted in SEARCHES.items():
        pages = found(site, words)
        if not pages or pages[0] not in wanted:
            faults.append(f"search for \"{words}\": first {', '.join(pages[:3]) or 'nothing'}; must be {' or '.join(wanted)}")
    print("\n".join(faults) or f"site: links are whole, {len(SEARCHES)} searches lead to their page")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
