"""How words, numbers and texts stand in a plant file."""

import json
import re
from collections.abc import Iterable
from typing import TypeAlias

from app.domain.units import Barcode

Value: TypeAlias = str | int
_BARE = re.compile(r"[A-Za-z_][A-Za-z0-9_.+-]*")
_MEANT_OTHERWISE = frozenset({"true", "false", "null"})


def quoted(text: str) -> str:
    """Return a text in quotes, whatever is in it."""
    return json.dumps(text, ensure_ascii=False)


def word(text: str) -> str:
    """Return a name: bare where it cannot be taken for something else."""
    return text if _BARE.fullmatch(text) and text not in _MEANT_OTHERWISE else quoted(text)


def mark(barcode: Barcode) -> str:
    """Return a barcode as it stands in the file: numbers bare, as people write them."""
    return barcode if barcode.isdecimal() and (barcode == "0" or not barcode.startswith("0")) else quoted(barcode)


def address(host: str, port: int) -> str:
    """Return HOST:PORT; the host alone where the port is 0."""
    shown = f"[{host}]" if ":" in host else host
    return f"{shown}:{port}" if port else shown


def flow(values: dict[str, Value | None]) -> str:
    """Return a mapping on one line, without what is None."""
    return "{" + ", ".join(f"{name}: {value}" for name, value in values.items() if value is not None) + "}"


def entries(name: str, lines: Iterable[str]) -> list[str]:
    """Return a section with a line each for its entries, nothing where there is none."""
    found = [f"  {line}" for line in lines]
    return [f"{name}:", *found] if found else []
