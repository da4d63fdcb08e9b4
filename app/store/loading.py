"""What a restart needs, read back from the tables."""

import sqlalchemy as sa

from app.domain.ids import Epoch
from app.domain.records import ControllerRecord, ControllerState, Kept
from app.store import rows
from app.store.device_rows import device
from app.store.tables import (
    carriers,
    controller,
    devices,
    events,
    going_on,
    intents,
    jobs,
    station_dests,
    stations,
    unsettled,
    vehicle_offsets,
    vehicles,
)


def kept(connection: sa.Connection, epoch: Epoch, *, fresh: bool) -> Kept:
    """Return all that a controller needs to go on; each kind in the order of its key, the same on every database."""
    one = connection.execute(sa.select(controller)).one_or_none()
    return Kept(
        epoch=epoch,
        jobs=tuple(map(rows.job, connection.execute(sa.select(jobs).where(going_on).order_by(jobs.c.number)))),
        intents=tuple(
            map(rows.intent, connection.execute(sa.select(intents).where(unsettled).order_by(intents.c.cmd_id)))
        ),
        vehicles=tuple(sorted(map(rows.vehicle, _all(connection, vehicles)), key=lambda record: record.vehicle)),
        stations=tuple(sorted(map(rows.station, _all(connection, stations)), key=lambda record: record.station)),
        carriers=tuple(sorted(map(rows.carrier, _all(connection, carriers)), key=lambda record: record.carrier)),
        dests=tuple(sorted(map(rows.dest, _newest(connection, station_dests)), key=lambda record: record.station)),
        offsets=tuple(
            sorted(map(rows.offset, _newest(connection, vehicle_offsets)), key=lambda record: record.vehicle)
        ),
        devices=tuple(sorted(map(device, _all(connection, devices)), key=lambda record: record.device)),
        controller=ControllerRecord(ControllerState.AUTO) if one is None else rows.controller(one),
        next_event=_next(connection, events.c.seq),
        next_order=_next(connection, jobs.c.number),
        fresh=fresh,
    )


def _all(connection: sa.Connection, table: sa.Table) -> sa.CursorResult[object]:
    return connection.execute(sa.select(table))


def _newest(connection: sa.Connection, table: sa.Table) -> sa.CursorResult[object]:
    """Return the row with the highest version of each owner (the first column of the key)."""
    owner = next(iter(table.c))
    last = sa.select(owner, sa.func.max(table.c.version).label("version")).group_by(owner).subquery()
    joined = sa.and_(owner == last.c[owner.name], table.c.version == last.c.version)
    return connection.execute(sa.select(table).join(last, joined))


def _next(connection: sa.Connection, number: sa.Column[int]) -> int:
    return (connection.execute(sa.select(sa.func.max(number))).scalar() or 0) + 1
