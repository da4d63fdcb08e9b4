"""How many vehicles may still be given jobs, where the plant says that a fleet may be larger than its track carries."""

from app.domain.units import Seconds
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow
from app.planning.restraint import Restraint

LOOK_EVERY = Seconds(1.0)
"""How often it is counted who stands and who drives. Our choice."""


class KeptBack:
    """Counts the vehicles that are on their way on jobs, and says how many more may set out (``planning.restraint``)."""

    def __init__(self, books: Books) -> None:
        self._books = books
        self._restraint = Restraint(len(books.vehicles)) if books.plant.restrain else None
        self._looked = books.now

    def room(self) -> int:
        """Return how many more vehicles may be given a job that they do not have."""
        books = self._books
        if self._restraint is None:
            return len(books.vehicles)
        on_jobs = [vehicle for vehicle in books.vehicles.values() if vehicle.job is not None]
        passed = min(books.now - self._looked, 2 * LOOK_EVERY)  # a pause tells nothing of the track
        if passed < LOOK_EVERY:
            return max(0, self._restraint.most - len(on_jobs))
        self._looked = books.now
        driving = sum(vehicle.drive is not None for vehicle in on_jobs)
        standing = sum(map(self._stands, on_jobs))
        return self._restraint.look(standing, driving, len(on_jobs), passed)

    def why(self) -> str:
        """Return why a job that could begin gets no vehicle now, for people."""
        most = self._restraint.most if self._restraint else len(self._books.vehicles)
        return f"the track carries no more just now: {most} vehicles may be on their way with jobs"

    def _stands(self, vehicle: VehicleNow) -> bool:
        """Whether it stands on its way because of others who have work too: one that has none is asked to go on."""
        if vehicle.drive is not None or vehicle.handling is not None or not vehicle.waiting:
            return False
        blocked = self._books.traffic.blocked.get(vehicle.id)
        other = self._books.vehicles[blocked.by] if blocked is not None and blocked.by else None
        return blocked is not None and (other is None or other.job is not None)
