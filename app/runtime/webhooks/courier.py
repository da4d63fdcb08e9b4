"""Tells each webhook of the events it wants, one after the other: the durable events are the outbox."""

import asyncio
import random
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Protocol

from structlog.typing import FilteringBoundLogger

from app.domain.errors import StoreError
from app.domain.records import HistoryEvent
from app.domain.units import Timestamp
from app.domain.webhooks import Webhook, WebhookProgress, WebhookState, WebhookTry
from app.fleet.views import view_of_event
from app.runtime.showing import encode, encoded, iso
from app.runtime.telemetry import logger
from app.runtime.webhooks.sending import Post, Unreachable
from app.runtime.webhooks.signing import signature

PAGE = 100
"""Events read at a time."""
KEEP_EVERY = 1.0
"""Seconds, at most, of deliveries that a crash makes happen again. Our choice."""
KEEP_AT = 50
"""Deliveries after which the position is kept in any case. Our choice."""
GONE = 410
PING = "Ping"


@dataclass(frozen=True, slots=True)
class Pace:
    """When a delivery is tried again: after ``first`` seconds, twice as long each time, at most ``most``; half of it by chance.

    After ``give_up`` seconds without one that is taken the webhook has failed. Our choice.
    """

    first: float = 1.0
    most: float = 300.0
    give_up: float = 3 * 86_400.0

    def pause(self, attempt: int, chance: float) -> float:
        """Return the seconds after so many attempts; ``chance`` is between 0 and 1."""
        return float(min(self.most, self.first * 2.0 ** min(attempt - 1, 30))) * (0.5 + chance / 2)


class Desk(Protocol):
    """What the courier needs of the controller."""

    def webhooks(self) -> Sequence[tuple[Webhook, WebhookProgress]]:
        """Return all webhooks, and how far each has been told."""
        ...

    def webhook_told(self, progress: WebhookProgress, tries: Sequence[WebhookTry], failed: str = "") -> None:
        """Keep how far a webhook has been told; ``failed``: it is given up, and why."""
        ...

    async def events_after(self, after: int, limit: int) -> Sequence[HistoryEvent]:
        """Return durable events in order. Raises StoreError."""
        ...

    def utc(self) -> Timestamp:
        """Return the present moment."""
        ...


@dataclass(frozen=True, slots=True)
class Delivery:
    """What became of one delivery, and how many seconds the receiver wants to be left alone."""

    done: WebhookTry
    rest: float


class Courier:
    """One task a webhook that is active. ``stir`` it when events were published or a webhook changed."""

    def __init__(
        self,
        desk: Desk,
        post: Post,
        pace: Pace = Pace(),
        chance: Callable[[], float] = random.random,
        tried: Counter[str] | None = None,
    ) -> None:
        """``tried`` counts deliveries by what became of them: taken, refused, unreachable."""
        self._tried: Counter[str] = Counter() if tried is None else tried
        self.desk, self.pace, self.chance = desk, pace, chance
        self._post = post
        self._log: FilteringBoundLogger = logger(part="webhooks")
        self._routes: dict[int, _Route] = {}
        self._over = False

    def stir(self) -> None:
        """Look what there is to do."""
        if self._over:
            return
        for webhook, _ in self.desk.webhooks():
            route = self._routes.get(webhook.number)
            if route is not None:
                route.wake.set()
            elif webhook.state is WebhookState.ACTIVE:
                route = self._routes[webhook.number] = _Route(self, webhook.number)
                route.task = asyncio.create_task(route.run())
                route.task.add_done_callback(partial(self._ended, webhook.number))

    async def stop(self) -> None:
        """Deliver nothing more; what has been delivered is told."""
        self._over = True
        tasks = [route.task for route in self._routes.values() if route.task is not None]
        for task in tasks:
            task.cancel()
        await asyncio.gather(*tasks, return_exceptions=True)

    async def ping(self, number: int) -> WebhookTry | None:
        """Deliver a test at once, beside the events; None: there is no such webhook. It is in the log like any other."""
        found = self.found(number)
        if found is None:
            return None
        webhook, now = found[0], self.desk.utc()
        data = encode({"webhook": number})
        done = (await self.deliver(webhook, PING, f"ping_{number}_{int(now * 1000)}", now, data, None, 1)).done
        route = self._routes.get(number)
        if route is not None:
            return route.note(done)
        known = self.found(number)
        if known is None:
            return done
        numbered = replace(done, number=known[1].tries + 1)
        self.desk.webhook_told(replace(known[1], tries=numbered.number), [numbered])
        return numbered

    def found(self, number: int) -> tuple[Webhook, WebhookProgress] | None:
        """Return a webhook with its progress."""
        return next((pair for pair in self.desk.webhooks() if pair[0].number == number), None)

    async def deliver(
        self, webhook: Webhook, event: str, name: str, at: Timestamp, data: bytes, seq: int | None, attempt: int
    ) -> Delivery:
        """Deliver once, and return what became of it."""
        now = self.desk.utc()
        body = b'{"type":%b,"timestamp":%b,"data":%b}' % (encode(event), encode(iso(at)), data)
        secrets = [webhook.secret]
        if webhook.old_secret and webhook.old_until is not None and now < webhook.old_until:
            secrets.append(webhook.old_secret)
        headers = {
            "webhook-id": name,
            "webhook-timestamp": str(int(now)),
            "webhook-signature": signature(secrets, name, int(now), body),
        }
        status: int | None = None
        rest = 0.0
        try:
            answer = await self._post(webhook.url, headers, body)
            status, rest = answer.status, answer.retry_after or 0.0
            error = answer.refusal[:300]
        except Unreachable as why:
            error = str(why)[:300]
        self._tried["taken" if not error else "unreachable" if status is None else "refused"] += 1
        seconds = max(self.desk.utc() - now, 0.0)
        done = WebhookTry(webhook.number, 0, now, seq, event, attempt, status, round(seconds, 3), error)
        return Delivery(done, rest)

    def _ended(self, number: int, task: asyncio.Task[None]) -> None:
        """A webhook is active no more, or a defect ended its task: then it is begun anew after a while."""
        self._routes.pop(number, None)
        if task.cancelled() or self._over:
            return
        if (defect := task.exception()) is not None:
            self._log.error("defect", webhook=str(number), exc_info=defect)
            asyncio.get_running_loop().call_later(self.pace.most, self.stir)
        else:
            self.stir()


