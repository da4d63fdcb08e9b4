"""The reading side sees what is committed, from any thread, and is in nobody's way."""

import time
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor

import pytest
import sqlalchemy as sa

from app.domain.errors import StoreError
from app.domain.ids import CmdId, JobId, StationId, VehicleId
from app.domain.job import JobState
from app.domain.records import IntentState
from app.domain.units import Timestamp
from app.store.ledger import SqlLedger
from app.store.reading import KEY_SECONDS, Reader
from tests.store.conftest import Open
from tests.store.samples import audit, dest, event, intent, job, offset

DONE = JobState.COMPLETED


@pytest.fixture
def ledger(url: str, open_ledger: Open) -> SqlLedger:
    ledger = open_ledger(url)
    ledger.load()
    return ledger


@pytest.fixture
def reader(url: str, ledger: SqlLedger) -> Iterator[Reader]:
    reader = Reader(url)
    yield reader
    reader.close()


def test_a_job_is_found_by_its_id_after_it_ended_too(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([job(1, DONE), job(2)])
    assert reader.job(JobId("J1")) == job(1, DONE)
    assert reader.job(JobId("J9")) is None


def test_the_names_of_all_jobs_come_oldest_first_in_pages(ledger: SqlLedger, reader: Reader) -> None:
    assert (reader.job_count(), reader.job_names(0, 3)) == (0, [])
    ledger.commit([job(number, DONE) for number in range(1, 6)])
    assert reader.job_count() == 5
    assert reader.job_names(0, 3) == [(1, "J1"), (2, "J2"), (3, "J3")]
    assert reader.job_names(3, 3) == [(4, "J4"), (5, "J5")]


def test_jobs_come_newest_first_in_pages(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([job(number) for number in range(1, 8)])
    page = reader.jobs(limit=3)
    assert [one.order for one in page] == [7, 6, 5]
    assert [one.order for one in reader.jobs(after=5, limit=3)] == [4, 3, 2]
    assert reader.jobs(after=1) == []


def test_jobs_are_filtered_by_state_carrier_and_vehicle_together(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit(
        [
            job(1, DONE, carrier="A", vehicle="V1"),
            job(2, DONE, carrier="A", vehicle="V2"),
            job(3, carrier="A", vehicle="V1"),
            job(4, DONE, carrier="B", vehicle="V1"),
        ]
    )
    assert [one.order for one in reader.jobs(state="completed")] == [4, 2, 1]
    assert [one.order for one in reader.jobs(carrier="A")] == [3, 2, 1]
    assert [one.order for one in reader.jobs(vehicle="V1")] == [4, 3, 1]
    assert [one.order for one in reader.jobs(state="completed", carrier="A", vehicle="V1")] == [1]


def test_an_idempotency_key_names_its_job_for_seven_days(ledger: SqlLedger, reader: Reader) -> None:
    week_ago = time.time() - KEY_SECONDS
    young, old = Timestamp(week_ago + 600), Timestamp(week_ago - 600)
    ledger.commit(
        [
            job(1, idempotency_key="old", created=old),
            job(2, idempotency_key="both", created=old),
            job(3, DONE, idempotency_key="both", created=young),
        ]
    )
    assert reader.job_by_key("old") is None
    assert reader.job_by_key("none") is None
    found = reader.job_by_key("both")
    assert found is not None
    assert found.order == 3


def test_events_come_in_order_after_a_number(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([event(1, "J1"), event(2, "J2", "V1"), event(3, "J1", "V1"), event(4)])
    assert [one.seq for one in reader.events()] == [1, 2, 3, 4]
    assert [one.seq for one in reader.events(after=1, limit=2)] == [2, 3]
    assert [one.seq for one in reader.events(job="J1")] == [1, 3]
    assert [one.seq for one in reader.events(vehicle="V1", job="J1")] == [3]


def test_commands_are_found_by_id_and_by_vehicle(ledger: SqlLedger, reader: Reader) -> None:
    theirs = (1 << 63) + 5
    ledger.commit([intent(1, IntentState.DONE), intent(2), intent(theirs)])
    assert reader.intent(CmdId(theirs)) == intent(theirs)
    assert reader.intent(CmdId(7)) is None
    assert [one.cmd_id for one in reader.intents(VehicleId("V1"), limit=2)] == [2, 1]
    assert reader.intents(VehicleId("V2")) == []


def test_the_audit_is_numbered_and_comes_in_order(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([audit("a"), audit("b")])
    ledger.commit([audit("c")])
    rows = reader.audit()
    assert [row.action for _, row in rows] == ["a", "b", "c"]
    assert reader.audit(after=rows[1][0]) == rows[2:]
    assert reader.audit(limit=1) == rows[:1]


def test_every_version_of_a_teaching_is_there_oldest_first(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([dest(2), dest(1), offset(1), offset(2)])
    assert reader.dests(StationId("S1")) == [dest(1), dest(2)]
    assert reader.offsets(VehicleId("V1")) == [offset(1), offset(2)]
    assert reader.dests(StationId("S9")) == []


def test_what_is_not_committed_is_not_seen_and_nobody_waits(ledger: SqlLedger, reader: Reader) -> None:
    ledger.commit([job(1)])
    with ledger._transaction("a long one") as connection:
        connection.execute(sa.text("UPDATE jobs SET priority = 1"))
        with ThreadPoolExecutor(3) as pool:
            seen = [future.result(10) for future in [pool.submit(reader.job, JobId("J1")) for _ in range(9)]]
        assert seen == [job(1)] * 9
    found = reader.job(JobId("J1"))
    assert found is not None
    assert found.priority == 1


def test_readers_in_many_threads_see_a_writer_at_work(ledger: SqlLedger, reader: Reader) -> None:
    with ThreadPoolExecutor(4) as pool:
        futures = []
        for number in range(1, 30):
            ledger.commit([event(number)])
            futures.append(pool.submit(reader.events))
        for least, future in enumerate(futures, start=1):
            assert len(future.result(10)) >= least


def test_the_reading_side_cannot_write(reader: Reader) -> None:
    with pytest.raises(sa.exc.DBAPIError, match=r"read-?only"), reader._engine.begin() as connection:
        connection.execute(sa.text("UPDATE plant SET epoch = 0"))


def test_a_database_without_tables_is_said_to_be_unreadable(url: str) -> None:
    reader = Reader(url)
    with pytest.raises(StoreError, match="cannot be read"):
        reader.job(JobId("J1"))
    reader.close()


@pytest.mark.parametrize(
    ("query", "index"),
    [
        ("carrier = 'A' ORDER BY number DESC", "ix_jobs_carrier_number"),
        ("vehicle = 'V1' ORDER BY number DESC", "ix_jobs_vehicle_number"),
        ("idempotency_key = 'k'", "ix_jobs_idempotency_key"),
        ("state NOT IN ('aborted', 'cancelled', 'completed', 'failed') ORDER BY number", "ix_jobs_going_on"),
    ],
)
def test_an_index_serves_what_is_asked_often(query: str, index: str, sqlite_url: str, open_ledger: Open) -> None:
    open_ledger(sqlite_url)
    with sa.create_engine(sqlite_url).connect() as connection:
        plan = connection.execute(sa.text(f"EXPLAIN QUERY PLAN SELECT * FROM jobs WHERE {query}")).all()
    assert index in str(plan)
