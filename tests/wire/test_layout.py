from dataclasses import dataclass

import pytest

from app.wire.layout import FieldError, Layout, filler, i32, raw, text, u8, u16, u32, wide, word


@dataclass
class Thing:
    small: int = 1
    middle: int = 2
    large: int = 3
    signed: int = -4
    name: str = "AB"
    number: int = 0x0102
    rest: bytes = b"xy"


FIELDS = (
    u8("small"),
    u16("middle"),
    u32("large"),
    i32("signed"),
    text("name", 4, 0x20),
    wide("number", 6, "big"),
    raw("rest", 2),
    filler(1),
)
LAYOUT = Layout("big", FIELDS, Thing)


def test_a_record_is_written_field_by_field_and_read_back() -> None:
    data = LAYOUT.write(Thing())
    assert data == bytes.fromhex("01 0002 00000003 fffffffc 41422020 000000000102 7879 00")
    assert LAYOUT.size == len(data) == 24
    assert LAYOUT.read(b"??" + data, 2) == Thing()


def test_little_endian_reverses_each_field_and_the_parts_of_a_word() -> None:
    @dataclass
    class Pair:
        high: int
        low: int

    for order, data in (("big", b"\x00\x00\x05\x50"), ("little", b"\x50\x05\x00\x00")):
        layout = Layout(order, word(order, filler(2), u8("high"), u8("low")), Pair, ("high", "low"))  # type: ignore[arg-type]
        assert layout.write(Pair(5, 0x50)) == data
        assert layout.read(data) == Pair(5, 0x50)


def test_a_layout_of_filler_alone_needs_no_fields() -> None:
    class Empty:
        pass

    layout = Layout("big", (filler(3),), Empty)
    assert layout.write(Empty()) == b"\0\0\0"
    assert isinstance(layout.read(b"abc"), Empty)


@pytest.mark.parametrize(
    ("thing", "complaint"),
    [
        (Thing(small=256), "small 256 does not fit: 0..255"),
        (Thing(signed=1 << 31), "signed 2147483648 does not fit: -2147483648..2147483647"),
        (Thing(name="ABCDE"), "name 'ABCDE' does not fit: a text of at most 4 characters"),
        (Thing(name="가"), "name '가' does not fit: a text of at most 4"),
        (Thing(name=7), "name 7 does not fit"),  # type: ignore[arg-type]
        (Thing(number=1 << 48), "number 281474976710656 does not fit: 0..281474976710655"),
        (Thing(rest=b"x"), "rest b'x' does not fit: 2 bytes"),
        (Thing(middle="x"), "middle 'x' does not fit: 0..65535"),  # type: ignore[arg-type]
    ],
)
def test_a_value_that_does_not_fit_is_named(thing: Thing, complaint: str) -> None:
    with pytest.raises(FieldError, match=complaint.replace("..", r"\.\.")):
        LAYOUT.write(thing)


def test_a_property_that_refuses_gives_its_own_reason() -> None:
    def refuse(_value: int) -> int:
        raise ValueError("nibble 16")

    layout = Layout("big", (u32("large", write=refuse),), Thing)
    with pytest.raises(FieldError, match="large 3 does not fit: nibble 16"):
        layout.write(Thing())


def test_reading_text_strips_padding_of_either_kind() -> None:
    @dataclass
    class Name:
        name: str

    layout = Layout("big", (text("name", 6, 0),), Name)
    assert layout.read(b"AB \0 \0") == Name("AB")
    assert layout.read(b" \xffC\0\0\0") == Name(" ÿC")
    assert layout.write(Name("AB")) == b"AB\0\0\0\0"
