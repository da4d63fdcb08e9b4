"""A fab at work in the fast plant: transfers come, are assigned, and are carried; ways follow the traffic."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from math import ceil
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
from app.sim.kinematic.events import remind, run, send_each, take_off
from app.sim.kinematic.load import NOBODY, Ports, Transfers, Work
from app.sim.kinematic.network import Map, Real, Whole
from app.sim.kinematic.state import BROKEN, DRIVING, DWELLING, FETCHING, IDLE, LOADED, STANDING, Rules, still
from app.sim.kinematic.ways import drives, free_flow, refresh, survey

TICK = 1.0
"""Seconds between two looks of dispatch. Our choice."""
CARRIED, PARKED_ROOM = 0.024, 1.3
"""Vehicles per barcode for which no room to park is needed (about half of those that are on their way at any time), and so many
places are kept free for each one more: with fewer, those that find none wander about and hold up the others; with more, ways lead
round too much. Our choice, by runs.
"""
PARKED_AT_ONCE = 20
"""So many are sent to park in a tick at most. Our choice."""
KEPT_FREE = 120.0
"""Seconds that a way costs besides where it leads over track kept free. Our choice."""


@dataclass(frozen=True, slots=True)
class Plant:
    """What a run keeps to. Times in seconds, ways in mm; all values are our choice where no specification gives them.

    ``admission``: the look-ahead of TRAFFIC section 3; without it the track itself is all that is asked for. ``reweigh``: how
    often ways are thought over by the traffic (``planning.congestion``; 0: never, static shortest ways). ``restraint``: no more
    vehicles set out than the track carries (``planning.restraint``), and the others park where ways keep off. ``dispatch``:
    assignment, nearest or random; ``backlog`` transfers wait at any time.
    """

    admission: bool = True
    reweigh: float = 10.0
    restraint: bool = True
    dispatch: str = "assignment"
    backlog: int = 200
    rethink: float = 5.0
    dwell: float = 10.0
    restart: float = 0.1
    reaction: float = 0.2
    hearing: float = 0.05
    more: float = 1000.0


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
        parking: Sequence[Barcode] = (),
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
        )
        self.ports: Work = work or Ports([plan.number[b] for b in ports], Random(f"{seed}/ports"))
        self.transfers = Transfers(how.backlog + len(starts))
        self.delivered: list[Delivered] = []
        self.now = Seconds(0.0)
        self.shut: dict[int, float] = {}
        """What ways over a buffer cost besides, s: somebody stands still there, or it is closed."""
        self.cut_off: frozenset[int] = frozenset()
        """Ports that cannot be reached just now: their transfers wait."""
        self.rows = 0
        """Rows of next hops made so far."""
        self._of: Whole = np.full(len(starts), NOBODY, dtype=np.int64)
        self._room = len(starts)
        self._restraint = Restraint(len(starts)) if how.restraint else None
        self._congestion = Congestion(free_flow(self.net), np.asarray(self.state.lines.capacity))
        self._rule: Rule = self._rule_of(seed)
        self._next_thought = self._next_weighing = 0.0
        self._turn = 0
        self._places: Whole = np.zeros(0, dtype=np.int64)
        self._place([plan.number[b] for b in starts])
        self._keep_free([plan.number[b] for b in parking])

    def run(self, seconds: float) -> None:
        """Let time pass."""
        end = self.now + seconds
        while self.now < end:
            self._order()
            self._look()
            self._weigh()
            self._dispatch()
            self._park()
            remind(self.state)
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

    def _assignment(self, vehicles: Vehicles, jobs: Jobs, times: Times, *, most: int | None = None) -> DispatchPlan:
        self._turn += 1
        return dispatch(vehicles, jobs, times, turn=self._turn, most=most)

    def _place(self, starts: list[int]) -> None:
        s = self.state
        for vehicle, barcode in enumerate(starts):
            s.at[vehicle], s.owner[barcode] = barcode, vehicle
        for vehicle in sorted(range(len(starts)), key=lambda v: -starts[v]):
            enter(s.lines, vehicle, int(self.net.buffer[starts[vehicle]]), ANY)

    def _keep_free(self, parking: Sequence[int]) -> None:
        """Keep track free where idle vehicles are in nobody's way: for as many as the track hardly carries besides."""
        s, buffer = self.state, self.net.buffer
        needed = PARKED_ROOM * (len(s.at) - CARRIED * len(buffer)) if self.how.restraint else 0.0
        used = {int(buffer[port]) for port in self.ports.barcodes}
        able = [b for b in np.unique(buffer[list(parking)]).tolist() if b not in used and not self.net.transit[b]]
        room = sum(int(s.lines.capacity[b]) for b in able)
        if needed <= 0 or not room:
            return
        count = min(len(able), ceil(len(able) * needed / room))
        chosen = [able[i * len(able) // count] for i in range(count)]
        s.park[chosen], self.ways.extra[chosen] = 1, KEPT_FREE
        self._places = np.array(chosen, dtype=np.int64)
        self.weigh()

    def _finish(self, vehicle: int, *, put_down: bool) -> None:
        row, transfers = int(self._of[vehicle]), self.transfers
        if row == NOBODY:
            raise LookupError(f"vehicle {vehicle} has handled a carrier without a transfer")
        source, destination = transfers.ports[row].tolist()
        if put_down:
            self.ports.filled(destination)
            self.delivered.append(Delivered(float(transfers.created[row]), self.now))
            self._of[vehicle] = NOBODY
            transfers.free.append(row)
        else:
            self.ports.emptied(source)
            transfers.open[row] = False
            if destination in self.cut_off:
                take_off(self.net, self.state, vehicle)

    def _order(self) -> None:
        missing = self.how.backlog - self.transfers.waiting
        while missing > 0 and (drawn := self.ports.draw()):
            self.transfers.order(drawn, self.ports.barcodes, self.now)
            missing -= 1

    def _look(self) -> None:
        """Look at who is on the way: where, and how many of them stand."""
        s = self.state
        under_way = s.phase != IDLE
        if self.how.reweigh:
            load = np.bincount(np.asarray(s.lines.slot)[under_way], minlength=len(self.net.first))
            self._congestion.look(load, TICK)
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
        ways.weight[:] += ways.extra
        ways.version[0] += 1
        self._know(self.net.buffer[s.goal[s.goal >= 0]])

    def set_aside(self) -> None:
        """Let those go elsewhere that were on their way to a port which is cut off now, and those come that wait for one no more.

        Who fetches has nothing to do any more, and its transfer waits. Who is loaded waits where idle ones do, out of the way,
        as the controller does where there is no fall-back (``app.fleet.missions``): at the closure it would hold up everybody.
        """
        s, transfers = self.state, self.transfers
        cut = np.zeros(len(self.net.buffer), np.bool_)
        cut[list(self.cut_off)] = True
        able = (self._of >= 0) & (s.doing != DWELLING) & (s.doing != BROKEN) & (s.failed == 0)
        for vehicle in np.flatnonzero(able).tolist():
            row, phase = int(self._of[vehicle]), int(s.phase[vehicle])
            source, destination = transfers.ports[row].tolist()
            if phase == FETCHING and (cut[source] or cut[destination]):
                transfers.vehicle[row] = self._of[vehicle] = NOBODY
                take_off(self.net, s, vehicle)
            elif phase == LOADED and cut[destination]:
                take_off(self.net, s, vehicle)
            elif phase == IDLE and not cut[destination]:
                self._know(self.net.buffer[[destination]])
                send_each(self.net, s, self.rules, np.array([vehicle]), np.array([destination]), LOADED)

    def _know(self, goals: "NDArray[np.int64]") -> None:
        older = goals[self.ways.made[goals] != self.ways.version[0]]
        if len(older):
            self.rows += refresh(self.ways, self.net, self.state.hop, older)

    def _dispatch(self) -> None:
        s, transfers, thinks = self.state, self.transfers, self.now >= self._next_thought
        may = self._free() if self._room > 0 else np.zeros(len(s.phase), np.bool_)
        if thinks:
            self._next_thought = self.now + self.how.rethink
            may |= (s.phase == FETCHING) & (s.doing != DWELLING)
        vehicles, jobs = np.flatnonzero(may), self._jobs(may)
        if not len(vehicles) or not len(jobs):
            return
        column = np.full(len(transfers.open), NOBODY, dtype=np.intp)
        column[jobs] = np.arange(len(jobs))
        on = np.where(self._of[vehicles] >= 0, column[self._of[vehicles]], NOBODY)
        fleet = Vehicles(np.zeros(len(vehicles)), on, np.zeros(len(vehicles), np.bool_))
        waiting = Jobs.waiting(self.now - transfers.created[jobs])
        most = self._room if self.how.restraint else None
        plan = self._rule(fleet, waiting, partial(self._times, vehicles, transfers.source[jobs]), most=most)
        self._carry_out(jobs, np.where(plan.vehicle >= 0, vehicles[plan.vehicle], NOBODY))

    def _free(self) -> "NDArray[np.bool_]":
        """Return who is idle, has no carrier that waits, and stands behind nobody who is."""
        idle = (self.state.phase == IDLE) & (self._of < 0)
        before = np.asarray(self.state.lines.before)
        found: NDArray[np.bool_] = idle & ~np.append(idle, False)[before]
        return found

    def _park(self) -> None:
        """Send who has nothing to do to the nearest track kept free that has room, those nearest to one first."""
        s, net, places = self.state, self.net, self._places
        if not len(places):
            return
        slot, idle = np.asarray(s.lines.slot), s.phase == IDLE
        loose = np.flatnonzero(idle & (s.goal < 0) & (s.park[slot] == 0))
        if not len(loose):
            return
        coming = idle & (s.goal >= 0) & (s.park[slot] == 0)
        heading = np.bincount(net.buffer[s.goal[coming]], minlength=len(s.park))
        room = (np.asarray(s.lines.capacity) - np.asarray(s.lines.load) - heading)[places]
        places, room = places[room > 0], room[room > 0]
        if not len(places):
            return
        some = loose[:PARKED_AT_ONCE]
        away = self._times(some, net.last[places], np.arange(len(some)), np.arange(len(places)))
        goals = np.full(len(some), NOBODY, dtype=np.int64)
        for row in np.argsort(away.min(axis=1), kind="stable").tolist():
            best = int(np.where(room > 0, away[row], np.inf).argmin())
            if room[best] > 0:
                room[best] -= 1
                goals[row] = net.last[places[best]]
        sent = goals >= 0
        send_each(net, s, self.rules, some[sent], goals[sent], IDLE)

    def _jobs(self, may: "NDArray[np.bool_]") -> "NDArray[np.intp]":
        """Return the rows of the transfers to be thought of: without a vehicle and possible, or of one that may change."""
        transfers = self.transfers
        able = np.append(may, True)[transfers.vehicle]
        if self.cut_off:
            cut = np.zeros(len(self.net.buffer), np.bool_)
            cut[list(self.cut_off)] = True
            able &= (transfers.vehicle >= 0) | ~(cut[transfers.source] | cut[transfers.destination])
        return np.flatnonzero(transfers.open & able)

    def _carry_out(self, jobs: "NDArray[np.intp]", chosen: Whole) -> None:
        transfers, before = self.transfers, self.transfers.vehicle[jobs]
        changed = np.flatnonzero(before != chosen)
        if not len(changed):
            return
        jobs, chosen, before = jobs[changed], chosen[changed], before[changed]
        left = before[before >= 0]
        self._of[left] = NOBODY
        for vehicle in sorted(set(left.tolist()).difference(chosen.tolist())):
            take_off(self.net, self.state, vehicle)
        transfers.vehicle[jobs] = chosen
        jobs, chosen = jobs[chosen >= 0], chosen[chosen >= 0]
        self._of[chosen] = jobs
        self.state.destination[chosen] = transfers.destination[jobs]
        self._know(self.net.buffer[np.concatenate((transfers.source[jobs], transfers.destination[jobs]))])
        if len(jobs):
            send_each(self.net, self.state, self.rules, chosen, transfers.source[jobs], FETCHING)

    def _times(self, vehicles: Indices, sources: Whole, rows: Indices, columns: Indices) -> Real:
        """Return the seconds from where each vehicle can turn to each source, by the weights of the moment."""
        s, some, goals = self.state, vehicles[rows], sources[columns]
        granted = s.granted[some]
        at = np.where(granted > 0, s.ahead[some, np.maximum(granted - 1, 0)], s.at[some])
        self._know(self.net.buffer[goals])
        out = np.empty((len(at), len(goals)))
        drives(self.ways, self.net, s.hop, at, goals, out)
        return out
