"""What counts as locked up in the trials of traffic: waits for barcodes, and waits for room behind others."""

from dataclasses import replace

import numpy as np

from app.cli.traffic.trials import HOIST, fab_of, locked
from app.plant.fab import SIZES
from app.sim.kinematic.events import remind
from app.sim.kinematic.fab import Fab, Plant
from app.sim.kinematic.network import Map
from app.sim.kinematic.state import STANDING, WATCHED
from app.sim.kinematic.waiting import watch

FAB = SIZES["1k"]
ALONE = Plant(restraint=False)


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
