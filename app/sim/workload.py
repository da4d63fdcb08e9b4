"""Random jobs: from a place that is full to one that is empty, each place in one job at a time."""

from collections.abc import Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import dataclass
from random import Random

from app.domain.ids import CarrierId, StationId


@dataclass(frozen=True, slots=True)
class Errand:
    """A transfer to order. ``carrier`` is what stands at the source."""

    source: StationId
    destination: StationId
    carrier: CarrierId


def choose(
    rng: Random,
    stations: Sequence[StationId],
    at: Mapping[StationId, CarrierId],
    engaged: AbstractSet[StationId],
    agv: AbstractSet[StationId] = frozenset(),
) -> Errand | None:
    """Return an errand between two of the stations that are in no open job, or None if there is none.

    ``at`` maps a station to the carrier that stands there; ``agv`` are the AGVs' stations, between which and the others
    nothing is carried. The choice depends on nothing but the arguments, in their order.
    """
    destinations = [station for station in stations if station not in at and station not in engaged]
    served = {station in agv for station in destinations}
    sources = [s for s in stations if s in at and s not in engaged and (s in agv) in served]
    if not sources or not destinations:
        return None
    source = rng.choice(sources)
    return Errand(source, rng.choice([d for d in destinations if (d in agv) is (source in agv)]), at[source])


class Pace:
    """When the next job comes: a Poisson stream, or so many kept open at all times.

    Exactly one of ``per_hour`` and ``keep_open`` is given. ``due(now, open_jobs)`` says how many to order now.
    """

    def __init__(self, rng: Random, *, per_hour: float | None = None, keep_open: int | None = None) -> None:
        if (per_hour is None) == (keep_open is None):
            raise ValueError("either a rate per hour or a number to keep open")
        self._rng = rng
        self._rate = per_hour / 3600.0 if per_hour is not None else 0.0
        self._keep_open = keep_open
        self._next: float | None = None

    def due(self, now: float, open_jobs: int) -> int:
        """Return how many jobs to order now."""
        if self._keep_open is not None:
            return max(0, self._keep_open - open_jobs)
        if self._rate <= 0:
            return 0
        if self._next is None:
            self._next = now + self._rng.expovariate(self._rate)
        number = 0
        while self._next <= now:
            number += 1
            self._next += self._rng.expovariate(self._rate)
        return number
