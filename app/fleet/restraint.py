"""How many vehicles may still be given jobs, where the plant says that a fleet may be larger than its track carries."""

from app.domain.units import Seconds
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow
from app.planning.restraint import Restraint

LOOK_EVERY = Seconds(1.0)
"""How often it is counted who stands and who drives. Our choice."""


class KeptBack:
    """Counts the hoists that are on their way on jobs, and says how many more may set out (``planning.restraint``).

    AGVs have track of their own and other rules: they are never kept back.
    """

    def __init__(self, books: Books) -> None:
        self._books = books
        self._hoists = [vehicle for vehicle in books.vehicles.values() if not vehicle.is_agv]
        self._restraint: Restraint | None = None
        if books.plant.restrain:
            on_jobs = sum(vehicle.job is not None for vehicle in self._hoists)
            self._restraint = Restraint(len(self._hoists), under_way=on_jobs)
            books.traffic_state.restrained_to = self._restraint.most
        self._looked = books.now

    def room(self) -> int:
        """Return how many more hoists may be given a job that they do not have."""
        books = self._books
        if self._restraint is None:
            return len(self._hoists)
        on_jobs = [vehicle for vehicle in self._hoists if vehicle.job is not None]
        passed = min(books.now - self._looked, 2 * LOOK_EVERY)  # a pause tells nothing of the track
        if passed < LOOK_EVERY:
            return max(0, self._restraint.most - len(on_jobs))
        self._looked = books.now
        driving = sum(vehicle.drive is not None for vehicle in on_jobs)
        standing = sum(map(self._stands, on_jobs))
        room = self._restraint.look(standing, driving, len(on_jobs), passed)
        books.traffic_state.restrained_to = self._restraint.most
        return room

    def why(self) -> str:
        """Return why a job that could begin gets no vehicle now, for people."""
        most = self._restraint.most if self._restraint else len(self._hoists)
        return f"the track carries no more just now: {most} vehicles may be on their way with jobs"

    def _stands(self, vehicle: VehicleNow) -> bool:
        """Whether it stands on its way because of others who have work too: one that has none is asked to go on."""
        if vehicle.drive is not None or vehicle.handling is not None or not vehicle.waiting:
            return False
        blocked = self._books.traffic.blocked.get(vehicle.id)
        other = self._books.vehicles[blocked.by] if blocked is not None and blocked.by else None
        return blocked is not None and (other is None or other.job is not None)
