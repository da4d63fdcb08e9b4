"""A fab at work in the fast plant: transfers come, are assigned, and are carried; ways follow the traffic."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from random import Random

import numpy as np
from numpy.typing import NDArray

from app.domain.layout import VehicleSpec
from app.domain.units import Barcode, Seconds
from app.planning.admission import ANY, enter
from app.planning.congestion import Congestion
from app.planning.dispatch import Indices, Jobs, Rule, Times, Vehicles, at_random, dispatch, nearest_first_come
from app.planning.dispatch import Plan as DispatchPlan
from app.planning.restraint import Restraint
from app.sim.kinematic.events import run, send, take_off
from app.sim.kinematic.load import Ports, Work
from app.sim.kinematic.network import Map, Real
from app.sim.kinematic.state import DRIVING, DWELLING, FETCHING, IDLE, STANDING, Rules, still
from app.sim.kinematic.ways import free_flow, refresh, survey

TICK = 1.0
"""Seconds between two looks of dispatch. Our choice."""


@dataclass(frozen=True, slots=True)
class Plant:
    """What a run keeps to. Times in seconds, ways in mm; all values are our choice where no specification gives them.

    ``admission``: the look-ahead of TRAFFIC section 3; without it the track itself is all that is asked for. ``reweigh``: how
    often ways are thought over by the traffic (``planning.congestion``; 0: never, static shortest ways). ``restraint``: no more
    vehicles set out than the track carries (``planning.restraint``). ``dispatch``: assignment, nearest or random; ``backlog``
    transfers wait at any time. ``patience``: a soft meter is ignored after so long; 0: there are none.
    """

    admission: bool = True
    reweigh: float = 0.0
    restraint: bool = True
    dispatch: str = "assignment"
    backlog: int = 200
    rethink: float = 5.0
    dwell: float = 10.0
    restart: float = 0.1
    reaction: float = 0.2
    hearing: float = 0.05
    more: float = 1000.0
    patience: float = 0.0


@dataclass(slots=True)
class Transfer:
    """A transfer between two ports, by number. ``vehicle``: who is on its way to fetch it, -1: nobody."""

    source: int
    destination: int
    created: float
    vehicle: int = -1


@dataclass(frozen=True, slots=True)
class Delivered:
    """A transfer that has been carried. Times in seconds."""

    created: float
    at: float


class Fab:
    """A fleet with a backlog of transfers, drawn over the ports unless ``work`` gives them. Same arguments, same run."""

    def __init__(
        self,
        plan: Map,
        spec: VehicleSpec,
        ports: Sequence[Barcode],
        starts: Sequence[Barcode],
        seed: int,
        how: Plant,
        work: Work | None = None,
    ) -> None:
        self.map, self.how, self.net = plan, how, plan.network
        self.ways = survey(self.net)
        self.state = still(plan, len(starts))
        self.rules = Rules(
            acceleration=float(spec.acceleration),
            braking=float(spec.braking),
            reaction=how.reaction,
            hearing=how.hearing,
            edge=1000.0,
            more=how.more,
            dwell=how.dwell,
            restart=how.restart,
            admission=how.admission,
            patience=how.patience,
        )
        self.ports: Work = work or Ports([plan.number[b] for b in ports], Random(f"{seed}/ports"))
        self.waiting: list[Transfer] = []
        """Transfers that are not picked up, the oldest first."""
        self.delivered: list[Delivered] = []
        self.now = Seconds(0.0)
        self.shut: dict[int, float] = {}
        """What ways over a buffer cost besides, s: somebody stands still there, or it is closed."""
        self.cut_off: frozenset[int] = frozenset()
        """Ports that cannot be reached just now: their transfers wait."""
        self.rows = 0
        """Rows of next hops made so far."""
        self._of: list[Transfer | None] = [None] * len(starts)
        self._room = len(starts)
        self._restraint = Restraint(len(starts)) if how.restraint else None
        self._congestion = Congestion(free_flow(self.net), np.asarray(self.state.lines.capacity))
        self._rule: Rule = self._rule_of(seed)
        self._next_thought = self._next_weighing = 0.0
        self._turn = 0
        self._place([plan.number[b] for b in starts])

    def run(self, seconds: float) -> None:
        """Let time pass."""
        end = self.now + seconds
        while self.now < end:
            self._order()
            self._look()
            self._weigh()
            self._dispatch()
            self.now = Seconds(min(end, self.now + TICK))
            done = run(self.net, self.state, self.rules, self.now)
            for code in self.state.finished[:done].tolist():
                self._finish(code >> 1, put_down=bool(code & 1))

    @property
    def stuck(self) -> int:
        """How many vehicles wait for track or for room."""
        return int((self.state.since >= 0).sum())

    def _rule_of(self, seed: int) -> Rule:
        if self.how.dispatch == "random":
            return at_random(np.random.default_rng(seed))
        return nearest_first_come if self.how.dispatch == "nearest" else self._assignment

    def _assignment(self, vehicles: Vehicles, jobs: Jobs, times: Times) -> DispatchPlan:
        self._turn += 1
        return dispatch(vehicles, jobs, times, turn=self._turn)

    def _place(self, starts: list[int]) -> None:
        s = self.state
        for vehicle, barcode in enumerate(starts):
            s.at[vehicle], s.owner[barcode] = barcode, vehicle
        for vehicle in sorted(range(len(starts)), key=lambda v: -starts[v]):
            enter(s.lines, vehicle, int(self.net.buffer[starts[vehicle]]), ANY)

    def _finish(self, vehicle: int, *, put_down: bool) -> None:
        transfer = self._of[vehicle]
        if transfer is None:
            raise LookupError(f"vehicle {vehicle} has handled a carrier without a transfer")
        if put_down:
            self.ports.filled(transfer.destination)
            self.delivered.append(Delivered(transfer.created, self.now))
            self._of[vehicle] = None
        else:
            self.ports.emptied(transfer.source)
            self.waiting.remove(transfer)

    def _order(self) -> None:
        missing = self.how.backlog - sum(transfer.vehicle < 0 for transfer in self.waiting)
        while missing > 0 and (drawn := self.ports.draw()):
            self.waiting.append(Transfer(*drawn, self.now))
            missing -= 1

    def _look(self) -> None:
        """Look at who is on the way: where, and how many of them stand."""
        s = self.state
        under_way = s.phase != IDLE
        size = len(self.net.first)
        self._congestion.look(np.bincount(np.asarray(s.lines.slot)[under_way], minlength=size), TICK)
        if self._restraint is not None:
            standing, driving = self._standing(under_way), int((under_way & (s.doing == DRIVING)).sum())
            self._room = self._restraint.look(standing, driving, int(under_way.sum()), TICK)

    def _standing(self, under_way: "NDArray[np.bool_]") -> int:
        """Return how many stand though they are on their way, without those before whom one stands that is asked to go on."""
        s = self.state
        waits_for = s.waits_for[under_way & (s.doing == STANDING)]
        before = s.owner[waits_for[waits_for >= 0]]
        return len(waits_for) - int((s.phase[before[before >= 0]] == IDLE).sum())

    def _weigh(self) -> None:
        if self.how.reweigh and self.now >= self._next_weighing:
            self._next_weighing = self.now + self.how.reweigh
            self.weigh()

    def weigh(self) -> None:
        """Think over all ways, by the traffic and what is shut."""
        s, ways = self.state, self.ways
        ways.weight[:] = self._congestion.costs() if self.how.reweigh else self._congestion.free
        for buffer, seconds in self.shut.items():
            ways.weight[buffer] += seconds
        ways.version[0] += 1
        self._know(np.unique(self.net.buffer[s.goal[s.goal >= 0]]))

    def _know(self, goals: "NDArray[np.int64]") -> None:
        self.rows += refresh(self.ways, self.net, self.state.hop, goals)

    def _dispatch(self) -> None:
        s, thinks = self.state, self.now >= self._next_thought
        may = (s.phase == IDLE) if self._room > 0 else np.zeros(len(s.phase), np.bool_)
        if thinks:
            self._next_thought = self.now + self.how.rethink
            may |= (s.phase == FETCHING) & (s.doing != DWELLING)
        vehicles = np.flatnonzero(may)
        jobs = [t for t in self.waiting if (may[t.vehicle] if t.vehicle >= 0 else self._reachable(t))]
        if not len(vehicles) or not jobs:
            return
        column = {id(t): i for i, t in enumerate(jobs)}
        on = np.array([column.get(id(self._of[v]), -1) for v in vehicles.tolist()], dtype=np.intp)
        still_soon = np.zeros(len(vehicles), np.bool_)
        sources = np.array([self.ports.barcodes[t.source] for t in jobs])
        times = partial(self._times, vehicles, sources)
        ages = Jobs.waiting(np.array([self.now - t.created for t in jobs]))
        plan = self._rule(Vehicles(np.zeros(len(vehicles)), on, still_soon), ages, times)
        if self.how.restraint:
            self._hold_back(plan, s.phase[vehicles] == IDLE)
        chosen = [int(vehicles[row]) if row >= 0 else -1 for row in plan.vehicle.tolist()]
        self._carry_out(jobs, chosen)

    def _reachable(self, transfer: Transfer) -> bool:
        ends = {self.ports.barcodes[transfer.source], self.ports.barcodes[transfer.destination]}
        return self.cut_off.isdisjoint(ends)

    def _hold_back(self, plan: DispatchPlan, idle: "NDArray[np.bool_]") -> None:
        """Of the idle vehicles chosen for jobs, leave those that are nearest; no more than may set out."""
        chosen = plan.vehicle
        new = np.flatnonzero((chosen >= 0) & idle[chosen])
        if len(new) <= self._room:
            return
        row, column = np.zeros(len(idle), dtype=np.intp), np.zeros(len(chosen), dtype=np.intp)
        row[plan.rows], column[plan.columns] = np.arange(len(plan.rows)), np.arange(len(plan.columns))
        away = plan.arrival[row[chosen[new]], column[new]]
        chosen[new[np.argsort(away, kind="stable")[self._room :]]] = -1

    def _carry_out(self, jobs: list[Transfer], chosen: list[int]) -> None:
        changed = [(t, v) for t, v in zip(jobs, chosen, strict=True) if t.vehicle != v]
        for transfer, _ in changed:
            if transfer.vehicle >= 0:
                self._of[transfer.vehicle] = None
        left = {t.vehicle for t, _ in changed if t.vehicle >= 0} - {v for _, v in changed}
        for vehicle in sorted(left):
            take_off(self.net, self.state, vehicle)
        for transfer, vehicle in changed:
            transfer.vehicle = vehicle
            if vehicle < 0:
                continue
            self._of[vehicle] = transfer
            source, destination = self.ports.barcodes[transfer.source], self.ports.barcodes[transfer.destination]
            self.state.destination[vehicle] = destination
            self._know(np.array([self.net.buffer[source], self.net.buffer[destination]]))
            send(self.net, self.state, self.rules, vehicle, source, FETCHING)

    def _times(
        self, vehicles: "NDArray[np.intp]", sources: "NDArray[np.int64]", rows: Indices, columns: Indices
    ) -> Real:
        """Return the seconds from where each vehicle can turn to each source, by the weights of the moment."""
        s, net, ways = self.state, self.net, self.ways
        some, goals = vehicles[rows], sources[columns]
        granted = s.granted[some]
        at = np.where(granted > 0, s.ahead[some, np.maximum(granted - 1, 0)], s.at[some])
        goal_buffers, buffers = net.buffer[goals], net.buffer[at]
        self._know(np.unique(goal_buffers))
        far: Real = ways.far[goal_buffers][:, buffers].T - ways.reach[at][:, None] + ways.reach[goals][None, :]
        behind = (buffers[:, None] == goal_buffers[None, :]) & (goals[None, :] < at[:, None])
        if behind.any():
            around = s.hop[goal_buffers, goal_buffers]
            far = far + behind * (ways.weight[goal_buffers] + ways.far[goal_buffers, around])[None, :]
        return far
