"""Circles of hoists that wait for each other: told as an alarm, counted, and resolved by another way (TRAFFIC section 5).

Admission keeps such circles from closing; a hand placement, a restart or a closure may put one there all the same. AGVs have
their own rule (``Courtesy``).
"""

from dataclasses import dataclass

from app.domain.alarms import AlarmKind
from app.domain.errors import NoRoute
from app.domain.ids import VehicleId
from app.domain.job import JobEvent
from app.domain.units import Seconds
from app.fleet.books import Books
from app.fleet.motion import Motion
from app.fleet.vehicle import VehicleNow

AGE = Seconds(5.0)
"""Circles are sought, at most once a second, while a vehicle has waited so long for another (our choice)."""
WAYS = 8
"""So many of the quickest ways of a vehicle are tried (our choice)."""
IN_A_CIRCLE = "wait for each other in a circle"
"""What the alarm says, by which it is told from a vehicle's own."""


@dataclass(frozen=True, slots=True)
class Circle:
    """A circle that was told: its vehicles, and the alarm in words."""

    vehicles: tuple[VehicleId, ...]
    detail: str


class Circles:
    """Knows the circles there are now."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._motion = motion
        self._known: list[Circle] = []

    def look(self) -> None:
        """Seek circles if a vehicle waits long, or one is known; tell and resolve them."""
        if not self._known and not self._long():
            return
        books = self._books
        cycles = [c for c in books.traffic.cycles() if not all(books.vehicles[name].is_agv for name in c)]
        for circle in list(self._known):
            if not any(set(circle.vehicles) & set(cycle) for cycle in cycles):
                self._known.remove(circle)
                self._count(JobEvent.ALARM_CLEARED, circle)
        for cycle in cycles:
            if not any(set(circle.vehicles) & set(cycle) for circle in self._known):
                circle = Circle(cycle, self._words(cycle))
                self._known.append(circle)
                self._count(JobEvent.ALARM_SET, circle)
            self._resolve([books.vehicles[name] for name in cycle])

    def _long(self) -> bool:
        """Whether any vehicle has waited for AGE for another."""
        books = self._books
        waiting = (books.vehicles[name] for name, blocked in books.traffic.blocked.items() if blocked.by)
        return any(vehicle.waiting and books.now - vehicle.waiting_since >= AGE for vehicle in waiting)

    def _words(self, cycle: tuple[VehicleId, ...]) -> str:
        waits = "; ".join(self._books.vehicles[name].waiting or f"{name} waits" for name in cycle)
        return (
            f"{', '.join(cycle)} {IN_A_CIRCLE} ({waits}); if none finds another way, move {cycle[0]} by hand, "
            "or take it off the rail"
        )

    def _count(self, name: JobEvent, circle: Circle) -> None:
        books = self._books
        if name is JobEvent.ALARM_SET:
            books.traffic_state.circles_found += 1
        else:
            books.traffic_state.circles_resolved += 1
        books.traffic_state.circles = tuple(known.detail for known in self._known)
        source, code = circle.vehicles[0], ", ".join(circle.vehicles)
        if name is JobEvent.ALARM_SET:
            remedy = f"move {source} by hand, or take it off the rail, if none finds another way"
            books.alarms.begin(AlarmKind.TRAFFIC, source, code, circle.detail, remedy)
        else:
            books.alarms.end_one(AlarmKind.TRAFFIC, source, code, "they go on")
        books.event(name, vehicle=source, detail=circle.detail)
        books.show_controller()

    def _resolve(self, tied: list[VehicleNow]) -> None:
        """Lead one by another way, if there is one: by then the others can go on."""
        next(filter(self._reroute, tied), None)

    def _reroute(self, vehicle: VehicleNow) -> bool:
        """Lead a vehicle that stands to its goal around what it waits for, where it would be let in now."""
        books, errand, here = self._books, vehicle.errand, vehicle.barcode
        blocked = books.traffic.blocked.get(vehicle.id)
        if errand is None or here is None or blocked is None or vehicle.is_agv:
            return False
        if not vehicle.fit or not vehicle.at_rest or vehicle.ahead:
            return False
        try:
            ways = books.router.alternatives(here, errand.goal, WAYS)
        except NoRoute:
            return False
        for way in (route.barcodes for route in ways):
            if blocked.at not in way and books.traffic.lets_in(vehicle.id, way[1:]):
                self._motion.send(vehicle, errand, way)
                return True
        return False
