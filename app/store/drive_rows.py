"""Records of drives to rows and back."""

from app.domain.drive_records import (
    DriveBackup,
    DriveOperation,
    DriveRecord,
    DriveValue,
    OperationKind,
    OperationState,
)
from app.store.columns import Found, Row, as_json, lockout_of, lockout_text


def operation_row(operation: DriveOperation) -> Row:
    """Columns of ``operations``."""
    return (
        operation.number,
        operation.kind.value,
        operation.state.value,
        operation.opened,
        operation.actor,
        operation.line,
        operation.drive,
        as_json(dict(operation.body)),
        operation.done,
        operation.total,
        operation.closed,
        as_json(dict(operation.result)),
        operation.reason,
        operation.remedy,
    )


def operation(row: Found) -> DriveOperation:
    """Undo :func:`operation_row`; sequences inside ``body`` and ``result`` come back as lists."""
    return DriveOperation(
        number=row.number,
        kind=OperationKind(row.kind),
        state=OperationState(row.state),
        opened=row.opened,
        actor=row.actor,
        line=row.line,
        drive=row.drive,
        body=row.body,
        done=row.done,
        total=row.total,
        closed=row.closed,
        result=row.result,
        reason=row.reason,
        remedy=row.remedy,
    )


def backup_row(backup: DriveBackup) -> Row:
    """Columns of ``drive_backups``."""
    raws = as_json(backup.values)
    return (backup.number, backup.drive, backup.model, backup.at, backup.actor, backup.note, raws)


def backup(row: Found) -> DriveBackup:
    """Undo :func:`backup_row`."""
    return DriveBackup(row.number, row.drive, row.model, row.at, row.actor, row.note, tuple(row.raws))


def value_row(value: DriveValue) -> Row:
    """Columns of ``drive_values``."""
    return (value.drive, value.parameter, value.value, value.at)


def value(row: Found) -> DriveValue:
    """Undo :func:`value_row`."""
    return DriveValue(row.drive, row.parameter, row.value, row.at)


def drive_row(record: DriveRecord) -> Row:
    """Columns of ``drives``."""
    return (record.drive, lockout_text(record.lockout))


def drive(row: Found) -> DriveRecord:
    """Undo :func:`drive_row`."""
    return DriveRecord(row.drive, lockout_of(row.lockout))
