"""One controller per plant (COMMANDS 3.7): whoever writes holds the lease, and every commit looks."""

import fcntl
import math
import os
import struct
import sys
from contextlib import suppress
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, Protocol

import sqlalchemy as sa
from sqlalchemy.dialects import postgresql

from app.domain.errors import PlantHeld, StoreError
from app.domain.units import Seconds, Timestamp
from app.store.engine import told
from app.store.tables import lease

LEASE_SECONDS = Seconds(10.0)
"""How long a PostgreSQL lease lasts without renewal: a killed controller's plant is free after that. Our choice."""

UNNAMED = "a controller that gave no name"
_FLOCK = "hhqqi0q"
"""struct flock: kind, whence, start, length (0: to the end, wherever that is), process."""
_WHOLE = struct.pack(_FLOCK, fcntl.F_WRLCK, os.SEEK_SET, 0, 0, 0)
_PAUSE_SECONDS = 0.1
_STOPPED = "Restart it: it then finds out what happened meanwhile before it sends anything."


class Lease(Protocol):
    """The right to write."""

    @property
    def seconds(self) -> Seconds:
        """How long the right lasts after :meth:`verify` without another; infinite if it does not run out."""
        ...

    def verify(self, connection: sa.Connection) -> None:
        """Make sure, inside the transaction of ``connection``, that the right is ours. Raises PlantHeld."""
        ...

    def release(self) -> None:
        """Let go."""
        ...


def _when(seconds: float) -> str:
    return datetime.fromtimestamp(seconds, UTC).strftime("%Y-%m-%d %H:%M:%S UTC")


class NoLease:
    """For a database in memory, which nobody else can see."""

    seconds = Seconds(math.inf)

    def verify(self, connection: sa.Connection) -> None:
        """Nothing to look at."""

    def release(self) -> None:
        """Nothing to let go."""


