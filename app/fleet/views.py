"""How the fleet's state looks to people and hosts (``app.domain.view``)."""

from collections.abc import Callable, Iterable
from dataclasses import replace

from app.domain.alarms import Alarm
from app.domain.closures import Closure
from app.domain.ids import Epoch, VehicleId
from app.domain.job import Job, Leg
from app.domain.layout import Plant, PulseSet, Station, StationKind
from app.domain.pulses import missing
from app.domain.records import (
    CarrierRecord,
    ControllerRecord,
    HistoryEvent,
    Intent,
    Provenance,
    StationDest,
    StationRecord,
)
from app.domain.teaching import TeachingSession
from app.domain.units import Barcode, Seconds, Timestamp
from app.domain.vehicle import Activity, Condition, Oper, VehicleState
from app.domain.view import (
    AgvView,
    AlarmView,
    BitView,
    CarrierView,
    ClosureView,
    CommandView,
    ControllerView,
    EventView,
    HoldView,
    JobView,
    LinkView,
    LockoutView,
    PauseView,
    StationView,
    VehicleView,
    WalkView,
)
from app.domain.walks import Walk
from app.fleet.closed import Closed, named
from app.fleet.traffic_state import TrafficState
from app.fleet.vehicle import Errand, Purpose, Stage, VehicleNow

VERIFIED = frozenset({Provenance.HOST, Provenance.PERSON, Provenance.SENSOR, Provenance.VERIFIED})
"""Provenances that count as seen by somebody, not inferred by us (DOMAIN section 2)."""

BITS_KEPT = 4096
"""Our choice: a vehicle that sends noise must not fill the memory."""
_bits: dict[int, tuple[Condition, tuple[BitView, ...]]] = {}


def view_of_job(job: Job) -> JobView:
    """Return a job as people see it."""
    return JobView(
        id=job.id,
        order=job.order,
        state=job.state.value,
        leg=job.leg.value,
        source=job.source,
        destination=job.destination,
        priority=job.priority,
        carrier=job.carrier,
        vehicle=job.vehicle,
        wish=job.wish,
        fallbacks=job.fallbacks,
        reason=job.reason,
        result=job.result,
        actor=job.actor,
        created=job.created,
        assigned=job.assigned,
        picked=job.picked,
        ended=job.ended,
    )


def view_of_event(event: HistoryEvent) -> EventView:
    """Return a durable event as people see it."""
    return EventView(
        seq=event.seq,
        at=event.at,
        event=event.event,
        ceid=event.ceid,
        job=event.job,
        carrier=event.carrier,
        vehicle=event.vehicle,
        source=event.source,
        destination=event.destination,
        result=event.result,
        detail=event.detail,
    )


def view_of_alarm(alarm: Alarm) -> AlarmView:
    """Return an alarm as people see it."""
    return AlarmView(
        id=alarm.number,
        kind=alarm.kind.value,
        source=alarm.source,
        code=alarm.code,
        cause=alarm.cause,
        remedy=alarm.remedy,
        begun=alarm.begun,
        ended=alarm.ended,
        outcome=alarm.outcome,
        job=alarm.job,
        acknowledged=alarm.acknowledged,
        acknowledged_by=alarm.acknowledged_by,
        note=alarm.note,
    )


def view_of_walk(walk: Walk, places: int, entered: int) -> WalkView:
    """Return an audit walk as people see it."""
    return WalkView(
        id=walk.number,
        actor=walk.actor,
        reason=walk.reason,
        state=walk.state.value,
        started=walk.started,
        ended=walk.ended,
        ended_by=walk.ended_by,
        places=places,
        entered=entered,
    )


def view_of_closure(
    closure: Closure, stations: tuple[str, ...], inside: tuple[str, ...] = (), waiting: tuple[str, ...] = ()
) -> ClosureView:
    """Return a closure as people see it."""
    return ClosureView(
        id=closure.number,
        kind=closure.place.kind.value,
        names=closure.place.names,
        place=str(closure.place),
        barcodes=closure.barcodes,
        stations=stations,
        reason=closure.reason,
        owner=closure.owner,
        purpose=closure.purpose.value,
        state=closure.state.value,
        since=closure.since,
        expires=closure.expires,
        closed=closure.closed,
        releases=closure.releases,
        ended=closure.ended,
        ended_by=closure.ended_by,
        inside=inside,
        waiting=waiting,
    )


