"""What a person or a host may ask about doors, buffers and chargers, and about fires and earthquakes (DOMAIN section 7)."""

from dataclasses import dataclass

from app.domain.devices import DeviceAct, DeviceId
from app.domain.ids import Actor
from app.domain.records import DoorPosition, EmergencyKind


@dataclass(frozen=True, slots=True)
class CommandDevice:
    """Open or close a door, lock or unlock a buffer."""

    actor: Actor
    device: DeviceId
    act: DeviceAct


@dataclass(frozen=True, slots=True)
class PinDoor:
    """Keep a door open or closed until the pin is taken off."""

    actor: Actor
    device: DeviceId
    position: DoorPosition
    reason: str


@dataclass(frozen=True, slots=True)
class UnpinDoor:
    """Let vehicles have the door again."""

    actor: Actor
    device: DeviceId


@dataclass(frozen=True, slots=True)
class LockOutDevice:
    """People are at the device: no remote command, no grant there (DOMAIN section 7)."""

    actor: Actor
    device: DeviceId
    reason: str


@dataclass(frozen=True, slots=True)
class LiftDeviceLockout:
    """Lift a lockout: its owner alone, or two others together."""

    actor: Actor
    device: DeviceId


@dataclass(frozen=True, slots=True)
class SetDeviceService:
    """Take a device out of service (``reason`` given) or put it back (empty)."""

    actor: Actor
    device: DeviceId
    reason: str


DeviceOrder = CommandDevice | PinDoor | UnpinDoor | LockOutDevice | LiftDeviceLockout | SetDeviceService
"""About one device of the plant."""


@dataclass(frozen=True, slots=True)
class RaiseEmergency:
    """Fire or earthquake: stop all, open or close doors as configured, and stay so until somebody releases it."""

    actor: Actor
    kind: EmergencyKind
    reason: str


@dataclass(frozen=True, slots=True)
class ReleaseEmergency:
    """A named person says that it is over. The controller stays paused until it is resumed."""

    actor: Actor
    kind: EmergencyKind
    reason: str
