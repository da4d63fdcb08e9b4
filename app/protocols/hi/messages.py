"""HI packets and their contents, as tables (PROTOCOLS 2.2, 2.4)."""

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, fields
from enum import IntEnum, StrEnum
from types import MappingProxyType

from app.domain.errors import EncodeError
from app.protocols.hi.dialects import DEFAULT, Dialect, Steps

ALL_DRIVES = 0
"""The id that every drive obeys and none answers (2.2, H12)."""
LAST_DRIVE = 15


class Role(StrEnum):
    """Who sends a packet (2.2, H26)."""

    MASTER = "M"
    SLAVE = "S"


class Cmd(StrEnum):
    """The three letters of a command or an answer (2.4). PDT stands in the worked example alone (H3)."""

    RUN = "RUN"
    SRK = "SRK"
    UPP = "UPP"
    DWN = "DWN"
    DSK = "DSK"
    SET = "SET"
    SED = "SED"
    INP = "INP"
    SSQ = "SSQ"
    PDT = "PDT"
    ACK = "ACK"
    NAK = "NAK"
    BSY = "BSY"
    SSA = "SSA"


class Mode(IntEnum):
    """X, the mode of a drive (2.4, H18)."""

    PARAMETER_SELECT = 0
    PARAMETER_VALUE = 1
    MONITORING = 2
    JOG = 3
    ERROR = 4


@dataclass(slots=True)
class Frame:
    """A packet: ``id`` 0 to 15, ``cmd`` three letters, the data fields as text; ``more``: it ends in ETB (H11)."""

    role: Role
    id: int
    cmd: str
    data: tuple[str, ...] = ()
    more: bool = False


@dataclass(frozen=True, slots=True)
class Nothing:
    """No data."""


@dataclass(slots=True)
class Number:
    """YY, the parameter that SET asks for."""

    number: int


@dataclass(slots=True)
class Setting:
    """YY and VVV: a parameter and its value, in SED and in the answer to SET."""

    number: int
    value: int


@dataclass(slots=True)
class Inputs:
    """What INP sets: four inputs, 0 or 1, and IN3 to IN0 as a number (H15)."""

    run: int
    home: int
    r_limit: int
    l_limit: int
    steps: int


@dataclass(slots=True)
class Ack:
    """X after the command."""

    mode: int


@dataclass(slots=True)
class Refused:
    """NAK or BSY, with X or without (H7, H8)."""

    mode: int | None = None


@dataclass(slots=True)
class Ssa:
    """Status: ``status`` is FF; ``direction`` (0 CW, 1 CCW) and ``distance_centi`` (1/100 mm, H16) in the long form (H6)."""

    mode: int
    output: int
    status: int
    direction: int | None = None
    distance_centi: int | None = None

    @property
    def meaning(self) -> str:
        """What FF says in this mode; ``?`` where the source says nothing."""
        return meaning(self.mode, self.status)


Content = Nothing | Number | Setting | Inputs | Ack | Refused | Ssa

NOTHING = Nothing()

OPERATIONS: Mapping[int, str] = MappingProxyType(
    dict(enumerate(("normal", "mark", "index", "semi step", "auto step", "reciprocating operation")))
)
"""FF in the modes 0 to 3 (2.4)."""

ERRORS: Mapping[int, str] = MappingProxyType(
    dict(
        enumerate(
            (
                "OC2", "OC", "OH", "OV", "UV", "BTR", "OL1", "OL2", "CB0", "CB1", "CB2", "COM_ERR", "MARK_ERR", "HOME_ERR",
                "SE", "EXT_ERR",
            ),
            start=1,
        )
    )
)  # fmt: skip
"""FF in mode 4, decimal (2.4, H14)."""


def meaning(mode: int, status: int) -> str:
    """Return the source's word for FF in a mode; ``?`` where it has none."""
    return (ERRORS if mode == Mode.ERROR else OPERATIONS).get(status, "?")


CONTENTS: Mapping[tuple[Role, str], type[Content]] = MappingProxyType(
    {
        **{(Role.MASTER, cmd): Nothing for cmd in (Cmd.RUN, Cmd.SRK, Cmd.UPP, Cmd.DWN, Cmd.DSK, Cmd.SSQ)},
        (Role.MASTER, Cmd.SET): Number,
        (Role.MASTER, Cmd.SED): Setting,
        (Role.MASTER, Cmd.INP): Inputs,
        (Role.SLAVE, Cmd.ACK): Ack,
        (Role.SLAVE, Cmd.NAK): Refused,
        (Role.SLAVE, Cmd.BSY): Refused,
        (Role.SLAVE, Cmd.SET): Setting,
        (Role.SLAVE, Cmd.SSA): Ssa,
    }
)
"""What a packet carries; a command that is not here is delivered with its data as texts (H3, H19)."""

