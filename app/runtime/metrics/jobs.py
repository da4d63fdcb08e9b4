"""What becomes of jobs, counted from the durable events as they are published (DOMAIN section 2)."""

from collections import Counter
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass

from app.domain.job import TERMINAL, JobEvent, JobState
from app.domain.layout import Plant
from app.domain.view import EventView, JobView, Topic, Update
from app.fleet.circles import IN_A_CIRCLE
from app.runtime.metrics.spread import Spread

CREATED = "created"
"""When the job was accepted: E82's TransferInitiated comes with its first vehicle."""
PHASES: dict[str, tuple[str, str]] = {
    "queued": (CREATED, JobEvent.VEHICLE_ASSIGNED),
    "to_source": (JobEvent.VEHICLE_ASSIGNED, JobEvent.VEHICLE_ACQUIRE_STARTED),
    "acquiring": (JobEvent.VEHICLE_ACQUIRE_STARTED, JobEvent.VEHICLE_ACQUIRE_COMPLETED),
    "to_destination": (JobEvent.VEHICLE_ACQUIRE_COMPLETED, JobEvent.VEHICLE_DEPOSIT_STARTED),
    "depositing": (JobEvent.VEHICLE_DEPOSIT_STARTED, JobEvent.VEHICLE_DEPOSIT_COMPLETED),
    "whole": (CREATED, JobEvent.TRANSFER_COMPLETED),
}
"""The phases of a delivery, each from one E82 event to another; the first from the acceptance. Of an event that came
more than once (another vehicle, a handling tried again) the last counts."""
SECONDS = (1, 2, 5, 10, 20, 30, 45, 60, 90, 120, 180, 240, 300, 450, 600, 900, 1800, 3600)
"""Upper bounds of a phase, s. Our choice: deliveries take minutes."""
_MARKS = frozenset(str(event) for ends in PHASES.values() for event in ends)
_ENDS = frozenset(
    event.value
    for event in (
        JobEvent.TRANSFER_COMPLETED,
        JobEvent.TRANSFER_CANCEL_COMPLETED,
        JobEvent.TRANSFER_ABORT_COMPLETED,
    )
)
_SETS = {JobEvent.ALARM_SET.value: 1, JobEvent.ALARM_CLEARED.value: -1}


@dataclass(frozen=True, slots=True)
class Finished:
    """A job that ended, by which event, and when (UTC) each event that marks a phase came last."""

    job: str
    event: EventView
    marks: Mapping[str, float]


class JobFigures:
    """Counts ends, phases, events and alarms. What it keeps of a job goes with the job's end."""

    def __init__(self, plant: Plant) -> None:
        self.ended: Counter[str] = Counter()
        """Jobs that ended, by their last state."""
        self.events: Counter[str] = Counter()
        self.alarms: Counter[str] = Counter()
        """Alarms that began, by the kind of what has them."""
        self.phases = {name: Spread(SECONDS) for name in PHASES}
        self.told: Callable[[Finished], None] | None = None
        """Hears of each job that ends."""
        self._marks: dict[str, dict[str, float]] = {}
        self._kinds = {str(vehicle.id): vehicle.kind.value for vehicle in plant.vehicles}
        self._kinds |= {str(door.id): "door" for door in plant.doors}
        self._kinds |= {str(buffer.id): "buffer" for buffer in plant.buffers}
        self._kinds |= {str(charger.id): "charger" for charger in plant.chargers}

    def begin(self, jobs: Iterable[object]) -> None:
        """Take over what is known of jobs that were open before the start."""
        for job in jobs:
            if isinstance(job, JobView):
                known = {
                    CREATED: job.created,
                    JobEvent.VEHICLE_ASSIGNED.value: job.assigned,
                    JobEvent.VEHICLE_ACQUIRE_COMPLETED.value: job.picked,
                }
                self._marks[job.id] = {name: at for name, at in known.items() if at is not None}

    def take(self, updates: Iterable[Update]) -> None:
        """Count what has been published."""
        for update in updates:
            if update.topic is Topic.EVENTS and isinstance(update.value, EventView):
                self._happened(update.value)
            elif isinstance(update.value, JobView) and update.key not in self._marks:
                self._marks[update.key] = {CREATED: update.value.created}

    def _happened(self, event: EventView) -> None:
        self.events[event.event] += 1
        if event.event in _SETS:
            self._alarm(event)
        elif event.event == JobEvent.DRIVE_ERROR_SET.value:
            self.alarms["drive"] += 1
        elif event.event == JobEvent.EMERGENCY_SET.value:
            self.alarms["emergency"] += 1
        if event.job is None:
            return
        if event.event in _MARKS:
            self._marks.setdefault(event.job, {})[event.event] = event.at
        if event.event in _ENDS and event.result in TERMINAL:
            self._ended(event.job, event)

    def _alarm(self, event: EventView) -> None:
        if _SETS[event.event] > 0:
            kind = "circle" if IN_A_CIRCLE in event.detail else self._kinds.get(event.vehicle or "", "other")
            self.alarms[kind] += 1

    def _ended(self, job: str, event: EventView) -> None:
        self.ended[event.result] += 1
        marks = self._marks.pop(job, {})
        if self.told is not None:
            self.told(Finished(job, event, marks))
        if event.result != JobState.COMPLETED:
            return
        for name, (first, last) in PHASES.items():
            if first in marks and last in marks:
                self.phases[name].see(max(marks[last] - marks[first], 0.0))
