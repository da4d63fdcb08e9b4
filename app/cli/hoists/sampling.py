"""What a process spends its CPU on, and how late its event loop is."""

import asyncio
import os
import signal
import threading
import time
from collections import Counter
from collections.abc import Mapping
from pathlib import Path
from types import FrameType

SAMPLE_EVERY = 0.01
"""Seconds of CPU between two samples. Our choice: 3,000 in a minute of half a processor."""
LOOK_EVERY = 0.02
"""Seconds between two looks at how late the loop is. Our choice."""
LOOP = "event loop, epoll and receive"

PARTS: Mapping[str, str] = {
    "app.protocols": "sessions and codec",
    "app.wire": "sessions and codec",
    "app.control": "control",
    "app.fleet": "fleet",
    "app.fleet.dispatch": "dispatch",
    "app.fleet.parking": "dispatch",
    "app.fleet.views": "views",
    "app.planning": "planning",
    "app.store": "store",
    "app.runtime.lines": "lines and send",
    "app.runtime.hub": "read model and live",
    "app.runtime.showing": "read model and live",
    "app.runtime": "shell",
    "app.api": "API",
    "uvicorn": "API",
    "starlette": "API",
    "fastapi": "API",
    "app.cli.hoists.sampling": "this measurement",
}
"""Modules and the part that they belong to; the innermost counts, the longest name first."""
OWNERS = frozenset({"dispatch", "API"})
"""Parts that answer for all that they call."""


class Sampler:
    """Gives the CPU time of the main thread to parts of the program, by where it is each time a timer runs out.

    The timer counts the CPU time of the process; each sample weighs what the main thread has used since the last one, so that
    the sum is its CPU time to the microsecond, whatever other threads do.
    """

    def __init__(self) -> None:
        self.parts: Counter[str] = Counter()
        self._known: dict[str, str] = {}
        self._last = time.thread_time()

    def start(self) -> None:
        """Begin; to be called in the main thread."""
        signal.signal(signal.SIGPROF, self._take)
        self.clear()
        signal.setitimer(signal.ITIMER_PROF, SAMPLE_EVERY, SAMPLE_EVERY)

    def clear(self) -> None:
        """Forget what was counted."""
        self.parts.clear()
        self._last = time.thread_time()

    def stop(self) -> None:
        """Take no more samples."""
        signal.setitimer(signal.ITIMER_PROF, 0)
        signal.signal(signal.SIGPROF, signal.SIG_IGN)

    def _take(self, _number: int, frame: FrameType | None) -> None:
        now = time.thread_time()
        self.parts[self._part(frame)] += now - self._last  # type: ignore[assignment]  # seconds, not a count
        self._last = now

    def _part(self, frame: FrameType | None) -> str:
        found = ""
        while frame is not None:
            part = self._part_of(str(frame.f_globals.get("__name__", "")))
            if part in OWNERS:
                return part
            found = found or part
            frame = frame.f_back
        return found or LOOP

    def _part_of(self, module: str) -> str:
        part = self._known.get(module)
        if part is None:
            names = module.split(".")
            longest = (".".join(names[:count]) for count in range(len(names), 0, -1))
            part = self._known[module] = next((PARTS[name] for name in longest if name in PARTS), "")
        return part


class Lateness:
    """How long after its time a timer of the loop is served, in seconds: what a packet may have to wait.

    ``own``: without the time for which the kernel had given the processors to others, which no program can help.
    """

    def __init__(self) -> None:
        self.found: list[float] = []
        self.own: list[float] = []
        self._waited = waited()
        self._loop = asyncio.get_running_loop()
        self._due = self._loop.time() + LOOK_EVERY
        self._handle = self._loop.call_at(self._due, self._look)

    def stop(self) -> None:
        """Look no more."""
        self._handle.cancel()

    def _look(self) -> None:
        now = self._loop.time()
        late, waiting = max(0.0, now - self._due), waited()
        self.found.append(late)
        self.own.append(max(0.0, late - (waiting - self._waited)))
        self._waited = waiting
        self._due = now + LOOK_EVERY
        self._handle = self._loop.call_at(self._due, self._look)

    def figures(self) -> dict[str, float]:
        """Return median, 99th percentile and the most, in milliseconds."""
        return _spread(self.found)

    def own_figures(self) -> dict[str, float]:
        """Return the same without what the kernel kept the thread waiting for a processor."""
        return _spread(self.own)


def _spread(seconds: list[float]) -> dict[str, float]:
    found = sorted(seconds) or [0.0]
    at = {"p50": 0.5, "p99": 0.99, "max": 1.0}
    return {name: 1000 * found[min(len(found) - 1, int(share * len(found)))] for name, share in at.items()}


def waited() -> float:
    """Return the seconds for which this thread was ready to run and had no processor (schedstat: the run queue)."""
    return int(Path(f"/proc/self/task/{threading.get_native_id()}/schedstat").read_text().split()[1]) / 1e9


def cpu_by_thread() -> dict[str, float]:
    """Return the seconds that each thread of this process has run (schedstat: nanoseconds on a processor)."""
    found: Counter[str] = Counter()
    named = {thread.native_id: thread.name for thread in threading.enumerate()}
    for task in Path("/proc/self/task").iterdir():
        name = named.get(int(task.name), "other threads")
        if name.startswith(("asyncio_", "ThreadPoolExecutor", "AnyIO")):
            name = "readers"
        found[name] += int((task / "schedstat").read_text().split()[0]) / 1e9  # type: ignore[assignment]
    return dict(found)


def usage() -> dict[str, float]:
    """Return this process' seconds in user and kernel mode, and its memory in MB."""
    times = os.times()
    pages = int(Path("/proc/self/statm").read_text().split()[1])
    return {"user": times.user, "kernel": times.system, "rss": pages * os.sysconf("SC_PAGE_SIZE") / 1e6}


def less(after: Mapping[str, float], before: Mapping[str, float]) -> dict[str, float]:
    """Return how much each figure has grown."""
    return {name: value - before.get(name, 0.0) for name, value in after.items()}
