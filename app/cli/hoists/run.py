"""The measurement: starts the children and the load, waits, and says what came of it."""

import asyncio
import json
import pickle
import sqlite3
import sys
import tempfile
from collections.abc import AsyncIterator, Mapping
from contextlib import asynccontextmanager, closing, suppress
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from app.cli.hoists.load import Load
from app.cli.plainly import CannotStart
from app.domain.layout import Plant

GRACE = 10.0
"""Seconds for a child to end by itself. Our choice."""


@dataclass(frozen=True, slots=True)
class Asked:
    """What to measure. ``settle`` seconds pass under load before it begins; ``jobs`` are kept open."""

    seconds: float
    settle: float
    processes: int
    first_port: int
    jobs: int
    seed: int = 1


@dataclass(frozen=True, slots=True)
class Found:
    """What came of it: figures of the children, deeds of the load, and how commands ended by kind and state."""

    vehicles: int
    seconds: float
    controller: Mapping[str, Any]
    floors: tuple[Mapping[str, Any], ...]
    completed: int
    failed: int
    alarms: int
    held: int
    commands: Mapping[str, int]
    said: Mapping[str, int]
    """How often each kind of alarm came."""

    @property
    def per_vehicle_second(self) -> float:
        """Return the controller's CPU in microseconds per vehicle and second."""
        process = self.controller["process"]
        return float(process["user"] + process["kernel"]) / self.seconds / self.vehicles * 1e6


class _Child:
    """One of our processes."""

    def __init__(self, process: asyncio.subprocess.Process, what: str) -> None:
        self._process = process
        self._what = what

    @classmethod
    async def start(cls, what: str, *words: object) -> "_Child":
        process = await asyncio.create_subprocess_exec(
            sys.executable, "-m", f"app.cli.hoists.{what}", *(str(word) for word in words),
            stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE, start_new_session=True, limit=1 << 22,
        )  # fmt: skip
        return cls(process, what)

    async def hear(self) -> dict[str, Any]:
        """Return what it says next. Raises CannotStart: it has ended instead."""
        assert self._process.stdout is not None
        line = await self._process.stdout.readline()
        if not line:
            raise CannotStart(f"the {self._what} ended before its time", remedy="The lines above say why.")
        found = json.loads(line)
        assert isinstance(found, dict)
        return found

    async def ask(self, word: str) -> dict[str, Any]:
        """Say a word and return the answer."""
        assert self._process.stdin is not None
        self._process.stdin.write(f"{word}\n".encode())
        return await self.hear()

    async def stop(self) -> None:
        """End it, however it takes that."""
        if self._process.stdin is not None:
            self._process.stdin.close()
        try:
            await asyncio.wait_for(self._process.wait(), GRACE)
        except TimeoutError:
            with suppress(ProcessLookupError):
                self._process.kill()
            await self._process.wait()


async def measure(plant: Plant, asked: Asked) -> Found:
    """Run controller, hoists and load, and return the figures. Raises CannotStart."""
    plant = _at_ports(plant, asked.first_port)
    with tempfile.TemporaryDirectory(prefix="hoistway-bench-") as place:
        file, database = Path(place, "plant.pickle"), Path(place, "bench.db")
        file.write_bytes(pickle.dumps(plant))
        async with (
            _floors(file, asked.processes) as floors,
            _child("controller", file, f"sqlite:///{database}") as main,
        ):
            url = str((await main.hear())["url"])
            load = Load(plant, url, asked.jobs, asked.seed)
            ordering = asyncio.create_task(load.run())
            try:
                return await _measured(plant, asked, main, floors, load, ordering, database)
            finally:
                ordering.cancel()
                with suppress(asyncio.CancelledError):
                    await ordering
                await load.close()


async def _measured(
    plant: Plant,
    asked: Asked,
    main: _Child,
    floors: list[_Child],
    load: Load,
    ordering: "asyncio.Task[None]",
    database: Path,
) -> Found:
    await _while(ordering, asked.settle)
    sent = _commands(database)
    for child in (main, *floors):
        await child.ask("begin")
    before, failed, noted, said = load.completed, load.failed, dict(load.noted), dict(load.alarms)
    await _while(ordering, asked.seconds)
    commands = {name: count - sent.get(name, 0) for name, count in _commands(database).items()}
    figures = await main.ask("end")
    return Found(
        vehicles=len(plant.hoists),
        seconds=float(figures["seconds"]),
        controller=figures,
        floors=tuple([await floor.ask("end") for floor in floors]),
        completed=load.completed - before,
        failed=load.failed - failed,
        alarms=load.noted.get("AlarmSet", 0) - noted.get("AlarmSet", 0),
        held=load.noted.get("VehicleHeld", 0) - noted.get("VehicleHeld", 0),
        commands=commands,
        said={alarm: more for alarm, count in load.alarms.items() if (more := count - said.get(alarm, 0))},
    )


async def _while(ordering: "asyncio.Task[None]", seconds: float) -> None:
    """Let time pass. Raises whatever ended the load before."""
    await asyncio.wait({ordering}, timeout=seconds)
    if ordering.done():
        ordering.result()


@asynccontextmanager
async def _child(what: str, *words: object) -> AsyncIterator[_Child]:
    child = await _Child.start(what, *words)
    try:
        yield child
    finally:
        await child.stop()


@asynccontextmanager
async def _floors(file: Path, count: int) -> AsyncIterator[list[_Child]]:
    children: list[_Child] = []
    try:
        starting = [_Child.start("floor", file, share, count) for share in range(count)]
        children.extend([await start for start in starting])
        await asyncio.gather(*(child.hear() for child in children))
        yield children
    finally:
        for child in children:
            await child.stop()


def _at_ports(plant: Plant, first: int) -> Plant:
    """Return the plant with each hoist at a port of this machine, one after the other."""
    vehicles = tuple(
        replace(spec, host="127.0.0.1", port=first + number, listen=False) for number, spec in enumerate(plant.hoists)
    )
    return replace(plant, vehicles=vehicles)


def _commands(database: Path) -> dict[str, int]:
    """Return how many commands of each kind came to which end."""
    with closing(sqlite3.connect(database)) as connection:
        rows = connection.execute("SELECT kind, state, count(*) FROM intents GROUP BY kind, state ORDER BY kind, state")
        return {f"{kind} {state}": int(count) for kind, state, count in rows}
