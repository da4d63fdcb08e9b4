"""What must hold of every effect, whatever the test."""

from collections.abc import Collection

from app.domain.devices import DeviceRequest
from app.domain.ids import CarrierId, StationId
from app.domain.job import JOB_STEPS, Job, JobState
from app.domain.records import CarrierGone, CarrierRecord, HistoryEvent, Intent, IntentState, Kept, StationRecord
from app.fleet import Effects

MOTION = frozenset({"move", "pickup", "place"})
END_EVENTS = frozenset({"TransferCompleted", "TransferCancelCompleted", "TransferAbortCompleted"})
NEXT: dict[JobState, set[JobState]] = {state: {state} for state in JobState}
for (_before, _), _after in JOB_STEPS.items():
    NEXT[_before].add(_after)
NEXT[JobState.QUEUED].add(JobState.TRANSFERRING)
"""A job whose carrier is aboard already goes through waiting in one record."""


class Judge:
    """Follows the records of a fleet and fails the test at the first contradiction.

    Kept: an intent is in the same effects as its command; events have no gap; an ended job is never saved again and ends with
    one event; a closed intent is never opened again; one open motion or handling a vehicle; one job a vehicle; one carrier a
    station, one place a carrier.
    """

    def __init__(self) -> None:
        self.world: dict[StationId, CarrierId] = {}
        self._jobs: dict[str, Job] = {}
        self._ends: dict[str, str] = {}
        self._intents: dict[int, Intent] = {}
        self._stations: dict[str, StationRecord] = {}
        self._carriers: dict[str, CarrierRecord] = {}
        self._next_event = 1

    def restarted(self, kept: Kept, stations: Collection[StationId]) -> None:
        """A controller has begun with this, on a plant with these stations."""
        self._stations = {name: record for name, record in self._stations.items() if name in stations}
        assert kept.next_event == self._next_event
        for job in kept.jobs:
            assert self._jobs[job.id] == job

    def effects(self, effects: Effects, now: float) -> None:
        """Judge one transaction."""
        for record in effects.records:
            match record:
                case Job():
                    self._job(record)
                case Intent():
                    self._intent(record)
                case HistoryEvent():
                    self._event(record)
                case StationRecord():
                    self._stations[record.station] = record
                case CarrierRecord():
                    self._carriers[record.carrier] = record
                case CarrierGone():
                    del self._carriers[record.carrier]
                case _:
                    pass
        opened = {int(r.cmd_id) for r in effects.records if isinstance(r, Intent) and r.state is IntentState.OPEN}
        for send in effects.sends:
            assert send.cmd_id in opened, f"{now}: {send} without an intent in the same transaction"
        for link_send in effects.link_sends:
            if isinstance(link_send.order, DeviceRequest):
                assert link_send.order.id in opened, f"{now}: {link_send} without an intent in the same transaction"
        self._all_together()

    def _job(self, job: Job) -> None:
        before = self._jobs.get(job.id)
        if before is None:
            assert job.state is JobState.QUEUED, job
        else:
            assert not before.state.terminal, f"{job.id} was saved after its end: {before.state} {job}"
            assert job.state in NEXT[before.state], f"{job.id}: {before.state} to {job.state}"
        if job.state.terminal:
            assert job.ended is not None
            assert job.result
        self._jobs[job.id] = job

    def _intent(self, intent: Intent) -> None:
        before = self._intents.get(intent.cmd_id)
        assert before is None or not before.state.closed, f"{before} was opened again: {intent}"
        self._intents[intent.cmd_id] = intent
        if intent.state is IntentState.OPEN and before is None and intent.kind in MOTION:
            others = [
                i
                for i in self._intents.values()
                if i.vehicle == intent.vehicle and i.kind in MOTION and not i.state.closed and i is not intent
            ]
            assert not others, f"{intent} while {others} are open"

    def _event(self, event: HistoryEvent) -> None:
        assert event.seq == self._next_event
        self._next_event += 1
        if event.event in END_EVENTS and event.job:
            assert event.job not in self._ends, f"{event.job} ended twice: {self._ends[event.job]}, {event.event}"
            self._ends[event.job] = event.event

    def _all_together(self) -> None:
        busy = [job.vehicle for job in self._jobs.values() if job.vehicle and not job.state.terminal]
        assert len(busy) == len(set(busy)), "a vehicle has two jobs"
        at: dict[str, str] = {}
        for record in self._stations.values():
            if record.carrier:
                assert record.carrier not in at, f"{record.carrier} is at {at[record.carrier]} and {record.station}"
                at[record.carrier] = record.station
                assert self._carriers[record.carrier].place == record.station, (
                    f"{record} {self._carriers[record.carrier]}"
                )
        for carrier in self._carriers.values():
            if carrier.place in self._stations:
                assert at.get(carrier.carrier) == carrier.place, f"{carrier}, but {self._stations[carrier.place]}"
