"""What the site of the documentation is made of, and what its builder notices. ``make docs`` builds the whole of it."""

import json
import re
from pathlib import Path

import pytest
import typer
import yaml

from app.api.commands import COMMANDS
from app.cli import app as cli
from tests.api.test_openapi import QUICK
from tools import reference
from tools.site import ROOT, lay_out, troubles

REST = json.loads((ROOT / "openapi/openapi.json").read_text(encoding="utf-8"))
LIVE = yaml.load((ROOT / "openapi/asyncapi.yaml").read_text(encoding="utf-8"), QUICK)


@pytest.fixture(scope="module")
def pages() -> dict[str, str]:
    return reference.pages()


def test_the_reference_has_every_route_and_every_schema(pages: dict[str, str]) -> None:
    routes = {f"{method.upper()} {path}" for path, found in REST["paths"].items() for method in found}
    told = [line for name, text in pages.items() if name.startswith("rest-") for line in text.splitlines()]
    assert {f"## `{route}`" for route in routes} <= set(told)
    assert {f"## {name}" for name in REST["components"]["schemas"]} <= set(pages["schemas"].splitlines())


def test_the_reference_has_every_message_and_command_of_the_live_stream(pages: dict[str, str]) -> None:
    lines = pages["live"].splitlines()
    assert {f"### Message {name}" for name in LIVE["components"]["messages"]} <= set(lines)
    rows = [re.match(r"\| `([a-z.]+)` \|", line) for line in lines]
    assert set(COMMANDS) <= {row[1] for row in rows if row}


def test_the_reference_has_every_command_of_the_command_line(pages: dict[str, str]) -> None:
    main = typer.main.get_command(cli)
    names = getattr(main, "commands", {})
    assert names
    assert {f"## `hoistway {name}`" for name in names} <= set(pages["command-line"].splitlines())


def test_the_first_page_leads_to_every_page_and_what_pages_lead_to_is_laid_beside_them(tmp_path: Path) -> None:
    lay_out(tmp_path)
    listed = re.findall(r"(?:<|^)([\w./-]+\.md)>?$", (tmp_path / "index.md").read_text(encoding="utf-8"), re.MULTILINE)
    laid = {str(page.relative_to(tmp_path)) for page in tmp_path.rglob("*.md")} - {"index.md"}
    assert sorted(listed) == sorted(laid)
    assert (tmp_path / "docs/screenshot.png").is_file()


@pytest.mark.parametrize(
    ("body", "trouble"),
    [
        ('<p id="a"><a href="#a">x</a><a href="two.html#b">x</a><a href="https://example.com/">x</a>', ""),
        ('<a href="#b">x</a>', "one.html leads to #b"),
        ('<a href="two.html#c">x</a>', "one.html leads to two.html#c"),
        ('<a href="three.html">x</a>', "one.html leads to three.html"),
        ('<img src="three.png">', "one.html leads to three.png"),
        ('<script src="https://cdn.example/x.js"></script>', "one.html fetches https://cdn.example/x.js"),
        ('<link href="//fonts.example/x.css">', "one.html fetches //fonts.example/x.css"),
    ],
)
def test_a_site_that_leads_nowhere_or_asks_another_host_is_told(tmp_path: Path, body: str, trouble: str) -> None:
    (tmp_path / "one.html").write_text(body)
    (tmp_path / "two.html").write_text('<h1 id="b">B</h1>')
    assert troubles(tmp_path) == ([trouble] if trouble else [])


def test_styles_that_ask_another_host_are_told(tmp_path: Path) -> None:
    (tmp_path / "x.css").write_text("body { src: url('https://fonts.example/x.woff2') }")
    assert troubles(tmp_path) == ["x.css fetches something of another host"]
