"""Our end of a line, as its owner feeds it: the session, with what it tells passed on."""

from collections.abc import Callable

from app.domain.units import Seconds
from app.protocols.itsc.session import Session


class VehicleLine:
    """A session as an ``app.domain.ports.Endpoint`` that calls ``heard(self, now)`` after every input."""

    __slots__ = ("_heard", "session")

    def __init__(self, session: Session, heard: "Callable[[VehicleLine, Seconds], None]") -> None:
        self.session = session
        self._heard = heard

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` is due."""
        return self.session.deadline

    @property
    def wants_close(self) -> bool:
        """Whether the line is silent and should be closed."""
        return self.session.wants_close

    def connected(self, now: Seconds) -> None:
        """The line is up."""
        self.session.connected(now)
        self._heard(self, now)

    def received(self, data: bytes, now: Seconds) -> None:
        """Bytes came."""
        self.session.received(data, now)
        self._heard(self, now)

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down."""
        self.session.disconnected(now, reason)
        self._heard(self, now)

    def tick(self, now: Seconds) -> None:
        """The deadline has passed."""
        self.session.tick(now)
        self._heard(self, now)

    def outgoing(self) -> bytes:
        """Return and forget the bytes to send."""
        return self.session.outgoing()
