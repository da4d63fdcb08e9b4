"""Breakdowns and closures in the fast plant, and what counts as locked up."""

from dataclasses import replace

import numpy as np
import pytest

from app.cli.traffic.trials import HOIST, Drilled, Outcome, Storm, drill, fab_of, locked, run, together
from app.plant.fab import SIZES
from app.sim.kinematic.drill import CYCLE, STORM, Drill
from app.sim.kinematic.events import fail, remind, repair
from app.sim.kinematic.fab import Fab, Plant
from app.sim.kinematic.network import Map
from app.sim.kinematic.state import BROKEN, DELIVERED, DRIVING, STANDING, WATCHED
from app.sim.kinematic.waiting import watch

FAB = SIZES["1k"]
ALONE = Plant(restraint=False)


def test_a_vehicle_that_breaks_down_stands_at_its_next_barcode_keeps_its_grant_and_goes_on_once_repaired() -> None:
    fab = fab_of(FAB, 20, Plant(backlog=30), 1)
    fab.run(30)
    s = fab.state
    vehicle = int(np.flatnonzero((s.doing == DRIVING) & (s.granted > 1))[0])
    after = int(s.ahead[vehicle, 0])
    fail(s, vehicle)
    fab.run(5)
    assert (s.doing[vehicle], int(s.at[vehicle])) == (BROKEN, after)
    held = {int(s.owner[b]) for b in s.ahead[vehicle, : s.granted[vehicle]]}
    assert held == {vehicle}
    fab.run(60)
    assert int(s.at[vehicle]) == after
    repair(s, vehicle)
    fab.run(10)
    assert int(s.at[vehicle]) != after


def test_a_drill_names_the_ports_that_it_cuts_off_and_all_is_well_after_it() -> None:
    fab = fab_of(FAB, 30, Plant(backlog=40), 1)
    trouble = Drill(fab, per_hour=480.0, seed=3)
    trouble.run(200)
    s = fab.state
    assert len(trouble.events) > 10
    assert {event.vehicle >= 0 for event in trouble.events} == {True, False}
    ports = {fab.map.names[port] for port in fab.ports.barcodes}
    cut = [event for event in trouble.events if event.cut_off]
    assert cut
    assert {name for event in cut for name in event.cut_off} <= ports
    trouble.stop()
    assert not fab.cut_off
    assert not s.closed.any()
    assert not s.failed.any()
    before = int(s.counts[DELIVERED])
    fab.run(200)
    assert s.counts[DELIVERED] > before + 10
    assert locked(fab) == ()


def test_no_transfer_is_begun_to_a_port_that_is_cut_off() -> None:
    fab = fab_of(FAB, 10, Plant(backlog=10), 1)
    fab.cut_off = frozenset(fab.ports.barcodes)
    fab.run(60)
    assert (fab.transfers.vehicle < 0).all()
    fab.cut_off = frozenset()
    fab.run(60)
    assert (fab.transfers.vehicle >= 0).any()


def test_vehicles_that_wait_for_each_others_barcodes_are_found_locked() -> None:
    fab = fab_of(FAB, 3, Plant(), 1)
    s = fab.state
    for vehicle, other in ((0, 1), (1, 2), (2, 0)):
        s.doing[vehicle], s.waits_for[vehicle], s.goal[vehicle] = STANDING, s.at[other], s.at[other]
    assert locked(fab) == ("0", "1", "2")
    s.waits_for[1] = -1
    assert locked(fab) == ()


def test_events_come_in_storms_so_that_the_time_after_one_can_be_judged() -> None:
    trouble = Drill(fab_of(FAB, 12, Plant(backlog=5), 1), per_hour=20.0, seed=1)
    trouble.run(2 * CYCLE)
    since = [event.at - trouble.began for event in trouble.events]
    assert len(since) == 20
    assert sum(at >= CYCLE for at in since) == 10
    assert all(at % CYCLE <= STORM + 1.0 for at in since)


@pytest.mark.campaign
def test_a_whole_drill_compares_each_storm_with_the_same_fab_undisturbed() -> None:
    found = drill(FAB, 12, 0.5, 40.0, 1, settle=300.0)
    assert found.events == sum(storm.events for storm in found.storms) == 20
    assert found.outcome.locked == 0
    assert found.usual > found.outcome.per_hour * 0.5 > 0
    (storm,) = found.storms
    assert storm.before == 1.0, "nothing has happened yet: the twin is the same"
    assert storm.during != 1.0
    assert found.judged == [storm.then]


