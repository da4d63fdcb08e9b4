"""A fab at work in the fast plant: transfers come, are assigned, and are carried; ways follow the traffic."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from random import Random

import numpy as np
from scipy.optimize import linear_sum_assignment

from app.domain.layout import VehicleSpec
from app.domain.units import Barcode
from app.planning.admission import ANY, enter
from app.sim.kinematic.events import run, send
from app.sim.kinematic.network import Map, Whole
from app.sim.kinematic.state import DELIVERED, FETCHING, IDLE, LOADED, Rules, still
from app.sim.kinematic.load import Ports
from app.sim.kinematic.ways import free_flow, refresh, survey


@dataclass(frozen=True, slots=True)
class Plan:
    """What rules a run keeps to. Times in seconds."""

    admission: bool = True
    congestion: bool = True
    dispatch: str = "assignment"
    backlog: int = 200
    tick: float = 1.0
    rethink: float = 5.0
    reweigh: float = 10.0
    queue_penalty: float = 0.0
    smoothing: float = 0.2
    dwell: float = 10.0
    restart: float = 0.1
    patience: float = 0.0
    reaction: float = 0.2
    hearing: float = 0.05
    more: float = 1000.0
    active: int = 0
    """At most so many vehicles are at work at a time; 0: all."""


@dataclass(slots=True)
class Job:
    source: int
    destination: int
    created: float
    vehicle: int = -1


class Fab:
    def __init__(self, plan: Map, spec: VehicleSpec, ports: Sequence[Barcode], starts: Sequence[Barcode], seed: int, how: Plan) -> None:
        self.map, self.how = plan, how
        self.net = plan.network
        self.ways = survey(self.net)
        self.state = still(plan, len(starts))
        self.rules = Rules(float(spec.acceleration), float(spec.braking), how.reaction, how.hearing, 1000.0, how.more, how.dwell, how.restart, how.admission, how.smoothing, how.patience)
        self.ports = Ports([plan.number[b] for b in ports], Random(f"{seed}/ports"))
        self.at_port = np.array(self.ports.barcodes)
        self.jobs: list[Job] = []      # waiting or unpicked
        self.of: list[Job | None] = [None] * len(starts)
        self.now = 0.0
        self.free = free_flow(self.net)
        self.state.observed[:] = self.free
        self._place(starts)
        self._next_think = self._next_weigh = 0.0
        self.delivered: list[tuple[float, float]] = []
        self.rows = 0
        self.rng = Random(f"{seed}/rule")

    def _place(self, starts):
        s = self.state
        at = [self.map.number[b] for b in starts]
        for v, b in enumerate(at):
            s.at[v], s.owner[b] = b, v
        for v in sorted(range(len(at)), key=lambda v: -at[v]):
            enter(s.lines, v, int(self.net.buffer[at[v]]), ANY)

    def run(self, seconds: float) -> None:
        end = self.now + seconds
        while self.now < end:
            self._fill()
            self._weigh()
            self._dispatch()
            self.now += self.how.tick
            done = run(self.net, self.state, self.rules, self.now)
            for code in self.state.finished[:done].tolist():
                self._finish(code >> 1, code & 1)

    def _finish(self, vehicle: int, put_down: int) -> None:
        job = self.of[vehicle]
        if put_down:
            self.ports.filled(job.destination)
            self.delivered.append((job.created, self.now))
            self.of[vehicle] = None
        else:
            self.ports.emptied(job.source)
            self.jobs.remove(job)

    def _fill(self) -> None:
        waiting = sum(job.vehicle < 0 for job in self.jobs)
        while waiting < self.how.backlog and (drawn := self.ports.draw()):
            self.jobs.append(Job(*drawn, self.now))
            waiting += 1

    def _weigh(self) -> None:
        if not self.how.congestion or self.now < self._next_weigh:
            return
        self._next_weigh = self.now + self.how.reweigh
        s, w = self.state, self.ways
        w.weight[:] = np.maximum(self.free, s.observed) + self.how.queue_penalty * s.lines.load
        # what has not been driven lately is believed to be free again
        s.observed[:] += 0.02 * (self.free - s.observed)
        w.version[0] += 1
        goals = np.unique(self.net.buffer[s.goal[s.goal >= 0]])
        self.rows += refresh(self.net, w, s.hop, goals)

    def _dispatch(self) -> None:
        s = self.state
        rethink = self.now >= self._next_think and self.how.dispatch == "assignment"
        idle = s.phase == IDLE
        vehicles = np.flatnonzero(idle)
        if self.how.active:
            room = self.how.active - int((~idle).sum())
            vehicles = vehicles[:max(0, room)]
        if rethink:
            self._next_think = self.now + self.how.rethink
            vehicles = np.concatenate([vehicles, np.flatnonzero(s.phase == FETCHING)])
            vehicles = vehicles[s.doing[vehicles] != 2]
            jobs = [j for j in self.jobs if j.vehicle < 0 or s.doing[j.vehicle] != 2]
        else:
            jobs = [j for j in self.jobs if j.vehicle < 0]
        if not len(vehicles) or not jobs:
            return
        times = self._times(vehicles, jobs)
        if self.how.dispatch == "random":
            pairs = list(enumerate(self.rng.sample(range(len(jobs)), min(len(jobs), len(vehicles)))))
        elif self.how.dispatch == "nearest":
            pairs, taken = [], set()
            for j in range(len(jobs)):
                order = np.argsort(times[:, j])
                v = next((int(v) for v in order if int(v) not in taken), None)
                if v is None:
                    break
                taken.add(v)
                pairs.append((v, j))
        else:
            age = np.array([self.now - j.created for j in jobs])
            cost = times - (3600 * age / (3600 + age))[None, :]
            if rethink:
                bound = np.array([j.vehicle for j in jobs])
                mine = bound[None, :] == vehicles[:, None]
                has = (s.phase[vehicles] == FETCHING)[:, None] | (bound >= 0)[None, :]
                cost += 30.0 * (has & ~mine)
            rows, cols = linear_sum_assignment(cost)
            pairs = list(zip(rows.tolist(), cols.tolist()))
        self._assign(vehicles, jobs, pairs, rethink)

    def _assign(self, vehicles, jobs, pairs, rethink):
        s = self.state
        given = {}
        for r, c in pairs:
            given[int(vehicles[r])] = jobs[c]
        if rethink:
            for v in vehicles.tolist():
                old = self.of[v]
                if old is not None and given.get(v) is not old:
                    old.vehicle = -1
                    self.of[v] = None
            for v in vehicles.tolist():
                if v not in given and s.phase[v] == FETCHING:
                    s.phase[v] = IDLE
                    s.goal[v] = -1
                    s.lines.want[v] = ANY
        for v, job in given.items():
            if self.of[v] is job:
                continue
            job.vehicle = v
            self.of[v] = job
            s.destination[v] = self.ports.barcodes[job.destination]
            source = self.ports.barcodes[job.source]
            self.rows += refresh(self.net, self.ways, s.hop, np.array([self.net.buffer[source], self.net.buffer[s.destination[v]]]))
            send(self.net, s, self.rules, v, source, FETCHING)

    def _times(self, vehicles, jobs):
        s, net, w = self.state, self.net, self.ways
        n = s.granted[vehicles]
        at = np.where(n > 0, s.ahead[vehicles, np.maximum(n - 1, 0)], s.at[vehicles])
        goals = np.array([self.ports.barcodes[j.source] for j in jobs])
        gb, vb = net.buffer[goals], net.buffer[at]
        self.rows += refresh(net, w, s.hop, np.unique(gb))
        far = w.far[gb][:, vb].T - w.reach[at][:, None] + w.reach[goals][None, :]
        # own buffer: ahead is direct, behind is once round
        same = vb[:, None] == gb[None, :]
        behind = same & (goals[None, :] < at[:, None])
        if behind.any():
            nxt = s.hop[gb, gb]
            round_ = w.weight[gb] + w.far[gb, nxt]
            far = far + behind * round_[None, :]
        return far
