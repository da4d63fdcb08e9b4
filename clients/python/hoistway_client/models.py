"""Made by ``python -m tools.client`` from openapi/openapi.json: change that, not this."""

from __future__ import annotations

from typing import Any, Generic, Literal, NotRequired, TypeAlias, TypedDict, TypeVar

T = TypeVar("T")


class Page(TypedDict, Generic[T]):
    """Objects, and what to send as ``after`` for more (None: the end)."""

    items: list[T]
    next: NotRequired[int | None]


class AbandonIn(TypedDict):
    """Why nothing is believed for it."""

    reason: str


class AcceptIn(TypedDict):
    """``partial``: also if places were not seen, or have changed since: those stay as they are."""

    partial: NotRequired[bool]


class ActivateIn(TypedDict):
    """Why. ``wait``: also if something stands in its way now; it becomes active once nothing does any more.
    ``instead_of``: the version that is active as far as the caller knows; if another one is, nothing is done.
    """

    reason: str
    wait: NotRequired[bool]
    instead_of: NotRequired[int | None]


class Agv(TypedDict):
    """What only AGVs report (PROTOCOLS 3.3): ``cart`` none, present or unknown, ``lift`` down, up or unknown,
    ``steering`` straight, left, right or mark_stop, ``path`` the number of the last move taken. ``toward`` is the
    tag on the way to which it was stopped: it stands between there and the vehicle's barcode.
    """

    cart: str
    lift: str
    charging: bool
    in_position: bool
    steering: str
    path: int
    tag: str
    toward: str | None


class AgvChargeCommand(TypedDict):
    """109 Charge. On: only where the AGV stands at a charger, since it would drive to one on a way of its own."""

    command: Literal['agv_charge']
    on: bool


class AgvLiftCommand(TypedDict):
    """106 Lift."""

    command: Literal['agv_lift']
    action: Literal['stop', 'up', 'down']


class AgvMarkStopCommand(TypedDict):
    """105 MarkStop: stop at the next mark."""

    command: Literal['agv_mark_stop']


class AgvMoveAliasCommand(TypedDict):
    """107 Move to a destination by its name, if the whole way there is free and certainly the AGV's own."""

    command: Literal['agv_move_alias']
    alias: str


class AgvMoveAutoCommand(TypedDict):
    """108 MoveAuto, in auto: follow the tape until stopped, where no other AGV may be on the same floor."""

    command: Literal['agv_move_auto']
    direction: NotRequired[Literal['backward', 'forward']]
    steering: NotRequired[Literal['straight', 'left', 'right']]
    speed: NotRequired[Literal['slow', 'normal', 'fast']]


class AgvMoveManualCommand(TypedDict):
    """104 MoveManual, in manual: drive until stopped. Never sent twice; what became of it a person decides."""

    command: Literal['agv_move_manual']
    direction: Literal['backward', 'forward', 'turn_left', 'turn_right']
    speed: NotRequired[Literal['slow', 'normal', 'fast']]


class AgvSetCurrentCommand(TypedDict):
    """103 SetCurrent: tell a standing AGV which tag it is at."""

    command: Literal['agv_set_current']
    tag: str


class Alarm(TypedDict):
    """Something that is, or was, wrong with ``source``. ``kind``: vehicle (it reports an alarm), hold (we hold it for
    a doubt), link (nothing is heard of it), device, drive, traffic (vehicles wait for each other in a circle),
    plant (fire, earthquake). ``code`` is what it is counted by. ``ended`` null: it is there now; ``outcome`` says
    how it ended.
    """

    id: int
    kind: Literal['vehicle', 'hold', 'link', 'device', 'drive', 'traffic', 'job', 'plant']
    source: str
    code: str
    cause: str
    remedy: str
    begun: str
    ended: str | None
    outcome: str
    job: str | None
    acknowledged: str | None
    acknowledged_by: str | None
    note: str


class AlarmAnswer(TypedDict):
    """What became of one of several alarms that were acknowledged together."""

    alarm: int
    acknowledged: bool
    code: str | None
    detail: str


class AlarmCount(TypedDict):
    """How often and how long something was wrong; null: not told apart by that."""

    kind: str | None
    source: str | None
    code: str | None
    times: int
    minutes: float
    share: float
    newest: str


AlarmKind: TypeAlias = "Literal['vehicle', 'hold', 'link', 'device', 'drive', 'traffic', 'job', 'plant']"


class ApproveIn(TypedDict):
    """``accept``: what stands against the proposal and the person takes responsibility for."""

    reason: NotRequired[str]
    accept: NotRequired[list[Literal['incomplete', 'wrong_mode', 'out_of_range']]]


class AssignIn(TypedDict):
    """Which of the ports at its barcode it is about."""

    station: str


class Audit(TypedDict):
    seq: int
    at: str
    actor: str
    action: str
    target: str
    detail: str
    accepted: bool


class AuditCheck(TypedDict):
    """`broken`: number of the first row that does not follow from the one before it; null: none."""

    rows: int
    last: int
    hash: str
    broken: int | None
    reason: str
    next: int | None


class Axes(TypedDict):
    """Positions of the three taught axes in pulses; null where one is not known."""

    shft: int | None
    rota: int | None
    lift: int | None


