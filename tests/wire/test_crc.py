import pytest

from app.wire.crc import NAMED, Crc16, reflected, swapped

CHECK = b"123456789"


@pytest.mark.parametrize(
    ("name", "check"),
    [
        ("ccitt-false", 0x29B1),
        ("xmodem", 0x31C3),
        ("kermit", 0x2189),
        ("x25", 0x906E),
        ("arc", 0xBB3D),
        ("modbus", 0x4B37),
    ],
)
def test_each_named_crc_gives_its_published_check_value(name: str, check: int) -> None:
    assert NAMED[name].function()(CHECK) == check


@pytest.mark.parametrize(
    ("crc", "check"),
    [
        (Crc16(0x1021, init=0xFFFF, xorout=0xFFFF), 0xD64E),  # GENIBUS
        (Crc16(0x1021, init=0xB2AA, refin=True, refout=True), 0x63D0),  # RIELLO: init is not its own mirror image
        (Crc16(0x8005), 0xFEE8),  # UMTS
        (Crc16(0x9E9E, init=0xFFFF, refin=True, refout=True), 0x1CD0),
        (Crc16(0x3D65, refin=True, refout=True, xorout=0xFFFF), 0xEA82),  # DNP
    ],
)
def test_rocksoft_parameters_give_the_published_check_value(crc: Crc16, check: int) -> None:
    assert crc.function()(CHECK) == check


def test_reflection_of_the_output_alone_mirrors_the_register() -> None:
    plain = Crc16(0x8005, init=0x1234).function()(CHECK)
    assert Crc16(0x8005, init=0x1234, refout=True, xorout=0x00FF).function()(CHECK) == reflected(plain) ^ 0x00FF


def test_swapping_exchanges_the_two_bytes() -> None:
    assert swapped(0x1234) == 0x3412


@pytest.mark.parametrize(
    "wrong", [{"poly": 0}, {"poly": 0x11021}, {"poly": 1, "init": -1}, {"poly": 1, "xorout": 1 << 16}]
)
def test_parameters_that_do_not_fit_sixteen_bits_are_refused(wrong: dict[str, int]) -> None:
    with pytest.raises(ValueError, match="CRC"):
        Crc16(**wrong)  # type: ignore[arg-type]
