"""What the test-vector command needs to know of HI (PROTOCOLS section 7)."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any, NoReturn

from app.protocols.hi.codec import bcc
from app.protocols.hi.detect import surviving
from app.protocols.hi.dialects import Bcc, Dialect
from app.protocols.hi.framing import Decoder, Garbled
from app.protocols.hi.plain import Plain, plain_to_bytes, to_plain


class Vectors:
    """Answers a vector's questions in one dialect. Raises: HoistwayError or ValueError: the question makes no sense."""

    def __init__(self, dialect: Mapping[str, Any], _: Mapping[str, Any]) -> None:
        self._dialect = Dialect.from_mapping(dialect)

    def decode(self, pieces: Iterable[bytes]) -> list[Plain]:
        """Return the frames that a fresh decoder gives for these pieces and the silence after them."""
        decoder = Decoder(self._dialect)
        items = [item for piece in pieces for item in decoder.feed(piece)]
        items += decoder.flush()
        return [to_plain(item, self._dialect) for item in items if not isinstance(item, Garbled)]

    def in_our_words(self, wanted: Mapping[str, Any], _: Plain) -> Plain:
        """Return an expected frame as it is: PROTOCOLS leaves no wording open."""
        return dict(wanted)

    def encode(self, frame: Mapping[str, Any], *, strict: bool) -> bytes:
        """Return a frame's bytes. Raises: EncodeError: a sender must not send it."""
        return plain_to_bytes(frame, self._dialect)

    def bits(self, layout: str, word: bytes) -> NoReturn:
        """HI has no status words. Raises: ValueError: always."""
        raise ValueError("HI has no status words")

    def form(self, name: str, data: bytes) -> NoReturn:
        """HI has no forms apart from its packets. Raises: ValueError: always."""
        raise ValueError("HI has no forms")

    def form_bytes(self, name: str, content: Mapping[str, Any]) -> NoReturn:
        """HI has no forms apart from its packets. Raises: ValueError: always."""
        raise ValueError("HI has no forms")

    def crc(self, algorithm: str, data: bytes) -> int:
        """Return the sum over some bytes as it is sent, as a number. Raises: ValueError: no such form of BCC."""
        sent = bcc(data, Bcc(algorithm))
        return sent[0] if algorithm == "raw" else int(sent, 16)

    def detect(self, packets: Sequence[bytes]) -> list[tuple[str]]:
        """Return the forms of BCC that fit all packets."""
        return [(form.value,) for form in surviving(packets, self._dialect)]
