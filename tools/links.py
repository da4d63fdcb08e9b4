"""The project's pages and where they lead: every link has its file, every anchor its heading."""

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

from markdown_it import MarkdownIt
from markdown_it.token import Token

ROOT = Path(__file__).parents[1]
PATTERNS = ("*.md", "docs/*.md", "app/**/README.md", "clients/*/README.md", "bench/*.md", "tests/**/README.md")
ELSEWHERE = re.compile(r"^(https?:|mailto:)")


@dataclass(frozen=True, slots=True)
class Link:
    """What a page leads to: ``target`` as it is written there, in the line ``line``."""

    page: Path
    line: int
    target: str

    @property
    def file(self) -> Path:
        """The file that it leads to; the page itself where only an anchor is named."""
        path = self.target.partition("#")[0]
        return Path(self.page.parent, path).resolve() if path else self.page

    @property
    def anchor(self) -> str:
        """The heading that it leads to, as its anchor; empty: the file as a whole."""
        return self.target.partition("#")[2]

    def trouble(self, root: Path = ROOT) -> str:
        """Return what is wrong with it; empty: nothing."""
        where = f"{self.page.relative_to(root)}:{self.line}: {self.target}"
        if not self.file.is_relative_to(root):
            return f"{where} leads out of the project"
        if not self.file.exists():
            return f"{where}: there is no such file"
        if self.file.is_dir():
            return f"{where} is a directory, which a site of pages has not: name a file in it"
        if self.anchor and self.anchor not in anchors(self.file):
            return f"{where}: no heading there has this anchor; there are {', '.join(sorted(anchors(self.file)))}"
        return ""


def pages(root: Path = ROOT) -> list[Path]:
    """Return all pages, in order of their names."""
    return sorted({page for pattern in PATTERNS for page in root.glob(pattern)})


def links(page: Path) -> Iterator[Link]:
    """Give the links and pictures of a page that lead to files of the project."""
    for token in _tokens(page):
        line = (token.map or [0])[0] + 1
        for inner in token.children or ():
            target = inner.attrGet("href") or inner.attrGet("src")
            if isinstance(target, str) and not ELSEWHERE.match(target):
                yield Link(page, line, target)


@lru_cache
def anchors(page: Path) -> frozenset[str]:
    """Return the anchors of a page's headings, as GitHub makes them."""
    found: list[str] = []
    for before, token in pairwise(_tokens(page)):
        if before.type == "heading_open":
            name = re.sub(r"[^\w\- ]", "", re.sub(r"[`*]", "", token.content).strip().lower()).replace(" ", "-")
            again = sum(one == name or re.fullmatch(rf"{re.escape(name)}-\d+", one) is not None for one in found)
            found.append(f"{name}-{again}" if again else name)
    return frozenset(found)


def _tokens(page: Path) -> list[Token]:
    return MarkdownIt("commonmark").enable("table").parse(page.read_text(encoding="utf-8"))
