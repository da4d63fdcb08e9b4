import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.cli.vectors import check
from app.domain.errors import EncodeError
from app.protocols.hi.codec import bcc, encode
from app.protocols.hi.dialects import DEFAULT, DIALECTS, Bcc, Dialect
from app.protocols.hi.framing import Decoder
from app.protocols.hi.messages import (
    NOTHING,
    Ack,
    Cmd,
    Content,
    Frame,
    Inputs,
    Number,
    Refused,
    Role,
    Setting,
    Ssa,
    content_of,
    frame_of,
)
from app.protocols.hi.plain import plain_to_bytes, to_plain
from app.protocols.hi.vectors import Vectors
from tests.protocols.hi.frames import any_frames, known_frames

SAMPLE = json.loads((Path(__file__).parents[2] / "vectors" / "sample.json").read_text(encoding="utf-8"))
VECTORS = [vector for vector in SAMPLE["vectors"] if vector["protocol"] == "hi"]

M, S = Role.MASTER, Role.SLAVE
WORKED = [
    (M, 1, Cmd.RUN, NOTHING, "02 4D 31 52 55 4E 40 23 36 03"),
    (S, 1, Cmd.ACK, Ack(2), "02 53 31 41 43 4B 40 32 23 38 03"),
    (M, 1, Cmd.SET, Number(0x1C), "02 4D 31 53 45 54 40 31 43 23 31 03"),
    (S, 1, Cmd.SET, Setting(0x1C, 123), "02 53 31 53 45 54 40 31 43 26 30 31 32 33 23 33 03"),
    (M, 1, Cmd.SED, Setting(0x1C, 123), "02 4D 31 53 45 44 40 31 43 26 30 31 32 33 23 44 03"),
    (M, 1, Cmd.SSQ, NOTHING, "02 4D 31 53 53 51 40 23 38 03"),
    (S, 1, Cmd.SSA, Ssa(2, 5, 2), "02 53 31 53 53 41 40 32 26 35 26 30 32 23 33 03"),
    (S, 1, Cmd.SSA, Ssa(2, 5, 2, 0, 123456),
     "02 53 31 53 53 41 40 32 26 35 26 30 32 26 30 26 31 32 33 34 35 36 23 34 03"),
    (S, 1, Cmd.SSA, Ssa(4, 0, 12), "02 53 31 53 53 41 40 34 26 30 26 31 32 23 31 03"),
    (S, 1, Cmd.NAK, Refused(), "02 53 31 4E 41 4B 40 23 31 03"),
    (S, 1, Cmd.BSY, Refused(), "02 53 31 42 53 59 40 23 35 03"),
    (M, 3, Cmd.INP, Inputs(1, 0, 0, 1, 0xC), "02 4D 33 49 4E 50 40 31 26 30 26 30 26 31 26 43 23 37 03"),
    (M, 0, Cmd.SRK, NOTHING, "02 4D 30 53 52 4B 40 23 30 03"),
]  # fmt: skip


@pytest.mark.parametrize("vector", VECTORS, ids=[vector["id"] for vector in VECTORS])
def test_each_sample_vector_passes(vector: dict[str, Any]) -> None:
    assert list(check(vector, SAMPLE["dialects"])) == []


@pytest.mark.parametrize(("role", "drive", "cmd", "content", "hexed"), WORKED, ids=lambda value: str(value)[:20])
def test_the_worked_packets_are_written_and_read(
    role: Role, drive: int, cmd: Cmd, content: Content, hexed: str
) -> None:
    frame = frame_of(role, drive, cmd, content)
    assert encode(frame) == bytes.fromhex(hexed)
    assert Decoder().feed(bytes.fromhex(hexed)) == [frame]
    assert content_of(frame) == content


@pytest.mark.parametrize(
    ("form", "sent"), [(Bcc.NIBBLE, b"8"), (Bcc.BYTE, b"C8"), (Bcc.WORD, b"01C8"), (Bcc.RAW, b"\xc8")]
)
def test_the_sum_of_the_worked_example_in_each_form(form: Bcc, sent: bytes) -> None:
    assert bcc(b"M0PDT@#", form) == sent
    assert form.size == len(sent)


