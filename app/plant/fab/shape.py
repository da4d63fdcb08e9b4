"""The figures by which a fab is drawn, and the sizes that tests and benchmarks speak of."""

from dataclasses import dataclass

from app.domain.units import Millimetres

LEAST_COLUMN = 15
"""Barcodes of a lane that a bay's ways in and out and its two lane changes take."""
LEAST_PITCH = Millimetres(1011)
"""Shortcuts have a barcode every 0.955 m or more then: vehicles are 0.95 m long."""
LEAST_GAP = Millimetres(1200)
"""Between rails side by side."""
LANE_CHANGES = 2
"""Per bay: one out of the outer lane behind its way in, one into it before the next bay's way in."""


@dataclass(frozen=True, slots=True)
class Shape:
    """A fab to be drawn: ``bays`` in two rows, one along each side of the spine.

    ``depth`` is the mean length of a bay's long sides in barcodes, ``spread`` how far a bay may differ from it (a share).
    ``shortcuts`` across bays are counted over all bays; ``pairs`` is how many couples of them lie side by side, one
    each way, so that a diverge is followed by a merge at once. ``turnarounds`` are counted per direction. ``column``
    is the distance of neighbouring bays in barcodes. ``ports`` and ``side_buffers`` are the shares of the barcodes along
    bays that serve one. The defaults are the fab of TRAFFIC section 1; values that it does not give are our choice.
    """

    name: str = "fab-10k"
    bays: int = 40
    depth: int = 77
    spread: float = 0.15
    shortcuts: int = 386
    pairs: int = 114
    turnarounds: int = 10
    column: int = 15
    pitch: Millimetres = Millimetres(1020)
    lane_gap: Millimetres = Millimetres(1500)
    ports: float = 0.88
    side_buffers: float = 0.08

    def __post_init__(self) -> None:
        """Raises: ValueError: no fab can be drawn with these figures."""
        if self.bays < 2 or self.bays % 2:
            raise ValueError(f"{self.bays} bays: they come in pairs, one on each side of the spine")
        if self.column < LEAST_COLUMN or self.pitch < LEAST_PITCH or self.lane_gap < LEAST_GAP:
            least = f"column {LEAST_COLUMN}, pitch {LEAST_PITCH} and lane_gap {LEAST_GAP} or more"
            raise ValueError(f"the track would be too close together: {least}")
        if not 0 <= self.turnarounds <= self.columns // 2:
            raise ValueError(f"{self.columns} columns have room for {self.columns // 2} turnarounds each way")

    @property
    def columns(self) -> int:
        """Bays along one side of the spine."""
        return self.bays // 2

    @property
    def diverges(self) -> int:
        """Diverges of the whole fab, and as many merges."""
        return self.bays * (2 + LANE_CHANGES) + 2 * self.turnarounds + self.shortcuts

    @property
    def buffers(self) -> int:
        """Chains of barcodes between merges and diverges (TRAFFIC section 1).

        A diverge opens two and a merge one, but a merge that follows a diverge at once opens none of its own: so it is inside
        a pair.
        """
        return 3 * self.diverges - 2 * self.pairs


SIZES: dict[str, Shape] = {
    "1k": Shape("fab-1k", bays=4, shortcuts=38, pairs=11, turnarounds=1),
    "10k": Shape(),
    "50k": Shape("fab-50k", bays=80, depth=279, shortcuts=160, pairs=80, turnarounds=20),
    "50k-dense": Shape("fab-50k-dense", bays=100, depth=167, shortcuts=2215, pairs=475, turnarounds=25),
}
"""The sizes of issue and benchmarks by the name that ``hoistway fab --size`` takes."""
