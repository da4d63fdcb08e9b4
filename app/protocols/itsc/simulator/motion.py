"""Kinematics along a line: accelerate, cruise, brake; exact in time, without steps.

Lengths in mm, speeds in mm/s, accelerations in mm/s² (both positive), times in seconds on the caller's clock.
"""

from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass
from math import sqrt

EPSILON = 1e-6
"""mm: nearer than this is the same point. Our choice: far below a tenth of a millimetre, far above rounding."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """A piece to run: its length, its speed limit, and the most speed allowed at its end (0: stop there)."""

    length: float
    limit: float
    exit: float


@dataclass(slots=True)
class _Phase:
    """Constant acceleration from a time, a place and a speed on."""

    start: float
    place: float
    speed: float
    acceleration: float
    duration: float


class Profile:
    """Place and speed over time. ``ends`` is when each stretch ends, ``end`` when all is over."""

    __slots__ = ("_phases", "_starts", "end", "ends", "length")

    def __init__(self, now: float) -> None:
        self._phases: list[_Phase] = []
        self._starts: list[float] = []
        self.end = now
        self.ends: list[float] = []
        self.length = 0.0

    def at(self, now: float) -> tuple[float, float]:
        """Return place (mm from the start) and speed at a time; outside the profile its nearer end's."""
        index = bisect_right(self._starts, now) - 1
        if index < 0:
            return (0.0, self._phases[0].speed) if self._phases else (0.0, 0.0)
        phase = self._phases[index]
        passed = min(now - phase.start, phase.duration)
        place = phase.place + phase.speed * passed + phase.acceleration * passed * passed / 2
        return min(place, self.length), max(0.0, phase.speed + phase.acceleration * passed)

    def _add(self, place: float, speed: float, acceleration: float, duration: float) -> None:
        if duration > 0:
            self._phases.append(_Phase(self.end, place, speed, acceleration, duration))
            self._starts.append(self.end)
            self.end += duration

    def _sweep(self, length: float, entry: float, leave: float, limit: float, up: float, down: float) -> None:
        """Run one stretch from one speed to another, as fast as the limit and the accelerations let."""
        at, end = self.length, self.length + length
        if entry > limit:
            braked = min(length, (entry**2 - limit**2) / (2 * down))
            slower = sqrt(max(0.0, entry**2 - 2 * down * braked))
            self._add(at, entry, -down, (entry - slower) / down)
            at, length, entry = at + braked, length - braked, slower
        peak = sqrt((2 * up * down * length + down * entry**2 + up * leave**2) / (up + down))
        peak = max(min(peak, limit), entry, leave)
        rise, fall = (peak**2 - entry**2) / (2 * up), (peak**2 - leave**2) / (2 * down)
        level = max(0.0, length - rise - fall)
        self._add(at, entry, up, (peak - entry) / up)
        if level > EPSILON:
            self._add(at + rise, peak, 0.0, level / peak)
        self._add(at + rise + level, peak, -down, (peak - leave) / down)
        self.length = end
        self.ends.append(self.end)


def plan(now: float, speed: float, stretches: Sequence[Stretch], up: float, down: float) -> Profile:
    """Return the quickest run over the stretches from a given speed; too fast for a limit, it brakes as hard as it can."""
    speeds = [speed]
    for index, stretch in enumerate(stretches):
        following = stretches[index + 1].limit if index + 1 < len(stretches) else stretch.limit
        speeds.append(min(stretch.exit, stretch.limit, following))
    for index in range(len(stretches) - 1, 0, -1):
        speeds[index] = min(speeds[index], sqrt(speeds[index + 1] ** 2 + 2 * down * stretches[index].length))
    profile = Profile(now)
    for index, stretch in enumerate(stretches):
        entry, length = speeds[index], stretch.length
        slowest = entry**2 - 2 * down * length
        fastest = sqrt(entry**2 + 2 * up * length)
        # Rounding must not leave a crawl at a stop that is just reached.
        slowest = sqrt(slowest) if slowest > 1e-3 else 0.0
        speeds[index + 1] = max(min(speeds[index + 1], fastest), slowest)
        profile._sweep(length, entry, speeds[index + 1], stretch.limit, up, down)
    return profile


def brake(now: float, speed: float, lengths: Sequence[float], down: float) -> Profile:
    """Return the shortest stop; ``ends`` holds those of the consecutive lengths that are passed or just reached."""
    profile = Profile(now)
    stop = speed**2 / (2 * down)
    passed = 0.0
    for length in lengths:
        passed += length
        if passed > stop + EPSILON:
            break
        left = sqrt(max(0.0, speed**2 - 2 * down * passed))
        profile.ends.append(now + (speed - left) / down)
    # At the end of the rail there is nothing to roll on.
    profile.length = min(stop, sum(lengths)) if lengths else 0.0
    profile._add(0.0, speed, -down, speed / down)
    return profile
