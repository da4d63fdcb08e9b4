"""What a person or a host may ask of the controller. ``actor`` is always who asks."""

from dataclasses import dataclass
from enum import StrEnum

from app.domain.alarms import AcknowledgeAlarm
from app.domain.closures import ClosureRequest
from app.domain.commands import Plain
from app.domain.device_requests import DeviceOrder, RaiseEmergency, ReleaseEmergency
from app.domain.devices import DeviceCommand
from app.domain.drive_requests import DriveOrder
from app.domain.errors import Refusal
from app.domain.ids import Actor, CarrierId, JobId, StationId, VehicleId, ZoneId
from app.domain.layout import PulseSet, StopAction
from app.domain.teaching import RowFate
from app.domain.teaching_requests import TeachingRequest
from app.domain.units import Barcode
from app.domain.walks import WalkRequest
from app.domain.webhooks import WebhookRequest


@dataclass(frozen=True, slots=True)
class CreateJob:
    """Order a transfer. ``job`` None: we name it. ``fingerprint`` digests the body as sent (COMMANDS section 5).

    ``known`` is the job that the store already has under this id or key but that has ended, if any.
    """

    actor: Actor
    job: JobId | None
    source: str
    destination: StationId
    carrier: CarrierId | None
    priority: int
    fingerprint: str
    idempotency_key: str | None = None
    vehicle: VehicleId | None = None
    fallbacks: tuple[StationId, ...] = ()


@dataclass(frozen=True, slots=True)
class CancelJob:
    """Before the carrier is aboard. ``reason`` is kept with the job; it may be empty."""

    actor: Actor
    job: JobId
    reason: str = ""


@dataclass(frozen=True, slots=True)
class AbortJob:
    """After; the carrier stays aboard (COMMANDS section 4). ``reason`` is kept with the job; it may be empty."""

    actor: Actor
    job: JobId
    reason: str = ""


@dataclass(frozen=True, slots=True)
class ChangeJob:
    """New priority, destination or vehicle; None leaves as is. ``any_vehicle``: the wish for one vehicle is taken back."""

    actor: Actor
    job: JobId
    priority: int | None = None
    destination: StationId | None = None
    vehicle: VehicleId | None = None
    any_vehicle: bool = False


@dataclass(frozen=True, slots=True)
class CommandVehicle:
    """Send a command without data."""

    actor: Actor
    vehicle: VehicleId
    what: Plain


@dataclass(frozen=True, slots=True)
class CommandAgv:
    """Send an AGV one of ENIG's own commands."""

    actor: Actor
    vehicle: VehicleId
    command: DeviceCommand


@dataclass(frozen=True, slots=True)
class DisplayOnVehicle:
    """DISPLAY BY HOST."""

    actor: Actor
    vehicle: VehicleId
    text: str
    alarm: int | None = None


@dataclass(frozen=True, slots=True)
class MoveVehicle:
    """Send a vehicle without a job to a barcode, under grants like any other."""

    actor: Actor
    vehicle: VehicleId
    barcode: Barcode
    action: StopAction = StopAction.STOP


@dataclass(frozen=True, slots=True)
class HandleOnce:
    """One PICKUP (or PLACE) by a vehicle standing at the station, without a job. ``target`` replaces the taught pulses."""

    actor: Actor
    vehicle: VehicleId
    station: StationId
    pickup: bool
    target: PulseSet | None = None


@dataclass(frozen=True, slots=True)
class RecoverAlarm:
    """The sequence of PROTOCOLS 6.2; ``confirmed`` says that a person at the vehicle has seen that homing is safe."""

    actor: Actor
    vehicle: VehicleId
    confirmed: bool = False


class Verdict(StrEnum):
    """What the person decides about a held or absent vehicle."""

    GO_ON = "go_on"
    """What the vehicle reports now is true: take it over, settle what was open by it."""
    OFF_RAIL = "off_rail"
    """The vehicle is not on the track: free all it held."""
    STANDS_AT = "stands_at"
    """The vehicle is silent and stands at the given barcode, I have seen it: it holds that place only."""


@dataclass(frozen=True, slots=True)
class ReleaseVehicle:
    """A named person decides. ``reason`` is required and kept."""

    actor: Actor
    vehicle: VehicleId
    verdict: Verdict
    reason: str
    barcode: Barcode | None = None


@dataclass(frozen=True, slots=True)
class HoldVehicle:
    """Nothing more is sent to the vehicle until released."""

    actor: Actor
    vehicle: VehicleId
    reason: str


@dataclass(frozen=True, slots=True)
class SetService:
    """Take a vehicle out of service (``reason`` given) or put it back (empty)."""

    actor: Actor
    vehicle: VehicleId
    reason: str


