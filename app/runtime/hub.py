"""The published read model, and its fan-out to everybody who watches.

State may skip: a watcher that falls behind gets the newest state after a resync mark. Events may not: each goes to every
watcher of the topic, from memory or, for one that asked for older ones or fell far behind, from the store.
"""

import asyncio
import secrets
import struct
import time
from collections import deque
from collections.abc import AsyncIterator, Awaitable, Callable, Iterable, Sequence
from dataclasses import dataclass, field

from app.domain.view import EventView, Topic, Update, View
from app.runtime.showing import encode, encoded

PERIOD = 0.1
"""Seconds between two frames of one feed, and the least age at which a list is built anew (QUALITY 1)."""
CHANGES_KEPT = 20
"""Change frames that wait for a slow watcher before it gets a fresh snapshot instead: 2 s. Our choice."""
EVENTS_KEPT = 1000
"""Events that wait in memory for a slow watcher before they are read from the store instead. Our choice."""
EVENTS_PAGE = 500
"""Events read from the store at a time."""

Replay = Callable[[int, int], Awaitable[Sequence[EventView]]]
"""``replay(after, limit)``: the durable events numbered above ``after``, in order."""
Later = Callable[[float, Callable[[], None]], object]
"""``later(seconds, call)``: as ``loop.call_later``."""


class _Object:
    """One object and its JSON, encoded at most once."""

    __slots__ = ("_raw", "view")

    def __init__(self, view: View) -> None:
        self.view = view
        self._raw: bytes | None = None

    @property
    def raw(self) -> bytes:
        if self._raw is None:
            self._raw = encoded(self.view)
        return self._raw


@dataclass(frozen=True, slots=True)
class Page:
    """All objects of a topic as one JSON body, ``{"items": [...]}``, with its ETag."""

    etag: str
    body: bytes


class ReadModel:
    """What has been published so far. Events pass through; only the number of the last is kept."""

    def __init__(self, now: Callable[[], float] = time.monotonic, last_event: int = 0) -> None:
        self.version = 0
        self.last_event = last_event
        self._now = now
        self._boot = secrets.token_hex(4)
        self._objects: dict[Topic, dict[str, _Object]] = {topic: {} for topic in Topic}
        self._versions = dict.fromkeys(Topic, 0)
        self._pages: dict[Topic, tuple[int, float, Page]] = {}

    def apply(self, updates: Iterable[Update]) -> None:
        """Take changes over, in order."""
        for update in updates:
            self.version += 1
            if isinstance(update.value, EventView):
                self.last_event = max(self.last_event, update.value.seq)
                continue
            self._versions[update.topic] = self.version
            if update.value is None:
                self._objects[update.topic].pop(update.key, None)
            else:
                self._objects[update.topic][update.key] = _Object(update.value)

    def get(self, topic: Topic, key: str) -> View | None:
        """Return one object, or None."""
        found = self._objects[topic].get(key)
        return found.view if found else None

    def all(self, topic: Topic) -> list[View]:
        """Return all objects of a topic in the order of their first appearance."""
        return [entry.view for entry in self._objects[topic].values()]

    def raw(self, topic: Topic, key: str) -> bytes | None:
        """Return one object as JSON, or None."""
        found = self._objects[topic].get(key)
        return found.raw if found else None

    def raws(self, topic: Topic) -> list[tuple[str, bytes]]:
        """Return all objects of a topic as (key, JSON)."""
        return [(key, entry.raw) for key, entry in self._objects[topic].items()]

    def page(self, topic: Topic) -> Page:
        """Return the list of a topic; up to 100 ms old, so that any number of readers cost one encoding."""
        version, now = self._versions[topic], self._now()
        kept = self._pages.get(topic)
        if kept and (kept[0] == version or now - kept[1] < PERIOD):
            return kept[2]
        body = b'{"items":[' + b",".join(entry.raw for entry in self._objects[topic].values()) + b"]}"
        page = Page(f'"{self._boot}-{version}"', body)
        self._pages[topic] = (version, now, page)
        return page


@dataclass(frozen=True, slots=True)
class Frame:
    """One message to a watcher. ``events`` are those it carries, in order; empty for a frame of state."""

    kind: str
    text: str
    events: tuple[EventView, ...] = ()
    wire: bytes = field(init=False, repr=False, compare=False)
    """The text as a frame of a WebSocket (RFC 6455 5.2): the same bytes for all."""

    def __post_init__(self) -> None:
        body = self.text.encode()
        object.__setattr__(self, "wire", _framed(len(body)) + body)


def _framed(length: int) -> bytes:
    """Return the head of a whole text frame from a server."""
    if length < 126:
        return bytes((0x81, length))
    return struct.pack("!BBH", 0x81, 126, length) if length < 65536 else struct.pack("!BBQ", 0x81, 127, length)


RESYNC = Frame("resync", '{"type":"resync"}')


