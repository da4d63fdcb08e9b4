"""The track of a plant as a graph: neighbours, stretches, areas, and which barcodes exclude each other."""

from collections import defaultdict
from collections.abc import Iterable, Sequence
from heapq import heappop, heappush
from itertools import chain, pairwise
from typing import TypeAlias, TypeVar

import networkx as nx

from app.domain.ids import DevId, VehicleId
from app.domain.layout import Edge, Plant, Point, Station, VehicleKind, VehicleSpec, Zone
from app.domain.units import Barcode, Millimetres
from app.planning.clearance import crossing_edges, near_points
from app.planning.floor import corridors, floor_of, kinds_on
from app.planning.kinematics import edge_time

Links: TypeAlias = dict[Barcode, list[tuple[Barcode, Millimetres]]]
Item = TypeVar("Item")
NOTHING: frozenset[Barcode] = frozenset()
BOOK_VEHICLE = VehicleSpec(VehicleId("book"), DevId(0))
"""The vehicle of PROTOCOLS 5.1, for a plant that has none."""


def _by_barcode(items: Iterable[tuple[Barcode, Item]]) -> dict[Barcode, tuple[Item, ...]]:
    found: defaultdict[Barcode, tuple[Item, ...]] = defaultdict(tuple)
    for barcode, item in items:
        found[barcode] += (item,)
    return found


def _within(links: Links, start: Barcode, mm: Millimetres) -> list[Barcode]:
    """Return the barcodes at most ``mm`` from ``start`` along the links, nearest first, ``start`` included."""
    found: dict[Barcode, None] = {}
    queue: list[tuple[int, Barcode]] = [(0, start)]
    while queue:
        way, barcode = heappop(queue)
        if barcode in found:
            continue
        found[barcode] = None
        for neighbour, length in links[barcode]:
            if way + length <= mm:
                heappush(queue, (way + length, neighbour))
    return list(found)


