"""ENIG's messages: their contents as records, the table of commands, and what is wrong with a content (PROTOCOLS 3.3)."""

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum
from types import MappingProxyType
from typing import Any, ClassVar

from app.protocols.enig.dialects import ACS, Dialect
from app.wire.layout import Field, Layout, u8

TAG_SIZE = 4
"""Characters of a TagID (E7)."""


class DeviceClass(StrEnum):
    """What a DeviceType is (3.2, E22)."""

    AGV = "agv"
    BUFFER = "buffer"
    DOOR = "door"


class Toward(StrEnum):
    """Which way a packet goes: the same CMD means different things (E10)."""

    DEVICE = "H>E"
    HOST = "E>H"


@dataclass(slots=True)
class Move:
    """100: drive to a tag."""

    name: ClassVar[str] = "Move"
    tag: str


@dataclass(slots=True)
class Stop:
    """101: stop."""

    name: ClassVar[str] = "Stop"


@dataclass(slots=True)
class Reset:
    """102: clear the error."""

    name: ClassVar[str] = "Reset"


@dataclass(slots=True)
class SetCurrent:
    """103: this tag is where you are."""

    name: ClassVar[str] = "SetCurrent"
    tag: str


@dataclass(slots=True)
class MoveManual:
    """104: drive in manual mode. ``direction`` 0 backward, 1 forward, 2 turn left, 3 turn right; ``speed`` 0 to 2."""

    name: ClassVar[str] = "MoveManual"
    direction: int
    speed: int


@dataclass(slots=True)
class MarkStop:
    """105: stop at the next mark."""

    name: ClassVar[str] = "MarkStop"


@dataclass(slots=True)
class Lift:
    """106: ``action`` 0 stop, 1 up, 2 down."""

    name: ClassVar[str] = "Lift"
    action: int


@dataclass(slots=True)
class MoveAlias:
    """107: drive to a destination by its name."""

    name: ClassVar[str] = "MoveAlias"
    alias: str


@dataclass(slots=True)
class MoveAuto:
    """108: follow the tape. ``motor`` 0 backward, 1 forward; ``magnet`` 0 straight, 1 left, 2 right; ``speed`` 0 to 2."""

    name: ClassVar[str] = "MoveAuto"
    motor: int
    magnet: int
    speed: int


@dataclass(slots=True)
class Charge:
    """109: ``action`` 1 go to a charger and charge, 0 charge no more (E12)."""

    name: ClassVar[str] = "Charge"
    action: int


@dataclass(slots=True)
class MoveComplete:
    """AGV 1: arrived. ``tag`` is the last one read (E25)."""

    name: ClassVar[str] = "MoveComplete"
    tag: str


@dataclass(slots=True)
class TagReceived:
    """AGV 2: a tag is read."""

    name: ClassVar[str] = "TagReceived"
    tag: str


@dataclass(slots=True)
class AgvReport:
    """AGV 3, Status: the twelve bytes under their names, as numbers."""

    name: ClassVar[str] = "Status"
    mode: int = 0
    run: int = 0
    direction: int = 0
    inposition: int = 0
    charge: int = 0
    cart: int = 0
    lift: int = 0
    tag: str = "0000"
    path: int = 0


@dataclass(slots=True)
class Lock:
    """Buffer 1."""

    name: ClassVar[str] = "Lock"


@dataclass(slots=True)
class UnLock:
    """Buffer 2."""

    name: ClassVar[str] = "UnLock"


@dataclass(slots=True)
class BufferReport:
    """Buffer 3, Status: 0 no cart, 1 cart, 2 busy, 3 unknown, 255 error."""

    name: ClassVar[str] = "Status"
    state: int


@dataclass(slots=True)
class Open:
    """Door 1."""

    name: ClassVar[str] = "Open"


@dataclass(slots=True)
class Close:
    """Door 2."""

    name: ClassVar[str] = "Close"


@dataclass(slots=True)
class DoorReport:
    """Door 3, Status: 0 closed, 1 open, 2 busy, 3 unknown, 255 error."""

    name: ClassVar[str] = "Status"
    state: int


@dataclass(slots=True)
class Raw:
    """DATA of a command that is unknown, or whose DATA does not have its size."""

    name: ClassVar[str | None] = None
    data: bytes


Body = (
    Move | Stop | Reset | SetCurrent | MoveManual | MarkStop | Lift | MoveAlias | MoveAuto | Charge
    | MoveComplete | TagReceived | AgvReport | Lock | UnLock | BufferReport | Open | Close | DoorReport | Raw
)  # fmt: skip


@dataclass(slots=True)
class Frame:
    """A packet as it stands on the wire: its ID byte, its CMD, its content, and its Target byte if there is one."""

    id: int
    cmd: int
    body: Body
    target: int | None = None

    @property
    def device(self) -> int:
        """The device of the conversation: the ID, or the Target where the ID is the host's own (E4)."""
        return self.target if self.id == ACS and self.target is not None else self.id


def _tag(name: str) -> Field:
    def write(value: str) -> bytes:
        data = value.encode("latin-1")
        if len(data) != TAG_SIZE:
            raise ValueError
        return data

    return Field(name, f"{TAG_SIZE}s", f"a text of {TAG_SIZE} characters", lambda data: data.decode("latin-1"), write)


