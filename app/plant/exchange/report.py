"""What an import did to what it was given: each repair with where and why, and what a person must still do."""

from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Any

from app.domain.errors import PlantError

SHOWN = 3
"""Places that are named where the same was done at many. Our choice; the JSON report names up to KEPT."""
KEPT = 1000
_LONGEST = 160


class Kind(StrEnum):
    """What a note says.

    ``repaired``: the form was wrong, the meaning clear. ``assumed``: the file does not say; another reading can be asked for.
    ``left out``: a plant file cannot carry it. ``to supply``: the plant runs without it only in simulation. ``wrong``: the file
    contradicts itself or names what it does not have; what was written lacks that.
    """

    WRONG = "wrong"
    REPAIRED = "repaired"
    ASSUMED = "assumed"
    LEFT_OUT = "left out"
    NEEDED = "to supply"


@dataclass(slots=True)
class Note:
    """One thing done or found, at all the places where it was; ``times`` counts them, ``where`` names the first of them."""

    kind: Kind
    what: str
    remedy: str = ""
    times: int = 0
    where: list[str] = field(default_factory=list)

    @property
    def named(self) -> tuple[list[str], int]:
        """The first places where it is, and how many more there are; none where no place is known."""
        named = [place for place in self.where[:SHOWN] if place]
        return named, self.times - len(named) if named else 0

    def __str__(self) -> str:
        named, rest = self.named
        places = ", ".join(named) + (f" and {rest} more" if rest else "")
        return f"{places}: {self.what}" if named else self.what


class UnreadableLayout(PlantError):
    """Nothing can be made of a file; the message says why, in one line, with the place where known."""

    code = "layout-file"


class Report:
    """The notes of one import, in the order in which they came up, equal ones together."""

    def __init__(self) -> None:
        self.source = ""
        """What was read: the format with its version, and the layout's own name."""
        self.read: dict[str, int] = {}
        """What there was, counted in the source's own words."""
        self._notes: dict[tuple[Kind, str], Note] = {}

    @property
    def notes(self) -> list[Note]:
        """All notes, the gravest kind first."""
        order = list(Kind)
        return sorted(self._notes.values(), key=lambda note: order.index(note.kind))

    @property
    def is_sound(self) -> bool:
        """Whether nothing was wrong with the source."""
        return not any(note.kind is Kind.WRONG for note in self._notes.values())

    def wrong(self, where: str, what: str, remedy: str = "", *, was: object = None) -> None:
        """Note a contradiction, or a reference to what is not there. ``was`` is what stands there: equal mistakes with other
        words are one note.
        """
        self._note(Kind.WRONG, where if was is None else f"{where} ({shown(repr(was))})", what, remedy)

    def repaired(self, where: str, what: str) -> None:
        """Note that something badly written was read as it was certainly meant."""
        self._note(Kind.REPAIRED, where, what, "")

    def assumed(self, where: str, what: str, remedy: str = "") -> None:
        """Note a choice that the source left open."""
        self._note(Kind.ASSUMED, where, what, remedy)

    def left_out(self, where: str, what: str, remedy: str = "") -> None:
        """Note what a plant file cannot carry."""
        self._note(Kind.LEFT_OUT, where, what, remedy)

    def needed(self, where: str, what: str, remedy: str = "") -> None:
        """Note what only a person can give."""
        self._note(Kind.NEEDED, where, what, remedy)

    def _note(self, kind: Kind, where: str, what: str, remedy: str) -> None:
        note = self._notes.setdefault((kind, what), Note(kind, what, remedy))
        note.times += 1
        if len(note.where) < KEPT and where:
            note.where.append(shown(where))

    def plain(self) -> dict[str, Any]:
        """Return the report as JSON has it."""
        notes = [
            {"kind": n.kind.value, "what": n.what, "remedy": n.remedy, "times": n.times, "where": n.where}
            for n in self.notes
        ]
        return {"source": self.source, "read": self.read, "notes": notes}


def counted(number: int, what: str) -> str:
    """Return a number of things, ``what`` in the plural: ``1 point``, ``2 points``."""
    single = what.replace("pieces", "piece") if what.startswith("pieces") else what.removesuffix("s")
    return f"{number} {single if number == 1 else what}"


def shown(text: object) -> str:
    """Return what a file holds so that it neither fills nor steers a screen."""
    whole = "".join(letter if letter.isprintable() else "?" for letter in str(text))
    return whole if len(whole) <= _LONGEST else f"{whole[:_LONGEST]}…"


def listed(names: Iterable[str], most: int = 8) -> str:
    """Return names in a row, the first of them where they are many."""
    known = list(names)
    more = f" and {len(known) - most} more" if len(known) > most else ""
    return ", ".join(shown(name) for name in known[:most]) + more
