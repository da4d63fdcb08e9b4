"""Power cuts: what the ledger writes to the disk is recorded, and the disk is put together as a cut at any moment may leave it.

A disk keeps what was flushed. What was written since it may have kept, lost, or kept in part, and in any order. The ledger's own
statements and pragmas run on a recording SQLite (apsw's VFS, under the same SQLAlchemy); each disk is then opened by the ordinary
ledger. ``python -m tests.acceptance.power --cuts 1000``: no acknowledged record is lost, no transaction is there in part.
"""

import argparse
import random
import sqlite3
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, ClassVar
from unittest import mock
from uuid import uuid4

import apsw
import sqlalchemy as sa

from app.domain.units import Timestamp
from app.store import engine as engines
from app.store.ledger import SqlLedger
from tests.store.samples import event, job

SECTOR = 512
"""Bytes that a disk writes whole or not at all."""
BATCHES = 40
NAME = "plant.db"


@dataclass(frozen=True, slots=True)
class Write:
    """Bytes written at an offset of a file; ``data`` None: cut to that length."""

    file: str
    offset: int
    data: bytes | None


@dataclass(frozen=True, slots=True)
class Flush:
    """All that was written to a file is on the disk."""

    file: str


@dataclass(frozen=True, slots=True)
class Delete:
    """A file is gone."""

    file: str


@dataclass(slots=True)
class Recording:
    """All that was done to the disk, in order, and how many batches were acknowledged when so much of it was done."""

    done: list[Write | Flush | Delete] = field(default_factory=list)
    acknowledged: list[int] = field(default_factory=list)

    def known_at(self, moment: int) -> int:
        """Return how many batches had been acknowledged before a moment."""
        return sum(done <= moment for done in self.acknowledged)


def cut(recording: Recording, moment: int, draw: random.Random) -> dict[str, bytes]:
    """Return the files as a power cut before ``done[moment]`` may leave them."""
    files: dict[str, bytearray] = {}
    pending: dict[str, list[Write | Delete]] = {}
    for step in recording.done[:moment]:
        if isinstance(step, Flush):
            for one in pending.pop(step.file, []):
                _apply(files, one)
            files.setdefault(step.file, bytearray())
        else:
            pending.setdefault(step.file, []).append(step)
    for steps in pending.values():
        for one in steps:
            if (kept := _survives(one, draw)) is not None:
                _apply(files, kept)
    return {name: bytes(content) for name, content in files.items()}


