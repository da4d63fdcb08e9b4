"""Bodies and parameters that we accept: strict (``false`` is no 0, ``"5"`` no 5), bounded, without control characters."""

import re
from datetime import UTC, datetime
from typing import Annotated, Literal

from fastapi import Path, Query
from pydantic import AfterValidator, AwareDatetime, BaseModel, BeforeValidator, ConfigDict, Field, StringConstraints

from app.api.problems import Problem
from app.domain.commands import Plain
from app.domain.ids import StationId
from app.domain.layout import PulseSet, StopAction
from app.domain.requests import Verdict
from app.domain.units import Pulses

_HIDDEN = r"\xad\u061c\u200b-\u200f\u2028-\u202e\u2060-\u206f\ufeff\ufff9-\ufffb"
"""Letters that nobody sees, or that turn the others round: two names would look alike."""
_NOT_IN_IDS = rf"\x00-\x20\x7f-\xa0/\\?#%\u1680\u2000-\u200a\u202f\u205f\u3000{_HIDDEN}"
ID_PATTERN = rf"^[^.{_NOT_IN_IDS}][^{_NOT_IN_IDS}]*$"
"""Ids travel in URLs: no blanks, control characters, or characters that cut a URL; a first dot would mean a step there."""
TEXT_PATTERN = rf"^[^\x00-\x1f\x7f-\x9f{_HIDDEN}]*$"
_NUMBER = re.compile(r"[\s+\-\d.eE_]*")
_EATEN_PLUS = re.compile(r"(:\d{2}(?:[.,]\d+)?) (?=\d{2}:?\d{2}$)")
"""A blank between a time and its zone: in a query a ``+`` that was not escaped comes as one (HTML, URL-encoded forms)."""
ASCII_PATTERN = r"^[\x20-\x7e]*$"

Id = Annotated[str, StringConstraints(strict=True, min_length=1, max_length=64, pattern=ID_PATTERN)]
Text = Annotated[str, StringConstraints(strict=True, max_length=200, pattern=TEXT_PATTERN)]
Reason = Annotated[str, StringConstraints(strict=True, min_length=1, max_length=200, pattern=TEXT_PATTERN)]
Priority = Annotated[int, Field(ge=0, le=99)]
Pulse = Annotated[int, Field(ge=-(1 << 31), le=(1 << 31) - 1)]


def _said(value: object) -> object:
    """Return what may be a moment: text that is no number, for that could be seconds, milliseconds or a day's date."""
    if value is not None and (not isinstance(value, str) or _NUMBER.fullmatch(value)):
        raise ValueError("is no moment in ISO 8601, such as 2026-07-01T08:30:00Z")
    return _EATEN_PLUS.sub(r"\1+", value) if isinstance(value, str) else value


def _within(moment: datetime) -> datetime:
    """Return a moment that any period around it can be reckoned with."""
    if not EARLIEST <= moment <= LATEST:
        raise ValueError(f"lies outside {EARLIEST.year} to {LATEST.year}")
    return moment


EARLIEST, LATEST = datetime(1970, 1, 1, tzinfo=UTC), datetime(9000, 1, 1, tzinfo=UTC)
"""Our choice: well within what a calendar has."""
Moment = Annotated[AwareDatetime, BeforeValidator(_said), AfterValidator(_within), Field(strict=False)]
"""A moment with its zone."""

PathId = Annotated[str, Path(min_length=1, max_length=64, pattern=ID_PATTERN)]
QueryId = Annotated[str | None, Query(min_length=1, max_length=64, pattern=ID_PATTERN)]
After = Annotated[int, Query(ge=0, le=(1 << 53) - 1, description="Only what is numbered above this.")]
Older = Annotated[
    int | None, Query(ge=1, le=(1 << 53) - 1, description="Only what is numbered below this; go on with `next`.")
]
Limit = Annotated[int, Query(ge=1, le=1000, description="At most this many.")]


class Strict(BaseModel):
    """No coercion, no unknown fields."""

    model_config = ConfigDict(strict=True, extra="forbid", frozen=True)


