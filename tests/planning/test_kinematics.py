from collections.abc import Callable
from itertools import pairwise
from math import sqrt
from typing import TypeAlias

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.domain.ids import DevId, VehicleId
from app.domain.layout import Edge, StopAction, VehicleSpec
from app.domain.units import Barcode, Millimetres, Percent
from app.planning.kinematics import braking_distance, driving_time, edge_speed, edge_time, elements, time_to_braking
from app.planning.track import Track

Lay: TypeAlias = Callable[..., Track]
SPEC = VehicleSpec(VehicleId("V1"), DevId(1))
A, B, C, D = (Barcode(name) for name in "abcd")


def edge(start: Barcode, end: Barcode, length: int, speed: int = 100, sensor: int = 0, *, curve: bool = False) -> Edge:
    return Edge(start, end, Millimetres(length), Percent(speed), sensor, curve)


def test_speed_is_percent_of_the_vehicles_own_and_lower_on_curves() -> None:
    assert edge_speed(edge(A, B, 1, 50), SPEC) == 1500
    assert edge_speed(edge(A, B, 1, 50, curve=True), SPEC) == 1000
    assert edge_speed(edge(A, B, 1, 20, curve=True), SPEC) == 600
    assert edge_time(edge(A, B, 1500, 50), SPEC) == 1.0


def test_braking_from_three_metres_a_second_takes_one_and_a_half_metres() -> None:
    assert braking_distance(3000, SPEC) == 1500
    assert braking_distance(100, SPEC) == 2
    assert braking_distance(0, SPEC) == 0


def test_a_long_way_is_a_trapezoid(lay: Lay) -> None:
    track = lay("a b c", length=5000)
    assert driving_time(track, [A, B, C], SPEC) == pytest.approx(1.5 + 1.0 + (10_000 - 2250 - 1500) / 3000)


def test_a_short_way_is_a_triangle(lay: Lay) -> None:
    peak = sqrt(2 * 2000 * 3000 * 1000 / 5000)
    assert driving_time(lay("a b"), [A, B], SPEC) == pytest.approx(peak / 2000 + peak / 3000)


def test_standing_takes_no_time(lay: Lay) -> None:
    assert driving_time(lay("a b"), [A], SPEC) == 0.0


def test_a_slow_edge_is_entered_and_left_at_its_own_speed(lay: Lay) -> None:
    track = lay(edges=[edge(A, B, 9000), edge(B, C, 2000, curve=True), edge(C, D, 9000)])
    before = 1.5 + (9000 - 2250 - (3000**2 - 1000**2) / 6000) / 3000 + 2 / 3
    after = 1.0 + (9000 - (3000**2 - 1000**2) / 4000 - 1500) / 3000 + 1.0
    assert driving_time(track, [A, B, C, D], SPEC) == pytest.approx(before + 2.0 + after)


@given(st.floats(0, 3000), st.floats(1, 20_000), st.floats(500, 3000))
def test_who_brakes_when_it_is_time_stands_at_the_end_of_the_way(speed: float, way: float, limit: float) -> None:
    speed = min(speed, limit)
    time = time_to_braking(speed, way, limit, SPEC)
    rise = min(time, (limit - speed) / SPEC.acceleration)
    top = speed + SPEC.acceleration * rise
    gone = (speed + top) / 2 * rise + top * (time - rise)
    if time >= 0:
        assert gone + top**2 / (2 * SPEC.braking) == pytest.approx(way)
    else:
        assert way < speed**2 / (2 * SPEC.braking)


@given(st.integers(1, 20_000))
def test_braking_begins_when_what_is_left_of_the_drive_is_braking(lay: Lay, way: int) -> None:
    peak = min(3000.0, sqrt(2 * 2000 * 3000 * way / 5000))
    begun = time_to_braking(0, way, 3000, SPEC)
    assert begun + peak / 3000 == pytest.approx(driving_time(lay("a b", length=way), [A, B], SPEC))


