"""Runs the trials of traffic one after the other and says what came of each, as a line that can be read."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict, dataclass, field, replace
from itertools import pairwise
from random import Random
from typing import Any

import networkx as nx

from app.cli.traffic.trials import MODES, Drilled, Outcome, drill, fab_of, run, together, track_of
from app.domain.units import Barcode
from app.planning.routing import Router
from app.plant.fab import SIZES, Shape
from app.sim.kinematic.fab import Plant
from app.sim.rules import Rule, check

FAB = SIZES["10k"]
BACKLOGGED = 400
"""Vehicles at which the rules of dispatch are compared (TRAFFIC section 6)."""
FAST = 500
"""Vehicles at which the fast plant's speed counts."""
RECOVERED = 0.9
"""So much of what the undisturbed twin delivers counts as recovered: chance moves five minutes by 4 %."""
OVER = 1.4
"""A fleet so many times that which delivers most must still carry nearly as much."""


@dataclass(frozen=True, slots=True)
class Extent:
    """How much is tried. ``fleets`` of the sweep; ``soak`` and ``drill`` in hours; ``growth`` fleets for CPU per
    vehicle; ``peak`` what counts as the fleet that delivers most: with nobody beyond what the track carries on the way, hardly
    more or fewer are delivered from 600 vehicles on, and 1,000 was the prototype's peak (TRAFFIC section 4).
    """

    pairs: int = 1000
    networks: int = 300
    fleets: tuple[int, ...] = (400, 600, 1000, 1400)
    seeds: tuple[int, ...] = (1, 2, 3)
    minutes: int = 40
    soak: float = 2.0
    drilled: int = 800
    drill: float = 2.0
    drills: tuple[int, ...] = (1,)
    per_hour: float = 20.0
    growth: tuple[int, ...] = (250, 500, 1000, 2000, 3000)
    peak: int = 1000


FULL = replace(Extent(), networks=1000, soak=8.0, drill=8.0, drills=(1, 2, 3))


@dataclass(slots=True)
class Report:
    """What is found, part by part; ``failed`` are the goals that were missed.

    ``found`` may hold parts of runs before: they stay as they are. ``goals`` in it has those of each part: what was tried, what
    was found, the goal, whether it was met.
    """

    extent: Extent
    found: dict[str, Any] = field(default_factory=dict)
    failed: list[str] = field(default_factory=list)
    peak: float | None = None
    """The most that a fleet delivers in an hour, if this run has tried fleets."""

    def begin(self, name: str) -> None:
        """Forget what a run before has found out about a part."""
        self.found.setdefault("goals", {})[name] = []

    def goal(self, name: str, reached: bool, goal: str, what: str, found: str) -> str:
        """Keep how a goal of issue and design was met by a part, and return it as the end of a line."""
        if not reached:
            self.failed.append(goal)
        row = {"what": what, "found": found, "goal": goal, "met": bool(reached)}
        self.found.setdefault("goals", {}).setdefault(name, []).append(row)
        return f"[{goal}: {'reached' if reached else 'MISSED'}]"


PARTS: dict[str, Callable[[Report], Iterator[str]]] = {}


def part(name: str) -> Callable[[Callable[[Report], Iterator[str]]], Callable[[Report], Iterator[str]]]:
    """Name a part of the trials."""

    def named(function: Callable[[Report], Iterator[str]]) -> Callable[[Report], Iterator[str]]:
        PARTS[name] = function
        return function

    return named


@part("routes")
def routes(report: Report) -> Iterator[str]:
    """Routes of random pairs cost what networkx's cost."""
    track = track_of(FAB, 1)
    router, dice, wrong = Router(track), Random("1/routes"), 0
    barcodes: Sequence[Barcode] = track.barcodes
    for _ in range(report.extent.pairs):
        start, end = dice.sample(barcodes, 2)
        ours = sum(track.graph.edges[pair]["time"] for pair in pairwise(router.route(start, end)))
        theirs = nx.shortest_path_length(track.graph, start, end, weight="time")
        wrong += abs(ours - theirs) > 1e-6
    pairs = report.extent.pairs
    report.found["routes"] = {"pairs": pairs, "wrong": wrong}
    what, found = f"routes of {pairs:,} random pairs against networkx's", f"{wrong} dearer"
    yield f"{pairs} routes, {wrong} dearer than networkx's {report.goal('routes', wrong == 0, 'equal costs', what, found)}"


@part("rules")
def rules(report: Report) -> Iterator[str]:
    """The rule of admission on random networks of queues."""
    networks, locked = report.extent.networks, {}
    for rule in Rule:
        locked[rule.value] = sum(check(seed, rule, 2000).locked for seed in range(networks))
    report.found["rules"] = {"networks": networks, "locked": locked}
    words = ", ".join(f"{rule} {count}" for rule, count in locked.items())
    what, whole = f"{networks:,} random networks of queues that lock up", locked["look-ahead"] == 0
    yield f"of {networks} networks locked up: {words} {report.goal('rules', whole, 'none with the rule', what, words)}"


