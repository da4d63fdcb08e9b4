"""The log of what happens in the plant: the life of each job, and what a person on duty should see without the page."""

from collections.abc import Iterable, Iterator

from structlog.typing import FilteringBoundLogger

from app.domain.job import JobEvent, JobState
from app.domain.layout import Plant
from app.domain.view import EventView, Update

NOTEWORTHY = frozenset(
    {
        JobEvent.VEHICLE_HELD,
        JobEvent.VEHICLE_RELEASED,
        JobEvent.ALARM_SET,
        JobEvent.ALARM_CLEARED,
        JobEvent.DRIVE_OFFLINE,
        JobEvent.DRIVE_ONLINE,
        JobEvent.DRIVE_ERROR_SET,
        JobEvent.DRIVE_ERROR_CLEARED,
        JobEvent.EMERGENCY_SET,
        JobEvent.EMERGENCY_RELEASED,
    }
)
"""Events that the log has as warnings."""
OF_DRIVES = frozenset(
    {JobEvent.DRIVE_OFFLINE, JobEvent.DRIVE_ONLINE, JobEvent.DRIVE_ERROR_SET, JobEvent.DRIVE_ERROR_CLEARED}
)
"""Events whose ``source`` is a drive; that of others is a station, or something beside the plant, such as a webhook."""
_FIELDS = ("job", "vehicle", "carrier", "source", "destination", "result", "detail")


class Journal:
    """Writes events into the log under their own names, with the ids of what they are about."""

    def __init__(self, log: FilteringBoundLogger, plant: Plant) -> None:
        self._log = log
        self._stations = {station.id for station in plant.stations}
        self._devices: dict[str, str] = {
            **{door.id: "door" for door in plant.doors},
            **{buffer.id: "buffer" for buffer in plant.buffers},
            **{charger.id: "charger" for charger in plant.chargers},
        }

    def take(self, updates: Iterable[Update]) -> None:
        """Write what has been published: events of jobs, and those that are noteworthy; a job that failed is a warning."""
        for update in updates:
            event = update.value
            if not isinstance(event, EventView):
                continue
            if event.event in NOTEWORTHY:
                self._log.warning(event.event, seq=event.seq, **dict(self._about(event)), detail=event.detail)
            elif event.job is not None:
                said = {name: value for name in _FIELDS if (value := getattr(event, name))}
                tell = self._log.warning if event.result == JobState.FAILED else self._log.info
                tell(event.event, seq=event.seq, **said)

    def _about(self, event: EventView) -> Iterator[tuple[str, str]]:
        """Give what an event is about, each by its kind; what is about nothing in particular is about the plant."""
        if event.vehicle:
            # An alarm of a device has its name where one of a vehicle has the vehicle's.
            yield self._devices.get(event.vehicle, "vehicle"), event.vehicle
        if event.source and not event.vehicle and not event.job:  # else it is where the job begins
            yield self._kind(event), event.source
        if event.job:
            yield "job", event.job

    def _kind(self, event: EventView) -> str:
        """Return what kind of thing the source of an event is."""
        if event.event in OF_DRIVES:
            return "drive"
        if event.source in self._stations:
            return "station"
        return "webhook" if str(event.source).startswith("webhook-") else "source"
