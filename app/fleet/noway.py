"""Why no way leads from one place to another just now: asked again and again, answered from memory until something changes."""

from math import inf

from app.domain.errors import NoRoute
from app.domain.units import Barcode
from app.fleet.closed import Closed
from app.planning.routing import Router
from app.planning.track import Track


class NoWay:
    """Missing ways, in words. Only closures are thought of: what the track does not connect is refused where it is ordered."""

    def __init__(self, track: Track, router: Router, closed: Closed) -> None:
        self._track = track
        self._router = router
        self._closed = closed
        self._causes: dict[Barcode, str] = {}
        self._found: dict[tuple[Barcode, Barcode], bool] = {}
        self._seen = -1

    def why(self, start: Barcode, goal: Barcode) -> str:
        """Return why no way leads there because of what is closed now, empty if one does."""
        if not len(self._closed) or self._router.time(start, goal) < inf:
            return ""
        cause = self.cause(goal)
        if not cause or (self._router.newly_open and self._leads(start, goal)):
            return ""
        return f"no way leads from {start} to {goal}: {cause}"

    def cause(self, goal: Barcode) -> str:
        """Return the closed place that is met first going back from a place that cannot be reached, and why it is closed.

        Empty if none is.
        """
        if self._closed.edition != self._seen:
            self._seen, self._causes, self._found = self._closed.edition, {}, {}
        if (known := self._causes.get(goal)) is None:
            known = self._causes[goal] = self._sought(goal)
        return known

    def _sought(self, goal: Barcode) -> str:
        closed, seen, queue = self._closed, {goal}, [goal]
        for here in queue:
            if here in closed:
                return closed.told(here)
            for before in self._track.predecessors(here):
                if (before, here) in closed:
                    return closed.told((before, here))
                if before not in seen:
                    seen.add(before)
                    queue.append(before)
        return ""

    def _leads(self, start: Barcode, goal: Barcode) -> bool:
        """Whether there is a way that the tables do not know yet."""
        if (known := self._found.get((start, goal))) is None:
            try:
                known = bool(self._router.route(start, goal))
            except NoRoute:
                known = False
            self._found[start, goal] = known
        return known
