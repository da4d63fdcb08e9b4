"""Opening a database: the lease first, then the schema, so that a running controller's tables stay as they are."""

from collections.abc import Iterator
from contextlib import contextmanager

import sqlalchemy as sa

from app.domain.units import Seconds, Timestamp
from app.store.engine import file_of, parsed, reading, told, writing
from app.store.lease import LEASE_SECONDS, FileLease, Lease, NoLease, RowLease
from app.store.schema import create, current, newest, upgrade

CANNOT_OPEN = "the database cannot be opened"


def opened(url: sa.URL, engine: sa.Engine, plant: str, holder: str, since: Timestamp, lease_seconds: Seconds) -> Lease:
    """Take the lease, bring the schema up to date, and return the lease. Raises PlantHeld or StoreError, holding nothing."""
    lease = _leased(url, engine, plant, holder, since, lease_seconds)
    try:
        with told(CANNOT_OPEN), engine.begin() as connection:
            if isinstance(lease, NoLease):
                create(connection)
            else:
                upgrade(connection)
    except BaseException:
        lease.release()
        raise
    return lease


@contextmanager
def held(url: str, plant: str, holder: str, since: Timestamp) -> Iterator[Lease]:
    """Hold the lease of a plant whose controller does not run just now, and give it; the schema is up to date meanwhile.

    It may run out while something long is done: what counts is written in a transaction that verifies it.

    Raises PlantHeld: another controller has it. Raises StoreError.
    """
    made = parsed(url)
    engine = writing(made)
    try:
        lease = opened(made, engine, plant, holder, since, LEASE_SECONDS)
        try:
            yield lease
        finally:
            lease.release()
    finally:
        engine.dispose()


def bring_up_to_date(url: str, holder: str, since: Timestamp) -> str:
    """Bring a database to the newest schema and return its name. Raises PlantHeld while a controller runs on it."""
    with held(url, "(any)", holder, since):
        return newest()


def revision(url: str) -> str | None:
    """Return the schema of a database, None if it is empty. Raises StoreError."""
    made = parsed(url)
    path = file_of(made)
    if path is not None and not path.exists():
        return None
    engine = reading(made)
    try:
        with told(CANNOT_OPEN), engine.connect() as connection:
            return current(connection)
    finally:
        engine.dispose()


def _leased(url: sa.URL, engine: sa.Engine, plant: str, holder: str, since: Timestamp, lease_seconds: Seconds) -> Lease:
    path = file_of(url)
    if path is not None:
        return FileLease(path, plant, holder, since)
    if url.get_backend_name() == "sqlite":
        return NoLease()
    with told(CANNOT_OPEN), engine.begin() as connection:
        if current(connection) is None:
            upgrade(connection)
    return RowLease(engine, plant, holder, lease_seconds)
