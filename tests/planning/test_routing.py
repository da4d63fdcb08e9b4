from collections.abc import Callable
from itertools import pairwise
from math import inf
from typing import TypeAlias

import networkx as nx
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.domain.errors import NoRoute
from app.domain.layout import Edge
from app.domain.units import Barcode, Millimetres
from app.planning import routing
from app.planning.routing import EdgeKey, Router
from app.planning.track import Track

Lay: TypeAlias = Callable[..., Track]
A, B, C, D, E, F, X = (Barcode(name) for name in "abcdefx")


def test_a_route_begins_at_the_start_and_ends_at_the_goal(lay: Lay) -> None:
    assert Router(lay("a b c d")).route(A, D) == (A, B, C, D)


def test_the_quicker_of_two_branches_is_taken(lay: Lay) -> None:
    router = Router(lay("a b c", "b d e c"))
    assert router.route(A, C) == (A, B, C)
    assert router.route(A, E) == (A, B, D, E)


def test_the_quicker_way_may_be_the_longer_one(lay: Lay) -> None:
    track = lay("a b c", edges=[Edge(A, C, Millimetres(1900), curve=True)])
    assert Router(track).route(A, C) == (A, B, C)


def test_being_there_is_a_route_of_one(lay: Lay) -> None:
    router = Router(lay("a b"))
    assert router.route(B, B) == (B,)
    assert router.time(B, B) == 0


def test_a_ring_without_branches_is_driven_round(lay: Lay) -> None:
    router = Router(lay("a b c d a"))
    assert router.route(C, B) == (C, D, A, B)
    assert router.time(C, B) == pytest.approx(1.0)


def test_a_barcode_just_behind_is_reached_by_the_whole_way_round(lay: Lay) -> None:
    router = Router(lay("a b c d a", "a x"))
    assert router.route(D, C) == (D, A, B, C)
    assert router.route(B, D) == (B, C, D)
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
    assert router.route(A, F) == (A, D, E, C, F)
    router.open(B)
    assert list(router.closed) == []
    assert router.route(A, F) == (A, B, C, F)


def test_a_closed_edge_is_driven_round_and_its_barcodes_stay_reachable(lay: Lay) -> None:
    router = Router(lay("a b c", "a d b", "d c"))
    router.close((A, B))
    assert router.route(A, B) == (A, D, B)
    assert router.route(B, C) == (B, C)


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
    assert router.route(C, D) == (C, D)
    assert router.route(C, C) == (C,)
    assert router.route(A, B) == (A, B)
    assert router.route(D, E) == (D, E)
    assert router.times([A, C, D], [B, C, E]) == [
        [pytest.approx(1 / 3), inf, inf],
        [inf, 0.0, pytest.approx(2 / 3)],
        [inf, inf, pytest.approx(1 / 3)],
    ]


def test_closing_what_is_not_there_changes_nothing(lay: Lay) -> None:
    router = Router(lay("a b"))
    router.close(X, (B, A))
    router.open(F)
    assert router.route(A, B) == (A, B)


def test_a_large_track_computes_its_rows_when_asked(lay: Lay, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(routing, "WHOLE_TABLE", 1)
    router = Router(lay("a b c", "b d", "d b"))
    assert router.route(A, C) == (A, B, C)
    assert router.time(D, C) == pytest.approx(2 / 3)


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


@given(edges, st.data())
def test_routes_cost_what_networkx_says_with_closures_or_without(
    lay: Lay, rails: list[Edge], data: st.DataObject
) -> None:
    track = lay(edges=rails)
    router = Router(track)
    places: list[Barcode | EdgeKey] = [*track.barcodes, *((e.start, e.end) for e in rails)]
    router.close(*data.draw(st.lists(st.sampled_from(places), max_size=3)))
    graph = free_track(track, router.closed)
    times = router.times(track.barcodes, track.barcodes)
    for row, start in enumerate(track.barcodes):
        expected = nx.single_source_dijkstra_path_length(graph, start, weight="time")
        for column, goal in enumerate(track.barcodes):
            assert times[row][column] == pytest.approx(expected.get(goal, inf))
            assert router.time(start, goal) == pytest.approx(expected.get(goal, inf))
            if goal not in expected:
                with pytest.raises(NoRoute):
                    router.route(start, goal)
                continue
            route = router.route(start, goal)
            assert (route[0], route[-1]) == (start, goal)
            assert len(set(route)) == len(route)
            assert sum(graph.edges[pair]["time"] for pair in pairwise(route)) == pytest.approx(expected[goal])
