"""The demo plant with everything in it, as views made up for the page: hoists, AGVs, a door, buffers, a charger, drives."""

from dataclasses import replace
from pathlib import Path
from typing import Any

from app.domain.layout import Plant
from app.domain.units import Barcode
from app.domain.view import DeviceView, DriveView, StationView, Topic, Update, VehicleView
from app.plant import read
from tests.api.scripted import NOW, Scripted

DEMO = Path(__file__).parents[2] / "plants" / "demo.yaml"


def whole(kind: type[Scripted] = Scripted) -> Scripted:
    """Return the demo plant under a scripted controller: every vehicle at its start, every device heard."""
    plant, _ = read(DEMO.read_text(encoding="utf-8"), "demo")
    controller = kind(plant=plant)
    model = controller.model
    stands: dict[str, Barcode | None] = {vehicle.id: vehicle.start for vehicle in plant.vehicles}
    vehicles = [view for view in model.all(Topic.VEHICLES) if isinstance(view, VehicleView)]
    controller.hub.publish(
        [
            Update(Topic.VEHICLES, view.id, replace(view, barcode=stands[view.id], dist=0, mode="auto", oper="ready"))
            for view in vehicles
        ]
    )
    stations = {view.id: view for view in model.all(Topic.STATIONS) if isinstance(view, StationView)}
    held: dict[str, str] = {station: carrier for carrier, station in plant.carriers}
    controller.hub.publish(
        [
            Update(Topic.STATIONS, view.id, replace(view, present=view.id in held, carrier=held.get(view.id)))
            for view in stations.values()
        ]
    )
    controller.hub.publish([*_devices(plant), *_drives(plant)])
    return controller


def _devices(plant: Plant) -> list[Update]:
    carts = {station for _, station in plant.carriers}
    buffers = {station.buffer: station.id in carts for station in plant.stations if station.buffer}
    return [
        *(device("door", door.id, door.number, "closed") for door in plant.doors),
        *(Update(Topic.DEVICES, c.id, DeviceView(c.id, "charger", None, None, fresh=True)) for c in plant.chargers),
        *(
            device("buffer", buffer.id, buffer.number, "cart" if buffers.get(buffer.id) else "no_cart")
            for buffer in plant.buffers
        ),
    ]


def device(kind: str, name: str, number: int, state: str, *, fresh: bool = True, **more: Any) -> Update:
    """Return what a door or buffer of the hall says."""
    view = DeviceView(name, kind, "hall", number, fresh, state=state, since=NOW, seen=NOW, **more)
    return Update(Topic.DEVICES, name, view)


def _drives(plant: Plant) -> list[Update]:
    return [
        Update(
            Topic.DRIVES,
            unit.id,
            DriveView(
                id=unit.id,
                name=unit.name,
                line=unit.link,
                address=unit.address,
                model=unit.model,
                online=True,
                mode="monitoring",
                output=0,
                code=0,
                meaning="normal",
                turn="cw",
                distance=12345,
                seen=NOW,
            ),
        )
        for unit in plant.drives
    ]
