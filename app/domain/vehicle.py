"""What a vehicle says of itself (PROTOCOLS 1.8, 1.9), and what we make of it."""

from dataclasses import dataclass
from enum import IntEnum, StrEnum
from typing import Literal, NamedTuple

from app.domain.devices import AgvStatus
from app.domain.layout import StationKind
from app.domain.units import Barcode, Millimetres


class Mode(IntEnum):
    """STATUS2 bits 31-30."""

    MANT = 0
    SEMI = 1
    UNDEFINED = 2
    AUTO = 3


class Oper(IntEnum):
    """STATUS2 bits 29-28."""

    IDLE = 0
    ALARM = 1
    RUN = 2
    PAUSE = 3


@dataclass(frozen=True, slots=True)
class Condition:
    """The two status words, read once and shared: one object per distinct pair of words.

    ``travelling`` is TRAV 8. ``tags`` are the stop positions that TRAV 1-7 names (a set of port, sbfl, sbfr; firmware that
    knows only document B says 1 for all, ``at_tag`` is true then too). ``at_rest`` is: no axis (TRAV, SHFT, ROTA, LIFT,
    SLID, GRIP, SFTB) driving or in error. ``homed`` is ``all_home`` with LIFT, SHFT, ROTA, SLID at home in STATUS1 too.
    ``details`` holds every field of both words as (name, raw value, meaning), for people.

    An AGV has no status words (both are 0): ``agv`` is its Status, ``at_tag`` that it stands in position, ``at_rest`` that
    neither wheels nor lift move. ``doubt`` is what it does not know of itself, in words that go on after its name.
    """

    status1: int
    status2: int
    mode: Mode
    oper: Oper
    code: int
    loaded: bool
    recognised: bool
    all_home: bool
    home_known: bool
    servos_on: bool
    travelling: bool
    at_tag: bool
    tags: frozenset[StationKind]
    at_rest: bool
    homed: bool
    details: tuple[tuple[str, int, str], ...]
    agv: AgvStatus | None = None
    doubt: str = ""


class VehicleStatus(NamedTuple):
    """One STATUS: condition and place. ``dist`` is mm past the barcode where the dialect reports it (PROTOCOLS 1.7).

    A named tuple, since there is one for each packet: a frozen dataclass takes more than twice as long to make.
    """

    condition: Condition
    barcode: Barcode
    seq: int
    dist: Millimetres | None = None


Activity = Literal[
    "off_rail",
    "absent",
    "locked_out",
    "recovering",
    "held",
    "alarm",
    "settling",
    "acquiring",
    "depositing",
    "paused",
    "moving",
    "charging",
    "waiting",
    "busy",
    "idle",
]
"""What a vehicle does, in one word for people; of several that apply the first."""


class VehicleState(StrEnum):
    """SEMI E82 vehicle states (ARCHITECTURE section 4)."""

    REMOVED = "removed"
    NOT_ASSIGNED = "not_assigned"
    ENROUTE = "enroute"
    PARKED = "parked"
    ACQUIRING = "acquiring"
    DEPOSITING = "depositing"
