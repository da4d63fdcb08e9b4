"""Routes over a whole fab: what they cost, and the tables that give them."""

import random
from itertools import pairwise

import networkx as nx
import numpy as np
import pytest
from scipy.sparse.csgraph import dijkstra

from app.domain.units import Barcode
from app.planning import tables
from app.planning.arcs import contract
from app.planning.routing import Router
from app.planning.tables import Elimination, Task, compute, planned, seconds_to
from app.planning.track import Track
from app.planning.walking import walking
from app.plant.fab import SIZES, generate
from tests.planning.weights import weigh


@pytest.fixture(scope="module")
def fab() -> Track:
    return Track(generate(SIZES["10k"], 1).plant)


def test_routes_of_a_thousand_pairs_in_a_fab_cost_what_networkx_says(fab: Track) -> None:
    draw = random.Random(4)
    router = Router(fab, inline=-1)
    graph = fab.graph.copy()
    closed = draw.sample(fab.barcodes, 12)
    seconds = {edge: draw.uniform(0.1, 5.0) for edge in draw.sample(list(graph.edges), 3000)}
    router.close(*closed)
    weigh(router, fab, seconds)
    task = router.replan()
    assert task is not None
    assert router.adopt(compute(task))
    for (a, b), time in seconds.items():
        graph.edges[a, b]["time"] = max(time, graph.edges[a, b]["time"])
    graph.remove_edges_from([(a, b) for a, b in graph.edges if b in closed])
    found = 0
    for start in draw.sample(fab.barcodes, 10):
        reached = nx.single_source_dijkstra_path_length(graph, start, weight="time")
        goals: list[Barcode] = draw.sample(fab.barcodes, 100)
        times = router.table([start], goals)[0]
        for goal, time in zip(goals, times.tolist(), strict=True):
            assert time == pytest.approx(reached.get(goal, np.inf), rel=1e-9)
            if goal in reached:
                found += 1
                path = router.route(start, goal)
                assert (path[0], path[-1]) == (start, goal)
                cost = sum(graph.edges[edge]["time"] for edge in pairwise(path))
                assert cost == pytest.approx(reached[goal], rel=1e-9)
    assert found > 500


def test_elimination_and_dijkstra_make_the_same_tables(fab: Track, monkeypatch: pytest.MonkeyPatch) -> None:
    arcs = contract(fab)
    ends = list(zip(arcs.tails, arcs.heads, strict=True))[: arcs.approaches]
    draw = np.random.default_rng(3)
    size = len(arcs.forks)
    assert arcs.plan.core == size
    monkeypatch.setattr(tables, "MOST_THROUGH", 6)
    few = Elimination(size, ends)
    number = {fork: place for place, fork in enumerate(few.order)}
    begins = arcs.plan.begins.tolist()
    over = [arcs.plan.over[begin:end].tolist() for begin, end in pairwise(begins)]
    plan = planned([(number[tail], number[head]) for tail, head in ends], few, over)
    assert 0 < plan.core < size
    edges = draw.uniform(0.1, 60, len(arcs.edges))
    shut = tuple(draw.integers(0, len(ends), 20).tolist())
    seconds = arcs.plan.whole(arcs.plan.at(edges), shut)
    whole, half = (compute(Task(1, way, edges, shut)) for way in (arcs.plan, plan))
    order = np.array([number[fork] for fork in range(size)])
    assert np.allclose(whole.seconds, half.seconds[np.ix_(order, order)], rtol=1e-12)
    graph = tables._graph(arcs.plan, tables._direct(arcs.plan, seconds)[0])
    assert np.allclose(whole.seconds, dijkstra(graph), rtol=1e-12)
    assert np.allclose(seconds_to(arcs.plan, seconds, [7, 9]), whole.seconds[:, [7, 9]].T, rtol=1e-12)


def test_the_same_task_gives_the_same_tables_to_the_byte(fab: Track) -> None:
    first, second = (Router(fab).view.tables for _ in range(2))
    assert first.seconds.tobytes() == second.seconds.tobytes()
    assert first.hop.tobytes() == second.hop.tobytes()
    assert first.parts.tobytes() == second.parts.tobytes()


def test_walking_by_numbers_costs_what_the_routes_do(fab: Track) -> None:
    draw = random.Random(5)
    router = Router(fab)
    goals = draw.sample(fab.barcodes, 20)
    walk = walking(fab, router.view, goals)
    assert len(walk.turn) <= len(goals)
    times = fab.graph.edges
    for number, goal in enumerate(goals):
        for start in draw.sample(range(len(fab.barcodes)), 2):
            here, path = start, [fab.barcodes[start]]
            while path[-1] != goal:
                fork = walk.fork[here]
                here = int(walk.ahead[here] if fork < 0 else walk.turn[walk.column[number], fork])
                path.append(fab.barcodes[here])
            assert sum(times[edge]["time"] for edge in pairwise(path)) == pytest.approx(router.time(path[0], goal))
