"""A virtual world that is killed at chosen points of its work, and whose answers, audit and live view are checked."""

from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import replace

from app.domain.ids import CarrierId, VehicleId
from app.domain.layout import Plant
from app.domain.records import AuditRow, Record
from app.domain.requests import Accepted, CreateJob, Request
from app.domain.units import Seconds
from app.domain.view import EventView, Topic, Update, View
from app.protocols.itsc.messages import Mode
from app.sim.fuzz.plan import Plan, Where
from app.sim.world import World

ARRIVED = 0.3
"""Seconds after which a packet has arrived on any of the plans' networks. Our choice."""


class Scene(World):
    """A world for a plan. ``seen`` counts what happened in it."""

    def __init__(self, plant: Plant, plan: Plan) -> None:
        self.plan = plan
        self.counts: Counter[str] = Counter()
        self.dropped: set[CarrierId] = set()
        """Carriers that a gripper let go of, until a person has said so."""
        self.said: list[tuple[float, str]] = []
        """What happened, in words and in order."""
        self._points = {where: {c.nth for c in plan.crashes if c.where is where} for where in Where}
        self._commits = self._packets = 0
        self._asked: dict[int, Request] = {}
        self._requests: Counter[str] = Counter()
        self._audited: Counter[str] = Counter()
        self._answered: Counter[str] = Counter()
        self._mirror: dict[tuple[Topic, str], View] = {}
        self._last_event = 0
        super().__init__(plant, plan.seed, delays=plan.delays)
        self.seen = self._update
        self.passed = self._packet

    @property
    def crashes(self) -> int:
        """How often the controller was killed."""
        return self._life

    def tell(self, what: str, detail: str = "") -> None:
        """Count a happening, and keep it for whoever wants to know what happened."""
        self.counts[what] += 1
        self.said.append((self.now, f"{what} {detail}".rstrip()))

    # -- crash points -------------------------------------------------------------------------------------------------

    def kill(self) -> None:
        """Kill the controller, if it lives."""
        if self.alive:
            self.tell("controller killed")
            self._asked.clear()
        super().kill()

    def _durable(self, life: int) -> None:
        if life != self._life or not self.alive:
            return
        self._commits += 1
        if self._commits in self._points[Where.DURABLE]:
            self.tell("kill at a commit", "just after it")
            self._write()
            self._committing = False
            self.kill()
        elif self._commits in self._points[Where.COMMIT]:
            self.tell("kill at a commit", "just before it")
            self._committing = False
            self.kill()
        else:
            super()._durable(life)

    def _packet(self, line: str, way: str, data: bytes) -> None:
        if way != ">" or not self.alive:
            return
        self._packets += 1
        if self._packets in self._points[Where.SEND]:
            self.tell("kill at a send", f"to {line}, lost")
            self.agenda.after(0.0, self.kill)
        elif self._packets in self._points[Where.ARRIVED]:
            self.tell("kill at a send", f"to {line}, arrived")
            self.agenda.after(ARRIVED, self.kill)

    # -- what people and hosts are told -------------------------------------------------------------------------------

    def ask(self, request: Request) -> int:
        """Ask the controller for something; whatever it answers is checked against what is durable."""
        self._requests[type(request).__name__] += 1
        self._asked[self.control._tickets + 1] = request
        return super().ask(request)

    def _pump(self) -> None:
        super()._pump()
        for ticket in [t for t in self._asked if t in self.replies]:
            self._answer(self._asked.pop(ticket), self.replies.pop(ticket))

    def _answer(self, request: Request, reply: object) -> None:
        """QUALITY 2, items 5 and 12: answered means durable, and audited."""
        kind = type(request).__name__
        self._answered[kind] += 1
        if self._answered[kind] > self._audited[kind]:
            self.oracle.note(f"a {kind} was answered before its audit row was durable", self.now)
        if isinstance(request, CreateJob) and isinstance(reply, Accepted) and reply.key not in self.books.jobs:
            self.oracle.note(f"{reply.key} was accepted before it was durable", self.now)

    def _write(self) -> int:
        records = [r for transaction in list(self._queue)[: self._batch] for r in transaction.records]
        number = super()._write()
        self._audit(records)
        return number

    def _audit(self, records: Sequence[Record]) -> None:
        for record in records:
            if isinstance(record, AuditRow):
                self._audited[record.action] += 1
                if self._audited[record.action] > self._requests[record.action] and record.action in self._requests:
                    self.oracle.note(f"{record.action} of {record.actor} was audited twice", self.now)

    # -- the live view ------------------------------------------------------------------------------------------------

    def _start_controller(self) -> None:
        super()._start_controller()
        self._last_event = 0
        self._mirror = {(u.topic, u.key): u.value for u in self.control.snapshot() if u.value is not None}

    def _update(self, update: Update) -> None:
        if isinstance(update.value, EventView):
            self._event(update.value)
        elif update.value is None:
            self._mirror.pop((update.topic, update.key), None)
        else:
            self._mirror[update.topic, update.key] = update.value

    def _event(self, event: EventView) -> None:
        if self._last_event and event.seq != self._last_event + 1:
            self.oracle.note(f"watchers saw event {event.seq} after event {self._last_event}", self.now)
        self._last_event = event.seq
        of = " ".join(part for part in (event.job, event.vehicle, event.carrier, event.result, event.detail) if part)
        self.tell(event.event, of)

    def compare_views(self) -> None:
        """QUALITY 2, item 13: who followed all changes sees what one who comes now is shown."""
        if not self.alive:
            return
        shown = {(u.topic, u.key): u.value for u in self.control.snapshot()}
        for name in sorted({str(key) for key in shown.keys() ^ self._mirror.keys()}):
            self.oracle.note(f"a watcher and a newcomer disagree whether there is {name}", self.now)
        for key, value in shown.items():
            if self._mirror.get(key, value) != value:
                self.oracle.note(f"a watcher sees an older {key[0].value} {key[1]} than a newcomer", self.now)

    # -- hands --------------------------------------------------------------------------------------------------------

    def knows_to_be_in(self, vehicle: VehicleId, mode: Mode) -> bool:
        """Whether the controller has heard that a hoist is in a mode."""
        return self.alive and self._watches[vehicle].mode is mode

    def flush(self, vehicle: VehicleId) -> None:
        """Let a hoist say what somebody's hands made of it."""
        self.cable(vehicle).flush_device()

    def flush_halls(self) -> None:
        """Let the devices on links say what somebody's hands made of them."""
        for link in self.plant.links:
            self.cable(link.id).flush_device()

    def handle(self, act: Callable[[], None]) -> None:
        """Lay hands on something in a hall, and let it say what came of it."""
        act()
        self.flush_halls()

    def slow_disk(self, least: float, most: float, until: float) -> None:
        """Let commits take longer for a while."""
        usual = self._delays

        def mended() -> None:
            self._delays = usual

        self._delays = replace(usual, commit=(least, most))
        self.agenda.at(Seconds(until), mended)