@part("sweep")
def sweep(report: Report) -> Iterator[str]:
    """Deliveries by fleet and by what is switched on."""
    extent = report.extent
    rows: list[dict[str, Any]] = []
    mean: dict[tuple[str, int], float] = {}
    for mode, how in MODES.items():
        for vehicles in extent.fleets:
            found = [run(fab_of(FAB, vehicles, how, seed), extent.minutes) for seed in extent.seeds]
            per_hour = mean[mode, vehicles] = sum(one.per_hour for one in found) / len(found)
            locked, stalled = sum(one.locked > 0 for one in found), sum(one.stalled for one in found)
            rows.append(
                {"mode": mode, "vehicles": vehicles, "per_hour": per_hour, "runs": [_kept(one) for one in found]}
            )
            each = ", ".join(f"{one.per_hour:,.0f}" for one in found)
            yield f"{mode:13} {vehicles:5} vehicles: {per_hour:7,.0f}/h ({each}), {locked} locked up, {stalled} at a standstill"
    report.found["sweep"] = rows
    report.found["peak"] = max(extent.fleets, key=lambda vehicles: mean["all", vehicles])
    report.peak = report.found["peak_per_hour"] = mean["all", report.found["peak"]]
    ruled = [run for row in rows if row["mode"] != "no rule" for run in row["runs"]]
    locked = sum(run["locked"] > 0 for run in ruled)
    end = report.goal("sweep", locked == 0, "no lock-up", "runs with a rule that lock up", f"{locked} of {len(ruled)}")
    yield f"{locked} of {len(ruled)} runs with a rule locked up {end}"
    for vehicles, goal in ((600, 1.25), (1000, 5.0)):
        for mode in ("+ congestion", "all") if vehicles in extent.fleets else ():
            gain = mean[mode, vehicles] / max(1.0, mean["admission", vehicles])
            what = f"{mode} against admission alone (static ways) at {vehicles:,} vehicles"
            yield f"{what}: {gain:.2f} times {report.goal('sweep', gain >= goal, f'{goal} times', what, f'{gain:.2f} times')}"


@part("soak")
def soak(report: Report) -> Iterator[str]:
    """Hours with a fleet larger than the one that delivers most."""
    peak, usual = report.extent.peak, report.peak
    if usual is None:
        usual = run(fab_of(FAB, peak, Plant(), 1), report.extent.minutes).per_hour
    vehicles, minutes = round(OVER * peak), round(report.extent.soak * 60)
    found = run(fab_of(FAB, vehicles, Plant(), 1), minutes)
    hours = [sum(found.per_minute[i : i + 60]) for i in range(0, minutes - 59, 60)]
    share, worst = hours[-1] / usual, min(hours[1:] or hours) / usual
    report.found["soak"] = asdict(found) | {"hours": hours, "peak": usual}
    long = f"{report.extent.soak:g} h"
    what = f"{vehicles:,} vehicles, {OVER} times {peak:,}, after {long}, of the most that a fleet delivers ({usual:,.0f}/h)"
    words = f"{share:.0%} in the last hour, {worst:.0%} in the worst after the first"
    yield (
        f"{vehicles} vehicles for {long}: {', '.join(f'{h:,}' for h in hours)} an hour, {found.locked} locked; "
        f"of the peak of {usual:,.0f}/h: {words} {report.goal('soak', share >= 0.9, '90 % of peak', what, words)}"
    )


@part("dispatch")
def dispatch(report: Report) -> Iterator[str]:
    """Rules of dispatch under a backlog."""
    rows: dict[str, Outcome] = {}
    for rule in ("random", "nearest", "assignment"):
        rows[rule] = run(fab_of(FAB, BACKLOGGED, Plant(dispatch=rule), 1), report.extent.minutes)
        yield f"{rule:10} {BACKLOGGED} vehicles: {rows[rule].per_hour:,.0f}/h, oldest {rows[rule].oldest:,.0f} s"
    gain = rows["assignment"].per_hour / rows["nearest"].per_hour
    older = rows["assignment"].oldest / max(1.0, rows["nearest"].oldest)
    report.found["dispatch"] = {rule: asdict(one) for rule, one in rows.items()}
    for words, ratio, reached, goal in (
        ("assignment against first-come nearest", gain, gain >= 1.5, "1.5 times"),
        ("its oldest transfer waits", older, older <= 1.0, "no longer"),
    ):
        what = f"{words}, {BACKLOGGED} vehicles and a backlog"
        yield f"{words}: {ratio:.2f} times {report.goal('dispatch', reached, goal, what, f'{ratio:.2f} times')}"


