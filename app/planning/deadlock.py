"""Finds who waits for whom in a circle."""

from collections import defaultdict
from collections.abc import Mapping
from itertools import chain
from typing import TypeAlias

import networkx as nx

from app.domain.ids import VehicleId

Needs: TypeAlias = list[list[VehicleId]]
"""What one vehicle waits for: from *each* group *one* vehicle must go first."""


def deadlocks(needs: Mapping[VehicleId, Needs]) -> tuple[tuple[VehicleId, ...], ...]:
    """Return one cycle for each knot of vehicles that can only wait for each other, starting with its smallest id.

    A vehicle without needs, or not named, can go on.
    """
    stuck = _stuck(needs)
    waits = {v: [other for other in chain(*groups) if other in stuck] for v, groups in stuck.items()}
    graph = nx.DiGraph([(v, other) for v, others in waits.items() for other in others])
    knots = [knot for knot in nx.strongly_connected_components(graph) if len(knot) > 1]
    return tuple(sorted(_cycle({v: [o for o in waits[v] if o in knot] for v in knot}) for knot in knots))


def _stuck(needs: Mapping[VehicleId, Needs]) -> dict[VehicleId, Needs]:
    """Return the needs that stay unmet when everyone who can go on has gone."""
    stuck = {vehicle: groups for vehicle, groups in needs.items() if groups}
    waiting: defaultdict[VehicleId, list[VehicleId]] = defaultdict(list)
    for vehicle, groups in stuck.items():
        for other in chain(*groups):
            waiting[other].append(vehicle)
    going = [vehicle for vehicle in waiting if vehicle not in stuck]
    while going:
        for vehicle in waiting.get(going.pop(), ()):
            if vehicle in stuck and all(any(o not in stuck for o in group) for group in stuck[vehicle]):
                del stuck[vehicle]
                going.append(vehicle)
    return stuck


def _cycle(waits: Mapping[VehicleId, list[VehicleId]]) -> tuple[VehicleId, ...]:
    """Follow the first wait of each, from the smallest id, until the way closes."""
    way: dict[VehicleId, None] = {}
    vehicle = min(waits)
    while vehicle not in way:
        way[vehicle] = None
        vehicle = waits[vehicle][0]
    order = list(way)
    cycle = order[order.index(vehicle) :]
    first = cycle.index(min(cycle))
    return (*cycle[first:], *cycle[:first])
