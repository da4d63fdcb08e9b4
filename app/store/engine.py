"""Connections: a URL to an engine set up to keep what it is told, and the database's errors in our words."""

import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any
from urllib.parse import quote

import sqlalchemy as sa
from sqlalchemy.pool import StaticPool

from app.domain.errors import StoreError, StoreRefused

BUSY_MS = 5_000
"""How long a lock of another connection is waited for. Our choice."""
MEMORY = ":memory:"
_CONNECT = {"connect_timeout": 5, "tcp_user_timeout": 10_000, "keepalives_idle": 5, "keepalives_interval": 2}
"""A PostgreSQL server that is gone without a word is noticed within seconds. Our choice."""


def parsed(url: str) -> sa.URL:
    """Return the URL with its driver. Raises StoreError for what is neither SQLite nor PostgreSQL."""
    try:
        made = sa.make_url(url)
    except (sa.exc.ArgumentError, ValueError) as cause:  # a port that is no number is a ValueError
        raise StoreError(f"{_without_password(url)!r} is not the URL of a database", remedy=_EXAMPLES) from cause
    if made.drivername in {"sqlite", "sqlite+pysqlite"}:
        return made.set(drivername="sqlite+pysqlite", database=made.database or MEMORY)
    if made.drivername in {"postgresql", "postgres", "postgresql+psycopg"}:
        query = {**{key: str(value) for key, value in _CONNECT.items()}, **made.query}
        return made.set(drivername="postgresql+psycopg", query=query)
    raise StoreError(f"{made.drivername} is not a database that Hoistway keeps a plant in", remedy=_EXAMPLES)


def _without_password(url: str) -> str:
    """Return what was given without what stands before an @."""
    scheme, mark, rest = url.partition("://")
    return f"{scheme}{mark}…{rest[rest.rindex('@') :]}" if "@" in rest else url


_EXAMPLES = "Write sqlite:///var/plant.db or postgresql://user@host/database."


def file_of(url: sa.URL) -> Path | None:
    """Return the file of an SQLite database with all links resolved, None for any other database."""
    if url.get_backend_name() != "sqlite" or url.database in {None, "", MEMORY}:
        return None
    return Path(str(url.database)).resolve()


def writing(url: sa.URL) -> sa.Engine:
    """Return the engine for the one connection that writes: durable on commit, and every transaction holds the write lock."""
    if url.get_backend_name() == "postgresql":
        engine = sa.create_engine(url, pool_size=1, max_overflow=0, pool_pre_ping=True, paramstyle="format")
        sa.event.listen(engine, "connect", _durable_postgresql)
        return engine
    if file_of(url) is None:
        engine = sa.create_engine(url, poolclass=StaticPool, connect_args={"check_same_thread": False})
    else:
        engine = sa.create_engine(url, pool_size=1, max_overflow=0)
    sa.event.listen(engine, "connect", _durable_sqlite)
    sa.event.listen(engine, "begin", _begin_immediate)
    return engine


def reading(url: sa.URL) -> sa.Engine:
    """Return an engine whose connections cannot write; each statement sees all that is committed and nothing else."""
    if url.get_backend_name() == "postgresql":
        engine = sa.create_engine(url, isolation_level="AUTOCOMMIT", pool_pre_ping=True)
        sa.event.listen(engine, "connect", _reading_postgresql)
    else:
        engine = sa.create_engine(_at_rest(url), isolation_level="AUTOCOMMIT")
        sa.event.listen(engine, "connect", _reading_sqlite)
    return engine


def _may_write(path: Path) -> bool:
    return os.access(path, os.W_OK, effective_ids=os.access in os.supports_effective_ids)


def _at_rest(url: sa.URL) -> sa.URL:
    """Return the URL of a file that we may not write, and nobody has open, as one that SQLite reads without files of its own
    beside it: even reading wants them where the database has been written with a WAL.

    With a WAL beside it there is more than the file has: SQLite reads both, or says that it cannot.
    """
    path = file_of(url)
    if path is None or not path.exists() or (_may_write(path) and _may_write(path.parent)):
        return url
    if any(path.with_name(path.name + more).exists() for more in ("-wal", "-shm")):
        return url
    return url.set(database=f"file:{quote(str(path))}", query={"mode": "ro", "immutable": "1", "uri": "true"})


@contextmanager
def told(what: str) -> Iterator[None]:
    """Raise the database's errors as ours; ``what`` begins the message.

    StoreRefused where the same again cannot succeed; StoreError where it may (disk full, server gone).
    """
    try:
        yield
    except (sa.exc.IntegrityError, sa.exc.DataError, sa.exc.ProgrammingError) as cause:
        raise StoreRefused(f"{what}: {_words(cause)}") from cause
    except (UnicodeEncodeError, OverflowError) as cause:
        raise StoreRefused(f"{what}: {cause}") from cause
    except sa.exc.DBAPIError as cause:
        raise StoreError(f"{what}: {_words(cause)}", remedy=_remedy(cause)) from cause
    except sa.exc.SQLAlchemyError as cause:
        raise StoreError(f"{what}: {cause}") from cause


def _words(cause: sa.exc.DBAPIError) -> str:
    return " ".join(str(cause.orig).split())


def _remedy(cause: sa.exc.DBAPIError) -> str:
    words = str(cause.orig)
    for sign, remedy in _REMEDIES.items():
        if sign in words:
            return remedy
    return ""


_REMEDIES = {
    "disk is full": "Make room on the disk.",
    "No space left": "Make room on the disk.",
    "readonly": "Give this user the right to write the file and its directory.",
    "unable to open": "See that the directory exists and that this user may write in it.",
    "malformed": "The file is damaged: put a backup back with hoistway db restore.",
    "not a database": "Name another file, or remove this one if nothing needs it.",
    "database is locked": "Another program is writing to the file; close it.",
    "connection": "See that the database server runs and can be reached.",
}


def execute(connection: Any, *statements: str) -> None:
    """Give statements to a new connection of the driver."""
    cursor = connection.cursor()
    for statement in statements:
        cursor.execute(statement)
    cursor.close()


def _durable_sqlite(connection: Any, _record: object) -> None:
    # The driver's own BEGIN comes too late for DDL: we begin ourselves, so that a migration is whole or not at all.
    connection.isolation_level = None
    # EXTRA, and before WAL: the switch is made with a rollback journal, whose end FULL does not flush. Come back after a power
    # cut, it would undo the switch, and all that was kept since. In WAL itself EXTRA is FULL.
    execute(
        connection,
        f"PRAGMA busy_timeout = {BUSY_MS}",
        "PRAGMA synchronous = EXTRA",
        "PRAGMA journal_mode = WAL",
        "PRAGMA fullfsync = ON",
        "PRAGMA foreign_keys = ON",
    )


def _begin_immediate(connection: sa.Connection) -> None:
    connection.exec_driver_sql("BEGIN IMMEDIATE")


def _reading_sqlite(connection: Any, _record: object) -> None:
    execute(connection, f"PRAGMA busy_timeout = {BUSY_MS}", "PRAGMA query_only = ON")


def _durable_postgresql(connection: Any, _record: object) -> None:
    # A stopped controller must not hold the lease's row for ever: the server ends its transaction.
    execute(
        connection,
        "SET synchronous_commit TO on",
        f"SET lock_timeout TO {BUSY_MS}",
        f"SET idle_in_transaction_session_timeout TO {BUSY_MS}",
    )
    connection.commit()


def _reading_postgresql(connection: Any, _record: object) -> None:
    execute(connection, "SET default_transaction_read_only TO on")
