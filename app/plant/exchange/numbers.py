"""Numbers as people and programs write them."""

import re
from collections.abc import Iterable
from math import isfinite

_THOUSANDS = re.compile(r"[-+]?[0-9]{1,3}(,[0-9]{3})+(\.[0-9]+)?")
_COMMA = re.compile(r"[-+]?[0-9]*,[0-9]+")
_PLAIN = re.compile(r"[-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]{1,3})?")
_LONGEST = 40
WANTED = "write a number, such as 12500 or 12.5"
"""What helps where there is none."""


def number(value: object, *, comma: bool = False) -> float:
    """Return a number, finite. ``comma``: a comma is the decimal point. Raises: ValueError: it is none, in a sentence."""
    if isinstance(value, bool) or value is None:
        raise ValueError(f"{value!r} is no number")
    if isinstance(value, int | float):
        try:
            found = float(value)
        except OverflowError:
            raise ValueError("the number is too large") from None
    else:
        found = _parsed(str(value).strip().replace(" ", "").replace("\u00a0", "").replace("−", "-"), comma=comma)
    if not isfinite(found):
        raise ValueError(f"{str(value)[:_LONGEST]!r} is no finite number")
    return found


def _parsed(text: str, *, comma: bool) -> float:
    if comma and _COMMA.fullmatch(text):
        text = text.replace(",", ".")
    elif _THOUSANDS.fullmatch(text):
        text = text.replace(",", "")
    if text.lower().lstrip("+-") in {"nan", "inf", "infinity"}:
        return float(text)
    if len(text) > _LONGEST or not _PLAIN.fullmatch(text):
        raise ValueError(f"{text[:_LONGEST]!r} is no number")
    return float(text)


def has_decimal_commas(values: Iterable[object]) -> bool:
    """Whether commas in these values are decimal points: some are no thousands, and none stands beside a point."""
    texts = [value.strip() for value in values if isinstance(value, str) and "," in value]
    return (
        bool(texts)
        and all(_COMMA.fullmatch(text) for text in texts)
        and any(not _THOUSANDS.fullmatch(t) for t in texts)
    )