class Words:
    """Reads and writes a DATA that is one text of any length from one character on."""

    size = None

    def read(self, data: bytes) -> MoveAlias | None:
        """Return the record; None if there is no text."""
        return MoveAlias(data.decode("latin-1")) if data else None

    def write(self, record: Any) -> bytes:
        """Return the bytes. Raises: UnicodeEncodeError: it is no text of single-byte characters."""
        return str(record.alias).encode("latin-1")


@dataclass(frozen=True, slots=True)
class Message:
    """One row of table 3.3. ``target``: whether the table lists a Target byte."""

    device: DeviceClass
    toward: Toward
    cmd: int
    cls: type[Any]
    layout: Layout[Any] | Words
    target: bool = False

    @property
    def name(self) -> str:
        """The command's name."""
        return str(self.cls.name)


def _row(
    device: DeviceClass, toward: Toward, cmd: int, cls: type[Any], *fields: Field, target: bool = False
) -> Message:
    return Message(device, toward, cmd, cls, Layout("big", fields, cls), target)


_AGV, _BUFFER, _DOOR = DeviceClass.AGV, DeviceClass.BUFFER, DeviceClass.DOOR
_DOWN, _UP = Toward.DEVICE, Toward.HOST
_STATUS = ("mode", "run", "direction", "inposition", "charge", "cart", "lift")

MESSAGES: tuple[Message, ...] = (
    _row(_AGV, _DOWN, 100, Move, _tag("tag"), target=True),
    _row(_AGV, _DOWN, 101, Stop),
    _row(_AGV, _DOWN, 102, Reset),
    _row(_AGV, _DOWN, 103, SetCurrent, _tag("tag"), target=True),
    _row(_AGV, _DOWN, 104, MoveManual, u8("direction"), u8("speed"), target=True),
    _row(_AGV, _DOWN, 105, MarkStop, target=True),
    _row(_AGV, _DOWN, 106, Lift, u8("action"), target=True),
    Message(_AGV, _DOWN, 107, MoveAlias, Words(), target=True),
    _row(_AGV, _DOWN, 108, MoveAuto, u8("motor"), u8("magnet"), u8("speed"), target=True),
    _row(_AGV, _DOWN, 109, Charge, u8("action"), target=True),
    _row(_AGV, _UP, 1, MoveComplete, _tag("tag")),
    _row(_AGV, _UP, 2, TagReceived, _tag("tag")),
    _row(_AGV, _UP, 3, AgvReport, *map(u8, _STATUS), _tag("tag"), u8("path")),
    _row(_BUFFER, _DOWN, 1, Lock, target=True),
    _row(_BUFFER, _DOWN, 2, UnLock, target=True),
    _row(_BUFFER, _UP, 3, BufferReport, u8("state")),
    _row(_DOOR, _DOWN, 1, Open),
    _row(_DOOR, _DOWN, 2, Close),
    _row(_DOOR, _UP, 3, DoorReport, u8("state")),
)
"""Table 3.3."""

BY_KEY: Mapping[tuple[DeviceClass, Toward, int], Message] = MappingProxyType(
    {(row.device, row.toward, row.cmd): row for row in MESSAGES}
)
"""The table by device class, direction and CMD (E10)."""

BY_CLASS: Mapping[type[Any], Message] = MappingProxyType({row.cls: row for row in MESSAGES})
"""The table by the record of the content."""

_STATES = (0, 1, 2, 3, 255)
_VALUES: Mapping[tuple[type[Any], str], tuple[int, ...]] = MappingProxyType(
    {
        (MoveManual, "direction"): (0, 1, 2, 3),
        (MoveManual, "speed"): (0, 1, 2),
        (Lift, "action"): (0, 1, 2),
        (MoveAuto, "motor"): (0, 1),
        (MoveAuto, "magnet"): (0, 1, 2),
        (MoveAuto, "speed"): (0, 1, 2),
        (Charge, "action"): (0, 1),
        (AgvReport, "mode"): (0, 1),
        (AgvReport, "run"): (0, 1, 2),
        (AgvReport, "direction"): (0, 1, 2, 3),
        (AgvReport, "inposition"): (0, 1),
        (AgvReport, "charge"): (0, 1),
        (AgvReport, "cart"): (0, 1, 2),
        (AgvReport, "lift"): (0, 1, 2),
        (BufferReport, "state"): _STATES,
        (DoorReport, "state"): _STATES,
    }
)


def problems(body: Body, dialect: Dialect) -> tuple[str, ...]:
    """Return what is wrong with a content: the names of the fields with a value that the table does not list."""
    found = [name for (cls, name), legal in _VALUES.items() if cls is type(body) and getattr(body, name) not in legal]
    if isinstance(body, Move | SetCurrent | MoveComplete | TagReceived | AgvReport) and not is_tag(body.tag):
        found.append("tag")
    if isinstance(body, MoveAlias) and body.alias not in dict(dialect.aliases):
        found.append("alias")
    return tuple(found)


def is_tag(text: str) -> bool:
    """Return whether a text is a TagID: four printable ASCII characters, digits as a rule (E7)."""
    return len(text) == TAG_SIZE and text.isascii() and text.isprintable()
