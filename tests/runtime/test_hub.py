"""The fan-out, driven by hand: no clock and no waiting beyond turns of the loop."""

import asyncio
import json
from collections.abc import Callable, Coroutine, Sequence
from typing import Any

import pytest

from app.domain.view import CarrierView, EventView, Topic, Update
from app.runtime.hub import CHANGES_KEPT, EVENTS_KEPT, Hub, ReadModel, Subscription

BOTH = frozenset({Topic.CARRIERS, Topic.EVENTS})


class Bell:
    """Stands for ``loop.call_later``: rings when the test says so."""

    def __init__(self) -> None:
        self.calls: list[Callable[[], None]] = []

    def later(self, _seconds: float, call: Callable[[], None]) -> None:
        self.calls.append(call)

    def ring(self) -> None:
        calls, self.calls = self.calls, []
        for call in calls:
            call()


def carrier(name: str, place: str | None = None) -> Update:
    return Update(Topic.CARRIERS, name, CarrierView(name, place, "host", verified=True, at=0.25))


def event(seq: int) -> Update:
    view = EventView(seq, 1.5, "Transferring", 0, "J1", None, None, None, None, "", "")
    return Update(Topic.EVENTS, str(seq), view)


def events(first: int, last: int) -> list[Update]:
    return [event(seq) for seq in range(first, last + 1)]


class Store:
    """Durable events up to a number, read one page at a time; each reading can be interrupted by a test."""

    def __init__(self, last: int) -> None:
        self.last = last
        self.first = 1
        self.reads = 0
        self.during: Callable[[], None] | None = None

    async def replay(self, after: int, limit: int) -> Sequence[EventView]:
        self.reads += 1
        page = [u.value for u in events(max(after + 1, self.first), min(self.last, after + limit))]
        during, self.during = self.during, None
        if during:
            during()
        await asyncio.sleep(0)
        return [view for view in page if isinstance(view, EventView)]


async def take(watcher: Subscription, count: int) -> list[dict[str, Any]]:
    return [json.loads((await anext(watcher)).text) for _ in range(count)]


async def waits(watcher: Subscription) -> bool:
    """Whether the watcher has nothing to give now."""
    task = asyncio.ensure_future(anext(watcher))
    for _ in range(5):
        await asyncio.sleep(0)
    idle = not task.done()
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)
    return idle


def run(test: Callable[[], Coroutine[Any, Any, None]]) -> None:
    asyncio.run(test())


def seqs(frame: dict[str, Any]) -> list[int]:
    return [item["seq"] for item in frame["events"]]


def test_a_watcher_gets_a_snapshot_then_numbered_changes() -> None:
    async def scene() -> None:
        bell = Bell()
        hub = Hub(ReadModel(), bell.later)
        hub.publish([carrier("F1", "P1")])
        watcher = hub.subscribe([Topic.CARRIERS])
        (snapshot,) = await take(watcher, 1)
        assert snapshot["type"] == "snapshot"
        assert snapshot["seq"] == 0
        assert snapshot["objects"]["carriers"]["F1"]["at"] == "1970-01-01T00:00:00.250Z"
        hub.publish([carrier("F1", "P2"), carrier("F1", "P3"), carrier("F2")])
        hub.publish([Update(Topic.CARRIERS, "F2", None)])
        assert len(bell.calls) == 1
        bell.ring()
        (change,) = await take(watcher, 1)
        assert change["seq"] == 1
        assert [(c["key"], c["value"] and c["value"]["place"]) for c in change["changes"]] == [
            ("F1", "P3"),
            ("F2", None),
        ]
        assert await waits(watcher)

    run(scene)


def test_all_watchers_of_the_same_topics_get_the_very_same_frame() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(), Bell().later)
        one, two, other = hub.subscribe(BOTH), hub.subscribe(BOTH), hub.subscribe([Topic.VEHICLES])
        assert await anext(one) is await anext(two)
        assert hub.watchers == 3
        hub.publish([carrier("F1")])
        hub.flush()
        assert await anext(one) is await anext(two)
        await anext(other)
        assert await waits(other)

    run(scene)


