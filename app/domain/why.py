"""Why a lot was late: what each assignment of its job was chosen by, and what the job waited for, kept with the job."""

from dataclasses import dataclass, replace

from app.domain.ids import JobId, VehicleId
from app.domain.units import Timestamp

MOST_CHOICES = 8
"""So many assignments are kept with a job: the first, and the latest (our choice)."""
MOST_WAITS = 16
"""So many waits are kept with a job: the first, and the latest (our choice)."""


@dataclass(frozen=True, slots=True)
class Candidate:
    """A vehicle that was thought of: its seconds to the source (None: no way leads there), and why it was not sent."""

    vehicle: VehicleId
    seconds: float | None
    why_not: str


@dataclass(frozen=True, slots=True)
class Choice:
    """One assignment: who was sent, and by what.

    ``seconds`` is its time to the source; ``waited`` what the job's waiting was worth, ``switch`` what the change had to save
    besides, both in seconds of driving; ``hot``: a hot lot, served before all others. ``candidates`` are the nearest others.
    ``before`` is the vehicle that had the job until then, ``saved`` the seconds by which this one is nearer than that; None: that
    one could not get there any more.
    """

    at: Timestamp
    vehicle: VehicleId
    seconds: float
    priority: int
    hot: bool
    waited: float
    switch: float
    candidates: tuple[Candidate, ...] = ()
    before: VehicleId | None = None
    saved: float | None = None


@dataclass(frozen=True, slots=True)
class Wait:
    """What a job waited for. ``until`` None: it still does."""

    since: Timestamp
    reason: str
    until: Timestamp | None = None


@dataclass(frozen=True, slots=True)
class Why:
    """What is kept of one job's why. ``order`` is the job's; ``left_out`` counts choices and waits between first and latest."""

    order: int
    job: JobId
    choices: tuple[Choice, ...] = ()
    waits: tuple[Wait, ...] = ()
    left_out: int = 0

    def chosen(self, choice: Choice) -> "Why":
        """Return it with one assignment more."""
        over = len(self.choices) >= MOST_CHOICES
        kept = (self.choices[0], *self.choices[2:]) if over else self.choices
        return replace(self, choices=(*kept, choice), left_out=self.left_out + over)

    def waiting(self, reason: str, now: Timestamp) -> "Why":
        """Return it with what the job waits for from now on, empty: for nothing. The same object if that is nothing new."""
        last = self.waits[-1] if self.waits else None
        going_on = last if last and last.until is None else None
        if reason == (going_on.reason if going_on else ""):
            return self
        waits = (*self.waits[:-1], replace(going_on, until=now)) if going_on else self.waits
        if not reason:
            return replace(self, waits=waits)
        over = len(waits) >= MOST_WAITS
        kept = (waits[0], *waits[2:]) if over else waits
        return replace(self, waits=(*kept, Wait(now, reason)), left_out=self.left_out + over)
