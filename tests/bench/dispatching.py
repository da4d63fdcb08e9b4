"""Who does which job: the time of one assignment, and what the rule is worth under a backlog, on an empty fab without jams."""

import gc
import random
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial
from heapq import heapify, heappop, heappush
from itertools import count

import numpy as np
from scipy.optimize import linear_sum_assignment

from app.cli.bench import generated
from app.domain.events import LinkUp, Reported
from app.domain.ids import Actor, CmdIds, JobId
from app.domain.requests import CreateJob
from app.domain.units import Seconds, Timestamp
from app.domain.vehicle import VehicleStatus
from app.domain.view import LinkView
from app.fleet import Fleet
from app.planning.dispatch import Floats, Indices, Jobs, Rule, Times, Vehicles, at_random, dispatch, nearest_first_come
from app.sim.memory import MemoryLedger
from tests.bench.measuring import Row, in_turn
from tests.fleet.script import words

BAYS = 40
PORTS = 25
"""Ports of a bay."""
HANDLING = 10.0
ROUNDS = 3
"""The ticks of a fleet are the same in each run: the quickest counts."""


def fab(draw: np.random.Generator) -> Floats:
    """Return the drive times between the ports of a fab: one-way loops of 150 m on both sides of a one-way spine of 400 m."""
    bay, port = np.divmod(np.arange(BAYS * PORTS), PORTS)
    on_spine, in_bay = bay // 2 * 20.0, (port + draw.random(len(port))) * 6.0
    between = (on_spine[None] - on_spine[:, None]) % 400
    around = (in_bay[None] - in_bay[:, None]) % 150
    metres = np.where(bay[:, None] == bay[None], around, 150 - in_bay[:, None] + between + in_bay[None])
    return metres / 2.5


@dataclass(frozen=True, slots=True)
class Shift:
    """What became of a shift: jobs delivered per hour, and how long the waits until the pick-up were, in seconds."""

    per_hour: float
    waits: Floats


def shift(rule: Rule, table: Floats, vehicles: int, backlog: int, hours: float = 1.0, seed: int = 1) -> Shift:
    """Return what a rule makes of a shift in which so many jobs wait at every moment."""
    draw = np.random.default_rng(seed)
    ports = len(table)
    sources, targets = draw.integers(ports, size=(2, backlog))
    since = np.zeros(backlog)
    where, order = draw.integers(ports, size=vehicles), count()
    free = [(0.0, next(order), row) for row in range(vehicles)]
    heapify(free)
    done, waits, end = 0, [], hours * 3600
    begin = end / 4
    while free[0][0] < end:
        now, idle = free[0][0] + 1.0, []
        while free and free[0][0] <= now:
            idle.append(heappop(free)[2])
        here = where[idle]
        plan = rule(Vehicles.idle(len(idle)), Jobs.waiting(now - since), partial(_block, table, here, sources))
        for job in np.flatnonzero(plan.vehicle >= 0).tolist():
            vehicle = idle[plan.vehicle[job]]
            fetched = now + table[where[vehicle], sources[job]]
            ended = fetched + 2 * HANDLING + table[sources[job], targets[job]]
            if begin < ended <= end:
                done += 1
                waits.append(fetched - since[job])
            heappush(free, (ended, next(order), vehicle))
            where[vehicle] = targets[job]
            sources[job], targets[job], since[job] = draw.integers(ports), draw.integers(ports), now
        left = set(idle) - {idle[row] for row in plan.vehicle[plan.vehicle >= 0].tolist()}
        for vehicle in sorted(left):
            heappush(free, (now, next(order), vehicle))
    return Shift(done / (end - begin) * 3600, np.array(waits))


def _block(table: Floats, here: Indices, there: Indices, rows: Indices, columns: Indices) -> Floats:
    return table.take(here[rows][:, None] * len(table) + there[columns])