def test_a_slow_watcher_gets_a_resync_mark_and_the_newest_state_and_every_event() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(), Bell().later)
        slow = hub.subscribe(BOTH)
        await take(slow, 1)
        for number in range(CHANGES_KEPT + 1):
            hub.publish([carrier("F1", f"P{number}"), event(number + 1)])
            hub.flush()
        mark, snapshot = await take(slow, 2)
        assert mark == {"type": "resync"}
        assert snapshot["seq"] == CHANGES_KEPT + 1
        assert snapshot["objects"]["carriers"]["F1"]["place"] == f"P{CHANGES_KEPT}"
        got = [seq for frame in await take(slow, CHANGES_KEPT + 1) for seq in seqs(frame)]
        assert got == list(range(1, CHANGES_KEPT + 2))
        assert await waits(slow)

    run(scene)


def test_a_watcher_that_resumes_gets_old_events_from_the_store_then_live_ones_without_gap() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(last_event=700), Bell().later)
        store = Store(700)
        watcher = hub.subscribe([Topic.EVENTS], after=100, replay=store.replay)

        def meanwhile() -> None:
            store.last = 702
            hub.publish(events(701, 702))
            hub.flush()

        store.during = meanwhile
        _, first, second = await take(watcher, 3)
        assert seqs(first) + seqs(second) == list(range(101, 703))
        assert await waits(watcher)
        hub.publish([event(703)])
        hub.flush()
        assert seqs((await take(watcher, 1))[0]) == [703]

    run(scene)


def test_an_event_published_during_the_last_reading_of_the_store_is_read_again() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(last_event=5), Bell().later)
        store = Store(5)
        watcher = hub.subscribe([Topic.EVENTS], after=5, replay=store.replay)

        def meanwhile() -> None:
            store.last = 6
            hub.publish([event(6)])
            hub.flush()

        store.during = meanwhile
        _, frame = await take(watcher, 2)
        assert seqs(frame) == [6]
        assert await waits(watcher)

    run(scene)


def test_events_already_read_from_the_store_do_not_come_a_second_time_from_memory() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(last_event=5), Bell().later)
        watcher = hub.subscribe([Topic.EVENTS], after=4, replay=Store(7).replay)
        hub.publish(events(6, 7))
        _, replayed = await take(watcher, 2)
        assert seqs(replayed) == [5, 6, 7]
        assert await waits(watcher)
        hub.publish([event(8)])
        hub.flush()
        assert seqs((await take(watcher, 1))[0]) == [8]

    run(scene)


def test_a_change_is_written_at_once_while_nothing_waits_before_it() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(), Bell().later)
        watcher = hub.subscribe([Topic.CARRIERS])
        written: list[bytes] = []
        ready = True

        def direct(wire: bytes) -> bool:
            if ready:
                written.append(wire)
            return ready

        watcher.direct = direct
        hub.publish([carrier("A", "S1")])
        hub.flush()
        assert not written  # the snapshot goes first
        await take(watcher, 1)
        waiting = asyncio.ensure_future(anext(watcher))
        await asyncio.sleep(0)
        hub.publish([carrier("A", "S2")])
        hub.flush()
        assert [wire[:2] for wire in written] == [b"\x81\x7e"]
        assert json.loads(written[0][4:])["seq"] == 2
        assert not waiting.done()
        ready = False
        hub.publish([carrier("A", "S3")])
        hub.flush()
        ready = True
        hub.publish([carrier("A", "S4")])
        hub.flush()
        assert json.loads((await waiting).text)["seq"] == 3
        assert [frame["seq"] for frame in await take(watcher, 1)] == [4]
        assert len(written) == 1

    run(scene)


def test_a_watcher_is_told_of_the_gap_where_events_have_been_deleted() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(last_event=8), Bell().later)
        store = Store(8)
        store.first = 6
        watcher = hub.subscribe([Topic.EVENTS], after=2, replay=store.replay)
        found = await take(watcher, 4)
        assert [frame["type"] for frame in found] == ["snapshot", "resync", "snapshot", "event"]
        assert seqs(found[-1]) == [6, 7, 8]
        assert await waits(watcher)
        hub.publish([event(9)])
        hub.flush()
        assert seqs((await take(watcher, 1))[0]) == [9]

    run(scene)


def test_a_watcher_that_comes_with_a_number_of_another_database_gets_the_next_events() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(last_event=5), Bell().later)
        watcher = hub.subscribe([Topic.EVENTS], after=9_000, replay=Store(5).replay)
        assert len(await take(watcher, 1)) == 1
        assert await waits(watcher)
        hub.publish([event(6)])
        hub.flush()
        assert seqs((await take(watcher, 1))[0]) == [6]

    run(scene)


