"""Sixteen-bit CRCs, given by name or by their Rocksoft parameters and computed in C."""

from binascii import crc_hqx
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import cast

import crcmod

CrcFunction = Callable[[bytes], int]

_WIDTH = 16
_MASK = 0xFFFF
_CCITT = 0x1021


@dataclass(frozen=True, slots=True)
class Crc16:
    """One CRC in Rocksoft's terms: ``poly`` without its top bit, ``init`` and ``xorout`` unreflected.

    Raises: ValueError: a parameter has more than 16 bits, or the polynomial is zero.
    """

    poly: int
    init: int = 0
    refin: bool = False
    refout: bool = False
    xorout: int = 0

    def __post_init__(self) -> None:
        for name, value in (("poly", self.poly), ("init", self.init), ("xorout", self.xorout)):
            if not 0 <= value <= _MASK:
                raise ValueError(f"CRC {name} {value:#x} does not fit in 16 bits")
        if self.poly == 0:
            raise ValueError("CRC poly must not be 0")

    def function(self) -> CrcFunction:
        """Return the function that gives this CRC of some bytes."""
        init, xorout = self.init, self.xorout
        if self.poly == _CCITT and not self.refin and not self.refout:
            if xorout:
                return lambda data: crc_hqx(data, init) ^ xorout
            return lambda data: crc_hqx(data, init)
        return self._from_library()

    def _from_library(self) -> CrcFunction:
        # crcmod takes the register as it stands in its own bit order, already exclusive-ored with xorOut.
        start = reflected(self.init) if self.refin else self.init
        if self.refin == self.refout:
            made = crcmod.mkCrcFun(self.poly | 1 << _WIDTH, start ^ self.xorout, self.refin, self.xorout)
            return cast("CrcFunction", made)
        register = cast("CrcFunction", crcmod.mkCrcFun(self.poly | 1 << _WIDTH, start, self.refin, 0))
        xorout = self.xorout
        return lambda data: reflected(register(data)) ^ xorout


def reflected(value: int) -> int:
    """Return a 16-bit value with its bits in reverse order."""
    return int(f"{value:016b}"[::-1], 2)


def swapped(value: int) -> int:
    """Return a 16-bit value with its two bytes exchanged."""
    return (value & 0xFF) << 8 | value >> 8


NAMED: Mapping[str, Crc16] = MappingProxyType(
    {
        "ccitt-false": Crc16(_CCITT, init=0xFFFF),
        "xmodem": Crc16(_CCITT),
        "kermit": Crc16(_CCITT, refin=True, refout=True),
        "x25": Crc16(_CCITT, init=0xFFFF, refin=True, refout=True, xorout=0xFFFF),
        "arc": Crc16(0x8005, refin=True, refout=True),
        "modbus": Crc16(0x8005, init=0xFFFF, refin=True, refout=True),
    }
)
"""The CRCs to try when a specification gives none, under their usual names."""
