"""Our end of a line, as its owner feeds it: the session, with what it tells passed on."""

from collections.abc import Container

from app.domain.ids import CmdIds
from app.domain.layout import VehicleSpec
from app.domain.units import Seconds
from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.session import Session, Timing, Told


class VehicleLine(Session):
    """A session that hands what it has to tell to ``told(events, now)`` after every input: an ``app.domain.ports.Endpoint``.

    It is a session instead of having one, because on the hot path each object between the socket and the session costs.
    """

    __slots__ = ()

    def __init__(
        self,
        told: Told,
        vehicle: VehicleSpec,
        dialect: Dialect,
        cmd_ids: CmdIds,
        timing: Timing,
        barcodes: Container[str] | None = None,
    ) -> None:
        super().__init__(vehicle, dialect, cmd_ids, timing, barcodes, told)

    def connected(self, now: Seconds) -> None:
        """The line is up."""
        super().connected(now)
        self._tell(now)

    def received(self, data: bytes, now: Seconds) -> None:
        """Bytes came."""
        Session.received(self, data, now)
        if self._events:
            self._tell(now)

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down."""
        super().disconnected(now, reason)
        self._tell(now)

    def tick(self, now: Seconds) -> None:
        """The deadline has passed."""
        super().tick(now)
        self._tell(now)

    def _tell(self, now: Seconds) -> None:
        events = self.events()
        if events and self._pass_on is not None:
            self._pass_on(events, now)
