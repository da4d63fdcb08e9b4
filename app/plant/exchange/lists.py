"""Barcode lists: tables of marks, track, stations and vehicles, in one table or several."""

from collections import defaultdict

from app.domain.layout import PulseSet, StationKind, VehicleKind
from app.domain.units import Pulses
from app.plant.exchange.columns import (
    BACKWARD,
    BOTH,
    CHARGER_WORDS,
    FALSE,
    KIND_OF,
    ONE_WAY,
    PARK_WORDS,
    TRUE,
    fold,
)
from app.plant.exchange.draft import Area, Charge, Draft, Machine, Place, Spot, Way
from app.plant.exchange.numbers import WANTED, has_decimal_commas, number
from app.plant.exchange.report import Report, UnreadableLayout, shown
from app.plant.exchange.sheets import Row, Table, letters
from app.plant.exchange.units import Reading, scale, settle_speeds

_SEPARATORS = ",;/|"


class Rows:
    """One table's cells by role."""

    def __init__(self, table: Table, report: Report) -> None:
        self.table, self._report = table, report
        self._at: defaultdict[str, list[int]] = defaultdict(list)
        for column in table.columns:
            self._at[column.role].append(column.index)
        self.unit = {column.role: column.unit for column in table.columns}
        self.name = {column.role: column.name for column in table.columns}
        self._comma = {
            role: has_decimal_commas(row[i] for _, row in table.rows for i in places if i < len(row))
            for role, places in self._at.items()
        }

    def text(self, row: Row, role: str) -> str:
        """Return a cell as text, a whole number without its ``.0``; empty where there is none."""
        return next((_text(row[i]) for i in self._at.get(role, ()) if i < len(row)), "")

    def texts(self, row: Row, role: str) -> list[str]:
        """Return what all columns of a role hold, several names in a cell apart; names of stations may have spaces."""
        cells = [_text(row[i]) for i in self._at.get(role, ()) if i < len(row)]
        return [name for cell in cells for name in (_names(cell) if role == "next" else _apart(cell))]

    def number(self, at: int, row: Row, role: str) -> float | None:
        """Return a cell's number, None where there is none; what is no number is noted."""
        given = self.text(row, role)
        return None if not given else self.parsed(at, given, role)

    def parsed(self, at: int, given: str, role: str) -> float | None:
        """Return a text of this column as a number, None with a note if it is none."""
        try:
            return number(given, comma=self._comma.get(role, False))
        except ValueError:
            self.wrong(at, role, given, "no number", WANTED)
            return None

    def wrong(self, at: int, role: str, given: str, what: str, remedy: str) -> None:
        """Note that a cell of this column holds what it cannot mean."""
        column = f"column {letters(self._at[role][0])} ({shown(self.name[role])})"
        self._report.wrong(self.table.where(at), f"{column}: {what}", remedy, was=given)


def _text(cell: object) -> str:
    if isinstance(cell, float) and cell.is_integer():
        return str(int(cell))
    if isinstance(cell, bool):
        return str(cell).lower()
    return str(cell).strip()


def _names(cell: str) -> list[str]:
    return [name for part in _apart(cell) for name in part.split()]


def _apart(cell: str) -> list[str]:
    for separator in _SEPARATORS:
        cell = cell.replace(separator, "\n")
    return [part.strip() for part in cell.split("\n") if part.strip()]


def draft_of(tables: list[Table], reading: Reading, report: Report) -> Draft:
    """Return the layout that tables describe. Raises: UnreadableLayout: none of them has barcodes with positions."""
    draft = Draft()
    sheets = [Rows(table, report) for table in tables]
    marks = [rows for rows in sheets if rows.table.has("barcode", "x", "y")]
    if not marks:
        missing = [role for role in ("barcode", "x", "y") if not any(rows.table.has(role) for rows in sheets)]
        what = f"no table has barcodes with positions: no column is understood as {', '.join(missing) or 'all three'}"
        raise UnreadableLayout(what, remedy="name the columns barcode, x and y (바코드, X, Y), in one table")
    for rows in sheets:
        for name in rows.table.unknown:
            report.left_out(f"{rows.table.name} {shown(name)}".strip(), "a column that is not understood")
        _read(draft, rows, report)
    if not draft.ways:
        _in_order(draft, reading, report)
    positions = next((rows.unit.get("x") or rows.unit.get("y") for rows in marks), "") or ""
    scale(draft, positions, _named_unit(sheets, "length"), reading, report)
    settle_speeds(draft, _named_unit(sheets, "speed"), report)
    kinds = {place.kind for place in draft.places}
    if StationKind.AGV_BUFFER in kinds or draft.charges:
        draft.kind = VehicleKind.AGV
    report.read |= {
        "barcodes": len(draft.spots),
        "pieces of track": len(draft.ways),
        "stations": len(draft.places),
        "vehicles": len(draft.machines),
    }
    return draft


