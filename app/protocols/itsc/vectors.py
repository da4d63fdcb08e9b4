"""What the test-vector command needs to know of iTSC (PROTOCOLS section 7)."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.detect import surviving
from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import Form, Toward, status1, status2
from app.protocols.itsc.plain import (
    Plain,
    body_from_plain,
    body_to_plain,
    from_plain,
    status1_to_plain,
    status2_to_plain,
    to_plain,
)
from app.wire.crc import NAMED
from app.wire.names import unknown


class Vectors:
    """Answers a vector's questions in one dialect. Raises: HoistwayError or ValueError: the question makes no sense."""

    def __init__(self, dialect: Mapping[str, Any], vector: Mapping[str, Any]) -> None:
        made = Dialect.from_mapping(dialect)
        self._codec = Codec(replace(made, max_sub=vector["max_sub"]) if "max_sub" in vector else made)
        self._toward = Toward(vector.get("direction", Toward.VEHICLE.value))

    def decode(self, pieces: Iterable[bytes]) -> list[Plain]:
        """Return the frames that a fresh decoder gives for these pieces and the silence after them."""
        decoder = Decoder(self._codec, self._toward)
        items = [item for piece in pieces for item in decoder.feed(piece)]
        items += decoder.flush()
        return [to_plain(item, self._codec) for item in items if not isinstance(item, Garbled)]

    def in_our_words(self, wanted: Mapping[str, Any], got: Plain) -> Plain:
        """Return an expected frame as we would have written it, where PROTOCOLS leaves the wording open.

        The raw data of an ETB packet may be the header's 16 bytes, the sub data, or (as we write it) both. A barcode of
        characters may be given as the number that they show. An unknown code is our problem, but need not be theirs.
        """
        ours: Plain = _with_our_barcodes(wanted, got)
        if not wanted.get("problems") and len(got.get("problems", ())) == 1 and self._is_unknown(got["code"]):
            ours["problems"] = got["problems"]
        if got["type"] == ours.get("type") == "ETB" and got["form"] == ours.get("form") == "RAW":
            data: str = got["fields"]["data"]
            if str(ours.get("fields", {}).get("data")).lower() in (data[:32], data[32:]):
                ours["fields"] = got["fields"]
        return ours

    def _is_unknown(self, code: str) -> bool:
        return self._codec.message(int(code, 16)) is None

    def encode(self, frame: Mapping[str, Any], *, strict: bool) -> bytes:
        """Return a frame's bytes. Raises: EncodeError: a sender must not send it."""
        return self._codec.encode(from_plain(frame), strict=strict)

    def bits(self, layout: str, word: bytes) -> tuple[Plain, bytes]:
        """Return a status word's fields, and the word made of them again."""
        if len(word) != 4:
            raise ValueError(f"a status word has 4 bytes, not {len(word)}")
        order = self._codec.dialect.byte_order
        number = int.from_bytes(word, order)
        if layout == "STATUS1":
            first = status1(number)
            return status1_to_plain(first), first.word.to_bytes(4, order)
        if layout == "STATUS2":
            second = status2(number)
            return status2_to_plain(second), second.word.to_bytes(4, order)
        raise ValueError(unknown("layout", layout, ("STATUS1", "STATUS2")))

    def form(self, name: str, data: bytes) -> Plain:
        """Return the content of 16 data bytes."""
        try:
            form = Form(name)
        except ValueError:
            raise ValueError(unknown("form", name, [form.value for form in Form])) from None
        return body_to_plain(self._codec.decode_body(form, data), self._codec.dialect)

    def form_bytes(self, name: str, content: Mapping[str, Any]) -> bytes:
        """Return the 16 data bytes of a content."""
        return self._codec.encode_body(body_from_plain(name, content))

    def crc(self, algorithm: str, data: bytes) -> int:
        """Return a named CRC of some bytes."""
        if algorithm not in NAMED:
            raise ValueError(unknown("crc", algorithm, NAMED))
        return NAMED[algorithm].function()(data)

    def detect(self, packets: Sequence[bytes]) -> list[tuple[str, str, str]]:
        """Return the (CRC, coverage, order) that fit all packets."""
        return [(v.crc, v.coverage, v.order) for v in surviving(packets, self._codec.dialect)]


def _with_our_barcodes(wanted: Any, got: Any, name: str = "") -> Any:
    if isinstance(wanted, Mapping) and isinstance(got, Mapping):
        return {key: _with_our_barcodes(value, got.get(key), key) for key, value in wanted.items()}
    if isinstance(wanted, list) and isinstance(got, list) and len(wanted) == len(got):
        return [_with_our_barcodes(*pair) for pair in zip(wanted, got, strict=True)]
    shown = name == "barcode" and isinstance(got, str) and got.isdecimal() and type(wanted) is int
    return got if shown and int(got) == wanted else wanted
