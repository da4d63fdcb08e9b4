import pickle
from collections.abc import Callable, Mapping, Sequence
from itertools import islice, pairwise
from math import inf, nan
from typing import TypeAlias

import networkx as nx
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.errors import NoRoute
from app.domain.layout import Edge
from app.domain.units import Barcode, Millimetres, Seconds
from app.planning.arcs import EdgeKey
from app.planning.routing import LONGEST, Route, Router
from app.planning.tables import compute
from app.planning.track import Track
from tests.planning.weights import quickest, weigh

Lay: TypeAlias = Callable[..., Track]
A, B, C, D, E, F, X = (Barcode(name) for name in "abcdefx")


def test_a_route_begins_at_the_start_and_ends_at_the_goal(lay: Lay) -> None:
    assert Router(lay("a b c d")).route(A, D) == [A, B, C, D]


def test_the_quicker_of_two_branches_is_taken(lay: Lay) -> None:
    router = Router(lay("a b c", "b d e c"))
    assert router.route(A, C) == [A, B, C]
    assert router.route(A, E) == [A, B, D, E]


def test_the_quicker_way_may_be_the_longer_one(lay: Lay) -> None:
    track = lay("a b c", edges=[Edge(A, C, Millimetres(1900), curve=True)])
    assert Router(track).route(A, C) == [A, B, C]


def test_being_there_is_a_route_of_one(lay: Lay) -> None:
    router = Router(lay("a b"))
    assert router.route(B, B) == [B]
    assert router.time(B, B) == 0


def test_a_ring_without_branches_is_driven_round(lay: Lay) -> None:
    router = Router(lay("a b c d a"))
    assert router.route(C, B) == [C, D, A, B]
    assert router.time(C, B) == pytest.approx(1.0)


def test_a_barcode_just_behind_is_reached_by_the_whole_way_round(lay: Lay) -> None:
    router = Router(lay("a b c d a", "a x"))
    assert router.route(D, C) == [D, A, B, C]
    assert router.route(B, D) == [B, C, D]
    assert router.time(B, D) == pytest.approx(2 / 3)


def test_times_for_dispatch_agree_with_single_ones(lay: Lay) -> None:
    router = Router(lay("a b c d a", "b e f", "x e"))
    names = [A, B, C, D, E, F, X]
    assert router.times(names, names) == [[router.time(s, g) for g in names] for s in names]
    assert router.times([], names) == []
    assert router.times([A, B], []) == [[], []]


def test_without_a_way_the_time_is_infinite_and_the_refusal_names_both(lay: Lay) -> None:
    router = Router(lay("a b", "c d"))
    assert router.time(A, D) == inf
    with pytest.raises(NoRoute, match=r"^no route from a to d: the track does not connect them$"):
        router.route(A, D)


@pytest.mark.parametrize(("start", "goal"), [(A, X), (X, A), (X, X)])
def test_a_barcode_off_the_track_is_named(lay: Lay, start: Barcode, goal: Barcode) -> None:
    router = Router(lay("a b c", "b d"))
    assert router.time(start, goal) == inf
    assert router.times([start], [goal]) == [[inf]]
    with pytest.raises(NoRoute, match=r"x is not on the track$"):
        router.route(start, goal)


def test_an_empty_track_has_no_routes(lay: Lay) -> None:
    assert Router(lay()).times([A], [A, B]) == [[inf, inf]]


def test_a_closed_barcode_is_driven_round_until_it_opens(lay: Lay) -> None:
    router = Router(lay("a b c f", "a d e c"))
    router.close(B)
    assert list(router.closed) == [B]
    assert router.route(A, F) == [A, D, E, C, F]
    router.open(B)
    assert list(router.closed) == []
    assert router.route(A, F) == [A, B, C, F]


def test_a_closed_edge_is_driven_round_and_its_barcodes_stay_reachable(lay: Lay) -> None:
    router = Router(lay("a b c", "a d b", "d c"))
    router.close((A, B))
    assert router.route(A, B) == [A, D, B]
    assert router.route(B, C) == [B, C]


