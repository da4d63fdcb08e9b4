"""The plant as it is now: vehicles, jobs, alarms, carriers, devices."""

from bisect import bisect_right
from collections import Counter
from collections.abc import Iterator

from prometheus_client.metrics_core import Metric

from app.domain.devices import DeviceKind
from app.domain.job import HOT_FROM, TERMINAL, JobEvent, JobState
from app.domain.layout import VehicleKind
from app.domain.records import ControllerState
from app.domain.units import Timestamp
from app.domain.vehicle import VehicleState
from app.domain.view import CarrierView, ControllerView, DeviceView, DriveView, JobView, StationView, Topic, VehicleView
from app.runtime.hub import ReadModel
from app.runtime.metrics.jobs import JobFigures
from app.runtime.metrics.shapes import alone, counter, counters, gauge, gauges, histograms

AGES = (60, 300, 900, 3600)
"""Ages from which on open jobs are counted, s. Our choice."""
OPEN = tuple(state for state in JobState if state not in TERMINAL)
ALARMED = (*(kind.value for kind in VehicleKind), *(kind.value for kind in DeviceKind if kind.value != "agv"))


def controller(model: ReadModel, trouble: str) -> Iterator[Metric]:
    """Give the state of the controller as a whole."""
    view = model.get(Topic.CONTROLLER, "controller")
    if isinstance(view, ControllerView):
        yield gauges("controller_info", "The plant that is controlled.", ["plant"], {(view.plant,): 1})
        states = {state.value: float(view.state == state) for state in ControllerState}
        yield gauges("controller_state", "1 for the state that the controller is in.", ["state"], alone(states))
        yield gauge("controller_epoch", "The epoch of this start (COMMANDS 2).", view.epoch)
        yield gauge("controller_start_time_seconds", "When the controller started, UTC.", view.started)
        yield gauge("roll_call_missing", "Vehicles that the roll-call still misses.", len(view.waiting_for))
        yield gauge("emergencies", "Fires and earthquakes that nobody has released.", len(view.emergencies))
        yield gauge("circles", "Circles of vehicles that wait for each other now.", len(view.circles))
        yield counter("circles_found", "Circles that were found.", view.circles_found)
        yield counter("circles_resolved", "Circles that are over.", view.circles_resolved)
        yield gauge("closed_places", "Barcodes and edges that ways keep off.", view.closed_places)
        yield gauge("stations_cut_off", "Stations that nobody can reach for what is closed.", len(view.cut_off))
        most = -1 if view.restrained_to is None else view.restrained_to
        yield gauge("restrained_to", "Hoists that may be on their way with jobs at once now; -1: all.", most)
        yield gauge("slow_track", "Pieces of track that take twice as long as usual.", view.slow_track)
        led = {("closed",): float(view.led_round), ("quicker",): float(view.led_quicker)}
        yield counters("led_another_way", "Vehicles under way that were led another way.", ["why"], led)
        yield counter("ways_weighed", "How often ways were weighed anew by the traffic.", view.weighed)
    yield gauge("database_trouble", "1 while nothing can be made durable.", float(bool(trouble)))
    yield gauge("events_last", "The number of the last event.", model.last_event)


def vehicles(model: ReadModel, waits: dict[str, int]) -> Iterator[Metric]:
    """Give vehicles by state, activity and cause of waiting."""
    views = [view for view in model.all(Topic.VEHICLES) if isinstance(view, VehicleView)]
    kinds = sorted({view.kind for view in views})
    states = Counter((view.kind, view.state) for view in views)
    shown = {(kind, state.value): states[kind, state.value] for kind in kinds for state in VehicleState}
    yield gauges("vehicles", "Vehicles by kind and E82 state.", ["kind", "state"], shown)
    activities = Counter(view.activity for view in views)
    yield gauges("vehicles_activity", "Vehicles by activity.", ["activity"], alone(activities))
    yield gauge("vehicles_linked", "Vehicles whose line is up.", sum(view.link.up for view in views))
    yield gauge("vehicles_loaded", "Vehicles that say they carry something.", sum(bool(v.loaded) for v in views))
    yield gauge("vehicles_parked", "Idle vehicles at a parking place.", sum(view.parked for view in views))
    yield gauge(
        "vehicles_held", "Vehicles on hold until a named person decides.", sum(v.hold is not None for v in views)
    )
    yield gauge("vehicles_locked_out", "Vehicles under a lockout.", sum(v.lockout is not None for v in views))
    out = sum(view.service != "in_service" for view in views)
    yield gauge("vehicles_out_of_service", "Vehicles out of service.", out)
    yield gauges("vehicles_waiting", "Vehicles that wait, by cause.", ["cause"], alone(waits))


