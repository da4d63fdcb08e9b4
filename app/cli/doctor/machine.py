"""The machine: Python, disk, open files."""

from __future__ import annotations

import os
import platform
import resource
import shutil
import statistics
import subprocess
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from app.cli.doctor.found import Found, doubtful, well, wrong
from app.cli.plainly import said

LEAST, FEW = 100 << 20, 1 << 30
"""Bytes on the disk below which a controller soon stops, and below which a person should look. Our choice."""
SLOW = 0.05
"""Seconds for a flush above which commands wait noticeably. Our choice."""
FLUSHES = 9
OWN_FILES = 100
"""Files that the controller needs besides its connections, with room to spare. Our choice."""


def looks() -> Iterator[Found]:
    """Look at Python and at the clock."""
    cores = os.cpu_count() or 1
    said = f"{platform.system()} {platform.machine()}, Python {platform.python_version()}, {cores} processors"
    if cores < 2:
        yield doubtful("machine", said, "The planner wants a processor beside the controller's.")
    else:
        yield well("machine", said)
    yield from _synchronized()


def _synchronized() -> Iterator[Found]:
    """Ask systemd whether the clock is kept; where it cannot be asked nothing is said."""
    command = shutil.which("timedatectl")
    if command is None:
        return
    try:
        asked = subprocess.run(
            [command, "show", "--property=NTPSynchronized", "--value"],
            capture_output=True,
            text=True,
            timeout=5,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return
    said = asked.stdout.strip()
    if said == "yes":
        yield well("clock", "kept by NTP")
    elif said == "no":
        yield doubtful(
            "clock", "not kept by NTP", "Times of events and audit are this clock's: run chrony or timesyncd."
        )


def disk(database: Path) -> Iterator[Found]:
    """Look whether this user may write where an SQLite database is, how much room there is, and how long a flush takes."""
    directory = database.parent
    if not directory.is_dir():
        yield wrong("disk", f"{directory} does not exist", f"Make it: mkdir -p {directory}")
        return
    for path in (directory, database):
        if path.exists() and not os.access(path, os.W_OK):
            yield wrong("disk", f"this user may not write {path}", f"Run it as its owner, or chown {path}.")
            return
    free = shutil.disk_usage(directory).free
    told = f"{free / 1e9:.1f} GB free in {directory}"
    if free < LEAST:
        yield wrong("disk", told, "Make room: a full disk stops all commands.")
    elif free < FEW:
        yield doubtful("disk", told, "Make room, or keep less: HOISTWAY_HISTORY_DAYS, HOISTWAY_PLAYBACK_MEGABYTES.")
    else:
        yield well("disk", told)
    yield _flushing(directory)


def _flushing(directory: Path) -> Found:
    took = []
    try:
        with tempfile.TemporaryFile(dir=directory) as file:
            for _ in range(FLUSHES):
                file.write(bytes(4096))
                file.flush()
                begin = time.perf_counter()
                os.fsync(file.fileno())
                took.append(time.perf_counter() - begin)
    except OSError as error:
        return wrong("disk", f"{directory} cannot be written to: {said(error)}", "Make room, or mount it for writing.")
    median = statistics.median(took)
    told = f"a flush takes {median * 1000:.1f} ms"
    if median > SLOW:
        return doubtful(
            "disk", told, "Every command waits for one: use a local disk, or find out what else writes to this one."
        )
    return well("disk", told)


def room_for(vehicles: int, connections: int) -> Iterator[Found]:
    """Look whether as many files may be open as vehicles and callers need."""
    _, most = resource.getrlimit(resource.RLIMIT_NOFILE)
    needed = vehicles + connections + OWN_FILES
    if most != resource.RLIM_INFINITY and most < needed:
        remedy = "Raise it (LimitNOFILE= in the systemd unit, ulimit -Hn), or lower HOISTWAY_CONNECTIONS."
        yield doubtful(
            "open files", f"at most {most}; {vehicles} vehicles and {connections} callers need {needed}", remedy
        )
    else:
        yield well("open files", "unlimited" if most == resource.RLIM_INFINITY else f"up to {most}, {needed} needed")
