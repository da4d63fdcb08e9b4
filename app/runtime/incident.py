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
    """Return what a file has. Raises ValueError: it is none, or far too large."""
    unpacking = zlib.decompressobj(wbits=31)
    found = unpacking.decompress(body, LARGEST)
    if unpacking.unconsumed_tail:
        raise ValueError(f"it unpacks to more than {LARGEST >> 20} MB")
    if not unpacking.eof:
        raise ValueError("it ends too soon")
    return found


def read(body: bytes) -> Incident:
    """Undo :func:`written`. Raises NoIncident: it is no such file, or a newer one."""
    try:
        head, *lines = _unpacked(body).splitlines() or [b""]
        first = msgspec.json.decode(head)
        if not isinstance(first, dict):
            raise TypeError("its first line does not say what it is")
        if first["hoistway"] != FORMAT:
            raise NoIncident("a newer Hoistway has written this file", remedy="Open it with that one.")
        plant = msgspec.convert(first["plant"], Plant, strict=False)
        state: State = {}
        changes: list[Change] = []
        events: list[dict[str, Any]] = []
        for line in lines:
            part = msgspec.json.decode(line)
            if "change" in part:
                changes.append(tuple(part["change"]))
            elif "event" in part:
                events.append(part["event"])
            else:
                state = part["state"]
        if not state:
            raise ValueError("it has no state of the plant")
        for name in ("from", "to"):
            iso(first[name])
        made = Timestamp(datetime.fromisoformat(first["made"]).timestamp())
        return Incident(plant, first["from"], first["to"], made, first["by"], state, changes, events)
    except MemoryError:
        raise NoIncident("it unpacks to more than the memory has") from None
    except (
        OSError, EOFError, ValueError, KeyError, TypeError, AttributeError, OverflowError, zlib.error, msgspec.MsgspecError,
    ) as wrong:  # fmt: skip
        remedy = "Get one with GET /api/v1/history/export."
        raise NoIncident(f"this is no recorded incident: {wrong}", remedy=remedy) from wrong
