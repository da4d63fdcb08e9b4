"""iTSC's messages: the codes, the message table, and what can be wrong in a well-framed packet (PROTOCOLS 1.4, 1.5).

The records and the status words are re-exported, so that users of the protocol need this module only.
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from enum import IntEnum
from itertools import pairwise
from types import MappingProxyType

from app.domain.errors import EncodeError
from app.protocols.itsc.dialects import DEFAULT, Dialect
from app.protocols.itsc.records import (
    ELEMENT_SIZE,
    INFO_SIZE,
    NOTHING,
    SUB_FORMS,
    Ack,
    Action,
    Barcode,
    Body,
    Disp,
    Element,
    Enq,
    Etb,
    Form,
    Frame,
    Infr,
    Jog,
    Move,
    Mzone,
    Nak,
    Nothing,
    Port,
    Raw,
    Req,
    Resp1,
    Resp2,
    Sbuf,
    Stid,
    Teach,
    Toward,
    Type,
    Xmove,
)
from app.protocols.itsc.status import AXES, Mode, Oper, Status1, Status2, status1, status2

__all__ = [
    "AXES",
    "ELEMENT_SIZE",
    "INFO_SIZE",
    "MESSAGES",
    "NOTHING",
    "SUB_FORMS",
    "Ack",
    "Action",
    "Barcode",
    "Body",
    "Code",
    "Disp",
    "Element",
    "EncodeError",
    "Enq",
    "Etb",
    "Form",
    "Frame",
    "Infr",
    "Jog",
    "Message",
    "Mode",
    "Move",
    "Mzone",
    "Nak",
    "Nothing",
    "Oper",
    "Port",
    "Raw",
    "Req",
    "Resp1",
    "Resp2",
    "Sbuf",
    "Status1",
    "Status2",
    "Stid",
    "Teach",
    "Toward",
    "Type",
    "Xmove",
    "messages_of",
    "problems",
    "status1",
    "status2",
]  # fmt: skip


class Code(IntEnum):
    """The command codes (1.5); 2070-2073 are inferred and a dialect may give others (I12)."""

    SERVO_ON = 0x2020
    SERVO_OFF = 0x2021
    SEARCH_HOME = 0x2022
    GO_HOME = 0x2023
    SYSTEM_RESET = 0x2024
    ALARM_CLEAR = 0x2025
    AUTO = 0x2026
    STATUS = 0x7030
    DISTANCE = 0x7032
    STOP = 0x7040
    STOP_BY_HOST = 0x5042
    MOVE = 0x1044
    XMOVE = 0x1045
    PICKUP_FROM_PORT = 0x1046
    PLACE_TO_PORT = 0x1047
    PICKUP_FROM_SBFL = 0x1048
    PLACE_TO_SBFL = 0x1049
    PICKUP_FROM_SBFR = 0x104A
    PLACE_TO_SBFR = 0x104B
    SHFT_DEST_TEACHING = 0x2070
    SHFT_OFFSET_TEACHING = 0x2071
    ROTA_DEST_TEACHING = 0x2072
    ROTA_OFFSET_TEACHING = 0x2073
    LIFT_DEST_TEACHING = 0x2074
    LIFT_OFFSET_TEACHING = 0x2075
    PORT_DEST_TEACHING = 0x2076
    PORT_OFFSET_TEACHING = 0x2077
    DISPLAY_BY_HOST = 0x50C2


_M, _S, _A = Mode.MANT, Mode.SEMI, Mode.AUTO
_ALL = frozenset({_M, _S, _A})


@dataclass(frozen=True, slots=True)
class Message:
    """A row of the message table. ``answer`` None: an ACK only. ``mode_after`` None: the mode stays.

    ``code`` is the number on the wire, ``kind`` the message it means (None for a format that only a dialect gave a code).
    ``sender`` is the source's word: HC, TC, HC/TC or VEH. ``source`` is the paragraph it comes from.
    """

    code: int
    kind: Code | None
    name: str
    sender: str
    request: Form
    answer: Form | None
    modes: frozenset[Mode]
    mode_after: Mode | None
    source: str

    @property
    def from_vehicle(self) -> bool:
        """Whether the vehicle sends it of itself, as its event."""
        return self.sender == "VEH"


def _row(
    kind: Code,
    sender: str,
    request: Form,
    answer: Form | None,
    modes: frozenset[Mode],
    after: Mode | None,
    source: str,
) -> Message:
    return Message(int(kind), kind, kind.name.replace("_", " "), sender, request, answer, modes, after, source)


_MANT, _AUTO, _AS = frozenset({_M}), frozenset({_A}), frozenset({_A, _S})
_N, _R1 = Form.NONE, Form.RESP1

_TABLE = (
    _row(Code.SERVO_ON, "HC", _N, _R1, _MANT, None, "1.5, A row 1"),
    _row(Code.SERVO_OFF, "HC", _N, _R1, _MANT, None, "1.5, A row 2"),
    _row(Code.SEARCH_HOME, "HC", _N, _R1, _MANT, None, "1.5, A row 3"),
    _row(Code.GO_HOME, "HC", _N, _R1, _MANT, None, "1.5, A row 4"),
    _row(Code.SYSTEM_RESET, "HC", _N, None, _MANT, None, "1.5, A row 5; I34"),
    _row(Code.ALARM_CLEAR, "HC", _N, _R1, _MANT, None, "1.5, A row 6"),
    _row(Code.AUTO, "HC", _N, _R1, _MANT, _A, "1.5, A row 7"),
    _row(Code.STATUS, "HC/TC", _N, Form.RESP2, _ALL, None, "1.5, A row 8, B row 1; I37"),
    _row(Code.DISTANCE, "HC/TC", _N, Form.RAW, _ALL, None, "1.5, A row 9; I31"),
    _row(Code.STOP, "HC", _N, _R1, _ALL, _M, "1.5, A row 10"),
    _row(Code.STOP_BY_HOST, "TC", _N, _R1, _AS, None, "1.5, A row 11, B row 2"),
    _row(Code.MOVE, "TC", Form.MOVE, _R1, _AUTO, None, "1.5, A row 12, B row 3; I20"),
    _row(Code.XMOVE, "TC", Form.XMOVE, _R1, _AUTO, None, "1.5, A row 13, B row 4; I13, I38"),
    _row(Code.PICKUP_FROM_PORT, "TC", Form.PORT, _R1, _AUTO, None, "1.5, A row 14, B row 5"),
    _row(Code.PLACE_TO_PORT, "TC", Form.PORT, _R1, _AUTO, None, "1.5, B row 6"),
    _row(Code.PICKUP_FROM_SBFL, "TC", Form.SBUF, _R1, _AUTO, None, "1.5, B row 7; I36"),
    _row(Code.PLACE_TO_SBFL, "TC", Form.SBUF, _R1, _AUTO, None, "1.5, B row 8"),
    _row(Code.PICKUP_FROM_SBFR, "TC", Form.SBUF, _R1, _AUTO, None, "1.5, B row 9"),
    _row(Code.PLACE_TO_SBFR, "TC", Form.SBUF, _R1, _AUTO, None, "1.5, B row 10"),
    _row(Code.SHFT_DEST_TEACHING, "VEH", Form.TEACH, None, _MANT, None, "1.5; I12, I39"),
    _row(Code.SHFT_OFFSET_TEACHING, "VEH", Form.TEACH, None, _MANT, None, "1.5; I12, I39"),
    _row(Code.ROTA_DEST_TEACHING, "VEH", Form.TEACH, None, _MANT, None, "1.5; I12, I39"),
    _row(Code.ROTA_OFFSET_TEACHING, "VEH", Form.TEACH, None, _MANT, None, "1.5; I12, I39"),
    _row(Code.LIFT_DEST_TEACHING, "VEH", Form.TEACH, None, _MANT, None, "1.5, B row 11"),
    _row(Code.LIFT_OFFSET_TEACHING, "VEH", Form.TEACH, None, _MANT, None, "1.5, B row 12"),
    _row(Code.PORT_DEST_TEACHING, "HC", _N, _R1, _MANT, None, "1.5, B row 13"),
    _row(Code.PORT_OFFSET_TEACHING, "HC", _N, _R1, _MANT, None, "1.5, B row 14; I11"),
    _row(Code.DISPLAY_BY_HOST, "TC", Form.DISP, _R1, _AS, None, "1.5, B row 15"),
)

_RENUMBERED = {
    Code.SHFT_DEST_TEACHING: "teach_shft_dest",
    Code.SHFT_OFFSET_TEACHING: "teach_shft_offset",
    Code.ROTA_DEST_TEACHING: "teach_rota_dest",
    Code.ROTA_OFFSET_TEACHING: "teach_rota_offset",
}
_OPTIONAL = {
    "req_code": Form.REQ,
    "mzone_code": Form.MZONE,
    "stid_code": Form.STID,
    "jog_code": Form.JOG,
    "infr_code": Form.INFR,
}
_BITS_OF_MODE = {1: _A, 2: _M, 4: _S}


def messages_of(dialect: Dialect) -> Mapping[int, Message]:
    """Return the message table of a dialect by the code on the wire.

    The formats of I32 that the dialect gives a code answer with unformatted data, since none is defined; their modes are
    read from the code's top nibble (1.4). A code given twice belongs to the row of the source's table.
    """
    table: dict[int, Message] = {}
    for name, form in _OPTIONAL.items():
        code: int | None = getattr(dialect, name)
        if code is not None:
            modes = frozenset(mode for bit, mode in _BITS_OF_MODE.items() if code >> 12 & bit)
            table[code] = Message(code, None, form.value, "TC", form, Form.RAW, modes, None, "1.6; I32")
    for row in _TABLE:
        code = getattr(dialect, _RENUMBERED[row.kind]) if row.kind in _RENUMBERED else row.code
        table[code] = Message(code, *(getattr(row, name) for name in Message.__slots__[1:]))
    return MappingProxyType(table)


MESSAGES: Mapping[int, Message] = messages_of(DEFAULT)
"""The message table of document B, with A's rows (PROTOCOLS 1.5; list differences: I55)."""


