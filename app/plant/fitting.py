"""Whether vehicles, stations and equipment fit one another: kinds, names on the wire, places to charge."""

from collections.abc import Iterable

from app.domain.devices import AliasName
from app.domain.layout import Plant, VehicleKind, Wire
from app.plant.dialects import hall_dialect_of
from app.plant.document import Document, Path
from app.protocols.enig.dialects import ALIASES, DialectError


def check_equipment(document: Document, plant: Plant, floor: set[str]) -> None:
    """Note doubled names, destinations that the wire does not know, and kinds that do not meet.

    ``floor`` are the barcodes that AGVs read.
    """
    _check_names(document, plant)
    _check_aliases(document, plant)
    _check_kinds(document, plant, floor)
    used = {v.link for v in plant.vehicles} | {d.link for d in plant.drives}
    used |= {door.link for door in plant.doors} | {buffer.link for buffer in plant.buffers}
    for link in plant.links:
        if link.id not in used:
            document.warn(("links", link.id), f"nothing is on link {link.id}", "name it at a device", key=True)


def _check_names(document: Document, plant: Plant) -> None:
    """One name, one thing: they stand side by side in the REST interface and in the history."""
    taken: dict[str, str] = {}
    sections: dict[str, list[str]] = {
        "vehicles": [vehicle.id for vehicle in plant.vehicles],
        "links": [link.id for link in plant.links],
        "doors": [door.id for door in plant.doors],
        "buffers": [buffer.id for buffer in plant.buffers],
        "chargers": [charger.id for charger in plant.chargers],
        "drives": [drive.id for drive in plant.drives],
    }
    for section, names in sections.items():
        for name in names:
            other = taken.setdefault(name, section)
            if other != section:
                message = f"{name} is a name under {other} already"
                document.error((section, name), message, "choose another name", key=True)


def _check_aliases(document: Document, plant: Plant) -> None:
    known = set(ALIASES)
    for link in plant.links:
        if link.wire is Wire.ENIG:
            try:
                known |= {name for name, _ in hall_dialect_of(link).aliases}
            except DialectError:
                return
    stations = [(("stations", station.id), station.alias) for station in plant.stations]
    chargers = [(("chargers", charger.id), charger.alias) for charger in plant.chargers]
    taken: dict[AliasName, str] = {}
    for path, alias in _given((*stations, *chargers)):
        if alias not in known:
            remedy = f"known: {', '.join(sorted(known))}; others go into the link's dialect"
            document.error((*path, "alias"), f"{alias} is no name on the wire (PROTOCOLS 3.2)", remedy)
        other = taken.setdefault(alias, str(path[1]))
        if other != path[1]:
            document.error((*path, "alias"), f"{path[1]} has the same alias as {other}: {alias}", "each needs its own")


def _given(named: Iterable[tuple[Path, AliasName | None]]) -> Iterable[tuple[Path, AliasName]]:
    return [(path, alias) for path, alias in named if alias is not None]


def _check_kinds(document: Document, plant: Plant, floor: set[str]) -> None:
    for station in plant.stations:
        if station.barcode in floor and station.kind in VehicleKind.HOIST.serves:
            message = f"{station.id} is a {station.kind.value} at {station.barcode}, on the track of AGVs"
            document.error(("stations", station.id, "at"), message, "hoists and AGVs need track of their own")
    for vehicle in plant.hoists:
        if vehicle.start in floor:
            message = f"{vehicle.id} is a hoist and starts at {vehicle.start}, on the track of AGVs"
            document.error(("vehicles", vehicle.id, "start"), message, "hoists and AGVs need track of their own")
    if plant.idle.park and not any(point.park and point.barcode not in floor for point in plant.points):
        message = "idle hoists have no place to park"
        document.warn(("idle",), message, "give barcodes of their track under parking", key=True)
    for zone in plant.zones:
        if zone.meter is not None and zone.barcodes <= floor:
            message = f"zone {zone.id} is soft and lies on the track of AGVs, where soft zones count for nothing"
            document.warn(("zones", zone.id), message, "give it a capacity instead", key=True)
    agvs = [vehicle for vehicle in plant.vehicles if vehicle.kind is VehicleKind.AGV]
    rules = plant.charging
    if agvs and not plant.chargers and (rules.trips or rules.after or rules.windows):
        document.warn(("charging",), "there is no charger", "give one under chargers", key=True)
    if plant.chargers and agvs and not (rules.trips or rules.after or rules.windows):
        message = "AGVs are never sent to charge: they report no battery level"
        document.warn(("chargers",), message, "say when under charging: trips, after or windows", key=True)
