import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DIALECTS, Dialect
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import (
    NOTHING,
    Ack,
    Body,
    Code,
    Disp,
    Element,
    EncodeError,
    Enq,
    Etb,
    Form,
    Frame,
    Jog,
    Move,
    Nak,
    Port,
    Raw,
    Resp1,
    Resp2,
    Sbuf,
    Status1,
    Status2,
    Teach,
    Toward,
    Xmove,
    status1,
    status2,
)
from app.protocols.itsc.plain import from_plain, to_plain
from tests.protocols.itsc.frames import a_move, frames

CODEC = Codec()
SLIDES = Codec(DIALECTS["slides"])
CODED = Dialect(req_code=0x2050, mzone_code=0x2051, stid_code=0x2052, jog_code=0x2053, infr_code=0x2054)
EVERY = {**DIALECTS, "with codes": CODED, "short ascii": Dialect(barcode_bytes=4, barcode_format="ascii", pad=32)}

MOVING = status1(0x08111134)
RUNNING = status2(0xEF002100)
WAY = [Element(1201, 0, 3, 0, 80), Element(1202, 1, 3, 0, 60), Element(1203, 2, 4, 2, 20)]
WAY_SLIDES = [
    Element(1201, 0, 3, 0, 80, 0, 1500),
    Element(1202, 1, 3, 0, 60, 0, 1500),
    Element(1203, 2, 4, 2, 20, 0, 0),
]
HEADER = "17 00000001 0000000000000002 1044 00000064 00000003 00000000 00000000 1657"
INFO = """464F5550303030313233343500000000 53544B30312D50303200000000000000
          45512D4130312D4C5032000000000000 00000000000000000000000000000000"""
PATH_B = "0000000004B1 0000 3050 0000 0000000004B2 0001 303C 0000 0000000004B3 0002 4214 0000 4A21"
PATH_A = "000004B1 0000 3050 0000 05DC 000004B2 0001 303C 0000 05DC 000004B3 0002 4214 0000 0000 C3E5"
STATES = (Status1(trav=11, shft=1, rota=1, lift=11, slid=11, grip=3, sftb=4), Status2())

WORKED = [
    ("STATUS request", CODEC, Enq(1, 1, Code.STATUS, NOTHING), Toward.VEHICLE,
     "05 00000001 0000000000000001 7030 00000000 00000000 00000000 00000000 4322"),
    ("ACK", CODEC, Ack(1, 1), Toward.CONTROLLER, "06 00000001 0000000000000001 5C65"),
    ("NAK", CODEC, Nak(1, 1), Toward.CONTROLLER, "15 00000001 0000000000000001 8574"),
    ("STATUS answer, B", CODEC, Enq(1, 1, Code.STATUS, Resp2(*STATES, 0, 0)), Toward.CONTROLLER,
     "05 00000001 0000000000000001 7030 0B11BB34 00000000 00000000 00000000 0E63"),
    ("STATUS answer, A", SLIDES, Enq(1, 1, Code.STATUS, Resp2(*STATES, 0, 0, 0)), Toward.CONTROLLER,
     "05 00000001 0000000000000001 7030 0B11BB34 00000000 00000000 00000000 0E63"),
    ("STATUS moving, B", CODEC, Enq(1, 1, Code.STATUS, Resp2(MOVING, RUNNING, 1203, 7)), Toward.CONTROLLER,
     "05 00000001 0000000000000001 7030 08111134 EF002100 0000000004B3 0007 7065"),
    ("STATUS moving, A", SLIDES, Enq(1, 1, Code.STATUS, Resp2(MOVING, RUNNING, 1203, 7, 450)), Toward.CONTROLLER,
     "05 00000001 0000000000000001 7030 08111134 EF002100 000004B3 0007 01C2 E43E"),
    ("MOVE, B", CODEC, Etb(1, 2, Code.MOVE, Move(WAY, "FOUP00012345", "STK01-P02", "EQ-A01-LP2")), Toward.VEHICLE,
     HEADER + INFO + PATH_B),
    ("MOVE, A", SLIDES, Etb(1, 2, Code.MOVE, Move(WAY_SLIDES, "FOUP00012345", "STK01-P02", "EQ-A01-LP2")),
     Toward.VEHICLE, HEADER + INFO + PATH_A),
    ("RESP1 of MOVE", CODEC, Enq(1, 2, Code.MOVE, Resp1(0, status2(0xCF000000), 1203, 2)), Toward.CONTROLLER,
     "05 00000001 0000000000000002 1044 00000000 CF000000 0000000004B3 0002 0FF3"),
    ("PICKUP FROM PORT", CODEC, Enq(1, 3, Code.PICKUP_FROM_PORT, Port(-1520, 900, 1170000, 5, 80)), Toward.VEHICLE,
     "05 00000001 0000000000000003 1046 FFFFFA10 00000384 0011DA50 0000 05 50 10D4"),
    ("LIFT DEST TEACHING", CODEC, Enq(1, 0x8000000000000001, Code.LIFT_DEST_TEACHING, Teach(1170000, 1203)),
     Toward.CONTROLLER, "05 00000001 8000000000000001 2074 00000000 0011DA50 0000000004B3 0000 0109"),
    ("DISPLAY", CODEC, Enq(1, 4, Code.DISPLAY_BY_HOST, Disp(2001, 1, "ZONE BLOCKED")), Toward.VEHICLE,
     f"05 00000001 0000000000000004 50C2 07D1 0001 {b'ZONE BLOCKED'.hex()} 7288"),
]  # fmt: skip


