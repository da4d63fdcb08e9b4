"""Bodies and parameters of teaching."""

from typing import Annotated, Literal

from fastapi import Path, Query
from pydantic import Field

from app.api.inputs import Id, Reason, Strict, Text
from app.domain.layout import PulseSet
from app.domain.teaching import DRIFT, ProposalState, Side
from app.domain.units import Pulses

Number = Annotated[int, Path(ge=1, le=(1 << 53) - 1)]
Version = Annotated[int, Path(ge=1, le=(1 << 31) - 1)]
After = Annotated[int | None, Query(ge=1, le=(1 << 53) - 1, description="Only what is numbered below this.")]
QueryNumber = Annotated[int | None, Query(ge=1, le=(1 << 53) - 1)]
Format = Annotated[Literal["json", "csv"], Query(description="csv: a file for a spreadsheet.")]
Drift = Annotated[int, Query(ge=0, le=(1 << 31) - 1, description="Pulses that may lie between two versions.")]


class SessionIn(Strict):
    """A port to teach (or to take as the reference for an OFFSET), and the vehicle to do it with."""

    station: Id
    vehicle: Id
    note: Text = ""


class StartIn(Strict):
    """``dest``: PORT DEST TEACHING, for the port. ``offset``: PORT OFFSET TEACHING, for the vehicle."""

    what: Literal["dest", "offset"]

    def side(self) -> Side:
        """Return it in the words of the business."""
        return Side(self.what)


class EndIn(Strict):
    """``abandon`` rejects what the session has taught and nobody has approved."""

    reason: Text = ""
    abandon: bool = False


class ApproveIn(Strict):
    """``accept``: what stands against the proposal and the person takes responsibility for."""

    reason: Text = ""
    accept: Annotated[list[Literal["incomplete", "wrong_mode", "out_of_range"]], Field(max_length=3)] = []

    def accepted(self) -> frozenset[ProposalState]:
        """Return the states in the words of the business."""
        return frozenset(ProposalState(state) for state in self.accept)


class RejectIn(Strict):
    """Why nothing is made of it."""

    reason: Reason


class AssignIn(Strict):
    """Which of the ports at its barcode it is about."""

    station: Id


class RollBackIn(Strict):
    """The older version that shall hold again, and why."""

    version: Annotated[int, Field(ge=1, le=(1 << 31) - 1)]
    reason: Reason


def most(shft: int = DRIFT.shft, rota: int = DRIFT.rota, lift: int = DRIFT.lift) -> PulseSet:
    """Return what may lie between two versions before it is pointed out."""
    return PulseSet(Pulses(shft), Pulses(rota), Pulses(lift))
