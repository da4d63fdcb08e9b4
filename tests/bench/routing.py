"""One route over a large plant, against networkx on the same graph."""

import random
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from itertools import pairwise
from typing import Any

import networkx as nx

from app.domain.layout import Edge, Plant, Point
from app.domain.units import Barcode, Millimetres
from app.planning.routing import Router
from app.planning.track import Track
from tests.bench.measuring import Row, in_turn

WIDTH = 200
"""Barcodes of a rail from one side of the hall to the other."""
CROSSINGS = (0, 50, 100, 150, WIDTH - 1)
UP = {0, 100}


def hall(rails: int) -> Plant:
    """Return a hall of so many long rails (even), every other one in the opposite direction, joined by five cross rails."""

    def at(rail: int, place: int) -> Barcode:
        return Barcode(str(1000 * (rail + 1) + place))

    points = [
        Point(at(rail, place), Millimetres(1000 * place), Millimetres(2000 * rail))
        for rail in range(rails)
        for place in range(WIDTH)
    ]
    ways = []
    for rail in range(rails):
        places = range(WIDTH) if rail % 2 == 0 else range(WIDTH - 1, -1, -1)
        ways.append([at(rail, place) for place in places])
    for place in CROSSINGS:
        order = range(rails - 1, -1, -1) if place in UP else range(rails)
        ways.append([at(rail, place) for rail in order])
    edges = [Edge(a, b, Millimetres(1000)) for way in ways for a, b in pairwise(way)]
    return Plant("hall", tuple(points), tuple(edges), (), ())


def per_route(route: Callable[[Barcode, Barcode], Any], pairs: Sequence[tuple[Barcode, Barcode]]) -> float:
    """Return the microseconds of CPU for each route."""
    began = time.thread_time_ns()
    for start, goal in pairs:
        route(start, goal)
    return (time.thread_time_ns() - began) / len(pairs) / 1000


def rows() -> Iterator[Row]:
    """Measure routes between random places."""
    for rails, asked, goal in ((50, 20, 1 / 300), (250, 5, 1 / 1000)):
        track = Track(hall(rails))
        router = Router(track)
        barcodes = sorted(track.graph)
        draw = random.Random(1)
        pairs = [(draw.choice(barcodes), draw.choice(barcodes)) for _ in range(500)]
        per_route(router.route, pairs)
        library = partial(nx.shortest_path, track.graph, weight="time")
        floor, ours = in_turn(3, partial(per_route, library, pairs[:asked]), partial(per_route, router.route, pairs))
        yield Row(
            f"one route, {len(barcodes):,} barcodes; floor: networkx shortest_path",
            ours, floor, None, "µs CPU/route", goal,
        )  # fmt: skip
