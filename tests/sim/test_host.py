from random import Random

from app.domain.ids import CarrierId, StationId
from app.domain.job import JobState
from app.domain.requests import CreateJob
from app.sim.host import REPEAT_AFTER, Host
from app.sim.workload import Pace

IDS = [StationId(name) for name in "ABCDEF"]


class Desk:
    """What the host sees of the world: carriers at A and B, and the jobs that are durable."""

    def __init__(self, seed: int = 1, keep: int = 2) -> None:
        self.at = {StationId("A"): CarrierId("F1"), StationId("B"): CarrierId("F2")}
        self.jobs: dict[str, JobState] = {}
        self.asked: list[CreateJob] = []
        pace = Pace(Random(seed), keep_open=keep)
        self.host = Host(IDS, self.at, self.jobs, self.asked.append, pace, Random(seed))


def test_orders_are_kept_open_and_no_station_is_in_two_chains() -> None:
    for seed in range(30):
        desk = Desk(seed)
        desk.host.look(0.0)
        carriers = {request.carrier for request in desk.asked}
        assert len(desk.asked) >= len(carriers) >= 1
        ends = [end for request in desk.asked for end in (request.source, request.destination)]
        chained = len(desk.asked) - len(carriers)
        assert len(set(ends)) == len(ends) - chained


def test_a_chain_begins_where_the_carrier_will_be() -> None:
    chains = 0
    for seed in range(30):
        desk = Desk(seed, keep=1)
        desk.host.look(0.0)
        if len(desk.asked) == 2:
            chains += 1
            first, second = desk.asked
            assert (second.source, second.carrier) == (first.destination, first.carrier)
    assert chains


def test_an_order_that_nobody_knows_is_repeated_word_for_word() -> None:
    desk = Desk(keep=1)
    desk.host.look(0.0)
    first = list(desk.asked)
    desk.host.look(REPEAT_AFTER / 2)
    assert desk.asked == first
    desk.host.look(REPEAT_AFTER)
    assert desk.asked == first * 2


def test_an_order_that_is_known_is_not_repeated_and_when_it_ends_another_follows() -> None:
    desk = Desk(keep=1)
    desk.host.look(0.0)
    first = list(desk.asked)
    for request in first:
        assert request.job is not None
        desk.jobs[request.job] = JobState.WAITING
    desk.host.look(REPEAT_AFTER)
    assert desk.asked == first
    for job in desk.jobs:
        desk.jobs[job] = JobState.COMPLETED
    desk.host.look(REPEAT_AFTER + 1)
    assert len(desk.asked) > len(first)


def test_without_room_nothing_is_ordered() -> None:
    desk = Desk()
    desk.at.clear()
    desk.host.look(0.0)
    assert desk.asked == []
