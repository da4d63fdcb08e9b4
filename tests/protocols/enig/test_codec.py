import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.domain.errors import EncodeError
from app.protocols.enig.codec import Codec, checksum
from app.protocols.enig.dialects import DIALECTS, Dialect
from app.protocols.enig.framing import Decoder, Garbled
from app.protocols.enig.messages import (
    AgvReport,
    Body,
    BufferReport,
    DoorReport,
    Frame,
    Lift,
    Lock,
    MarkStop,
    Move,
    MoveAlias,
    MoveAuto,
    MoveComplete,
    MoveManual,
    Open,
    Raw,
    Stop,
    TagReceived,
    Toward,
)
from tests.protocols.enig.frames import frames

CODEC = Codec()
TARGET = Codec(DIALECTS["target"])
ACS_ID = Codec(DIALECTS["acs-id"])
DOWN, UP = Toward.DEVICE, Toward.HOST

WORKED: list[tuple[Codec, int, Body, Toward, str]] = [
    (CODEC, 11, MoveAlias("B1"), DOWN, "02 03 0B 6B 42 31 49 4B 03"),
    (Codec(DIALECTS["crc-stx"]), 11, MoveAlias("B1"), DOWN, "02 03 0B 6B 42 31 31 58 03"),
    (Codec(DIALECTS["crc-id"]), 11, MoveAlias("B1"), DOWN, "02 03 0B 6B 42 31 B8 76 03"),
    (Codec(DIALECTS["crc-cmd-be"]), 11, MoveAlias("B1"), DOWN, "02 03 0B 6B 42 31 39 99 03"),
    (Codec(DIALECTS["crc-data"]), 11, MoveAlias("B1"), DOWN, "02 03 0B 6B 42 31 D9 5E 03"),
    (Codec(DIALECTS["crc-be"]), 11, MoveAlias("B1"), DOWN, "02 03 0B 6B 42 31 4B 49 03"),
    (TARGET, 11, MoveAlias("B1"), DOWN, "02 04 0B 6B 0B 42 31 5E 37 03"),
    (ACS_ID, 11, MoveAlias("B1"), DOWN, "02 04 00 6B 0B 42 31 68 3E 03"),
    (CODEC, 11, Stop(), DOWN, "02 01 0B 65 E4 21 03"),
    (TARGET, 11, Stop(), DOWN, "02 01 0B 65 E4 21 03"),
    (CODEC, 11, Move("0042"), DOWN, "02 05 0B 64 30 30 34 32 C2 0B 03"),
    (CODEC, 21, Lock(), DOWN, "02 01 15 01 63 4E 03"),
    (CODEC, 30, Open(), DOWN, "02 01 1E 01 6E 58 03"),
    (CODEC, 30, DoorReport(1), UP, "02 02 1E 03 01 E8 07 03"),
    (CODEC, 11, MoveComplete("0042"), UP, "02 05 0B 01 30 30 34 32 77 31 03"),
    (
        CODEC,
        11,
        AgvReport(mode=1, run=1, cart=1, tag="0042", path=1),
        UP,
        "02 0D 0B 03 01 01 00 00 00 01 00 30 30 34 32 01 97 0B 03",
    ),
]


@pytest.mark.parametrize(("codec", "device", "body", "toward", "text"), WORKED)
def test_the_specification_s_worked_packets_are_written_and_read(
    codec: Codec, device: int, body: Body, toward: Toward, text: str
) -> None:
    data = bytes.fromhex(text)
    frame = codec.packet(device, body)
    assert frame.device == device
    assert codec.encode(frame, toward) == data
    assert Decoder(codec, toward).feed(data) == [frame]
    assert codec.problems(frame, toward) == ()


def slow_crc(data: bytes) -> int:
    """The source's algorithm, a bit at a time."""
    crc = 0xFFFF
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x7979 if crc & 1 else 0)
    return crc


@given(st.binary(max_size=300))
def test_the_checksum_is_the_source_s_and_its_bit_15_is_always_clear(data: bytes) -> None:
    assert checksum(data) == slow_crc(data)
    assert not data or checksum(data) < 0x8000


def test_the_checksum_has_the_check_value_and_residue_of_the_reference() -> None:
    assert checksum(b"123456789") == 0x1CD0
    assert checksum(b"123456789" + (0x1CD0).to_bytes(2, "little")) == 0