def tick(vehicles: int, jobs: int, per_fetch: int = 3) -> tuple[Callable[[], float], Callable[[], float]]:
    """Return what measures one assignment, bare and ours, in milliseconds of CPU: every third vehicle fetches already."""
    draw = np.random.default_rng(7)
    table = fab(draw)
    here, there = draw.integers(len(table), size=vehicles), draw.integers(len(table), size=jobs)
    fleet = Vehicles.idle(vehicles)
    engaged = np.arange(0, vehicles, per_fetch)[: jobs // per_fetch]
    fleet.job[engaged] = np.arange(len(engaged))
    asked = Jobs.waiting(draw.random(jobs) * 200)
    whole: Times = partial(_block, table, here, there)
    costs = whole(np.arange(vehicles), np.arange(jobs))
    return partial(_cpu, partial(linear_sum_assignment, costs)), partial(_cpu, partial(dispatch, fleet, asked, whole))


def thinking(vehicles: int, jobs: int, ticks: int = 200) -> list[float]:
    """Return the CPU milliseconds of a fleet's ticks from the moment at which its idle vehicles see so many jobs."""
    plant, kept, draw = generated(vehicles, 1), MemoryLedger().load(), random.Random(1)
    fleet = Fleet(
        plant, kept, CmdIds(kept.epoch), Seconds(0), Timestamp(1e9), lambda _: LinkView(up=True, since=0.0, reason="")
    )
    for spec in plant.vehicles:
        fleet.handle(LinkUp(spec.id), Seconds(0))
    now = 0.0
    for now in (1.5, 3.0, 4.5):
        while fleet.deadline <= now:
            fleet.tick(Seconds(now))
            fleet.take()
        for spec in plant.vehicles:
            assert spec.start is not None
            status = VehicleStatus(words(), spec.start, 0)
            fleet.handle(Reported(spec.id, status, polled=True, asked_at=Seconds(now)), Seconds(now))
    full = [station for station, record in fleet.books.stations.items() if record.present]
    empty = [station for station, record in fleet.books.stations.items() if not record.present]
    for n in range(jobs):
        source, destination = draw.choice(full), draw.choice(empty)
        fleet.ask(CreateJob(Actor("bench"), JobId(f"J{n}"), source, destination, None, 50, "0"), n, Seconds(now))
    fleet.take()
    gc.collect()
    gc.freeze()
    took = []
    for _ in range(ticks):
        now = max(now + 0.001, fleet.deadline)
        took.append(_cpu(partial(fleet.tick, Seconds(now))))
        fleet.take()
    gc.unfreeze()
    return took


def _cpu(call: Callable[[], object]) -> float:
    began = time.thread_time_ns()
    call()
    return (time.thread_time_ns() - began) / 1e6


def rows() -> Iterator[Row]:
    """Measure one assignment, and what the rule delivers under a backlog."""
    for vehicles, jobs in ((1000, 300), (3000, 3000)):
        bare, ours = tick(vehicles, min(jobs, 300))[0], tick(vehicles, jobs)[1]
        floor, our_time = in_turn(7, bare, ours)
        note = (
            ""
            if jobs <= 300
            else "floor: bare assignment of 3,000 x 300, since 3,000 x 3,000 blocks for seconds; the rest waits its turn"
        )
        yield Row(
            f"one assignment, {vehicles:,} vehicles x {jobs:,} jobs; floor: bare linear_sum_assignment",
            our_time, floor, None, "ms CPU/tick", None, note=note,
        )  # fmt: skip
    runs = [thinking(1000, 3000) for _ in range(ROUNDS)]
    took = [min(same) for same in zip(*runs, strict=True)]
    yield Row(
        "longest tick of a fleet, 1,000 idle vehicles and 3,000 jobs; floor: what the loop may be held, 5 ms",
        max(took), 5.0, None, "ms CPU", 1.0,
        note=f"mean of {len(took)} ticks {sum(took) / len(took):.2f} ms; each tick at its quickest of {ROUNDS} runs, "
        f"since neighbours hold up any; the longest of each run: {', '.join(f'{max(run):.1f}' for run in runs)} ms",
    )  # fmt: skip
    table = fab(np.random.default_rng(0))
    by_chance = at_random(np.random.default_rng(3))
    ours_, first, chance = (shift(rule, table, 400, 200) for rule in (dispatch, nearest_first_come, by_chance))
    yield Row(
        "deliveries with 400 vehicles and 200 jobs waiting; floor: first come, nearest; naive: random",
        ours_.per_hour, first.per_hour, chance.per_hour, "jobs/h, empty fab", 1.5, "higher",
    )  # fmt: skip
    yield Row(
        "longest wait until the pick-up in that shift; floor: first come, nearest; naive: random",
        ours_.waits.max(), first.waits.max(), chance.waits.max(), "s", 1.0,
    )  # fmt: skip
