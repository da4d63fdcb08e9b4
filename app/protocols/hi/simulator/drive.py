"""A simulated drive: requests on one side, its panel and faults on the other (PROTOCOLS 5.2)."""

from collections.abc import Callable, Mapping

from app.domain.units import Seconds
from app.protocols.hi.dialects import DEFAULT, Dialect
from app.protocols.hi.messages import (
    ALL_DRIVES,
    ERRORS,
    LAST_DRIVE,
    OPERATIONS,
    Ack,
    Cmd,
    Content,
    Frame,
    Inputs,
    Mode,
    Number,
    Refused,
    Role,
    Setting,
    Ssa,
    content_of,
    frame_of,
)
from app.protocols.hi.simulator.options import Mischief, Options
from app.protocols.hi.simulator.state import CCW, CW, Motion, State

_ALWAYS = frozenset({Cmd.SSQ, Cmd.SET, Cmd.SRK})
"""Commands that no busy drive refuses."""


class SimulatedDrive:
    """One drive, with the id that it obeys, 1 to 15. It lives on by itself: every call first brings it up to ``now``.

    Raises: ValueError: the id is none.
    """

    def __init__(self, drive: int, dialect: Dialect = DEFAULT, options: Options | None = None) -> None:
        if not 1 <= drive <= LAST_DRIVE:
            raise ValueError(f"id {drive} is not from 1 to {LAST_DRIVE}")
        self.id = drive
        self.options = options or Options()
        self.mischief = Mischief()
        self._dialect = dialect
        self._state = State()
        self._motion = Motion(self._state, self.options.speed, self.options.jog_stop)
        self._acts: Mapping[str, Callable[[Content, Seconds], None]] = {
            Cmd.RUN: lambda _, __: self._run(),
            Cmd.SRK: lambda _, __: self._stop_or_reset(),
            Cmd.UPP: lambda _, now: self._step(1, now),
            Cmd.DWN: lambda _, now: self._step(-1, now),
            Cmd.DSK: lambda _, now: self._data_set(now),
            Cmd.SED: self._store,
            Cmd.INP: self._inputs,
        }

    def state(self, now: Seconds) -> State:
        """Return the drive's state, to be read only."""
        self._motion.bring_to(now)
        return self._state

    # The line

    def take(self, frame: Frame, now: Seconds) -> Frame | None:
        """Take a packet with a good BCC, whoever it is for; return the answer, if any."""
        self._motion.bring_to(now)
        if self.mischief.silent or frame.role is not Role.MASTER or frame.id not in (self.id, ALL_DRIVES):
            return None
        answer = self._obey(frame, now)
        return None if frame.id == ALL_DRIVES else self._sent(answer)

    def take_broken(self, frame: Frame, now: Seconds) -> Frame | None:
        """Take a packet whose BCC is wrong: NAK, if it is for this drive."""
        self._motion.bring_to(now)
        if self.mischief.silent or frame.role is not Role.MASTER or frame.id != self.id:
            return None
        return self._sent(self._answer(Cmd.NAK, Refused()))

    def _sent(self, answer: Frame) -> Frame | None:
        if self.mischief.answers_lost:
            self.mischief.answers_lost -= 1
            return None
        return answer

    def _answer(self, cmd: Cmd, content: Content) -> Frame:
        return frame_of(Role.SLAVE, self.id, cmd, content, self._dialect)

    def _obey(self, frame: Frame, now: Seconds) -> Frame:
        content = content_of(frame, self._dialect)
        # The worked example's command says nothing of what it does: it is taken, and does nothing (H3).
        unknown = content is None and frame.cmd != Cmd.PDT
        if unknown or self.mischief.naks:
            self.mischief.naks -= 0 if unknown else 1
            return self._answer(Cmd.NAK, Refused())
        if self._is_busy(frame.cmd, content, now):
            return self._answer(Cmd.BSY, Refused())
        if isinstance(content, Number):
            return self._answer(Cmd.SET, Setting(content.number, self._state.values[content.number]))
        if frame.cmd == Cmd.SSQ:
            return self._answer(Cmd.SSA, self._status())
        if content is not None:
            self._acts[frame.cmd](content, now)
        return self._answer(Cmd.ACK, Ack(self._state.mode))

    def _is_busy(self, cmd: str, content: Content | None, now: Seconds) -> bool:
        if cmd in _ALWAYS:
            return False
        if self.mischief.busies:
            self.mischief.busies -= 1
            return True
        state = self._state
        moves = cmd in (Cmd.RUN, Cmd.UPP, Cmd.DWN) or (isinstance(content, Inputs) and content.run == 1)
        return now < state.busy_until or (state.running and moves)

    def _status(self) -> Ssa:
        state = self._state
        status = state.error if state.mode is Mode.ERROR else state.operation
        if not self.options.long_status:
            return Ssa(state.mode, state.output, status)
        return Ssa(state.mode, state.output, status, state.direction, state.distance)

    # What the commands do

    def _run(self) -> None:
        state = self._state
        if state.mode is not Mode.ERROR:
            state.mode = Mode.MONITORING
            state.start(state.direction, jog=False)

    def _stop_or_reset(self) -> None:
        state = self._state
        state.stop()
        if state.mode is Mode.ERROR and not state.cause_remains:
            state.mode, state.error = Mode.PARAMETER_SELECT, 0

    def _step(self, by: int, now: Seconds) -> None:
        state = self._state
        if state.mode is Mode.PARAMETER_SELECT:
            state.selected = (state.selected + by) % 256
        elif state.mode is Mode.PARAMETER_VALUE:
            state.shown = min(max(state.shown + by, 0), self._dialect.highest_value)
        elif state.mode is Mode.JOG:
            state.last_jog = now
            state.start(CW if by > 0 else CCW, jog=True)

    def _data_set(self, now: Seconds) -> None:
        state = self._state
        if state.mode is Mode.PARAMETER_SELECT:
            state.mode, state.shown = Mode.PARAMETER_VALUE, state.values[state.selected]
        elif state.mode is Mode.PARAMETER_VALUE:
            state.values[state.selected] = state.shown
            state.mode, state.busy_until = Mode.PARAMETER_SELECT, Seconds(now + self.options.storing)

    def _store(self, content: Content, now: Seconds) -> None:
        if isinstance(content, Setting):
            self._state.values[content.number] = content.value
            self._state.busy_until = Seconds(now + self.options.storing)

    def _inputs(self, content: Content, now: Seconds) -> None:
        if not isinstance(content, Inputs):
            return
        state = self._state
        state.step = content.steps
        state.limited = frozenset(way for way, on in ((CW, content.r_limit), (CCW, content.l_limit)) if on)
        if content.run:
            self._run()
        if content.home and state.mode is not Mode.ERROR:
            state.start(state.direction, jog=False)
            state.home_at = Seconds(now + self.options.homing) if state.running else None
        if state.moving and state.direction in state.limited:
            state.stop()

    # The panel, and the world

    def panel_mode(self, mode: Mode, now: Seconds) -> None:
        """Choose a mode at the drive, which stops it; mode 4 comes from errors alone (H18). Raises: ValueError."""
        if mode is Mode.ERROR:
            raise ValueError("mode 4 is entered by an error, not from the panel")
        self._motion.bring_to(now)
        self._state.stop()
        self._state.mode, self._state.error = Mode(mode), 0

    def fail(self, error: int, now: Seconds, *, cause_remains: bool = False) -> None:
        """Stop with an error, 1 to 16, which Stop/Reset clears unless its cause remains. Raises: ValueError: no such error."""
        if error not in ERRORS:
            raise ValueError(f"error {error} is not from 1 to {max(ERRORS)}")
        self._motion.bring_to(now)
        self._state.stop()
        self._state.mode, self._state.error, self._state.cause_remains = Mode.ERROR, error, cause_remains

    def clear_cause(self) -> None:
        """Remove what caused the error; Stop/Reset will clear it now."""
        self._state.cause_remains = False

    def set_operation(self, operation: int) -> None:
        """Choose what the drive is doing, FF 0 to 5. Raises: ValueError: no such operation."""
        if operation not in OPERATIONS:
            raise ValueError(f"operation {operation} is not from 0 to {max(OPERATIONS)}")
        self._state.operation = operation

    def set_output(self, output: int) -> None:
        """Set the output number, 0 to 7. Raises: ValueError: no such output."""
        if not 0 <= output <= 7:
            raise ValueError(f"output {output} is not from 0 to 7")
        self._state.output = output

    def set_value(self, number: int, value: int) -> None:
        """Give a parameter a value at the panel. Raises: ValueError: it cannot be sent."""
        if not (0 <= number <= 255 and 0 <= value <= self._dialect.highest_value):
            raise ValueError(f"parameter {number} = {value} is out of range")
        self._state.values[number] = value
