import pytest

from app.wire.hextext import parse_hex, show_hex


@pytest.mark.parametrize("text", ["0506ff", "05 06 FF", "0x05, 0x06, 0xFF", "05:06:ff\n", "05-06_FF", " 05\t06|ff "])
def test_bytes_are_read_however_people_write_them(text: str) -> None:
    assert parse_hex(text) == b"\x05\x06\xff"


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("05 0g", "'g' at position 5"),
        ("x5", "'x' at position 1"),
        ("05 6", "half a byte: the digit '6' at position 4"),
        ("05 6 07", "half a byte: the digit '6' at position 4"),
    ],
)
def test_a_refusal_names_the_character_and_its_position(text: str, complaint: str) -> None:
    with pytest.raises(ValueError, match=complaint):
        parse_hex(text)


def test_bytes_are_shown_in_pairs() -> None:
    assert show_hex(b"\x05\xff") == "05 FF"
