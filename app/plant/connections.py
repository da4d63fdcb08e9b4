"""Whether the track connects what it should: dead ends, lone pieces, stations that cannot be reached or left."""

from collections import Counter
from collections.abc import Iterable

import networkx as nx

from app.domain.layout import Plant, Station, VehicleKind
from app.plant.document import Document
from app.plant.references import Places


def graph_of(plant: Plant) -> "nx.DiGraph[str]":
    """Return the track as a directed graph with ``length`` at its edges."""
    graph: nx.DiGraph[str] = nx.DiGraph()
    graph.add_nodes_from(point.barcode for point in plant.points)
    graph.add_edges_from((edge.start, edge.end, {"length": edge.length}) for edge in plant.edges)
    return graph


def agv_floor(plant: Plant, graph: "nx.DiGraph[str]") -> set[str]:
    """Return the barcodes that AGVs read: those that track connects with a start of one, its stations or its chargers."""
    places = {station.barcode for station in plant.stations if station.kind in VehicleKind.AGV.serves}
    places |= {charger.barcode for charger in plant.chargers}
    places |= {v.start for v in plant.vehicles if v.kind is VehicleKind.AGV and v.start is not None}
    pieces = nx.weakly_connected_components(graph)
    return {barcode for piece in pieces if piece & places for barcode in piece}


def check_connections(document: Document, plant: Plant, places: Places, graph: "nx.DiGraph[str]") -> None:
    """Note every dead end, every piece of track that cannot be left or reached, and the stations and starts that suffer."""
    _check_ends(document, places, graph)
    pieces = sorted(nx.weakly_connected_components(graph), key=lambda piece: (-len(piece), min(piece)))
    for kind in VehicleKind:
        stations = {station.barcode for station in plant.stations if station.kind in kind.serves}
        served = [piece for piece in pieces if piece & stations]
        if len(served) > 1:
            barcode = min(served[1])
            first = min(served[0])
            message = f"the track falls into {len(served)} pieces with stations; {barcode} is not connected to {first}"
            document.warn(places.barcodes[barcode], message, "no transfer is possible from one to the other", key=True)
    for piece in pieces:
        # Most plants are one piece, and a view of all of it is slower than the graph itself.
        _check_piece(document, plant, places, graph if len(pieces) == 1 else graph.subgraph(piece))


def _check_ends(document: Document, places: Places, graph: "nx.DiGraph[str]") -> None:
    for barcode in graph:
        into, out = graph.in_degree(barcode), graph.out_degree(barcode)
        where = places.barcodes[barcode]
        if not into and not out:
            document.warn(
                where, f"no track touches barcode {barcode}", "name it under track, or leave it out", key=True
            )
        elif not out:
            message = f"dead end: track leads to {barcode}, but none leads on"
            document.error(where, message, "add track from it, or end the track before it", key=True)
        elif not into:
            message = f"no track leads to {barcode}: a vehicle can leave it, but never return"
            document.warn(where, message, "add track to it", key=True)


def _check_piece(document: Document, plant: Plant, places: Places, piece: "nx.DiGraph[str]") -> None:
    stations = [station for station in plant.stations if station.barcode in piece]
    starts = [vehicle for vehicle in plant.vehicles if vehicle.start in piece]
    if not stations:
        for vehicle in starts if plant.stations else ():
            message = f"{vehicle.id} starts at {vehicle.start}, on a piece of track without stations"
            document.warn(("vehicles", vehicle.id, "start"), message, "start it on track that has stations")
        return
    if len(stations) == 1:
        message = f"{stations[0].id} is the only station on its piece of track: no transfer can begin or end there"
        document.warn(("stations", stations[0].id, "at"), message, "connect it to other stations")
    main = _main_loop(piece, [station.barcode for station in stations])
    onward, back = nx.descendants(piece, main) | {main}, nx.ancestors(piece, main) | {main}
    reference = next(station for station in stations if station.barcode in onward and station.barcode in back)
    for station in stations:
        _check_station(document, station, reference, onward, back)
    for vehicle in starts:
        if vehicle.start not in back:
            message = f"{vehicle.id} starts at {vehicle.start}, from where no way leads to station {reference.id}"
            document.error(("vehicles", vehicle.id, "start"), message, "start it elsewhere, or add the missing track")
    _check_traps(document, places, piece, onward & back)


def reachable(graph: "nx.DiGraph[str]", stations: Iterable[str]) -> set[str]:
    """Return the barcodes that can be reached from the part of the track with the most stations, and lead back there."""
    main = _main_loop(graph, stations)
    onward: set[str] = nx.descendants(graph, main)
    back: set[str] = nx.ancestors(graph, main)
    return onward & back | {main}


def _main_loop(piece: "nx.DiGraph[str]", stations: Iterable[str]) -> str:
    """Return a barcode of the strongly connected part that has the most stations."""
    parts = list(nx.strongly_connected_components(piece))
    part_of = {barcode: i for i, part in enumerate(parts) for barcode in part}
    served = Counter(part_of[barcode] for barcode in stations)
    best = max(range(len(parts)), key=lambda i: (served[i], len(parts[i])))
    return min(parts[best])


def _check_station(document: Document, station: Station, reference: Station, onward: set[str], back: set[str]) -> None:
    path = ("stations", station.id, "at")
    remedy = "check the direction of the track around it"
    if station.barcode not in onward:
        document.error(path, f"{station.id} at {station.barcode} cannot be reached from {reference.id}", remedy)
    if station.barcode not in back:
        document.error(path, f"{station.id} at {station.barcode} has no way to {reference.id}", remedy)


def _check_traps(document: Document, places: Places, piece: "nx.DiGraph[str]", main: set[str]) -> None:
    for part in nx.strongly_connected_components(piece):
        leaves = any(after not in part for barcode in part for after in piece[barcode])
        if len(part) > 1 and not leaves and not part & main:
            first = min(part)
            message = f"track leads into the loop of {first} and {len(part) - 1} more barcodes, but none leads out"
            document.error(places.barcodes[first], message, "add track out of it", key=True)
