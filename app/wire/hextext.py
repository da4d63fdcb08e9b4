"""Hexadecimal text as people copy it: with blanks, commas, ``0x`` and line ends in between."""

import re

_SKIPPED = re.compile(r"(?:[\s:,|_-]|0[xX](?=[0-9a-fA-F]))+")
_PAIR = re.compile(r"[0-9a-fA-F]{2}")


def parse_hex(text: str) -> bytes:
    """Return the bytes that the text spells.

    Raises: ValueError: a character is no hexadecimal digit, or a byte has only one; the message gives its position,
    counted from 1.
    """
    found = bytearray()
    at = 0
    while at < len(text):
        if skipped := _SKIPPED.match(text, at):
            at = skipped.end()
        elif pair := _PAIR.match(text, at):
            found.append(int(pair.group(), 16))
            at = pair.end()
        else:
            raise ValueError(_complaint(text, at))
    return bytes(found)


def _complaint(text: str, at: int) -> str:
    wrong = next((i for i in (at, at + 1) if i < len(text) and text[i] not in "0123456789abcdefABCDEF"), None)
    if wrong is None or (wrong > at and _SKIPPED.match(text, wrong)):
        return f"half a byte: the digit {text[at]!r} at position {at + 1} has no second one"
    return f"{text[wrong]!r} at position {wrong + 1} is no hexadecimal digit"


def show_hex(data: bytes) -> str:
    """Return the bytes as upper-case pairs with blanks in between."""
    return data.hex(" ").upper()
