"""The controller on the event loop: carries everything between ``Control`` and the sockets, the database and the watchers."""

import asyncio
import math
import os
import secrets
import socket
from collections import deque
from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial
from itertools import takewhile
from typing import TypeVar

from structlog.typing import FilteringBoundLogger

from app.control import Control, Transaction
from app.domain.drive_requests import Word
from app.domain.errors import Refusal, StoreError
from app.domain.ids import LinkId, VehicleId
from app.domain.layout import Plant
from app.domain.records import HistoryEvent, Kept
from app.domain.requests import Reply, Request
from app.domain.units import Barcode, Seconds, Timestamp
from app.domain.view import LineView, Topic
from app.domain.webhooks import Webhook, WebhookProgress, WebhookTry
from app.fleet.closure_preview import Survey, survey
from app.fleet.takeover import check_nobody_is_forgotten
from app.planning.routing import Route
from app.planning.tables import Tables
from app.plant.dialects import dialect_of
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.session import LinkQuality
from app.runtime.access import Access
from app.runtime.clock import Clock
from app.runtime.hub import Hub, ReadModel
from app.runtime.journal import Journal
from app.runtime.lines import Line
from app.runtime.listener import Expected, Listener
from app.runtime.metrics import Figures
from app.runtime.playback import Playback
from app.runtime.reception import Reception
from app.runtime.recording import PIECE_SECONDS, Limits, Recorder
from app.runtime.replanning import Replanner
from app.runtime.serial_port import Serial
from app.runtime.telemetry import logger
from app.runtime.transports import Dialler, Tcp
from app.runtime.versions import Versions
from app.runtime.webhooks import Courier, Sender, Targets
from app.runtime.writer import Writer
from app.store.access import AccessStore
from app.store.ledger import FOR_EVER, SqlLedger
from app.store.playback import PlaybackStore
from app.store.reading import Reader

Value = TypeVar("Value")
ANSWER_WITHIN = 30.0
"""Seconds until who asks is told that there is no answer (a database in trouble). Our choice."""
SWEEP = 1.0
"""Seconds between looks for those who have waited so long. Our choice."""
GONE = Refusal("not-now", "This controller has stopped.", "Ask the one that holds the plant now, or start it again.")


class _Whole:
    """Ends the controller if a defect leaves a decision half made: a fresh start settles all by asking (COMMANDS 3)."""

    def __init__(self, defect: Callable[[], None]) -> None:
        self._defect = defect

    def __enter__(self) -> None:
        """Begin a decision."""

    def __exit__(self, kind: type[BaseException] | None, _error: object, _trace: object) -> bool:
        if kind is None or not issubclass(kind, Exception):
            return False
        self._defect()
        return True


