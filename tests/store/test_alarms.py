"""Lists and sums of alarms, on every database."""

from dataclasses import replace

from app.domain.alarms import Alarm, AlarmKind
from app.domain.units import Timestamp
from app.store.reading import Reader
from tests.store.conftest import Open


def alarm(number: int, begun: float, ended: float | None, **more: object) -> Alarm:
    row = Alarm(number, AlarmKind.VEHICLE, "V1", "101", "c", "r", Timestamp(begun))
    return replace(row, ended=None if ended is None else Timestamp(ended), **more)  # type: ignore[arg-type]


ROWS = [
    alarm(1, 0, 10),
    alarm(2, 5, 25, source="V2"),
    alarm(3, 30, 40, code="202"),
    alarm(4, 50, None, kind=AlarmKind.LINK, code="silent"),
    alarm(5, 60, 70, kind=AlarmKind.HOLD, code="held", acknowledged=Timestamp(65), acknowledged_by="kim"),
]


def test_alarms_are_listed_by_what_is_asked(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    ledger.commit(ROWS)

    def numbers(**asked: object) -> list[int]:
        return [row.number for row in reader.alarms(**asked)]  # type: ignore[arg-type]

    assert numbers() == [5, 4, 3, 2, 1]
    assert numbers(after=4, limit=2) == [3, 2]
    assert numbers(source="V2") == [2]
    assert numbers(kind="link", code="silent") == [4]
    assert (numbers(active=True), numbers(active=False)) == ([4], [5, 3, 2, 1])
    assert (numbers(acknowledged=True), numbers(acknowledged=False)) == ([5], [4, 3, 2, 1])
    assert numbers(begin=10, end=50) == [3, 2, 1]
    assert numbers(begin=100) == [4]
    reader.close()


def test_alarms_are_counted_within_the_period_alone(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    ledger.commit(ROWS)
    found = reader.alarm_counts(("code",), 8.0, 56.0)
    assert [(row.about["code"], row.times, row.seconds) for row in found] == [
        ("101", 2, 19.0),
        ("202", 1, 10.0),
        ("silent", 1, 6.0),
    ]
    both = reader.alarm_counts(("kind", "source", "code"), 0.0, 100.0, limit=1)
    assert [(row.about, row.seconds) for row in both] == [({"kind": "link", "source": "V1", "code": "silent"}, 50.0)]
    assert reader.failures(0.0, 100.0) == [("V1", 0.0, 10.0), ("V2", 5.0, 25.0), ("V1", 30.0, 40.0), ("V1", 60.0, 70.0)]
    assert reader.failures(26.0, 31.0) == [("V1", 30.0, 40.0)]
    reader.close()
