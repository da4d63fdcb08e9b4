"""How doors, buffers and chargers look to people and hosts."""

from typing import TYPE_CHECKING

from app.domain.layout import ChargerSpec, DoorSpec
from app.domain.view import DeviceView, LockoutView, LockView, PinView
from app.fleet.books import Books

if TYPE_CHECKING:
    from app.fleet.devices import DeviceNow


def view_of_device(device: "DeviceNow", books: Books) -> DeviceView:
    """Return a device as people see it."""
    spec, record = device.spec, device.record
    charger = spec if isinstance(spec, ChargerSpec) else None
    station = next((s for s in books.plant.stations if s.buffer == device.id), None)
    pin, lock = record.pin, record.lock
    return DeviceView(
        id=device.id,
        kind=device.kind.value,
        link=device.link,
        number=None if isinstance(spec, ChargerSpec) else spec.number,
        fresh=device.fresh,
        reason=device.reason,
        state=device.state.name.lower() if device.state is not None else None,
        since=None if charger else books.utc_at(device.since),
        seen=books.utc_at(device.seen) if device.seen is not None else None,
        service="out_of_service" if record.out_of_service else "in_service",
        out_of_service=record.out_of_service,
        barcode=charger.barcode if charger else station.barcode if station else None,
        station=station.id if station else None,
        passages=tuple(sorted(spec.passages)) if isinstance(spec, DoorSpec) else (),
        pending=", ".join(intent.kind for intent in device.opened.values()),
        vehicles=device.vehicles,
        waiting=device.waiting,
        pin=PinView(pin.position.value, pin.owner, pin.reason, pin.since) if pin else None,
        lock=LockView(lock.owner, lock.person, lock.since, record.locked) if lock else None,
        lockout=LockoutView.of(record.lockout),
        alarm=device.alarm,
        remedy=device.remedy,
        contradiction=device.contradiction,
    )
