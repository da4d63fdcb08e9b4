"""What transfers came to: the moments of each that ended, from E82's events (DOMAIN sections 1 and 2)."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum

from app.domain.job import JobEvent


class Phase(StrEnum):
    """Parts of a transfer's life, in order; ``total`` is all of it."""

    QUEUED = "queued"
    """From its acceptance until a vehicle is assigned, the last one if several were."""
    FETCHING = "fetching"
    """The vehicle comes empty to the source."""
    ACQUIRING = "acquiring"
    CARRYING = "carrying"
    DEPOSITING = "depositing"
    TOTAL = "total"


MARKS = {
    "assigned": JobEvent.VEHICLE_ASSIGNED,
    "acquire_started": JobEvent.VEHICLE_ACQUIRE_STARTED,
    "acquired": JobEvent.VEHICLE_ACQUIRE_COMPLETED,
    "deposit_started": JobEvent.VEHICLE_DEPOSIT_STARTED,
    "deposited": JobEvent.VEHICLE_DEPOSIT_COMPLETED,
}
"""The last event of each kind is a moment of the transfer."""


def spent(created: float, marks: Mapping[str, float | None], ended: float | None) -> dict[Phase, float | None]:
    """Return how long each phase took, seconds, by the moments of :data:`MARKS` that there were; None: it is not over."""
    assigned, acquire_started, acquired, deposit_started, deposited = (marks.get(name) for name in MARKS)
    both = {
        Phase.QUEUED: (created, assigned),
        Phase.FETCHING: (assigned, acquire_started),
        Phase.ACQUIRING: (acquire_started, acquired),
        Phase.CARRYING: (acquired, deposit_started),
        Phase.DEPOSITING: (deposit_started, deposited),
        Phase.TOTAL: (created, ended),
    }
    return {
        phase: None if begin is None or end is None or end < begin else end - begin
        for phase, (begin, end) in both.items()
    }


@dataclass(frozen=True, slots=True)
class Transfer:
    """A transfer that ended: UTC seconds of what happened to it, None for what did not, or is not kept any more."""

    job: str
    state: str
    carrier: str | None
    source: str
    destination: str
    priority: int
    vehicle: str | None
    created: float
    assigned: float | None
    acquire_started: float | None
    acquired: float | None
    deposit_started: float | None
    deposited: float | None
    ended: float

    def seconds(self, phase: Phase) -> float | None:
        """Return how long a phase took; None if it did not come to its end."""
        return spent(self.created, {name: getattr(self, name) for name in MARKS}, self.ended)[phase]


@dataclass(frozen=True, slots=True)
class Queued:
    """When a job was accepted, and when it got its first vehicle or ended without one (None: it waits)."""

    created: float
    until: float | None


@dataclass(frozen=True, slots=True)
class Waited:
    """A wait of a job: since, until (None: it still waits), why, and which job."""

    since: float
    until: float | None
    reason: str
    job: str


@dataclass(frozen=True, slots=True)
class OpenJob:
    """A job that had not ended at a moment, and what it waited for just then, empty: for nothing. Times are UTC seconds."""

    job: str
    carrier: str | None
    source: str
    destination: str
    priority: int
    created: float
    reason: str


@dataclass(frozen=True, slots=True)
class Kept:
    """All that is kept of a period. ``waits`` are those of the newest ``waits_of`` jobs that were accepted in it.

    ``waits_late`` are those of the latest transfers, whenever they were accepted; ``open`` what was open when it ended.
    """

    transfers: Sequence[Transfer]
    queued: Sequence[Queued]
    waits: Sequence[Waited]
    waits_of: int
    failures: Mapping[str, Sequence[tuple[float, float | None]]]
    waits_late: Sequence[Waited] = ()
    open: Sequence[OpenJob] = ()
