"""How long we wait, and how often we ask (PROTOCOLS 6.1)."""

from dataclasses import dataclass
from typing import assert_never

from app.domain.commands import Command, Direct, Display, Move, Pickup, Place, Plain, Simple, Xmove
from app.domain.units import Seconds


@dataclass(frozen=True, slots=True)
class Timing:
    """The session's figures. None of them comes from the source; those not in PROTOCOLS 6.1 are marked our choice.

    * ``ack``, ``resends``: an ACK is due within a second; without one the same bytes go again, three times.
    * ``poll``: STATUS is asked each second, start to start; ``silence`` without a valid packet is a dead link.
    * ``flush``: bytes that are no whole packet are given up after this silence; shorter than ``ack``.
    * ``status``: answers to STATUS and DISPLAY. ``transfer``: answers to PICKUP and PLACE.
    * ``move_factor``, ``move_extra``: a MOVE's answer is due after factor x planned time + extra, counted from its ACK and
      again from each rise of SEQ and each STATUS with OPER = PAUSE.
    * ``xmove``: 2 s, since it is answered at once. Our choice.
    * ``homing``: 60 s for SEARCH HOME and GO HOME, whose axes may have their whole stroke to go. Our choice.
    * ``teaching``: 30 s for three events, each with up to four transmissions. Our choice.
    * ``other``: 10 s for the rest. Our choice: longer than braking from full speed.
    * ``stale``: a STATUS older than this decides nothing: one poll and its time to answer have passed. Our choice.
    """

    ack: Seconds = Seconds(1.0)
    resends: int = 3
    poll: Seconds = Seconds(1.0)
    silence: Seconds = Seconds(3.5)
    flush: Seconds = Seconds(0.2)
    status: Seconds = Seconds(2.0)
    transfer: Seconds = Seconds(120.0)
    move_factor: float = 2.0
    move_extra: Seconds = Seconds(30.0)
    xmove: Seconds = Seconds(2.0)
    homing: Seconds = Seconds(60.0)
    teaching: Seconds = Seconds(30.0)
    other: Seconds = Seconds(10.0)
    stale: Seconds = Seconds(3.0)

    def drive(self, planned: Seconds) -> Seconds:
        """Return how long the answer to a MOVE of this planned driving time may take."""
        return Seconds(self.move_factor * planned + self.move_extra)

    def answer(self, command: Command) -> Seconds:
        """Return how long the answer may take once the command is acknowledged."""
        match command:
            case Move():
                return self.drive(command.planned)
            case Xmove():
                return self.xmove
            case Pickup() | Place():
                return self.transfer
            case Display() | Direct():
                return self.status
            case Simple():
                return self._simple(command.what)
        assert_never(command)

    def _simple(self, what: Plain) -> Seconds:
        match what:
            case Plain.STATUS:
                return self.status
            case Plain.SEARCH_HOME | Plain.GO_HOME:
                return self.homing
            case Plain.PORT_DEST_TEACHING | Plain.PORT_OFFSET_TEACHING:
                return self.teaching
            case _:
                return self.other
