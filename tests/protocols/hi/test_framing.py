import json
from itertools import pairwise
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.protocols.hi.codec import LONGEST, encode
from app.protocols.hi.dialects import DIALECTS, Dialect
from app.protocols.hi.framing import MOST_PARTS, Assembler, Decoder, Garbled, Reason
from app.protocols.hi.messages import Frame, Role
from tests.protocols.hi.frames import any_frames

SAMPLE = json.loads((Path(__file__).parents[2] / "vectors" / "sample.json").read_text(encoding="utf-8"))
ADVISED = [v for v in SAMPLE["vectors"] if v["protocol"] == "hi" and "frames_before_flush" in v]
RUN = Frame(Role.MASTER, 1, "RUN")
RUN_BYTES = encode(RUN)
READ = Frame(Role.MASTER, 2, "SET", ("1C",))


def everything(decoder: Decoder, *pieces: bytes) -> list[Frame | Garbled]:
    items = [item for piece in pieces for item in decoder.feed(piece)]
    return [*items, *decoder.flush()]


def good(items: list[Frame | Garbled]) -> list[Frame]:
    return [item for item in items if not isinstance(item, Garbled)]


@pytest.mark.parametrize("vector", ADVISED, ids=[vector["id"] for vector in ADVISED])
def test_the_head_candidate_decoder_behaves_as_the_vectors_advise(vector: dict[str, Any]) -> None:
    decoder = Decoder(Dialect.from_mapping(SAMPLE["dialects"][vector["dialect"]]))
    before = decoder.feed(bytes.fromhex(vector["hex"]))
    assert len(good(before)) == vector["frames_before_flush"]
    assert decoder.pending == vector.get("pending", 0)
    items = [*before, *decoder.flush()]
    reasons = {item.reason.value for item in items if isinstance(item, Garbled)}
    assert reasons == set(vector.get("bad", ()))
    assert decoder.pending == 0


@given(data=st.data(), name=st.sampled_from(sorted(DIALECTS)), sent=st.lists(any_frames(), max_size=5))
def test_frames_come_out_the_same_however_the_stream_is_cut(data: st.DataObject, name: str, sent: list[Frame]) -> None:
    dialect = DIALECTS[name]
    stream = b"".join(encode(frame, dialect) for frame in sent)
    cuts = sorted({0, len(stream), *data.draw(st.lists(st.integers(0, len(stream)), max_size=9))})
    decoder = Decoder(dialect)
    assert [item for a, b in pairwise(cuts) for item in decoder.feed(stream[a:b])] == sent
    assert decoder.pending == 0


BITS = st.sampled_from([b"\x02", b"\x02M", b"\x02M1RUN@", b"\x02S1SET@1C&", b"#", b"\x03", b"\x17", RUN_BYTES])
RUBBISH = st.lists(st.one_of(st.binary(max_size=20), BITS)).map(b"".join)


@given(name=st.sampled_from(sorted(DIALECTS)), stream=RUBBISH, cut=st.integers(1, 20))
def test_no_sequence_of_bytes_raises_and_every_byte_is_accounted_for(name: str, stream: bytes, cut: int) -> None:
    dialect = DIALECTS[name]
    items = everything(Decoder(dialect), *[stream[i : i + cut] for i in range(0, len(stream), cut)])
    dropped = sum(item.dropped for item in items if isinstance(item, Garbled))
    assert dropped + sum(len(encode(frame, dialect)) for frame in good(items)) == len(stream)
    assert good(everything(Decoder(dialect), stream)) == good(items)


@given(noise=st.binary(max_size=60))
def test_after_noise_and_silence_the_next_packet_is_read(noise: bytes) -> None:
    decoder = Decoder()
    everything(decoder, noise)
    assert decoder.feed(RUN_BYTES) == [RUN]


def test_a_second_stx_ends_a_packet_whose_end_was_lost() -> None:
    items = Decoder().feed(RUN_BYTES[:7] + encode(READ))
    assert items == [Garbled(Reason.FORMAT, "STX without a packet of the specified form behind it", 7), READ]


def test_a_packet_with_a_wrong_sum_is_named_and_shown() -> None:
    (item,) = everything(Decoder(), RUN_BYTES[:8] + b"7\x03")
    assert item == Garbled(Reason.BCC, "BCC 37, expected 36", 10, RUN)


def test_a_small_letter_in_the_sum_or_in_the_id_does_not_pass() -> None:
    wide = encode(Frame(Role.MASTER, 10, "SED", ("1C", "0123")))
    assert wide[-2:-1] == b"D"
    assert good(everything(Decoder(), wide[:-2] + b"d\x03")) == []
    assert good(everything(Decoder(), wide.replace(b"MA", b"Ma"))) == []


def test_any_byte_may_be_the_raw_sum_even_stx_and_etx() -> None:
    raw = DIALECTS["bcc-raw"]
    texts = ["~" * n + a + chr(b) for n in range(1, 9) for a in "A_~" for b in range(0x41, 0x7F)]
    frames = [Frame(Role.MASTER, 1, "ZZZ", (text,)) for text in texts]
    packets = {encode(frame, raw)[-2]: frame for frame in frames}
    for wanted in (0x02, 0x03, 0x17):
        assert Decoder(raw).feed(encode(packets[wanted], raw)) == [packets[wanted]]


def test_a_packet_without_end_is_dropped_at_the_limit() -> None:
    decoder = Decoder()
    start = b"\x02M1ZZZ@" + b"x" * (LONGEST - 7)
    assert decoder.feed(start) == []
    assert decoder.pending == LONGEST
    assert [item.reason for item in decoder.feed(b"x") if isinstance(item, Garbled)] == [Reason.FORMAT]
    assert decoder.pending == 0


def test_what_does_not_end_in_etx_or_etb_is_no_packet() -> None:
    (item,) = everything(Decoder(), RUN_BYTES[:9] + b"\x04")
    assert isinstance(item, Garbled)
    assert item.detail == "the packet ends in 04, neither ETX nor ETB"


def part(*data: str, more: bool = True, drive: int = 1) -> Frame:
    return Frame(Role.SLAVE, drive, "SET", data, more)


def test_continued_packets_are_put_together() -> None:
    assembler = Assembler()
    assert assembler.add(part("01", "0005")) == []
    assert assembler.add(part("02", more=False)) == [part("01", "0005", "02", more=False)]
    assert assembler.add(RUN) == [RUN]
    assert assembler.flush() == []


def test_a_continued_packet_that_another_one_breaks_off_is_given_up() -> None:
    assembler = Assembler()
    assembler.add(part("01"))
    broken, whole = assembler.add(part("02", more=False, drive=2))
    assert isinstance(broken, Garbled)
    assert broken.reason is Reason.TRUNCATED
    assert whole == part("02", more=False, drive=2)


def test_more_parts_than_eight_are_given_up() -> None:
    assembler = Assembler()
    items = [item for i in range(MOST_PARTS) for item in assembler.add(part(f"{i:02X}"))]
    assert [type(item) for item in items] == [Garbled]
    assert assembler.add(part("01", more=False)) == [part("01", more=False)]
