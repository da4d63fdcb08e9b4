"""The drives of the scripted controller: one line with D1 and D2, of which D1 has a catalogue; answers at once."""

from collections.abc import Sequence
from dataclasses import replace

from app.domain import drive_requests as d
from app.domain.catalogue import Catalogue, ParameterSpec
from app.domain.drive import DriveAddress, DriveId, Parameter, RawValue
from app.domain.drive_records import (
    DriveBackup,
    DriveOperation,
    DriveRecord,
    DriveValue,
    OperationKind,
    OperationState,
)
from app.domain.errors import Refusal
from app.domain.ids import Actor, LinkId
from app.domain.layout import DriveUnit, LinkSpec, Wire
from app.domain.requests import Accepted, Reply
from app.domain.units import Timestamp
from app.domain.view import LineView, Topic, Update
from app.fleet.drive import DriveNow, view_of_drive, view_of_operation, view_of_parameter

AXES, D1, D2 = LinkId("AXES"), DriveId("D1"), DriveId("D2")
LINKS = (LinkSpec(AXES, Wire.HI, port=1),)
DRIVES = (DriveUnit(D1, AXES, DriveAddress(1), "HI-1", "axis 1"), DriveUnit(D2, AXES, DriveAddress(2)))
CATALOGUE = Catalogue(
    "HI-1",
    "for tests",
    {
        Parameter(0x1C): ParameterSpec(
            Parameter(0x1C), "Acceleration", "s", 0.01, 2, RawValue(10), RawValue(6000), RawValue(150)
        ),
        Parameter(0x1D): ParameterSpec(Parameter(0x1D), "Direction", highest=RawValue(1), choices={0: "CW", 1: "CCW"}),
    },
)
_KINDS = {
    d.PressDriveKey: OperationKind.KEY,
    d.StopDriveLine: OperationKind.STOP_ALL,
    d.AskDriveStatus: OperationKind.STATUS,
    d.SetDriveInputs: OperationKind.INPUTS,
    d.ReadDrive: OperationKind.READ,
    d.WriteDrive: OperationKind.WRITE,
    d.BackUpDrive: OperationKind.BACKUP,
    d.CompareDrive: OperationKind.COMPARE,
    d.RestoreDrive: OperationKind.RESTORE,
    d.JogDrive: OperationKind.JOG,
}


class ScriptedDrives:
    """Every request becomes an operation that runs until ``end``. ``words`` has every word that was told."""

    def __init__(self, now: Timestamp) -> None:
        self.now = now
        self.operations: dict[int, DriveOperation] = {}
        self.backups: dict[int, DriveBackup] = {}
        self.words: list[d.Word] = []
        self.traffic: list[tuple[Timestamp, str, bytes]] = []

    def shown(self) -> list[Update]:
        """Return what is published at the start."""
        return [update for unit in DRIVES for update in self._shown(unit)]

    def _shown(self, unit: DriveUnit) -> list[Update]:
        drive = DriveNow(unit, CATALOGUE if unit.model else Catalogue(""), DriveRecord(unit.id), online=True)
        drive.values[Parameter(0x1C)] = DriveValue(unit.id, Parameter(0x1C), RawValue(123), self.now)
        views = [view_of_parameter(drive, Parameter(number)) for number in (0x1C, 0x1D)]
        return [
            Update(Topic.DRIVES, unit.id, view_of_drive(drive, self.now, lambda moment: Timestamp(moment))),  # type: ignore[arg-type]
            *(Update(Topic.PARAMETERS, f"{unit.id}/{view.number}", view) for view in views if view.raw or unit.model),
        ]

    def answer(self, request: d.DriveOrder) -> tuple[Reply, list[Update]]:
        """Return the reply, and what is published with it."""
        drive = getattr(request, "drive", None)
        if drive is not None and drive not in {D1, D2}:
            return Refusal("not-found", f"there is no drive {drive}", "see GET /api/v1/drives"), []
        if isinstance(request, d.LockDrive | d.UnlockDrive):
            return Accepted(Topic.DRIVES, request.drive), []
        if isinstance(request, d.CancelDriveOperation):
            return Accepted(Topic.OPERATIONS, str(request.operation)), [self.end(request.operation)]
        number = len(self.operations) + 1
        operation = DriveOperation(
            number, _KINDS[type(request)], OperationState.RUNNING, self.now, request.actor, AXES, drive
        )
        self.operations[number] = operation
        update = Update(Topic.OPERATIONS, str(number), view_of_operation(operation))
        return Accepted(Topic.OPERATIONS, str(number), created=True), [update]

    def end(self, number: int, state: OperationState = OperationState.DONE) -> Update:
        """Let an operation end, and return what is published then."""
        operation = replace(self.operations[number], state=state, closed=self.now, done=1)
        self.operations[number] = operation
        return Update(Topic.OPERATIONS, str(number), view_of_operation(operation))

    def keep_backup(self, drive: DriveId = D1, model: str = "HI-1") -> DriveBackup:
        """Let there be a backup."""
        values: tuple[RawValue | None, ...] = (*(RawValue(number) for number in range(255)), None)
        backup = DriveBackup(len(self.backups) + 1, drive, model, self.now, Actor("kim"), "a note", values)
        self.backups[backup.number] = backup
        return backup

    def tell(self, word: d.Word) -> Reply:
        self.words.append(word)
        if isinstance(word, d.KeepDriveJog | d.ReleaseDriveJog):
            jog = self.operations.get(word.operation)
            if jog is None or jog.state is not OperationState.RUNNING:
                return Refusal("not-now", f"jog {word.operation} is over")
        elif isinstance(word, d.WatchDrive) and word.drive not in {D1, D2}:
            return Refusal("not-found", f"there is no drive {word.drive}")
        elif isinstance(word, d.UnwatchDrive) and word.watch not in self.watched():
            return Refusal("not-found", f"there is no watch {word.watch}")
        return Accepted(Topic.DRIVES, "")

    def watched(self) -> set[str]:
        return {word.watch for word in self.words if isinstance(word, d.WatchDrive)}

    def links(self) -> Sequence[LineView]:
        return [
            LineView(
                AXES, "hi", "127.0.0.1:1", up=True, since=self.now, reason="", devices=(D1, D2), figures={"sent": 1}
            )
        ]
