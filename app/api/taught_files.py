"""Import and export of taught values: present versions or all history, as JSON or CSV (DOMAIN section 3)."""

import json
from collections import Counter
from collections.abc import Sequence
from typing import Annotated, Any

from fastapi import APIRouter, Query
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, answer_of, ask, items, read
from app.api.declared import gives
from app.api.port import Controller
from app.api.problems import Problem, is_json
from app.api.taught_tables import Read, exported, from_csv, from_json
from app.api.teaching_answers import Version, version_row
from app.api.teaching_inputs import Format
from app.domain.ids import Actor
from app.domain.imports import Present, fates
from app.domain.layout import StationKind, VehicleKind
from app.domain.teaching import Fate, RowFate, Side
from app.domain.teaching_requests import ImportTaught

router = APIRouter(prefix="/teaching", tags=["teaching"])
History = Annotated[bool, Query(description="Every version instead of the present ones.")]
DryRun = Annotated[bool, Query(description="Change nothing; say what would become of each row.")]
_BODY: dict[str, Any] = {
    "requestBody": {
        "required": True,
        "description": "A file as exported; columns that tell who and when are passed over. An axis left out stays as it is.",
        "content": {
            "text/csv": {"schema": {"type": "string"}},
            "application/json": {
                "schema": {"type": "object", "properties": {"items": {"type": "array", "items": {"type": "object"}}}}
            },
        },
    }
}


def _csv(side: Side, rows: Sequence[tuple[str, Version]]) -> Response:
    headers = {"Content-Disposition": f'attachment; filename="{side.value}s.csv"'}
    return Response(exported(side, rows), headers=headers, media_type="text/csv; charset=utf-8")


def _declared(name: str, description: str) -> dict[str, Any]:
    made = gives(name, description=description)
    made["responses"][200]["content"]["text/csv"] = {"schema": {"type": "string"}}
    return made


@router.get("/dests", **_declared("TaughtDest[]", "The DEST of every port that has one, by name."))
async def export_dests(controller: Ctl, format: Format = "json", *, history: History = False) -> Response:  # noqa: A002
    """Export the taught values of ports."""
    rows = await read(controller.reader.all_dests, history=history)
    if format == "csv":
        return _csv(Side.DEST, [(row.station, row) for row in rows])
    return items({"station": row.station, **version_row(row)} for row in rows)


@router.get("/offsets", **_declared("TaughtOffset[]", "The OFFSET of every vehicle that has one, by name."))
async def export_offsets(controller: Ctl, format: Format = "json", *, history: History = False) -> Response:  # noqa: A002
    """Export the taught values of vehicles."""
    rows = await read(controller.reader.all_offsets, history=history)
    if format == "csv":
        return _csv(Side.OFFSET, [(row.vehicle, row) for row in rows])
    return items({"vehicle": row.vehicle, **version_row(row)} for row in rows)


@router.post("/dests/import", openapi_extra=_BODY, **gives("ImportReport"))
async def import_dests(request: Request, controller: Ctl, actor: Person, *, dry_run: DryRun = False) -> Response:
    """Import the taught values of ports: all rows or none. With ``dry_run`` only say what would become of each."""
    return await _import(request, controller, actor, Side.DEST, dry_run=dry_run)


@router.post("/offsets/import", openapi_extra=_BODY, **gives("ImportReport"))
async def import_offsets(request: Request, controller: Ctl, actor: Person, *, dry_run: DryRun = False) -> Response:
    """Import the taught values of vehicles, likewise."""
    return await _import(request, controller, actor, Side.OFFSET, dry_run=dry_run)


async def _import(request: Request, controller: Controller, actor: Actor, side: Side, *, dry_run: bool) -> Response:
    given = await _given(request, side)
    found = sorted([*given.wrong, *await _fates(controller, side, given)], key=lambda fate: fate.line)
    if dry_run:
        return _report(found, dry_run=True)
    errors = [fate for fate in found if fate.fate is Fate.ERROR]
    if errors:
        wrong = [{"field": f"line {e.line}", "message": f"{e.detail}; {e.remedy}"} for e in errors]
        detail = (
            f"Nothing was imported: {len(errors)} of {len(found)} rows are wrong, the first on line {errors[0].line}."
        )
        raise Problem("invalid", detail, "Correct them; dry_run=true shows every row.", wrong[0]["field"], wrong)
    accepted = await ask(controller, ImportTaught(actor, side, given.rows))
    return _report(accepted.fates, dry_run=False)


async def _given(request: Request, side: Side) -> Read:
    kind = request.headers.get("content-type", "")
    body = await request.body()
    if kind.partition(";")[0].strip().lower() == "text/csv":
        return from_csv(side, body)
    if not is_json(kind):
        remedy = "Send the header Content-Type: text/csv, or application/json."
        raise Problem("media-type", f"The body came as {kind[:80]!r}.", remedy)
    try:
        return from_json(side, json.loads(body))
    except (ValueError, RecursionError):
        raise Problem("malformed", "The body is not JSON.", "Export a file, and edit that.") from None


async def _fates(controller: Controller, side: Side, given: Read) -> list[RowFate]:
    plant = controller.plant
    if side is Side.DEST:
        names: set[str] = {s.id for s in plant.stations if s.kind is StationKind.PORT}
        present: Present = {d.station: (d.version, d.pulses) for d in await read(controller.reader.all_dests)}
    else:
        hoists = {v.id for v in plant.vehicles if v.kind is VehicleKind.HOIST}
        names = set(hoists - plant.reference_vehicles)
        present = {o.vehicle: (o.version, o.pulses) for o in await read(controller.reader.all_offsets)}
    return fates(side, given.rows, names, present)


def _report(found: Sequence[RowFate], *, dry_run: bool) -> Response:
    counted = Counter(fate.fate for fate in found)
    counts = {fate.value: counted[fate] for fate in Fate}
    return answer_of({"dry_run": dry_run, "counts": counts, "items": found})
