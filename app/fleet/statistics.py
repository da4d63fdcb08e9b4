"""Figures of a period: delivery times by phase, throughput, queue, what vehicles did, what jobs waited for. Pure."""

import re
from collections import defaultdict
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np

from app.domain.alarms import Reliability, reliability
from app.domain.job import JobState
from app.domain.statistics import Kept, Phase, Queued, Transfer, Waited
from app.planning.tables import Floats

MOST_INTERVALS = 2000
"""So many intervals at most (our choice)."""
CAUSES = 30
"""So many causes of waits are named (our choice)."""


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


def statistics(kept: Kept, begin: float, end: float, interval: float, vehicles: Sequence[str]) -> Statistics:
    """Return the figures of a period in steps of so many seconds, with a row for each of these vehicles."""
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


def _causes(waits: Sequence[Waited], begin: float, end: float) -> Iterable[Cause]:
    found: defaultdict[str, list[float]] = defaultdict(list)
    for wait in waits:
        first, last = max(wait.since, begin), min(end if wait.until is None else wait.until, end)
        if last > first:
            found[cause_of(wait.reason)].append(last - first)
    longest = sorted(found.items(), key=lambda item: (-sum(item[1]), item[0]))[:CAUSES]
    return (Cause(cause, len(seconds), round(sum(seconds), 3)) for cause, seconds in longest)
