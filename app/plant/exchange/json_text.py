"""JSON that others wrote: read whole, with numbers and names taken out of it tolerantly, each repair noted."""

import json
from collections import Counter
from collections.abc import Iterator
from math import isfinite
from typing import Any

from app.plant.exchange.numbers import WANTED, number
from app.plant.exchange.report import Report, UnreadableLayout, shown


def parsed(data: bytes, name: str, report: Report) -> Any:
    """Return what a JSON file holds; a key that one object has twice is noted. Raises: UnreadableLayout: it is none, with line
    and column.
    """
    try:
        text = data.decode(json.detect_encoding(data))
    except UnicodeDecodeError as wrong:
        raise UnreadableLayout(
            f"{name} is not UTF-8: byte {wrong.start} fits no letter", remedy="save it as UTF-8"
        ) from None
    try:
        found = json.loads(text, object_pairs_hook=_object)
    except json.JSONDecodeError as wrong:
        cut = wrong.pos >= len(text.rstrip()) - 1
        remedy = "the file ends in the middle: was it copied whole?" if cut else "correct it there"
        what = f"{name} is no JSON: line {wrong.lineno}, column {wrong.colno}: {expected(wrong)}"
        raise UnreadableLayout(what, remedy=remedy) from None
    except RecursionError:
        raise UnreadableLayout(f"{name} is nested too deep to be a layout") from None
    except ValueError:
        raise UnreadableLayout(f"{name} is no JSON that can be read: it has a number of thousands of digits") from None
    for where, key in _doubled(found, ""):
        report.wrong(where or name, f"{shown(key)} is given twice in it: the last one counts", "leave one of them out")
    return found


_EXPECTED = {
    "Expecting value": "a value is expected here",
    "Expecting ',' delimiter": "a comma is expected here, or the end of the list or object",
    "Expecting ':' delimiter": "a colon is expected here, between name and value",
    "Expecting property name enclosed in double quotes": "a name in double quotes is expected here",
    "Illegal trailing comma before end of object": "no comma may stand before the end of an object",
    "Illegal trailing comma before end of array": "no comma may stand before the end of a list",
    "Extra data": "the JSON has ended before this",
    "Unterminated string starting at": "the text that begins here has no closing quotation mark",
    "Invalid control character at": "a line break or control character stands within a text",
    "Invalid \\escape": "this is no escape: a backslash itself is written twice",
    "Invalid \\uXXXX escape": "four hexadecimal digits belong behind this",
}


def expected(wrong: json.JSONDecodeError) -> str:
    """Return what JSON wants where it is broken, in our words."""
    said = next((ours for theirs, ours in _EXPECTED.items() if wrong.msg.startswith(theirs)), "")
    return said or f"this cannot stand here ({wrong.msg})"


class _Twice(dict[str, Any]):
    """An object in which these keys stand more than once."""

    keys_twice: list[str]


def _object(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    whole = dict(pairs)
    if len(whole) == len(pairs):
        return whole
    marked = _Twice(whole)
    marked.keys_twice = [key for key, times in Counter(key for key, _ in pairs).items() if times > 1]
    return marked


def _doubled(value: Any, where: str) -> Iterator[tuple[str, str]]:
    """Give the places of objects that have a key twice, and the key."""
    if isinstance(value, _Twice):
        yield from ((where, key) for key in value.keys_twice)
    if isinstance(value, dict):
        for key, item in value.items():
            yield from _doubled(item, f"{where}.{key}" if where else key)
    elif isinstance(value, list):
        for i, item in enumerate(value):
            yield from _doubled(item, f"{where}[{i}]")


class Item:
    """One object of a JSON file and its place, ``nodes[3] (N4)``."""

    def __init__(self, value: dict[str, Any], where: str, report: Report) -> None:
        self.value, self.where, self._report = value, where, report

    def get(self, key: str) -> Any:
        """Return a value, found also where its name is written otherwise in case; None if there is none."""
        if key in self.value:
            return self.value[key]
        other = next((name for name in self.value if name.casefold() == key.casefold()), None)
        if other is None:
            return None
        self._report.repaired(self.where, f"{shown(other)} is read as {key}")
        return self.value[other]

    def text(self, key: str) -> str:
        """Return a text, empty if there is none; a number is read as one."""
        given = self.get(key)
        if given is None:
            return ""
        if isinstance(given, str):
            return given.strip()
        if isinstance(given, int | float) and not isinstance(given, bool) and isfinite(given):
            self._report.repaired(self.where, f"{key} is a number where a text is meant")
            return str(int(given)) if isinstance(given, float) and given.is_integer() else str(given)
        self._report.wrong(self.where, f"{key} is no text", "write it in quotes")
        return ""

    def number(self, key: str) -> float | None:
        """Return a number, None if there is none; a text is read as one if it is."""
        given = self.get(key)
        if given is None or given == "":
            return None
        try:
            found = number(given)
        except ValueError:
            self._report.wrong(self.where, f"{key}: no number", WANTED, was=given)
            return None
        if isinstance(given, str):
            self._report.repaired(self.where, f"{key} is a text where a number is meant")
        return found if isfinite(found) else None

    def items(self, key: str, name: str = "", *, path: str = "") -> "list[Item]":
        """Return the objects of a list, each with its ``name``; what is none is noted."""
        given = self.get(key)
        if given is None:
            return []
        if isinstance(given, dict) and given:
            self._report.repaired(self.where, f"{key} is one object where a list is meant")
            given = [given]
        if not isinstance(given, list):
            self._report.wrong(self.where, f"{key} is no list", "write it in brackets")
            return []
        return [item for i, value in enumerate(given) if (item := self._item(value, f"{path}{key}[{i}]", name))]

    def _item(self, value: object, where: str, name: str) -> "Item | None":
        if not isinstance(value, dict):
            self._report.wrong(where, "is no object: left out", "write it in braces")
            return None
        named = value.get(name) if name else None
        return Item(value, f"{where} ({shown(named)})" if isinstance(named, str | int) else where, self._report)
