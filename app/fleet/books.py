"""The fleet's state, and what has been decided since it was last taken: every change goes through here."""

from collections.abc import Mapping, Sequence
from dataclasses import replace

from app.domain.alarms import OF_VEHICLES, Alarm, AlarmKind
from app.domain.closures import Closure
from app.domain.commands import Command, Send
from app.domain.ids import Actor, CarrierId, CmdId, CmdIds, JobId, StationId, VehicleId
from app.domain.job import Job, JobEvent
from app.domain.layout import Plant, Station, StationKind
from app.domain.records import (
    AuditRow,
    CarrierGone,
    CarrierRecord,
    ControllerRecord,
    ControllerState,
    HistoryEvent,
    Intent,
    IntentState,
    Kept,
    Provenance,
    StationDest,
    StationRecord,
    VehicleOffset,
    VehicleRecord,
)
from app.domain.teaching import Proposal, SessionState, TeachingSession
from app.domain.units import Barcode, Seconds, Timestamp
from app.domain.versions import Leaving
from app.domain.view import ClosureView, Topic, Update, View
from app.domain.walks import Walk, WalkPlace
from app.domain.why import Why
from app.fleet.alarm_book import AlarmBook
from app.fleet.backlog import Backlog
from app.fleet.closed import Closed
from app.fleet.closure_book import ClosureBook
from app.fleet.effects import Effects
from app.fleet.noway import NoWay
from app.fleet.rollcall import RollCall
from app.fleet.teaching_books import TeachingBooks
from app.fleet.teaching_views import view_of_proposal, view_of_session
from app.fleet.traffic_state import TrafficState
from app.fleet.vehicle import VehicleNow
from app.fleet.views import (
    view_of_alarm,
    view_of_carrier,
    view_of_closure,
    view_of_controller,
    view_of_event,
    view_of_intent,
    view_of_job,
    view_of_station,
    view_of_walk,
    with_traffic,
)
from app.planning.routing import Router
from app.planning.track import Track
from app.planning.traffic import Traffic

SYSTEM = Actor("hoistway")
"""The controller itself, as the actor of what it decides alone."""
UNNAMED = "(no name under alarm_codes)"
"""What is said of an alarm that the plant file, which is where a site writes what its vehicles' codes mean, does not name."""
REMEMBERED = 20_000
"""How many ended jobs are remembered for the idempotency of a host that repeats itself at once (our choice; older: database)."""


