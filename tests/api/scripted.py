"""A small controller with a real read model and hub: answers requests from memory, at once. Its plant has two hoists."""

from collections.abc import Callable, Collection, Sequence
from dataclasses import replace

from app.domain import requests as r
from app.domain import teaching_requests as t
from app.domain.alarms import AcknowledgeAlarm, Alarm, AlarmCount, AlarmKind
from app.domain.closures import ClosePlace, Closure, ClosureState, OpenPlace
from app.domain.device_requests import (
    CommandDevice,
    RaiseEmergency,
    ReleaseEmergency,
)
from app.domain.drive import DriveId
from app.domain.drive_records import DriveBackup, DriveOperation
from app.domain.drive_requests import DriveOrder, Word
from app.domain.errors import Refusal
from app.domain.ids import Actor, CarrierId, CmdId, DevId, JobId, LinkId, StationId, VehicleId, ZoneId
from app.domain.job import Job, JobState
from app.domain.layout import Axis, Edge, Plant, Point, PulseSet, Station, StationKind, VehicleSpec, Zone
from app.domain.records import (
    AuditRow,
    CarrierRecord,
    ControllerRecord,
    ControllerState,
    HistoryEvent,
    Intent,
    IntentState,
    Provenance,
    StationDest,
    StationRecord,
    TeachingEvent,
    VehicleOffset,
)
from app.domain.statistics import OpenJob, Queued, Transfer, Waited
from app.domain.teaching import Fate, Proposal, ProposalState, Reading, RowFate, Side, TeachingSession
from app.domain.units import Barcode, Millimetres, Pulses, Timestamp
from app.domain.view import (
    BitView,
    CarrierView,
    ControllerView,
    DeviceView,
    LineView,
    LinkView,
    PauseView,
    StationView,
    Topic,
    Update,
    VehicleView,
)
from app.domain.walks import AcceptWalk, EnterSights, StartWalk, Walk, WalkPlace, WalkRequest, WalkState
from app.domain.webhooks import (
    AddWebhook,
    ChangeWebhook,
    RemoveWebhook,
    ReplayWebhook,
    Webhook,
    WebhookProgress,
    WebhookRequest,
    WebhookTry,
)
from app.domain.why import Why
from app.fleet.closure_preview import SeenJob, SeenVehicle, Survey
from app.fleet.teaching_views import view_of_proposal, view_of_session
from app.fleet.views import view_of_alarm, view_of_closure, view_of_event, view_of_intent, view_of_job, view_of_walk
from app.planning.routing import Route, Router
from app.planning.track import Track
from app.protocols.itsc.session import LinkQuality
from app.runtime.hub import Hub, ReadModel
from app.runtime.metrics import Figures
from app.runtime.playback import Playback
from app.runtime.reception import Reception
from app.runtime.versions import Versions
from app.runtime.webhooks import Targets
from app.store.chain import Checked
from tests.api.scripted_drives import CATALOGUE, DRIVES, LINKS, ScriptedDrives

NOW = Timestamp(1_767_225_600.0)
B = Barcode
PLANT = Plant(
    name="tiny",
    points=tuple(Point(B(str(n)), Millimetres(n * 10), Millimetres(0)) for n in (1001, 1002, 1003)),
    edges=(
        Edge(B("1001"), B("1002"), Millimetres(1000)),
        Edge(B("1002"), B("1003"), Millimetres(1000)),
        Edge(B("1003"), B("1001"), Millimetres(2000), curve=True),
    ),
    stations=(
        Station(StationId("P1"), StationKind.PORT, B("1001")),
        Station(StationId("P2"), StationKind.PORT, B("1002")),
        Station(StationId("L3"), StationKind.SBFL, B("1003")),
    ),
    vehicles=tuple(VehicleSpec(VehicleId(f"V00{n}"), DevId(n)) for n in (1, 2)),
    zones=(Zone(ZoneId("Z1"), frozenset({B("1003"), B("1002")})),),
    links=LINKS,
    drives=DRIVES,
    catalogues=(CATALOGUE,),
)