def test_without_another_way_the_refusal_names_the_closure_and_the_remedy(lay: Lay) -> None:
    router = Router(lay("a b c d"))
    router.close(C)
    with pytest.raises(NoRoute, match=r"^no route from a to d: c is closed$") as refused:
        router.route(A, D)
    assert refused.value.remedy == "open c"
    router.open(C)
    router.close((B, C))
    with pytest.raises(NoRoute, match=r"^no route from b to d: b to c is closed$"):
        router.route(B, D)


def test_a_closed_barcode_cannot_be_a_goal_but_can_be_left(lay: Lay) -> None:
    router = Router(lay("a b c d e"))
    router.close(C)
    assert router.time(A, C) == inf
    assert router.route(C, D) == [C, D]
    assert router.route(C, C) == [C]
    assert router.route(A, B) == [A, B]
    assert router.route(D, E) == [D, E]
    assert router.times([A, C, D], [B, C, E]) == [
        [pytest.approx(1 / 3), inf, inf],
        [inf, 0.0, pytest.approx(2 / 3)],
        [inf, inf, pytest.approx(1 / 3)],
    ]


def test_closing_what_is_not_there_changes_nothing(lay: Lay) -> None:
    router = Router(lay("a b"))
    router.close(X, (B, A))
    router.open(F)
    assert router.route(A, B) == [A, B]


names = st.integers(0, 11).map(lambda i: Barcode(str(i)))
edges = st.lists(
    st.builds(
        lambda ends, length, curve: Edge(ends[0], ends[1], Millimetres(length), curve=curve),
        st.tuples(names, names).filter(lambda ends: ends[0] != ends[1]),
        st.integers(1, 3000),
        st.booleans(),
    ),
    min_size=1,
    max_size=22,
    unique_by=lambda e: (e.start, e.end),
)


def free_track(track: Track, closed: tuple[Barcode | EdgeKey, ...]) -> "nx.DiGraph[Barcode]":
    graph = track.graph.copy()
    graph.remove_edges_from([(a, b) for a, b in track.graph.edges if b in closed or (a, b) in closed])
    return graph


LATER = -1
"""So many forks are computed inline: the tables of every track are computed elsewhere."""


def weighed(
    track: Track, closed: tuple[Barcode | EdgeKey, ...], seconds: Mapping[EdgeKey, float]
) -> "nx.DiGraph[Barcode]":
    """Return the open track with these seconds, or those of an empty track where they are more."""
    graph = track.graph.copy()
    for (a, b), time in seconds.items():
        graph.edges[a, b]["time"] = max(time, graph.edges[a, b]["time"])
    graph.remove_edges_from([(a, b) for a, b in track.graph.edges if b in closed or (a, b) in closed])
    return graph


def costs(graph: "nx.DiGraph[Barcode]", path: Sequence[Barcode]) -> float:
    assert len(set(path)) == len(path)
    return float(sum(graph.edges[pair]["time"] for pair in pairwise(path)))


def assert_equals_networkx(router: Router, graph: "nx.DiGraph[Barcode]") -> None:
    names = list(graph)
    times = router.times(names, names)
    for row, start in enumerate(names):
        expected = nx.single_source_dijkstra_path_length(graph, start, weight="time")
        for column, goal in enumerate(names):
            assert times[row][column] == pytest.approx(expected.get(goal, inf))
            assert router.time(start, goal) == pytest.approx(expected.get(goal, inf))
            if goal not in expected:
                with pytest.raises(NoRoute):
                    router.route(start, goal)
                continue
            route = quickest(router, start, goal)
            assert (route.barcodes[0], route.barcodes[-1]) == (start, goal)
            assert costs(graph, route.barcodes) == pytest.approx(expected[goal])
            assert route.seconds == pytest.approx(expected[goal])


def replanned(router: Router) -> None:
    """Compute and adopt what a router wants, in another process as it were."""
    while (task := router.replan()) is not None:
        assert router.adopt(pickle.loads(pickle.dumps(compute(pickle.loads(pickle.dumps(task))))))


