"""The real thing on bad cables: processes over loopback, each line through a relay that delays, loses, falls silent and cuts.

``python -m tests.acceptance.cables --seed 1``: the demo plant is simulated in one process and watched by the oracle there,
its drive line in another one over a pty that is pulled out; a controller serves it, is killed with -9, and reaches its database
(with ``--database URL`` a PostgreSQL server, which is cut off too) as it reaches its machines. A person looks after what is
held. After the storm every job has to end, no rule may have been broken, and the carriers have to be where they are said to be.
"""

import argparse
import asyncio
import json
import sys
import threading
import time
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from contextlib import ExitStack, contextmanager, suppress
from dataclasses import dataclass, field
from enum import Enum
from itertools import count
from pathlib import Path
from random import Random
from tempfile import TemporaryDirectory
from typing import Any
from urllib.parse import urlsplit, urlunsplit

import httpx

from app.plant import read
from app.wire.faults import Fault, Lane, Rates
from tests.e2e.processes import HTTP, answers, free_ports, journal_of, quick_plant, running, wait_until
from tests.e2e.test_killed_server import jobs

SPELL = (0.5, 3.0)
"""Seconds of one weather on one line."""
CALM_FOR = 300.0
"""Seconds after the storm in which every job has to end."""
ENDS = ("the database cannot be opened", "of the database cannot be read", "controller lost")
"""What a controller says that ends since its database is away; whoever watches over it starts it again."""
PERSON = {"X-Actor": "kim"}
OPEN = 12
"""Most jobs that are open when another one is ordered."""
TERMINAL = {"completed", "failed", "cancelled", "aborted"}


class Weather(Enum):
    """What a line does to what it carries."""

    FINE = "carries everything"
    LATE = "delays"
    LOSSY = "loses, doubles and spoils"
    DRIP = "carries a byte at a time"
    SILENT = "swallows everything, and stays open"
    CUT = "is cut, and takes no connection"


RATES: Rates = {Fault.DROP: 0.15, Fault.CORRUPT: 0.05, Fault.DUPLICATE: 0.1, Fault.NOISE: 0.05, Fault.STALE: 0.05}
LINE = (16, 3, 3, 1, 1, 1)
"""How often a line has each weather."""
DATABASE = (6, 2, 0, 0, 1, 2)
"""A database is not spoiled: TCP would not let it be."""


class Relay:
    """One line: connections to ``port`` are carried to another port of this machine, as the weather is."""

    def __init__(self, name: str, port: int, to: int, dice: Random, chances: Sequence[int]) -> None:
        self.name, self.port, self.weather = name, port, Weather.FINE
        self.met: Counter[Weather] = Counter()
        self._to, self._dice, self._chances = to, dice, chances
        self._open: set[asyncio.StreamWriter] = set()

    async def serve(self, stormy: asyncio.Event) -> None:
        """Carry, and change the weather while it is stormy, until this is cancelled."""
        server = await asyncio.start_server(self._carry, "127.0.0.1", self.port)
        try:
            while True:
                drawn = self._dice.choices(tuple(Weather), self._chances)[0] if stormy.is_set() else Weather.FINE
                self.met[drawn] += stormy.is_set()
                self.weather = drawn
                if drawn is Weather.CUT:
                    self._cut()
                await asyncio.sleep(self._dice.uniform(*SPELL))
        finally:
            server.close()
            self._cut()

    def _cut(self) -> None:
        for writer in self._open:
            writer.transport.abort()

    async def _carry(self, near: asyncio.StreamReader, back: asyncio.StreamWriter) -> None:
        if self.weather is Weather.CUT:
            back.transport.abort()
            return
        try:
            far, on = await asyncio.open_connection("127.0.0.1", self._to)
        except OSError:
            back.transport.abort()
            return
        self._open |= {back, on}
        ways = [asyncio.create_task(self._way(*ends)) for ends in ((near, on), (far, back))]
        await asyncio.wait(ways, return_when=asyncio.FIRST_COMPLETED)
        for writer in (back, on):
            self._open.discard(writer)
            writer.transport.abort()
        for way in ways:
            way.cancel()

    async def _way(self, source: asyncio.StreamReader, target: asyncio.StreamWriter) -> None:
        lane = Lane(Random(self._dice.random()), RATES)
        with suppress(OSError):
            while data := await source.read(4096):
                match self.weather:
                    case Weather.SILENT:
                        continue
                    case Weather.LATE:
                        await asyncio.sleep(self._dice.uniform(0.02, 0.6))
                    case Weather.LOSSY:
                        lane.put(data, 0.0)
                        data = b"".join(iter(lambda: lane.take(float("inf")), b""))
                    case Weather.DRIP:
                        for byte in data[:64]:
                            target.write(bytes((byte,)))
                            await asyncio.sleep(0.005)
                            if target.is_closing():
                                return
                        data = data[64:]
                    case Weather.FINE | Weather.CUT:
                        pass
                target.write(data)
                await target.drain()


