"""A virtual world: the whole controller and a simulated plant in virtual time, in one thread, from one seed."""

import struct
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from hashlib import sha256
from random import Random

from app.control import Control, Transaction
from app.domain.ids import VehicleId
from app.domain.layout import Plant, StationKind, Wire
from app.domain.ports import Ledger
from app.domain.records import Record
from app.domain.requests import Reply, Request
from app.domain.units import Seconds, Timestamp
from app.domain.view import Update
from app.planning.tables import compute
from app.plant.dialects import dialect_of
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.simulator import Options
from app.sim.agenda import Agenda
from app.sim.cables import Cable
from app.sim.hallwatch import HallWatch
from app.sim.host import Host
from app.sim.memory import MemoryLedger, written
from app.sim.oracle import Books, LineWatch, Oracle
from app.sim.plantworld import SimulatedPlant
from app.sim.truth import Act
from app.sim.workload import Pace

BEGINNING = 1_767_225_600.0
"""UTC at virtual time 0: 2026-01-01. Our choice."""
LOOK_EVERY = 0.2
"""Virtual seconds between two looks of the oracle at the rails. Our choice: 0.6 m at full speed."""

REPLAN_AFTER = 0.2
"""Virtual seconds until routing tables that are wanted are there. Our choice: what a process needs for a whole fab."""


@dataclass(frozen=True, slots=True)
class Delays:
    """How long things take, least and most, in seconds. Our choice: a switched network and a disk that flushes."""

    link: tuple[float, float] = (0.0005, 0.004)
    commit: tuple[float, float] = (0.001, 0.005)
    restart: tuple[float, float] = (0.5, 3.0)


@dataclass(frozen=True, slots=True)
class Result:
    """What came of a run. ``open`` jobs have not ended; ``violations`` must be empty."""

    virtual: float
    completed: int
    ended: int
    open: tuple[str, ...]
    takes: int
    puts: int
    violations: tuple[str, ...]
    trace: str