@settings(max_examples=25)
@given(edges, st.data(), st.sampled_from([LATER, 300]))
def test_routes_cost_what_networkx_says_with_closures_and_weights(
    lay: Lay, rails: list[Edge], data: st.DataObject, inline: int
) -> None:
    track = lay(edges=rails)
    router = Router(track, inline)
    places: list[Barcode | EdgeKey] = [*track.barcodes, *((e.start, e.end) for e in rails)]
    router.close(*data.draw(st.lists(st.sampled_from(places), max_size=3)))
    seconds = data.draw(st.dictionaries(st.sampled_from([(e.start, e.end) for e in rails]), st.floats(0, 9)))
    weigh(router, track, seconds)
    replanned(router)
    assert_equals_networkx(router, weighed(track, router.closed, seconds))


@settings(max_examples=25)
@given(edges, st.data())
def test_until_new_tables_come_no_route_leads_over_what_is_closed_and_what_is_open_is_found(
    lay: Lay, rails: list[Edge], data: st.DataObject
) -> None:
    track = lay(edges=rails)
    router = Router(track, LATER)
    places: list[Barcode | EdgeKey] = [*track.barcodes, *((e.start, e.end) for e in rails)]
    some = st.lists(st.sampled_from(places), max_size=3)
    router.close(*data.draw(some))
    replanned(router)
    router.open(*data.draw(some))
    router.close(*data.draw(some))
    graph = weighed(track, router.closed, {})
    for start in track.barcodes:
        reached = nx.single_source_dijkstra_path_length(graph, start, weight="time")
        for goal in track.barcodes:
            if goal in reached:
                path = router.route(start, goal)
                assert (path[0], path[-1]) == (start, goal)
                assert costs(graph, path) >= reached[goal] - 1e-9
            else:
                with pytest.raises(NoRoute):
                    router.route(start, goal)
    replanned(router)
    assert_equals_networkx(router, graph)


@settings(max_examples=25)
@given(edges, st.data())
def test_a_new_closure_is_driven_round_at_once_by_the_quickest_way(
    lay: Lay, rails: list[Edge], data: st.DataObject
) -> None:
    track = lay(edges=rails)
    router = Router(track, LATER)
    router.close(*data.draw(st.lists(st.sampled_from(track.barcodes), max_size=3)))
    graph = weighed(track, router.closed, {})
    for start in track.barcodes:
        reached = nx.single_source_dijkstra_path_length(graph, start, weight="time")
        for goal, expected in reached.items():
            assert costs(graph, router.route(start, goal)) == pytest.approx(expected)


def test_a_version_counts_from_when_its_tables_are_adopted(lay: Lay) -> None:
    track = lay("a b c f", "a d e c")
    router = Router(track, LATER)
    assert (router.version, router.replan()) == (1, None)
    weigh(router, track, {(A, B): 9.0})
    task = router.replan()
    assert task is not None
    assert router.replan() is None
    assert quickest(router, A, F) == Route((A, B, C, F), Seconds(1.0), Seconds(1.0), 1)
    assert router.adopt(compute(task))
    route = quickest(router, A, F)
    assert (route.barcodes, route.version) == ((A, D, E, C, F), 2)
    assert not router.adopt(compute(task))


def test_tables_that_are_late_are_still_used_and_the_newest_asked_for(lay: Lay) -> None:
    track = lay("a b c f", "a d e c")
    router = Router(track, LATER)
    weigh(router, track, {(A, B): 9.0})
    first = router.replan()
    weigh(router, track, {(A, D): 99.0})
    assert first is not None
    assert router.adopt(compute(first))
    assert router.route(A, F) == [A, D, E, C, F]
    second = router.replan()
    assert second is not None
    assert second.version > first.version
    assert router.adopt(compute(second))
    assert router.route(A, F) == [A, B, C, F]


def test_an_edge_never_takes_less_than_on_an_empty_track(lay: Lay) -> None:
    track = lay("a b c")
    router = Router(track)
    weigh(router, track, {(A, B): 0.01, (B, C): 4.0})
    assert router.seconds[router.edges[A, B]] == pytest.approx(1 / 3)
    route = quickest(router, A, C)
    assert route.seconds == pytest.approx(4 + 1 / 3)
    assert route.free_flow == pytest.approx(2 / 3)
    weigh(router, track, {(B, C): 0.0})
    assert quickest(router, A, C).seconds == pytest.approx(2 / 3)


