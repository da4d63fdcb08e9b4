"""Computes routing tables beside the event loop: in a process of its own, or in slices if there can be none."""

import asyncio
import contextlib
import os
import pickle
import sys
from asyncio.subprocess import PIPE, Process
from collections.abc import Callable, Sequence
from concurrent.futures import ThreadPoolExecutor
from threading import get_native_id
from typing import Protocol

from structlog.typing import FilteringBoundLogger

from app.planning.tables import Tables, Task, computing
from app.runtime.planner import LENGTH, NICE, clear, read, told
from app.runtime.telemetry import logger

COMMAND = (sys.executable, "-m", "app.runtime.planner")
TRIES = 3
"""How often a task is given to a process before it is computed here. Our choice."""
PAUSE = 0.5
"""Seconds before a process that died is started again. Our choice."""
LEAVE_WITHIN = 2.0
"""Seconds for the process to end by itself when the controller stops. Our choice."""
SLICE_PAUSE = 0.001
"""Seconds that the loop has for others between two slices. Our choice."""


def less_urgent() -> None:
    """Let the calling thread have a processor when nobody else wants it, where threads have an urgency of their own."""
    if sys.platform == "linux":
        os.setpriority(os.PRIO_PROCESS, get_native_id(), NICE)


class Seen(Protocol):
    """Takes durations."""

    def see(self, value: float) -> None:
        """Count a value."""
        ...


class Computed(Protocol):
    """Counts what was computed: ``table_seconds`` from the task to its tables, ``table_failures`` processes lost."""

    @property
    def table_seconds(self) -> Seen:
        """Takes seconds."""
        ...

    table_failures: int


class Replanner:
    """Computes one task after the other and tells ``deliver`` of each, on the loop. The process starts with the first task.

    A process that dies is logged and started again; nothing here ends the controller.
    """

    def __init__(
        self, deliver: Callable[[Tables], None], command: Sequence[str] = COMMAND, figures: Computed | None = None
    ) -> None:
        self._figures = figures
        self._deliver = deliver
        self._command = command
        self._log: FilteringBoundLogger = logger(part="planner")
        self._process: Process | None = None
        self._aside = ThreadPoolExecutor(1, "hoistway-tables", initializer=less_urgent)
        self._told: Task | None = None
        """What the process was given last."""
        self._tasks: asyncio.Queue[Task] = asyncio.Queue()
        self._running: asyncio.Task[None] | None = None

    @property
    def pid(self) -> int | None:
        """The process that computes, if there is one."""
        return None if self._process is None else self._process.pid

    def submit(self, task: Task) -> None:
        """Compute this after what waits."""
        self._tasks.put_nowait(task)
        if self._running is None:
            self._running = asyncio.get_running_loop().create_task(self._run())

    async def stop(self) -> None:
        """End the process and the thread, for good. What is not computed yet never will be."""
        if self._running is not None:
            self._running.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._running
            self._running = None
        await self._end()
        self._aside.shutdown(wait=False)

    async def _run(self) -> None:
        used: list[Tables] = []
        loop = asyncio.get_running_loop()
        while True:
            task = await self._tasks.get()
            began = loop.time()
            tables = await self._computed(task)
            if self._figures is not None:
                self._figures.table_seconds.see(loop.time() - began)
            self._deliver(tables)
            # The last to hold the tables before these is a thread: unmapping 60 MB takes some 8 ms, but not the GIL.
            await loop.run_in_executor(self._aside, used.clear)
            used.append(tables)

    async def _computed(self, task: Task) -> Tables:
        for _ in range(TRIES):
            try:
                return await self._elsewhere(task)
            except (OSError, EOFError, ValueError, pickle.UnpicklingError) as why:
                if self._figures is not None:
                    self._figures.table_failures += 1
                self._log.warning("planner process lost", reason=str(why) or type(why).__name__)
                await self._end()
                await asyncio.sleep(PAUSE)
        self._log.error("no planner process: routes are planned in the controller, in slices")
        return await self._here(task)

    async def _elsewhere(self, task: Task) -> Tables:
        """Let the process compute. Raises OSError, EOFError: there is none, or it died."""
        if self._process is None:
            self._process = await asyncio.create_subprocess_exec(*self._command, stdin=PIPE, stdout=PIPE)
            self._log.info("planner process started", pid=self._process.pid)
        stdin, stdout = self._process.stdin, self._process.stdout
        assert stdin is not None
        assert stdout is not None
        stdin.write(told(task, self._told))
        self._told = task
        await stdin.drain()
        (length,) = LENGTH.unpack(await stdout.readexactly(LENGTH.size))
        found = pickle.loads(await stdout.readexactly(length))  # noqa: S301 (from our own child)
        return await asyncio.get_running_loop().run_in_executor(self._aside, read, *found)

    async def _here(self, task: Task) -> Tables:
        steps = computing(task)
        while True:
            try:
                next(steps)
            except StopIteration as end:
                tables: Tables = end.value
                return tables
            await asyncio.sleep(SLICE_PAUSE)

    async def _end(self) -> None:
        process, self._process, self._told = self._process, None, None
        if process is None:
            return
        if process.stdin is not None:
            process.stdin.close()
        try:
            await asyncio.wait_for(process.wait(), LEAVE_WITHIN)
        except TimeoutError:
            with contextlib.suppress(ProcessLookupError):
                process.kill()
            await process.wait()
        clear(process.pid)
