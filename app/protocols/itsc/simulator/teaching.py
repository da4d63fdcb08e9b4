"""Teaching events of a simulated vehicle (PROTOCOLS 1.5, 5.1)."""

from collections.abc import Callable, Mapping

from app.domain.layout import Axis
from app.protocols.itsc.messages import Code

DEST_TEACHING = (Code.SHFT_DEST_TEACHING, Code.ROTA_DEST_TEACHING, Code.LIFT_DEST_TEACHING)
OFFSET_TEACHING = (Code.SHFT_OFFSET_TEACHING, Code.ROTA_OFFSET_TEACHING, Code.LIFT_OFFSET_TEACHING)
"""What PORT DEST TEACHING and PORT OFFSET TEACHING send, in this order."""

TAUGHT_AXIS: Mapping[Code, Axis] = {
    code: axis for codes in (DEST_TEACHING, OFFSET_TEACHING) for code, axis in zip(codes, Axis, strict=True)
}

Told = Callable[[], None]
Teach = Callable[[Code, Told, Told], None]
"""Sends one event, and calls the first when it is acknowledged, the second when it is given up."""


def teach_each(codes: tuple[Code, ...], teach: Teach, goes_on: Callable[[], bool], done: Callable[[int], None]) -> None:
    """Send the events, each after the ACK of the one before; ``done`` gets the RESULT, unless the job no longer ``goes_on``."""

    def after_ack(rest: tuple[Code, ...]) -> None:
        if not goes_on():
            return
        if rest:
            teach(rest[0], lambda: after_ack(rest[1:]), lost)
        else:
            done(0)

    def lost() -> None:
        if goes_on():
            done(1)

    after_ack(codes)
