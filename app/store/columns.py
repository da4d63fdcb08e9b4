"""What columns hold where Python holds something else: unsigned numbers, JSON."""

import json
from collections.abc import Mapping, Sequence
from typing import Any

import sqlalchemy as sa

from app.domain.ids import CmdId
from app.domain.lockout import Lockout

Row = tuple[str | int | float | bool | None, ...]
Found = sa.Row[Any]
"""A row as a query gives it."""

_TOP = 1 << 63
_WRAP = 1 << 64


def signed(cmd_id: int) -> int:
    """Return an unsigned 64-bit number as the database holds it."""
    return cmd_id - _WRAP if cmd_id >= _TOP else cmd_id


def unsigned(value: int) -> CmdId:
    """Undo :func:`signed`."""
    return CmdId(value + _WRAP if value < 0 else value)


def as_json(value: Mapping[str, object] | Sequence[object]) -> str:
    """Return compact JSON. Raises TypeError or ValueError for what JSON cannot say."""
    return json.dumps(value, separators=(",", ":"), allow_nan=False)


def as_names(value: tuple[str, ...]) -> str:
    """Return a list of names as JSON."""
    return as_json(value) if value else "[]"


def lockout_text(lockout: Lockout | None) -> str | None:
    """Return a lockout as JSON."""
    if lockout is None:
        return None
    return as_json(
        {"owner": lockout.owner, "reason": lockout.reason, "since": lockout.since, "releases": lockout.releases}
    )


def lockout_of(found: dict[str, Any] | None) -> Lockout | None:
    """Undo :func:`lockout_text`."""
    return None if found is None else Lockout(**{**found, "releases": tuple(found["releases"])})
