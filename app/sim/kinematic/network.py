"""The track of a fab as arrays: barcodes numbered buffer by buffer in order of driving."""

from itertools import pairwise
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from app.domain.layout import VehicleSpec
from app.domain.units import Barcode
from app.planning.buffers import Buffers
from app.planning.kinematics import edge_speed
from app.planning.track import Track

Whole: TypeAlias = "NDArray[np.int64]"
Real: TypeAlias = "NDArray[np.float64]"


class Network(NamedTuple):
    """Per barcode: its buffer, whether a vehicle may wait there, and to the next one of the same buffer the way (mm) and the
    speed (mm/s). Per buffer: first and last barcode, whether it is only crossed; ``next_at`` (one longer) into ``next_to`` with
    the way and speed of each connection.
    """

    buffer: Whole
    stop: Whole
    gap: Real
    speed: Real
    first: Whole
    last: Whole
    transit: Whole
    next_at: Whole
    next_to: Whole
    next_gap: Real
    next_speed: Real
    inside: Real
    """Free-flow seconds from a buffer's first to its last barcode."""


class Map(NamedTuple):
    """A network with the names of its barcodes, and the buffers it was made of."""

    network: Network
    names: tuple[Barcode, ...]
    number: dict[Barcode, int]
    buffers: Buffers


def draw(track: Track, spec: VehicleSpec) -> Map:
    """Return the network that vehicles like this one drive on. Two-way floor is left out."""
    buffers = Buffers(track, spec.length)
    names = tuple(barcode for chain in buffers.chains for barcode in chain)
    number = {barcode: i for i, barcode in enumerate(names)}
    gap, speed, inside = np.zeros(len(names)), np.zeros(len(names)), np.zeros(len(buffers))
    for buffer, chain in enumerate(buffers.chains):
        for a, b in pairwise(chain):
            edge = track.edge(a, b)
            gap[number[a]], speed[number[a]] = edge.length, edge_speed(edge, spec)
            inside[buffer] += edge.length / speed[number[a]]
    at, to, gaps, speeds = [0], [], [], []
    for chain, nexts in zip(buffers.chains, buffers.nexts, strict=True):
        for after in nexts:
            edge = track.edge(chain[-1], buffers.chains[after][0])
            to.append(after)
            gaps.append(float(edge.length))
            speeds.append(edge_speed(edge, spec))
        at.append(len(to))
    network = Network(
        buffer=np.array([buffers.at(b) for b in names], dtype=np.int64),
        stop=np.array([buffers.stop[buffers.index[b]] for b in names], dtype=np.int64),
        gap=gap,
        speed=speed,
        first=np.array([number[chain[0]] for chain in buffers.chains], dtype=np.int64),
        last=np.array([number[chain[-1]] for chain in buffers.chains], dtype=np.int64),
        transit=np.array(buffers.transit, dtype=np.int64),
        next_at=np.array(at, dtype=np.int64),
        next_to=np.array(to, dtype=np.int64),
        next_gap=np.array(gaps),
        next_speed=np.array(speeds),
        inside=inside,
    )
    return Map(network, names, number, buffers)
