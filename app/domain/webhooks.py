"""Webhooks: who is told of events by HTTP, how far they have been told, and what may be asked about it (DOMAIN section 8)."""

from dataclasses import dataclass, field
from enum import StrEnum

from app.domain.ids import Actor
from app.domain.units import Timestamp

TRIES_KEPT = 200
"""Deliveries that the log of each webhook has, the newest. Our choice."""


class WebhookState(StrEnum):
    """``paused`` by a person; ``failed`` after days of failure: both go on where they were when they are made active again."""

    ACTIVE = "active"
    PAUSED = "paused"
    FAILED = "failed"
    REMOVED = "removed"


@dataclass(frozen=True, slots=True)
class Webhook:
    """A subscription. ``events`` are the names wanted, none: all. ``secret`` signs, ``old_secret`` beside it until ``old_until``.

    ``replays`` counts how often somebody set the position: what was sent before counts no more then. ``reason``: why it failed.
    """

    number: int
    url: str
    events: tuple[str, ...]
    secret: str = field(repr=False)
    actor: Actor
    created: Timestamp
    note: str = ""
    state: WebhookState = WebhookState.ACTIVE
    reason: str = ""
    replays: int = 0
    old_secret: str = field(default="", repr=False)
    old_until: Timestamp | None = None

    @property
    def name(self) -> str:
        """What people call it."""
        return f"webhook {self.number}"

    def wants(self, event: str) -> bool:
        """Whether it is told of events of that name."""
        return not self.events or event in self.events


@dataclass(frozen=True, slots=True)
class WebhookProgress:
    """How far a webhook has been told: every event up to ``position`` is delivered, or not wanted.

    ``tries`` counts deliveries tried, ``delivered`` those that were taken; ``failing`` is since when the present one is not,
    ``error`` why; ``attempts`` how often it has been tried.
    """

    webhook: int
    position: int
    replays: int = 0
    tries: int = 0
    delivered: int = 0
    last: Timestamp | None = None
    failing: Timestamp | None = None
    attempts: int = 0
    error: str = ""


@dataclass(frozen=True, slots=True)
class WebhookTry:
    """One delivery that was tried: a row of the log, which has ``TRIES_KEPT`` of each webhook.

    ``seq`` is the event's number, None for a ping; ``status`` the answer's, None if there was none; ``error`` why it does not
    count as taken, empty if it does. ``number`` counts from 1 for each webhook.
    """

    webhook: int
    number: int
    at: Timestamp
    seq: int | None
    event: str
    attempt: int
    status: int | None
    seconds: float
    error: str


@dataclass(frozen=True, slots=True)
class AddWebhook:
    """Subscribe. ``after``: events above this number, None: from the next on."""

    actor: Actor
    url: str
    events: tuple[str, ...]
    secret: str = field(repr=False)
    note: str = ""
    after: int | None = None


@dataclass(frozen=True, slots=True)
class ChangeWebhook:
    """Change what is not None; ``active`` pauses, or takes up again, also what failed."""

    actor: Actor
    webhook: int
    url: str | None = None
    events: tuple[str, ...] | None = None
    active: bool | None = None
    note: str | None = None


@dataclass(frozen=True, slots=True)
class RemoveWebhook:
    """Tell it nothing more, for ever."""

    actor: Actor
    webhook: int


@dataclass(frozen=True, slots=True)
class RenewWebhookSecret:
    """Sign with another secret; the old one signs beside it for ``overlap`` seconds."""

    actor: Actor
    webhook: int
    secret: str = field(repr=False)
    overlap: float


@dataclass(frozen=True, slots=True)
class ReplayWebhook:
    """Tell it all events above a number (again)."""

    actor: Actor
    webhook: int
    after: int


WebhookRequest = AddWebhook | ChangeWebhook | RemoveWebhook | RenewWebhookSecret | ReplayWebhook
