"""What a well-formed plant file may still get wrong: identities that do not fit the wire, and vehicles without room."""

from itertools import combinations
from math import hypot

import networkx as nx

from app.domain.layout import NO_OFFSET, Axis, Plant, Station, StationKind, VehicleSpec
from app.plant.connections import agv_floor, check_connections, graph_of
from app.plant.dialects import dialect_of
from app.plant.document import Document
from app.plant.fitting import check_equipment
from app.plant.references import Places
from app.protocols.enig.messages import is_tag
from app.protocols.itsc.dialects import Dialect, DialectError

_MAX_DIST_NEXT = 0xFFFF


def check(document: Document, plant: Plant, places: Places) -> None:
    """Note what is wrong with the plant as a whole."""
    if not plant.vehicles and not document.section("vehicles"):
        document.warn(("vehicles",), "the plant has no vehicle", "give at least one under vehicles", key=True)
    if not plant.stations and not document.section("stations"):
        document.warn(("stations",), "the plant has no station", "give at least two under stations", key=True)
    graph = graph_of(plant)
    floor = agv_floor(plant, graph)
    _check_tags(document, places, floor)
    check_equipment(document, plant, floor)
    for dialect, names in _dialects(plant).items():
        _check_barcodes(document, plant, places, dialect, names, floor)
        _check_lengths(document, plant, places, dialect, names)
    _check_identities(document, plant)
    _check_teaching(document, plant)
    _check_zones(document, plant)
    if document.is_sound("parking"):
        _check_parking(document, plant)
    # What is missing or wrong there would be reported again as a dozen unreachable stations.
    if document.is_sound("", "barcodes", "track", "stations"):
        check_connections(document, plant, places, graph)
        _check_starts(document, plant, graph)
        if plant.clearance:
            _check_clearance(document, plant, graph)


def _dialects(plant: Plant) -> dict[Dialect, list[VehicleSpec]]:
    """Return the vehicles of each dialect; a vehicle without one has been reported."""
    found: dict[Dialect, list[VehicleSpec]] = {}
    for vehicle in plant.hoists:
        try:
            found.setdefault(dialect_of(plant, vehicle.dialect), []).append(vehicle)
        except DialectError:
            continue
    return found


def _check_barcodes(
    document: Document, plant: Plant, places: Places, dialect: Dialect, vehicles: list[VehicleSpec], floor: set[str]
) -> None:
    rail = (point.barcode for point in plant.points if point.barcode not in floor)
    unfit = [barcode for barcode in rail if not _fits(barcode, dialect)]
    if not unfit:
        return
    room = f"numbers up to {(1 << 8 * dialect.barcode_bytes) - 1}, without leading zeros"
    if dialect.barcode_format == "ascii":
        room = f"at most {dialect.barcode_bytes} characters"
    more = f" and {len(unfit) - 1} more do" if len(unfit) > 1 else " does"
    message = f"barcode {unfit[0]}{more} not fit dialect {vehicles[0].dialect} of {vehicles[0].id}: it takes {room}"
    document.error(places.barcodes[unfit[0]], message, "correct the barcode or the vehicle's dialect", key=True)


def _check_tags(document: Document, places: Places, floor: set[str]) -> None:
    """Tags that AGVs read are four characters on the wire (PROTOCOLS E7)."""
    unfit = [tag for tag in sorted(floor) if not is_tag(tag)]
    if unfit:
        more = f" and {len(unfit) - 1} more are" if len(unfit) > 1 else " is"
        message = f"barcode {unfit[0]}{more} no tag that an AGV reads: four printable ASCII characters"
        document.error(places.barcodes[unfit[0]], message, "write it as four digits, such as 0042", key=True)


def _fits(barcode: str, dialect: Dialect) -> bool:
    if dialect.barcode_format == "ascii":
        return len(barcode) <= dialect.barcode_bytes
    is_number = barcode.isdecimal() and (barcode == "0" or not barcode.startswith("0"))
    return is_number and int(barcode) < 1 << 8 * dialect.barcode_bytes


def _check_lengths(
    document: Document, plant: Plant, places: Places, dialect: Dialect, vehicles: list[VehicleSpec]
) -> None:
    for edge in plant.edges if dialect.has_dist else ():
        if edge.length > _MAX_DIST_NEXT:
            message = f"track {edge.start} → {edge.end} is {edge.length} mm long; {vehicles[0].id} can be told {_MAX_DIST_NEXT}"
            document.warn(places.edges[edge.start, edge.end], message, "put a barcode between (DIST_NEXT has 16 bits)")