@dataclass(eq=False)
class _Route:
    """The way to one webhook."""

    courier: Courier
    number: int
    wake: asyncio.Event = field(default_factory=asyncio.Event)
    task: asyncio.Task[None] | None = None

    def __post_init__(self) -> None:
        self._desk, self._pace = self.courier.desk, self.courier.pace
        self._seen: Webhook | None = None
        self._log: FilteringBoundLogger = logger(part="webhooks", webhook=str(self.number))
        self._progress = WebhookProgress(self.number, 0, replays=-1)
        self._tries: list[WebhookTry] = []
        self._dirty = False
        self._kept = 0.0

    async def run(self) -> None:
        """Tell it of events until it is active no more."""
        try:
            while (webhook := self._current()) is not None:
                await self._page(webhook)
        finally:
            self._keep()

    def note(self, done: WebhookTry) -> WebhookTry:
        """Number a delivery, and let it be written into the log."""
        self._progress = replace(self._progress, tries=self._progress.tries + 1)
        numbered = replace(done, number=self._progress.tries)
        self._tries.append(numbered)
        self._dirty = True
        return numbered

    def _current(self) -> Webhook | None:
        """Return the webhook as it is now, with the position that somebody may have set; None: it is active no more."""
        found = self.courier.found(self.number)
        if found is None or found[0].state is not WebhookState.ACTIVE:
            return None
        webhook, known = found
        if known.replays != self._progress.replays:
            self._progress = replace(known, tries=max(known.tries, self._progress.tries))
            self._dirty = False
        elif self._seen is not None and self._seen.url != webhook.url:
            self._progress = replace(self._progress, failing=None, attempts=0, error="")
        self._seen = webhook
        return webhook

    async def _page(self, webhook: Webhook) -> None:
        self.wake.clear()
        position = self._progress.position
        try:
            page = await self._desk.events_after(position, PAGE)
        except StoreError as trouble:
            self._log.warning("events cannot be read", reason=trouble.message)
            await asyncio.sleep(self._pace.first)
            return
        if not page:
            self._keep()
            await self.wake.wait()
            return
        if page[0].seq > position + 1 and position > 0:
            self._missed(position + 1, page[0].seq - 1)
        for event in page:
            if webhook.wants(event.event) and not await self._told(event):
                return
            self._progress = replace(self._progress, position=event.seq, failing=None, attempts=0, error="")
            self._dirty = True
            if asyncio.get_running_loop().time() - self._kept >= KEEP_EVERY or len(self._tries) >= KEEP_AT:
                self._keep()
            if self._current() is not webhook:
                return

    async def _told(self, event: HistoryEvent) -> bool:
        """Deliver one event, again and again; False: the webhook has changed meanwhile, or failed."""
        data, name = encoded(view_of_event(event)), f"evt_{event.seq}_{int(event.at * 1000)}"
        replays = self._progress.replays
        while (webhook := self._current()) is not None and webhook.wants(event.event):
            if self._progress.replays != replays:
                return False
            attempt = self._progress.attempts + 1
            delivery = await self.courier.deliver(webhook, event.event, name, event.at, data, event.seq, attempt)
            done = self.note(delivery.done)
            if not done.error:
                self._progress = replace(self._progress, delivered=self._progress.delivered + 1, last=done.at)
                return True
            if not await self._again(webhook, done, delivery.rest):
                return False
        return False

    async def _again(self, webhook: Webhook, done: WebhookTry, rest: float) -> bool:
        """Wait after a delivery that was not taken; False: it is given up."""
        now = self._desk.utc()
        since = self._progress.failing if self._progress.failing is not None else done.at
        self._progress = replace(self._progress, failing=since, attempts=done.attempt, error=done.error)
        if done.attempt == 1:
            self._log.warning("webhook not taken", seq=done.seq, url=webhook.url, reason=done.error)
        if done.status == GONE:
            self._keep(failed="says that it is gone for good (410)")
            return False
        if now - since >= self._pace.give_up:
            self._keep(failed=f"has not taken event {done.seq} for {(now - since) / 3600:.0f} h ({done.error})")
            return False
        self._keep()
        pause = max(self._pace.pause(done.attempt, self.courier.chance()), min(rest, self._pace.most))
        loop = asyncio.get_running_loop()
        until = loop.time() + pause
        while loop.time() < until and self._current() is webhook:
            self.wake.clear()
            try:
                async with asyncio.timeout_at(until):
                    await self.wake.wait()
            except TimeoutError:
                break
        return True

    def _missed(self, first: int, last: int) -> None:
        """Events that it was to be told of have grown old and are gone: write that down."""
        words = f"events {first} to {last} are no longer kept"
        self._log.error("events missed", first=first, last=last)
        self.note(WebhookTry(self.number, 0, self._desk.utc(), first, "(missed)", 1, None, 0.0, words))

    def _keep(self, failed: str = "") -> None:
        if not self._dirty and not self._tries and not failed:
            return
        tries, self._tries, self._dirty = self._tries, [], False
        self._kept = asyncio.get_running_loop().time()
        self._desk.webhook_told(self._progress, tries, failed)
