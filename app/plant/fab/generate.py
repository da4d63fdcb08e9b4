"""From a shape and a seed to a fab: track, stations, parking places, and which barcode lies in which bay."""

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from random import Random

from app.domain.ids import StationId
from app.domain.layout import Plant, PulseSet, Station, StationKind
from app.domain.units import Barcode, Millimetres, Pulses
from app.plant.fab.bay import Bay, draw_bay, plan_bays
from app.plant.fab.drawing import Drawing
from app.plant.fab.shape import Shape
from app.plant.fab.spine import draw_spine

PARKED_ACROSS = 3
"""Parking places of a shortcut: its last barcodes, so that who comes later queues behind. Our choice."""


@dataclass(frozen=True)
class Fab:
    """A generated plant without vehicles, and where its barcodes lie: in a bay (by its name), or on the spine."""

    plant: Plant
    bays: dict[str, tuple[Barcode, ...]]
    spine: tuple[Barcode, ...]

    @cached_property
    def bay_of(self) -> dict[Barcode, str]:
        """The bay of each barcode that is not the spine's."""
        return {barcode: name for name, barcodes in self.bays.items() for barcode in barcodes}


def generate(shape: Shape, seed: int) -> Fab:
    """Return the fab of this shape; the seed varies depths of bays and where shortcuts, ports and side buffers are.

    No two edges meet on the plan but at a common barcode, every edge is longer than a vehicle of 0.95 m, and every barcode
    can be reached from every other. ``clearance`` is 0: a vehicle covers its own barcode alone, and rails lie 1.2 m apart or
    more except where branches part or join. Nearest to another rail are the barcode half way of a lane change (0.75 m from
    both lanes; nobody waits there) and the first and last of a ramp (0.8 m). Our choice.
    """
    random = Random(seed)
    drawing = Drawing()
    spine = draw_spine(drawing, shape)
    bays: dict[str, Bay] = {}
    for i, plan in enumerate(plan_bays(shape, random)):
        lanes, column = spine.lanes[i % 2], i // 2
        # Columns are counted in driving direction, names from the west end.
        column = shape.columns - 1 - column if lanes.direction.turned else column
        bays[f"B{i + 1:0{len(str(shape.bays))}d}"] = draw_bay(drawing, shape, lanes, column, plan, random)
    junctions = _junctions(drawing)
    parking = frozenset(b for bay in bays.values() for b in _parking(bay))
    stations = [s for name, bay in bays.items() for s in _stations(shape, name, bay, junctions, random)]
    plant = Plant(
        name=shape.name,
        points=drawing.points(parking),
        edges=tuple(drawing.edges),
        stations=tuple(stations),
        vehicles=(),
        clearance=Millimetres(0),
    )
    return Fab(plant, {name: bay.barcodes for name, bay in bays.items()}, spine.barcodes)


def _junctions(drawing: Drawing) -> frozenset[Barcode]:
    into, out = Counter(e.end for e in drawing.edges), Counter(e.start for e in drawing.edges)
    return frozenset(b for b in drawing.spots if into[b] != 1 or out[b] != 1)


def _parking(bay: Bay) -> Iterator[Barcode]:
    """Give the places where a waiting vehicle is least in the way: the ends of shortcuts, and the bay's far end."""
    for shortcut in bay.shortcuts:
        yield from shortcut[-PARKED_ACROSS:]
    yield from bay.far_end[1:-1]


def _stations(shape: Shape, name: str, bay: Bay, junctions: frozenset[Barcode], random: Random) -> Iterator[Station]:
    numbers: Counter[StationKind] = Counter()
    for barcode in (*bay.sides[0], *bay.sides[1]):
        chance = random.random()
        if barcode in junctions or chance >= shape.ports + shape.side_buffers:
            continue
        kind = StationKind.PORT
        if chance >= shape.ports:
            kind = random.choice((StationKind.SBFL, StationKind.SBFR))
        numbers[kind] += 1
        letter = {StationKind.PORT: "P", StationKind.SBFL: "L", StationKind.SBFR: "R"}[kind]
        station = f"{name}-{letter}{numbers[kind]:03d}"
        taught = _taught(random) if kind is StationKind.PORT else None
        yield Station(StationId(station), kind, barcode, dest=taught, display=station)


def _taught(random: Random) -> PulseSet:
    """Return where a port's axes stand: within what every generated vehicle reaches. Our choice."""
    shft, rota, lift = random.randint(-1800, 1800), random.randint(-250, 250), random.randint(41_000, 43_000)
    return PulseSet(Pulses(shft), Pulses(rota), Pulses(lift))
