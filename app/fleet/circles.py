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
"""Who has stood and waited so long may be in a circle, and one that has not been there for so long is over (our choice).

In a ring full of traffic each waits for the next, and all drive on."""
WAYS = 8
"""So many of the quickest ways of a vehicle are tried (our choice)."""
IN_A_CIRCLE = "wait for each other in a circle"
"""What the alarm says, by which it is told from a vehicle's own."""


@dataclass(slots=True)
class Circle:
    """A circle that was told: its vehicles, the alarm in words, and when some of them were last in a circle."""

    vehicles: tuple[VehicleId, ...]
    detail: str
    seen: Seconds


class Circles:
    """Knows the circles there are now."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._motion = motion
        self._known: list[Circle] = []

    def look(self) -> None:
        """Seek circles of vehicles that all stand and wait long; tell and resolve them."""
        books = self._books
        cycles = [c for c in self._stuck() if not all(books.vehicles[name].is_agv for name in c)]
        for cycle in cycles:
            shared = [circle for circle in self._known if not set(circle.vehicles).isdisjoint(cycle)]
            for circle in shared:
                circle.seen = books.now
            if not shared:
                circle = Circle(cycle, self._words(cycle), books.now)
                self._known.append(circle)
                self._count(JobEvent.ALARM_SET, circle)
            self._resolve([books.vehicles[name] for name in cycle])
        for circle in [circle for circle in self._known if books.now - circle.seen >= AGE]:
            self._known.remove(circle)
            self._count(JobEvent.ALARM_CLEARED, circle)

    def _stuck(self) -> tuple[tuple[VehicleId, ...], ...]:
        """Return the circles of vehicles that have all waited for AGE, or wait and were in one just now.

        Who may not drive at all, as while everything is stopped, waits for that.
        """
        books = self._books
        refused = [books.vehicles[name] for name in books.traffic.blocked]
        told = {name for circle in self._known for name in circle.vehicles}
        going = {v.id for v in refused if not v.waiting or (books.now - v.waiting_since < AGE and v.id not in told)}
        going.update(v.id for v in refused if not self._motion.may_drive(v))
        return books.traffic.cycles(going) if len(going) < len(refused) else ()

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
