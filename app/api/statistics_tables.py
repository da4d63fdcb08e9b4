"""Statistics as tables: what CSV and Parquet files hold, and the printable report shows."""

import csv
import io
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from datetime import datetime
from importlib import import_module
from importlib.util import find_spec
from typing import Any

from app.api.alarms import held_out
from app.api.problems import Problem
from app.domain.statistics import Phase, Transfer
from app.fleet.statistics import Statistics, Times
from app.runtime.showing import iso

Cell = str | int | float | None
NAMES = ("phases", "intervals", "vehicles", "waits", "places", "late", "open", "transfers")
TEXTS = frozenset({"phase", "vehicle", "cause", "job", "state", "carrier", "source", "destination", "place", "reason"})
COUNTS = frozenset({"count", "ordered", "completed", "unfinished", "failures", "times", "priority", "jobs"})
MOMENTS = frozenset({"begin", "created", "ended"})
"""What a column's cells are, by its name; in all others numbers that may have a fraction. It does not depend on the rows,
so that the files of several shifts can be read as one table."""


@dataclass(frozen=True, slots=True)
class Table:
    """Columns by name, and rows. Moments are text in ISO 8601, durations seconds."""

    columns: tuple[str, ...]
    rows: Sequence[tuple[Cell, ...]]


def table_of(name: str, found: Statistics, transfers: Sequence[Transfer]) -> Table:
    """Return one of the tables by name. Raises KeyError: there is none."""
    made: Mapping[str, Callable[[Statistics], Table]] = {
        "phases": _phases,
        "intervals": _intervals,
        "vehicles": _vehicles,
        "waits": _waits,
        "places": _places,
        "late": _late,
        "open": _open,
        "transfers": lambda _found: _transfers(transfers),
    }
    return made[name](found)


def _cells(times: Times) -> tuple[Cell, ...]:
    return (times.count, *(_round(value) for value in (times.mean, times.p50, times.p95, times.longest)))


def _round(value: float | None) -> float | None:
    return None if value is None else round(value, 3)


_TIMES = ("count", "mean", "p50", "p95", "longest")


def _phases(found: Statistics) -> Table:
    return Table(("phase", *_TIMES), [(phase.value, *_cells(times)) for phase, times in found.phases.items()])


def _intervals(found: Statistics) -> Table:
    rows = [
        (iso(one.begin), one.ordered, one.completed, one.unfinished, one.queue, *_cells(one.times)[1:])
        for one in found.intervals
    ]
    return Table(("begin", "ordered", "completed", "unfinished", "queue", *_TIMES[1:]), rows)


def _vehicles(found: Statistics) -> Table:
    columns = ("vehicle", "completed", "fetching", "acquiring", "carrying", "depositing", "busy_share")
    more = ("failures", "down_minutes", "mtbf_hours", "mttr_minutes", "availability")
    rows = [
        (
            one.vehicle,
            one.completed,
            one.fetching,
            one.acquiring,
            one.carrying,
            one.depositing,
            one.busy,
            *map(held_out(one.held_out).__getitem__, more),
        )
        for one in found.vehicles
    ]
    return Table((*columns, *more), rows)


def _waits(found: Statistics) -> Table:
    return Table(("cause", "times", "seconds"), [(one.cause, one.times, one.seconds) for one in found.waits])


def _places(found: Statistics) -> Table:
    rows = [(one.place, one.jobs, one.seconds, one.cause) for one in found.places]
    return Table(("place", "jobs", "seconds", "cause"), rows)


_PHASES = tuple(phase.value for phase in Phase)


def _late(found: Statistics) -> Table:
    columns = ("job", "carrier", "source", "destination", "vehicle", "created", "ended", *_PHASES, "waited", "reason")
    rows = [
        (
            one.transfer.job,
            one.transfer.carrier,
            one.transfer.source,
            one.transfer.destination,
            one.transfer.vehicle,
            iso(one.transfer.created),
            iso(one.transfer.ended),
            *(_round(one.transfer.seconds(phase)) for phase in Phase),
            one.waited,
            one.reason,
        )
        for one in found.late
    ]
    return Table(columns, rows)


def _open(found: Statistics) -> Table:
    columns = ("job", "carrier", "source", "destination", "priority", "created", "seconds", "reason")
    rows = [
        (
            one.job,
            one.carrier,
            one.source,
            one.destination,
            one.priority,
            iso(one.created),
            _round(found.end - one.created),
            one.reason,
        )
        for one in found.open
    ]
    return Table(columns, rows)


def _transfers(transfers: Sequence[Transfer]) -> Table:
    columns = ("job", "state", "carrier", "source", "destination", "priority", "vehicle", "created", "ended")
    rows = [
        (
            one.job,
            one.state,
            one.carrier,
            one.source,
            one.destination,
            one.priority,
            one.vehicle,
            iso(one.created),
            iso(one.ended),
            *(_round(one.seconds(phase)) for phase in Phase),
        )
        for one in transfers
    ]
    return Table((*columns, *_PHASES), rows)


def as_objects(table: Table) -> list[dict[str, Cell]]:
    """Return the rows of a table as JSON has them: objects with the columns as names."""
    return [dict(zip(table.columns, row, strict=True)) for row in table.rows]


def as_csv(table: Table) -> bytes:
    """Return a table as CSV (RFC 4180) in UTF-8; text that a spreadsheet would take for a formula begins with a quote."""
    out = io.StringIO()
    writer = csv.writer(out)
    writer.writerow(table.columns)
    writer.writerows([_harmless(cell) for cell in row] for row in table.rows)
    return out.getvalue().encode()


def _harmless(cell: Cell) -> Cell:
    return f"'{cell}" if isinstance(cell, str) and cell.startswith(("=", "+", "-", "@", "\t")) else cell


def as_parquet(table: Table) -> bytes:
    """Return a table as a Parquet file. Raises Problem: what writes them is not installed."""
    if find_spec("pyarrow") is None:
        raise Problem("not-now", "Parquet needs pyarrow.", "pip install 'hoistway[parquet]', or ask for CSV.")
    arrow: Any = import_module("pyarrow")
    parquet: Any = import_module("pyarrow.parquet")
    columns = list(zip(*table.rows, strict=True)) or [()] * len(table.columns)
    arrays = {
        name: arrow.array(map(_moment, cells) if name in MOMENTS else cells, _kind(arrow, name))
        for name, cells in zip(table.columns, columns, strict=True)
    }
    out = io.BytesIO()
    parquet.write_table(arrow.table(arrays), out)
    return out.getvalue()


def _kind(arrow: Any, name: str) -> Any:
    if name in MOMENTS:
        return arrow.timestamp("ms", "UTC")
    return arrow.string() if name in TEXTS else arrow.int64() if name in COUNTS else arrow.float64()


def _moment(cell: Cell) -> datetime | None:
    return None if cell is None else datetime.fromisoformat(str(cell))
