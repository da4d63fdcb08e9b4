"""The oracle: judges a run by physical truth and by the bytes on the lines, never through the controller's code."""

from collections.abc import Callable, Iterable, Mapping

from app.domain.devices import DeviceId
from app.domain.ids import VehicleId
from app.domain.job import JOB_STEPS, Job, JobState
from app.domain.layout import Plant, VehicleSpec
from app.domain.records import HistoryEvent, Intent, Record
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Action, Code, Enq, Etb, Mode, Move, Resp2, Toward, Xmove
from app.sim.rails import Place, Rails
from app.sim.truth import Act, Deed, Truth

MOST_VIOLATIONS = 50
"""Violations kept; the first is the one that matters. Our choice."""
_MOTION = frozenset({
    Code.PICKUP_FROM_PORT, Code.PLACE_TO_PORT, Code.PICKUP_FROM_SBFL, Code.PLACE_TO_SBFL, Code.PICKUP_FROM_SBFR,
    Code.PLACE_TO_SBFR, Code.SEARCH_HOME, Code.GO_HOME,
})  # fmt: skip
_AUTO_ONLY = frozenset({
    Code.MOVE, Code.XMOVE, Code.PICKUP_FROM_PORT, Code.PLACE_TO_PORT, Code.PICKUP_FROM_SBFL, Code.PLACE_TO_SBFL,
    Code.PICKUP_FROM_SBFR, Code.PLACE_TO_SBFR,
})  # fmt: skip
IDLE = 0.2
"""Seconds of silence after which bytes that are no whole packet are given up (PROTOCOLS 6.1)."""
OLDEST_STATUS = 3.0
"""Seconds after which a STATUS decides nothing any more (PROTOCOLS 6.1: one poll and its time to answer)."""
_STEPS = {(before, after) for (before, _), after in JOB_STEPS.items()}


class Oracle:
    """Collects what must never happen (QUALITY 2, items 1 to 4 and 6). ``violations`` empty means: nothing did."""

    def __init__(self, plant: Plant, truth: Truth) -> None:
        self.violations: list[str] = []
        self.takes = 0
        self.puts = 0
        self._plant = plant
        self._truth = truth
        self._rails = Rails(plant)
        self._meeting: frozenset[str] = frozenset()
        self._in_doors: frozenset[str] = frozenset()

    def follow(self, plant: Plant) -> None:
        """Judge by another plant from now on."""
        self._plant, self._rails = plant, Rails(plant)

    def look(self, places: Mapping[VehicleId, Place], loaded: Mapping[VehicleId, bool], now: float) -> None:
        """Look at all vehicles on the rails at one moment: their places, and whether their FOUP sensors see a carrier."""
        meeting = frozenset(self._rails.meetings(places))
        for text in sorted(meeting - self._meeting):
            self.note(text, now)
        self._meeting = meeting
        for vehicle, sensed in loaded.items():
            if sensed != (vehicle in self._truth.aboard):
                self.note(f"{vehicle} says F={int(sensed)}, aboard is {self._truth.aboard.get(vehicle)}", now)

    def look_at_doors(self, free: Mapping[DeviceId, bool], now: float) -> None:
        """Look at all doors, after all vehicles: whether each one's leaf is out of the way of who is in it."""
        found = set()
        for door in self._plant.doors:
            if free.get(door.id, True):
                continue
            for vehicle in self._rails.vehicles_on(door.passages):
                found.add(f"{vehicle} is in {door.id}, which is not open")
        for text in sorted(found - self._in_doors):
            self.note(text, now)
        self._in_doors = frozenset(found)

    def act(self, act: Act, now: float) -> None:
        """Judge what a gripper did."""
        match act.deed:
            case Deed.TAKE:
                self.takes += 1
            case Deed.PUT:
                self.puts += 1
            case Deed.TAKE_FAILED:
                self.note(f"{act.vehicle} picked up at {act.station or act.barcode} where it could not", now)
            case Deed.PUT_FAILED:
                self.note(f"{act.vehicle} placed at {act.station or act.barcode} where it could not", now)
        kept = [*self._truth.at.values(), *self._truth.aboard.values()]
        if len(kept) != self._truth.total or len(set(kept)) != len(kept):
            self.note(f"{len(kept)} carriers, of which {len(set(kept))} differ; there must be {self._truth.total}", now)

    def note(self, text: str, now: float) -> None:
        """Keep a violation."""
        if len(self.violations) < MOST_VIOLATIONS:
            self.violations.append(f"at {now:.3f} s: {text}")


