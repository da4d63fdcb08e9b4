"""The tape on the floor as a simulated AGV knows it: tags, the pieces between them, and places with names."""

import heapq
from collections.abc import Iterable, Mapping
from itertools import count

from app.domain.devices import Steering
from app.domain.layout import Edge
from app.domain.units import Barcode

Turn = tuple[Barcode, Barcode]


def both_ways(edges: Iterable[Edge]) -> list[Edge]:
    """Return the pieces and the same ones the other way."""
    return [way for edge in edges for way in (edge, flipped(edge))]


def flipped(edge: Edge) -> Edge:
    """Return a piece as it is driven backwards."""
    return Edge(edge.end, edge.start, edge.length, edge.speed, edge.sensor, edge.curve)


class Tape:
    """Pieces of tape between neighbouring tags, each to be driven one way; two-way tape is two pieces.

    ``places`` are the tags of destinations with a name; ``chargers`` those of the chargers, if not those named C1 to C4.
    ``turns`` says of a piece (from, to) where MoveAuto must steer for it; the first piece without one is straight on.
    """

    __slots__ = ("_ahead", "_behind", "_turns", "chargers", "places")

    def __init__(
        self,
        edges: Iterable[Edge],
        places: Mapping[str, Barcode] | None = None,
        chargers: Iterable[Barcode] | None = None,
        turns: Mapping[Turn, Steering] | None = None,
    ) -> None:
        self._turns = dict(turns or {})
        self.lay(edges, places, chargers)

    def lay(
        self,
        edges: Iterable[Edge],
        places: Mapping[str, Barcode] | None = None,
        chargers: Iterable[Barcode] | None = None,
    ) -> None:
        """Lay the tape, instead of what there was. Who drives ends the way that was begun, and then finds the new tape."""
        self.places = dict(places or {})
        named = [tag for name, tag in self.places.items() if name in ("C1", "C2", "C3", "C4")]
        self.chargers = tuple(named if chargers is None else chargers)
        self._ahead: dict[Barcode, dict[Barcode, Edge]] = {}
        self._behind: dict[Barcode, dict[Barcode, Edge]] = {}
        for edge in edges:
            for tag in (edge.start, edge.end):
                self._ahead.setdefault(tag, {})
                self._behind.setdefault(tag, {})
            self._ahead[edge.start][edge.end] = edge
            self._behind[edge.end][edge.start] = edge

    def __contains__(self, tag: object) -> bool:
        return tag in self._ahead

    @property
    def tags(self) -> Iterable[Barcode]:
        """All tags, in the order in which the pieces name them."""
        return self._ahead.keys()

    def edge(self, start: Barcode, end: Barcode) -> Edge | None:
        """Return the piece from one tag to the next, or None."""
        return self._ahead.get(start, {}).get(end)

    def onward(self, tag: Barcode, came_from: Barcode | None, steering: int) -> Edge | None:
        """Return the piece that an AGV follows forwards from a tag; None at the end of the tape."""
        ways = [edge for edge in self._ahead[tag].values() if edge.end != came_from]
        steered = [edge for edge in ways if self._turns.get((tag, edge.end)) == steering]
        straight = [edge for edge in ways if self._turns.get((tag, edge.end), Steering.STRAIGHT) is Steering.STRAIGHT]
        return next(iter(steered or straight or ways), None)

    def backward(self, tag: Barcode, came_from: Barcode | None) -> Edge | None:
        """Return the piece that an AGV drives backwards from a tag, as it is then driven; None at the end of the tape."""
        ways = self._behind[tag]
        edge = ways.get(came_from) if came_from is not None and came_from in ways else next(iter(ways.values()), None)
        return None if edge is None else flipped(edge)

    def route(self, start: Barcode, goal: Barcode) -> tuple[Edge, ...] | None:
        """Return the shortest way; empty if there is nowhere to go, None if there is no way."""
        order = count()
        heap: list[tuple[int, int, Barcode, tuple[Edge, ...]]] = [(0, next(order), start, ())]
        seen: set[Barcode] = set()
        while heap:
            length, _, tag, way = heapq.heappop(heap)
            if tag == goal:
                return way
            if tag in seen:
                continue
            seen.add(tag)
            for edge in self._ahead.get(tag, {}).values():
                heapq.heappush(heap, (length + edge.length, next(order), edge.end, (*way, edge)))
        return None
