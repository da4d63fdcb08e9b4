"""Which vehicle does which job, in arrays."""

from dataclasses import replace
from functools import partial
from itertools import permutations
from math import inf, nan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.planning.dispatch import (
    MOST_JOBS,
    MOST_PAIRS,
    RULES,
    SHORTER_SIDE,
    STEEPEST,
    Floats,
    Indices,
    Jobs,
    Plan,
    Rules,
    Times,
    Vehicles,
    at_random,
    best_pairs,
    considered,
    dispatch,
    nearest_first_come,
    worth_of_waiting,
)


def table(rows: list[list[float]]) -> Times:
    """Return the times as the rules ask for them."""
    whole = np.array(rows, dtype=np.float64)
    return partial(_cut, whole)


def _cut(whole: Floats, rows: Indices, columns: Indices) -> Floats:
    return whole[np.ix_(rows, columns)]


def fleet(count: int, *, on: dict[int, int] | None = None, soon: dict[int, float] | None = None) -> Vehicles:
    """Return idle vehicles; ``on``: the job that one is to fetch; ``soon``: the seconds until one is free."""
    idle = Vehicles.idle(count)
    for row, job in (on or {}).items():
        idle.job[row] = job
    for row, left in (soon or {}).items():
        idle.offset[row], idle.soon[row] = left, True
    return idle


def jobs(
    count: int,
    *,
    ages: list[float] | None = None,
    priorities: list[int] | None = None,
    ready: list[float] | None = None,
    hot: list[int] | None = None,
) -> Jobs:
    """Return jobs ordered just now, of one priority and with their carriers there unless said otherwise."""
    found = Jobs.waiting(np.array(ages or [0.0] * count))
    flags = found.hot.copy()
    flags[hot or []] = True
    return replace(
        found,
        priority=np.array(priorities or [50] * count, dtype=np.intp),
        ready=np.array(ready or [0.0] * count),
        hot=flags,
    )


def given_to(plan: Plan) -> list[int]:
    return [int(row) for row in plan.vehicle]


# -- the pairs ------------------------------------------------------------------------------------------------------------


def same(columns: int) -> Indices:
    return np.zeros(columns, np.intp)


def test_the_cheapest_pairs_win_together_and_not_one_by_one() -> None:
    assert best_pairs(np.array([[1.0, 2.0], [2.0, 9.0]]), same(2)) == [(0, 1), (1, 0)]


def test_infinite_and_undefined_costs_are_never_paired() -> None:
    assert best_pairs(np.array([[inf, 5.0], [nan, 1.0], [3.0, inf]]), same(2)) == [(1, 1), (2, 0)]
    assert best_pairs(np.array([[inf, inf]]), same(2)) == []
    assert best_pairs(np.empty((0, 3)), same(3)) == []


def test_as_many_pairs_as_can_be_come_before_cheap_ones() -> None:
    assert best_pairs(np.array([[1.0, 1000.0], [2.0, inf]]), same(2)) == [(0, 1), (1, 0)]


costs = st.one_of(st.integers(-1000, 1000).map(float), st.just(inf))
tables = st.integers(1, 4).flatmap(
    lambda n: st.tuples(
        st.lists(st.lists(costs, min_size=n, max_size=n), min_size=1, max_size=4),
        st.lists(st.integers(0, 99), min_size=n, max_size=n),
    )
)


@given(tables)
def test_no_other_choice_has_more_pairs_or_higher_priorities_or_as_good_ones_for_less(
    example: tuple[list[list[float]], list[int]],
) -> None:
    cells, priority = example

    def worth(pairs: list[tuple[int, int]]) -> tuple[int, list[int], float]:
        """What is better is less: more pairs, then the higher priorities, then the lower cost."""
        taken = sorted((-priority[column] for _, column in pairs))
        return -len(pairs), taken, sum(cells[row][column] for row, column in pairs)

    pairs = best_pairs(np.array(cells), np.array(priority, dtype=np.intp))
    assert all(cells[row][column] < inf for row, column in pairs)
    assert len({row for row, _ in pairs}) == len({column for _, column in pairs}) == len(pairs)
    found = worth(pairs)
    wide = [*range(len(cells[0])), *([None] * len(cells))]
    for choice in permutations(wide, len(cells)):
        other = [(r, c) for r, c in enumerate(choice) if c is not None and cells[r][c] < inf]
        assert found <= worth(other)


