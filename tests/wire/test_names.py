import pytest

from app.wire.names import FEW, misspelt, nearest, unknown


def test_the_nearest_name_is_found_in_spite_of_case_and_a_slip() -> None:
    assert nearest("Modbsu", ["arc", "modbus"]) == "modbus"


def test_a_name_like_no_other_has_no_nearest() -> None:
    assert nearest("zzz", ["arc", "modbus"]) is None


def test_a_refusal_offers_the_nearest_name_or_all() -> None:
    assert unknown("crc", "arcc", ["arc", "modbus"]) == "unknown crc 'arcc'; did you mean 'arc'?"
    assert unknown("crc", "zzz", ["modbus", "arc"]) == "unknown crc 'zzz'; known: arc, modbus"


@pytest.mark.parametrize(
    ("name", "meant"),
    [
        ("sb-l2", "SB-L2"),
        ("SBL2", "SB-L2"),
        ("sb_l02", "SB-L2"),
        ("v001", "V001"),
        ("v1", "V001"),
        ("STK01-P0l2", "STK01-P012"),
        ("P9", None),
        ("NOPE", None),
        ("", None),
    ],
)
def test_the_name_that_was_surely_meant_differs_in_case_separators_zeros_or_little_else(
    name: str, meant: str | None
) -> None:
    assert misspelt(name, ["SB-L2", "SB-L3", "V001", "V002", "P1", "STK01-P012"]) == meant


def test_of_several_names_that_sound_the_same_the_one_with_the_same_letters_is_meant_or_none() -> None:
    assert misspelt("p1", ["P01", "P1", "P-1"]) == "P1"
    assert misspelt("p001", ["P01", "P1"]) is None
    assert misspelt("px", ["PX", "pX"]) is None


def test_among_many_names_none_is_looked_for_by_likeness() -> None:
    many = [f"PORT-{number:04d}" for number in range(FEW + 1)]
    assert misspelt("port-7", many) == "PORT-0007"
    assert misspelt("PROT-0007", many) is None
    assert misspelt("PROT-0007", many[:FEW]) == "PORT-0007"
