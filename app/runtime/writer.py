"""The group-commit thread: everything that waits goes into one durable transaction, then its owner is told."""

import math
import threading
import time
from collections.abc import Callable, Sequence
from typing import Protocol

from app.domain.errors import PlantHeld, StoreError, StoreRefused
from app.domain.ports import Ledger
from app.domain.records import Record
from app.domain.units import Seconds

PAUSES = (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0)
"""Seconds between attempts while the database is in trouble; the last goes on. Our choice."""
RENEWALS = 4
"""How often the lease is renewed within its life, at least. Our choice."""
IDLE = 2.0
"""Seconds between looks at a lease that does not run out. Our choice."""


SLICE = 500
"""Events deleted at a time: some milliseconds, since commits wait meanwhile. Our choice."""
PRUNE_EVERY = 60.0
"""Seconds between looks for events that have grown old. Our choice."""
PRUNE_ON = 0.1
"""Seconds until the next slice while there is more: 5,000 events a second may grow old. Our choice."""


class LeasedLedger(Ledger, Protocol):
    """A ledger that one controller at a time may write."""

    @property
    def lease_seconds(self) -> Seconds:
        """How long the plant is ours after a commit or renewal began; infinite if it does not run out."""
        ...

    def renew(self) -> None:
        """Keep the plant. Raises PlantHeld or StoreError."""
        ...

    def prune(self, most: int) -> int:
        """Delete events that have grown old, at most so many, and return how many were. Raises PlantHeld or StoreError."""
        ...


class Counted(Protocol):
    """Counts commits; called from the writer's thread."""

    commit_failures: int

    def committed(self, seconds: float, records: int) -> None:
        """Count one commit."""
        ...


class Writer:
    """A thread around a ledger. Batches are committed in the order of :meth:`submit`, as many together as wait.

    The callbacks run in the writer's thread. ``deliver(last)`` says that every batch up to that number is durable.
    ``on_trouble(message)`` says that the database cannot be written: the writer tries again with growing pauses and delivers
    nothing meanwhile; an empty message says that it is over. ``on_lost(message)`` is the end: the plant is held by another
    controller, or the records cannot be kept, or the thread broke; nothing is delivered any more.

    Between commits, old events are deleted slice by slice.
    """

    def __init__(
        self,
        ledger: LeasedLedger,
        deliver: Callable[[int], None],
        *,
        on_trouble: Callable[[str], None],
        on_lost: Callable[[str], None],
        figures: Counted | None = None,
        clock: Callable[[], float] = time.monotonic,
        pauses: Sequence[float] = PAUSES,
    ) -> None:
        self._ledger = ledger
        self._deliver = deliver
        self._on_trouble = on_trouble
        self._on_lost = on_lost
        self._figures = figures
        self._clock = clock
        self._pauses = pauses
        self._renew_every = min(ledger.lease_seconds / RENEWALS, IDLE)
        self._waiting: list[tuple[int, Sequence[Record]]] = []
        self._changed = threading.Condition()
        self._closing = False
        self._in_trouble = False
        self._verified = self._beat = clock()
        self._prune_at = self._verified + PRUNE_EVERY
        self._thread = threading.Thread(target=self._run, name="hoistway-writer", daemon=True)

    @property
    def held_until(self) -> Seconds:
        """The moment on ``clock`` until which the plant is surely ours: after it, send nothing (COMMANDS 3.7)."""
        return Seconds(self._verified + self._ledger.lease_seconds)

    @property
    def waiting(self) -> int:
        """How many batches wait to be taken."""
        return len(self._waiting)

    def silent_for(self) -> Seconds:
        """Return for how long the thread has tried nothing: some seconds at rest, infinite at its end."""
        ended = self._thread.ident is not None and not self._thread.is_alive()
        return Seconds(math.inf if ended else self._clock() - self._beat)

    def start(self) -> None:
        """Start the thread; the ledger belongs to it from now on."""
        self._thread.start()

    def submit(self, batch_id: int, records: Sequence[Record]) -> None:
        """Queue a batch. Never blocks. A batch without records is delivered in its turn too."""
        with self._changed:
            self._waiting.append((batch_id, records))
            self._changed.notify()

    def submit_all(self, batches: Sequence[tuple[int, Sequence[Record]]]) -> None:
        """Queue batches, all at once."""
        if batches:
            with self._changed:
                self._waiting += batches
                self._changed.notify()

    def close(self) -> None:
        """Commit and deliver what waits, then end the thread. In trouble there is one more attempt. The ledger stays open."""
        with self._changed:
            self._closing = True
            self._changed.notify()
        if self._thread.ident is not None:
            self._thread.join()

    def _run(self) -> None:
        lost = "the thread that writes the database broke; see the log"
        try:
            while (taken := self._take()) is not None:
                if not self._durable([record for _, records in taken for record in records]):
                    break
                if taken:
                    self._deliver(taken[-1][0])
                self._prune()
            lost = ""
        except (PlantHeld, StoreRefused) as end:
            lost = f"{end.message.rstrip('.')}. {end.remedy}".rstrip()
        finally:
            if lost:
                self._on_lost(lost)

    def _take(self) -> list[tuple[int, Sequence[Record]]] | None:
        """Wait for batches and return all of them; none if the lease wants renewal; None at the end."""
        with self._changed:
            due = min(self._verified + self._renew_every, self._prune_at) - self._clock()
            self._changed.wait_for(lambda: self._waiting or self._closing, max(due, 0.0))
            if self._closing and not self._waiting:
                return None
            taken, self._waiting = self._waiting, []
            return taken

    def _durable(self, records: list[Record]) -> bool:
        """Commit, or renew the lease if it is time; return False if the writer was closed before it could."""
        attempts = 0
        while True:
            began = self._beat = self._clock()
            try:
                if records:
                    self._ledger.commit(records)
                    if self._figures is not None:
                        self._figures.committed(self._clock() - began, len(records))
                elif began - self._verified >= self._renew_every:
                    self._ledger.renew()
                else:
                    return True
            except (PlantHeld, StoreRefused):
                raise
            except StoreError as trouble:
                if self._figures is not None:
                    self._figures.commit_failures += 1
                if not self._again(trouble, attempts):
                    return False
                attempts += 1
            else:
                self._verified = began
                if self._in_trouble:
                    self._in_trouble = False
                    self._on_trouble("")
                return True

    def _prune(self) -> None:
        """Delete a slice of old events if it is time; what cannot be deleted now is tried again later."""
        now = self._clock()
        if now < self._prune_at or self._closing:
            return
        self._prune_at = now + PRUNE_EVERY
        try:
            if self._ledger.prune(SLICE) == SLICE:
                self._prune_at = now + PRUNE_ON
        except (PlantHeld, StoreRefused):
            raise
        except StoreError:
            return

    def _again(self, trouble: StoreError, attempts: int) -> bool:
        """Tell of the trouble and pause; return False if there is to be no further attempt."""
        self._in_trouble = True
        self._on_trouble(f"{trouble.message.rstrip('.')}. {trouble.remedy}".rstrip())
        with self._changed:
            if not self._closing:
                self._changed.wait_for(lambda: self._closing, self._pauses[min(attempts, len(self._pauses) - 1)])
                return True
            return False
