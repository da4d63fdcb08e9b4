"""Backups of drives: made, shown, downloaded, compared, restored."""

import csv
import io
from typing import Annotated, Literal
from urllib.parse import quote

from fastapi import APIRouter, Query
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, items, read
from app.api.declared import gives
from app.api.drive_inputs import BackupIn, Before, CompareIn, PathCount, RestoreIn, Wait
from app.api.drives import unit_of
from app.api.inputs import Limit, PathId
from app.api.operations import TAKEN, taken
from app.api.port import Controller
from app.api.problems import Problem
from app.domain import drive_requests as r
from app.domain.drive import DriveId, Parameter
from app.domain.drive_records import DriveBackup
from app.domain.layout import Plant
from app.runtime.showing import iso

router = APIRouter(prefix="/drives/{drive}", tags=["drives"])


@router.post("/backups", **TAKEN)
async def back_up_drive(drive: PathId, body: BackupIn, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Read all 256 parameters and keep them; ``result.backup`` of the operation is the backup's number."""
    return await taken(controller, r.BackUpDrive(actor, DriveId(drive), body.note), wait)


@router.get("/backups", **gives("Backup[]", description="Backups, newest first, without their values."))
async def list_backups(drive: PathId, controller: Ctl, after: Before = None, limit: Limit = 100) -> Response:
    """List the backups of a drive."""
    unit = unit_of(controller, drive)
    rows = await read(controller.reader.backups, unit.id, after, limit)
    last = rows[-1].number if len(rows) == limit else None
    return items((_told(row) for row in rows), last)


async def backup_of(controller: Controller, number: int) -> DriveBackup:
    """Return a backup. Raises Problem: there is none."""
    backup = await read(controller.reader.backup, number)
    if backup is None:
        raise Problem("not-found", f"There is no backup {number}.", "GET /api/v1/drives/DRIVE/backups lists them.")
    return backup


_AS_CSV = gives("BackupWithValues", description="The backup; with format=csv one line for each parameter.")
_AS_CSV["responses"][200]["content"]["text/csv"] = {}


@router.get("/backups/{backup}", **_AS_CSV)
async def get_backup(
    drive: PathId,
    backup: PathCount,
    controller: Ctl,
    form: Annotated[Literal["json", "csv"], Query(alias="format")] = "json",
) -> Response:
    """Show or download a backup: each parameter raw, and in its unit where a catalogue names it."""
    found = await backup_of(controller, backup)
    if found.drive != drive:
        raise Problem("not-found", f"Backup {backup} is of drive {found.drive}.", f"Look at drive {found.drive}.")
    rows = _rows(found, controller.plant)
    name = f"{found.drive}-{found.number}.{form}"
    headers = {"Content-Disposition": f"attachment; filename*=UTF-8''{quote(name)}"}
    if form == "csv":
        return Response(_csv(rows), 200, headers, "text/csv; charset=utf-8")
    return answer_of(_told(found) | {"values": rows}, headers=headers)


def _told(backup: DriveBackup) -> dict[str, object]:
    return {
        "id": backup.number,
        "drive": backup.drive,
        "model": backup.model,
        "at": iso(backup.at),
        "actor": backup.actor,
        "note": backup.note,
        "parameters": sum(value is not None for value in backup.values),
    }


def _rows(backup: DriveBackup, plant: Plant) -> list[dict[str, object]]:
    catalogue = next((c for c in plant.catalogues if c.model == backup.model), None)
    rows: list[dict[str, object]] = []
    for number, raw in enumerate(backup.values):
        if raw is None:
            continue
        spec = catalogue.get(number) if catalogue else None
        rows.append(
            {
                "parameter": f"{number:02X}",
                "raw": raw,
                "name": spec.name if spec else "",
                "value": spec.scaled(raw) if spec else None,
                "unit": spec.unit if spec else "",
            }
        )
    return rows


def _csv(rows: list[dict[str, object]]) -> str:
    text = io.StringIO()
    writer = csv.DictWriter(text, ["parameter", "raw", "name", "value", "unit"])
    writer.writeheader()
    writer.writerows(rows)
    return text.getvalue()


def values_of(backup: DriveBackup) -> r.Values:
    """Return the values that a backup has."""
    return tuple((Parameter(number), raw) for number, raw in enumerate(backup.values) if raw is not None)


@router.post("/compare", **TAKEN)
async def compare_drive(drive: PathId, body: CompareIn, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Read the drive and tell where it differs from a backup or another drive: see ``result.differences``."""
    if body.backup is not None:
        backup = await backup_of(controller, body.backup)
        what = f"backup {backup.number} of {backup.drive}"
        return await taken(controller, r.CompareDrive(actor, DriveId(drive), what, values_of(backup)), wait)
    other = DriveId(body.drive or "")
    return await taken(controller, r.CompareDrive(actor, DriveId(drive), f"drive {other}", other=other), wait)


@router.post("/restore", **TAKEN)
async def restore_drive(drive: PathId, body: RestoreIn, controller: Ctl, actor: Who, wait: Wait = 0.0) -> Response:
    """Write what differs from a backup, each read back; ``result.rows`` says what becomes of each. Try ``dry_run`` first."""
    backup = await backup_of(controller, body.backup)
    what = f"backup {backup.number} of {backup.drive}"
    asked = r.RestoreDrive(actor, DriveId(drive), what, backup.model, values_of(backup), body.dry_run)
    return await taken(controller, asked, wait)
