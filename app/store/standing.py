"""What a plant's database holds just now, read beside a running controller: nothing is taken, nothing written."""

import sqlalchemy as sa

from app.domain.errors import StoreError
from app.domain.ids import Epoch
from app.domain.records import Kept
from app.store.engine import MEMORY, parsed, reading, told
from app.store.loading import kept
from app.store.opening import revision
from app.store.schema import newest


def standing(url: str) -> Kept:
    """Return what a controller would find if it started now.

    Raises StoreError: there is no such database, it is of another version, or it is in memory.
    """
    made = parsed(url)
    if made.database == MEMORY:
        raise StoreError("a database in memory can be read by its ledger alone", remedy="Keep the plant in a file.")
    found = revision(url)
    if found != newest():
        what = f"its schema is {found}, not {newest()}" if found else "it holds no plant"
        raise StoreError(f"the database cannot be read: {what}", remedy="Start the controller on it once.")
    engine = reading(made)
    try:
        with told("the database cannot be read"), engine.connect() as connection:
            return kept(connection, Epoch(0), fresh=_is_fresh(connection))
    finally:
        engine.dispose()


def _is_fresh(connection: sa.Connection) -> bool:
    from app.store.tables import plant

    return connection.execute(sa.select(plant.c.epoch)).scalar() in (None, 0)
