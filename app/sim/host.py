"""The host of a virtual world: orders random jobs, some of them ahead, and repeats what was not answered."""

from collections.abc import Callable, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from random import Random

from app.domain.ids import Actor, CarrierId, JobId, StationId
from app.domain.job import JobState
from app.domain.requests import CreateJob
from app.sim.workload import Pace, choose

AHEAD = 0.25
"""Share of orders that are followed at once by one for the same carrier, from where it will be then. Our choice."""
REPEAT_AFTER = 10.0
"""Seconds without a durable job after which its order is sent again. Our choice."""


@dataclass(slots=True)
class _Order:
    request: CreateJob
    sent: float


class Host:
    """Looks once in a while; each station is in one chain of orders at a time.

    ``jobs`` are the durable jobs and their states, ``at`` where carriers really stand, ``ask`` sends a request; ``agv`` are the
    stations of AGVs.
    """

    def __init__(
        self,
        stations: Sequence[StationId],
        at: Mapping[StationId, CarrierId],
        jobs: Mapping[str, JobState],
        ask: Callable[[CreateJob], object],
        pace: Pace,
        dice: Random,
        agv: AbstractSet[StationId] = frozenset(),
    ) -> None:
        self._stations = stations
        self._at = at
        self._jobs = jobs
        self._ask = ask
        self._pace = pace
        self._dice = dice
        self._agv = agv
        self._orders: dict[JobId, _Order] = {}
        self._number = 0

    def look(self, now: float) -> None:
        """Forget what has ended, repeat what is not known, order what is due."""
        for job in [job for job in self._orders if (state := self._jobs.get(job)) is not None and state.terminal]:
            del self._orders[job]
        for job, order in self._orders.items():
            if job not in self._jobs and now - order.sent >= REPEAT_AFTER:
                order.sent = now
                self._ask(order.request)
        for _ in range(self._pace.due(now, len(self._orders))):
            if not self._order(now):
                return

    def _order(self, now: float) -> bool:
        engaged = {StationId(end) for order in self._orders.values() for end in _ends(order.request)}
        errand = choose(self._dice, self._stations, self._at, engaged, self._agv)
        if errand is None:
            return False
        self._send(errand.source, errand.destination, errand.carrier, now)
        engaged |= {errand.source, errand.destination}
        if self._dice.random() < AHEAD:
            kind = errand.destination in self._agv
            like = [station for station in self._stations if (station in self._agv) is kind]
            free = [station for station in like if station not in self._at and station not in engaged]
            if free:
                self._send(errand.destination, self._dice.choice(free), errand.carrier, now)
        return True

    def _send(self, source: StationId, destination: StationId, carrier: CarrierId, now: float) -> None:
        self._number += 1
        job = JobId(f"J{self._number:06d}")
        request = CreateJob(
            actor=Actor("host"),
            job=job,
            source=source,
            destination=destination,
            carrier=carrier,
            priority=50,
            fingerprint=f"{source}/{destination}/{carrier}",
        )
        self._orders[job] = _Order(request, now)
        self._ask(request)


def _ends(request: CreateJob) -> tuple[str, str]:
    return request.source, request.destination