def _named_unit(sheets: list[Rows], role: str) -> str:
    return next((rows.unit[role] for rows in sheets if rows.unit.get(role)), "")


def _read(draft: Draft, rows: Rows, report: Report) -> None:
    table = rows.table
    if table.has("from", "to"):
        for at, row in table.rows:
            _read_edge(draft, rows, at, row, report)
    elif table.has("vehicle"):
        for at, row in table.rows:
            _read_machine(draft, rows, at, row, report)
    elif table.has("barcode"):
        if not table.has("x", "y") and not table.has("next") and not table.has("station"):
            report.left_out(table.name, "a table that says nothing about its barcodes")
        for at, row in table.rows:
            _read_mark(draft, rows, at, row, report)
    else:
        report.left_out(table.name, "a table without barcodes")


def _read_mark(draft: Draft, rows: Rows, at: int, row: Row, report: Report) -> None:
    where, name = rows.table.where(at), rows.text(row, "barcode")
    if not name:
        report.wrong(where, "the row has no barcode: left out", "fill in the barcode")
        return
    word = fold(rows.text(row, "kind"))
    if rows.table.has("x", "y"):
        x, y = rows.number(at, row, "x"), rows.number(at, row, "y")
        if x is None or y is None:
            if not rows.text(row, "x") or not rows.text(row, "y"):
                report.wrong(where, "the barcode has no position: left out", "fill in x and y")
            return
        park = _truth(rows, at, row, "park") or word in PARK_WORDS
        draft.spots.append(Spot(name, x, y, where, park))
    _read_next(draft, rows, at, row, report)
    _read_station(draft, rows, at, row, report)
    _read_zone(draft, rows, at, row)


def _read_next(draft: Draft, rows: Rows, at: int, row: Row, report: Report) -> None:
    name, onward = (
        rows.text(row, "barcode"),
        [n for n in rows.texts(row, "next") if n not in {"-", "none", "end", "없음"}],
    )
    cell = rows.text(row, "length")
    lengths = _names(cell) if len(onward) > 1 and len(_names(cell)) == len(onward) else [cell] * len(onward)
    if len(onward) > 1 and cell and len(set(lengths)) == 1 and len(_names(cell)) == 1:
        report.assumed(
            rows.table.where(at), "one length for several ways on: it is taken for each", "give one for each"
        )
    for end, given in zip(onward, lengths, strict=True):
        length = rows.parsed(at, given, "length") if given else None
        _add_ways(draft, rows, at, row, (name, end), length, report)


def _read_edge(draft: Draft, rows: Rows, at: int, row: Row, report: Report) -> None:
    start, end = rows.text(row, "from"), rows.text(row, "to")
    if not start or not end:
        report.wrong(rows.table.where(at), "the track has no beginning or no end: left out", "fill in both barcodes")
        return
    _add_ways(draft, rows, at, row, (start, end), rows.number(at, row, "length"), report)


def _add_ways(
    draft: Draft, rows: Rows, at: int, row: Row, ends: tuple[str, str], length: float | None, report: Report
) -> None:
    where = rows.table.where(at)
    given = rows.text(row, "direction")
    word = given.casefold().replace(" ", "")
    if word not in BOTH | ONE_WAY | BACKWARD:
        rows.wrong(at, "direction", given, "no direction: taken is one-way", "write one-way or two-way")
    sensor = rows.number(at, row, "sensor")
    way = Way(*ends, where, length, speed=rows.number(at, row, "speed"), sensor=int(sensor or 0))
    way.curve = _truth(rows, at, row, "curve") if rows.text(row, "curve") else None
    if word not in BACKWARD:
        draft.ways.append(way)
    if word in BOTH | BACKWARD and word:
        draft.ways.append(Way(ends[1], ends[0], where, length, way.speed, None, way.sensor, way.curve))


