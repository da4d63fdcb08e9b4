"""What a changed plant file would break of what a running plant has under way: jobs, carriers, vehicles, teaching, closures."""

from collections.abc import Iterator
from itertools import pairwise

from app.domain.closures import PlaceKind
from app.domain.layout import Plant, Station, VehicleKind
from app.domain.records import Kept, VehicleRecord
from app.domain.versions import Leaving
from app.plant.connections import graph_of, reachable
from app.plant.difference import Broken

AHEAD = "end it, or cancel it, first"


def touched(old: Plant, new: Plant, kept: Kept, *, listening: bool = True) -> list[Broken]:
    """Return everything kept that has no place in the new plant, by name; nothing: the plant can be changed now.

    ``kept`` is what the database of the running plant has; ``listening``: vehicles are listened for meanwhile.
    """
    return [
        *(_listening(old, new) if listening else ()),
        *_jobs(new, kept),
        *_carriers(new, kept),
        *_vehicles(new, kept),
        *_teaching(old, new, kept),
        *_closures(new, kept),
        *_operations(new, kept),
        *_people(new, kept),
    ]


def leaving(old: Plant, new: Plant, version: int) -> Leaving:
    """Return what a job can name now, and not once the new plant is there: its number is ``version``."""
    before, after = _names(old), _names(new)
    served = {station for kind in VehicleKind for station in _served(new, kind)}
    kept = {station.id for station in old.stations} & after
    return Leaving(version, frozenset(before - after), frozenset(kept - served))


def _names(plant: Plant) -> set[str]:
    return {*(station.id for station in plant.stations), *(vehicle.id for vehicle in plant.vehicles)}


def listens_at(plant: Plant) -> tuple[str, int] | None:
    """Return where a controller of the plant listens for vehicles; None: it dials all of them."""
    return plant.listen if any(vehicle.listen for vehicle in plant.hoists) else None


def _listening(old: Plant, new: Plant) -> Iterator[Broken]:
    """Another address to listen at may be taken, which would be found out too late to go back in order."""
    before, after = listens_at(old), listens_at(new)
    if after is not None and after != before:
        text = f"vehicles are to connect to {after[0]}:{after[1]}, where the controller does not listen"
        yield Broken("plant", "listen", text, "stop the controller, and start it with the new file", ("vehicles",))


def _jobs(new: Plant, kept: Kept) -> Iterator[Broken]:
    stations: dict[str, Station] = {station.id: station for station in new.stations}
    vehicles = {vehicle.id for vehicle in new.vehicles}
    served = {kind: _served(new, kind) for kind in VehicleKind}
    for job in kept.jobs:
        for place in (job.source, job.destination):
            station = stations.get(place)
            if station is None and place not in vehicles:
                yield Broken("job", job.id, f"it names {place}, which the new plant does not have", AHEAD, ("jobs",))
            elif station is not None and not any(station.id in known for known in served.values()):
                text = f"{station.id} cannot be reached from the other stations in the new plant"
                yield Broken("job", job.id, text, AHEAD, ("jobs",))
        for vehicle in {job.vehicle, job.wish} - {None} - vehicles:
            text = f"it is {vehicle}'s, which the new plant does not have"
            yield Broken("job", job.id, text, AHEAD, ("jobs", "vehicles"))


def _served(plant: Plant, kind: VehicleKind) -> set[str]:
    stations: list[Station] = [station for station in plant.stations if station.kind in kind.serves]
    if not stations:
        return set()
    main = reachable(graph_of(plant), [station.barcode for station in stations])
    return {station.id for station in stations if station.barcode in main}


def _carriers(new: Plant, kept: Kept) -> Iterator[Broken]:
    places = {*(station.id for station in new.stations), *(vehicle.id for vehicle in new.vehicles)}
    for record in kept.carriers:
        if record.place is not None and record.place not in places:
            text = f"it is at {record.place}, which the new plant does not have"
            yield Broken("carrier", record.carrier, text, "tell where it is: PUT /api/v1/carriers/ID", ("carriers",))


