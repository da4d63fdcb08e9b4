"""What rows are made of."""

import json
from typing import Any

import sqlalchemy as sa

from app.domain.lockout import Lockout

Row = tuple[str | int | float | bool | None, ...]
Found = sa.Row[Any]
"""A row as a query gives it."""


def text_of(value: object) -> str:
    """Return compact JSON. Raises TypeError or ValueError for what JSON cannot say."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False)


def lockout_text(lockout: Lockout | None) -> str | None:
    """Return a lockout as JSON."""
    if lockout is None:
        return None
    return text_of(
        {"owner": lockout.owner, "reason": lockout.reason, "since": lockout.since, "releases": lockout.releases}
    )


def lockout_of(found: dict[str, Any] | None) -> Lockout | None:
    """Undo :func:`lockout_text`."""
    return None if found is None else Lockout(**{**found, "releases": tuple(found["releases"])})
