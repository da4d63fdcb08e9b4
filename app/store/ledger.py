"""The ledger: takes the plant, gives what is kept, and writes each batch in one durable transaction."""

import math
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace

import sqlalchemy as sa

from app.domain.errors import PlantHeld, StoreError, StoreRefused
from app.domain.ids import MAX_EPOCH, Epoch
from app.domain.records import Kept, Record
from app.domain.units import Seconds, Timestamp
from app.store import tables
from app.store.chain import Chain
from app.store.columns import Row
from app.store.engine import parsed, told, writing
from app.store.lease import LEASE_SECONDS, Lease, NoLease
from app.store.loading import kept
from app.store.opening import CANNOT_OPEN, opened
from app.store.statements import Statements, carry_out

EPOCH_ZERO = 1_704_067_200
"""2024-01-01T00:00:00Z. Our choice."""
FOR_EVER = Seconds(math.inf)


def _old_events() -> sa.Delete:
    """Return the statement that deletes old events: oldest first, and never the last, from which their numbers go on."""
    seq = tables.events.c.seq
    first = sa.select(seq, tables.events.c.at).order_by(seq).limit(sa.bindparam("most", type_=sa.Integer)).subquery()
    old = sa.select(first.c.seq).where(first.c.at < sa.bindparam("before"))
    last = sa.select(sa.func.max(seq)).scalar_subquery()
    return tables.events.delete().where(seq.in_(old), seq < last)


_OLD = _old_events()


