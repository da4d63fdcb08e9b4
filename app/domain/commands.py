"""Commands to a vehicle, in the words of the business. The session turns each into a packet (PROTOCOLS 1.5, 1.6)."""

from dataclasses import dataclass
from enum import StrEnum

from app.domain.devices import DeviceCommand
from app.domain.ids import CmdId, VehicleId
from app.domain.layout import PulseSet, StationKind
from app.domain.route import PathElement
from app.domain.units import Percent, Seconds


@dataclass(frozen=True, slots=True)
class Move:
    """0x1044 MOVE. ``planned`` is the expected driving time (the answer is due after 2 x planned + 30 s, PROTOCOLS 6.1).

    The three texts are for the vehicle's display, at most 16 ASCII characters each.
    """

    path: tuple[PathElement, ...]
    planned: Seconds
    foup_id: str = ""
    source: str = ""
    destination: str = ""


@dataclass(frozen=True, slots=True)
class Xmove:
    """0x1045 XMOVE: replaces the path of the running MOVE from the first element's SEQ on.

    ``planned`` is the expected driving time to the *new* end, counted from now; ``amends`` the CMD_ID of the MOVE.
    """

    path: tuple[PathElement, ...]
    planned: Seconds
    amends: CmdId


@dataclass(frozen=True, slots=True)
class Pickup:
    """0x1046, 0x1048, 0x104A: take the carrier from a port (``target`` given) or a side buffer (``target`` None)."""

    at: StationKind
    target: PulseSet | None
    look_down: int
    speed: Percent


@dataclass(frozen=True, slots=True)
class Place:
    """0x1047, 0x1049, 0x104B: put the carrier down; fields as in :class:`Pickup`."""

    at: StationKind
    target: PulseSet | None
    look_down: int
    speed: Percent


class Plain(StrEnum):
    """Commands without data (PROTOCOLS 1.5)."""

    STATUS = "status"
    STOP = "stop"
    STOP_BY_HOST = "stop_by_host"
    SERVO_ON = "servo_on"
    SERVO_OFF = "servo_off"
    SEARCH_HOME = "search_home"
    GO_HOME = "go_home"
    SYSTEM_RESET = "system_reset"
    ALARM_CLEAR = "alarm_clear"
    AUTO = "auto"
    PORT_DEST_TEACHING = "port_dest_teaching"
    PORT_OFFSET_TEACHING = "port_offset_teaching"


@dataclass(frozen=True, slots=True)
class Simple:
    """A command without data."""

    what: Plain


@dataclass(frozen=True, slots=True)
class Display:
    """0x50C2 DISPLAY BY HOST: at most 12 ASCII characters; ``alarm`` (0x8000-0xFFFF, I45) makes it an alarm."""

    text: str
    alarm: int | None = None


@dataclass(frozen=True, slots=True)
class Direct:
    """A command in ENIG's own words (PROTOCOLS 3.3), for AGVs alone."""

    command: DeviceCommand


Command = Move | Xmove | Pickup | Place | Simple | Display | Direct


@dataclass(frozen=True, slots=True)
class Send:
    """A command on its way to a vehicle, under an identity that is already durable."""

    vehicle: VehicleId
    cmd_id: CmdId
    command: Command
