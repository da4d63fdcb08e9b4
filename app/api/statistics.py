"""Statistics of a period: as JSON, as files, as a report to print (DOMAIN section 1)."""

from collections import defaultdict
from typing import Annotated, Any, Literal

from fastapi import APIRouter, Path, Query
from starlette.responses import Response

from app.api.alarms import held_out
from app.api.calls import Ctl, answer_of, read
from app.api.declared import gives
from app.api.periods import DAY, Begin, End, Period, Zone, period, zone_of
from app.api.port import Controller
from app.api.problems import Problem
from app.api.statistics_report import report
from app.api.statistics_tables import as_csv, as_objects, as_parquet, table_of
from app.domain.statistics import Kept
from app.fleet.statistics import MOST_INTERVALS, Statistics, Times, latest, statistics
from app.runtime.showing import iso

router = APIRouter(prefix="/statistics", tags=["statistics"])
MOST_EVENTS = 3_000_000
"""So many events may lie in a period: some seconds of the database's time. Our choice."""
ALARMS_NAMED = 30
Every = Annotated[
    int | None,
    Query(ge=60, le=31 * 86_400, description="Seconds of an interval; by default an hour, for long periods a day."),
]
HOUR = 3600
FILES = {"csv": ("text/csv; charset=utf-8", as_csv), "parquet": ("application/vnd.apache.parquet", as_parquet)}
HTML: dict[int | str, dict[str, Any]] = {200: {"description": "A page to print.", "content": {"text/html": {}}}}
FILE: dict[int | str, dict[str, Any]] = {
    200: {"description": "The table.", "content": {"text/csv": {}, "application/vnd.apache.parquet": {}}}
}


@router.get("", **gives("Statistics"))
async def show_statistics(controller: Ctl, begin: Begin = None, end: End = None, interval: Every = None) -> Response:
    """Show what a period came to (by default the last day): delivery times by phase, throughput, queue, vehicles, waits."""
    asked, every = await _asked(controller, begin, end, interval)
    _, found = await read(_found, controller, asked, every)
    return answer_of(_shown(found))


@router.get("/report", responses=HTML, response_class=Response)
async def print_report(
    controller: Ctl,
    begin: Begin = None,
    end: End = None,
    interval: Every = None,
    lang: Annotated[Literal["en", "ko"], Query()] = "en",
    tz: Zone = None,
) -> Response:
    """Give the report of a shift as a page to print (by default the last 8 hours)."""
    zone = zone_of(tz)
    asked, every = await _asked(controller, begin, end, interval, usual=8 * 3600.0)
    _, found = await read(_found, controller, asked, every)
    columns = ("kind", "source", "code")
    alarms = await read(controller.reader.alarm_counts, columns, asked.begin, asked.end, ALARMS_NAMED)
    page = await read(report, controller.plant.name, found, alarms, controller.utc(), lang, zone)
    headers = {"Content-Security-Policy": "default-src 'none'; style-src 'unsafe-inline'", "Cache-Control": "no-store"}
    return Response(page, headers=headers, media_type="text/html")


@router.get("/{table}.{kind}", responses=FILE, response_class=Response)
async def export_statistics(
    table: Annotated[
        Literal["phases", "intervals", "vehicles", "waits", "places", "late", "open", "transfers"], Path()
    ],
    kind: Annotated[Literal["csv", "parquet"], Path()],
    controller: Ctl,
    begin: Begin = None,
    end: End = None,
    interval: Every = None,
) -> Response:
    """Give one table as a file: durations in seconds, moments in ISO 8601. Parquet needs the extra `parquet`."""
    asked, every = await _asked(controller, begin, end, interval)
    transfers, found = await read(_found, controller, asked, every)
    media, write = FILES[kind]
    body = await read(lambda: write(table_of(table, found, transfers)))
    name = f'attachment; filename="{table}-{iso(asked.begin)[:10]}.{kind}"'
    return Response(body, headers={"Content-Disposition": name}, media_type=media)


async def _asked(
    controller: Controller, begin: Any, end: Any, interval: int | None, usual: float = DAY
) -> tuple[Period, int]:
    """Return the period that is asked about, and the seconds of an interval. Raises Problem: it is too much."""
    asked = period(begin, end, controller.utc(), usual)
    every = interval or (HOUR if asked.seconds / HOUR <= MOST_INTERVALS else int(DAY))
    if asked.seconds / every > MOST_INTERVALS:
        raise Problem("invalid", f"More than {MOST_INTERVALS} intervals.", "Ask for longer ones.", "interval")
    if await read(controller.reader.event_count, asked.begin, asked.end) > MOST_EVENTS:
        raise Problem("invalid", f"More than {MOST_EVENTS:,} events in this period.", "Ask for a shorter one.", "from")
    return asked, every


def _found(controller: Controller, asked: Period, interval: float) -> tuple[Any, Statistics]:
    """Read and reckon, in a thread."""
    reader = controller.reader
    waits, waits_of = reader.waits(asked.begin, asked.end)
    failures: defaultdict[str, list[tuple[float, float | None]]] = defaultdict(list)
    for vehicle, begun, ended in reader.failures(asked.begin, asked.end):
        failures[vehicle].append((begun, ended))
    transfers = reader.transfers(asked.begin, asked.end)
    kept = Kept(
        transfers,
        reader.queued(asked.begin, asked.end),
        waits,
        waits_of,
        failures,
        reader.waits_named([one.job for one in latest(transfers)]),
        reader.open_jobs(asked.end),
    )
    vehicles = [spec.id for spec in controller.plant.vehicles]
    stations = [spec.id for spec in controller.plant.stations]
    return transfers, statistics(kept, asked.begin, asked.end, float(interval), vehicles, stations)


def _times(times: Times) -> dict[str, object]:
    values = {"mean": times.mean, "p50": times.p50, "p95": times.p95, "longest": times.longest}
    return {"count": times.count, **{name: None if v is None else round(v, 3) for name, v in values.items()}}


def _shown(found: Statistics) -> dict[str, object]:
    return {
        "from": iso(found.begin),
        "to": iso(found.end),
        "jobs": found.states,
        "phases": {phase.value: _times(times) for phase, times in found.phases.items()},
        "empty_share": None if found.empty is None else round(found.empty, 4),
        "intervals": [
            {
                "begin": iso(one.begin),
                "ordered": one.ordered,
                "completed": one.completed,
                "unfinished": one.unfinished,
                "queue": one.queue,
                "delivery": _times(one.times),
            }
            for one in found.intervals
        ],
        "vehicles": [
            {
                "vehicle": one.vehicle,
                "completed": one.completed,
                "fetching": one.fetching,
                "acquiring": one.acquiring,
                "carrying": one.carrying,
                "depositing": one.depositing,
                "busy_share": one.busy,
                **held_out(one.held_out),
            }
            for one in found.vehicles
        ],
        "waits": [{"cause": one.cause, "times": one.times, "seconds": one.seconds} for one in found.waits],
        "waits_of": found.waits_of,
        "places": [
            {"place": one.place, "jobs": one.jobs, "seconds": one.seconds, "cause": one.cause} for one in found.places
        ],
        **{name: as_objects(table_of(name, found, ())) for name in ("late", "open")},
    }