class Controller:
    """One plant under control. ``start`` takes the plant, ``stop`` lets it go; nothing else blocks.

    After every input (bytes, a request, a deadline, a commit) the loop runs ``_pump`` once, however many inputs came in that
    round: records go to the writer, and bytes, updates and replies go out once they may.
    """

    def __init__(
        self,
        plant: Plant,
        database: str,
        clock: Clock | None = None,
        *,
        restored: bool = False,
        keep_events: Seconds = FOR_EVER,
        playback: Limits | None = None,
        webhooks: Callable[[], Sender] = lambda: Sender(Targets(()), "0"),
        versions: Versions | None = None,
        version: int | None = None,
    ) -> None:
        """``webhooks`` makes what delivers to them: where they may lead is for the settings to say. ``version`` is the plant's
        number among ``versions``, which have to agree that it is the active one.
        """
        self.plant = plant
        self.versions = versions
        self.version = version
        self.trouble = ""
        """Why nothing can be made durable just now; empty if all is well."""
        self._clock = clock or Clock()
        self._database = database
        self._restored = restored
        self._keep_events = keep_events
        self._limits = playback
        self._recorder: Recorder | None = None
        self.playback: Playback | None = None
        """What was recorded, if anything is."""
        self._sender_made = webhooks
        self._log: FilteringBoundLogger = logger(plant=plant.name)
        self._journal = Journal(self._log, plant)
        self.figures = Figures(plant)
        """What is counted for /metrics."""
        self._in_flight: deque[Transaction] = deque()
        self._asked: dict[int, tuple[asyncio.Future[Reply], float]] = {}
        self._sweeping = False
        self._whole = _Whole(self._defect)
        self._lines: dict[str, Line] = {}
        self._diallers: list[Dialler] = []
        self._listener: Listener | None = None
        self._timer: asyncio.TimerHandle | None = None
        self._armed = 0.0
        self._pumping = False
        self._over = False

    async def start(self) -> None:
        """Take the plant, see what is kept, and begin to connect.

        Raises PlantHeld: another controller has it. Raises StoreError: the database cannot be used. Raises PlantError: a vehicle
        that may be on the rail is not in the plant any more. Raises OSError: the address to listen at cannot be used.
        """
        self._loop = asyncio.get_running_loop()
        self.lost: asyncio.Future[str] = self._loop.create_future()
        """Done, with the reason, when this controller may not go on."""
        kept = await asyncio.to_thread(self._take_plant)
        self.reader = Reader(self._database)
        self.reception = Reception(Access(AccessStore(self._database, secrets.token_bytes), self._clock))
        await self.reception.access.start()
        await self._record()
        self._control = Control(self.plant, kept, self._clock.now(), self._clock.utc())
        self.model = ReadModel(last_event=kept.next_event - 1)
        self.hub = Hub(self.model)
        self._writer = Writer(
            self._ledger,
            lambda last: self._tell(self._durable, last),
            on_trouble=lambda message: self._tell(self._troubled, message),
            on_lost=lambda message: self._tell(self._lose, message),
            figures=self.figures,
        )
        self._writer.start()
        self._replanner = Replanner(self._replanned, figures=self.figures)
        if self.versions is not None:
            self.versions.attach(self._control.leave)
        snapshot = self._control.snapshot()
        self.hub.publish(snapshot)
        if self._recorder is not None:
            self._recorder.note(snapshot)
        self.figures.jobs.begin(self.model.all(Topic.JOBS))
        self.figures.start()
        self._sender = self._sender_made()
        self._courier = Courier(self, self._sender, tried=self.figures.webhook_tries)
        self._courier.stir()
        leased = math.isfinite(self._writer.held_until)
        for name in self._control.lines:
            end = self._control.endpoint(name)
            may_send = self._may_send if leased else None
            self._lines[name] = Line(end, self._clock.now, self._kick, may_send)
        self._pump()
        try:
            await self._connect()
        except OSError:
            await self.stop()
            raise
        self._log.info(
            "started", version=self.version, epoch=kept.epoch, vehicles=len(self.plant.vehicles), jobs=len(kept.jobs)
        )

    async def stop(self) -> None:
        """Cut the lines, make durable what was decided, and let the plant go. Nothing stops a vehicle: it ends its grant."""
        if self._listener is not None:
            await self._listener.stop()
        await asyncio.gather(*(dialler.stop() for dialler in self._diallers))
        for line in self._lines.values():
            line.stop()
            await line.disconnected()
        await self._courier.stop()
        await self._sender.close()
        if not self._over:
            self._pump()
        await asyncio.to_thread(self._writer.close)
        await asyncio.sleep(0)
        self._end()
        await self._replanner.stop()
        await self.reception.access.stop()
        await asyncio.to_thread(self._ledger.close)
        self.reader.close()
        if self._recorder is not None:
            await asyncio.to_thread(self._recorder.close)
        if self.playback is not None:
            self.playback.close()
        self._log.info("stopped")

    async def _record(self) -> None:
        """Begin to record for playback; a plant is controlled without it all the same."""
        if self._limits is None:
            return
        try:
            store = await asyncio.to_thread(PlaybackStore, self._database)
            self._recorder = Recorder(store, self._limits, self._clock.utc, self._log)
            self.playback = Playback(self._database)
        except StoreError as wrong:
            self._log.warning("playback is not recorded", reason=wrong.message)
            return
        self._loop.call_later(PIECE_SECONDS, self._flush_recorder)

    def _flush_recorder(self) -> None:
        if self._recorder is not None and not self._over:
            self._recorder.flush()
            self._loop.call_later(PIECE_SECONDS, self._flush_recorder)

    def ask(self, request: Request) -> asyncio.Future[Reply]:
        """Put a request to the controller; the answer is durable. The future raises TimeoutError: there is none in time."""
        future: asyncio.Future[Reply] = self._loop.create_future()
        if not self._over:
            with self._whole:
                now = self._clock.now()
                self._asked[self._control.ask(request, now)] = future, now
                self._kick()
                if not self._sweeping:
                    self._sweep()
        if self._over and not future.done():
            future.set_result(GONE)
        return future

    def _sweep(self) -> None:
        """Give up those who have waited too long; look again later while anybody waits."""
        before = self._clock.now() - ANSWER_WITHIN
        late = list(takewhile(lambda ticket: self._asked[ticket][1] <= before, self._asked))
        for ticket in late:
            future, _ = self._asked.pop(ticket)
            if not future.done():
                future.set_exception(TimeoutError())
        self._sweeping = bool(self._asked) and not self._over
        if self._sweeping:
            self._loop.call_later(min(SWEEP, ANSWER_WITHIN), self._sweep)

    def frames(self, vehicle: VehicleId) -> Sequence[tuple[Timestamp, str, bytes]]:
        """Return the last frames on a vehicle's line, oldest first."""
        return self._control.frames(vehicle)

    def tell(self, word: Word) -> Reply:
        """Take a word that changes nothing that is kept; it takes effect at once, whatever the database does."""
        if self._over:
            return GONE
        reply: Reply = GONE
        with self._whole:
            reply = self._control.tell(word, self._clock.now())
            for name in self._control.dirty():
                self._lines[name].flush()
            self._kick()
        return reply

    def links(self) -> Sequence[LineView]:
        """Return how all links are doing."""
        return self._control.links()

    def line_quality(self) -> Sequence[LinkQuality]:
        """Return the figures of every hoist's line."""
        return self._control.line_quality()

    def named_quality(self) -> Sequence[tuple[VehicleId, LinkQuality]]:
        """Return the figures of every hoist's line, by the hoist's name."""
        return self._control.named_quality()

    def waits(self) -> dict[str, int]:
        """Return how many vehicles wait for what, by cause."""
        return self._control.waits()

    @property
    def backlog(self) -> tuple[int, int]:
        """Batches that wait for the writer, and decisions that are not durable yet."""
        return self._writer.waiting, len(self._in_flight)

    @property
    def targets(self) -> Targets:
        """Where webhooks may lead."""
        return self._sender.targets

    def webhooks(self) -> Sequence[tuple[Webhook, WebhookProgress]]:
        """Return all webhooks, and how far each has been told."""
        return self._control.webhooks()

    def webhook_told(self, progress: WebhookProgress, tries: Sequence[WebhookTry], failed: str = "") -> None:
        """Keep how far a webhook has been told; ``failed``: it is given up, and why."""
        if not self._over:
            with self._whole:
                self._control.webhook_told(progress, tries, failed)
                self._kick()

    async def ping_webhook(self, number: int) -> WebhookTry | None:
        """Deliver a test; None: there is no such webhook."""
        return await self._courier.ping(number)

    async def events_after(self, after: int, limit: int) -> Sequence[HistoryEvent]:
        """Return durable events above a number, in order. Raises StoreError."""
        return await asyncio.to_thread(self.reader.events, after, limit)

    def silent_for(self) -> Seconds:
        """Return for how long nothing was made durable or tried; for ever once the controller may not go on."""
        return Seconds(math.inf) if self._over else self._writer.silent_for()

    def link_frames(self, link: LinkId) -> Sequence[tuple[Timestamp, str, bytes]]:
        """Return the last frames on a link, oldest first."""
        return self._control.link_frames(link)

    def routes(self, start: Barcode, goal: Barcode, most: int) -> Sequence[Route]:
        """Return the quickest routes as they would be planned now. Raises NoRoute."""
        return self._control.fleet.books.router.alternatives(start, goal, most)

    def survey(self) -> Survey:
        """Return the fleet at this moment, fixed."""
        return survey(self._control.fleet.books)

    def utc(self) -> Timestamp:
        """Return the present moment."""
        return self._clock.utc()

    def _take_plant(self) -> Kept:
        holder = f"{socket.gethostname()}, process {os.getpid()}"
        self._ledger = SqlLedger(
            self._database, self.plant.name, holder, self._clock.utc, keep_events=self._keep_events
        )
        try:
            kept = self._ledger.load()
            kept = replace(kept, restored=kept.restored or self._restored)
            check_nobody_is_forgotten(self.plant, kept)
            self._check_version()
            return kept
        except BaseException:
            self._ledger.close()
            raise

    def _check_version(self) -> None:
        """See, with the lease in hand, that the version is still the active one: another controller may have been here."""
        if self.versions is not None:
            active = self.versions.store.active()
            if active is None or active.number != self.version:
                said = "none" if active is None else f"version {active.number}"
                raise StoreError(
                    f"the plant was changed meanwhile: {said} is active, not {self.version}", remedy="Start again."
                )

    async def _connect(self) -> None:
        coming = []
        for spec in self.plant.hoists:
            line = self._lines[spec.id]
            if spec.listen:
                coming.append(Expected(spec, line, Codec(dialect_of(self.plant, spec.dialect))))
            else:
                dialler = Dialler(line, Tcp(spec.host, spec.port), spec.id, partial(self._unreachable, spec.id))
                self._diallers.append(dialler)
                dialler.start()
        for link in self.plant.links:
            way = Serial(link.serial) if link.serial else Tcp(link.host, link.port)
            keeper = Dialler(self._lines[link.id], way, link.id, partial(self._unreachable, link.id))
            self._diallers.append(keeper)
            keeper.start()
        if coming and self.plant.listen is not None:
            self._listener = Listener(*self.plant.listen, coming, self._claimed)
            await self._listener.start()

    def _claimed(self, reason: str) -> None:
        self._log.warning("connection refused", reason=reason)
        if not self._over:
            with self._whole:
                self._control.stranger(reason, self._clock.now())
                self._kick()

    def _unreachable(self, line: str, reason: str) -> None:
        if not self._over:
            with self._whole:
                self._control.unreachable(line, reason, self._clock.now())
                self._kick()

    def _kick(self) -> None:
        if not self._pumping:
            self._pumping = True
            self._loop.call_soon(self._pump)

    def _pump(self) -> None:
        """Carry everything that the controller gives to where it belongs."""
        self._pumping = False
        if self._over:
            return
        with self._whole:
            self._take_transactions()
            for name in self._control.dirty():
                self._lines[name].flush()
            updates = self._control.updates()
            if updates:
                self.hub.publish(updates)
                if self._recorder is not None:
                    self._recorder.note(updates)
                self.figures.jobs.take(updates)
                self._journal.take(updates)
            replies = self._control.replies()
            if updates or replies:
                self._courier.stir()
            for ticket, reply in replies:
                asked = self._asked.pop(ticket, None)
                if asked is not None and not asked[0].done():
                    asked[0].set_result(reply)
            if (task := self._control.replan()) is not None:
                self._replanner.submit(task)
            self._arm()

    def _replanned(self, tables: Tables) -> None:
        if not self._over:
            with self._whole:
                self._control.replanned(tables, self._clock.now())
            self._kick()

    def _defect(self) -> None:
        self._log.exception("defect")
        self._lose("a defect stopped the controller; see the log")

    def _take_transactions(self) -> None:
        control, waiting = self._control, self._in_flight
        while transactions := control.transactions():
            self._writer.submit_all([(one.number, one.records) for one in transactions if one.records])
            waiting.extend(transactions)
            self._commit_empty()

    def _commit_empty(self) -> None:
        """Let those that have nothing to write pass, up to the first that is being written."""
        last = None
        while self._in_flight and not self._in_flight[0].records:
            last = self._in_flight.popleft()
        if last is not None:
            self._control.committed(last.number, self._clock.now())

    def _durable(self, last: int) -> None:
        if self._over:
            return
        while self._in_flight and self._in_flight[0].number <= last:
            self._in_flight.popleft()
        with self._whole:
            self._control.committed(last, self._clock.now())
            self._commit_empty()
        self._pump()

    def _arm(self) -> None:
        deadline = self._control.deadline
        if self._timer is not None and self._armed <= deadline:
            return
        if self._timer is not None:
            self._timer.cancel()
        self._armed = deadline
        self._timer = self._loop.call_later(max(deadline - self._clock.now(), 0.001), self._fire)

    def _fire(self) -> None:
        self._timer = None
        now = self._clock.now()
        if self._control.deadline <= now and not self._over:
            with self._whole:
                self._control.tick(now)
        self._pump()

    def _may_send(self) -> bool:
        if not self._over and self._clock.now() > self._writer.held_until:
            self._lose("the lease on the plant ran out while this process stood still or the database was away")
        return not self._over

    def _troubled(self, message: str) -> None:
        if message:
            self._log.error("database", trouble=message)
        else:
            self._log.info("database is well again")
        self.trouble = message

    def _lose(self, reason: str) -> None:
        """Send nothing more."""
        if self._over:
            return
        self.trouble = reason
        self._log.critical("controller lost", reason=reason)
        self._end()
        for line in self._lines.values():
            line.stop()
        if not self.lost.done():
            self.lost.set_result(reason)

    def _end(self) -> None:
        self._over = True
        self.figures.stop()
        if self._timer is not None:
            self._timer.cancel()
            self._timer = None
        for future, _ in self._asked.values():
            if not future.done():
                future.set_result(GONE)
        self._asked.clear()

    def _tell(self, what: Callable[[Value], None], value: Value) -> None:
        """Call something on the loop from the writer's thread."""
        if not self._loop.is_closed():
            self._loop.call_soon_threadsafe(what, value)
