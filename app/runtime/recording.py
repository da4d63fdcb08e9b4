"""Records what is shown, for playback: beside the controller, bounded, and never in its way.

Of vehicles only what a map shows is recorded, and only where it is other than before; of drives what they do and what is
wrong with them, not where they are; a second thread makes differences, compresses and writes. What it cannot write in time is
left out but for the newest; what failed, a whole state makes good.
"""

import queue
import threading
import zlib
from collections.abc import Callable, Sequence
from dataclasses import asdict, dataclass
from operator import attrgetter
from typing import Any

from structlog.typing import FilteringBoundLogger

from app.domain.errors import StoreError
from app.domain.units import Timestamp
from app.domain.view import DriveView, HoldView, LockoutView, Topic, Update, VehicleView
from app.runtime.heat import KEPT_EVERY, WAITS, Counts
from app.runtime.showing import encode, shown
from app.store.playback import CHANGES, STATE, Piece, PlaybackStore

RECORDED = frozenset(
    {
        Topic.CONTROLLER,
        Topic.VEHICLES,
        Topic.JOBS,
        Topic.STATIONS,
        Topic.CARRIERS,
        Topic.DEVICES,
        Topic.DRIVES,
        Topic.CLOSURES,
        Topic.ALARMS,
    }
)
"""Teaching is not among them: its proposals and versions are kept for ever with their times, and no map shows them."""
_SEEN = (
    "state",
    "activity",
    "service",
    "mode",
    "oper",
    "code",
    "loaded",
    "carrier",
    "barcode",
    "job",
    "goal",
    "parked",
    "hold",
    "lockout",
)
VEHICLE_FIELDS = (*_SEEN, "waiting", "waits_for", "granted")
"""What is recorded of a vehicle. A change of the last three alone is no change: they follow the others."""
_COMPARED: dict[type, Callable[[Any], tuple[object, ...]]] = {
    VehicleView: attrgetter(*_SEEN),
    DriveView: attrgetter("online", "mode", "code", "error", "reason", "moving", "operation", "lockout"),
}
"""What has to be other than before for an object to be recorded anew; all others are, whenever they are published."""
PIECE_SECONDS = 2.0
"""Changes of so many seconds are one piece. Our choice."""
STATE_SECONDS = 60.0
"""So often the whole state is kept: what is behind a moment is at most so many seconds of changes. Our choice."""
HEAVY = 4.0
"""It is kept sooner, once the changes since the last one weigh so many times as much: in a large plant, whoever looks for a
moment would have to read a great many of them. Our choice: a quarter more to keep, at most."""
WAITING = 30
"""So many pieces may wait for the disk; then only the newest of each object is kept. Our choice."""
LEVEL = 1

Change = tuple[float, str, str, Any]
"""When, topic, key, and the object; of a vehicle what has changed. None: it is gone."""


@dataclass(frozen=True, slots=True)
class Limits:
    """How long playback is kept, seconds, and how large it may become, bytes."""

    seconds: float
    size: int


def packed(value: object) -> bytes:
    """Return a value as a piece has it."""
    return zlib.compress(encode(value), LEVEL)


class Recorder:
    """Takes published updates on the loop (``note``), and gives a piece to its thread when ``flush`` is called."""

    def __init__(
        self, store: PlaybackStore, limits: Limits, utc: Callable[[], Timestamp], log: FilteringBoundLogger
    ) -> None:
        self._store, self._limits, self._utc, self._log = store, limits, utc, log
        self._seen: dict[tuple[Topic, str], tuple[object, ...]] = {}
        self._some: list[tuple[float, Update]] = []
        self._waiting: queue.Queue[list[tuple[float, Update]] | None] = queue.Queue()
        self._left_out = False
        self._writes = _Writes(store, limits)
        self._thread = threading.Thread(target=self._run, name="playback", daemon=True)
        self._thread.start()

    def note(self, updates: Sequence[Update]) -> None:
        """Take what has just been published."""
        at, some = self._utc(), self._some
        for update in updates:
            compared = _COMPARED.get(type(update.value))
            if compared is not None:
                now, which = compared(update.value), (update.topic, update.key)
                if self._seen.get(which) == now:
                    continue
                self._seen[which] = now
            elif update.topic not in RECORDED:
                continue
            elif update.value is None:
                self._seen.pop((update.topic, update.key), None)
            some.append((at, update))

    @property
    def waiting(self) -> int:
        """How many pieces wait for the disk."""
        return self._waiting.qsize()

    def flush(self) -> None:
        """Give what was noted to the thread; while that is far behind, keep the newest of each object alone."""
        some = self._some
        if self.waiting >= WAITING:
            self._some = list({(update.topic, update.key): (at, update) for at, update in some}.values())
            self._some.sort(key=lambda one: one[0])
            if not self._left_out:
                self._log.warning("playback fell behind the disk: changes are left out")
            self._left_out = True
            return
        self._some, self._left_out = [], False
        if some:
            self._waiting.put(some)

    def close(self) -> None:
        """Write what waits, and end. Blocking."""
        if self._some:
            self._waiting.put(self._some)
        self._waiting.put(None)
        self._thread.join()
        self._store.close()

    def _run(self) -> None:
        failed = False
        while (some := self._waiting.get()) is not None:
            try:
                self._writes.write(some)
                failed = False
            except StoreError as wrong:
                if not failed:
                    self._log.warning("playback is not recorded", reason=wrong.message)
                failed = True
                self._writes.forget()


