"""Jobs that are durable when they are answered: ``POST /jobs``, and the writer alone, 64 at once."""

import asyncio
import itertools
import json
import os
import subprocess
import sys
import tempfile
import threading
import time
from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from pathlib import Path
from typing import cast

import uvloop

from app.domain.ids import Actor, JobId, StationId
from app.domain.job import Job
from app.domain.records import HistoryEvent, Record
from app.domain.units import Timestamp
from app.runtime.writer import Writer
from app.store.ledger import SqlLedger
from tests.bench.measuring import Row, child, cpu_of, in_turn, line_of, module
from tests.bench.posts import STATIONS, plant

AT_ONCE = 64
WARM, MEASURE = 0.5, 2.0
ROUNDS = 3
_numbers = itertools.count()


class Poster(asyncio.Protocol):
    """One connection that posts one job after the other, each with a name of its own."""

    def __init__(self, count: list[int]) -> None:
        self._count = count
        self._held = b""

    def connection_made(self, transport: asyncio.BaseTransport) -> None:
        """Post the first."""
        self._transport = cast(asyncio.Transport, transport)
        self._post()

    def data_received(self, data: bytes) -> None:
        """Take an answer; post the next when it is whole."""
        self._held += data
        head, found, body = self._held.partition(b"\r\n\r\n")
        if not found:
            return
        length = int(head.lower().partition(b"content-length:")[2].partition(b"\r\n")[0])
        if len(body) < length:
            return
        if not head.startswith(b"HTTP/1.1 201"):
            raise RuntimeError(f"a job was not taken: {head!r} {body!r}")
        self._count[0] += 1
        self._held = b""
        self._post()

    def _post(self) -> None:
        n = next(_numbers)
        order = {
            "job_id": f"J{n}",
            "source": f"B{n % STATIONS}",
            "destination": f"B{(n + 7) % STATIONS}",
            "priority": 50,
        }
        body = json.dumps(order).encode()
        self._transport.write(
            b"POST /api/v1/jobs HTTP/1.1\r\nHost: 127.0.0.1\r\nContent-Type: application/json\r\nContent-Length: %d\r\n\r\n%b"
            % (len(body), body)
        )


async def _load(port: int, pid: int) -> tuple[float, float]:
    """Return CPU microseconds per request, and requests per second."""
    loop, count = asyncio.get_running_loop(), [0]
    lines = [await loop.create_connection(lambda: Poster(count), "127.0.0.1", port) for _ in range(AT_ONCE)]
    await asyncio.sleep(WARM)
    posts, cpu, began = count[0], cpu_of(pid), time.perf_counter()
    await asyncio.sleep(MEASURE)
    posts, cpu, took = count[0] - posts, cpu_of(pid) - cpu, time.perf_counter() - began
    for transport, _ in lines:
        transport.abort()
    return cpu / posts * 1e6, posts / took


def _server(kind: str, place: Path) -> list[str]:
    database = place / "bench.db"
    if kind != "ours":
        return module("posts", kind, database)
    (place / "plant.yaml").write_text(plant())
    ours = [sys.executable, "-m", "app.cli", "serve", "--plant", f"{place}/plant.yaml"]
    return [*ours, "--database", f"sqlite:///{database}", "--port", "0"]


def posted(kind: str, speeds: list[float]) -> float:
    """Return the CPU microseconds per request of one of the servers; note its requests per second."""
    with tempfile.TemporaryDirectory(prefix="hoistway-bench-") as name:
        quiet = {**os.environ, "HOISTWAY_LOG_LEVEL": "error", "HOISTWAY_LOG_FORMAT": "json"}
        with child(*_server(kind, Path(name)), stdout=subprocess.PIPE, env=quiet) as server:
            port = int(line_of(server.stdout).rpartition(":")[2])
            with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
                cpu, speed = runner.run(_load(port, server.pid))
    speeds.append(speed)
    return cpu


def flushes(seconds: float = 1.0) -> float:
    """Return how often in a second 4 KiB can be appended to a file and made durable."""
    with tempfile.NamedTemporaryFile(prefix="hoistway-bench-") as file:
        count, began, page = 0, time.perf_counter(), os.urandom(4096)
        while (took := time.perf_counter() - began) < seconds:
            os.write(file.fileno(), page)
            os.fdatasync(file.fileno())
            count += 1
        return count / took


