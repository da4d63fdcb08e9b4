"""The kinematics of the simulated vehicle."""

from itertools import pairwise

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.protocols.itsc.simulator.motion import Stretch, brake, plan

UP, DOWN = 2000.0, 3000.0


def test_a_long_stretch_is_run_by_accelerating_cruising_and_braking() -> None:
    profile = plan(10.0, 0.0, [Stretch(10_000, 3000, 0)], UP, DOWN)
    # 1.5 s and 2.25 m up, 1 s and 1.5 m down, 6.25 m at 3 m/s between.
    assert profile.end == pytest.approx(10 + 1.5 + 6250 / 3000 + 1)
    assert profile.at(11.5) == pytest.approx((2250, 3000))
    assert profile.at(profile.end) == pytest.approx((10_000, 0), abs=1e-6)


def test_a_short_stretch_never_reaches_its_limit() -> None:
    profile = plan(0.0, 0.0, [Stretch(100, 3000, 0)], UP, DOWN)
    # Up for 60 mm, down for 40 mm.
    assert profile.end == pytest.approx((2 * 60 / UP) ** 0.5 + (2 * 40 / DOWN) ** 0.5)


def test_a_slower_stretch_is_entered_at_its_limit() -> None:
    profile = plan(0.0, 0.0, [Stretch(3000, 3000, 3000), Stretch(3000, 1000, 0)], UP, DOWN)
    assert profile.at(profile.ends[0]) == pytest.approx((3000, 1000))


def test_what_is_too_fast_for_its_limit_brakes_first() -> None:
    profile = plan(0.0, 3000.0, [Stretch(5000, 1000, 0)], UP, DOWN)
    assert profile.at(2000 / DOWN)[1] == pytest.approx(1000)
    assert profile.at(profile.end) == pytest.approx((5000, 0), abs=1e-6)


def test_what_cannot_brake_in_time_brakes_as_hard_as_it_can() -> None:
    profile = plan(0.0, 3000.0, [Stretch(500, 1000, 0), Stretch(5000, 1000, 0)], UP, DOWN)
    assert profile.at(profile.ends[0])[1] == pytest.approx((3000**2 - 2 * DOWN * 500) ** 0.5)
    assert profile.at(profile.end)[0] == 5500


def test_no_stretch_at_all_is_over_at_once() -> None:
    profile = plan(3.0, 0.0, [], UP, DOWN)
    assert (profile.end, profile.at(3.0), profile.at(9.0)) == (3.0, (0.0, 0.0), (0.0, 0.0))


def test_before_its_start_a_profile_stands_at_its_beginning() -> None:
    assert plan(3.0, 500.0, [Stretch(1000, 500, 0)], UP, DOWN).at(2.0) == (0.0, 500.0)


def test_braking_passes_what_lies_within_the_braking_distance() -> None:
    profile = brake(0.0, 3000.0, [500, 500, 600], DOWN)
    assert len(profile.ends) == 2
    assert profile.at(profile.ends[0])[0] == pytest.approx(500)
    assert profile.at(profile.end) == pytest.approx((1500, 0), abs=1e-6)


def test_braking_ends_where_the_rail_ends() -> None:
    profile = brake(0.0, 3000.0, [400], DOWN)
    assert profile.at(profile.end)[0] == 400
    assert len(profile.ends) == 1


stretches = st.lists(
    st.builds(
        lambda length, limit, stops: Stretch(length, limit, 0.0 if stops else limit),
        st.floats(0, 20_000),
        st.floats(30, 3000),
        st.booleans(),
    ),
    min_size=1,
    max_size=6,
)


@given(stretches, st.floats(0, 3000))
def test_a_run_is_continuous_forward_and_within_the_accelerations(way: list[Stretch], speed: float) -> None:
    profile = plan(0.0, speed, way, UP, DOWN)
    times = sorted({0.0, profile.end, *profile.ends, *(profile.end * i / 50 for i in range(51))})
    for (early, late), (before, after) in zip(
        pairwise(times), pairwise([profile.at(time) for time in times]), strict=True
    ):
        assert after[0] >= before[0] - 1e-6
        assert after[0] - before[0] <= max(before[1], after[1]) * (late - early) + UP * (late - early) ** 2 + 1e-2
        assert after[1] - before[1] <= UP * (late - early) + 0.1
        assert before[1] - after[1] <= DOWN * (late - early) + 0.1
    total = 0.0
    for stretch, end in zip(way, profile.ends, strict=True):
        total += stretch.length
        assert profile.at(end)[0] == pytest.approx(total, abs=1e-3)


@given(stretches)
def test_from_a_stand_no_limit_is_ever_exceeded(way: list[Stretch]) -> None:
    profile = plan(0.0, 0.0, way, UP, DOWN)
    begin = 0.0
    for stretch, end in zip(way, profile.ends, strict=True):
        for i in range(1, 10):
            assert profile.at(begin + (end - begin) * i / 10)[1] <= stretch.limit + 1e-3
        if stretch.exit == 0:
            assert profile.at(end)[1] <= 0.1 or stretch.length == 0
        begin = end
