"""How slow each piece of track is by how long vehicles took over it of late, those included that have not got over it yet."""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Real: TypeAlias = "NDArray[np.float64]"
Whole: TypeAlias = "NDArray[np.int64]"


@dataclass(frozen=True, slots=True)
class Smoothing:
    """How observed times are turned into costs; all values are our choice.

    ``over``: an observation counts for about so many seconds: with less, ways follow every platoon and swing from lane to lane.
    ``doubt``: so many vehicles that were not held up are reckoned with besides, so that one slow vehicle makes no jam. ``usual``:
    this share of what is seen passes as not held up: vehicles brake and accelerate, which the empty track's times leave out.
    ``most``: no piece counts as more than so many times slower. So slow a one costs ``weight`` times its time besides, less by
    ``power`` one that is not: where ways follow each difference, vehicles swing from lane to lane (docs/traffic.md).
    """

    over: float = 120.0
    doubt: float = 3.0
    usual: float = 0.25
    most: float = 20.0
    weight: float = 3.0
    power: float = 6.0


class Traverses:
    """What was seen of each piece of track. ``free``: seconds on an empty track, a place for each piece."""

    def __init__(self, free: Real, smoothing: Smoothing | None = None) -> None:
        self._free, self._smoothing = np.maximum(free, 1e-9), smoothing or Smoothing()
        self._ratios: Real = np.zeros(len(free))
        self._count: Real = np.zeros(len(free))
        self._late: Real = np.zeros(len(free))
        self._late_ratios: Real = np.zeros(len(free))

    def look(self, pieces: Whole, seconds: Real, inside: Whole, since: Real, passed: float) -> None:
        """Take in which pieces were driven over in how many seconds since the last look, ``passed`` seconds ago.

        And on which pieces vehicles are now, and for how long each: of those, who takes longer than others did counts already.
        """
        fade = np.exp(-passed / self._smoothing.over)
        size = len(self._free)
        self._ratios = self._ratios * fade + _summed(pieces, seconds / self._free[pieces], size)
        self._count = self._count * fade + _summed(pieces, np.ones(len(pieces)), size)
        ratios = since / self._free[inside]
        late = ratios > self._mean(self._ratios, self._count)[inside]
        self._late = _summed(inside[late], np.ones(int(late.sum())), size)
        self._late_ratios = _summed(inside[late], ratios[late], size)

    def _mean(self, ratios: Real, count: Real) -> Real:
        doubt, usual = self._smoothing.doubt, self.usual
        return np.asarray((ratios + doubt * usual) / (count + doubt))

    @property
    def usual(self) -> float:
        """How many times as long as on an empty track vehicles take that are not held up, by what was seen; at least 1."""
        seen = np.flatnonzero(self._count > 0)
        if not len(seen):
            return 1.0
        ratios = self._ratios[seen] / self._count[seen]
        order = np.argsort(ratios, kind="stable")
        share = np.cumsum(self._count[seen][order])
        return max(1.0, float(ratios[order[np.searchsorted(share, self._smoothing.usual * share[-1])]]))

    def slowness(self) -> Real:
        """Return how many times slower than usual each piece is now: 1 where nobody is held up, ``most`` at most."""
        mean = self._mean(self._ratios + self._late_ratios, self._count + self._late)
        return np.asarray(np.clip(mean / self.usual, 1.0, self._smoothing.most))

    def costs(self) -> Real:
        """Return how many times its usual time each piece costs now: 1 where nobody is held up much."""
        rules = self._smoothing
        return np.asarray(1.0 + rules.weight * ((self.slowness() - 1.0) / (rules.most - 1.0)) ** rules.power)


def _summed(pieces: Whole, values: Real, size: int) -> Real:
    """Return the sum of the values of each piece."""
    return np.asarray(np.bincount(pieces, values, size), np.float64)