def view_of_station(
    spec: Station,
    record: StationRecord,
    dest: StationDest | None,
    teaching: TeachingSession | None = None,
    closures: tuple[int, ...] = (),
) -> StationView:
    """Return a station and what is believed of it."""
    return StationView(
        id=spec.id,
        kind=spec.kind.value,
        barcode=spec.barcode,
        present=record.present,
        carrier=record.carrier,
        reserved=record.reserved,
        out_of_service=record.out_of_service,
        provenance=record.provenance.value,
        verified=record.provenance in VERIFIED,
        at=record.at or None,
        target=_complete(dest),
        target_version=dest.version if dest else None,
        missing=tuple(axis.value for axis in missing(dest.pulses if dest else None))
        if spec.kind is StationKind.PORT
        else (),
        teaching=teaching.number if teaching else None,
        closures=closures,
    )


def _complete(dest: StationDest | None) -> tuple[int, int, int] | None:
    if dest is None or not isinstance(dest.pulses, PulseSet):
        return None
    return (dest.pulses.shft, dest.pulses.rota, dest.pulses.lift)


def view_of_carrier(record: CarrierRecord) -> CarrierView:
    """Return where a carrier is believed to be."""
    return CarrierView(record.carrier, record.place, record.provenance.value, record.provenance in VERIFIED, record.at)


def view_of_controller(
    plant: str, record: ControllerRecord, epoch: Epoch, started: Timestamp, waiting_for: Iterable[VehicleId]
) -> ControllerView:
    """Return the controller as a whole."""
    return ControllerView(
        plant=plant,
        state=record.state.value,
        reason=record.reason,
        epoch=epoch,
        started=started,
        waiting_for=tuple(waiting_for),
        emergencies=tuple(f"{e.kind.value}: {e.reason} ({e.actor})" for e in record.emergencies),
        pauses=tuple(PauseView(p.zone, p.owner, p.reason, p.since, p.stopped) for p in record.pauses),
    )


def with_traffic(view: ControllerView, state: TrafficState, closed: Closed) -> ControllerView:
    """Return the controller's view with what is told of the traffic as a whole."""
    return replace(
        view,
        circles=state.circles,
        circles_found=state.circles_found,
        circles_resolved=state.circles_resolved,
        kept_off=tuple(f"{', '.join(map(named, places))}: {words}" for words, places in closed.by_words().items()),
        closed_places=len(closed),
        cut_off=tuple(f"{station}: {why}" for station, why in state.cut_off.items()),
        led_round=state.led_round,
        led_quicker=state.led_quicker,
        slow_track=state.slow,
        weighed=state.weighed,
        restrained_to=state.restrained_to,
    )


def view_of_intent(intent: Intent) -> CommandView:
    """Return a command and its outcome."""
    return CommandView(
        cmd_id=f"{intent.cmd_id:016x}",
        vehicle=intent.vehicle,
        kind=intent.kind,
        state=intent.state.value,
        actor=intent.actor,
        opened=intent.opened,
        closed=intent.closed,
        outcome=intent.outcome,
        job=intent.job,
    )


def state_of(vehicle: VehicleNow, job: Job | None) -> VehicleState:
    """Return the E82 state (ARCHITECTURE section 4)."""
    if vehicle.record.off_rail or vehicle.stage is Stage.ABSENT:
        return VehicleState.REMOVED
    if vehicle.handling:
        return VehicleState.ACQUIRING if vehicle.handling.pickup else VehicleState.DEPOSITING
    if job is None:
        return VehicleState.NOT_ASSIGNED
    if job.leg in {Leg.ACQUIRING, Leg.DEPOSITING} and vehicle.stage is Stage.SETTLING:
        return VehicleState.ACQUIRING if job.leg is Leg.ACQUIRING else VehicleState.DEPOSITING
    return VehicleState.ENROUTE if vehicle.drive else VehicleState.PARKED


def activity_of(vehicle: VehicleNow) -> Activity:
    """Return one word for people."""
    first: tuple[tuple[object, Activity], ...] = (
        (vehicle.record.off_rail, "off_rail"),
        (vehicle.stage is Stage.ABSENT, "absent"),
        (vehicle.record.lockout, "locked_out"),
        (vehicle.recovery, "recovering"),
        (vehicle.record.hold, "held"),
        (vehicle.oper is Oper.ALARM, "alarm"),
        (vehicle.stage is Stage.SETTLING, "settling"),
        (vehicle.handling and vehicle.handling.pickup, "acquiring"),
        (vehicle.handling, "depositing"),
        (vehicle.oper is Oper.PAUSE, "paused"),
        (vehicle.drive, "moving"),
        (_charges(vehicle), "charging"),
        (vehicle.waiting, "waiting"),
        (vehicle.errand or vehicle.job or vehicle.order, "busy"),
    )
    return next((word for applies, word in first if applies), "idle")


