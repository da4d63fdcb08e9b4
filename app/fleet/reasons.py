"""Which vehicles can do a job at all, and why none does it now, in words."""

from app.domain.errors import Refusal
from app.domain.ids import StationId, VehicleId
from app.domain.job import Job
from app.fleet.books import Books
from app.fleet.servants import Servants
from app.fleet.targets import target_for
from app.fleet.vehicle import VehicleNow


class Reasons:
    """Explains jobs without a vehicle. ``rows``: the place of each vehicle in the arrays of ``servants``."""

    def __init__(self, books: Books, servants: Servants, rows: dict[VehicleId, int]) -> None:
        self._books = books
        self._servants = servants
        self._rows = rows

    def loaded(self, vehicle: VehicleNow) -> bool:
        """Whether the vehicle has a FOUP aboard, by its own word or by our books."""
        return bool(vehicle.loaded) or bool(vehicle.record.believed_loaded)

    def hopeless(self, job: Job) -> str:
        """Return why no vehicle will do this job for now; it does not keep its ends from others then."""
        only = self._only(job)
        if only:
            able = self._able(only, job)
            return self.nobody(job) if only.barred or not only.linked or not able else ""
        if job.wish or not (self._servants.of(job.source) & self._servants.of(job.destination)).any():
            return "no vehicle can serve both stations: see their DEST, OFFSET and limits"
        return ""

    def nobody(self, job: Job) -> str:
        """Return why no vehicle does this job now. The words change only when the cause does: they are kept."""
        only = self._only(job)
        if only is None:
            return "no vehicle is free"
        asked = "has the carrier aboard" if only.id == job.source else "is asked for"
        return f"no vehicle is free: {only.id} {asked}, and {self.engaged(only) or self._unserved(only, job)}"

    def engaged(self, vehicle: VehicleNow) -> str:
        """Return why a vehicle is given no job, empty if it could be."""
        states = (
            (vehicle.barred, f"is {vehicle.barred}"),
            (not vehicle.linked, "is not connected"),
            (vehicle.job, f"is on job {vehicle.job}"),
            (vehicle.teaching is not None, f"is used for teaching (session {vehicle.teaching})"),
            (not vehicle.fit, "is not ready"),
            (self.loaded(vehicle), "is loaded"),
            (vehicle.kept, vehicle.kept),
            (paused := self._books.closures.paused_at(vehicle.barcode), f"waits: {paused}"),
        )
        return next((words for applies, words in states if applies), "")

    def _only(self, job: Job) -> VehicleNow | None:
        """Return the one vehicle that may do this job, if there is just one."""
        vehicles = self._books.vehicles
        return vehicles.get(VehicleId(job.source)) or (vehicles.get(job.wish) if job.wish else None)

    def _unserved(self, vehicle: VehicleNow, job: Job) -> str:
        """Return why the vehicle cannot serve one of the job's stations, with the missing axis named."""
        for place in (job.source, job.destination):
            station = self._books.specs.get(StationId(place))
            why = target_for(self._books, vehicle, station) if station else None
            if isinstance(why, Refusal):
                return f"cannot serve {place}: {why.reason}"
        return "cannot serve both stations"

    def _able(self, vehicle: VehicleNow, job: Job) -> bool:
        """Whether this vehicle may and can serve both ends."""
        if job.wish and job.wish != vehicle.id:
            return False
        row = self._rows[vehicle.id]
        return bool(self._servants.of(job.source)[row] and self._servants.of(job.destination)[row])
