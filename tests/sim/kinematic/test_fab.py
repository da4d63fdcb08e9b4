"""The fast plant: nobody meets, nobody locks up, every carrier is in one place, and the same seed gives the same run."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest

from app.domain.layout import Plant as Layout
from app.domain.units import Millimetres
from app.planning.restraint import Restraint
from app.planning.track import BOOK_VEHICLE, Track
from app.plant.fab import SIZES, generate, populate
from app.sim.kinematic.fab import Fab, Plant
from app.sim.kinematic.network import Map, draw
from app.sim.kinematic.state import DWELLING, STANDING
from app.sim.kinematic.ways import grow, lead, renew, survey

HOIST = replace(BOOK_VEHICLE, length=Millimetres(950))


@pytest.fixture(scope="module")
def layout() -> Layout:
    return generate(SIZES["1k"], 1).plant


@pytest.fixture(scope="module")
def plan(layout: Layout) -> Map:
    return draw(Track(layout), HOIST)


def fab(layout: Layout, plan: Map, vehicles: int, how: Plant) -> Fab:
    starts = [vehicle.start for vehicle in populate(layout, vehicles, 1, 0.5).vehicles]
    ports = list(dict.fromkeys(station.barcode for station in layout.stations))
    parking = [point.barcode for point in layout.points if point.park]
    return Fab(plan, HOIST, ports, [start for start in starts if start is not None], 1, how, parking=parking)


def test_every_barcode_has_one_holder_and_every_vehicle_holds_where_it_is_and_its_grant(
    layout: Layout, plan: Map
) -> None:
    run = fab(layout, plan, 60, Plant(backlog=50))
    for _ in range(20):
        run.run(15)
        s = run.state
        held = Counter(s.owner[s.owner >= 0].tolist())
        for vehicle in range(60):
            ahead = s.ahead[vehicle, : s.granted[vehicle]].tolist()
            assert {int(s.owner[b]) for b in (int(s.at[vehicle]), *ahead)} == {vehicle}
            assert held[vehicle] == 1 + len(ahead)


def test_lines_hold_every_vehicle_once_and_no_buffer_more_than_its_slots(layout: Layout, plan: Map) -> None:
    run = fab(layout, plan, 100, Plant(backlog=50))
    for _ in range(10):
        run.run(30)
        lines = run.state.lines
        assert Counter(lines.slot)[-1] == 0
        for buffer, load in enumerate(lines.load):
            line, vehicle = [], lines.head[buffer]
            while vehicle >= 0:
                line.append(vehicle)
                vehicle = lines.behind[vehicle]
            assert len(line) == load <= lines.capacity[buffer]
            assert all(lines.slot[v] == buffer for v in line)


def test_transfers_end_where_they_were_ordered_to(layout: Layout, plan: Map) -> None:
    run = fab(layout, plan, 20, Plant(backlog=20))
    run.run(900)

    assert len(run.delivered) > 50
    assert all(d.created <= d.at for d in run.delivered)
    resting = (run.state.doing == STANDING) | (run.state.doing == DWELLING)
    assert (run.state.pace[resting] == 0).all()


def test_who_is_kept_back_parks_where_ways_keep_off_and_the_rest_of_the_track_is_free(
    layout: Layout, plan: Map, monkeypatch: pytest.MonkeyPatch
) -> None:
    def forty(_: Restraint, standing: int, driving: int, under_way: int, seconds: float) -> int:
        return max(0, 40 - under_way)

    monkeypatch.setattr(Restraint, "look", forty)
    run = fab(layout, plan, 100, Plant(backlog=50))
    s, lines = run.state, run.state.lines
    kept = np.flatnonzero(s.park)
    assert sum(lines.capacity[b] for b in kept) >= 1.3 * (100 - 0.024 * len(run.net.buffer))
    assert not {int(run.net.buffer[p]) for p in run.ports.barcodes} & set(kept.tolist())
    run.run(900)
    parked = s.park[np.asarray(lines.slot)] == 1
    idle = s.phase == 0
    assert idle.sum() > 20
    assert (parked & idle).sum() > 0.7 * idle.sum()
    assert (parked & ~idle).sum() < 5


def test_ways_lead_over_track_kept_free_only_where_no_other_does(layout: Layout, plan: Map) -> None:
    run = fab(layout, plan, 100, Plant(backlog=50))
    run._know(np.arange(len(run.net.first)))
    kept, met, steps = run.state.park == 1, 0, 0
    for start in range(0, len(kept), 5):
        for goal in range(0, len(kept), 5):
            here = start
            while here != goal and not kept[goal] and not kept[start]:
                here = int(run.state.hop[goal, here])
                met, steps = met + int(kept[here]), steps + 1
    assert met < steps / 200


def test_a_fleet_that_is_not_kept_back_has_no_track_kept_free(layout: Layout, plan: Map) -> None:
    run = fab(layout, plan, 100, Plant(restraint=False))
    assert not run.state.park.any()
    assert not run.ways.extra.any()


def test_the_same_seed_gives_the_same_run(layout: Layout, plan: Map) -> None:
    runs = [fab(layout, plan, 40, Plant(backlog=30)) for _ in range(2)]
    for run in runs:
        run.run(400)

    assert runs[0].delivered == runs[1].delivered
    assert runs[0].state.counts.tolist() == runs[1].state.counts.tolist()


def test_next_hops_lead_to_the_goal_in_the_time_they_say(plan: Map) -> None:
    net, ways = plan.network, survey(plan.network)
    hop = np.full(len(net.first), -1, dtype=np.int64)
    for goal in (0, 40, 99):
        grow(ways, goal, hop)
        for start in range(0, len(net.first), 7):
            here, time, steps = start, 0.0, 0
            while here != goal:
                time += ways.weight[here]
                here, steps = int(hop[here]), steps + 1
                assert steps <= len(net.first)
            assert time == pytest.approx(float(ways.far[goal, start]))


def test_a_row_made_by_the_order_of_its_old_one_is_as_exact_as_one_grown_from_the_start(plan: Map) -> None:
    net, dice = plan.network, np.random.default_rng(1)
    ways, fresh = survey(net), survey(net)
    size, kept = len(net.first), 0
    hop, again = np.zeros(size, dtype=np.int64), np.zeros(size, dtype=np.int64)
    free = ways.weight.copy()
    for goal in range(0, size, 5):
        ways.weight[:] = free
        grow(ways, goal, again)
        ways.weight[:] = fresh.weight[:] = free * dice.uniform(1.0, 3.0, size)
        grow(fresh, goal, hop)
        lead(ways, net)
        if renew(ways, net, goal, again):
            kept += 1
            assert ways.far[goal] == pytest.approx(fresh.far[goal])
            for here in range(size):
                if here != goal:
                    assert fresh.far[goal, again[here]] + fresh.weight[here] == fresh.far[goal, here]
    assert kept > size // 5 * 0.9, "hardly any row was made by its order"
