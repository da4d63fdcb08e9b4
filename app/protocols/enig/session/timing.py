"""How long we wait, and how often we ask (PROTOCOLS 6.1)."""

from dataclasses import dataclass

from app.domain.units import Seconds


@dataclass(frozen=True, slots=True)
class Timing:
    """The session's figures. None of them comes from the source; those not in PROTOCOLS 6.1 are marked our choice.

    * ``confirm``, ``resends``: Status shows an effect within 2 s, or the command goes again, twice at most, if it may.
    * ``stale``: a device is not known any more 5 s after its last Status. ``flush``: half packets are given up.
    * ``transit``: a Status that comes so soon after a command may have been sent before the command arrived; it confirms
      nothing that was so before. Our choice: longer than a slow serial line takes both ways.
    * ``standing``: an AGV that stands so long out of position will not arrive; ``docking``: nor will one charge. Our choice.
    * ``lifting``: a lift is at an end after this (5.3), so that one that still is at none was stopped.
    * ``work``: a lift, door or lock that has begun must end within this. Our choice.
    * ``silence``: without a valid packet for so long the link is closed, since a dead one may not say so. Our choice.
    """

    confirm: Seconds = Seconds(2.0)
    resends: int = 2
    stale: Seconds = Seconds(5.0)
    flush: Seconds = Seconds(0.1)
    transit: Seconds = Seconds(0.3)
    standing: Seconds = Seconds(2.0)
    docking: Seconds = Seconds(10.0)
    lifting: Seconds = Seconds(2.0)
    work: Seconds = Seconds(30.0)
    silence: Seconds = Seconds(15.0)
