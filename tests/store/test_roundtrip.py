"""Every record type comes back equal to what was written, whatever it says."""

from collections.abc import Callable, Iterator
from typing import Any, get_args

import pytest
import sqlalchemy as sa
from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.alarms import Alarm, AlarmKind
from app.domain.closures import ClosedPlace, Closure, ClosurePurpose, ClosureState, PlaceKind
from app.domain.drive_records import (
    DriveBackup,
    DriveOperation,
    DriveRecord,
    DriveValue,
    OperationKind,
    OperationState,
)
from app.domain.job import TERMINAL, Job, JobState, Leg
from app.domain.layout import Axis
from app.domain.pulses import pulses_of
from app.domain.records import (
    AuditRow,
    BufferLock,
    CarrierGone,
    CarrierRecord,
    ControllerRecord,
    ControllerState,
    DeviceRecord,
    DoorPosition,
    Emergency,
    EmergencyKind,
    HistoryEvent,
    Hold,
    Intent,
    IntentState,
    Kept,
    Lockout,
    Pin,
    Provenance,
    Record,
    StationDest,
    StationRecord,
    TeachingEvent,
    VehicleOffset,
    VehicleRecord,
    ZonePause,
)
from app.domain.teaching import Basis, Proposal, ProposalState, Reading, SessionState, Side, TeachingSession
from app.domain.units import Pulses
from app.domain.walks import Finding, Walk, WalkPlace, WalkState
from app.domain.webhooks import Webhook, WebhookProgress, WebhookState, WebhookTry
from app.domain.why import Candidate, Choice, Wait, Why
from app.store import tables
from app.store.engine import parsed
from app.store.reading import Reader
from app.store.rows import ROW_OF
from app.store.statements import APPENDED, REPLACED
from tests.shares import shared
from tests.store.conftest import Open, own_schema

TEXT = st.text(st.characters(exclude_categories=["Cs"], exclude_characters="\0"), max_size=12)
INT64 = st.integers(-(1 << 63), (1 << 63) - 1)
UINT64 = st.integers(0, (1 << 64) - 1)
PULSES = st.integers(-(1 << 31), (1 << 31) - 1)
TIME = st.floats(0, 4e9)
JSON = st.recursive(
    st.none() | st.booleans() | INT64 | st.floats(allow_nan=False, allow_infinity=False) | TEXT,
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(TEXT, inner, max_size=3),
    max_leaves=6,
)
NAMES = st.lists(TEXT, max_size=4).map(tuple)
MAYBE = st.none() | TEXT
PROVENANCE = st.sampled_from(Provenance)
HOLDS = st.builds(Hold, reason=TEXT, remedy=TEXT, since=TIME)
LOCKOUTS = st.builds(Lockout, owner=TEXT, reason=TEXT, since=TIME, releases=NAMES)
SOME_PULSES = st.dictionaries(st.sampled_from(Axis), PULSES.map(Pulses), max_size=3).map(pulses_of)
NUMBER = st.integers(1, 1 << 62)
NUMBERS = st.lists(NUMBER, max_size=3).map(tuple)
BASES = st.builds(
    Basis,
    axis=st.sampled_from(Axis),
    raw=PULSES,
    vehicle=TEXT,
    barcode=TEXT,
    events=NUMBERS,
    against=TEXT,
    version=st.none() | NUMBER,
    less=PULSES,
)
READINGS = st.builds(Reading, axis=st.sampled_from(Axis), position=PULSES, cmd_id=UINT64, events=NUMBERS)
PINS = st.builds(Pin, position=st.sampled_from(DoorPosition), owner=TEXT, reason=TEXT, since=TIME)
BUFFER_LOCKS = st.builds(BufferLock, owner=TEXT, person=st.booleans(), since=TIME)
EMERGENCIES = st.builds(Emergency, kind=st.sampled_from(EmergencyKind), actor=TEXT, reason=TEXT, since=TIME)
PAUSES = st.builds(ZonePause, zone=TEXT, owner=TEXT, reason=TEXT, since=TIME, stopped=st.booleans())
SECONDS = st.floats(-1e9, 1e9)
CANDIDATES = st.builds(Candidate, vehicle=TEXT, seconds=st.none() | SECONDS, why_not=TEXT)
CHOICES = st.builds(
    Choice,
    at=TIME,
    vehicle=TEXT,
    seconds=SECONDS,
    priority=st.integers(0, 99),
    hot=st.booleans(),
    waited=SECONDS,
    switch=SECONDS,
    candidates=st.lists(CANDIDATES, max_size=2).map(tuple),
    before=MAYBE,
    saved=st.none() | SECONDS,
)
TAUGHT: dict[str, st.SearchStrategy[Any]] = {
    "version": st.integers(1, 1 << 31),
    "pulses": SOME_PULSES,
    "actor": TEXT,
    "source": TEXT,
    "at": TIME,
    "basis": st.lists(BASES, max_size=3).map(tuple),
    "proposal": st.none() | NUMBER,
    "restores": st.none() | NUMBER,
    "reason": TEXT,
}

