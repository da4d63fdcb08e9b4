"""Files that hold a layout, but are no plant files: what they are is said, instead of all that is wrong with their YAML."""

import re
from collections.abc import Iterator
from itertools import islice

from app.plant.findings import Finding, Severity

LOOKED_AT = 20
"""Lines that are looked at for how a text begins. Our choice."""
_KEY = re.compile(r"\s*[\w.-]+\s*:(?:\s|$)")
_CELLS = re.compile(r"[^,;\t|]*(?:[,;\t|][^,;\t|]*)+")
_REMEDY = "make a plant file of it: hoistway layout import FILE -o plant.yaml"


def foreign(text: str) -> list[Finding]:
    """Return what a text is that describes no plant, as a finding about its beginning; nothing: it may be a plant file.

    Only for texts that could not be read as one.
    """
    what = _what(text.lstrip("\ufeff \r\n"))
    return [Finding(1, 1, Severity.ERROR, "", f"this is no plant file, but {what}", _REMEDY)] if what else []


def _what(text: str) -> str:
    if text.startswith("<"):
        return "XML"
    if text.startswith(("{", "[")) and re.search(r'"(?:layouts|nodes|metaInformation)"\s*:', text):
        return "a layout in JSON"
    lines = list(islice(_filled(text), LOOKED_AT))
    if any(map(_KEY.match, lines)):
        return ""
    return "a list (CSV)" if 2 * sum(map(bool, map(_CELLS.fullmatch, lines))) > len(lines) else ""


def _filled(text: str) -> Iterator[str]:
    return (line for line in text.splitlines() if line.strip() and not line.startswith("#"))
