"""The log of what happens in the plant: the life of each job, and what a person on duty should see without the page."""

from collections.abc import Iterable

from structlog.typing import FilteringBoundLogger

from app.domain.job import JobEvent, JobState
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
_FIELDS = ("job", "vehicle", "carrier", "source", "destination", "result", "detail")


class Journal:
    """Writes events into the log under their own names, with the ids of what they are about."""

    def __init__(self, log: FilteringBoundLogger) -> None:
        self._log = log

    def take(self, updates: Iterable[Update]) -> None:
        """Write what has been published: events of jobs, and those that are noteworthy; a job that failed is a warning."""
        for update in updates:
            event = update.value
            if not isinstance(event, EventView):
                continue
            if event.event in NOTEWORTHY:
                about = {"vehicle": event.vehicle} if event.vehicle else {"drive": event.source}
                self._log.warning(event.event, seq=event.seq, **about, job=event.job, detail=event.detail)
            elif event.job is not None:
                said = {name: value for name in _FIELDS if (value := getattr(event, name))}
                tell = self._log.warning if event.result == JobState.FAILED else self._log.info
                tell(event.event, seq=event.seq, **said)
