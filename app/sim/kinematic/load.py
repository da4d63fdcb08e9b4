"""Work for the fast plant: a backlog of transfers between ports, drawn from one seed."""

from collections.abc import Sequence
from random import Random
from typing import Protocol

import numpy as np

from app.sim.kinematic.network import Real, Whole

NOBODY = -1


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


class Transfers:
    """Transfers that are ordered and not put down, as columns; a row is used again once its transfer is delivered.

    ``source`` and ``destination`` are barcodes, ``ports`` (two columns) the ports there; ``created`` in seconds; ``vehicle``:
    who fetches or carries it, NOBODY; ``open``: it is not picked up; ``free`` are the rows without a transfer.
    """

    def __init__(self, most: int) -> None:
        self.source: Whole = np.zeros(most, dtype=np.int64)
        self.destination: Whole = np.zeros(most, dtype=np.int64)
        self.ports: Whole = np.zeros((most, 2), dtype=np.int64)
        self.created: Real = np.zeros(most)
        self.vehicle: Whole = np.full(most, NOBODY, dtype=np.int64)
        self.open = np.zeros(most, dtype=np.bool_)
        self.free = list(range(most - 1, -1, -1))

    def order(self, ports: tuple[int, int], barcodes: Sequence[int], now: float) -> None:
        """Take in a transfer between two ports."""
        row = self.free.pop()
        self.ports[row] = ports
        self.source[row], self.destination[row] = (barcodes[port] for port in ports)
        self.created[row], self.vehicle[row], self.open[row] = now, NOBODY, True

    @property
    def waiting(self) -> int:
        """How many wait for a vehicle to be sent."""
        return int(np.count_nonzero(self.open & (self.vehicle == NOBODY)))

    def oldest(self, now: float) -> float:
        """Return how long the transfer that waits longest for its pick-up has waited, s."""
        return float(now - self.created[self.open].min(initial=now))
