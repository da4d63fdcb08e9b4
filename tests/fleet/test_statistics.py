"""Figures of a period, reckoned from what is kept of it."""

from itertools import pairwise

import numpy as np
import pytest

from app.domain.statistics import Kept, OpenJob, Phase, Queued, Transfer, Waited
from app.fleet.statistics import LATEST, Cause, Late, Place, cause_of, latest, mean_level, place_of, statistics, times


def transfer(created: float, *marks: float, state: str = "completed", vehicle: str = "V1") -> Transfer:
    """Return a transfer: assigned, acquire started, acquired, deposit started, deposited (and ended) at these moments."""
    given: list[float | None] = [*marks, *[None] * (5 - len(marks))]
    assigned, start, acquired, deposit, deposited = given
    ended = marks[-1] if len(marks) == 5 else created + 1
    return Transfer(
        "J", state, None, "A", "B", 50, vehicle, created, assigned, start, acquired, deposit, deposited, ended
    )


ONE = transfer(100, 110, 140, 150, 190, 200)
TWO = transfer(120, 130, 180, 190, 270, 280, vehicle="V2")


def test_each_phase_is_between_two_events() -> None:
    found = statistics(Kept([ONE, TWO], [], [], 0, {}), 0, 400, 200, ["V1", "V2"])
    assert {phase.value: one.mean for phase, one in found.phases.items()} == {
        "queued": 10,
        "fetching": 40,
        "acquiring": 10,
        "carrying": 60,
        "depositing": 10,
        "total": 130,
    }
    assert found.empty == pytest.approx(80 / 200)
    assert found.states == {"completed": 2, "failed": 0, "cancelled": 0, "aborted": 0}


def test_what_did_not_come_to_its_end_counts_for_no_phase() -> None:
    lost = transfer(100, 110, state="failed")
    found = statistics(Kept([lost], [], [], 0, {}), 0, 200, 200, ["V1"])
    assert found.phases[Phase.TOTAL].count == 0
    assert found.intervals[0].unfinished == 1
    assert found.empty is None
    assert lost.seconds(Phase.FETCHING) is None


def test_median_and_95th_percentile_of_a_hundred_times() -> None:
    found = times(float(n) for n in range(1, 101))
    assert (found.count, found.p50, found.longest) == (100, 50.5, 100)
    assert found.p95 == pytest.approx(95.05)
    assert times([None]) == times([])


def test_jobs_are_counted_in_the_interval_in_which_they_ended() -> None:
    queued = [Queued(100, 110), Queued(120, 130), Queued(250, None)]
    found = statistics(Kept([ONE, TWO], queued, [], 0, {}), 0, 350, 100, [])
    assert [(one.begin, one.ordered, one.completed) for one in found.intervals] == [
        (0, 0, 0),
        (100, 2, 0),
        (200, 1, 2),
        (300, 0, 0),
    ]
    assert [one.queue for one in found.intervals] == [0, 0.2, 0.5, 1.0]


def test_the_mean_queue_is_what_a_count_at_every_moment_gives() -> None:
    dice = np.random.default_rng(3)
    begins = dice.uniform(0, 1000, 200)
    queued = [Queued(begin, begin + wait) for begin, wait in zip(begins, dice.exponential(50, 200), strict=True)]
    edges = np.array([100.0, 300.0, 310.0, 900.0])
    steps = [np.linspace(a, b, 20_001) for a, b in pairwise(edges)]
    counted = [
        np.mean([sum(one.created <= at < (one.until or 0) for one in queued) for at in step[::200]]) for step in steps
    ]
    assert mean_level(queued, edges) == pytest.approx(counted, rel=0.1)


def test_a_vehicle_is_busy_with_what_lies_in_the_period() -> None:
    found = statistics(Kept([ONE], [], [], 0, {"V1": [(160.0, 170.0)]}), 120, 220, 100, ["V1", "V9"])
    first, second = found.vehicles
    assert (first.fetching, first.carrying, first.busy) == (20, 40, 0.8)
    assert (first.held_out.failures, first.held_out.to_repair) == (1, 10)
    assert (second.completed, second.busy, second.held_out.failures) == (0, 0, 0)


