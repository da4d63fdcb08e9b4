"""Versions of the plant: what was staged, by whom and why, which one runs, and which ran before."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum
from hashlib import sha256

from app.domain.ids import Actor
from app.domain.units import Timestamp


class VersionState(StrEnum):
    """Where a version is on its way. One is ``active`` at any time, at most one ``awaited``."""

    STAGED = "staged"
    """Taken in; it never ran."""
    AWAITED = "awaited"
    """It is to become the active one, as soon as nothing stands in its way."""
    ACTIVE = "active"
    FORMER = "former"
    """It ran; to activate it again is to roll back."""
    REJECTED = "rejected"
    """A person does not want it, or the controller could not begin with it."""


class Origin(StrEnum):
    """Where a version came from."""

    FILE = "file"
    """The plant file that the controller was started with, or read again on SIGHUP."""
    UPLOAD = "upload"


@dataclass(frozen=True, slots=True)
class PlantVersion:
    """A version of the plant file; its text is kept beside it, with the catalogues of its drives. Numbers rise from 1.

    ``digest`` tells it from others, ``models`` has the digests of its catalogues.
    ``reason`` is why it was staged, ``why`` why it was activated last; ``before`` the version that was active until then.
    ``ran`` is when a controller first ran with it; ``tries`` how many starts with it were begun since it became active while none
    of them came to run (None: one did), which says after a crash too that the way back is still open.
    ``rejected`` is when it was, ``pruned`` when its text was thrown away. ``asked``, ``asked_by`` and ``asked_why`` say who wants
    it active while it is awaited; ``patient``: also if something stands in its way now. ``note`` is what became of the last wish
    that came to nothing.
    """

    number: int
    digest: str
    state: VersionState
    origin: Origin
    at: Timestamp
    actor: Actor
    reason: str
    size: int
    activated: Timestamp | None = None
    activated_by: Actor | None = None
    why: str = ""
    before: int | None = None
    asked: Timestamp | None = None
    asked_by: Actor | None = None
    asked_why: str = ""
    patient: bool = False
    note: str = ""
    ran: Timestamp | None = None
    tries: int | None = None
    models: Mapping[str, str] = field(default_factory=dict)
    rejected: Timestamp | None = None
    pruned: Timestamp | None = None

    @property
    def at_rest(self) -> VersionState:
        """Its state when a wish to activate it comes to nothing, or another takes its place."""
        return VersionState.STAGED if self.ran is None else VersionState.FORMER


@dataclass(frozen=True, slots=True)
class Source:
    """What a version is made of: the text of a plant file, and the catalogues of its drives by model (None: those found)."""

    text: str
    catalogues: Mapping[str, str] | None = None

    @property
    def digest(self) -> str:
        """What tells it from another, catalogues included."""
        models = sorted(self.models.items())
        return digest_of(self.text) if not models else digest_of("\n".join([digest_of(self.text), *map(str, models)]))

    @property
    def models(self) -> dict[str, str]:
        """The digests of the catalogues, by model."""
        return {model: digest_of(text) for model, text in (self.catalogues or {}).items()}


@dataclass(frozen=True, slots=True)
class Leaving:
    """What a version that is awaited has no place for: no new job may need it, or the wait would never end.

    ``gone`` are stations and vehicles that it does not have, ``cut_off`` stations that no way leads to any more.
    """

    version: int
    gone: frozenset[str]
    cut_off: frozenset[str]


def digest_of(text: str) -> str:
    """Return what tells one text from another: SHA-256, in hex."""
    return sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
