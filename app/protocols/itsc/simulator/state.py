"""What a simulated vehicle says of itself: the two status words and the tail of its answers (PROTOCOLS 1.7-1.9, 5.1)."""

from dataclasses import dataclass, field

from app.domain.layout import Axis
from app.domain.units import Barcode, Pulses
from app.protocols.itsc.messages import Action, Mode, Oper, Status1, Status2
from app.protocols.itsc.simulator.options import Options

STOPPED = 0
HOME = 1
DRIVING = 8
NOT_READY = 11
GRIP_OPEN = 1
GRIP_CLOSED = 3
BAR_OPEN = 3
BAR_RAISED = 4
SLID_LEFT = 5
SLID_RIGHT = 6

HOMING_AXES = ("shft", "rota", "lift", "slid")
"""H is 1 when all of these are at home (5.1)."""

STOP_TAGS = {
    Action.STOP: 0,
    Action.STOP_PORT: 1,
    Action.STOP_PORT_UNPREPARED: 1,
    Action.STOP_SBFL: 2,
    Action.STOP_SBFR: 4,
}
"""TRAV after each stop (5.1, MOVE)."""


def _axes_at_start() -> dict[str, int]:
    return dict.fromkeys(HOMING_AXES, HOME) | {"grip": GRIP_CLOSED, "sftb": BAR_RAISED}


@dataclass(slots=True)
class State:
    """The state of 5.1. ``axes`` holds the nibbles as they are with servos on; without, the words show 11.

    ``working`` keeps H at 0 from the first axis movement of PICKUP or PLACE to the last, whatever the targets.
    ``barcode`` is None until one is recognised; the wire then shows 0.
    """

    mode: Mode = Mode.MANT
    oper: Oper = Oper.IDLE
    alarm: int = 0
    cause_remains: bool = False
    moving: bool = False
    """A MOVE runs: CODE is the process code."""
    driving: bool = False
    tag: int = 0
    foup: bool = False
    servos: bool = False
    home_known: bool = False
    recognised: bool = False
    working: bool = False
    axes: dict[str, int] = field(default_factory=_axes_at_start)
    pulses: dict[Axis, Pulses] = field(default_factory=lambda: dict.fromkeys(Axis, Pulses(0)))
    barcode: Barcode | None = None
    seq: int = 0
    shown_text: str = ""
    shown_alarm: int | None = None

    @property
    def all_home(self) -> bool:
        """H. False while the servos are off, for LIFT and SLID then show 11."""
        return self.servos and not self.working and all(self.axes[axis] == HOME for axis in HOMING_AXES)

    @property
    def trav(self) -> int:
        """The TRAV nibble."""
        if not self.servos:
            return NOT_READY
        return DRIVING if self.driving else self.tag

    def status1(self, options: Options) -> Status1:
        """Return STATUS1."""
        shown = dict(self.axes)
        if not self.servos:
            shown["lift"] = shown["slid"] = NOT_READY
            if options.rota_servo_codes:
                shown["rota"] = NOT_READY
        return Status1(foup=self.foup, trav=self.trav, **shown)

    def status2(self, options: Options) -> Status2:
        """Return STATUS2; CODE is the alarm's if there is one, otherwise the process code."""
        process = options.process_code if self.moving else 0
        return Status2(
            mode=self.mode,
            oper=self.oper,
            at_barcode=self.recognised,
            all_home=self.all_home,
            home_known=self.home_known,
            servos_on=self.servos,
            code=self.alarm if self.oper is Oper.ALARM else process,
        )

    def servos_off(self) -> None:
        """S = 0."""
        self.servos = False
        self.tag = 0

    def servos_on(self) -> None:
        """S = 1: what showed 11 becomes 1 if at home, else 0."""
        self.servos = True
        self.tag = 0
        for axis in ("lift", "slid"):
            if self.axes[axis] != HOME:
                self.axes[axis] = STOPPED

    def restarted(self) -> "State":
        """Return the start-up state of a vehicle whose axes and FOUP are where they are."""
        axes = {axis: STOPPED if nibble == DRIVING else nibble for axis, nibble in self.axes.items()}
        return State(foup=self.foup, axes=axes, pulses=dict(self.pulses))
