"""What the line knows of each of its drives."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass

from app.domain.drive import (
    DriveEvent,
    DriveId,
    DriveMode,
    DriveOnline,
    DriveReported,
    DriveSpec,
    DriveStatus,
    Parameter,
    ParameterRead,
    RawValue,
)
from app.domain.units import Seconds
from app.protocols.hi.messages import LAST_DRIVE, Ack, Cmd, Setting, Ssa
from app.protocols.hi.session.line import Answer
from app.protocols.hi.session.scripts import status_of
from app.protocols.hi.session.steps import Ask


@dataclass(frozen=True, slots=True)
class DriveView:
    """A drive as it is known: ``online`` is None before it was heard or missed; ``status_at`` is when it was heard."""

    online: bool | None
    status: DriveStatus | None
    status_at: Seconds | None


@dataclass(slots=True)
class Drive:
    """A drive, and when it is to be polled."""

    spec: DriveSpec
    online: bool | None = None
    status: DriveStatus | None = None
    status_at: Seconds | None = None
    poll_at: Seconds = Seconds(0.0)
    polling: bool = False

    @property
    def view(self) -> DriveView:
        """What is known, frozen."""
        return DriveView(self.online, self.status, self.status_at)

    @property
    def in_error(self) -> bool:
        """Whether it said last that it is in error."""
        return self.status is not None and self.status.mode is DriveMode.ERROR


class Drives:
    """The drives of a line by name and by address. Raises: ValueError: two have one name or address, or it has none."""

    def __init__(self, specs: Iterable[DriveSpec], poll: Seconds) -> None:
        self._poll = poll
        self._named: dict[DriveId, Drive] = {}
        self._addressed: dict[int, Drive] = {}
        for spec in specs:
            if not 1 <= spec.address <= LAST_DRIVE:
                raise ValueError(f"drive {spec.id}: address {spec.address} is not from 1 to {LAST_DRIVE}")
            if spec.id in self._named or spec.address in self._addressed:
                raise ValueError(f"drive {spec.id}: its name or its address {spec.address} is on the line already")
            self._named[spec.id] = self._addressed[spec.address] = Drive(spec)

    def __iter__(self) -> Iterator[Drive]:
        return iter(self._named.values())

    def named(self, drive: DriveId) -> Drive | None:
        """Return the drive of this name."""
        return self._named.get(drive)

    def at(self, address: int) -> Drive | None:
        """Return the drive at this address."""
        return self._addressed.get(address)

    def forget(self, now: Seconds) -> None:
        """Know nothing any more: the line is new. All are to be asked now."""
        for drive in self:
            drive.online = drive.status = drive.status_at = None
            drive.poll_at, drive.polling = now, False

    def due(self) -> Drive | None:
        """Return the drive that is to be polled next."""
        waiting = [drive for drive in self if not drive.polling]
        return min(waiting, key=lambda drive: drive.poll_at, default=None)

    def ask_all(self, now: Seconds) -> None:
        """Ask all that answer for their status now: they have been told something together."""
        for drive in self:
            if drive.online is not False:
                drive.poll_at = now

    def heard(self, ask: Ask, answer: Answer, now: Seconds) -> list[DriveEvent]:
        """Learn from an answer, and return what is new in it."""
        drive = self._addressed.get(ask.address)
        if drive is None:
            return []
        news: list[DriveEvent] = []
        if drive.online is not True:
            drive.online = True
            news.append(DriveOnline(drive.spec.id))
        if isinstance(answer, Ssa):
            status = status_of(answer)
            if status != drive.status:
                news.append(DriveReported(drive.spec.id, status))
            drive.status, drive.status_at = status, now
        if isinstance(answer, Setting):
            news.append(ParameterRead(drive.spec.id, Parameter(answer.number), RawValue(answer.value)))
        if isinstance(answer, Ack) and (drive.status is None or drive.status.mode != answer.mode):
            drive.poll_at = now
        if ask.cmd is Cmd.SSQ:
            drive.poll_at = Seconds(now + self._poll)
        return news
