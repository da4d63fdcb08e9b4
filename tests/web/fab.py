"""A whole fab at work, served: ``python -m tests.web.fab [--vehicles N] [--port P]`` prints its address, and serves.

The application is the real one; the fleet behind it is played: every vehicle that drives reports ten times a second, and the
others once a second, with all that a vehicle's view has. ``--recorded SECONDS``: so much of it lies in the past, recorded by
the real recorder, with an event of note every other second.
"""

import argparse
import asyncio
import random
import socket
import tempfile
import time
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any, cast

import structlog
import uvicorn
import uvloop

from app.cli.hosting import _configured
from app.domain.layout import Plant
from app.domain.units import Barcode, Timestamp
from app.domain.view import BitView, JobView, StationView, Topic, Update, VehicleView
from app.plant.fab import SIZES, generate, populate
from app.runtime.playback import Playback
from app.runtime.recording import PIECE_SECONDS, Limits, Recorder
from app.settings import Settings
from app.store.playback import PlaybackStore
from tests.api.scripted import Scripted

TICK = 0.1
PACE = 2500
"""mm/s."""
AHEAD = 6
"""Barcodes granted ahead."""
STATES = ("moving",) * 15 + ("waiting", "waiting", "acquiring", "depositing", "idle")
BITS = tuple(BitView(f"FIELD{number}", number % 4, "meaning of the field") for number in range(18))


class Driver:
    """One vehicle on its way round the fab, wherever chance leads it."""

    def __init__(self, view: VehicleView, start: Barcode, fleet: "Fleet", chance: random.Random) -> None:
        self.view = view
        self.doing = chance.choice(STATES)
        self._fleet, self._chance = fleet, chance
        self._path = [start]
        self._dist = 0.0

    def step(self) -> VehicleView:
        """Go on for one tick; return what it reports."""
        if self.doing == "moving":
            self._dist += PACE * TICK
        while len(self._path) < AHEAD:
            self._path.append(self._chance.choice(self._fleet.ways[self._path[-1]])[0])
        while (length := dict(self._fleet.ways[self._path[0]])[self._path[1]]) <= self._dist:
            self._dist -= length
            self._path.pop(0)
            self._path.append(self._chance.choice(self._fleet.ways[self._path[-1]])[0])
        here, *granted = self._path
        why = f"{self.view.id} waits at {here} for {granted[0]} held by V0001" if self.doing == "waiting" else ""
        self.view = replace(
            self.view, barcode=here, dist=int(self._dist), granted=tuple(granted), activity=self.doing, waiting=why
        )
        return self.view


class Fleet:
    """All vehicles of a plant."""

    def __init__(self, plant: Plant, plays: Scripted, seed: int = 1) -> None:
        chance = random.Random(seed)
        self.ways: dict[Barcode, list[tuple[Barcode, int]]] = {}
        for edge in plant.edges:
            self.ways.setdefault(edge.start, []).append((edge.end, edge.length))
        views = {view.id: view for view in plays.model.all(Topic.VEHICLES) if isinstance(view, VehicleView)}
        self.drivers = [
            Driver(self._dressed(views[spec.id], chance), spec.start, self, chance)
            for spec in plant.vehicles
            if spec.start is not None
        ]

    @staticmethod
    def _dressed(view: VehicleView, chance: random.Random) -> VehicleView:
        loaded = chance.random() < 0.5
        link = replace(view.link, up=True, round_trip_ms=3.2)
        oper = "alarm" if chance.random() < 0.003 else "running"
        return replace(
            view, link=link, mode="auto", oper=oper, loaded=loaded, bits=BITS, carrier="F1" if loaded else None
        )

    def reports(self, tick: int) -> Iterator[Update]:
        """Return what changes at a tick."""
        for number, driver in enumerate(self.drivers):
            if driver.doing == "moving" or number % 10 == tick % 10:
                yield Update(Topic.VEHICLES, driver.view.id, driver.step())


