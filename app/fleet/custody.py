"""What our books say after a carrier went from a station to a vehicle, or back."""

from dataclasses import replace

from app.domain.ids import CarrierId, JobId, StationId
from app.domain.job import Job, JobEvent
from app.domain.records import Provenance, StationRecord
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow


def carrier_moved(books: Books, vehicle: VehicleNow, station: StationId, job: JobId | None, *, pickup: bool) -> None:
    """Write down that the vehicle has taken a carrier from a station or put it there: by F, not by belief."""
    order = (books.jobs.get(job) or books.ended.get(job)) if job else None
    record = books.stations.get(station, StationRecord(station))
    if pickup:
        _taken(books, vehicle, record, order)
    else:
        _put(books, vehicle, record, order)


def _taken(books: Books, vehicle: VehicleNow, record: StationRecord, job: Job | None) -> None:
    carrier = (job.carrier if job else None) or record.carrier
    if record.carrier and record.carrier != carrier:
        _lose(books, record.carrier, f"{vehicle.id} took {carrier} from {record.station} instead")
    _save(books, replace(record, present=False, carrier=None, provenance=Provenance.PICKED, at=books.utc))
    books.save_vehicle(vehicle, carrier=carrier, believed_loaded=True)
    if carrier:
        books.put_carrier(carrier, vehicle.id, Provenance.PICKED)
    if job and not job.state.terminal:
        job = books.save_job(replace(job, carrier=carrier, picked=books.utc))
    books.event(JobEvent.CARRIER_INSTALLED, job=job, vehicle=vehicle.id, carrier=carrier, source=record.station)


def _put(books: Books, vehicle: VehicleNow, record: StationRecord, job: Job | None) -> None:
    carrier = vehicle.record.carrier
    if record.carrier and record.carrier != carrier:
        _lose(books, record.carrier, f"{vehicle.id} put {carrier or 'a carrier'} down at {record.station}")
    _save(
        books,
        replace(record, present=True, carrier=carrier, reserved="", provenance=Provenance.PLACED, at=books.utc),
    )
    books.save_vehicle(vehicle, carrier=None, believed_loaded=False)
    if carrier:
        books.put_carrier(carrier, record.station, Provenance.PLACED)
    books.event(JobEvent.CARRIER_REMOVED, job=job, vehicle=vehicle.id, carrier=carrier, destination=record.station)


def _lose(books: Books, carrier: CarrierId, why: str) -> None:
    """A carrier cannot be where it was believed to be: nobody knows where it is, and that is told."""
    books.put_carrier(carrier, None, Provenance.INFERRED)
    books.event(JobEvent.CARRIER_MOVED, carrier=carrier, detail=f"nobody knows where it is: {why}")


def _save(books: Books, record: StationRecord) -> None:
    """Keep what is believed of a station; one that the plant file no longer has is not."""
    if record.station in books.specs:
        books.save_station(record)
