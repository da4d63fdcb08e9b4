"""What the test-vector command needs to know of ENIG (PROTOCOLS section 7)."""

from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from app.protocols.enig.codec import HEAD_SIZE, TAIL_SIZE, Codec, checksum
from app.protocols.enig.detect import surviving
from app.protocols.enig.dialects import ACS, Dialect
from app.protocols.enig.framing import Cut, Decoder
from app.protocols.enig.messages import Toward
from app.protocols.enig.plain import Plain, from_plain, to_plain
from app.wire.names import unknown


class Vectors:
    """Answers a vector's questions in one dialect. Raises: HoistwayError or ValueError: the question makes no sense."""

    def __init__(self, dialect: Mapping[str, Any], vector: Mapping[str, Any]) -> None:
        self._codec = Codec(Dialect.from_mapping(dialect))
        self._toward = Toward(vector.get("direction", Toward.DEVICE.value))

    def decode(self, pieces: Iterable[bytes]) -> list[Plain]:
        """Return the frames that a fresh decoder gives for these pieces and the silence after them."""
        decoder = Decoder(self._codec, self._toward)
        items = [item for piece in pieces for item in decoder.cut(piece)]
        items += decoder.cut(b"", idle=True)
        return [
            to_plain(item.frame, item.data[HEAD_SIZE:-TAIL_SIZE], self._codec, self._toward)
            for item in items
            if isinstance(item, Cut)
        ]

    def in_our_words(self, wanted: Mapping[str, Any], got: Plain) -> Plain:
        """Return an expected frame as we would have written it, where PROTOCOLS leaves the wording open.

        Where the ID byte is the host's, ``id`` may be the device that the Target names. A DATA that does not have its
        command's size may be given whole, as we do, or by what can be read of it; so may that of an alias nobody knows.
        """
        ours: Plain = dict(wanted)
        if got["id"] == ACS and wanted.get("id") == got["fields"].get("target", ACS):
            ours["id"] = ACS
        same = wanted.get("problems") and (wanted.get("id"), wanted.get("cmd")) == (got["id"], got["cmd"])
        if same and str(wanted.get("data", "")).lower() == got["data"]:
            whole = str(wanted.get("fields", {}).get("data")).lower() == got["data"]
            unread = whole and got["name"] == "MoveAlias" and got["problems"]
            if unread or got["problems"] == ["size"]:
                ours["fields"] = got["fields"]
        return ours

    def encode(self, frame: Mapping[str, Any], *, strict: bool) -> bytes:
        """Return a frame's bytes. Raises: EncodeError: a sender must not send it."""
        return self._codec.encode(from_plain(frame, self._codec, self._toward), self._toward, strict=strict)

    def bits(self, layout: str, word: bytes) -> tuple[Plain, bytes]:
        """ENIG has no status words."""
        raise ValueError(f"layout {layout!r}: ENIG has no status words, {word.hex()}")

    def form(self, name: str, data: bytes) -> Plain:
        """ENIG has no forms."""
        raise ValueError(f"form {name!r}: ENIG has no forms, {data.hex()}")

    def form_bytes(self, name: str, content: Mapping[str, Any]) -> bytes:
        """ENIG has no forms."""
        raise ValueError(f"form {name!r}: ENIG has no forms, {content!r}")

    def crc(self, algorithm: str, data: bytes) -> int:
        """Return ENIG's CRC of some bytes."""
        if algorithm != "enig":
            raise ValueError(unknown("crc", algorithm, ("enig",)))
        return checksum(data)

    def detect(self, packets: Sequence[bytes]) -> list[tuple[str, str]]:
        """Return the (coverage, order) that fit all packets."""
        return [(variant.crc_from.value, variant.crc_order) for variant in surviving(packets)]