class Backup(TypedDict):
    id: int
    drive: str
    model: str
    at: str
    actor: str
    note: str
    parameters: int


class BackupIn(TypedDict):
    """A note for those who look for the backup later."""

    note: NotRequired[str]


class BackupWithValues(Backup):
    values: list[dict[str, Any]]


class BarcodesIn(TypedDict):
    """One or more barcodes: nobody comes to them."""

    kind: Literal['barcode']
    barcodes: list[str]


class Basis(TypedDict):
    """Where one axis comes from: value = raw - less, where less is of version `version` of `against`."""

    axis: str
    raw: int
    vehicle: str
    barcode: str
    events: list[int]
    against: str
    version: int | None
    less: int


class Bit(TypedDict):
    """One field of STATUS1 or STATUS2 (PROTOCOLS 1.8, 1.9): its name, raw value, and meaning."""

    name: str
    value: int
    meaning: str


class Call(TypedDict):
    """Method and path under /api/v1, which roles may, and whether the caller may (all, where nobody has to say who
    they are).
    """

    call: str
    roles: list[str]
    allowed: bool


class Caller(TypedDict):
    """Who calls. `open`: nobody has to say who they are; then the name is null, and all is allowed."""

    open: bool
    name: str | None
    person: bool
    roles: list[str]
    scopes: list[str]


class Carrier(TypedDict):
    """A carrier and where it is believed to be (a station, a vehicle, or None)."""

    id: str
    place: str | None
    provenance: Literal['host', 'placed', 'picked', 'person', 'sensor', 'inferred', 'plant', 'verified']
    verified: bool
    at: str


class CarrierPut(TypedDict):
    """Where the carrier is: a station or a vehicle."""

    place: str
    by_person: NotRequired[bool]


class Catalogue(TypedDict):
    model: str
    description: str
    parameters: list[dict[str, Any]]


class Closure(TypedDict):
    """A reason for which a place is closed. ``kind``: barcode, edge, stretch, zone or station; ``names`` as it was
    named. ``state``: draining (nobody comes in, those ``inside`` drive out), closed (nobody is inside), opened,
    expired. ``barcodes`` are kept empty, ``stations`` cannot be used. ``purpose``: traffic or work; work never
    expires, and its ``owner`` opens it, or two others together (``releases``: who wished so). ``closed`` is when
    it was empty; ``waiting`` says who is not out yet, and why.
    """

    id: int
    kind: str
    names: list[str]
    place: str
    barcodes: list[str]
    stations: list[str]
    reason: str
    owner: str
    purpose: str
    state: str
    since: str
    expires: str | None
    closed: str | None
    releases: list[str]
    ended: str | None
    ended_by: str | None
    inside: list[str]
    waiting: list[str]


class ClosureIn(TypedDict):
    """What is closed, and why. ``purpose`` work: people are there; it never expires, and only its owner opens it, or
    two others. A traffic closure may end by itself: at ``expires``, or after so many ``minutes``.
    """

    place: BarcodesIn | EdgeIn | StretchIn | ZoneIn | StationIn
    reason: str
    purpose: NotRequired[Literal['traffic', 'work']]
    expires: NotRequired[str | None]
    minutes: NotRequired[int | None]


class ClosurePreview(TypedDict):
    """What a closure would do."""

    place: str
    barcodes: list[str]
    stations: list[str]
    cut_off: list[str]
    inside: list[str]
    shut_in: list[str]
    jobs_touched: int
    jobs: list[dict[str, Any]]
    routes: dict[str, Any]


class Command(TypedDict):
    """A command to a vehicle or device (``vehicle`` names it) and what became of it (an intent). ``cmd_id`` as 16 hex
    digits.
    """

    cmd_id: str
    vehicle: str
    kind: str
    state: Literal['open', 'done', 'failed', 'unknown', 'not_sent', 'settled_done', 'settled_not_done']
    actor: str
    opened: str
    closed: str | None
    outcome: str
    job: str | None


class CompareIn(TypedDict):
    """Compare with a backup (of this or another drive), or with another drive."""

    backup: NotRequired[int | None]
    drive: NotRequired[str | None]


class Controller(TypedDict):
    """The controller itself. ``waiting_for`` are the vehicles that the roll-call after a start still misses.
    ``emergencies``: what somebody told (fire, earthquake) and nobody has released yet, in words. ``circles``:
    vehicles that wait for each other now, in words; how many were found, and are over, since the start.
    ``kept_off``: what routes keep off, and why, a line for each reason; ``closed_places`` counts the places.
    ``cut_off``: the stations that nobody can reach for that, with the reason. How many vehicles under way were led
    another way since the start: ``led_round`` what is closed, ``led_quicker`` because another way had become
    quicker. ``slow_track``: pieces of track that take twice as long as usual for the traffic on them; ``weighed``:
    how often ways were weighed anew by that. ``restrained_to``: so many hoists may be on their way with jobs now,
    where the fleet may be larger than its track carries. ``pauses``: zones that are paused or stopped.
    ``recording``: a recorded incident is replayed, and nothing can be asked of it.
    """

    plant: str
    state: Literal['auto', 'pausing', 'paused']
    reason: str
    epoch: int
    started: str
    waiting_for: list[str]
    trouble: str
    emergencies: list[str]
    circles: list[str]
    circles_found: int
    circles_resolved: int
    kept_off: list[str]
    closed_places: int
    cut_off: list[str]
    led_round: int
    led_quicker: int
    slow_track: int
    weighed: int
    restrained_to: int | None
    pauses: list[Pause]
    recording: bool


