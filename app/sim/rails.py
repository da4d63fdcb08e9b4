"""Which rail each vehicle covers, from physical places alone, and who meets whom."""

from collections import defaultdict, deque
from collections.abc import Iterator, Mapping
from collections.abc import Set as AbstractSet
from dataclasses import dataclass, field
from itertools import combinations
from typing import TypeAlias

from app.domain.ids import VehicleId
from app.domain.layout import Edge, Plant, Point
from app.domain.units import Barcode

Place: TypeAlias = tuple[Barcode, float, Barcode | None]
"""The barcode last passed, mm past it, and the barcode that comes next (None: standing at a barcode)."""
Pair: TypeAlias = tuple[Barcode, Barcode]
TOUCH = 1.0
"""mm by which two stretches may overlap and still only touch: rounding. Our choice."""
FARTHEST_JUMP = 30
"""Barcodes between two looks that still count as driven; more, and the vehicle was put there by hand. Our choice."""


@dataclass(slots=True)
class Cover:
    """What one vehicle covers: the barcodes, and [low, high] mm of each edge."""

    barcodes: set[Barcode] = field(default_factory=set)
    stretches: dict[Pair, tuple[float, float]] = field(default_factory=dict)


class Rails:
    """The rails of a plant and the vehicles' trails on them.

    A vehicle covers its ``length`` behind its front, along the way it came. Where it came from before the first look is
    taken from the map as long as there is only one way; at a merge it is not known and not guessed.
    """

    def __init__(self, plant: Plant) -> None:
        self._lengths: dict[Pair, float] = {(e.start, e.end): float(e.length) for e in plant.edges}
        self._ahead: defaultdict[Barcode, list[Barcode]] = defaultdict(list)
        self._behind: defaultdict[Barcode, list[Barcode]] = defaultdict(list)
        for edge in plant.edges:
            self._ahead[edge.start].append(edge.end)
            self._behind[edge.end].append(edge.start)
        self._vehicle_lengths = {v.id: float(v.length) for v in plant.vehicles}
        self._trails: dict[VehicleId, list[Barcode]] = {}
        self._places: dict[VehicleId, Place] = {}
        self._covers: dict[VehicleId, Cover] = {}
        self._crossings = _crossings(plant)
        self._too_near = _too_near(plant, self._ahead)

    def meetings(self, places: Mapping[VehicleId, Place]) -> Iterator[str]:
        """Move the vehicles to these places and tell who stands on, or too near to, somebody else's rail."""
        moved = False
        for vehicle, place in places.items():
            if self._places.get(vehicle) != place:
                self._places[vehicle] = place
                self._trails[vehicle] = self._trail(vehicle, place)
                self._covers[vehicle] = self._cover(vehicle, place)
                moved = True
        for gone in self._covers.keys() - places.keys():
            del self._covers[gone], self._places[gone], self._trails[gone]
        if moved:
            yield from self._shared_barcodes()
            yield from self._shared_edges()
            yield from self._shared_crossings()

    def vehicles_on(self, edges: AbstractSet[Pair]) -> Iterator[VehicleId]:
        """Give who covers part of one of these edges at its last known place."""
        for vehicle, cover in self._covers.items():
            if any(edge in edges and high - low > TOUCH for edge, (low, high) in cover.stretches.items()):
                yield vehicle

    def _trail(self, vehicle: VehicleId, place: Place) -> list[Barcode]:
        """Return the barcodes behind and at the vehicle, newest last, as far back as it is long."""
        at = place[0]
        trail = self._trails.get(vehicle)
        driven = self._way(trail[-1], at) if trail else None
        trail = [*trail, *driven] if trail and driven is not None else self._only_way_to(vehicle, at)
        need = self._vehicle_lengths[vehicle]
        first = len(trail) - 1
        while first > 0 and need > 0:
            need -= self._lengths[trail[first - 1], trail[first]]
            first -= 1
        return trail[first:]

    def _way(self, start: Barcode, goal: Barcode) -> list[Barcode] | None:
        """Return the barcodes after ``start`` up to ``goal`` with the fewest steps; None: too far to have been driven."""
        queue: deque[tuple[Barcode, ...]] = deque([()])
        seen = {start}
        while queue:
            way = queue.popleft()
            here = way[-1] if way else start
            if here == goal:
                return list(way)
            if len(way) < FARTHEST_JUMP:
                for following in self._ahead[here]:
                    if following not in seen:
                        seen.add(following)
                        queue.append((*way, following))
        return None

    def _only_way_to(self, vehicle: VehicleId, at: Barcode) -> list[Barcode]:
        need = self._vehicle_lengths[vehicle]
        way = [at]
        while need > 0 and len(self._behind[way[0]]) == 1 and len(way) <= len(self._lengths):
            before = self._behind[way[0]][0]
            need -= self._lengths[before, way[0]]
            way.insert(0, before)
        return way

    def _cover(self, vehicle: VehicleId, place: Place) -> Cover:
        at, past, following = place
        left = self._vehicle_lengths[vehicle]
        cover = Cover()
        if following is not None and past > 0:
            cover.stretches[at, following] = (max(0.0, past - left), past)
            left -= past
        if left > 0 or past == 0:
            cover.barcodes.add(at)
        trail = self._trails[vehicle]
        for before, after in zip(reversed(trail[:-1]), reversed(trail), strict=False):
            if left <= 0:
                break
            length = self._lengths[before, after]
            cover.stretches[before, after] = (max(0.0, length - left), length)
            left -= length
            if left > TOUCH:
                cover.barcodes.add(before)
        return cover

    def _shared_barcodes(self) -> Iterator[str]:
        holders: dict[Barcode, VehicleId] = {}
        for vehicle, cover in self._covers.items():
            for barcode in cover.barcodes:
                other = holders.setdefault(barcode, vehicle)
                if other != vehicle:
                    yield f"{other} and {vehicle} both cover barcode {barcode}"
        for barcode, near in self._too_near.items():
            if (vehicle_here := holders.get(barcode)) is not None:
                for neighbour in near:
                    other_there = holders.get(neighbour, vehicle_here)
                    if other_there != vehicle_here:
                        yield f"{vehicle_here} at {barcode} and {other_there} at {neighbour} are nearer than the clearance"

    def _shared_edges(self) -> Iterator[str]:
        taken: dict[Pair, list[tuple[float, float, VehicleId]]] = {}
        for vehicle, cover in self._covers.items():
            for edge, (low, high) in map(self._one_way, cover.stretches.items()):
                others = taken.setdefault(edge, [])
                for other_low, other_high, other in others:
                    if other != vehicle and min(high, other_high) - max(low, other_low) > TOUCH:
                        yield f"{other} and {vehicle} overlap between {edge[0]} and {edge[1]}"
                others.append((low, high, vehicle))

    def _one_way(self, stretch: tuple[Pair, tuple[float, float]]) -> tuple[Pair, tuple[float, float]]:
        """Return a stretch of two-way track in one direction, the same for all: it is one piece of floor."""
        (start, end), (low, high) = stretch
        if start < end or (end, start) not in self._lengths:
            return stretch
        length = self._lengths[start, end]
        return (end, start), (length - high, length - low)

    def _shared_crossings(self) -> Iterator[str]:
        if not self._crossings:
            return
        at: dict[int, VehicleId] = {}
        for vehicle, cover in self._covers.items():
            for edge, (low, high) in cover.stretches.items():
                for number, mm in self._crossings.get(edge, ()):
                    if low < mm < high and at.setdefault(number, vehicle) != vehicle:
                        yield f"{at[number]} and {vehicle} meet where {edge[0]}-{edge[1]} is crossed"


