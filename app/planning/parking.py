"""Where idle vehicles wait: over the areas as jobs have begun there lately, each at a place of its own, moved only when it pays.

In arrays, like ``dispatch``: areas, places and vehicles are indices, and whoever calls keeps the names. Times are seconds.
"""

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray
from scipy.spatial.distance import cdist

from app.planning.dispatch import Flags, Floats, Indices, best_pairs

NOWHERE = -1
Points = NDArray[np.float64]


@dataclass(frozen=True, slots=True)
class ParkingRules:
    """All values are our choice. ``memory``: after so long a job counts 1/e. ``gain``: by so many vehicles an area must have too
    many, and another too few, before one goes from there to here (hysteresis). ``farthest``: nobody is sent farther than
    so long. ``moves``: at most so many set out at a time.
    """

    memory: float = 1800.0
    gain: float = 0.75
    farthest: float = 240.0
    moves: int = 5


RULES = ParkingRules()


@dataclass(slots=True)
class Demand:
    """How many jobs began in each area lately, exponentially smoothed. ``at``: the moment that ``counts`` are of."""

    counts: Floats
    at: float = 0.0
    memory: float = field(default=RULES.memory)

    def begins(self, area: int, now: float) -> None:
        """A job begins in this area."""
        self.upto(now)[area] += 1.0

    def upto(self, now: float) -> Floats:
        """Return the counts as they are worth now."""
        self.counts *= np.exp(-max(now - self.at, 0.0) / self.memory)
        self.at = max(self.at, now)
        return self.counts


def areas_of(points: Points, count: int) -> Indices:
    """Return the area of each point (rows x, y): at most ``count`` groups of points near each other; no randomness.

    The centres are first the points farthest from each other, then the means of their groups, until nothing changes.
    """
    if not len(points):
        return np.empty(0, np.intp)
    centres = [int(np.argmin(((points - points.mean(axis=0)) ** 2).sum(axis=1)))]
    away = cdist(points, points[centres])[:, 0]
    while len(centres) < count and away.max() > 0:
        centres.append(int(np.argmax(away)))
        away = np.minimum(away, cdist(points, points[centres[-1:]])[:, 0])
    where, group = points[centres], np.full(len(points), NOWHERE, np.intp)
    for _ in range(MOST_ROUNDS):
        nearest = np.argmin(cdist(points, where), axis=1)
        if (nearest == group).all():
            break
        group = nearest
        where = np.array(
            [points[group == n].mean(axis=0) if (group == n).any() else where[n] for n in range(len(where))]
        )
    return np.unique(group, return_inverse=True)[1].reshape(-1).astype(np.intp)


MOST_ROUNDS = 50
"""Our choice: so often at most the centres of areas are moved."""


def shares(demand: Floats, room: Indices, idle: int) -> Floats:
    """Return how many of the idle vehicles belong in each area: by demand, and no more than there are places (``room``).

    An area without any demand has a claim of 1/20 of the mean: demand may begin anywhere (our choice).
    """
    share, left = np.zeros(len(demand)), float(min(idle, int(room.sum())))
    weight = demand + max(float(demand.mean()), 1e-9) / 20 if len(demand) else demand
    open_ = room > 0
    while left > 1e-9 and open_.any():
        given = np.where(open_, weight, 0.0)
        share += left * given / given.sum()
        over = np.maximum(share - room, 0.0)
        share, left = share - over, float(over.sum())
        open_ &= share < room - 1e-9
    return share


@dataclass(frozen=True, slots=True)
class Idle:
    """One entry for each vehicle that has nothing to do.

    ``area``: where it is (-1: in none). ``stays``: it stands at a proper place, or is on its way to one.
    """

    area: Indices
    stays: Flags


def park(
    idle: Idle,
    demand: Floats,
    places: Indices,
    taken: Flags,
    times: Floats,
    rules: ParkingRules = RULES,
    parked: Indices | None = None,
) -> dict[int, int]:
    """Return which vehicle goes to which place, by vehicle: few, and only those by which something is gained.

    ``places``: the area of each place. ``taken``: somebody stands there or is coming. ``times``: of each vehicle to each
    place, infinite: not reached. A vehicle that stands where nobody should goes to the nearest place of an area that lacks
    vehicles, or to the nearest of all; one at a place only goes from an area with too many to one with too few.
    ``parked``: so many more idle vehicles, by area, stand at places or go to them, and stay there whatever is gained.
    """
    if not len(idle.area) or not len(places):
        return {}
    staying = np.zeros(len(demand), np.intp) if parked is None else parked
    there = np.bincount(idle.area[idle.area >= 0], minlength=len(demand)).astype(np.float64) + staying
    share = shares(demand, np.bincount(places, minlength=len(demand)), len(idle.area) + int(staying.sum()))
    settled = np.bincount(idle.area[idle.stays & (idle.area >= 0)], minlength=len(demand)) + staying
    allowed = np.isfinite(times) & (times <= rules.farthest) & ~taken
    costs = np.where(allowed, times, np.inf)
    too_many = (there - share)[idle.area] >= rules.gain
    lacks = (share - there)[places]
    for row in range(len(idle.area)):
        if idle.stays[row]:
            leaves = bool(too_many[row]) and idle.area[row] >= 0
            costs[row, (lacks < rules.gain) if leaves else slice(None)] = np.inf
        else:
            costs[row, (share - settled)[places] < rules.gain] += rules.farthest
    return _chosen(idle, costs, places, there - share, share - there, rules)


def _chosen(
    idle: Idle, costs: Floats, places: Indices, over: Floats, under: Floats, rules: ParkingRules
) -> dict[int, int]:
    """Return the moves of least cost, each counted before the next: an area is not emptied for another, nor over-filled."""
    over, under = over.copy(), under.copy()
    pairs = best_pairs(costs, np.zeros(len(places), np.intp))
    chosen: dict[int, int] = {}
    for row, place in sorted(pairs, key=lambda pair: (costs[pair], pair)):
        here, there = int(idle.area[row]), int(places[place])
        if idle.stays[row] and (over[here] < rules.gain or under[there] < rules.gain):
            continue
        if len(chosen) >= rules.moves:
            break
        chosen[row] = place
        under[there] -= 1
        over[there] += 1
        if here >= 0:
            over[here] -= 1
            under[here] += 1
    return chosen
