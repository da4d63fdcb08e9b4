"""Figures of a period: delivery times by phase, throughput, queue, what vehicles did, what jobs waited for. Pure."""

import re
from collections import defaultdict
from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from app.domain.alarms import Reliability, reliability
from app.domain.job import JobState
from app.domain.statistics import Kept, OpenJob, Phase, Queued, Transfer, Waited
from app.planning.tables import Floats

MOST_INTERVALS = 2000
"""So many intervals at most (our choice)."""
CAUSES = 30
"""So many causes of waits, and places of waits, are named (our choice)."""
LATEST = 5
"""So many of the latest transfers are named (our choice)."""


@dataclass(frozen=True, slots=True)
class Times:
    """How long something took, seconds; all None if it never happened."""

    count: int
    mean: float | None
    p50: float | None
    p95: float | None
    longest: float | None


@dataclass(frozen=True, slots=True)
class Interval:
    """Part of a period: jobs accepted and ended in it, the mean number that waited for a vehicle, delivery times."""

    begin: float
    ordered: int
    completed: int
    unfinished: int
    """Those that failed, or were cancelled or aborted."""
    queue: float
    times: Times


@dataclass(frozen=True, slots=True)
class VehicleFigures:
    """What a vehicle did with the transfers that ended in the period, seconds within it, and how it held out."""

    vehicle: str
    completed: int
    fetching: float
    acquiring: float
    carrying: float
    depositing: float
    busy: float
    """Share of the period."""
    held_out: Reliability


@dataclass(frozen=True, slots=True)
class Cause:
    """Why jobs waited, without names, so often and so long."""

    cause: str
    times: int
    seconds: float


@dataclass(frozen=True, slots=True)
class Place:
    """The station, or else the vehicle, for which jobs waited: how many, how long, and for what there the longest."""

    place: str
    jobs: int
    seconds: float
    cause: str


@dataclass(frozen=True, slots=True)
class Late:
    """A transfer that took long, and its longest wait in words, empty: it waited for nothing that was kept."""

    transfer: Transfer
    reason: str
    waited: float


@dataclass(frozen=True, slots=True)
class Statistics:
    """All figures of a period. ``empty`` is the share of driving that is done empty, to the source; None if nobody drove."""

    begin: float
    end: float
    states: dict[str, int]
    phases: dict[Phase, Times]
    intervals: tuple[Interval, ...]
    vehicles: tuple[VehicleFigures, ...]
    waits: tuple[Cause, ...]
    waits_of: int
    empty: float | None
    places: tuple[Place, ...]
    late: tuple[Late, ...]
    open: tuple[OpenJob, ...]


def statistics(
    kept: Kept, begin: float, end: float, interval: float, vehicles: Sequence[str], stations: Collection[str] = ()
) -> Statistics:
    """Return the figures of a period in steps of so many seconds, with a row for each of these vehicles.

    Waits are told by place for the vehicles and stations that are named here.
    """
    states = {state.value: 0 for state in JobState if state.terminal}
    for transfer in kept.transfers:
        states[transfer.state] += 1
    done = [transfer for transfer in kept.transfers if transfer.state == JobState.COMPLETED]
    phases = {phase: times(transfer.seconds(phase) for transfer in done) for phase in Phase}
    rows = tuple(_vehicles(kept, begin, end, vehicles))
    empty, loaded = sum(row.fetching for row in rows), sum(row.carrying for row in rows)
    return Statistics(
        begin,
        end,
        states,
        phases,
        tuple(_intervals(kept, begin, end, interval)),
        rows,
        tuple(_causes(kept.waits, begin, end)),
        kept.waits_of,
        empty / (empty + loaded) if empty + loaded else None,
        tuple(_places(kept.waits, begin, end, frozenset(stations), frozenset(vehicles))),
        tuple(_late(kept)),
        tuple(sorted(kept.open, key=lambda one: one.created)),
    )


def times(seconds: Iterable[float | None]) -> Times:
    """Return mean, median, 95th percentile and the longest of what is known."""
    known: Floats = np.array([one for one in seconds if one is not None], dtype=np.float64)
    if not len(known):
        return Times(0, None, None, None, None)
    half, most = np.percentile(known, (50, 95))
    return Times(len(known), float(known.mean()), float(half), float(most), float(known.max()))


def _intervals(kept: Kept, begin: float, end: float, interval: float) -> Iterable[Interval]:
    edges = np.append(np.arange(begin, end, interval), end)
    ended = np.array([transfer.ended for transfer in kept.transfers])
    place = np.clip(np.searchsorted(edges, ended, side="right") - 1, 0, len(edges) - 2)
    within: defaultdict[int, list[Transfer]] = defaultdict(list)
    for at, transfer in zip(place.tolist(), kept.transfers, strict=True):
        within[at].append(transfer)
    ordered = np.histogram([one.created for one in kept.queued], edges)[0].tolist()
    queue = mean_level(kept.queued, edges).tolist()
    for at in range(len(edges) - 1):
        done = [transfer for transfer in within[at] if transfer.state == JobState.COMPLETED]
        delivery = times(transfer.seconds(Phase.TOTAL) for transfer in done)
        yield Interval(
            float(edges[at]), ordered[at], len(done), len(within[at]) - len(done), round(queue[at], 3), delivery
        )


def mean_level(queued: Sequence[Queued], edges: Floats) -> Floats:
    """Return how many waited on the average between each two edges."""
    waited = [_Sum([one.created for one in queued]), _Sum([one.until for one in queued if one.until is not None])]
    whole: Floats = waited[0].until(edges) - waited[1].until(edges)
    mean: Floats = np.diff(whole) / np.diff(edges)
    return mean


