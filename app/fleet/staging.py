"""Vehicles sent ahead: to a station before its lot is ready, or to a parking place, when somebody asks (DOMAIN section 1)."""

from collections.abc import Callable, Iterable

from app.domain.errors import NoRoute, Refusal
from app.domain.ids import VehicleId
from app.domain.layout import StopAction
from app.domain.requests import Accepted, ParkVehicle, Reply, StageVehicle
from app.domain.units import Barcode
from app.domain.view import Topic
from app.fleet.books import Books
from app.fleet.kinds import no_servant, serves
from app.fleet.motion import Motion
from app.fleet.orders import VehicleOrders
from app.fleet.refusals import no_station, no_vehicle
from app.fleet.vehicle import Errand, Purpose, VehicleNow

FAR = float("inf")


class Staging:
    """Answers who wants a vehicle somewhere without an order. Once there it is idle: it gives way, and takes jobs."""

    def __init__(self, books: Books, motion: Motion, orders: VehicleOrders) -> None:
        self._books = books
        self._motion = motion
        self._orders = orders

    def stage(self, request: StageVehicle) -> Reply:
        """Send a vehicle to a station: the one that is named, or the nearest that is free."""
        books = self._books
        station = books.specs.get(request.station)
        if station is None:
            return no_station(request.station)
        if closed := books.closures.against(station):
            return Refusal("not-now", closed, "open it first")
        vehicle: VehicleNow | None
        if request.vehicle is not None:
            vehicle = books.vehicles.get(request.vehicle)
            if vehicle is None:
                return Refusal("invalid", no_vehicle(request.vehicle).reason, "see GET /api/v1/vehicles", "vehicle")
            if refusal := no_servant(vehicle, station) or self._orders.unfit(vehicle):
                return refusal
        else:
            free = (v for v in books.vehicles.values() if v.available and serves(v, station) and not v.loaded)
            vehicle = self._nearest(free, lambda v: self._time(v, station.barcode))
            if vehicle is None:
                return Refusal("not-now", f"no vehicle is free that can go to {station.id}", "try again shortly")
        return self._send(vehicle, Errand(station.barcode, station.kind.stop_action, Purpose.PERSON))

    def park(self, request: ParkVehicle) -> Reply:
        """Send a vehicle to the nearest parking place where nobody stands and nobody is going."""
        books = self._books
        vehicle = books.vehicles.get(request.vehicle)
        if vehicle is None:
            return no_vehicle(request.vehicle)
        if refusal := self._orders.unfit(vehicle):
            return refusal
        goals = {v.errand.goal for v in books.vehicles.values() if v.errand and v.id != vehicle.id}
        free = [b for b in books.parking if b not in goals and books.traffic.holders(b) <= {vehicle.id}]
        times = {place: self._time(vehicle, place) for place in sorted(free)}
        place = min(times, key=lambda place: (times[place], place), default=None)
        if place is None or times[place] == FAR:
            return Refusal("not-now", f"no parking place is free that {vehicle.id} can reach", "try again shortly")
        return self._send(vehicle, Errand(place, StopAction.STOP, Purpose.PARK))

    def _nearest(self, vehicles: Iterable[VehicleNow], time: Callable[[VehicleNow], float]) -> VehicleNow | None:
        times: dict[VehicleId, float] = {v.id: time(v) for v in vehicles if v.barcode is not None}
        best = min(times, key=lambda name: (times[name], name), default=None)
        return None if best is None or times[best] == FAR else self._books.vehicles[best]

    def _time(self, vehicle: VehicleNow, goal: Barcode) -> float:
        """Return the seconds from the end of what a vehicle is granted."""
        here = vehicle.ahead[-1] if vehicle.ahead else vehicle.barcode
        return FAR if here is None else self._books.router.time(here, goal)

    def _send(self, vehicle: VehicleNow, errand: Errand) -> Reply:
        try:
            self._motion.send(vehicle, errand)
        except NoRoute as why:
            return Refusal("no-route", self._books.closed.explain(why), "see GET /api/v1/layout")
        return Accepted(Topic.VEHICLES, vehicle.id)
