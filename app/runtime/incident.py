"""An incident as one file: the plant, its state, what changed, and the events; lines of JSON under gzip."""

import gzip
import zlib
from collections.abc import Sequence
from dataclasses import dataclass
from datetime import datetime
from typing import Any

import msgspec

from app.domain.errors import HoistwayError
from app.domain.layout import Plant
from app.domain.records import HistoryEvent
from app.domain.units import Timestamp
from app.runtime.playback import State
from app.runtime.recording import Change
from app.runtime.showing import encode, iso

FORMAT = 1
GZIP = b"\x1f\x8b"
COPY_AGAIN = "Copy it again, whole, or export it anew."
LARGEST = 1 << 30
"""Bytes that a file may unpack to. Our choice: an export ends at 500,000 changes, some 100 MB."""


class NoIncident(HoistwayError):
    """A file is none that this program can replay."""

    code = "incident"


@dataclass(frozen=True, slots=True)
class Incident:
    """What was recorded from ``begin`` to ``end``: ``state`` at the begin, then ``changes``; ``events`` as people see them."""

    plant: Plant
    begin: float
    end: float
    made: Timestamp
    actor: str
    state: State
    changes: Sequence[Change]
    events: Sequence[dict[str, Any]]

    def history(self) -> list[HistoryEvent]:
        """Return the events as records."""
        return [
            HistoryEvent(
                seq=e["seq"],
                at=Timestamp(datetime.fromisoformat(e["ts"]).timestamp()),
                event=e["event"],
                ceid=e["ceid"],
                job=e["job"],
                carrier=e["carrier"],
                vehicle=e["vehicle"],
                source=e["source"],
                destination=e["destination"],
                result=e["result"],
                detail=e["detail"],
            )
            for e in self.events
        ]


def written(incident: Incident) -> bytes:
    """Return an incident as a file."""
    head = {
        "hoistway": FORMAT,
        "from": incident.begin,
        "to": incident.end,
        "made": iso(incident.made),
        "by": incident.actor,
        "plant": incident.plant,
    }
    lines = [encode(head), encode({"state": incident.state})]
    lines += [encode({"change": change}) for change in incident.changes]
    lines += [encode({"event": event}) for event in incident.events]
    return gzip.compress(b"\n".join(lines) + b"\n", 6)


def _unpacked(body: bytes) -> bytes:
    """Return what a file has. Raises NoIncident: it is none, or far too large."""
    if not body:
        raise _none("it is empty")
    if not body.startswith(GZIP):
        raise _none("it is not packed by gzip")
    unpacking = zlib.decompressobj(wbits=31)
    try:
        found = unpacking.decompress(body, LARGEST)
    except zlib.error:
        raise _none("it is damaged: its bytes do not fit their checksum", COPY_AGAIN) from None
    if unpacking.unconsumed_tail:
        raise _none(f"it unpacks to more than {LARGEST >> 20} MB")
    if not unpacking.eof:
        raise _none("it ends too soon", COPY_AGAIN)
    return found


def _none(why: str, remedy: str = "Get one with GET /api/v1/history/export.") -> NoIncident:
    return NoIncident(f"this is no recorded incident: {why}", remedy=remedy)


_WRONG = (
    OSError, EOFError, ValueError, KeyError, TypeError, AttributeError, OverflowError, msgspec.MsgspecError,
)  # fmt: skip
"""What comes of lines that something else has written."""


def read(body: bytes) -> Incident:
    """Undo :func:`written`. Raises NoIncident: it is no such file, or a newer one."""
    try:
        head, *lines = _unpacked(body).splitlines() or [b""]
        number = 1
        try:
            plant, first, made = _head(head)
            parts = _Parts()
            for number, line in enumerate(lines, 2):  # noqa: B007 (named in what is raised)
                parts.add(msgspec.json.decode(line))
        except _WRONG as wrong:
            raise _none(f"its line {number} cannot be understood") from wrong
    except MemoryError:
        raise NoIncident("it unpacks to more than the memory has") from None
    if not parts.state:
        raise _none("it has no state of the plant")
    begin, end = first["from"], first["to"]
    return Incident(plant, begin, end, made, first["by"], parts.state, parts.changes, parts.events)


class _Parts:
    """The lines below the first, by what they are."""

    def __init__(self) -> None:
        self.state: State = {}
        self.changes: list[Change] = []
        self.events: list[dict[str, Any]] = []

    def add(self, part: Any) -> None:
        """Take a line. Raises what ``_WRONG`` names: it is none of ours."""
        if "change" in part:
            self.changes.append(tuple(part["change"]))
        elif "event" in part:
            self.events.append(part["event"])
        else:
            self.state = part["state"]


def _head(line: bytes) -> tuple[Plant, dict[str, Any], Timestamp]:
    """Return what the first line says: the plant, all of it, and when it was made."""
    first = msgspec.json.decode(line)
    if not isinstance(first, dict) or "hoistway" not in first:
        raise _none("its first line does not say what it is")
    if first["hoistway"] != FORMAT:
        raise NoIncident("a newer Hoistway has written this file", remedy="Open it with that one.")
    for name in ("from", "to"):
        iso(first[name])
    made = Timestamp(datetime.fromisoformat(first["made"]).timestamp())
    return msgspec.convert(first["plant"], Plant, strict=False), first, made