def address_of(vehicle: VehicleNow) -> str:
    """Return where the vehicle's line leads."""
    spec = vehicle.spec
    if vehicle.is_agv:
        return f"{spec.link}, device {spec.dev_id}"
    return f"listening for DEV_ID {spec.dev_id}" if spec.listen else f"{spec.host}:{spec.port}"


def goal_of(errand: Errand | None, job: Job | None) -> str | None:
    """Return what the vehicle is going to, as a station where it is one."""
    if errand is None:
        return None
    if job and errand.purpose is Purpose.SOURCE:
        return job.source
    if job and errand.purpose is Purpose.DESTINATION:
        return job.destination
    return errand.goal


def bits_of(condition: Condition) -> tuple[BitView, ...]:
    """Return every field of the status words; made once for each condition, since a fleet shows few different ones."""
    known = _bits.get(id(condition))
    if known is not None and known[0] is condition:
        return known[1]
    if len(_bits) >= BITS_KEPT:
        _bits.clear()
    bits = tuple(BitView(*detail) for detail in condition.details)
    _bits[id(condition)] = (condition, bits)
    return bits


def view_of_vehicle(
    vehicle: VehicleNow,
    job: Job | None,
    plant: Plant,
    link: LinkView,
    utc_at: Callable[[Seconds], Timestamp],
    parking: frozenset[Barcode],
) -> VehicleView:
    """Return a vehicle as people see it."""
    spec, record, status = vehicle.spec, vehicle.record, vehicle.status
    condition = status.condition if status else None
    words = condition if condition and condition.agv is None else None
    hold = HoldView(record.hold.reason, record.hold.remedy, record.hold.since) if record.hold else None
    return VehicleView(
        id=spec.id,
        dev_id=spec.dev_id,
        dialect=spec.dialect,
        address=address_of(vehicle),
        state=state_of(vehicle, job).value,
        activity=activity_of(vehicle),
        service="out_of_service" if record.out_of_service else "in_service",
        link=link,
        mode=condition.mode.name.lower() if condition else None,
        oper=condition.oper.name.lower() if condition else None,
        code=words.code if words else None,
        code_name=_code_name(vehicle, plant),
        loaded=condition.loaded if condition else None,
        carrier=record.carrier,
        barcode=vehicle.barcode or (status.barcode if status else record.barcode),
        dist=status.dist if status else None,
        seq=status.seq if status and words else None,
        status1=f"{words.status1:08X}" if words else None,
        status2=f"{words.status2:08X}" if words else None,
        bits=bits_of(condition) if condition else (),
        job=vehicle.job,
        goal=goal_of(vehicle.errand, job),
        waiting=vehicle.waiting or vehicle.barred or _teaches(vehicle),
        waits_for=vehicle.waits_for if vehicle.waiting else None,
        granted=tuple(vehicle.ahead),
        covered=tuple(vehicle.trail),
        hold=hold,
        lockout=LockoutView.of(record.lockout),
        seen=utc_at(vehicle.seen) if vehicle.seen is not None else None,
        kind=spec.kind.value,
        agv=_view_of_agv(vehicle),
        parked=vehicle.barcode in parking and vehicle.available and vehicle.errand is None and vehicle.at_rest,
    )


def _teaches(vehicle: VehicleNow) -> str:
    return "" if vehicle.teaching is None else f"used for teaching (session {vehicle.teaching})"


def _charges(vehicle: VehicleNow) -> bool:
    agv = vehicle.status.condition.agv if vehicle.status else None
    return agv is not None and agv.charging


def _view_of_agv(vehicle: VehicleNow) -> AgvView | None:
    agv = vehicle.status.condition.agv if vehicle.status else None
    if agv is None:
        return None
    return AgvView(
        cart=agv.cart.name.lower(),
        lift=agv.lift.name.lower(),
        charging=agv.charging,
        in_position=agv.in_position,
        steering=agv.steering.name.lower(),
        path=agv.path,
        tag=agv.tag,
        toward=vehicle.toward,
    )


def _code_name(vehicle: VehicleNow, plant: Plant) -> str:
    if vehicle.status is None:
        return ""
    condition = vehicle.status.condition
    names = plant.alarm_codes if condition.oper is Oper.ALARM else plant.process_codes
    return names.get(condition.code, "")