def _crossings(plant: Plant) -> dict[Pair, list[tuple[int, float]]]:
    """Return for each edge that others cross on the plan: the crossing's number and where it is, mm from the start."""
    points = {p.barcode: p for p in plant.points}
    found: defaultdict[Pair, list[tuple[int, float]]] = defaultdict(list)
    edges = sorted(plant.edges, key=lambda e: min(points[e.start].x, points[e.end].x))
    number = 0
    for i, one in enumerate(edges):
        right = max(points[one.start].x, points[one.end].x)
        for other in edges[i + 1 :]:
            if min(points[other.start].x, points[other.end].x) > right:
                break
            if {one.start, one.end} & {other.start, other.end}:
                continue
            where = _meet(one, other, points)
            if where is not None:
                found[one.start, one.end].append((number, where[0] * one.length))
                found[other.start, other.end].append((number, where[1] * other.length))
                number += 1
    return dict(found)


def _meet(one: Edge, other: Edge, points: Mapping[Barcode, Point]) -> tuple[float, float] | None:
    """Return how far along each edge, 0 to 1, the two straight lines cross; None if they do not, or lie side by side."""
    a, b, c, d = points[one.start], points[one.end], points[other.start], points[other.end]
    turn = (b.x - a.x) * (d.y - c.y) - (b.y - a.y) * (d.x - c.x)
    if turn == 0:
        return None
    along_one = ((c.x - a.x) * (d.y - c.y) - (c.y - a.y) * (d.x - c.x)) / turn
    along_other = ((c.x - a.x) * (b.y - a.y) - (c.y - a.y) * (b.x - a.x)) / turn
    return (along_one, along_other) if 0 <= along_one <= 1 and 0 <= along_other <= 1 else None


def _too_near(plant: Plant, ahead: Mapping[Barcode, list[Barcode]]) -> dict[Barcode, list[Barcode]]:
    """Return the barcodes of other branches that are nearer to a barcode than the plant's clearance.

    Two barcodes lie on one branch if a way of at most 8/5 clearance leads from one to the other (a half circle is pi/2
    times its chord), or if they are neighbours.
    """
    found: defaultdict[Barcode, list[Barcode]] = defaultdict(list)
    if plant.clearance <= 0:
        return {}
    lengths = {(e.start, e.end): e.length for e in plant.edges}
    following = {p.barcode: _following(p.barcode, plant.clearance * 8 / 5, ahead, lengths) for p in plant.points}
    for one, other in combinations(plant.points, 2):
        near = (one.x - other.x) ** 2 + (one.y - other.y) ** 2 < plant.clearance**2
        apart = other.barcode not in following[one.barcode] and one.barcode not in following[other.barcode]
        if near and apart:
            found[one.barcode].append(other.barcode)
    return dict(found)


def _following(
    start: Barcode, mm: float, ahead: Mapping[Barcode, list[Barcode]], lengths: Mapping[Pair, int]
) -> set[Barcode]:
    found = set(ahead.get(start, ()))
    queue = [(start, mm)]
    best: dict[Barcode, float] = {}
    while queue:
        here, left = queue.pop()
        if best.get(here, -1.0) >= left:
            continue
        best[here] = left
        found.add(here)
        queue += [(to, left - lengths[here, to]) for to in ahead.get(here, ()) if lengths[here, to] <= left]
    return found
