"""Alarms to rows and back, as ``rows`` does for the other records."""

from operator import attrgetter

from app.domain.alarms import Alarm, AlarmKind
from app.store.columns import Found, Row

_plain = attrgetter(
    "source", "code", "cause", "remedy", "begun", "job", "ended", "outcome", "acknowledged", "acknowledged_by", "note"
)


def alarm_row(alarm: Alarm) -> Row:
    """Columns of ``alarms``."""
    return (alarm.number, alarm.kind.value, *_plain(alarm))


def alarm(row: Found) -> Alarm:
    """Undo :func:`alarm_row`."""
    return Alarm(
        number=row.number,
        kind=AlarmKind(row.kind),
        source=row.source,
        code=row.code,
        cause=row.cause,
        remedy=row.remedy,
        begun=row.begun,
        job=row.job,
        ended=row.ended,
        outcome=row.outcome,
        acknowledged=row.acknowledged,
        acknowledged_by=row.acknowledged_by,
        note=row.note,
    )
