"""Doors and buffers: what is known of them (DOMAIN section 7)."""

from dataclasses import dataclass

from app.domain.devices import (
    BufferState,
    DeviceBack,
    DeviceDone,
    DeviceEvent,
    DeviceFailed,
    DeviceGarbled,
    DeviceId,
    DeviceKind,
    DeviceNotAccepted,
    DeviceNotSent,
    DeviceReported,
    DeviceStale,
    DeviceTaken,
    DeviceUnknown,
    DoorState,
    MoveCompleted,
    TagRead,
)
from app.domain.ids import LinkId
from app.domain.layout import BufferSpec, DoorSpec
from app.domain.units import Seconds
from app.domain.view import DeviceView, Topic
from app.fleet.books import Books


@dataclass(slots=True)
class DeviceNow:
    """A door or buffer at this moment. ``state`` is its last word; it counts only while ``fresh``."""

    spec: DoorSpec | BufferSpec
    fresh: bool = False
    state: DoorState | BufferState | None = None
    seen: Seconds | None = None
    reason: str = "not connected yet"

    @property
    def id(self) -> DeviceId:
        """The device's name."""
        return self.spec.id

    @property
    def link(self) -> LinkId:
        """The line that it is on."""
        return self.spec.link

    @property
    def kind(self) -> DeviceKind:
        """What it is."""
        return DeviceKind.DOOR if isinstance(self.spec, DoorSpec) else DeviceKind.BUFFER


class Devices:
    """Knows the doors and buffers of the plant."""

    def __init__(self, books: Books) -> None:
        self._books = books
        specs: list[DoorSpec | BufferSpec] = [*books.plant.doors, *books.plant.buffers]
        self.all: dict[DeviceId, DeviceNow] = {spec.id: DeviceNow(spec) for spec in specs}
        for device in self.all.values():
            self._show(device)

    def handle(self, event: DeviceEvent) -> None:
        """Take what a link tells of one of its doors and buffers."""
        device = None if event.device is None else self.all.get(event.device)
        if device is None:
            return
        match event:
            case DeviceReported(status=DoorState() | BufferState() as state, at=at):
                device.fresh, device.state, device.seen, device.reason = True, state, at, ""
            case DeviceStale(reason=reason):
                device.fresh, device.reason = False, reason
            case DeviceBack():
                device.fresh, device.reason = True, ""
            case (
                DeviceReported()
                | DeviceTaken()
                | DeviceDone()
                | DeviceFailed()
                | DeviceNotAccepted()
                | DeviceNotSent()
                | DeviceUnknown()
                | DeviceGarbled()
                | TagRead()
                | MoveCompleted()
            ):
                return
        self._show(device)

    def _show(self, device: DeviceNow) -> None:
        books = self._books
        view = DeviceView(
            id=device.id,
            kind=device.kind.value,
            link=device.link,
            number=device.spec.number,
            fresh=device.fresh,
            reason=device.reason,
            state=device.state.name.lower() if device.state is not None else None,
            seen=books.utc_at(device.seen) if device.seen is not None else None,
        )
        books.show(Topic.DEVICES, device.id, view)
