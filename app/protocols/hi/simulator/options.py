"""What can be set on a simulated drive: the figures that PROTOCOLS 5.2 gives as defaults, and faults."""

from dataclasses import dataclass

from app.domain.units import Seconds


@dataclass(frozen=True, slots=True)
class Options:
    """Times in seconds; the defaults are PROTOCOLS 5.2's unless marked as our choice."""

    t2: Seconds = Seconds(0.005)
    """From the end of a request to the first byte of its answer."""
    storing: Seconds = Seconds(0.3)
    """How long the drive is busy after SED, and after DSK has stored a value."""
    jog_stop: Seconds = Seconds(0.15)
    """How long a jog goes on after the last key (H17)."""
    long_status: bool = True
    """Whether SSA has direction and distance (H6)."""
    speed: int = 1000
    """Hundredths of a millimetre per second: 0.5 mm per 50 ms. Running is as fast as jogging: our choice."""
    homing: Seconds = Seconds(2.0)
    """How long a home search takes. Our choice."""


@dataclass(slots=True)
class Mischief:
    """Faults of a drive that can be turned on and off while it runs; the counters count down."""

    silent: bool = False
    """It neither takes nor says anything, as if its cable were pulled; what it does goes on."""
    answers_lost: int = 0
    """So many answers never leave, though what was asked was done."""
    naks: int = 0
    """So many good requests are taken for broken ones."""
    busies: int = 0
    """So many requests that are no status, parameter or stop meet a busy drive."""
    late: Seconds = Seconds(0.0)
    """Added to the turnaround of every answer."""
