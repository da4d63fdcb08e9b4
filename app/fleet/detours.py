"""Other ways than the quickest, for a vehicle that cannot go on by it."""

from collections.abc import Callable

from app.domain.errors import NoRoute
from app.domain.units import Barcode
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow
from app.planning.ways import free_way


class Detours:
    """Leads vehicles that stand blocked to their goals by other ways, where there are such."""

    def __init__(self, books: Books) -> None:
        self._books = books

    def over_free_track(self, vehicle: VehicleNow, goal: Barcode) -> bool:
        """Lead a blocked AGV to its goal over track that is free now, if there is such a way (our choice; floors are small)."""
        way = self.free_way(vehicle, lambda barcode: barcode == goal) if vehicle.is_agv and not vehicle.toward else None
        if way is not None:
            vehicle.rest = list(way[1:])
        return way is not None

    def free_way(self, vehicle: VehicleNow, ends: Callable[[Barcode], bool]) -> tuple[Barcode, ...] | None:
        """Return the shortest way for a standing vehicle over track that it would be granted; None: there is none."""
        traffic = self._books.traffic
        if vehicle.barcode is None:
            return None
        return free_way(self._books.track, vehicle.barcode, ends, lambda b: traffic.obstacle(vehicle.id, b) is None)

    def as_committed(self, vehicle: VehicleNow, goal: Barcode) -> bool:
        """Lead a vehicle by the queue that it is committed to wait in next, where its new way could close a circle of full ones.

        Return whether that is another way than the one it had.
        """
        books = self._books
        queues = books.traffic.queues
        here = vehicle.ahead[-1] if vehicle.ahead else vehicle.barcode
        if queues is None or here is None or not books.traffic.strays(vehicle.id, vehicle.rest):
            return False
        entry = queues.buffers.chains[queues.want(vehicle.id)][0]
        try:
            rest = [*books.router.route(here, entry)[1:], *books.router.route(entry, goal)[1:]]
        except NoRoute:
            return False
        if rest == vehicle.rest or books.traffic.strays(vehicle.id, rest):
            return False
        vehicle.rest = rest
        return True