class Inserting:
    """64 orders at once into the group-commit writer: each durable one is followed by the next."""

    def __init__(self, ledger: SqlLedger, batches: Iterator[Sequence[Record]]) -> None:
        self.durable = 0
        self._batches = batches
        self._number = itertools.count(1)
        self._writer = Writer(ledger, self._deliver, on_trouble=_fail, on_lost=_fail)
        self._go_on = True

    def run(self, seconds: float) -> float:
        """Return jobs per second."""
        self._writer.start()
        began = time.perf_counter()
        for _ in range(AT_ONCE):
            self._submit()
        threading.Event().wait(seconds)
        done, took = self.durable, time.perf_counter() - began
        self._go_on = False
        self._writer.close()
        return done / took

    def _deliver(self, last: int) -> None:
        fresh, self.durable = last - self.durable, last
        for _ in range(fresh if self._go_on else 0):
            self._submit()

    def _submit(self) -> None:
        self._writer.submit(next(self._number), next(self._batches))


def _fail(message: str) -> None:
    raise RuntimeError(message)


def _orders() -> Iterator[Sequence[Record]]:
    """Give a job and its first event, again and again."""
    now = Timestamp(1_767_225_600.0)
    job = Job(JobId("J"), 1, None, StationId("B1"), StationId("B2"), 50, now, Actor("bench"), "0" * 32)
    for n in itertools.count(1):
        named = replace(job, id=JobId(f"J{n}"), order=n)
        yield (named, HistoryEvent(n, now, "TransferInitiated", 0, job=named.id, source="B1", destination="B2"))


def inserted(seconds: float = 1.5) -> float:
    """Return durable jobs per second, 64 at once."""
    with tempfile.TemporaryDirectory(prefix="hoistway-bench-") as place:
        ledger = SqlLedger(f"sqlite:///{place}/bench.db", "bench", "bench", lambda: Timestamp(time.time()))
        try:
            ledger.load()
            return Inserting(ledger, _orders()).run(seconds)
        finally:
            with suppress(Exception):
                ledger.close()


def inserted_one_by_one(seconds: float = 1.0) -> float:
    """Return durable jobs per second with a transaction for each."""
    with tempfile.TemporaryDirectory(prefix="hoistway-bench-") as place:
        ledger = SqlLedger(f"sqlite:///{place}/bench.db", "bench", "bench", lambda: Timestamp(time.time()))
        ledger.load()
        count, began, orders = 0, time.perf_counter(), _orders()
        while (took := time.perf_counter() - began) < seconds:
            ledger.commit(next(orders))
            count += 1
        ledger.close()
        return count / took


def rows() -> Iterator[Row]:
    """Measure requests, then the writer."""
    speeds: dict[str, list[float]] = {"floor": [], "ours": [], "naive": []}
    floor, ours = in_turn(ROUNDS, *(partial(posted, kind, speeds[kind]) for kind in ("floor", "ours")))
    naive = posted("naive", speeds["naive"])
    yield Row(
        "POST /jobs answered after a durable commit, 64 at once",
        ours, floor, naive, "µs CPU/request", 3.0,
        note="floor: raw ASGI, group commit of one row; ours: the whole controller; naive: FastAPI, session and commit per row",
    )  # fmt: skip
    middle = {kind: sorted(found)[len(found) // 2] for kind, found in speeds.items()}
    synced, grouped, single = in_turn(ROUNDS, flushes, inserted, inserted_one_by_one)
    yield Row(
        "POST /jobs per second, durable, 64 at once, against fdatasync per second",
        middle["ours"], synced, middle["naive"], "1/s", None, "higher",
        note=f"raw ASGI and group commit: {middle['floor']:,.0f}/s",
    )  # fmt: skip
    yield Row(
        "durable job inserts on the writer, 64 at once (a job and its event), against fdatasync per second",
        grouped, synced, single, "1/s", 8.0, "higher",
        note="naive: the same ledger, a transaction for each job",
    )  # fmt: skip
