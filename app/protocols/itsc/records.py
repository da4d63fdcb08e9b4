"""iTSC's packets as records: what they carry, format by format (PROTOCOLS 1.3, 1.6, 1.7).

Plain slotted dataclasses, made once per frame. A barcode is an int in dialects with ``barcode_format`` uint and a str in
ascii; a position in pulses is signed; a speed is in percent.
"""

from dataclasses import dataclass, field
from enum import Enum, IntEnum, StrEnum
from typing import ClassVar

from app.protocols.itsc.status import Status1, Status2

Barcode = int | str

INFO_SIZE = 64
"""Bytes of transport information before the path of a MOVE (1.6)."""
ELEMENT_SIZE = 12
"""Bytes of one path element, in every dialect (1.6)."""


class Type(IntEnum):
    """A packet's first byte (1.3; NAK: I17)."""

    ENQ = 0x05
    ACK = 0x06
    NAK = 0x15
    ETB = 0x17


class Toward(Enum):
    """Where a packet goes. The same code carries the request one way and the answer the other."""

    VEHICLE = "TC>VEH"
    CONTROLLER = "VEH>TC"


class Form(StrEnum):
    """The formats of a packet's data (1.6, 1.7). RAW is our name for data without a known format."""

    NONE = "NONE"
    PORT = "PORT"
    SBUF = "SBUF"
    DISP = "DISP"
    TEACH = "TEACH"
    MOVE = "MOVE"
    XMOVE = "XMOVE"
    RESP1 = "RESP1"
    RESP2 = "RESP2"
    REQ = "REQ"
    MZONE = "MZONE"
    STID = "STID"
    JOG = "JOG"
    INFR = "INFR"
    RAW = "RAW"


SUB_FORMS = frozenset({Form.MOVE, Form.XMOVE})
"""The formats that travel in an ETB packet's sub data."""


class Action(IntEnum):
    """What a path element asks for at its barcode: TRAV_COND bits 11-8 (1.6); 6-15 are undefined."""

    RUN = 0
    STOP = 1
    STOP_PORT = 2
    STOP_SBFL = 3
    STOP_SBFR = 4
    STOP_PORT_UNPREPARED = 5


@dataclass(slots=True)
class Nothing:
    """No data: sixteen zero bytes are sent; what arrives in their place is ignored."""

    form: ClassVar[Form] = Form.NONE


NOTHING = Nothing()


@dataclass(slots=True)
class Port:
    """INST_PORT: target pulses of the three axes, look-down area 0-15, speed 1-100 (1.6, I25)."""

    form: ClassVar[Form] = Form.PORT
    shft: int
    rota: int
    lift: int
    lkdn: int
    spd: int


@dataclass(slots=True)
class Sbuf:
    """INST_SBUF: speed 1-100; the vehicle knows its side buffers (1.6)."""

    form: ClassVar[Form] = Form.SBUF
    spd: int


@dataclass(slots=True)
class Disp:
    """INST_DISP: alarm number, OPT 0 notice or 1 notice with alarm, at most 12 ASCII characters (1.6, I45)."""

    form: ClassVar[Form] = Form.DISP
    alarm: int
    opt: int
    text: str


@dataclass(slots=True)
class Teach:
    """INST_TEACH, from the vehicle: an axis position in pulses, and the current barcode (1.6, I14)."""

    form: ClassVar[Form] = Form.TEACH
    pos: int
    barcode: Barcode


@dataclass(slots=True)
class Element:
    """A path element: barcode to pass, ordinal, TRAV_COND's three parts (1.6).

    ``action`` is one of :class:`Action` (a plain int, since a peer may send 6-15). ``dist_act`` and ``dist_next`` are mm and
    travel in the slides dialect alone (I9); the others leave them out.
    """

    barcode: Barcode
    seq: int
    sensor: int
    action: int
    speed: int
    dist_act: int = 0
    dist_next: int = 0

    @property
    def trav_cond(self) -> int:
        """TRAV_COND's 16 bits. Raises: ValueError: a part has more bits than its place."""
        for name, value, largest in (
            ("sensor", self.sensor, 15),
            ("action", self.action, 15),
            ("speed", self.speed, 255),
        ):
            if not 0 <= value <= largest:
                raise ValueError(f"{name} {value} does not fit: 0..{largest}")
        return self.sensor << 12 | self.action << 8 | self.speed