@dataclass(frozen=True, slots=True)
class LockVehicle:
    """Maintenance lockout."""

    actor: Actor
    vehicle: VehicleId
    reason: str


@dataclass(frozen=True, slots=True)
class UnlockVehicle:
    """Lift a lockout: its owner alone, or two others together."""

    actor: Actor
    vehicle: VehicleId


@dataclass(frozen=True, slots=True)
class PauseController:
    """No new movement; what moves comes to rest at the end of its grant."""

    actor: Actor
    reason: str


@dataclass(frozen=True, slots=True)
class ResumeController:
    """Go on."""

    actor: Actor


@dataclass(frozen=True, slots=True)
class StopAll:
    """Withhold grants and stop every vehicle that moves where it is; vehicles keep AUTO. Ends with ResumeController."""

    actor: Actor
    reason: str


@dataclass(frozen=True, slots=True)
class PauseZone:
    """No new movement in a zone, and nobody comes in; ``stop``: what drives there is stopped where it is."""

    actor: Actor
    zone: ZoneId
    reason: str
    stop: bool = False


@dataclass(frozen=True, slots=True)
class ResumeZone:
    """Vehicles go on in a zone."""

    actor: Actor
    zone: ZoneId


@dataclass(frozen=True, slots=True)
class StageVehicle:
    """Send a vehicle to a station before its lot is ready; ``vehicle`` None: the nearest that is free."""

    actor: Actor
    station: StationId
    vehicle: VehicleId | None = None


@dataclass(frozen=True, slots=True)
class ParkVehicle:
    """Send a vehicle to the nearest free parking place."""

    actor: Actor
    vehicle: VehicleId


@dataclass(frozen=True, slots=True)
class WriteStation:
    """The host or a person writes what is at a station; None leaves as is. ``carrier`` \"\" means: no carrier.

    ``forgotten``: what stands there is not known any more, nor which carrier; ``present`` and ``carrier`` are None or \"\" then.
    """

    actor: Actor
    station: StationId
    present: bool | None = None
    carrier: str | None = None
    reserved: str | None = None
    out_of_service: str | None = None
    by_person: bool = False
    walked: bool = False
    """On an audit walk, accepted by a named person."""
    forgotten: bool = False


@dataclass(frozen=True, slots=True)
class WriteCarrier:
    """Install a carrier at a place or move its record; ``place`` None removes it from the plant."""

    actor: Actor
    carrier: CarrierId
    place: str | None
    by_person: bool = False


@dataclass(frozen=True, slots=True)
class WriteDest:
    """A new version of a station's DEST. ``expected`` is the version the writer saw, None for not checked."""

    actor: Actor
    station: StationId
    pulses: PulseSet
    expected: int | None = None


@dataclass(frozen=True, slots=True)
class WriteOffset:
    """A new version of a vehicle's OFFSET."""

    actor: Actor
    vehicle: VehicleId
    pulses: PulseSet
    expected: int | None = None


VehicleRequest = (
    CommandVehicle
    | CommandAgv
    | DisplayOnVehicle
    | MoveVehicle
    | HandleOnce
    | RecoverAlarm
    | ReleaseVehicle
    | HoldVehicle
    | SetService
    | LockVehicle
    | UnlockVehicle
)
"""About one vehicle of the plant."""

JobRequest = CreateJob | CancelJob | AbortJob | ChangeJob
"""About transfer jobs."""

PlantRequest = PauseController | ResumeController | WriteStation | WriteCarrier | WriteDest | WriteOffset
"""About the plant as a whole, and what is believed and taught of it."""

Stilling = StopAll | PauseZone | ResumeZone
"""About motion in the whole plant, or in a zone."""

RoomRequest = StageVehicle | ParkVehicle | ClosureRequest | Stilling | AcknowledgeAlarm | WalkRequest
"""What a control room asks besides."""

HallRequest = DeviceOrder | RaiseEmergency | ReleaseEmergency
"""About doors, buffers and chargers, and the signals that stop all."""

Request = (
    VehicleRequest
    | JobRequest
    | PlantRequest
    | DriveOrder
    | TeachingRequest
    | HallRequest
    | RoomRequest
    | WebhookRequest
)


@dataclass(frozen=True, slots=True)
class Accepted:
    """The request was carried out or is under way, and is durable.

    ``topic`` and ``key`` name the object concerned in the read model; ``created`` tells a new one from one that was there.
    ``cmd_id`` is set for commands to a vehicle or device: the intent that carries their outcome. ``fates`` are those of
    imported rows.
    """

    topic: str
    key: str
    created: bool = False
    cmd_id: int | None = None
    fates: tuple[RowFate, ...] = ()


Reply = Accepted | Refusal