def _check_identities(document: Document, plant: Plant) -> None:
    for vehicle in plant.hoists:
        if vehicle.dev_id == 0:
            message = f"{vehicle.id}'s dev_id is 0, which vehicles without a number send"
            document.warn(("vehicles", vehicle.id, "dev_id"), message, "number vehicles from 1")


def _check_teaching(document: Document, plant: Plant) -> None:
    for axis in Axis if plant.hoists else ():
        lowest, highest = _accepted_by_all(plant, axis)
        for station in plant.stations:
            is_taught = station.kind is StationKind.PORT and station.dest is not None
            if is_taught and not lowest <= (station.dest or NO_OFFSET).of(axis) <= highest:
                _note_target(document, plant, station, axis)


def _accepted_by_all(plant: Plant, axis: Axis) -> tuple[int, int]:
    """Return the lowest and highest DEST that keeps every vehicle within its limits."""
    lowest = max(vehicle.limits.of(axis)[0] - (vehicle.offset or NO_OFFSET).of(axis) for vehicle in plant.hoists)
    highest = min(vehicle.limits.of(axis)[1] - (vehicle.offset or NO_OFFSET).of(axis) for vehicle in plant.hoists)
    return lowest, highest


def _note_target(document: Document, plant: Plant, station: Station, axis: Axis) -> None:
    dest = station.dest or NO_OFFSET
    beyond = []
    for vehicle in plant.hoists:
        target = dest.plus(vehicle.offset or NO_OFFSET).of(axis)
        low, high = vehicle.limits.of(axis)
        if not low <= target <= high:
            beyond.append(f"{vehicle.id} ({target}, limits {low} to {high})")
    more = f" and {len(beyond) - 1} more" if len(beyond) > 1 else ""
    message = f"{station.id}'s {axis} target is beyond the limits of {beyond[0]}{more}"
    path = ("stations", station.id, "dest", axis.value)
    document.warn(path, message, "correct dest, or the vehicle's limits or offset")


def _check_parking(document: Document, plant: Plant) -> None:
    places = sum(point.park for point in plant.points)
    vehicles = sum(vehicle.in_service for vehicle in plant.vehicles)
    if places < vehicles:
        message = f"there are {places} parking places for {vehicles} vehicles in service"
        document.warn(("parking",), message, "add barcodes to parking, best ones that no route needs", key=True)


def _check_starts(document: Document, plant: Plant, graph: "nx.DiGraph[str]") -> None:
    started = {vehicle.start: vehicle for vehicle in plant.vehicles if vehicle.start is not None}
    against = graph.reverse(copy=False)
    for start, vehicle in started.items():
        covered = nx.single_source_dijkstra_path_length(against, start, cutoff=vehicle.length, weight="length")
        for other, second in started.items():
            if other != start and other in covered:
                message = (
                    f"{second.id} starts at {other}, which {vehicle.id} at {start} covers ({vehicle.length} mm long)"
                )
                document.error(("vehicles", second.id, "start"), message, "start one of them elsewhere")


def _check_clearance(document: Document, plant: Plant, graph: "nx.DiGraph[str]") -> None:
    places = {point.barcode: point for point in plant.points}
    started = [(places[vehicle.start], vehicle) for vehicle in plant.vehicles if vehicle.start is not None]
    for (first, one), (second, other) in combinations(started, 2):
        apart = hypot(first.x - second.x, first.y - second.y)
        linked = graph.has_edge(first.barcode, second.barcode) or graph.has_edge(second.barcode, first.barcode)
        if apart < plant.clearance and not linked:
            message = f"{other.id} starts {apart:.0f} mm from {one.id}; the plant's clearance is {plant.clearance} mm"
            document.warn(("vehicles", other.id, "start"), message, "start one of them elsewhere")


def _check_zones(document: Document, plant: Plant) -> None:
    for zone in plant.zones:
        inside = [vehicle for vehicle in plant.vehicles if vehicle.start in zone.barcodes]
        if zone.meter is None and len(inside) > zone.capacity:
            message = f"{len(inside)} vehicles start in zone {zone.id}, which holds {zone.capacity}"
            document.error(("zones", zone.id), message, "start some of them elsewhere", key=True)
        if not zone.no_stop:
            continue
        for vehicle in inside:
            message = f"{vehicle.id} starts in zone {zone.id}, where no vehicle may stop"
            document.warn(("vehicles", vehicle.id, "start"), message, "start it elsewhere")
        parked = [point.barcode for point in plant.points if point.park and point.barcode in zone.barcodes]
        if parked:
            message = f"{parked[0]} is a parking place in zone {zone.id}, where no vehicle may stop"
            document.warn(("parking",), message, "take it out of one of them", key=True)