@pytest.mark.parametrize(
    ("codec", "frame", "toward", "text"), [row[1:] for row in WORKED], ids=[row[0] for row in WORKED]
)
def test_the_worked_examples_are_written_and_read_byte_for_byte(
    codec: Codec, frame: Frame, toward: Toward, text: str
) -> None:
    data = bytes.fromhex(text)
    assert codec.encode(frame) == data
    assert Decoder(codec, toward).feed(data) == [frame]


@pytest.mark.parametrize("name", EVERY)
@given(data=st.data())
def test_every_frame_comes_back_as_it_was_sent_in_every_dialect(name: str, data: st.DataObject) -> None:
    codec = Codec(EVERY[name])
    toward = data.draw(st.sampled_from(Toward))
    frame = data.draw(frames(codec.dialect, toward))
    written = codec.encode(frame)
    assert Decoder(codec, toward).feed(written) == [frame]
    assert from_plain(to_plain(frame, codec)) == frame
    assert codec.encode(frame, strict=False) == written


def test_the_quick_ack_is_the_ack() -> None:
    assert CODEC.ack(7, 1 << 63) == CODEC.encode(Ack(7, 1 << 63))


def test_little_endian_puts_the_speed_of_a_transfer_first() -> None:
    little = Codec(DIALECTS["little"])
    assert little.encode_body(Port(-1520, 900, 7, 5, 80)).hex() == "10faffff840300000700000050050000"
    assert little.encode_body(Sbuf(80)).hex() == "00" * 12 + "50000000"


@pytest.mark.parametrize(
    ("name", "sub_at", "size"),
    [("default", 33, 111), ("etb-no-sub-crc", 33, 109), ("etb-one-crc", 31, 109)],
)
def test_the_sub_packet_stands_where_the_dialect_says(name: str, sub_at: int, size: int) -> None:
    data = Codec(DIALECTS[name]).encode(a_move())
    assert len(data) == size
    assert data[sub_at + 64 : sub_at + 76] == bytes.fromhex("0000000004b1 0000 3150 0000")


@pytest.mark.parametrize(
    ("frame", "complaint"),
    [
        (Ack(1 << 32, 1), "DEV_ID 4294967296 does not fit in 32 bits"),
        (Ack(-1, 1), "DEV_ID -1"),
        (Enq(1, 1 << 64, Code.STATUS, NOTHING), "CMD_ID 18446744073709551616 does not fit in 64 bits"),
        (Enq(1, 1, 0x10000, NOTHING), "unknown code"),
        (Enq(1, 1, Code.MOVE, Move(WAY)), "MOVE needs an ETB packet"),
        (Etb(1, 1, Code.STATUS, NOTHING), "does not travel in an ETB packet"),
        (Enq(1, 1, Code.PICKUP_FROM_PORT, Port(1 << 31, 0, 0, 0, 50)), "PORT: shft 2147483648 does not fit"),
        (Enq(1, 1, Code.DISPLAY_BY_HOST, Disp(0, 0, "THIRTEEN CHAR")), "text 'THIRTEEN CHAR' does not fit"),
        (Enq(1, 1, Code.DISTANCE, Raw(b"short")), "raw data has 5 bytes"),
        (Enq(1, 1, Code.LIFT_DEST_TEACHING, Teach(0, 1 << 48)), "barcode"),
        (Enq(1, 1, Code.LIFT_DEST_TEACHING, Teach(0, "1203")), "barcode '1203' does not fit"),
        (Enq(1, 1, Code.STATUS, Resp2(Status1(trav=16), Status2(), 0, 0)), "trav 16 does not fit in four bits"),
        (Etb(1, 1, Code.MOVE, Move(WAY, foup_id="X" * 17)), "foup_id"),
        (Etb(1, 1, Code.MOVE, Move([Element(1 << 48, 0, 0, 1, 50)])), "MOVE: barcode"),
        (Etb(1, 1, Code.MOVE, Move(WAY, length=99)), "LENGTH 99"),
        (
            Etb(1, 1, Code.MOVE, Move([Element(1, i, 0, 1, 50) for i in range(513)])),
            "LENGTH 6220: at most 6208",
        ),
    ],
)
def test_a_strict_sender_refuses_what_no_receiver_would_accept(frame: Frame, complaint: str) -> None:
    with pytest.raises(EncodeError, match=complaint):
        CODEC.encode(frame)