def test_no_weight_is_a_closure_and_what_is_no_number_is_the_empty_track(lay: Lay) -> None:
    track = lay("a b c", "a d e c")
    router = Router(track)
    weigh(router, track, {(A, B): inf, (B, C): nan})
    assert router.seconds[router.edges[A, B]] == LONGEST
    assert router.seconds[router.edges[B, C]] == pytest.approx(1 / 3)
    assert router.route(A, C) == [A, D, E, C]
    router.close(D)
    assert quickest(router, A, C).seconds == pytest.approx(LONGEST + 1 / 3)


def test_what_changes_nothing_makes_no_new_version(lay: Lay) -> None:
    track = lay("a b c", "a d c")
    router = Router(track, LATER)
    router.close(X, (C, A))
    router.open(B)
    weigh(router, track, {(A, B): 0.0})
    weigh(router, track, {})
    assert router.replan() is None


@settings(max_examples=25)
@given(edges, st.data())
def test_alternatives_are_the_quickest_simple_paths_of_networkx(
    lay: Lay, rails: list[Edge], data: st.DataObject
) -> None:
    track = lay(edges=rails)
    router = Router(track)
    router.close(*data.draw(st.lists(st.sampled_from(track.barcodes), max_size=1)))
    graph = weighed(track, router.closed, {})
    start, goal = data.draw(st.sampled_from(track.barcodes)), data.draw(st.sampled_from(track.barcodes))
    if start == goal or not nx.has_path(graph, start, goal):
        return
    expected = list(islice(nx.shortest_simple_paths(graph, start, goal, weight="time"), 6))
    found = router.alternatives(start, goal, 6)
    assert len(found) == len({route.barcodes for route in found}) == len(expected)
    for route, path in zip(found, expected, strict=True):
        assert costs(graph, route.barcodes) == pytest.approx(costs(graph, path))
        assert route.seconds == pytest.approx(costs(graph, path))


def test_there_are_as_many_alternatives_as_asked_for_quickest_first(lay: Lay) -> None:
    router = Router(lay("a b c d e", "a x c", "c f d"))
    assert [route.barcodes for route in router.alternatives(A, E, 2)] == [(A, B, C, D, E), (A, X, C, D, E)]
    assert len(router.alternatives(A, E, 9)) == 4
    assert [route.barcodes for route in router.alternatives(A, A, 9)] == [(A,)]
    with pytest.raises(NoRoute):
        router.alternatives(E, A, 3)


def test_alternatives_keep_off_a_closure_at_once(lay: Lay) -> None:
    router = Router(lay("a b c e", "a d c", "a x f c"), LATER)
    router.close(D)
    assert [route.barcodes for route in router.alternatives(A, E, 9)] == [(A, B, C, E), (A, X, F, C, E)]
    replanned(router)
    router.open(D)
    assert len(router.alternatives(A, E, 9)) == 3


@settings(max_examples=50)
@given(edges, st.data())
def test_what_can_be_reached_is_what_networkx_reaches_with_and_without_closures(
    lay: Lay, rails: list[Edge], data: st.DataObject
) -> None:
    track = lay(edges=rails)
    router = Router(track, LATER)
    places: list[Barcode | EdgeKey] = [*track.barcodes, *((e.start, e.end) for e in rails)]
    router.close(*data.draw(st.lists(st.sampled_from(places), max_size=3)))
    starts = data.draw(st.lists(st.sampled_from(track.barcodes), max_size=3))
    for anyway, graph in ((False, weighed(track, router.closed, {})), (True, track.graph)):
        there = {goal for start in starts for goal in nx.descendants(graph, start) | {start}}
        expected = [barcode in there for barcode in track.barcodes]
        reach = router.reach(starts, anyway=anyway)
        assert [reach.leads_to(barcode) for barcode in track.barcodes] == expected


def test_a_way_costs_what_its_edges_do_whatever_is_closed_on_it(lay: Lay) -> None:
    track = lay("a b c", "a d e c")
    router = Router(track)
    weigh(router, track, {(A, B): 4.0})
    router.close(B)
    assert router.along((A, B, C)) == pytest.approx(4 + 1 / 3)
    assert router.along((A, D, E, C)) == pytest.approx(router.time(A, C))
    assert router.along((A,)) == 0
