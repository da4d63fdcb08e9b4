from itertools import permutations
from math import inf, nan

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.planning.dispatch import FULL_AGE, SWITCH, assign, cost


def test_the_nearer_vehicle_costs_less() -> None:
    assert cost(10) == 10
    assert cost(10) < cost(11)


def test_what_cannot_be_reached_costs_infinitely_much_however_urgent() -> None:
    assert cost(inf, age=9e9, priority=99) == inf


def test_a_second_of_waiting_is_worth_about_a_second_of_driving_at_first() -> None:
    assert cost(100, age=10) == pytest.approx(90, abs=0.1)
    assert cost(100, age=-1) == 100


@given(st.floats(0, 1e6), st.floats(1, 1e6), st.integers(0, 98), st.floats(0, FULL_AGE))
def test_age_grows_without_end_but_never_outranks_a_class(age: float, more: float, priority: int, far: float) -> None:
    assert cost(far, age + more, priority) < cost(far, age, priority)
    assert cost(far, 0, priority + 1) < cost(0, age, priority)


def test_changing_an_assignment_must_be_worth_it() -> None:
    assert cost(10, switches=True) == 10 + SWITCH


def test_the_cheapest_pairs_win_together_and_not_one_by_one() -> None:
    assert assign([[1.0, 2.0], [2.0, 9.0]]) == [(0, 1), (1, 0)]


def test_infinite_and_undefined_costs_are_never_paired() -> None:
    assert assign([[inf, 5.0], [nan, 1.0], [3.0, inf]]) == [(1, 1), (2, 0)]
    assert assign([[inf, inf]]) == []


def test_as_many_pairs_as_can_be_come_before_cheap_ones() -> None:
    assert assign([[1.0, 1000.0], [2.0, inf]]) == [(0, 1), (1, 0)]


@pytest.mark.parametrize("nothing", [[], [[]], [[], []]])
def test_nobody_or_nothing_to_do_gives_no_pairs(nothing: list[list[float]]) -> None:
    assert assign(nothing) == []


costs = st.one_of(st.integers(-1000, 1000).map(float), st.just(inf))


@given(st.integers(1, 4).flatmap(lambda n: st.lists(st.lists(costs, min_size=n, max_size=n), min_size=1, max_size=4)))
def test_no_other_choice_has_more_pairs_or_as_many_for_less(table: list[list[float]]) -> None:
    pairs = assign(table)
    assert all(table[row][column] < inf for row, column in pairs)
    assert len({row for row, _ in pairs}) == len({column for _, column in pairs}) == len(pairs)
    found = (-len(pairs), sum(table[row][column] for row, column in pairs))
    wide = [*range(len(table[0])), *([None] * len(table))]
    for choice in permutations(wide, len(table)):
        chosen = [table[r][c] for r, c in enumerate(choice) if c is not None and table[r][c] < inf]
        assert found <= (-len(chosen), sum(chosen))
