"""What all simulated devices do: live in their own time, report on every change and each second (PROTOCOLS 5.3, E14)."""

from collections.abc import Callable
from dataclasses import replace

from app.domain.devices import DeviceNumber
from app.domain.units import Seconds
from app.protocols.enig.messages import AgvReport, Body, BufferReport, DoorReport
from app.wire.agenda import Agenda

Report = AgvReport | BufferReport | DoorReport


class SimulatedDevice:
    """A device on a link. ``tick`` it at ``deadline``, connected or not; ``said`` gives what it wants to send.

    ``on`` is False while it has no power: it neither hears nor says anything, and nothing in it moves.
    """

    def __init__(self, number: DeviceNumber, report: Report, status_every: Seconds) -> None:
        self.number = number
        self.on = True
        self._state: Report = report
        self._told = replace(report)
        self._every = status_every
        self._agenda = Agenda()
        self._said: list[tuple[float, Body]] = []
        self._agenda.after(status_every, self._periodically)

    @property
    def deadline(self) -> Seconds | None:
        """When ``tick`` wants to be called next."""
        due = self._agenda.deadline
        return None if due is None else Seconds(due)

    def tick(self, now: Seconds) -> None:
        """Let everything happen that is due."""
        self._agenda.run(now)

    def take(self, body: Body, now: Seconds) -> None:
        """Take a command that is sound and for this device."""
        self._agenda.run(now)
        if self.on:
            self._obey(body)
            self._settle()

    def said(self) -> list[tuple[float, Body]]:
        """Return and forget what the device has sent, and when."""
        said, self._said = self._said, []
        return said

    def power_off(self, now: Seconds) -> None:
        """Cut the power: it falls silent, and what it was at ends where it is."""
        self._agenda.run(now)
        self.on = False
        self._freeze()
        self._agenda.clear()

    def power_on(self, now: Seconds) -> None:
        """Give power again: it reports in its start-up state after a period."""
        self._agenda.run(now)
        self.on = True
        self._restart()
        self._told = replace(self._state)
        self._agenda.after(self._every, self._periodically)

    def _obey(self, body: Body) -> None:
        raise NotImplementedError

    def _restart(self) -> None:
        raise NotImplementedError

    def _freeze(self) -> None:
        """The power is gone: what moves stands."""

    def _after(self, seconds: float, act: Callable[[], None]) -> Callable[[], None]:
        """Let something happen later, and what changes by it be reported; return what prevents it."""

        def then() -> None:
            act()
            self._settle()

        return self._agenda.after(seconds, then).cancel

    def _say(self, body: Body) -> None:
        if self.on:
            self._said.append((self._agenda.now, body))

    def _settle(self) -> None:
        """Report if anything has changed."""
        if self._state != self._told:
            self._report()

    def _report(self) -> None:
        self._told = replace(self._state)
        self._say(replace(self._state))

    def _periodically(self) -> None:
        self._report()
        self._agenda.after(self._every, self._periodically)