# -- the rule -------------------------------------------------------------------------------------------------------------


def test_each_job_gets_a_vehicle_so_that_all_drive_least() -> None:
    plan = dispatch(fleet(2), jobs(2), table([[10, 12], [11, 60]]))
    assert given_to(plan) == [1, 0]


def test_who_cannot_do_a_job_is_not_sent_however_urgent_it_is() -> None:
    plan = dispatch(fleet(1), jobs(1, ages=[9e9], priorities=[99], hot=[0]), table([[inf]]))
    assert given_to(plan) == [-1]


def test_where_not_all_may_set_out_those_do_that_cost_least_and_each_takes_the_job_that_suits_best() -> None:
    times = table([[50, 60], [9, 12], [10, 40], [70, 11]])
    assert given_to(dispatch(fleet(4), jobs(2), times, most=1)) == [1, -1]
    assert given_to(dispatch(fleet(4), jobs(2), times, most=2)) == [1, 3]
    assert given_to(dispatch(fleet(4), jobs(2), times, most=0)) == [-1, -1]
    assert given_to(dispatch(fleet(4), jobs(2), times, most=4)) == given_to(dispatch(fleet(4), jobs(2), times))


def test_of_those_that_may_set_out_the_urgent_and_the_old_jobs_have_the_first() -> None:
    times = table([[10, 300], [12, 300]])
    assert given_to(dispatch(fleet(2), jobs(2, priorities=[50, 51]), times, most=1)) == [-1, 0]
    assert given_to(dispatch(fleet(2), jobs(2, hot=[1]), times, most=1)) == [-1, 0]
    assert given_to(dispatch(fleet(2), jobs(2, ages=[0, 1000]), times, most=1)) == [-1, 0]


def test_who_fetches_already_goes_on_though_nobody_else_may_set_out() -> None:
    plan = dispatch(fleet(3, on={1: 0}), jobs(2), table([[1, 1], [90, 95], [2, 2]]), most=0)
    assert given_to(plan) == [1, -1]


def test_first_come_first_served_gives_the_oldest_jobs_vehicles_as_long_as_any_may_set_out() -> None:
    plan = nearest_first_come(fleet(3), jobs(3, ages=[1, 9, 5]), table([[1, 9, 9], [1, 4, 9], [1, 9, 3]]), most=2)
    assert given_to(plan) == [-1, 1, 2]


def test_a_higher_priority_comes_first_however_old_and_near_the_other_job_is() -> None:
    plan = dispatch(fleet(1), jobs(2, ages=[0, 1e6], priorities=[51, 50]), table([[3000, 1]]))
    assert given_to(plan) == [0, -1]


def test_a_hot_lot_comes_before_every_priority() -> None:
    plan = dispatch(fleet(1), jobs(2, ages=[0, 1e6], priorities=[0, 99], hot=[0]), table([[3000, 1]]))
    assert given_to(plan) == [0, -1]


def test_a_hot_lot_gets_the_nearest_vehicle_though_all_together_would_drive_less() -> None:
    plan = dispatch(fleet(2), jobs(2, hot=[0]), table([[10, 10], [20, 500]]))
    assert given_to(plan) == [0, 1]
    assert given_to(dispatch(fleet(2), jobs(2), table([[10, 10], [20, 500]]))) == [1, 0]


def test_a_hot_lot_takes_the_nearest_vehicle_off_a_job_that_is_not_picked_up_and_that_job_gets_another() -> None:
    plan = dispatch(fleet(2, on={0: 1}), jobs(2, hot=[0]), table([[10, 10], [40, 90]]))
    assert given_to(plan) == [0, 1]