class Device(TypedDict):
    """A door, buffer or charger (PROTOCOLS 3.2, 3.3). A charger has no link, number or state of its own. ``state`` in
    the specification's words, its last one, ``since`` that time; it counts only while ``fresh``. ``pending`` is
    the command under way. ``vehicles`` are in the door or granted the way through it, or charge there; ``waiting``
    want it soon. ``alarm`` and ``remedy`` say what is wrong and what helps; ``contradiction`` what a buffer
    reports against our books.
    """

    id: str
    kind: Literal['agv', 'buffer', 'door', 'charger']
    link: str | None
    number: int | None
    fresh: bool
    reason: str
    state: str | None
    since: str | None
    seen: str | None
    service: Literal['in_service', 'out_of_service']
    out_of_service: str
    barcode: str | None
    station: str | None
    passages: list[list[str]]
    pending: str
    vehicles: list[str]
    waiting: list[str]
    pin: Pin | None
    lock: Lock | None
    lockout: Lockout | None
    alarm: str
    remedy: str
    contradiction: str


class DeviceCommandIn(TypedDict):
    """Doors open and close, buffers lock and unlock."""

    command: Literal['open', 'close', 'lock', 'unlock']


class DeviceTaken(TypedDict):
    """Under way. `cmd_id` null: nothing had to be sent."""

    device: str
    cmd_id: str | None


class DisplayCommand(TypedDict):
    """Show a text on the vehicle; with ``alarm`` (0x8000 to 0xFFFF) as an alarm."""

    command: Literal['display']
    text: str
    alarm: NotRequired[int | None]


class DriftRow(TypedDict):
    side: Literal['dest', 'offset']
    name: str
    drift: str
    old: PulsesVersion
    new: PulsesVersion


class Drive(TypedDict):
    """An axis drive (PROTOCOLS 2.4). ``online`` None: not heard yet on this connection. ``code`` is an error's number
    in mode error, else the operation's, ``meaning`` its word; ``distance`` in hundredths of the axis's unit (H16).
    ``error`` and ``remedy`` explain an error. ``moving``: its distance changes, or it was told to run; None:
    nobody can tell. ``operation`` is what is being done to it that may change or move something.
    """

    id: str
    name: str
    line: str
    address: int
    model: str
    online: bool | None
    reason: str
    mode: str | None
    output: int | None
    code: int | None
    meaning: str
    turn: str | None
    distance: int | None
    seen: str | None
    error: str
    remedy: str
    moving: bool | None
    operation: str | None
    lockout: Lockout | None


EdgeIn = TypedDict(
    "EdgeIn",
    {
        'kind': "Literal['edge']",
        'from': 'str',
        'to': 'str',
    },
)


class EmergencyIn(TypedDict):
    """What is told, or over, and how that is known."""

    kind: Literal['fire', 'earthquake']
    reason: str


class EndIn(TypedDict):
    """``abandon`` rejects what the session has taught and nobody has approved."""

    reason: NotRequired[str]
    abandon: NotRequired[bool]


class Event(TypedDict):
    """A durable event: docs/events.md has all there are. ``seq`` has no gaps."""

    seq: int
    ts: str
    event: Literal['TransferInitiated', 'VehicleAssigned', 'VehicleDeparted', 'VehicleArrived', 'Transferring', 'VehicleAcquireStarted', 'CarrierInstalled', 'VehicleAcquireCompleted', 'VehicleDepositStarted', 'CarrierRemoved', 'VehicleDepositCompleted', 'VehicleUnassigned', 'TransferCompleted', 'TransferCancelInitiated', 'TransferCancelCompleted', 'TransferCancelFailed', 'TransferAbortInitiated', 'TransferAbortCompleted', 'TransferAbortFailed', 'TransferPaused', 'TransferResumed', 'TransferUpdated', 'VehicleBrokenDown', 'VehicleMended', 'VehicleHeld', 'VehicleReleased', 'VehicleInstalled', 'VehicleRemoved', 'AlarmSet', 'AlarmCleared', 'ControllerAuto', 'ControllerPausing', 'ControllerPaused', 'PortStateChanged', 'CarrierLocationChanged', 'DriveOffline', 'DriveOnline', 'DriveErrorSet', 'DriveErrorCleared', 'DriveParameterWritten', 'TeachingSessionOpened', 'TeachingSessionEnded', 'TeachingTaken', 'TeachingApproved', 'TeachingRejected', 'TeachingRolledBack', 'TeachingImported', 'TeachingCodeUnknown', 'DeviceChanged', 'EmergencySet', 'EmergencyReleased', 'PlaceClosing', 'PlaceClosed', 'PlaceOpened', 'ZonePaused', 'ZoneResumed', 'WalkStarted', 'WalkEnded']
    ceid: int
    job: str | None
    carrier: str | None
    vehicle: str | None
    source: str | None
    destination: str | None
    result: str
    detail: str


