"""Backups: a plant's database as one SQLite file, whatever it is kept in, and such a file put back, on either database.

A backup is one moment of the plant, taken while a controller runs on it. It is an ordinary database of ours with a mark in its
name only: ``hoistway db`` and ``sqlite3`` read it. Playback is no part of it.
"""

import os
import sqlite3
from collections.abc import Iterator
from contextlib import closing, contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

import sqlalchemy as sa

from app.domain.errors import StoreError
from app.domain.units import Timestamp
from app.domain.versions import VersionState
from app.store import tables
from app.store.chain import head_of
from app.store.engine import file_of, parsed, reading, told, writing
from app.store.lease import LEASE_SECONDS, Lease
from app.store.opening import opened
from app.store.schema import create, current, newest

ROWS = 5_000
"""Rows that are copied of another database at a time. Our choice."""
PRIVATE = 0o600
"""A backup holds the hashes of passwords and keys."""
OTHERS = frozenset({"lease"})
"""Tables whose rows belong to the running controller, not to the plant."""


@dataclass(frozen=True, slots=True)
class Stock:
    """What a backup holds: the plant, the schema, how many commits and jobs, the last row of the audit as number and hash."""

    plant: str
    schema: str
    commits: int
    jobs: int
    audit: tuple[int, str]


def back_up(url: str, target: Path) -> Stock:
    """Write the database at one moment to a new file, readable by its owner only, durable on return; return what it holds.

    Raises StoreError: there is no such database, it has another schema than ours (``hoistway db upgrade``), the file exists
    already or cannot be written, or what was written does not hold together. Nothing is left behind then.
    """
    made = parsed(url)
    source = file_of(made)
    if made.get_backend_name() == "sqlite" and (source is None or not source.exists()):
        raise StoreError(f"there is no database {made.database}", remedy="See --url.")
    _refuse_other_schema(url)
    with _new(target) as partial:
        if source is not None:
            _copy_file(source, partial)
        else:
            _copy_rows(made, partial)
        return look(partial)


def look(file: Path) -> Stock:
    """Return what a backup holds. Raises StoreError: it is none, it is damaged, or a newer Hoistway made it."""
    if not file.is_file():
        raise StoreError(f"there is no backup {file}", remedy="Name a file that hoistway db backup has written.")
    engine = reading(_url(file))
    try:
        with told(f"{file} is no backup of a plant"), engine.connect() as connection:
            found = [str(row[0]) for row in connection.execute(sa.text("PRAGMA integrity_check(5)"))]
            if found != ["ok"]:
                raise StoreError(f"{file} is damaged: {'; '.join(found)}", remedy="Take an earlier backup.")
            return _stock(connection, file)
    finally:
        engine.dispose()


def put_back(file: Path, url: str, holder: str, now: Timestamp) -> tuple[Stock, Path | None]:
    """Replace the database by a backup and mark it, so that the next start holds every vehicle (COMMANDS 3.8).

    Returns what the backup holds, and the file in which what was there before is kept (None if there was nothing). An older
    schema is brought up to date. Raises PlantHeld while a controller runs on the database, StoreError where the backup or the
    database cannot be used, or keeps another plant; then nothing has changed.
    """
    made = parsed(url)
    if made.get_backend_name() == "sqlite" and file_of(made) is None:
        raise StoreError("a database in memory cannot be put back", remedy="Write sqlite:///var/plant.db.")
    stock = look(file)
    if (path := file_of(made)) is not None and path == file.resolve():
        raise StoreError(f"{file} is the database itself", remedy="Name the backup.")
    engine = writing(made)
    try:
        lease = opened(made, engine, stock.plant, holder, now, LEASE_SECONDS)
        try:
            _refuse_other_plant(engine, stock.plant)
            before = _keep(url, file, now)
            _renewed(engine, lease)
            with _prepared(file, file.resolve().parent if path is None else path.parent, now) as prepared:
                _fill(engine, prepared, lease) if path is None else _exchange(engine, prepared, path)
        finally:
            lease.release()
    finally:
        engine.dispose()
    return stock, before


