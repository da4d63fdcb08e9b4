"""The group-commit thread: order, retry, the lease, and the end."""

import itertools
import math
import queue
import threading
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path

import pytest

from app.domain.errors import PlantHeld, StoreError, StoreRefused
from app.domain.ids import Epoch
from app.domain.records import ControllerRecord, ControllerState, HistoryEvent, Kept, Record
from app.domain.units import Seconds, Timestamp
from app.runtime.writer import PRUNE_EVERY, SLICE, Writer
from app.store.ledger import SqlLedger
from app.store.reading import Reader

BOUND = 20.0
"""Seconds after which a test gives up waiting for a thread."""


def record(name: object) -> Record:
    return ControllerRecord(ControllerState.AUTO, str(name))


class ScriptedLedger:
    """A ledger in a list. ``errors`` are raised by the next commits and renewals, first to last; ``gate`` shut holds it up."""

    def __init__(self, lease_seconds: float = math.inf) -> None:
        self.lease_seconds = Seconds(lease_seconds)
        self.committed: list[list[Record]] = []
        self.errors: list[Exception] = []
        self.gate = threading.Event()
        self.gate.set()
        self.entered = threading.Event()
        self.renewals = 0
        self.old = 0
        self.prune_errors: list[Exception] = []
        self.slices: list[int] = []
        self.pruned = threading.Event()
        self.renewed = threading.Event()

    def load(self) -> Kept:
        return Kept(Epoch(1))

    def commit(self, batch: Sequence[Record]) -> None:
        self.entered.set()
        assert self.gate.wait(BOUND)
        self._fail()
        self.committed.append(list(batch))

    def renew(self) -> None:
        self._fail()
        self.renewals += 1
        self.renewed.set()

    def prune(self, most: int) -> int:
        if self.prune_errors:
            raise self.prune_errors.pop(0)
        deleted = min(most, self.old)
        self.old -= deleted
        self.slices.append(deleted)
        self.pruned.set()
        return deleted

    def close(self) -> None:
        pass

    def _fail(self) -> None:
        if self.errors:
            raise self.errors.pop(0)


class Heard:
    """What a writer said, in order: ("durable", 3), ("trouble", "..."), ("lost", "...")."""

    def __init__(self) -> None:
        self._said: queue.Queue[tuple[str, object]] = queue.Queue()

    def hears(self, what: str) -> Callable[[object], None]:
        return lambda value: self._said.put((what, value))

    def next(self) -> tuple[str, object]:
        return self._said.get(timeout=BOUND)

    def rest(self) -> list[tuple[str, object]]:
        return [self._said.get_nowait() for _ in range(self._said.qsize())]


class Bench:
    """A writer on a scripted ledger."""

    def __init__(self, lease_seconds: float = math.inf, clock: Callable[[], float] = lambda: 0.0) -> None:
        self.ledger = ScriptedLedger(lease_seconds)
        self.heard = Heard()
        self.writer = Writer(
            self.ledger,
            self.heard.hears("durable"),
            on_trouble=self.heard.hears("trouble"),
            on_lost=self.heard.hears("lost"),
            clock=clock,
            pauses=(0.0, 0.001),
        )


@pytest.fixture
def bench() -> Iterator[Bench]:
    bench = Bench()
    bench.writer.start()
    yield bench
    bench.ledger.gate.set()
    bench.writer.close()


def test_a_batch_is_delivered_once_it_is_durable(bench: Bench) -> None:
    bench.ledger.gate.clear()
    bench.writer.submit(1, [record("a")])
    assert bench.ledger.entered.wait(BOUND)
    assert bench.heard.rest() == []
    bench.ledger.gate.set()
    assert bench.heard.next() == ("durable", 1)
    assert bench.ledger.committed == [[record("a")]]


