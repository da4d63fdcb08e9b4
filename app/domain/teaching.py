"""Teaching as it is kept: sets of teaching events as proposals, sessions, and what a version was derived from.

(DOMAIN section 3; PROTOCOLS I11-I14, I39-I41.)
"""

from dataclasses import dataclass
from enum import StrEnum

from app.domain.commands import Plain
from app.domain.ids import Actor, CmdId, StationId, VehicleId
from app.domain.layout import Axis, PulseSet
from app.domain.pulses import AxisPulses
from app.domain.units import Barcode, Pulses, Seconds, Timestamp

WINDOW = Seconds(10.0)
"""SHFT, ROTA and LIFT from one vehicle and barcode within this time are one set (I41)."""
DRIFT = PulseSet(Pulses(100), Pulses(50), Pulses(300))
"""A new value farther than this from the old one is pointed out (our choice: about a millimetre of a usual axis)."""


class Side(StrEnum):
    """Which database an event is for: Station Teaching (DEST) or Vehicle Offset."""

    DEST = "dest"
    OFFSET = "offset"

    @property
    def command(self) -> Plain:
        """The command that asks a vehicle for all three axes (0x2076, 0x2077)."""
        return Plain.PORT_DEST_TEACHING if self is Side.DEST else Plain.PORT_OFFSET_TEACHING


class ProposalState(StrEnum):
    """What became of a set of teaching events. The raw events stay, whatever it is."""

    COLLECTING = "collecting"
    """Its events are still coming."""
    UNKNOWN_BARCODE = "unknown_barcode"
    """No port of the plant is at its barcode."""
    WRONG_MODE = "wrong_mode"
    """The vehicle was not in MANT when it sent them (PROTOCOLS 1.5)."""
    AMBIGUOUS = "ambiguous"
    """Several ports share the barcode, and no session names one: a person assigns it."""
    UNUSABLE = "unusable"
    """An OFFSET of a declared reference vehicle: it is zero by declaration."""
    INCOMPLETE = "incomplete"
    """All three axes were asked for, or the vehicle was lost in the middle: axes are missing."""
    PENDING = "pending"
    """The other side is not known: DEST by a vehicle without OFFSET, OFFSET at a port without DEST."""
    OUT_OF_RANGE = "out_of_range"
    """A position that the vehicle's limits exclude."""
    READY = "ready"
    """Waits for a person's approval."""
    APPROVED = "approved"
    REJECTED = "rejected"
    SUPERSEDED = "superseded"
    """A later teaching of the same port or vehicle has at least the same axes."""

    @property
    def over(self) -> bool:
        """Whether nothing more becomes of it."""
        return self in {ProposalState.APPROVED, ProposalState.REJECTED, ProposalState.SUPERSEDED}


ACCEPTABLE = frozenset({ProposalState.INCOMPLETE, ProposalState.WRONG_MODE, ProposalState.OUT_OF_RANGE})
"""States that a person who approves may accept by name."""


@dataclass(frozen=True, slots=True)
class Basis:
    """Where one axis of a version comes from (I40): value = ``raw`` - ``less``.

    ``vehicle`` sent ``raw`` from ``barcode`` in the teaching events ``events`` (the last one counts). ``less`` is the other
    side's value: of version ``version`` of vehicle ``against`` (a DEST) or of station ``against`` (an OFFSET). ``version``
    None: ``against`` is a declared reference vehicle.
    """

    axis: Axis
    raw: Pulses
    vehicle: VehicleId
    barcode: Barcode
    events: tuple[int, ...]
    against: str
    version: int | None
    less: Pulses


@dataclass(frozen=True, slots=True)
class Reading:
    """The position of one axis in a set. ``events`` are the numbers of the teaching events that gave it, the last one counts."""

    axis: Axis
    position: Pulses
    cmd_id: CmdId
    events: tuple[int, ...]


@dataclass(frozen=True, slots=True)
class Proposal:
    """A set of teaching events, and the version that it would make.

    ``station`` is the port taught (DEST) or the reference port (OFFSET), None while nobody knows which. ``asked`` is the
    PORT DEST or PORT OFFSET command that asked for it, ``asked_by`` who sent that or opened the session. ``broken`` says why
    its events stopped coming too early. ``mode`` is a mode other than MANT that an event came in. ``collecting``: more events
    may come. ``result`` is the whole version that approval makes, ``base`` the version it follows (0: none),
    ``against_version`` that of the other side. ``revision`` rises with every change, and is its ETag.
    """

    number: int
    side: Side
    vehicle: VehicleId
    barcode: Barcode
    opened: Timestamp
    at: Timestamp
    readings: tuple[Reading, ...] = ()
    state: ProposalState = ProposalState.COLLECTING
    why: str = ""
    remedy: str = ""
    warnings: tuple[str, ...] = ()
    station: StationId | None = None
    session: int | None = None
    asked: CmdId | None = None
    asked_by: Actor | None = None
    collecting: bool = True
    broken: str = ""
    mode: str = ""
    result: AxisPulses | None = None
    base: int = 0
    against_version: int | None = None
    closed: Timestamp | None = None
    closed_by: Actor | None = None
    reason: str = ""
    version: int | None = None
    revision: int = 1


class SessionState(StrEnum):
    """Life of a teaching session."""

    OPEN = "open"
    CLOSED = "closed"
    ABANDONED = "abandoned"


@dataclass(frozen=True, slots=True)
class TeachingSession:
    """A named person teaches with a vehicle at a port: the port is closed to jobs, and the vehicle's events belong to it."""

    number: int
    station: StationId
    vehicle: VehicleId
    actor: Actor
    opened: Timestamp
    note: str = ""
    state: SessionState = SessionState.OPEN
    ended: Timestamp | None = None
    ended_by: Actor | None = None
    reason: str = ""


class Fate(StrEnum):
    """What an import does with a row."""

    NEW = "new"
    CHANGED = "changed"
    SAME = "same"
    ERROR = "error"


@dataclass(frozen=True, slots=True)
class ImportRow:
    """A row to import. ``line`` counts from 1 in the file; an axis that is left out stays as it is.

    ``version`` is the one that the writer saw, None for not checked.
    """

    line: int
    name: str
    pulses: AxisPulses
    version: int | None = None


@dataclass(frozen=True, slots=True)
class RowFate:
    """What becomes of a row: ``detail`` has the differences or the mistake, ``version`` the one it makes or leaves."""

    line: int
    name: str
    fate: Fate
    detail: str = ""
    remedy: str = ""
    version: int | None = None
