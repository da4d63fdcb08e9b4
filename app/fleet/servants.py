"""Which vehicles can serve which station: for all vehicles at once, since pairs are many."""

from operator import attrgetter

import numpy as np
from numpy.typing import NDArray

from app.domain.ids import StationId
from app.domain.layout import Axis, Station, StationKind
from app.domain.pulses import AxisPulses
from app.fleet.books import Books
from app.planning.dispatch import Flags


class Servants:
    """Says by station who can handle there: the kind of vehicle, complete teaching, and targets within its limits.

    The answer for one vehicle is that of ``target_for``; it is found for all in one go, and again when something is taught.
    Arrays have one entry for each vehicle, in the order of ``books.vehicles``.
    """

    def __init__(self, books: Books) -> None:
        self._books = books
        self._taught = -1
        self._known: dict[str, Flags] = {}
        vehicles = list(books.vehicles.values())
        self._all: Flags = np.ones(len(vehicles), np.bool_)
        self._kinds = {
            kind: np.array([vehicle.spec.kind is kind for vehicle in vehicles], np.bool_)
            for kind in {vehicle.spec.kind: None for vehicle in vehicles}
        }
        limits = [[vehicle.spec.limits.of(axis) for axis in Axis] for vehicle in vehicles]
        self._limits: NDArray[np.float64] = np.array(limits, np.float64).reshape(len(vehicles), len(Axis), 2)
        self._offsets: NDArray[np.float64] = np.empty((len(vehicles), len(Axis)))

    def of(self, place: str) -> Flags:
        """Return who can handle at a station; all, if the place is no station. Not to be changed."""
        books = self._books
        if self._taught != books.taught:
            self._taught = books.taught
            self._known.clear()
            offsets = [books.teaching.offset_of(name, books.offsets.get(name)) for name in books.vehicles]
            self._offsets = np.array([_row(offset) for offset in offsets], np.float64).reshape(len(offsets), len(Axis))
        found = self._known.get(place)
        if found is None:
            station = books.specs.get(StationId(place))
            found = self._known[place] = self._all if station is None else self._who(station)
        return found

    def _who(self, station: Station) -> Flags:
        kind: Flags = np.zeros(len(self._all), np.bool_)
        for one, flags in self._kinds.items():
            if station.kind in one.serves:
                kind |= flags
        if station.kind is not StationKind.PORT:
            return kind
        dest = self._books.dests.get(station.id)
        if dest is None:
            return np.zeros(len(self._all), np.bool_)
        target = self._offsets + np.array(_row(dest.pulses), np.float64)
        within = (self._limits[..., 0] <= target) & (target <= self._limits[..., 1])
        return kind & within.all(axis=1)


_of_all_axes = attrgetter(*(axis.name.lower() for axis in Axis))


def _row(pulses: AxisPulses | None) -> tuple[float | None, ...]:
    """Return the pulses by axis; as an array not a number where one is not known, which is within no limits."""
    return _NOTHING if pulses is None else _of_all_axes(pulses)


_NOTHING = (None,) * len(Axis)