def test_what_waits_together_is_one_transaction_in_order(bench: Bench) -> None:
    bench.ledger.gate.clear()
    bench.writer.submit(1, [record("a")])
    assert bench.ledger.entered.wait(BOUND)
    for number in range(2, 6):
        bench.writer.submit(number, [record(number), record(-number)])
    bench.ledger.gate.set()
    assert [bench.heard.next(), bench.heard.next()] == [("durable", 1), ("durable", 5)]
    assert bench.ledger.committed[1] == [record(sign * number) for number in range(2, 6) for sign in (1, -1)]


def test_a_batch_without_records_is_delivered_in_its_turn_without_a_transaction(bench: Bench) -> None:
    bench.writer.submit(1, [])
    assert bench.heard.next() == ("durable", 1)
    assert bench.ledger.committed == []


def test_trouble_is_told_and_the_same_batch_is_tried_until_it_is_in(bench: Bench) -> None:
    bench.ledger.errors = [StoreError("disk full", remedy="Make room."), StoreError("disk full"), StoreError("gone")]
    bench.writer.submit(1, [record("a")])
    said = [bench.heard.next() for _ in range(5)]
    assert said == [
        ("trouble", "disk full. Make room."),
        ("trouble", "disk full."),
        ("trouble", "gone."),
        ("trouble", ""),
        ("durable", 1),
    ]
    assert bench.ledger.committed == [[record("a")]]
    bench.writer.submit(2, [record("b")])
    assert bench.heard.next() == ("durable", 2)


@pytest.mark.parametrize(
    "end", [PlantHeld("held by B", remedy="Stop it."), StoreRefused("held by B", remedy="Stop it.")]
)
def test_a_lost_plant_or_a_record_that_cannot_be_kept_is_the_end(bench: Bench, end: StoreError) -> None:
    bench.ledger.errors = [end]
    bench.writer.submit(1, [record("a")])
    assert bench.heard.next() == ("lost", "held by B. Stop it.")
    bench.writer.submit(2, [record("b")])
    bench.writer.close()
    assert bench.heard.rest() == []
    assert bench.ledger.committed == []


def test_closing_drains_what_waits(bench: Bench) -> None:
    bench.ledger.gate.clear()
    for number in range(1, 4):
        bench.writer.submit(number, [record(number)])
    bench.ledger.gate.set()
    bench.writer.close()
    bench.writer.close()
    assert [record for batch in bench.ledger.committed for record in batch] == [record(n) for n in (1, 2, 3)]
    assert bench.heard.rest()[-1] == ("durable", 3)


def test_closing_in_trouble_gives_up_and_delivers_nothing(bench: Bench) -> None:
    bench.ledger.errors = [StoreError("gone") for _ in range(100_000)]
    bench.writer.submit(1, [record("a")])
    assert bench.heard.next() == ("trouble", "gone.")
    bench.writer.close()
    assert set(bench.heard.rest()) <= {("trouble", "gone.")}
    assert bench.ledger.committed == []


def test_a_writer_that_was_never_started_closes() -> None:
    Bench().writer.close()


def test_old_events_are_deleted_in_slices_between_commits() -> None:
    moments = itertools.count(step=30.0)
    bench = Bench(clock=lambda: next(moments))
    bench.ledger.old = 2 * SLICE + 7
    bench.writer.start()
    while sum(bench.ledger.slices) < 2 * SLICE + 7:
        assert bench.ledger.pruned.wait(BOUND)
        bench.ledger.pruned.clear()
    bench.writer.close()
    assert bench.ledger.slices[:3] == [SLICE, SLICE, 7]


def test_commits_go_before_old_events_and_no_slice_is_deleted_before_its_time() -> None:
    moments = iter([0.0, *([PRUNE_EVERY - 0.01] * 4), *([PRUNE_EVERY] * 1000)])
    bench = Bench(clock=lambda: next(moments))
    bench.writer.submit(1, [record("a")])
    bench.writer.start()
    assert bench.heard.next() == ("durable", 1)
    assert bench.ledger.pruned.wait(BOUND)
    bench.writer.close()
    assert bench.ledger.committed == [[record("a")]]
    assert bench.ledger.slices == [0]