Finding: TypeAlias = "Literal['not_seen', 'agrees', 'differs', 'moved']"


class Frame(TypedDict):
    at: str
    direction: Literal['in', 'out']
    hex: str
    frames: list[dict[str, Any]]


class Health(TypedDict):
    status: str


Heat = TypedDict(
    "Heat",
    {
        'from': 'str | None',
        'to': 'str | None',
        'waiting': 'dict[str, float]',
        'traffic': 'dict[str, int]',
    },
)


class Hold(TypedDict):
    """Why nothing is sent to a vehicle until a person decides, and what would help."""

    reason: str
    remedy: str
    since: str


class ImportReport(TypedDict):
    dry_run: bool
    counts: dict[str, Any]
    items: list[dict[str, Any]]


class InputsIn(TypedDict):
    """The drive's inputs; ``run`` and ``home`` make it move. What is left out is off."""

    run: NotRequired[bool]
    home: NotRequired[bool]
    right_limit: NotRequired[bool]
    left_limit: NotRequired[bool]
    step: NotRequired[int]


class Job(TypedDict):
    """A job with its present state. ``order`` rises in order of acceptance and serves as the key of paging."""

    id: str
    order: int
    state: Literal['queued', 'waiting', 'transferring', 'paused', 'cancelling', 'aborting', 'completed', 'failed', 'cancelled', 'aborted']
    leg: Literal['none', 'to_source', 'acquiring', 'to_destination', 'depositing']
    source: str
    destination: str
    priority: int
    carrier: str | None
    vehicle: str | None
    wish: str | None
    fallbacks: list[str]
    reason: str
    result: str
    actor: str
    created: str
    assigned: str | None
    picked: str | None
    ended: str | None


class JobChange(TypedDict):
    """What to change; a field that is left out stays. ``vehicle`` null: any vehicle may do it again."""

    priority: NotRequired[int | None]
    destination: NotRequired[str | None]
    vehicle: NotRequired[str | None]


class JobEndIn(TypedDict):
    """Why a job is ended, for those who ask later; it may be left out."""

    reason: NotRequired[str]


class JobIn(TypedDict):
    """A transfer. ``source`` is a station, or a vehicle that has the carrier aboard."""

    job_id: NotRequired[str | None]
    source: str
    destination: str
    carrier: NotRequired[str | None]
    priority: NotRequired[int]
    vehicle: NotRequired[str | None]
    fallbacks: NotRequired[list[str]]


JobState: TypeAlias = "Literal['queued', 'waiting', 'transferring', 'paused', 'cancelling', 'aborting', 'completed', 'failed', 'cancelled', 'aborted']"


class JobWhy(TypedDict):
    job: str
    state: str
    reason: str
    created: str
    queued: float | None
    fetching: float | None
    acquiring: float | None
    carrying: float | None
    depositing: float | None
    total: float | None
    assignments: list[dict[str, Any]]
    waits: list[dict[str, Any]]
    left_out: int


class JobWithHistory(Job):
    history: list[Event]


class Jog(TypedDict):
    drive: str
    jog: str
    hold: float


class JogIn(TypedDict):
    """Which way."""

    direction: Literal['cw', 'ccw']


class Key(TypedDict):
    name: str
    roles: list[str]
    created: str
    created_by: str
    expires: str | None
    revoked: str | None
    used: str | None
    state: Literal['active', 'expired', 'revoked']


class KeyIn(TypedDict):
    """A key of the drive's panel. ``stop_reset`` stops whatever moves, and clears an error whose cause is gone."""

    key: Literal['run', 'stop_reset', 'up', 'down', 'data_set']


class Layout(TypedDict):
    name: str
    version: int | None
    points: list[dict[str, Any]]
    edges: list[dict[str, Any]]
    stations: list[dict[str, Any]]
    zones: list[dict[str, Any]]
    vehicles: list[dict[str, Any]]
    links: list[dict[str, Any]]
    doors: list[dict[str, Any]]
    buffers: list[dict[str, Any]]
    chargers: list[dict[str, Any]]
    drives: list[dict[str, Any]]


class Line(TypedDict):
    """A link that carries several devices. ``since``: when it came up, or went down for this ``reason``; null before
    it was ever up. ``figures`` count since the controller started; which there are depends on the wire.
    """

    id: str
    wire: str
    address: str
    up: bool
    since: str | None
    reason: str
    devices: list[str]
    figures: dict[str, int]


class Link(TypedDict):
    """Quality of the line to a vehicle. Counters since the controller started; round trip of polls in ms."""

    up: bool
    since: str
    reason: str
    frames_in: int
    frames_out: int
    garbled: int
    resends: int
    duplicates: int
    round_trip_ms: float | None


class Lock(TypedDict):
    """For whom a buffer is locked: a vehicle, or a person. ``locked`` null: not known whether it is by now."""

    owner: str
    person: bool
    since: str
    locked: bool | None


class Lockout(TypedDict):
    """A maintenance lockout. ``releases``: those who have asked to lift it without being its owner (two are needed)."""

    owner: str
    reason: str
    since: str
    releases: list[str]


