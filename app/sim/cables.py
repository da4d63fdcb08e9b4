"""Cables of a virtual world: bytes take their time, stay in order, and are lost when the cable is cut."""

from collections.abc import Callable
from random import Random

from app.domain.ports import Endpoint
from app.sim.agenda import Agenda, Watchdog


class Cable:
    """Joins the controller's end of one line to a simulated device.

    ``latency`` is the least and the most that bytes take, in seconds; each direction keeps its order. ``dial`` is tried again
    and again while the controller's end is there and the device accepts. ``wire`` sees every byte as it is sent (direction
    ``>`` to the device). ``after`` is called after each input to the controller's end.
    """

    REDIAL = 0.5
    """Seconds between two attempts to connect. Our choice."""

    def __init__(
        self,
        agenda: Agenda,
        rng: Random,
        latency: tuple[float, float],
        device: Endpoint,
        refuses: Callable[[], bool],
        wire: Callable[[str, bytes], None],
    ) -> None:
        self.up = False
        self.heard: Callable[[bytes | None, float], None] = lambda data, now: None
        """Told what arrives at the controller's end, and None as it loses the connection."""
        self.mute = False
        """While True nothing arrives on either side, though the line stays up: half-open."""
        self._agenda = agenda
        self._rng = rng
        self._latency = latency
        self._device = device
        self._refuses = refuses
        self._wire = wire
        self._controller: Endpoint | None = None
        self._after: Callable[[], None] = lambda: None
        self._device_timer = Watchdog(agenda, device, self.flush_device)
        self._controller_timer: Watchdog | None = None
        self._connection = 0
        self._arrival = {">": 0.0, "<": 0.0}

    def start(self) -> None:
        """Let the device's physical time run."""
        self._device_timer.rearm()

    def plug_in(self, controller: Endpoint, after: Callable[[], None]) -> None:
        """Give the line its controller's end and begin to dial."""
        self._controller = controller
        self._after = after
        self._controller_timer = Watchdog(self._agenda, controller, self._ticked)
        self._controller_timer.rearm()
        self._agenda.after(self._delay(), lambda: self._dial(controller))

    def disturb(self, disturbed: Callable[[Endpoint], Endpoint]) -> None:
        """Put something between the device and its end of the line: ``disturbed`` gives what is there instead."""
        self._device = self._device_timer._of = disturbed(self._device)

    def unplug(self) -> None:
        """The controller is gone: its end says nothing more, the device hears of the cut."""
        self._controller = None
        if self._controller_timer is not None:
            self._controller_timer.stop()
        self.cut("controller gone")

    def cut(self, reason: str) -> None:
        """Lose the connection and all bytes under way; both ends hear of it at once."""
        if not self.up:
            return
        self.up = False
        self._connection += 1
        self.heard(None, self._agenda.now)
        self._device.disconnected(self._agenda.now, reason)
        if self._controller is not None:
            self._controller.disconnected(self._agenda.now, reason)
            self._redial(self._controller)
        self.flush()
        if self._controller is not None:
            self._after()

    def flush(self) -> None:
        """Send what both ends have to say, close if one wants to, and see to their timers."""
        self.flush_device()
        self.flush_controller()

    def flush_controller(self) -> None:
        """Send what the controller's end has to say; call after each input to it."""
        end = self._controller
        if end is None or self._controller_timer is None:
            return
        while data := end.outgoing():
            if self.up:
                self._send(">", self._device, data)
        self._controller_timer.rearm()
        if self.up and end.wants_close:
            self._hang_up()

    def flush_device(self) -> None:
        """Send what the device has to say; call after each input to it."""
        while data := self._device.outgoing():
            if self.up and self._controller is not None:
                self._send("<", self._controller, data)
        self._device_timer.rearm()
        if self.up and self._device.wants_close:
            self._hang_up()

    def _hang_up(self) -> None:
        connection = self._connection
        self._agenda.after(self._latency[1], lambda: self._close(connection))

    def _ticked(self) -> None:
        self.flush_controller()
        self._after()

    def _close(self, connection: int) -> None:
        if connection == self._connection:
            self.cut("closed")

    def _send(self, direction: str, other: Endpoint, data: bytes) -> None:
        self._wire(direction, data)
        arrival = max(self._agenda.now + self._delay(), self._arrival[direction])
        self._arrival[direction] = arrival
        connection = self._connection
        self._agenda.at(arrival, lambda: self._arrive(connection, other, data))

    def _arrive(self, connection: int, end: Endpoint, data: bytes) -> None:
        if connection != self._connection or not self.up or self.mute:
            return
        if end is self._controller:
            self.heard(data, self._agenda.now)
        end.received(data, self._agenda.now)
        if end is self._controller:
            self.flush_controller()
            self._after()
        else:
            self.flush_device()

    def _redial(self, controller: Endpoint) -> None:
        self._agenda.after(self.REDIAL, lambda: self._dial(controller))

    def _dial(self, controller: Endpoint) -> None:
        if self._controller is not controller or self.up:
            return
        if self._refuses():
            self._redial(controller)
            return
        self.up = True
        self._connection += 1
        self._device.connected(self._agenda.now)
        controller.connected(self._agenda.now)
        self.flush()
        self._after()

    def _delay(self) -> float:
        return self._rng.uniform(*self._latency)