def test_a_hot_lot_leaves_a_vehicle_its_job_where_another_is_as_near() -> None:
    rules = Rules(preempt=5.0)
    assert given_to(dispatch(fleet(2, on={0: 1}), jobs(2, hot=[0]), table([[10, 10], [14, 14]]), rules)) == [1, 0]
    assert given_to(dispatch(fleet(2, on={0: 1}), jobs(2, hot=[0]), table([[10, 10], [16, 16]]), rules)) == [0, 1]


def test_one_hot_lot_does_not_take_a_vehicle_off_another_for_a_small_gain() -> None:
    plan = dispatch(fleet(2, on={0: 0}), jobs(2, hot=[0, 1]), table([[10, 10], [30, 35]]))
    assert given_to(plan) == [0, 1]


def test_an_assignment_is_kept_unless_a_switch_saves_more_than_it_costs() -> None:
    near = table([[50], [50 - RULES.switch + 1]])
    assert given_to(dispatch(fleet(2, on={0: 0}), jobs(1), near)) == [0]
    nearer = table([[50], [50 - RULES.switch - 1]])
    assert given_to(dispatch(fleet(2, on={0: 0}), jobs(1), nearer)) == [1]


def test_a_vehicle_leaves_its_job_for_another_only_if_that_is_worth_a_switch() -> None:
    assert given_to(dispatch(fleet(1, on={0: 0}), jobs(2), table([[50, 40]]))) == [0, -1]
    assert given_to(dispatch(fleet(1, on={0: 0}), jobs(2), table([[50, 10]]))) == [-1, 0]


def test_a_job_is_kept_for_a_vehicle_that_is_soon_free_and_near() -> None:
    plan = dispatch(fleet(2, soon={0: 12.0}), jobs(1), table([[3], [60]]))
    assert given_to(plan) == [0]
    assert plan.arrival.tolist() == [[15], [60]]


def test_what_is_not_free_yet_must_save_something_to_be_waited_for() -> None:
    assert given_to(dispatch(fleet(2, soon={0: 12.0}), jobs(1), table([[3], [15 + RULES.unsure - 1]]))) == [1]


def test_a_vehicle_sets_out_so_that_it_is_there_with_the_carrier() -> None:
    assert given_to(dispatch(fleet(1), jobs(1, ready=[60]), table([[30]]))) == [-1]
    assert given_to(dispatch(fleet(1), jobs(1, ready=[60]), table([[60 - RULES.early + 1]]))) == [0]


def test_one_that_has_set_out_keeps_its_job_though_the_carrier_is_late() -> None:
    assert given_to(dispatch(fleet(1, on={0: 0}), jobs(1, ready=[60]), table([[5]]))) == [0]


def test_of_vehicles_that_come_before_the_carrier_none_is_nearer() -> None:
    """The one that comes with the carrier is as good as the nearest, which another job needs."""
    plan = dispatch(fleet(2), jobs(2, ready=[30, 0]), table([[25, 5], [30, 200]]))
    assert given_to(plan) == [1, 0]


@given(st.floats(0, 1e6), st.floats(1, 1e6))
def test_waiting_is_worth_more_the_longer_it_lasts_and_without_end(age: float, more: float) -> None:
    before, after = worth_of_waiting(np.array([age, age + more]))
    assert after > before
    assert before + more * (RULES.waiting + STEEPEST / RULES.patience) >= after - 1e-6 * after


def test_no_stream_of_near_jobs_keeps_a_far_one_waiting_for_ever() -> None:
    """A new job appears beside the only vehicle whenever it is free: the far job has its turn within a bound."""
    turns = 0
    while given_to(dispatch(fleet(1), jobs(2, ages=[20.0 * turns, 0.0]), table([[600, 1]]))) != [0, -1]:
        turns += 1
    assert 20.0 * turns < 1100


