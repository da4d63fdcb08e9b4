"""Places that are closed, each for one or more reasons: open again only when every reason is lifted (DOMAIN section 7)."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import islice, pairwise
from typing import Protocol, TypeAlias

from app.domain.errors import NoRoute
from app.domain.units import Barcode

Place: TypeAlias = Barcode | tuple[Barcode, Barcode]
"""A barcode, or the piece of track from one to the next."""


@dataclass(frozen=True, slots=True)
class Reason:
    """Why a place is closed: ``by`` whom or what (the same reason wherever it is the same), and in ``words`` for people."""

    by: str
    words: str = field(compare=False)


class Switch(Protocol):
    """What makes places closed, or open, all at once: ``Router.close`` and ``Router.open``."""

    def __call__(self, *places: Place) -> None: ...


def named(place: Place) -> str:
    """Return a place as people read it."""
    return f"{place[0]} to {place[1]}" if isinstance(place, tuple) else place


class Closed:
    """A book of closed places by their reasons. What it closes and opens, only it may: ``close`` is called when a place gets
    its first reason, ``open_`` when it loses its last.

    ``version`` rises whenever a place has closed or opened, ``edition`` also when only the words for it are others.
    """

    def __init__(self, close: Switch, open_: Switch) -> None:
        self._close, self._open = close, open_
        self._reasons: dict[Place, dict[str, Reason]] = {}
        self._places: dict[str, dict[Place, None]] = {}
        self.version = self.edition = 0
        self._edges = 0

    def __contains__(self, place: Place) -> bool:
        return place in self._reasons

    def __iter__(self) -> Iterator[Place]:
        """Give the closed places, in the order of closing."""
        return iter(self._reasons)

    def __len__(self) -> int:
        return len(self._reasons)

    def shut(self, reason: Reason, *places: Place) -> None:
        """Close these for this reason, besides others; where they are closed for it already, its words are the new ones."""
        fresh = [place for place in dict.fromkeys(places) if place not in self._reasons]
        for place in places:
            if (before := self._reasons.get(place, {}).get(reason.by)) is None or before.words != reason.words:
                self.edition += 1
            self._reasons.setdefault(place, {})[reason.by] = reason
            self._places.setdefault(reason.by, {})[place] = None
        if fresh:
            self.version += 1
            self._edges += sum(isinstance(place, tuple) for place in fresh)
            self._close(*fresh)

    def lift(self, reason: Reason, *places: Place) -> None:
        """Close these no more for this reason; those that have no other open. What is not closed for it is left as it is."""
        free = []
        for place in dict.fromkeys(places):
            reasons = self._reasons.get(place, {})
            if reasons.pop(reason.by, None) is None:
                continue
            self.edition += 1
            del self._places[reason.by][place]
            if not reasons:
                del self._reasons[place]
                free.append(place)
        if not self._places.get(reason.by, True):
            del self._places[reason.by]
        if free:
            self.version += 1
            self._edges -= sum(isinstance(place, tuple) for place in free)
            self._open(*free)

    def shut_only(self, reason: Reason, *places: Place) -> None:
        """Let these, and no others, be closed for this reason: none lifts it everywhere."""
        self.shut(reason, *places)
        self.lift(reason, *(place for place in self.by(reason) if place not in places))

    def by(self, reason: Reason) -> tuple[Place, ...]:
        """Return what is closed for a reason."""
        return tuple(self._places.get(reason.by, ()))

    def by_words(self) -> dict[str, tuple[Place, ...]]:
        """Return for each reason in words what is closed for it, the oldest reason first."""
        found = {}
        for by, places in self._places.items():
            first = next(iter(places))
            found[self._reasons[first][by].words] = tuple(places)
        return found

    def reasons(self, place: Place) -> tuple[Reason, ...]:
        """Return why a place is closed, the oldest reason first; nothing if it is open."""
        return tuple(self._reasons.get(place, {}).values())

    def why(self, place: Place) -> str:
        """Return why a place is closed, in words; empty if it is open."""
        return "; ".join(reason.words for reason in self.reasons(place))

    def on(self, way: Sequence[Barcode]) -> Place | None:
        """Return the first closed place on a way that begins at its first barcode; that one itself may be closed."""
        known = self._reasons.keys()
        if known.isdisjoint(islice(way, 1, None)) and (not self._edges or known.isdisjoint(pairwise(way))):
            return None
        passed = ((pair[1], pair) for pair in pairwise(way))
        return next((place for both in passed for place in both if place in self._reasons), None)

    def told(self, place: Place) -> str:
        """Return that a place is closed, and why, as a clause."""
        return f"{named(place)} is closed ({self.why(place)})"

    def explain(self, why: NoRoute) -> str:
        """Return why there is no way in one sentence, with the reasons of the closure where it is one."""
        words = self.why(why.closed) if why.closed is not None else ""
        return f"{why.message} ({words})" if words else why.message