DOOR = DeviceView("DOOR1", "door", "HALL", 30, fresh=True, state="closed", since=NOW, seen=NOW)


class MemoryReader:
    """Committed history."""

    def __init__(self) -> None:
        self.kept: dict[str, Job] = {}
        self.whys: dict[int, Why] = {}
        self.past: list[HistoryEvent] = []
        self.commands: dict[int, Intent] = {}
        self.asked: list[AuditRow] = []
        self.pulses: list[StationDest] = []
        self.corrections: list[VehicleOffset] = []
        self.drives = ScriptedDrives(NOW)
        self.sent: list[TeachingEvent] = []
        self.proposed: dict[int, Proposal] = {}
        self.taught_in: dict[int, TeachingSession] = {}
        self.shut: dict[int, Closure] = {}
        self.wrong: dict[int, Alarm] = {}
        self.done: list[Transfer] = []
        self.walked: dict[int, Walk] = {}
        self.along: list[WalkPlace] = []

    def first_event(self, moment: float) -> int:
        return 1

    def happened(
        self,
        begin: float,
        end: float,
        *,
        named: Collection[str] | None = None,
        newest: bool = False,
        limit: int = 100,
        **_: object,
    ) -> Sequence[HistoryEvent]:
        found = [one for one in self.past if begin <= one.at < end and (named is None or one.event in named)]
        return found[-limit:] if newest else found[:limit]

    def event_count(self, begin: float, end: float) -> int:
        return self.events_between

    events_between = 7

    def transfers(self, begin: float, end: float) -> Sequence[Transfer]:
        return [one for one in self.done if begin <= one.ended < end]

    def queued(self, begin: float, end: float) -> Sequence[Queued]:
        return [Queued(one.created, one.assigned) for one in self.done]

    def waits(self, begin: float, end: float) -> tuple[Sequence[Waited], int]:
        return [Waited(begin, begin + 60, "P2 is occupied by F1", "LOT-1")], 1

    def waits_named(self, names: Collection[str]) -> Sequence[Waited]:
        return [Waited(NOW - 580, NOW - 565, "P2 is occupied by F1", name) for name in sorted(names)]

    def open_jobs(self, moment: float) -> Sequence[OpenJob]:
        return [OpenJob("LOT-9", None, "P1", "P2", 50, moment - 90, "no vehicle is free")]

    def walk(self, number: int) -> Walk | None:
        return self.walked.get(number)

    def walks(self, after: int | None = None, limit: int = 100) -> Sequence[Walk]:
        return [one for one in reversed(self.walked.values()) if after is None or one.number < after][:limit]

    def walk_places(self, number: int) -> Sequence[WalkPlace]:
        return [place for place in self.along if place.walk == number]

    def alarm(self, number: int) -> Alarm | None:
        return self.wrong.get(number)

    def alarms(self, *, after: int | None = None, limit: int = 100, **asked: object) -> Sequence[Alarm]:
        self.asked_for = asked
        return [one for one in reversed(self.wrong.values()) if after is None or one.number < after][:limit]

    def alarm_counts(self, by: tuple[str, ...], begin: float, end: float, limit: int = 100) -> Sequence[AlarmCount]:
        self.asked_for = {"begin": begin, "end": end}
        about = {"kind": "vehicle", "source": "V001", "code": "101"}
        return [AlarmCount({name: about[name] for name in by}, 3, 90.0, NOW)]

    def failures(self, begin: float, end: float) -> Sequence[tuple[str, float, float | None]]:
        return [("V001", NOW - 3600, NOW - 1800)]

    def closure(self, number: int) -> Closure | None:
        return self.shut.get(number)

    def closures(self, after: int | None = None, limit: int = 100) -> Sequence[Closure]:
        found = [one for one in reversed(self.shut.values()) if after is None or one.number < after]
        return found[:limit]

    def why(self, order: int) -> Why | None:
        return self.whys.get(order)

    def operation(self, number: int) -> DriveOperation | None:
        return self.drives.operations.get(number)

    def operations(
        self, *, drive: str | None = None, line: str | None = None, after: int | None = None, limit: int = 100
    ) -> Sequence[DriveOperation]:
        found = [
            one
            for one in reversed(self.drives.operations.values())
            if drive in (None, one.drive) and line in (None, one.line) and (after is None or one.number < after)
        ]
        return found[:limit]

    def backup(self, number: int) -> DriveBackup | None:
        return self.drives.backups.get(number)

    def backups(self, drive: DriveId, after: int | None = None, limit: int = 100) -> Sequence[DriveBackup]:
        found = [one for one in reversed(self.drives.backups.values()) if one.drive == drive]
        return [one for one in found if after is None or one.number < after][:limit]

    def job(self, job: JobId) -> Job | None:
        return self.kept.get(job)

    def jobs_named(self, names: Sequence[JobId]) -> Sequence[Job]:
        return [self.kept[name] for name in names if name in self.kept]

    def job_count(self) -> int:
        return len(self.kept)

    def job_names(self, after: int, limit: int) -> Sequence[tuple[int, str]]:
        return list(enumerate(self.kept, 1))[after : after + limit]

    def job_by_key(self, key: str) -> Job | None:
        return next((job for job in self.kept.values() if job.idempotency_key == key), None)

    def jobs(
        self,
        *,
        state: str | None = None,
        carrier: str | None = None,
        vehicle: str | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> Sequence[Job]:
        found = [
            job
            for job in reversed(self.kept.values())
            if (state is None or job.state == state)
            and (carrier is None or job.carrier == carrier)
            and (vehicle is None or job.vehicle == vehicle)
            and (after is None or job.order < after)
        ]
        return found[:limit]

    def events(
        self, after: int = 0, limit: int = 100, *, job: str | None = None, vehicle: str | None = None
    ) -> Sequence[HistoryEvent]:
        found = [e for e in self.past if e.seq > after and job in (None, e.job) and vehicle in (None, e.vehicle)]
        return found[:limit]

    def webhook_tries(self, webhook: int, after: int | None = None, limit: int = 100) -> Sequence[WebhookTry]:
        return [WebhookTry(webhook, 1, NOW, 7, "TransferCompleted", 1, None, 5.0, "no answer within 10 s")]

    def intent(self, cmd_id: CmdId) -> Intent | None:
        return self.commands.get(cmd_id)

    def intents(self, vehicle: VehicleId, limit: int = 100) -> Sequence[Intent]:
        return [i for i in reversed(self.commands.values()) if i.vehicle == vehicle][:limit]

    def audit(self, after: int = 0, limit: int = 100) -> Sequence[tuple[int, AuditRow]]:
        return list(enumerate(self.asked, 1))[after : after + limit]

    def audit_found(
        self,
        *,
        actor: str | None = None,
        action: str | None = None,
        target: str | None = None,
        accepted: bool | None = None,
        begin: float | None = None,
        end: float | None = None,
        before: int | None = None,
        limit: int = 100,
    ) -> Sequence[tuple[int, AuditRow]]:
        found = [
            (seq, row)
            for seq, row in enumerate(self.asked, 1)
            if actor in (None, row.actor) and action in (None, row.action) and target in (None, row.target)
            if accepted in (None, row.accepted) and (begin or 0) <= row.at and (end is None or row.at < end)
        ]
        return [one for one in reversed(found) if before is None or one[0] < before][:limit]

    broken: Checked | None = None

    def audit_checked(self, after: int, limit: int) -> Checked:
        if self.broken is not None:
            return self.broken
        rows = self.asked[after : after + limit]
        return Checked(len(rows), after + len(rows), "00")

    def dests(self, station: StationId) -> Sequence[StationDest]:
        return [row for row in self.pulses if row.station == station]

    def offsets(self, vehicle: VehicleId) -> Sequence[VehicleOffset]:
        return [row for row in self.corrections if row.vehicle == vehicle]

    def all_dests(self, *, history: bool = False) -> Sequence[StationDest]:
        return self.pulses if history else list({row.station: row for row in self.pulses}.values())

    def all_offsets(self, *, history: bool = False) -> Sequence[VehicleOffset]:
        return self.corrections if history else list({row.vehicle: row for row in self.corrections}.values())

    def taught(
        self, after: int = 0, limit: int = 100, *, vehicle: str | None = None, barcode: str | None = None
    ) -> Sequence[TeachingEvent]:
        return [row for row in self.sent if row.number > after][:limit]

    def proposals(
        self,
        *,
        state: str | None = None,
        station: str | None = None,
        vehicle: str | None = None,
        session: int | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> Sequence[Proposal]:
        return list(self.proposed.values())[:limit]

    def proposal(self, number: int) -> Proposal | None:
        return self.proposed.get(number)

    def sessions(
        self,
        *,
        state: str | None = None,
        station: str | None = None,
        vehicle: str | None = None,
        after: int | None = None,
        limit: int = 100,
    ) -> Sequence[TeachingSession]:
        return list(self.taught_in.values())[:limit]

    def session(self, number: int) -> TeachingSession | None:
        return self.taught_in.get(number)


class Scripted:
    """Plays the controller. ``refusal`` set: the next request gets it. ``seen`` has every request."""

    def __init__(
        self, later: Callable[[float, Callable[[], None]], object] | None = None, plant: Plant = PLANT
    ) -> None:
        self.plant = plant
        self.model = ReadModel(lambda: float(self.model.version))
        self.hub = Hub(self.model, later)
        self.reader = MemoryReader()
        self.figures = Figures(plant)
        self.backlog = (0, 0)
        self.targets = Targets(["mes.fab", "10.0.0.0/8"])
        self.subscribed: dict[int, tuple[Webhook, WebhookProgress]] = {}
        self.trouble = ""
        self.refusal: Refusal | Exception | None = None
        self.seen: list[r.Request] = []
        self.traffic: list[tuple[Timestamp, str, bytes]] = []
        self._cmd = 1 << 32
        self.hub.publish([self._controller(ControllerRecord(ControllerState.AUTO))])
        self.reception: Reception | None = None
        self.versions: Versions | None = None
        self.version: int | None = None
        self.hub.publish([self._vehicle(v) for v in plant.vehicles])
        self.hub.publish([self._station(StationRecord(s.id, at=NOW)) for s in plant.stations])
        self.drives = self.reader.drives
        if plant is PLANT:
            self.hub.publish(self.drives.shown())
            self.hub.publish([Update(Topic.DEVICES, DOOR.id, DOOR)])

    def utc(self) -> Timestamp:
        return NOW

    playback: Playback | None = None

    def survey(self) -> Survey:
        track = Track(self.plant)
        router = Router(track)
        vehicle = SeenVehicle(VehicleId("V001"), B("1003"), (B("1003"),), (B("1003"), B("1001"), B("1002")))
        job = SeenJob(JobId("J1"), "P1", StationId("P2"), None)
        return Survey(track, router.edges, router.seconds, (), (vehicle,), (job,))

    def routes(self, start: Barcode, goal: Barcode, most: int) -> Sequence[Route]:
        return Router(Track(self.plant)).alternatives(start, goal, most)

    def webhooks(self) -> Sequence[tuple[Webhook, WebhookProgress]]:
        return list(self.subscribed.values())

    async def ping_webhook(self, number: int) -> WebhookTry | None:
        if number not in self.subscribed:
            return None
        return WebhookTry(number, 1, NOW, None, "Ping", 1, 200, 0.012, "")

    def _webhook(self, request: WebhookRequest) -> r.Reply:
        if isinstance(request, AddWebhook):
            number = len(self.subscribed) + 1
            made = Webhook(number, request.url, request.events, request.secret, request.actor, NOW, request.note)
            self.subscribed[number] = made, WebhookProgress(number, request.after or 0)
            return r.Accepted("webhooks", str(number), created=True)
        if request.webhook not in self.subscribed:
            return Refusal("not-found", f"there is no webhook {request.webhook}")
        webhook, progress = self.subscribed[request.webhook]
        match request:
            case RemoveWebhook():
                del self.subscribed[request.webhook]
            case ChangeWebhook():
                self.subscribed[request.webhook] = replace(webhook, url=request.url or webhook.url), progress
            case ReplayWebhook():
                self.subscribed[request.webhook] = webhook, replace(progress, position=request.after)
            case _:
                pass
        return r.Accepted("webhooks", str(request.webhook))

    def waits(self) -> dict[str, int]:
        return {"held": 0}

    def named_quality(self) -> Sequence[tuple[VehicleId, LinkQuality]]:
        quality = LinkQuality(2, 10, 11, 1, 3, 4, 9, 5, 12.5, 11.0)
        return [(vehicle.id, quality) for vehicle in self.plant.vehicles]

    def frames(self, vehicle: VehicleId) -> Sequence[tuple[Timestamp, str, bytes]]:
        return self.traffic

    def tell(self, word: Word) -> r.Reply:
        return self.drives.tell(word)

    def links(self) -> Sequence[LineView]:
        return self.drives.links()

    def link_frames(self, link: LinkId) -> Sequence[tuple[Timestamp, str, bytes]]:
        return self.drives.traffic

    async def ask(self, request: r.Request) -> r.Reply:
        self.seen.append(request)
        refusal, self.refusal = self.refusal, None
        if isinstance(refusal, Exception):
            raise refusal
        reply = refusal or (self._webhook(request) if isinstance(request, WebhookRequest) else self._reply(request))
        accepted = isinstance(reply, r.Accepted)
        self.reader.asked.append(AuditRow(NOW, request.actor, type(request).__name__, "", "", accepted))
        return reply

    def happen(
        self, event: str, job: str | None = None, vehicle: str | None = None, at: Timestamp = NOW
    ) -> HistoryEvent:
        """Let an event happen: kept, then published."""
        row = HistoryEvent(
            len(self.reader.past) + 1,
            at,
            event,
            7,
            JobId(job) if job else None,
            None,
            VehicleId(vehicle) if vehicle else None,
        )
        self.reader.past.append(row)
        updates = [Update(Topic.EVENTS, str(row.seq), view_of_event(row))]
        self.hub.publish(updates)
        self.figures.jobs.take(updates)
        return row

    def end(self, job: str, state: JobState = JobState.COMPLETED) -> None:
        """Let a job end: it leaves the model."""
        self.reader.kept[job] = replace(self.reader.kept[job], state=state, ended=NOW)
        self.hub.publish([Update(Topic.JOBS, job, None)])

    def _reply(self, request: r.Request) -> r.Reply:
        match request:
            case r.CreateJob():
                return self._create(request)
            case r.CancelJob() | r.AbortJob() | r.ChangeJob():
                return self._change(request)
            case r.WriteStation() | r.WriteDest():
                return self._write(request)
            case r.WriteCarrier():
                return self._carrier(request)
            case r.PauseController() | r.ResumeController():
                state = ControllerState.PAUSING if isinstance(request, r.PauseController) else ControllerState.AUTO
                self.hub.publish([self._controller(ControllerRecord(state, getattr(request, "reason", "")))])
                return r.Accepted(Topic.CONTROLLER, "controller")
            case _ if isinstance(request, DriveOrder):
                reply, updates = self.drives.answer(request)
                self.hub.publish(updates)
                return reply
            case t.OpenTeaching():
                self.teach()
                return r.Accepted(Topic.TEACHING, "session-1", created=True)
            case t.ImportTaught():
                return r.Accepted(Topic.TEACHING, "import", fates=(RowFate(2, "P1", Fate.SAME, version=1),))
            case t.EndTeaching() | t.ApproveProposal() | t.RejectProposal() | t.AssignProposal():
                return r.Accepted(Topic.TEACHING, "proposal-1")
            case t.StartTeaching():
                return r.Accepted(Topic.TEACHING, "session-1", cmd_id=self._cmd)
            case _ if isinstance(request, r.HallRequest):
                return self._hall(request)
            case _:
                return self._of_room(request)

    def _of_room(self, request: r.Request) -> r.Reply:
        match request:
            case _ if isinstance(request, WalkRequest):
                return self._walk(request)
            case r.StageVehicle():
                return r.Accepted(Topic.VEHICLES, request.vehicle or "V001")
            case AcknowledgeAlarm() if request.alarm not in self.reader.wrong:
                return Refusal("not-found", f"There is no alarm {request.alarm}.")
            case AcknowledgeAlarm():
                row = replace(self.reader.wrong[request.alarm], acknowledged=NOW, acknowledged_by=request.actor)
                self.reader.wrong[request.alarm] = row
                self.hub.publish([Update(Topic.ALARMS, str(row.number), view_of_alarm(row))])
                return r.Accepted(Topic.ALARMS, str(row.number))
            case ClosePlace() | OpenPlace():
                return self._closure(request)
            case r.StopAll() | r.PauseZone() | r.ResumeZone():
                return self._still(request)
            case _:
                return self._vehicles(request)

    def _hall(self, request: r.HallRequest) -> r.Reply:
        match request:
            case CommandDevice():
                return self._device(request)
            case RaiseEmergency() | ReleaseEmergency():
                return r.Accepted(Topic.CONTROLLER, "controller")
            case _:
                return r.Accepted(Topic.DEVICES, request.device)

    def _closure(self, request: ClosePlace | OpenPlace) -> r.Reply:
        shut = self.reader.shut
        if isinstance(request, ClosePlace):
            number = len(shut) + 1
            row = Closure(
                number, request.place, (), request.reason, request.actor, request.purpose, NOW, request.expires
            )
        elif request.closure in shut:
            number = request.closure
            row = replace(shut[number], state=ClosureState.OPENED, ended=NOW, ended_by=request.actor)
        else:
            return Refusal("not-found", f"There is no closure {request.closure} now.")
        shut[number] = row
        view = None if row.state.over else view_of_closure(row, ())
        self.hub.publish([Update(Topic.CLOSURES, str(number), view)])
        return r.Accepted(Topic.CLOSURES, str(number), created=isinstance(request, ClosePlace))

    def _walk(self, request: WalkRequest) -> r.Reply:
        walked = self.reader.walked
        if isinstance(request, StartWalk):
            walked[1] = Walk(1, request.actor, request.reason, NOW)
            self.reader.along = [WalkPlace(1, StationId("L3"), present, None) for present in (None,)]
        elif request.walk not in walked:
            return Refusal("not-found", f"There is no open walk {request.walk}.")
        elif isinstance(request, EnterSights):
            (sight,) = request.sights
            self.reader.along = [
                replace(self.reader.along[0], seen=sight.present, by=request.actor, at=Timestamp(NOW + 1))
            ]
        else:
            state = WalkState.ACCEPTED if isinstance(request, AcceptWalk) else WalkState.ABANDONED
            walked[1] = replace(walked[1], state=state, ended=NOW, ended_by=request.actor)
        seen = sum(place.seen is not None for place in self.reader.along)
        view = None if walked[1].ended else view_of_walk(walked[1], len(self.reader.along), seen)
        self.hub.publish([Update(Topic.WALKS, "1", view)])
        return r.Accepted(Topic.WALKS, "1", created=isinstance(request, StartWalk))

    def _still(self, request: r.Stilling) -> r.Reply:
        record = ControllerRecord(ControllerState.PAUSING if isinstance(request, r.StopAll) else ControllerState.AUTO)
        view = self._controller(record).value
        assert isinstance(view, ControllerView)
        if isinstance(request, r.PauseZone):
            if request.zone not in {zone.id for zone in self.plant.zones}:
                return Refusal("not-found", f"There is no zone {request.zone}.")
            pause = PauseView(request.zone, request.actor, request.reason, NOW, request.stop)
            view = replace(view, pauses=(pause,))
        self.hub.publish([Update(Topic.CONTROLLER, "controller", view)])
        return r.Accepted(Topic.CONTROLLER, "controller")

    def _create(self, request: r.CreateJob) -> r.Reply:
        order = len(self.reader.kept) + 1
        known = {station.id for station in self.plant.stations}
        if request.destination not in known:
            return Refusal("invalid", f"There is no station {request.destination}.", "GET /stations", "destination")
        job = Job(
            request.job or JobId(f"J{order}"),
            order,
            request.carrier,
            StationId(request.source),
            request.destination,
            request.priority,
            NOW,
            request.actor,
            request.fingerprint,
            request.idempotency_key,
            wish=request.vehicle,
            fallbacks=request.fallbacks,
        )
        self._keep(job)
        self.happen("TransferInitiated", job.id)
        return r.Accepted(Topic.JOBS, job.id, created=True)

    def _change(self, request: r.CancelJob | r.AbortJob | r.ChangeJob) -> r.Reply:
        job = self.reader.kept.get(request.job)
        if job is None:
            return Refusal("not-found", f"There is no job {request.job}.")
        if job.state.terminal:
            return Refusal("not-now", f"Job {job.id} is {job.state}.", "Order a new one.")
        if isinstance(request, r.CancelJob):
            self.end(job.id, JobState.CANCELLED)
        elif isinstance(request, r.AbortJob):
            self._keep(replace(job, state=JobState.ABORTING))
        else:
            self._keep(replace(job, priority=request.priority or job.priority))
        return r.Accepted(Topic.JOBS, job.id)

    def _keep(self, job: Job) -> None:
        self.reader.kept[job.id] = job
        self.hub.publish([Update(Topic.JOBS, job.id, view_of_job(job))])

    def _write(self, request: r.WriteStation | r.WriteDest) -> r.Reply:
        if self.plant.station(request.station) is None:
            return Refusal("not-found", f"There is no station {request.station}.")
        record = StationRecord(request.station, at=NOW)
        if isinstance(request, r.WriteDest):
            version = len(self.reader.dests(request.station))
            if request.expected not in (None, version):
                return Refusal("stale", f"It is version {version} now.", "Read it again.")
            row = StationDest(request.station, version + 1, request.pulses, request.actor, "host", NOW)
            self.reader.pulses.append(row)
        else:
            carrier = CarrierId(request.carrier) if request.carrier else None
            record = replace(record, present=request.present, carrier=carrier, provenance=Provenance.HOST)
        self.hub.publish([self._station(record)])
        return r.Accepted(Topic.STATIONS, request.station)

    def _carrier(self, request: r.WriteCarrier) -> r.Reply:
        created = self.model.get(Topic.CARRIERS, request.carrier) is None
        if request.place is None:
            if created:
                return Refusal("not-found", f"There is no carrier {request.carrier}.")
            self.hub.publish([Update(Topic.CARRIERS, request.carrier, None)])
            return r.Accepted(Topic.CARRIERS, request.carrier)
        row = CarrierRecord(request.carrier, StationId(request.place), Provenance.HOST, NOW)
        view = CarrierView(row.carrier, row.place, row.provenance.value, verified=True, at=row.at)
        self.hub.publish([Update(Topic.CARRIERS, row.carrier, view)])
        return r.Accepted(Topic.CARRIERS, row.carrier, created=created)

    def _device(self, request: CommandDevice) -> r.Reply:
        self._cmd += 1
        name = VehicleId(request.device)
        intent = Intent(CmdId(self._cmd), name, request.act.value, IntentState.OPEN, NOW, request.actor)
        self.reader.commands[self._cmd] = intent
        self.hub.publish([Update(Topic.COMMANDS, f"{self._cmd:016x}", view_of_intent(intent))])
        return r.Accepted(Topic.DEVICES, request.device, cmd_id=self._cmd)

    def _vehicles(self, request: r.Request) -> r.Reply:
        vehicle = VehicleId(getattr(request, "vehicle", ""))
        spec = self.plant.vehicle(vehicle)
        if spec is None:
            return Refusal("not-found", f"There is no vehicle {vehicle}.")
        if isinstance(request, r.WriteOffset):
            version = len(self.reader.corrections) + 1
            self.reader.corrections.append(VehicleOffset(vehicle, version, request.pulses, request.actor, "host", NOW))
        if isinstance(request, r.MoveVehicle):
            return r.Accepted(Topic.VEHICLES, vehicle)
        self._cmd += 1
        intent = Intent(CmdId(self._cmd), vehicle, type(request).__name__, IntentState.OPEN, NOW, request.actor)
        self.reader.commands[self._cmd] = intent
        self.hub.publish([Update(Topic.COMMANDS, f"{self._cmd:016x}", view_of_intent(intent))])
        return r.Accepted(Topic.VEHICLES, vehicle, cmd_id=self._cmd)

    def alarm(self) -> Alarm:
        """Let V001 have alarm 1."""
        row = Alarm(1, AlarmKind.VEHICLE, "V001", "101", "alarm 101 wrong barcode", "look", NOW)
        self.reader.wrong[1] = row
        self.hub.publish([Update(Topic.ALARMS, "1", view_of_alarm(row))])
        return row

    def teach(self) -> None:
        """Let session 1 at P1 with V001 have taught proposal 1, which waits for approval."""
        v1, p1, b = VehicleId("V001"), StationId("P1"), B("1001")
        cmd = CmdId(1 << 63)
        self.reader.sent = [
            TeachingEvent(v1, "1/1", cmd, 0x2074, Axis.LIFT, Pulses(7), b, NOW, 1, ACTOR),
            TeachingEvent(v1, "1/1", cmd, 0x2079, None, Pulses(7), b, NOW, 2),
        ]
        session = TeachingSession(1, p1, v1, ACTOR, NOW)
        self.reader.taught_in = {1: session}
        readings = (Reading(Axis.LIFT, Pulses(7), cmd, (1,)),)
        proposal = Proposal(1, Side.DEST, v1, b, NOW, NOW, readings, ProposalState.READY, station=p1, session=1)
        self.reader.proposed = {1: replace(proposal, result=PulseSet(Pulses(1), Pulses(2), Pulses(4)), base=2)}
        self.hub.publish(
            [
                Update(Topic.TEACHING, "session-1", view_of_session(session)),
                Update(Topic.TEACHING, "proposal-1", view_of_proposal(self.reader.proposed[1])),
            ]
        )

    def forget_commands(self) -> None:
        """Let all commands leave the model."""
        self.hub.publish([Update(Topic.COMMANDS, f"{cmd:016x}", None) for cmd in self.reader.commands])

    def _controller(self, record: ControllerRecord) -> Update:
        view = ControllerView(self.plant.name, record.state.value, record.reason, 1, NOW)
        return Update(Topic.CONTROLLER, "controller", view)

    @staticmethod
    def _vehicle(spec: VehicleSpec) -> Update:
        link = LinkView(up=True, since=NOW, round_trip_ms=1.5)
        bits = (BitView("MODE", 3, "AUTO"), BitView("F", 0, "no FOUP"))
        view = VehicleView(
            spec.id,
            spec.dev_id,
            "default",
            "127.0.0.1:1",
            "not_assigned",
            "idle",
            "in_service",
            link,
            bits=bits,
            seen=NOW,
        )
        return Update(Topic.VEHICLES, spec.id, view)

    def _station(self, record: StationRecord) -> Update:
        spec = self.plant.station(record.station)
        assert spec is not None
        view = StationView(
            spec.id,
            spec.kind.value,
            spec.barcode,
            record.present,
            record.carrier,
            record.reserved,
            record.out_of_service,
            record.provenance.value,
            verified=record.provenance is Provenance.HOST,
            at=record.at,
            target=None,
            target_version=None,
        )
        return Update(Topic.STATIONS, spec.id, view)


ACTOR = Actor("kim")
PULSES = PulseSet(Pulses(1), Pulses(2), Pulses(3))
