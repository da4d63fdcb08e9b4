"""Why a command is not sent, why it failed, and why a barcode looks odd, in sentences for people (PROTOCOLS 1.5, I46)."""

from collections.abc import Container
from dataclasses import replace
from typing import NamedTuple

from app.domain.commands import Command, Move, Xmove
from app.domain.layout import VehicleSpec
from app.domain.units import Seconds
from app.domain.vehicle import Condition, Mode, Oper
from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import MESSAGES, Code, Form
from app.protocols.itsc.session.link import Link
from app.protocols.itsc.session.orders import Order
from app.protocols.itsc.session.quick import codec_of
from app.protocols.itsc.session.requests import STOPS, name_of

_SAID = {Mode.MANT: "MANUAL", Mode.SEMI: "SEMI", Mode.AUTO: "AUTO", Mode.UNDEFINED: "an undefined mode"}
_NEEDS_NO_STATUS = STOPS | {Code.STATUS}
"""Sent on a stale STATUS too: a stop is on the safe side, and the vehicle refuses one that does not fit. Our choice."""


class Refused(NamedTuple):
    """Why not, and what would help."""

    reason: str
    remedy: str = ""


def refusal(
    vehicle: VehicleSpec,
    command: Command,
    code: Code,
    link: Link,
    status: tuple[Mode, Seconds] | None,
    stale: Seconds,
    in_the_way: Order | None,
) -> Refused | None:
    """Return what forbids sending the command now, None if nothing does. ``status``: newest mode, and its age."""
    name = f"vehicle {vehicle.id}"
    if not link.alive:
        return Refused(f"{name} is not connected", "check its power and its network; it is dialled again by itself")
    if link is not Link.UP or status is None:
        return Refused(f"{name} has not yet answered STATUS since it connected", "try again once it has")
    mode, age = status
    if age > stale:
        if code not in _NEEDS_NO_STATUS:
            return Refused(f"the newest STATUS of {name} is {age:.1f} s old", "try again once it answers STATUS")
    elif wrong := _wrong_mode(name, code, mode):
        return wrong
    if in_the_way is not None:
        busy = name_of(in_the_way.command)
        return Refused(f"{name} has not yet answered {busy}", "wait for its answer, or stop the vehicle")
    if isinstance(command, Move | Xmove) and len(command.path) > vehicle.max_count:
        return Refused(
            f"the path has {len(command.path)} elements, and {name} takes at most {vehicle.max_count}",
            "send the first part and extend it by XMOVE",
        )
    return None


def _wrong_mode(name: str, code: Code, mode: Mode) -> Refused | None:
    allowed = {int(each) for each in MESSAGES[code].modes}
    if len(allowed) == 3 or int(mode) in allowed:
        return None
    wanted = " or ".join(_SAID[Mode(each)] for each in sorted(allowed, reverse=True))
    return Refused(f"{name} is in {_SAID[mode]}", f"switch it to {wanted}")


def why_failed(condition: Condition) -> str:
    """Return what can be known of a RESULT 1, which carries no reason (I46)."""
    if condition.oper is Oper.ALARM:
        return f"alarm {condition.code} (0x{condition.code:04X})"
    said = [f"in {_SAID[condition.mode]}", condition.oper.name]
    flags = (("servos off", condition.servos_on), ("home not known", condition.home_known))
    said += [name for name, fine in (*flags, ("not all devices at home", condition.all_home)) if not fine]
    return f"refused or broken off without a reason; the vehicle is {', '.join(said)}"


def off_the_map(barcode: str, body: bytes, dialect: Dialect, barcodes: Container[str]) -> str:
    """Return a hint if a barcode is not on the map: which dialect would give one that is (PROTOCOLS 1.11).

    ``body`` is the RESP2 as sixteen bytes.
    """
    if barcode in barcodes:
        return ""
    width = 4 if dialect.barcode_bytes == 6 else 6
    other = replace(dialect, barcode_bytes=width)
    read = str(getattr(codec_of(other).decode_body(Form.RESP2, body), "barcode", ""))
    said = f"barcode {barcode} is not on the map"
    if read not in barcodes:
        return f"{said}: check the dialect and the layout"
    fitting = "slides" if width == 4 else "default"
    return f"{said}, but read with barcode_bytes {width} it would be {read}, which is: try dialect {fitting}"
