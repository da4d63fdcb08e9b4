"""Databases for the tests of the store: each test gets one of its own, on SQLite and on PostgreSQL."""

import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from uuid import uuid4

import pytest
import sqlalchemy as sa

from app.domain.units import Seconds, Timestamp
from app.store.engine import parsed
from app.store.ledger import FOR_EVER, SqlLedger

NOW = Timestamp(1000.0)

Open = Callable[..., SqlLedger]


@pytest.fixture(autouse=True)
def _connections_are_closed() -> Iterator[None]:
    """Close what a test left open, crashes it played included: Python 3.13 warns of every one that is just forgotten."""
    made: list[Any] = []

    def note(connection: Any, _record: object) -> None:
        made.append(connection)

    sa.event.listen(sa.Pool, "connect", note)
    yield
    sa.event.remove(sa.Pool, "connect", note)
    for connection in made:
        connection.close()


@pytest.fixture
def sqlite_url(tmp_path: Path) -> str:
    return f"sqlite:///{tmp_path}/plant.db"


@contextmanager
def own_schema() -> Iterator[str]:
    """Make a schema of its own in the database that HOISTWAY_TEST_POSTGRES_URL names."""
    base = os.environ.get("HOISTWAY_TEST_POSTGRES_URL")
    if base is None:
        pytest.skip("HOISTWAY_TEST_POSTGRES_URL is not set")
    schema = f"test_{uuid4().hex}"
    engine = sa.create_engine(parsed(base))
    with engine.begin() as connection:
        connection.execute(sa.schema.CreateSchema(schema))
    url = sa.make_url(base).update_query_dict({"options": f"-csearch_path={schema}"})
    yield url.render_as_string(hide_password=False)
    with engine.begin() as connection:
        connection.execute(sa.schema.DropSchema(schema, cascade=True))
    engine.dispose()


@pytest.fixture
def postgres_url() -> Iterator[str]:
    with own_schema() as url:
        yield url


@pytest.fixture(params=["sqlite", pytest.param("postgres", marks=pytest.mark.postgres)])
def url(request: pytest.FixtureRequest) -> str:
    return str(request.getfixturevalue(f"{request.param}_url"))


@pytest.fixture
def open_ledger() -> Iterator[Open]:
    """Open ledgers that are closed when the test is over."""
    ledgers: list[SqlLedger] = []

    def opened(
        url: str,
        plant: str = "P1",
        holder: str = "first",
        *,
        seconds: float = 10.0,
        now: float = NOW,
        keep: Seconds = FOR_EVER,
    ) -> SqlLedger:
        ledger = SqlLedger(url, plant, holder, lambda: Timestamp(now), lease_seconds=Seconds(seconds), keep_events=keep)
        ledgers.append(ledger)
        return ledger

    yield opened
    for ledger in ledgers:
        ledger.close()


@pytest.fixture
def raw(url: str) -> Iterator[sa.Engine]:
    """A way into the same database past the store."""
    engine = sa.create_engine(parsed(url))
    yield engine
    engine.dispose()
