"""What the fleet knows of one vehicle at this moment."""

from dataclasses import dataclass, field
from enum import StrEnum

from app.domain.commands import Plain
from app.domain.ids import Actor, CmdId, JobId, StationId, VehicleId
from app.domain.layout import PulseSet, StopAction, VehicleKind, VehicleSpec
from app.domain.records import Intent, VehicleRecord
from app.domain.route import PathElement
from app.domain.units import Barcode, Millimetres, Seconds
from app.domain.vehicle import Mode, Oper, VehicleStatus

HANDLINGS = frozenset({"pickup", "place"})
"""Kinds of command that move a carrier: F alone tells what became of them."""


class Stage(StrEnum):
    """How far we know where the vehicle is and what it is doing."""

    ABSENT = "absent"
    """No link. What it held, it holds."""
    SETTLING = "settling"
    """Linked; asked by STATUS until two answers agree and it is at rest (COMMANDS section 3)."""
    READY = "ready"
    """Known: place, load, and every command settled."""


class Purpose(StrEnum):
    """Why a vehicle is sent somewhere."""

    SOURCE = "source"
    DESTINATION = "destination"
    PERSON = "person"
    GIVE_WAY = "give_way"
    PARK = "park"
    BACK_OUT = "back_out"
    """Out of the way of one that waits for it as it waits for that one: its job goes on afterwards."""
    CHARGE = "charge"


@dataclass(frozen=True, slots=True)
class Errand:
    """Where a vehicle is to go, how to stop there, and why."""

    goal: Barcode
    action: StopAction
    purpose: Purpose


@dataclass(frozen=True, slots=True)
class Amendment:
    """An XMOVE under way: the elements that take the place of the present path from ``path[0].seq`` on."""

    cmd_id: CmdId
    path: tuple[PathElement, ...]
    intent: Intent


@dataclass(slots=True)
class Drive:
    """The open MOVE. ``path`` is what the vehicle is known to have (amendments count once accepted).

    ``acknowledged`` is when its ACK came; ``answered``: RESP1 RESULT 0 came before it stood at the end (vehicles that answer
    on acceptance, PROTOCOLS I19); ``stopping``: an XMOVE was refused, it runs to its end. ``recalled``: we have stopped it
    ourselves, so that its abnormal end says nothing against the vehicle. ``driven`` is the way since it set out, up to the last
    barcode that it has read, and ``read`` when that was.
    """

    cmd_id: CmdId
    path: tuple[PathElement, ...]
    intent: Intent
    acknowledged: Seconds | None = None
    answered: bool = False
    stopping: bool = False
    recalled: bool = False
    amendment: Amendment | None = None
    driven: Millimetres = Millimetres(0)
    read: Seconds | None = None

    @property
    def end(self) -> PathElement:
        """The present STOP element."""
        return self.path[-1]

    def completed_by(self, status: VehicleStatus, asked_at: Seconds) -> bool:
        """Whether this polled STATUS shows the MOVE done: standing at the last element, asked after the vehicle had it."""
        condition = status.condition
        ends = {self.end.barcode}
        if self.amendment:
            if not self.stopping:
                return False
            ends.add(self.amendment.path[-1].barcode)
        return (
            self.acknowledged is not None
            and asked_at > self.acknowledged
            and status.barcode in ends
            and (status.seq == self.end.seq or self.amendment is not None)
            and not condition.travelling
            and condition.recognised
            and condition.mode is Mode.AUTO
            and condition.oper is Oper.IDLE
        )

    def broken_off_by(self, status: VehicleStatus, asked_at: Seconds) -> bool:
        """Whether a MOVE that was answered on acceptance (I19) has ended without a word: idle, and not at its end."""
        condition = status.condition
        started = self.answered and self.acknowledged is not None and asked_at > self.acknowledged
        return started and condition.oper is Oper.IDLE and not condition.travelling


@dataclass(slots=True)
class Handling:
    """An open PICKUP or PLACE. ``answered`` is when RESULT 0 came; then F must agree in a later STATUS."""

    cmd_id: CmdId
    intent: Intent
    pickup: bool
    station: StationId
    job: JobId | None
    started: Seconds
    answered: Seconds | None = None


@dataclass(slots=True)
class AlarmRecovery:
    """The sequence of PROTOCOLS 6.2 on its way: the command under way, or None while a fresh STATUS is awaited.

    ``done`` is the last command answered RESULT 0: where that comes on acceptance (I19), its effect may still be awaited.
    """

    actor: Actor
    confirmed: bool
    since: Seconds
    waiting: CmdId | None = None
    done: Plain | None = None


@dataclass(slots=True)
class HandleOrder:
    """One PICKUP or PLACE that a person asked for without a job."""

    station: StationId
    pickup: bool
    actor: Actor
    target: PulseSet | None


