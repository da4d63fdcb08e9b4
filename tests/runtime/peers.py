"""A tiny endpoint, and what tests of the running shell share."""

import asyncio
from collections import deque
from collections.abc import Callable, Coroutine
from typing import Any

import uvloop

from app.domain.units import Seconds

GENEROUS = 180.0


class Echo:
    """Sends back what it gets, in capitals; notes what happens to it; ticks when told."""

    def __init__(self) -> None:
        self.notes: list[str] = []
        self.out: deque[bytes] = deque()
        self.deadline: Seconds | None = None
        self.wants_close = False

    def connected(self, now: Seconds) -> None:
        self.notes.append("connected")
        self.wants_close = False

    def received(self, data: bytes, now: Seconds) -> None:
        self.notes.append(data.decode())
        if data == b"bye":
            self.wants_close = True
        self.out.append(data.upper())

    def disconnected(self, now: Seconds, reason: str) -> None:
        self.notes.append("disconnected")

    def tick(self, now: Seconds) -> None:
        assert self.deadline is not None
        assert now >= self.deadline
        self.notes.append("tick")
        self.deadline = None

    def outgoing(self) -> bytes:
        return self.out.popleft() if self.out else b""


def run(scenario: Callable[[], Coroutine[Any, Any, None]]) -> None:
    """Run a scenario on a fresh loop of either kind; it may take a generous time and no more."""

    async def bounded() -> None:
        await asyncio.wait_for(scenario(), GENEROUS)

    for factory in (uvloop.new_event_loop, asyncio.new_event_loop):
        with asyncio.Runner(loop_factory=factory) as runner:
            runner.run(bounded())
            runner.run(settled())


async def settled() -> None:
    """Let what is closing be closed: a transport that its loop leaves half closed is a warning in whatever test runs later."""
    for _ in range(20):
        await asyncio.sleep(0)


async def until(condition: Callable[[], bool]) -> None:
    """Wait for a condition."""
    while not condition():
        await asyncio.sleep(0.002)