class _Sum:
    """Seconds that have gone by since each of some moments, added up."""

    def __init__(self, moments: list[float]) -> None:
        self._moments = np.sort(np.array(moments, dtype=np.float64))
        self._before = np.concatenate([[0.0], np.cumsum(self._moments)])

    def until(self, edges: Floats) -> Floats:
        count = np.searchsorted(self._moments, edges)
        summed: Floats = count * edges - self._before[count]
        return summed


def _vehicles(kept: Kept, begin: float, end: float, names: Sequence[str]) -> Iterable[VehicleFigures]:
    of: defaultdict[str, list[Transfer]] = defaultdict(list)
    for transfer in kept.transfers:
        if transfer.vehicle:
            of[transfer.vehicle].append(transfer)
    for name in names:
        spent = {phase: sum(_within(t, phase, begin) for t in of[name]) for phase in Phase}
        working = (Phase.FETCHING, Phase.ACQUIRING, Phase.CARRYING, Phase.DEPOSITING)
        busy = sum(spent[phase] for phase in working)
        yield VehicleFigures(
            name,
            sum(transfer.state == JobState.COMPLETED for transfer in of[name]),
            fetching=round(spent[Phase.FETCHING], 3),
            acquiring=round(spent[Phase.ACQUIRING], 3),
            carrying=round(spent[Phase.CARRYING], 3),
            depositing=round(spent[Phase.DEPOSITING], 3),
            busy=round(min(1.0, busy / (end - begin)), 5),
            held_out=reliability(kept.failures.get(name, ()), begin, end),
        )


def _within(transfer: Transfer, phase: Phase, begin: float) -> float:
    """Return the seconds of a phase that lie in the period: what began before counts from its begin on."""
    seconds = transfer.seconds(phase)
    if seconds is None:
        return 0.0
    ends = {
        Phase.QUEUED: transfer.assigned,
        Phase.FETCHING: transfer.acquire_started,
        Phase.ACQUIRING: transfer.acquired,
        Phase.CARRYING: transfer.deposit_started,
        Phase.DEPOSITING: transfer.deposited,
        Phase.TOTAL: transfer.ended,
    }
    return max(0.0, min(seconds, (ends[phase] or begin) - begin))


_NAME = re.compile(r"[^\s,;()]*\d[^\s,;()]*(?<!:)")
"""A word with a digit, without a colon after it: that belongs to the sentence."""


def cause_of(reason: str) -> str:
    """Return a reason without names and figures: each word with a digit becomes ``…``, and the rest is what it is about.

    An ellipsis, not a dash: a spreadsheet takes a text that begins with a dash for a formula.
    """
    return _NAME.sub("…", reason)


def place_of(reason: str, stations: Collection[str], vehicles: Collection[str]) -> str | None:
    """Return the first station that a reason names, or else the first vehicle; None: it names neither."""
    words = [name for word in _WORD.findall(reason) for name in (word, word.rstrip(":.'"))]
    return next((name for known in (stations, vehicles) for name in words if name in known), None)


_WORD = re.compile(r"[^\s,;()]+")


def latest(transfers: Iterable[Transfer]) -> list[Transfer]:
    """Return those of the transfers that were completed and took the longest from their acceptance on, the longest first."""
    done = (transfer for transfer in transfers if transfer.state == JobState.COMPLETED)
    return sorted(done, key=lambda one: (one.created - one.ended, one.job))[:LATEST]


def _late(kept: Kept) -> Iterable[Late]:
    for transfer in latest(kept.transfers):
        found: defaultdict[str, float] = defaultdict(float)
        for wait in kept.waits_late:
            if wait.job == transfer.job:
                found[wait.reason] += max(0.0, (wait.until or transfer.ended) - wait.since)
        reason = max(found, key=lambda one: (found[one], one), default="")
        yield Late(transfer, reason, round(found.get(reason, 0.0), 3))


def _within_period(waits: Sequence[Waited], begin: float, end: float) -> Iterator[tuple[Waited, float]]:
    """Give each wait with its seconds within a period, where there are any."""
    for wait in waits:
        first, last = max(wait.since, begin), min(end if wait.until is None else wait.until, end)
        if last > first:
            yield wait, last - first


def _causes(waits: Sequence[Waited], begin: float, end: float) -> Iterable[Cause]:
    found: defaultdict[str, list[float]] = defaultdict(list)
    for wait, seconds in _within_period(waits, begin, end):
        found[cause_of(wait.reason)].append(seconds)
    longest = sorted(found.items(), key=lambda item: (-sum(item[1]), item[0]))[:CAUSES]
    return (Cause(cause, len(each), round(sum(each), 3)) for cause, each in longest)


def _places(
    waits: Sequence[Waited], begin: float, end: float, stations: frozenset[str], vehicles: frozenset[str]
) -> Iterable[Place]:
    spent: defaultdict[str, defaultdict[str, float]] = defaultdict(lambda: defaultdict(float))
    jobs: defaultdict[str, set[str]] = defaultdict(set)
    for wait, seconds in _within_period(waits, begin, end):
        if place := place_of(wait.reason, stations, vehicles):
            spent[place][cause_of(wait.reason)] += seconds
            jobs[place].add(wait.job)
    longest = sorted(spent.items(), key=lambda item: (-sum(item[1].values()), item[0]))[:CAUSES]
    for place, causes in longest:
        cause = max(causes, key=lambda one: (causes[one], one))
        yield Place(place, len(jobs[place]), round(sum(causes.values()), 3), cause)
