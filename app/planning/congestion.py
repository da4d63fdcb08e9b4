"""What ways cost by the traffic on them (TRAFFIC section 4): by how full track is."""

from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

Real: TypeAlias = "NDArray[np.float64]"
Whole: TypeAlias = "NDArray[np.int64]"


@dataclass(frozen=True, slots=True)
class Costs:
    """How fullness is turned into seconds; all values are our choice, from runs on the fab of TRAFFIC section 1.

    ``over``: fullness is the mean over about so many seconds; with one or less, as it is at the last look. What it was minutes
    ago says where the jam was, not where it is (docs/traffic.md). A piece of track costs its free-flow time, and ``weight`` times
    that where it is full, less by ``power`` where it is not.
    """

    over: float = 1.0
    weight: float = 6.0
    power: float = 6.0


class Congestion:
    """How full each piece of track is, and what it costs therefore.

    ``free``: seconds of each piece at free flow; ``capacity``: vehicles it has room for. Both are rows, a place for each piece.
    """

    def __init__(self, free: Real, capacity: Whole, costs: Costs | None = None) -> None:
        self.free, self._costs = free, costs or Costs()
        self._room = np.maximum(capacity, 1).astype(float)
        self._mean = np.zeros(len(free))

    def look(self, load: Whole, seconds: float) -> None:
        """Take in how many vehicles that are on their way are on each piece now; ``seconds`` after the last look."""
        self._mean += (load - self._mean) * min(1.0, seconds / self._costs.over)

    def costs(self) -> Real:
        """Return the seconds that each piece costs now: never less than at free flow, at most ``1 + weight`` times as much."""
        full = np.minimum(1.0, self._mean / self._room)
        return np.asarray(self.free * (1.0 + self._costs.weight * full**self._costs.power))
