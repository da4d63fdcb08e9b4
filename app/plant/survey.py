"""What is worth knowing of a plant's track beyond its mistakes: figures, tight places, places that exclude one another."""

from collections import Counter, defaultdict
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import pairwise
from math import hypot

import networkx as nx

from app.domain.layout import Plant, StationKind, VehicleKind
from app.domain.units import Barcode, Millimetres
from app.planning.buffers import Buffers
from app.planning.clearance import crossing_edges, near_points
from app.planning.track import BOOK_VEHICLE, Track
from app.plant.connections import graph_of
from app.plant.fab.statistics import statistics

SAME_PLACE = Millimetres(150)
"""Two marks nearer than this that no track connects are probably one. Our choice."""
MANY = 0.25
"""A barcode is named when its closure cuts off so many of all places with stations. Our choice."""
SHOWN = 5
MM_PER_KM = 1_000_000


@dataclass(frozen=True, slots=True)
class Remark:
    """Something that a planner should look at: ``barcodes`` are the first places of ``count``, ``remedy`` may be empty."""

    topic: str
    message: str
    count: int
    barcodes: tuple[Barcode, ...] = ()
    remedy: str = ""


@dataclass(frozen=True, slots=True)
class Survey:
    """Figures by name, in the order in which they are shown, and remarks."""

    figures: dict[str, float | int | str]
    remarks: list[Remark]


def survey(plant: Plant) -> Survey:
    """Return what a plant's track measures and where it is tight. Takes a second for 10,000 barcodes."""
    track = Track(plant)
    length = max((v.length for v in plant.hoists), default=BOOK_VEHICLE.length)
    buffers = Buffers(track, length)
    makers = (_lengths(plant), _marks(plant), _crossings(plant), _near(plant, track))
    remarks = [remark for made in makers for remark in made]
    remarks += [*_buffers(track, buffers, length), *_stops(plant, track), *_cuts(plant)]
    return Survey(_figures(plant, track, buffers), remarks)


