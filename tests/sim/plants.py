"""Small tracks, drawn for one test each."""

from app.domain.ids import CarrierId, DevId, StationId, VehicleId
from app.domain.layout import Edge, Plant, Point, PulseSet, Station, StationKind, VehicleSpec
from app.domain.units import Barcode, Millimetres, Pulses


def points(**places: tuple[int, int]) -> tuple[Point, ...]:
    return tuple(Point(Barcode(name), Millimetres(x), Millimetres(y)) for name, (x, y) in places.items())


def edges(*ways: str, length: int = 1000) -> tuple[Edge, ...]:
    """Return the edges of ways such as ``a-b-c``."""
    pairs = [pair for way in ways for pair in zip(way.split("-"), way.split("-")[1:], strict=False)]
    return tuple(Edge(Barcode(a), Barcode(b), Millimetres(length)) for a, b in pairs)


def vehicles(*starts: str, length: int = 1500) -> tuple[VehicleSpec, ...]:
    return tuple(
        VehicleSpec(VehicleId(f"V{i}"), DevId(i), start=Barcode(start), length=Millimetres(length))
        for i, start in enumerate(starts, 1)
    )


def line() -> Plant:
    """Return a straight piece a-b-c-d-e of 1 m steps with a branch into c, and two ports at b."""
    return Plant(
        name="line",
        points=points(a=(0, 0), b=(1000, 0), c=(2000, 0), d=(3000, 0), e=(4000, 0), x=(1000, 1000)),
        edges=edges("a-b-c-d-e", "x-c"),
        stations=(port("P1", "b", 100), port("P2", "b", 9000), Station(StationId("L"), StationKind.SBFL, Barcode("d"))),
        vehicles=vehicles("a", "e"),
        carriers=((CarrierId("F1"), StationId("P1")),),
    )


def port(name: str, barcode: str, shft: int) -> Station:
    dest = PulseSet(Pulses(shft), Pulses(0), Pulses(0))
    return Station(StationId(name), StationKind.PORT, Barcode(barcode), dest=dest)