def _event_frame(events: Sequence[EventView]) -> Frame:
    body = b",".join(encoded(event) for event in events)
    return Frame("event", (b'{"type":"event","events":[' + body + b"]}").decode(), tuple(events))


class _Feed:
    """All watchers of one set of topics: they get the very same frames under the same numbers."""

    def __init__(self, model: ReadModel, topics: frozenset[Topic]) -> None:
        self.topics = topics
        self.seq = 0
        self.watchers: dict[Subscription, None] = {}
        self._model = model
        self._shot: tuple[int, int, Frame] | None = None

    def change(self, dirty: Iterable[tuple[Topic, str]]) -> None:
        """Send what changed to all watchers, if it concerns them."""
        parts = []
        for topic, key in dirty:
            if topic in self.topics:
                raw = self._model.raw(topic, key) or b"null"
                parts.append(b'{"topic":"%b","key":%b,"value":%b}' % (topic.value.encode(), encode(key), raw))
        if not parts:
            return
        self.seq += 1
        text = (b'{"type":"change","seq":%d,"changes":[' % self.seq) + b",".join(parts) + b"]}"
        frame = Frame("change", text.decode())
        wire = frame.wire
        for watcher in self.watchers:
            if (eager := watcher.eager) is None or not eager(wire):
                watcher.take(frame)

    def snapshot(self) -> Frame:
        """Return the whole state under the present number; encoded once for all who ask before the next change."""
        at = (self.seq, self._model.version)
        if self._shot is None or self._shot[:2] != at:
            topics = b",".join(
                self._topic(topic) for topic in Topic if topic in self.topics and topic is not Topic.EVENTS
            )
            head = b'{"type":"snapshot","seq":%d,"last_event":%d,"objects":{' % (self.seq, self._model.last_event)
            self._shot = (*at, Frame("snapshot", (head + topics + b"}}").decode()))
        return self._shot[2]

    def _topic(self, topic: Topic) -> bytes:
        objects = b",".join(encode(key) + b":" + raw for key, raw in self._model.raws(topic))
        return b'"%b":{%b}' % (topic.value.encode(), objects)


class Subscription(AsyncIterator[Frame]):
    """What one watcher gets: a snapshot, then numbered changes, and events. Made by :meth:`Hub.subscribe`; close it after use."""

    # Slots, because hundreds are visited ten times a second, each out of the cache.
    __slots__ = (
        "_behind", "_changes", "_closed", "_events", "_feed", "_frames", "_fresh", "_given", "_hub", "_mark", "_replay",
        "_taken", "_wake", "direct", "eager",
    )  # fmt: skip

    def __init__(self, hub: "Hub", topics: frozenset[Topic], after: int | None, replay: Replay | None) -> None:
        self._hub = hub
        self._feed = hub.join(self, topics)
        self._replay = replay
        self._frames: deque[Frame] = deque()
        self._changes = 0
        self._events = 0
        self._given = hub.model.last_event if after is None else after
        self._taken = self._given
        self._behind = after is not None and replay is not None
        self._mark = False
        self._fresh = True
        self._closed = False
        self._wake = asyncio.Event()
        self.direct: Callable[[bytes], bool] | None = None
        """Takes the wire of a frame while nothing waits before it, past the iteration; False: not now."""
        self.eager: Callable[[bytes], bool] | None = None
        """``direct`` while the iteration waits and nothing is there for it."""

    async def __anext__(self) -> Frame:
        while not self._closed:
            frame = self._next() or (await self._catch_up() if self._behind else None)
            if frame is not None:
                return frame
            if not self._behind and not self._closed:
                self._wake.clear()
                self.eager = self.direct
                await self._wake.wait()
        raise StopAsyncIteration

    def take(self, frame: Frame) -> None:
        """Let a frame wait for this watcher (called by the hub)."""
        if frame.kind == "event":
            self._take_events(frame)
        elif self._changes >= CHANGES_KEPT:
            self.resync()
        elif not self._fresh:
            self._frames.append(frame)
            self._changes += 1
        self._rouse()

    def resync(self) -> None:
        """Give a resync mark and the newest state next, in place of the changes that wait."""
        self._hub.resyncs += 1
        self._hub.frames_dropped += self._changes
        self._mark = self._fresh = True
        self._frames = deque(frame for frame in self._frames if frame.kind == "event")
        self._changes = 0
        self._rouse()

    def select(self, topics: frozenset[Topic]) -> None:
        """Watch other topics from now on; starts with a resync mark and a snapshot. Events go on where they were."""
        wanted_before = Topic.EVENTS in self._feed.topics
        self._hub.leave(self, self._feed)
        self._feed = self._hub.join(self, topics)
        if Topic.EVENTS in topics and not wanted_before:
            self._given = self._taken = self._hub.model.last_event
        self.resync()

    def close(self) -> None:
        """Want nothing more; an iteration under way ends."""
        self._closed = True
        self._hub.leave(self, self._feed)
        self._rouse()

    def _rouse(self) -> None:
        self.eager = None
        self._wake.set()

    def _next(self) -> Frame | None:
        if self._mark:
            self._mark = False
            return RESYNC
        if self._fresh:
            self._fresh = False
            return self._feed.snapshot()
        if not self._frames:
            return None
        frame = self._frames.popleft()
        if frame.events:
            self._events -= len(frame.events)
            self._given = frame.events[-1].seq
        else:
            self._changes -= 1
        return frame

    def _take_events(self, frame: Frame) -> None:
        if self._behind:
            return
        news = [event for event in frame.events if event.seq > self._taken]
        if not news:
            return
        if self._replay is not None and self._events + len(news) > EVENTS_KEPT:
            self._frames = deque(waiting for waiting in self._frames if waiting.kind != "event")
            self._events = 0
            self._taken = self._given
            self._behind = True
            self._hub.catch_ups += 1
            return
        self._frames.append(frame if len(news) == len(frame.events) else _event_frame(news))
        self._events += len(news)
        self._taken = news[-1].seq

    async def _catch_up(self) -> Frame | None:
        """Return the next events from the store; none left: live ones follow from memory again."""
        assert self._replay is not None
        known = self._hub.model.last_event
        page = await self._replay(self._given, EVENTS_PAGE)
        if page and page[0].seq > self._given + 1:  # those between have grown old and are gone: a gap is marked
            self._given = page[0].seq - 1
            self.resync()
            return self._next()
        if page:
            self._given = self._taken = page[-1].seq
            return _event_frame(page)
        if self._given > known and not await self._replay(self._given - 1, 1):
            self._given = known  # a number of another database
        self._given = self._taken = max(self._given, known)
        self._behind = self._hub.model.last_event > known
        return None


