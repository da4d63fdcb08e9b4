"""How slow track is by how long vehicles took over it of late."""

import numpy as np
import pytest

from app.planning.traverses import Smoothing, Traverses

FREE = np.array([2.0, 4.0, 1.0])
NOBODY = np.array([], np.int64)
NO_TIMES = np.array([])


def looked(
    seen: dict[int, list[float]],
    inside: dict[int, list[float]] | None = None,
    smoothing: Smoothing | None = None,
    traverses: Traverses | None = None,
) -> Traverses:
    """Take in, 10 s after the last look, the seconds of those who got over each piece, and of those who are on it still."""
    traverses = traverses or Traverses(FREE, smoothing)
    rows = [(piece, seconds) for piece, times in seen.items() for seconds in times]
    still = [(piece, seconds) for piece, times in (inside or {}).items() for seconds in times]
    traverses.look(*columns(rows), *columns(still), 10.0)
    return traverses


def columns(rows: list[tuple[int, float]]) -> tuple[np.ndarray, np.ndarray]:
    return np.array([row[0] for row in rows], np.int64), np.array([row[1] for row in rows], np.float64)


def test_where_nobody_drives_nothing_is_slow() -> None:
    assert looked({}).slowness().tolist() == [1.0, 1.0, 1.0]


def test_what_all_take_longer_over_than_on_an_empty_track_is_usual_and_not_slow() -> None:
    traverses = looked({0: [4.0] * 9, 1: [8.0] * 9, 2: [2.0] * 9})
    assert traverses.usual == pytest.approx(2.0)
    assert traverses.slowness() == pytest.approx([1.0, 1.0, 1.0])


def test_a_piece_that_takes_many_vehicles_longer_than_usual_is_slow_and_never_more_than_the_most() -> None:
    usual = {0: [2.0] * 50, 2: [1.0] * 50}
    assert looked(usual | {1: [16.0] * 30}).slowness()[1] == pytest.approx((4 * 30 + 3) / 33)
    assert looked(usual | {1: [4000.0] * 30}).slowness().tolist() == [1.0, 20.0, 1.0]


def test_one_slow_vehicle_makes_no_jam() -> None:
    assert looked({0: [2.0] * 50, 1: [12.0]}).slowness()[1] == pytest.approx((3 + 3) / 4)


def test_vehicles_that_do_not_get_on_count_before_they_have_and_those_that_do_are_no_hint() -> None:
    jammed = looked({0: [2.0] * 50}, {1: [40.0, 30.0, 0.5]}).slowness()
    assert jammed[1] == pytest.approx((10 + 7.5 + 3) / 5)
    assert jammed[0] == 1.0


def test_a_jam_that_has_gone_is_forgotten() -> None:
    traverses = looked({0: [2.0] * 50, 1: [40.0] * 20})
    before = traverses.slowness()[1]
    for _ in range(120):
        looked({0: [2.0] * 5}, traverses=traverses)
    assert before > 5
    assert traverses.slowness()[1] == pytest.approx(1.0, abs=0.1)


def test_a_little_slower_costs_hardly_more_and_what_is_jammed_costs_as_much_more_as_is_said() -> None:
    rules = Smoothing(doubt=0.0, most=5.0, weight=2.0, power=2.0)
    costs = looked({0: [2.0] * 50, 1: [8.0] * 20, 2: [500.0] * 20}, smoothing=rules).costs()
    assert costs == pytest.approx([1.0, 1.0 + 2.0 / 16, 3.0])