def _survives(step: Write | Delete, draw: random.Random) -> Write | Delete | None:
    """Return what is left of something that was not flushed: all, nothing, or some of its sectors."""
    fate = draw.random()
    if fate < 0.4:
        return None
    if fate < 0.8 or isinstance(step, Delete) or step.data is None or len(step.data) <= SECTOR:
        return step
    return Write(step.file, step.offset, step.data[: SECTOR * draw.randrange(1, -(-len(step.data) // SECTOR))])


def _apply(files: dict[str, bytearray], step: Write | Delete) -> None:
    if isinstance(step, Delete):
        files.pop(step.file, None)
        return
    content = files.setdefault(step.file, bytearray())
    if step.data is None:
        del content[step.offset :]
        return
    if len(content) < step.offset:
        content.extend(bytes(step.offset - len(content)))
    content[step.offset : step.offset + len(step.data)] = step.data


class _Vfs(apsw.VFS):
    """The system's own files, with every change told to a recording."""

    def __init__(self, name: str, recording: Recording) -> None:
        self._recording = recording
        super().__init__(name, "")

    def xOpen(self, name: Any, flags: list[int]) -> apsw.VFSFile:  # noqa: N802
        """Open a file."""
        return _File("", name, flags, self._recording)

    def xDelete(self, filename: str, syncdir: bool) -> None:  # noqa: N802
        """Delete a file."""
        self._recording.done.append(Delete(Path(filename).name))
        super().xDelete(filename, syncdir)
        if syncdir:
            self._recording.done.append(Flush(Path(filename).name))


class _File(apsw.VFSFile):
    def __init__(self, vfs: str, name: Any, flags: list[int], recording: Recording) -> None:
        filename = name.filename() if isinstance(name, apsw.URIFilename) else name
        self._name = Path(filename).name
        self._recording = recording
        super().__init__(vfs, name, flags)

    def xWrite(self, data: Any, offset: int) -> None:  # noqa: N802
        """Write bytes."""
        self._recording.done.append(Write(self._name, offset, bytes(data)))
        super().xWrite(data, offset)

    def xTruncate(self, newsize: int) -> None:  # noqa: N802
        """Cut to a length."""
        self._recording.done.append(Write(self._name, newsize, None))
        super().xTruncate(newsize)

    def xSync(self, flags: int) -> None:  # noqa: N802
        """Flush."""
        super().xSync(flags)
        self._recording.done.append(Flush(self._name))


class _Cursor:
    """As much of a DB-API cursor as SQLAlchemy needs."""

    arraysize = 1
    lastrowid = None

    def __init__(self, connection: apsw.Connection) -> None:
        self._connection = connection
        self._rows: list[tuple[Any, ...]] = []
        self.description: list[tuple[Any, ...]] | None = None
        self.rowcount = -1

    def execute(self, statement: str, parameters: Sequence[Any] = ()) -> None:
        """Run a statement to its end."""
        cursor = self._connection.cursor()
        before = self._connection.total_changes()
        self.description = None
        cursor.exec_trace = self._described  # afterwards it is too late where there are no rows
        cursor.execute(statement, tuple(parameters))
        self._rows = list(cursor)
        self.rowcount = self._connection.total_changes() - before

    def _described(self, cursor: apsw.Cursor, _statement: str, _values: object) -> bool:
        self.description = [(one[0], None, None, None, None, None, None) for one in cursor.get_description()] or None
        return True

    def executemany(self, statement: str, many: Sequence[Sequence[Any]]) -> None:
        """Run a statement with each of several sets of values."""
        before = self._connection.total_changes()
        self._connection.cursor().executemany(statement, [tuple(one) for one in many])
        self.description, self.rowcount = None, self._connection.total_changes() - before

    def fetchone(self) -> tuple[Any, ...] | None:
        """Return the next row."""
        return self._rows.pop(0) if self._rows else None

    def fetchmany(self, size: int = 1) -> list[tuple[Any, ...]]:
        """Return some rows."""
        found, self._rows = self._rows[:size], self._rows[size:]
        return found

    def fetchall(self) -> list[tuple[Any, ...]]:
        """Return all other rows."""
        found, self._rows = self._rows, []
        return found

    def close(self) -> None:
        """Nothing is held."""


class _Connection:
    """As much of a DB-API connection as SQLAlchemy needs."""

    isolation_level: ClassVar[str | None] = None

    def __init__(self, file: str, vfs: str) -> None:
        self._connection = apsw.Connection(file, vfs=vfs)
        # Without shared memory, which a VFS in Python does not have, a log needs the file for itself.
        self._connection.execute("PRAGMA locking_mode = EXCLUSIVE")

    def cursor(self) -> _Cursor:
        """Return a cursor."""
        return _Cursor(self._connection)

    def create_function(self, *_: object, **__: object) -> None:
        """Regular expressions are not used."""

    def commit(self) -> None:
        """End the transaction, if there is one."""
        if self._connection.in_transaction:
            self._connection.execute("COMMIT")

    def rollback(self) -> None:
        """Undo the transaction, if there is one."""
        if self._connection.in_transaction:
            self._connection.execute("ROLLBACK")

    def close(self) -> None:
        """Close."""
        self._connection.close()


@contextmanager
def recorded(recording: Recording, but: str = "") -> Iterator[None]:
    """Let ledgers write through the recording; ``but``: a pragma that is laid over the product's own, a mistake."""
    name = f"recorded-{uuid4().hex}"
    vfs = _Vfs(name, recording)

    def writing(url: sa.URL) -> sa.Engine:
        made = sa.create_engine(url, pool_size=1, max_overflow=0, creator=lambda: _Connection(str(url.database), name))
        sa.event.listen(made, "connect", engines._durable_sqlite)
        if but:
            sa.event.listen(made, "connect", lambda raw, _: engines.execute(raw, but))
        sa.event.listen(made, "begin", engines._begin_immediate)
        return made

    with mock.patch("app.store.ledger.writing", writing):
        yield
    vfs.unregister()


def written(directory: Path, but: str = "") -> Recording:
    """Open a ledger and commit batch after batch: a job, its event, and every other time a change of the one before."""
    recording = Recording()
    with recorded(recording, but):
        ledger = SqlLedger(f"sqlite:///{directory / NAME}", "P1", "me", lambda: Timestamp(1000.0))
        ledger.load()
        for number in range(1, BATCHES + 1):
            ledger.commit((job(number), event(number, f"J{number}")))
            recording.acknowledged.append(len(recording.done))
        ledger.close()
    return recording


def lost(files: dict[str, bytes], known: int, directory: Path) -> str:
    """Return what is wrong with a disk after a cut; nothing if every acknowledged batch is there, and each whole."""
    for old in directory.iterdir():
        old.unlink()
    for name, content in files.items():
        (directory / name).write_bytes(content)
    if not known and NAME not in files:
        return ""
    try:
        damage, jobs, events = _found(directory / NAME, known)
    except sqlite3.DatabaseError as wrong:
        return f"{known} batches were acknowledged; {wrong}"
    if damage:
        return f"damaged: {damage}"
    if jobs != events or jobs != list(range(1, len(jobs) + 1)):
        return f"a transaction is there in part: jobs {jobs}, events {events}"
    return f"{known} batches were acknowledged, {len(jobs)} are there" if len(jobs) < known else ""


def _found(file: Path, known: int) -> tuple[str, list[int], list[int]]:
    """Return what is damaged in a database, and the numbers of its jobs and events."""
    with closing(sqlite3.connect(file)) as connection:
        found = connection.execute("PRAGMA integrity_check").fetchall()
        if found != [("ok",)]:
            return str(found[:3]), [], []
        if not known and not connection.execute("SELECT 1 FROM sqlite_master WHERE name = 'jobs'").fetchall():
            return "", [], []
        jobs = [number for (number,) in connection.execute("SELECT number FROM jobs ORDER BY number")]
        events = [number for (number,) in connection.execute("SELECT seq FROM events ORDER BY seq")]
        return "", jobs, events


def reopened(files: dict[str, bytes], directory: Path) -> int:
    """Open what a cut left by the ordinary ledger; return how many jobs it goes on with."""
    lost(files, 0, directory)
    ledger = SqlLedger(f"sqlite:///{directory / NAME}", "P1", "the next one", lambda: Timestamp(2000.0))
    try:
        return len(ledger.load().jobs)
    finally:
        ledger.close()


def cuts(recording: Recording, number: int, seed: int, told: Callable[[int, str], None]) -> int:
    """Cut the power so many times at drawn moments; ``told`` of each that lost something. Returns how many did."""
    draw, bad = random.Random(seed), 0
    with TemporaryDirectory() as directory:
        for one in range(number):
            moment = draw.randrange(len(recording.done) + 1)
            wrong = lost(cut(recording, moment, draw), recording.known_at(moment), Path(directory))
            if wrong:
                bad += 1
                told(one, wrong)
    return bad


def main() -> int:
    """Record, cut, print, and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--cuts", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    given = parser.parse_args()
    with TemporaryDirectory() as directory:
        recording = written(Path(directory))
    bad = cuts(recording, given.cuts, given.seed, lambda one, wrong: print(f"cut {one}: {wrong}"))
    print(f"{given.cuts} power cuts over {len(recording.done)} writes and flushes: {bad} lost something acknowledged")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
