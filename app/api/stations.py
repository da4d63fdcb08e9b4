"""Stations and carriers: what is believed of them, and what hosts and people write."""

from collections.abc import Sequence

from fastapi import APIRouter
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import (
    Ctl,
    Person,
    Who,
    answer_of,
    answer_view,
    ask,
    listing,
    live_object,
    missing,
    read,
    version_expected,
)
from app.api.declared import gives
from app.api.inputs import CarrierPut, Id, PathId, StationPatch, StationPut, Strict, Target
from app.api.port import Controller
from app.api.problems import Problem
from app.api.teaching_answers import version_row
from app.domain import requests
from app.domain.ids import Actor, CarrierId, StationId, VehicleId
from app.domain.records import StationDest, VehicleOffset
from app.domain.view import Topic

router = APIRouter(prefix="/stations", tags=["stations"])
carriers = APIRouter(prefix="/carriers", tags=["carriers"])


@router.get("", **gives("Station[]", description="All stations; up to 100 ms old."))
async def list_stations(request: Request, controller: Ctl) -> Response:
    """List stations and what is believed of them."""
    return listing(request, controller.model.page(Topic.STATIONS))


@router.get("/{station}", **gives("Station"))
async def get_station(station: PathId, request: Request, controller: Ctl) -> Response:
    """Show one station."""
    return live_object(request, controller, Topic.STATIONS, station)


async def _written(controller: Controller, station: str, request: requests.Request) -> Response:
    await ask(controller, request)
    view = controller.model.get(Topic.STATIONS, station)
    return answer_view(view) if view is not None else missing("station", station)


@router.put("/{station}", **gives("Station"))
async def put_station(station: PathId, body: StationPut, controller: Ctl, actor: Who) -> Response:
    """Write the whole state of a station."""
    return await _written(controller, station, _asked(actor, station, body))


@router.patch("/{station}", **gives("Station"))
async def patch_station(station: PathId, body: StationPatch, controller: Ctl, actor: Who) -> Response:
    """Write parts of a station's state."""
    if not body.model_fields_set - {"by_person"}:
        raise Problem("invalid", "Nothing to write was named.", "Send present, carrier, reserved or out_of_service.")
    return await _written(controller, station, _asked(actor, station, body))


def _asked(actor: Actor, station: str, body: StationPut | StationPatch) -> requests.WriteStation:
    """Return what is to be written. Raises Problem: a carrier is named where nobody knows whether something stands."""
    forgotten = "present" in body.model_fields_set and body.present is None
    if forgotten and body.carrier:
        raise Problem(
            "invalid",
            f"{body.carrier} cannot be where nobody knows whether something stands.",
            "Send present true with it, or leave carrier out.",
            "carrier",
        )
    return requests.WriteStation(
        actor,
        StationId(station),
        body.present,
        body.carrier,
        body.reserved,
        body.out_of_service,
        by_person=body.by_person,
        forgotten=forgotten,
    )


class StageIn(Strict):
    """Which vehicle; none: the nearest that is free."""

    vehicle: Id | None = None


@router.post("/{station}/stage", **gives("Vehicle"))
async def stage_vehicle(station: PathId, body: StageIn, controller: Ctl, actor: Who) -> Response:
    """Send a vehicle to a station before its lot is ready. It stays idle there: it gives way, and takes jobs."""
    vehicle = VehicleId(body.vehicle) if body.vehicle else None
    accepted = await ask(controller, requests.StageVehicle(actor, StationId(station), vehicle))
    view = controller.model.get(Topic.VEHICLES, accepted.key)
    return answer_view(view) if view is not None else missing("vehicle", accepted.key)


@router.get("/{station}/dest", **gives("PulsesVersion[]", description="All versions, oldest first; ETag: the newest."))
async def list_dests(station: PathId, controller: Ctl) -> Response:
    """Show a station's DEST and its history."""
    if controller.plant.station(StationId(station)) is None:
        missing("station", station)
    return versions(await read(controller.reader.dests, StationId(station)))


def versions(rows: Sequence[StationDest | VehicleOffset]) -> Response:
    """Return versions of pulses, with the newest one's number as ETag."""
    newest = max((row.version for row in rows), default=0)
    shown = [version_row(row) for row in sorted(rows, key=lambda row: row.version)]
    return answer_of({"items": shown, "next": None}, headers={"ETag": f'"{newest}"'})


@router.put("/{station}/dest", **gives("Station"))
async def write_dest(station: PathId, body: Target, request: Request, controller: Ctl, actor: Person) -> Response:
    """Write a new version of a port's DEST, as a named person; with If-Match only if nobody else did meanwhile."""
    expected = version_expected(request)
    asked = requests.WriteDest(actor, StationId(station), body.pulses(), expected)
    return await _written(controller, station, asked)


@carriers.get("", **gives("Carrier[]", description="All carriers; up to 100 ms old."))
async def list_carriers(request: Request, controller: Ctl) -> Response:
    """List carriers and where they are believed to be."""
    return listing(request, controller.model.page(Topic.CARRIERS))


@carriers.get("/{carrier}", **gives("Carrier"))
async def get_carrier(carrier: PathId, request: Request, controller: Ctl) -> Response:
    """Locate a carrier."""
    return live_object(request, controller, Topic.CARRIERS, carrier)


@carriers.put("/{carrier}", **gives("Carrier", 200, "The carrier; 201 if it is new.", Carrier=201))
async def put_carrier(carrier: PathId, body: CarrierPut, controller: Ctl, actor: Who) -> Response:
    """Install a carrier, or say where it is."""
    asked = requests.WriteCarrier(actor, CarrierId(carrier), body.place, by_person=body.by_person)
    accepted = await ask(controller, asked)
    view = controller.model.get(Topic.CARRIERS, carrier)
    return answer_view(view, 201 if accepted.created else 200) if view is not None else missing("carrier", carrier)


@carriers.delete("/{carrier}", **gives(None, 204, "It is gone."))
async def remove_carrier(carrier: PathId, controller: Ctl, actor: Who) -> Response:
    """Remove a carrier from the plant."""
    await ask(controller, requests.WriteCarrier(actor, CarrierId(carrier), None))
    return Response(status_code=204)
