"""Axis drives: what is known of them (PROTOCOLS section 2, DOMAIN section 7)."""

from dataclasses import dataclass

from app.domain.drive import (
    DriveDone,
    DriveEvent,
    DriveFailed,
    DriveId,
    DriveLineDown,
    DriveLineGarbled,
    DriveLineUp,
    DriveOffline,
    DriveOnline,
    DriveReported,
    DriveStatus,
    DriveUnknown,
    JogBegan,
    ParameterRead,
)
from app.domain.layout import DriveUnit
from app.domain.units import Seconds
from app.domain.view import DriveView, Topic
from app.fleet.books import Books


@dataclass(slots=True)
class DriveNow:
    """A drive at this moment. ``online`` is None before it was heard or missed on this connection of its line."""

    spec: DriveUnit
    online: bool | None = None
    reason: str = "not connected yet"
    status: DriveStatus | None = None
    seen: Seconds | None = None


class Drives:
    """Knows the drives of the plant."""

    def __init__(self, books: Books) -> None:
        self._books = books
        self.all: dict[DriveId, DriveNow] = {spec.id: DriveNow(spec) for spec in books.plant.drives}
        for drive in self.all.values():
            self._show(drive)

    def handle(self, event: DriveEvent) -> None:
        """Take what a drive line tells."""
        match event:
            case DriveLineUp(line=line):
                self._line(line, "")
            case DriveLineDown(line=line, reason=reason):
                self._line(line, f"the line is down: {reason}")
            case DriveOnline(drive=name):
                self._learn(self.all[name], online=True)
            case DriveOffline(drive=name, reason=reason):
                self._learn(self.all[name], online=False, reason=reason)
            case DriveReported(drive=name, status=status):
                self._learn(self.all[name], online=True, status=status)
            case DriveDone() | DriveFailed() | DriveUnknown() | JogBegan() | ParameterRead() | DriveLineGarbled():
                pass

    def _line(self, line: str, reason: str) -> None:
        for drive in self.all.values():
            if drive.spec.link == line:
                drive.online, drive.reason = None, reason
                self._show(drive)

    def _learn(self, drive: DriveNow, *, online: bool, reason: str = "", status: DriveStatus | None = None) -> None:
        drive.online, drive.reason = online, reason
        if online:
            drive.seen = self._books.now
        drive.status = status or drive.status
        self._show(drive)

    def _show(self, drive: DriveNow) -> None:
        status, books = drive.status, self._books
        view = DriveView(
            id=drive.spec.id,
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
            seen=books.utc_at(drive.seen) if drive.seen is not None else None,
        )
        books.show(Topic.DRIVES, drive.spec.id, view)
