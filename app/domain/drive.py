"""Axis drives (HI Inverter): what is asked of them and what their line tells (PROTOCOLS section 2, COMMANDS section 1)."""

from dataclasses import dataclass
from enum import IntEnum, StrEnum
from typing import NewType

from app.domain.units import Seconds

DriveId = NewType("DriveId", str)
DriveLineId = NewType("DriveLineId", str)
DriveAddress = NewType("DriveAddress", int)
"""A drive's id on its line, 1 to 15 (PROTOCOLS 2.2)."""
DriveRequestId = NewType("DriveRequestId", int)
"""Identity of a request inside this process; nothing of it is on the wire."""
Parameter = NewType("Parameter", int)
"""Number of a parameter, 0 to 255; what it means is the model's business (PROTOCOLS H23)."""
RawValue = NewType("RawValue", int)
"""A parameter's value as the drive has it, 0 to 9999."""
Hundredths = NewType("Hundredths", int)
"""Distance in hundredths of the axis's unit, mm unless configured otherwise (PROTOCOLS H16)."""


@dataclass(frozen=True, slots=True)
class DriveSpec:
    """A drive and its place on the line."""

    id: DriveId
    address: DriveAddress


class DriveMode(IntEnum):
    """What a drive is doing with its panel and keys (PROTOCOLS 2.4, H18)."""

    PARAMETER_SELECT = 0
    PARAMETER_VALUE = 1
    MONITORING = 2
    JOG = 3
    ERROR = 4


class Turn(IntEnum):
    """Direction of rotation (PROTOCOLS 2.4, K)."""

    CW = 0
    CCW = 1


@dataclass(frozen=True, slots=True)
class DriveStatus:
    """What a drive says of itself. ``code`` is an error's number in mode ERROR, else the operation's; ``meaning`` its word.

    ``turn`` and ``distance`` are None where the drive sends the short form (PROTOCOLS H6).
    """

    mode: DriveMode
    output: int
    code: int
    meaning: str
    turn: Turn | None = None
    distance: Hundredths | None = None


class Key(StrEnum):
    """The keys of a drive's panel. STOP_RESET stops whatever moves and clears an error whose cause is gone (H25)."""

    RUN = "run"
    STOP_RESET = "stop_reset"
    UP = "up"
    DOWN = "down"
    DATA_SET = "data_set"


# Requests


@dataclass(frozen=True, slots=True)
class PressKey:
    """Press a key once. RUN, UP and DOWN first ask for the status: a drive in error is not told to move (PROTOCOLS 2.3)."""

    key: Key


@dataclass(frozen=True, slots=True)
class AskStatus:
    """Ask for the status now; not for all drives at once."""


@dataclass(frozen=True, slots=True)
class ReadParameter:
    """Read a parameter; not for all drives at once."""

    parameter: Parameter


@dataclass(frozen=True, slots=True)
class WriteParameter:
    """Write a parameter, read it back and compare (PROTOCOLS H24)."""

    parameter: Parameter
    value: RawValue


@dataclass(frozen=True, slots=True)
class SetInputs:
    """Set the inputs RUN, HOME, right and left limit, and the step, 0 to 15 (PROTOCOLS H15)."""

    run: bool = False
    home: bool = False
    right_limit: bool = False
    left_limit: bool = False
    step: int = 0


DriveCommand = PressKey | AskStatus | ReadParameter | WriteParameter | SetInputs


@dataclass(frozen=True, slots=True)
class DriveRequest:
    """A command for one drive, or for all on the line (``drive`` None), which no drive answers (PROTOCOLS 2.3)."""

    id: DriveRequestId
    drive: DriveId | None
    command: DriveCommand


@dataclass(frozen=True, slots=True)
class Jog:
    """Drive an axis as long as the caller says so again before ``until``, which is a moment of the line's clock."""

    id: DriveRequestId
    drive: DriveId
    turn: Turn
    until: Seconds


@dataclass(frozen=True, slots=True)
class KeepJogging:
    """The caller still holds the key of a jog: it goes on until ``until``, a moment of the line's clock."""

    id: DriveRequestId
    until: Seconds


@dataclass(frozen=True, slots=True)
class ReleaseJog:
    """The caller has let go of the key: the jog ends with Stop/Reset (PROTOCOLS H17)."""

    id: DriveRequestId


# Events


@dataclass(frozen=True, slots=True)
class DriveLineUp:
    """The line is connected; nothing is known of its drives yet."""

    line: DriveLineId


@dataclass(frozen=True, slots=True)
class DriveLineDown:
    """The line is lost, and with it what is known of its drives. Each request under way has its own event."""

    line: DriveLineId
    reason: str


@dataclass(frozen=True, slots=True)
class DriveOnline:
    """A drive answers, for the first time or again."""

    drive: DriveId


@dataclass(frozen=True, slots=True)
class DriveOffline:
    """An alarm: five transmissions without a fit answer (PROTOCOLS H10). The drive is probed until it answers again."""

    drive: DriveId
    reason: str


@dataclass(frozen=True, slots=True)
class DriveReported:
    """A drive's status, where it is another than the last one told."""

    drive: DriveId
    status: DriveStatus


@dataclass(frozen=True, slots=True)
class ParameterRead:
    """What a drive says a parameter's value is, asked for by itself or after a write."""

    drive: DriveId
    parameter: Parameter
    value: RawValue


@dataclass(frozen=True, slots=True)
class JogBegan:
    """The first key of a jog is about to be sent: the axis may move from here on."""

    drive: DriveId
    request: DriveRequestId


@dataclass(frozen=True, slots=True)
class Setting:
    """A parameter and its value, as read or as written and read back."""

    parameter: Parameter
    value: RawValue


class JogEnd(StrEnum):
    """Why a jog ended as it should; the Stop key was acknowledged behind it."""

    RELEASED = "released"
    CALLER_GONE = "caller gone"


DriveResult = DriveMode | DriveStatus | Setting | JogEnd | None
"""What a request gave: the mode after a key or inputs, a status, a setting, how a jog ended; None for all drives at once."""


@dataclass(frozen=True, slots=True)
class DriveDone:
    """A request was carried out. For all drives at once (``drive`` None) it says that it was sent, for a write also read back."""

    drive: DriveId | None
    request: DriveRequestId
    result: DriveResult


@dataclass(frozen=True, slots=True)
class DriveFailed:
    """A request did not take effect, or (a write that reads back otherwise) not the effect that was asked for."""

    drive: DriveId | None
    request: DriveRequestId
    reason: str
    remedy: str = ""


@dataclass(frozen=True, slots=True)
class DriveUnknown:
    """A request may or may not have taken effect; ``status`` is what the drive says since then, if it says anything."""

    drive: DriveId | None
    request: DriveRequestId
    reason: str
    status: DriveStatus | None = None


@dataclass(frozen=True, slots=True)
class DriveLineGarbled:
    """Bytes that were no packet, or a packet that answers nothing that was asked."""

    line: DriveLineId
    reason: str
    detail: str


DriveEvent = (
    DriveLineUp
    | DriveLineDown
    | DriveOnline
    | DriveOffline
    | DriveReported
    | ParameterRead
    | JogBegan
    | DriveDone
    | DriveFailed
    | DriveUnknown
    | DriveLineGarbled
)
