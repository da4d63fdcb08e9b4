"""Requests about doors, buffers and chargers: commands, pins, lockouts, service (DOMAIN section 7)."""

from app.domain.device_requests import (
    CommandDevice,
    DeviceOrder,
    LiftDeviceLockout,
    LockOutDevice,
    PinDoor,
    SetDeviceService,
    UnpinDoor,
)
from app.domain.devices import DeviceAct, DeviceKind
from app.domain.errors import Refusal
from app.domain.ids import Actor, VehicleId
from app.domain.job import JobEvent
from app.domain.records import BufferLock, DoorPosition, Lockout, Pin
from app.domain.requests import Accepted, Reply
from app.domain.view import Topic
from app.fleet.books import Books
from app.fleet.buffers import Buffers
from app.fleet.devices import DeviceNow, Devices
from app.fleet.doors import Doors
from app.fleet.passages import Passages
from app.fleet.refusals import not_lifted

ACTS = {
    DeviceKind.DOOR: (DeviceAct.OPEN, DeviceAct.CLOSE),
    DeviceKind.BUFFER: (DeviceAct.LOCK, DeviceAct.UNLOCK),
    DeviceKind.CHARGER: (),
}
"""What people may ask of each kind (PROTOCOLS 3.3): a charger has no packets."""


