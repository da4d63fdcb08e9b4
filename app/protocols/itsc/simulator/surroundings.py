"""What is around a simulated vehicle: places with or without a FOUP."""

from typing import Protocol

from app.domain.ids import VehicleId
from app.domain.layout import PulseSet, StationKind
from app.domain.units import Barcode


class Surroundings(Protocol):
    """The physical world as a vehicle's gripper meets it. ``target`` is None at a side buffer, whose pulses are not sent."""

    def take(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """The gripper closed at a place: return whether it now holds a FOUP, which has left the place."""
        ...

    def put(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """The gripper opened at a place: return whether the FOUP stands there now; False if the place was taken."""
        ...


class Places:
    """A world in memory. At a place not yet known one finds what one came for; from then on the place is known."""

    def __init__(self) -> None:
        self._full: dict[tuple[Barcode, StationKind], bool] = {}

    def fill(self, barcode: Barcode, kind: StationKind) -> None:
        """A FOUP stands at the place."""
        self._full[barcode, kind] = True

    def empty(self, barcode: Barcode, kind: StationKind) -> None:
        """No FOUP stands at the place."""
        self._full[barcode, kind] = False

    def full(self, barcode: Barcode, kind: StationKind) -> bool | None:
        """Return whether a FOUP stands at the place; None if nothing is known of it."""
        return self._full.get((barcode, kind))

    def take(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """Give the FOUP out, if there is one."""
        there = self._full.get((barcode, kind), True)
        self._full[barcode, kind] = False
        return there

    def put(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """Take the FOUP in, if there is room."""
        room = not self._full.get((barcode, kind), False)
        self._full[barcode, kind] = True
        return room
