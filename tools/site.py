"""The documentation as a site with a search, in ``site/html``: ``python -m tools.site``.

All pages of the project and the reference are laid out as they lie in the project, so that their links hold here and there.
Whatever is wrong fails it: a warning of Sphinx, a link to a page or an anchor that is not there, anything asked of another host,
a search that finds nothing (looked at from the disk, without a server, where Chromium is installed).
"""

import re
import shutil
import sys
from collections.abc import Iterator
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import quote, unquote, urlsplit

from sphinx.cmd.build import main as sphinx

from tools import chromium, links, reference

ROOT = Path(__file__).parents[1]
SITE = ROOT / "site"
FIRST = ("README.md", "README.ko.md", "docs/tutorial.md")
TITLES = {"README.md": "Read me first", "README.ko.md": "한국어", "clients/python/README.md": "The Python client"}
"""Titles of the list where a page's own would not tell it from others."""
LOADED = {("script", "src"), ("link", "href"), ("img", "src"), ("iframe", "src"), ("source", "src")}
"""What a browser fetches by itself."""
SOUGHT = ("closure", "호이스트", "drive.jog", "ReasonIn")
"""Words that a person may search for, in guides, in Korean and in the reference."""
FETCHED = re.compile(r"""url\(\s*["']?https?:|@import\s+["']https?:""")


def lay_out(into: Path) -> None:
    """Write all pages, what they show, and the reference into a directory."""
    shutil.rmtree(into, ignore_errors=True)
    names = [page.relative_to(ROOT) for page in links.pages() if not page.is_relative_to(ROOT / "tests")]
    files = {link.file for name in names for link in links.links(ROOT / name) if link.file.is_file()}
    for file in sorted({*(ROOT / name for name in names), *files}):
        copy = into / file.relative_to(ROOT)
        copy.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(file, copy)
    made = reference.pages()
    (into / "reference").mkdir()
    for name, text in made.items():
        (into / "reference" / f"{name}.md").write_text(text, encoding="utf-8")
    (into / "index.md").write_text("\n".join(_index([str(name) for name in names], list(made))), encoding="utf-8")


def _index(pages: list[str], made: list[str]) -> Iterator[str]:
    """Give the first page: where everything is."""
    guides = [page for page in pages if page.startswith("docs/") and page not in FIRST]
    others = [page for page in pages if page not in {*FIRST, *guides}]
    yield "# Hoistway\n\nBegin with the [first ten minutes](README.md#the-first-ten-minutes).\n"
    parts = {
        "Begin": FIRST,
        "Guides": guides,
        "Reference": [f"reference/{name}.md" for name in made],
        "Working on it": others,
    }
    for caption, names in parts.items():
        yield f"```{{toctree}}\n:caption: {caption}\n:maxdepth: 1\n"
        yield from (f"{TITLES[name]} <{name}>" if name in TITLES else name for name in names)
        yield "```\n"


class _Page(HTMLParser):
    """What a built page leads to, what it has a name for, and what a browser would fetch for it."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.targets: list[str] = []
        self.names: set[str] = set()
        self.fetched: list[str] = []
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Take what matters of an element."""
        for name, value in attrs:
            if name in {"id", "name"} and value:
                self.names.add(value)
            if value and name in {"href", "src"}:
                self.targets.append(value)
                if (tag, name) in LOADED:
                    self.fetched.append(value)


def troubles(html: Path) -> list[str]:
    """Return what is wrong with a built site."""
    pages = {file: _Page(file.read_text(encoding="utf-8")) for file in sorted(html.rglob("*.html"))}
    found = [
        f"{file.relative_to(html)} fetches {target}"
        for file, page in pages.items()
        for target in page.fetched
        if urlsplit(target).netloc
    ]
    found += [
        f"{file.relative_to(html)} fetches something of another host"
        for file in sorted(html.rglob("*.css"))
        if FETCHED.search(file.read_text(encoding="utf-8"))
    ]
    for file, page in pages.items():
        found += [
            f"{file.relative_to(html)} leads to {target}" for target in page.targets if _is_lost(file, target, pages)
        ]
    return found


def _is_lost(file: Path, target: str, pages: dict[Path, _Page]) -> bool:
    """Whether a link leads nowhere."""
    parts = urlsplit(target)
    if parts.scheme or parts.netloc:
        return False
    where = (file.parent / unquote(parts.path)).resolve() if parts.path else file
    if where in pages and parts.fragment:
        return unquote(parts.fragment) not in pages[where].names
    return not where.is_file()


def unfound(html: Path) -> list[str]:
    """Return what goes wrong when a person searches the site, opened from the disk."""
    found: list[str] = []
    with chromium.browser() as page:
        for word in SOUGHT:
            page.open(f"{(html / 'search.html').as_uri()}?q={quote(word)}")
            page.until("document.querySelector('#search-results .search-summary')?.innerText.length > 0")
            if not page.ask("document.querySelectorAll('#search-results li').length"):
                found.append(f"the search finds nothing for {word}")
        found += [f"the search asks {url}" for url in page.requests if not url.startswith(("file:", "data:"))]
        return found + [f"the search complains: {said}" for said in page.complaints]


def main() -> int:
    """Build the site; return the exit code."""
    lay_out(SITE / "source")
    shutil.rmtree(SITE / "html", ignore_errors=True)
    code = sphinx(
        ["-b", "html", "-q", "-W", "--keep-going", "-j", "auto", "-d", str(SITE / "trees"), "-c", str(ROOT / "docs"),
         str(SITE / "source"), str(SITE / "html")]
    )  # fmt: skip
    wrong = troubles(SITE / "html") + (unfound(SITE / "html") if chromium.installed() else [])
    sys.stderr.writelines(f"{line}\n" for line in wrong)
    if code or wrong:
        return 1
    sys.stdout.write(f"the documentation is in {SITE / 'html' / 'index.html'}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
