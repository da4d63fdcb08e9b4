"""Alarms as history: what was wrong with which machine, from when to when, and who has seen it (DOMAIN sections 1 and 8)."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from enum import StrEnum

from app.domain.ids import Actor, JobId
from app.domain.units import Timestamp


class AlarmKind(StrEnum):
    """What an alarm is about. ``link``: nothing is heard of a vehicle; ``hold``: we do not believe what it says, or gave up;
    ``job``: one waits for what no driving puts right.
    """

    VEHICLE = "vehicle"
    HOLD = "hold"
    LINK = "link"
    DEVICE = "device"
    DRIVE = "drive"
    TRAFFIC = "traffic"
    JOB = "job"
    PLANT = "plant"


OF_VEHICLES = (AlarmKind.VEHICLE, AlarmKind.HOLD, AlarmKind.LINK)
"""Kinds whose source is a vehicle."""
FAILURES = (AlarmKind.VEHICLE, AlarmKind.HOLD)
"""Kinds that count as a failure of the vehicle: a cut line says nothing about it (our choice)."""


@dataclass(frozen=True, slots=True)
class Alarm:
    """Something that is wrong with ``source`` (a vehicle, device or drive; the plant's name for kind plant).

    ``code`` is what to count by (an alarm's number, a device's state); ``cause`` and ``remedy`` are for people. ``outcome`` says
    how it ended. ``acknowledged`` is when ``acknowledged_by`` said that they know of it, with a ``note``.
    """

    number: int
    kind: AlarmKind
    source: str
    code: str
    cause: str
    remedy: str
    begun: Timestamp
    job: JobId | None = None
    ended: Timestamp | None = None
    outcome: str = ""
    acknowledged: Timestamp | None = None
    acknowledged_by: Actor | None = None
    note: str = ""


@dataclass(frozen=True, slots=True)
class AcknowledgeAlarm:
    """A person knows of an alarm. ``known`` is the alarm as the store has it, for one that has ended."""

    actor: Actor
    alarm: int
    note: str = ""
    known: Alarm | None = None


@dataclass(frozen=True, slots=True)
class AlarmCount:
    """How often something was wrong, and for so many seconds altogether. ``about``: what is counted together, by name."""

    about: Mapping[str, str]
    times: int
    seconds: float
    newest: float


@dataclass(frozen=True, slots=True)
class Reliability:
    """How a vehicle held out: so many ``failures``, together so many seconds ``down`` of a ``period``.

    Failures that overlap, such as an alarm and the hold that came of it, are one.
    """

    failures: int
    down: float
    period: float

    @property
    def between(self) -> float | None:
        """Mean seconds of service between failures (MTBF); None without one."""
        return (self.period - self.down) / self.failures if self.failures else None

    @property
    def to_repair(self) -> float | None:
        """Mean seconds from a failure to its end (MTTR); None without one."""
        return self.down / self.failures if self.failures else None


def reliability(spans: Iterable[tuple[float, float | None]], begin: float, end: float) -> Reliability:
    """Return how a vehicle held out between two moments, by the begin and end of its failures, in order of begin."""
    failures, down, until = 0, 0.0, begin
    for begun, ended in spans:
        first, last = max(begun, until), min(end if ended is None else ended, end)
        if begun > until or not failures:
            failures += 1
        down += max(0.0, last - first)
        until = max(until, last)
    return Reliability(failures, down, end - begin)
