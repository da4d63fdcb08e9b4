from collections.abc import Callable
from itertools import combinations
from typing import TypeAlias

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.domain.ids import DevId, VehicleId
from app.domain.layout import Edge, Plant, Point, VehicleSpec, Zone
from app.domain.units import Barcode, Millimetres, Percent
from app.planning.clearance import crossing_edges, near_points
from app.planning.track import Track

Lay: TypeAlias = Callable[..., Track]
CROSS = {"w": (0, 0), "e": (1000, 0), "s": (500, -500), "n": (500, 500)}


def b(name: str) -> Barcode:
    return Barcode(name)


def path(names: str) -> list[Barcode]:
    return [Barcode(name) for name in names.split()]


def mm(value: int) -> Millimetres:
    return Millimetres(value)


def test_the_graph_carries_points_stations_and_edges_with_their_time(lay: Lay) -> None:
    slow = Edge(b("b"), b("c"), mm(600), Percent(20), 7, curve=True)
    track = lay("a b", at={"c": (5, 6)}, edges=[slow], ports="c")
    assert track.graph.nodes[b("c")] == {"x": 5, "y": 6, "park": False, "stations": ("P-c",)}
    assert track.graph.edges[b("b"), b("c")] == {"length": 600, "speed": 20, "sensor": 7, "curve": True, "time": 1.0}


def test_times_are_those_of_the_first_vehicle_or_of_the_one_named() -> None:
    points = (Point(b("a"), mm(0), mm(0)), Point(b("b"), mm(1000), mm(0)))
    first, second = (VehicleSpec(VehicleId(f"V{i}"), DevId(i), max_speed=mm(i * 1000)) for i in (1, 2))
    plant = Plant("p", points, (Edge(b("a"), b("b"), mm(1000)),), (), (first, second))
    assert Track(plant).graph.edges[b("a"), b("b")]["time"] == 1.0
    assert Track(plant, second).graph.edges[b("a"), b("b")]["time"] == 0.5


def test_neighbours_points_edges_stations_and_zones_are_found_by_barcode(lay: Lay, zone: Callable[..., Zone]) -> None:
    merge, bay = zone("b c", no_stop=True, name="merge"), zone("b d", name="bay")
    track = lay("a b c", "b d", zones=[merge, bay], ports="d")
    assert track.barcodes == ("a", "b", "c", "d")
    assert "a" in track
    assert "x" not in track
    assert track.successors(b("b")) == ("c", "d")
    assert track.predecessors(b("d")) == ("b",)
    assert track.edge(b("a"), b("b")).length == 1000
    assert track.point(b("a")).barcode == "a"
    assert [s.id for s in track.stations_at(b("d"))] == ["P-d"]
    assert track.zones_at(b("b")) == (merge, bay)
    assert track.zones_at(b("a")) == ()
    assert track.no_stop(b("c"))
    assert not track.no_stop(b("d"))
    assert track.distance(path("a b c")) == 2000


@pytest.mark.parametrize("ask", [Track.point, Track.successors, Track.predecessors, Track.area])
def test_an_unknown_barcode_is_a_key_error(lay: Lay, ask: Callable[[Track, Barcode], object]) -> None:
    with pytest.raises(KeyError):
        ask(lay("a b"), b("x"))


def test_an_edge_against_the_direction_is_a_key_error(lay: Lay) -> None:
    with pytest.raises(KeyError):
        lay("a b").edge(b("b"), b("a"))


def test_behind_and_ahead_follow_every_branch_within_the_length(lay: Lay) -> None:
    track = lay("a b m n o", "p q m", "n x")
    assert track.behind(b("m"), mm(1000)) == {"b", "q"}
    assert track.behind(b("m"), mm(1999)) == {"b", "q"}
    assert track.behind(b("m"), mm(2000)) == {"a", "b", "p", "q"}
    assert track.ahead(b("m"), mm(2000)) == {"n", "o", "x"}
    assert track.ahead(b("m"), mm(0)) == frozenset()


def test_covered_is_tail_first_and_ends_with_the_barcode(lay: Lay) -> None:
    track = lay("a b c d")
    assert track.covered(b("d"), mm(2500)) == ("b", "c", "d")
    assert track.covered(b("d"), mm(2500)) == ("b", "c", "d")


def test_a_short_ring_is_covered_once(lay: Lay) -> None:
    track = lay("a b c a")
    assert track.covered(b("a"), mm(9000)) == ("b", "c", "a")
    assert track.behind(b("a"), mm(9000)) == {"b", "c"}


def test_reach_goes_to_and_fro(lay: Lay) -> None:
    track = lay("a b c d", "b x")
    assert track.reach(b("c"), mm(2000)) == {"a", "b", "c", "d", "x"}
    assert track.reach(b("c"), mm(0)) == {"c"}


def test_pieces_that_do_not_touch_are_areas_of_their_own(lay: Lay) -> None:
    track = lay("a b", "c b", "x y")
    assert track.areas == (frozenset("abc"), frozenset("xy"))
    assert track.area(b("c")) == 0
    assert track.area(b("y")) == 1


