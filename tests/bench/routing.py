"""One route over a whole fab, against networkx on the same graph."""

import gc
import random
import time
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from typing import Any

import networkx as nx

from app.domain.units import Barcode
from app.planning.routing import Router
from app.planning.track import Track
from app.plant.fab import SIZES, generate
from tests.bench.measuring import Row, in_turn


def per_route(route: Callable[[Barcode, Barcode], Any], pairs: Sequence[tuple[Barcode, Barcode]]) -> float:
    """Return the microseconds of CPU for each route."""
    began = time.thread_time_ns()
    for start, goal in pairs:
        route(start, goal)
    return (time.thread_time_ns() - began) / len(pairs) / 1000


def rows() -> Iterator[Row]:
    """Measure routes between random places: the floor over some of those that ours plans, since it takes milliseconds."""
    for size, asked, goal in (("10k", 100, 1 / 300), ("50k", 100, 1 / 1000), ("50k-dense", 50, 1 / 1000)):
        track = Track(generate(SIZES[size], 1).plant)
        router = Router(track)
        barcodes = sorted(track.graph)
        draw = random.Random(1)
        pairs = [(draw.choice(barcodes), draw.choice(barcodes)) for _ in range(500)]
        per_route(router.route, pairs)
        gc.freeze()  # as the controller does after its start
        library = partial(nx.shortest_path, track.graph, weight="time")
        floor, ours = in_turn(3, partial(per_route, library, pairs[:asked]), partial(per_route, router.route, pairs))
        yield Row(
            f"one route, {size} fab, {len(barcodes):,} barcodes; floor: networkx shortest_path",
            ours, floor, None, "µs CPU/route", goal,
            note=f"floor over {asked} of 500 pairs, of 10 only before, whose ways were shorter or longer than most by chance",
        )  # fmt: skip
        gc.unfreeze()
