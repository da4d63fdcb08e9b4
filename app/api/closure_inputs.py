"""Bodies about closures."""

from datetime import timedelta
from typing import Annotated, Literal

from pydantic import Field

from app.api.inputs import Id, Moment, Reason, Strict, Text
from app.api.problems import Problem
from app.domain.closures import ClosedPlace, ClosePlace, ClosurePurpose, PlaceKind
from app.domain.ids import Actor
from app.domain.units import Timestamp

LONGEST = timedelta(days=366)
"""Our choice."""


class BarcodesIn(Strict):
    """One or more barcodes: nobody comes to them."""

    kind: Literal["barcode"]
    barcodes: Annotated[list[Id], Field(min_length=1, max_length=1000)]

    def place(self) -> ClosedPlace:
        """Return it in the words of the business."""
        return ClosedPlace(PlaceKind.BARCODE, tuple(self.barcodes))


class EdgeIn(Strict):
    """The piece of track from one barcode to the next: nobody drives there; both barcodes stay in use."""

    kind: Literal["edge"]
    start: Id = Field(alias="from")
    end: Id = Field(alias="to")

    def place(self) -> ClosedPlace:
        """Return it in the words of the business."""
        return ClosedPlace(PlaceKind.EDGE, (self.start, self.end))


class StretchIn(Strict):
    """The shortest way between two barcodes, both included."""

    kind: Literal["stretch"]
    start: Id = Field(alias="from")
    end: Id = Field(alias="to")

    def place(self) -> ClosedPlace:
        """Return it in the words of the business."""
        return ClosedPlace(PlaceKind.STRETCH, (self.start, self.end))


class ZoneIn(Strict):
    """All barcodes of a zone of the plant."""

    kind: Literal["zone"]
    zone: Id

    def place(self) -> ClosedPlace:
        """Return it in the words of the business."""
        return ClosedPlace(PlaceKind.ZONE, (self.zone,))


class StationIn(Strict):
    """A station: nothing is picked up or put down there; the rail stays in use."""

    kind: Literal["station"]
    station: Id

    def place(self) -> ClosedPlace:
        """Return it in the words of the business."""
        return ClosedPlace(PlaceKind.STATION, (self.station,))


PlaceIn = Annotated[BarcodesIn | EdgeIn | StretchIn | ZoneIn | StationIn, Field(discriminator="kind")]


class PreviewIn(Strict):
    """What would be closed."""

    place: PlaceIn


class ClosureIn(Strict):
    """What is closed, and why. ``purpose`` work: people are there; it never expires, and only its owner opens it, or two others.

    A traffic closure may end by itself: at ``expires``, or after so many ``minutes``.
    """

    place: PlaceIn
    reason: Reason
    purpose: Literal["traffic", "work"] = "traffic"
    expires: Moment | None = None
    minutes: Annotated[int, Field(ge=1, le=527_040)] | None = None

    def asked(self, actor: Actor, now: Timestamp) -> ClosePlace:
        """Return it in the words of the business. Raises Problem: the end is said twice, or is too far away."""
        if self.expires is not None and self.minutes is not None:
            raise Problem("invalid", "The end is said twice.", "Send expires or minutes.", "minutes")
        end = None if self.expires is None else Timestamp(self.expires.timestamp())
        if self.minutes is not None:
            end = Timestamp(now + 60.0 * self.minutes)
        if end is not None and end - now > LONGEST.total_seconds():
            raise Problem("invalid", "A closure ends within a year.", "Leave expires out to close for good.", "expires")
        return ClosePlace(actor, self.place.place(), self.reason, ClosurePurpose(self.purpose), end)


class OpenIn(Strict):
    """Why it is opened; may be empty."""

    reason: Text = ""
