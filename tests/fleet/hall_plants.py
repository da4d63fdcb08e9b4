"""Small plants with a door across the track and a buffer, slow enough that doors matter."""

from itertools import pairwise

from app.domain.devices import DeviceId, DeviceNumber
from app.domain.ids import CarrierId, DevId, LinkId, StationId, VehicleId
from app.domain.layout import (
    BufferSpec,
    ChargerSpec,
    DoorSpec,
    Edge,
    LinkSpec,
    OnEmergency,
    Plant,
    Point,
    PulseSet,
    Station,
    StationKind,
    VehicleSpec,
    Wire,
)
from app.domain.units import Barcode, Millimetres, Pulses

HALL = LinkId("HALL")
DOOR1, BUFFER1, CHARGER1 = DeviceId("DOOR1"), DeviceId("BUFFER1"), DeviceId("CHARGER1")
HOME = PulseSet(Pulses(0), Pulses(0), Pulses(0))
STEP = 2000
RING = [str(n) for n in range(101, 117)]
LINE = [str(n) for n in range(201, 211)]


def points(names: list[str]) -> tuple[Point, ...]:
    return tuple(Point(Barcode(b), Millimetres(STEP * n), Millimetres(0)) for n, b in enumerate(names))


def loop() -> tuple[Point, ...]:
    there = [Point(Barcode(b), Millimetres(STEP * n), Millimetres(0)) for n, b in enumerate(RING[:8])]
    back = [Point(Barcode(b), Millimetres(STEP * (7 - n)), Millimetres(STEP)) for n, b in enumerate(RING[8:])]
    return (*there, *back)


def edge(start: str, end: str) -> Edge:
    return Edge(Barcode(start), Barcode(end), Millimetres(STEP))


def hoist(number: int, start: str, length: int = 1000) -> VehicleSpec:
    return VehicleSpec(
        VehicleId(f"V00{number}"),
        DevId(number),
        length=Millimetres(length),
        max_speed=Millimetres(1000),
        start=Barcode(start),
        offset=HOME,
    )


def door(
    *passages: tuple[str, str], normally_open: bool = False, on_emergency: OnEmergency = OnEmergency.LEAVE
) -> DoorSpec:
    edges = frozenset((Barcode(a), Barcode(b)) for a, b in passages)
    return DoorSpec(DOOR1, HALL, DeviceNumber(30), edges, normally_open, on_emergency)


def ring(*, normally_open: bool = False, on_emergency: OnEmergency = OnEmergency.LEAVE) -> Plant:
    """Return a one-way ring 101..116 with DOOR1 across 106-107, V001 at 102, V002 at 112.

    P1 at 103, P2 at 109 (BUFFER1 locks it, P3 is its fall-back), P3 at 111; FOUP0001 at P1.
    """
    edges = tuple(edge(a, b) for a, b in zip(RING, [*RING[1:], RING[0]], strict=True))
    stations = (
        Station(StationId("P1"), StationKind.PORT, Barcode("103"), dest=HOME),
        Station(
            StationId("P2"),
            StationKind.PORT,
            Barcode("109"),
            dest=HOME,
            buffer=BUFFER1,
            fallbacks=(StationId("P3"),),
        ),
        Station(StationId("P3"), StationKind.PORT, Barcode("111"), dest=HOME),
    )
    return Plant(
        "ring",
        loop(),
        edges,
        stations,
        (hoist(1, "102"), hoist(2, "112")),
        carriers=((CarrierId("FOUP0001"), StationId("P1")),),
        links=(LinkSpec(HALL, Wire.ENIG),),
        doors=(door(("106", "107"), normally_open=normally_open, on_emergency=on_emergency),),
        buffers=(BufferSpec(BUFFER1, HALL, DeviceNumber(21)),),
        chargers=(ChargerSpec(CHARGER1, Barcode("105")),),
    )


def two_way(length: int = 1000) -> Plant:
    """Return a two-way line 201..210 with DOOR1 across 205-206, either way, and V001 at 202."""
    pairs = list(pairwise(LINE))
    edges = tuple(edge(a, b) for pair in pairs for a, b in (pair, pair[::-1]))
    return Plant(
        "two-way",
        points(LINE),
        edges,
        (),
        (hoist(1, "202", length),),
        links=(LinkSpec(HALL, Wire.ENIG),),
        doors=(door(("205", "206"), ("206", "205")),),
    )
