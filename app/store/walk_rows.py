"""Audit walks to rows and back, as ``rows`` does for the other records."""

from collections.abc import Callable
from operator import attrgetter

from app.domain.walks import Finding, Walk, WalkPlace, WalkState
from app.store.columns import Found, Row


def walk_row(walk: Walk) -> Row:
    """Columns of ``walks``."""
    return (walk.number, walk.actor, walk.reason, walk.started, walk.state.value, walk.ended, walk.ended_by)


def walk(row: Found) -> Walk:
    """Undo :func:`walk_row`."""
    state = WalkState(row.state)
    return Walk(row.number, row.actor, row.reason, row.started, state, row.ended, row.ended_by)


_PLACE = ("walk", "station", "believed", "believed_carrier", "seen", "seen_carrier", "by", "at")
_entered: Callable[[WalkPlace], Row] = attrgetter(*_PLACE)


def walk_place_row(place: WalkPlace) -> Row:
    """Columns of ``walk_places``."""
    return (*_entered(place), place.accepted.value if place.accepted else None)


def walk_place(row: Found) -> WalkPlace:
    """Undo :func:`walk_place_row`."""
    accepted = Finding(row.accepted) if row.accepted else None
    return WalkPlace(**{name: getattr(row, name) for name in _PLACE}, accepted=accepted)
