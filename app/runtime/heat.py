"""Where vehicles wait, and where many come by: counted while they are recorded, kept by the five minutes for the map."""

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

HEAT_SECONDS = 300.0
"""What is counted in so many seconds is kept together. Our choice: a period is exact to that."""
KEPT_EVERY = 60.0
"""What is counted at present is kept so often. Our choice: so much of it is lost with the process."""
MOST_PERIODS = 288
"""Of a stretch without any change so many periods are kept apart, and the rest as one. Our choice: a day."""
WAITS = "waiting"
"""The activity of a vehicle that stands for want of track."""


@dataclass(frozen=True, slots=True)
class Heat:
    """What was counted from ``begin`` to ``end`` (UTC seconds): seconds waited, and vehicles that came, by barcode."""

    begin: float
    end: float
    waiting: dict[str, float]
    traffic: dict[str, int]


class Counts:
    """Counts from ``begin`` on. A vehicle is told of as it changes; between two changes it goes on as it was."""

    def __init__(self, begin: float) -> None:
        self.begin = begin
        self._waiting: defaultdict[str, float] = defaultdict(float)
        self._traffic: defaultdict[str, int] = defaultdict(int)
        self._last: dict[str, tuple[str, bool, float]] = {}
        """Of each vehicle: where it is, whether it waits there, and up to when that is counted."""

    def take(self, vehicle: str, barcode: str | None, at: float, *, waits: bool) -> None:
        """A vehicle is at a barcode now; None: nobody knows where."""
        before = self._last.pop(vehicle, None)
        if before is not None:
            self._add(before, at)
        if barcode is None:
            return
        if before is not None and before[0] != barcode:
            self._traffic[barcode] += 1
        self._last[vehicle] = barcode, waits, at

    def until(self, end: float) -> Heat:
        """Return what was counted up to a moment."""
        for vehicle, last in self._last.items():
            self._add(last, end)
            self._last[vehicle] = last[0], last[1], max(end, last[2])
        waiting = {barcode: round(seconds, 1) for barcode, seconds in self._waiting.items()}
        return Heat(self.begin, end, waiting, dict(self._traffic))

    def over(self, at: float) -> Iterator[Heat]:
        """Give what was counted in each period that is over at a moment, and count anew from there."""
        for _ in range(MOST_PERIODS):
            end = self.begin + HEAT_SECONDS
            if at < end:
                return
            yield self.until(end)
            self.begin_anew(end)
        if at >= self.begin + HEAT_SECONDS:
            yield self.until(at)
            self.begin_anew(at)

    def begin_anew(self, begin: float) -> None:
        """Count from zero, with the vehicles where they are."""
        self.begin = begin
        self._waiting.clear()
        self._traffic.clear()

    def _add(self, last: tuple[str, bool, float], at: float) -> None:
        barcode, waits, since = last
        if waits and at > since:
            self._waiting[barcode] += at - since


def counted(
    vehicles: Mapping[str, Mapping[str, Any]], changes: Iterable[Sequence[Any]], begin: float, end: float
) -> Iterator[Heat]:
    """Count anew what was recorded of a time: the vehicles at its begin, and changes of theirs (when, topic, id, what)."""
    counts, now = Counts(begin), {name: dict(vehicle) for name, vehicle in vehicles.items()}
    for name, vehicle in now.items():
        counts.take(name, vehicle.get("barcode"), begin, waits=vehicle.get("activity") == WAITS)
    for at, _, name, change in changes:
        yield from counts.over(at)
        vehicle = now.setdefault(name, {})
        vehicle.update(change or {"barcode": None})
        counts.take(name, vehicle.get("barcode"), at, waits=vehicle.get("activity") == WAITS)
    yield from counts.over(end)
    if end > counts.begin:
        yield counts.until(end)


def together(some: Iterable[Heat]) -> Heat | None:
    """Return what several have counted, in their order; None: there are none."""
    waiting: defaultdict[str, float] = defaultdict(float)
    traffic: defaultdict[str, int] = defaultdict(int)
    first = last = None
    for heat in some:
        first, last = first or heat, heat
        for barcode, seconds in heat.waiting.items():
            waiting[barcode] += seconds
        for barcode, came in heat.traffic.items():
            traffic[barcode] += came
    if first is None or last is None:
        return None
    return Heat(first.begin, last.end, {b: round(s, 1) for b, s in waiting.items()}, dict(traffic))
