"""The state of a simulated drive, and its motion (PROTOCOLS 5.2)."""

from dataclasses import dataclass, field

from app.domain.units import Seconds
from app.protocols.hi.messages import Mode

CW, CCW = 0, 1
FURTHEST = 1_000_000
"""Hundredths at which the six digits of the distance begin anew."""


@dataclass(slots=True)
class State:
    """``distance`` counts hundredths moved in ``direction`` since the drive last turned round or was homed (our choice).

    ``selected`` is the parameter shown, ``shown`` its value while it is edited. ``step`` is the last one chosen by INP;
    ``limited`` the directions in which a limit input holds the drive.
    """

    mode: Mode = Mode.MONITORING
    running: bool = False
    jogging: bool = False
    operation: int = 0
    error: int = 0
    cause_remains: bool = False
    output: int = 0
    direction: int = CW
    distance: int = 0
    values: list[int] = field(default_factory=lambda: [0] * 256)
    selected: int = 0
    shown: int = 0
    step: int = 0
    limited: frozenset[int] = frozenset()
    busy_until: Seconds = Seconds(0.0)
    last_jog: Seconds = Seconds(0.0)
    home_at: Seconds | None = None

    @property
    def moving(self) -> bool:
        """Whether the axis turns."""
        return self.running or self.jogging

    def stop(self) -> None:
        """Stand still."""
        self.running = self.jogging = False
        self.home_at = None

    def start(self, direction: int, *, jog: bool) -> None:
        """Turn, unless a limit forbids it."""
        if direction in self.limited:
            self.stop()
            return
        if direction != self.direction:
            self.direction, self.distance = direction, 0
        self.running, self.jogging = not jog, jog


class Motion:
    """Brings a state up to a moment. Fractions of a hundredth are kept, so that many small steps add up."""

    def __init__(self, state: State, speed: int, jog_stop: Seconds) -> None:
        self._state = state
        self._speed = speed
        self._jog_stop = jog_stop
        self._at = 0.0
        self._rest = 0.0

    def bring_to(self, now: Seconds) -> None:
        """Let everything happen until now; a clock that went back is ignored."""
        state = self._state
        end = state.last_jog + self._jog_stop
        if state.jogging and now >= end:
            self._move(end)
            state.stop()
        if state.home_at is not None and now >= state.home_at:
            self._move(state.home_at)
            state.stop()
            state.distance = 0
        self._move(now)

    def _move(self, until: float) -> None:
        if self._state.moving:
            moved = max(0.0, until - self._at) * self._speed + self._rest
            # What is a whole hundredth but for the last bit of a float counts as one.
            whole = int(moved + 1e-6)
            self._rest = moved - whole
            self._state.distance = (self._state.distance + whole) % FURTHEST
        else:
            self._rest = 0.0
        self._at = max(self._at, until)
