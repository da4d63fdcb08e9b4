"""Devices and emergencies to rows and back, as ``rows`` does for the other records."""

from typing import Any

from app.domain.devices import DeviceId
from app.domain.records import (
    BufferLock,
    DeviceRecord,
    DoorPosition,
    Emergency,
    EmergencyKind,
    Pin,
    ZonePause,
)
from app.store.columns import Found, Row, as_json, lockout_of, lockout_text


def device_row(record: DeviceRecord) -> Row:
    """Columns of ``devices``."""
    pin, lock = record.pin, record.lock
    return (
        record.device,
        lockout_text(record.lockout),
        as_json([pin.position.value, pin.owner, pin.reason, pin.since]) if pin else None,
        as_json([lock.owner, lock.person, lock.since]) if lock else None,
        record.locked,
        record.out_of_service,
    )


def device(row: Found) -> DeviceRecord:
    """Undo :func:`device_row`."""
    return DeviceRecord(
        device=DeviceId(row.device),
        lockout=lockout_of(row.lockout),
        pin=Pin(DoorPosition(row.pin[0]), *row.pin[1:]) if row.pin else None,
        lock=BufferLock(*row.lock) if row.lock else None,
        locked=row.locked,
        out_of_service=row.out_of_service,
    )


def emergencies_text(emergencies: tuple[Emergency, ...]) -> str | None:
    """Return emergencies as the column ``controller.emergencies`` holds them; None: there are none."""
    rows = [[e.kind.value, e.actor, e.reason, e.since] for e in emergencies]
    return as_json(rows) if rows else None


def pauses_text(pauses: tuple[ZonePause, ...]) -> str | None:
    """Return pauses as the column ``controller.pauses`` holds them; None: there are none."""
    rows = [[p.zone, p.owner, p.reason, p.since, p.stopped] for p in pauses]
    return as_json(rows) if rows else None


def pauses(column: list[list[Any]] | None) -> tuple[ZonePause, ...]:
    """Undo :func:`pauses_text`."""
    return tuple(ZonePause(*row) for row in column or ())


def emergencies(column: list[list[Any]] | None) -> tuple[Emergency, ...]:
    """Undo :func:`emergencies_text`."""
    return tuple(Emergency(EmergencyKind(kind), *rest) for kind, *rest in column or ())
