"""Audit walks: people go along places and enter what stands there; a named person accepts it (DOMAIN section 2)."""

from dataclasses import dataclass
from enum import StrEnum

from app.domain.ids import Actor, CarrierId, StationId
from app.domain.units import Timestamp


class WalkState(StrEnum):
    """How far a walk is."""

    OPEN = "open"
    ACCEPTED = "accepted"
    ABANDONED = "abandoned"


class Finding(StrEnum):
    """What an entry says against the books. ``moved``: the books have changed since it was seen: look again."""

    NOT_SEEN = "not_seen"
    AGREES = "agrees"
    DIFFERS = "differs"
    MOVED = "moved"


@dataclass(frozen=True, slots=True)
class Walk:
    """A walk as a whole."""

    number: int
    actor: Actor
    reason: str
    started: Timestamp
    state: WalkState = WalkState.OPEN
    ended: Timestamp | None = None
    ended_by: Actor | None = None


@dataclass(frozen=True, slots=True)
class WalkPlace:
    """A place of a walk: what was believed when the walk began, and what was ``seen`` there (None: not yet), by whom, when.

    ``seen_carrier`` None though something is there: its id could not be read. ``accepted``: the finding with which the entry
    was taken for true; it stays, though the books have been changed by just that.
    """

    walk: int
    station: StationId
    believed: bool | None
    believed_carrier: CarrierId | None
    seen: bool | None = None
    seen_carrier: CarrierId | None = None
    by: Actor | None = None
    at: Timestamp | None = None
    accepted: Finding | None = None

    def finding(self, present: bool | None, carrier: CarrierId | str | None, since: float) -> Finding:
        """Return what the entry says against the books as they are now, which have been so since then, or as it was accepted."""
        if self.accepted is not None:
            return self.accepted
        if self.seen is None or self.at is None:
            return Finding.NOT_SEEN
        if since > self.at:
            return Finding.MOVED
        same = self.seen is present and (self.seen_carrier is None or self.seen_carrier == carrier)
        return Finding.AGREES if same else Finding.DIFFERS


@dataclass(frozen=True, slots=True)
class StartWalk:
    """Begin a walk along these stations; none: every side buffer of the plant."""

    actor: Actor
    reason: str
    stations: tuple[StationId, ...] = ()


@dataclass(frozen=True, slots=True)
class Sight:
    """What somebody saw at a station."""

    station: StationId
    present: bool
    carrier: CarrierId | None = None


@dataclass(frozen=True, slots=True)
class EnterSights:
    """Write down what was seen: all or nothing; a later entry for a station replaces the one before."""

    actor: Actor
    walk: int
    sights: tuple[Sight, ...]


@dataclass(frozen=True, slots=True)
class AcceptWalk:
    """A named person takes what was seen for true. ``partial``: also if some places were not seen, or have changed since."""

    actor: Actor
    walk: int
    partial: bool = False


@dataclass(frozen=True, slots=True)
class AbandonWalk:
    """End a walk; nothing is believed for it."""

    actor: Actor
    walk: int
    reason: str


WalkRequest = StartWalk | EnterSights | AcceptWalk | AbandonWalk
