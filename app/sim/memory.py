"""A ledger in memory, for worlds that never lose power."""

from collections.abc import Sequence
from dataclasses import fields

from app.domain.alarms import Alarm
from app.domain.closures import Closure
from app.domain.devices import DeviceId
from app.domain.drive import DriveId, Parameter
from app.domain.drive_records import DriveOperation, DriveRecord, DriveValue, OperationState
from app.domain.ids import CarrierId, CmdId, Epoch, JobId, StationId, VehicleId
from app.domain.job import Job
from app.domain.records import (
    CarrierGone,
    CarrierRecord,
    ControllerRecord,
    ControllerState,
    DeviceRecord,
    HistoryEvent,
    Intent,
    Kept,
    Record,
    StationDest,
    StationRecord,
    TeachingEvent,
    VehicleOffset,
    VehicleRecord,
)
from app.domain.teaching import Proposal, SessionState, TeachingSession
from app.domain.walks import Walk, WalkPlace
from app.domain.why import Why


class MemoryLedger:
    """Keeps records as a database would, for as long as the process lives; a new controller may load what an old one wrote."""

    def __init__(self) -> None:
        self._epoch = 0
        self._fresh = True
        self._jobs: dict[JobId, Job] = {}
        self._intents: dict[CmdId, Intent] = {}
        self._vehicles: dict[VehicleId, VehicleRecord] = {}
        self._stations: dict[StationId, StationRecord] = {}
        self._carriers: dict[CarrierId, CarrierRecord] = {}
        self._dests: dict[StationId, StationDest] = {}
        self._offsets: dict[VehicleId, VehicleOffset] = {}
        self._devices: dict[DeviceId, DeviceRecord] = {}
        self._whys: dict[int, Why] = {}
        self._controller = ControllerRecord(ControllerState.AUTO)
        self._next_event = 1
        self._next_order = 1
        self._drives: dict[DriveId, DriveRecord] = {}
        self._values: dict[tuple[DriveId, Parameter], DriveValue] = {}
        self._operations: dict[int, DriveOperation] = {}
        self._proposals: dict[int, Proposal] = {}
        self._sessions: dict[int, TeachingSession] = {}
        self._next_taught = 1
        self._closures: dict[int, Closure] = {}
        self._alarms: dict[int, Alarm] = {}
        self._walks: dict[int, Walk] = {}
        self._walk_places: dict[tuple[int, StationId], WalkPlace] = {}

    def load(self) -> Kept:
        """Raise the epoch and return all that is kept."""
        self._epoch += 1
        return Kept(
            epoch=Epoch(self._epoch),
            jobs=tuple(job for job in self._jobs.values() if not job.state.terminal),
            intents=tuple(intent for intent in self._intents.values() if not intent.state.closed),
            vehicles=tuple(self._vehicles.values()),
            stations=tuple(self._stations.values()),
            carriers=tuple(self._carriers.values()),
            dests=tuple(self._dests.values()),
            offsets=tuple(self._offsets.values()),
            devices=tuple(self._devices.values()),
            controller=self._controller,
            next_event=self._next_event,
            next_order=self._next_order,
            whys=tuple(self._whys[job.order] for job in self._jobs.values() if self._goes_on(job)),
            drives=tuple(self._drives.values()),
            drive_values=tuple(self._values.values()),
            operations=tuple(one for one in self._operations.values() if one.state is OperationState.RUNNING),
            next_operation=max(self._operations, default=0) + 1,
            proposals=tuple(p for p in self._proposals.values() if not p.state.over),
            sessions=tuple(s for s in self._sessions.values() if s.state is SessionState.OPEN),
            next_taught=self._next_taught,
            next_proposal=max(self._proposals, default=0) + 1,
            next_session=max(self._sessions, default=0) + 1,
            closures=tuple(c for c in self._closures.values() if not c.state.over),
            alarms=tuple(a for a in self._alarms.values() if a.ended is None),
            next_alarm=max(self._alarms, default=0) + 1,
            walks=tuple(w for w in self._walks.values() if w.ended is None),
            walk_places=tuple(p for p in self._walk_places.values() if self._walks[p.walk].ended is None),
            next_walk=max(self._walks, default=0) + 1,
            next_closure=max(self._closures, default=0) + 1,
            fresh=self._fresh,
        )

    def commit(self, batch: Sequence[Record]) -> None:
        """Take all records over, in order."""
        self._fresh = False
        for record in batch:
            self._keep(record)

    def close(self) -> None:
        """Nothing to let go."""

    def job(self, job: JobId) -> Job | None:
        """Return a job, ended ones too."""
        return self._jobs.get(job)

    def why(self, order: int) -> Why | None:
        """Return what is kept of a job's why."""
        return self._whys.get(order)

    def _goes_on(self, job: Job) -> bool:
        return not job.state.terminal and job.order in self._whys

    def _keep(self, record: Record) -> None:
        match record:
            case Job():
                self._jobs[record.id] = record
                self._next_order = max(self._next_order, record.order + 1)
            case Intent():
                self._intents[record.cmd_id] = record
            case HistoryEvent():
                self._next_event = max(self._next_event, record.seq + 1)
            case VehicleRecord():
                self._vehicles[record.vehicle] = record
            case StationRecord():
                self._stations[record.station] = record
            case CarrierRecord():
                self._carriers[record.carrier] = record
            case CarrierGone():
                self._carriers.pop(record.carrier, None)
            case StationDest():
                self._dests[record.station] = record
            case VehicleOffset():
                self._offsets[record.vehicle] = record
            case DeviceRecord():
                self._devices[record.device] = record
            case ControllerRecord():
                self._controller = record
            case _:
                self._keep_of_drive(record)

    def _keep_of_drive(self, record: Record) -> None:
        match record:
            case Why():
                self._whys[record.order] = record
            case Alarm():
                self._alarms[record.number] = record
            case Closure():
                self._closures[record.number] = record
            case DriveRecord():
                self._drives[record.drive] = record
            case DriveValue():
                self._values[record.drive, record.parameter] = record
            case DriveOperation():
                self._operations[record.number] = record
            case Walk():
                self._walks[record.number] = record
            case WalkPlace():
                self._walk_places[record.walk, record.station] = record
            case _:
                self._keep_teaching(record)

    def _keep_teaching(self, record: Record) -> None:
        match record:
            case Proposal():
                self._proposals[record.number] = record
            case TeachingSession():
                self._sessions[record.number] = record
            case TeachingEvent():
                self._next_taught = max(self._next_taught, record.number + 1)
            case _:
                pass


def written(record: Record) -> str:
    """Return a record as text that is the same in every process."""
    values = ", ".join(f"{field.name}={getattr(record, field.name)!r}" for field in fields(record))
    return f"{type(record).__name__}({values})"
