"""The hoist of a simulated vehicle: PICKUP, PLACE and homing, step by step (PROTOCOLS 5.1)."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import Enum

from app.domain.layout import Axis, StationKind
from app.domain.units import Pulses
from app.protocols.itsc.messages import Code
from app.protocols.itsc.simulator.agenda import Agenda, Due
from app.protocols.itsc.simulator.options import Options
from app.protocols.itsc.simulator.state import (
    BAR_OPEN,
    BAR_RAISED,
    DRIVING,
    GRIP_CLOSED,
    GRIP_OPEN,
    HOME,
    HOMING_AXES,
    SLID_LEFT,
    SLID_RIGHT,
    STOPPED,
    State,
)

_PULSED = frozenset(axis.value for axis in Axis)
_AT_REST = {"grip": GRIP_CLOSED, "sftb": BAR_RAISED}


class Effect(Enum):
    """What a step of the gripper does to a FOUP."""

    TAKE = "take"
    PUT = "put"


@dataclass(frozen=True, slots=True)
class Step:
    """One axis drives (nibble 8) and then shows ``end``; ``out``: to its target in pulses, otherwise to 0."""

    axis: str
    end: int
    out: bool = False
    effect: Effect | None = None


_OPEN_BAR, _RAISE_BAR = Step("sftb", BAR_OPEN), Step("sftb", BAR_RAISED)
_SHFT_OUT, _ROTA_OUT, _LIFT_DOWN = (Step(axis, STOPPED, out=True) for axis in ("shft", "rota", "lift"))
_SHFT_HOME, _ROTA_HOME, _LIFT_UP, _SLID_HOME = (Step(axis, HOME) for axis in HOMING_AXES)
_GRIP = (Step("grip", GRIP_OPEN), _LIFT_DOWN, Step("grip", GRIP_CLOSED, effect=Effect.TAKE), _LIFT_UP)
_RELEASE = (_LIFT_DOWN, Step("grip", GRIP_OPEN, effect=Effect.PUT), _LIFT_UP, Step("grip", GRIP_CLOSED))
_TO_PORT, _FROM_PORT = (_OPEN_BAR, _SHFT_OUT, _ROTA_OUT), (_ROTA_HOME, _SHFT_HOME, _RAISE_BAR)


def _at_buffer(side: int, work: tuple[Step, ...]) -> tuple[Step, ...]:
    return (_OPEN_BAR, Step("slid", side), *work, _SLID_HOME, _RAISE_BAR)


@dataclass(frozen=True, slots=True)
class Transfer:
    """A transfer command: where, which way, and its steps. ``tag`` is the bit of TRAV that it needs."""

    kind: StationKind
    tag: int
    picks: bool
    steps: tuple[Step, ...]


TRANSFERS: Mapping[Code, Transfer] = {
    Code.PICKUP_FROM_PORT: Transfer(StationKind.PORT, 1, picks=True, steps=(*_TO_PORT, *_GRIP, *_FROM_PORT)),
    Code.PLACE_TO_PORT: Transfer(StationKind.PORT, 1, picks=False, steps=(*_TO_PORT, *_RELEASE, *_FROM_PORT)),
    Code.PICKUP_FROM_SBFL: Transfer(StationKind.SBFL, 2, picks=True, steps=_at_buffer(SLID_LEFT, _GRIP)),
    Code.PLACE_TO_SBFL: Transfer(StationKind.SBFL, 2, picks=False, steps=_at_buffer(SLID_LEFT, _RELEASE)),
    Code.PICKUP_FROM_SBFR: Transfer(StationKind.SBFR, 4, picks=True, steps=_at_buffer(SLID_RIGHT, _GRIP)),
    Code.PLACE_TO_SBFR: Transfer(StationKind.SBFR, 4, picks=False, steps=_at_buffer(SLID_RIGHT, _RELEASE)),
}
"""The sequences of 5.1, at the default half second a step: 5 s at a port, 4 s at a side buffer."""


class Work:
    """A PICKUP or PLACE under way: its steps, the targets of SHFT, ROTA and LIFT, and whom to tell.

    ``effect`` is asked as the gripper has moved: False leaves a closing gripper empty, or a full one closed.
    """

    def __init__(
        self,
        steps: tuple[Step, ...],
        targets: Mapping[str, Pulses],
        effect: Callable[[Effect], bool],
        done: Callable[[], None],
    ) -> None:
        self.steps = steps
        self.targets = targets
        self.effect = effect
        self.done = done
        moved = [index for index, step in enumerate(steps) if step.axis in HOMING_AXES]
        self.first, self.last = moved[0], moved[-1]


class Hoist:
    """Drives SHFT, ROTA, LIFT, SLID, GRIP and SFTB, one job at a time, and keeps their nibbles in the state."""

    def __init__(self, state: State, agenda: Agenda, options: Options) -> None:
        self.state = state
        self._agenda = agenda
        self._options = options
        self._due: Due | None = None
        self._since = self._seconds = 0.0
        self._going: dict[str, Pulses | None] = {}

    def run(self, work: Work) -> None:
        """Go through the steps of a PICKUP or PLACE."""
        self._step(work, 0)

    def home(self, seconds: float, done: Callable[[], None]) -> None:
        """Bring all axes home together, close the gripper, raise the safety bar."""
        axes = self.state.axes
        self._going = {axis: Pulses(0) for axis in HOMING_AXES}
        self._going |= {axis: None for axis, rest in _AT_REST.items() if axes[axis] != rest}
        axes.update(dict.fromkeys(self._going, DRIVING))
        self._wait(seconds, lambda: self._at_home(done))

    def freeze(self) -> None:
        """Stop every axis where it is; the job is over and ``done`` is not called."""
        if self._due is None:
            return
        self._due.cancel()
        self._due = None
        share = min(1.0, (self._agenda.now - self._since) / max(self._seconds, 1e-9))
        for axis, target in self._going.items():
            self.state.axes[axis] = STOPPED
            if target is not None and axis in _PULSED:
                at = self.state.pulses[Axis(axis)]
                self.state.pulses[Axis(axis)] = Pulses(at + int((target - at) * share))
        self._going = {}
        self.state.working = False

    def jog(self, axis: Axis, pulses: Pulses) -> None:
        """Bring one axis to a position by hand; 0 is home."""
        self.state.pulses[axis] = pulses
        self.state.axes[axis.value] = HOME if pulses == 0 else STOPPED

    def _wait(self, seconds: float, then: Callable[[], None]) -> None:
        self._since, self._seconds = self._agenda.now, seconds
        self._due = self._agenda.after(seconds, then)

    def _at_home(self, done: Callable[[], None]) -> None:
        self._due = None
        self._going = {}
        self.state.axes.update(dict.fromkeys(HOMING_AXES, HOME) | _AT_REST)
        self.state.pulses.update(dict.fromkeys(Axis, Pulses(0)))
        done()

    def _step(self, work: Work, index: int) -> None:
        if index == len(work.steps):
            work.done()
            return
        step = work.steps[index]
        target = (work.targets[step.axis] if step.out else Pulses(0)) if step.axis in _PULSED else None
        self.state.working = work.first <= index <= work.last
        self.state.axes[step.axis] = DRIVING
        self._going = {step.axis: target}

        def end() -> None:
            self._due = None
            self._going = {}
            self._stop(step, target, work.effect)
            self.state.working = work.first <= index < work.last
            self._step(work, index + 1)

        self._wait(self._options.step_time, end)

    def _stop(self, step: Step, target: Pulses | None, effect: Callable[[Effect], bool]) -> None:
        nibble = step.end
        if target is not None:
            self.state.pulses[Axis(step.axis)] = target
            nibble = HOME if target == 0 else STOPPED
        done = step.effect is None or effect(step.effect)
        # A gripper that may not let go stays closed around its FOUP.
        self.state.axes[step.axis] = GRIP_CLOSED if step.effect is Effect.PUT and not done else nibble