RECORDS: dict[type, st.SearchStrategy[Any]] = {
    Job: st.builds(
        Job,
        id=TEXT,
        order=st.integers(1, 1 << 62),
        carrier=MAYBE,
        source=TEXT,
        destination=TEXT,
        priority=st.integers(-100, 100),
        created=TIME,
        actor=TEXT,
        fingerprint=TEXT,
        idempotency_key=MAYBE,
        state=st.sampled_from(JobState),
        leg=st.sampled_from(Leg),
        vehicle=MAYBE,
        wish=MAYBE,
        fallbacks=NAMES,
        reason=TEXT,
        result=TEXT,
        assigned=st.none() | TIME,
        picked=st.none() | TIME,
        ended=st.none() | TIME,
    ),
    Why: st.builds(
        Why,
        order=st.integers(1, 1 << 62),
        job=TEXT,
        choices=st.lists(CHOICES, max_size=3).map(tuple),
        waits=st.lists(st.builds(Wait, since=TIME, reason=TEXT, until=st.none() | TIME), max_size=3).map(tuple),
        left_out=st.integers(0, 1 << 62),
    ),
    Intent: st.builds(
        Intent,
        cmd_id=UINT64,
        vehicle=TEXT,
        kind=TEXT,
        state=st.sampled_from(IntentState),
        opened=TIME,
        actor=TEXT,
        job=MAYBE,
        path=NAMES,
        body=st.dictionaries(TEXT, JSON, max_size=3),
        amends=st.none() | UINT64,
        closed=st.none() | TIME,
        outcome=TEXT,
    ),
    HistoryEvent: st.builds(
        HistoryEvent,
        seq=st.integers(1, 1 << 62),
        at=TIME,
        event=TEXT,
        ceid=st.integers(0, 1 << 32),
        job=MAYBE,
        carrier=MAYBE,
        vehicle=MAYBE,
        source=MAYBE,
        destination=MAYBE,
        result=TEXT,
        detail=TEXT,
    ),
    AuditRow: st.builds(AuditRow, at=TIME, actor=TEXT, action=TEXT, target=TEXT, detail=TEXT, accepted=st.booleans()),
    VehicleRecord: st.builds(
        VehicleRecord,
        vehicle=TEXT,
        barcode=MAYBE,
        held=NAMES,
        carrier=MAYBE,
        believed_loaded=st.none() | st.booleans(),
        hold=st.none() | HOLDS,
        lockout=st.none() | LOCKOUTS,
        out_of_service=TEXT,
        off_rail=TEXT,
    ),
    StationRecord: st.builds(
        StationRecord,
        station=TEXT,
        present=st.none() | st.booleans(),
        carrier=MAYBE,
        reserved=TEXT,
        out_of_service=TEXT,
        provenance=PROVENANCE,
        at=TIME,
    ),
    CarrierRecord: st.builds(CarrierRecord, carrier=TEXT, place=MAYBE, provenance=PROVENANCE, at=TIME),
    CarrierGone: st.builds(CarrierGone, TEXT),
    StationDest: st.builds(StationDest, station=TEXT, **TAUGHT),
    VehicleOffset: st.builds(VehicleOffset, vehicle=TEXT, **TAUGHT),
    TeachingEvent: st.builds(
        TeachingEvent,
        vehicle=TEXT,
        connection=TEXT,
        cmd_id=UINT64,
        code=st.integers(0, 0xFFFF),
        axis=st.none() | st.sampled_from(Axis),
        position=PULSES,
        barcode=TEXT,
        at=TIME,
        number=NUMBER,
        asked_by=MAYBE,
    ),
    Proposal: st.builds(
        Proposal,
        number=NUMBER,
        side=st.sampled_from(Side),
        vehicle=TEXT,
        barcode=TEXT,
        opened=TIME,
        at=TIME,
        readings=st.lists(READINGS, max_size=3).map(tuple),
        state=st.sampled_from(ProposalState),
        why=TEXT,
        remedy=TEXT,
        warnings=NAMES,
        station=MAYBE,
        session=st.none() | NUMBER,
        asked=st.none() | UINT64,
        asked_by=MAYBE,
        collecting=st.booleans(),
        broken=TEXT,
        mode=TEXT,
        result=st.none() | SOME_PULSES,
        base=NUMBER,
        against_version=st.none() | NUMBER,
        closed=st.none() | TIME,
        closed_by=MAYBE,
        reason=TEXT,
        version=st.none() | NUMBER,
        revision=NUMBER,
    ),
    TeachingSession: st.builds(
        TeachingSession,
        number=NUMBER,
        station=TEXT,
        vehicle=TEXT,
        actor=TEXT,
        opened=TIME,
        note=TEXT,
        state=st.sampled_from(SessionState),
        ended=st.none() | TIME,
        ended_by=MAYBE,
        reason=TEXT,
    ),
    DriveOperation: st.builds(
        DriveOperation,
        number=st.integers(1, 1 << 62),
        kind=st.sampled_from(OperationKind),
        state=st.sampled_from(OperationState),
        opened=TIME,
        actor=TEXT,
        line=TEXT,
        drive=MAYBE,
        body=st.dictionaries(TEXT, JSON, max_size=3),
        done=st.integers(0, 256),
        total=st.integers(1, 256),
        closed=st.none() | TIME,
        result=st.dictionaries(TEXT, JSON, max_size=3),
        reason=TEXT,
        remedy=TEXT,
    ),
    DriveBackup: st.builds(
        DriveBackup,
        number=st.integers(1, 1 << 62),
        drive=TEXT,
        model=TEXT,
        at=TIME,
        actor=TEXT,
        note=TEXT,
        values=st.lists(st.none() | st.integers(0, 9999), max_size=256).map(tuple),
    ),
    DriveValue: st.builds(DriveValue, drive=TEXT, parameter=st.integers(0, 255), value=st.integers(0, 9999), at=TIME),
    DriveRecord: st.builds(DriveRecord, drive=TEXT, lockout=st.none() | LOCKOUTS),
    ControllerRecord: st.builds(
        ControllerRecord,
        state=st.sampled_from(ControllerState),
        reason=TEXT,
        emergencies=st.lists(EMERGENCIES, max_size=2).map(tuple),
        pauses=st.lists(PAUSES, max_size=2).map(tuple),
    ),
    DeviceRecord: st.builds(
        DeviceRecord,
        device=TEXT,
        lockout=st.none() | LOCKOUTS,
        pin=st.none() | PINS,
        lock=st.none() | BUFFER_LOCKS,
        locked=st.none() | st.booleans(),
        out_of_service=TEXT,
    ),
    Alarm: st.builds(
        Alarm,
        number=NUMBER,
        kind=st.sampled_from(AlarmKind),
        source=TEXT,
        code=TEXT,
        cause=TEXT,
        remedy=TEXT,
        begun=TIME,
        job=MAYBE,
        ended=st.none() | TIME,
        outcome=TEXT,
        acknowledged=st.none() | TIME,
        acknowledged_by=MAYBE,
        note=TEXT,
    ),
    Walk: st.builds(
        Walk,
        number=NUMBER,
        actor=TEXT,
        reason=TEXT,
        started=TIME,
        state=st.sampled_from(WalkState),
        ended=st.none() | TIME,
        ended_by=MAYBE,
    ),
    WalkPlace: st.builds(
        WalkPlace,
        walk=NUMBER,
        station=TEXT,
        believed=st.none() | st.booleans(),
        believed_carrier=MAYBE,
        seen=st.none() | st.booleans(),
        seen_carrier=MAYBE,
        by=MAYBE,
        at=st.none() | TIME,
        accepted=st.none() | st.sampled_from(Finding),
    ),
    Closure: st.builds(
        Closure,
        number=NUMBER,
        place=st.builds(ClosedPlace, kind=st.sampled_from(PlaceKind), names=NAMES),
        barcodes=NAMES,
        reason=TEXT,
        owner=TEXT,
        purpose=st.sampled_from(ClosurePurpose),
        since=TIME,
        expires=st.none() | TIME,
        state=st.sampled_from(ClosureState),
        closed=st.none() | TIME,
        releases=NAMES,
        ended=st.none() | TIME,
        ended_by=MAYBE,
    ),
    Webhook: st.builds(
        Webhook,
        number=NUMBER,
        url=TEXT,
        events=NAMES,
        secret=TEXT,
        actor=TEXT,
        created=TIME,
        note=TEXT,
        state=st.sampled_from(WebhookState),
        reason=TEXT,
        replays=NUMBER,
        old_secret=TEXT,
        old_until=st.none() | TIME,
    ),
    WebhookProgress: st.builds(
        WebhookProgress,
        webhook=NUMBER,
        position=NUMBER,
        replays=NUMBER,
        tries=NUMBER,
        delivered=NUMBER,
        last=st.none() | TIME,
        failing=st.none() | TIME,
        attempts=NUMBER,
        error=TEXT,
    ),
    WebhookTry: st.builds(
        WebhookTry,
        webhook=NUMBER,
        number=NUMBER,
        at=TIME,
        seq=st.none() | NUMBER,
        event=TEXT,
        attempt=NUMBER,
        status=st.none() | NUMBER,
        seconds=TIME,
        error=TEXT,
    ),
}


