"""The pieces of track that lead through doors: which are open to vehicles, and who is in them (DOMAIN section 7)."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from app.domain.devices import DeviceAct, DeviceId, DoorState
from app.domain.ids import VehicleId
from app.domain.layout import DoorSpec
from app.domain.records import DoorPosition
from app.domain.units import Barcode
from app.fleet.books import Books
from app.fleet.devices import DeviceNow, Devices
from app.fleet.vehicle import VehicleNow

Passage = tuple[Barcode, Barcode]


class Passages:
    """Answers for every piece of track whether a door stands across it, open or not. Knows no motion and changes nothing."""

    def __init__(self, books: Books, devices: Devices) -> None:
        self._books = books
        self.doors: dict[DeviceNow, tuple[Passage, ...]] = {
            device: self._both_ways(device.spec) for device in devices.all.values() if isinstance(device.spec, DoorSpec)
        }
        self._at: dict[Passage, DeviceNow] = {
            passage: door for door, passages in self.doors.items() for passage in passages
        }

        self._ends: dict[Barcode, tuple[DeviceId, ...]] = {}
        for door, passages in self.doors.items():
            for end in dict.fromkeys(barcode for passage in passages for barcode in passage):
                self._ends[end] = (*self._ends.get(end, ()), door.id)

    def near(self, vehicle: VehicleId) -> tuple[DeviceId, ...]:
        """Return the doors of whose passages the vehicle holds an end."""
        held = self._books.traffic.held(vehicle)
        return tuple(dict.fromkeys(door for barcode in held for door in self._ends.get(barcode, ())))

    def _both_ways(self, spec: DoorSpec) -> tuple[Passage, ...]:
        """Return the pieces of track that lead through a door: those named, and the same ones driven the other way."""
        track = self._books.track
        named = {*spec.passages, *((end, start) for start, end in spec.passages)}
        return tuple(sorted((start, end) for start, end in named if start in track and end in track.successors(start)))

    def door_at(self, start: Barcode, end: Barcode) -> DeviceNow | None:
        """Return the door across a piece of track, if there is one."""
        return self._at.get((start, end))

    def barred(self, start: Barcode, end: Barcode) -> DeviceNow | None:
        """Return the door that keeps everybody from being granted this piece of track; None if nothing does."""
        door = self._at.get((start, end))
        return door if door is not None and self.against(door) else None

    def against(self, door: DeviceNow) -> str:
        """Return why nobody may be granted the way through a door, as a clause; empty if somebody may.

        Only a fresh Status that says open, with no close under way that might still take effect, lets anybody through.
        """
        if door.barred:
            return door.barred
        pin = door.record.pin
        if pin and pin.position is DoorPosition.CLOSED:
            return f"kept closed by {pin.owner}: {pin.reason}"
        if not door.fresh or door.state is None:
            return f"silent: {door.reason}"
        if door.pending(DeviceAct.CLOSE):
            return "closing"
        if door.state is DoorState.OPEN:
            return ""
        if door.pending(DeviceAct.OPEN) and door.state in (DoorState.CLOSED, DoorState.BUSY):
            return "opening"
        return "moving" if door.busy else door.state.name.lower()

    def wait_for(self, door: DeviceNow) -> str:
        """Return a door and why it is waited for, with the seconds that this has lasted where the door itself is why."""
        why = self.against(door)
        if door.barred or door.record.pin:
            return f"{door.id} ({why})"
        return f"{door.id} ({why}, {int(self._books.now - door.since)} s)"

    # -- who is in them -----------------------------------------------------------------------------------------------

    def engaged(self, door: DeviceNow) -> dict[str, str]:
        """Return who keeps a door from closing, each with the words for it: by length, by grant, or by doubt.

        After a start a vehicle that has not reported may be anywhere it was last known to be, or anywhere at all.
        """
        books = self._books
        found: dict[str, str] = {}
        for start, end in self.doors[door]:
            for name in sorted(books.traffic.holders(end) | books.traffic.holders(start)):
                if name not in found and (how := self._how(books.vehicles[name], start, end)):
                    found[name] = f"{name} {how}"
        for name in books.roll_call.anywhere:
            if name not in found:
                found[name] = f"{name} has not said where it is since the start"
        return found

    def _how(self, vehicle: VehicleNow, start: Barcode, end: Barcode) -> str:
        """Return how a vehicle that holds an end of a passage is engaged in it; empty if it is not.

        Whoever drives on a piece of track holds its head, and holds it until the tail is past it. One that was stopped
        may stand there and hold its start only.
        """
        if (start, end) in self.granted(vehicle):
            return "is granted the way through it"
        if vehicle.barcode == start and end in vehicle.beyond:
            return "may stand in it"
        if end not in self._books.traffic.held(vehicle.id):
            return ""
        if vehicle.barcode is None or not (end in vehicle.trail or end in vehicle.ahead):
            return "may be in it"
        behind = vehicle.trail.get(end)
        if behind is None or behind >= vehicle.spec.length:
            return ""
        came = vehicle.way.index(end) if end in vehicle.way else 0
        if came == 0:
            return "may stand in it"
        return "is in it" if vehicle.way[came - 1] == start else ""

    def granted(self, vehicle: VehicleNow) -> list[Passage]:
        """Return the pieces of track that a vehicle is granted beyond the barcode it last reported, in order."""
        if vehicle.barcode is None:
            return []
        return list(pairwise([vehicle.barcode, *vehicle.ahead]))

    def shut_on(self, path: Sequence[Barcode]) -> Iterator[DeviceNow]:
        """Give the doors on a path that let nobody through now."""
        for start, end in pairwise(path) if self.doors else ():
            if (door := self.barred(start, end)) is not None:
                yield door

    def shut_ahead(self, vehicle: VehicleNow) -> Iterator[tuple[Passage, DeviceNow]]:
        """Give the passages that a vehicle is granted though their door lets nobody through by now, in order."""
        for start, end in self.granted(vehicle):
            if (door := self.barred(start, end)) is not None:
                yield (start, end), door