_RANGES: Mapping[Form, tuple[tuple[str, str, int, int], ...]] = MappingProxyType(
    {
        Form.PORT: (("LKDN", "lkdn", 0, 15), ("SPD", "spd", 1, 100)),
        Form.SBUF: (("SPD", "spd", 1, 100),),
        Form.DISP: (("OPT", "opt", 0, 1),),
        Form.RESP1: (("RESULT", "result", 0, 1),),
        Form.REQ: (("OPT1", "opt1", 0, 1), ("OPT2", "opt2", 0, 1)),
        Form.JOG: (("OPT", "opt", 1, 4),),
        Form.INFR: (("OPT", "opt", 0, 5),),
    }
)
"""What the source limits beyond a field's width: name, attribute, lowest, highest (1.6, 1.7)."""

_TEXTS: Mapping[Form, tuple[tuple[str, str], ...]] = MappingProxyType(
    {
        Form.MOVE: (("FOUP ID", "foup_id"), ("SOURCE", "source"), ("DESTINATION", "destination")),
        Form.DISP: (("text", "text"),),
        Form.STID: (("STID", "stid"),),
        Form.TEACH: (("BARCODE", "barcode"),),
        Form.RESP1: (("BARCODE", "barcode"),),
        Form.RESP2: (("BARCODE", "barcode"),),
    }
)
"""What has to be printable ASCII (I26; a barcode where it is text, I7)."""


