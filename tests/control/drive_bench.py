"""A whole controller with a line of simulated drives, in virtual time, each character 1.042 ms long; commits when due."""

from collections.abc import Callable, Sequence
from dataclasses import replace

from app.control import Control, Transaction
from app.domain.catalogue import Catalogue, ParameterSpec
from app.domain.drive import DriveAddress, DriveId, Parameter, RawValue
from app.domain.drive_records import DriveBackup, DriveOperation, DriveValue
from app.domain.drive_requests import DriveOrder, Word
from app.domain.errors import Refusal
from app.domain.ids import Actor, LinkId
from app.domain.layout import DriveUnit, LinkSpec, Plant, Wire
from app.domain.records import AuditRow, HistoryEvent, Record
from app.domain.requests import Accepted, Reply, Request
from app.domain.units import Seconds, Timestamp
from app.domain.view import DriveView, OperationView, ParameterView, Topic, Update, View
from app.protocols.hi.codec import encode
from app.protocols.hi.framing import Decoder, Garbled
from app.protocols.hi.messages import Cmd, Mode, Refused, Role, frame_of
from app.protocols.hi.simulator import Options, SimulatedDrive, SimulatedLine
from app.sim.memory import MemoryLedger
from tests.fleet.script import small
from tests.protocols.hi.rig import Cable

KIM, LEE, PAK = Actor("kim"), Actor("lee"), Actor("pak")
D1, D2, LINE = DriveId("D1"), DriveId("D2"), LinkId("AXES")
UTC = 1_000_000_000.0
P = Parameter

CATALOGUE = Catalogue(
    "HI-1",
    "for tests",
    {
        spec.number: spec
        for spec in (
            ParameterSpec(P(0x1C), "Acceleration", "s", 0.01, 2, RawValue(10), RawValue(6000), RawValue(150)),
            ParameterSpec(P(0x1D), "Jog speed", "%", 1.0, 0, RawValue(1), RawValue(100), while_running=True),
            ParameterSpec(P(0xF0), "Version", read_only=True),
        )
    },
)


def drive_plant(model: str = "HI-1", drives: int = 2) -> Plant:
    """Return the small plant with drives D1, D2 ... on a line."""
    units = tuple(DriveUnit(DriveId(f"D{n}"), LINE, DriveAddress(n), model, f"axis {n}") for n in range(1, drives + 1))
    return replace(small(), links=(LinkSpec(LINE, Wire.HI),), drives=units, catalogues=(CATALOGUE,))


