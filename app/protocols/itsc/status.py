"""STATUS1 and STATUS2, the two status words (PROTOCOLS 1.8, 1.9), decoded once for each value seen."""

from dataclasses import dataclass
from enum import IntEnum

_CACHE_LIMIT = 4096
"""Our choice: a fleet shows some hundred different words; a peer that sends noise must not fill the memory."""


class Mode(IntEnum):
    """MODE, STATUS2 bits 31-30. Source: PROTOCOLS 1.9."""

    MANT = 0
    SEMI = 1
    UNDEFINED = 2
    AUTO = 3


class Oper(IntEnum):
    """OPER, STATUS2 bits 29-28. Source: PROTOCOLS 1.9."""

    IDLE = 0
    ALARM = 1
    RUN = 2
    PAUSE = 3


@dataclass(frozen=True, slots=True)
class Status1:
    """The carrier bit and the axes' raw nibbles; an unknown nibble is a number, never an error (I27)."""

    foup: bool = False
    rsv: int = 0
    trav: int = 0
    shft: int = 0
    rota: int = 0
    lift: int = 0
    slid: int = 0
    grip: int = 0
    sftb: int = 0

    @property
    def word(self) -> int:
        """The 32 bits on the wire. Raises: ValueError: a nibble or ``rsv`` (three bits) is too large."""
        word = int(self.foup) << 3 | self.rsv
        if not 0 <= self.rsv <= 7:
            raise ValueError(f"STATUS1 rsv {self.rsv} does not fit in three bits")
        for name in AXES:
            nibble: int = getattr(self, name)
            if not 0 <= nibble <= 15:
                raise ValueError(f"STATUS1 {name} {nibble} does not fit in four bits")
            word = word << 4 | nibble
        return word


AXES = ("trav", "shft", "rota", "lift", "slid", "grip", "sftb")
"""STATUS1's nibbles from bits 27-24 down."""


@dataclass(frozen=True, slots=True)
class Status2:
    """Mode, operation and the four flags; ``code`` is an alarm code if OPER is ALARM, otherwise a process code.

    ``at_barcode`` is R, ``all_home`` H, ``home_known`` F (not the FOUP bit, I51), ``servos_on`` S.
    """

    mode: Mode = Mode.MANT
    oper: Oper = Oper.IDLE
    at_barcode: bool = False
    all_home: bool = False
    home_known: bool = False
    servos_on: bool = False
    rsv: int = 0
    code: int = 0

    @property
    def word(self) -> int:
        """The 32 bits on the wire. Raises: ValueError: ``rsv`` or ``code`` is too large."""
        if not 0 <= self.rsv <= 0xFF:
            raise ValueError(f"STATUS2 rsv {self.rsv} does not fit in eight bits")
        if not 0 <= self.code <= 0xFFFF:
            raise ValueError(f"STATUS2 code {self.code} does not fit in sixteen bits")
        flags = self.at_barcode << 3 | self.all_home << 2 | self.home_known << 1 | self.servos_on
        return self.mode << 30 | self.oper << 28 | flags << 24 | self.rsv << 16 | self.code


KNOWN_STATUS1: dict[int, Status1] = {}
KNOWN_STATUS2: dict[int, Status2] = {}
"""The words seen so far; only for looking up on the hot path, :func:`status1` and :func:`status2` fill them."""


def status1(word: int) -> Status1:
    """Return STATUS1 of a word from 0 to 2^32-1: for the same word usually the very same object."""
    found = KNOWN_STATUS1.get(word)
    if found is None:
        if len(KNOWN_STATUS1) >= _CACHE_LIMIT:
            KNOWN_STATUS1.clear()
        nibbles = [word >> shift & 15 for shift in range(24, -4, -4)]
        found = KNOWN_STATUS1[word] = Status1(bool(word >> 31), word >> 28 & 7, *nibbles)
    return found


def status2(word: int) -> Status2:
    """Return STATUS2 of a word from 0 to 2^32-1: for the same word usually the very same object."""
    found = KNOWN_STATUS2.get(word)
    if found is None:
        if len(KNOWN_STATUS2) >= _CACHE_LIMIT:
            KNOWN_STATUS2.clear()
        found = KNOWN_STATUS2[word] = Status2(
            mode=Mode(word >> 30),
            oper=Oper(word >> 28 & 3),
            at_barcode=bool(word >> 27 & 1),
            all_home=bool(word >> 26 & 1),
            home_known=bool(word >> 25 & 1),
            servos_on=bool(word >> 24 & 1),
            rsv=word >> 16 & 0xFF,
            code=word & 0xFFFF,
        )
    return found


KNOWN_STATUS: dict[int, tuple[Status1, Status2]] = {}
"""The pairs of words seen so far, STATUS1 above STATUS2; only for looking up on the hot path, :func:`statuses` fills it."""


def statuses(words: int) -> tuple[Status1, Status2]:
    """Return STATUS1 and STATUS2 of both words read as one number of 64 bits."""
    found = KNOWN_STATUS.get(words)
    if found is None:
        if len(KNOWN_STATUS) >= _CACHE_LIMIT:
            KNOWN_STATUS.clear()
        found = KNOWN_STATUS[words] = status1(words >> 32), status2(words & 0xFFFF_FFFF)
    return found
