"""The rail as a simulated vehicle knows it: from each barcode to the next ones (PROTOCOLS 5.1, "map")."""

from collections.abc import Iterable, Mapping

from app.domain.layout import Edge, Plant
from app.domain.units import Barcode


class Track:
    """One-way pieces of rail between neighbouring barcodes."""

    __slots__ = ("_ahead",)

    def __init__(self, edges: Iterable[Edge]) -> None:
        self.lay(edges)

    def lay(self, edges: Iterable[Edge]) -> None:
        """Lay the rail, instead of what there was. Who drives ends the way that was begun, and then finds the new rail."""
        self._ahead: dict[Barcode, dict[Barcode, Edge]] = {}
        for edge in edges:
            self._ahead.setdefault(edge.start, {})[edge.end] = edge
            self._ahead.setdefault(edge.end, {})

    @classmethod
    def of(cls, plant: Plant) -> "Track":
        """Return the rail of a plant."""
        return cls(plant.edges)

    @property
    def barcodes(self) -> Iterable[Barcode]:
        """All barcodes, in the order in which the pieces name them."""
        return self._ahead.keys()

    def ahead(self, barcode: Barcode) -> Mapping[Barcode, Edge]:
        """Return the pieces that begin at a barcode, by where they end; the first is taken by who is not steered."""
        return self._ahead.get(barcode, {})

    def edge(self, start: Barcode, end: Barcode) -> Edge | None:
        """Return the piece from one barcode to the other, or None."""
        return self.ahead(start).get(end)

    def __contains__(self, barcode: object) -> bool:
        return barcode in self._ahead
