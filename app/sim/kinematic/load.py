"""Work for the fast plant: a backlog of transfers between ports, drawn from one seed."""

from collections.abc import Sequence
from random import Random
from typing import Protocol

UNBOUND = -1


class Work(Protocol):
    """Transfers between ports, numbered as in ``barcodes``."""

    barcodes: list[int]

    def draw(self) -> tuple[int, int] | None:
        """Return the ports of a new transfer; None: there is none now."""

    def emptied(self, port: int) -> None:
        """The carrier has left the port."""

    def filled(self, port: int) -> None:
        """A carrier has come to the port."""


class Ports:
    """Ports that are full or empty, each in one job at a time.

    A job runs from a full port to an empty one; both are engaged until the carrier has left, or come.
    """

    def __init__(self, barcodes: Sequence[int], rng: Random, share_full: float = 0.5) -> None:
        self.barcodes = list(barcodes)
        self._rng = rng
        order = list(range(len(self.barcodes)))
        rng.shuffle(order)
        cut = round(share_full * len(order))
        self._full, self._empty = order[:cut], order[cut:]

    def draw(self) -> tuple[int, int] | None:
        """Return the ports of a new transfer and engage them; None: there is no full or no empty one left."""
        if not self._full or not self._empty:
            return None
        return self._pick(self._full), self._pick(self._empty)

    def emptied(self, port: int) -> None:
        """The carrier has left the port."""
        self._empty.append(port)

    def filled(self, port: int) -> None:
        """A carrier has come to the port."""
        self._full.append(port)

    def _pick(self, ports: list[int]) -> int:
        at = self._rng.randrange(len(ports))
        ports[at], ports[-1] = ports[-1], ports[at]
        return ports.pop()