@part("speed")
def speed(report: Report) -> Iterator[str]:
    """How much faster than real time the fast plant runs."""
    fab = fab_of(FAB, FAST, Plant(), 1)
    fab.run(60.0)
    found = run(fab, 20)
    report.found["speed"] = asdict(found)
    words, what = f"{found.times_real:,.0f} times", f"simulated seconds per CPU second, {FAST} vehicles"
    yield (
        f"{FAST} vehicles: {words} real time, {found.events / found.cpu:,.0f} barcodes read per CPU second "
        f"{report.goal('speed', found.times_real >= 400, '400 times', what, words)}"
    )


@part("growth")
def growth(report: Report) -> Iterator[str]:
    """CPU by fleet, each in a fab that grows with it."""
    rows = []
    for vehicles in report.extent.growth:
        fab = fab_of(grown(vehicles), vehicles, Plant(), 1)
        fab.run(60.0)
        found = run(fab, 10)
        each = 1e6 * found.cpu / (found.seconds * vehicles)
        rows.append({"vehicles": vehicles, "us_per_vehicle_second": each, "times_real": found.times_real})
        yield f"{vehicles:5} vehicles: {each:6.1f} us CPU per vehicle and second, {found.times_real:,.0f} times real time"
    report.found["growth"] = rows


@part("drill")
def drills(report: Report) -> Iterator[str]:
    """Breakdowns and closures for hours, with several seeds, and what was delivered after storms in all of them together."""
    extent = report.extent
    found = [drill(FAB, extent.drilled, extent.drill, extent.per_hour, seed) for seed in extent.drills]
    report.found["drill"] = [asdict(one) for one in found]
    for seed, one in zip(extent.drills, found, strict=True):
        yield from _drilled(report, one, seed)
    yield _recovery(report, together(found), [share for one in found for share in one.judged])


def _drilled(report: Report, found: Drilled, seed: int) -> Iterator[str]:
    """Say what came of one drill, storm by storm."""
    extent, outcome = report.extent, found.outcome
    what = f"{found.events} breakdowns and closures in {extent.drill:g} h at {extent.drilled} vehicles, seed {seed}"
    end = report.goal("drill", outcome.locked == 0, "nothing locks up", what, f"{outcome.locked} locked up at the end")
    rates = f"{outcome.per_hour:,.0f}/h of {found.usual:,.0f} of the undisturbed twin"
    yield f"{what}: {rates}, {outcome.locked} locked up at the end {end}"
    yield f"{found.named} of them cut ports off, and each named them"
    for storm in found.storms:
        yield (
            f"storm of {storm.events} events over {storm.ended - storm.began:,.0f} s: before it {_percent(storm.before)} of the "
            f"undisturbed twin's deliveries, meanwhile {_percent(storm.during)}, in the five minutes after its last end "
            f"{_percent(storm.after)}, in the next five {_percent(storm.then)}"
        )


def _recovery(report: Report, storms: list[float], each: list[float]) -> str:
    """Return what was delivered after storms, of all seeds together and in each, and whether that is enough."""
    if not storms:
        return "no storm was over ten minutes before the end: whether deliveries recover in five is not known"
    well, mean, drilled = (
        sum(share >= RECOVERED for share in storms),
        sum(storms) / len(storms),
        len(report.extent.drills),
    )
    what = f"from five to ten minutes after {len(storms)} storms, of the undisturbed twins' deliveries, {drilled} drills together"
    words = f"{mean:.0%} in the mean, {min(storms):.0%} at least, {RECOVERED:.0%} or more after {well}"
    alone = sum(share >= RECOVERED for share in each)
    apart = f"; each drill by itself: {RECOVERED:.0%} or more after {alone} of {len(each)}, {min(each):.0%} at least"
    return (
        f"{what}: {words}{apart} {report.goal('drill', well == len(storms), 'recovers within 5 minutes', what, words)}"
    )


def _kept(one: Outcome) -> dict[str, Any]:
    return asdict(one) | {"stalled": one.stalled}


def _percent(share: float | None) -> str:
    return "-" if share is None else f"{share:.0%}"


def grown(vehicles: int) -> Shape:
    """Return a fab that grows with its fleet: 25 hoists a bay, as 1,000 have in the fab of TRAFFIC section 1."""
    usual = Shape()
    bays = max(4, 2 * round(vehicles / 50))
    share = bays / usual.bays
    return Shape(
        f"fab-{vehicles}",
        bays=bays,
        shortcuts=round(usual.shortcuts * share),
        pairs=round(usual.pairs * share),
        turnarounds=min(round(usual.turnarounds * share), bays // 4),
    )
