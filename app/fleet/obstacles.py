"""What stands against picking up or putting down now, as a clause for people; empty if nothing does (DOMAIN section 2)."""

from app.domain.ids import JobId, StationId, VehicleId
from app.domain.job import Job
from app.domain.layout import StationKind
from app.domain.records import Provenance, StationRecord
from app.domain.units import Barcode
from app.fleet.books import Books

PLACED_COUNTS_FOR = 3600.0
"""Seconds after which "we placed it there" says nothing about a port any more: equipment takes carriers unseen (our choice)."""


def against_picking_up(books: Books, job: Job) -> str:
    """Return why the job's carrier cannot be fetched from its source, as far as is known."""
    if job.source in books.vehicles:
        return _against_taking_over(books, job)
    if closed := against_fetching(books, job):
        return closed
    record = books.stations[StationId(job.source)]
    if books.sensed.get(record.station) is False:
        return f"{job.source} is empty: its buffer reports no cart"
    if record.present is False and record.station not in books.sensed:
        known = books.carriers.get(job.carrier) if job.carrier else None
        elsewhere = f": {job.carrier} is at {known.place}" if known and known.place else ""
        return f"{job.source} is empty{elsewhere}"
    if job.carrier and record.carrier and record.carrier != job.carrier:
        return f"{job.source} holds {record.carrier}, not {job.carrier}"
    if record.present is None and job.carrier in books.carriers:
        place = books.carriers[job.carrier].place
        if place is None:
            return f"nobody knows where {job.carrier} is: PUT /api/v1/carriers/{job.carrier} with its place"
        if place != job.source:
            return f"{job.carrier} is at {place}, not at {job.source}"
    return ""


def against_fetching(books: Books, job: Job) -> str:
    """Return why nothing can be fetched from the job's source, whatever stands there."""
    if taught := _taught(books, StationId(job.source)):
        return taught
    if closed := books.closures.against(books.specs[StationId(job.source)]):
        return closed
    record = books.stations[StationId(job.source)]
    if record.out_of_service:
        return f"{job.source} is out of service: {record.out_of_service}"
    return books.buffer_trouble.get(record.station, "")


def against_driving(books: Books, job: Job) -> str:
    """Return why nobody comes to the job's source, or from there to the destination or a fall-back, for what is closed now.

    Nor is anything begun whose destination nobody gets away from again, as long as its source lies where one can drive round:
    one vehicle after the other would be lost in there (our choice).
    """
    if not len(books.closed):
        return ""
    holder = books.vehicles.get(VehicleId(job.source))
    if holder is None and (why := books.traffic_state.cut_off.get(StationId(job.source), "")):
        return f"{job.source} cannot be reached: {why}"
    start = holder.barcode if holder else books.specs[StationId(job.source)].barcode
    ends = (job.destination, *(name for name in job.fallbacks if name in books.specs))
    ways = [_against_coming_to(books, start, end) for end in ends]
    return ways[0] if all(ways) else ""


def _against_coming_to(books: Books, start: Barcode | None, station: StationId) -> str:
    if why := books.traffic_state.cut_off.get(station, ""):
        return f"{station} cannot be reached: {why}"
    if start is None:
        return ""
    goal = books.specs[station].barcode
    if why := books.no_way.why(start, goal):
        return why
    trap = books.no_way.why(goal, start)
    rounds = any(not books.no_way.why(after, start) for after in books.track.successors(start))
    return f"nobody gets away from {station} again: {trap}" if trap and rounds else ""


def bringer(books: Books, job: Job) -> Job | None:
    """Return the job under way whose vehicle brings the carrier to this job's source, if there is one: hosts order ahead."""
    for other in books.backlog.bringing(job.source):
        if other.order < job.order:
            another = job.carrier and other.carrier and job.carrier != other.carrier
            return None if another else other
    return None


def brought_first(books: Books, source: str, order: int) -> str:
    """Return which earlier job brings a carrier to a source first, where none is known to stand there."""
    first = books.backlog.earliest_to(source)
    if first is None or first[0] >= order or books.stations[StationId(source)].present:
        return ""
    return f"{first[1]} brings a carrier to {source} first"


def in_line(destination: StationId) -> str:
    """Return why a job waits that has several others to its destination before it: words that stay true as they go."""
    return f"other jobs to {destination} come first"


def _against_taking_over(books: Books, job: Job) -> str:
    aboard = books.vehicles[VehicleId(job.source)].record
    if not aboard.believed_loaded:
        return f"nothing is aboard {job.source}"
    if job.carrier and aboard.carrier and aboard.carrier != job.carrier:
        return f"{job.source} carries {aboard.carrier}, not {job.carrier}"
    return ""


def against_putting_down(books: Books, station: StationId, job: JobId | None) -> str:
    """Return why nothing can be put down at a station, as far as is known."""
    if job is not None and (taught := _taught(books, station)):
        return taught
    if closed := books.closures.against(books.specs[station]):
        return closed
    record = books.stations[station]
    if record.out_of_service:
        return f"{station} is out of service: {record.out_of_service}"
    if record.reserved and record.reserved != job:
        return f"{station} is reserved: {record.reserved}"
    if trouble := books.buffer_trouble.get(station):
        return trouble
    if books.sensed.get(station):
        return f"{station} is occupied: its buffer reports a cart"
    if record.present and not _expired(books, record):
        return f"{station} is occupied by {record.carrier or 'a carrier'}"
    if record.doubted:
        what = record.carrier or "a carrier"
        return f"{what} may stand at {station}, where a pick-up failed: look, then PATCH /api/v1/stations/{station} with present"
    return ""


def _taught(books: Books, station: StationId) -> str:
    """Return who teaches the port just now: jobs wait, a person's one-shot to try the taught values does not."""
    session = books.teaching.closing(station)
    if session is None:
        return ""
    return f"{station} is being taught by {session.actor} with {session.vehicle} (teaching session {session.number})"


def _expired(books: Books, record: StationRecord) -> bool:
    """Whether all we know is that we once placed something at a port, long ago."""
    return (
        record.provenance is Provenance.PLACED
        and books.specs[record.station].kind is StationKind.PORT
        and books.utc - record.at > PLACED_COUNTS_FOR
    )