class _Writes:
    """The thread's side: knows the whole state, makes pieces and keeps them."""

    def __init__(self, store: PlaybackStore, limits: Limits) -> None:
        self._store, self._limits = store, limits
        self._state: dict[str, dict[str, Any]] = {}
        self._next_state = self._next_prune = 0.0
        self._heat: Counts | None = None
        self._next_heat = 0.0
        self._size = self._since = 0
        """Bytes of the last whole state, and of the changes since then."""

    def write(self, some: list[tuple[float, Update]]) -> None:
        """Keep some updates as a piece of changes, with the whole state before them if it is time."""
        begin, end = some[0][0], some[-1][0]
        self._heat = self._heat or Counts(begin)
        for heat in self._heat.over(begin):
            self._store.keep_heat(heat.begin, heat.end, packed(asdict(heat)))
        made: list[Piece] = []
        whole = begin >= self._next_state or self._since > HEAVY * self._size
        if whole and self._state:
            made.append(Piece(STATE, begin, begin, 1, packed(self._state)))
        changes = [change for at, update in some if (change := self._change(at, update)) is not None]
        if whole and not made:
            made.append(Piece(STATE, end, end, 1, packed(self._state)))
        elif changes:
            made.append(Piece(CHANGES, begin, end, len(changes), packed(changes)))
        if made:
            self._store.append(made)
        self._weigh(made)
        if whole:
            self._next_state = begin + STATE_SECONDS
        if begin >= self._next_prune:
            self._next_prune = begin + STATE_SECONDS
            self._store.prune(end - self._limits.seconds, self._limits.size)
        self._keep_heat(self._heat, end)

    def _keep_heat(self, counts: Counts, end: float) -> None:
        """Keep what was counted, if it is time."""
        if end < self._next_heat:
            return
        self._next_heat = end + KEPT_EVERY
        self._store.keep_heat(counts.begin, end, packed(asdict(counts.until(end))))

    def _weigh(self, made: list[Piece]) -> None:
        for piece in made:
            if piece.kind == STATE:
                self._size, self._since = len(piece.body), 0
            else:
                self._since += len(piece.body)

    def forget(self) -> None:
        """Something was not kept: the next piece begins with the whole state."""
        self._next_state = 0.0

    def _change(self, at: float, update: Update) -> Change | None:
        topic, key, view = update.topic.value, update.key, update.value
        of_topic = self._state.setdefault(topic, {})
        if topic == Topic.VEHICLES and self._heat is not None:
            barcode = view.barcode if isinstance(view, VehicleView) else None
            waits = isinstance(view, VehicleView) and view.activity == WAITS
            self._heat.take(key, barcode, at, waits=waits)
        if view is None:
            return (at, topic, key, None) if of_topic.pop(key, None) is not None else None
        if not isinstance(view, VehicleView):
            of_topic[key] = value = shown(view)
            return at, topic, key, value
        before, now = of_topic.get(key, {}), {name: _plain(getattr(view, name)) for name in VEHICLE_FIELDS}
        of_topic[key] = now
        return (
            at,
            topic,
            key,
            {name: value for name, value in now.items() if name not in before or before[name] != value},
        )


def _plain(value: Any) -> Any:
    """Return a field as JSON has it: a hold and a lockout with the moment since when they are."""
    return shown(value) if isinstance(value, HoldView | LockoutView) else value