@dataclass
class Storm:
    """Relays in a loop of their own."""

    relays: list[Relay]
    _loop: asyncio.AbstractEventLoop = field(default_factory=asyncio.new_event_loop)

    @contextmanager
    def blowing(self) -> Iterator[asyncio.Event]:
        """Carry everything within; the event says whether the weather is bad."""
        stormy = asyncio.Event()

        async def all_of_them() -> None:
            await asyncio.gather(*(relay.serve(stormy) for relay in self.relays))

        work = self._loop.create_task(all_of_them())

        def run() -> None:
            with suppress(asyncio.CancelledError):
                self._loop.run_until_complete(work)

        thread = threading.Thread(target=run)
        thread.start()
        try:
            yield stormy
        finally:
            self._loop.call_soon_threadsafe(work.cancel)
            thread.join()
            self._loop.close()


@dataclass(frozen=True)
class Outcome:
    """What became of a run."""

    met: Mapping[Weather, int]
    kills: int
    restarts: int
    unplugged: int
    helped: int
    states: Mapping[str, int]
    wrong: tuple[str, ...]


def stormed(directory: Path, seed: int, seconds: float, kills: int, database: str | None = None) -> Outcome:
    """Let a plant work through a storm; ``database``: a PostgreSQL database that is empty, or None for SQLite."""
    dice = Random(seed)
    plant = quick_plant("demo", directory)
    text = plant.read_text(encoding="utf-8")
    shutter = directory / "axes"
    found, _ = read(text, "demo")
    there: dict[str, int] = {spec.id: spec.port for spec in found.hoists}
    there |= {link.id: link.port for link in found.links}
    text = text.replace(f'address: "127.0.0.1:{there.pop("axes")}"', f"serial: {{device: {shutter}}}")
    plant.write_text(text, encoding="utf-8")
    ports = dict(zip(there, free_ports(len(there)), strict=True))
    for name, port in there.items():
        text = text.replace(f'"127.0.0.1:{port}"', f'"127.0.0.1:{ports[name]}"')
    seen = directory / "seen.yaml"
    seen.write_text(text, encoding="utf-8")
    relays = [Relay(name, ports[name], there[name], Random(f"{seed}/{name}"), LINE) for name in there]
    url = f"sqlite:///{directory / 'plant.db'}"
    if database is not None:
        at = urlsplit(database)
        (port,) = free_ports(1)
        relays.append(Relay("database", port, at.port or 5432, Random(f"{seed}/database"), DATABASE))
        url = urlunsplit(at._replace(netloc=f"{at.netloc.rpartition('@')[0]}@127.0.0.1:{port}"))
    run = _Run(plant, seen, directory, url, sure=database is None)
    with Storm(relays).blowing() as stormy, run.simulated():
        run.start()
        run.ready()
        stormy.set()
        run.weather(dice, seconds, kills)
        stormy.clear()
        run.calm()
        return Outcome(
            sum((relay.met for relay in relays), Counter()),
            run.kills,
            run.restarts,
            run.unplugged,
            run.helped,
            run.states(),
            tuple(run.wrong()),
        )


def _orders() -> Iterator[dict[str, str]]:
    """Give orders for ever: every carrier there and back, again and again."""
    for trip in count(1):
        for job in jobs():
            yield {**job, "job_id": f"{job['job_id']}-{trip}"}


