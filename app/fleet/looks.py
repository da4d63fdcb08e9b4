"""When each vehicle with something to do is looked at again, though nothing is heard of it."""

from heapq import heappop, heappush
from itertools import count
from math import inf

from app.domain.ids import VehicleId
from app.domain.units import Seconds
from app.fleet.vehicle import VehicleNow

LOOKS_AT_ONCE = 50
"""So many vehicles are looked at in one tick; the others in the next, at once (our choice: about 2 ms)."""
LOOK_EVERY = Seconds(1.0)
"""A vehicle that has something to do is looked at at least so often, and one that an event woke not sooner (our choice)."""


class Looks:
    """A heap of vehicles by the time of their next look: who has nothing to do costs nothing, and no moment is everybody's."""

    def __init__(self) -> None:
        self._heap: list[tuple[Seconds, int, VehicleId]] = []
        self._order = count()
        self._at: dict[VehicleId, Seconds] = {}
        """When each vehicle wants a look; its entry in the heap may be earlier, never later."""
        self._entered: set[VehicleId] = set()

    @property
    def deadline(self) -> Seconds:
        """When ``due`` wants to be asked next; infinite if nobody wants a look."""
        return self._heap[0][0] if self._heap else Seconds(inf)

    def looked(self, vehicle: VehicleNow, now: Seconds) -> None:
        """A vehicle has just been looked at: the next look is a while from now."""
        if vehicle.id in self._at:
            self._at[vehicle.id] = Seconds(now + LOOK_EVERY)

    def mind(self, vehicle: VehicleNow, now: Seconds) -> None:
        """A vehicle is different now: it wants looks from now on, or none."""
        name = vehicle.id
        if not _restless(vehicle):
            self._at.pop(name, None)
        elif name not in self._at:
            self._at[name] = at = Seconds(now + LOOK_EVERY)
            if name not in self._entered:
                self._enter(name, at)

    def due(self, now: Seconds, most: int = LOOKS_AT_ONCE) -> list[VehicleId]:
        """Return who wants a look by now, in order of time, at most so many: the others at once in the next call."""
        found: list[VehicleId] = []
        while self._heap and self._heap[0][0] <= now and len(found) < most:
            _, _, name = heappop(self._heap)
            self._entered.discard(name)
            at = self._at.get(name)
            if at is None:
                continue
            if at > now:
                self._enter(name, at)
                continue
            del self._at[name]
            found.append(name)
        return found

    def _enter(self, name: VehicleId, at: Seconds) -> None:
        self._entered.add(name)
        heappush(self._heap, (at, next(self._order), name))


def _restless(vehicle: VehicleNow) -> bool:
    """Whether time alone may change what is to be done with a vehicle. At a handling, all is told by its events."""
    if vehicle.recovery is not None:
        return True
    busy = vehicle.job is not None or vehicle.errand is not None or vehicle.order is not None
    return busy and (vehicle.handling is None or not vehicle.fit)
