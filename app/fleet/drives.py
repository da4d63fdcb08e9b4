"""Axis drives: what is known of them, and what people do with them (PROTOCOLS section 2, DOMAIN section 7)."""

from app.domain.alarms import AlarmKind
from app.domain.drive import (
    DriveDone,
    DriveEvent,
    DriveFailed,
    DriveId,
    DriveLineDown,
    DriveLineGarbled,
    DriveLineUp,
    DriveMode,
    DriveOffline,
    DriveOnline,
    DriveReported,
    DriveRequest,
    DriveStatus,
    DriveUnknown,
    Jog,
    JogBegan,
    Parameter,
    ParameterRead,
)
from app.domain.drive_errors import explained
from app.domain.drive_records import DriveRecord, DriveValue
from app.domain.drive_requests import DriveOrder, KeepDriveJog, ReleaseDriveJog, UnwatchDrive, WatchDrive, Word
from app.domain.errors import Refusal
from app.domain.ids import Actor
from app.domain.job import JobEvent
from app.domain.links import LinkSend
from app.domain.records import Kept
from app.domain.requests import Accepted, Reply
from app.domain.units import Seconds
from app.domain.view import Topic
from app.fleet.books import Books
from app.fleet.drive import DriveNow, view_of_drive, view_of_parameter
from app.fleet.drive_operations import Operations
from app.fleet.drive_orders import DriveOrders, no_drive
from app.fleet.drive_watch import Watches

OFFLINE = "offline"
"""The code of the alarm of a drive that does not answer."""


