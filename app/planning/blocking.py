"""Why a vehicle was not granted all it wanted, and what it was granted."""

from dataclasses import dataclass
from enum import StrEnum
from typing import NamedTuple

from app.domain.ids import VehicleId, ZoneId
from app.domain.units import Barcode


class BlockReason(StrEnum):
    """Why a barcode was not granted."""

    HELD = "held"
    """Another vehicle holds it."""
    CONFLICT = "conflict"
    """Another vehicle holds a barcode that excludes it (``Track.conflicts``)."""
    ZONE = "zone"
    """As many other vehicles as it can take hold track in a zone it lies in."""
    CLOSED = "closed"
    """It is closed for new claims."""
    NO_STOP = "no_stop"
    """What was wanted ends inside a no-stop zone, and not at a goal. Want more."""
    FULL = "full"
    """No slot is free in the buffer that begins there, or beyond it."""
    CIRCLE = "circle"
    """The last slot of that buffer is free, and taking it could close a circle of full buffers (TRAFFIC section 3)."""
    METER = "meter"
    """As large a share of the soft zone that begins there is taken as may be filled from outside. Ends by itself."""
    TURN = "turn"
    """Another vehicle has waited very long to come in there from another branch. Ends by itself."""
    DOOR = "door"
    """A door leads there that is not known to be open. Traffic knows no doors: who claims says this."""


OF_BUFFERS = (BlockReason.FULL, BlockReason.CIRCLE, BlockReason.METER, BlockReason.TURN)
"""Refusals that hang on the lines in buffers, not on a barcode."""


class Blocked(NamedTuple):
    """A refusal: the barcode that could not be granted and what stands against it.

    ``by`` is the vehicle waited for: the longest in the zone for ZONE, the head of the full buffer for FULL, whose turn it is for
    CIRCLE and TURN; None for CLOSED, METER, NO_STOP and DOOR. ``zone`` goes with ZONE, METER and NO_STOP, ``note`` (why it is
    closed) with CLOSED and DOOR.
    """

    at: Barcode
    by: VehicleId | None
    why: BlockReason
    zone: ZoneId | None = None
    note: str = ""


class Grant(NamedTuple):
    """The prefix of what was wanted that the vehicle now holds, and what ended it: None if all was granted.

    A prefix trimmed for a no-stop zone is blocked by what stands beyond it.
    """

    granted: tuple[Barcode, ...]
    blocked: Blocked | None


@dataclass(frozen=True, slots=True)
class TrafficView:
    """All of it at one moment, for the read model."""

    held: dict[VehicleId, tuple[Barcode, ...]]
    blocked: dict[VehicleId, Blocked]
    closed: dict[Barcode, str]
    cycles: tuple[tuple[VehicleId, ...], ...]