def problems(frame: Frame, messages: Mapping[int, Message] = MESSAGES) -> tuple[str, ...]:
    """Return what is wrong in a well-framed packet, in words; empty if a receiver may act on it.

    Reserved fields are not looked at. Pass ``codec.messages`` for a dialect with codes of its own.
    """
    if isinstance(frame, Ack | Nak):
        return ()
    message = messages.get(frame.code)
    if message is None:
        return (f"unknown code {frame.code:#06x}", *_in_body(frame.body))
    return (*_in_place(frame, message), *_in_body(frame.body))


def _in_place(frame: Enq | Etb, message: Message) -> Iterator[str]:
    form = frame.body.form
    if message.request in SUB_FORMS and isinstance(frame, Enq) and form is not message.answer:
        yield f"{message.name} needs an ETB packet"
    elif isinstance(frame, Etb) and form not in SUB_FORMS:
        yield f"{message.name} does not travel in an ETB packet"
    elif form is not message.request and form is not message.answer:
        yield f"{form} is no format of {message.name}"


def _in_body(body: Body) -> Iterator[str]:
    for name, attribute, low, high in _RANGES.get(body.form, ()):
        yield from _outside(name, getattr(body, attribute), low, high)
    for name, attribute in _TEXTS.get(body.form, ()):
        yield from _not_ascii(name, getattr(body, attribute))
    if isinstance(body, Jog) and body.opt in (3, 4):
        yield from _outside("VALUE", body.value, 0, 0)
    if isinstance(body, Move | Xmove):
        yield from _in_route(body)


def _in_route(body: Move | Xmove) -> Iterator[str]:
    path = body.path
    length = ELEMENT_SIZE * len(path)
    if isinstance(body, Move):
        length += INFO_SIZE
    if body.length not in (None, length):
        yield f"LENGTH {body.length} does not fit {len(path)} elements ({length})"
    if body.count not in (None, len(path)):
        yield f"COUNT {body.count}, but {len(path)} elements"
    if not path:
        yield "the path is empty"
        return
    if isinstance(body, Move) and path[0].seq != 0:
        yield f"the first SEQ is {path[0].seq}, not 0"
    for before, after in pairwise(path):
        if after.seq != before.seq + 1:
            yield f"SEQ {after.seq} follows {before.seq}"
    for element in path:
        yield from _in_element(element)
    if not Action.STOP <= path[-1].action <= Action.STOP_PORT_UNPREPARED:
        yield "the last element is not a stop"


def _in_element(element: Element) -> Iterator[str]:
    where = f"SEQ {element.seq}: "
    yield from _outside(where + "sensor", element.sensor, 0, 15)
    yield from _outside(where + "action", element.action, Action.RUN, Action.STOP_PORT_UNPREPARED)
    yield from _outside(where + "speed", element.speed, 1, 100)
    yield from _not_ascii(where + "BARCODE", element.barcode)


def _outside(name: str, value: int, low: int, high: int) -> Iterator[str]:
    if not low <= value <= high:
        yield f"{name} {value} is outside {low}..{high}"


def _not_ascii(name: str, value: Barcode) -> Iterator[str]:
    if isinstance(value, str) and not (value.isascii() and value.isprintable()):
        yield f"{name} {value!r} is not printable ASCII"
