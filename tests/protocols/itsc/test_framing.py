import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DIALECTS, Dialect
from app.protocols.itsc.framing import Decoder, Garbled, Reason
from app.protocols.itsc.messages import NOTHING, Ack, Code, Enq, Etb, Frame, Nak, Raw, Resp1, Status2, Toward
from tests.protocols.itsc.frames import a_move, frames

CODEC = Codec()
REQUEST = Enq(1, 0x100, Code.STATUS, NOTHING)
REQUEST_BYTES = CODEC.encode(REQUEST)
ACK = Ack(1, 0x100)
ACK_BYTES = CODEC.encode(ACK)
MOVE = a_move()
MOVE_BYTES = CODEC.encode(MOVE)

VECTORS = json.loads((Path(__file__).parents[2] / "vectors" / "itsc.json").read_text(encoding="utf-8"))
ADVISED = [vector for vector in VECTORS["vectors"] if "frames_before_flush" in vector]


def vehicle(codec: Codec = CODEC) -> Decoder:
    return Decoder(codec, Toward.VEHICLE)


def everything(decoder: Decoder, *pieces: bytes) -> list[Frame | Garbled]:
    items = [item for piece in pieces for item in decoder.feed(piece)]
    return [*items, *decoder.flush()]


def good(items: list[Frame | Garbled]) -> list[Frame]:
    return [item for item in items if not isinstance(item, Garbled)]


@pytest.mark.parametrize("vector", ADVISED, ids=[vector["id"] for vector in ADVISED])
def test_the_head_candidate_decoder_behaves_as_the_vectors_advise(vector: dict[str, Any]) -> None:
    decoder = Decoder(Codec(Dialect.from_mapping(VECTORS["dialects"][vector["dialect"]])), Toward(vector["direction"]))
    before = decoder.feed(bytes.fromhex(vector["hex"]))
    assert len(good(before)) == vector["frames_before_flush"]
    assert decoder.pending == vector.get("pending", 0)
    items = [*before, *decoder.flush()]
    reasons = {item.reason.value for item in items if isinstance(item, Garbled)}
    assert reasons == set(vector.get("bad", ()))
    assert decoder.pending == 0


@given(data=st.data())
def test_frames_come_out_the_same_however_the_stream_is_cut(data: st.DataObject) -> None:
    codec = Codec(DIALECTS[data.draw(st.sampled_from(sorted(DIALECTS)))])
    toward = data.draw(st.sampled_from(Toward))
    sent = data.draw(st.lists(frames(codec.dialect, toward), max_size=5))
    stream = b"".join(codec.encode(frame) for frame in sent)
    cuts = sorted({0, len(stream), *data.draw(st.lists(st.integers(0, len(stream)), max_size=9))})
    pieces = [stream[a:b] for a, b in pairwise(cuts)]
    decoder = Decoder(codec, toward)
    assert [item for piece in pieces for item in decoder.feed(piece)] == sent
    assert decoder.pending == 0


HEADS = st.sampled_from([b"\x05", b"\x06", b"\x15", b"\x17", b"\x17" + bytes(14) + b"\0\0\0\x05", MOVE_BYTES[:33]])
RUBBISH = st.lists(st.one_of(st.binary(max_size=40), HEADS, st.just(REQUEST_BYTES), st.just(MOVE_BYTES[:60]))).map(
    b"".join
)


@given(name=st.sampled_from(sorted(DIALECTS)), stream=RUBBISH, cut=st.integers(1, 50))
def test_no_sequence_of_bytes_raises_and_every_byte_is_accounted_for(name: str, stream: bytes, cut: int) -> None:
    codec = Codec(DIALECTS[name])
    pieces = [stream[i : i + cut] for i in range(0, len(stream), cut)]
    decoder = Decoder(codec, Toward.CONTROLLER)
    items = everything(decoder, *pieces)
    dropped = sum(item.dropped for item in items if isinstance(item, Garbled))
    kept = sum(len(codec.encode(frame, strict=False)) for frame in good(items))
    assert dropped + kept == len(stream)
    whole = good(everything(Decoder(codec, Toward.CONTROLLER), stream))
    assert good(items) == whole


@given(noise=st.binary(max_size=60))
def test_after_noise_and_silence_the_next_packet_is_read(noise: bytes) -> None:
    decoder = vehicle()
    everything(decoder, noise)
    assert decoder.feed(REQUEST_BYTES) == [REQUEST]