@given(data=st.data(), name=st.sampled_from(sorted(DIALECTS)))
def test_what_a_strict_sender_says_is_read_as_it_was_meant(data: st.DataObject, name: str) -> None:
    dialect = DIALECTS[name]
    frame = data.draw(known_frames(dialect))
    content = content_of(frame, dialect)
    assert content is not None
    assert frame_of(frame.role, frame.id, frame.cmd, content, dialect) == frame
    assert Decoder(dialect).feed(encode(frame, dialect)) == [frame]
    plain = to_plain(frame, dialect)
    assert plain_to_bytes(plain, dialect) == encode(frame, dialect)
    assert plain_to_bytes({k: v for k, v in plain.items() if k != "data"}, dialect) == encode(frame, dialect)


@given(frame=any_frames(), name=st.sampled_from(sorted(DIALECTS)))
def test_what_keeps_the_grammar_is_delivered_as_it_is(frame: Frame, name: str) -> None:
    dialect = DIALECTS[name]
    assert Decoder(dialect).feed(encode(frame, dialect)) == [frame]
    assert plain_to_bytes(to_plain(frame, dialect), dialect) == encode(frame, dialect)


@pytest.mark.parametrize(
    ("frame", "complaint"),
    [
        (Frame(M, 16, "RUN"), "id 16 is not from 0 to 15"),
        (Frame(M, -1, "RUN"), "id -1"),
        (Frame(S, 0, "ACK"), "id 0 is not from 1 to 15"),
        (Frame(M, 1, "run"), "not three capital letters"),
        (Frame(M, 1, "RU"), "not three capital letters"),
        (Frame(M, 1, "RUN", ("a&b",)), "data field 'a&b'"),
        (Frame(M, 1, "RUN", ("",)), "data field ''"),
        (Frame(M, 1, "RUN", ("1\n",)), "printable"),
        (Frame(M, 1, "RUN", ("é",)), "printable"),
        (Frame(M, 1, "RUN", ("x" * 250,)), "257 characters; 256 are the most"),
    ],
)
def test_a_packet_that_breaks_the_grammar_is_not_sent(frame: Frame, complaint: str) -> None:
    with pytest.raises(EncodeError, match=complaint.replace("(", r"\(")):
        encode(frame)


@pytest.mark.parametrize(
    ("role", "cmd", "content"),
    [
        (M, Cmd.SET, Number(256)),
        (M, Cmd.SET, Number(-1)),
        (M, Cmd.SED, Setting(0, 10000)),
        (M, Cmd.INP, Inputs(2, 0, 0, 0, 0)),
        (M, Cmd.INP, Inputs(0, 0, 0, 0, 16)),
        (M, Cmd.INP, Inputs(True, 0, 0, 0, 0)),  # noqa: FBT003
        (S, Cmd.ACK, Ack(5)),
        (S, Cmd.SSA, Ssa(0, 8, 0)),
        (S, Cmd.SSA, Ssa(0, 0, 100)),
        (S, Cmd.SSA, Ssa(0, 0, 6)),
        (S, Cmd.SSA, Ssa(4, 0, 17)),
        (S, Cmd.SSA, Ssa(0, 0, 0, 2, 0)),
        (S, Cmd.SSA, Ssa(0, 0, 0, 0, 1_000_000)),
        (S, Cmd.SSA, Ssa(0, 0, 0, 0)),
        (S, Cmd.SSA, Ssa(0, 0, 0, None, 5)),
        (M, Cmd.RUN, Ack(1)),
        (S, Cmd.RUN, NOTHING),
        (M, Cmd.PDT, NOTHING),
    ],
)
def test_a_number_out_of_range_and_a_content_of_another_command_are_not_sent(
    role: Role, cmd: Cmd, content: Content
) -> None:
    with pytest.raises(EncodeError):
        frame_of(role, 1, cmd, content)


def test_three_digits_are_read_everywhere_and_sent_where_the_dialect_says_so() -> None:
    three = DIALECTS["value3"]
    assert frame_of(M, 1, Cmd.SED, Setting(1, 5), three).data == ("01", "005")
    assert content_of(Frame(M, 1, "SED", ("01", "005"))) == Setting(1, 5)
    assert content_of(Frame(M, 1, "SED", ("01", "1005")), three) == Setting(1, 1005)
    with pytest.raises(EncodeError, match="0 to 999"):
        frame_of(M, 1, Cmd.SED, Setting(1, 1000), three)