def test_a_storm_after_which_the_drill_ends_at_once_is_not_judged() -> None:
    found = drill(FAB, 12, 0.3, 40.0, 1, settle=30.0)
    assert found.judged == []


def storm(then: float | None, usual: int) -> Storm:
    return Storm(0.0, 300.0, 10, 1.0, 0.5, 0.9, then, usual)


def test_storms_of_several_drills_are_judged_by_all_they_delivered_together() -> None:
    quiet = Outcome(1, 1.0, (), 0, 0, 0, 0.0, 0.0)
    first = Drilled(20, 1, quiet, 100.0, (storm(0.5, 100), storm(1.0, 100), storm(1.0, 50)))
    second = Drilled(20, 1, quiet, 100.0, (storm(1.0, 300), storm(None, 0), storm(0.8, 50), storm(1.0, 9)))
    assert together([first]) == [0.5, 1.0, 1.0]
    assert together([first, second]) == pytest.approx([350 / 400, 90 / 100])
    assert together([]) == []


def test_a_run_counts_each_minute_and_the_fleet_that_is_held_back_delivers_too() -> None:
    some = run(fab_of(FAB, 30, Plant(backlog=40), 1), 4)
    assert len(some.per_minute) == 4
    assert some.locked == 0
    assert some.per_hour > 0
    assert replace(some, per_minute=(0, 0, 0, 9)).per_hour == 180.0
    assert HOIST.length == 950


@pytest.mark.parametrize("dispatch", ["random", "nearest", "assignment"])
def test_no_more_vehicles_set_out_than_may_whoever_is_chosen(dispatch: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("app.planning.restraint.Restraint.look", lambda *_: 0)
    fab = fab_of(FAB, 40, Plant(backlog=30, dispatch=dispatch), 1)
    fab.run(5)
    assert not fab.state.phase.any()
    monkeypatch.setattr("app.planning.restraint.Restraint.look", lambda *_: 7)
    fab.run(1)
    assert int((fab.state.phase != 0).sum()) == 7


def full(drawn: Fab, but: int = 0) -> Fab:
    """Return a fab with a vehicle at each place where one may wait, except for so many of the first of them."""
    plan: Map = drawn.map
    net, lines = plan.network, drawn.state.lines
    places = [
        int(net.last[buffer]) - place
        for buffer, slots in enumerate(lines.capacity)
        for place in range(0 if net.transit[buffer] else int(slots))
        if net.last[buffer] - place >= net.first[buffer]
    ]
    ports = [plan.names[port] for port in drawn.ports.barcodes]
    return Fab(plan, HOIST, ports, [plan.names[place] for place in places[but:]], 1, replace(ALONE, backlog=100))


def test_a_track_full_of_vehicles_is_locked_though_the_heads_of_its_queues_wait_for_no_barcode() -> None:
    fab = full(fab_of(FAB, 20, ALONE, 1))
    fab.run(60)
    s, circle = fab.state, [int(name) for name in locked(fab)]
    assert len(circle) > 1
    assert all(s.doing[vehicle] == STANDING for vehicle in circle)
    assert any(s.waits_for[vehicle] < 0 and s.watching[vehicle] for vehicle in circle)


def test_a_fleet_at_work_is_not_locked_and_one_that_waits_for_closed_track_neither() -> None:
    fab = fab_of(FAB, 60, ALONE, 1)
    for _ in range(10):
        fab.run(30)
        assert locked(fab) == ()
    fab.state.closed[fab.state.owner < 0] = 1
    fab.run(60)
    assert ((fab.state.doing == STANDING) & (fab.state.waits_for >= 0)).sum() > 30
    assert locked(fab) == ()


def test_who_hangs_on_more_buffers_than_it_can_watch_is_asked_again() -> None:
    fab = fab_of(FAB, 20, ALONE, 1)
    s = fab.state
    for buffer in range(WATCHED):
        watch(s, 3, buffer, 0.0)
    for buffer in range(WATCHED - 1):
        watch(s, 4, buffer, 0.0)
    remind(s)
    assert np.flatnonzero(s.queued).tolist() == [3]