def _renewed(engine: sa.Engine, lease: Lease) -> None:
    """Keep the lease after something that may take long. Raises PlantHeld: another controller has come meanwhile."""
    with told("the lease of the plant cannot be renewed"), engine.begin() as connection:
        lease.verify(connection)


def _refuse_other_schema(url: str) -> None:
    engine = reading(parsed(url))
    try:
        with told("the database cannot be opened"), engine.connect() as connection:
            found = current(connection)
    finally:
        engine.dispose()
    if found != newest():
        remedy = "Bring it up to date: hoistway db upgrade." if found else "There is nothing to keep yet."
        raise StoreError(f"the database has schema {found or 'none'}, not {newest()}", remedy=remedy)


def _refuse_other_plant(engine: sa.Engine, plant: str) -> None:
    with told("the database cannot be opened"), engine.connect() as connection:
        found = connection.execute(sa.select(tables.plant.c.name)).scalar()
    if found not in (None, plant):
        raise StoreError(
            f"the database keeps plant {found}, the backup plant {plant}", remedy="See --url and the file."
        )


def _keep(url: str, file: Path, now: Timestamp) -> Path | None:
    """Back up what is about to be replaced, beside the backup; nothing where no plant was kept yet."""
    engine = reading(parsed(url))
    try:
        with told("the database cannot be read"), engine.connect() as connection:
            if connection.execute(sa.select(tables.plant.c.one)).scalar() is None:
                return None
    finally:
        engine.dispose()
    target = file.with_name(f"{file.name}.replaced-{int(now)}")
    back_up(url, target)
    return target


@contextmanager
def _prepared(file: Path, directory: Path, now: Timestamp) -> Iterator[Path]:
    """Give a copy of the backup with our schema and the mark, in a directory where it may be renamed from; it goes away."""
    copy = directory / f".{file.name}.{os.getpid()}"
    try:
        with told(f"the backup cannot be prepared in {directory}"):
            _copy_file(file, copy)
            engine = writing(_url(copy))
            try:
                opened(_url(copy), engine, "(any)", "hoistway db restore", now, LEASE_SECONDS).release()
                with engine.begin() as connection:
                    connection.execute(tables.restored.delete())
                    _let_no_layout_be_awaited(connection)
                    connection.execute(tables.restored.insert(), {"one": 1, "at": now, "source": str(file)})
                _into_one_file(engine)
            finally:
                engine.dispose()
        yield copy
    finally:
        _remove(copy)


def _let_no_layout_be_awaited(connection: sa.Connection) -> None:
    """A wish of that time to change the layout is no wish of today."""
    versions = tables.plant_versions
    never = versions.c.activated.is_(None)
    rest = sa.case((never, VersionState.STAGED.value), else_=VersionState.FORMER.value)
    awaited = versions.c.state == VersionState.AWAITED.value
    connection.execute(versions.update().where(awaited).values(state=rest, note="a backup was put back"))


def _exchange(engine: sa.Engine, prepared: Path, path: Path) -> None:
    """Put the file in the place of a database that nobody uses."""
    _into_one_file(engine)
    engine.dispose()
    for end in ("-wal", "-shm"):
        Path(f"{path}{end}").unlink(missing_ok=True)
    with _disk(path):
        _flush(prepared)
        mode = path.stat().st_mode & 0o777
        prepared.chmod(mode)
        with suppress(PermissionError):
            os.chown(prepared, path.stat().st_uid, path.stat().st_gid)
        prepared.replace(path)
        _flush(path.parent)


def _fill(engine: sa.Engine, prepared: Path, lease: Lease) -> None:
    """Replace the rows of a database by those of the file, in one transaction that nobody else's controller can come between."""
    source = reading(_url(prepared))
    try:
        with told("the backup cannot be put back"), source.connect() as rows, engine.begin() as connection:
            lease.verify(connection)
            for table in reversed(tables.metadata.sorted_tables):
                if table.name not in OTHERS:
                    connection.execute(table.delete())
            for table in tables.metadata.sorted_tables:
                if table.name not in OTHERS:
                    _pour(rows, connection, table)
    finally:
        source.dispose()


