"""The roll-call after a start: who has not said yet where it is, and where nobody may drive for that (COMMANDS section 3.6)."""

from collections.abc import Iterator

from app.domain.ids import VehicleId
from app.domain.units import Barcode
from app.fleet.vehicle import VehicleNow
from app.planning.track import Track

NAMED = 5
"""So many vehicles that are missing are named in a sentence (our choice)."""


class RollCall:
    """The vehicles that are missing, and the areas in which each of them may be. Areas are ``Track.area``'s."""

    def __init__(self, track: Track) -> None:
        self._track = track
        self._absent: dict[VehicleId, tuple[int, ...]] = {}
        self._by_area: dict[int, dict[VehicleId, None]] = {}
        self._anywhere: dict[VehicleId, None] = {}

    def __iter__(self) -> Iterator[VehicleId]:
        return iter(self._absent)

    def __contains__(self, vehicle: VehicleId) -> bool:
        return vehicle in self._absent

    def __len__(self) -> int:
        return len(self._absent)

    @property
    def anywhere(self) -> tuple[VehicleId, ...]:
        """Who is missing without any place that it was last known to be at."""
        return tuple(self._anywhere)

    def miss(self, vehicle: VehicleNow) -> None:
        """Wait for a vehicle, or note what is kept of its place by now."""
        self._leave(vehicle.id)
        places = [b for b in (vehicle.record.barcode, *vehicle.record.held) if b is not None and b in self._track]
        areas = tuple(dict.fromkeys(self._track.area(b) for b in places))
        if not areas:
            kind = vehicle.spec.kind
            areas = tuple(area for area in range(len(self._track.areas)) if kind in self._track.kinds(area))
        self._absent[vehicle.id] = areas
        for area in areas:
            self._by_area.setdefault(area, {})[vehicle.id] = None
        if vehicle.record.barcode is None and not vehicle.record.held:
            self._anywhere[vehicle.id] = None

    def strike_off(self, vehicle: VehicleId) -> tuple[int, ...]:
        """Wait for a vehicle no more; return the areas in which nobody is missing now that it is struck off."""
        freed = self._leave(vehicle)
        self._absent.pop(vehicle, None)
        return freed

    def _leave(self, vehicle: VehicleId) -> tuple[int, ...]:
        self._anywhere.pop(vehicle, None)
        freed = []
        for area in self._absent.get(vehicle, ()):
            missing = self._by_area[area]
            del missing[vehicle]
            if not missing:
                del self._by_area[area]
                freed.append(area)
        return tuple(freed)

    def misses(self, barcode: Barcode) -> bool:
        """Whether somebody is missing who may be in the area of a barcode."""
        return bool(self._by_area) and self._track.area(barcode) in self._by_area

    def missing(self, barcode: Barcode) -> tuple[VehicleId, ...]:
        """Return who is missing and may be in the area of a barcode."""
        return tuple(self._by_area.get(self._track.area(barcode), ())) if self._by_area else ()

    def clear(self) -> None:
        """Wait for nobody."""
        for vehicle in tuple(self._absent):
            self.strike_off(vehicle)


def named(missing: tuple[VehicleId, ...]) -> str:
    """Return who is missing, as a list in words; empty if nobody is."""
    more = f" and {len(missing) - NAMED} more" if len(missing) > NAMED else ""
    return ", ".join(missing[:NAMED]) + more
