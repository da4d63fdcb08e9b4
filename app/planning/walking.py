"""Routes as whole numbers, for a compiled simulation: at each fork, which barcode comes next toward a goal."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.domain.units import Barcode
from app.planning.compiled import NO_CUTS, Cuts, View
from app.planning.tables import Ints
from app.planning.track import Track


@dataclass(frozen=True, slots=True)
class Walk:
    """Next hops over a track by number: barcodes in the order of the track, goals in the order given.

    From barcode ``b`` toward goal ``g`` the next one is ``ahead[b]`` where there is no choice, and
    ``turn[column[g], fork[b]]`` where ``fork[b]`` is not -1; -1 in either: no way. Goals on one stretch of track without
    merges or forks share a column. ``turn`` takes 4 bytes for each fork and column.
    """

    ahead: Ints
    fork: Ints
    column: Ints
    turn: Ints


def walking(track: Track, view: View, goals: Sequence[Barcode], cuts: Cuts = NO_CUTS) -> Walk:
    """Return the next hops of a view toward these goals. Takes about 10 µs a column and 600 forks; not for the event loop."""
    number = {barcode: place for place, barcode in enumerate(track.barcodes)}
    forks = view.arcs.forks
    alone = [track.successors(b) if b not in forks else () for b in track.barcodes]
    turns = _turns(view, number)
    columns: dict[tuple[tuple[int, int], ...], int] = {}
    rows: list[Ints] = []
    column = []
    for goal in goals:
        entries = list(view.entries(goal, cuts).items())
        key = (
            tuple((arc, index - entries[0][1]) for arc, index in entries) if goal not in forks else ((forks[goal], -1),)
        )
        if key not in columns:
            columns[key] = len(rows)
            rows.append(_toward(view, goal, entries, turns, number))
        column.append(columns[key])
    return Walk(
        ahead=np.array([number[after[0]] if after else -1 for after in alone], dtype=np.int32),
        fork=np.array([forks.get(barcode, -1) for barcode in track.barcodes], dtype=np.int32),
        column=np.array(column, dtype=np.int32),
        turn=np.array(rows, dtype=np.int32).reshape(len(rows), view.arcs.plan.size),
    )


def _turns(view: View, number: dict[Barcode, int]) -> Ints:
    """Return the barcode that comes next from each fork (row) toward each fork (column)."""
    parts, plan, paths = view.tables.parts.tolist(), view.arcs.plan, view.arcs.paths
    first = np.full(len(parts), -1, dtype=np.int32)
    for pair in range(len(parts)):
        one, other = parts[pair]
        while other >= 0:
            one, other = parts[one]
        if one >= 0:
            first[pair] = number[paths[one][1]]
    if not len(parts):
        return np.full((plan.size, plan.size), -1, dtype=np.int32)
    last = len(parts) - 1
    pairs = np.minimum(plan.first[:-1, None] + view.tables.hop, last)
    turns: Ints = np.where(view.tables.seconds < np.inf, first[pairs], -1).astype(np.int32)
    return turns


def _toward(
    view: View, goal: Barcode, entries: Sequence[tuple[int, int]], turns: Ints, number: dict[Barcode, int]
) -> Ints:
    if (fork := view.arcs.forks.get(goal)) is not None:
        return turns[:, fork]
    if not entries:
        return np.full(view.arcs.plan.size, -1, dtype=np.int32)
    tails = [view.arcs.tails[arc] for arc, _ in entries]
    more = np.array([view.time_along(arc, 0, index) for arc, index in entries])
    best: NDArray[np.intp] = (view.tables.seconds[:, np.array(tails)] + more).argmin(axis=1)
    row: Ints = turns[np.arange(len(best)), np.array(tails)[best]]
    for entry, (arc, _) in enumerate(entries):
        if best[tails[entry]] == entry:
            row[tails[entry]] = number[view.arcs.paths[arc][1]]
    return row
