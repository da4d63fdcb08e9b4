"""What a closure or new weights cost: the tables of a whole fab, and how late the event loop is while they are made."""

import asyncio
import random
import statistics
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import partial
from itertools import cycle
from typing import Any

import networkx as nx
import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import dijkstra

from app.domain.units import Barcode
from app.planning.arcs import EdgeKey
from app.planning.routing import Router
from app.planning.tables import Floats, Tables, compute
from app.planning.track import Track
from app.plant.fab import SIZES, generate
from app.runtime.replanning import Replanner
from tests.bench.measuring import Row, in_turn

BEAT = 0.002
"""Seconds between two looks at how late the loop is."""
WATCH = 5.0
"""Seconds of watching, with the planner on and off in turn."""


def rows() -> Iterator[Row]:
    """Measure making tables, and the loop meanwhile."""
    for size in ("10k", "50k-dense"):
        track = Track(generate(SIZES[size], 1).plant)
        router = Router(track, inline=-1)
        yield _tables(size, track, router)
        if size == "50k-dense":
            yield _lateness(track, router)


def _tables(size: str, track: Track, router: Router) -> Row:
    router.slow(_slower(track, router, dict.fromkeys(list(track.graph.edges)[:100], 60.0)))
    task = router.replan()
    assert task is not None
    junctions = _junctions(track)
    ours, floor = in_turn(3, partial(_cpu, partial(compute, task)), partial(_cpu, partial(dijkstra, junctions)))
    router.adopt(compute(task))
    forks = len(task.plan.first) - 1
    return Row(
        f"a closure takes effect, {size} fab, {forks:,} forks; floor: one scipy call over its merges and diverges",
        ours, floor, None, "ms CPU", 1.0,
    )  # fmt: skip


def _slower(track: Track, router: Router, seconds: Mapping[EdgeKey, float]) -> Floats:
    """Return how many times as long as on an empty track each edge takes, if these take so many seconds."""
    factors = np.ones(len(router.edges))
    for edge, took in seconds.items():
        factors[router.edges[edge]] = took / track.graph.edges[edge]["time"]
    return factors


def _junctions(track: Track) -> csr_array:
    """Return the track between merges and diverges as scipy takes it."""
    graph: nx.DiGraph[Any] = nx.DiGraph()
    ends = [b for b in track.barcodes if not len(track.successors(b)) == len(track.predecessors(b)) == 1]
    known = set(ends)
    for tail in ends:
        for head in track.successors(tail):
            here, seconds = head, track.graph.edges[tail, head]["time"]
            while here not in known:
                after = track.successors(here)[0]
                seconds, here = seconds + track.graph.edges[here, after]["time"], after
            graph.add_edge(tail, here, weight=seconds)
    return csr_array(nx.to_scipy_sparse_array(graph))


def _cpu(call: Callable[[], object]) -> float:
    """Return the milliseconds of CPU that a call takes."""
    began = time.thread_time_ns()
    call()
    return (time.thread_time_ns() - began) / 1e6


def _lateness(track: Track, router: Router) -> Row:
    if sys.platform == "win32":
        runner = asyncio.Runner()
    else:
        import uvloop

        runner = asyncio.Runner(loop_factory=uvloop.new_event_loop)
    with runner:
        off, on, made = runner.run(_watched(track, router))
    return Row(
        "event-loop lateness p99 while the planner re-plans without a pause, 50k-dense fab; floor: planner off",
        on, off, None, "ms", 2.0, note=f"{made} tables adopted in {2 * WATCH:.0f} s",
    )  # fmt: skip


async def _watched(track: Track, router: Router) -> tuple[float, float, int]:
    """Return the p99 of lateness with the planner off and on, in turn, in ms, and how many tables were adopted."""
    draw, made, on = random.Random(1), 0, False
    edges, barcodes = list(track.graph.edges), track.barcodes
    drawn = ({edge: draw.uniform(1, 60) for edge in draw.sample(edges, 500)} for _ in range(20))
    weights = cycle([_slower(track, router, seconds) for seconds in drawn])

    def want() -> None:
        router.slow(next(weights))
        task = router.replan()
        if task is not None:
            replanner.submit(task)

    def adopt(tables: Tables) -> None:
        nonlocal made
        made += router.adopt(tables)
        if on:  # in a later round of the loop, as the controller asks after an input
            asyncio.get_running_loop().call_soon(want)

    replanner = Replanner(adopt)
    late: dict[bool, list[float]] = {False: [], True: []}
    for _ in range(2):
        for on in (False, True):
            if on:
                want()
            late[on].append(await _p99(barcodes, router, draw))
    await replanner.stop()
    return statistics.median(late[False]), statistics.median(late[True]), made


async def _p99(barcodes: Sequence[Barcode], router: Router, draw: random.Random) -> float:
    """Return the p99 of how late the loop is, in ms, while it plans a few routes in each beat as a controller does."""
    late: list[float] = []
    end = time.perf_counter() + WATCH  # the loop's own clock counts whole milliseconds
    while (due := time.perf_counter() + BEAT) < end:
        await asyncio.sleep(BEAT)
        late.append(time.perf_counter() - due)
        for _ in range(5):
            router.route(*draw.sample(barcodes, 2))
    return float(np.percentile(late, 99)) * 1000
