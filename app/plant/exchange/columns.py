"""Which column of a table means what: names in English and Korean, units, directions."""

import re
from collections.abc import Sequence
from dataclasses import dataclass

from app.plant.exchange import synonyms

ROLES = {synonym: role for role, names in synonyms.COLUMNS.items() for synonym in names.split()}
WEAK = {"id": "barcode", "no": "barcode", "number": "barcode", "name": "barcode", "번호": "barcode", "이름": "barcode"}
"""Words that mean the barcode where no other column does."""

MM = {"mm": 1.0, "밀리": 1.0, "cm": 10.0, "m": 1000.0, "미터": 1000.0, "km": 1e6, "in": 25.4, "inch": 25.4, "ft": 304.8}
SPEEDS = {
    "%": 0.0,
    "percent": 0.0,
    "mm/s": 1.0,
    "mm/sec": 1.0,
    "m/s": 1000.0,
    "m/sec": 1000.0,
    "m/min": 1000 / 60,
    "mpm": 1000 / 60,
}
"""In mm/s; 0: percent of the vehicle's own."""
_UNIT = re.compile(r"[(\[{（]\s*([^)\]}）]{1,12}?)\s*[)\]}）]")
_TAIL = re.compile(r"(?:[_\s]+)(mm|cm|m|km|mm/s|m/s|m/min|%|percent)$")

KIND_OF = {word: kind for kind, words in synonyms.KINDS.items() for word in words.split()}
CHARGER_WORDS = frozenset(synonyms.CHARGER.split())
PARK_WORDS = frozenset(synonyms.PARK.split())
TRUE = frozenset(synonyms.TRUE.split())
FALSE = frozenset((*synonyms.FALSE.split(), ""))
BOTH = frozenset(synonyms.BOTH.split())
ONE_WAY = frozenset((*synonyms.ONE_WAY.split(), ""))
BACKWARD = frozenset(synonyms.BACKWARD.split())


@dataclass(frozen=True, slots=True)
class Column:
    """A column that is understood: its role, its place in a row (from 0), its own name, and its unit if one is named."""

    role: str
    index: int
    name: str
    unit: str = ""


def fold(text: str) -> str:
    """Return a column's name or a word as it is compared: case, spaces and marks do not count."""
    return re.sub(r"[\s_\-./#:·]+", "", text.casefold())


def unit_in(name: str) -> tuple[str, str]:
    """Return a column's name without its unit, and the unit as it is written, in lower case."""
    match = _UNIT.search(name)
    if match is not None:
        unit = match[1].casefold().replace(" ", "")
        return (name[: match.start()] + name[match.end() :]).strip(), unit if unit in MM or unit in SPEEDS else ""
    match = _TAIL.search(name.casefold())
    return (name[: match.start()], match[1]) if match else (name, "")


def columns_of(header: Sequence[object]) -> list[Column]:
    """Return the columns that are understood, in their order; several may mean the next barcode, else the first counts."""
    found: list[Column] = []
    for index, cell in enumerate(header):
        bare, unit = unit_in(str(cell))
        folded = fold(bare)
        role = ROLES.get(folded) or ROLES.get(folded.rstrip("0123456789"))
        if role is not None and (role == "next" or all(column.role != role for column in found)):
            found.append(Column(role, index, str(cell).strip(), unit))
    return _with_contexts(found, header)


def _with_contexts(found: list[Column], header: Sequence[object]) -> list[Column]:
    """Settle what only the other columns tell: a vehicle's start, a lone ``to``, a bare ``id``."""
    roles = {column.role for column in found}
    if "barcode" not in roles and "from" not in roles:
        weak = [
            Column("barcode", index, str(cell).strip())
            for index, cell in enumerate(header)
            if fold(str(cell)) in WEAK and all(column.index != index for column in found)
        ]
        found = [*weak[:1], *found]
    if "vehicle" in roles and "from" in roles and "to" not in roles:
        return [Column("start", c.index, c.name) if c.role == "from" else c for c in found]
    if "to" in roles and "from" not in roles:
        return [Column("next", c.index, c.name, c.unit) if c.role == "to" else c for c in found]
    if "from" in roles and "to" not in roles and "next" in roles and "barcode" not in roles:
        return [Column("barcode", c.index, c.name) if c.role == "from" else c for c in found]
    return found
