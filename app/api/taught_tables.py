"""Taught values as CSV and JSON files: written safely for spreadsheets, read with every mistake named by its line."""

import csv
import io
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, Any

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError

from app.api.inputs import Id, Pulse
from app.api.problems import Problem, message_of
from app.api.teaching_answers import Version, version_row
from app.domain.layout import Axis
from app.domain.pulses import pulses_of
from app.domain.teaching import Fate, ImportRow, RowFate, Side
from app.domain.units import Pulses
from app.wire.names import unknown

MAX_ROWS = 10_000
"""Most rows of one import (our choice; a fab of 40 bays has some 1,500 ports)."""
OWNER = {Side.DEST: "station", Side.OFFSET: "vehicle"}
VALUES = ("version", "shft", "rota", "lift")
TOLD = ("actor", "source", "at", "reason")
NOT_READ = frozenset({*TOLD, "proposal", "restores", "basis"})
"""Columns of an export that an import passes over."""
_FORMULA = ("=", "+", "-", "@", "\t", "\r")
_WHOLE = re.compile(r"[+-]?[0-9]{1,12}")


def exported(side: Side, rows: Sequence[tuple[str, Version]]) -> str:
    """Return versions as CSV. Text that a spreadsheet would take for a formula begins with an apostrophe there."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\r\n")
    writer.writerow((OWNER[side], *VALUES, *TOLD))
    for name, version in rows:
        shown = version_row(version)
        writer.writerow([_safe(name), *(shown[key] for key in VALUES), *(_safe(str(shown[key])) for key in TOLD)])
    return text.getvalue()


def _safe(text: str) -> str:
    return f"'{text}" if text.startswith(_FORMULA) else text


def _unsafe(text: str) -> str:
    """Undo :func:`_safe`."""
    return text[1:] if text[:1] == "'" and text[1:].startswith(_FORMULA) else text


# -- reading ----------------------------------------------------------------------------------------------------------------


def _number(value: object) -> object:
    """Take a cell: empty means not given; a number as text must be a whole one."""
    if not isinstance(value, str):
        return value
    text = value.strip()
    if not text:
        return None
    if not _WHOLE.fullmatch(text):
        raise ValueError(f"{text[:40]!r} is no whole number")
    return int(text)


Cell = Annotated[Pulse | None, BeforeValidator(_number)]


class Row(BaseModel):
    """One row of a file; an axis left out stays as it is."""

    model_config = ConfigDict(extra="ignore", frozen=True, strict=True)

    name: Id
    version: Annotated[Annotated[int, Field(ge=0, lt=1 << 31)] | None, BeforeValidator(_number)] = None
    shft: Cell = None
    rota: Cell = None
    lift: Cell = None

    def at(self, line: int) -> ImportRow:
        """Return it in the words of the business."""
        values = {axis: getattr(self, axis.value) for axis in Axis}
        pulses = pulses_of({axis: Pulses(value) for axis, value in values.items() if value is not None})
        return ImportRow(line, self.name, pulses, self.version)


@dataclass(frozen=True, slots=True)
class Read:
    """What a file says: rows that could be read, and the mistakes of those that could not."""

    rows: tuple[ImportRow, ...]
    wrong: tuple[RowFate, ...]


def from_csv(side: Side, body: bytes) -> Read:
    """Read a CSV file as exported, or with fewer columns. Raises Problem: it is no such file at all."""
    try:
        text = body.decode("utf-8-sig")
    except UnicodeDecodeError:
        raise Problem("malformed", "The file is not UTF-8.", "Save it as CSV in UTF-8.") from None
    reader = csv.reader(io.StringIO(text, newline=""), strict=True)
    found: list[tuple[int, dict[str, str]]] = []
    try:
        header = [cell.strip().lower() for cell in next(reader, [])]
        _check_header(side, header)
        filled = (cells for cells in reader if any(cell.strip() for cell in cells))
        found.extend((reader.line_num, _cells(header, cells)) for cells in filled)
    except csv.Error as wrong:
        raise Problem(
            "malformed", f"Line {reader.line_num} is no CSV: {wrong}.", "Export a file, and edit that."
        ) from None
    return _read(side, found)


def _cells(header: Sequence[str], cells: Sequence[str]) -> dict[str, str]:
    given = {name: _unsafe(cell) for name, cell in zip(header, cells, strict=False)}
    return given if len(cells) <= len(header) else {**given, "too many": ""}


def _check_header(side: Side, header: Sequence[str]) -> None:
    owner = OWNER[side]
    if owner not in header:
        remedy = f"The first line names the columns: {','.join((owner, *VALUES))}, separated by commas."
        raise Problem("invalid", f"The file has no column {owner}.", remedy, "line 1")
    for name in header:
        if name not in {owner, *VALUES, *NOT_READ}:
            raise Problem("invalid", f"Line 1: {unknown('column', name, (owner, *VALUES))}", field="line 1")
    if len(set(header)) < len(header):
        raise Problem("invalid", "A column stands twice.", "Keep one of them.", "line 1")


def from_json(side: Side, document: object) -> Read:
    """Read ``{"items": [...]}`` as exported; lines count items. Raises Problem: it is nothing of the kind."""
    given = document.get("items") if isinstance(document, Mapping) else document
    if not isinstance(given, list) or not all(isinstance(item, Mapping) for item in given):
        remedy = f'Send {{"items": [{{"{OWNER[side]}": "...", "shft": 0, "rota": 0, "lift": 0}}]}}.'
        raise Problem("invalid", "The body is no list of rows.", remedy, "items")
    return _read(side, enumerate(given, 1))


def _read(side: Side, given: Iterable[tuple[int, Mapping[str, Any]]]) -> Read:
    rows: list[ImportRow] = []
    wrong: list[RowFate] = []
    for count, (line, cells) in enumerate(given):
        if count >= MAX_ROWS:
            raise Problem("too-large", f"The file has more than {MAX_ROWS} rows.", "Send it in parts.")
        name = str(cells.get(OWNER[side], ""))[:64]
        odd = next((key for key in cells if key not in {OWNER[side], *VALUES, *NOT_READ}), None)
        if odd is not None:
            wrong.append(RowFate(line, name, Fate.ERROR, f"there is no column {odd[:40]!r} here", "take it out"))
            continue
        try:
            rows.append(Row.model_validate({**cells, "name": cells.get(OWNER[side])}).at(line))
        except ValidationError as error:
            first = error.errors(include_url=False)[0]
            where = "".join(str(part) for part in first["loc"][:1]).replace("name", OWNER[side])
            wrong.append(RowFate(line, name, Fate.ERROR, f"{where}: {message_of(first)}", "correct the cell"))
    return Read(tuple(rows), tuple(wrong))