class Track:
    """Rails, stations and zones of one plant, indexed by barcode. Never changes; closures are elsewhere.

    ``graph`` is the public model: nodes with ``x``, ``y``, ``park`` and ``stations`` (ids), edges with ``length``,
    ``speed``, ``sensor``, ``curve`` and ``time``. ``time`` is the free-flow time in seconds of ``reference``; without
    one, of the plant's first vehicle (our choice). ``areas`` are the stretches between which no vehicle can pass and
    across which none can touch: connected by edges, or by conflicts. Methods raise KeyError for a barcode that is not
    on the track. Mappings and sets here are shared: they are not to be changed.
    """

    def __init__(self, plant: Plant, reference: VehicleSpec | None = None) -> None:
        self.plant = plant
        self._points = {point.barcode: point for point in plant.points}
        self._edges = {(edge.start, edge.end): edge for edge in plant.edges}
        self._stations: dict[Barcode, tuple[Station, ...]] = _by_barcode((s.barcode, s) for s in plant.stations)
        self.floor = floor_of(plant)
        """The barcodes that AGVs read."""
        zones = (*plant.zones, *corridors(plant, self.floor))
        self._zones: dict[Barcode, tuple[Zone, ...]] = _by_barcode((b, z) for z in zones for b in z.barcodes)
        self._ahead: Links = {barcode: [] for barcode in self._points}
        self._behind: Links = {barcode: [] for barcode in self._points}
        for edge in self._edges.values():
            self._ahead[edge.start].append((edge.end, edge.length))
            self._behind[edge.end].append((edge.start, edge.length))
        self._around: Links = {b: self._ahead[b] + self._behind[b] for b in self._points}
        self._successors = {b: tuple(n for n, _ in links) for b, links in self._ahead.items()}
        self._predecessors = {b: tuple(n for n, _ in links) for b, links in self._behind.items()}
        self._conflicts = self._find_conflicts()
        self._covered: dict[tuple[Barcode, Millimetres], tuple[Barcode, ...]] = {}
        self.graph = self._draw(reference or next(iter(plant.vehicles), None) or BOOK_VEHICLE)
        self.areas = self._find_areas()
        self._area = {barcode: i for i, area in enumerate(self.areas) for barcode in area}
        self._kinds = tuple(kinds_on(plant, area) for area in self.areas)

    def __contains__(self, barcode: object) -> bool:
        return barcode in self._points

    @property
    def barcodes(self) -> tuple[Barcode, ...]:
        """Return all barcodes in the order of the plant file."""
        return tuple(self._points)

    def point(self, barcode: Barcode) -> Point:
        """Return where the barcode lies."""
        return self._points[barcode]

    def edge(self, start: Barcode, end: Barcode) -> Edge:
        """Return the edge between two neighbours."""
        return self._edges[start, end]

    def successors(self, barcode: Barcode) -> tuple[Barcode, ...]:
        """Return the barcodes that may come next."""
        return self._successors[barcode]

    def predecessors(self, barcode: Barcode) -> tuple[Barcode, ...]:
        """Return the barcodes that may have come before."""
        return self._predecessors[barcode]

    def stations_at(self, barcode: Barcode) -> tuple[Station, ...]:
        """Return the stations served from this barcode."""
        return self._stations.get(barcode, ())

    def zones_at(self, barcode: Barcode) -> tuple[Zone, ...]:
        """Return the zones this barcode lies in."""
        return self._zones.get(barcode, ())

    def no_stop(self, barcode: Barcode) -> bool:
        """Return whether a grant that is not for a goal may not end here."""
        return any(zone.no_stop for zone in self.zones_at(barcode))

    def conflicts(self, barcode: Barcode) -> frozenset[Barcode]:
        """Return the barcodes that no other vehicle may hold while one holds this.

        They are the heads of edges that cross or touch an edge leading here on the plan without sharing a barcode with
        it (a vehicle on an edge holds its head), and barcodes of other branches nearer than the plant's ``clearance``:
        those from which no way of at most 8/5 clearance leads here or back (a half circle is pi/2 times its chord).
        """
        return self._conflicts.get(barcode, NOTHING)

    def covered(self, barcode: Barcode, mm: Millimetres) -> tuple[Barcode, ...]:
        """Return ``behind`` and the barcode itself, farthest first: what ``Traffic.hold`` wants, the same in every run."""
        if (known := self._covered.get((barcode, mm))) is None:
            known = tuple(reversed(_within(self._behind, barcode, mm)))
            self._covered[barcode, mm] = known
        return known

    def behind(self, barcode: Barcode, mm: Millimetres) -> frozenset[Barcode]:
        """Return every barcode at most ``mm`` behind this one, by any branch, without it.

        That is what a vehicle of this length that reports ``barcode`` may cover.
        """
        return frozenset(self.covered(barcode, mm)[:-1])

    def distances_behind(self, barcode: Barcode, mm: Millimetres) -> dict[Barcode, Millimetres]:
        """Return every barcode at most ``mm`` behind this one with its least distance by any branch, nearest first."""
        found: dict[Barcode, Millimetres] = {}
        queue: list[tuple[int, Barcode]] = [(0, barcode)]
        while queue:
            way, here = heappop(queue)
            if here in found:
                continue
            found[here] = Millimetres(way)
            for before, length in self._behind[here]:
                if way + length <= mm:
                    heappush(queue, (way + length, before))
        return found

    def ahead(self, barcode: Barcode, mm: Millimetres) -> frozenset[Barcode]:
        """Return every barcode at most ``mm`` ahead of this one, by any branch, without it."""
        return frozenset(_within(self._ahead, barcode, mm)[1:])

    def reach(self, barcode: Barcode, mm: Millimetres) -> frozenset[Barcode]:
        """Return every barcode within ``mm`` when driving to and fro without regard to direction, this one included."""
        return frozenset(_within(self._around, barcode, mm))

    def area(self, barcode: Barcode) -> int:
        """Return the index in ``areas`` of the area this barcode lies in."""
        return self._area[barcode]

    def kinds(self, area: int) -> frozenset[VehicleKind]:
        """Return the kinds of vehicle that may be in an area."""
        return self._kinds[area]

    def may_rest(self, barcode: Barcode) -> bool:
        """Return whether a vehicle that waits harms nobody's passage here: outside no-stop zones, or at a dead end."""
        around = {*self._successors[barcode], *self._predecessors[barcode]}
        return not self.no_stop(barcode) or (barcode in self.floor and len(around) == 1)

    def distance(self, path: Sequence[Barcode]) -> Millimetres:
        """Return the length of a path of neighbours."""
        return Millimetres(sum(self._edges[pair].length for pair in pairwise(path)))

    def _draw(self, reference: VehicleSpec) -> "nx.DiGraph[Barcode]":
        graph: nx.DiGraph[Barcode] = nx.DiGraph()
        for p in self._points.values():
            stations = tuple(s.id for s in self.stations_at(p.barcode))
            graph.add_node(p.barcode, x=p.x, y=p.y, park=p.park, stations=stations)
        for e in self._edges.values():
            time = edge_time(e, reference)
            graph.add_edge(e.start, e.end, length=e.length, speed=e.speed, sensor=e.sensor, curve=e.curve, time=time)
        return graph

    def _find_conflicts(self) -> dict[Barcode, frozenset[Barcode]]:
        found: defaultdict[Barcode, set[Barcode]] = defaultdict(set)
        crossings = ((e.end, f.end) for e, f in crossing_edges(tuple(self._edges.values()), self._points))
        near = near_points(tuple(self._points.values()), self.plant.clearance)
        for one, other in chain(crossings, self._of_other_branches(near)):
            found[one].add(other)
            found[other].add(one)
        return {barcode: frozenset(others - {barcode}) for barcode, others in found.items()}

    def _of_other_branches(self, pairs: Iterable[tuple[Barcode, Barcode]]) -> Iterable[tuple[Barcode, Barcode]]:
        way = Millimetres(self.plant.clearance * 8 // 5)
        following: dict[Barcode, frozenset[Barcode]] = {}
        for pair in pairs:
            for barcode in pair:
                if barcode not in following:
                    following[barcode] = self.ahead(barcode, way).union(self._successors[barcode])
            if pair[1] not in following[pair[0]] and pair[0] not in following[pair[1]]:
                yield pair

    def _find_areas(self) -> tuple[frozenset[Barcode], ...]:
        touching = nx.Graph(self.graph)
        touching.add_edges_from((b, c) for b, others in self._conflicts.items() for c in others)
        return tuple(frozenset(area) for area in nx.connected_components(touching))