def _vehicles(new: Plant, kept: Kept) -> Iterator[Broken]:
    known = {vehicle.id for vehicle in new.vehicles}
    for record in kept.vehicles:
        if record.off_rail:
            continue
        if record.vehicle not in known and (record.held or record.barcode):
            text = "it may be on the rail, and the new plant does not have it"
            remedy = (
                f"take it off the rail, and say so: POST /api/v1/vehicles/{record.vehicle}/release, verdict off_rail"
            )
            yield Broken("vehicle", record.vehicle, text, remedy, ("vehicles",))
        elif record.vehicle in known:
            yield from _standing(new, kept, record)


def _standing(new: Plant, kept: Kept, record: VehicleRecord) -> Iterator[Broken]:
    """A vehicle and what it was sent to pass must be found in the new plant."""
    places = {point.barcode for point in new.points}
    pairs = {(edge.start, edge.end) for edge in new.edges}
    paths = [intent.path for intent in kept.intents if intent.vehicle == record.vehicle and not intent.state.closed]
    held = [record.barcode] if record.barcode is not None else []
    for barcode in dict.fromkeys([*held, *record.held, *(barcode for path in paths for barcode in path)]):
        if barcode not in places:
            text = f"it stands at, holds or drives to {barcode}, which the new plant does not have"
            yield Broken("vehicle", record.vehicle, text, "move it elsewhere first", ("vehicles",))
            return
    for pair in (pair for path in paths for pair in pairwise(path)):
        if pair not in pairs:
            text = f"it drives from {pair[0]} to {pair[1]}, where the new plant has no track"
            yield Broken("vehicle", record.vehicle, text, "let it end its way first", ("vehicles",))
            return


def _teaching(old: Plant, new: Plant, kept: Kept) -> Iterator[Broken]:
    stations = {station.id: station for station in new.stations}
    before = {station.id: station for station in old.stations}
    vehicles = {vehicle.id for vehicle in new.vehicles}
    for session in kept.sessions:
        if session.station not in stations or session.vehicle not in vehicles:
            text = "it names a station or vehicle that the new plant does not have"
            yield Broken("teaching session", str(session.number), text, "close it first", ("teaching",))
    closed = {record.station for record in kept.stations if record.out_of_service}
    for dest in kept.dests:
        was, now = before.get(dest.station), stations.get(dest.station)
        if was is None or now is None or was.barcode == now.barcode or dest.station in closed:
            continue
        text = (
            f"its DEST was taught at {was.barcode}, and it is served from {now.barcode}: a hoist would reach elsewhere"
        )
        remedy = f"PATCH /api/v1/stations/{dest.station} with out_of_service first; teach it anew afterwards"
        yield Broken("station", dest.station, text, remedy, ("teaching",))


def _closures(new: Plant, kept: Kept) -> Iterator[Broken]:
    places: set[str] = {point.barcode for point in new.points}
    named: dict[PlaceKind, set[str]] = {
        PlaceKind.STATION: {station.id for station in new.stations},
        PlaceKind.ZONE: {zone.id for zone in new.zones},
    }
    for closure in kept.closures:
        names = named.get(closure.place.kind, places)
        gone: list[str] = [barcode for barcode in closure.barcodes if barcode not in places]
        gone += [name for name in closure.place.names if name not in names]
        if gone:
            text = f"{closure.place} is closed ({closure.reason}), and {gone[0]} of it is not in the new plant"
            yield Broken("closure", str(closure.number), text, "its owner opens it first", ("closures",))


def _operations(new: Plant, kept: Kept) -> Iterator[Broken]:
    drives = {drive.id for drive in new.drives}
    for operation in kept.operations:
        if operation.drive is not None and operation.drive not in drives:
            text = f"it is under way at {operation.drive}, which the new plant does not have"
            yield Broken("operation", str(operation.number), text, "let it end first", ("drives",))


def _people(new: Plant, kept: Kept) -> Iterator[Broken]:
    """A lockout keeps commands from a machine that somebody works at: it must not go with the machine's name."""
    devices = {*(d.id for d in new.doors), *(b.id for b in new.buffers), *(c.id for c in new.chargers)}
    drives = {drive.id for drive in new.drives}
    gone = [(record.device, record.lockout) for record in kept.devices if record.device not in devices]
    found = [*gone, *((record.drive, record.lockout) for record in kept.drives if record.drive not in drives)]
    for name, lockout in found:
        if lockout is not None:
            text = "somebody works at it (lockout), and the new plant does not have it"
            yield Broken("device", name, text, "its owner lifts the lockout first", ("lockouts",))