class JobIn(Strict):
    """A transfer. ``source`` is a station, or a vehicle that has the carrier aboard."""

    job_id: Id | None = None
    source: Id
    destination: Id
    carrier: Id | None = None
    priority: Priority = 50
    vehicle: Id | None = None
    fallbacks: Annotated[list[Id], Field(max_length=16)] = Field(
        default_factory=list, json_schema_extra={"default": []}
    )


class JobEndIn(Strict):
    """Why a job is ended, for those who ask later; it may be left out."""

    reason: Text = ""


class JobChange(Strict):
    """What to change; a field that is left out stays. ``vehicle`` null: any vehicle may do it again."""

    priority: Priority | None = None
    destination: Id | None = None
    vehicle: Id | None = None


class Target(Strict):
    """Positions of the three taught axes, pulses."""

    shft: Pulse
    rota: Pulse
    lift: Pulse

    def pulses(self) -> PulseSet:
        """Return them in the words of the business."""
        return PulseSet(Pulses(self.shft), Pulses(self.rota), Pulses(self.lift))


class PlainCommand(Strict):
    """A command without data. ``stop`` drops the vehicle to MANT; ``stop_by_host`` keeps it in its mode."""

    command: Literal[
        "status",
        "stop",
        "stop_by_host",
        "servo_on",
        "servo_off",
        "search_home",
        "go_home",
        "system_reset",
        "alarm_clear",
        "auto",
    ]

    def plain(self) -> Plain:
        """Return it in the words of the business."""
        return Plain(self.command)


class DisplayCommand(Strict):
    """Show a text on the vehicle; with ``alarm`` (0x8000 to 0xFFFF) as an alarm."""

    command: Literal["display"]
    text: Annotated[str, StringConstraints(strict=True, min_length=1, max_length=12, pattern=ASCII_PATTERN)]
    alarm: Annotated[int, Field(ge=0x8000, le=0xFFFF)] | None = None


class MoveCommand(Strict):
    """Drive to a barcode, under grants like any job."""

    command: Literal["move"]
    barcode: Id
    action: Literal["stop", "port", "sbfl", "sbfr", "port_bare"] = "stop"

    def stop_action(self) -> StopAction:
        """Return the stop in the words of the business."""
        return StopAction[self.action.upper()]


class TransferCommand(Strict):
    """One pick-up or put-down by a vehicle that stands at the station. ``target`` replaces the taught pulses."""

    command: Literal["pickup", "place"]
    station: Id
    target: Target | None = None


class RecoverIn(Strict):
    """``confirmed``: a person at the vehicle has seen that homing is safe."""

    confirmed: bool = False


class ReasonIn(Strict):
    """Why."""

    reason: Reason


class ReleaseIn(Strict):
    """What a named person has found. ``barcode`` with ``stands_at`` only."""

    verdict: Literal["go_on", "off_rail", "stands_at"]
    reason: Reason
    barcode: Id | None = None

    def decided(self) -> Verdict:
        """Return the verdict in the words of the business."""
        return Verdict(self.verdict)


class ServiceIn(Strict):
    """Whether a vehicle or a device is used; out of service needs a ``reason``."""

    in_service: bool
    reason: Text = ""

    def why_not(self) -> str:
        """Return why it is not used, empty if it is. Raises Problem: the two do not fit."""
        reason = self.reason.strip()
        if bool(reason) == self.in_service:
            detail = "Out of service needs a reason, in service has none."
            raise Problem("invalid", detail, "Send reason with in_service false only.", "reason")
        return reason


class StationPut(Strict):
    """Everything that a host or a person may write of a station. ``carrier`` empty: none, or not known. ``present`` null:
    nobody knows whether something stands there.
    """

    present: bool | None
    carrier: Id | Literal[""]
    reserved: Text
    out_of_service: Text
    by_person: bool = False


class StationPatch(Strict):
    """As above; a field that is left out stays."""

    present: bool | None = None
    carrier: Id | Literal[""] | None = None
    reserved: Text | None = None
    out_of_service: Text | None = None
    by_person: bool = False


class CarrierPut(Strict):
    """Where the carrier is: a station or a vehicle."""

    place: Id
    by_person: bool = False


def station_ids(names: list[str]) -> tuple[StationId, ...]:
    """Return names of stations as such."""
    return tuple(StationId(name) for name in names)