@given(st.data())
def test_every_packet_of_every_dialect_comes_back_as_it_was(data: st.DataObject) -> None:
    dialect = DIALECTS[data.draw(st.sampled_from(sorted(DIALECTS)))]
    toward = data.draw(st.sampled_from(Toward))
    codec = Codec(dialect)
    frame = data.draw(frames(dialect, toward))
    packet = codec.encode(frame, toward)
    assert Decoder(codec, toward).feed(packet) == [frame]
    assert codec.problems(frame, toward) == ()


def read(codec: Codec, toward: Toward, device: int, cmd: int, data: bytes) -> tuple[Frame, tuple[str, ...]]:
    packet = codec.encode(Frame(device, cmd, Raw(data)), toward, strict=False)
    (frame,) = Decoder(codec, toward).feed(packet)
    assert not isinstance(frame, Garbled)
    return frame, codec.problems(frame, toward)


@pytest.mark.parametrize("codec", [CODEC, TARGET])
def test_a_target_byte_is_read_whether_or_not_the_dialect_sends_it(codec: Codec) -> None:
    for cmd, device, content, body in (
        (100, 12, b"0042", Move("0042")),
        (104, 12, b"\3\2", MoveManual(3, 2)),
        (105, 12, b"", MarkStop()),
        (107, 12, b"C4", MoveAlias("C4")),
        (108, 12, b"\1\2\0", MoveAuto(1, 2, 0)),
        (1, 21, b"", Lock()),
    ):
        assert read(codec, DOWN, device, cmd, content) == (Frame(device, cmd, body), ())
        assert read(codec, DOWN, device, cmd, bytes([device]) + content) == (Frame(device, cmd, body, device), ())


def test_a_target_that_names_another_device_is_a_problem() -> None:
    assert read(CODEC, DOWN, 11, 100, b"\x0c0042") == (Frame(11, 100, Move("0042"), 12), ("target",))
    with pytest.raises(EncodeError, match="target"):
        CODEC.encode(Frame(11, 100, Move("0042"), 12), DOWN)


def test_the_host_s_own_id_needs_a_target_to_address_anybody() -> None:
    assert read(ACS_ID, DOWN, 0, 107, b"\x0bB1") == (Frame(0, 107, MoveAlias("B1"), 11), ())
    assert read(ACS_ID, DOWN, 11, 107, b"B1") == (Frame(11, 107, MoveAlias("B1")), ())
    assert read(ACS_ID, DOWN, 0, 107, b"B1") == (Frame(0, 107, Raw(b"B1")), ("unknown command",))
    assert read(ACS_ID, DOWN, 0, 101, b"\x0b") == (Frame(0, 101, Raw(b"\x0b")), ("unknown command",))
    assert read(CODEC, DOWN, 0, 107, b"\x0bB1") == (Frame(0, 107, Raw(b"\x0bB1")), ("unknown command",))
    assert read(ACS_ID, UP, 0, 3, b"\x1e") == (Frame(0, 3, Raw(b"\x1e")), ("unknown command",))


@pytest.mark.parametrize(
    ("toward", "device", "cmd", "data", "problems"),
    [
        (DOWN, 11, 200, b"", ("unknown command",)),
        (UP, 11, 100, b"0042", ("unknown command",)),
        (UP, 31, 3, b"\1", ("unknown command",)),
        (UP, 20, 3, b"\1", ("unknown command",)),
        (DOWN, 11, 100, b"042", ("size",)),
        (DOWN, 11, 100, b"00042", ("size",)),
        (DOWN, 11, 101, b"\x0b", ("size",)),
        (DOWN, 30, 1, b"\x1e", ("size",)),
        (DOWN, 11, 107, b"", ("size",)),
        (DOWN, 11, 107, b"\x0b", ("size",)),
        (UP, 11, 3, bytes(11), ("size",)),
        (UP, 21, 3, b"", ("size",)),
    ],
)
def test_what_cannot_be_read_is_delivered_raw_with_a_problem(
    toward: Toward, device: int, cmd: int, data: bytes, problems: tuple[str, ...]
) -> None:
    assert read(CODEC, toward, device, cmd, data) == (Frame(device, cmd, Raw(data)), problems)


