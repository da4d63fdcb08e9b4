"""What the ledger promises: whole batches, durable, in order, once."""

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from typing import Any

import pytest
import sqlalchemy as sa

from app.domain.errors import PlantHeld, StoreError, StoreRefused
from app.domain.ids import CarrierId, JobId, StationId
from app.domain.job import TERMINAL, JobState
from app.domain.records import (
    CarrierGone,
    CarrierRecord,
    ControllerRecord,
    ControllerState,
    IntentState,
    Provenance,
    Record,
)
from app.domain.units import Seconds, Timestamp
from app.domain.why import Why
from app.store.ledger import EPOCH_ZERO, SqlLedger
from app.store.reading import Reader
from tests.store.conftest import Open
from tests.store.samples import audit, dest, event, intent, job, offset, taught


def carrier(name: str, place: str) -> CarrierRecord:
    return CarrierRecord(CarrierId(name), StationId(place), Provenance.HOST, Timestamp(1.0))


def test_an_empty_database_is_fresh_until_the_first_commit(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    assert ledger.load().fresh
    assert ledger.load().fresh
    ledger.commit([audit("start")])
    assert not ledger.load().fresh


def test_each_load_raises_the_epoch_also_over_a_restart(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    epochs = [ledger.load().epoch, ledger.load().epoch]
    ledger.close()
    epochs.append(open_ledger(url).load().epoch)
    assert epochs == [1, 2, 3]


def test_a_restored_backup_starts_with_an_epoch_never_used(sqlite_url: str, open_ledger: Open) -> None:
    ledger = open_ledger(sqlite_url, now=EPOCH_ZERO + 5_000.5)
    assert ledger.load().epoch == 5_000
    assert ledger.load().epoch == 5_001


def test_a_wall_clock_beyond_reason_does_not_use_the_epochs_up(sqlite_url: str, open_ledger: Open) -> None:
    assert open_ledger(sqlite_url, now=5e9).load().epoch == 1


def test_a_restart_gets_what_goes_on_and_no_more(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    jobs = [job(number, state) for number, state in enumerate(JobState, start=1)]
    intents = [intent(number, state) for number, state in enumerate(IntentState, start=1)]
    ledger.commit([*jobs, *intents, *(event(seq) for seq in range(1, 8))])
    kept = ledger.load()
    assert list(kept.jobs) == [one for one in jobs if one.state not in TERMINAL]
    assert [one.state for one in kept.intents] == [IntentState.OPEN, IntentState.UNKNOWN]
    assert (kept.next_order, kept.next_event) == (len(jobs) + 1, 8)
    assert kept.controller == ControllerRecord(ControllerState.AUTO)


def test_a_restart_gets_the_why_of_jobs_that_go_on_and_the_rest_stays_to_be_read(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    live = Why(1, JobId("J1")).waiting("no vehicle is free", Timestamp(5.0))
    over = Why(2, JobId("J2")).waiting("S1 is empty", Timestamp(6.0)).waiting("", Timestamp(7.0))
    ledger.commit([job(1), job(2, JobState.COMPLETED), live, over])
    assert ledger.load().whys == (live,)
    reader = Reader(url)
    assert (reader.why(2), reader.why(3)) == (over, None)
    reader.close()


def test_a_record_replaces_the_row_of_its_key(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    paused = ControllerRecord(ControllerState.PAUSED, "fire drill")
    ledger.commit([job(1), ControllerRecord(ControllerState.PAUSING), job(1, JobState.WAITING), paused])
    ledger.commit([job(1, JobState.TRANSFERRING)])
    ledger.commit([job(1, JobState.TRANSFERRING)])
    kept = ledger.load()
    assert kept.jobs == (job(1, JobState.TRANSFERRING),)
    assert kept.controller == paused


@pytest.mark.parametrize("apart", [False, True])
def test_a_carrier_that_left_and_came_back_is_there_and_the_other_way_round(
    apart: bool, url: str, open_ledger: Open
) -> None:
    ledger = open_ledger(url)
    ledger.load()
    back, gone = carrier("A", "S2"), CarrierGone(CarrierId("B"))
    records: list[Record] = [carrier("A", "S1"), CarrierGone(CarrierId("A")), back, carrier("B", "S1"), gone]
    for batch in [[record] for record in records] if apart else [records]:
        ledger.commit(batch)
    assert ledger.load().carriers == (back,)


def test_the_newest_version_of_each_teaching_is_kept(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([dest(1), dest(2), offset(1)])
    ledger.commit([dest(3), offset(2)])
    kept = ledger.load()
    assert kept.dests == (dest(3),)
    assert kept.offsets == (offset(2),)


def test_a_teaching_event_sent_again_is_one_row(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([taught(1 << 63), taught(1 << 63, at=2.0)])
    ledger.commit([taught(1 << 63, at=3.0), taught((1 << 63) + 1)])
    reader = Reader(url)
    assert reader.taught(vehicle="V1") == [taught(1 << 63), taught((1 << 63) + 1)]
    reader.close()


@pytest.mark.parametrize("many", [1, 3, 500])
def test_events_come_back_in_order_however_many_are_kept_at_once(url: str, open_ledger: Open, many: int) -> None:
    ledger = open_ledger(url)
    ledger.load()
    events = [replace(event(seq, job="J\t1", vehicle="V\\N"), detail="a\nb\\.") for seq in range(1, many + 1)]
    ledger.commit(events)
    reader = Reader(url)
    assert reader.events(0, 1000) == events
    reader.close()


def test_a_carrier_that_only_left_in_the_end_leaves_nothing_to_write_of_it(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    carried = CarrierRecord(CarrierId("A"), StationId("S1"), Provenance.HOST, Timestamp(1.0))
    ledger.commit([carried, CarrierGone(CarrierId("A"))])
    assert ledger.load().carriers == ()
    ledger.commit([CarrierGone(CarrierId("A")), carried])
    assert ledger.load().carriers == (carried,)


def test_many_events_one_of_which_holds_what_no_database_keeps_are_kept(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([replace(event(seq), detail="a\0b" if seq == 7 else "") for seq in range(1, 20)])
    reader = Reader(url)
    assert [len(one.detail) for one in reader.events(5, 3)] == [0, 3, 0]
    reader.close()


def test_many_events_with_a_number_used_before_are_refused_whole(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([event(30)])
    with pytest.raises(StoreRefused):
        ledger.commit([event(seq) for seq in range(11, 40)])
    ledger.commit([event(seq) for seq in range(31, 60)])
    reader = Reader(url)
    assert len(reader.events(0, 1000)) == 30
    reader.close()


def test_events_are_deleted_when_they_are_old_in_slices_but_never_the_last(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url, now=1000.0, keep=Seconds(980.0))
    ledger.load()
    ledger.commit([event(seq) for seq in range(1, 101)])
    assert [ledger.prune(25) for _ in range(4)] == [25, 25, 9, 0]  # event(60) is of 20 s
    reader = Reader(url)
    assert [one.seq for one in reader.events(0, 2)] == [60, 61]
    ledger.close()
    later = open_ledger(url, now=1_000_000.0, keep=Seconds(1.0))
    assert later.load().next_event == 101
    assert [later.prune(30) for _ in range(3)] == [30, 10, 0]
    assert [one.seq for one in reader.events(0, 2)] == [100]
    later.close()
    assert open_ledger(url).load().next_event == 101
    reader.close()


def test_events_are_kept_for_ever_unless_an_age_is_set(sqlite_url: str, open_ledger: Open) -> None:
    ledger = open_ledger(sqlite_url, now=1e9)
    ledger.load()
    ledger.commit([event(1), event(2)])
    assert ledger.prune(10) == 0


def test_a_batch_with_a_number_used_before_is_refused_whole(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([event(1)])
    with pytest.raises(StoreRefused, match="cannot be kept"):
        ledger.commit([job(1), event(1)])
    assert ledger.load().jobs == ()
    ledger.commit([job(1), event(2)])
    assert len(ledger.load().jobs) == 1


@pytest.mark.parametrize("body", [{"at": {1, 2}}, {"at": float("nan")}])
def test_a_body_that_json_cannot_say_is_refused(body: dict[str, Any], sqlite_url: str, open_ledger: Open) -> None:
    ledger = open_ledger(sqlite_url)
    ledger.load()
    with pytest.raises(StoreRefused, match="a record cannot be kept"):
        ledger.commit([replace(intent(1), body=body)])


def test_text_that_no_database_keeps_is_kept_with_its_symbol(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    ledger.commit([job(1, reason="half \ud800 and \U0001f600\0")])
    (kept,) = ledger.load().jobs
    assert kept.reason == "half \ufffd and \U0001f600\u2400"


def test_nothing_is_added_before_what_is_kept_is_known(sqlite_url: str, open_ledger: Open) -> None:
    with pytest.raises(StoreError, match="not loaded"):
        open_ledger(sqlite_url).commit([event(1)])


def test_a_database_keeps_one_plant(url: str, open_ledger: Open) -> None:
    open_ledger(url, plant="north").close()
    with pytest.raises(StoreError, match="keeps plant north, not south"):
        open_ledger(url, plant="south")
    open_ledger(url, plant="north")


def test_a_database_in_memory_keeps_a_plant_for_one_ledger(open_ledger: Open) -> None:
    ledger = open_ledger("sqlite://")
    other = open_ledger("sqlite://")
    other.load()
    ledger.load()
    ledger.commit([job(1)])
    ledger.renew()
    assert ledger.load().jobs == (job(1),)
    assert other.load().jobs == ()
    with pytest.raises(StoreError, match="in memory"):
        Reader("sqlite://")


def test_a_full_disk_is_trouble_and_the_same_batch_goes_in_when_there_is_room(
    sqlite_url: str, open_ledger: Open
) -> None:
    ledger = open_ledger(sqlite_url)
    ledger.load()
    batch = [job(number, reason="x" * 500) for number in range(1, 200)]
    _pragma(ledger, "max_page_count = 1")
    with pytest.raises(StoreError, match="full") as caught:
        ledger.commit(batch)
    assert not isinstance(caught.value, StoreRefused)
    assert caught.value.remedy == "Make room on the disk."
    _pragma(ledger, "max_page_count = 100000")
    ledger.commit(batch)
    assert len(ledger.load().jobs) == 199


def _pragma(ledger: SqlLedger, words: str) -> None:
    with ledger._transaction("pragma") as connection:
        connection.exec_driver_sql(f"PRAGMA {words}")


@contextmanager
def _answer_lost(ledger: SqlLedger) -> Iterator[None]:
    """Let commits happen without their caller hearing of it."""

    def commit(connection: sa.Connection) -> None:
        driver = connection.connection.driver_connection
        assert driver is not None
        driver.commit()
        raise sa.exc.OperationalError("COMMIT", None, Exception("connection lost"))

    sa.event.listen(ledger._engine, "commit", commit)
    yield
    sa.event.remove(ledger._engine, "commit", commit)


def test_a_batch_whose_commit_was_not_answered_is_written_once(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    with _answer_lost(ledger), pytest.raises(StoreError, match="connection lost"):
        ledger.commit([event(1), audit("once")])
    ledger.commit([event(1), audit("once")])
    ledger.commit([event(2)])
    reader = Reader(url)
    assert [row.action for _, row in reader.audit()] == ["once"]
    assert reader.events() == [event(1), event(2)]
    reader.close()


def test_another_batch_after_an_unanswered_commit_is_added_to_it(url: str, open_ledger: Open) -> None:
    ledger = open_ledger(url)
    ledger.load()
    with _answer_lost(ledger), pytest.raises(StoreError):
        ledger.commit([event(1)])
    ledger.commit([event(2)])
    ledger.commit([event(3)])
    assert ledger.load().next_event == 4


def test_a_ledger_whose_database_somebody_else_has_loaded_writes_no_more(
    url: str, open_ledger: Open, raw: sa.Engine
) -> None:
    ledger = open_ledger(url)
    ledger.load()
    with raw.begin() as connection:
        connection.execute(sa.text("UPDATE plant SET epoch = epoch + 1"))
    with pytest.raises(PlantHeld, match="another controller has started"):
        ledger.commit([event(1)])


@pytest.mark.postgres
def test_a_connection_cut_by_the_server_is_made_anew(postgres_url: str, open_ledger: Open) -> None:
    ledger = open_ledger(postgres_url)
    ledger.load()
    pid = _backend(ledger)
    admin = sa.create_engine(sa.make_url(postgres_url).set(drivername="postgresql+psycopg"))
    with admin.begin() as connection:
        connection.execute(sa.select(sa.func.pg_terminate_backend(pid, 5000)))
    admin.dispose()
    with pytest.raises(StoreError, match="cannot be kept"):
        ledger.commit([job(1)])
    ledger.commit([job(1)])
    assert [one.id for one in ledger.load().jobs] == [JobId("J1")]


def _backend(ledger: SqlLedger) -> int:
    with ledger._transaction("asking") as connection:
        return int(connection.execute(sa.select(sa.func.pg_backend_pid())).scalar_one())
