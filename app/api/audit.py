"""The audit: who asked for what, and whether its rows are as they were written."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from starlette.responses import Response

from app.api.calls import Ctl, answer_of, items, read
from app.api.declared import gives
from app.api.inputs import TEXT_PATTERN, After, Limit
from app.api.periods import Begin, End, ordered
from app.runtime.showing import iso

router = APIRouter(prefix="/audit", tags=["audit"])
MOST_CHECKED = 100_000
"""Rows looked at by one call: about a second of a core. Our choice."""

Named = Annotated[str | None, Query(min_length=1, max_length=140, pattern=TEXT_PATTERN)]


@router.get("", **gives("Audit[]", description="Who asked for what."))
async def list_audit(
    controller: Ctl,
    after: After = 0,
    limit: Limit = 100,
    actor: Named = None,
    action: Named = None,
    target: Named = None,
    accepted: Annotated[bool | None, Query(description="Only what was carried out, or only what was refused.")] = None,
    begin: Begin = None,
    end: End = None,
    order: Annotated[Literal["oldest", "newest"], Query(description="Which come first.")] = "oldest",
) -> Response:
    """List what people and hosts asked for, refused or not: all oldest first, or what is looked for newest first."""
    ordered(begin, end)
    wanted = {
        "actor": actor,
        "action": action,
        "target": target,
        "accepted": accepted,
        "begin": begin.timestamp() if begin else None,
        "end": end.timestamp() if end else None,
    }
    if order == "newest" or any(value is not None for value in wanted.values()):
        rows = await read(controller.reader.audit_found, **wanted, before=after or None, limit=limit)
    else:
        rows = await read(controller.reader.audit, after, limit)
    last = rows[-1][0] if len(rows) == limit else None
    return items(
        (
            {
                "seq": seq,
                "at": iso(row.at),
                "actor": row.actor,
                "action": row.action,
                "target": row.target,
                "detail": row.detail,
                "accepted": row.accepted,
            }
            for seq, row in rows
        ),
        last,
    )


@router.get("/check", **gives("AuditCheck", description="The first row that was changed, if any was."))
async def check_audit(
    controller: Ctl,
    after: After = 0,
    limit: Annotated[int, Query(ge=1, le=MOST_CHECKED, description="At most this many rows.")] = MOST_CHECKED,
) -> Response:
    """Look whether each row of the audit follows from the one before it; go on with ``after`` = ``next``."""
    found = await read(controller.reader.audit_checked, after, limit)
    more = found.last if found.broken is None and found.rows == limit else None
    return answer_of(
        {
            "rows": found.rows,
            "last": found.last,
            "hash": found.hash,
            "broken": found.broken,
            "reason": found.reason,
            "next": more,
        }
    )
