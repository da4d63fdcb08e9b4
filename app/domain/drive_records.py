"""What is kept of drives: what people asked of them, backups, the values last read, lockouts."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from app.domain.drive import DriveId, Parameter, RawValue
from app.domain.ids import Actor, LinkId
from app.domain.lockout import Lockout
from app.domain.units import Timestamp


class OperationState(StrEnum):
    """How an operation stands. *Unknown* is not *failed*: it may have taken effect."""

    RUNNING = "running"
    DONE = "done"
    FAILED = "failed"
    UNKNOWN = "unknown"


class OperationKind(StrEnum):
    """What people can ask of a drive that takes its time."""

    STATUS = "status"
    KEY = "key"
    INPUTS = "inputs"
    READ = "read"
    WRITE = "write"
    BACKUP = "backup"
    COMPARE = "compare"
    RESTORE = "restore"
    JOG = "jog"
    STOP_ALL = "stop_all"

    @property
    def changes(self) -> bool:
        """Whether it may change or move something: one such at a time on a drive."""
        return self in _CHANGES

    @property
    def reads_only(self) -> bool:
        """Whether nothing can have come of it if it was broken off."""
        return self in _READS


_CHANGES = frozenset(
    {OperationKind.KEY, OperationKind.INPUTS, OperationKind.WRITE, OperationKind.RESTORE, OperationKind.JOG}
)
_READS = frozenset({OperationKind.STATUS, OperationKind.READ, OperationKind.BACKUP, OperationKind.COMPARE})


@dataclass(frozen=True, slots=True)
class DriveOperation:
    """A request about a drive, or all drives of a line (``drive`` None), from its acceptance to its end.

    Numbers rise by one. ``body`` is what was asked, ``result`` what has come of it so far, both for people and JSON-able;
    ``done`` of ``total`` steps are over. ``reason`` and ``remedy`` are set where it has failed or nobody knows.
    """

    number: int
    kind: OperationKind
    state: OperationState
    opened: Timestamp
    actor: Actor
    line: LinkId
    drive: DriveId | None = None
    body: Mapping[str, object] = field(default_factory=dict)
    done: int = 0
    total: int = 1
    closed: Timestamp | None = None
    result: Mapping[str, object] = field(default_factory=dict)
    reason: str = ""
    remedy: str = ""


@dataclass(frozen=True, slots=True)
class DriveBackup:
    """All parameters of a drive at one time; its number is that of the operation that read them.

    ``values`` has the raw value of each parameter from 00 on, None where the drive gave none.
    """

    number: int
    drive: DriveId
    model: str
    at: Timestamp
    actor: Actor
    note: str
    values: tuple[RawValue | None, ...]


@dataclass(frozen=True, slots=True)
class DriveValue:
    """What a parameter was when it was last read for somebody, or written and read back."""

    drive: DriveId
    parameter: Parameter
    value: RawValue
    at: Timestamp


@dataclass(frozen=True, slots=True)
class DriveRecord:
    """What must be known of a drive after a restart."""

    drive: DriveId
    lockout: Lockout | None = None


DriveRecords = DriveOperation | DriveBackup | DriveValue | DriveRecord
"""Operation and record replace the row of their key, a value that of drive and parameter; backups append."""
