"""What people may ask for in teaching (DOMAIN section 3). ``actor`` is always a named person."""

from dataclasses import dataclass

from app.domain.ids import Actor, StationId, VehicleId
from app.domain.records import StationDest, VehicleOffset
from app.domain.teaching import ImportRow, ProposalState, Side


@dataclass(frozen=True, slots=True)
class OpenTeaching:
    """Open a session for a port and a vehicle."""

    actor: Actor
    station: StationId
    vehicle: VehicleId
    note: str = ""


@dataclass(frozen=True, slots=True)
class StartTeaching:
    """Ask the session's vehicle for its three axes: PORT DEST or PORT OFFSET TEACHING."""

    actor: Actor
    session: int
    side: Side


@dataclass(frozen=True, slots=True)
class EndTeaching:
    """Close a session. ``abandon`` rejects what it has taught and nobody has approved."""

    actor: Actor
    session: int
    reason: str = ""
    abandon: bool = False


@dataclass(frozen=True, slots=True)
class ApproveProposal:
    """Make a version of a proposal. ``accept`` names states that the person takes responsibility for.

    ``expected`` is the revision that was seen, None for not checked.
    """

    actor: Actor
    proposal: int
    accept: frozenset[ProposalState] = frozenset()
    reason: str = ""
    expected: int | None = None


@dataclass(frozen=True, slots=True)
class RejectProposal:
    """Make nothing of a proposal."""

    actor: Actor
    proposal: int
    reason: str
    expected: int | None = None


@dataclass(frozen=True, slots=True)
class AssignProposal:
    """Say which of the ports at its barcode a proposal is about."""

    actor: Actor
    proposal: int
    station: StationId
    expected: int | None = None


@dataclass(frozen=True, slots=True)
class RollBackDest:
    """Make a new version of a station's DEST that equals ``to``, an old one as the store has it."""

    actor: Actor
    station: StationId
    to: StationDest
    reason: str
    expected: int | None = None

    @property
    def summary(self) -> str:
        """Return it for the audit."""
        return f"to version {self.to.version}: {self.reason}"


@dataclass(frozen=True, slots=True)
class RollBackOffset:
    """The same of a vehicle's OFFSET."""

    actor: Actor
    vehicle: VehicleId
    to: VehicleOffset
    reason: str
    expected: int | None = None

    @property
    def summary(self) -> str:
        """Return it for the audit."""
        return f"to version {self.to.version}: {self.reason}"


@dataclass(frozen=True, slots=True)
class ImportTaught:
    """Take over rows of a file: all, or none if one cannot be."""

    actor: Actor
    side: Side
    rows: tuple[ImportRow, ...]

    @property
    def summary(self) -> str:
        """Return it for the audit."""
        return f"{len(self.rows)} rows of {self.side.value}"


TeachingRequest = (
    OpenTeaching
    | StartTeaching
    | EndTeaching
    | ApproveProposal
    | RejectProposal
    | AssignProposal
    | RollBackDest
    | RollBackOffset
    | ImportTaught
)
