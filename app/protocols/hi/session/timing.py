"""How long we wait, and how often we ask (PROTOCOLS 6.1, 2.6)."""

from dataclasses import dataclass

from app.domain.units import Seconds
from app.protocols.hi.messages import Cmd


@dataclass(frozen=True, slots=True)
class Timing:
    """The line's figures; those not in PROTOCOLS are marked our choice.

    * ``t2``: from the end of a request to the first byte of its answer. ``character``: one character at 9600 8N1, with a
      little air. ``longest``: characters of the longest answer. ``margin``: what the way to the port may take on top; a
      serial server behind a network needs more.
    * ``retries``: transmissions after the first. ``busy_repeat``, ``busy_repeats``: BSY is no failure (H9, H10).
    * ``probe``: a drive that is offline is asked this often.
    * ``poll``: each drive's status is asked this often where the line has time for it. Our choice.
    * ``jog``: from the start of one jog key to the start of the next (H17).
    * ``all_keys``, ``all_write``: how long the line rests after telling all drives (H20).
    * ``gap``: silence before we speak again, about four characters, so that an answer that comes twice is not taken for
      the answer to the next question. Our choice.
    """

    t2: Seconds = Seconds(0.1)
    character: Seconds = Seconds(0.00105)
    longest: int = 26
    margin: Seconds = Seconds(0.01)
    retries: int = 4
    busy_repeat: Seconds = Seconds(0.4)
    busy_repeats: int = 10
    probe: Seconds = Seconds(5.0)
    poll: Seconds = Seconds(1.0)
    jog: Seconds = Seconds(0.05)
    all_keys: Seconds = Seconds(0.1)
    all_write: Seconds = Seconds(0.5)
    gap: Seconds = Seconds(0.0042)

    @property
    def rest_of_answer(self) -> Seconds:
        """How long an answer may take from its first byte on."""
        return Seconds(self.longest * self.character + self.margin)

    def answer(self, size: int) -> Seconds:
        """Return how long the whole answer may take from the moment at which a request of this size is handed over."""
        return Seconds(size * self.character + self.t2 + self.rest_of_answer)

    def told_all(self, size: int, cmd: Cmd) -> Seconds:
        """Return how long the line rests from the moment at which a request of this size to all drives is handed over."""
        return Seconds(size * self.character + (self.all_write if cmd is Cmd.SED else self.all_keys))
