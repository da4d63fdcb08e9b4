"""Soft meters: zones of which a share may be filled from outside, as long as nobody waits too long (TRAFFIC section 4).

A hard cap would be a resource that the rule of admission does not see; a soft one ends by itself.
"""

from app.domain.layout import Meter, Zone
from app.planning.buffers import Buffers, Row
from app.planning.track import Track


class Metered:
    """A soft zone as the buffers that it takes in, in part or whole, and how many of their slots may be filled from outside."""

    def __init__(self, zone: Zone, meter: Meter, buffers: Buffers) -> None:
        self.zone, self.patience = zone.id, meter.patience
        self.buffers = frozenset(
            b for at in sorted(zone.barcodes) if (b := buffers.at(at)) >= 0 and not buffers.transit[b]
        )
        self.room = max(1, int(meter.share * sum(buffers.capacity[b] for b in self.buffers)))

    def full(self, load: Row) -> bool:
        """Whether no more may come in from outside."""
        return sum(load[buffer] for buffer in self.buffers) >= self.room


def metered(track: Track, buffers: Buffers) -> dict[int, list[Metered]]:
    """Return the soft zones that each buffer lies in."""
    found: dict[int, list[Metered]] = {}
    for zone in track.plant.zones:
        if zone.meter is not None:
            meter = Metered(zone, zone.meter, buffers)
            for buffer in sorted(meter.buffers):
                found.setdefault(buffer, []).append(meter)
    return found
