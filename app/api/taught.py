"""Taught values: what would be sent and from which rows, comparisons, drift, roll-back (DOMAIN section 3)."""

from collections.abc import Callable, Sequence
from itertools import groupby
from typing import TypeVar

from fastapi import APIRouter
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, answer_of, ask, items, missing, read, version_expected
from app.api.declared import gives
from app.api.inputs import PathId, QueryId
from app.api.port import Controller
from app.api.problems import Problem
from app.api.teaching_answers import Version, axes, changes_of, numbered, version_row, versions_of
from app.api.teaching_inputs import Drift, RollBackIn, most
from app.api.teaching_inputs import Version as VersionNumber
from app.domain import teaching_requests as requests
from app.domain.ids import StationId, VehicleId
from app.domain.impact import differences, offset_of
from app.domain.layout import PulseSet, Station, StationKind, VehicleSpec
from app.domain.pulses import AxisPulses, beyond, drifts, named, target
from app.domain.pulses import missing as lacking
from app.domain.records import StationDest, VehicleOffset
from app.domain.teaching import DRIFT, Side

V = TypeVar("V", StationDest, VehicleOffset)

router = APIRouter(prefix="/teaching", tags=["teaching"])
roll_backs = APIRouter(tags=["teaching"])


def _port(controller: Controller, name: str) -> Station:
    """Return the port of that name. Raises Problem: there is none, or it is a side buffer."""
    station = controller.plant.station(StationId(name)) or missing("station", name)
    if station.kind is not StationKind.PORT:
        remedy = "Vehicles know the positions of side buffers themselves."
        raise Problem("invalid", f"{name} is no port: it has no DEST.", remedy, "station")
    return station


def _vehicle(controller: Controller, name: str) -> VehicleSpec:
    return controller.plant.vehicle(VehicleId(name)) or missing("vehicle", name)


# -- what would be sent -----------------------------------------------------------------------------------------------------


@router.get("/targets/{station}/{vehicle}", **gives("TaughtTarget"))
async def get_target(station: PathId, vehicle: PathId, controller: Ctl) -> Response:
    """Show what a vehicle would be sent at a port, and from which rows; nothing is sent."""
    port, spec = _port(controller, station), _vehicle(controller, vehicle)
    dests, offsets = await read(controller.reader.dests, port.id), await read(controller.reader.offsets, spec.id)
    reference = spec.id in controller.plant.reference_vehicles
    dest = dests[-1] if dests else None
    offset = None if reference or not offsets else offsets[-1]
    other = offset_of(controller.plant, spec.id, {} if offset is None else {spec.id: offset})
    sum_ = target(dest.pulses if dest else None, other)
    body = {
        "station": port.id,
        "vehicle": spec.id,
        **axes(sum_),
        "complete": isinstance(sum_, PulseSet),
        "refusal": _refusal(port, spec, dest, other, sum_),
        "reference": reference,
        "dest": version_row(dest) if dest else None,
        "offset": version_row(offset) if offset else None,
    }
    return answer_of(body)


def _refusal(
    port: Station, spec: VehicleSpec, dest: StationDest | None, offset: AxisPulses | None, sum_: AxisPulses
) -> str:
    """Return why a job there would be refused, empty if it would not."""
    if unknown := lacking(dest.pulses if dest else None):
        return f"{port.id} has no DEST ({named(unknown)})"
    if unknown := lacking(offset):
        return f"{spec.id} has no OFFSET ({named(unknown)})"
    why = beyond(sum_, spec.limits)
    return f"{why} of {spec.id}" if why else ""


# -- comparisons ------------------------------------------------------------------------------------------------------------


@router.get("/compare/stations/{station}/{old}/{new}", **gives("TaughtComparison"))
async def compare_dests(station: PathId, old: VersionNumber, new: VersionNumber, controller: Ctl) -> Response:
    """Compare two versions of a port's DEST: the differences, and what each vehicle would be sent."""
    return await _compared(controller, _port(controller, station).id, Side.DEST, old, new)


@router.get("/compare/vehicles/{vehicle}/{old}/{new}", **gives("TaughtComparison"))
async def compare_offsets(vehicle: PathId, old: VersionNumber, new: VersionNumber, controller: Ctl) -> Response:
    """Compare two versions of a vehicle's OFFSET: the differences, and what it would be sent at each port."""
    return await _compared(controller, _vehicle(controller, vehicle).id, Side.OFFSET, old, new)


