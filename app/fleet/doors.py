"""Doors across the track: opened before a vehicle, closed behind it, and never closed on one (DOMAIN section 7, S56).

*Before:* a door that lies on a vehicle's way, as far as the vehicle claims ahead and drives while a door opens, is asked to open.
The way through is granted only while a fresh Status says that it is open and no close is under way (``Passages.against``).
*Behind:* it is asked to close once nobody is in it by length, by grant or by doubt (``Passages.engaged``), and nobody has wanted
it for a moment, on a fresh Status that says open. Between the decision and the packet this is looked at once more.
*When it fails* (error, unknown, silent, closed by hand, locked out): nobody is granted the way through any more. Who is granted
it and has not entered is stopped before it (STOP BY HOST, AGV Stop) if that is certain to bring it to a stand before the
passage; then it asks for the way anew, and waits. Who can no longer stop before it keeps its grant: to stop it inside the door
would be no safer. A door that reports an error is asked to open again every 10 s while somebody waits for it, and is never
asked to close.
"""

from collections.abc import Iterable

from app.domain.devices import DeviceAct, DeviceId, DoorState
from app.domain.ids import Actor, VehicleId
from app.domain.layout import DoorSpec, OnEmergency
from app.domain.records import DoorPosition
from app.domain.units import Barcode, Seconds
from app.fleet.books import SYSTEM, Books
from app.fleet.devices import DeviceNow, Devices
from app.fleet.horizon import can_stop_before, on_its_way
from app.fleet.motion import Motion
from app.fleet.passages import Passages
from app.fleet.vehicle import VehicleNow

OPENS_WITHIN = Seconds(4.0)
"""A door is asked to open so long before a vehicle would have to brake for it: 2 s to open, 1 s to report (5.3), 1 s to spare."""
CLOSE_AFTER = Seconds(2.0)
"""A door closes when nobody has needed it for so long (our choice)."""
OPENED_BY_HAND = Seconds(60.0)
"""A door that a person has opened closes after so long by itself; kept open it stays (our choice)."""