def test_what_cannot_be_deleted_now_is_no_trouble_and_a_lost_plant_is_the_end() -> None:
    moments = itertools.count(step=PRUNE_EVERY)
    bench = Bench(clock=lambda: next(moments))
    bench.ledger.prune_errors = [StoreError("busy"), PlantHeld("held by B")]
    bench.writer.start()
    assert bench.heard.next() == ("lost", "held by B.")
    bench.writer.close()
    assert not bench.ledger.slices


def test_an_idle_writer_renews_the_lease() -> None:
    moments = itertools.count(step=10.0)
    bench = Bench(lease_seconds=40.0, clock=lambda: next(moments))
    bench.writer.start()
    assert bench.ledger.renewed.wait(BOUND)
    bench.writer.close()
    assert bench.ledger.committed == []
    assert bench.heard.rest() == []


def test_batches_without_records_do_not_keep_the_lease_from_being_renewed() -> None:
    moments = itertools.count(step=10.0)
    bench = Bench(lease_seconds=40.0, clock=lambda: next(moments))
    bench.writer.submit(1, [])
    bench.writer.start()
    assert bench.heard.next() == ("durable", 1)
    assert bench.ledger.renewals > 0
    bench.writer.close()


def test_a_plant_lost_while_idle_is_told() -> None:
    moments = itertools.count(step=10.0)
    bench = Bench(lease_seconds=40.0, clock=lambda: next(moments))
    bench.ledger.errors = [StoreError("gone"), PlantHeld("its lease has run out", remedy="Restart it.")]
    bench.writer.start()
    assert bench.heard.next() == ("trouble", "gone.")
    assert bench.heard.next() == ("lost", "its lease has run out. Restart it.")
    bench.writer.close()


def test_the_plant_is_surely_ours_for_one_lease_from_the_start_of_the_last_commit() -> None:
    now = [100.0]
    bench = Bench(lease_seconds=10.0, clock=lambda: now[0])
    assert bench.writer.held_until == 110.0
    now[0] = 105.0
    bench.ledger.gate.clear()
    bench.writer.submit(1, [record("a")])
    bench.writer.start()
    assert bench.ledger.entered.wait(BOUND)
    now[0] = 106.0
    bench.ledger.gate.set()
    assert bench.heard.next() == ("durable", 1)
    assert bench.writer.held_until == 115.0
    bench.writer.close()


def test_a_lease_that_does_not_run_out_is_held_for_ever(bench: Bench) -> None:
    assert bench.writer.held_until == math.inf


@pytest.mark.filterwarnings("ignore::pytest.PytestUnhandledThreadExceptionWarning")
def test_a_defect_in_the_thread_is_told_before_it_dies() -> None:
    bench = Bench()
    bench.ledger.errors = [RuntimeError("a defect")]
    bench.writer.submit(1, [record("a")])
    bench.writer.start()
    assert bench.heard.next() == ("lost", "the thread that writes the database broke; see the log")
    bench.writer.close()


def test_all_that_was_delivered_is_in_the_database(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/plant.db"
    ledger = SqlLedger(url, "P1", "this test", lambda: Timestamp(0.0))
    ledger.load()
    heard = Heard()
    writer = Writer(ledger, heard.hears("durable"), on_trouble=heard.hears("trouble"), on_lost=heard.hears("lost"))
    writer.start()
    for number in range(1, 201):
        writer.submit(number, [HistoryEvent(number, Timestamp(0.0), "TransferInitiated", 0)])
    writer.close()
    ledger.close()
    said = heard.rest()
    assert said == sorted(said)
    assert said[-1] == ("durable", 200)
    reader = Reader(url)
    assert [event.seq for event in reader.events(limit=1000)] == list(range(1, 201))
    reader.close()
