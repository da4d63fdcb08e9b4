"""AGVs, buffers and doors (ENIG): what is asked of them and what they say (PROTOCOLS section 3, COMMANDS section 1)."""

from dataclasses import dataclass
from enum import IntEnum, StrEnum
from typing import NewType

from app.domain.units import Barcode, Seconds

DeviceId = NewType("DeviceId", str)
DeviceNumber = NewType("DeviceNumber", int)
"""A device's DeviceType on the wire: 11 to 19 AGVs, 21 to 29 buffers, 30 the door, unless configured (PROTOCOLS E22)."""
DeviceRequestId = NewType("DeviceRequestId", int)
"""Identity of a request whose intent is durable; nothing of it is on the wire (PROTOCOLS E9)."""
AliasName = NewType("AliasName", str)
"""A destination by name, such as B1 (PROTOCOLS 3.2)."""


class DeviceKind(StrEnum):
    """What a device is."""

    AGV = "agv"
    BUFFER = "buffer"
    DOOR = "door"
    CHARGER = "charger"
    """Has no packets of its own (PROTOCOLS 3.2): it is on no link."""


@dataclass(frozen=True, slots=True)
class DeviceSpec:
    """A device and its number on the link."""

    id: DeviceId
    number: DeviceNumber
    kind: DeviceKind


# What they say


class AgvMode(IntEnum):
    """Who drives: only a person at the AGV changes it (PROTOCOLS E21)."""

    MANUAL = 0
    AUTO = 1


class AgvRun(IntEnum):
    """RunSt."""

    STOP = 0
    RUN = 1
    ERROR = 2


class Steering(IntEnum):
    """Direction in Status; MARK_STOP is that it will stop, or has stopped, at a mark."""

    STRAIGHT = 0
    LEFT = 1
    RIGHT = 2
    MARK_STOP = 3


class CartState(IntEnum):
    """Whether a cart is on the AGV."""

    NONE = 0
    PRESENT = 1
    UNKNOWN = 2


class LiftState(IntEnum):
    """Where the lift is; UNKNOWN while it moves, and where it was stopped on its way (PROTOCOLS 5.3)."""

    DOWN = 0
    UP = 1
    UNKNOWN = 2


@dataclass(frozen=True, slots=True)
class AgvStatus:
    """Status of an AGV (PROTOCOLS 3.3). ``tag`` is the last one read; ``path`` counts accepted moves, 0 none (E15)."""

    mode: AgvMode
    run: AgvRun
    steering: Steering
    in_position: bool
    charging: bool
    cart: CartState
    lift: LiftState
    tag: Barcode
    path: int

    @property
    def arrived(self) -> bool:
        """Whether it stands at its destination: this says the same as Move Complete (PROTOCOLS E27)."""
        return self.in_position and self.run is AgvRun.STOP


class BufferState(IntEnum):
    """Status of a buffer. It does not say whether the buffer is locked."""

    NO_CART = 0
    CART = 1
    BUSY = 2
    UNKNOWN = 3
    ERROR = 255


class DoorState(IntEnum):
    """Status of a door."""

    CLOSED = 0
    OPEN = 1
    BUSY = 2
    UNKNOWN = 3
    ERROR = 255


DeviceStatus = AgvStatus | BufferState | DoorState


# Commands


class ManualDirection(IntEnum):
    """Which way a person drives an AGV."""

    BACKWARD = 0
    FORWARD = 1
    TURN_LEFT = 2
    TURN_RIGHT = 3


class AgvSpeed(IntEnum):
    """How fast."""

    SLOW = 0
    NORMAL = 1
    FAST = 2


class LiftAction(IntEnum):
    """What the lift is to do."""

    STOP = 0
    UP = 1
    DOWN = 2


@dataclass(frozen=True, slots=True)
class AgvMove:
    """100 Move: drive to a tag."""

    tag: Barcode


@dataclass(frozen=True, slots=True)
class AgvMoveAlias:
    """107 Move: drive to a named place. It hides its path: only onto track that is granted whole (COMMANDS section 1)."""

    alias: AliasName


@dataclass(frozen=True, slots=True)
class AgvSetCurrent:
    """103 SetCurrent: tell a standing AGV which tag it is at."""

    tag: Barcode


@dataclass(frozen=True, slots=True)
class AgvMoveManual:
    """104 MoveManual: drive until stopped; never sent twice."""

    direction: ManualDirection
    speed: AgvSpeed


