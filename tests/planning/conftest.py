"""Small plants, drawn in a line or two."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from itertools import pairwise

import pytest

from app.domain.ids import StationId, ZoneId
from app.domain.layout import Edge, Plant, Point, Station, StationKind, Zone
from app.domain.units import Barcode, Millimetres
from app.planning.track import Track


def _lay(
    *lines: str,
    at: Mapping[str, tuple[int, int]] | None = None,
    length: int = 1000,
    clearance: int = 0,
    zones: Iterable[Zone] = (),
    ports: str = "",
    edges: Sequence[Edge] = (),
) -> Track:
    """Return the track of chains of barcodes; without positions nothing crosses anything."""
    chains = [[Barcode(b) for b in line.split()] for line in lines]
    found = dict.fromkeys(b for chain in chains for b in chain)
    found.update(dict.fromkeys(b for edge in edges for b in (edge.start, edge.end)))
    spots = {b: (at or {}).get(b, (0, 0)) for b in found}
    points = tuple(Point(b, Millimetres(x), Millimetres(y)) for b, (x, y) in spots.items())
    links = [Edge(a, b, Millimetres(length)) for chain in chains for a, b in pairwise(chain)]
    stations = tuple(Station(StationId(f"P-{b}"), StationKind.PORT, Barcode(b)) for b in ports.split())
    return Track(Plant("test", points, (*links, *edges), stations, (), tuple(zones), clearance=Millimetres(clearance)))


def _zone(barcodes: str, capacity: int = 1, *, no_stop: bool = False, name: str = "Z") -> Zone:
    return Zone(ZoneId(name), frozenset(Barcode(b) for b in barcodes.split()), capacity, no_stop)


@pytest.fixture(scope="session")
def lay() -> Callable[..., Track]:
    """Return what makes a track of chains: ``lay("a b c", "b d", at={...}, zones=[...])``."""
    return _lay


@pytest.fixture(scope="session")
def zone() -> Callable[..., Zone]:
    """Return what makes a zone: ``zone("a b", 2, no_stop=True)``."""
    return _zone
