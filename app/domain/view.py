"""The read model: what people and hosts see. Published after the commit of what it shows, never before.

Plain frozen dataclasses of JSON-able values, so that the API declares them as schemas and the live stream encodes them as
they are. Times are UTC seconds (the API shows ISO 8601).
"""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from app.domain.lockout import Lockout


class Topic(StrEnum):
    """Kinds of objects in the read model; each object has a key of its own."""

    CONTROLLER = "controller"
    VEHICLES = "vehicles"
    JOBS = "jobs"
    STATIONS = "stations"
    CARRIERS = "carriers"
    EVENTS = "events"
    COMMANDS = "commands"
    DEVICES = "devices"
    DRIVES = "drives"
    OPERATIONS = "operations"
    PARAMETERS = "parameters"
    TEACHING = "teaching"
    CLOSURES = "closures"
    ALARMS = "alarms"
    WALKS = "walks"


@dataclass(frozen=True, slots=True)
class BitView:
    """One field of STATUS1 or STATUS2 (PROTOCOLS 1.8, 1.9): its name, raw value, and meaning."""

    name: str
    value: int
    meaning: str


@dataclass(frozen=True, slots=True)
class LinkView:
    """Quality of the line to a vehicle. Counters since the controller started; round trip of polls in ms."""

    up: bool
    since: float
    reason: str = ""
    frames_in: int = 0
    frames_out: int = 0
    garbled: int = 0
    resends: int = 0
    duplicates: int = 0
    round_trip_ms: float | None = None


@dataclass(frozen=True, slots=True)
class HoldView:
    """Why nothing is sent to a vehicle until a person decides, and what would help."""

    reason: str
    remedy: str
    since: float


@dataclass(frozen=True, slots=True)
class LockoutView:
    """A maintenance lockout. ``releases``: those who have asked to lift it without being its owner (two are needed)."""

    owner: str
    reason: str
    since: float
    releases: tuple[str, ...] = ()

    @classmethod
    def of(cls, lockout: Lockout | None) -> "LockoutView | None":
        """Return a lockout as people see it, None where there is none."""
        if lockout is None:
            return None
        return cls(lockout.owner, lockout.reason, lockout.since, lockout.releases)


@dataclass(frozen=True, slots=True)
class AgvView:
    """What only AGVs report (PROTOCOLS 3.3): ``cart`` none, present or unknown, ``lift`` down, up or unknown, ``steering``
    straight, left, right or mark_stop, ``path`` the number of the last move taken. ``toward`` is the tag on the way to which it
    was stopped: it stands between there and the vehicle's barcode.
    """

    cart: str
    lift: str
    charging: bool
    in_position: bool
    steering: str
    path: int
    tag: str
    toward: str | None = None


@dataclass(frozen=True, slots=True)
class VehicleView:
    """A vehicle as it is now. ``state`` in E82's words; ``activity`` one word more for people (idle, moving, waiting, settling,
    absent, held ...); ``waiting`` the sentence that explains a wait, ``waits_for`` the vehicle that has to go first; ``granted``
    the track ahead it may drive,
    ``covered`` what it holds at and behind its place. Mode and everything from STATUS is None before its first STATUS. An
    AGV (``kind``) has ``agv`` in place of status words, SEQ and code. ``parked``: it is idle at a parking place.
    """

    id: str
    dev_id: int
    dialect: str
    address: str
    state: str
    activity: str
    service: str
    link: LinkView
    mode: str | None = None
    oper: str | None = None
    code: int | None = None
    code_name: str = ""
    loaded: bool | None = None
    carrier: str | None = None
    barcode: str | None = None
    dist: int | None = None
    seq: int | None = None
    status1: str | None = None
    status2: str | None = None
    bits: tuple[BitView, ...] = ()
    job: str | None = None
    goal: str | None = None
    waiting: str = ""
    waits_for: str | None = None
    granted: tuple[str, ...] = ()
    covered: tuple[str, ...] = ()
    hold: HoldView | None = None
    lockout: LockoutView | None = None
    seen: float | None = None
    kind: str = "hoist"
    agv: AgvView | None = None
    parked: bool = False