def _figures(plant: Plant, track: Track, buffers: Buffers) -> dict[str, float | int | str]:
    counted = statistics(plant)
    pairs = {(edge.start, edge.end) for edge in plant.edges}
    both = sum(edge.length for edge in plant.edges if (edge.end, edge.start) in pairs) / 2
    lengths = sorted(edge.length for edge in plant.edges)
    kinds = Counter(station.kind for station in plant.stations)
    figures: dict[str, float | int | str] = {
        "barcodes": len(plant.points),
        "edges": len(plant.edges),
        "kilometres": round(sum(lengths) / MM_PER_KM, 3),
        "two-way kilometres": round(both / MM_PER_KM, 3),
        "diverges": counted.diverges,
        "merges": counted.merges,
        "pieces": len(track.areas),
        "strongly connected parts": counted.parts,
        "buffers": len(buffers),
        "buffers for fewer than two vehicles": sum(buffers.transit),
        "barcodes that exclude others": sum(bool(track.conflicts(barcode)) for barcode in track.barcodes),
        "shortest edge, mm": lengths[0] if lengths else 0,
        "middle edge, mm": lengths[len(lengths) // 2] if lengths else 0,
        "longest edge, mm": lengths[-1] if lengths else 0,
        "mean way between ports, m": counted.mean_path,
        "parking places": counted.parking,
        "vehicles": len(plant.vehicles),
    }
    named = {StationKind.PORT: "ports", StationKind.AGV_BUFFER: "AGV buffers"}
    side = kinds[StationKind.SBFL] + kinds[StationKind.SBFR]
    figures |= {text: kinds[kind] for kind, text in named.items() if kinds[kind]}
    figures |= {"side buffers": side} if side else {}
    return figures if counted.ports else {name: value for name, value in figures.items() if "between ports" not in name}


def _remark(topic: str, message: str, places: Iterable[Barcode], remedy: str = "") -> Iterator[Remark]:
    found = list(dict.fromkeys(places))
    if found:
        yield Remark(topic, message, len(found), tuple(found[:SHOWN]), remedy)


def _lengths(plant: Plant) -> Iterator[Remark]:
    """Lengths within the checker's tolerance that cannot be all the same."""
    places = {point.barcode: point for point in plant.points}
    short = []
    for edge in plant.edges:
        a, b = places[edge.start], places[edge.end]
        if edge.length + 1 < hypot(b.x - a.x, b.y - a.y):
            short.append(edge.start)
    message = "track is shorter than the straight line between its ends"
    yield from _remark("lengths", message, short, "correct the length or the positions")


def _marks(plant: Plant) -> Iterator[Remark]:
    linked = {(edge.start, edge.end) for edge in plant.edges} | {(edge.end, edge.start) for edge in plant.edges}
    near = [one for one, other in near_points(plant.points, SAME_PLACE) if (one, other) not in linked]
    message = f"another barcode lies within {SAME_PLACE} mm, and no track connects them"
    yield from _remark("doubled barcodes", message, near, "are both on the rail, or is one an old name of the other?")


def _crossings(plant: Plant) -> Iterator[Remark]:
    places = {point.barcode: point for point in plant.points}
    crossing = [edge.start for edge, _ in crossing_edges(plant.edges, places)]
    message = "track crosses other track without a common barcode: vehicles exclude one another there"
    yield from _remark("crossings", message, crossing, "is a barcode missing, or does one pass above the other?")


def _near(plant: Plant, track: Track) -> Iterator[Remark]:
    if plant.clearance:
        apart = [b for b in track.barcodes if track.conflicts(b)]
        message = f"barcodes of other branches lie within the clearance of {plant.clearance} mm: one vehicle at a time"
        yield from _remark("conflicts", message, apart)


def _buffers(track: Track, buffers: Buffers, length: Millimetres) -> Iterator[Remark]:
    transit = [chain[0] for chain, small in zip(buffers.chains, buffers.transit, strict=True) if small]
    message = f"between two branches there is no room for two vehicles of {length} mm: nobody waits there"
    yield from _remark("short buffers", message, transit, "grants pass through; lay barcodes closer, or branches apart")
    dense = [a for chain in buffers.chains for a, b in pairwise(chain) if track.edge(a, b).length < length]
    message = f"barcodes are nearer to each other than a vehicle is long ({length} mm): it covers more than one"
    yield from _remark("dense barcodes", message, dense)


def _stops(plant: Plant, track: Track) -> Iterator[Remark]:
    branching = {b for b in track.barcodes if len(track.successors(b)) > 1 or len(track.predecessors(b)) > 1}
    rail = branching - track.floor
    stations = [station.barcode for station in plant.stations if station.barcode in rail]
    message = "a station lies at a merge or diverge: whoever stops there bars both ways"
    yield from _remark("stations at branches", message, stations, "serve it from a barcode before or behind")
    parks = [point.barcode for point in plant.points if point.park and point.barcode in rail]
    yield from _remark("parking at branches", "a parking place lies at a merge or diverge", parks, "choose another")
    busy = {station.barcode for station in plant.stations}
    both = [point.barcode for point in plant.points if point.park and point.barcode in busy]
    message = "a parking place is a station's barcode as well: an idle vehicle may stand in the way there"
    yield from _remark("parking at stations", message, both, "choose another")


def _cuts(plant: Plant) -> Iterator[Remark]:
    """Barcodes whose closure would cut many stations off from the others, by kind of vehicle."""
    graph = graph_of(plant)
    for kind in VehicleKind:
        served = list(dict.fromkeys(s.barcode for s in plant.stations if s.kind in kind.serves))
        if len(served) < 2:
            continue
        onward = _barred(graph, served)
        back = _barred(graph.reverse(copy=False), served)
        least = max(2, len(served) * MANY)
        barred = {barcode: max(onward[barcode], back[barcode]) for barcode in onward | back}
        worst = sorted((b for b in barred if barred[b] >= least and b != served[0]), key=lambda b: (-barred[b], b))
        most = f"{barred[worst[0]]} of {len(served)}" if worst else ""
        message = f"closed, a barcode cuts off up to {most} places of stations: there is no way around"
        yield from _remark("no way around", message, worst)


def _barred(graph: "nx.DiGraph[str]", served: list[Barcode]) -> Counter[Barcode]:
    """Return for each barcode how many of the served ones are reached from the first of them only by passing it."""
    above = nx.immediate_dominators(graph, served[0])
    below: defaultdict[str, list[str]] = defaultdict(list)
    for barcode, parent in above.items():
        if parent is not None and parent != barcode:
            below[parent].append(barcode)
    order: list[str] = [served[0]]
    for barcode in order:
        order += below[barcode]
    wanted, counts = set(served), Counter[Barcode]()
    for barcode in reversed(order):
        counts[Barcode(barcode)] = sum(counts[Barcode(b)] + (b in wanted) for b in below[barcode])
    return counts