class FileLease:
    """An exclusive lock on ``<database>.lock``; its text says who. The kernel lets it go when the process ends.

    It is a flock. A flock can only be tried, and who tries one keeps a controller out for that moment: so the holder has a lock
    of the other kind too (fcntl_locking(2), "open file description locks"), which anybody can ask about: :func:`holder_of`.

    The file stays: to remove it while another opens it would give the plant to two. A process made by ``fork`` without
    ``exec`` shares the lock.
    """

    seconds = Seconds(math.inf)

    def __init__(self, database: Path, plant: str, holder: str, since: Timestamp) -> None:
        self.path = Path(f"{database}.lock")
        try:
            self._fd = os.open(self.path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
        except OSError as cause:
            raise StoreError(
                f"cannot open {self.path}: {cause.strerror}",
                remedy="See that the directory exists and that this user may write in it.",
            ) from cause
        try:
            fcntl.flock(self._fd, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except OSError as cause:
            who = os.pread(self._fd, 1000, 0).decode(errors="replace").strip() or UNNAMED
            os.close(self._fd)
            raise PlantHeld(
                f"{database} is held by {who}",
                remedy="Stop that controller first, or give this one a database of its own.",
            ) from cause
        os.ftruncate(self._fd, 0)
        os.pwrite(self._fd, f"{holder}, for plant {plant}, since {_when(since)}\n".encode(), 0)
        if sys.platform == "linux":
            with suppress(OSError):  # a file system without them: nobody sees the holder, but it holds
                fcntl.fcntl(self._fd, fcntl.F_OFD_SETLK, _WHOLE)

    def verify(self, connection: sa.Connection) -> None:
        """Look whether the file is still the one that was locked: removed, it no longer keeps others out."""
        try:
            present = self.path.stat().st_ino
        except OSError:
            present = -1
        if present != os.fstat(self._fd).st_ino:
            raise PlantHeld(f"{self.path} was removed: another controller may have taken the plant", remedy=_STOPPED)

    def release(self) -> None:
        """Empty the file and unlock it."""
        with suppress(OSError):
            os.ftruncate(self._fd, 0)
        os.close(self._fd)


def holder_of(database: Path) -> str | None:
    """Return who has locked a database, as far as can be seen: on Linux, and where the file system has such locks.

    It takes no lock: a controller that starts just now is not disturbed.
    """
    if sys.platform != "linux":
        return None
    try:
        descriptor = os.open(f"{database}.lock", os.O_RDONLY | os.O_CLOEXEC)
    except FileNotFoundError:
        return None
    try:
        found, *_ = struct.unpack(_FLOCK, fcntl.fcntl(descriptor, fcntl.F_OFD_GETLK, _WHOLE))
        if found == fcntl.F_UNLCK:
            return None
        return os.pread(descriptor, 1000, 0).decode(errors="replace").strip() or UNNAMED
    except OSError:
        return None
    finally:
        os.close(descriptor)


NOW = sa.cast(sa.func.extract("epoch", sa.func.clock_timestamp()), sa.Double)
WHO = sa.select(lease, NOW.label("now"))


def pause(connection: sa.Connection, seconds: float) -> None:
    """Let the database wait: time passes by its clock, which alone counts here."""
    connection.execute(sa.select(sa.func.pg_sleep(seconds)))


class RowLease:
    """A row with a token and a deadline by the database's clock, which alone decides (PostgreSQL).

    A plant whose last holder's deadline is still ahead is waited for, one lease long at most; a holder that renews meanwhile
    is alive and keeps it. :meth:`verify` locks the row until its transaction ends, so that nobody takes the lease between
    the check and the commit.
    """

    def __init__(self, engine: sa.Engine, plant: str, holder: str, seconds: Seconds = LEASE_SECONDS) -> None:
        self.seconds = seconds
        self._engine = engine
        self._verify = (
            lease.update()
            .where(lease.c.token == sa.bindparam("ours"), lease.c.deadline > NOW)
            .values(deadline=NOW + seconds)
        )
        with told("the lease of the plant cannot be taken"):
            self._token = self._take(plant, holder)

    def _take(self, plant: str, holder: str) -> str:
        waited = 0.0
        seen: sa.Row[Any] | None = None
        while True:
            with self._engine.begin() as connection:
                found = connection.execute(WHO).one_or_none()
                if found is not None and seen is not None and found.deadline != seen.deadline:
                    raise _held(found)
                # A clock that was set back would keep a dead holder's plant: one lease long without renewal is enough.
                if found is None or found.deadline <= found.now or waited >= self.seconds:
                    token = connection.execute(self._take_from(found, plant, holder)).scalar()
                    if token is not None:
                        return str(token)
            seen = found
            with self._engine.begin() as connection:
                pause(connection, _PAUSE_SECONDS)
            waited += _PAUSE_SECONDS

    def _take_from(self, last: sa.Row[Any] | None, plant: str, holder: str) -> sa.Executable:
        """Return the statement that takes the lease unless somebody has renewed or taken it since ``last`` was read."""
        insert = postgresql.insert(lease).values(
            one=1,
            plant=plant,
            holder=holder,
            token=sa.cast(sa.func.gen_random_uuid(), sa.Text),
            since=NOW,
            deadline=NOW + self.seconds,
        )
        if last is None:
            return insert.on_conflict_do_nothing().returning(lease.c.token)
        given = {name: insert.excluded[name] for name in ("plant", "holder", "token", "since", "deadline")}
        same = sa.and_(lease.c.token == last.token, lease.c.deadline == last.deadline)
        return insert.on_conflict_do_update(index_elements=["one"], set_=given, where=same).returning(lease.c.token)

    def verify(self, connection: sa.Connection) -> None:
        """Renew the lease, if it is still ours and has not run out."""
        if connection.execute(self._verify, {"ours": self._token}).rowcount == 1:
            return
        found = connection.execute(WHO).one_or_none()
        if found is not None and found.token != self._token:
            raise _held(found)
        raise PlantHeld(
            f"this controller was stopped, or cut off from the database, for longer than {self.seconds:g} s: "
            "its lease of the plant has run out",
            remedy=_STOPPED,
        )

    def release(self) -> None:
        """Take the row away, if the database can be reached; otherwise the lease runs out by itself."""
        with suppress(sa.exc.DBAPIError), self._engine.begin() as connection:
            connection.execute(lease.delete().where(lease.c.token == self._token))


def _held(found: sa.Row[Any]) -> PlantHeld:
    return PlantHeld(
        f"plant {found.plant} is held by {found.holder}, since {_when(found.since)}",
        remedy="Stop that controller first, or give this one a database of its own.",
    )
