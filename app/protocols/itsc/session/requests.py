"""Commands of the domain as packets of the wire (PROTOCOLS 1.5, 1.6)."""

from typing import assert_never

from app.domain.commands import Command, Direct, Display, Move, Pickup, Place, Plain, Send, Simple, Xmove
from app.domain.errors import EncodeError
from app.domain.layout import StationKind
from app.domain.route import PathElement
from app.protocols.itsc import messages
from app.protocols.itsc.condition import barcode_value
from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import NOTHING, Body, Code, Enq, Etb

TC_ALARMS = range(0x8000, 0x10000)
"""Alarm numbers that DISPLAY may raise without meeting the vehicle's own (I45)."""

_PLAIN = {
    Plain.STATUS: Code.STATUS,
    Plain.STOP: Code.STOP,
    Plain.STOP_BY_HOST: Code.STOP_BY_HOST,
    Plain.SERVO_ON: Code.SERVO_ON,
    Plain.SERVO_OFF: Code.SERVO_OFF,
    Plain.SEARCH_HOME: Code.SEARCH_HOME,
    Plain.GO_HOME: Code.GO_HOME,
    Plain.SYSTEM_RESET: Code.SYSTEM_RESET,
    Plain.ALARM_CLEAR: Code.ALARM_CLEAR,
    Plain.AUTO: Code.AUTO,
    Plain.PORT_DEST_TEACHING: Code.PORT_DEST_TEACHING,
    Plain.PORT_OFFSET_TEACHING: Code.PORT_OFFSET_TEACHING,
}
_PICKUP = {
    StationKind.PORT: Code.PICKUP_FROM_PORT,
    StationKind.SBFL: Code.PICKUP_FROM_SBFL,
    StationKind.SBFR: Code.PICKUP_FROM_SBFR,
}
_PLACE = {
    StationKind.PORT: Code.PLACE_TO_PORT,
    StationKind.SBFL: Code.PLACE_TO_SBFL,
    StationKind.SBFR: Code.PLACE_TO_SBFR,
}

STOPS = frozenset({Code.STOP, Code.STOP_BY_HOST})
MOTION = frozenset(
    {Code.MOVE, Code.XMOVE, *_PICKUP.values(), *_PLACE.values(), Code.SEARCH_HOME, Code.GO_HOME}
    | {Code.PORT_DEST_TEACHING, Code.PORT_OFFSET_TEACHING}
)
"""The vehicle's jobs: while one runs it refuses another (PROTOCOLS 5.1, Busy)."""


def code_of(command: Command) -> Code:
    """Return the code under which the command and its answer travel. Raises: EncodeError: iTSC has no such command."""
    match command:
        case Move():
            return Code.MOVE
        case Xmove():
            return Code.XMOVE
        case Pickup():
            return _PICKUP[command.at]
        case Place():
            return _PLACE[command.at]
        case Simple():
            return _PLAIN[command.what]
        case Display():
            return Code.DISPLAY_BY_HOST
        case Direct():
            raise EncodeError("iTSC has no command of an AGV", remedy="send it to an AGV")
    assert_never(command)


def frame_of(send: Send, dev_id: int, dialect: Dialect) -> Enq | Etb:
    """Return the command as a packet. Raises: EncodeError: iTSC, or this dialect, cannot say it."""
    code, command = int(code_of(send.command)), send.command
    match command:
        case Move():
            path = _path(command.path, dialect)
            move = messages.Move(path, command.foup_id, command.source, command.destination)
            return Etb(dev_id, send.cmd_id, code, move)
        case Xmove():
            return Etb(dev_id, send.cmd_id, code, messages.Xmove(_path(command.path, dialect)))
        case Pickup() | Place():
            return Enq(dev_id, send.cmd_id, code, _transfer(command))
        case Simple():
            return Enq(dev_id, send.cmd_id, code, NOTHING)
        case Display():
            return Enq(dev_id, send.cmd_id, code, _display(command))
        case Direct():
            raise EncodeError("iTSC has no command of an AGV", remedy="send it to an AGV")
    assert_never(command)


def _path(path: tuple[PathElement, ...], dialect: Dialect) -> list[messages.Element]:
    return [
        messages.Element(
            barcode_value(element.barcode, dialect.barcode_format),
            element.seq,
            element.sensor,
            int(element.action),
            element.speed,
            dist_act=0,
            dist_next=element.to_next if dialect.has_dist else 0,
        )
        for element in path
    ]


def _transfer(command: Pickup | Place) -> Body:
    if command.at is not StationKind.PORT:
        return messages.Sbuf(command.speed)
    if command.target is None:
        raise EncodeError("a port needs target pulses", remedy="teach the port, or give its pulses in the plant file")
    target = command.target
    return messages.Port(target.shft, target.rota, target.lift, command.look_down, command.speed)


def _display(command: Display) -> Body:
    if command.alarm is None:
        return messages.Disp(0, 0, command.text)
    if command.alarm not in TC_ALARMS:
        raise EncodeError(
            f"alarm 0x{command.alarm:04X} may be one of the vehicle's own",
            remedy=f"choose a number from 0x{TC_ALARMS[0]:04X} to 0x{TC_ALARMS[-1]:04X}",
        )
    return messages.Disp(command.alarm, 1, command.text)


def name_of(command: Command) -> str:
    """Return a command's name for a sentence, such as ``PICKUP FROM PORT``."""
    return messages.MESSAGES[code_of(command)].name