class DriveBench:
    """``model`` is what is published, ``kept`` what is durable. ``durable`` False holds every commit back.

    The hoists of the plant are not there.
    """

    def __init__(
        self,
        plant: Plant | None = None,
        seed: int = 1,
        *,
        connect: bool = True,
        options: Options | None = None,
    ) -> None:
        self.plant = plant or drive_plant()
        self.now = Seconds(0.0)
        self.durable, self.echo, self.up = True, False, False
        self.ledger = MemoryLedger()
        self.kept: list[Record] = []
        self._holes: set[int] = set()
        self.model: dict[Topic, dict[str, View]] = {topic: {} for topic in Topic}
        self.updates: list[Update] = []
        self.replies: dict[int, Reply] = {}
        self.waiting: list[Transaction] = []
        self.sent: list[tuple[float, bytes]] = []
        self.drives = {
            DriveId(f"D{i}"): SimulatedDrive(i, options=options) for i in range(1, len(self.plant.drives) + 1)
        }
        self.line = SimulatedLine(self.drives.values())
        self.out, self.back = Cable(seed), Cable(seed + 1)
        self._begin()
        if connect:
            self.connect()
            self.until(lambda: all(self.view(drive).online for drive in self.drives))

    def _begin(self) -> None:
        self.control = Control(self.plant, self.ledger.load(), self.now, Timestamp(UTC + self.now))
        self.end = self.control.endpoint(LINE)
        self._pump()

    # -- the line -----------------------------------------------------------------------------------------------------

    def connect(self) -> None:
        self.up = True
        self.line.connected(self.now)
        self.end.connected(self.now)
        self._pump()

    def cut(self) -> None:
        self.up = False
        self.out.clear()
        self.back.clear()
        self.line.disconnected(self.now, "cut")
        self.end.disconnected(self.now, "unplugged")
        self._pump()

    def restart(self) -> None:
        """Kill the controller and start another on what is durable."""
        self.waiting.clear()
        self.out.clear()
        self.back.clear()
        self.up = False
        self.line.disconnected(self.now, "cut")
        self._begin()
        self.connect()

    def commands(self, cmd: Cmd, drive: DriveId | None = None) -> list[float]:
        """When this command was sent."""
        frames = [(at, frame) for at, packet in self.sent for frame in Decoder().feed(packet)]
        address = None if drive is None else int(drive[1:])
        return [
            at
            for at, frame in frames
            if not isinstance(frame, Garbled) and frame.cmd == cmd and address in (None, frame.id)
        ]

    def values(self, drive: DriveId = D1) -> list[int]:
        return self.drives[drive].state(self.now).values

    def hole(self, number: int) -> None:
        """Let the drives have no such parameter: they refuse it by NAK (PROTOCOLS H19)."""
        self._holes.add(number)

    def _asked_in_vain(self, packet: bytes) -> bool:
        frame = Decoder().feed(packet)[0]
        return not isinstance(frame, Garbled) and frame.cmd == Cmd.SET and int(frame.data[0], 16) in self._holes

    def jog_mode(self, drive: DriveId = D1) -> None:
        self.drives[drive].panel_mode(Mode.JOG, self.now)
        self.until(lambda: self.view(drive).mode == "jog")

    # -- time ---------------------------------------------------------------------------------------------------------

    def run(self, seconds: float) -> None:
        self._live(self.now + seconds, lambda: False)

    def until(self, reached: Callable[[], bool], within: float = 60.0) -> None:
        self._live(self.now + within, reached)
        assert reached(), f"not within {within} s"

    def _live(self, end: float, reached: Callable[[], bool]) -> None:
        steps = 0
        self._pump()
        while not reached():
            steps += 1
            assert steps < 500_000, "time stands still"
            times = [
                self.end.deadline,
                self.line.deadline,
                self.control.deadline,
                self.out.deadline,
                self.back.deadline,
            ]
            at = min((time for time in times if time is not None), default=end)
            if at > end:
                self.now = Seconds(end)
                return
            self.now = Seconds(max(self.now, at))
            for piece in self.out.arrived(self.now):
                self.line.received(piece, self.now)
            for piece in self.back.arrived(self.now):
                self.end.received(piece, self.now)
            self.line.tick(self.now)
            self.end.tick(self.now)
            self.control.tick(self.now)
            self._pump()

    def _pump(self) -> None:
        while self._bytes() or self._carry():
            pass

    def _bytes(self) -> bool:
        moved = False
        while packet := self.end.outgoing():
            moved = True
            self.sent.append((self.now, packet))
            if self.up and self._holes and self._asked_in_vain(packet):
                self.back.put(encode(frame_of(Role.SLAVE, int(packet[2:3], 16), Cmd.NAK, Refused())), self.now)
            elif self.up:
                self.out.put(packet, self.now)
            if self.up and self.echo:
                self.back.put(packet, self.now)
        while answer := self.line.outgoing():
            moved = True
            if self.up:
                self.back.put(answer, self.now)
        return moved

    def _carry(self) -> bool:
        self.waiting += self.control.transactions()
        if self.durable and self.waiting:
            batch, self.waiting = self.waiting, []
            records = [record for transaction in batch for record in transaction.records]
            self.ledger.commit(records)
            self.kept += records
            self.control.committed(batch[-1].number, self.now)
            return True
        self.control.dirty()
        for update in self.control.updates():
            self.updates.append(update)
            if update.value is None:
                self.model[update.topic].pop(update.key, None)
            else:
                self.model[update.topic][update.key] = update.value
        self.replies.update(self.control.replies())
        return False

    # -- people -------------------------------------------------------------------------------------------------------

    def ask(self, request: Request) -> Reply:
        ticket = self.control.ask(request, self.now)
        self._pump()
        return self.replies[ticket]

    def begin(self, request: DriveOrder) -> int:
        """Ask for something that must be accepted; return its operation."""
        reply = self.ask(request)
        assert isinstance(reply, Accepted), reply
        return int(reply.key)

    def refuse(self, request: DriveOrder) -> Refusal:
        reply = self.ask(request)
        assert isinstance(reply, Refusal), reply
        return reply

    def do(self, request: DriveOrder, within: float = 120.0) -> OperationView:
        """Ask, and live on until it has ended."""
        number = self.begin(request)
        self.until(lambda: self.operation(number).state != "running", within)
        return self.operation(number)

    def tell(self, word: Word) -> Reply:
        reply = self.control.tell(word, self.now)
        self._pump()
        return reply

    # -- what is seen and kept ----------------------------------------------------------------------------------------

    def view(self, drive: DriveId = D1) -> DriveView:
        view = self.model[Topic.DRIVES][drive]
        assert isinstance(view, DriveView)
        return view

    def operation(self, number: int) -> OperationView:
        view = self.model[Topic.OPERATIONS][str(number)]
        assert isinstance(view, OperationView)
        return view

    def parameter(self, number: int, drive: DriveId = D1) -> ParameterView:
        view = self.model[Topic.PARAMETERS][f"{drive}/{number:02X}"]
        assert isinstance(view, ParameterView)
        return view

    def events(self) -> list[tuple[str, str]]:
        """Return the durable events about drives: name and detail."""
        return [(r.event, r.detail) for r in self.kept if isinstance(r, HistoryEvent) and r.event.startswith("Drive")]

    def audits(self) -> list[tuple[str, str, str, bool]]:
        return [(r.actor, r.action, r.target, r.accepted) for r in self.kept if isinstance(r, AuditRow)]

    def operations(self, number: int) -> Sequence[DriveOperation]:
        """Return every durable state of an operation."""
        return [r for r in self.kept if isinstance(r, DriveOperation) and r.number == number]

    def backups(self) -> list[DriveBackup]:
        return [r for r in self.kept if isinstance(r, DriveBackup)]

    def durable_values(self) -> dict[tuple[str, int], int]:
        return {(r.drive, r.parameter): r.value for r in self.kept if isinstance(r, DriveValue)}
