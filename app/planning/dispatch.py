"""Which vehicle does which job: one assignment over all at once, in arrays (DOMAIN section 6, TRAFFIC section 6).

Nothing here knows a vehicle or a job: rows are vehicles, columns are jobs, whoever calls keeps the names. So a compiled
simulator and the fleet call the same function. All times are seconds.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

Floats: TypeAlias = NDArray[np.float64]
Indices: TypeAlias = NDArray[np.intp]
Flags: TypeAlias = NDArray[np.bool_]
Times: TypeAlias = Callable[[Indices, Indices], Floats]
"""``times(rows, columns)`` gives, as a table of that shape, the time of each of these vehicles from where it can turn to the
source of each of these jobs; infinite where it cannot do the job."""
NOBODY = -1


@dataclass(frozen=True, slots=True)
class Rules:
    """What a pair costs besides the drive. All values are our choice; the figures are in the benchmark ``dispatch``.

    ``switch``: what must be saved before a job that is being fetched gets another vehicle. ``preempt``: what a hot lot
    must save to take a vehicle off another job. ``unsure``: what a vehicle that is not free yet must save, since nobody
    knows when it will be. ``early``: so long a vehicle may stand at a source before the carrier is there. ``waiting``
    and ``patience``: see ``worth_of_waiting``.
    """

    switch: float = 30.0
    preempt: float = 5.0
    unsure: float = 5.0
    early: float = 10.0
    waiting: float = 0.2
    patience: float = 1000.0


RULES = Rules()
MOST_JOBS = 500
"""So many jobs are looked at in one assignment, the most urgent and oldest first (TRAFFIC section 6)."""
MOST_PAIRS = 25_000
"""So many pairs of vehicle and job are weighed at once; more come with the next tick (our choice: about 3 ms)."""
STEEPEST = 3600.0
"""Our choice: the age in seconds after which waiting counts no more than it does then."""
SHORTER_SIDE = 300
"""Our choice: where vehicles and jobs are about as many, an assignment of more than so many takes too long (n³)."""


@dataclass(frozen=True, slots=True)
class Vehicles:
    """One entry for each vehicle that carries nothing, or soon will not.

    ``offset``: seconds until it can turn to another goal (the end of its grant), or until it is free. ``job``: the column of
    the job that it is on its way to fetch, else -1. ``soon``: it is not free yet: it may be waited for, not sent. ``exempt``: it
    does not count where only so many may get something; None: all count.
    """

    offset: Floats
    job: Indices
    soon: Flags
    exempt: Flags | None = None

    @classmethod
    def idle(cls, count: int) -> "Vehicles":
        """Return so many vehicles that stand and have nothing to do."""
        return cls(np.zeros(count), np.full(count, NOBODY, np.intp), np.zeros(count, np.bool_))


@dataclass(frozen=True, slots=True)
class Jobs:
    """One entry for each job that is not picked up.

    ``age``: seconds since it was ordered. ``ready``: seconds until its carrier is at the source (0: it is there). ``priority``:
    more is more urgent. ``hot``: a hot lot, served before all that are not.
    """

    priority: Indices
    age: Floats
    ready: Floats
    hot: Flags

    @classmethod
    def waiting(cls, age: Floats) -> "Jobs":
        """Return jobs of one class whose carriers are there."""
        count = len(age)
        return cls(np.zeros(count, np.intp), age, np.zeros(count), np.zeros(count, np.bool_))


@dataclass(frozen=True, slots=True)
class Plan:
    """Who does what. ``vehicle`` has the row for each job, -1: nobody.

    ``rows`` and ``columns`` are what was weighed, by rising row and by urgency; ``arrival`` the table of times over them until
    the vehicle is at the source, infinite: it cannot do the job. Jobs that were not weighed keep the vehicle that they had.
    """

    vehicle: Indices
    rows: Indices
    columns: Indices
    arrival: Floats


class Rule(Protocol):
    """A way to choose: at most ``most`` vehicles that have nothing to do get something; None: all may."""

    def __call__(self, vehicles: Vehicles, jobs: Jobs, times: Times, *, most: int | None = None) -> Plan:
        """Return who does what."""


def dispatch(
    vehicles: Vehicles, jobs: Jobs, times: Times, rules: Rules = RULES, turn: int = 0, most: int | None = None
) -> Plan:
    """Return the assignment of least total cost, hot lots first.

    Hot lots get the vehicles that are nearest to them, off other jobs if need be; then all others are assigned at once.
    Among jobs that are not hot, as many get a vehicle as can; if not all can, those of the highest priorities do, and among
    equals it counts how long the drive is and how long they have waited. An assignment once made is changed where that saves
    more than ``rules.switch``. ``turn``: rises from call to call, so that where not all assignments can be thought over at
    once, each has its turn. ``most``: only so many of the vehicles that have nothing to do get something, those for which it
    costs least (None: all of them; ``planning.restraint``).
    """
    plan = weighed(vehicles, jobs, times, turn)
    assigned(plan, vehicles, jobs, rules, most)
    return plan


def weighed(vehicles: Vehicles, jobs: Jobs, times: Times, turn: int = 0) -> Plan:
    """Return the plan in which all keep what they have, but those that ``assigned`` may change have nothing yet."""
    rows, columns = considered(vehicles, jobs, turn)
    return unassigned(vehicles, jobs, (rows, columns), times(rows, columns) if len(rows) and len(columns) else None)


def unassigned(vehicles: Vehicles, jobs: Jobs, block: tuple[Indices, Indices], driven: Floats | None) -> Plan:
    """Return the same for rows and columns ``considered`` and their table of times; None: there are no pairs."""
    rows, columns = block
    vehicle = _holders(vehicles, len(jobs.age))
    vehicle[columns] = NOBODY
    return Plan(vehicle, rows, columns, np.empty((0, 0)) if driven is None else driven + vehicles.offset[rows][:, None])


def assigned(plan: Plan, vehicles: Vehicles, jobs: Jobs, rules: Rules = RULES, most: int | None = None) -> None:
    """Carry out ``dispatch`` on a plan just weighed."""
    rows, columns = plan.rows, plan.columns
    holder = _holders(vehicles, len(jobs.age))
    free = np.ones(len(rows), np.bool_)
    idle = (vehicles.job[rows] == NOBODY) & ~vehicles.soon[rows]
    if vehicles.exempt is not None:
        idle &= ~vehicles.exempt[rows]
    room = len(rows) if most is None else most
    for hot in (True, False):
        some, left = np.flatnonzero(jobs.hot[columns] == hot), np.flatnonzero(free)
        if not len(some) or not len(left):
            continue
        costs = _costs(vehicles, jobs, plan, holder, (left, some), rules)
        if np.count_nonzero(idle[left]) > room:
            may = _set_out(costs, idle[left], jobs.priority[columns[some]], room)
            costs, left = costs[may], left[may]
        for row, column in best_pairs(costs, jobs.priority[columns[some]]):
            plan.vehicle[columns[some[column]]] = rows[left[row]]
            free[left[row]] = False
            room -= int(idle[left[row]])


def _set_out(costs: Floats, idle: Flags, priority: Indices, room: int) -> Flags:
    """Return which rows may be given something: all but the idle ones, and of these so many whose best pairs cost least.

    Pair after pair of the highest priority that is left and of least cost, each row and column once.
    """
    may, own = ~idle, np.flatnonzero(idle)
    left = costs[own]
    for level in np.unique(priority)[::-1] if room > 0 else ():
        block = np.where(priority == level, left, np.inf)
        while room > 0:
            row, column = divmod(int(block.argmin()), block.shape[1])
            if not np.isfinite(block[row, column]):
                break
            may[own[row]] = True
            left[row], block[row], block[:, column] = np.inf, np.inf, np.inf
            room -= 1
    return may


def considered(vehicles: Vehicles, jobs: Jobs, turn: int = 0) -> tuple[Indices, Indices]:
    """Return the vehicles and jobs that can be weighed within a few milliseconds: (rows, columns by urgency).

    All jobs without a vehicle come before those that have one, the most urgent and oldest first; a vehicle with a job is
    weighed with its job, or not at all.
    """
    engaged = np.flatnonzero(vehicles.job != NOBODY)
    idle = np.flatnonzero(vehicles.job == NOBODY)
    waiting = np.ones(len(jobs.age), np.bool_)
    waiting[vehicles.job[engaged]] = False
    queued = np.flatnonzero(waiting)
    queued = queued[_by_urgency(jobs, queued)][: _most(len(idle), len(queued))]
    room = SHORTER_SIDE - min(len(idle), len(queued))
    count = min(len(engaged), max(room, 0))
    while count and (len(idle) + count) * (len(queued) + count) > MOST_PAIRS:
        count = count * 3 // 4
    if count < len(engaged):
        engaged = np.sort(np.roll(engaged, -turn * max(count, 1))[:count])
    columns = np.concatenate((queued, vehicles.job[engaged]))
    return np.sort(np.concatenate((idle, engaged))), columns[_by_urgency(jobs, columns)]


def _most(vehicles: int, jobs: int) -> int:
    """Return how many jobs may be weighed for so many vehicles."""
    near_square = vehicles > SHORTER_SIDE and jobs > SHORTER_SIDE
    return max(1, min(MOST_JOBS, SHORTER_SIDE if near_square else MOST_JOBS, MOST_PAIRS // max(vehicles, 1)))


def _by_urgency(jobs: Jobs, columns: Indices) -> Indices:
    keys = (-jobs.age[columns], -jobs.priority[columns], ~jobs.hot[columns])
    return np.lexsort((columns, *keys))


def _holders(vehicles: Vehicles, jobs: int) -> Indices:
    """Return the row of the vehicle that is on its way to fetch each job."""
    holder = np.full(jobs, NOBODY, np.intp)
    engaged = np.flatnonzero(vehicles.job != NOBODY)
    holder[vehicles.job[engaged]] = engaged
    return holder


def worth_of_waiting(age: Floats, rules: Rules = RULES) -> Floats:
    """Return what waiting is worth in seconds of driving: ``waiting * age + age² / (2 patience)``, after an hour no steeper.

    Little at first, so that the shortest drives are chosen, then ever more: no stream of near jobs keeps a far one waiting
    for ever. With these values the oldest wait under a backlog is below that of first come, first served, at 1.5 times its
    deliveries (benchmark ``dispatch``). It decides within a class of priority only.
    """
    waited = np.maximum(age, 0.0)
    steep = np.minimum(waited, STEEPEST)
    return (
        waited * rules.waiting + steep * steep / (2 * rules.patience) + (waited - steep) * (STEEPEST / rules.patience)
    )


def _costs(
    vehicles: Vehicles,
    jobs: Jobs,
    plan: Plan,
    holder: Indices,
    block: tuple[Indices, Indices],
    rules: Rules,
) -> Floats:
    """Return what each pair of a block of the plan's table costs within its class of priority; infinite: impossible.

    Nobody is taken off a job for one that is not free yet.
    """
    row, column = plan.rows[block[0]], plan.columns[block[1]]
    ready, arrival = jobs.ready[column], _part(plan.arrival, *block)
    bound, job_bound = _among(vehicles.job[row], column, len(jobs.age)), _among(holder[column], row, len(vehicles.job))
    preempted = (vehicles.job[row] != NOBODY) & ~bound
    by_row = rules.unsure * vehicles.soon[row] + rules.preempt * preempted + rules.switch * bound
    by_column = rules.switch * job_bound - worth_of_waiting(jobs.age[column], rules)
    costs: Floats = np.maximum(arrival, ready) if ready.any() else arrival + 0.0
    costs += by_row[:, None]
    costs += by_column
    costs[np.ix_(bound, job_bound)] -= rules.switch
    held = np.flatnonzero(job_bound)
    keepers = np.searchsorted(row, holder[column[held]])
    kept = costs[keepers, held] - rules.switch
    costs[np.ix_(vehicles.soon[row], job_bound)] = np.inf
    late = np.flatnonzero(ready > rules.early)
    costs[:, late] = np.where(arrival[:, late] < ready[late] - rules.early, np.inf, costs[:, late])
    costs[keepers, held] = kept
    return costs


def _among(some: Indices, all_: Indices, size: int) -> Flags:
    """Return which of some indices below ``size``, or NOBODY, are among all of these."""
    there = np.zeros(size + 1, np.bool_)
    there[all_] = True
    found: Flags = there[some]
    return found


def _part(table: Floats, rows: Indices, columns: Indices) -> Floats:
    """Return a block of a table; the whole one as it is."""
    return table if table.shape == (len(rows), len(columns)) else table[np.ix_(rows, columns)]


def best_pairs(costs: Floats, priority: Indices) -> list[tuple[int, int]]:
    """Return the pairs (row, column): as many as there can be, of the highest priorities, and of least total cost, by row.

    Each row and column is in one pair at most; infinite and undefined costs are never paired. In this order by construction:
    a step of priority weighs more than all costs together, and a pair more than that. That the linear weights choose the
    highest priorities, one after the other, is the greedy property of a transversal matroid.
    """
    if not costs.size:
        return []
    least, most, some = costs.min(), costs.max(), min(costs.shape)
    possible = None if np.isfinite(least + most) else np.isfinite(costs)
    if possible is not None:
        if not possible.any():
            return []
        least, most = costs[possible].min(), costs[possible].max()
    step = (most - least + 1.0) * (some + 1)
    levels = np.unique(priority, return_inverse=True)[1].reshape(-1)
    weighed = costs + (step * (levels.max() - levels) - least)
    if possible is not None:
        weighed[~possible] = step * (levels.max() + 2) * (some + 1)
    rows, columns = linear_sum_assignment(weighed)
    good = slice(None) if possible is None else possible[rows, columns]
    return list(zip(rows[good].tolist(), columns[good].tolist(), strict=True))


# -- rules to compare with ------------------------------------------------------------------------------------------------


def nearest_first_come(vehicles: Vehicles, jobs: Jobs, times: Times, *, most: int | None = None) -> Plan:
    """Give the most urgent and oldest job its nearest vehicle, then the next; nothing is thought over. For comparison."""
    return _one_by_one(vehicles, jobs, times, most, lambda reach: int(np.argmin(reach)))


def at_random(draw: np.random.Generator) -> Rule:
    """Return the rule that gives the most urgent and oldest job any vehicle, then the next. For comparison."""

    def rule(vehicles: Vehicles, jobs: Jobs, times: Times, *, most: int | None = None) -> Plan:
        return _one_by_one(
            vehicles, jobs, times, most, lambda reach: int(draw.choice(np.flatnonzero(np.isfinite(reach))))
        )

    return rule


def _one_by_one(
    vehicles: Vehicles, jobs: Jobs, times: Times, most: int | None, choose: Callable[[Floats], int]
) -> Plan:
    engaged = vehicles.job != NOBODY
    vehicle = _holders(vehicles, len(jobs.age))
    rows, queued = np.flatnonzero(~engaged & ~vehicles.soon), np.flatnonzero(vehicle == NOBODY)
    room = len(rows) if most is None else min(most, len(rows))
    columns = queued[_by_urgency(jobs, queued)][: max(len(rows), 1)]
    arrival = times(rows, columns) + vehicles.offset[rows][:, None] if len(rows) and len(columns) else np.empty((0, 0))
    plan, left = Plan(vehicle, rows, columns, arrival), arrival.copy()
    for index in range(left.shape[1]):
        if room > 0 and np.isfinite(left[:, index]).any():
            chosen = choose(left[:, index])
            vehicle[columns[index]] = rows[chosen]
            left[chosen] = np.inf
            room -= 1
    return plan