def _copy_file(source: Path, target: Path) -> None:
    """Copy an SQLite database that may be written to meanwhile, at one moment."""
    with _disk(target):
        target.touch(mode=PRIVATE)
        engine = reading(_url(source))
        try:
            with closing(engine.raw_connection()) as come_from, closing(sqlite3.connect(target)) as goes_to:
                whole: sqlite3.Connection = come_from.driver_connection  # type: ignore[assignment]
                whole.backup(goes_to)  # in one go: a commit in between would make it begin again
        except (sqlite3.Error, sa.exc.SQLAlchemyError) as wrong:
            raise StoreError(f"{source} cannot be copied: {wrong}", remedy="See that the disk has room.") from wrong
        finally:
            engine.dispose()


def _copy_rows(made: sa.URL, target: Path) -> None:
    """Copy the rows of another database, as they are in one snapshot, into a new SQLite file."""
    target.touch(mode=PRIVATE)
    source, engine = reading(made), writing(_url(target))
    try:
        with told("the database cannot be copied"), source.connect() as connected:
            snapshot = connected.execution_options(isolation_level="REPEATABLE READ")
            with snapshot.begin(), engine.begin() as connection:
                create(connection)
                connection.execute(
                    sa.text("CREATE TABLE alembic_version (version_num VARCHAR(32) NOT NULL PRIMARY KEY)")
                )
                connection.execute(sa.text("INSERT INTO alembic_version VALUES (:version)"), {"version": newest()})
                for table in tables.metadata.sorted_tables:
                    if table.name not in OTHERS:
                        _pour(snapshot, connection, table)
        _into_one_file(engine)
    finally:
        source.dispose()
        engine.dispose()


def _pour(source: sa.Connection, target: sa.Connection, table: sa.Table) -> None:
    found = source.execution_options(yield_per=ROWS).execute(sa.select(table))
    for some in found.mappings().partitions():
        target.execute(table.insert(), [dict(row) for row in some])


def _stock(connection: sa.Connection, file: Path) -> Stock:
    schema = current(connection)
    row = connection.execute(sa.select(tables.plant)).one_or_none() if schema else None
    if schema is None or row is None:
        raise StoreError(f"{file} keeps no plant", remedy="Name a file that hoistway db backup has written.")
    jobs = connection.execute(sa.select(sa.func.count()).select_from(tables.jobs)).scalar_one()
    chained = any(column["name"] == "hash" for column in sa.inspect(connection).get_columns("audit"))
    return Stock(row.name, schema, row.commits, jobs, head_of(connection) if chained else (0, ""))


@contextmanager
def _new(target: Path) -> Iterator[Path]:
    """Give a file beside the target that becomes the target at the end, whole and on the disk, or goes away."""
    if target.exists():
        raise StoreError(
            f"{target} exists already", remedy="A backup does not replace another one: give it a new name."
        )
    partial = target.with_name(f".{target.name}.{os.getpid()}")
    try:
        yield partial
        with _disk(target):
            _flush(partial)
            os.link(partial, target)
            _flush(target.resolve().parent)
    finally:
        _remove(partial)


def _remove(database: Path) -> None:
    """Remove an SQLite database and what may lie beside it."""
    for end in ("", "-wal", "-shm", ".lock"):
        Path(f"{database}{end}").unlink(missing_ok=True)


@contextmanager
def _disk(target: Path) -> Iterator[None]:
    try:
        yield
    except OSError as wrong:
        remedy = "See that the directory exists, that this user may write in it, and that the disk has room."
        raise StoreError(f"{target} cannot be written: {wrong.strerror}", remedy=remedy) from wrong


def _into_one_file(engine: sa.Engine) -> None:
    """Take what the log beside an SQLite file holds into the file."""
    with told("the database cannot be finished"), closing(engine.raw_connection()) as raw:
        cursor = raw.cursor()
        busy = cursor.execute("PRAGMA wal_checkpoint(TRUNCATE)").fetchone()[0]
        cursor.execute("PRAGMA journal_mode = DELETE")
        cursor.close()
    if busy:
        raise StoreError("another program has the database open", remedy="Close it, then try again.")


def _flush(path: Path) -> None:
    descriptor = os.open(path, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)


def _url(file: Path) -> sa.URL:
    return sa.URL.create("sqlite+pysqlite", database=str(file))
