"""The committed page is the one that its sources give, and needs nothing from elsewhere."""

import hashlib
import json
import re
from pathlib import Path

from app.web import PAGE

WEB = Path(__file__).parents[2] / "web"
SOURCES = ("index.html", "package.json", "package-lock.json", "tsconfig.json", "vite.config.ts", "src")
TEXTS = ("../app/texts/en.json", "../app/texts/ko.json")


def digest_of_sources() -> str:
    """As ``web/vite.config.ts`` computes it."""
    roots = [WEB / name for name in SOURCES]
    files = [file for root in roots for file in ([root] if root.is_file() else root.rglob("*")) if file.is_file()]
    digest = hashlib.sha256()
    named = [(file.relative_to(WEB).as_posix(), file) for file in files] + [(name, WEB / name) for name in TEXTS]
    for name, file in sorted(named):
        digest.update(name.encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()


def test_the_bundle_is_built_from_the_present_sources() -> None:
    manifest = json.loads((PAGE / "manifest.json").read_text(encoding="utf-8"))
    assert manifest["sources"] == digest_of_sources(), "the sources have changed: run `make web`"


def test_the_page_finds_all_its_parts_beside_it() -> None:
    page = (PAGE / "index.html").read_text(encoding="utf-8")
    parts = re.findall(r'(?:src|href)="(/[^"]+)"', page)
    assert {Path(part).suffix for part in parts} == {".js", ".css"}
    assert {PAGE / part.lstrip("/") for part in parts} == set((PAGE / "assets").iterdir())


def test_the_page_names_no_other_host() -> None:
    files = [PAGE / "index.html", *(PAGE / "assets").iterdir()]
    named = {found for file in files for found in re.findall(r"(?:https?|wss?)://([\w.-]+)", file.read_text("utf-8"))}
    assert named <= {"www.w3.org"}, "only names of XML vocabularies are allowed"


def test_the_lock_names_no_registry() -> None:
    lock = json.loads((WEB / "package-lock.json").read_text(encoding="utf-8"))
    assert not [name for name, package in lock["packages"].items() if "resolved" in package]
