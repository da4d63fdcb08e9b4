"""A simulated door (PROTOCOLS 5.3)."""

from collections.abc import Callable

from app.domain.devices import DeviceNumber, DoorState
from app.domain.units import Seconds
from app.protocols.enig.messages import Body, Close, DoorReport, Open
from app.protocols.enig.simulator.device import SimulatedDevice
from app.protocols.enig.simulator.options import DoorOptions


class SimulatedDoor(SimulatedDevice):
    """Open and close: busy for two seconds, then open or closed; error while it is obstructed."""

    def __init__(
        self,
        number: DeviceNumber,
        *,
        is_open: bool = False,
        options: DoorOptions = DoorOptions(),  # noqa: B008
    ) -> None:
        self._options = options
        self._report_now = DoorReport(int(is_open))
        self._obstructed = False
        self._leaf_open = is_open
        self._cancel: Callable[[], None] | None = None
        self._toward: DoorState | None = None
        super().__init__(number, self._report_now, options.status_every)

    @property
    def state(self) -> DoorState:
        """What it reports."""
        return DoorState(self._report_now.state)

    @property
    def is_open(self) -> bool:
        """Whether one can pass, by what it reports."""
        return self.state is DoorState.OPEN

    @property
    def leaf_open(self) -> bool:
        """Whether its leaf is out of the way, whatever it reports: it came to the end and has not closed since."""
        return self._leaf_open

    def obstruct(self, now: Seconds) -> None:
        """Put something in its way: it stops where it is, in error; a command while it is there ends in error again."""
        self.tick(now)
        self._obstructed = True
        self._stop()
        self._report_now.state = int(DoorState.ERROR)
        self._settle()

    def clear(self, now: Seconds) -> None:
        """Take it away: the error stays until the next command has ended."""
        self.tick(now)
        self._obstructed = False

    def _obey(self, body: Body) -> None:
        toward = DoorState.OPEN if isinstance(body, Open) else DoorState.CLOSED
        if not isinstance(body, Open | Close) or toward is self._toward:
            return
        self._stop()
        self._toward = toward
        self._leaf_open = self._leaf_open and toward is DoorState.OPEN
        self._report_now.state = int(DoorState.BUSY)
        self._cancel = self._after(self._options.move_time, self._end)

    def _end(self) -> None:
        reached = DoorState.ERROR if self._obstructed or self._toward is None else self._toward
        self._cancel = self._toward = None
        self._leaf_open = self._leaf_open or reached is DoorState.OPEN
        self._report_now.state = int(reached)

    def _stop(self) -> None:
        if self._cancel is not None:
            self._cancel()
        self._cancel = self._toward = None

    def _restart(self) -> None:
        """Without power it stayed where it was; it does not know where, unless it was at an end."""
        if self.state is DoorState.BUSY:
            self._report_now.state = int(DoorState.UNKNOWN)
        self._stop()