@dataclass(frozen=True, slots=True)
class JobView:
    """A job with its present state. ``order`` rises in order of acceptance and serves as the key of paging."""

    id: str
    order: int
    state: str
    leg: str
    source: str
    destination: str
    priority: int
    carrier: str | None
    vehicle: str | None
    wish: str | None
    fallbacks: tuple[str, ...]
    reason: str
    result: str
    actor: str
    created: float
    assigned: float | None
    picked: float | None
    ended: float | None


@dataclass(frozen=True, slots=True)
class StationView:
    """A station and what is believed of it. ``provenance`` and ``at`` say how and when we came to believe it (None: we
    never learnt anything); ``verified`` is true only where the host or a person wrote it. ``target`` is the DEST in
    pulses (shft, rota, lift), ports only, null while it is not complete; ``missing`` are the axes that it lacks.
    ``teaching`` is the session that closes the port to jobs, ``closures`` are the numbers of the closures that do.
    """

    id: str
    kind: str
    barcode: str
    present: bool | None
    carrier: str | None
    reserved: str
    out_of_service: str
    provenance: str
    verified: bool
    at: float | None
    target: tuple[int, int, int] | None
    target_version: int | None
    missing: tuple[str, ...] = ()
    teaching: int | None = None
    closures: tuple[int, ...] = ()


@dataclass(frozen=True, slots=True)
class CarrierView:
    """A carrier and where it is believed to be (a station, a vehicle, or None)."""

    id: str
    place: str | None
    provenance: str
    verified: bool
    at: float


@dataclass(frozen=True, slots=True)
class PauseView:
    """A zone in which nothing begins to move; ``stopped``: what drove there was stopped where it was."""

    zone: str
    owner: str
    reason: str
    since: float
    stopped: bool


@dataclass(frozen=True, slots=True)
class ControllerView:
    """The controller itself. ``waiting_for`` are the vehicles that the roll-call after a start still misses.

    ``emergencies``: what somebody told (fire, earthquake) and nobody has released yet, in words.
    ``circles``: vehicles that wait for each other now, in words; how many were found, and are over, since the start.
    ``kept_off``: what routes keep off, and why, a line for each reason; ``closed_places`` counts the places. ``cut_off``: the
    stations that nobody can reach for that, with the reason. How many vehicles under way were led another way since the start:
    ``led_round`` what is closed, ``led_quicker`` because another way had become quicker. ``slow_track``: pieces of track that
    take twice as long as usual for the traffic on them; ``weighed``: how often ways were weighed anew by that.
    ``restrained_to``: so many hoists may be on their way with jobs now, where the fleet may be larger than its track carries.
    ``pauses``: zones that are paused or stopped. ``recording``: a recorded incident is replayed, and nothing can be asked of it.
    """

    plant: str
    state: str
    reason: str
    epoch: int
    started: float
    waiting_for: tuple[str, ...] = ()
    trouble: str = ""
    emergencies: tuple[str, ...] = ()
    circles: tuple[str, ...] = ()
    circles_found: int = 0
    circles_resolved: int = 0
    kept_off: tuple[str, ...] = ()
    closed_places: int = 0
    cut_off: tuple[str, ...] = ()
    led_round: int = 0
    led_quicker: int = 0
    slow_track: int = 0
    weighed: int = 0
    restrained_to: int | None = None
    pauses: tuple[PauseView, ...] = ()
    recording: bool = False


@dataclass(frozen=True, slots=True)
class EventView:
    """A durable event: docs/events.md has all there are. ``seq`` has no gaps."""

    seq: int
    at: float
    event: str
    ceid: int
    job: str | None
    carrier: str | None
    vehicle: str | None
    source: str | None
    destination: str | None
    result: str
    detail: str


@dataclass(frozen=True, slots=True)
class CommandView:
    """A command to a vehicle or device (``vehicle`` names it) and what became of it (an intent). ``cmd_id`` as 16 hex digits."""

    cmd_id: str
    vehicle: str
    kind: str
    state: str
    actor: str
    opened: float
    closed: float | None
    outcome: str
    job: str | None


@dataclass(frozen=True, slots=True)
class PinView:
    """A person keeps a door ``open`` or ``closed``."""

    position: str
    owner: str
    reason: str
    since: float


@dataclass(frozen=True, slots=True)
class LockView:
    """For whom a buffer is locked: a vehicle, or a person. ``locked`` null: not known whether it is by now."""

    owner: str
    person: bool
    since: float
    locked: bool | None


