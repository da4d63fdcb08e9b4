"""ENIG packets to bytes and back in one dialect (PROTOCOLS 3.1, 3.4).

Reading never fails on content; writing is strict: what ``problems`` finds, or what does not fit, is refused.
"""

from functools import cache

from app.domain.errors import EncodeError
from app.protocols.enig.dialects import ACS, DEFAULT, MAX_TARGET, CrcFrom, Dialect, Order
from app.protocols.enig.messages import BY_CLASS, BY_KEY, Body, DeviceClass, Frame, Message, Raw, Toward, problems
from app.wire.crc import Crc16
from app.wire.layout import FieldError
from app.wire.names import unknown

STX, ETX = 0x02, 0x03
HEAD_SIZE = 4
"""STX, LEN, ID, CMD."""
TAIL_SIZE = 3
"""CRC and ETX."""
AROUND_LEN = 6
"""A packet has so many bytes more than LEN counts."""

checksum = Crc16(0x9E9E, init=0xFFFF, refin=True, refout=True).function()
"""ENIG's CRC (3.4), its table computed from the polynomial (E28). Bit 15 of it is always 0 (E17)."""


def crc_of(packet: bytes, start: CrcFrom, order: Order) -> bytes:
    """Return the two CRC bytes that a whole packet should have in its third and second last place."""
    return checksum(packet[start.offset : -TAIL_SIZE]).to_bytes(2, order)


class Codec:
    """The packets of one dialect. Immutable; share one among all links that speak the dialect."""

    __slots__ = ("_classes", "dialect")

    def __init__(self, dialect: Dialect = DEFAULT) -> None:
        self.dialect = dialect
        self._classes: dict[int, DeviceClass] = {
            **dict.fromkeys(dialect.agv_ids, DeviceClass.AGV),
            **dict.fromkeys(dialect.buffer_ids, DeviceClass.BUFFER),
            **dict.fromkeys(dialect.door_ids, DeviceClass.DOOR),
        }

    def class_of(self, device: int) -> DeviceClass | None:
        """Return what a DeviceType is in this dialect; None for the host and for numbers given to nobody."""
        return self._classes.get(device)

    def message(self, device: int, toward: Toward, cmd: int) -> Message | None:
        """Return the row of the table that a CMD means for this device in this direction."""
        kind = self.class_of(device)
        return None if kind is None else BY_KEY.get((kind, toward, cmd))

    def packet(self, device: int, body: Body) -> Frame:
        """Return the packet that carries a content to or from a device, with ID and Target as the dialect wants them.

        A command that lists no Target has the device's ID in every dialect: nothing else could address it (E3).
        Raises: EncodeError: raw data has no CMD of its own.
        """
        row = BY_CLASS.get(type(body))
        if row is None:
            raise EncodeError("raw data needs a CMD: make the frame yourself")
        if not row.target or self.dialect.target == "omit":
            return Frame(device, row.cmd, body)
        return Frame(ACS if self.dialect.host_id == "acs" else device, row.cmd, body, device)

    def problems(self, frame: Frame, toward: Toward) -> tuple[str, ...]:
        """Return what is wrong with a well-framed packet, in words; empty if it is sound."""
        if self.message(frame.device, toward, frame.cmd) is None:
            return ("unknown command",)
        if isinstance(frame.body, Raw):
            return ("size",)
        # In another dialect's hands the host's ID stands before a Target; here it would address nobody.
        astray = frame.target is not None and frame.target != frame.id and not self._from_host(frame.id)
        return ("target",) * astray + problems(frame.body, self.dialect)

    def encode(self, frame: Frame, toward: Toward, *, strict: bool = True) -> bytes:
        """Return a packet's bytes.

        ``strict=False`` is for simulators and tests: unknown commands, wrong sizes and values that the table does not
        list are allowed. Raises: EncodeError: the packet must not be sent, or a value does not fit its place.
        """
        if strict:
            self._check(frame, toward)
        data = b"" if frame.target is None else _byte("Target", frame.target)
        data += _data(frame.body)
        length = 1 + len(data)
        if length > self.dialect.max_len:
            raise EncodeError(f"LEN {length} is more than {self.dialect.max_len}")
        inner = bytes([STX, length]) + _byte("ID", frame.id) + _byte("CMD", frame.cmd) + data
        crc = crc_of(inner + bytes(TAIL_SIZE), self.dialect.crc_from, self.dialect.crc_order)
        return inner + crc + bytes([ETX])

    def _check(self, frame: Frame, toward: Toward) -> None:
        row = self.message(frame.device, toward, frame.cmd)
        if row is not None and not isinstance(frame.body, Raw | row.cls):
            raise EncodeError(
                f"CMD {frame.cmd} of device {frame.device} is {row.name}, not {type(frame.body).__name__}"
            )
        if wrong := self.problems(frame, toward):
            raise EncodeError(f"device {frame.device}, CMD {frame.cmd}: {', '.join(wrong)}")
        if frame.target is not None and row is not None and not row.target:
            raise EncodeError(f"{row.name} has no Target")

    def decode(self, packet: bytes, toward: Toward) -> Frame:
        """Return the packet that some bytes are, framing and CRC already checked. Never fails on content."""
        number, cmd, data = packet[2], packet[3], packet[HEAD_SIZE:-TAIL_SIZE]
        device = data[0] if data and self._from_host(number) and toward is Toward.DEVICE else number
        row = self.message(device, toward, cmd)
        target = _target(row, data) if row is not None else None
        if row is None or (device != number and target is None):
            return Frame(number, cmd, Raw(data))
        rest = data if target is None else data[1:]
        if row.layout.size not in (None, len(rest)):
            return Frame(number, cmd, Raw(data))
        body: Body | None = row.layout.read(rest)
        return Frame(number, cmd, Raw(data)) if body is None else Frame(number, cmd, body, target)

    def _from_host(self, number: int) -> bool:
        return number == ACS and self.dialect.host_id == "acs"

    def named(self, device: int, toward: Toward, name: str) -> Message:
        """Return the row of a command by its name. Raises: EncodeError: this device has no such command."""
        kind = self.class_of(device)
        rows = {row.name: row for (cls, way, _), row in BY_KEY.items() if cls is kind and way is toward}
        if name not in rows:
            what = kind.value if kind is not None else "device of unknown class"
            raise EncodeError(unknown(f"command {toward.value} of {what} {device}:", name, rows))
        return rows[name]


@cache
def codec_of(dialect: Dialect) -> Codec:
    """Return the one codec of a dialect."""
    return Codec(dialect)


def _target(row: Message, data: bytes) -> int | None:
    """Return the Target byte that stands before a command's content, if there is one (E3)."""
    has = row.target and data and data[0] <= MAX_TARGET and row.layout.size in (None, len(data) - 1)
    return data[0] if has else None


def _data(body: Body) -> bytes:
    if isinstance(body, Raw):
        return body.data
    try:
        return BY_CLASS[type(body)].layout.write(body)
    except FieldError as wrong:
        raise EncodeError(f"{body.name}: {wrong}") from None
    except UnicodeEncodeError as wrong:
        raise EncodeError(f"{body.name}: {wrong.object!r} is no text of single bytes") from None


def _byte(name: str, value: int) -> bytes:
    if not 0 <= value <= 0xFF:
        raise EncodeError(f"{name} {value!r} does not fit: 0..255")
    return bytes([value])
