"""What is kept: each record is one row to write. The store turns them into SQL and gives a :class:`Kept` at start-up."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from app.domain.alarms import Alarm
from app.domain.closures import Closure
from app.domain.devices import DeviceId
from app.domain.drive_records import DriveOperation, DriveRecord, DriveRecords, DriveValue
from app.domain.ids import Actor, CarrierId, CmdId, Epoch, JobId, StationId, VehicleId, ZoneId
from app.domain.job import Job
from app.domain.layout import Axis
from app.domain.lockout import Lockout as Lockout
from app.domain.pulses import AxisPulses
from app.domain.teaching import Basis, Proposal, TeachingSession
from app.domain.units import Barcode, Pulses, Timestamp
from app.domain.walks import Walk, WalkPlace
from app.domain.webhooks import Webhook, WebhookProgress, WebhookTry
from app.domain.why import Why


class IntentState(StrEnum):
    """Life of a command that was made durable before its first byte (COMMANDS section 1, PROTOCOLS 6.2)."""

    OPEN = "open"
    DONE = "done"
    FAILED = "failed"
    UNKNOWN = "unknown"
    NOT_SENT = "not_sent"
    SETTLED_DONE = "settled_done"
    SETTLED_NOT_DONE = "settled_not_done"

    @property
    def closed(self) -> bool:
        """Whether nothing more is to be found out about it."""
        return self not in {IntentState.OPEN, IntentState.UNKNOWN}


@dataclass(frozen=True, slots=True)
class Intent:
    """A command as durable fact. ``kind`` is the command's name (``move``, ``pickup``, ``servo_on`` ...).

    ``vehicle`` names the vehicle, or the device (``open``, ``lock`` ...): no two in a plant have the same name.

    ``path`` is every barcode of a MOVE or XMOVE in order; ``body`` the rest for people (JSON-able; pulses, pinned teaching
    versions). ``amends`` names the MOVE that an XMOVE amends. ``acknowledged`` is set by the vehicle's ACK.
    """

    cmd_id: CmdId
    vehicle: VehicleId
    kind: str
    state: IntentState
    opened: Timestamp
    actor: Actor
    job: JobId | None = None
    path: tuple[Barcode, ...] = ()
    body: Mapping[str, object] = field(default_factory=dict)
    amends: CmdId | None = None
    closed: Timestamp | None = None
    outcome: str = ""


@dataclass(frozen=True, slots=True)
class HistoryEvent:
    """A durable event. ``seq`` rises by one without a gap; ``ceid`` is the site's event number (0: none configured)."""

    seq: int
    at: Timestamp
    event: str
    ceid: int
    job: JobId | None = None
    carrier: CarrierId | None = None
    vehicle: VehicleId | None = None
    source: str | None = None
    destination: str | None = None
    result: str = ""
    detail: str = ""


@dataclass(frozen=True, slots=True)
class AuditRow:
    """One change asked for by a person or a host: who, what, on what, with which words, and whether it was accepted."""

    at: Timestamp
    actor: Actor
    action: str
    target: str
    detail: str
    accepted: bool


HELD_BY, STOPPED_BY = "held by ", "stopped by "
"""How the reasons begin of holds that people wanted."""


@dataclass(frozen=True, slots=True)
class Hold:
    """A vehicle that nothing is sent to until a named person decides (COMMANDS section 3.4).

    ``doubt`` says why the place that it reports is not believed, empty if it is: a recovered alarm does not lift that.
    """

    reason: str
    remedy: str
    since: Timestamp
    doubt: str = ""

    @property
    def by_person(self) -> bool:
        """Whether a person wanted it: nothing is wrong with the vehicle."""
        return self.reason.startswith((HELD_BY, STOPPED_BY))

    @property
    def for_alarm(self) -> bool:
        """Whether it is for an alarm that the vehicle reports."""
        return self.reason.startswith("alarm ") and not self.reason.startswith("alarm recovery")


@dataclass(frozen=True, slots=True)
class VehicleRecord:
    """What must be known of a vehicle after a restart.

    ``barcode`` is the last place it was known to stand; ``held`` the track it may be on, tail first (COMMANDS 3.1).
    ``off_rail``: a named person said that it is not on the track. ``carrier``: believed aboard. ``believed_loaded``: F as last
    accounted for; None while never seen.
    """

    vehicle: VehicleId
    barcode: Barcode | None = None
    held: tuple[Barcode, ...] = ()
    carrier: CarrierId | None = None
    believed_loaded: bool | None = None
    hold: Hold | None = None
    lockout: Lockout | None = None
    out_of_service: str = ""
    off_rail: str = ""


