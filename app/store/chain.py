"""The audit as a chain: each row has a hash over itself and the hash of the row before, so that no row can be changed, left out
or put in between without breaking what follows.

Whoever can write the database can compute a chain anew: who wants to notice that notes the last number and hash elsewhere.
"""

import json
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from hashlib import sha256

import sqlalchemy as sa

from app.domain.records import AuditRow
from app.store.columns import Row
from app.store.tables import audit, plant

START = ""
"""What stands for the hash before the first row."""
_encode = json.JSONEncoder(separators=(",", ":"), ensure_ascii=True, allow_nan=False).encode
_INSERT = audit.insert()


def link(before: str, seq: int, row: Sequence[object]) -> str:
    """Return the hash of a row (time, actor, action, target, detail, accepted), in hex, given the one before it."""
    return sha256(_encode([before, seq, *row]).encode()).hexdigest()


def head_of(connection: sa.Connection) -> tuple[int, str]:
    """Return number and hash of the last row."""
    query = sa.select(audit.c.seq, audit.c.hash).order_by(audit.c.seq.desc()).limit(1)
    found = connection.execute(query).one_or_none()
    return (0, START) if found is None else (found.seq, found.hash)


def append(connection: sa.Connection, row: AuditRow) -> None:
    """Add a row beside a running controller, whose commits wait until this transaction ends."""
    connection.execute(sa.select(plant.c.one).with_for_update())
    seq, before = head_of(connection)
    said = (row.at, row.actor, row.action, row.target, row.detail, row.accepted)
    names = ("at", "actor", "action", "target", "detail", "accepted")
    values = dict(zip(names, said, strict=True))
    connection.execute(_INSERT, {"seq": seq + 1, **values, "hash": link(before, seq + 1, said)})


class Chain:
    """The end of the chain as the ledger knows it. Another program may have added rows: their numbers are taken then, the
    ledger's transaction fails, and it begins again from what is there."""

    def __init__(self) -> None:
        self._head: tuple[int, str] | None = None

    def linked(self, connection: sa.Connection, rows: Iterable[Row]) -> list[Row]:
        """Return rows with their numbers and hashes, to be written in this transaction."""
        seq, before = self._head or head_of(connection)
        made: list[Row] = []
        for row in rows:
            seq += 1
            before = link(before, seq, row)
            made.append((seq, *row, before))
        self._head = (seq, before)
        return made

    def forget(self) -> None:
        """Look for the end again: the transaction was not written, or nobody knows."""
        self._head = None


@dataclass(frozen=True, slots=True)
class Checked:
    """What came of looking at a piece of the chain: the last row that follows from the first, and the first that does not."""

    rows: int
    last: int
    hash: str
    broken: int | None = None
    reason: str = ""


def check(before: Checked, rows: Iterable[tuple[int, AuditRow, str]]) -> Checked:
    """Look at rows that come after ``before``, oldest first, up to the first that does not follow."""
    count, last, mark = before.rows, before.last, before.hash
    for seq, row, kept in rows:
        said = (row.at, row.actor, row.action, row.target, row.detail, row.accepted)
        if link(mark, seq, said) != kept:
            reason = f"row {seq} has been changed, or a row between {last} and {seq} was taken out or put in"
            return Checked(count, last, mark, seq, reason)
        count, last, mark = count + 1, seq, kept
    return Checked(count, last, mark)