def test_pieces_that_cross_are_one_area(lay: Lay) -> None:
    assert lay("w e", "s n", at=CROSS).areas == (frozenset("wesn"),)


def test_heads_of_crossing_edges_exclude_each_other(lay: Lay) -> None:
    track = lay("w e", "s n", at=CROSS)
    assert track.conflicts(b("e")) == {"n"}
    assert track.conflicts(b("n")) == {"e"}
    assert track.conflicts(b("w")) == frozenset()


def test_an_edge_that_ends_on_another_conflicts_and_one_that_stops_short_does_not(lay: Lay) -> None:
    assert lay("w e", "s n", at=CROSS | {"n": (500, 0)}).conflicts(b("e")) == {"n"}
    assert lay("w e", "s n", at=CROSS | {"n": (500, -1)}).conflicts(b("e")) == frozenset()


def test_edges_on_one_line_conflict_where_they_overlap(lay: Lay) -> None:
    at = {"a": (0, 0), "b": (1000, 0), "c": (900, 0), "d": (2000, 0), "e": (1001, 0)}
    assert lay("a b", "c d", at=at).conflicts(b("b")) == {"d"}
    assert lay("a b", "e d", at=at).conflicts(b("b")) == frozenset()


def test_edges_that_share_a_barcode_do_not_conflict(lay: Lay) -> None:
    assert lay("w e w", "e n", "s e", at=CROSS).conflicts(b("e")) == frozenset()


def test_branches_closer_than_the_clearance_exclude_each_other(lay: Lay) -> None:
    at = {"a": (0, 0), "d": (1000, 0), "l": (2000, 100), "r": (2000, -100), "l2": (3000, 500), "r2": (3000, -500)}
    track = lay("a d l l2", "d r r2", at=at, clearance=1000)
    assert track.conflicts(b("l")) == {"r"}
    assert track.conflicts(b("l2")) == frozenset()
    assert track.conflicts(b("d")) == frozenset()


def test_barcodes_that_follow_each_other_closely_do_not_exclude_each_other(lay: Lay) -> None:
    track = lay("a b c", at={"a": (0, 0), "b": (300, 0), "c": (600, 0)}, length=300, clearance=1000)
    assert all(track.conflicts(barcode) == frozenset() for barcode in track.barcodes)


def test_the_two_legs_of_a_narrow_turn_exclude_each_other(lay: Lay) -> None:
    at = {"a": (0, 0), "b": (2000, 0), "c": (2000, 600), "d": (0, 600)}
    track = lay("a b c d", at=at, length=2000, clearance=1000)
    assert track.conflicts(b("a")) == {"d"}
    assert track.conflicts(b("b")) == frozenset()


spots = st.tuples(st.integers(-5, 5), st.integers(-5, 5))


@given(st.lists(st.tuples(spots, spots), max_size=12))
def test_the_grid_finds_the_crossings_that_comparing_all_pairs_finds(lines: list[tuple[tuple[int, int], ...]]) -> None:
    points, edges = {}, []
    for i, ends in enumerate(lines):
        for end, (x, y) in zip("ab", ends, strict=True):
            points[b(f"{i}{end}")] = Point(b(f"{i}{end}"), mm(x), mm(y))
        edges.append(Edge(b(f"{i}a"), b(f"{i}b"), mm(1)))
    together = {(e.end, f.end) for e, f in crossing_edges(edges, points)}
    assert together == {(e.end, f.end) for e, f in combinations(edges, 2) if crossing_edges([e, f], points)}


@given(st.lists(spots, max_size=12), st.integers(0, 6))
def test_near_points_are_all_pairs_nearer_than_the_clearance(places: list[tuple[int, int]], clearance: int) -> None:
    points = [Point(b(str(i)), mm(x), mm(y)) for i, (x, y) in enumerate(places)]
    expected = [
        (p.barcode, q.barcode) for p, q in combinations(points, 2) if (p.x - q.x) ** 2 + (p.y - q.y) ** 2 < clearance**2
    ]
    assert near_points(points, mm(clearance)) == expected


def test_a_very_long_edge_among_short_ones_is_found_to_cross(lay: Lay) -> None:
    at = {"a": (-10_000_000, -10_000_000), "b": (10_000_000, 10_000_000)}
    at |= {f"s{i}": (i, 0) for i in range(9)} | {f"t{i}": (i, 1) for i in range(9)}
    track = lay("a b", *(f"s{i} t{i}" for i in range(9)), at=at)
    assert track.conflicts(b("b")) == {"t0", "t1"}


def test_distances_behind_are_the_least_by_any_branch_nearest_first(lay: Lay) -> None:
    track = lay("a b c d", "x c", edges=[Edge(b("a"), b("d"), mm(2500))])
    assert list(track.distances_behind(b("d"), mm(2500)).items()) == [
        (b("d"), 0),
        (b("c"), 1000),
        (b("b"), 2000),
        (b("x"), 2000),
        (b("a"), 2500),
    ]
    assert track.distances_behind(b("d"), mm(999)) == {b("d"): 0}
