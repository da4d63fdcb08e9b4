"""A drive at this moment, and how people see it."""

from collections.abc import Callable
from dataclasses import dataclass, field
from math import inf

from app.domain.catalogue import Catalogue, ParameterSpec
from app.domain.drive import DriveId, DriveMode, DriveStatus, Hundredths, Parameter, Turn
from app.domain.drive_errors import explained
from app.domain.drive_records import DriveOperation, DriveRecord, DriveValue
from app.domain.layout import DriveUnit
from app.domain.units import Seconds, Timestamp
from app.domain.view import DriveView, LockoutView, OperationView, ParameterView

STILL_AFTER = Seconds(2.5)
"""A drive whose distance has not changed for so long stands still: twice the time between two polls, and some. Our choice."""


@dataclass(slots=True)
class DriveNow:
    """A drive at this moment. ``online`` is None before it was heard or missed on this connection of its line.

    ``missed``: it was told offline and not told online since. ``started``: it was told to move and not told to stop since.
    ``jogging``: a jog of ours moves it. ``moves_until``: it was seen to move, or told to, so lately that it counts as moving
    until then. ``place`` is what its next distance is compared with. ``operation`` is the number of what is being done to it
    that may change or move something.
    """

    spec: DriveUnit
    catalogue: Catalogue
    record: DriveRecord
    online: bool | None = None
    missed: bool = False
    reason: str = "not connected yet"
    status: DriveStatus | None = None
    seen: Seconds | None = None
    started: bool = False
    jogging: bool = False
    shown_moving: bool | None = None
    moves_until: Seconds = Seconds(-inf)
    place: tuple[Turn | None, Hundredths] | None = None
    operation: int | None = None
    values: dict[Parameter, DriveValue] = field(default_factory=dict)

    @property
    def id(self) -> DriveId:
        """The drive's name."""
        return self.spec.id

    def moving(self, now: Seconds) -> bool | None:
        """Return whether the axis moves; None where nobody can tell.

        No field of the status says so (PROTOCOLS 2.4). The distance of its long form does, by changing; of a drive with the
        short form we know only what we told it.
        """
        if self.status is None or self.online is not True:
            return None
        if self.status.mode is DriveMode.ERROR:
            return False
        if self.jogging or now < self.moves_until:
            return True
        if self.status.distance is None:
            return True if self.started else None
        return False

    @property
    def still_from(self) -> Seconds | None:
        """When it counts as standing still if it is not seen to move before; None if time alone does not tell."""
        lasting = self.jogging or (self.started and self.status is not None and self.status.distance is None)
        return None if lasting or not self.shown_moving else self.moves_until

    def learn(self, status: DriveStatus, now: Seconds) -> None:
        """Take a status over."""
        self.status = status
        place = None if status.distance is None else (status.turn, status.distance)
        if None not in (self.place, place) and self.place != place:
            self.moves_until = Seconds(now + STILL_AFTER)
        self.place = place
        if status.mode is DriveMode.ERROR:
            self.stopped()

    def told_to_move(self, now: Seconds) -> None:
        """It was told to move, or may have been."""
        self.started, self.moves_until = True, Seconds(now + STILL_AFTER)

    def stopped(self) -> None:
        """It was told to stop, or stopped by itself."""
        self.started, self.moves_until, self.place = False, Seconds(-inf), None


def hexed(number: int) -> str:
    """Return a parameter's number as people and the wire write it."""
    return f"{number:02X}"


def named(drive: DriveNow, number: int) -> str:
    """Return a parameter for people: its number, and its name where there is one."""
    spec = drive.catalogue.get(number)
    return f"{hexed(number)} ({spec.name})" if spec else hexed(number)


def said(drive: DriveNow, number: int, raw: int) -> str:
    """Return a parameter's value for people: raw, and in its unit where there is one."""
    spec = drive.catalogue.get(number)
    return f"{raw:04d} ({spec.shown(raw)})" if spec else f"{raw:04d}"


def view_of_drive(drive: DriveNow, now: Seconds, utc_at: Callable[[Seconds], Timestamp]) -> DriveView:
    """Return a drive as people see it."""
    status = drive.status
    broken = status is not None and status.mode is DriveMode.ERROR
    error, remedy = explained(status.code) if status is not None and broken else ("", "")
    return DriveView(
        id=drive.id,
        name=drive.spec.name,
        line=drive.spec.link,
        address=drive.spec.address,
        model=drive.spec.model,
        online=drive.online,
        reason=drive.reason,
        mode=status.mode.name.lower() if status else None,
        output=status.output if status else None,
        code=status.code if status else None,
        meaning=status.meaning if status else "",
        turn=status.turn.name.lower() if status and status.turn is not None else None,
        distance=status.distance if status else None,
        seen=utc_at(drive.seen) if drive.seen is not None else None,
        error=error,
        remedy=remedy,
        moving=drive.moving(now),
        operation=None if drive.operation is None else str(drive.operation),
        lockout=LockoutView.of(drive.record.lockout),
    )


def view_of_parameter(drive: DriveNow, number: Parameter, *, watched: bool = False) -> ParameterView:
    """Return a parameter as people see it."""
    known = drive.values.get(number)
    spec = drive.catalogue.get(number) or ParameterSpec(number, "")
    raw = None if known is None else known.value
    is_named = drive.catalogue.get(number) is not None
    return ParameterView(
        drive=drive.id,
        number=hexed(number),
        named=is_named,
        name=spec.name,
        unit=spec.unit,
        raw=raw,
        value=None if raw is None or not is_named else spec.scaled(raw),
        text="" if raw is None else spec.shown(raw),
        at=None if known is None else known.at,
        lowest=spec.scaled(spec.lowest) if is_named else None,
        highest=spec.scaled(spec.highest) if is_named else None,
        default=None if spec.default is None else spec.scaled(spec.default),
        read_only=spec.read_only,
        while_running=spec.while_running,
        description=spec.description,
        watched=watched,
    )


def view_of_operation(operation: DriveOperation) -> OperationView:
    """Return an operation as people see it."""
    return OperationView(
        id=str(operation.number),
        kind=operation.kind.value,
        state=operation.state.value,
        drive=operation.drive,
        line=operation.line,
        actor=operation.actor,
        opened=operation.opened,
        closed=operation.closed,
        done=operation.done,
        total=operation.total,
        body=operation.body,
        result=operation.result,
        reason=operation.reason,
        remedy=operation.remedy,
    )