class LogInIn(TypedDict):
    """Name and password of a person."""

    name: str
    password: str


class MachineKeyIn(TypedDict):
    """A machine's key. Without ``days`` it is good until it is revoked."""

    name: str
    roles: list[Role]
    days: NotRequired[float | None]


class Moment(TypedDict):
    """The plant as it was."""

    at: str
    objects: dict[str, dict[str, dict[str, Any]]]


class MoveCommand(TypedDict):
    """Drive to a barcode, under grants like any job."""

    command: Literal['move']
    barcode: str
    action: NotRequired[Literal['stop', 'port', 'sbfl', 'sbfr', 'port_bare']]


class NamedSightIn(TypedDict):
    """The same, with the place."""

    present: bool
    carrier: NotRequired[str | None]
    station: str


class NewKey(Key):
    """The key itself is shown now and never again."""

    key: str


class NewPasswordIn(TypedDict):
    """The old password, and the new one."""

    old: str
    new: str


class NoteIn(TypedDict):
    """What is known of it; may be empty."""

    note: NotRequired[str]


class NotedAlarmsIn(TypedDict):
    """Several alarms at once, by their numbers."""

    note: NotRequired[str]
    alarms: list[int]


class OpenIn(TypedDict):
    """Why it is opened; may be empty."""

    reason: NotRequired[str]


class Operation(TypedDict):
    """Something that was asked about a drive, or about all of a ``line`` (``drive`` null): see ``state``.
    ``running``, ``done``, ``failed``, or ``unknown`` (it may have taken effect). ``done`` of ``total`` steps are
    over. ``body`` is what was asked, ``result`` what has come of it so far; ``reason`` and ``remedy`` say why it
    is not done.
    """

    id: str
    kind: str
    state: str
    drive: str | None
    line: str
    actor: str
    opened: str
    closed: str | None
    done: int
    total: int
    body: dict[str, Any]
    result: dict[str, Any]
    reason: str
    remedy: str


class Parameter(TypedDict):
    """A parameter of a drive as last known. ``number`` in hexadecimal; ``raw`` as the drive has it, null if it was
    not read yet; ``value`` in ``unit``, ``text`` for people; ``lowest``, ``highest``, ``default`` in the same
    unit. ``named``: a catalogue has it. ``at``: when it was read; ``watched``: it is polled now.
    """

    drive: str
    number: str
    named: bool
    name: str
    unit: str
    raw: int | None
    value: float | None
    text: str
    at: str | None
    lowest: float | None
    highest: float | None
    default: float | None
    read_only: bool
    while_running: bool
    description: str
    watched: bool


class Pause(TypedDict):
    """A zone in which nothing begins to move; ``stopped``: what drove there was stopped where it was."""

    zone: str
    owner: str
    reason: str
    since: str
    stopped: bool


class Pin(TypedDict):
    """A person keeps a door ``open`` or ``closed``."""

    position: str
    owner: str
    reason: str
    since: str


class PinIn(TypedDict):
    """How the door is to stay until the pin is taken off, and why."""

    position: Literal['open', 'closed']
    reason: str


class PlainCommand(TypedDict):
    """A command without data. ``stop`` drops the vehicle to MANT; ``stop_by_host`` keeps it in its mode."""

    command: Literal['status', 'stop', 'stop_by_host', 'servo_on', 'servo_off', 'search_home', 'go_home', 'system_reset', 'alarm_clear', 'auto']


class PlantActivation(TypedDict):
    version: PlantVersion
    in_the_way: list[PlantBreak]


class PlantBreak(TypedDict):
    what: str
    name: str
    text: str
    remedy: str
    touches: list[str]


class PlantChange(TypedDict):
    what: str
    how: Literal['added', 'removed', 'changed', 'moved', 'renamed']
    name: str
    text: str
    before: Any
    after: Any


class PlantDifference(TypedDict):
    """As `hoistway layout diff` tells it, from `against` to `version`."""

    version: int
    against: int
    changes: list[PlantChange]
    breaks: list[PlantBreak]


class PlantFinding(TypedDict):
    """As `hoistway check` tells it. Lines and columns count from 1."""

    line: int
    column: int
    severity: Literal['error', 'warning']
    path: str
    message: str
    remedy: str


class PlantImpact(TypedDict):
    version: int
    ready: bool
    in_the_way: list[PlantBreak]
    lost: list[PlantBreak]
    lacking: list[PlantBreak]


class PlantVersion(TypedDict):
    """A version of the plant file. One is active at any time; at most one is awaited."""

    number: int
    digest: str
    models: dict[str, str]
    size: int
    state: Literal['staged', 'awaited', 'active', 'former', 'rejected']
    origin: Literal['file', 'upload']
    at: str
    actor: str
    reason: str
    activated: str | None
    activated_by: str | None
    why: str
    before: int | None
    asked: str | None
    asked_by: str | None
    asked_why: str
    patient: bool
    note: str
    ran: str | None
    tries: int | None
    rejected: str | None
    pruned: str | None


class PlaybackChange(TypedDict):
    at: str
    topic: str
    key: str
    value: Any | None