class Doors:
    """Decides when doors open and close."""

    def __init__(self, books: Books, devices: Devices, passages: Passages, motion: Motion) -> None:
        self._books = books
        self._devices = devices
        self._passages = passages
        self._motion = motion
        self._wanted: dict[VehicleId, tuple[DeviceId, ...]] = {}
        self._near: dict[VehicleId, tuple[DeviceId, ...]] = {}
        self._needed: dict[DeviceId, Seconds] = {}
        self._by_hand: dict[DeviceId, Seconds] = {}

    # -- before a vehicle ---------------------------------------------------------------------------------------------

    def follow(self, vehicle: VehicleNow) -> None:
        """Look which doors a vehicle will need soon."""
        if not self._passages.doors:
            return
        before = self._wanted.pop(vehicle.id, ())
        wanted = self._ahead_of(vehicle)
        if wanted:
            self._wanted[vehicle.id] = wanted
        for name in {*before, *wanted}:
            self._devices.touch(self._devices.all[name])

    def _ahead_of(self, vehicle: VehicleNow) -> tuple[DeviceId, ...]:
        if vehicle.errand is None or vehicle.handling is not None or not self._motion.may_drive(vehicle):
            return ()
        edges = on_its_way(self._books, vehicle, OPENS_WITHIN)
        doors = (self._passages.door_at(start, end) for start, end in edges)
        return tuple(dict.fromkeys(door.id for door in doors if door is not None))

    def waiting(self, door: DeviceNow) -> tuple[VehicleId, ...]:
        """Return who wants a door soon."""
        return tuple(sorted(name for name, doors in self._wanted.items() if door.id in doors))

    def told(self, door: DeviceNow) -> None:
        """A door has said something new: who wants it looks again."""
        for name in self.waiting(door):
            self._books.wake(name)

    # -- what a door is to do -----------------------------------------------------------------------------------------

    def concern(self, vehicles: Iterable[VehicleId]) -> None:
        """Note which doors hang on what is different of these vehicles: those whose track they hold, or held before."""
        if not self._passages.doors:
            return
        for name in vehicles:
            near = self._passages.near(name)
            for door in (*self._near.pop(name, ()), *near):
                self._devices.concern(door)
            if near:
                self._near[name] = near

    def mind(self, devices: Iterable[DeviceNow]) -> None:
        """Withdraw what may not be granted any more, and ask these doors for what they should do now."""
        for door in devices:
            if door not in self._passages.doors:
                continue
            engaged = self._passages.engaged(door)
            waiting = self.waiting(door)
            if engaged or waiting:
                self._needed[door.id] = self._books.now
            if (door.vehicles, door.waiting) != (tuple(sorted(engaged)), waiting):
                door.vehicles, door.waiting = tuple(sorted(engaged)), waiting
                self._devices.touch(door)
            self._withdraw(door, engaged)
            match self._desired(door, waiting):
                case DoorPosition.OPEN:
                    self._open(door)
                case DoorPosition.CLOSED:
                    self._close(door, engaged)
                case None:
                    pass

    def _desired(self, door: DeviceNow, waiting: Iterable[VehicleId]) -> DoorPosition | None:
        """Return how the door should stand now; None: as it does."""
        spec, pin = door.spec, door.record.pin
        if wanted := self.in_emergency(door):
            return wanted
        if pin:
            return pin.position
        if door.barred:
            return None
        if waiting:
            return DoorPosition.OPEN
        at_rest = isinstance(spec, DoorSpec) and spec.normally_open
        return None if at_rest or self._lately_needed(door) else DoorPosition.CLOSED

    def in_emergency(self, door: DeviceNow) -> DoorPosition | None:
        """Return how the plant file wants a door while a fire or an earthquake is told; None: none is, or as it stands."""
        if not self._books.controller.emergencies or not isinstance(door.spec, DoorSpec):
            return None
        positions = {OnEmergency.OPEN: DoorPosition.OPEN, OnEmergency.CLOSE: DoorPosition.CLOSED}
        return positions.get(door.spec.on_emergency)

    def _lately_needed(self, door: DeviceNow) -> bool:
        now, opened = self._books.now, self._by_hand.get(door.id)
        needed = self._needed.get(door.id)
        by_hand = opened is not None and now - opened < OPENED_BY_HAND
        return by_hand or (needed is not None and now - needed < CLOSE_AFTER)

    def _open(self, door: DeviceNow) -> None:
        closing = door.pending(DeviceAct.CLOSE)
        stands = door.state is DoorState.OPEN or (door.busy and not door.pending(DeviceAct.OPEN))
        if (closing or not stands) and self._devices.may_ask(door, DeviceAct.OPEN):
            self._devices.ask(door, DeviceAct.OPEN, SYSTEM)

    def _close(self, door: DeviceNow, engaged: dict[str, str]) -> None:
        idle = door.state is DoorState.OPEN and not door.opened
        if idle and not engaged and self._devices.may_ask(door, DeviceAct.CLOSE):
            self._devices.ask(door, DeviceAct.CLOSE, SYSTEM)

    # -- when it fails ------------------------------------------------------------------------------------------------

    def _withdraw(self, door: DeviceNow, engaged: dict[str, str]) -> None:
        """Nobody may enter a door that is not known to be open; say so if somebody cannot be kept from it."""
        why = self._passages.against(door)
        late = [name for name in sorted(engaged) if why and self._comes(door, VehicleId(name), f"{door.id} is {why}")]
        if not late:
            self._devices.say(door, None)
            return
        who = ", ".join(late)
        trouble = f"is not open, and {who} cannot be stopped before it any more", f"look at {door.id} and {who}"
        self._devices.say(door, trouble)

    def _comes(self, door: DeviceNow, name: VehicleId, why: str) -> bool:
        """Keep a vehicle out of a door that it is granted the way through; return whether it comes all the same."""
        vehicle = self._books.vehicles[name]
        through = set(self._passages.doors[door]).intersection(self._passages.granted(vehicle))
        return any(
            self._enters(vehicle, passage) and not self._keep_out(vehicle, passage[0], why) for passage in through
        )

    def _enters(self, vehicle: VehicleNow, passage: tuple[Barcode, Barcode]) -> bool:
        """Whether the vehicle was told to drive through, or stands and would be; not: it only holds track to behind it."""
        drive = vehicle.drive
        if drive is None:
            return True
        amended = drive.amendment.path if drive.amendment else ()
        return any(element.barcode == passage[1] for element in (*drive.path, *amended))

    def _keep_out(self, vehicle: VehicleNow, before: Barcode, why: str) -> bool:
        """Stop a vehicle before a passage; False: it is too late for that, or it cannot be told."""
        if vehicle.drive and vehicle.drive.recalled:
            return True
        if vehicle.drive and not can_stop_before(self._books, vehicle, before):
            return False
        self._motion.recall(vehicle, why)
        return vehicle.drive is None or vehicle.drive.recalled

    # -- people -------------------------------------------------------------------------------------------------------

    def opened_by(self, door: DeviceNow, actor: Actor) -> int | None:
        """A person opens a door. Returns the command's CMD_ID; None: it is open and somebody drives through, so nothing is sent.

        A door that is asked to open reports busy first, even an open one (5.3): that would stop who comes.
        """
        self._by_hand[door.id] = self._books.now
        if not self._passages.against(door) and self._passages.engaged(door):
            return None
        return self._devices.ask(door, DeviceAct.OPEN, actor).cmd_id

    def closed_by(self, door: DeviceNow, actor: Actor) -> int:
        """A person closes a door that nobody is in. Returns the command's CMD_ID."""
        self._by_hand.pop(door.id, None)
        return self._devices.ask(door, DeviceAct.CLOSE, actor).cmd_id

    def may_leave(self, door: DeviceNow, act: DeviceAct) -> str:
        """Return why a command to a door must not leave any more: somebody is in it by now; empty if it may."""
        engaged = self._passages.engaged(door) if act is DeviceAct.CLOSE and door in self._passages.doors else {}
        return ", ".join(engaged.values())
