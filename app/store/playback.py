"""What playback keeps: changes in pieces of some seconds, and the whole state now and then; durable enough, never for ever.

On SQLite it is a file of its own beside the plant's, so that nothing waits for it; losing the last seconds in a power cut is
no harm. PostgreSQL has it in the same database, without waiting for the disk.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import sqlalchemy as sa

from app.store.engine import BUSY_MS, MEMORY, execute, parsed, reading, told
from app.store.tables import BIG, UTC

STATE, CHANGES = "state", "changes"
metadata = sa.MetaData()
pieces = sa.Table(
    "playback",
    metadata,
    sa.Column("id", BIG, primary_key=True, autoincrement=True),
    sa.Column("kind", sa.Text(), nullable=False),
    sa.Column("begin", UTC, nullable=False),
    sa.Column("end", UTC, nullable=False),
    sa.Column("changes", BIG, nullable=False),
    sa.Column("size", BIG, nullable=False),
    sa.Column("body", sa.LargeBinary(), nullable=False),
)
sa.Index("ix_playback_kind_begin", pieces.c.kind, pieces.c.begin)
heats = sa.Table(
    "playback_heat",
    metadata,
    sa.Column("begin", UTC, primary_key=True),
    sa.Column("end", UTC, nullable=False),
    sa.Column("body", sa.LargeBinary(), nullable=False),
)


@dataclass(frozen=True, slots=True)
class Piece:
    """The whole ``state`` at ``begin``, or the ``changes`` from ``begin`` to ``end``; ``body`` is compressed."""

    kind: str
    begin: float
    end: float
    count: int
    body: bytes
    id: int = 0


@dataclass(frozen=True, slots=True)
class Span:
    """What there is: from the first whole state to the last change, in so many bytes; None: nothing."""

    begin: float | None
    end: float | None
    size: int


def playback_url(url: str) -> sa.URL:
    """Return where playback of the plant in a database is kept. Raises StoreError for what is no database of ours."""
    made = parsed(url)
    if made.get_backend_name() == "sqlite" and made.database != MEMORY:
        return made.set(database=f"{made.database}.playback")
    return made


class PlaybackStore:
    """Pieces in a database; blocking. Every method raises StoreError if it cannot be used."""

    def __init__(self, url: str) -> None:
        made = playback_url(url)
        self._engine = sa.create_engine(made, pool_size=1, max_overflow=0)
        quick = _quick_sqlite if made.get_backend_name() == "sqlite" else _quick_postgresql
        sa.event.listen(self._engine, "connect", quick)
        with told("the playback store cannot be opened"):
            metadata.create_all(self._engine)
        self._size = self._sum()

    def close(self) -> None:
        """Close the connection."""
        self._engine.dispose()

    def append(self, some: Sequence[Piece]) -> None:
        """Keep some pieces, in order."""
        rows = [
            {"kind": p.kind, "begin": p.begin, "end": p.end, "changes": p.count, "size": len(p.body), "body": p.body}
            for p in some
        ]
        with told("playback cannot be kept"), self._engine.begin() as connection:
            connection.execute(pieces.insert(), rows)
        self._size += sum(len(p.body) for p in some)

    def keep_heat(self, begin: float, end: float, body: bytes) -> None:
        """Keep what was counted since a moment, in place of what was kept of it before."""
        with told("playback cannot be kept"), self._engine.begin() as connection:
            connection.execute(heats.delete().where(heats.c.begin == begin))
            connection.execute(heats.insert(), [{"begin": begin, "end": end, "body": body}])

    def prune(self, before: float, most: int) -> int:
        """Delete what ended before a moment, and the oldest while all is more than so many bytes; return how many pieces were.

        What was counted on the way is small, and goes by its age alone.
        """
        deleted = 0
        with told("old playback cannot be deleted"), self._engine.begin() as connection:
            connection.execute(heats.delete().where(heats.c.end < before))
            deleted += connection.execute(pieces.delete().where(pieces.c.end < before)).rowcount
            if deleted:
                self._size = self._sum(connection)
            while self._size > most:
                oldest = connection.execute(
                    sa.select(pieces.c.id, pieces.c.size).order_by(pieces.c.id).limit(200)
                ).all()
                over, ids = self._size - most, []
                for row in oldest:
                    if over <= 0:
                        break
                    ids.append(row.id)
                    over -= row.size
                    self._size -= row.size
                if not ids:
                    break
                deleted += connection.execute(pieces.delete().where(pieces.c.id.in_(ids))).rowcount
        return deleted

    def _sum(self, connection: sa.Connection | None = None) -> int:
        query = sa.select(sa.func.coalesce(sa.func.sum(pieces.c.size), 0))
        if connection is not None:
            return int(connection.execute(query).scalar_one())
        with told("the playback store cannot be read"), self._engine.connect() as own:
            return int(own.execute(query).scalar_one())


class PlaybackReader:
    """Questions to the pieces, from any thread; a store must have been opened first. Raises StoreError."""

    def __init__(self, url: str) -> None:
        self._engine = reading(playback_url(url))

    def close(self) -> None:
        """Close all connections."""
        self._engine.dispose()

    def span(self) -> Span:
        """Return what there is."""
        c = pieces.c
        first = sa.select(sa.func.min(c.begin)).where(c.kind == STATE).scalar_subquery().label("first")
        columns: list[sa.ColumnElement[Any]] = [
            first,
            sa.func.max(c.end).label("last"),
            sa.func.coalesce(sa.func.sum(c.size), 0).label("size"),
        ]
        row = self._rows(sa.select(*columns))[0]
        return Span(row.first, None if row.first is None else row.last, int(row.size))

    def state_before(self, at: float) -> Piece | None:
        """Return the newest whole state that is not after a moment."""
        query = sa.select(pieces).where(pieces.c.kind == STATE, pieces.c.begin <= at)
        return next(iter(self._pieces(query.order_by(pieces.c.begin.desc(), pieces.c.id.desc()).limit(1))), None)

    def first_state(self, begin: float, end: float) -> Piece | None:
        """Return the first whole state of a period."""
        c = pieces.c
        query = sa.select(pieces).where(c.kind == STATE, c.begin >= begin, c.begin <= end)
        return next(iter(self._pieces(query.order_by(c.begin, c.id).limit(1))), None)

    def since(self, after: int, end: float, limit: int) -> list[Piece]:
        """Return pieces of both kinds with ids above ``after`` that begin before a moment, in order."""
        query = sa.select(pieces).where(pieces.c.id > after, pieces.c.begin <= end)
        return self._pieces(query.order_by(pieces.c.id).limit(limit))

    def changes(self, begin: float, end: float, after: int = 0, limit: int = 100) -> list[Piece]:
        """Return pieces of changes that reach into a period, in order, with ids from ``after`` on."""
        c = pieces.c
        query = sa.select(pieces).where(c.kind == CHANGES, c.end >= begin, c.begin <= end, c.id >= after)
        return self._pieces(query.order_by(c.id).limit(limit))

    def heats(self, begin: float, end: float) -> list[bytes]:
        """Return what was counted in a period, and a little before and after it, in order."""
        c = heats.c
        query = sa.select(c.body).where(c.end > begin, c.begin < end).order_by(c.begin)
        return [bytes(row.body) for row in self._rows(query)]

    def _rows(self, query: sa.Select[Any]) -> list[sa.Row[Any]]:
        with told("the playback store cannot be read"), self._engine.connect() as connection:
            return list(connection.execute(query))

    def _pieces(self, query: sa.Select[Any]) -> list[Piece]:
        return [Piece(r.kind, r.begin, r.end, r.changes, bytes(r.body), r.id) for r in self._rows(query)]


def _quick_sqlite(connection: Any, _record: object) -> None:
    execute(connection, f"PRAGMA busy_timeout = {BUSY_MS}", "PRAGMA journal_mode = WAL", "PRAGMA synchronous = NORMAL")


def _quick_postgresql(connection: Any, _record: object) -> None:
    execute(connection, "SET synchronous_commit TO off", f"SET lock_timeout TO {BUSY_MS}")
    connection.commit()