class LineWatch:
    """Reads the bytes that the controller sends to one vehicle. ``working`` is the command that the vehicle carries out."""

    def __init__(
        self,
        spec: VehicleSpec,
        codec: Codec,
        books: "Books",
        oracle: Oracle,
        working: Callable[[], Code | None] = lambda: None,
    ) -> None:
        self._spec = spec
        self._working = working
        self._sent: set[int] = set()
        self._codec = codec
        self._decoder = Decoder(codec, Toward.VEHICLE)
        self._ear = Decoder(codec, Toward.CONTROLLER)
        self._last_heard = 0.0
        self._told: set[int] = set()
        """CMD_IDs under which a STATUS came: what comes again is an echo."""
        self._status: tuple[Mode, float] | None = None
        """The mode of the newest STATUS that arrived on this connection, and when."""
        self._books = books
        self._oracle = oracle

    def sent(self, data: bytes, now: float) -> None:
        """Judge what was put on the wire."""
        for frame in self._decoder.feed(data):
            if isinstance(frame, Enq | Etb):
                self._judge(frame, now)

    def heard(self, data: bytes | None, now: float) -> None:
        """Take what arrives at the controller's end, None as the connection is lost: what it may know, no more."""
        if data is None:
            self._status, self._ear = None, Decoder(self._codec, Toward.CONTROLLER)
            self._told.clear()
            return
        given_up = self._ear.flush() if self._ear.pending and now - self._last_heard >= IDLE else []
        self._last_heard = now
        for frame in (*given_up, *self._ear.feed(data)):
            if isinstance(frame, Enq) and isinstance(frame.body, Resp2) and frame.cmd_id not in self._told:
                self._told.add(frame.cmd_id)
                self._status = (frame.body.status2.mode, now)

    @property
    def mode(self) -> Mode | None:
        """The mode that the controller has heard of on this connection; None: it has heard nothing."""
        return None if self._status is None else self._status[0]

    def _judge_status(self, frame: Enq | Etb, now: float) -> None:
        """QUALITY 2, items 7 and 10: in AUTO only, and by a STATUS that is not too old."""
        code = f"{frame.code:04X}"
        if self._status is None:
            self._oracle.note(f"{self._spec.id} was sent {code} before any STATUS of this connection", now)
            return
        mode, at = self._status
        if mode != Mode.AUTO:
            self._oracle.note(f"{self._spec.id} was sent {code} in {mode.name}", now)
        if now - at > OLDEST_STATUS:
            self._oracle.note(f"{self._spec.id} was sent {code} on a STATUS {now - at:.1f} s old", now)

    def _judge(self, frame: Enq | Etb, now: float) -> None:
        if isinstance(frame.body, Move | Xmove):
            seqs = [element.seq for element in frame.body.path]
            if seqs != list(range(seqs[0], seqs[0] + len(seqs))):
                self._oracle.note(f"{self._spec.id} was sent a path whose SEQ does not rise by one: {seqs}", now)
            if frame.body.path[-1].action == Action.RUN:
                self._oracle.note(f"{self._spec.id} was sent a path that does not end in a stop", now)
        elif frame.code not in _MOTION:
            return
        if frame.cmd_id not in self._books.intents:
            self._oracle.note(f"{self._spec.id} was sent {frame.code:04X} without a durable intent", now)
        if frame.cmd_id not in self._sent and frame.code in _AUTO_ONLY:
            self._judge_status(frame, now)
        busy = self._working()
        if busy is not None and frame.code != Code.XMOVE and frame.cmd_id not in self._sent:
            self._oracle.note(f"{self._spec.id} was sent {frame.code:04X} while it was at {busy:04X}", now)
        self._sent.add(frame.cmd_id)


class Books:
    """Reads what is committed: jobs follow their state table, history has no gap, CMD_IDs are not used again."""

    def __init__(self, oracle: Oracle) -> None:
        self.intents: dict[int, VehicleId] = {}
        self.open_intents: dict[VehicleId, dict[int, Intent]] = {}
        """The commands whose outcome is not known, by vehicle."""
        self.jobs: dict[str, JobState] = {}
        self._oracle = oracle
        self._orders: dict[str, int] = {}
        self._last_event = 0

    def committed(self, records: Iterable[Record], now: float) -> None:
        """Judge one durable transaction."""
        for record in records:
            match record:
                case Job():
                    self._job(record, now)
                case Intent():
                    if self.intents.setdefault(record.cmd_id, record.vehicle) != record.vehicle:
                        self._oracle.note(f"CMD_ID {record.cmd_id:016X} was used for two vehicles", now)
                    opened = self.open_intents.setdefault(record.vehicle, {})
                    opened.pop(record.cmd_id, None)
                    if not record.state.closed:
                        opened[record.cmd_id] = record
                case HistoryEvent():
                    if record.seq != self._last_event + 1:
                        self._oracle.note(f"event {record.seq} follows event {self._last_event}", now)
                    self._last_event = record.seq
                case _:
                    pass

    @property
    def open(self) -> list[str]:
        """Return the jobs that have not ended."""
        return [job for job, state in self.jobs.items() if not state.terminal]

    def count(self, state: JobState) -> int:
        """Return how many jobs are in this state."""
        return sum(1 for other in self.jobs.values() if other is state)

    def _job(self, job: Job, now: float) -> None:
        before = self.jobs.get(job.id)
        if self._orders.setdefault(job.id, job.order) != job.order:
            self._oracle.note(f"there are two jobs {job.id}", now)
        self.jobs[job.id] = job.state
        if before is None:
            before = JobState.QUEUED
        if before is not job.state and not _reachable(before, job.state):
            self._oracle.note(f"job {job.id} went from {before} to {job.state}", now)


def _reachable(before: JobState, after: JobState) -> bool:
    """Whether the table leads from one state to another; one transaction may hold several steps but keeps the last."""
    if before.terminal:
        return False
    seen, queue = {before}, [before]
    while queue:
        here = queue.pop()
        for start, end in _STEPS:
            if start is here and end not in seen:
                seen.add(end)
                queue.append(end)
    return after in seen
