"""The read model: what people and hosts see. Published after the commit of what it shows, never before.

Plain frozen dataclasses of JSON-able values, so that the API declares them as schemas and the live stream encodes them as
they are. Times are UTC seconds (the API shows ISO 8601).
"""

from dataclasses import dataclass
from enum import StrEnum


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


@dataclass(frozen=True, slots=True)
class AgvView:
    """What only AGVs report (PROTOCOLS 3.3): ``cart`` none, present or unknown, ``lift`` down, up or unknown, ``steering``
    straight, left, right or mark_stop, ``path`` the number of the last move taken. ``beyond`` is the tag on the way to which it
    was stopped: it stands between there and the vehicle's barcode.
    """

    cart: str
    lift: str
    charging: bool
    in_position: bool
    steering: str
    path: int
    tag: str
    beyond: str | None = None


@dataclass(frozen=True, slots=True)
class VehicleView:
    """A vehicle as it is now. ``state`` in E82's words; ``activity`` one word more for people (idle, moving, waiting, settling,
    absent, held ...); ``waiting`` the sentence that explains a wait; ``granted`` the track ahead it may drive,
    ``covered`` what it holds at and behind its place. Mode and everything from STATUS is None before its first STATUS. An
    AGV (``kind``) has ``agv`` in place of status words, SEQ and code.
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
    granted: tuple[str, ...] = ()
    covered: tuple[str, ...] = ()
    hold: HoldView | None = None
    lockout: LockoutView | None = None
    seen: float | None = None
    kind: str = "hoist"
    agv: AgvView | None = None


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
    """A station and what is believed of it. ``provenance`` and ``at`` say how and when we came to believe it; ``verified`` is
    true only where the host or a person wrote it. ``target`` is the DEST in pulses (shft, rota, lift), ports only.
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
    at: float
    target: tuple[int, int, int] | None
    target_version: int | None


@dataclass(frozen=True, slots=True)
class CarrierView:
    """A carrier and where it is believed to be (a station, a vehicle, or None)."""

    id: str
    place: str | None
    provenance: str
    verified: bool
    at: float


@dataclass(frozen=True, slots=True)
class ControllerView:
    """The controller itself. ``waiting_for`` are the vehicles that the roll-call after a start still misses."""

    plant: str
    state: str
    reason: str
    epoch: int
    started: float
    waiting_for: tuple[str, ...] = ()
    trouble: str = ""


@dataclass(frozen=True, slots=True)
class EventView:
    """A durable event (DOMAIN section 2). ``seq`` has no gaps."""

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
    """A command to a vehicle and what became of it (an intent). ``cmd_id`` as 16 hex digits."""

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
class DeviceView:
    """A door or buffer (PROTOCOLS 3.3). ``state`` in the specification's words, its last one; it counts only while ``fresh``."""

    id: str
    kind: str
    link: str
    number: int
    fresh: bool
    reason: str = ""
    state: str | None = None
    seen: float | None = None


@dataclass(frozen=True, slots=True)
class DriveView:
    """An axis drive (PROTOCOLS 2.4). ``online`` None: not heard yet on this connection. ``code`` is an error's number in mode
    error, else the operation's, ``meaning`` its word; ``distance`` in hundredths of the axis's unit (H16).
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
)


@dataclass(frozen=True, slots=True)
class Update:
    """A change of the read model; ``value`` None removes the object. Ended jobs leave the model (the database keeps them)."""

    topic: Topic
    key: str
    value: View | None