@dataclass(frozen=True, slots=True)
class DeviceView:
    """A door, buffer or charger (PROTOCOLS 3.2, 3.3). A charger has no link, number or state of its own.

    ``state`` in the specification's words, its last one, ``since`` that time; it counts only while ``fresh``. ``pending`` is the
    command under way. ``vehicles`` are in the door or granted the way through it, or charge there; ``waiting`` want it soon.
    ``alarm`` and ``remedy`` say what is wrong and what helps; ``contradiction`` what a buffer reports against our books.
    """

    id: str
    kind: str
    link: str | None
    number: int | None
    fresh: bool
    reason: str = ""
    state: str | None = None
    since: float | None = None
    seen: float | None = None
    service: str = "in_service"
    out_of_service: str = ""
    barcode: str | None = None
    station: str | None = None
    passages: tuple[tuple[str, str], ...] = ()
    pending: str = ""
    vehicles: tuple[str, ...] = ()
    waiting: tuple[str, ...] = ()
    pin: PinView | None = None
    lock: LockView | None = None
    lockout: LockoutView | None = None
    alarm: str = ""
    remedy: str = ""
    contradiction: str = ""


@dataclass(frozen=True, slots=True)
class DriveView:
    """An axis drive (PROTOCOLS 2.4). ``online`` None: not heard yet on this connection. ``code`` is an error's number in mode
    error, else the operation's, ``meaning`` its word; ``distance`` in hundredths of the axis's unit (H16). ``error`` and
    ``remedy`` explain an error. ``moving``: its distance changes, or it was told to run; None: nobody can tell.
    ``operation`` is what is being done to it that may change or move something.
    """

    id: str
    name: str
    line: str
    address: int
    model: str
    online: bool | None
    reason: str = ""
    mode: str | None = None
    output: int | None = None
    code: int | None = None
    meaning: str = ""
    turn: str | None = None
    distance: int | None = None
    seen: float | None = None
    error: str = ""
    remedy: str = ""
    moving: bool | None = None
    operation: str | None = None
    lockout: LockoutView | None = None


@dataclass(frozen=True, slots=True)
class OperationView:
    """Something that was asked about a drive, or about all of a ``line`` (``drive`` null): see ``state``.

    ``running``, ``done``, ``failed``, or ``unknown`` (it may have taken effect). ``done`` of ``total`` steps are over.
    ``body`` is what was asked, ``result`` what has come of it so far; ``reason`` and ``remedy`` say why it is not done.
    """

    id: str
    kind: str
    state: str
    drive: str | None
    line: str
    actor: str
    opened: float
    closed: float | None
    done: int
    total: int
    body: Mapping[str, object]
    result: Mapping[str, object]
    reason: str
    remedy: str


@dataclass(frozen=True, slots=True)
class ParameterView:
    """A parameter of a drive as last known. ``number`` in hexadecimal; ``raw`` as the drive has it, null if it was not read yet;
    ``value`` in ``unit``, ``text`` for people; ``lowest``, ``highest``, ``default`` in the same unit. ``named``: a catalogue has
    it. ``at``: when it was read; ``watched``: it is polled now.
    """

    drive: str
    number: str
    named: bool
    name: str
    unit: str
    raw: int | None
    value: float | None
    text: str
    at: float | None
    lowest: float | None = None
    highest: float | None = None
    default: float | None = None
    read_only: bool = False
    while_running: bool = False
    description: str = ""
    watched: bool = False


@dataclass(frozen=True, slots=True)
class LineView:
    """A link that carries several devices. ``since``: when it came up, or went down for this ``reason``; null before it was ever
    up. ``figures`` count since the controller started; which there are depends on the wire.
    """

    id: str
    wire: str
    address: str
    up: bool
    since: float | None
    reason: str
    devices: tuple[str, ...]
    figures: Mapping[str, int]


@dataclass(frozen=True, slots=True)
class AxesView:
    """Positions of the three taught axes in pulses; null where one is not known."""

    shft: int | None
    rota: int | None
    lift: int | None


