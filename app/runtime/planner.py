"""The process that computes routing tables: pickled tasks in, and for each a file with the tables out.

The plan comes with the first task only, since it stays the same as long as the track does.

It ends when its standard input does, so that it never outlives the controller. Tables go through a file in shared memory (or on
disk, where that is too small) that the controller maps and unlinks: a table of many megabytes is copied by nobody.
"""

import mmap
import os
import pickle
import signal
import struct
import sys
import tempfile
from pathlib import Path
from typing import BinaryIO, TypeAlias

import numpy as np

from app.planning.tables import Tables, Task, compute

LENGTH = struct.Struct("<Q")
"""Before each message: its length in bytes."""
SHARED_MEMORY = Path("/dev/shm")  # noqa: S108 (files are made there by mkstemp)
NICE = 15
"""Our choice: less urgent than the controller, by so many steps."""
Array: TypeAlias = "tuple[tuple[int, ...], str, int]"
"""Shape, dtype and offset in the file of an array."""


def packed(message: object) -> bytes:
    """Return a message as it goes through a pipe."""
    body = pickle.dumps(message, pickle.HIGHEST_PROTOCOL)
    return LENGTH.pack(len(body)) + body


def told(task: Task, before: Task | None) -> bytes:
    """Return a task as the process takes it that had another one ``before``: without the plan, if it is the same."""
    plan = None if before is not None and task.plan is before.plan else task.plan
    return packed((plan, task.version, task.seconds, task.shut))


def heard(body: bytes, before: Task | None) -> Task:
    """Return the task that ``told`` has packed. Raises ValueError: it is without a plan, and there was none before."""
    plan, version, seconds, shut = pickle.loads(body)  # noqa: S301 (from the process that started this one)
    if plan is None:
        if before is None:
            raise ValueError("the first task has a plan")
        plan = before.plan
    return Task(version, plan, seconds, shut)


def clear(process: int) -> None:
    """Remove what a planner process that has ended left behind."""
    for folder in (SHARED_MEMORY, Path(tempfile.gettempdir())):
        for left in folder.glob(f"hoistway-{process}-*.tables"):
            left.unlink(missing_ok=True)


def written(tables: Tables) -> tuple[str, int, list[Array]]:
    """Write tables into a new file. Returns its name, their version, and where each array is."""
    arrays = [np.ascontiguousarray(array) for array in (tables.seconds, tables.hop, tables.parts, tables.at)]
    places: list[Array] = []
    end = 0
    for array in arrays:
        places.append((array.shape, array.dtype.str, end))
        end += -(-array.nbytes // 64) * 64
    handle, name = _file(max(end, 1))
    with open(handle, "r+b") as file, mmap.mmap(file.fileno(), 0) as memory:  # noqa: PTH123
        for array, (_, _, offset) in zip(arrays, places, strict=True):
            memory[offset : offset + array.nbytes] = array.data.cast("B") if array.size else b""
    return name, tables.version, places


def _file(size: int) -> tuple[int, str]:
    """Make a file of this size, in memory if it fits there."""
    for folder in (str(SHARED_MEMORY) if SHARED_MEMORY.is_dir() else None, None):
        handle, name = tempfile.mkstemp(prefix=f"hoistway-{os.getpid()}-", suffix=".tables", dir=folder)
        try:
            if hasattr(os, "posix_fallocate"):
                os.posix_fallocate(handle, 0, size)
            else:
                os.truncate(handle, size)
        except OSError:
            os.close(handle)
            Path(name).unlink()
            if folder is None:
                raise
            continue
        return handle, name
    raise OSError("no folder for temporary files")


def read(name: str, version: int, places: list[Array]) -> Tables:
    """Map the tables in a file, and unlink it: it is gone with the last of their arrays."""
    path = Path(name)
    with path.open("rb") as file:
        memory = mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ)
    path.unlink()
    seconds, hop, parts, at = (
        np.frombuffer(memory, dtype, int(np.prod(shape)), offset).reshape(shape) for shape, dtype, offset in places
    )
    return Tables(version, seconds, hop, parts, at)


def serve(tasks: BinaryIO, answers: BinaryIO) -> None:
    """Compute task after task until there are no more."""
    task: Task | None = None
    while len(head := tasks.read(LENGTH.size)) == LENGTH.size:
        body = tasks.read(LENGTH.unpack(head)[0])
        task = heard(body, task)
        answers.write(packed(written(compute(task))))
        answers.flush()


def main() -> None:
    """Serve the process that started this one."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the controller; its end is ours
    if hasattr(os, "nice"):
        os.nice(NICE)
    try:
        serve(sys.stdin.buffer, sys.stdout.buffer)
    finally:
        clear(os.getpid())


if __name__ == "__main__":
    main()