class _Run:
    def __init__(self, plant: Path, seen: Path, directory: Path, database: str, *, sure: bool) -> None:
        (port,) = free_ports(1)
        self._plant, self._seen = plant, seen
        self._url = f"http://127.0.0.1:{port}"
        self._log, self._sim_log = directory / "serve.log", directory / "sim.log"
        self._drives_log, self._journal = directory / "drives.log", directory / "journal"
        self._served = ("serve", "--plant", str(seen), "--database", database, "--port", str(port))
        self._server, self._drives = ExitStack(), ExitStack()
        self._orders = _orders()
        self._next = next(self._orders)
        self._ordered = 0
        """Jobs that were accepted; more are ordered as long as the storm lasts."""
        self._sure = sure
        self.kills = self.restarts = self.unplugged = self.helped = 0

    # -- processes ----------------------------------------------------------------------------------------------------

    @contextmanager
    def simulated(self) -> Iterator[None]:
        words = ("sim", "--plant", str(self._plant), "--without", "axes", "--journal", str(self._journal))
        with running(*words, "--haste", "5", log=self._sim_log), self._server, self._drives:
            wait_until(lambda: b"are there" in self._sim_log.read_bytes(), "the simulated vehicles", self._sim_log)
            self._plug_in()
            yield

    def start(self) -> None:
        self._process = self._server.enter_context(running(*self._served, log=self._log))

    def ready(self) -> None:
        def is_ready() -> bool:
            self._alive()
            return answers(self._url)

        wait_until(is_ready, "the server", self._log)

    def _alive(self) -> None:
        """Start the controller again if it ended by itself, which only one without its database may, and says so."""
        if self._process.poll() is None:
            return
        last = self._log.read_text(encoding="utf-8")[-3000:]
        if self._sure or not any(words in last for words in ENDS):
            raise AssertionError(f"the server ended by itself:\n{last}")
        self.restarts += 1
        self.start()

    def _plug_in(self) -> None:
        words = ("sim", "--plant", str(self._plant), "--only", "axes")
        self._drives.enter_context(running(*words, log=self._drives_log))

    def _unplug(self) -> None:
        self._drives.close()
        self._drives = ExitStack()
        self.unplugged += 1
        self._plug_in()

    # -- the storm ----------------------------------------------------------------------------------------------------

    def weather(self, dice: Random, seconds: float, kills: int) -> None:
        """Order, look after vehicles, read drives, kill the controller and pull the drive line, for so long."""
        begun = time.monotonic()
        deadly = sorted(dice.uniform(0.1, 0.95) * seconds for _ in range(kills))
        pulled = sorted(dice.uniform(0.1, 0.95) * seconds for _ in range(max(1, kills // 2)))
        while (now := time.monotonic() - begun) < seconds:
            if deadly and now > deadly[0]:
                del deadly[0]
                self._alive()
                self._process.kill()
                self._process.wait()
                self.kills += 1
                self.start()
            if pulled and now > pulled[0]:
                del pulled[0]
                self._unplug()
            if self._order(self._next):
                self._next = next(self._orders)
            self._round(dice)
            time.sleep(0.3)

    def calm(self) -> None:
        """Look after everything until every job has ended."""
        dice = Random(0)
        begun = time.monotonic()
        self.ready()
        while not self._over() and time.monotonic() - begun < CALM_FOR:
            self._round(dice)
            time.sleep(1.0)

    def _over(self) -> bool:
        return set(self.states()) <= TERMINAL

    def _round(self, dice: Random) -> None:
        self._alive()
        for vehicle in self._items("vehicles"):
            if dice.random() < 0.3:
                self._help(vehicle)
        for drive in self._items("drives"):
            if dice.random() < 0.1:
                self._post(f"drives/{drive['id']}/parameters/01/read")

    def _order(self, job: dict[str, str]) -> bool:
        if sum(number for state, number in self.states().items() if state not in TERMINAL) > OPEN:
            return False
        answer = self._post("jobs", **job)
        if answer is not None and answer.status_code not in (200, 201, 503):
            raise AssertionError(f"{job} is refused: {answer.text}")
        accepted = answer is not None and answer.status_code != 503
        self._ordered += accepted
        return accepted

    def _help(self, vehicle: dict[str, Any]) -> None:
        """What a person does at a vehicle: recover an alarm or what fell to MANT, let go on what is held."""
        name = vehicle["id"]
        if not vehicle["link"]["up"] or vehicle["activity"] == "recovering":
            return
        if vehicle["oper"] == "alarm" or vehicle["mode"] == "mant":
            helped = self._post(f"vehicles/{name}/recover", confirmed=True)
        elif vehicle["hold"]:
            helped = self._post(f"vehicles/{name}/release", verdict="go_on", reason="looked at it")
        else:
            return
        self.helped += helped is not None and helped.is_success

    # -- what is seen -------------------------------------------------------------------------------------------------

    def _post(self, path: str, **body: object) -> httpx.Response | None:
        """Ask for something; None if nobody answers, be it that it was done."""
        with suppress(httpx.HTTPError):
            return HTTP.post(f"{self._url}/api/v1/{path}", json=body, headers=PERSON, timeout=5.0)
        return None

    def _items(self, path: str) -> list[dict[str, Any]]:
        with suppress(httpx.HTTPError):
            answer = HTTP.get(f"{self._url}/api/v1/{path}", timeout=5.0)
            if answer.status_code == 200:
                items: list[dict[str, Any]] = answer.json()["items"]
                return items
        return []

    def states(self) -> Counter[str]:
        """Return how many jobs are in each state; with one of ``nobody answers`` where that is so."""
        found = self._items("jobs?limit=1000")
        return Counter(job["state"] for job in found) or Counter({"nobody answers": 1})

    def wrong(self) -> Iterator[str]:
        """Give what must not be."""
        states = self.states()
        for state in set(states) - TERMINAL:
            left = [f"{job['id']} {job['reason']}" for job in self._items("jobs?limit=1000") if job["state"] == state]
            yield f"{states[state]} jobs are {state}: {'; '.join(left)}"
        # One more may be: who ordered it was not told so, and ordered no other.
        if sum(states.values()) - self._ordered not in (0, 1):
            yield f"{self._ordered} jobs were accepted, {sum(states.values())} are known"
        acts = journal_of(self._journal)
        for act in acts:
            if act["deed"] == "violation":
                yield f"the oracle: {act['what']}"
        yield from self._misplaced(acts)
        yield from self._unread()
        logged = self._log.read_text(encoding="utf-8", errors="replace")
        if "Traceback" in logged:
            yield f"a traceback:\n{logged[logged.index('Traceback') :][:3000]}"

    def _misplaced(self, acts: Sequence[Mapping[str, Any]]) -> Iterator[str]:
        places = dict[str, str](read(self._seen.read_text("utf-8"), "seen")[0].carriers)
        for act in acts:
            if act["deed"] in ("take", "put"):
                places[act["carrier"]] = act["vehicle"] if act["deed"] == "take" else act["station"]
        for carrier in self._items("carriers"):
            if places.get(carrier["id"], "nowhere") != carrier["place"]:
                yield f"{carrier['id']} is said to be at {carrier['place']}, and is at {places.get(carrier['id'])}"

    def _unread(self) -> Iterator[str]:
        """Drives of a line that was pulled out are read again."""
        for drive in self._items("drives"):
            answer = self._post(f"drives/{drive['id']}/parameters/01/read?wait=4")
            state = "nobody answers" if answer is None else answer.json().get("state", answer.text)
            if state != "done":
                yield f"parameter 01 of {drive['id']} is not read: {state}"


def main() -> int:
    """Run, print what was found, and return the exit code."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--seconds", type=float, default=60.0, help="length of the storm")
    parser.add_argument("--kills", type=int, default=3, help="kills of the controller with -9")
    parser.add_argument("--database", help="URL of an empty PostgreSQL database; without it SQLite")
    parser.add_argument("--keep", type=Path, help="directory for logs and databases")
    given = parser.parse_args()
    with TemporaryDirectory() as temporary:
        directory = given.keep or Path(temporary)
        directory.mkdir(parents=True, exist_ok=True)
        outcome = stormed(directory, given.seed, given.seconds, given.kills, given.database)
    met = ", ".join(f"{weather.value} {times}" for weather, times in outcome.met.items())
    print(f"lines: {met}")
    print(f"controller killed {outcome.kills} times, ended by itself {outcome.restarts}", end="; ")
    print(f"drive line pulled {outcome.unplugged}; a person helped {outcome.helped} times")
    print(f"jobs: {json.dumps(dict(outcome.states))}")
    for what in outcome.wrong:
        print(f"WRONG: {what}")
    print("no rule was broken" if not outcome.wrong else f"{len(outcome.wrong)} wrong")
    return 1 if outcome.wrong else 0


if __name__ == "__main__":
    sys.exit(main())