def fab(vehicles: int, size: str = "10k", seed: int = 1) -> tuple[Scripted, Fleet]:
    """Return a generated fab under a played controller, and its fleet."""
    plant = populate(generate(SIZES[size], seed).plant, vehicles, seed, 0.3)
    plays = Scripted(plant=plant)
    full = {station for _, station in plant.carriers}
    plays.hub.publish(
        [
            Update(Topic.STATIONS, view.id, replace(view, present=view.id in full))
            for view in plays.model.all(Topic.STATIONS)
            if isinstance(view, StationView)
        ]
    )
    return plays, Fleet(plant, plays, seed)


OPEN = 300
"""Jobs under way in what is recorded."""


def _at_first(plays: Scripted) -> list[Update]:
    """Return what stands still in what is recorded, and the vehicles as they are."""
    stations = [(view.id, view) for view in plays.model.all(Topic.STATIONS) if isinstance(view, StationView)]
    names = [name for name, _ in stations]
    jobs = [_job(number, names[number], names[-number]) for number in range(1, OPEN + 1)]
    vehicles = [(view.id, view) for view in plays.model.all(Topic.VEHICLES) if isinstance(view, VehicleView)]
    return [
        *(Update(Topic.STATIONS, key, station) for key, station in stations),
        *(Update(Topic.VEHICLES, key, vehicle) for key, vehicle in vehicles),
        *(Update(Topic.JOBS, job.id, job) for job in jobs),
        *(Update(Topic.CONTROLLER, plays.plant.name, view) for view in plays.model.all(Topic.CONTROLLER)),
    ]


def _job(number: int, source: str, destination: str) -> JobView:
    return JobView(
        id=f"J{number}", order=number, state="transferring", leg="to_destination",
        source=source, destination=destination, priority=50, carrier=f"F{number}", vehicle=f"V{number:04}",
        wish=None, fallbacks=(), reason="", result="", actor="mes",
        created=time.time() - 600, assigned=None, picked=None, ended=None,
    )  # fmt: skip


def record(plays: Scripted, fleet: Fleet, seconds: int, directory: Path) -> None:
    """Let so many seconds have passed until now, recorded in a directory as the controller does it."""
    url = f"sqlite:///{directory}/plant.db"
    now = time.time() - seconds
    keeper = PlaybackStore(url)
    recorder = Recorder(keeper, Limits(86_400.0, 4_000_000_000), lambda: Timestamp(now), structlog.get_logger("fab"))
    recorder.note(_at_first(plays))
    pieces = int(PIECE_SECONDS / TICK)
    for tick in range(int(seconds / TICK)):
        now += TICK
        recorder.note(list(fleet.reports(tick)))
        if tick % pieces == 0:
            plays.happen(("AlarmSet", "AlarmCleared")[tick // pieces % 2], vehicle="V0001", at=Timestamp(now))
            while recorder.waiting > 2:
                time.sleep(0.01)
            recorder.flush()
    recorder.close()
    plays.playback = Playback(url)


async def _serve(listening: socket.socket, vehicles: int, size: str, recorded: int, directory: Path) -> None:
    plays, fleet = fab(vehicles, size)
    if recorded:
        record(plays, fleet, recorded, directory)

    async def work() -> None:
        tick = 0
        while True:
            await asyncio.sleep(TICK)
            tick += 1
            plays.hub.publish(list(fleet.reports(tick)))

    at_work = asyncio.create_task(work())
    print(f"http://127.0.0.1:{listening.getsockname()[1]}/", flush=True)  # noqa: T201
    await uvicorn.Server(_configured(cast(Any, plays), Settings())).serve([listening])
    at_work.cancel()


def main() -> None:
    """Serve."""
    parser = argparse.ArgumentParser(description="Serve a generated fab whose vehicles report ten times a second.")
    parser.add_argument("--vehicles", type=int, default=1000)
    parser.add_argument("--size", default="10k", choices=list(SIZES))
    parser.add_argument("--port", type=int, default=0)
    parser.add_argument("--recorded", type=int, default=0, help="seconds of the past")
    given = parser.parse_args()
    with socket.create_server(("127.0.0.1", given.port)) as listening, tempfile.TemporaryDirectory() as directory:
        uvloop.run(_serve(listening, given.vehicles, given.size, given.recorded, Path(directory)))


if __name__ == "__main__":
    main()