class Hub:
    """Takes published updates into the model and sends them on, coalesced, at most once per period."""

    def __init__(self, model: ReadModel, later: Later | None = None, period: float = PERIOD) -> None:
        self.model = model
        self._later = later
        self._period = period
        self._armed = False
        self._dirty: dict[tuple[Topic, str], None] = {}
        self._events: list[EventView] = []
        self._feeds: dict[frozenset[Topic], _Feed] = {}
        self._awaited: dict[tuple[Topic, str], asyncio.Future[None]] = {}
        self.frames_dropped = 0
        """Frames of state that slow watchers never got, the newest state in their place."""
        self.resyncs = 0
        """How often a watcher was given a resync mark."""
        self.catch_ups = 0
        """How often a watcher was so slow that its events were read from the store again."""

    async def changed(self, topic: Topic, key: str) -> None:
        """Wait until an object is published again."""
        future = self._awaited.get((topic, key))
        if future is None:
            future = self._awaited[topic, key] = asyncio.get_running_loop().create_future()
        await asyncio.shield(future)

    @property
    def watchers(self) -> int:
        """How many watch now."""
        return sum(len(feed.watchers) for feed in self._feeds.values())

    def publish(self, updates: Sequence[Update]) -> None:
        """Take updates into the model and to everybody who watches. Call it with what is durable only."""
        self.model.apply(updates)
        for update in updates if self._awaited else ():
            if future := self._awaited.pop((update.topic, update.key), None):
                future.set_result(None)
        if not self._feeds:
            return
        for update in updates:
            if isinstance(update.value, EventView):
                self._events.append(update.value)
            else:
                self._dirty[update.topic, update.key] = None
        if updates and not self._armed:
            self._armed = True
            later = self._later or asyncio.get_running_loop().call_later
            later(self._period, self._tick)

    def subscribe(
        self, topics: Iterable[Topic], *, after: int | None = None, replay: Replay | None = None
    ) -> Subscription:
        """Return a subscription; events start after ``after`` (from the store, by ``replay``), by default with the next one."""
        return Subscription(self, frozenset(topics), after, replay)

    def flush(self) -> None:
        """Send what has gathered now."""
        dirty, self._dirty = self._dirty, {}
        events, self._events = self._events, []
        frame = _event_frame(events) if events else None
        for feed in list(self._feeds.values()):
            feed.change(dirty)
            if frame and Topic.EVENTS in feed.topics:
                for watcher in feed.watchers:
                    watcher.take(frame)

    def join(self, watcher: Subscription, topics: frozenset[Topic]) -> _Feed:
        """Add a watcher (called by :class:`Subscription`)."""
        feed = self._feeds.get(topics)
        if feed is None:
            feed = self._feeds[topics] = _Feed(self.model, topics)
        feed.watchers[watcher] = None
        return feed

    def leave(self, watcher: Subscription, feed: _Feed) -> None:
        """Remove a watcher (called by :class:`Subscription`)."""
        feed.watchers.pop(watcher, None)
        if not feed.watchers and self._feeds.get(feed.topics) is feed:
            del self._feeds[feed.topics]

    def _tick(self) -> None:
        self._armed = False
        self.flush()
