"""What can be said of a plant's database without taking it: for ``hoistway doctor``."""

from dataclasses import dataclass
from pathlib import Path

import sqlalchemy as sa

from app.domain.units import Timestamp
from app.store import tables
from app.store.engine import file_of, parsed, reading, told
from app.store.lease import NOW, WHO, holder_of
from app.store.opening import CANNOT_OPEN
from app.store.schema import current


@dataclass(frozen=True, slots=True)
class Condition:
    """The state of a database; all None where it is empty or not there yet.

    ``holder`` is the controller that runs on it, ``last`` the time of the newest event, ``clock`` the database's own clock
    (PostgreSQL), ``put_back`` the file of a backup that no start has seen yet.
    """

    schema: str | None = None
    plant: str | None = None
    holder: str | None = None
    last: Timestamp | None = None
    clock: Timestamp | None = None
    put_back: str | None = None


def condition(url: str) -> Condition:
    """Look at a database. Raises StoreError: it cannot be reached, is not ours, or a newer Hoistway wrote it."""
    made = parsed(url)
    path = file_of(made)
    if made.get_backend_name() == "sqlite" and (path is None or not path.exists()):
        return Condition()
    engine = reading(made)
    try:
        with told(CANNOT_OPEN), engine.connect() as connection:
            return _looked(connection, path)
    finally:
        engine.dispose()


def _looked(connection: sa.Connection, path: Path | None) -> Condition:
    schema = current(connection)
    if schema is None:
        return Condition()
    there = set(sa.inspect(connection).get_table_names())
    last = connection.execute(sa.select(sa.func.max(tables.events.c.at))).scalar()
    mark = connection.execute(sa.select(tables.restored.c.source)).scalar() if "restored" in there else None
    lease = None if path is not None else connection.execute(WHO).one_or_none()
    return Condition(
        schema=schema,
        plant=connection.execute(sa.select(tables.plant.c.name)).scalar(),
        holder=holder_of(path)
        if path is not None
        else None
        if lease is None or lease.deadline <= lease.now
        else lease.holder,
        last=None if last is None else Timestamp(last),
        clock=None if path is not None else Timestamp(connection.execute(sa.select(NOW)).scalar_one()),
        put_back=mark,
    )
