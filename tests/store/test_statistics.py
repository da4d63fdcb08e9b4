"""Periods, put together by the database."""

from dataclasses import replace

from app.domain.ids import JobId, VehicleId
from app.domain.job import JobState
from app.domain.records import HistoryEvent, Record
from app.domain.statistics import Phase, Queued, Waited
from app.domain.units import Timestamp
from app.domain.why import Wait, Why
from app.store.reading import Reader
from tests.store.conftest import Open
from tests.store.samples import job

DAY = 86_400.0


def at(moment: float) -> Timestamp:
    return Timestamp(10 * DAY + moment)


def story() -> list[Record]:
    """Return job 1, done at 90 after a change of vehicle, job 2 cancelled at 50, job 3 waiting, and events of a day before."""
    told = [
        (-DAY, "ControllerAuto", None),
        (10, "VehicleAssigned", "J1"),
        (20, "VehicleAssigned", "J1"),
        (40, "VehicleAcquireStarted", "J1"),
        (45, "VehicleAcquireCompleted", "J1"),
        (50, "TransferCancelCompleted", "J2"),
        (80, "VehicleDepositStarted", "J1"),
        (88, "VehicleDepositCompleted", "J1"),
        (90, "TransferCompleted", "J1"),
    ]
    events = [
        HistoryEvent(n, at(moment), name, 0, JobId(about) if about else None, None, VehicleId("V1"))
        for n, (moment, name, about) in enumerate(told, 1)
    ]
    done = job(
        1, JobState.COMPLETED, created=at(0), assigned=at(10), picked=at(45), ended=at(90), vehicle=VehicleId("V1")
    )
    cancelled = job(2, JobState.CANCELLED, created=at(5), ended=at(50))
    why = Why(3, JobId("J3"), (), (Wait(at(61), "no vehicle is free", at(70)), Wait(at(70), "P1 is empty")))
    return [*events, done, cancelled, job(3, created=at(60)), why]


def test_a_transfer_has_the_last_moment_of_each_kind(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    ledger.commit(story())
    first, second = reader.transfers(at(0), at(100))
    assert (first.job, first.state, first.vehicle, first.ended) == ("J1", "completed", "V1", at(90))
    assert {phase.value: first.seconds(phase) for phase in Phase} == {
        "queued": 20,
        "fetching": 20,
        "acquiring": 5,
        "carrying": 35,
        "depositing": 8,
        "total": 90,
    }
    assert (second.job, second.state, second.assigned) == ("J2", "cancelled", None)
    assert [one.job for one in reader.transfers(at(50), at(90))] == ["J2"]
    assert reader.transfers(at(100), at(200)) == []
    reader.close()


def test_events_are_counted_and_jobs_found_by_their_moments(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    assert reader.event_count(at(0), at(100)) == 0
    assert reader.transfers(at(0), at(100)) == []
    ledger.commit(story())
    assert [reader.event_count(at(a), at(b)) for a, b in ((0, 100), (20, 50), (90, 91), (91, 99))] == [8, 3, 1, 0]
    assert reader.queued(at(0), at(100)) == [Queued(at(0), at(10)), Queued(at(5), at(50)), Queued(at(60), None)]
    assert reader.queued(at(20), at(60)) == [Queued(at(5), at(50))]
    waits, jobs = reader.waits(at(0), at(100))
    assert (waits, jobs) == (
        [Waited(at(61), at(70), "no vehicle is free", "J3"), Waited(at(70), None, "P1 is empty", "J3")],
        1,
    )
    assert reader.waits(at(0), at(60)) == ([], 0)
    assert reader.waits_named(["J3", "J9"]) == waits
    assert reader.waits_named([]) == []
    reader.close()


def test_what_was_open_at_a_moment_has_what_it_waited_for_then(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    assert reader.open_jobs(at(100)) == []
    ledger.commit(story())
    assert [(one.job, one.reason) for one in reader.open_jobs(at(40))] == [("J1", ""), ("J2", "")]
    assert [(one.job, one.reason) for one in reader.open_jobs(at(65))] == [("J1", ""), ("J3", "no vehicle is free")]
    (last,) = reader.open_jobs(at(100))
    assert (last.job, last.created, last.reason) == ("J3", at(60), "P1 is empty")
    reader.close()


def test_numbers_with_gaps_are_found_too(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    ledger.commit([replace(row, seq=row.seq**3) for row in story() if isinstance(row, HistoryEvent)])
    assert reader.event_count(at(40), at(80)) > 0
    reader.close()


def test_events_of_a_period_are_found_by_name_and_from_either_end(url: str, open_ledger: Open) -> None:
    ledger, reader = open_ledger(url), Reader(url)
    ledger.load()
    assert reader.happened(at(0), at(100)) == []
    ledger.commit(story())
    all_of_them = [event.seq for event in reader.happened(at(0), at(100))]
    assert len(all_of_them) == 8
    assert [event.seq for event in reader.happened(at(0), at(100), limit=2)] == all_of_them[:2]
    assert [event.seq for event in reader.happened(at(0), at(100), newest=True, limit=2)] == all_of_them[-2:]
    assert len(reader.happened(at(20), at(50))) == 3
    names = {event.event for event in reader.happened(at(0), at(100), named={"VehicleAssigned"})}
    assert names == {"VehicleAssigned"}
    reader.close()
