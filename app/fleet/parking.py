"""Where hoists go that have nothing to do: to parking places, by where jobs began lately (``app.planning.parking``)."""

from collections.abc import Collection

import numpy as np
from scipy.spatial.distance import cdist

from app.domain.errors import NoRoute
from app.domain.ids import StationId, VehicleId
from app.domain.layout import StopAction
from app.domain.records import ControllerState
from app.domain.units import Barcode, Millimetres, Seconds
from app.fleet.books import Books
from app.fleet.motion import Motion
from app.fleet.vehicle import Errand, Purpose, VehicleNow
from app.planning.dispatch import Flags, Indices
from app.planning.parking import NOWHERE, Demand, Idle, ParkingRules, areas_of, park

LOOK_EVERY = Seconds(2.0)
"""Idle hoists are looked at so often (our choice)."""
WEIGHED_AT_ONCE = 8
"""So many at most are weighed in one look, those that have been idle longest: the others at the next (our choice)."""
PLACES_PER_AREA = 4
MOST_AREAS = 32
"""Our choice: an area has about four places, and there are at most so many areas."""


class Parking:
    """Sends idle hoists to parking places. AGVs stay: places on their track serve to give way."""

    def __init__(self, books: Books, motion: Motion) -> None:
        self._books = books
        self._motion = motion
        self._next_look = books.now
        self._since: dict[VehicleId, Seconds] = {}
        """Since when idle hoists that stand at no parking place have been seen idle."""
        self._seen = -1
        """The newest job whose beginning was counted."""
        rules = books.plant.idle
        self._rules = ParkingRules(farthest=rules.farthest)
        self._names = self._proper() if rules.park else []
        longest = max((vehicle.length for vehicle in books.plant.hoists), default=Millimetres(0))
        self._covered = [self._under(barcode, longest) for barcode in self._names]
        self._index = {barcode: n for n, barcode in enumerate(self._names)}
        points = np.array([self._at(barcode) for barcode in self._names], np.float64).reshape(-1, 2)
        count = min(MOST_AREAS, -(-len(points) // PLACES_PER_AREA))
        self._areas: Indices = areas_of(points, count)
        self._demand = Demand(np.zeros(int(self._areas.max()) + 1 if len(points) else 0), books.now)
        stations = [*books.specs.values()] if len(points) else []
        where = np.array([self._at(station.barcode) for station in stations], np.float64).reshape(-1, 2)
        near = np.argmin(cdist(where, points), axis=1).tolist() if stations else []
        self._area_of = {station.id: int(self._areas[n]) for station, n in zip(stations, near, strict=True)}

    def _at(self, barcode: Barcode) -> tuple[float, float]:
        point = self._books.track.point(barcode)
        return float(point.x), float(point.y)

    def _proper(self) -> list[Barcode]:
        """Return the parking places where a hoist may stay: at no station, at no charger, and not where none may stop."""
        books = self._books
        needed = {station.barcode for station in books.specs.values()}
        needed |= {charger.barcode for charger in books.plant.chargers}
        points = (point.barcode for point in books.plant.points if point.park)
        longest = max((vehicle.length for vehicle in books.plant.hoists), default=Millimetres(0))
        return [b for b in points if not books.track.no_stop(b) and not self._under(b, longest) & needed]

    def _under(self, place: Barcode, length: Millimetres) -> set[Barcode]:
        """Return what a vehicle of that length covers at a place."""
        return {place, *self._books.track.behind(place, length)} if length else {place}

    def run(self, free: Collection[VehicleId]) -> None:
        """Look at the vehicles that a job could be given to; send those that have been idle for long."""
        books = self._books
        if not self._names or books.now < self._next_look:
            return
        self._next_look = Seconds(books.now + LOOK_EVERY)
        self._count_jobs()
        due, parked = self._look(free)
        if due and books.controller.state is ControllerState.AUTO:
            self._send(due, parked)

    def _count_jobs(self) -> None:
        """Count the sources of the jobs that have come since the last look: new ones stand last."""
        newest = self._seen
        for job in reversed(self._books.jobs.values()):
            if job.order <= self._seen:
                break
            newest = max(newest, job.order)
            if (area := self._area_of.get(StationId(job.source))) is not None:
                self._demand.begins(area, self._books.now)
        self._seen = newest

    def _look(self, free: Collection[VehicleId]) -> tuple[list[VehicleNow], Indices]:
        """Return the hoists that are due, longest idle first, and how many are parked in each area, or will be."""
        now, after = self._books.now, self._books.plant.idle.after
        parked, since = np.zeros(len(self._demand.counts), np.intp), dict[VehicleId, Seconds]()
        for name in sorted(free):
            vehicle = self._books.vehicles[name]
            if vehicle.is_agv:
                continue
            errand = vehicle.errand
            place = self._index.get(errand.goal if errand else vehicle.barcode or Barcode(""))
            if place is not None and (errand is None or errand.purpose is Purpose.PARK):
                parked[self._areas[place]] += 1
            elif self._idle(vehicle):
                since[name] = self._since.get(name, now)
        self._since = since
        ready = [name for name, begun in since.items() if now - begun >= after]
        ready.sort(key=lambda name: (since[name], name))
        found = (self._books.vehicles[name] for name in ready)
        return [vehicle for vehicle in found if self._motion.may_drive(vehicle)][:WEIGHED_AT_ONCE], parked

    def _idle(self, vehicle: VehicleNow) -> bool:
        """Whether a hoist stands somewhere with nothing to do and nothing aboard."""
        free = vehicle.available and vehicle.errand is None and vehicle.at_rest and not vehicle.opened
        return free and not vehicle.loaded and vehicle.barcode is not None

    def _send(self, due: list[VehicleNow], parked: Indices) -> None:
        """Send them where the rule says; who finds no place waits as long again, so that others are weighed."""
        starts = [vehicle.barcode for vehicle in due if vehicle.barcode is not None]
        times = np.array(self._books.router.times(starts, self._names), np.float64)
        idle = Idle(np.full(len(due), NOWHERE, np.intp), np.zeros(len(due), np.bool_))
        demand = self._demand.upto(self._books.now)
        moves = park(idle, demand, self._areas, self._taken(), times, self._rules, parked)
        for row, vehicle in enumerate(due):
            del self._since[vehicle.id]
            if row in moves:
                try:
                    self._motion.send(vehicle, Errand(self._names[moves[row]], StopAction.STOP, Purpose.PARK))
                except NoRoute:
                    continue

    def _taken(self) -> Flags:
        """Return at which places somebody stands, or holds what is covered there, or is going to."""
        books = self._books
        goals = {vehicle.errand.goal for vehicle in books.vehicles.values() if vehicle.errand}
        places = zip(self._names, self._covered, strict=True)
        return np.array([b in goals or any(map(books.traffic.holders, under)) for b, under in places], np.bool_)