def jobs(model: ReadModel, figures: JobFigures, now: Timestamp) -> Iterator[Metric]:
    """Give open jobs by state and age, and what became of others."""
    views = [view for view in model.all(Topic.JOBS) if isinstance(view, JobView)]
    states = Counter(view.state for view in views)
    yield gauges("jobs", "Open jobs by E82 state.", ["state"], alone({state: states[state] for state in OPEN}))
    yield gauge("jobs_hot", "Open hot lots.", sum(view.priority >= HOT_FROM for view in views))
    yield gauge("jobs_explained", "Open jobs that do not go on, and say why.", sum(bool(v.reason) for v in views))
    by_state: dict[str, list[float]] = {state.value: [] for state in OPEN}
    for view in views:
        by_state.setdefault(view.state, []).append(view.created)
    oldest = {state: max(now - min(created), 0.0) if created else 0.0 for state, created in by_state.items()}
    shown = {}
    for state in OPEN:
        created = sorted(by_state[state.value])
        for bound in AGES:
            shown[state.value, str(bound)] = bisect_right(created, now - bound)
    yield gauges("jobs_aged", "Open jobs that are at least so many seconds old.", ["state", "at_least"], shown)
    yield gauges("job_oldest_seconds", "Age of the oldest open job.", ["state"], alone(oldest))
    ended = {state.value: figures.ended[state.value] for state in JobState if state in TERMINAL}
    yield counters("jobs_ended", "Jobs that ended, by their last state.", ["state"], alone(ended))
    spreads = (((name,), spread) for name, spread in figures.phases.items())
    yield histograms(
        "job_phase_seconds", "Completed jobs: seconds by phase, each between two E82 events.", ["phase"], spreads
    )
    counted = {event.value: figures.events[event.value] for event in JobEvent}
    yield counters("events", "Durable events, by name.", ["event"], alone(counted))


def alarms(model: ReadModel, figures: JobFigures) -> Iterator[Metric]:
    """Give alarms by the kind of what has them: those that began, and those there are now."""
    kinds = (*ALARMED, "drive", "circle", "emergency", "other")
    began = {kind: figures.alarms[kind] for kind in kinds}
    yield counters("alarms", "Alarms that began, by the kind of what has them.", ["kind"], alone(began))
    now: Counter[str] = Counter()
    for view in (*model.all(Topic.VEHICLES), *model.all(Topic.DEVICES), *model.all(Topic.DRIVES)):
        if isinstance(view, VehicleView):
            now[view.kind] += view.oper == "alarm"
        elif isinstance(view, DeviceView):
            now[view.kind] += bool(view.alarm)
        elif isinstance(view, DriveView):
            now["drive"] += bool(view.error)
    whole = model.get(Topic.CONTROLLER, "controller")
    if isinstance(whole, ControllerView):
        now["circle"], now["emergency"] = len(whole.circles), len(whole.emergencies)
    yield gauges("alarms_active", "Alarms there are now.", ["kind"], alone({kind: now[kind] for kind in kinds}))


def equipment(model: ReadModel) -> Iterator[Metric]:
    """Give stations, carriers, devices and drives."""
    stations = [view for view in model.all(Topic.STATIONS) if isinstance(view, StationView)]
    believed = Counter({True: "full", False: "empty", None: "unknown"}[view.present] for view in stations)
    shown = {name: believed[name] for name in ("full", "empty", "unknown")}
    yield gauges("stations", "Stations by what is believed of them.", ["believed"], alone(shown))
    closed = sum(bool(view.out_of_service) for view in stations)
    yield gauge("stations_out_of_service", "Stations out of service.", closed)
    names = {str(view.id) for view in stations}
    carriers = [view for view in model.all(Topic.CARRIERS) if isinstance(view, CarrierView)]
    where = Counter(_where(view.place, names) for view in carriers)
    shown = {name: where[name] for name in ("station", "vehicle", "unknown")}
    yield gauges("carriers", "Carriers by where they are believed to be.", ["where"], alone(shown))
    devices = [view for view in model.all(Topic.DEVICES) if isinstance(view, DeviceView)]
    fresh = Counter((view.kind, "fresh" if view.fresh else "silent") for view in devices)
    kinds = sorted({view.kind for view in devices})
    seen = {(kind, state): fresh[kind, state] for kind in kinds for state in ("fresh", "silent")}
    yield gauges("devices", "Doors, buffers and chargers, by whether they report.", ["kind", "state"], seen)
    drives = [view for view in model.all(Topic.DRIVES) if isinstance(view, DriveView)]
    online = Counter({True: "online", False: "offline", None: "unknown"}[view.online] for view in drives)
    shown = {name: online[name] for name in ("online", "offline", "unknown")}
    yield gauges("drives", "Axis drives, by whether they answer.", ["state"], alone(shown))


def _where(place: str | None, stations: set[str]) -> str:
    if place is None:
        return "unknown"
    return "station" if place in stations else "vehicle"