def test_the_longest_path_that_fits_is_sent() -> None:
    assert len(CODEC.encode(Etb(1, 1, Code.MOVE, Move([Element(1, i, 0, 1, 50) for i in range(512)])))) == 35 + 6208


@pytest.mark.parametrize(
    "frame",
    [
        Etb(1, 1, Code.MOVE, Move([Element(1, 3, 0, 6, 0)], length=88, count=5)),
        Etb(1, 1, Code.MOVE, Move([], length=10, count=1)),
        Etb(1, 1, Code.XMOVE, Xmove([], length=5, count=0)),
        Etb(1, 1, 0x1234, Raw(bytes(3) + b"\x02" + bytes(12), b"ab")),
        Enq(1, 1, Code.DISPLAY_BY_HOST, Disp(0, 7, "")),
    ],
)
def test_a_test_may_send_what_is_wrong_and_it_arrives_so(frame: Frame) -> None:
    data = CODEC.encode(frame, strict=False)
    (got,) = Decoder(CODEC, Toward.VEHICLE).feed(data)
    assert isinstance(got, Enq | Etb)
    assert CODEC.problems(got)
    assert CODEC.encode(got, strict=False) == data


@pytest.mark.parametrize(
    ("frame", "complaint"),
    [
        (Etb(1, 1, Code.MOVE, Move(WAY, length=6209)), "LENGTH 6209: at most 6208"),
        (Etb(1, 1, Code.MOVE, Move(WAY, length=100, count=-1)), "a field of the header does not fit"),
        (Etb(1, 1, Code.MOVE, Move([Element(1, 0, 16, 1, 50)])), "sensor 16"),
        (Etb(1, 1, Code.STATUS, NOTHING), "NONE does not travel in an ETB packet"),
        (Enq(1, 1, Code.MOVE, Move(WAY)), "MOVE needs an ETB packet"),
        (Etb(1, 1, 0x1234, Raw(b"", bytes(6209))), "6209 bytes of sub data, at most 6208"),
    ],
)
def test_what_fits_no_field_is_refused_even_from_a_test(frame: Frame, complaint: str) -> None:
    with pytest.raises(EncodeError, match=complaint):
        CODEC.encode(frame, strict=False)


def test_raw_sub_data_alone_gets_a_header() -> None:
    data = CODEC.encode(Etb(1, 1, 0x1234, Raw(b"", b"abc")), strict=False)
    (got,) = Decoder(CODEC, Toward.VEHICLE).feed(data)
    assert got == Etb(1, 1, 0x1234, Raw(bytes.fromhex("00000003") + bytes(12), b"abc"))
    assert from_plain(to_plain(got, CODEC)) == got
    assert from_plain({**to_plain(got, CODEC), "fields": {"data": "616263"}}) == Etb(1, 1, 0x1234, Raw(b"", b"abc"))


def test_a_format_is_read_by_its_name() -> None:
    data = bytes.fromhex("00000002fffffe0c0000000000000000")
    assert CODEC.decode_body(Form.JOG, data) == Jog(2, -500)
    assert CODEC.decode_body(Form.RAW, data) == Raw(data)
    assert CODEC.decode_body(Form.NONE, data) == NOTHING
    with pytest.raises(ValueError, match="15 data bytes"):
        CODEC.decode_body(Form.JOG, data[:15])
    with pytest.raises(ValueError, match="MOVE does not fit in an ENQ"):
        CODEC.decode_body(Form.MOVE, data)