class PreviewIn(TypedDict):
    """What would be closed."""

    place: BarcodesIn | EdgeIn | StretchIn | ZoneIn | StationIn


class Problem(TypedDict):
    """RFC 9457. `code` is stable; `remedy` says what would help and may be empty."""

    type: str
    title: str
    status: int
    detail: str
    code: NotRequired[Literal['malformed', 'unauthorised', 'forbidden', 'foreign-origin', 'not-found', 'no-such-path', 'method', 'conflict', 'not-now', 'stale', 'too-large', 'media-type', 'misdirected', 'invalid', 'no-route', 'cannot-encode', 'too-many', 'internal', 'store', 'plant-held', 'unavailable']]
    remedy: NotRequired[str]
    field: NotRequired[str]
    errors: NotRequired[list[dict[str, Any]]]


class ProblemKind(TypedDict):
    code: str
    status: int
    title: str


class Proposal(TypedDict):
    """A set of teaching events from one vehicle and barcode, and the version that approval would make of it.
    ``side``: ``dest`` (of port ``station``) or ``offset`` (of the vehicle, at the reference port ``station``).
    ``raw`` are the positions sent, in the teaching events numbered ``events``; ``missing`` the axes that were not.
    ``result`` is the whole new version, untaught axes carried over from version ``base`` (0: none);
    ``against_version`` is that of the other side. ``opened`` and ``at`` are when the first and the last event
    came. ``revision`` is its ETag. Its live key is ``proposal-ID``.
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
    warnings: list[str]
    raw: Axes
    missing: list[str]
    events: list[int]
    asked: str | None
    asked_by: str | None
    opened: str
    at: str
    result: Axes | None
    base: int
    against_version: int | None
    closed: str | None
    closed_by: str | None
    reason: str
    version: int | None
    revision: int


class ProposalDetail(Proposal):
    present: PulsesVersion | None
    changes: list[TaughtChange]
    drift: str


ProposalState: TypeAlias = "Literal['collecting', 'unknown_barcode', 'wrong_mode', 'ambiguous', 'unusable', 'incomplete', 'pending', 'out_of_range', 'ready', 'approved', 'rejected', 'superseded']"


class Pulses(TypedDict):
    shft: int
    rota: int
    lift: int


class PulsesVersion(Axes):
    version: int
    actor: str
    source: str
    at: str
    basis: list[Basis]
    proposal: int | None
    restores: int | None
    reason: str


class ReadIn(TypedDict):
    """Which parameters to read, in hexadecimal; left out: all 256."""

    parameters: NotRequired[list[str] | None]


class Readiness(TypedDict):
    ready: bool
    reasons: list[str]


class ReasonIn(TypedDict):
    """Why."""

    reason: str


class RecoverIn(TypedDict):
    """``confirmed``: a person at the vehicle has seen that homing is safe."""

    confirmed: NotRequired[bool]


class RejectIn(TypedDict):
    """Why nothing is made of it."""

    reason: str


class RejectVersionIn(TypedDict):
    """Why not."""

    reason: str


class ReleaseIn(TypedDict):
    """What a named person has found. ``barcode`` with ``stands_at`` only."""

    verdict: Literal['go_on', 'off_rail', 'stands_at']
    reason: str
    barcode: NotRequired[str | None]


class Reliability(TypedDict):
    vehicle: str
    failures: int
    down_minutes: float
    mtbf_hours: float | None
    mttr_minutes: float | None
    availability: float


class ReplayIn(TypedDict):
    """Tell it all events above this number, again if it has had them."""

    after: int


class Required(TypedDict):
    """Whether callers have to say who they are."""

    required: bool


class RestoreIn(TypedDict):
    """Which backup to write back. ``dry_run``: only say what would be written."""

    backup: int
    dry_run: NotRequired[bool]


Role: TypeAlias = "Literal['viewer', 'operator', 'maintenance', 'mes', 'admin']"


class RollBackIn(TypedDict):
    """The older version that shall hold again, and why."""

    version: int
    reason: str


class RouteView(TypedDict):
    """Seconds of driving at the present delays, and on an empty track; length in mm; which version of the map."""

    barcodes: list[str]
    length: int
    seconds: float
    free_flow_seconds: float
    version: int


class SecretIn(TypedDict):
    """For so many seconds the old secret signs beside the new one."""

    overlap: NotRequired[int]


class ServiceIn(TypedDict):
    """Whether a vehicle or a device is used; out of service needs a ``reason``."""

    in_service: bool
    reason: NotRequired[str]


class Session(TypedDict):
    """The token is shown once. It is good until `expires`, and can be renewed until `until`."""

    token: str
    expires: str
    until: str
    name: str
    roles: list[str]


class SessionIn(TypedDict):
    """A port to teach (or to take as the reference for an OFFSET), and the vehicle to do it with."""

    station: str
    vehicle: str
    note: NotRequired[str]


class SightIn(TypedDict):
    """What stands at a place. ``carrier`` null though something is there: its id could not be read."""

    present: bool
    carrier: NotRequired[str | None]


class SightsIn(TypedDict):
    """What stands at several places: all are entered, or none."""

    sights: list[NamedSightIn]


Span = TypedDict(
    "Span",
    {
        'from': 'str | None',
        'to': 'str | None',
        'bytes': 'int',
        'incident': 'dict[str, Any] | None',
    },
)


class StageIn(TypedDict):
    """Which vehicle; none: the nearest that is free."""

    vehicle: NotRequired[str | None]


class StagedVersion(PlantVersion):
    findings: list[PlantFinding]


class StartIn(TypedDict):
    """``dest``: PORT DEST TEACHING, for the port. ``offset``: PORT OFFSET TEACHING, for the vehicle."""

    what: Literal['dest', 'offset']


class Station(TypedDict):
    """A station and what is believed of it. ``provenance`` and ``at`` say how and when we came to believe it (None:
    we never learnt anything); ``verified`` is true only where the host or a person wrote it. ``target`` is the
    DEST in pulses (shft, rota, lift), ports only, null while it is not complete; ``missing`` are the axes that it
    lacks. ``teaching`` is the session that closes the port to jobs, ``closures`` are the numbers of the closures
    that do.
    """

    id: str
    kind: Literal['port', 'sbfl', 'sbfr', 'agv_buffer']
    barcode: str
    present: bool | None
    carrier: str | None
    reserved: str
    out_of_service: str
    provenance: Literal['host', 'placed', 'picked', 'person', 'sensor', 'inferred', 'plant', 'verified']
    verified: bool
    at: str | None
    target: list[int] | None
    target_version: int | None
    missing: list[str]
    teaching: int | None
    closures: list[int]


class StationIn(TypedDict):
    """A station: nothing is picked up or put down there; the rail stays in use."""

    kind: Literal['station']
    station: str


class StationPatch(TypedDict):
    """As above; a field that is left out stays."""

    present: NotRequired[bool | None]
    carrier: NotRequired[str | Literal[''] | None]
    reserved: NotRequired[str | None]
    out_of_service: NotRequired[str | None]
    by_person: NotRequired[bool]


class StationPut(TypedDict):
    """Everything that a host or a person may write of a station. ``carrier`` empty: none, or not known. ``present``
    null: nobody knows whether something stands there.
    """

    present: bool | None
    carrier: str | Literal['']
    reserved: str
    out_of_service: str
    by_person: NotRequired[bool]


Statistics = TypedDict(
    "Statistics",
    {
        'from': 'str',
        'to': 'str',
        'jobs': 'dict[str, int]',
        'phases': 'dict[str, Times]',
        'empty_share': 'float | None',
        'intervals': 'list[dict[str, Any]]',
        'vehicles': 'list[Any]',
        'waits': 'list[dict[str, Any]]',
        'waits_of': 'int',
        'places': 'list[dict[str, Any]]',
        'late': 'list[dict[str, Any]]',
        'open': 'list[dict[str, Any]]',
    },
)


StretchIn = TypedDict(
    "StretchIn",
    {
        'kind': "Literal['stretch']",
        'from': 'str',
        'to': 'str',
    },
)


class Taken(TypedDict):
    """Under way. `cmd_id` null: the command follows when the vehicle has its track."""

    vehicle: str
    cmd_id: str | None


class Target(TypedDict):
    """Positions of the three taught axes, pulses."""

    shft: int
    rota: int
    lift: int


class TaughtChange(TypedDict):
    """What one vehicle is sent at one port, before and after, in pulses."""

    station: str
    vehicle: str
    old: Axes
    new: Axes
    beyond: str


class TaughtComparison(TypedDict):
    old: PulsesVersion
    new: PulsesVersion
    differences: Axes
    changes: list[TaughtChange]


class TaughtDest(PulsesVersion):
    station: str


class TaughtOffset(PulsesVersion):
    vehicle: str


class TaughtTarget(Axes):
    """What a vehicle would be sent at a port. `refusal`: why a job would be refused, empty if not."""

    station: str
    vehicle: str
    complete: bool
    refusal: str
    reference: bool
    dest: PulsesVersion | None
    offset: PulsesVersion | None


class TeachingEvent(TypedDict):
    number: int
    at: str
    vehicle: str
    barcode: str
    code: str
    axis: str | None
    position: int
    cmd_id: str
    connection: str
    asked_by: str | None


class TeachingSession(TypedDict):
    """A teaching session: its port is closed to jobs while it is open. Its live key is ``session-ID``."""

    id: int
    station: str
    vehicle: str
    actor: str
    note: str
    state: str
    opened: str
    ended: str | None
    ended_by: str | None
    reason: str


class TeachingSessionDetail(TeachingSession):
    proposals: list[Proposal]
    advice: str


class Ticket(TypedDict):
    ticket: str
    expires_in: float


class Times(TypedDict):
    """How long something took, seconds; null if it never happened."""

    count: int
    mean: float | None
    p50: float | None
    p95: float | None
    longest: float | None


class TransferCommand(TypedDict):
    """One pick-up or put-down by a vehicle that stands at the station. ``target`` replaces the taught pulses."""

    command: Literal['pickup', 'place']
    station: str
    target: NotRequired[Target | None]


class User(TypedDict):
    name: str
    roles: list[str]
    created: str
    created_by: str
    disabled: bool
    logged_in: str | None


class UserChange(TypedDict):
    """What to change; a field that is left out stays."""

    roles: NotRequired[list[Role] | None]
    disabled: NotRequired[bool | None]
    password: NotRequired[str | None]


class UserIn(TypedDict):
    """A person who may log in."""

    name: str
    roles: list[Role]
    password: str


class Vehicle(TypedDict):
    """A vehicle as it is now. ``state`` in E82's words; ``activity`` one word more for people (idle, moving, waiting,
    settling, absent, held ...); ``waiting`` the sentence that explains a wait, ``waits_for`` the vehicle that has
    to go first; ``granted`` the track ahead it may drive, ``covered`` what it holds at and behind its place. Mode
    and everything from STATUS is None before its first STATUS. An AGV (``kind``) has ``agv`` in place of status
    words, SEQ and code. ``parked``: it is idle at a parking place.
    """

    id: str
    dev_id: int
    dialect: str
    address: str
    state: Literal['removed', 'not_assigned', 'enroute', 'parked', 'acquiring', 'depositing']
    activity: Literal['off_rail', 'absent', 'locked_out', 'recovering', 'held', 'alarm', 'settling', 'acquiring', 'depositing', 'paused', 'moving', 'charging', 'waiting', 'busy', 'idle']
    service: Literal['in_service', 'out_of_service']
    link: Link
    mode: Literal['mant', 'semi', 'undefined', 'auto'] | None
    oper: Literal['idle', 'alarm', 'run', 'pause'] | None
    code: int | None
    code_name: str
    loaded: bool | None
    carrier: str | None
    barcode: str | None
    dist: int | None
    seq: int | None
    status1: str | None
    status2: str | None
    bits: list[Bit]
    job: str | None
    goal: str | None
    waiting: str
    waits_for: str | None
    granted: list[str]
    covered: list[str]
    hold: Hold | None
    lockout: Lockout | None
    seen: str | None
    kind: Literal['hoist', 'agv']
    agv: Agv | None
    parked: bool


class VehicleComparison(TypedDict):
    one: Any
    other: Any
    differences: Axes
    stations: list[dict[str, Any]]


class Walk(TypedDict):
    """An audit walk: of so many ``places`` so many have been ``entered``. ``state``: open, accepted or abandoned."""

    id: int
    actor: str
    reason: str
    state: str
    started: str
    ended: str | None
    ended_by: str | None
    places: int
    entered: int


class WalkIn(TypedDict):
    """Why, and along which stations; none: every side buffer of the plant."""

    reason: str
    stations: NotRequired[list[str]]


class WalkPlace(TypedDict):
    """A place of an audit walk. After the walk has ended `now` may be long past what was seen."""

    station: str
    believed: bool | None
    believed_carrier: str | None
    now: bool | None
    now_carrier: str | None
    seen: bool | None
    seen_carrier: str | None
    by: str | None
    at: str | None
    finding: Literal['not_seen', 'agrees', 'differs', 'moved']


class Watch(TypedDict):
    watch: str
    drive: str
    parameters: list[str]
    seconds: float


class WatchIn(TypedDict):
    """Which parameters to poll, and for how many seconds."""

    parameters: list[str]
    seconds: NotRequired[float]


class Webhook(TypedDict):
    id: int
    url: str
    events: list[str]
    note: str
    state: Literal['active', 'paused', 'failed']
    reason: str
    actor: str
    created: str
    position: int
    behind: int
    delivered: int
    last: str | None
    failing: str | None
    attempts: int
    error: str


class WebhookChange(TypedDict):
    """What to change; a field that is left out stays. ``active`` true takes up again what is paused or has failed."""

    url: NotRequired[str | None]
    events: NotRequired[list[str] | None]
    note: NotRequired[str | None]
    active: NotRequired[bool | None]


class WebhookDelivery(TypedDict):
    number: int
    at: str
    event: str
    seq: int | None
    attempt: int
    status: int | None
    seconds: float
    taken: bool
    error: str


class WebhookIn(TypedDict):
    """A subscription. ``after``: begin with the events above this number; left out: with the next one."""

    url: str
    events: NotRequired[list[str]]
    note: NotRequired[str]
    after: NotRequired[int | None]


class WebhookMessage(TypedDict):
    """What a receiver gets (headers webhook-id, webhook-timestamp, webhook-signature: Standard Webhooks)."""

    type: str
    timestamp: str
    data: Event | dict[str, Any]


class WebhookWithSecret(Webhook):
    secret: str


class WriteIn(TypedDict):
    """What to write: ``value`` in the catalogue's unit, or ``raw`` as the drive has it. ``raw_access`` says that a
    parameter without a catalogue is meant.
    """

    raw: NotRequired[int | None]
    value: NotRequired[float | None]
    raw_access: NotRequired[bool]


class Zone(TypedDict):
    """A zone of the plant."""

    id: str
    name: str
    capacity: int
    no_stop: bool
    state: Literal['auto', 'paused', 'stopped']
    pause: Pause | None
    vehicles: list[str]


class ZoneIn(TypedDict):
    """All barcodes of a zone of the plant."""

    kind: Literal['zone']
    zone: str