@dataclass(slots=True)
class Move:
    """INST_MOVE: texts of at most 16 ASCII characters for the vehicle's display, and the path (1.6).

    ``length`` and ``count`` are what a received packet said; a sender leaves them None and they are computed (I15).
    """

    form: ClassVar[Form] = Form.MOVE
    path: list[Element]
    foup_id: str = ""
    source: str = ""
    destination: str = ""
    length: int | None = field(default=None, compare=False)
    count: int | None = field(default=None, compare=False)


@dataclass(slots=True)
class Xmove:
    """INST_XMOVE: the path from the first element to change on (1.6, I13, I16); ``length`` and ``count`` as in Move."""

    form: ClassVar[Form] = Form.XMOVE
    path: list[Element]
    length: int | None = field(default=None, compare=False)
    count: int | None = field(default=None, compare=False)


@dataclass(slots=True)
class Resp1:
    """RESP1: RESULT 0 completed normally, 1 abnormally (1.7). ``dist`` in mm in the slides dialect, else None (I10)."""

    form: ClassVar[Form] = Form.RESP1
    result: int
    status2: Status2
    barcode: Barcode
    seq: int
    dist: int | None = None


@dataclass(slots=True)
class Resp2:
    """RESP2: the vehicle's state (1.7). ``dist`` is mm from the barcode in the slides dialect, else None (I8)."""

    form: ClassVar[Form] = Form.RESP2
    status1: Status1
    status2: Status2
    barcode: Barcode
    seq: int
    dist: int | None = None


@dataclass(slots=True)
class Req:
    """INST_REQ: OPT1 0 access test without PIO handshake or 1 with, OPT2 1 repeat (1.6, I32)."""

    form: ClassVar[Form] = Form.REQ
    opt1: int
    opt2: int


@dataclass(slots=True)
class Mzone:
    """INST_MZONE: a zone (1.6, I33)."""

    form: ClassVar[Form] = Form.MZONE
    zone: int


@dataclass(slots=True)
class Stid:
    """INST_STID: a storage or port id of at most 16 ASCII characters (1.6, I32)."""

    form: ClassVar[Form] = Form.STID
    stid: str


@dataclass(slots=True)
class Jog:
    """INST_JOG: OPT 1 absolute or 2 relative with ``value`` in pulses, 3 and 4 speed moves with ``value`` 0 (1.6, I32)."""

    form: ClassVar[Form] = Form.JOG
    opt: int
    value: int


@dataclass(slots=True)
class Infr:
    """INST_INFR: OPT 0 firmware version, 1-5 an axis' position (1.6, I32)."""

    form: ClassVar[Form] = Form.INFR
    opt: int


@dataclass(slots=True)
class Raw:
    """Data without a known format: the 16 data bytes as they came, and an ETB packet's sub data.

    Of an ETB, ``data`` may be left empty: then LENGTH is computed and COUNT is 0.
    """

    form: ClassVar[Form] = Form.RAW
    data: bytes
    sub: bytes = b""


Body = (
    Nothing | Port | Sbuf | Disp | Teach | Move | Xmove | Resp1 | Resp2 | Req | Mzone | Stid | Jog | Infr | Raw
)  # fmt: skip


@dataclass(slots=True)
class Ack:
    """Received without error; both ids as received (1.2, 1.3)."""

    dev_id: int
    cmd_id: int


@dataclass(slots=True)
class Nak:
    """Send again now (I17); both ids as received."""

    dev_id: int
    cmd_id: int


@dataclass(slots=True)
class Enq:
    """A command, an answer or an event in 33 bytes (1.3). ``code`` is the number on the wire."""

    dev_id: int
    cmd_id: int
    code: int
    body: Body


@dataclass(slots=True)
class Etb:
    """A command with a sub packet (1.3, I5)."""

    dev_id: int
    cmd_id: int
    code: int
    body: Body


Frame = Ack | Nak | Enq | Etb