def test_a_watcher_far_behind_on_events_gets_them_from_the_store() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(), Bell().later)
        store = Store(EVENTS_KEPT + 10)
        slow = hub.subscribe([Topic.EVENTS], replay=store.replay)
        await take(slow, 1)
        for seq in range(1, EVENTS_KEPT + 11):
            hub.publish([event(seq)])
            hub.flush()
        got: list[int] = []
        while len(got) < EVENTS_KEPT + 10:
            got += seqs((await take(slow, 1))[0])
        assert got == list(range(1, EVENTS_KEPT + 11))
        assert store.reads > 0

    run(scene)


def test_a_watcher_without_a_store_keeps_all_events_in_memory() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(), Bell().later)
        slow = hub.subscribe([Topic.EVENTS])
        await take(slow, 1)
        hub.publish(events(1, EVENTS_KEPT + 10))
        hub.flush()
        assert len(seqs((await take(slow, 1))[0])) == EVENTS_KEPT + 10

    run(scene)


def test_choosing_other_topics_starts_over_with_a_snapshot_of_them() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(), Bell().later)
        watcher = hub.subscribe([Topic.VEHICLES])
        await take(watcher, 1)
        hub.publish([carrier("F1"), event(1)])
        watcher.select(BOTH)
        mark, snapshot = await take(watcher, 2)
        assert mark["type"] == "resync"
        assert list(snapshot["objects"]) == ["carriers"]
        assert snapshot["last_event"] == 1
        watcher.resync()
        assert [f["type"] for f in await take(watcher, 2)] == ["resync", "snapshot"]

    run(scene)


def test_closing_ends_the_iteration_and_the_last_watcher_ends_the_feed() -> None:
    async def scene() -> None:
        bell = Bell()
        hub = Hub(ReadModel(), bell.later)
        watcher = hub.subscribe(BOTH)
        await take(watcher, 1)
        task = asyncio.ensure_future(anext(watcher))
        await asyncio.sleep(0)
        watcher.close()
        with pytest.raises(StopAsyncIteration):
            await task
        assert hub.watchers == 0
        hub.publish([carrier("F1")])
        assert not bell.calls

    run(scene)


def test_the_period_comes_from_the_running_loop_unless_given() -> None:
    async def scene() -> None:
        hub = Hub(ReadModel(), period=0.0)
        watcher = hub.subscribe(BOTH)
        await take(watcher, 1)
        hub.publish([carrier("F1")])
        assert (await take(watcher, 1))[0]["type"] == "change"

    run(scene)


def test_a_list_is_built_again_at_most_every_100_ms_and_keeps_its_etag_until_then() -> None:
    now = [0.0]
    model = ReadModel(lambda: now[0])
    model.apply([carrier("F1")])
    first = model.page(Topic.CARRIERS)
    model.apply([carrier("F2")])
    assert model.page(Topic.CARRIERS) is first
    now[0] = 0.1
    second = model.page(Topic.CARRIERS)
    assert second.etag != first.etag
    assert [item["id"] for item in json.loads(second.body)["items"]] == ["F1", "F2"]
    now[0] = 9.0
    assert model.page(Topic.CARRIERS) is second
    model.apply([event(3)])
    assert model.page(Topic.CARRIERS) is second
    assert model.last_event == 3


def test_the_model_gives_and_forgets_objects() -> None:
    model = ReadModel()
    model.apply([carrier("F1"), carrier("F2")])
    model.apply([Update(Topic.CARRIERS, "F1", None), Update(Topic.CARRIERS, "F1", None)])
    assert model.get(Topic.CARRIERS, "F1") is None
    assert model.raw(Topic.CARRIERS, "F1") is None
    assert model.all(Topic.CARRIERS) == [carrier("F2").value]
    assert model.version == 4


def test_who_waits_for_an_object_is_woken_by_its_next_publication_even_if_another_gave_up() -> None:
    async def scenario() -> None:
        hub = Hub(ReadModel())
        one, two = (asyncio.ensure_future(hub.changed(Topic.CARRIERS, "F1")) for _ in range(2))
        await asyncio.sleep(0)
        one.cancel()
        hub.publish([carrier("F2")])
        await asyncio.sleep(0)
        assert not two.done()
        hub.publish([carrier("F1")])
        await two

    asyncio.run(scenario())
