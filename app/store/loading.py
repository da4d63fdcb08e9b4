"""What a restart needs, read back from the tables."""

import sqlalchemy as sa

from app.domain.ids import Epoch
from app.domain.records import ControllerRecord, ControllerState, Kept
from app.domain.webhooks import WebhookState
from app.store import drive_rows, rows, teaching, webhook_rows, why_rows
from app.store.alarm_rows import alarm
from app.store.closure_rows import closure
from app.store.device_rows import device
from app.store.tables import (
    alarms,
    carriers,
    closures,
    controller,
    devices,
    drive_values,
    drives,
    events,
    going_on,
    going_on_teaching,
    in_force,
    intents,
    job_whys,
    jobs,
    open_walks,
    operations,
    station_dests,
    stations,
    teaching_events,
    teaching_proposals,
    teaching_sessions,
    there_now,
    undecided,
    under_way,
    unsettled,
    vehicle_offsets,
    vehicles,
    walk_places,
    walks,
    webhook_progress,
    webhooks,
)
from app.store.walk_rows import walk, walk_place


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
        dests=tuple(sorted(map(teaching.dest, _newest(connection, station_dests)), key=lambda record: record.station)),
        offsets=tuple(
            sorted(map(teaching.offset, _newest(connection, vehicle_offsets)), key=lambda record: record.vehicle)
        ),
        devices=tuple(sorted(map(device, _all(connection, devices)), key=lambda record: record.device)),
        controller=ControllerRecord(ControllerState.AUTO) if one is None else rows.controller(one),
        whys=tuple(map(why_rows.why, _whys(connection))),
        next_event=_next(connection, events.c.seq),
        next_order=_next(connection, jobs.c.number),
        drives=tuple(sorted(map(drive_rows.drive, _all(connection, drives)), key=lambda record: record.drive)),
        drive_values=tuple(
            sorted(map(drive_rows.value, _all(connection, drive_values)), key=lambda one: (one.drive, one.parameter))
        ),
        operations=tuple(
            map(
                drive_rows.operation,
                connection.execute(sa.select(operations).where(under_way).order_by(operations.c.number)),
            )
        ),
        next_operation=_next(connection, operations.c.number),
        proposals=tuple(map(teaching.proposal, _those(connection, teaching_proposals, undecided))),
        sessions=tuple(map(teaching.session, _those(connection, teaching_sessions, going_on_teaching))),
        next_taught=_next(connection, teaching_events.c.seq),
        next_proposal=_next(connection, teaching_proposals.c.number),
        next_session=_next(connection, teaching_sessions.c.number),
        closures=tuple(map(closure, _those(connection, closures, in_force))),
        alarms=tuple(map(alarm, _those(connection, alarms, there_now))),
        next_alarm=_next(connection, alarms.c.number),
        walks=tuple(map(walk, _those(connection, walks, open_walks))),
        walk_places=tuple(map(walk_place, _places(connection))),
        next_walk=_next(connection, walks.c.number),
        next_closure=_next(connection, closures.c.number),
        webhooks=tuple(
            map(webhook_rows.webhook, _those(connection, webhooks, webhooks.c.state != WebhookState.REMOVED.value))
        ),
        webhook_progress=tuple(
            sorted(map(webhook_rows.progress, _all(connection, webhook_progress)), key=lambda one: one.webhook)
        ),
        next_webhook=_next(connection, webhooks.c.number),
        fresh=fresh,
    )


def _all(connection: sa.Connection, table: sa.Table) -> sa.CursorResult[object]:
    return connection.execute(sa.select(table))


def _those(connection: sa.Connection, table: sa.Table, wanted: sa.ColumnElement[bool]) -> sa.CursorResult[object]:
    """Return the rows wanted, in the order of their number."""
    return connection.execute(sa.select(table).where(wanted).order_by(table.c.number))


def _places(connection: sa.Connection) -> sa.CursorResult[object]:
    """Return the places of open walks."""
    live = sa.select(walks.c.number).where(open_walks)
    query = sa.select(walk_places).where(walk_places.c.walk.in_(live))
    return connection.execute(query.order_by(walk_places.c.walk, walk_places.c.station))


def _whys(connection: sa.Connection) -> sa.CursorResult[object]:
    """Return the why-records of the jobs that have not ended."""
    live = sa.select(jobs.c.number).where(going_on)
    return connection.execute(sa.select(job_whys).where(job_whys.c.number.in_(live)).order_by(job_whys.c.number))


def _newest(connection: sa.Connection, table: sa.Table) -> sa.CursorResult[object]:
    """Return the row with the highest version of each owner (the first column of the key)."""
    owner = next(iter(table.c))
    last = sa.select(owner, sa.func.max(table.c.version).label("version")).group_by(owner).subquery()
    joined = sa.and_(owner == last.c[owner.name], table.c.version == last.c.version)
    return connection.execute(sa.select(table).join(last, joined))


def _next(connection: sa.Connection, number: sa.Column[int]) -> int:
    return (connection.execute(sa.select(sa.func.max(number))).scalar() or 0) + 1
