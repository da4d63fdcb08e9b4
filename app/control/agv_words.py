"""What an AGV reports in the fleet's words (PROTOCOLS 3.3)."""

from enum import IntEnum

from app.domain.devices import AgvMode, AgvRun, AgvStatus, CartState, LiftState
from app.domain.units import Barcode
from app.domain.vehicle import Condition, Mode, Oper

NO_TAG = Barcode("0000")
"""LastTag before the AGV has read or been told any (PROTOCOLS 5.3)."""
_OPER = {AgvRun.STOP: Oper.IDLE, AgvRun.RUN: Oper.RUN, AgvRun.ERROR: Oper.ALARM}


def condition_of(status: AgvStatus) -> Condition:
    """Return a Status as the condition of a vehicle. ENIG has neither servos, nor homing, nor the number of an error."""
    lift_known = status.lift is not LiftState.UNKNOWN
    return Condition(
        status1=0,
        status2=0,
        mode=Mode.AUTO if status.mode is AgvMode.AUTO else Mode.MANT,
        oper=_OPER[status.run],
        code=0,
        loaded=status.cart is CartState.PRESENT,
        recognised=status.tag != NO_TAG,
        all_home=True,
        home_known=True,
        servos_on=True,
        travelling=status.run is AgvRun.RUN,
        at_tag=status.arrived,
        tags=frozenset(),
        at_rest=status.run is not AgvRun.RUN and lift_known,
        homed=lift_known,
        details=_details(status),
        agv=status,
        doubt=_doubt(status),
    )


def _doubt(status: AgvStatus) -> str:
    if status.lift is LiftState.UNKNOWN:
        return "has its lift neither up nor down: wait for it, or send agv_lift up or down"
    if status.cart is CartState.UNKNOWN:
        return "does not know whether a cart is on it: see, and set that right at the AGV"
    return ""


def _details(status: AgvStatus) -> tuple[tuple[str, int, str], ...]:
    words: tuple[tuple[str, IntEnum], ...] = (
        ("mode", status.mode),
        ("run", status.run),
        ("direction", status.steering),
        ("cart", status.cart),
        ("lift", status.lift),
    )
    flags = (("in_position", status.in_position), ("charge", status.charging))
    return (
        *((name, int(value), value.name.lower()) for name, value in words),
        *((name, int(on), "on" if on else "off") for name, on in flags),
        ("last_tag", int(status.tag) if status.tag.isdecimal() else 0, str(status.tag)),
        ("path", status.path, "moves taken, 255 is followed by 1" if status.path else "none yet"),
    )
