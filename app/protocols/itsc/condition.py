"""From the wire's words to the domain's: what the two status words mean, and barcodes as text (PROTOCOLS 1.8, 1.9, I7)."""

from collections.abc import Mapping
from typing import Literal

from app.domain.errors import EncodeError
from app.domain.layout import StationKind
from app.domain.units import Barcode
from app.domain.vehicle import Condition, Mode, Oper

CONDITIONS_KEPT = 4096
"""Our choice: a fleet shows some hundred different pairs of words; a peer that sends noise must not fill the memory."""
BARCODES_KEPT = 131_072
"""Our choice: twice the barcodes of a large plant."""

_NOT_READY = {11: "servo_not_ready", 10: "servo_error", 8: "driving"}
_AXES: tuple[tuple[str, int, Mapping[int, str]], ...] = (
    (
        "trav",
        24,
        _NOT_READY
        | {13: "front_bumper", 12: "rear_bumper", 7: "at_port_sbfl_sbfr", 6: "at_sbfl_sbfr", 5: "at_port_sbfr"}
        | {4: "at_sbfr", 3: "at_port_sbfl", 2: "at_sbfl", 1: "at_stop_tag", 0: "stop"},
    ),
    ("shft", 20, _NOT_READY | {4: "right_limit", 3: "left_limit", 1: "home", 0: "stop"}),
    ("rota", 16, _NOT_READY | {4: "cw_limit", 3: "ccw_limit", 1: "home", 0: "stop"}),
    ("lift", 12, _NOT_READY | {1: "home", 0: "stop"}),
    (
        "slid",
        8,
        _NOT_READY
        | {6: "right_destination", 5: "left_destination", 4: "right_limit", 3: "left_limit"}
        | {2: "right_side", 1: "home", 0: "left_side"},
    ),
    ("grip", 4, {10: "driver_error", 8: "driving", 4: "wide", 3: "close", 1: "open", 0: "stop"}),
    ("sftb", 0, {8: "driving", 4: "raised", 3: "open", 0: "stop"}),
)
"""Name, lowest bit and meanings of STATUS1's nibbles: the union of both documents, B's words first (PROTOCOLS 1.8, I27)."""

_HOME_AXES = (20, 16, 12, 8)
"""Lowest bits of SHFT, ROTA, LIFT and SLID, whose nibble 1 is home."""
_TAGS = ((1, StationKind.PORT), (2, StationKind.SBFL), (4, StationKind.SBFR))
"""TRAV 1-7 as a set of stop positions (PROTOCOLS 1.8)."""

KNOWN_CONDITIONS: dict[int, Condition] = {}
KNOWN_BARCODES: dict[int, Barcode] = {}
"""What has been seen so far; only for looking up on the hot path, :func:`condition_of` and :func:`barcode_text` fill them."""


def condition(status1: int, status2: int) -> Condition:
    """Return what the two words (each 0 to 2^32-1) mean; for the same words usually the very same object.

    The meanings in ``details`` are names in one language-neutral form (``servo_not_ready``); a value without a name is
    its number (I27).
    """
    return condition_of(status1 << 32 | status2)


def condition_of(words: int) -> Condition:
    """Return the condition of STATUS1 and STATUS2 read as one number of 64 bits."""
    found = KNOWN_CONDITIONS.get(words)
    if found is None:
        if len(KNOWN_CONDITIONS) >= CONDITIONS_KEPT:
            KNOWN_CONDITIONS.clear()
        found = KNOWN_CONDITIONS[words] = _read(words >> 32, words & 0xFFFF_FFFF)
    return found


def _read(status1: int, status2: int) -> Condition:
    trav = status1 >> 24 & 15
    all_home = bool(status2 >> 26 & 1)
    return Condition(
        status1=status1,
        status2=status2,
        mode=Mode(status2 >> 30),
        oper=Oper(status2 >> 28 & 3),
        code=status2 & 0xFFFF,
        loaded=bool(status1 >> 31),
        recognised=bool(status2 >> 27 & 1),
        all_home=all_home,
        home_known=bool(status2 >> 25 & 1),
        servos_on=bool(status2 >> 24 & 1),
        travelling=trav == 8,
        at_tag=1 <= trav <= 7,
        tags=frozenset(kind for bit, kind in _TAGS if trav < 8 and trav & bit),
        # 8 is driving, everything above an error, a servo that does not hold, or unknown: none of these is rest.
        at_rest=all(status1 >> bit & 15 < 8 for _, bit, _ in _AXES),
        homed=all_home and all(status1 >> bit & 15 == 1 for bit in _HOME_AXES),
        details=_details(status1, status2),
    )


def _details(status1: int, status2: int) -> tuple[tuple[str, int, str], ...]:
    rows = [("foup", status1 >> 31, "loaded" if status1 >> 31 else "empty"), _number("rsv1", status1 >> 28 & 7)]
    for name, bit, meanings in _AXES:
        value = status1 >> bit & 15
        rows.append((name, value, meanings.get(value, str(value))))
    mode, oper = Mode(status2 >> 30), Oper(status2 >> 28 & 3)
    rows.append(("mode", mode.value, mode.name.lower()))
    rows.append(("oper", oper.value, oper.name.lower()))
    for name, bit in (("at_barcode", 27), ("all_home", 26), ("home_known", 25), ("servos_on", 24)):
        value = status2 >> bit & 1
        rows.append((name, value, "yes" if value else "no"))
    rows.append(_number("rsv2", status2 >> 16 & 0xFF))
    name = "alarm_code" if oper is Oper.ALARM else "process_code"
    rows.append((name, status2 & 0xFFFF, f"0x{status2 & 0xFFFF:04X}"))
    return tuple(rows)


def _number(name: str, value: int) -> tuple[str, int, str]:
    return (name, value, str(value))


def barcode_text(value: int | str) -> Barcode:
    """Return a barcode of the wire as text: a number in decimal, characters as they are (I7)."""
    if isinstance(value, str):
        return Barcode(value)
    found = KNOWN_BARCODES.get(value)
    if found is None:
        if len(KNOWN_BARCODES) >= BARCODES_KEPT:
            KNOWN_BARCODES.clear()
        found = KNOWN_BARCODES[value] = Barcode(str(value))
    return found


def barcode_value(barcode: Barcode, barcode_format: Literal["uint", "ascii"]) -> int | str:
    """Return a barcode as the wire wants it.

    Raises: EncodeError: a number is wanted and this is none, or it is written otherwise than the vehicle's own reports
    would be (leading zeros), so that the two would never match.
    """
    if barcode_format == "ascii":
        return str(barcode)
    if not (barcode.isascii() and barcode.isdigit()) or (barcode[0] == "0" and barcode != "0"):
        raise EncodeError(
            f"barcode {barcode!r} is no decimal number without leading zeros",
            remedy="write it in the plant file as the vehicle reports it, or choose a dialect with barcode_format ascii",
        )
    return int(barcode)
