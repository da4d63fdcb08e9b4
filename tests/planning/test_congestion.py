"""What ways cost by the traffic on them, and how many vehicles may be on their way."""

import numpy as np
import pytest

from app.planning.congestion import Congestion, Costs
from app.planning.restraint import Limits, Restraint

COSTS = Costs(over=10.0, weight=2.0, power=2.0)


def congestion() -> Congestion:
    return Congestion(np.array([4.0, 4.0]), np.array([2, 0]), COSTS)


def test_ways_cost_their_free_flow_time_where_nobody_drives() -> None:
    assert congestion().costs().tolist() == [4.0, 4.0]


def test_a_full_piece_of_track_costs_as_much_more_as_is_said_and_never_more_than_that() -> None:
    ways = congestion()
    for _ in range(1000):
        ways.look(np.array([2, 7]), 1.0)
    assert ways.costs() == pytest.approx([12.0, 12.0])


def test_one_look_changes_little_and_an_old_jam_is_forgotten() -> None:
    ways = congestion()
    ways.look(np.array([2, 0]), 1.0)
    first = ways.costs()[0]
    assert 4.0 < first < 4.1
    for _ in range(200):
        ways.look(np.array([0, 0]), 1.0)
    assert ways.costs()[0] == pytest.approx(4.0)


def test_more_may_set_out_as_long_as_few_of_them_stand() -> None:
    fleet = Restraint(400, Limits(first=100))
    room = [fleet.look(standing=5, driving=95, under_way=fleet.most, seconds=1.0) for _ in range(50)]
    assert room[0] == 1
    assert fleet.most == 150


def test_between_the_two_limits_the_number_stays_and_a_tenth_standing_lies_between_them() -> None:
    fleet = Restraint(400, Limits(first=100, low=0.0))
    for _ in range(200):
        fleet.look(standing=10, driving=90, under_way=fleet.most, seconds=1.0)
    assert fleet.most == 100
    fleet = Restraint(400, Limits(first=100))
    for _ in range(200):
        fleet.look(standing=10, driving=90, under_way=fleet.most, seconds=1.0)
    grown = fleet.most
    for _ in range(200):
        fleet.look(standing=10, driving=90, under_way=fleet.most, seconds=1.0)
    assert fleet.most == grown < 130


def test_fewer_may_be_on_their_way_while_many_stand_but_never_fewer_than_the_least() -> None:
    fleet = Restraint(400, Limits(first=100, least=60))
    for _ in range(5):
        fleet.look(standing=80, driving=20, under_way=100, seconds=1.0)
    for _ in range(200):
        assert fleet.look(standing=80, driving=20, under_way=100, seconds=1.0) == 0
    assert fleet.most == 60
    assert fleet.look(standing=80, driving=20, under_way=40, seconds=1.0) == 20


def test_the_number_does_not_grow_where_nobody_asks_for_more_nor_beyond_the_fleet() -> None:
    fleet = Restraint(110, Limits(first=100))
    for _ in range(50):
        fleet.look(standing=0, driving=20, under_way=20, seconds=1.0)
    assert fleet.most == 100
    for _ in range(50):
        fleet.look(standing=0, driving=99, under_way=fleet.most, seconds=1.0)
    assert fleet.most == 110