def _truth(rows: Rows, at: int, row: Row, role: str) -> bool:
    given = rows.text(row, role)
    word = given.casefold()
    if word in FALSE:
        return False
    if word in TRUE or fold(given) in PARK_WORDS:
        return True
    rows.wrong(at, role, given, "neither yes nor no: taken is no", "write yes or no")
    return False


def _read_station(draft: Draft, rows: Rows, at: int, row: Row, report: Report) -> None:
    given, word = rows.text(row, "kind"), fold(rows.text(row, "kind"))
    where, spot = rows.table.where(at), rows.text(row, "barcode")
    names = rows.texts(row, "station")
    if word in CHARGER_WORDS:
        draft.charges += [Charge(name, spot, where) for name in names or [f"CHARGER-{spot}"]]
        return
    if not names:
        return
    kind = KIND_OF.get(word)
    if word and kind is None and word not in PARK_WORDS:
        known = "known: port, sbfl, sbfr, agv_buffer, charger"
        rows.wrong(at, "kind", given, "no kind of station: taken is the usual one", known)
    dest = _pulses(rows, at, row, report)
    look_down = rows.number(at, row, "look_down")
    for name in names:
        place = Place(name, [spot], where, kind, rows.text(row, "display"), look_down=int(look_down or 0))
        place.dest = dest
        place.carrier = rows.text(row, "carrier") if len(names) == 1 else ""
        place.fallbacks = tuple(rows.texts(row, "fallbacks"))
        draft.places.append(place)


def _pulses(rows: Rows, at: int, row: Row, report: Report) -> PulseSet | None:
    axes = [rows.number(at, row, axis) for axis in ("shft", "rota", "lift")]
    pulses = [Pulses(round(axis)) for axis in axes if axis is not None and abs(axis) < 1 << 31]
    if 0 < len(pulses) < len(axes):
        report.wrong(rows.table.where(at), "only some of shft, rota and lift are given: left out", "give all three")
    return PulseSet(*pulses) if len(pulses) == len(axes) else None


def _read_zone(draft: Draft, rows: Rows, at: int, row: Row) -> None:
    for name in rows.texts(row, "zone"):
        area = draft.areas.setdefault(name, Area(name, [], rows.table.where(at)))
        area.spots.append(rows.text(row, "barcode"))
        capacity = rows.text(row, "capacity")
        if capacity.isdecimal() and capacity.isascii():
            area.capacity = max(area.capacity, int(capacity[:6]))


def _read_machine(draft: Draft, rows: Rows, at: int, row: Row, report: Report) -> None:
    where, name = rows.table.where(at), rows.text(row, "vehicle")
    if not name:
        report.wrong(where, "the row has no vehicle: left out", "fill in its name")
        return
    word, dev_id = fold(rows.text(row, "kind")), rows.number(at, row, "dev_id")
    address, port = rows.text(row, "address"), rows.text(row, "port_number")
    draft.machines.append(
        Machine(
            name,
            where,
            VehicleKind.AGV if word == "agv" else VehicleKind.HOIST if word else None,
            None if dev_id is None else int(dev_id),
            f"{address}:{port}" if address and port else address,
            rows.text(row, "start") or rows.text(row, "barcode") or None,
            offset=_pulses(rows, at, row, report),
        )
    )


def _in_order(draft: Draft, reading: Reading, report: Report) -> None:
    if not reading.in_order:
        what = "no column says which barcode comes next: the plan has no track"
        report.wrong(
            "",
            what,
            "add a column next (다음 바코드), or say --in-order: each row leads to the next (--loop: in a ring)",
        )
        return
    spots = draft.spots
    pairs = list(zip(spots, spots[1:] + (spots[:1] if reading.loop else []), strict=False))
    draft.ways = [Way(one.name, other.name, one.where) for one, other in pairs]