FOUND: dict[type, Callable[[Any, Kept, Reader], list[object]]] = {
    Job: lambda one, kept, reader: [reader.job(one.id), *([] if one.state in TERMINAL else [kept.jobs[0]])],
    Why: lambda one, kept, reader: [reader.why(one.order)],
    Intent: lambda one, kept, reader: [reader.intent(one.cmd_id), *([] if one.state.closed else [kept.intents[0]])],
    HistoryEvent: lambda one, kept, reader: list(reader.events()),
    AuditRow: lambda one, kept, reader: [row for _, row in reader.audit()],
    VehicleRecord: lambda one, kept, reader: list(kept.vehicles),
    StationRecord: lambda one, kept, reader: list(kept.stations),
    CarrierRecord: lambda one, kept, reader: list(kept.carriers),
    CarrierGone: lambda one, kept, reader: [one, *kept.carriers],
    StationDest: lambda one, kept, reader: [kept.dests[0], *reader.dests(one.station), *reader.all_dests()],
    VehicleOffset: lambda one, kept, reader: [kept.offsets[0], *reader.offsets(one.vehicle), *reader.all_offsets()],
    TeachingEvent: lambda one, kept, reader: list(reader.taught(vehicle=one.vehicle)),
    Proposal: lambda one, kept, reader: [reader.proposal(one.number), *([] if one.state.over else [kept.proposals[0]])],
    TeachingSession: lambda one, kept, reader: [
        reader.session(one.number),
        *([kept.sessions[0]] if one.state is SessionState.OPEN else []),
    ],
    ControllerRecord: lambda one, kept, reader: [kept.controller],
    DriveOperation: lambda one, kept, reader: [
        reader.operation(one.number),
        *reader.operations(drive=one.drive, line=one.line),
        *([kept.operations[0]] if one.state is OperationState.RUNNING else []),
    ],
    DriveBackup: lambda one, kept, reader: [reader.backup(one.number), *reader.backups(one.drive)],
    DriveValue: lambda one, kept, reader: list(kept.drive_values),
    DriveRecord: lambda one, kept, reader: list(kept.drives),
    DeviceRecord: lambda one, kept, reader: list(kept.devices),
    Alarm: lambda one, kept, reader: [
        reader.alarm(one.number),
        *reader.alarms(source=one.source, code=one.code, kind=one.kind.value),
        *([kept.alarms[0]] if one.ended is None else []),
    ],
    Walk: lambda one, kept, reader: [
        reader.walk(one.number),
        *reader.walks(),
        *([kept.walks[0]] if one.state is WalkState.OPEN else []),
    ],
    WalkPlace: lambda one, kept, reader: list(reader.walk_places(one.walk)),
    Closure: lambda one, kept, reader: [
        reader.closure(one.number),
        *reader.closures(),
        *([] if one.state.over else [kept.closures[0]]),
    ],
    Webhook: lambda one, kept, reader: [one, *kept.webhooks],
    WebhookProgress: lambda one, kept, reader: list(kept.webhook_progress),
    WebhookTry: lambda one, kept, reader: list(reader.webhook_tries(one.webhook)),
}
"""What the database says where it should say the record that was written, in every place where it can be asked."""
TABLE = {kind: table.name for kind, table in {**REPLACED, **APPENDED, CarrierGone: tables.carriers}.items()}


