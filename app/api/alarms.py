"""Alarms: those there are, those there were, who knows of them, and what they add up to (DOMAIN sections 1 and 8)."""

import asyncio
from itertools import groupby
from typing import Annotated, Literal

from fastapi import APIRouter, Query
from pydantic import Field
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, answer_of, answer_view, ask, items, listing, missing, read
from app.api.declared import gives
from app.api.inputs import Limit, Older, QueryId, Strict, Text
from app.api.periods import Begin, End, Period, ordered, period
from app.api.port import Controller
from app.api.problems import Problem
from app.api.teaching_inputs import Number
from app.domain.alarms import AcknowledgeAlarm, AlarmKind, Reliability, reliability
from app.domain.ids import Actor
from app.domain.view import Topic
from app.fleet.views import view_of_alarm
from app.runtime.showing import iso, shown

router = APIRouter(prefix="/alarms", tags=["alarms"])
By = Literal["code", "source", "both"]
MOST = 1000
"""Alarms that are acknowledged with one request, at most (our choice): one for each vehicle of a large plant."""
_COLUMNS: dict[str, tuple[str, ...]] = {
    "code": ("kind", "code"),
    "source": ("source",),
    "both": ("kind", "source", "code"),
}


class NoteIn(Strict):
    """What is known of it; may be empty."""

    note: Text = ""


class NotedAlarmsIn(NoteIn):
    """Several alarms at once, by their numbers."""

    alarms: Annotated[list[Annotated[int, Field(ge=1, le=(1 << 53) - 1)]], Field(min_length=1, max_length=MOST)]


@router.get("/active", **gives("Alarm[]", description="What is wrong now; up to 100 ms old."))
async def list_active_alarms(request: Request, controller: Ctl) -> Response:
    """List the alarms that there are now."""
    return listing(request, controller.model.page(Topic.ALARMS))


@router.get("", **gives("Alarm[]", description="Alarms, newest first."))
async def list_alarms(
    controller: Ctl,
    kind: Annotated[AlarmKind | None, Query()] = None,
    source: QueryId = None,
    code: Annotated[str | None, Query(max_length=200)] = None,
    active: Annotated[
        bool | None, Query(description="Only those there are now, or only those that have ended.")
    ] = None,
    acknowledged: bool | None = None,
    begin: Begin = None,
    end: End = None,
    after: Older = None,
    limit: Limit = 100,
) -> Response:
    """List alarms, ended or not, of a period or of all time; go on with ``after`` = ``next``."""
    ordered(begin, end)
    rows = await read(
        controller.reader.alarms,
        kind=kind.value if kind else None,
        source=source,
        code=code,
        active=active,
        acknowledged=acknowledged,
        begin=begin.timestamp() if begin else None,
        end=end.timestamp() if end else None,
        after=after,
        limit=limit,
    )
    return items((shown(view_of_alarm(row)) for row in rows), rows[-1].number if len(rows) == limit else None)


@router.get("/pareto", **gives("AlarmCount[]", description="The longest altogether first."))
async def count_alarms(
    controller: Ctl, by: By = "code", begin: Begin = None, end: End = None, limit: Limit = 100
) -> Response:
    """Count alarms of a period (by default the last 7 days): how often and how long, by code, by machine, or by both."""
    asked = period(begin, end, controller.utc())
    rows = await read(controller.reader.alarm_counts, _COLUMNS[by], asked.begin, asked.end, limit)
    whole = sum(row.seconds for row in rows) or 1.0
    return items(
        {
            "kind": row.about.get("kind"),
            "source": row.about.get("source"),
            "code": row.about.get("code"),
            "times": row.times,
            "minutes": round(row.seconds / 60, 2),
            "share": round(row.seconds / whole, 4),
            "newest": iso(row.newest),
        }
        for row in rows
    )


@router.get("/reliability", **gives("Reliability[]", description="One row a vehicle, in the order of the plant file."))
async def show_reliability(controller: Ctl, begin: Begin = None, end: End = None) -> Response:
    """Show how vehicles held out in a period (by default the last 7 days), up to now: failures, MTBF, MTTR, availability."""
    now = controller.utc()
    asked = period(begin, end, now)
    if asked.begin >= now:
        raise Problem("invalid", "from lies in the future.", "Ask for a period that has begun.", "from")
    asked = Period(asked.begin, min(asked.end, now))
    rows = await read(controller.reader.failures, asked.begin, asked.end)
    by_vehicle = {
        name: [(begun, ended) for _, begun, ended in group]
        for name, group in groupby(sorted(rows, key=lambda row: (row[0], row[1])), key=lambda row: row[0])
    }
    return items(
        {"vehicle": spec.id, **held_out(reliability(by_vehicle.get(spec.id, ()), asked.begin, asked.end))}
        for spec in controller.plant.vehicles
    )


def held_out(found: Reliability) -> dict[str, int | float | None]:
    """Return how a vehicle held out, for people: hours and minutes."""
    return {
        "failures": found.failures,
        "down_minutes": round(found.down / 60, 2),
        "mtbf_hours": None if found.between is None else round(found.between / 3600, 3),
        "mttr_minutes": None if found.to_repair is None else round(found.to_repair / 60, 2),
        "availability": round(1 - found.down / found.period, 5),
    }


@router.get("/{alarm}", **gives("Alarm"))
async def get_alarm(alarm: Number, controller: Ctl) -> Response:
    """Show one alarm, ended or not."""
    return await _shown(controller, alarm)


@router.post("/acknowledge", **gives("AlarmAnswer[]", description="One for each, in the order asked."))
async def acknowledge_alarms(body: NotedAlarmsIn, controller: Ctl, actor: Person) -> Response:
    """A named person knows of several alarms that have one cause: each is answered, and kept in the audit, by itself.

    One that there is not keeps no other from being acknowledged.
    """
    numbers = dict.fromkeys(body.alarms)
    return items(await asyncio.gather(*(_answered(controller, actor, number, body.note) for number in numbers)))


async def _answered(controller: Controller, actor: Actor, number: int, note: str) -> dict[str, object]:
    try:
        await _acknowledge(controller, actor, number, note)
    except Problem as problem:
        return {"alarm": number, "acknowledged": False, "code": problem.code, "detail": problem.detail}
    return {"alarm": number, "acknowledged": True, "code": None, "detail": ""}


async def _acknowledge(controller: Controller, actor: Actor, number: int, note: str) -> None:
    live = controller.model.get(Topic.ALARMS, str(number)) is not None
    known = None if live else await read(controller.reader.alarm, number)
    await ask(controller, AcknowledgeAlarm(actor, number, note, known))


@router.post("/{alarm}/acknowledge", **gives("Alarm"))
async def acknowledge_alarm(alarm: Number, body: NoteIn, controller: Ctl, actor: Person) -> Response:
    """A named person knows of an alarm; the first one stays. It goes on until its cause is gone."""
    await _acknowledge(controller, actor, alarm, body.note)
    return await _shown(controller, alarm)


async def acknowledge_named(alarm: str, body: NoteIn, controller: Ctl, actor: Person) -> Response:
    """Acknowledge an alarm that is named in text, as over the live stream."""
    if not (alarm.isascii() and alarm.isdigit() and len(alarm) < 16):
        missing("alarm", alarm)
    return await acknowledge_alarm(int(alarm), body, controller, actor)


async def _shown(controller: Controller, number: int) -> Response:
    live = controller.model.get(Topic.ALARMS, str(number))
    if live is not None:
        return answer_view(live)
    row = await read(controller.reader.alarm, number)
    return answer_of(shown(view_of_alarm(row))) if row is not None else missing("alarm", str(number))