@pytest.mark.parametrize(
    ("toward", "body", "problems"),
    [
        (DOWN, MoveManual(9, 9), ("direction", "speed")),
        (DOWN, Lift(3), ("action",)),
        (DOWN, MoveAuto(2, 3, 3), ("motor", "magnet", "speed")),
        (DOWN, MoveAlias("B6"), ("alias",)),
        (DOWN, MoveAlias("\xff"), ("alias",)),
        (UP, TagReceived("000\xff"), ("tag",)),
        (UP, TagReceived("\t000"), ("tag",)),
        (
            UP,
            AgvReport(2, 3, 4, 2, 2, 3, 3, "\x00000", 255),
            ("mode", "run", "direction", "inposition", "charge", "cart", "lift", "tag"),
        ),
    ],
)
def test_values_that_the_table_does_not_list_are_read_named_and_not_sent(
    toward: Toward, body: Body, problems: tuple[str, ...]
) -> None:
    frame = CODEC.packet(11, body)
    packet = CODEC.encode(frame, toward, strict=False)
    assert Decoder(CODEC, toward).feed(packet) == [frame]
    assert CODEC.problems(frame, toward) == problems
    with pytest.raises(EncodeError, match=problems[0]):
        CODEC.encode(frame, toward)


def test_a_tag_may_be_of_any_printable_characters() -> None:
    assert CODEC.problems(CODEC.packet(11, TagReceived(" ~00")), UP) == ()


def test_further_aliases_and_ids_can_be_configured() -> None:
    codec = Codec(Dialect.from_mapping({"aliases": {"OVEN": 99}, "agv_ids": [1, 2], "door_ids": [30, 31]}))
    frame = codec.packet(2, MoveAlias("OVEN"))
    assert Decoder(codec, DOWN).feed(codec.encode(frame, DOWN)) == [frame]
    assert codec.problems(codec.packet(2, MoveAlias("B1")), DOWN) == ("alias",)
    assert codec.problems(codec.packet(31, DoorReport(0)), UP) == ()


@pytest.mark.parametrize(
    ("frame", "toward", "complaint"),
    [
        (Frame(21, 100, Move("0042")), DOWN, "unknown command"),
        (Frame(11, 100, Stop()), DOWN, "CMD 100 of device 11 is Move, not Stop"),
        (Frame(11, 101, Stop(), 11), DOWN, "Stop has no Target"),
        (Frame(11, 100, Move("42")), DOWN, "tag"),
        (Frame(11, 100, Raw(b"0042")), DOWN, "size"),
        (Frame(21, 3, BufferReport(256)), UP, "state"),
    ],
)
def test_a_strict_sender_refuses_what_the_table_does_not_allow(frame: Frame, toward: Toward, complaint: str) -> None:
    with pytest.raises(EncodeError, match=complaint):
        CODEC.encode(frame, toward)


@pytest.mark.parametrize(
    ("frame", "complaint"),
    [
        (Frame(11, 100, Move("42")), "tag '42' does not fit: a text of 4 characters"),
        (Frame(11, 104, MoveManual(256, 0)), "direction 256 does not fit"),
        (Frame(11, 107, MoveAlias("버퍼")), "is no text of single bytes"),
        (Frame(256, 101, Stop()), "ID 256 does not fit"),
        (Frame(11, 300, Raw(b"")), "CMD 300 does not fit"),
        (Frame(11, 100, Move("0042"), -1), "Target -1 does not fit"),
        (Frame(11, 200, Raw(bytes(255))), "LEN 256 is more than 255"),
    ],
)
def test_what_has_no_place_in_a_packet_is_refused_even_to_a_lax_sender(frame: Frame, complaint: str) -> None:
    with pytest.raises(EncodeError, match=complaint):
        CODEC.encode(frame, DOWN, strict=False)


def test_raw_data_has_no_packet_of_its_own() -> None:
    with pytest.raises(EncodeError, match="needs a CMD"):
        CODEC.packet(11, Raw(b""))


def test_max_len_bounds_what_is_sent() -> None:
    codec = Codec(DIALECTS["max64"])
    assert len(codec.encode(Frame(11, 200, Raw(bytes(63))), DOWN, strict=False)) == 70
    with pytest.raises(EncodeError, match="LEN 65 is more than 64"):
        codec.encode(Frame(11, 200, Raw(bytes(64))), DOWN, strict=False)
