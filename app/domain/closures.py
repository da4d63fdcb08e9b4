"""Closures: a rail, a station or a zone that people keep vehicles out of for a while (DOMAIN sections 1 and 7)."""

from dataclasses import dataclass, replace
from enum import StrEnum

from app.domain.ids import Actor
from app.domain.units import Barcode, Timestamp


class PlaceKind(StrEnum):
    """What a closure is about. A station is closed without the rail below it."""

    BARCODE = "barcode"
    EDGE = "edge"
    STRETCH = "stretch"
    ZONE = "zone"
    STATION = "station"


@dataclass(frozen=True, slots=True)
class ClosedPlace:
    """A place as it was named: barcodes; the two of an edge; the first and the last of a stretch; a zone; a station."""

    kind: PlaceKind
    names: tuple[str, ...]

    def __str__(self) -> str:
        """Return it as people say it."""
        if self.kind in {PlaceKind.EDGE, PlaceKind.STRETCH}:
            return " to ".join(self.names)
        word = f"{self.kind.value} " if self.kind is PlaceKind.ZONE else ""
        return word + ", ".join(self.names)


class ClosurePurpose(StrEnum):
    """Why a place is closed: only a traffic closure may expire, and may be opened by anybody with a name."""

    TRAFFIC = "traffic"
    WORK = "work"


class ClosureState(StrEnum):
    """``draining``: nobody comes in, those inside drive out; ``closed``: nobody is inside."""

    DRAINING = "draining"
    CLOSED = "closed"
    OPENED = "opened"
    EXPIRED = "expired"

    @property
    def over(self) -> bool:
        """Whether it keeps nobody out any more."""
        return self in {ClosureState.OPENED, ClosureState.EXPIRED}


@dataclass(frozen=True, slots=True)
class Closure:
    """One reason for which a place is closed; a place that several concern opens with the last of them.

    ``barcodes`` are what nobody may come to, resolved when it was made: a stretch stays the same if routes change. ``expires`` is
    None for work. ``closed`` is when it was empty, ``releases`` are those who wish it opened without being its owner.
    """

    number: int
    place: ClosedPlace
    barcodes: tuple[Barcode, ...]
    reason: str
    owner: Actor
    purpose: ClosurePurpose
    since: Timestamp
    expires: Timestamp | None = None
    state: ClosureState = ClosureState.DRAINING
    closed: Timestamp | None = None
    releases: tuple[Actor, ...] = ()
    ended: Timestamp | None = None
    ended_by: Actor | None = None

    @property
    def edge(self) -> tuple[Barcode, Barcode] | None:
        """The edge that it closes, if it closes just that."""
        if self.place.kind is not PlaceKind.EDGE:
            return None
        return Barcode(self.place.names[0]), Barcode(self.place.names[1])

    @property
    def station(self) -> str | None:
        """The station that it closes, if it closes just that."""
        return self.place.names[0] if self.place.kind is PlaceKind.STATION else None

    @property
    def name(self) -> str:
        """What it is called where it is a reason among others."""
        return f"closure {self.number}"

    def __str__(self) -> str:
        """Return it as the end of a sentence about a place."""
        what = "closed for people at work" if self.purpose is ClosurePurpose.WORK else "closed"
        return f"{what} by {self.owner}: {self.reason} ({self.name})"

    def wished_away_by(self, actor: Actor) -> "Closure":
        """Return it with one more who wishes to open it."""
        return replace(self, releases=tuple(dict.fromkeys((*self.releases, actor))))

    def opened_by(self, actor: Actor) -> bool:
        """Whether it goes now: traffic by anybody; work by its owner alone, or two others together."""
        return self.purpose is ClosurePurpose.TRAFFIC or actor == self.owner or len(self.releases) >= 2


@dataclass(frozen=True, slots=True)
class ClosePlace:
    """Close a place. ``expires``: for traffic only; a closure for people's work never ends by itself."""

    actor: Actor
    place: ClosedPlace
    reason: str
    purpose: ClosurePurpose = ClosurePurpose.TRAFFIC
    expires: Timestamp | None = None


@dataclass(frozen=True, slots=True)
class OpenPlace:
    """End a closure; for people's work its owner, or two others together."""

    actor: Actor
    closure: int
    reason: str = ""


ClosureRequest = ClosePlace | OpenPlace