@pytest.mark.parametrize("bit", range(0, 33 * 8, 5))
def test_a_flipped_bit_never_passes(bit: int) -> None:
    broken = bytearray(REQUEST_BYTES)
    broken[bit // 8] ^= 1 << bit % 8
    assert good(everything(vehicle(), bytes(broken))) == []


def test_the_same_code_is_a_request_one_way_and_an_answer_the_other() -> None:
    answer = Enq(1, 2, Code.MOVE, Resp1(0, Status2(), 1203, 2))
    assert Decoder(CODEC, Toward.CONTROLLER).feed(CODEC.encode(answer)) == [answer]
    (other,) = vehicle().feed(CODEC.encode(answer))
    assert isinstance(other, Enq)
    assert isinstance(other.body, Raw)
    assert "MOVE needs an ETB packet" in CODEC.problems(other)


def test_an_unknown_code_is_delivered_raw() -> None:
    frame = Enq(1, 2, 0x9999, Raw(bytes(range(16))))
    data = CODEC.encode(frame, strict=False)
    assert vehicle().feed(data) == Decoder(CODEC, Toward.CONTROLLER).feed(data) == [frame]


@pytest.mark.parametrize(
    ("code", "toward"),
    [(Code.LIFT_DEST_TEACHING, Toward.VEHICLE), (Code.SYSTEM_RESET, Toward.CONTROLLER)],
)
def test_a_code_that_carries_nothing_this_way_is_delivered_raw_with_a_problem(code: Code, toward: Toward) -> None:
    frame = Enq(1, 2, code, Raw(bytes(range(16))))
    data = CODEC.encode(frame, strict=False)
    assert Decoder(CODEC, toward).feed(data) == [frame]
    assert "RAW is no format of" in "".join(CODEC.problems(frame))


def test_an_acknowledgement_and_a_nak_are_told_apart() -> None:
    assert vehicle().feed(ACK_BYTES + CODEC.encode(Nak(1, 2))) == [ACK, Nak(1, 2)]


def test_a_crc_error_says_what_came_and_what_was_expected() -> None:
    (item,) = everything(vehicle(), ACK_BYTES[:-1] + b"\0")
    assert item == Garbled(Reason.CRC, "ACK: CRC 7F00, expected 7F75", 15)


def test_a_broken_sub_packet_drops_the_header_and_looks_into_the_rest() -> None:
    broken = MOVE_BYTES[:33] + REQUEST_BYTES + MOVE_BYTES[66:-1] + b"\0"
    items = vehicle().feed(broken)
    assert items[0] == Garbled(Reason.CRC, f"sub packet: CRC {MOVE_BYTES[-2]:02X}00, expected {_sub_crc(broken)}", 33)
    assert items[1] == REQUEST


def _sub_crc(data: bytes) -> str:
    return f"{CODEC.checksum(data[33:-2]):04X}"


def test_without_a_header_crc_the_whole_packet_is_checked_and_one_byte_dropped() -> None:
    codec = Codec(DIALECTS["etb-one-crc"])
    data = bytearray(codec.encode(a_move()))
    data[40] ^= 1
    items = everything(vehicle(codec), bytes(data) + codec.encode(REQUEST))
    assert good(items) == [REQUEST]
    assert isinstance(items[0], Garbled)
    assert items[0].reason is Reason.CRC
    assert items[0].detail.startswith("ETB: CRC")


def test_without_a_sub_crc_the_path_is_taken_as_it_comes() -> None:
    codec = Codec(DIALECTS["etb-no-sub-crc"])
    data = bytearray(codec.encode(a_move()))
    data[33] ^= 1
    (frame,) = vehicle(codec).feed(bytes(data))
    assert isinstance(frame, Etb)


@pytest.mark.parametrize("name", ["default", "etb-no-sub-crc", "etb-one-crc"])
def test_a_length_beyond_the_bound_is_refused_at_once(name: str) -> None:
    codec = Codec(DIALECTS[name])
    small = Codec(Dialect(etb=codec.dialect.etb, max_sub=75))
    items = vehicle(small).feed(codec.encode(a_move()) + codec.encode(REQUEST))
    assert good(items) == [REQUEST]
    assert isinstance(items[0], Garbled)
    assert (items[0].reason, items[0].detail) == (Reason.LENGTH, "LENGTH 76 is more than 75")


def test_a_noise_run_is_one_report_and_a_crc_error_in_it_gives_the_reason() -> None:
    items = everything(vehicle(), b"\xff\xfe" + ACK_BYTES[:-1] + b"\0" + b"\xfd" * 5 + REQUEST_BYTES)
    assert items == [Garbled(Reason.CRC, "ACK: CRC 7F00, expected 7F75", 22), REQUEST]


def test_bytes_of_any_kind_may_be_fed() -> None:
    assert vehicle().feed(memoryview(REQUEST_BYTES)) == vehicle().feed(bytearray(REQUEST_BYTES)) == [REQUEST]
    decoder = vehicle()
    assert decoder.feed(b"") == []
    assert decoder.feed(memoryview(REQUEST_BYTES)[:5]) == []
    assert decoder.feed(memoryview(REQUEST_BYTES)[5:]) == [REQUEST]


def test_silence_gives_up_the_broken_head_and_finds_the_packet_behind_it() -> None:
    decoder = vehicle()
    assert decoder.feed(REQUEST_BYTES[:10] + ACK_BYTES) == []
    assert decoder.pending == 25
    assert decoder.flush() == [Garbled(Reason.TRUNCATED, "25 of 33 bytes, then silence", 10), ACK]
    assert decoder.flush() == []


def test_a_long_path_fed_byte_by_byte_waits_without_looking() -> None:
    decoder = vehicle()
    for at in range(len(MOVE_BYTES) - 1):
        assert decoder.feed(MOVE_BYTES[at : at + 1]) == []
    assert decoder.feed(MOVE_BYTES[-1:]) == [MOVE]