class Provenance(StrEnum):
    """How we know where a carrier is (DOMAIN section 2)."""

    HOST = "host"
    PLACED = "placed"
    PICKED = "picked"
    PERSON = "person"
    SENSOR = "sensor"
    INFERRED = "inferred"
    PLANT = "plant"
    VERIFIED = "verified"
    """Seen on an audit walk, and accepted by a named person."""


@dataclass(frozen=True, slots=True)
class StationRecord:
    """What is believed of a station. ``present``: True, False, or None for not known. ``carrier`` may be unknown though
    something is present. ``verified`` is True where a person or the host wrote it, False where we infer it.
    """

    station: StationId
    present: bool | None = None
    carrier: CarrierId | None = None
    reserved: str = ""
    out_of_service: str = ""
    provenance: Provenance = Provenance.INFERRED
    at: Timestamp = Timestamp(0.0)

    @property
    def doubted(self) -> bool:
        """Whether a pick-up failed there, and nobody has said since what stands there."""
        return self.present is None and self.provenance is Provenance.INFERRED and self.at > 0


class DoorPosition(StrEnum):
    """How a person keeps a door."""

    OPEN = "open"
    CLOSED = "closed"


@dataclass(frozen=True, slots=True)
class Pin:
    """A person keeps a door open or closed, whatever vehicles want (DOMAIN section 7)."""

    position: DoorPosition
    owner: Actor
    reason: str
    since: Timestamp


@dataclass(frozen=True, slots=True)
class BufferLock:
    """For whom a buffer is locked: the vehicle that serves it, or a person."""

    owner: str
    person: bool
    since: Timestamp


@dataclass(frozen=True, slots=True)
class DeviceRecord:
    """What must be known of a door, buffer or charger after a restart.

    ``lock`` is who wants a buffer locked; ``locked`` what its last settled command made of it, None while that is not known:
    no Status says whether a buffer is locked (PROTOCOLS 3.3).
    """

    device: DeviceId
    lockout: Lockout | None = None
    pin: Pin | None = None
    lock: BufferLock | None = None
    locked: bool | None = False
    out_of_service: str = ""


@dataclass(frozen=True, slots=True)
class CarrierRecord:
    """Where a carrier is: a station, a vehicle, or nowhere we know (``place`` None)."""

    carrier: CarrierId
    place: StationId | VehicleId | None
    provenance: Provenance
    at: Timestamp


@dataclass(frozen=True, slots=True)
class CarrierGone:
    """The carrier has left the plant; its record goes."""

    carrier: CarrierId


@dataclass(frozen=True, slots=True)
class StationDest:
    """A version of a port's DEST (DOMAIN section 3). Versions count from 1 per station; the newest holds, if it is complete.

    ``source`` says how it came: ``plant file``, ``rest``, ``teaching``, ``roll-back``, ``import``. ``basis`` has what each taught
    axis was derived from, frozen (I40); an axis that a person wrote has none. ``proposal`` is what was approved, ``restores``
    the version that was rolled back to, ``reason`` the person's.
    """

    station: StationId
    version: int
    pulses: AxisPulses
    actor: Actor
    source: str
    at: Timestamp
    basis: tuple[Basis, ...] = ()
    proposal: int | None = None
    restores: int | None = None
    reason: str = ""


@dataclass(frozen=True, slots=True)
class VehicleOffset:
    """A version of a vehicle's OFFSET; fields as in :class:`StationDest`."""

    vehicle: VehicleId
    version: int
    pulses: AxisPulses
    actor: Actor
    source: str
    at: Timestamp
    basis: tuple[Basis, ...] = ()
    proposal: int | None = None
    restores: int | None = None
    reason: str = ""


@dataclass(frozen=True, slots=True)
class TeachingEvent:
    """A raw teaching event 0x2070-0x2075, kept for ever (I40). Same connection, CMD_ID and payload: same event.

    ``number`` rises; ``asked_by`` is who asked for it, None where the vehicle sent it unasked.
    """

    vehicle: VehicleId
    connection: str
    cmd_id: CmdId
    code: int
    axis: Axis | None
    position: Pulses
    barcode: Barcode
    at: Timestamp
    number: int
    asked_by: Actor | None = None


class ControllerState(StrEnum):
    """E82 controller states."""

    AUTO = "auto"
    PAUSING = "pausing"
    PAUSED = "paused"