def test_waits_are_added_up_by_cause_without_names_and_within_the_period() -> None:
    waits = [
        Waited(0, 110, "P3 is occupied by FOUP0001", "J1"),
        Waited(100, 130, "STK01-P02 is occupied by FOUP2", "J2"),
        Waited(150, None, "no vehicle is free", "J3"),
        Waited(300, 400, "no vehicle is free", "J4"),
    ]
    found = statistics(Kept([], [], waits, 4, {}), 100, 200, 100, [])
    assert found.waits == (Cause("no vehicle is free", 1, 50.0), Cause("… is occupied by …", 2, 40.0))
    assert cause_of("P3 is closed by kim: x (closure 7)") == "… is closed by kim: x (closure …)"
    assert cause_of("given back by V002: on hold: 10.0.0.1:17001") == "given back by …: on hold: …"
    assert cause_of("no way leads from P1 to SB-L2: N4 is closed (x)") == "no way leads from … to …: … is closed (x)"


def test_waits_are_added_up_by_the_place_that_they_name_with_the_cause_there() -> None:
    waits = [
        Waited(100, 110, "P3 is occupied by FOUP0001", "J1"),
        Waited(120, 160, "P3 is closed by kim: x (closure 7)", "J1"),
        Waited(100, 130, "given back by V1: P3 is occupied by F2", "J2"),
        Waited(100, 170, "V1 is on hold", "J3"),
        Waited(100, 200, "no vehicle is free", "J4"),
    ]
    found = statistics(Kept([], [], waits, 4, {}), 100, 200, 100, ["V1"], ["P1", "P3"])
    assert found.places == (
        Place("P3", 2, 80.0, "… is closed by kim: x (closure …)"),
        Place("V1", 1, 70.0, "… is on hold"),
    )


@pytest.mark.parametrize(
    ("reason", "place"),
    [
        ("no way leads from V1 to P1: P3 is closed", "P1"),
        ("(P3) is closed", "P3"),
        ("V1: on hold", "V1"),
        ("P33 is empty", None),
        ("", None),
    ],
)
def test_the_place_of_a_wait_is_the_first_station_it_names_or_else_the_vehicle(reason: str, place: str | None) -> None:
    assert place_of(reason, {"P1", "P3"}, {"V1"}) == place


def test_the_latest_transfers_are_named_with_their_longest_wait_in_words() -> None:
    long = transfer(0, 110, 140, 150, 190, 200, vehicle="V2")
    waits = [
        Waited(0, 40, "no vehicle is free", "J"),
        Waited(40, 90, "P3 is empty", "J"),
        Waited(90, 110, "no vehicle is free", "J"),
        Waited(0, 500, "P9 is empty", "another"),
    ]
    found = statistics(Kept([long], [], [], 0, {}, waits), 150, 400, 250, ["V2"])
    assert found.late == (Late(long, "no vehicle is free", 60.0),)
    assert statistics(Kept([long], [], [], 0, {}), 150, 400, 250, []).late == (Late(long, "", 0.0),)


def test_no_more_than_a_few_are_the_latest_and_none_that_was_not_completed() -> None:
    many = [transfer(at, at + 1, at + 2, at + 3, at + 4, at + 5 + at) for at in range(20)]
    failed = transfer(0, 10, state="failed")
    assert latest([*many, failed]) == many[: -LATEST - 1 : -1]


def test_what_is_open_at_the_end_is_told_the_oldest_first() -> None:
    first, second = (OpenJob(name, None, "A", "B", 50, at, "P3 is empty") for name, at in (("J2", 10.0), ("J1", 20.0)))
    assert statistics(Kept([], [], [], 0, {}, (), [second, first]), 0, 100, 100, []).open == (first, second)
