"""What a session tells of its vehicle. The fleet decides from these alone."""

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from app.domain.commands import Command
from app.domain.ids import CmdId, VehicleId
from app.domain.units import Barcode, Pulses, Seconds
from app.domain.vehicle import Condition, VehicleStatus


@dataclass(frozen=True, slots=True)
class LinkUp:
    """The first STATUS answer after connecting has come: the vehicle is there and is who it should be."""

    vehicle: VehicleId


@dataclass(frozen=True, slots=True)
class LinkDown:
    """Connection lost, or 3.5 s without a valid packet (PROTOCOLS 6.1). Commands under way are *unknown*, each said so."""

    vehicle: VehicleId
    reason: str


class Reported(NamedTuple):
    """A STATUS. ``polled`` tells an answer to our question (``asked_at``: when we asked) from an event of the vehicle's own.

    Every polled answer is given; an unasked one only where something changed. A named tuple: see VehicleStatus.
    """

    vehicle: VehicleId
    status: VehicleStatus
    polled: bool
    asked_at: Seconds


@dataclass(frozen=True, slots=True)
class Acknowledged:
    """The vehicle has the command without error (ACK)."""

    vehicle: VehicleId
    cmd_id: CmdId


@dataclass(frozen=True, slots=True)
class Answered:
    """RESP1 for a command. ``ok`` is RESULT 0; ``reason`` is what can be known of a RESULT 1 (I46), else empty."""

    vehicle: VehicleId
    cmd_id: CmdId
    command: Command
    ok: bool
    reason: str
    condition: Condition
    barcode: Barcode
    seq: int


class Unknown(StrEnum):
    """Why the outcome of a command is unknown. Unknown is not failed (PROTOCOLS 6.2)."""

    NO_ACK = "no acknowledgement after four transmissions"
    NO_ANSWER = "acknowledged, but no answer in time"
    LINK_LOST = "the link was lost"


@dataclass(frozen=True, slots=True)
class Unanswered:
    """Nothing is known of this command's outcome; it must be settled by STATUS before anything else is sent."""

    vehicle: VehicleId
    cmd_id: CmdId
    command: Command
    why: Unknown


@dataclass(frozen=True, slots=True)
class NotSent:
    """The session refused before the first byte (mode gate, path too long, not connected): nothing happened."""

    vehicle: VehicleId
    cmd_id: CmdId
    command: Command
    reason: str
    remedy: str = ""


class TeachingKind(StrEnum):
    """Which of the six teaching events (PROTOCOLS 1.5, I12)."""

    SHFT_DEST = "shft_dest"
    SHFT_OFFSET = "shft_offset"
    ROTA_DEST = "rota_dest"
    ROTA_OFFSET = "rota_offset"
    LIFT_DEST = "lift_dest"
    LIFT_OFFSET = "lift_offset"


@dataclass(frozen=True, slots=True)
class Taught:
    """A teaching event, not yet acknowledged: call ``Session.stored(receipt, now)`` once it is durable (COMMANDS section 1).

    ``connection`` counts the connections of the line: a vehicle's counter may restart with each (PROTOCOLS 6.2).
    """

    vehicle: VehicleId
    kind: TeachingKind | None
    code: int
    position: Pulses
    barcode: Barcode
    cmd_id: CmdId
    receipt: int
    connection: int = 0


@dataclass(frozen=True, slots=True)
class Garbled:
    """Bytes that were no packet, or a packet that does not fit (wrong DEV_ID, another epoch, unknown code)."""

    vehicle: VehicleId
    reason: str
    detail: str


Event = LinkUp | LinkDown | Reported | Acknowledged | Answered | Unanswered | NotSent | Taught | Garbled
