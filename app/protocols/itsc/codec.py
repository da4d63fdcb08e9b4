"""iTSC packets to bytes and back, compiled once for each dialect (PROTOCOLS 1.3, 1.6, 1.7).

Reading never fails on content; writing is strict: what ``problems`` finds, or what does not fit its field, is refused.
"""

import struct
from collections.abc import Callable
from typing import Any

from app.domain.errors import EncodeError
from app.protocols.itsc.dialects import DEFAULT, Dialect, EtbLayout
from app.protocols.itsc.forms import ENQ_FORMS, path_layout, route_info_layout
from app.protocols.itsc.messages import (
    ELEMENT_SIZE,
    INFO_SIZE,
    NOTHING,
    Ack,
    Body,
    Element,
    Enq,
    Etb,
    Form,
    Frame,
    Message,
    Move,
    Nak,
    Raw,
    Toward,
    Type,
    Xmove,
    messages_of,
    problems,
)
from app.wire.crc import swapped
from app.wire.layout import FieldError, Layout

DATA_SIZE = 16
"""Bytes of DATA1 to DATA4."""
SHORT_SIZE = 15
"""Bytes of an ACK or NAK."""
HEAD_SIZE = 31
"""Bytes of an ENQ, or of an ETB's header, without the CRC."""
CRC_SIZE = 2
_NO_DATA = bytes(DATA_SIZE)

BodyReader = Callable[[bytes, int], Body]
SubReader = Callable[[bytes, int, int, bytes], Body]


