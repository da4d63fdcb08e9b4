"""Records to write."""

from app.domain.ids import Actor, CarrierId, CmdId, JobId, StationId, VehicleId
from app.domain.job import Job, JobState
from app.domain.layout import Axis, PulseSet
from app.domain.records import (
    AuditRow,
    HistoryEvent,
    Intent,
    IntentState,
    StationDest,
    TeachingEvent,
    VehicleOffset,
)
from app.domain.units import Barcode, Pulses, Timestamp

V1 = VehicleId("V1")
S1 = StationId("S1")
ACTOR = Actor("mes")


def job(number: int, state: JobState = JobState.QUEUED, **more: object) -> Job:
    given: dict[str, object] = {
        "id": JobId(f"J{number}"),
        "order": number,
        "carrier": CarrierId(f"F{number}"),
        "source": S1,
        "destination": StationId("S2"),
        "priority": 50,
        "created": Timestamp(100.0 + number),
        "actor": ACTOR,
        "fingerprint": "ab12",
        "state": state,
    }
    return Job(**{**given, **more})  # type: ignore[arg-type]


def event(seq: int, job: str | None = None, vehicle: str | None = None) -> HistoryEvent:
    return HistoryEvent(
        seq,
        Timestamp(seq / 3),
        "TransferInitiated",
        101,
        JobId(job) if job else None,
        None,
        VehicleId(vehicle) if vehicle else None,
    )


def intent(cmd_id: int, state: IntentState = IntentState.OPEN) -> Intent:
    return Intent(
        CmdId(cmd_id),
        V1,
        "move",
        state,
        Timestamp(1.5),
        ACTOR,
        path=(Barcode("1001"), Barcode("1002")),
        body={"seq": 1},
    )


def audit(action: str) -> AuditRow:
    return AuditRow(Timestamp(1.0), ACTOR, action, "V1", "", accepted=True)


def pulses(lift: int) -> PulseSet:
    return PulseSet(Pulses(1), Pulses(-2), Pulses(lift))


def dest(version: int) -> StationDest:
    return StationDest(S1, version, pulses(version), ACTOR, "rest", Timestamp(1.0))


def offset(version: int) -> VehicleOffset:
    return VehicleOffset(V1, version, pulses(version), ACTOR, "rest", Timestamp(1.0))


def taught(cmd_id: int, at: float = 1.0, number: int = 0) -> TeachingEvent:
    return TeachingEvent(
        V1,
        "c1",
        CmdId(cmd_id),
        0x2074,
        Axis.LIFT,
        Pulses(-1000),
        Barcode("1001"),
        Timestamp(at),
        number or (cmd_id & 0xFF) + 1,
    )
