"""What a simulated vehicle looks at before it obeys, in the order of PROTOCOLS 5.1, rule 5."""

from collections.abc import Iterator

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.messages import Code, Enq, Etb, Message, Oper
from app.protocols.itsc.simulator.options import Options
from app.protocols.itsc.simulator.state import State
from app.protocols.itsc.simulator.transfer import TRANSFERS

_WHILE_BUSY = frozenset({Code.STATUS, Code.DISTANCE, Code.STOP, Code.STOP_BY_HOST, Code.DISPLAY_BY_HOST})
"""Allowed while a job runs; XMOVE too, during a MOVE (5.1, "Busy")."""
_NEEDS_IDLE = frozenset({Code.SEARCH_HOME, Code.GO_HOME, Code.AUTO, Code.MOVE, *TRANSFERS})
"""What moves something needs OPER = IDLE, and so does AUTO."""
_NEEDS_SERVOS = _NEEDS_IDLE
_NEEDS_HOMING = frozenset({Code.GO_HOME, Code.AUTO, Code.MOVE})
_NEEDS_HOME = frozenset({Code.AUTO, Code.MOVE, *TRANSFERS})
_TEACHES = frozenset({Code.PORT_DEST_TEACHING, Code.PORT_OFFSET_TEACHING})
_HIGHEST_TAG = 7
"""TRAV 1-7 is a set of stop tags, more is something else (1.8)."""


def objections(
    frame: Enq | Etb, message: Message | None, codec: Codec, state: State, options: Options, running: Code | None
) -> Iterator[str]:
    """Give what speaks against a command; the first decides. ``running`` is the job under way.

    What hangs on the path of a MOVE or XMOVE is found out on taking it up.
    """
    if message is None or message.kind is None or message.from_vehicle:
        return iter((f"code {frame.code:04X} is no command",))
    return _objections_to(message.kind, frame, message, codec, state, options, running)


def _objections_to(
    kind: Code, frame: Enq | Etb, message: Message, codec: Codec, state: State, options: Options, running: Code | None
) -> Iterator[str]:
    if state.mode not in message.modes:
        yield f"{message.name} is not allowed in {state.mode.name}"
    yield from codec.problems(frame)
    if running is not None and kind not in _WHILE_BUSY and (kind, running) != (Code.XMOVE, Code.MOVE):
        yield f"busy with {running.name}"
    if kind in _NEEDS_IDLE and state.oper is not Oper.IDLE:
        yield f"OPER is {state.oper.name}"
    yield from _preconditions(kind, state, options)


def _preconditions(kind: Code, state: State, options: Options) -> Iterator[str]:
    """The column "precondition beyond mode" of 5.1."""
    if kind is Code.SERVO_ON and state.oper is Oper.ALARM:
        yield "OPER is ALARM"
    if kind in _NEEDS_SERVOS and not state.servos:
        yield "S = 0"
    if kind in _NEEDS_HOMING and not state.home_known:
        yield "F = 0: not homed"
    if kind in _NEEDS_HOME and not state.all_home:
        yield "H = 0"
    if kind in _TEACHES and not state.recognised:
        yield "R = 0"
    transfer = TRANSFERS.get(kind)
    if transfer is not None:
        needed = 1 if options.stop_tag_only else transfer.tag
        if state.trav > _HIGHEST_TAG or not state.trav & needed:
            yield f"not at a {transfer.kind} stop"
        if state.foup is transfer.picks:
            yield "a FOUP is aboard" if state.foup else "no FOUP is aboard"