class Books:
    """State of one plant in memory, written to only through methods that also say what must be kept and shown."""

    def __init__(self, plant: Plant, kept: Kept, cmd_ids: CmdIds, now: Seconds, utc: Timestamp) -> None:
        self.plant = plant
        self.track = Track(plant)
        self.router = Router(self.track)
        self.closed = Closed(self.router.close, self.router.open)
        """What routes are kept off, and why: nobody else closes or opens anything for the router."""
        self.no_way = NoWay(self.track, self.router, self.closed)
        self.parking = frozenset(point.barcode for point in plant.points if point.park)
        self.traffic = Traffic(self.track, admission=True)
        self.traffic_state = TrafficState()
        self.closures = ClosureBook(self.track, self.closed, self.traffic, kept.closures)
        self.closures.still(kept.controller.pauses)
        self._next_closure = kept.next_closure
        self._closures_shown: dict[int, ClosureView] = {}
        self.cmd_ids = cmd_ids
        self.now = now
        self.started = utc
        self._utc_offset = utc - now
        self.effects = Effects()
        self.dirty: dict[VehicleId, Seconds] = {}
        """Vehicles that look different now, by when they first did since they were last shown: the longest wait first."""
        self.touched: dict[VehicleId, None] = {}
        """Vehicles that look different since the effects were last taken."""
        self.woken: dict[VehicleId, None] = {}
        self.changed: dict[VehicleId, None] = {}
        """Vehicles of which something is different since the fleet last minded their looks and doors."""
        self.specs: dict[StationId, Station] = {s.id: s for s in plant.stations}
        self.vehicles = self._vehicles(kept)
        self.jobs: dict[JobId, Job] = {job.id: job for job in kept.jobs}
        self.ended: dict[JobId, Job] = {}
        self.backlog = Backlog(kept.jobs)
        self.jobs_changed = bool(self.backlog.queued)
        """Whether there is something that dispatch can use: a job without a vehicle, a station that such a job waits for."""
        self.whys: dict[JobId, Why] = {why.job: why for why in kept.whys}
        """Of jobs not ended."""
        self.by_key: dict[str, JobId] = {j.idempotency_key: j.id for j in kept.jobs if j.idempotency_key}
        self.stations = {s.id: StationRecord(s.id) for s in plant.stations} | {
            record.station: record for record in kept.stations if record.station in self.specs
        }
        self.stations_changed: dict[StationId, None] = {}
        """Stations of which something is different since the fleet last minded their buffers."""
        self.carriers: dict[CarrierId, CarrierRecord] = {record.carrier: record for record in kept.carriers}
        self.dests: dict[StationId, StationDest] = {d.station: d for d in kept.dests}
        self.offsets: dict[VehicleId, VehicleOffset] = {o.vehicle: o for o in kept.offsets}
        self.taught = 0
        """Rises with every new DEST or OFFSET."""
        self.teaching = TeachingBooks(plant, kept)
        self._note_teaching()
        self.controller = kept.controller
        self.leaving: Leaving | None = None
        """What goes with a version of the plant that is awaited."""
        self.roll_call = RollCall(self.track)
        self.buffer_trouble: dict[StationId, str] = {}
        """Why the buffer of a station cannot be used now."""
        self.sensed: dict[StationId, bool] = {}
        """Whether the buffer of a station reports a cart, where it says so now."""
        self.alarms = AlarmBook(kept.alarms, kept.next_alarm, self._keep_alarm, lambda: self.utc)
        self.walks: dict[int, Walk] = {walk.number: walk for walk in kept.walks}
        """Those that are open; their places by walk and station in the next."""
        self.walk_places: dict[int, dict[StationId, WalkPlace]] = {number: {} for number in self.walks}
        for place in kept.walk_places:
            if place.station in self.specs:
                self.walk_places[place.walk][place.station] = place
        self._next_walk = kept.next_walk
        self._next_event = kept.next_event
        self._next_order = kept.next_order
        self.epoch = kept.epoch
        if kept.fresh:
            self._take_over_plant_file()

    def _vehicles(self, kept: Kept) -> dict[VehicleId, VehicleNow]:
        records = {record.vehicle: record for record in kept.vehicles}
        vehicles = {
            spec.id: VehicleNow(
                spec, records.get(spec.id, VehicleRecord(spec.id)), link_since=self.now, stage_since=self.now
            )
            for spec in self.plant.vehicles
        }
        for intent in kept.intents:
            if intent.vehicle in vehicles:
                vehicles[intent.vehicle].opened[intent.cmd_id] = intent
        for job in kept.jobs:
            if job.vehicle in vehicles:
                vehicles[job.vehicle].job = job.id
        return vehicles

    def _note_teaching(self) -> None:
        for vehicle in self.vehicles.values():
            session = self.teaching.session_of(vehicle.id)
            vehicle.teaching = session.number if session else None

    def _take_over_plant_file(self) -> None:
        for carrier, place in self.plant.carriers:
            self.put_carrier(carrier, place, Provenance.PLANT)
        for station in self.plant.stations:
            if station.dest and station.kind is StationKind.PORT:
                self.keep_dest(StationDest(station.id, 1, station.dest, SYSTEM, "plant file", self.utc))
        for spec in self.plant.vehicles:
            if not spec.in_service:
                self.save_vehicle(self.vehicles[spec.id], out_of_service="by the plant file")
            if spec.offset and not self.teaching.is_reference(spec.id):
                self.keep_offset(VehicleOffset(spec.id, 1, spec.offset, SYSTEM, "plant file", self.utc))

    @property
    def utc(self) -> Timestamp:
        """UTC at the present input."""
        return Timestamp(self.now + self._utc_offset)

    def utc_at(self, moment: Seconds) -> Timestamp:
        """UTC at a moment of the running clock."""
        return Timestamp(moment + self._utc_offset)

    # -- look-ups -----------------------------------------------------------------------------------------------------

    def job_of(self, vehicle: VehicleNow) -> Job | None:
        """Return the job that a vehicle is on."""
        return self.jobs.get(vehicle.job) if vehicle.job else None

    def vehicle_of(self, job: Job) -> VehicleNow | None:
        """Return the vehicle that is on a job."""
        return self.vehicles.get(job.vehicle) if job.vehicle else None

    def named_alarm(self, code: int) -> str:
        """Return an alarm's code with its name from the plant file; no specification has a table of them (I30)."""
        return f"{code} {self.plant.alarm_codes.get(code, UNNAMED)}"

    # -- records ------------------------------------------------------------------------------------------------------

    def save_job(self, job: Job) -> Job:
        """Keep and show a job. An ended one leaves the live ones."""
        before = self.jobs.get(job.id)
        if job.state.terminal:
            self.jobs.pop(job.id, None)
            self.ended[job.id] = job
            if len(self.ended) > REMEMBERED:
                old = self.ended.pop(next(iter(self.ended)))
                if old.idempotency_key:
                    self.by_key.pop(old.idempotency_key, None)
        else:
            self.jobs[job.id] = job
        if job.idempotency_key:
            self.by_key[job.idempotency_key] = job.id
        self.jobs_changed |= self.backlog.note(before, job)
        self.effects.records.append(job)
        self._follow(before, job)
        self.show(Topic.JOBS, job.id, None if job.state.terminal else view_of_job(job))
        return job

    def _follow(self, before: Job | None, job: Job) -> None:
        """Keep what the job waits for with its why-record: from the second word on, since the first is the job's own."""
        if before is None:
            return
        kept = self.whys.get(job.id)
        known = kept or Why(job.order, job.id)
        if kept is None and before.reason:
            known = known.waiting(before.reason, before.created)
        why = known.waiting(job.reason, self.utc)
        if why is not kept and why.waits:
            self.keep_why(why)
        if job.state.terminal:
            self.whys.pop(job.id, None)

    def keep_why(self, why: Why) -> None:
        """Keep a job's why-record as it is now."""
        self.whys[why.job] = why
        self.effects.records.append(why)

    def new_order(self) -> int:
        """Return the next number of acceptance."""
        self._next_order += 1
        return self._next_order - 1

    def event(
        self,
        name: JobEvent,
        *,
        job: Job | None = None,
        vehicle: VehicleId | None = None,
        carrier: CarrierId | None = None,
        source: str | None = None,
        destination: str | None = None,
        result: str = "",
        detail: str = "",
    ) -> None:
        """Record a durable event; what a job knows need not be repeated."""
        event = HistoryEvent(
            seq=self._next_event,
            at=self.utc,
            event=name.value,
            ceid=self.plant.event_numbers.get(name.value, 0),
            job=job.id if job else None,
            carrier=carrier or (job.carrier if job else None),
            vehicle=vehicle or (job.vehicle if job else None),
            source=source or (job.source if job else None),
            destination=destination or (job.destination if job else None),
            result=result,
            detail=detail,
        )
        self._next_event += 1
        self.effects.records.append(event)
        self.show(Topic.EVENTS, str(event.seq), view_of_event(event))

    @property
    def last_event(self) -> int:
        """The number of the last event."""
        return self._next_event - 1

    def audit(self, actor: Actor, action: str, target: str, detail: str, *, accepted: bool) -> None:
        """Record that somebody asked for something."""
        self.effects.records.append(AuditRow(self.utc, actor, action, target, detail, accepted))

    def save_vehicle(self, vehicle: VehicleNow, **changes: object) -> None:
        """Change and keep the durable part of a vehicle."""
        record = replace(vehicle.record, **changes)  # type: ignore[arg-type]
        if record != vehicle.record:
            if record.hold != vehicle.record.hold or record.off_rail != vehicle.record.off_rail:
                self._mind_hold(record)
            vehicle.record = record
            self.effects.records.append(record)
            if vehicle.id in self.roll_call:
                self.roll_call.miss(vehicle)
        self.touch(vehicle)

    def _mind_hold(self, record: VehicleRecord) -> None:
        """A hold for a doubt of ours is an alarm; one by a person is none, and an alarm of its own has one already."""
        name, hold = record.vehicle, record.hold
        if hold is not None and not hold.by_person and not hold.for_alarm:
            self.alarms.begin_only(AlarmKind.HOLD, name, "held", hold.reason, hold.remedy)
        else:
            self.alarms.end(AlarmKind.HOLD, name, "released" if hold is None else f"now: {hold.reason}")
        if record.off_rail:
            for kind in OF_VEHICLES:
                self.alarms.end(kind, name, f"off the rail: {record.off_rail}")

    def _keep_alarm(self, alarm: Alarm) -> None:
        """Keep and show an alarm; one that has ended leaves the live ones."""
        self.effects.records.append(alarm)
        self.show(Topic.ALARMS, str(alarm.number), None if alarm.ended is not None else view_of_alarm(alarm))

    def open_intent(
        self,
        vehicle: VehicleNow,
        kind: str,
        command: Command,
        actor: Actor,
        *,
        job: JobId | None = None,
        path: tuple[Barcode, ...] = (),
        body: Mapping[str, object] | None = None,
        amends: CmdId | None = None,
    ) -> Intent:
        """Make a command durable and send it: the bytes leave after the commit (COMMANDS: intent before first byte)."""
        intent = Intent(
            cmd_id=self.cmd_ids.next(),
            vehicle=vehicle.id,
            kind=kind,
            state=IntentState.OPEN,
            opened=self.utc,
            actor=actor,
            job=job,
            path=path,
            body=body or {},
            amends=amends,
        )
        self.keep_intent(vehicle, intent)
        self.effects.sends.append(Send(vehicle.id, intent.cmd_id, command))
        return intent

    def keep_intent(self, vehicle: VehicleNow, intent: Intent) -> Intent:
        """Keep and show an intent as it is now."""
        if intent.state.closed:
            vehicle.opened.pop(intent.cmd_id, None)
        else:
            vehicle.opened[intent.cmd_id] = intent
        self.effects.records.append(intent)
        self.show(Topic.COMMANDS, f"{intent.cmd_id:016x}", None if intent.state.closed else view_of_intent(intent))
        self.touch(vehicle)
        return intent

    def close_intent(self, vehicle: VehicleNow, cmd_id: CmdId, state: IntentState, outcome: str) -> Intent | None:
        """Write down what became of a command; None if it was closed before."""
        intent = vehicle.opened.get(cmd_id)
        if intent is None:
            return None
        closed = self.utc if state.closed else None
        return self.keep_intent(vehicle, replace(intent, state=state, closed=closed, outcome=outcome))

    def save_station(self, record: StationRecord) -> None:
        """Keep and show what is believed of a station."""
        self.stations[record.station] = record
        self.stations_changed[record.station] = None
        self.jobs_changed |= self.backlog.waits_at(record.station)
        self.effects.records.append(record)
        self.show_station(record.station)

    def put_carrier(self, carrier: CarrierId, place: StationId | VehicleId | None, provenance: Provenance) -> None:
        """Move a carrier's record, and what is believed of the stations it left and came to."""
        before = self.carriers.get(carrier)
        if before and before.place in self.stations and before.place != place:
            left = self.stations[StationId(before.place)]
            if left.carrier == carrier:
                self.save_station(replace(left, present=False, carrier=None, provenance=provenance, at=self.utc))
        record = CarrierRecord(carrier, place, provenance, self.utc)
        self.carriers[carrier] = record
        self.effects.records.append(record)
        self.show_carrier(carrier)
        if place in self.stations:
            station = self.stations[StationId(place)]
            self.save_station(replace(station, present=True, carrier=carrier, provenance=provenance, at=self.utc))

    def drop_carrier(self, carrier: CarrierId) -> None:
        """Forget a carrier."""
        self.carriers.pop(carrier, None)
        self.effects.records.append(CarrierGone(carrier))
        self.show(Topic.CARRIERS, carrier, None)

    def keep_dest(self, dest: StationDest) -> None:
        """Keep a version of a station's DEST."""
        self.dests[dest.station] = dest
        self.taught += 1
        self.effects.records.append(dest)
        self.show_station(dest.station)

    def keep_offset(self, offset: VehicleOffset) -> None:
        """Keep a version of a vehicle's OFFSET."""
        self.offsets[offset.vehicle] = offset
        self.taught += 1
        self.effects.records.append(offset)

    def save_proposal(self, proposal: Proposal) -> Proposal:
        """Keep and show a proposal; one that is over leaves the live ones."""
        self.teaching.note_proposal(proposal)
        self.effects.records.append(proposal)
        self.show(
            Topic.TEACHING, f"proposal-{proposal.number}", None if proposal.state.over else view_of_proposal(proposal)
        )
        return proposal

    def save_session(self, session: TeachingSession) -> TeachingSession:
        """Keep and show a teaching session, and its station, which it closes to jobs."""
        self.teaching.note_session(session)
        self._note_teaching()
        self.effects.records.append(session)
        ended = session.state is not SessionState.OPEN
        self.show(Topic.TEACHING, f"session-{session.number}", None if ended else view_of_session(session))
        if session.station in self.specs:
            self.show_station(session.station)
        return session

    def new_walk(self) -> int:
        """Return the next number of an audit walk."""
        self._next_walk += 1
        return self._next_walk - 1

    def walk_at(self, station: StationId) -> Walk | None:
        """Return the open walk that a station is on."""
        return next((walk for walk in self.walks.values() if station in self.walk_places[walk.number]), None)

    def save_walk_place(self, place: WalkPlace) -> None:
        """Keep a place of a walk."""
        self.walk_places.setdefault(place.walk, {})[place.station] = place
        self.effects.records.append(place)

    def save_walk(self, walk: Walk) -> None:
        """Keep and show a walk; one that has ended leaves the live ones."""
        self.effects.records.append(walk)
        if walk.ended is None:
            self.walks[walk.number] = walk
            self.show_walk(walk)
            return
        self.walks.pop(walk.number, None)
        self.walk_places.pop(walk.number, None)
        self.show(Topic.WALKS, str(walk.number), None)

    def show_walk(self, walk: Walk) -> None:
        """Show an open walk."""
        places = self.walk_places[walk.number].values()
        seen = sum(place.seen is not None for place in places)
        self.show(Topic.WALKS, str(walk.number), view_of_walk(walk, len(places), seen))

    def new_closure(self) -> int:
        """Return the next number of a closure."""
        self._next_closure += 1
        return self._next_closure - 1

    def save_closure(self, closure: Closure) -> None:
        """Keep and show a closure, and the stations that it concerns."""
        self.closures.put(closure)
        self.effects.records.append(closure)
        self.show_closure(closure)
        for station in self.closures.stations(closure):
            if station in self.specs:
                self.show_station(station)

    def save_controller(self, record: ControllerRecord) -> None:
        """Keep and show the controller's state."""
        if record.pauses != self.controller.pauses:
            self.closures.still(record.pauses)
        self.controller = record
        self.effects.records.append(record)
        self.show_controller()

    # -- what people see ----------------------------------------------------------------------------------------------

    def show(self, topic: Topic, key: str, value: View | None) -> None:
        """Put a change of the read model into the effects."""
        self.effects.updates.append(Update(topic, key, value))

    def show_station(self, station: StationId) -> None:
        """Show a station as it is now."""
        self.show(
            Topic.STATIONS,
            station,
            view_of_station(
                self.specs[station],
                self.stations[station],
                self.dests.get(station),
                self.teaching.closing(station),
                tuple(closure.number for closure in self.closures.of(self.specs[station])),
            ),
        )

    def show_closure(self, closure: Closure, inside: Sequence[VehicleNow] = (), waiting: tuple[str, ...] = ()) -> None:
        """Show a closure, with who is inside and what those do; one that is over leaves the live ones."""
        stations = self.closures.stations(closure)
        names = tuple(vehicle.id for vehicle in inside)
        if closure.state.over:
            self._closures_shown.pop(closure.number, None)
            self.show(Topic.CLOSURES, str(closure.number), None)
            return
        view = view_of_closure(closure, stations, names, waiting)
        if self._closures_shown.get(closure.number) != view:
            self._closures_shown[closure.number] = view
            self.show(Topic.CLOSURES, str(closure.number), view)

    def show_carrier(self, carrier: CarrierId) -> None:
        """Show a carrier as it is now."""
        self.show(Topic.CARRIERS, carrier, view_of_carrier(self.carriers[carrier]))

    def show_controller(self) -> None:
        """Show the controller as it is now."""
        self.show(
            Topic.CONTROLLER,
            self.plant.name,
            with_traffic(
                view_of_controller(self.plant.name, self.controller, self.epoch, self.started, self.roll_call),
                self.traffic_state,
                self.closed,
            ),
        )

    def stilled(self, vehicle: VehicleNow) -> str:
        """Return why a vehicle begins nothing where it is, or anywhere; empty if it may."""
        if self.controller.state is not ControllerState.AUTO:
            return f"the controller is {self.controller.state.value}"
        return self.closures.barring(vehicle) or self.closures.paused_at(vehicle.barcode)

    def touch(self, vehicle: VehicleNow) -> None:
        """Note that a vehicle looks different now; it is shown with the next flush."""
        self.dirty.setdefault(vehicle.id, self.now)
        self.changed[vehicle.id] = self.touched[vehicle.id] = None

    def wake(self, vehicle: VehicleId) -> None:
        """Note that a vehicle should look again whether it can go on."""
        self.woken[vehicle] = self.changed[vehicle] = None
