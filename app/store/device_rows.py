"""Devices and emergencies to rows and back, as ``rows`` does for the other records."""

import json
from typing import Any

import sqlalchemy as sa

from app.domain.devices import DeviceId
from app.domain.ids import Actor
from app.domain.records import (
    BufferLock,
    DeviceRecord,
    DoorPosition,
    Emergency,
    EmergencyKind,
    Lockout,
    Pin,
)
from app.domain.units import Timestamp

Row = tuple[str | int | float | bool | None, ...]


def _json(value: object) -> str:
    return json.dumps(value, separators=(",", ":"), allow_nan=False)


def device_row(record: DeviceRecord) -> Row:
    """Columns of ``devices``."""
    pin, lock, lockout = record.pin, record.lock, record.lockout
    return (
        record.device,
        _json([lockout.owner, lockout.reason, lockout.since, *lockout.releases]) if lockout else None,
        _json([pin.position.value, pin.owner, pin.reason, pin.since]) if pin else None,
        _json([lock.owner, lock.person, lock.since]) if lock else None,
        record.locked,
        record.out_of_service,
    )


def device(row: sa.Row[Any]) -> DeviceRecord:
    """Undo :func:`device_row`."""
    return DeviceRecord(
        device=DeviceId(row.device),
        lockout=_lockout(*row.lockout) if row.lockout else None,
        pin=Pin(DoorPosition(row.pin[0]), *row.pin[1:]) if row.pin else None,
        lock=BufferLock(*row.lock) if row.lock else None,
        locked=row.locked,
        out_of_service=row.out_of_service,
    )


def _lockout(owner: str, reason: str, since: float, *releases: str) -> Lockout:
    return Lockout(Actor(owner), reason, Timestamp(since), tuple(Actor(name) for name in releases))


def emergencies_text(emergencies: tuple[Emergency, ...]) -> str | None:
    """Return emergencies as the column ``controller.emergencies`` holds them; None: there are none."""
    rows = [[e.kind.value, e.actor, e.reason, e.since] for e in emergencies]
    return _json(rows) if rows else None


def emergencies(column: list[list[Any]] | None) -> tuple[Emergency, ...]:
    """Undo :func:`emergencies_text`."""
    return tuple(Emergency(EmergencyKind(kind), *rest) for kind, *rest in column or ())
