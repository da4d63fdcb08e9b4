import pytest

from app.protocols.hi.dialects import DEFAULT, DIALECTS, Bcc, Dialect, DialectError, Steps, dialect_named


def test_a_dialect_is_an_overlay_of_the_default() -> None:
    made = Dialect.from_mapping({"bcc": "byte", "input_steps": "bits"})
    assert made == Dialect(bcc=Bcc.BYTE, input_steps=Steps.BITS)
    assert Dialect.from_mapping({"value_digits": 3}, made).bcc is Bcc.BYTE
    assert Dialect.from_mapping({}) == DEFAULT
    assert (DEFAULT.highest_value, DIALECTS["value3"].highest_value) == (9999, 999)


@pytest.mark.parametrize(
    ("mapping", "complaint"),
    [
        ({"bcd": "byte"}, "did you mean 'bcc'"),
        ({"bcc": "crc"}, "bcc 'crc' is none of 'nibble'"),
        ({"value_digits": 5}, "value_digits 5 is none of 3, 4"),
        ({"value_digits": "4"}, "value_digits '4' is none of"),
        ({"input_steps": None}, "input_steps None is none of"),
    ],
)
def test_a_dialect_that_cannot_be_is_refused(mapping: dict[str, object], complaint: str) -> None:
    with pytest.raises(DialectError, match=complaint):
        Dialect.from_mapping(mapping)


def test_presets_are_found_with_and_without_the_prefix() -> None:
    assert dialect_named("hi.bcc-raw") is dialect_named("bcc-raw") is DIALECTS["bcc-raw"]
    with pytest.raises(DialectError, match="did you mean 'bcc-raw'"):
        dialect_named("bcc_raw")
