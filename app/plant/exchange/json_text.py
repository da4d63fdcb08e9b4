"""JSON that others wrote: read whole, with numbers and names taken out of it tolerantly, each repair noted."""

import json
from math import isfinite
from typing import Any

from app.plant.exchange.numbers import number
from app.plant.exchange.report import Report, UnreadableLayout, shown


def parsed(data: bytes, name: str) -> Any:
    """Return what a JSON file holds. Raises: UnreadableLayout: it is none, with line and column."""
    try:
        text = data.decode("utf-16" if data[:2] in (b"\xff\xfe", b"\xfe\xff") else "utf-8-sig")
    except UnicodeDecodeError as wrong:
        raise UnreadableLayout(
            f"{name} is not UTF-8: {wrong.reason} at byte {wrong.start}", remedy="save it as UTF-8"
        ) from None
    try:
        return json.loads(text)
    except json.JSONDecodeError as wrong:
        cut = wrong.pos >= len(text.rstrip()) - 1
        remedy = "the file ends in the middle: was it copied whole?" if cut else "correct it there"
        what = f"{name} is no JSON: line {wrong.lineno}, column {wrong.colno}: {wrong.msg}"
        raise UnreadableLayout(what, remedy=remedy) from None
    except RecursionError:
        raise UnreadableLayout(f"{name} is nested too deep to be a layout") from None
    except ValueError as wrong:
        raise UnreadableLayout(f"{name} is no JSON that can be read: {shown(wrong)}") from None


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
        if isinstance(given, int | float) and not isinstance(given, bool):
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
        except ValueError as wrong:
            self._report.wrong(self.where, f"{key}: {shown(wrong)}", "correct it")
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