class DeviceOrders:
    """Answers requests about one device."""

    def __init__(self, books: Books, devices: Devices, passages: Passages, doors: Doors, buffers: Buffers) -> None:
        self._books = books
        self._devices = devices
        self._passages = passages
        self._doors = doors
        self._buffers = buffers

    def answer(self, request: DeviceOrder) -> Reply:
        """Carry a request out or say why not."""
        device = self._devices.all.get(request.device)
        if device is None:
            return Refusal("not-found", f"there is no device {request.device}", "see GET /api/v1/devices")
        match request:
            case CommandDevice():
                return self._command(device, request)
            case PinDoor():
                return self._pin(device, request)
            case UnpinDoor():
                return self._unpin(device, request)
            case LockOutDevice():
                return self._lock_out(device, request)
            case LiftDeviceLockout():
                return self._lift(device, request)
            case SetDeviceService():
                return self._service(device, request)

    def _accepted(self, device: DeviceNow, cmd_id: int | None = None) -> Accepted:
        self._devices.touch(device)
        return Accepted(Topic.DEVICES, device.id, cmd_id=cmd_id)

    def _changed(self, device: DeviceNow, actor: Actor, what: str) -> Accepted:
        detail = f"{device.id} {what} by {actor}"
        self._books.event(JobEvent.DEVICE_CHANGED, vehicle=VehicleId(device.id), detail=detail)
        for vehicle in self._books.vehicles:
            self._books.wake(vehicle)
        return self._accepted(device)

    # -- commands -----------------------------------------------------------------------------------------------------

    def _command(self, device: DeviceNow, request: CommandDevice) -> Reply:
        act, actor = request.act, request.actor
        acts = ACTS[device.kind]
        if act not in acts:
            able = " and ".join(a.value for a in acts) or "nothing: it has no packets of its own"
            return Refusal(
                "invalid",
                f"{device.id} is a {device.kind.value} and does not {act.value}",
                f"it does {able}",
                "command",
            )
        if refusal := self._locked_out(device):
            return refusal
        if act is not DeviceAct.OPEN and not device.fresh:
            return Refusal("not-now", f"{device.id} is silent: {device.reason}", "see its line and its power")
        if device.kind is DeviceKind.DOOR:
            return self._move_door(device, act, actor)
        return self._lock_buffer(device, act, actor)

    def _locked_out(self, device: DeviceNow) -> Refusal | None:
        lock = device.record.lockout
        return Refusal("not-now", f"{device.id} is {lock}", "lift the lockout first") if lock else None

    def _move_door(self, door: DeviceNow, act: DeviceAct, actor: Actor) -> Reply:
        position = DoorPosition.OPEN if act is DeviceAct.OPEN else DoorPosition.CLOSED
        if refusal := self._against(door, position):
            return refusal
        if act is DeviceAct.OPEN:
            return self._accepted(door, self._doors.opened_by(door, actor))
        return self._accepted(door, self._doors.closed_by(door, actor))

    def _against(self, door: DeviceNow, position: DoorPosition) -> Refusal | None:
        """Return why a person cannot have a door in this position now."""
        pin, wanted = door.record.pin, self._doors.in_emergency(door)
        if wanted and wanted is not position:
            told = self._books.controller.told
            return Refusal("not-now", f"{door.id} is kept {wanted.value}: {told}", "release the emergency first")
        if pin and pin.position is not position:
            return Refusal(
                "conflict",
                f"{door.id} is kept {pin.position.value} by {pin.owner}: {pin.reason}",
                f"DELETE /api/v1/devices/{door.id}/pin first",
            )
        engaged = self._passages.engaged(door) if position is DoorPosition.CLOSED else {}
        if engaged:
            return Refusal(
                "not-now",
                f"{door.id} cannot close: {', '.join(engaged.values())}",
                "wait until it is through, or lock the door out: nobody else is granted the way then",
            )
        return None

    def _lock_buffer(self, buffer: DeviceNow, act: DeviceAct, actor: Actor) -> Reply:
        lock = buffer.record.lock
        if lock and not lock.person:
            return Refusal("conflict", f"{buffer.id} is locked for {lock.owner}", f"wait until {lock.owner} is done")
        wanted = BufferLock(actor, person=True, since=self._books.utc) if act is DeviceAct.LOCK else None
        self._devices.save(buffer, lock=wanted)
        return self._accepted(buffer, self._devices.ask(buffer, act, actor).cmd_id)

    # -- decisions of people ------------------------------------------------------------------------------------------

    def _pin(self, door: DeviceNow, request: PinDoor) -> Reply:
        """Keep a door open or closed."""
        if door.kind is not DeviceKind.DOOR:
            return Refusal("invalid", f"{door.id} is a {door.kind.value}, not a door", "name a door", "device")
        pin = door.record.pin
        if pin and pin.owner != request.actor:
            return Refusal("conflict", f"{door.id} is kept {pin.position.value} by {pin.owner}", f"ask {pin.owner}")
        if refusal := self._locked_out(door) or (None if pin else self._against(door, request.position)):
            return refusal
        if pin and request.position is DoorPosition.CLOSED and (engaged := self._passages.engaged(door)):
            return Refusal("not-now", f"{door.id} cannot close: {', '.join(engaged.values())}", "wait a moment")
        self._devices.save(door, pin=Pin(request.position, request.actor, request.reason, self._books.utc))
        return self._changed(door, request.actor, f"is kept {request.position.value} ({request.reason})")

    def _unpin(self, door: DeviceNow, request: UnpinDoor) -> Reply:
        """Anybody may give the door back to the vehicles: what protects people is the lockout."""
        if door.record.pin is None:
            return Refusal("conflict", f"{door.id} is not kept open or closed", "see GET /api/v1/devices: pin")
        self._devices.save(door, pin=None)
        return self._changed(door, request.actor, "is given back to the vehicles")

    def _lock_out(self, device: DeviceNow, request: LockOutDevice) -> Reply:
        """Nothing is asked of the device; nobody is granted the way through, served or charged there, until it is lifted."""
        if lockout := device.record.lockout:
            return Refusal("conflict", f"{device.id} is locked out by {lockout.owner} already", f"ask {lockout.owner}")
        self._devices.save(device, lockout=Lockout(request.actor, request.reason, self._books.utc))
        return self._changed(device, request.actor, f"is locked out ({request.reason})")

    def _lift(self, device: DeviceNow, request: LiftDeviceLockout) -> Reply:
        """Lifted by its owner, or by two others together."""
        lockout = device.record.lockout
        if lockout is None:
            return Refusal("conflict", f"{device.id} is not locked out", "see GET /api/v1/devices: lockout")
        wished = lockout.wished_away_by(request.actor)
        if not wished.lifted_by(request.actor):
            self._devices.save(device, lockout=wished)
            return not_lifted(lockout)
        self._devices.save(device, lockout=None)
        return self._changed(device, request.actor, "is locked out no more")

    def _service(self, device: DeviceNow, request: SetDeviceService) -> Reply:
        """Out of service with a reason, or back."""
        self._devices.save(device, out_of_service=request.reason)
        what = f"is taken out of service ({request.reason})" if request.reason else "is in service"
        return self._changed(device, request.actor, what)