class EmergencyKind(StrEnum):
    """What may be told to the controller so that everything stops (DOMAIN section 7)."""

    FIRE = "fire"
    EARTHQUAKE = "earthquake"


@dataclass(frozen=True, slots=True)
class Emergency:
    """A fire or an earthquake that somebody has told and nobody has released yet."""

    kind: EmergencyKind
    actor: Actor
    reason: str
    since: Timestamp


@dataclass(frozen=True, slots=True)
class ZonePause:
    """Nothing begins to move in a zone and nobody comes in; ``stopped``: what drove there was stopped where it was."""

    zone: ZoneId
    owner: Actor
    reason: str
    since: Timestamp
    stopped: bool = False

    def __str__(self) -> str:
        """Return it as a clause."""
        return f"zone {self.zone} is {'stopped' if self.stopped else 'paused'} by {self.owner}: {self.reason}"


@dataclass(frozen=True, slots=True)
class ControllerRecord:
    """State of the controller as a whole. ``emergencies``: at most one of a kind; while there is one, nothing moves.

    ``pauses``: at most one a zone.
    """

    state: ControllerState
    reason: str = ""
    emergencies: tuple[Emergency, ...] = ()
    pauses: tuple[ZonePause, ...] = ()

    @property
    def told(self) -> str:
        """What emergencies there are, for people; empty if there is none."""
        return ", ".join(emergency.kind.value for emergency in self.emergencies)


Record = (
    Job
    | Intent
    | HistoryEvent
    | AuditRow
    | VehicleRecord
    | StationRecord
    | CarrierRecord
    | CarrierGone
    | StationDest
    | VehicleOffset
    | TeachingEvent
    | Proposal
    | TeachingSession
    | ControllerRecord
    | DriveRecords
    | DeviceRecord
    | Why
    | Closure
    | Webhook
    | WebhookProgress
    | WebhookTry
    | Alarm
    | Walk
    | WalkPlace
)
"""Job, Intent, VehicleRecord, StationRecord, CarrierRecord, Proposal, TeachingSession, ControllerRecord, DeviceRecord, Why,
Closure, Alarm, Walk and WalkPlace replace the row of their key; the rest append."""


@dataclass(frozen=True, slots=True)
class Kept:
    """All that a controller needs to go on after a restart.

    ``jobs`` are those not ended, ``whys`` their why-records; ``intents`` those not closed; ``dests`` and ``offsets`` the
    newest version of each; ``proposals``, ``sessions`` and ``closures`` those not over; ``next_...`` the first numbers not yet
    used; ``epoch`` has been raised for this process life.
    """

    epoch: Epoch
    jobs: tuple[Job, ...] = ()
    intents: tuple[Intent, ...] = ()
    vehicles: tuple[VehicleRecord, ...] = ()
    stations: tuple[StationRecord, ...] = ()
    carriers: tuple[CarrierRecord, ...] = ()
    dests: tuple[StationDest, ...] = ()
    offsets: tuple[VehicleOffset, ...] = ()
    devices: tuple[DeviceRecord, ...] = ()
    controller: ControllerRecord = ControllerRecord(ControllerState.AUTO)
    next_event: int = 1
    next_order: int = 1
    whys: tuple[Why, ...] = ()
    drives: tuple[DriveRecord, ...] = ()
    drive_values: tuple[DriveValue, ...] = ()
    operations: tuple[DriveOperation, ...] = ()
    """Those that had not ended."""
    next_operation: int = 1
    proposals: tuple[Proposal, ...] = ()
    sessions: tuple[TeachingSession, ...] = ()
    next_taught: int = 1
    next_proposal: int = 1
    next_session: int = 1
    closures: tuple[Closure, ...] = ()
    next_closure: int = 1
    webhooks: tuple[Webhook, ...] = ()
    """All but those removed, with their progress."""
    webhook_progress: tuple[WebhookProgress, ...] = ()
    next_webhook: int = 1
    alarms: tuple[Alarm, ...] = ()
    """Those that had not ended."""
    next_alarm: int = 1
    walks: tuple[Walk, ...] = ()
    """Those that are open, with their places in the next."""
    walk_places: tuple[WalkPlace, ...] = ()
    next_walk: int = 1
    restored: bool = False
    """True when a person says that the database is a backup put back: what it says of the plant may be long past."""
    fresh: bool = True
    """True when this database has never run this plant: initial carriers and teaching come from the plant file."""