class Codec:
    """The packets of one dialect. Immutable; share one among all devices that speak the dialect."""

    __slots__ = (
        "_element",
        "_forms",
        "_head",
        "_info",
        "_order",
        "_short",
        "_start",
        "_two_words",
        "checksum",
        "dialect",
        "messages",
    )

    def __init__(self, dialect: Dialect = DEFAULT) -> None:
        prefix = ">" if dialect.byte_order == "big" else "<"
        self.dialect = dialect
        self.messages = messages_of(dialect)
        self._order = dialect.byte_order
        self._short = struct.Struct(prefix + "BIQ")
        self._head = struct.Struct(prefix + "BIQH")
        self._two_words = struct.Struct(prefix + "II8x")
        self._start = 0 if dialect.crc_covers_type else 1
        self._forms: dict[Form, Layout[Any]] = {form: make(dialect) for form, make in ENQ_FORMS.items()}
        self._info = route_info_layout(dialect)
        self._element = path_layout(dialect)
        plain = dialect.crc_parameters.function()
        # Everywhere below, a CRC is a number in the order of the other fields.
        self.checksum: Callable[[bytes], int] = (
            plain if dialect.crc_order == dialect.byte_order else lambda data: swapped(plain(data))
        )

    def encode(self, frame: Frame, *, strict: bool = True) -> bytes:
        """Return the packet's bytes, LENGTH and COUNT computed.

        With ``strict`` off, a path, a code or a value that no receiver would accept is written all the same, as far as it
        fits its fields, and LENGTH and COUNT are taken from the frame: for tests and simulators.
        Raises: EncodeError: the frame cannot be sent; the message says why.
        """
        if strict and (wrong := problems(frame, self.messages)):
            raise EncodeError("; ".join(wrong))
        try:
            match frame:
                case Ack():
                    return self._sealed(self._short.pack(Type.ACK, frame.dev_id, frame.cmd_id))
                case Nak():
                    return self._sealed(self._short.pack(Type.NAK, frame.dev_id, frame.cmd_id))
                case Enq():
                    return self._sealed(self._header(Type.ENQ, frame) + self.encode_body(frame.body))
                case Etb():
                    return self._encode_etb(frame)
        except struct.error as wrong_header:
            raise EncodeError(_header_complaint(frame)) from wrong_header

    def ack(self, dev_id: int, cmd_id: int) -> bytes:
        """Return the bytes of an ACK for ids that a decoder gave: the quick way."""
        return self._sealed(self._short.pack(0x06, dev_id, cmd_id))

    def bare(self, dev_id: int, cmd_id: int, code: int) -> bytes:
        """Return the bytes of an ENQ without data, for ids that fit their fields: the quick way."""
        return self._sealed(self._head.pack(0x05, dev_id, cmd_id, code) + _NO_DATA)

    def encode_body(self, body: Body) -> bytes:
        """Return the 16 data bytes of an ENQ. Raises: EncodeError: a value does not fit, or the format needs an ETB."""
        if isinstance(body, Move | Xmove):
            raise EncodeError(f"{body.form} needs an ETB packet")
        if isinstance(body, Raw):
            if len(body.data) != DATA_SIZE or body.sub:
                raise EncodeError(f"raw data has {len(body.data)} bytes and {len(body.sub)} more, not {DATA_SIZE}")
            return body.data
        try:
            return self._forms[body.form].write(body)
        except FieldError as wrong:
            raise EncodeError(f"{body.form}: {wrong}") from None

    def decode_body(self, form: Form, data: bytes) -> Body:
        """Return the content of an ENQ's 16 data bytes in a given format. Raises: ValueError: not 16 bytes, or no ENQ's."""
        if len(data) != DATA_SIZE:
            raise ValueError(f"{len(data)} data bytes, not {DATA_SIZE}")
        if form is not Form.RAW and form not in self._forms and form is not Form.NONE:
            raise ValueError(f"{form} does not fit in an ENQ packet")
        return self._reader(form)(data, 0)

    def problems(self, frame: Frame) -> tuple[str, ...]:
        """Return what is wrong in a well-framed packet of this dialect."""
        return problems(frame, self.messages)

    def message(self, code: int) -> Message | None:
        """Return the message that a code means in this dialect."""
        return self.messages.get(code)

    def body_readers(self, toward: Toward) -> dict[int, BodyReader]:
        """Return, for each code, what reads the data of an ENQ that goes this way; any other code's data is raw."""
        readers: dict[int, BodyReader] = {}
        for code, message in self.messages.items():
            asks = message.from_vehicle is (toward is Toward.CONTROLLER)
            readers[code] = self._reader(message.request if asks else message.answer or Form.RAW)
        return readers

    def sub_readers(self) -> dict[int, SubReader]:
        """Return, for each code with a path, what reads (buffer, offset, LENGTH, the header's data bytes)."""
        readers: dict[Form, SubReader] = {Form.MOVE: self._read_move, Form.XMOVE: self._read_xmove}
        return {code: readers[row.request] for code, row in self.messages.items() if row.request in readers}

    def _reader(self, form: Form) -> BodyReader:
        if form is Form.NONE:
            return lambda _data, _at: NOTHING
        if form in self._forms:
            return self._forms[form].read
        return lambda data, at: Raw(data[at : at + DATA_SIZE])

    def _sealed(self, data: bytes) -> bytes:
        return data + self.checksum(data[self._start :]).to_bytes(CRC_SIZE, self._order)

    def _header(self, kind: Type, frame: Enq | Etb) -> bytes:
        return self._head.pack(kind, frame.dev_id, frame.cmd_id, frame.code)

    def _encode_etb(self, frame: Etb) -> bytes:
        data, sub = self._data_and_sub(frame.body)
        if len(sub) > self.dialect.max_sub:
            raise EncodeError(f"{len(sub)} bytes of sub data, at most {self.dialect.max_sub} (max_sub)")
        head = self._header(Type.ETB, frame) + data
        match self.dialect.etb:
            case EtbLayout.HEAD_CRC_SUB_CRC:
                return self._sealed(head) + sub + self.checksum(sub).to_bytes(CRC_SIZE, self._order)
            case EtbLayout.HEAD_CRC_SUB:
                return self._sealed(head) + sub
            case EtbLayout.HEAD_SUB_CRC:
                return self._sealed(head + sub)

    def _data_and_sub(self, body: Body) -> tuple[bytes, bytes]:
        if isinstance(body, Raw):
            return body.data or self._two_words.pack(len(body.sub), 0), body.sub
        if not isinstance(body, Move | Xmove):
            raise EncodeError(f"{body.form} does not travel in an ETB packet")
        try:
            sub = self._info.write(body) if isinstance(body, Move) else b""
            sub += b"".join([self._element.write(element) for element in body.path])
        except ValueError as wrong:
            raise EncodeError(f"{body.form}: {wrong}") from None
        length = len(sub) if body.length is None else body.length
        count = len(body.path) if body.count is None else body.count
        if not 0 <= length <= self.dialect.max_sub:
            raise EncodeError(f"LENGTH {length}: at most {self.dialect.max_sub} bytes of sub data (max_sub)")
        return self._two_words.pack(length, count), sub[:length].ljust(length, b"\0")

    def _read_move(self, data: bytes, at: int, length: int, head: bytes) -> Move:
        # A LENGTH below 64 cuts the texts short; zeros make up for them, so that reading never fails.
        info: bytes = data[at : at + min(length, INFO_SIZE)].ljust(INFO_SIZE, b"\0")
        move = self._info.read(info)
        move.path = self._read_path(data, at + INFO_SIZE, length - INFO_SIZE)
        move.length, move.count = self._two_words.unpack(head)
        return move

    def _read_xmove(self, data: bytes, at: int, length: int, head: bytes) -> Xmove:
        return Xmove(self._read_path(data, at, length), *self._two_words.unpack(head))

    def _read_path(self, data: bytes, at: int, length: int) -> list[Element]:
        read = self._element.read
        return [read(data, at + ELEMENT_SIZE * i) for i in range(max(0, length) // ELEMENT_SIZE)]


def _header_complaint(frame: Frame) -> str:
    if not 0 <= frame.dev_id < 1 << 32:
        return f"DEV_ID {frame.dev_id!r} does not fit in 32 bits"
    if not 0 <= frame.cmd_id < 1 << 64:
        return f"CMD_ID {frame.cmd_id!r} does not fit in 64 bits"
    return "a field of the header does not fit"