class SqlLedger:
    """The durable store of one plant; implements :class:`app.domain.ports.Ledger`. Blocking; one thread at a time.

    Opening takes the lease of the plant (COMMANDS 3.7), makes the tables or brings them to the newest schema, and checks that
    the database is this plant's. ``holder`` names this controller to whoever comes second (host and process); ``now_utc`` is
    only for records and for the age of events, never for the lease. Raises PlantHeld while another controller has the plant,
    StoreError for a database that cannot be used. ``sqlite://`` is a database in memory, for simulation.
    """

    def __init__(
        self,
        url: str,
        plant: str,
        holder: str,
        now_utc: Callable[[], Timestamp],
        *,
        lease_seconds: Seconds = LEASE_SECONDS,
        keep_events: Seconds = FOR_EVER,
    ) -> None:
        self._plant = plant
        self._now_utc = now_utc
        self._keep_events = keep_events
        self._epoch: Epoch | None = None
        self._commits = 0
        self._doubt: tuple[Record, ...] | None = None
        self._put_back = False
        self._connection: sa.Connection | None = None
        made = parsed(url)
        self._engine = writing(made)
        self._statements = Statements(self._engine.dialect)
        self._chain = Chain()
        self._counted = (
            tables.plant.update()
            .where(tables.plant.c.epoch == sa.bindparam("ours"), tables.plant.c.commits == sa.bindparam("before"))
            .values(commits=tables.plant.c.commits + 1)
        )
        self._lease: Lease = NoLease()
        try:
            self._lease = opened(made, self._engine, plant, holder, now_utc(), lease_seconds)
            self._own()
        except BaseException:
            self.close()
            raise

    @property
    def lease_seconds(self) -> Seconds:
        """How long after the start of a :meth:`commit` or :meth:`renew` the plant is surely ours; infinite on SQLite."""
        return self._lease.seconds

    def load(self) -> Kept:
        """Raise the epoch durably and return all that is kept.

        The epoch is not below the seconds since 2024 either, so that a restored backup starts with one never used
        (COMMANDS section 2). A backup that was put back stays marked until the first commit, which keeps the holds for it.
        """
        with self._transaction("what is kept cannot be read") as connection:
            row = connection.execute(sa.select(tables.plant)).one()
            clock = int(self._now_utc()) - EPOCH_ZERO
            self._epoch = Epoch(max(row.epoch + 1, clock if clock < MAX_EPOCH // 2 else 0))
            self._commits = row.commits
            connection.execute(tables.plant.update().values(epoch=self._epoch))
            self._put_back = connection.execute(sa.select(tables.restored.c.one)).scalar() is not None
            return replace(kept(connection, self._epoch, fresh=row.commits == 0), restored=self._put_back)

    def commit(self, batch: Sequence[Record]) -> None:
        """Write all records in one transaction, in order; durable on return.

        Raises StoreError (nothing is written; the same batch may be given again), StoreRefused (it never can be) or
        PlantHeld (the plant is no longer ours). A batch whose commit was cut off, so that nobody knows, is looked up when
        it is given again.
        """
        if self._epoch is None:
            raise StoreError("the ledger is not loaded: what is kept must be known before anything is added")
        records = tuple(batch)
        planned = list(self._statements.of(records))
        try:
            self._write(records, planned)
        except StoreRefused:
            # Somebody else may have added to the audit (hoistway users), or text from a wire holds what no database keeps
            # (NUL, half a surrogate pair).
            self._write(records, [(sql, [_storable(row) for row in many]) for sql, many in planned])

    def renew(self) -> None:
        """Keep the lease while there is nothing to write. Raises PlantHeld if it is lost, StoreError if nobody can say."""
        with self._transaction("the lease cannot be renewed"):
            pass

    def prune(self, most: int) -> int:
        """Delete events older than ``keep_events``, at most so many, and return how many were; the newest stays always.

        Raises PlantHeld or StoreError.
        """
        before = self._now_utc() - self._keep_events
        if before == -math.inf:
            return 0
        with self._transaction("old events cannot be deleted") as connection:
            return connection.execute(_OLD, {"before": before, "most": most}).rowcount

    def close(self) -> None:
        """Let the plant go. More than once is once."""
        self._drop()
        self._lease.release()
        self._lease = NoLease()
        self._engine.dispose()

    def _own(self) -> None:
        """Write the plant's name into an empty database; refuse one with another's."""
        with self._transaction(CANNOT_OPEN) as connection:
            found = connection.execute(sa.select(tables.plant.c.name)).scalar()
            if found is None:
                row = {"one": 1, "name": self._plant, "epoch": 0, "commits": 0, "created": self._now_utc()}
                connection.execute(tables.plant.insert(), row)
            elif found != self._plant:
                raise StoreError(
                    f"the database keeps plant {found}, not {self._plant}",
                    remedy="Give each plant a database of its own, or write the plant's old name into the plant file.",
                )

    def _write(self, records: tuple[Record, ...], planned: list[tuple[str, list[Row]]]) -> None:
        try:
            with self._transaction("the records cannot be kept") as connection:
                if self._count(connection, records):
                    self._doubt = records
                    if self._put_back:
                        connection.execute(tables.restored.delete())
                    for sql, many in planned:
                        rows = self._chain.linked(connection, many) if sql == self._statements.audit else many
                        carry_out(connection, sql, rows)
                else:
                    self._chain.forget()
        except BaseException:
            self._chain.forget()
            raise
        self._doubt, self._put_back = None, False
        self._commits += 1

    def _count(self, connection: sa.Connection, records: tuple[Record, ...]) -> bool:
        """Count this transaction; return False if it has been written already, by a commit whose answer was lost.

        Raises PlantHeld if anybody else has written.
        """
        while connection.execute(self._counted, {"ours": self._epoch, "before": self._commits}).rowcount == 0:
            found = connection.execute(sa.select(tables.plant)).one()
            if self._doubt is None or found.epoch != self._epoch or found.commits != self._commits + 1:
                raise PlantHeld(
                    f"another controller has started on the database of plant {self._plant}",
                    remedy="Stop one of them; this one sends nothing more.",
                )
            if self._doubt == records:
                return False
            self._doubt = None
            self._commits += 1
        return True

    @contextmanager
    def _transaction(self, what: str) -> Iterator[sa.Connection]:
        """Give the connection inside a transaction that the lease allows; after an error the next one connects afresh."""
        try:
            with told(what):
                if self._connection is None:
                    self._connection = self._engine.connect()
                with self._connection.begin():
                    self._lease.verify(self._connection)
                    yield self._connection
        except BaseException:
            self._drop()
            raise

    def _drop(self) -> None:
        connection, self._connection = self._connection, None
        if connection is not None:
            with suppress(sa.exc.SQLAlchemyError):
                connection.close()


def _storable(row: Row) -> Row:
    """Return the row with what no database keeps replaced: NUL by its symbol, half a surrogate pair by U+FFFD."""
    return tuple(_clean(value) if isinstance(value, str) else value for value in row)


def _clean(text: str) -> str:
    return text.replace("\0", "\N{SYMBOL FOR NULL}").encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace")
