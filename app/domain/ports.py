"""Ports: what the pure layers ask of the world, and what the world may ask of them."""

from collections.abc import Sequence
from typing import Protocol, runtime_checkable

from app.domain.records import Kept, Record
from app.domain.units import Seconds


class Endpoint(Protocol):
    """One end of a line: our session, or a simulated device. Takes bytes and now, gives bytes and a deadline.

    The owner calls one of the four inputs, then ``outgoing`` until empty, then arranges for ``tick`` at ``deadline``.
    """

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next; None for not at all."""
        ...

    @property
    def wants_close(self) -> bool:
        """Whether the owner should close the connection once ``outgoing`` is sent."""
        ...

    def connected(self, now: Seconds) -> None:
        """The line is up."""
        ...

    def received(self, data: bytes, now: Seconds) -> None:
        """Bytes came. Never raises, whatever they are."""
        ...

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down."""
        ...

    def tick(self, now: Seconds) -> None:
        """The deadline has passed."""
        ...

    def outgoing(self) -> bytes:
        """Return and forget the bytes to send; empty if none."""
        ...


@runtime_checkable
class Prompt(Protocol):
    """What an endpoint may offer besides: the commonest bytes taken and answered in one step."""

    def at_once(self, data: bytes, now: Seconds) -> bytes:
        """Take bytes and return the whole answer; empty if they are for ``received``, and nothing has been done with them.

        Where it answers, ``outgoing``, ``wants_close`` and ``deadline`` are as before (``deadline`` may have moved back).
        """
        ...


class Ledger(Protocol):
    """The durable store as the controller's shell uses it; blocking, called from one thread."""

    def load(self) -> Kept:
        """Raise the epoch durably and return all that is kept."""
        ...

    def commit(self, batch: Sequence[Record]) -> None:
        """Write all records in one transaction, in order; durable on return. Raises StoreError: nothing was written."""
        ...

    def close(self) -> None:
        """Let the plant go."""
        ...