@dataclass(frozen=True, slots=True)
class ProposalView:
    """A set of teaching events from one vehicle and barcode, and the version that approval would make of it.

    ``side``: ``dest`` (of port ``station``) or ``offset`` (of the vehicle, at the reference port ``station``). ``raw`` are the
    positions sent, in the teaching events numbered ``events``; ``missing`` the axes that were not. ``result`` is the whole new
    version, untaught axes carried over from version ``base`` (0: none); ``against_version`` is that of the other side. ``opened``
    and ``at`` are when the first and the last event came. ``revision`` is its ETag. Its live key is ``proposal-ID``.
    """

    id: int
    side: str
    vehicle: str
    barcode: str
    station: str | None
    session: int | None
    state: str
    why: str
    remedy: str
    warnings: tuple[str, ...]
    raw: AxesView
    missing: tuple[str, ...]
    events: tuple[int, ...]
    asked: str | None
    asked_by: str | None
    opened: float
    at: float
    result: AxesView | None
    base: int
    against_version: int | None
    closed: float | None
    closed_by: str | None
    reason: str
    version: int | None
    revision: int


@dataclass(frozen=True, slots=True)
class TeachingSessionView:
    """A teaching session: its port is closed to jobs while it is open. Its live key is ``session-ID``."""

    id: int
    station: str
    vehicle: str
    actor: str
    note: str
    state: str
    opened: float
    ended: float | None
    ended_by: str | None
    reason: str


@dataclass(frozen=True, slots=True)
class ClosureView:
    """A reason for which a place is closed. ``kind``: barcode, edge, stretch, zone or station; ``names`` as it was named.

    ``state``: draining (nobody comes in, those ``inside`` drive out), closed (nobody is inside), opened, expired. ``barcodes``
    are kept empty, ``stations`` cannot be used. ``purpose``: traffic or work; work never expires, and its ``owner`` opens it,
    or two others together (``releases``: who wished so). ``closed`` is when it was empty; ``waiting`` says who is not out yet,
    and why.
    """

    id: int
    kind: str
    names: tuple[str, ...]
    place: str
    barcodes: tuple[str, ...]
    stations: tuple[str, ...]
    reason: str
    owner: str
    purpose: str
    state: str
    since: float
    expires: float | None
    closed: float | None
    releases: tuple[str, ...]
    ended: float | None
    ended_by: str | None
    inside: tuple[str, ...] = ()
    waiting: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class AlarmView:
    """Something that is, or was, wrong with ``source``. ``kind``: vehicle (it reports an alarm), hold (we hold it for a doubt),
    link (nothing is heard of it), device, drive, traffic (vehicles wait for each other in a circle), plant (fire, earthquake).

    ``code`` is what it is counted by. ``ended`` null: it is there now; ``outcome`` says how it ended.
    """

    id: int
    kind: str
    source: str
    code: str
    cause: str
    remedy: str
    begun: float
    ended: float | None
    outcome: str
    job: str | None
    acknowledged: float | None
    acknowledged_by: str | None
    note: str


@dataclass(frozen=True, slots=True)
class WalkView:
    """An audit walk: of so many ``places`` so many have been ``entered``. ``state``: open, accepted or abandoned."""

    id: int
    actor: str
    reason: str
    state: str
    started: float
    ended: float | None
    ended_by: str | None
    places: int
    entered: int


View = (
    VehicleView
    | JobView
    | StationView
    | CarrierView
    | ControllerView
    | EventView
    | CommandView
    | DeviceView
    | DriveView
    | OperationView
    | ParameterView
    | LineView
    | ProposalView
    | TeachingSessionView
    | ClosureView
    | AlarmView
    | WalkView
)


SHOWN: Mapping[Topic, tuple[type, ...]] = {
    Topic.CONTROLLER: (ControllerView,),
    Topic.VEHICLES: (VehicleView,),
    Topic.JOBS: (JobView,),
    Topic.STATIONS: (StationView,),
    Topic.CARRIERS: (CarrierView,),
    Topic.EVENTS: (EventView,),
    Topic.COMMANDS: (CommandView,),
    Topic.DEVICES: (DeviceView,),
    Topic.DRIVES: (DriveView,),
    Topic.OPERATIONS: (OperationView,),
    Topic.PARAMETERS: (ParameterView,),
    Topic.TEACHING: (TeachingSessionView, ProposalView),
    Topic.CLOSURES: (ClosureView,),
    Topic.ALARMS: (AlarmView,),
    Topic.WALKS: (WalkView,),
}
"""What the objects of each topic are."""


@dataclass(frozen=True, slots=True)
class Update:
    """A change of the read model; ``value`` None removes the object. Ended jobs leave the model (the database keeps them)."""

    topic: Topic
    key: str
    value: View | None
