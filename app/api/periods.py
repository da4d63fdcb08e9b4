"""Periods in queries: from, to, both ISO 8601 with a zone."""

from dataclasses import dataclass
from typing import Annotated
from zoneinfo import ZoneInfo, ZoneInfoNotFoundError, available_timezones

from fastapi import Query
from pydantic import AwareDatetime

from app.api.inputs import Moment
from app.api.problems import Problem
from app.domain.units import Timestamp

Zone = Annotated[
    str | None,
    Query(
        alias="tz", max_length=64, description="Zone of the moments shown, such as Asia/Seoul; by default the server's."
    ),
]
Begin = Annotated[Moment | None, Query(alias="from", description="First moment; ISO 8601 with a zone.")]
End = Annotated[Moment | None, Query(alias="to", description="Where it ends; by default now.")]
DAY = 86_400.0
LONGEST = 400 * DAY
"""Our choice."""


@dataclass(frozen=True, slots=True)
class Period:
    """Two moments in UTC seconds; the second is not part of it."""

    begin: float
    end: float

    @property
    def seconds(self) -> float:
        """How long it is."""
        return self.end - self.begin


def ordered(begin: AwareDatetime | None, end: AwareDatetime | None) -> None:
    """Look whether the first moment is the earlier one, if both are said. Raises Problem."""
    if begin is not None and end is not None and begin >= end:
        raise Problem("invalid", "from does not lie before to.", "Exchange them.", "from")


def period(begin: AwareDatetime | None, end: AwareDatetime | None, now: Timestamp, usual: float = 7 * DAY) -> Period:
    """Return what is asked about; without a begin so many seconds until its end. Raises Problem: it is none, or too long."""
    ordered(begin, end)
    last = now if end is None else end.timestamp()
    first = last - usual if begin is None else begin.timestamp()
    if first >= last and end is None:
        raise Problem("invalid", "from lies in the future.", "It is a period up to now, unless to is said.", "from")
    if first >= last:
        raise Problem("invalid", "from does not lie before to.", "Say both, or neither.", "from")
    if last - first > LONGEST:
        raise Problem("invalid", f"At most {LONGEST / DAY:.0f} days at a time.", "Ask for less.", "from")
    return Period(first, last)


def zone_of(name: str | None) -> ZoneInfo | None:
    """Return a time zone by its name in the IANA database; None: no name, so that of this machine. Raises Problem: there is none.

    Windows, and some containers, have no such database: there the package tzdata brings it.
    """
    if name is None:
        return None
    try:
        return ZoneInfo(name)
    except (ValueError, OSError, ZoneInfoNotFoundError):
        pass
    if not available_timezones():
        remedy = "pip install tzdata, or leave tz out."
        raise Problem("not-now", "This machine has no time zones.", remedy, "tz")
    raise Problem("invalid", f"There is no time zone {name!r}.", "Such as Asia/Seoul, Europe/Berlin or UTC.", "tz")
