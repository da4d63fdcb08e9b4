"""Operations, backups and values of drives, as asked for in pages and as a restart needs them."""

from app.domain.drive import DriveId, Parameter, RawValue
from app.domain.drive_records import (
    DriveBackup,
    DriveOperation,
    DriveValue,
    OperationKind,
    OperationState,
)
from app.domain.ids import Actor, LinkId
from app.domain.units import Timestamp
from app.store.reading import Reader
from tests.store.conftest import Open

KIM, D1, D2, LINE = Actor("kim"), DriveId("D1"), DriveId("D2"), LinkId("AXES")
AT = Timestamp(1.0)


def operation(number: int, drive: DriveId | None = D1, state: OperationState = OperationState.DONE) -> DriveOperation:
    return DriveOperation(number, OperationKind.READ, state, AT, KIM, LINE, drive)


def backup(number: int, drive: DriveId = D1) -> DriveBackup:
    return DriveBackup(number, drive, "HI-1", AT, KIM, "", (RawValue(number), None))


def test_operations_come_newest_first_in_pages_by_drive_and_line(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    ledger.commit([operation(1), operation(2, D2), operation(3, None), operation(4)])
    assert [one.number for one in reader.operations(limit=2)] == [4, 3]
    assert [one.number for one in reader.operations(after=3)] == [2, 1]
    assert [one.number for one in reader.operations(drive="D1")] == [4, 1]
    assert [one.number for one in reader.operations(line="AXES", after=4, limit=2)] == [3, 2]
    assert reader.operations(line="OTHER") == []
    assert reader.operation(9) is None
    reader.close()


def test_backups_come_newest_first_in_pages(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    ledger.commit([backup(1), backup(2, D2), backup(3), backup(5)])
    assert [one.number for one in reader.backups(D1, limit=2)] == [5, 3]
    assert [one.number for one in reader.backups(D1, after=3)] == [1]
    assert reader.backup(2) == backup(2, D2)
    assert reader.backup(9) is None
    reader.close()


def test_a_restart_gets_what_had_not_ended_the_newest_values_and_the_next_number(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    running = operation(7, state=OperationState.RUNNING)
    first, second = (DriveValue(D1, Parameter(28), RawValue(raw), AT) for raw in (1, 2))
    other = DriveValue(D1, Parameter(29), RawValue(3), AT)
    ledger.commit([operation(6, state=OperationState.RUNNING), running, first, other])
    ledger.commit([operation(6), second])
    kept = ledger.load()
    assert kept.operations == (running,)
    assert kept.next_operation == 8
    assert kept.drive_values == (second, other)


def test_of_several_values_in_one_batch_the_last_of_each_parameter_is_kept(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    values = [
        DriveValue(drive, Parameter(number), RawValue(raw), AT)
        for raw in (1, 2)
        for drive in (D1, D2)
        for number in (5, 6)
    ]
    ledger.commit(values)
    assert [(one.drive, one.parameter, one.value) for one in ledger.load().drive_values] == [
        ("D1", 5, 2),
        ("D1", 6, 2),
        ("D2", 5, 2),
        ("D2", 6, 2),
    ]