def test_the_step_inputs_are_a_digit_or_four_bits() -> None:
    bits = DIALECTS["input-bits"]
    inputs = Inputs(1, 0, 0, 1, 0b1100)
    assert frame_of(M, 1, Cmd.INP, inputs, bits).data == ("1", "0", "0", "1", "1100")
    assert content_of(Frame(M, 1, "INP", ("1", "0", "0", "1", "1100"))) is None
    assert content_of(Frame(M, 1, "INP", ("1", "0", "0", "1", "C")), bits) is None


UNFIT = [
    (M, "RUN", ("1",)), (M, "RUN", ("",)), (M, "SET", ()), (M, "SET", ("1",)), (M, "SET", ("1G",)), (M, "SET", ("1c",)),
    (M, "SET", ("01", "0005")), (M, "SED", ("01", "")), (M, "SED", ("01", "12")), (M, "SED", ("01", "-123")),
    (M, "INP", ("1", "0", "0", "2", "C")), (M, "INP", ("1", "0", "0", "1", "G")), (S, "ACK", ()), (S, "ACK", ("2", "2")),
    (S, "NAK", ("5",)), (S, "SET", ("1C",)), (S, "SSA", ("2", "8", "00")), (S, "SSA", ("2", "0", "00", "1")),
    (S, "SSA", ("2", "0", "0A")), (M, "ACK", ("2",)), (S, "RUN", ()), (M, "PDT", ()), (M, "ZZZ", ("1",)),
]  # fmt: skip


@pytest.mark.parametrize(("role", "cmd", "data"), UNFIT)
def test_data_that_do_not_fit_their_command_have_no_content(role: Role, cmd: str, data: tuple[str, ...]) -> None:
    assert content_of(Frame(role, 1, cmd, data)) is None


def test_the_meaning_of_a_status_depends_on_the_mode() -> None:
    assert [Ssa(mode, 0, 5).meaning for mode in range(5)] == ["reciprocating operation"] * 4 + ["UV"]
    assert [Ssa(0, 0, 6).meaning, Ssa(4, 0, 0).meaning, Ssa(4, 0, 17).meaning] == ["?"] * 3


@pytest.mark.parametrize(
    "changes",
    [
        {"role": "X"}, {"role": None}, {"id": "a"}, {"id": "10"}, {"id": 1}, {"id": None}, {"cmd": "run"}, {"data": "1C"},
        {"data": [28]}, {"fields": {"number": 29}}, {"fields": 5},
        {"data": None, "fields": {"number": 28, "value": 1}}, {"data": None, "fields": {"number": "1C"}},
        {"data": None, "cmd": "SETT"}, {"data": None, "fields": None},
    ],
)  # fmt: skip
def test_a_dictionary_that_describes_no_packet_is_not_sent(changes: dict[str, Any]) -> None:
    plain = {"role": "M", "id": "1", "cmd": "SET", "data": ["1C"], "more": False, "fields": {"number": 28}}
    assert plain_to_bytes(plain, DEFAULT)
    with pytest.raises(EncodeError):
        plain_to_bytes({**plain, **changes}, DEFAULT)
    with pytest.raises(EncodeError, match="has no 'role'"):
        plain_to_bytes({}, DEFAULT)


def test_the_vector_runner_is_told_what_hi_does_not_have() -> None:
    answers = Vectors({}, {})
    with pytest.raises(ValueError, match="no status words"):
        answers.bits("STATUS1", bytes(4))
    with pytest.raises(ValueError, match="no forms"):
        answers.form("NONE", bytes(16))
    with pytest.raises(ValueError, match="no forms"):
        answers.form_bytes("NONE", {})
    assert answers.crc("nibble", b"M0PDT@#") == 8
    assert answers.crc("raw", b"M0PDT@#") == 0xC8
    assert answers.crc("word", b"M0PDT@#") == 0x1C8
    assert answers.detect([bytes.fromhex("024d305044544023c803")]) == [("raw",)]


def test_more_than_a_word_of_sum_wraps() -> None:
    assert bcc(b"~" * 600, Bcc.WORD) == b"2750"
    assert Dialect(bcc=Bcc.BYTE).bcc.size == 2
