"""The floor that AGVs drive on, and its single-track corridors (TRAFFIC section 5)."""

from collections.abc import Iterable, Iterator, Mapping
from collections.abc import Set as AbstractSet
from typing import TypeAlias

import networkx as nx

from app.domain.ids import ZoneId
from app.domain.layout import Plant, VehicleKind, Zone
from app.domain.units import Barcode

Neighbours: TypeAlias = Mapping[Barcode, AbstractSet[Barcode]]


def kinds_on(plant: Plant, area: AbstractSet[Barcode]) -> frozenset[VehicleKind]:
    """Return the kinds of vehicle that a connected stretch of track is for: both where nothing tells.

    Stations, chargers and the starts of vehicles tell.
    """
    found = {kind for s in plant.stations if s.barcode in area for kind in VehicleKind if s.kind in kind.serves}
    found |= {VehicleKind.AGV for charger in plant.chargers if charger.barcode in area}
    found |= {vehicle.kind for vehicle in plant.vehicles if vehicle.start in area}
    return frozenset(found or VehicleKind)


def floor_of(plant: Plant) -> frozenset[Barcode]:
    """Return the barcodes that AGVs read: all of every connected stretch that is for them alone."""
    if all(vehicle.kind is not VehicleKind.AGV for vehicle in plant.vehicles):
        return frozenset()
    graph: nx.Graph[Barcode] = nx.Graph((edge.start, edge.end) for edge in plant.edges)
    graph.add_nodes_from(point.barcode for point in plant.points)
    pieces = nx.connected_components(graph)
    return frozenset(b for piece in pieces if kinds_on(plant, piece) == {VehicleKind.AGV} for b in piece)


def corridors(plant: Plant, floor: AbstractSet[Barcode]) -> tuple[Zone, ...]:
    """Return the no-stop zones that keep two AGVs from meeting head on, each for one vehicle.

    A corridor is a chain of two-way track without a branch, with the dead end that it may lead to; a junction of two-way
    track is one by itself. Between them lie the places where a vehicle may wait for another: one-way track, and barcodes
    marked ``park``. A vehicle enters only if it is granted all the way through, or to its goal inside.
    """
    pairs = {(e.start, e.end) for e in plant.edges if e.start in floor}
    around: dict[Barcode, set[Barcode]] = {barcode: set() for barcode in sorted(floor)}
    for start, end in sorted(pairs):
        around[start].add(end)
        around[end].add(start)
    parks = {point.barcode for point in plant.points if point.park}
    two_way = {b for b, others in around.items() if others and all({(b, o), (o, b)} <= pairs for o in others)}
    inside = {b for b in two_way if len(around[b]) <= 2 and b not in parks}
    junctions = [
        b
        for b, others in around.items()
        if len(others) > 2 and b not in parks and any((b, o) in pairs and (o, b) in pairs for o in others)
    ]
    chains = list(_chains(inside, around))
    return tuple(
        Zone(ZoneId(f"two-way {'-'.join(dict.fromkeys((min(chain), max(chain))))}"), frozenset(chain), 1, no_stop=True)
        for chain in (*chains, *([junction] for junction in junctions))
    )


def _chains(inside: AbstractSet[Barcode], around: Neighbours) -> Iterator[Iterable[Barcode]]:
    """Give the chains of barcodes inside corridors; a lone dead end is none, since a barcode has one holder anyway."""
    graph: nx.Graph[Barcode] = nx.Graph()
    graph.add_nodes_from(sorted(inside))
    graph.add_edges_from((b, o) for b in sorted(inside) for o in sorted(around[b]) if o in inside)
    for chain in nx.connected_components(graph):
        if len(chain) > 1 or any(len(around[barcode]) > 1 for barcode in chain):
            yield sorted(chain)
