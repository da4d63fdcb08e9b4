"""The hall around a simulated AGV: doors on its way, and buffers that take and give carts."""

from collections.abc import Mapping

from app.domain.units import Barcode, Seconds
from app.protocols.enig.simulator.buffer import SimulatedBuffer
from app.protocols.enig.simulator.door import SimulatedDoor


class Hall:
    """Doors by the piece of tape (from, to) that leads through them, both ways; buffers by the tag in front of them."""

    def __init__(
        self,
        doors: Mapping[tuple[Barcode, Barcode], SimulatedDoor] | None = None,
        buffers: Mapping[Barcode, SimulatedBuffer] | None = None,
    ) -> None:
        self._doors = dict(doors or {})
        self._buffers = dict(buffers or {})

    def passable(self, start: Barcode, end: Barcode, now: Seconds) -> bool:
        """Return whether nothing closed stands between two tags."""
        for way in ((start, end), (end, start)):
            if way in self._doors:
                self._doors[way].tick(now)
                if not self._doors[way].is_open:
                    return False
        return True

    def take_cart(self, tag: Barcode, now: Seconds) -> bool:
        """Return whether a lift that has risen here has a cart on it now; the buffer has lost it then."""
        buffer = self._buffers.get(tag)
        if buffer is None or not buffer.cart:
            return False
        buffer.set_cart(now, cart=False)
        return True

    def put_cart(self, tag: Barcode, now: Seconds) -> bool:
        """Return whether a lift that has sunk here has left its cart in the buffer."""
        buffer = self._buffers.get(tag)
        if buffer is None or buffer.cart:
            return False
        buffer.set_cart(now, cart=True)
        return True
