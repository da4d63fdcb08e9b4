"""The simulated plant of ``hoistway demo``: in a process of its own, it becomes whatever plant the controller goes on with."""

from __future__ import annotations

import asyncio
import sys
from contextlib import suppress
from typing import TYPE_CHECKING

from app.cli.changes import Changes
from app.cli.plainly import CannotStart
from app.cli.sim import message

if TYPE_CHECKING:
    from collections.abc import Callable
    from pathlib import Path

    from app.domain.layout import Plant
    from app.domain.units import Timestamp

FOLLOW_WITHIN = 60.0
"""Seconds for the simulator to follow a change of the plant: the controller waits with its start. Our choice."""


class Simulator:
    """The simulated plant, in a process of its own; ``text`` is what its plant file says."""

    process: asyncio.subprocess.Process

    def __init__(self, file: Path, text: str, operator: int | None) -> None:
        self._file, self._text, self._operator = file, text, operator

    async def start(self) -> None:
        """Start it; return once its vehicles are there. Raises CannotStart."""
        hands = () if self._operator is None else ("--operator", str(self._operator))
        # A session of its own: Ctrl-C reaches the parent alone, which ends both in order.
        self.process = await asyncio.create_subprocess_exec(
            sys.executable, "-m", "app.cli", "sim", "--plant", str(self._file), "--with-parent", *hands,
            stdin=asyncio.subprocess.PIPE,
            stdout=asyncio.subprocess.PIPE,
            start_new_session=True,
        )  # fmt: skip
        assert self.process.stdout is not None
        if not await self.process.stdout.readline():
            await self.process.wait()
            raise CannotStart("the simulated vehicles could not be started", remedy="The line above says why.")

    async def follow(self, text: str) -> None:
        """Let it become another plant, as far as it can; what it cannot it says on standard error."""
        if text == self._text:
            return
        self._text = text
        assert self.process.stdin is not None
        assert self.process.stdout is not None
        with suppress(TimeoutError, ConnectionError):
            self.process.stdin.write(message(text))
            await self.process.stdin.drain()
            await asyncio.wait_for(self.process.stdout.readline(), FOLLOW_WITHIN)


class ShownChanges(Changes):
    """Changes that the simulated plant makes before the controller starts with them."""

    def __init__(self, file: Path, database: str, utc: Callable[[], Timestamp], simulator: Simulator) -> None:
        super().__init__(file, database, utc)
        self._simulator = simulator

    async def settle(self, plant: Plant) -> Plant:
        following = await super().settle(plant)
        await self.show()
        return following

    async def fall_back(self, plant: Plant, why: str, *, listening: bool = False) -> Plant | None:
        before = await super().fall_back(plant, why, listening=listening)
        await self.show()
        return before

    async def show(self) -> None:
        """Let the simulated plant become the version that runs, or is about to."""
        text = await asyncio.to_thread(self.versions.store.text, self.number)
        if text is not None:
            await self._simulator.follow(text)
