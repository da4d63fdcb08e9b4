"""AGVs on two-way track: corridors for one, and jobs that all end whoever meets whom (TRAFFIC section 5)."""

from random import Random

import networkx as nx
import pytest

from app.domain.layout import Plant
from app.domain.units import Barcode
from app.planning.floor import corridors, floor_of
from app.planning.track import Track
from app.planning.ways import Ways
from tests.agv.hall import HallWorld, hall, tag
from tests.shares import shared

TEN_MINUTES = 600.0


def star(agvs: int) -> Plant:
    """Return five spurs around one junction."""
    tips = [21, 31, 41, 51, 61]
    spurs = [f"1-{tip - 1}-{tip}" for tip in tips]
    return hall(two_way=spurs, stations=tips, starts=tips[-agvs:], carts=2)


def ring(agvs: int, *, two_way: bool = False) -> Plant:
    """Return a ring with four two-way spurs."""
    spurs = ["2-20-21", "4-40-41", "6-60-61", "8-80"]
    round_ = ["1-2-3-4-5-6-7-8-1"]
    starts = ([21, 41, 61] if two_way else [1, 3, 5])[:agvs]
    return hall(
        two_way=[*spurs, *(round_ if two_way else [])],
        one_way=[] if two_way else round_,
        stations=[21, 41, 61, 80],
        starts=starts,
        carts=2,
    )


def ladder() -> Plant:
    """Return a corridor with rungs, one of them a waiting place."""
    return hall(
        two_way=["1-2-3-4-5", "2-12", "3-13", "4-14"], stations=[1, 5, 12, 14], starts=[13, 1], carts=2, parks=[13]
    )


def tree(seed: int, agvs: int) -> Plant | None:
    """Return a random tree with stations at its ends, two more than AGVs; None: it has too few ends."""
    dice = Random(seed)
    branches = [(n, dice.randrange(1, n)) for n in range(2, dice.randrange(7, 13))]
    graph = nx.Graph(branches)
    tips = sorted(n for n in graph if graph.degree(n) == 1)
    if len(tips) < agvs + 2:
        return None
    stations = sorted(dice.sample(tips, agvs + 2))
    return hall(two_way=[f"{a}-{b}" for a, b in branches], stations=stations, starts=dice.sample(tips, agvs), carts=2)


def mesh(seed: int) -> Plant:
    """Return a random two-way network with rings, two AGVs and stations anywhere."""
    dice = Random(seed)
    while True:
        count = dice.randrange(6, 12)
        pieces = {(n, dice.randrange(1, n)) for n in range(2, count + 1)}
        pieces |= {(max(p), min(p)) for p in (dice.sample(range(1, count + 1), 2) for _ in range(3))}
        graph = nx.Graph(sorted(pieces))
        if nx.check_planarity(graph)[0]:
            break
    stations, starts = sorted(dice.sample(sorted(graph), 5)), dice.sample(sorted(graph), 2)
    return hall(two_way=[f"{a}-{b}" for a, b in sorted(pieces)], stations=stations, starts=starts, carts=2)


def worked(plant: Plant, seed: int) -> HallWorld:
    """Return the world after ten minutes of jobs that all have ended."""
    world = HallWorld(plant, seed)
    world.work(until=TEN_MINUTES, keep_open=2)
    world.run(TEN_MINUTES)
    assert world.finish(TEN_MINUTES), world.said()
    result = world.result()
    assert result.violations == ()
    assert result.completed == result.ended >= 10
    return world


@pytest.mark.parametrize(
    "plant",
    [star(2), star(3), ring(2), ring(3), ring(2, two_way=True), ring(3, two_way=True), ladder()],
    ids=["star 2", "star 3", "ring 2", "ring 3", "two-way ring 2", "two-way ring 3", "ladder"],
)
def test_agvs_that_want_each_others_place_all_come_through(plant: Plant) -> None:
    worked(plant, 1)


@pytest.mark.parametrize("seeds", shared([range(9), range(9, 16)], 1), ids=["few", "more"])
@pytest.mark.parametrize("agvs", [2, 3])
def test_no_agvs_lock_up_on_any_tree_with_more_ends_than_agvs(agvs: int, seeds: range) -> None:
    trees = [(seed, plant) for seed in seeds if (plant := tree(seed, agvs))]
    assert len(trees) >= 2
    for seed, plant in trees:
        worked(plant, seed)


@pytest.mark.parametrize("seed", shared([*range(10)], 3))
def test_no_two_agvs_lock_up_on_any_two_way_network(seed: int) -> None:
    worked(mesh(seed), seed)


def test_a_chain_of_two_way_track_is_a_corridor_and_so_is_a_junction() -> None:
    plant = hall(two_way=["1-2-3-4", "4-5", "4-6-7"], one_way=["7-8-9-7"], stations=[1, 5], starts=[1], carts=1)
    zones = [zone.barcodes for zone in corridors(plant, floor_of(plant))]
    assert {tag(1), tag(2), tag(3)} in zones
    assert {tag(4)} in zones
    assert {tag(7)} in zones
    assert {tag(6)} in zones
    assert not any(tag(8) in zone or tag(5) in zone for zone in zones)
    track = Track(plant)
    assert track.no_stop(tag(2))
    assert track.may_rest(tag(1))
    assert track.may_rest(tag(8))
    assert not track.may_rest(tag(4))


def test_a_waiting_place_parts_a_corridor() -> None:
    plant = hall(two_way=["1-2-3-4-5"], stations=[1, 5], starts=[1], carts=1, parks=[3])
    zones = [zone.barcodes for zone in corridors(plant, floor_of(plant))]
    assert zones == [{tag(1), tag(2)}, {tag(4), tag(5)}]


def test_the_track_of_hoists_has_no_corridors() -> None:
    plant = hall(two_way=["1-2-3"], stations=[], starts=[], carts=0)
    assert floor_of(plant) == frozenset()
    assert corridors(plant, floor_of(plant)) == ()


def test_an_agv_is_left_alone_only_on_the_one_shortest_way() -> None:
    plant = hall(two_way=["1-2-3-4", "1-5-4"], stations=[1, 3], starts=[1], carts=1)
    ways = Ways(Track(plant))

    def sure(*numbers: int) -> int:
        return ways.sure([Barcode(tag(n)) for n in numbers])

    assert sure(1, 2, 3) == 2, "no way to 3 is as short"
    assert sure(1, 2, 3, 4) == 2, "1-5-4 is shorter"
    assert sure(1, 2, 1) == 1, "it must be told to turn where it is to turn"
    assert sure(2, 3, 4, 5) == 2, "2-1-5 is as short as 2-3-4-5"
    assert sure(1) == 0