class Drives:
    """Knows the drives of the plant, and carries out what is asked about them."""

    def __init__(self, books: Books, kept: Kept) -> None:
        self._books = books
        records = {record.drive: record for record in kept.drives}
        self.all: dict[DriveId, DriveNow] = {
            spec.id: DriveNow(spec, books.plant.catalogue_of(spec), records.get(spec.id, DriveRecord(spec.id)))
            for spec in books.plant.drives
        }
        for value in kept.drive_values:
            if value.drive in self.all:
                self.all[value.drive].values[value.parameter] = value
        self._operations = Operations(books, self.all, self._show, kept.operations, kept.next_operation)
        self._orders = DriveOrders(books, self.all, self._operations, self._show)
        self._watches = Watches(books, self.all, self._operations)
        for drive in self.all.values():
            self._show(drive)
            for number in sorted({*drive.catalogue.parameters, *drive.values}):
                self._show_parameter(drive, number)

    # -- people -------------------------------------------------------------------------------------------------------

    def answer(self, request: DriveOrder) -> Reply:
        """Carry a request out, or begin to, or refuse it."""
        return self._orders.answer(request)

    def tell(self, word: Word) -> tuple[Reply, list[LinkSend]]:
        """Take a word that changes nothing that is kept; what it gives the line to do is to leave at once."""
        match word:
            case KeepDriveJog():
                return self._orders.keep_jog(word)
            case ReleaseDriveJog():
                return self._orders.release_jog(word)
            case WatchDrive():
                return (self._watches.begin(word) if word.drive in self.all else no_drive(word.drive)), []
            case UnwatchDrive():
                if self._watches.end(word.watch):
                    return Accepted(Topic.PARAMETERS, word.watch), []
                return Refusal("not-found", f"there is no watch {word.watch}", "it may be over"), []

    def halt(self, actor: Actor, why: str) -> None:
        """Stop every axis that may move."""
        self._orders.halt_all(actor, why)

    def objection(self, send: LinkSend) -> str:
        """Return why an order must not leave any more now that it is durable; empty if it may."""
        order = send.order
        return self._operations.objection(order.id) if isinstance(order, DriveRequest | Jog) else ""

    # -- time ---------------------------------------------------------------------------------------------------------

    @property
    def deadline(self) -> Seconds:
        """When ``tick`` wants to be called next; infinite if nothing is to be done."""
        still = [at for drive in self.all.values() if (at := drive.still_from) is not None]
        return min([self._watches.deadline, self._operations.deadline, *still])

    def tick(self) -> None:
        """Time has passed."""
        for drive in self.all.values():
            still_from = drive.still_from
            if still_from is not None and still_from <= self._books.now:
                self._show(drive)
        self._operations.tick()
        self._watches.tick()

    # -- what the line tells ------------------------------------------------------------------------------------------

    def handle(self, event: DriveEvent) -> None:
        """Take what a drive line tells."""
        match event:
            case DriveLineUp(line=line):
                self._line(line, "")
            case DriveLineDown(line=line, reason=reason):
                self._line(line, f"the line is down: {reason}")
            case DriveOnline(drive=name):
                self._online(self.all[name])
            case DriveOffline(drive=name, reason=reason):
                self._offline(self.all[name], reason)
            case DriveReported(drive=name, status=status):
                self._reported(self.all[name], status)
            case ParameterRead():
                self._read(self.all[event.drive], event)
            case JogBegan():
                self._operations.began(event)
            case DriveDone() | DriveFailed() | DriveUnknown():
                self._ended(event)
            case DriveLineGarbled():
                pass

    def _line(self, line: str, reason: str) -> None:
        for drive in self.all.values():
            if drive.spec.link == line:
                drive.online, drive.reason = None, reason
                self._show(drive)

    def _online(self, drive: DriveNow) -> None:
        self._books.alarms.end_one(AlarmKind.DRIVE, drive.id, OFFLINE, "it answers again")
        if drive.missed:
            self._books.event(JobEvent.DRIVE_ONLINE, source=drive.id, detail=f"{drive.id} answers again")
        drive.online, drive.missed, drive.reason, drive.seen = True, False, "", self._books.now
        self._show(drive)
        self._operations.back(drive.id)
        if doubts := self._operations.doubts(drive.id):
            self._orders.look(drive, doubts)

    def _offline(self, drive: DriveNow, reason: str) -> None:
        """An alarm (PROTOCOLS H10). One that outlasts a reconnection is told once."""
        self._books.alarms.begin(AlarmKind.DRIVE, drive.id, OFFLINE, reason, "see its line, its address and its power")
        if not drive.missed:
            self._books.event(JobEvent.DRIVE_OFFLINE, source=drive.id, result="alarm", detail=reason)
        drive.online, drive.missed, drive.reason = False, True, reason
        self._show(drive)

    def _reported(self, drive: DriveNow, status: DriveStatus) -> None:
        before = drive.status
        was = before.code if before is not None and before.mode is DriveMode.ERROR else None
        is_ = status.code if status.mode is DriveMode.ERROR else None
        if is_ is not None and was != is_:
            meaning, remedy = explained(is_)
            detail = f"{is_:02d} {status.meaning}: {meaning}; {remedy}"
            self._books.event(JobEvent.DRIVE_ERROR_SET, source=drive.id, result=status.meaning, detail=detail)
        elif was is not None and is_ is None:
            self._books.event(JobEvent.DRIVE_ERROR_CLEARED, source=drive.id, detail=f"{was:02d}")
        self._mind_error(drive, status)
        drive.learn(status, self._books.now)
        drive.online, drive.reason, drive.seen = True, "", self._books.now
        self._show(drive)

    def _mind_error(self, drive: DriveNow, status: DriveStatus) -> None:
        """Keep which error it has; one from before a restart may be over."""
        alarms = self._books.alarms
        if status.mode is DriveMode.ERROR:
            meaning, remedy = explained(status.code)
            cause = f"{status.code:02d} {status.meaning}: {meaning}"
            alarms.begin_only(AlarmKind.DRIVE, drive.id, f"error {status.code:02d}", cause, remedy)
        elif alarms.about(AlarmKind.DRIVE, drive.id):
            alarms.end(AlarmKind.DRIVE, drive.id, "it reports no error any more")

    def _read(self, drive: DriveNow, event: ParameterRead) -> None:
        drive.values[event.parameter] = DriveValue(drive.id, event.parameter, event.value, self._books.utc)
        self._show_parameter(drive, event.parameter)

    def _ended(self, event: DriveDone | DriveFailed | DriveUnknown) -> None:
        if self._watches.ended(event.request) or not self._operations.ended(event):
            return
        drive = self.all.get(event.drive) if event.drive is not None else None
        if drive is not None:
            drive.seen = self._books.now if isinstance(event, DriveDone) else drive.seen

    # -- what people see ----------------------------------------------------------------------------------------------

    def _show(self, drive: DriveNow) -> None:
        books = self._books
        view = view_of_drive(drive, books.now, books.utc_at)
        drive.shown_moving = view.moving
        books.show(Topic.DRIVES, drive.id, view)

    def _show_parameter(self, drive: DriveNow, number: Parameter) -> None:
        view = view_of_parameter(drive, number, watched=self._watches.watched(drive.id, number))
        self._books.show(Topic.PARAMETERS, f"{drive.id}/{view.number}", view)