@given(
    st.lists(st.tuples(st.integers(1, 20_000), st.integers(1, 100), st.booleans()), min_size=1, max_size=8),
    st.integers(1, 9000),
    st.integers(1, 9000),
)
def test_driving_takes_at_least_the_time_at_full_speed_and_cutting_an_edge_changes_nothing(
    lay: Lay, pieces: list[tuple[int, int, bool]], acceleration: int, braking: int
) -> None:
    spec = VehicleSpec(VehicleId("V"), DevId(1), acceleration=Millimetres(acceleration), braking=Millimetres(braking))
    names = [Barcode(str(i)) for i in range(2 * len(pieces) + 1)]
    whole = [
        edge(a, b, 2 * length, speed, curve=curve)
        for (a, b), (length, speed, curve) in zip(pairwise(names[::2]), pieces, strict=True)
    ]
    halves = [
        edge(a, b, pieces[i // 2][0], pieces[i // 2][1], curve=pieces[i // 2][2])
        for i, (a, b) in enumerate(pairwise(names))
    ]
    time = driving_time(lay(edges=whole), names[::2], spec)
    assert time >= sum(edge_time(e, spec) for e in whole)
    assert time == pytest.approx(driving_time(lay(edges=halves), names, spec))


def test_elements_run_by_their_leaving_edge_and_the_last_stops_by_the_arriving_one(lay: Lay) -> None:
    track = lay(edges=[edge(A, B, 700, 80, 3), edge(B, C, 900, 60, 5)])
    found = elements(track, [A, B, C], StopAction.SBFL, SPEC)
    assert [(e.barcode, e.seq, e.action, e.speed, e.sensor, e.to_next) for e in found] == [
        ("a", 0, StopAction.RUN, 80, 3, 700),
        ("b", 1, StopAction.RUN, 60, 5, 900),
        ("c", 2, StopAction.SBFL, 60, 5, 0),
    ]


def test_elements_of_a_change_go_on_from_the_sequence_number_of_the_stop(lay: Lay) -> None:
    assert [e.seq for e in elements(lay("a b c"), [B, C], StopAction.STOP, SPEC, first_seq=7)] == [7, 8]


def test_on_curves_the_speed_is_the_curve_speed_rounded_down_but_never_nothing(lay: Lay) -> None:
    track = lay(edges=[edge(A, B, 700, 80, curve=True), edge(B, C, 900, 20, curve=True)])
    assert [e.speed for e in elements(track, [A, B, C], StopAction.STOP, SPEC)] == [33, 20, 20]
    crawler = VehicleSpec(VehicleId("V"), DevId(1), curve_speed=Millimetres(5))
    assert [e.speed for e in elements(track, [A, B], StopAction.STOP, crawler)] == [1, 1]


def test_a_path_of_one_barcode_takes_the_slowest_edge_that_leads_there(lay: Lay) -> None:
    track = lay(edges=[edge(A, C, 700, 80, 3), edge(B, C, 900, 20, 5)])
    assert [(e.speed, e.sensor, e.to_next) for e in elements(track, [C], StopAction.PORT, SPEC)] == [(20, 5, 0)]
    assert [(e.speed, e.sensor) for e in elements(track, [A], StopAction.PORT, SPEC)] == [(100, 0)]


@pytest.mark.parametrize(
    ("path", "action", "first"),
    [
        ([], StopAction.STOP, 0),
        ([A, B], StopAction.RUN, 0),
        ([A, B], StopAction.STOP, 65_535),
        ([A], StopAction.STOP, -1),
    ],
)
def test_a_path_without_elements_without_a_stop_or_without_numbers_is_refused(
    lay: Lay, path: list[Barcode], action: StopAction, first: int
) -> None:
    with pytest.raises(ValueError):
        elements(lay("a b"), path, action, SPEC, first)


def test_a_path_that_leaves_the_track_is_a_key_error(lay: Lay) -> None:
    with pytest.raises(KeyError):
        elements(lay("a b", "c d"), [A, D], StopAction.STOP, SPEC)
