"""What an operation asks of the line, and what the line makes of it.

An operation is a generator: it yields a step, gets the outcome sent back, and returns its verdict.
"""

from collections.abc import Generator
from dataclasses import dataclass
from enum import Enum, auto

from app.domain.drive import DriveResult, DriveStatus
from app.domain.units import Seconds
from app.protocols.hi.messages import NOTHING, Ack, Cmd, Content, Setting, Ssa


class Repeat(Enum):
    """When a request is sent again by itself (COMMANDS section 1)."""

    ALWAYS = auto()
    """After silence too: twice does no more than once."""
    REFUSED = auto()
    """Only after NAK or BSY, which say that it was not taken."""
    NEVER = auto()


@dataclass(frozen=True, slots=True)
class Ask:
    """Send this and await the answer; address 0 awaits none."""

    address: int
    cmd: Cmd
    content: Content = NOTHING
    repeat: Repeat = Repeat.ALWAYS


@dataclass(frozen=True, slots=True)
class Pause:
    """Go on at this moment, when the line is free."""

    until: Seconds


Step = Ask | Pause


@dataclass(frozen=True, slots=True)
class Heard:
    """The fit answer."""

    content: Ack | Setting | Ssa


@dataclass(frozen=True, slots=True)
class Missed:
    """No fit answer, and why. ``maybe``: the request may have been taken all the same."""

    reason: str
    maybe: bool


@dataclass(frozen=True, slots=True)
class Woken:
    """The pause is over, or all drives have been told."""

    now: Seconds


Outcome = Heard | Missed | Woken


@dataclass(frozen=True, slots=True)
class Done:
    """Carried out."""

    result: DriveResult


@dataclass(frozen=True, slots=True)
class Failed:
    """Not carried out."""

    reason: str
    remedy: str = ""


@dataclass(frozen=True, slots=True)
class Unknown:
    """Carried out or not."""

    reason: str
    status: DriveStatus | None = None


Verdict = Done | Failed | Unknown

Script = Generator[Step, Outcome, Verdict | None]
"""An operation; without a verdict if nobody waits for one."""
