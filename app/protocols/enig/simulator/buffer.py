"""A simulated buffer (PROTOCOLS 5.3)."""

from collections.abc import Callable

from app.domain.devices import BufferState, DeviceNumber
from app.domain.units import Seconds
from app.protocols.enig.messages import Body, BufferReport, Lock, UnLock
from app.protocols.enig.simulator.device import SimulatedDevice
from app.protocols.enig.simulator.options import BufferOptions


class SimulatedBuffer(SimulatedDevice):
    """Lock and UnLock: busy for a second, then cart or no cart. ``locked`` and ``cart`` are for whoever looks on."""

    def __init__(
        self,
        number: DeviceNumber,
        *,
        cart: bool = False,
        options: BufferOptions = BufferOptions(),  # noqa: B008
    ) -> None:
        self.cart = cart
        self.locked = False
        self._options = options
        self._report_now = BufferReport(int(cart))
        self._cancel: Callable[[], None] | None = None
        super().__init__(number, self._report_now, options.status_every)

    @property
    def state(self) -> BufferState:
        """What it reports."""
        return BufferState(self._report_now.state)

    def set_cart(self, now: Seconds, *, cart: bool) -> None:
        """Put a cart in or take it out by hand; seen at once unless the buffer is busy or in error."""
        self.tick(now)
        self.cart = cart
        if self.state in (BufferState.NO_CART, BufferState.CART):
            self._show_cart()
        self._settle()

    def set_state(self, state: BufferState, now: Seconds) -> None:
        """Let it report an error, or that it does not know; NO_CART or CART ends that and shows what is there."""
        self.tick(now)
        self._stop()
        self._report_now.state = int(state)
        if state in (BufferState.NO_CART, BufferState.CART):
            self._show_cart()
        self._settle()

    def _obey(self, body: Body) -> None:
        if isinstance(body, Lock | UnLock) and self.state is not BufferState.ERROR:
            self._stop()
            self._report_now.state = int(BufferState.BUSY)
            self._cancel = self._after(self._options.lock_time, lambda: self._locked(locked=isinstance(body, Lock)))

    def _locked(self, *, locked: bool) -> None:
        self._cancel = None
        self.locked = locked
        self._show_cart()

    def _show_cart(self) -> None:
        self._report_now.state = int(BufferState.CART if self.cart else BufferState.NO_CART)

    def _stop(self) -> None:
        if self._cancel is not None:
            self._cancel()
            self._cancel = None

    def _restart(self) -> None:
        self.locked = False
        self._stop()
        self._show_cart()
