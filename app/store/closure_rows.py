"""Closures to rows and back, as ``rows`` does for the other records."""

from app.domain.closures import ClosedPlace, Closure, ClosurePurpose, ClosureState, PlaceKind
from app.store.columns import Found, Row, as_names


def closure_row(closure: Closure) -> Row:
    """Columns of ``closures``."""
    return (
        closure.number,
        closure.place.kind.value,
        as_names(closure.place.names),
        as_names(closure.barcodes),
        closure.reason,
        closure.owner,
        closure.purpose.value,
        closure.since,
        closure.expires,
        closure.state.value,
        closure.closed,
        as_names(closure.releases),
        closure.ended,
        closure.ended_by,
    )


def closure(row: Found) -> Closure:
    """Undo :func:`closure_row`."""
    return Closure(
        number=row.number,
        place=ClosedPlace(PlaceKind(row.kind), tuple(row.names)),
        barcodes=tuple(row.barcodes),
        reason=row.reason,
        owner=row.owner,
        purpose=ClosurePurpose(row.purpose),
        since=row.since,
        expires=row.expires,
        state=ClosureState(row.state),
        closed=row.closed,
        releases=tuple(row.releases),
        ended=row.ended,
        ended_by=row.ended_by,
    )