async def _compared(controller: Controller, name: str, side: Side, old: int, new: int) -> Response:
    rows = await versions_of(controller, name, side)
    one, other = _numbered(rows, name, old), _numbered(rows, name, new)
    body = {
        "old": version_row(one),
        "new": version_row(other),
        "differences": axes(differences(one.pulses, other.pulses)),
        "changes": await changes_of(controller, name, side, one.pulses, other.pulses),
    }
    return answer_of(body)


def _numbered(rows: Sequence[Version], name: str, version: int) -> Version:
    found = numbered(rows, version)
    if found is None:
        there = f"It has versions 1 to {rows[-1].version}." if rows else "It was never taught."
        raise Problem("not-found", f"{name} has no version {version}.", there)
    return found


@router.get("/compare/offsets/{vehicle}/{other}", **gives("VehicleComparison"))
async def compare_two_vehicles(vehicle: PathId, other: PathId, controller: Ctl, station: QueryId = None) -> Response:
    """Compare the OFFSETs of two vehicles, and what each would be sent at a port (all ports, if none is named)."""
    one, two = _vehicle(controller, vehicle), _vehicle(controller, other)
    offsets = {row.vehicle: row for row in await read(controller.reader.all_offsets)}
    dests = await read(controller.reader.all_dests)
    first, second = (offset_of(controller.plant, spec.id, offsets) for spec in (one, two))
    if station is not None:
        port = _port(controller, station)
        dests = [row for row in dests if row.station == port.id]
    rows = [
        {"station": row.station, "one": axes(target(row.pulses, first)), "other": axes(target(row.pulses, second))}
        for row in dests
    ]
    body = {
        "one": {"vehicle": one.id, **axes(first)},
        "other": {"vehicle": two.id, **axes(second)},
        "differences": axes(differences(first, second)),
        "stations": rows,
    }
    return answer_of(body)


# -- drift ------------------------------------------------------------------------------------------------------------------


@router.get("/drift", **gives("DriftRow[]", description="What was last taught far from what held before."))
async def list_drift(
    controller: Ctl, shft: Drift = DRIFT.shft, rota: Drift = DRIFT.rota, lift: Drift = DRIFT.lift
) -> Response:
    """List ports and vehicles whose newest version is farther from the one before than so many pulses."""
    far = most(shft, rota, lift)
    dests = await read(controller.reader.all_dests, history=True)
    offsets = await read(controller.reader.all_offsets, history=True)
    found = [
        *_drifting(Side.DEST, dests, lambda row: row.station, far),
        *_drifting(Side.OFFSET, offsets, lambda row: row.vehicle, far),
    ]
    return items(found)


def _drifting(side: Side, rows: Sequence[V], name: Callable[[V], str], far: PulseSet) -> list[dict[str, object]]:
    found: list[dict[str, object]] = []
    for owner, of_one in groupby(rows, name):
        *before, newest = of_one
        drift = drifts(before[-1].pulses, newest.pulses, far) if before else ""
        if drift:
            found.append(
                {
                    "side": side.value,
                    "name": owner,
                    "drift": drift,
                    "old": version_row(before[-1]),
                    "new": version_row(newest),
                }
            )
    return found


# -- roll back --------------------------------------------------------------------------------------------------------------


@roll_backs.post("/stations/{station}/dest/rollback", **gives("TaughtComparison"))
async def roll_back_dest(
    station: PathId, body: RollBackIn, request: Request, controller: Ctl, actor: Person
) -> Response:
    """Make a new version of a port's DEST that equals an old one; with If-Match only if nobody wrote meanwhile."""
    port = _port(controller, station)
    to = _numbered(await read(controller.reader.dests, port.id), port.id, body.version)
    if isinstance(to, StationDest):
        await ask(controller, requests.RollBackDest(actor, port.id, to, body.reason, version_expected(request)))
    return await _rolled_back(controller, port.id, Side.DEST)


@roll_backs.post("/vehicles/{vehicle}/offset/rollback", **gives("TaughtComparison"))
async def roll_back_offset(
    vehicle: PathId, body: RollBackIn, request: Request, controller: Ctl, actor: Person
) -> Response:
    """The same with a vehicle's OFFSET."""
    spec = _vehicle(controller, vehicle)
    to = _numbered(await read(controller.reader.offsets, spec.id), spec.id, body.version)
    if isinstance(to, VehicleOffset):
        await ask(controller, requests.RollBackOffset(actor, spec.id, to, body.reason, version_expected(request)))
    return await _rolled_back(controller, spec.id, Side.OFFSET)


async def _rolled_back(controller: Controller, name: str, side: Side) -> Response:
    rows = await versions_of(controller, name, side)
    newest = rows[-1].version
    return await _compared(controller, name, side, max(newest - 1, 1), newest)
