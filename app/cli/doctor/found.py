"""What the doctor finds."""

from dataclasses import dataclass
from enum import StrEnum


class Verdict(StrEnum):
    """``WRONG`` keeps a controller from running as it should."""

    WELL = "well"
    DOUBTFUL = "doubtful"
    WRONG = "wrong"


@dataclass(frozen=True, slots=True)
class Found:
    """One thing looked at: what it is, how it was found, and what would help."""

    what: str
    verdict: Verdict
    message: str
    remedy: str = ""


def well(what: str, message: str) -> Found:
    """Return that something is as it should be."""
    return Found(what, Verdict.WELL, message)


def doubtful(what: str, message: str, remedy: str) -> Found:
    """Return that a person should look at something."""
    return Found(what, Verdict.DOUBTFUL, message, remedy)


def wrong(what: str, message: str, remedy: str) -> Found:
    """Return that something keeps the controller from running."""
    return Found(what, Verdict.WRONG, message, remedy)
