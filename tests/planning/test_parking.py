"""Where idle vehicles wait."""

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.planning.parking import Demand, Idle, ParkingRules, areas_of, park, shares


def standing(*areas: int, badly: int = 0) -> Idle:
    """Return vehicles in these areas, of which the first so many stand where nobody should."""
    stays = np.ones(len(areas), np.bool_)
    stays[:badly] = False
    return Idle(np.array(areas, np.intp), stays)


PLACES = np.array([0, 0, 0, 1, 1, 1], np.intp)
NEAR = np.full((4, 6), 20.0)
FREE = np.zeros(6, np.bool_)


def test_vehicles_go_to_where_jobs_begin() -> None:
    taken = FREE.copy()
    taken[:3] = True
    moves = park(standing(0, 0, 0, 0), np.array([1.0, 3.0]), PLACES, taken, NEAR)
    assert len(moves) == 3
    assert all(PLACES[place] == 1 for place in moves.values())
    assert len(set(moves.values())) == len(moves)


def test_those_set_out_that_are_nearest() -> None:
    times = NEAR.copy()
    times[2] = 5.0
    assert list(park(standing(0, 0, 0, 1), np.array([1.0, 1.0]), PLACES, FREE, times)) == [2]


def test_nobody_moves_for_less_than_the_gain() -> None:
    assert park(standing(0, 0, 1, 1), np.array([1.0, 1.3]), PLACES, FREE, NEAR) == {}


def test_nobody_goes_too_far_or_where_no_way_leads_or_somebody_is() -> None:
    demand, all_here = np.array([0.0, 9.0]), standing(0, 0, 0, 0)
    assert park(all_here, demand, PLACES, FREE, np.full((4, 6), 1000.0)) == {}
    assert park(all_here, demand, PLACES, FREE, np.full((4, 6), np.inf)) == {}
    assert park(all_here, demand, PLACES, np.ones(6, np.bool_), NEAR) == {}


def test_only_so_many_set_out_at_a_time() -> None:
    assert len(park(standing(0, 0, 0, 0), np.array([0.0, 9.0]), PLACES, FREE, NEAR, ParkingRules(moves=1))) == 1


def test_one_that_stands_in_the_way_goes_to_a_place_whatever_the_balance() -> None:
    moves = park(standing(0, 0, 1, 1, badly=1), np.array([1.0, 1.0]), PLACES, FREE, NEAR)
    assert list(moves) == [0]
    nowhere = park(standing(-1, badly=1), np.array([1.0, 1.0]), PLACES, FREE, NEAR[:1])
    assert list(nowhere) == [0]


@given(st.integers(1, 12), st.integers(1, 4), st.integers(0, 2**32 - 1))
def test_parking_comes_to_rest_and_then_nobody_moves_any_more(count: int, areas: int, seed: int) -> None:
    draw = np.random.default_rng(seed)
    places = np.sort(draw.integers(0, areas, 3 * count))
    at = draw.permutation(len(places))[:count]
    demand = draw.random(areas) * 10
    times = draw.integers(1, 100, (len(places), len(places))).astype(np.float64)
    rounds = 0
    while moves := _round(at, places, demand, times):
        for row, place in moves.items():
            at[row] = place
        assert len(set(at.tolist())) == count, "one vehicle a place"
        rounds += 1
        assert rounds <= count
    share = shares(demand, np.bincount(places, minlength=areas), count)
    there = np.bincount(places[at], minlength=areas)
    assert not ((there - share).max() >= 1 and (share - there).max() >= 1)


def _round(
    at: "np.ndarray[tuple[int], np.dtype[np.intp]]", places: object, demand: object, times: object
) -> dict[int, int]:
    assert isinstance(places, np.ndarray)
    assert isinstance(demand, np.ndarray)
    assert isinstance(times, np.ndarray)
    taken = np.zeros(len(places), np.bool_)
    taken[at] = True
    return park(Idle(places[at], np.ones(len(at), np.bool_)), demand, places, taken, times[at])


@given(st.lists(st.tuples(st.floats(0, 100), st.integers(0, 9)), min_size=1, max_size=6), st.integers(0, 60))
def test_shares_are_those_of_demand_within_the_room_there_is(areas: list[tuple[float, int]], idle: int) -> None:
    demand, room = np.array([d for d, _ in areas]), np.array([r for _, r in areas], np.intp)
    share = shares(demand, room, idle)
    assert abs(share.sum() - min(idle, room.sum())) < 1e-6
    assert (share <= room + 1e-9).all()
    assert (share >= 0).all()


def test_demand_is_forgotten_with_time() -> None:
    demand = Demand(np.zeros(2), memory=100.0)
    demand.begins(0, 0.0)
    demand.begins(1, 100.0)
    np.testing.assert_allclose(demand.upto(100.0), [np.exp(-1), 1.0])
    np.testing.assert_allclose(demand.upto(300.0), [np.exp(-3), np.exp(-2)])


def test_points_near_each_other_are_one_area_and_the_same_every_time() -> None:
    corners = [(0.0, 0.0), (1000.0, 0.0), (0.0, 1000.0)]
    points = np.array([(x + dx, y) for x, y in corners for dx in (0.0, 3.0, 9.0)])
    found = areas_of(points, 3)
    assert [len(set(found[n : n + 3].tolist())) for n in (0, 3, 6)] == [1, 1, 1]
    assert len(set(found.tolist())) == 3
    assert found.tolist() == areas_of(points, 3).tolist()
    assert areas_of(points[:1], 5).tolist() == [0]
    assert areas_of(np.empty((0, 2)), 5).tolist() == []