@given(st.integers(1, 6), st.integers(1, 8), st.integers(0, 2**32 - 1), st.booleans())
def test_an_assignment_is_stable_once_it_is_made(vehicles: int, count: int, seed: int, some_hot: bool) -> None:
    draw = np.random.default_rng(seed)
    times = table(draw.integers(0, 300, (vehicles, count)).tolist())
    asked = jobs(count, ages=draw.integers(0, 900, count).tolist(), hot=[0] if some_hot else [])
    first = dispatch(fleet(vehicles), asked, times)
    on = {row: job for job, row in enumerate(given_to(first)) if row >= 0}
    assert given_to(dispatch(fleet(vehicles, on=on), asked, times)) == given_to(first)


# -- what is weighed ------------------------------------------------------------------------------------------------------


def test_only_the_most_urgent_and_oldest_jobs_are_weighed() -> None:
    many = jobs(2 * MOST_JOBS, ages=[float(n) for n in range(2 * MOST_JOBS)])
    many.hot[3] = True
    many.priority[5] = 60
    rows, columns = considered(fleet(2), many)
    assert rows.tolist() == [0, 1]
    assert columns.tolist() == [3, 5, *range(2 * MOST_JOBS - 1, MOST_JOBS + 1, -1)]


@settings(max_examples=50)
@given(st.integers(0, 3000), st.integers(0, 900), st.integers(0, 900), st.integers(0, 5))
def test_never_more_is_weighed_than_can_be_in_a_few_milliseconds(
    idle: int, engaged: int, queued: int, turn: int
) -> None:
    on = {idle + n: queued + n for n in range(engaged)}
    rows, columns = considered(fleet(idle + engaged, on=on), jobs(queued + engaged), turn)
    assert len(rows) * len(columns) <= MOST_PAIRS
    assert len(columns) <= 2 * MOST_JOBS
    assert min(len(rows), len(columns)) <= SHORTER_SIDE
    assert len(set(rows.tolist())) == len(rows)
    assert sorted(row for row in rows.tolist() if row >= idle) == sorted(
        idle + column - queued for column in columns.tolist() if column >= queued
    ), "a vehicle on its way is weighed with its job, or not at all"


def test_where_not_all_assignments_can_be_thought_over_each_has_its_turn() -> None:
    count = 3 * SHORTER_SIDE
    on = {n: n for n in range(count)}
    seen: set[int] = set()
    weighed = len(considered(fleet(count, on=on), jobs(count))[0])
    for turn in range(-(-count // weighed)):
        rows, _ = considered(fleet(count, on=on), jobs(count), turn)
        seen |= set(rows.tolist())
    assert len(seen) == count


def test_jobs_that_are_not_weighed_keep_the_vehicle_they_have() -> None:
    count = 2 * SHORTER_SIDE
    on = {n: n for n in range(count)}
    times: Times = lambda rows, columns: np.zeros((len(rows), len(columns)))  # noqa: E731
    assert given_to(dispatch(fleet(count, on=on), jobs(count), times)) == list(range(count))


# -- rules to compare with ------------------------------------------------------------------------------------------------


def test_first_come_nearest_gives_the_oldest_job_its_nearest_vehicle() -> None:
    plan = nearest_first_come(fleet(2), jobs(2, ages=[5, 9]), table([[10, 12], [inf, 60]]))
    assert given_to(plan) == [-1, 0]
    assert given_to(nearest_first_come(fleet(2), jobs(2, ages=[9, 5]), table([[10, 12], [inf, 60]]))) == [0, 1]


def test_at_random_gives_each_job_any_vehicle_that_can_do_it() -> None:
    rule = at_random(np.random.default_rng(1))
    plans = {tuple(given_to(rule(fleet(3), jobs(2), table([[1, 1], [1, 1], [inf, 1]])))) for _ in range(50)}
    assert plans == {(0, 1), (0, 2), (1, 0), (1, 2)}


@pytest.mark.parametrize("rule", [dispatch, nearest_first_come, at_random(np.random.default_rng(1))])
def test_nobody_or_nothing_to_do_gives_no_pairs(rule: object) -> None:
    assert callable(rule)
    none: Times = lambda rows, columns: np.empty((len(rows), len(columns)))  # noqa: E731
    assert given_to(rule(fleet(0), jobs(2), none)) == [-1, -1]
    assert given_to(rule(fleet(2), jobs(0), none)) == []