class World:
    """Control, ledger, cables and simulated vehicles on one agenda.

    The trace is a running SHA-256 over every byte on every line and every committed record, each with its virtual time: two
    runs with the same arguments give the same trace, whatever the process.
    """

    def __init__(
        self,
        plant: Plant,
        seed: int,
        ledger: Ledger | None = None,
        delays: Delays | None = None,
        options: Options | None = None,
    ) -> None:
        self.plant = plant
        self.agenda = Agenda()
        self.ledger = ledger or MemoryLedger()
        self.replies: dict[int, Reply] = {}
        self.seen: Callable[[Update], None] = lambda update: None
        """Told each update of the read model as it is published."""
        self.acted: Callable[[Act], None] = lambda act: None
        """Told each physical act at a station as it happens."""
        self.passed: Callable[[str, str, bytes], None] = lambda line, way, data: None
        """Told what is put on each line: its name, ``>`` to the device or ``<``, bytes."""
        self._delays = delays or Delays()
        self._seed = seed
        self._rng = self._random("world")
        self._trace = sha256()
        self._floor = SimulatedPlant(plant, self._acted, options)
        self.oracle = Oracle(plant, self._floor.truth)
        self.books = Books(self.oracle)
        self._watches: dict[VehicleId, LineWatch] = {}
        self._cables = {line: self._cable(line) for line in self._floor.lines}
        self._control: Control | None = None
        self._control_armed: float | None = None
        self._queue: deque[Transaction] = deque()
        self._committing = False
        self._batch = 0
        self._life = 0
        self._start_controller()
        for cable in self._cables.values():
            cable.start()
        self.agenda.after(LOOK_EVERY, self._look)

    @property
    def now(self) -> Seconds:
        """Return virtual time in seconds."""
        return self.agenda.now

    @property
    def floor(self) -> SimulatedPlant:
        """Return the simulated plant."""
        return self._floor

    @property
    def control(self) -> Control:
        """Return the controller that is alive. Raises LookupError: it has been killed and is not back."""
        if self._control is None:
            raise LookupError("the controller is not running")
        return self._control

    @property
    def alive(self) -> bool:
        """Whether the controller runs."""
        return self._control is not None

    @property
    def trace(self) -> str:
        """Return the hash of all that has happened."""
        return self._trace.hexdigest()

    def run(self, until: float) -> None:
        """Let time pass."""
        self.agenda.run(until)

    def ask(self, request: Request) -> int:
        """Ask the controller for something; the answer appears in ``replies`` under the number returned."""
        ticket = self.control.ask(request, self.now)
        self._pump()
        return ticket

    def kill(self) -> None:
        """Kill the controller at this moment and start it again a little later.

        What was being committed is durable or not, as the dice fall; nothing that was not told is ever told.
        """
        if self._control is None:
            return
        self._control = None
        self._life += 1
        if self._committing and self._rng.random() < 0.5:
            self._write()
        self._committing = False
        self._queue.clear()
        for cable in self._cables.values():
            cable.unplug()
        self.agenda.after(self._rng.uniform(*self._delays.restart), self._start_controller)

    def cut(self, line: str) -> None:
        """Cut one line; it is dialled again."""
        self._cables[line].cut("cut")

    def cable(self, line: str) -> Cable:
        """Return a line's cable. Raises KeyError: the plant has no such line."""
        return self._cables[line]

    def work(self, *, until: float, per_hour: float | None = None, keep_open: int | None = None) -> None:
        """Order random jobs until that time, once a second."""
        host = Host(
            [station.id for station in self.plant.stations],
            self._floor.truth.at,
            self.books.jobs,
            self.ask,
            Pace(self._random("pace"), per_hour=per_hour, keep_open=keep_open),
            self._random("jobs"),
            frozenset(s.id for s in self.plant.stations if s.kind is StationKind.AGV_BUFFER),
        )

        def look() -> None:
            if self.alive:
                host.look(self.now)
            if self.now < until:
                self.agenda.after(1.0, look)

        self.agenda.after(1.0, look)

    def finish(self, at_most: float) -> bool:
        """Let time pass until every job has ended, for at most so many seconds more; return whether they all have."""
        end = self.now + at_most
        while self.books.open and self.now < end:
            self.run(min(self.now + 5.0, end))
        return not self.books.open

    def result(self) -> Result:
        """Return what came of it so far."""
        states = self.books.jobs.values()
        return Result(
            virtual=self.now,
            completed=sum(state.value == "completed" for state in states),
            ended=sum(state.terminal for state in states),
            open=tuple(self.books.open),
            takes=self.oracle.takes,
            puts=self.oracle.puts,
            violations=tuple(self.oracle.violations),
            trace=self.trace,
        )

    def _random(self, part: str) -> Random:
        return Random(f"{self._seed}/{part}")

    def _cable(self, line: str) -> Cable:
        name = line.encode()
        hoist = VehicleId(line)
        if hoist in self._floor.devices:
            self._watches[hoist] = self._watch(hoist)
        hall = next((k for k in self.plant.links if k.id == line and k.wire is Wire.ENIG), None)
        watch = None if hall is None else HallWatch(self.plant, hall, self.books, self.oracle)

        def wire(direction: str, data: bytes) -> None:
            self._trace.update(struct.pack("<d", self.now) + name + direction.encode() + data)
            self.passed(line, direction, data)
            if direction == ">" and hoist in self._watches:
                self._watches[hoist].sent(data, self.now)
            if watch is not None:
                watch.passed(direction, data, self.now)

        dice = self._random(f"cable {line}")
        end = self._floor.lines[line]
        cable = Cable(self.agenda, dice, self._delays.link, end, lambda: self._floor.refuses(line), wire)
        if hoist in self._watches:
            cable.heard = self._watches[hoist].heard
        return cable

    def _watch(self, vehicle: VehicleId) -> LineWatch:
        device = self._floor.devices[vehicle]
        codec = Codec(dialect_of(self.plant, device.spec.dialect))
        return LineWatch(device.spec, codec, self.books, self.oracle, lambda: device.working)

    def _start_controller(self) -> None:
        kept = self.ledger.load()
        self._control = Control(self.plant, kept, self.now, Timestamp(BEGINNING + self.now))
        self._control_armed = None
        for line, cable in self._cables.items():
            cable.plug_in(self._control.endpoint(line), self._pump)
        self._pump()

    def _pump(self) -> None:
        """Carry everything that the controller gives to where it belongs."""
        control = self._control
        if control is None:
            return
        self._take_transactions(control)
        for line in control.dirty():
            self._cables[line].flush_controller()
        for update in control.updates():
            self.seen(update)
        for ticket, reply in control.replies():
            self.replies[ticket] = reply
        self._replan(control)
        self._arm(control)

    def _replan(self, control: Control) -> None:
        if (task := control.replan()) is None:
            return
        tables = compute(task)

        def deliver() -> None:
            if self._control is control:
                control.replanned(tables, self.now)
                self._pump()

        self.agenda.after(REPLAN_AFTER, deliver)

    def _take_transactions(self, control: Control) -> None:
        while True:
            self._queue.extend(control.transactions())
            if self._committing or not self._queue:
                return
            if self._queue[0].records:
                self._commit()
                return
            control.committed(self._queue.popleft().number, self.now)

    def _commit(self) -> None:
        """Begin to make everything that waits durable."""
        self._committing = True
        self._batch = len(self._queue)
        life = self._life
        self.agenda.after(self._rng.uniform(*self._delays.commit), lambda: self._durable(life))

    def _write(self) -> int:
        """Make the batch under way durable; return its last number."""
        batch = [self._queue.popleft() for _ in range(self._batch)]
        records: list[Record] = [record for transaction in batch for record in transaction.records]
        self.ledger.commit(records)
        for transaction in batch:
            self.books.committed(transaction.records, self.now)
        text = "\n".join(written(record) for record in records)
        self._trace.update(struct.pack("<d", self.now) + text.encode())
        return batch[-1].number

    def _durable(self, life: int) -> None:
        if life != self._life or self._control is None:
            return
        number = self._write()
        self._committing = False
        self._control.committed(number, self.now)
        self._pump()

    def _arm(self, control: Control) -> None:
        deadline = control.deadline
        if self._control_armed is None or deadline < self._control_armed:
            self._control_armed = deadline
            self.agenda.at(deadline, lambda: self._tick(control, deadline))

    def _tick(self, control: Control, armed: float) -> None:
        if self._control is not control or self._control_armed != armed:
            return
        self._control_armed = None
        if control.deadline <= self.now:
            control.tick(self.now)
        self._pump()

    def _look(self) -> None:
        self.oracle.look(self._floor.places(self.now), self._floor.loaded(), self.now)
        doors = self._floor.halls.doors
        if doors:
            self.oracle.look_at_doors({name: door.leaf_open for name, door in doors.items()}, self.now)
        self.agenda.after(LOOK_EVERY, self._look)

    def _acted(self, act: Act) -> None:
        self.oracle.act(act, self.now)
        self.acted(act)
