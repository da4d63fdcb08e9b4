"""Tells webhooks of events: from the durable events themselves, in order, each until it is taken (``docs/webhooks.md``)."""

from app.runtime.webhooks.courier import Courier, Pace
from app.runtime.webhooks.sending import Answer, Post, Sender, Unreachable
from app.runtime.webhooks.signing import drawn_secret, signature
from app.runtime.webhooks.targets import Targets, TargetsError

__all__ = [
    "Answer",
    "Courier",
    "Pace",
    "Post",
    "Sender",
    "Targets",
    "TargetsError",
    "Unreachable",
    "drawn_secret",
    "signature",
]