def test_every_record_type_has_a_row_a_statement_and_a_strategy() -> None:
    kinds = set(get_args(Record))
    assert kinds == set(ROW_OF) == {*REPLACED, *APPENDED, CarrierGone} == set(RECORDS)


@pytest.fixture(scope="module", params=["sqlite", pytest.param("postgres", marks=pytest.mark.postgres)])
def lent_url(request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """A database that one test after the other is lent: to make its tables takes as long as the examples of one test."""
    if request.param == "sqlite":
        yield f"sqlite:///{tmp_path_factory.mktemp('lent')}/plant.db"
        return
    with own_schema() as url:
        yield url


@pytest.fixture
def empty_url(lent_url: str) -> Iterator[str]:
    """The same database, without a row when the next test gets it, whatever became of this one."""
    yield lent_url
    engine = sa.create_engine(parsed(lent_url))
    with engine.begin() as connection:
        for table in reversed(tables.metadata.sorted_tables):
            connection.execute(table.delete())
    engine.dispose()


@pytest.mark.parametrize("examples", shared([15, 100], 1))
@pytest.mark.parametrize("kind", RECORDS, ids=lambda kind: kind.__name__)
def test_a_record_comes_back_equal(kind: type, examples: int, empty_url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(empty_url), Reader(empty_url)
    raw = sa.create_engine(parsed(empty_url))
    assert ledger.load().fresh

    @given(record=RECORDS[kind])
    @settings(max_examples=examples)
    def comes_back(record: Record) -> None:
        with raw.begin() as connection:
            connection.execute(tables.metadata.tables[TABLE[kind]].delete())
        ledger.commit([record])
        answers = FOUND[kind](record, ledger.load(), reader)
        assert answers
        assert all(answer == record for answer in answers)

    comes_back()
    reader.close()
    raw.dispose()
