"""Routes over the track, in microseconds: a compiled view of it, and the closures and weights of now around that."""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise
from math import inf

import numpy as np

from app.domain.errors import NoRoute
from app.domain.units import Barcode, Seconds
from app.planning.alternatives import by_present, by_table, drawn, search, ways
from app.planning.arcs import EdgeKey, contract
from app.planning.compiled import NO_CUTS, Cuts, View, is_open
from app.planning.reach import Reach
from app.planning.tables import Floats, Tables, Task, compute
from app.planning.track import Track

INLINE_FORKS = 300
"""Our choice: up to so many forks tables are computed at once where they are wanted, in less than 5 ms of CPU."""
LONGEST = Seconds(600.0)
"""Our choice: no weight makes an edge take longer: a jam is slow track, never a closure, however long it was watched."""


@dataclass(frozen=True, slots=True)
class Route:
    """A way with its expected duration: at the present weights, and on an empty track; by which version of the view."""

    barcodes: tuple[Barcode, ...]
    seconds: Seconds
    free_flow: Seconds
    version: int


@dataclass(frozen=True, slots=True)
class _Asked:
    """What tables were asked for: they are of use only together with this."""

    version: int
    seconds: Floats
    shut: Cuts


class Router:
    """Quickest routes over a track, around what is closed; an edge takes its ``time`` in ``track.graph``, or more.

    With more than ``inline`` forks a change of closures or weights makes a new ``version`` that is only *wanted*: ``replan``
    gives a task, to be computed elsewhere, and ``adopt`` takes what came of it. Until then routes follow the old times, but
    no route ever leads over what is closed: where the old table would, the way round is searched for, which takes about
    1 ms at 3,000 forks. ``times`` stay those of the old version until then, except at the ends.
    """

    def __init__(self, track: Track, inline: int = INLINE_FORKS) -> None:
        self._track = track
        self._arcs = contract(track)
        self._free: Floats = np.array([track.graph.edges[edge]["time"] for edge in self._arcs.edges], dtype=np.float64)
        self._most: Floats = np.maximum(LONGEST, self._free)
        self._seconds = self._free
        self._closed: dict[Barcode | EdgeKey, None] = {}
        self._cuts: Cuts = {}
        self._inline = self._arcs.plan.size <= inline
        self._version = 1
        self._asked: _Asked | None = None
        self._stale = False
        self._shown = self._view(self._ask())
        self._newly_open = self._newly_shut = False

    # -- what is closed, what takes how long -------------------------------------------------------------------------------

    @property
    def closed(self) -> tuple[Barcode | EdgeKey, ...]:
        """The closed barcodes and edges, in the order of closing."""
        return tuple(self._closed)

    @property
    def version(self) -> int:
        """The version that routes are planned by; rises."""
        return self.view.version

    @property
    def newly_open(self) -> bool:
        """Whether track is open again that the tables do not lead over yet: ``time`` may be infinite where there is a way."""
        return self._newly_open

    @property
    def view(self) -> View:
        """What routes are planned by: fixed, to be held as long as one likes."""
        if self._stale:
            self._stale = False
            self._shown = self._view(self._ask())
        return self._shown

    def close(self, *places: Barcode | EdgeKey) -> None:
        """Let no route lead over these barcodes, nor to them, nor over these edges. A route may start at a closed barcode."""
        self._closed.update(dict.fromkeys(places))
        self._recut()

    def open(self, *places: Barcode | EdgeKey) -> None:
        """End the closure of these."""
        for place in places:
            self._closed.pop(place, None)
        self._recut()

    def slow(self, factors: Floats) -> None:
        """Let each edge, by its number in ``edges``, take so many times as long as on an empty track from now on; at least once.

        Nor more than ``LONGEST``, unless the empty track takes more; what is no number counts as the empty track.
        """
        values: Floats = np.fmax(factors, 1.0)
        values *= self._free
        np.minimum(values, self._most, out=values)
        if not np.array_equal(values, self._seconds):
            self._seconds = values
            self._change()

    @property
    def edges(self) -> Mapping[EdgeKey, int]:
        """The number of each edge, for ``seconds``."""
        return self._arcs.edges

    @property
    def seconds(self) -> Floats:
        """The seconds that each edge takes by the newest weights, by its number. Not to be changed; a new array each time."""
        return self._seconds

    # -- new versions --------------------------------------------------------------------------------------------------------

    def replan(self) -> Task | None:
        """Return the task of computing the newest version, once; None if it is being computed, or is there."""
        if self._inline or self._asked is not None or self._shown.version == self._version:
            return None
        return self._ask()

    def adopt(self, tables: Tables) -> bool:
        """Plan by these tables from now on; False if they are not those that were asked for last.

        If a newer version is wanted meanwhile, ``replan`` asks for it then.
        """
        if self._asked is None or tables.version != self._asked.version:
            return False
        self._shown = self._view(tables)
        self._compare()
        return True

    def _ask(self) -> Task:
        self._asked = _Asked(self._version, self._seconds, self._cuts)
        return Task(self._version, self._arcs.plan, self._seconds, tuple(self._cuts))

    def _view(self, result: Task | Tables) -> View:
        asked = self._asked
        assert asked is not None
        self._asked = None
        tables = compute(result) if isinstance(result, Task) else result
        return View(self._arcs, asked.seconds, asked.shut, tables)

    def _recut(self) -> None:
        cuts: dict[int, list[int]] = {}
        for place in self._closed:
            for edge in self._edges_of(place):
                for arc, index in self._arcs.on(edge):
                    cuts.setdefault(arc, []).append(index)
        if cuts != self._cuts:
            self._cuts = cuts
            self._change()

    def _edges_of(self, place: Barcode | EdgeKey) -> Iterable[EdgeKey]:
        if isinstance(place, tuple):
            return (place,)
        return ((before, place) for before in self._track.predecessors(place)) if place in self._track else ()

    def _change(self) -> None:
        self._version += 1
        if self._inline:
            self._stale = True
        else:
            self._compare()

    def _compare(self) -> None:
        """See whether the view that is shown may lead over closed track, or not see track that is open again."""
        self._newly_shut = any(arc not in self._shown.shut for arc in self._cuts)
        self._newly_open = any(arc not in self._cuts for arc in self._shown.shut)

    # -- routes --------------------------------------------------------------------------------------------------------------

    def route(self, start: Barcode, goal: Barcode) -> list[Barcode]:
        """Return the barcodes of a quickest route, start and goal included; just one if they are the same.

        The list is the caller's own; a tuple made of it would cost a quarter more.
        Raises NoRoute: neither the layout nor, with the present closures, the open track connects them.
        """
        if start == goal and start in self._track:
            return [start]
        path = (self.view if self._stale else self._shown).path(start, goal, self._cuts)
        if path is None:
            path = self._search(start, goal, self._cuts) if self._newly_open else None
        elif self._newly_shut and any(map(self._is_closed, path, path[1:])):
            path = self._search(start, goal, self._cuts)
        if path is None:
            raise self._no_route(start, goal)
        return path

    def alternatives(self, start: Barcode, goal: Barcode, most: int) -> list[Route]:
        """Return the ``most`` quickest routes that pass no barcode twice, quickest first; fewer if there are no more.

        Exact (Yen's algorithm between forks), by the version that is shown. Raises NoRoute as ``route`` does.
        """
        first = self.route(start, goal)
        fork, _ = self.view.leave(start, self._cuts)
        if self.view.stretch(start, goal) or start == goal or self._arcs.forks.get(goal) == fork:
            return [self._timed(first)][:most]
        differs = self._newly_open or self._newly_shut
        search = (by_present if differs else by_table)(self.view, goal, self._cuts)
        before = self._before(start)
        found = [self._timed((*before, *drawn(search, way))) for _, way in islice(ways(search, fork), most)]
        return sorted(found, key=lambda route: route.seconds)

    def time(self, start: Barcode, goal: Barcode) -> float:
        """Return the seconds of the quickest route; infinite if there is none."""
        if start == goal:
            return 0.0 if start in self._track else inf
        return self.view.time(start, goal, self._cuts)

    def along(self, way: Sequence[Barcode]) -> float:
        """Return the seconds of this way by the weights that ``time`` goes by, whatever is closed on it."""
        edges = self._arcs.edges
        return float(self.view.seconds[[edges[edge] for edge in pairwise(way)]].sum())

    def times(self, starts: Sequence[Barcode], goals: Sequence[Barcode]) -> list[list[float]]:
        """Return a row for each start with the time to each goal, in seconds, infinite if there is no route."""
        times: list[list[float]] = self.table(starts, goals).tolist()
        return times

    def table(self, starts: Sequence[Barcode], goals: Sequence[Barcode]) -> Floats:
        """Return what ``times`` does, as an array."""
        return self.view.times(starts, goals, self._cuts)

    def reach(self, starts: Iterable[Barcode], *, anyway: bool = False) -> Reach:
        """Return where an open way leads now from any of the starts; ``anyway``: whatever is closed."""
        return Reach(self._arcs, NO_CUTS if anyway else self._cuts, starts)

    def _timed(self, path: Sequence[Barcode]) -> Route:
        view = self.view
        passed = [self._arcs.edges[edge] for edge in pairwise(path)]
        seconds, free = view.seconds[passed].sum(), self._free[passed].sum()
        return Route(tuple(path), Seconds(float(seconds)), Seconds(float(free)), view.version)

    def _before(self, start: Barcode) -> tuple[Barcode, ...]:
        """Return the barcodes from here to the first fork of any route, both included."""
        for arc, index in self._arcs.spots.get(start, ())[:1]:
            return self._arcs.paths[arc][index:]
        return (start,)

    def _search(self, start: Barcode, goal: Barcode, cuts: Cuts) -> list[Barcode] | None:
        """Return a quickest way by search: with the times that are shown, and these closures."""
        view = self.view
        if (direct := view.stretch(start, goal)) is not None:
            arc, index, place = direct
            return list(self._arcs.paths[arc][index : place + 1]) if is_open(cuts, *direct) else None
        fork, rest = view.leave(start, cuts)
        if rest == inf:
            return None
        sought = by_present(view, goal, cuts)
        found = (0.0, ()) if sought.fork == fork else search(sought, fork)
        return None if found is None else [*self._before(start), *drawn(sought, found[1])]

    # -- why there is none ---------------------------------------------------------------------------------------------------

    def _no_route(self, start: Barcode, goal: Barcode) -> NoRoute:
        for barcode in (start, goal):
            if barcode not in self._track:
                return NoRoute(f"no route from {start} to {goal}: {barcode} is not on the track")
        path = self._search(start, goal, NO_CUTS)
        if path is None:
            return NoRoute(f"no route from {start} to {goal}: the track does not connect them")
        at = next((b if b in self._closed else (a, b)) for a, b in pairwise(path) if self._is_closed(a, b))
        shut = f"{at[0]} to {at[1]}" if isinstance(at, tuple) else at
        return NoRoute(f"no route from {start} to {goal}: {shut} is closed", remedy=f"open {shut}", closed=at)

    def _is_closed(self, start: Barcode, end: Barcode) -> bool:
        return end in self._closed or (start, end) in self._closed