def test_in_document_b_distances_are_left_out() -> None:
    body: Body = Resp1(0, Status2(), 1203, 2, dist=99)
    assert CODEC.encode_body(body) == CODEC.encode_body(Resp1(0, Status2(), 1203, 2))
    assert SLIDES.encode_body(body)[-2:] == b"\0\x63"


def test_a_code_has_its_message() -> None:
    found = CODEC.message(0x7030)
    assert found is not None
    assert found.kind is Code.STATUS
    assert CODEC.message(0x9999) is None


STATUS2_PLAIN = {"mode": 3, "oper": 0, "r": 1, "h": 0, "f": 0, "s": 0, "rsv": 0, "code": 0}
RESP1_PLAIN = {"result": 0, "status2": STATUS2_PLAIN, "barcode": 1, "seq": 0}
ELEMENT_PLAIN = {"barcode": 1, "seq": 0, "sensor": 0, "action": 1, "speed": 50}


@pytest.mark.parametrize(
    ("changes", "complaint"),
    [
        ({"dev_id": "1"}, "dev_id '1' is no whole number"),
        ({"dev_id": None}, "dev_id None"),
        ({"cmd_id": 1.5}, "cmd_id 1.5"),
        ({"cmd_id": None}, "cmd_id None"),
        ({"code": True}, "code True"),
        ({"fields": {**RESP1_PLAIN, "result": "0"}}, "result '0'"),
        ({"fields": {**RESP1_PLAIN, "seq": None}}, "seq None"),
        ({"fields": {**RESP1_PLAIN, "status2": {**STATUS2_PLAIN, "r": 2}}}, "r 2 is neither 0 nor 1"),
        ({"fields": {**RESP1_PLAIN, "status2": {**STATUS2_PLAIN, "rr": 1}}}, "did you mean 'r'"),
        ({"fields": {**RESP1_PLAIN, "status2": {"mode": 3, "oper": 0}}}, "no 'r'"),
        ({"form": "RESP2", "fields": {**RESP1_PLAIN, "status1": {"foup": 2}}}, "no 'rsv'"),
        ({"form": "SBUF", "fields": {"spd": 50.0}}, "spd 50.0"),
        ({"form": "DISP", "fields": {"alarm": 0, "opt": 0, "text": 5}}, "text 5 is no text"),
        ({"form": "NONE", "fields": {"spd": 50}}, "NONE has no fields"),
        ({"type": "ETB", "form": "XMOVE", "fields": {"path": [{**ELEMENT_PLAIN, "sensor": "0"}]}}, "sensor '0'"),
        ({"type": "ETB", "form": "XMOVE", "fields": {"path": [{**ELEMENT_PLAIN, "seq": None}]}}, "seq None"),
        ({"type": "ETB", "form": "XMOVE", "fields": {"path": [3]}}, "no frame"),
    ],
)
def test_a_dictionary_with_a_value_of_the_wrong_kind_is_refused(changes: dict[str, object], complaint: str) -> None:
    plain = {"type": "ENQ", "dev_id": 1, "cmd_id": "1", "code": "0x1044", "form": "RESP1", "fields": RESP1_PLAIN}
    assert Codec().encode(from_plain(plain))
    with pytest.raises(EncodeError, match=complaint):
        from_plain({**plain, **changes})


@pytest.mark.parametrize(
    ("plain", "complaint"),
    [
        ({}, "no 'dev_id'"),
        ({"type": "ENW", "dev_id": 1, "cmd_id": "1"}, "did you mean 'ENQ'"),
        (
            {"type": "ENQ", "dev_id": 1, "cmd_id": "1", "form": "PORTS", "fields": {}, "code": "0x7030"},
            "did you mean 'PORT'",
        ),
        (
            {"type": "ENQ", "dev_id": 1, "cmd_id": "1", "form": "SBUF", "fields": {"speed": 1}, "code": "0x1048"},
            "speed",
        ),
        ({"type": "ACK", "dev_id": 1, "cmd_id": "x"}, "no frame"),
    ],
)
def test_a_dictionary_that_is_no_frame_is_refused_with_the_reason(plain: dict[str, object], complaint: str) -> None:
    with pytest.raises(EncodeError, match=complaint):
        from_plain(plain)
