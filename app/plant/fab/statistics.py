"""What a plant's track measures, in the figures by which fabs are compared."""

from collections import Counter
from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array
from scipy.sparse.csgraph import connected_components, dijkstra

from app.domain.layout import Plant, StationKind
from app.plant.fab.chains import chains, degrees

SOURCES = 128
"""Ports, evenly spread, from which the mean path is measured to all others. Our choice: within 1 % of all to all."""
MM_PER_M = 1000


@dataclass(frozen=True, slots=True)
class Statistics:
    """Counts of a plant; ``kilometres`` of track, ``mean_path`` in metres between two different ports.

    ``buffers`` are chains between merges and diverges, ``single`` those that have room for one vehicle only; ``parts`` are
    the strongly connected parts of the track: 1 where every barcode can be reached from every other.
    """

    barcodes: int
    kilometres: float
    diverges: int
    merges: int
    buffers: int
    single: int
    parts: int
    ports: int
    side_buffers: int
    parking: int
    mean_path: float


def statistics(plant: Plant) -> Statistics:
    """Return the figures of a plant, stations and barcodes of any kind of vehicle together."""
    into, out = degrees(plant)
    kinds = Counter(station.kind for station in plant.stations)
    buffers = chains(plant)
    graph = _graph(plant)
    return Statistics(
        barcodes=len(plant.points),
        kilometres=round(sum(edge.length for edge in plant.edges) / MM_PER_M / 1000, 2),
        diverges=sum(count > 1 for count in out.values()),
        merges=sum(count > 1 for count in into.values()),
        buffers=len(buffers),
        single=sum(len(chain) == 1 for chain in buffers),
        parts=int(connected_components(graph, connection="strong")[0]),
        ports=kinds[StationKind.PORT],
        side_buffers=kinds[StationKind.SBFL] + kinds[StationKind.SBFR],
        parking=sum(point.park for point in plant.points),
        mean_path=round(_mean_path(plant, graph), 1),
    )


def _graph(plant: Plant) -> csr_array:
    index = {point.barcode: i for i, point in enumerate(plant.points)}
    ends = ([index[e.start] for e in plant.edges], [index[e.end] for e in plant.edges])
    return csr_array(([e.length for e in plant.edges], ends), shape=(len(index), len(index)))


def _mean_path(plant: Plant, graph: csr_array) -> float:
    """Return the mean way in metres over reachable pairs of different port barcodes, 0 if there is none."""
    index = {point.barcode: i for i, point in enumerate(plant.points)}
    ports = list(dict.fromkeys(index[s.barcode] for s in plant.stations if s.kind is StationKind.PORT))
    sources = [ports[i] for i in np.linspace(0, len(ports), SOURCES, endpoint=False, dtype=int)] if ports else []
    ways = dijkstra(graph, indices=list(dict.fromkeys(sources)))[:, ports] if ports else np.zeros(0)
    ways = ways[np.isfinite(ways) & (ways > 0)]
    return float(ways.mean()) / MM_PER_M if ways.size else 0.0
