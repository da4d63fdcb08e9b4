"""What people may ask about axis drives (PROTOCOLS section 2; DOMAIN section 7). ``actor`` is always who asks."""

from dataclasses import dataclass

from app.domain.drive import DriveId, Key, Parameter, RawValue, SetInputs, Turn
from app.domain.ids import Actor, LinkId
from app.domain.units import Seconds

Values = tuple[tuple[Parameter, RawValue], ...]
"""Parameters with their values, lowest number first."""


@dataclass(frozen=True, slots=True)
class PressDriveKey:
    """Press a key of a drive's panel once. RUN, UP and DOWN move where the drive's mode says so."""

    actor: Actor
    drive: DriveId
    key: Key


@dataclass(frozen=True, slots=True)
class StopDriveLine:
    """Stop all drives of a line at once. None of them answers (PROTOCOLS 2.3)."""

    actor: Actor
    line: LinkId


@dataclass(frozen=True, slots=True)
class AskDriveStatus:
    """Ask a drive for its status now."""

    actor: Actor
    drive: DriveId


@dataclass(frozen=True, slots=True)
class SetDriveInputs:
    """Set a drive's inputs; RUN and HOME make it move."""

    actor: Actor
    drive: DriveId
    inputs: SetInputs


@dataclass(frozen=True, slots=True)
class ReadDrive:
    """Read parameters, one after the other."""

    actor: Actor
    drive: DriveId
    parameters: tuple[Parameter, ...]


@dataclass(frozen=True, slots=True)
class WriteDrive:
    """Write a parameter. One of ``raw`` and ``value`` (in the catalogue's unit) is given.

    ``raw_access``: it is meant although no catalogue names the parameter. ``expected``: write only if the drive has this now.
    """

    actor: Actor
    drive: DriveId
    parameter: Parameter
    raw: RawValue | None = None
    value: float | None = None
    raw_access: bool = False
    expected: RawValue | None = None


@dataclass(frozen=True, slots=True)
class BackUpDrive:
    """Read all parameters and keep them."""

    actor: Actor
    drive: DriveId
    note: str = ""


@dataclass(frozen=True, slots=True)
class CompareDrive:
    """Read a drive and tell where it differs from a backup's ``values``, or from another drive, which is read too."""

    actor: Actor
    drive: DriveId
    what: str
    values: Values = ()
    other: DriveId | None = None


@dataclass(frozen=True, slots=True)
class RestoreDrive:
    """Write what differs from a backup's ``values``. ``dry_run``: only say what would be written."""

    actor: Actor
    drive: DriveId
    what: str
    model: str
    values: Values
    dry_run: bool = False


@dataclass(frozen=True, slots=True)
class JogDrive:
    """Jog an axis as long as the caller says so again in time (:class:`KeepDriveJog`)."""

    actor: Actor
    drive: DriveId
    turn: Turn


@dataclass(frozen=True, slots=True)
class CancelDriveOperation:
    """Ask nothing more of a drive for this operation; what was sent already is not undone."""

    actor: Actor
    operation: int


@dataclass(frozen=True, slots=True)
class LockDrive:
    """Maintenance lockout: people are at the axis. Only status and stop go through."""

    actor: Actor
    drive: DriveId
    reason: str


@dataclass(frozen=True, slots=True)
class UnlockDrive:
    """Lift a lockout: its owner alone, or two others together."""

    actor: Actor
    drive: DriveId


DriveOrder = (
    PressDriveKey
    | StopDriveLine
    | AskDriveStatus
    | SetDriveInputs
    | ReadDrive
    | WriteDrive
    | BackUpDrive
    | CompareDrive
    | RestoreDrive
    | JogDrive
    | CancelDriveOperation
    | LockDrive
    | UnlockDrive
)


# Words: carried out at once, without a commit, because they change nothing that is kept.


@dataclass(frozen=True, slots=True)
class KeepDriveJog:
    """The caller still holds the jog key."""

    operation: int


@dataclass(frozen=True, slots=True)
class ReleaseDriveJog:
    """The caller has let go of the jog key. A stop waits for no disk."""

    operation: int


@dataclass(frozen=True, slots=True)
class WatchDrive:
    """Poll parameters for somebody who watches, for so many seconds; None: until :class:`UnwatchDrive`.

    ``watch`` is a name that the watcher has chosen; the same again replaces what it watches.
    """

    watch: str
    drive: DriveId
    parameters: tuple[Parameter, ...]
    seconds: Seconds | None = None


@dataclass(frozen=True, slots=True)
class UnwatchDrive:
    """Nobody watches any more."""

    watch: str


Word = KeepDriveJog | ReleaseDriveJog | WatchDrive | UnwatchDrive
"""What is told to the controller and changes nothing that is kept: it takes effect at once."""
