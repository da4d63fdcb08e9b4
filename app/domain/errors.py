"""Errors, split by whose fault it is. Each class has a stable ``code``; the API maps them in one table.

Faults of a peer's bytes are events (``app.domain.events``), never exceptions.
"""

from dataclasses import dataclass
from typing import ClassVar

from app.domain.units import Barcode


class HoistwayError(Exception):
    """Anything this product raises on purpose."""

    code: ClassVar[str] = "error"

    def __init__(self, message: str, *, remedy: str = "") -> None:
        super().__init__(message)
        self.message = message
        self.remedy = remedy


class EncodeError(HoistwayError):
    """We were asked to send something that the protocol cannot say."""

    code = "cannot-encode"


class PlantError(HoistwayError):
    """The plant file does not describe a plant."""

    code = "plant-file"


class NoRoute(HoistwayError):
    """No way leads from one place to the other; ``closed`` is the closed barcode or edge that is to blame, if one is."""

    code = "no-route"

    def __init__(
        self, message: str, *, remedy: str = "", closed: Barcode | tuple[Barcode, Barcode] | None = None
    ) -> None:
        super().__init__(message, remedy=remedy)
        self.closed = closed


class StoreError(HoistwayError):
    """The database cannot be used."""

    code = "store"


class StoreRefused(StoreError):
    """The database is there but cannot take what it was given: the same again cannot succeed."""

    code = "store-refused"


class PlantHeld(StoreError):
    """Another controller holds this plant; the message says who."""

    code = "plant-held"


@dataclass(frozen=True, slots=True)
class Refusal:
    """Why a request was not carried out, for a person or a host.

    ``code`` is one of ``not-found``, ``conflict``, ``not-now``, ``invalid``, ``no-route``, ``stale``; ``reason`` is one sentence;
    ``remedy`` says what would help and may be empty; ``field`` names the offending part of the request.
    """

    code: str
    reason: str
    remedy: str = ""
    field: str = ""
