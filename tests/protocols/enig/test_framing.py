import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.protocols.enig.codec import Codec
from app.protocols.enig.dialects import DIALECTS, Dialect
from app.protocols.enig.framing import Cut, Decoder, Garbled, Reason
from app.protocols.enig.messages import Frame, MoveAlias, MoveComplete, Raw, Toward
from tests.protocols.enig.frames import frames

CODEC = Codec()
ALIAS = CODEC.packet(11, MoveAlias("B1"))
ALIAS_BYTES = CODEC.encode(ALIAS, Toward.DEVICE)

VECTORS = json.loads((Path(__file__).parents[2] / "vectors" / "sample.json").read_text(encoding="utf-8"))
ADVISED = [v for v in VECTORS["vectors"] if v["protocol"] == "enig" and "frames_before_flush" in v]


def device() -> Decoder:
    return Decoder(CODEC, Toward.DEVICE)


@pytest.mark.parametrize("vector", ADVISED, ids=[vector["id"] for vector in ADVISED])
def test_the_head_candidate_decoder_behaves_as_the_vectors_advise(vector: dict[str, Any]) -> None:
    codec = Codec(Dialect.from_mapping(VECTORS["dialects"][vector["dialect"]]))
    decoder = Decoder(codec, Toward(vector["direction"]))
    before = decoder.feed(bytes.fromhex(vector["hex"]))
    assert sum(isinstance(item, Frame) for item in before) == vector["frames_before_flush"]
    assert decoder.pending == vector.get("pending", 0)
    reasons = {item.reason.value for item in [*before, *decoder.flush()] if isinstance(item, Garbled)}
    assert reasons == set(vector.get("bad", ()))
    assert decoder.pending == 0


@given(data=st.data())
def test_frames_come_out_the_same_however_the_stream_is_cut(data: st.DataObject) -> None:
    codec = Codec(DIALECTS[data.draw(st.sampled_from(sorted(DIALECTS)))])
    toward = data.draw(st.sampled_from(Toward))
    sent = data.draw(st.lists(frames(codec.dialect, toward), max_size=5))
    stream = b"".join(codec.encode(frame, toward) for frame in sent)
    cuts = sorted({0, len(stream), *data.draw(st.lists(st.integers(0, len(stream)), max_size=9))})
    decoder = Decoder(codec, toward)
    assert [item for a, b in pairwise(cuts) for item in decoder.feed(stream[a:b])] == sent
    assert decoder.pending == 0


RUBBISH = st.lists(
    st.one_of(
        st.binary(max_size=40),
        st.sampled_from([b"\2", b"\2\0", b"\2\xff", ALIAS_BYTES, ALIAS_BYTES[:6], ALIAS_BYTES[:-1] + b"\2"]),
    )
).map(b"".join)


@given(name=st.sampled_from(sorted(DIALECTS)), stream=RUBBISH, cut=st.integers(1, 50))
def test_no_sequence_of_bytes_raises_and_every_byte_is_accounted_for(name: str, stream: bytes, cut: int) -> None:
    decoder = Decoder(Codec(DIALECTS[name]), Toward.HOST)
    items = [item for i in range(0, len(stream), cut) for item in decoder.cut(stream[i : i + cut])]
    assert decoder.pending < 261
    items += decoder.cut(b"", idle=True)
    assert decoder.pending == 0
    assert sum(len(item.data) if isinstance(item, Cut) else item.dropped for item in items) == len(stream)


@given(st.integers(0, 8 * len(ALIAS_BYTES) - 1))
def test_a_flipped_bit_never_gives_another_packet_and_the_next_one_is_found(bit: int) -> None:
    broken = (int.from_bytes(ALIAS_BYTES, "big") ^ 1 << bit).to_bytes(len(ALIAS_BYTES), "big")
    decoder = device()
    items = [*decoder.feed(broken + ALIAS_BYTES), *decoder.flush()]
    assert [item for item in items if isinstance(item, Frame)] == [ALIAS]


def test_a_false_head_holds_a_packet_until_the_line_is_silent() -> None:
    decoder = device()
    assert decoder.feed(b"\2\xff" + ALIAS_BYTES) == []
    garbled, frame = decoder.flush()
    assert garbled == Garbled(Reason.TRUNCATED, "11 bytes of a packet, then silence", 2)
    assert frame == ALIAS


def test_len_is_bounded_before_it_is_waited_for() -> None:
    decoder = Decoder(Codec(DIALECTS["max64"]), Toward.DEVICE)
    garbled, frame = decoder.feed(b"\2\x41" + ALIAS_BYTES)
    assert garbled == Garbled(Reason.LENGTH, "LEN 65 is not from 1 to 64", 2)
    assert frame == ALIAS
    assert [item.reason for item in device().feed(b"\2\0") if isinstance(item, Garbled)] == [Reason.LENGTH]


def test_a_packet_without_its_etx_is_none() -> None:
    (garbled,) = device().feed(ALIAS_BYTES[:-1] + b"\4")
    assert garbled == Garbled(Reason.ETX, "byte 04 stands in the place of ETX", 9)


def test_stx_and_etx_inside_a_packet_do_not_cut_it() -> None:
    frame = Frame(11, 200, Raw(bytes([2, 3]) * 127))
    packet = CODEC.encode(frame, Toward.DEVICE, strict=False)
    assert len(packet) == 261
    assert device().feed(packet) == [frame]


def test_the_longest_claim_never_hides_more_than_one_packet_s_worth() -> None:
    decoder = Decoder(CODEC, Toward.HOST)
    packet = CODEC.encode(CODEC.packet(11, MoveComplete("0042")), Toward.HOST)
    items = [item for part in [b"\2\xff", *[packet] * 24] for item in decoder.feed(part)]
    assert sum(isinstance(item, Frame) for item in items) == 24
