"""How fast a vehicle drives a path, how far it needs to stop, and the path elements that tell it so."""

from collections.abc import Sequence
from itertools import pairwise
from math import ceil, sqrt
from typing import Protocol

from app.domain.layout import Edge, StopAction, VehicleSpec
from app.domain.route import MAX_SEQ, PathElement
from app.domain.units import Barcode, Millimetres, Percent, Seconds


class Rails(Protocol):
    """What kinematics needs of the track."""

    def edge(self, start: Barcode, end: Barcode) -> Edge:
        """Return the edge from one barcode to a neighbour. Raises KeyError."""
        ...

    def predecessors(self, barcode: Barcode) -> tuple[Barcode, ...]:
        """Return the barcodes with an edge to this one."""
        ...


def edge_speed(edge: Edge, spec: VehicleSpec) -> float:
    """Return the speed in mm/s that the vehicle keeps to on this edge."""
    speed = spec.max_speed * edge.speed / 100
    return min(speed, spec.curve_speed) if edge.curve else speed


def edge_time(edge: Edge, spec: VehicleSpec) -> Seconds:
    """Return the time over one edge at its full speed, without starting and stopping."""
    return Seconds(edge.length / edge_speed(edge, spec))


def braking_distance(speed_mm_s: float, spec: VehicleSpec) -> Millimetres:
    """Return the way from this speed to standstill, rounded up."""
    return Millimetres(ceil(speed_mm_s * speed_mm_s / (2 * spec.braking)))


def time_to_braking(speed_mm_s: float, way: float, limit: float, spec: VehicleSpec) -> Seconds:
    """Return how long a vehicle may go on from this speed until it must brake to stand after ``way`` mm; below 0: too late.

    It accelerates up to ``limit`` mm/s where the way allows it. All as hard as it can.
    """
    up, down = spec.acceleration, spec.braking
    cruising = way - (limit**2 - speed_mm_s**2) / (2 * up) - limit**2 / (2 * down)
    if cruising >= 0:
        return Seconds(max(0.0, limit - speed_mm_s) / up + cruising / limit)
    peak = sqrt((2 * up * down * way + down * speed_mm_s**2) / (up + down))
    return Seconds((peak - speed_mm_s) / up)


def driving_time(track: Rails, path: Sequence[Barcode], spec: VehicleSpec) -> Seconds:
    """Return the time over a path from standstill to standstill, accelerating and braking as hard as the vehicle can.

    The vehicle keeps to each edge's limit from the edge's first to its last millimetre. Raises KeyError: the path
    leaves the track.
    """
    edges = [track.edge(start, end) for start, end in pairwise(path)]
    speeds = _speeds_at_barcodes(edges, spec)
    return Seconds(sum(_ramp_time(e, speeds[i], speeds[i + 1], spec) for i, e in enumerate(edges)))


def _speeds_at_barcodes(edges: Sequence[Edge], spec: VehicleSpec) -> list[float]:
    limits = [edge_speed(edge, spec) for edge in edges]
    speeds = [0.0, *(min(before, after) for before, after in pairwise(limits)), 0.0]
    for i, edge in enumerate(edges):
        speeds[i + 1] = min(speeds[i + 1], sqrt(speeds[i] ** 2 + 2 * spec.acceleration * edge.length))
    for i in range(len(edges) - 1, -1, -1):
        speeds[i] = min(speeds[i], sqrt(speeds[i + 1] ** 2 + 2 * spec.braking * edges[i].length))
    return speeds


def _ramp_time(edge: Edge, enter: float, leave: float, spec: VehicleSpec) -> float:
    up, down = spec.acceleration, spec.braking
    reachable = sqrt((2 * up * down * edge.length + down * enter**2 + up * leave**2) / (up + down))
    peak = min(edge_speed(edge, spec), reachable)
    ramps = (peak**2 - enter**2) / (2 * up) + (peak**2 - leave**2) / (2 * down)
    return (peak - enter) / up + (peak - leave) / down + max(0.0, edge.length - ramps) / peak


def elements(
    track: Rails, path: Sequence[Barcode], last_action: StopAction, spec: VehicleSpec, first_seq: int = 0
) -> tuple[PathElement, ...]:
    """Return a path as the elements of a MOVE (from SEQ 0) or of an XMOVE (from the SEQ of its first element).

    Every element but the last is RUN with speed and sensor of the edge it leaves by (PROTOCOLS I56); the last has the
    stop and what governs the edge it is reached by (our choice). On curves the speed is lowered to the vehicle's curve
    speed. A path of one barcode takes the slowest edge that leads there, or 100 percent and area 0 if none does (our
    choice). The caller keeps to ``spec.max_count``. Raises ValueError: the path is empty, would not end with a stop
    (PROTOCOLS I42), or runs out of SEQ; KeyError: the path leaves the track.
    """
    if not path or last_action is StopAction.RUN:
        raise ValueError("a path has at least one element, and its last is a stop")
    if not 0 <= first_seq <= first_seq + len(path) - 1 <= MAX_SEQ:
        raise ValueError(f"SEQ {first_seq} to {first_seq + len(path) - 1} is outside 0..{MAX_SEQ}")
    edges = [track.edge(start, end) for start, end in pairwise(path)]
    running = tuple(_element(e.start, first_seq + i, StopAction.RUN, e, e.length, spec) for i, e in enumerate(edges))
    arriving = edges[-1] if edges else _slowest_into(track, path[-1])
    return (*running, _element(path[-1], first_seq + len(edges), last_action, arriving, Millimetres(0), spec))


def _slowest_into(track: Rails, barcode: Barcode) -> Edge:
    into = [track.edge(before, barcode) for before in track.predecessors(barcode)]
    return min(into, key=lambda e: e.speed, default=Edge(barcode, barcode, Millimetres(0)))


def _element(
    barcode: Barcode, seq: int, action: StopAction, edge: Edge, to_next: Millimetres, spec: VehicleSpec
) -> PathElement:
    speed = min(edge.speed, 100 * spec.curve_speed // spec.max_speed) if edge.curve else edge.speed
    return PathElement(barcode, seq, action, Percent(max(1, speed)), edge.sensor, to_next)
