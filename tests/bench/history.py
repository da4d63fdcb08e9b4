"""Events of the history into the database: the ledger against a bulk load of tuples that are made already."""

import os
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import partial
from typing import Any, TypeVar
from uuid import uuid4

import sqlalchemy as sa
from sqlalchemy import orm

from app.domain.ids import CarrierId, JobId, VehicleId
from app.domain.records import HistoryEvent
from app.domain.units import Timestamp
from app.store.engine import parsed, writing
from app.store.ledger import SqlLedger
from app.store.rows import event_row
from app.store.tables import events as table
from tests.bench.measuring import Row, in_turn

Item = TypeVar("Item")
BATCH = 1_000
BATCHES = 20
ONE_BY_ONE = 300
"""Rows of the usual way, which takes a transaction for each."""
ROUNDS = 5


def _events(first: int, count: int) -> list[HistoryEvent]:
    now = Timestamp(1_767_225_600.0)
    return [
        HistoryEvent(
            n, Timestamp(now + n), "VehicleArrived", 205, JobId(f"J{n // 12}"), CarrierId(f"FOUP{n % 900:04}"),
            VehicleId(f"V{n % 400:03}"), "P0123", "P0456", "", "to the source: V001 12 s, V002 19 s",
        )
        for n in range(first, first + count)
    ]  # fmt: skip


@contextmanager
def _database() -> Iterator[str]:
    """Give the URL of an empty database: on the PostgreSQL server of the tests where there is one, else SQLite."""
    base = os.environ.get("HOISTWAY_TEST_POSTGRES_URL")
    if base is None:
        with tempfile.TemporaryDirectory(prefix="hoistway-bench-") as place:
            yield f"sqlite:///{place}/bench.db"
        return
    schema = f"bench_{uuid4().hex}"
    engine = sa.create_engine(parsed(base))
    with engine.begin() as connection:
        connection.execute(sa.schema.CreateSchema(schema))
    url = sa.make_url(base).update_query_dict({"options": f"-csearch_path={schema}"})
    try:
        yield url.render_as_string(hide_password=False)
    finally:
        with engine.begin() as connection:
            connection.execute(sa.schema.DropSchema(schema, cascade=True))
        engine.dispose()


def _cost(rows: int, call: Callable[[Item], None], items: Sequence[Item]) -> float:
    """Return the microseconds of this thread's CPU for each row."""
    began = time.thread_time_ns()
    for item in items:
        call(item)
    return (time.thread_time_ns() - began) / rows / 1e3


@contextmanager
def _ledger() -> Iterator[tuple[str, SqlLedger]]:
    with _database() as url:
        ledger = SqlLedger(url, "bench", "bench", lambda: Timestamp(time.time()))
        ledger.load()
        try:
            yield url, ledger
        finally:
            ledger.close()


def appended() -> float:
    """Return what the ledger takes, from records to durable rows, 1,000 events in a transaction."""
    batches = [_events(n * BATCH + 1, BATCH) for n in range(BATCHES)]
    with _ledger() as (_, ledger):
        return _cost(BATCH * BATCHES, ledger.commit, batches)


def loaded() -> float:
    """Return what COPY of ready tuples takes (SQLite: executemany), into the same table, as durable."""
    batches = [[event_row(event) for event in _events(n * BATCH + 1, BATCH)] for n in range(BATCHES)]
    with _ledger() as (url, _):
        engine = writing(parsed(url))
        with engine.connect() as connection:
            raw: Any = connection.connection.driver_connection
            load = _copied if engine.dialect.name == "postgresql" else _executed
            cost = _cost(BATCH * BATCHES, partial(load, raw), batches)
        engine.dispose()
        return cost


def _copied(raw: Any, rows: Sequence[Any]) -> None:
    with raw.cursor() as cursor, cursor.copy("COPY events FROM STDIN") as copy:
        for row in rows:
            copy.write_row(row)
    raw.commit()


def _executed(raw: Any, rows: Sequence[Any]) -> None:
    raw.execute("BEGIN IMMEDIATE")
    raw.executemany(f"INSERT INTO events VALUES ({', '.join('?' * 11)})", rows)
    raw.execute("COMMIT")


class _Event:
    """An event as an object-relational mapper knows it."""


def one_by_one() -> float:
    """Return what the usual way takes: a mapped object, a session and a commit for each event."""
    mapper = orm.registry()
    mapper.map_imperatively(_Event, table)
    with _ledger() as (url, _):
        engine = writing(parsed(url))
        names = [column.name for column in table.c]

        def add(row: Sequence[Any]) -> None:
            with orm.Session(engine) as session:
                event = _Event()
                for name, value in zip(names, row, strict=True):
                    setattr(event, name, value)
                session.add(event)
                session.commit()

        rows = [event_row(event) for event in _events(1, ONE_BY_ONE)]
        cost = _cost(len(rows), add, rows)
        engine.dispose()
    mapper.dispose()
    return cost


def rows() -> Iterator[Row]:
    """Measure the ledger."""
    floor, ours = in_turn(ROUNDS, loaded, appended)
    server = "PostgreSQL, COPY" if "HOISTWAY_TEST_POSTGRES_URL" in os.environ else "SQLite, executemany"
    yield Row(
        f"event history append, 1,000 events in a transaction ({server})",
        ours, floor, one_by_one(), "µs CPU/row", 2.0,
        note="floor: a bulk load of ready tuples; ours: from records, with the lease and the count of commits; "
        "naive: a mapped object, a session and a commit for each",
    )  # fmt: skip