@dataclass(slots=True)
class VehicleNow:
    """A vehicle at this moment. ``record`` is its durable part, as last saved or about to be.

    ``trail`` maps each barcode it covers to its distance behind the present one (mm; the present one 0); ``ahead`` are the
    barcodes granted beyond it in order; ``rest`` the way from there to the errand's goal, not yet granted. ``way`` are the
    barcodes that it is known to have come by, newest last, as far back as it is long and one more; ``beyond`` the next ones
    that it may be on its way to though it has not read them: it was stopped, or is not settled.
    ``opened`` are the intents whose outcome is not known yet, by CMD_ID. ``agreed`` is the first of the two STATUS that must
    agree; ``trusted``: a named person vouched for what it reports next.
    ``missed`` counts handlings or moves in a row that ended abnormally. ``teaching`` is its open teaching session.
    ``toward`` is the tag on the way to which an AGV was stopped: it stands between there and its ``barcode``. ``kept`` says
    why no job is given to it though it is idle; ``trips`` counts the carriers that it has put down.
    """

    spec: VehicleSpec
    record: VehicleRecord
    stage: Stage = Stage.ABSENT
    linked: bool = False
    link_reason: str = "not connected yet"
    link_since: Seconds = Seconds(0.0)
    stage_since: Seconds = Seconds(0.0)
    status: VehicleStatus | None = None
    seen: Seconds | None = None
    barcode: Barcode | None = None
    stopped: StopAction | None = None
    trail: dict[Barcode, Millimetres] = field(default_factory=dict)
    ahead: list[Barcode] = field(default_factory=list)
    rest: list[Barcode] = field(default_factory=list)
    way: list[Barcode] = field(default_factory=list)
    beyond: tuple[Barcode, ...] = ()
    errand: Errand | None = None
    drive: Drive | None = None
    handling: Handling | None = None
    recovery: AlarmRecovery | None = None
    order: HandleOrder | None = None
    job: JobId | None = None
    opened: dict[CmdId, Intent] = field(default_factory=dict)
    agreed: VehicleStatus | None = None
    quiet_until: Seconds = Seconds(0.0)
    trusted: bool = False
    accounted: bool = False
    failed_handling: str = ""
    missed: int = 0
    teaching: int | None = None
    unfit_since: Seconds | None = None
    waiting: str = ""
    waits_for: VehicleId | None = None
    """Who has to go first, while it waits."""
    waiting_since: Seconds = Seconds(0.0)
    toward: Barcode | None = None
    kept: str = ""
    trips: int = 0

    id: VehicleId = field(init=False, repr=False)
    """The vehicle's name, here since each event asks for it some times."""

    def __post_init__(self) -> None:
        """Take the name from the plant's row."""
        self.id = self.spec.id

    @property
    def is_agv(self) -> bool:
        """Whether it is an AGV: it chooses its way itself, and reports without being asked."""
        return self.spec.kind is VehicleKind.AGV

    @property
    def burden(self) -> str:
        """What it carries is called: a FOUP, or an AGV's cart."""
        return "cart" if self.is_agv else "FOUP"

    @property
    def in_position(self) -> bool:
        """Whether it stands at its barcode, not somewhere after it: an AGV says so, a hoist stops nowhere else."""
        return not self.is_agv or (self.status is not None and self.status.condition.at_tag)

    @property
    def mode(self) -> Mode | None:
        """Mode of its newest STATUS."""
        return self.status.condition.mode if self.status else None

    @property
    def oper(self) -> Oper | None:
        """OPER of its newest STATUS."""
        return self.status.condition.oper if self.status else None

    @property
    def loaded(self) -> bool | None:
        """FOUP bit of its newest STATUS."""
        return self.status.condition.loaded if self.status else None

    @property
    def done_by(self) -> str:
        """What says that a command is done: RESP1 of a hoist; an AGV has no answers, and shows it (PROTOCOLS E9)."""
        return "Status shows it" if self.is_agv else "RESULT 0"

    @property
    def handlings(self) -> list[Intent]:
        """PICKUP and PLACE whose outcome is not known yet."""
        return [intent for intent in self.opened.values() if intent.kind in HANDLINGS]

    @property
    def doubt(self) -> str:
        """Why the place that it reports is not believed, empty if it is."""
        return self.record.hold.doubt if self.record.hold else ""

    @property
    def barred(self) -> str:
        """Why nothing may be sent to it by ourselves, empty if it may."""
        if self.record.off_rail:
            return f"off the rail: {self.record.off_rail}"
        if self.record.lockout:
            return str(self.record.lockout)
        if self.record.hold:
            return f"on hold: {self.record.hold.reason}"
        if self.record.out_of_service:
            return f"out of service: {self.record.out_of_service}"
        return ""

    @property
    def fit(self) -> bool:
        """Whether it can be given motion and handling: settled, in AUTO, without alarm, not barred."""
        status, record = self.status, self.record
        return (
            self.stage is Stage.READY
            and status is not None
            and status.condition.mode is Mode.AUTO
            and status.condition.oper is not Oper.ALARM
            and not (record.off_rail or record.lockout or record.hold or record.out_of_service)
            and self.recovery is None
        )

    @property
    def at_rest(self) -> bool:
        """Whether it stands with no motion or handling of ours under way."""
        return self.drive is None and self.handling is None

    @property
    def moves(self) -> bool:
        """Whether it drives as we told it, or is seen to travel: by hand, or along its tape."""
        return self.drive is not None or (self.status is not None and self.status.condition.travelling)

    @property
    def available(self) -> bool:
        """Whether a job may be given to it: nothing to do, or only giving way or parking."""
        free = self.errand is None or self.errand.purpose in {Purpose.GIVE_WAY, Purpose.PARK}
        bound = self.job or self.order or self.handling or self.kept or self.teaching is not None
        return self.fit and free and not bound