_INPUTS = r"([01])&([01])&([01])&([01])&"
_FORMS: Mapping[type[Content], re.Pattern[str]] = MappingProxyType(
    {
        Nothing: re.compile(""),
        Number: re.compile("([0-9A-F]{2})"),
        Setting: re.compile("([0-9A-F]{2})&([0-9]{3,4})"),
        Ack: re.compile("([0-4])"),
        Refused: re.compile("([0-4])?"),
        Ssa: re.compile("([0-4])&([0-7])&([0-9]{2})(?:&([01])&([0-9]{6}))?"),
    }
)
_INPUT_FORMS: Mapping[Steps, re.Pattern[str]] = MappingProxyType(
    {Steps.HEX: re.compile(_INPUTS + "([0-9A-F])"), Steps.BITS: re.compile(_INPUTS + "([01]{4})")}
)


def content_of(frame: Frame, dialect: Dialect = DEFAULT) -> Content | None:
    """Return what a packet's data say; None if the command is unknown or the data do not fit it (H19)."""
    kind = CONTENTS.get((frame.role, frame.cmd))
    if kind is None:
        return None
    form = _INPUT_FORMS[dialect.input_steps] if kind is Inputs else _FORMS[kind]
    found = form.fullmatch("&".join(frame.data))
    # Fields hold no "&", so joining them loses nothing; but one empty text is not the same as no field.
    if found is None or frame.data == ("",):
        return None
    bases = _bases(kind, dialect)
    numbers = [None if text is None else int(text, base) for text, base in zip(found.groups(), bases, strict=True)]
    make: Callable[..., Content] = kind
    return make(*numbers)


def _bases(kind: type[Content], dialect: Dialect) -> tuple[int, ...]:
    if kind is Inputs:
        return (10, 10, 10, 10, 16 if dialect.input_steps is Steps.HEX else 2)
    return {Number: (16,), Setting: (16, 10)}.get(kind, (10,) * len(fields(kind)))


def frame_of(role: Role, drive: int, cmd: str, content: Content, dialect: Dialect = DEFAULT) -> Frame:
    """Return the packet that says this. Raises: EncodeError: the command carries something else, or a number is out of range."""
    if CONTENTS.get((role, cmd)) is not type(content):
        raise EncodeError(f"{role.value} {cmd} does not carry {type(content).__name__}")
    _check(content, dialect)
    return Frame(role, drive, cmd, _WRITERS[type(content)](content, dialect))


_HIGHEST = {
    "number": 255, "run": 1, "home": 1, "r_limit": 1, "l_limit": 1, "steps": 15, "mode": 4, "output": 7, "status": 99,
    "direction": 1, "distance_centi": 999999,
}  # fmt: skip


def _check(content: Content, dialect: Dialect) -> None:
    for field in fields(content):
        value = getattr(content, field.name)
        if value is None and field.default is None:
            continue
        highest = _HIGHEST.get(field.name, dialect.highest_value)
        if not isinstance(value, int) or isinstance(value, bool) or not 0 <= value <= highest:
            raise EncodeError(f"{field.name} {value!r} is no whole number from 0 to {highest}")
    if isinstance(content, Ssa):
        if content.meaning == "?":
            raise EncodeError(f"status {content.status} means nothing in mode {content.mode}")
        if (content.direction is None) != (content.distance_centi is None):
            raise EncodeError("direction and distance go together")


def _write_setting(content: Setting, dialect: Dialect) -> tuple[str, ...]:
    return (f"{content.number:02X}", f"{content.value:0{dialect.value_digits}d}")


def _write_inputs(content: Inputs, dialect: Dialect) -> tuple[str, ...]:
    steps = f"{content.steps:X}" if dialect.input_steps is Steps.HEX else f"{content.steps:04b}"
    return (*(str(value) for value in (content.run, content.home, content.r_limit, content.l_limit)), steps)


def _write_ssa(content: Ssa, _: Dialect) -> tuple[str, ...]:
    short = (str(content.mode), str(content.output), f"{content.status:02d}")
    return short if content.direction is None else (*short, str(content.direction), f"{content.distance_centi:06d}")


_WRITERS: Mapping[type[Content], Callable[..., tuple[str, ...]]] = MappingProxyType(
    {
        Nothing: lambda _, __: (),
        Number: lambda content, _: (f"{content.number:02X}",),
        Setting: _write_setting,
        Inputs: _write_inputs,
        Ack: lambda content, _: (str(content.mode),),
        Refused: lambda content, _: () if content.mode is None else (str(content.mode),),
        Ssa: _write_ssa,
    }
)
