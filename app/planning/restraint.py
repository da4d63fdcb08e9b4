"""How many vehicles may be on their way at once: beyond some number they only stand in each other's way.

On a narrow spine the flow is greatest where about a third of the track is taken; where nearly all is, it falls to a fifth
(TRAFFIC section 4: 1,400 vehicles carry less than 1,000). So a fleet that is larger than its track carries keeps the rest idle,
where it can be asked to go on. Nobody who is on the way is ever stopped for this: it is no resource that anyone could wait for,
so that it cannot lock anybody up.
"""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Limits:
    """When a fleet counts as too many; all values are our choice, from runs on the fab of TRAFFIC section 1.

    Of the vehicles on their way, without those that handle a carrier: below ``low`` (a share) of them standing more may set out,
    above ``high`` fewer. The share is a mean over about ``over`` seconds. ``pace``: vehicles more or fewer in a second.
    ``least``: so many always may. With 0.15 and 0.25 a fleet came so near to what its track carries that it fell far back once or
    twice in an hour; about 0.05 stand behind one that handles a carrier, however few are on their way (docs/traffic.md).
    """

    low: float = 0.08
    high: float = 0.12
    over: float = 10.0
    pace: float = 1.0
    least: int = 50
    first: int = 150


class Restraint:
    """The number of vehicles that may be on their way, found by how many of them stand."""

    def __init__(self, vehicles: int, limits: Limits | None = None, under_way: int = 0) -> None:
        """Begin with so many on their way: after a restart, no fewer than there were."""
        self._limits = limits or Limits()
        self._vehicles = vehicles
        self._most = float(min(vehicles, max(self._limits.first, under_way)))
        self._share = 0.0

    @property
    def most(self) -> int:
        """How many may be on their way now."""
        return int(self._most)

    def look(self, standing: int, driving: int, under_way: int, seconds: float) -> int:
        """Take in how many on their way stand and drive, and how many have work at all; return how many more may set out.

        ``seconds`` after the last look.
        """
        limits = self._limits
        share = standing / (standing + driving) if standing + driving else 0.0
        self._share += (share - self._share) * min(1.0, seconds / limits.over)
        if self._share > limits.high:
            self._most = max(float(min(limits.least, self._vehicles)), self._most - limits.pace * seconds)
        elif self._share < limits.low and under_way >= self._most - 5:
            self._most = min(float(self._vehicles), self._most + limits.pace * seconds)
        return max(0, self.most - under_way)
