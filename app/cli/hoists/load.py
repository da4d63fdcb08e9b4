"""The host of the measurement: as many open jobs as it is told, over REST, following the durable events."""

import asyncio
import re
from collections import defaultdict
from random import Random

import httpx
import networkx as nx

from app.domain.ids import CarrierId, StationId
from app.domain.layout import Plant
from app.sim.workload import choose

EVERY = 0.5
"""Seconds between two looks at the events. Our choice."""
PAGE = 1000
"""Events in one answer."""
AT_ONCE = 16
"""Orders on their way at the same time. Our choice."""
ENDS = frozenset({"TransferCompleted", "TransferCancelCompleted", "TransferAbortCompleted"})


class Load:
    """Orders random transfers of carriers, from where they stand to somewhere empty that the track leads to."""

    def __init__(self, plant: Plant, url: str, open_jobs: int, seed: int) -> None:
        self.completed = 0
        self.failed = 0
        self.noted: dict[str, int] = defaultdict(int)
        """How often each event came."""
        self.alarms: defaultdict[str, int] = defaultdict(int)
        """How often each alarm came, without the names and numbers in it."""
        self._open = open_jobs
        self._rng = Random(seed)
        # The server closes lines that are idle for 5 s: an order must not cross with that.
        limits = httpx.Limits(keepalive_expiry=2.0)
        self._client = httpx.AsyncClient(
            base_url=f"{url}/api/v1", headers={"X-Actor": "bench"}, timeout=30.0, limits=limits
        )
        self._at: dict[StationId, CarrierId] = {station: carrier for carrier, station in plant.carriers}
        self._engaged: set[StationId] = set()
        self._jobs: dict[str, tuple[StationId, StationId, CarrierId]] = {}
        self._groups = _connected(plant)
        self._seen = 0

    async def run(self) -> None:
        """Go on until cancelled."""
        while True:
            await self._follow()
            await self._order()
            await asyncio.sleep(EVERY)

    async def close(self) -> None:
        """Let the connections go."""
        await self._client.aclose()

    @property
    def open(self) -> int:
        """Jobs that have not ended, as far as is known."""
        return len(self._jobs)

    async def _follow(self) -> None:
        while True:
            answer = await self._client.get("/events", params={"after": self._seen, "limit": PAGE})
            events = answer.raise_for_status().json()["items"]
            for event in events:
                self._note(event)
            if len(events) < PAGE:
                return

    def _note(self, event: dict[str, object]) -> None:
        self._seen = int(str(event["seq"]))
        name = str(event["event"])
        self.noted[name] += 1
        if name == "AlarmSet":
            self.alarms[nameless(str(event.get("detail") or event.get("source") or ""))] += 1
        ended = self._jobs.pop(str(event["job"]), None) if name in ENDS else None
        if ended is None:
            return
        source, destination, carrier = ended
        done = event["result"] == "completed"
        self.completed += done
        self.failed += not done
        # What did not arrive stands somewhere unknown: its places are left alone.
        if done:
            self._engaged -= {source, destination}
            self._at[destination] = carrier

    async def _order(self) -> None:
        wanted = [errand for _ in range(self._open - len(self._jobs)) if (errand := self._choose()) is not None]
        for first in range(0, len(wanted), AT_ONCE):
            await asyncio.gather(*(self._post(*errand) for errand in wanted[first : first + AT_ONCE]))

    def _choose(self) -> tuple[StationId, StationId, CarrierId] | None:
        """Draw one transfer; after some draws that do not fit, none."""
        for _ in range(20):
            group = self._rng.choice(self._groups)
            some = self._rng.sample(group, min(len(group), 20))
            errand = choose(self._rng, some, self._at, self._engaged)
            if errand is not None:
                self._engaged |= {errand.source, errand.destination}
                return errand.source, errand.destination, errand.carrier
        return None

    async def _post(self, source: StationId, destination: StationId, carrier: CarrierId) -> None:
        body = {"source": source, "destination": destination, "carrier": carrier}
        answer = await self._client.post("/jobs", json=body)
        if answer.status_code == 201:
            self._jobs[str(answer.json()["id"])] = (source, destination, carrier)
            del self._at[source]


def nameless(sentence: str) -> str:
    """Return a sentence up to its details, every word with a digit left out: so alarms of one kind are the same."""
    words = re.sub(r"\S*\d\S*", "…", sentence.partition(" (")[0])
    return re.sub(r"(…\W*)+", "… ", words)[:80].strip()


def _connected(plant: Plant) -> list[list[StationId]]:
    """Return the stations of each piece of track that hangs together and has more than one."""
    graph = nx.Graph((edge.start, edge.end) for edge in plant.edges)
    number = {barcode: n for n, part in enumerate(nx.connected_components(graph)) for barcode in part}
    found: defaultdict[int, list[StationId]] = defaultdict(list)
    for station in plant.stations:
        found[number[station.barcode]].append(station.id)
    return [group for group in found.values() if len(group) > 1]
