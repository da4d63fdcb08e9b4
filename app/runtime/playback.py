"""Reads what was recorded: the state at a moment, and the changes of a period (for scrubbing)."""

import zlib
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import msgspec

from app.domain.units import Timestamp
from app.domain.view import Topic
from app.runtime.heat import Heat, together
from app.runtime.recording import Change
from app.store.playback import Piece, PlaybackReader, Span

State = dict[str, dict[str, Any]]
MOST_PIECES = 100
ENOUGH = 4_000_000
"""So many pieces, and hardly more bytes than that, are given at a time. Our choice."""
IN_A_PIECE = 1 << 20
"""A place among the changes is the piece's number times this, and its place in the piece."""


@dataclass(frozen=True, slots=True)
class Moment:
    """The state at a moment: topic, then key, to object."""

    at: float
    objects: State


def unpacked(body: bytes) -> Any:
    """Undo :func:`app.runtime.recording.packed`."""
    return msgspec.json.decode(zlib.decompress(body))


def apply(state: State, change: Change) -> None:
    """Bring a change into a state. Of vehicles a change has only the fields that are other than before."""
    _, topic, key, value = change
    objects = state.setdefault(topic, {})
    if value is None:
        objects.pop(key, None)
    elif topic == Topic.VEHICLES:
        objects[key] = {**objects.get(key, {}), **value}
    else:
        objects[key] = value


@dataclass(frozen=True, slots=True)
class Source:
    """Who made an incident's file, and when."""

    by: str
    made: Timestamp


class Playback:
    """What was recorded of a plant; blocking, from any thread. Every method raises StoreError.

    ``source``: it is an incident from elsewhere; None: the plant under control itself.
    """

    def __init__(self, url: str, source: Source | None = None) -> None:
        self._reader = PlaybackReader(url)
        self.source = source

    def close(self) -> None:
        """Close all connections."""
        self._reader.close()

    def span(self) -> Span:
        """Return what there is."""
        return self._reader.span()

    def state(self, at: float) -> Moment | None:
        """Return the state at a moment; None: nothing was recorded by then."""
        whole = self._reader.state_before(at)
        if whole is None:
            return None
        state: State = unpacked(whole.body)
        for piece in self._reader.changes(whole.begin, at, whole.id, limit=1000):
            for change in unpacked(piece.body):
                if change[0] <= at:
                    apply(state, change)
        return Moment(at, state)

    def pieces(self, begin: float, end: float, after: int | None = None) -> tuple[list[Piece], bool]:
        """Return pieces as they are kept, in order, and whether there are more up to ``end``.

        They begin with the newest whole state that is not after ``begin`` (else the first after it), or with what comes
        after a piece's number. Whole states among them are what the changes before them led to, unless some were lost.
        """
        if after is None:
            whole = self._reader.state_before(begin) or self._reader.first_state(begin, end)
            if whole is None:
                return [], False
            after = whole.id - 1
        found = self._reader.since(after, end, MOST_PIECES + 1)
        taken, size = found[:MOST_PIECES], 0
        for count, piece in enumerate(taken, 1):
            size += len(piece.body)
            if size > ENOUGH:
                taken = taken[:count]
                break
        return taken, len(taken) < len(found)

    def heat(self, begin: float, end: float) -> Heat | None:
        """Return what was counted in a period, by the five minutes; None: nothing was."""
        return together(Heat(**unpacked(body)) for body in self._reader.heats(begin, end))

    def changes(self, begin: float, end: float, after: int = 0, limit: int = 5000) -> Iterator[tuple[int, Change]]:
        """Give the changes after a moment up to another, in order, with their places; ``after`` is the last place seen."""
        first, given = after // IN_A_PIECE, 0
        while pieces := self._reader.changes(begin, end, first, limit=50):
            for piece in pieces:
                for index, change in enumerate(unpacked(piece.body)):
                    place = piece.id * IN_A_PIECE + index
                    if place <= after or not begin < change[0] <= end:
                        continue
                    yield place, tuple(change)
                    given += 1
                    if given == limit:
                        return
            first = pieces[-1].id + 1