@dataclass(frozen=True, slots=True)
class AgvMoveAuto:
    """108 MoveAuto: follow the tape until stopped; never sent twice. ``steering`` is straight, left or right."""

    forward: bool
    steering: Steering
    speed: AgvSpeed


@dataclass(frozen=True, slots=True)
class AgvLift:
    """106 Lift."""

    action: LiftAction


@dataclass(frozen=True, slots=True)
class AgvCharge:
    """109 Charge: ``on`` drives to a charger of the AGV's choice and charges (PROTOCOLS E12); never sent twice."""

    on: bool


class DeviceAct(StrEnum):
    """Commands without data: three for AGVs, two each for buffers and doors."""

    STOP = "stop"
    RESET = "reset"
    MARK_STOP = "mark_stop"
    LOCK = "lock"
    UNLOCK = "unlock"
    OPEN = "open"
    CLOSE = "close"


DeviceCommand = AgvMove | AgvMoveAlias | AgvSetCurrent | AgvMoveManual | AgvMoveAuto | AgvLift | AgvCharge | DeviceAct


@dataclass(frozen=True, slots=True)
class DeviceRequest:
    """A command on its way to a device."""

    id: DeviceRequestId
    device: DeviceId
    command: DeviceCommand


# Events


@dataclass(frozen=True, slots=True)
class DeviceBack:
    """The first Status since connecting, or after a silence, has come; a DeviceReported with it follows."""

    device: DeviceId


@dataclass(frozen=True, slots=True)
class DeviceStale:
    """No Status for 5 s (PROTOCOLS E14), or the link is lost: nothing is known of the device until it is back."""

    device: DeviceId
    reason: str


@dataclass(frozen=True, slots=True)
class DeviceReported:
    """A Status that differs from the one before, or the first after a silence. ``at`` is when it came."""

    device: DeviceId
    status: DeviceStatus
    at: Seconds


@dataclass(frozen=True, slots=True)
class TagRead:
    """An AGV has read a tag (TagID Received)."""

    device: DeviceId
    tag: Barcode


@dataclass(frozen=True, slots=True)
class MoveCompleted:
    """An AGV has sent Move Complete, whoever had it move. It may be lost; a request's end is DeviceDone."""

    device: DeviceId
    tag: Barcode


@dataclass(frozen=True, slots=True)
class DeviceTaken:
    """Status shows that the device is carrying the command out; its end is still to come."""

    device: DeviceId
    request: DeviceRequestId


@dataclass(frozen=True, slots=True)
class DeviceDone:
    """The device shows the command's effect."""

    device: DeviceId
    request: DeviceRequestId


@dataclass(frozen=True, slots=True)
class DeviceNotSent:
    """The session refused before the first byte: nothing happened."""

    device: DeviceId
    request: DeviceRequestId
    reason: str
    remedy: str = ""


@dataclass(frozen=True, slots=True)
class DeviceNotAccepted:
    """The device reports, and shows no effect of the command. There is no refusal packet: ``reason`` is what Status tells."""

    device: DeviceId
    request: DeviceRequestId
    reason: str
    remedy: str = ""


@dataclass(frozen=True, slots=True)
class DeviceFailed:
    """The device began and ended otherwise: stopped short, in error, overtaken by a later command."""

    device: DeviceId
    request: DeviceRequestId
    reason: str


class DeviceDoubt(StrEnum):
    """Why the outcome of a command is unknown. Unknown is not failed: Status decides (COMMANDS section 1)."""

    LINK_LOST = "the link was lost"
    STALE = "the device reports no more"
    OVERTAKEN = "another command was sent before this one showed its effect"


@dataclass(frozen=True, slots=True)
class DeviceUnknown:
    """Nothing is known of this command's outcome."""

    device: DeviceId
    request: DeviceRequestId
    why: DeviceDoubt


@dataclass(frozen=True, slots=True)
class DeviceGarbled:
    """Bytes that were no packet (``device`` None), or a packet that does not fit."""

    device: DeviceId | None
    reason: str
    detail: str


DeviceEvent = (
    DeviceBack
    | DeviceStale
    | DeviceReported
    | TagRead
    | MoveCompleted
    | DeviceTaken
    | DeviceDone
    | DeviceNotSent
    | DeviceNotAccepted
    | DeviceFailed
    | DeviceUnknown
    | DeviceGarbled
)
"""Each request ends in exactly one of DeviceDone, DeviceNotSent, DeviceNotAccepted, DeviceFailed and DeviceUnknown."""
