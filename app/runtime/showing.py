"""How the objects of the read model look as JSON: times in ISO 8601 UTC, everything else as it is."""

import dataclasses
from collections.abc import Callable
from datetime import UTC, datetime
from functools import lru_cache
from math import floor
from operator import attrgetter
from typing import get_args

import msgspec

from app.domain.view import EventView, HoldView, LinkView, LockoutView, LockView, PauseView, PinView, View

_AT = ("at", "since", "seen", "created", "assigned", "picked", "ended", "started", "opened", "closed")
TIMES = frozenset((*_AT, "expires", "begun", "acknowledged"))
"""Names of the fields that are moments, in every view."""

RENAMED: dict[tuple[type, str], str] = {(EventView, "at"): "ts"}
"""DOMAIN section 2 gives an event's moment its own name."""

encode = msgspec.json.Encoder().encode


def iso(moment: float) -> str:
    """Return a moment in UTC seconds as ISO 8601 with milliseconds, such as ``2026-07-01T08:30:00.250Z``."""
    second = floor(moment)
    more, microsecond = divmod(round((moment - second) * 1_000_000), 1_000_000)
    return f"{_second(second + more)}.{microsecond // 1000:03d}Z"


@lru_cache(maxsize=256)
def _second(moment: int) -> str:
    """Return a whole second; what is shown together is mostly of a few."""
    return datetime.fromtimestamp(moment, UTC).strftime("%Y-%m-%dT%H:%M:%S")


def shown(view: object) -> dict[str, object]:
    """Return any view, or a part of one, as a mapping that encodes to JSON."""
    return _SHOWERS[type(view)](view)


def encoded(view: View) -> bytes:
    """Return a view as JSON."""
    return encode(shown(view))


def _shower(kind: type) -> Callable[[object], dict[str, object]]:
    fields = [f.name for f in dataclasses.fields(kind)]
    labels = [RENAMED.get((kind, n), n) for n in fields]
    values = attrgetter(*fields)
    moments = [RENAMED.get((kind, n), n) for n in fields if n in TIMES]
    nested = [n for n in fields if n in _NESTED]
    listed = [n for n in fields if n in _LISTED]

    def show(view: object) -> dict[str, object]:
        out: dict[str, object] = dict(zip(labels, values(view), strict=True))
        for label in moments:
            if (moment := out[label]) is not None:
                out[label] = iso(moment)  # type: ignore[arg-type]
        for name in nested:
            if type(out[name]) in _SHOWERS:
                out[name] = shown(out[name])
        for name in listed:
            out[name] = [shown(part) for part in getattr(view, name)]
        return out

    return show


_NESTED = frozenset({"link", "hold", "lockout", "pin", "lock"})
_LISTED = frozenset({"pauses"})
"""Parts that are lists of views with moments of their own."""
_SHOWERS: dict[type, Callable[[object], dict[str, object]]] = {
    kind: _shower(kind) for kind in (*get_args(View), LinkView, HoldView, LockoutView, PinView, LockView, PauseView)
}
