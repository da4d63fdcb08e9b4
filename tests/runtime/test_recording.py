"""The recorder: what is shown is played back as it was, and only what is other than before is kept."""

import threading
from dataclasses import replace
from pathlib import Path
from typing import Any

from app.domain.errors import StoreError
from app.domain.units import Timestamp
from app.domain.view import CarrierView, DriveView, HoldView, LinkView, LockoutView, Topic, Update, VehicleView
from app.runtime.playback import Playback
from app.runtime.recording import WAITING, Limits, Recorder
from app.runtime.telemetry import logger
from app.store.playback import Piece, PlaybackStore

LINK = LinkView(up=True, since=0.0)
VEHICLE = VehicleView("V1", 1, "default", "a", "not_assigned", "idle", "in_service", LINK, barcode="101")


class Watched(PlaybackStore):
    """Says when it has been asked to keep something; fails, or waits to be let go, while it is told to."""

    failing = False
    held: threading.Event | None = None

    def __init__(self, url: str) -> None:
        super().__init__(url)
        self._asked = threading.Semaphore(0)

    def append(self, some: Any) -> None:
        if self.held is not None:
            assert self.held.wait(60)
        try:
            if self.failing:
                raise StoreError("the disk is full")
            super().append(some)
        finally:
            self._asked.release()

    def wait(self) -> None:
        assert self._asked.acquire(timeout=60)


class Scene:
    """A recorder on a clock of its own."""

    def __init__(self, directory: Path, store: Watched | None = None) -> None:
        self.url, self.now = f"sqlite:///{directory}/plant.db", 1000.0
        self.store = store or Watched(self.url)
        self.recorder = Recorder(self.store, Limits(1e9, 10**9), lambda: Timestamp(self.now), logger(part="test"))

    def show(self, at: float, **changes: Any) -> None:
        self.now = at
        self.recorder.note([Update(Topic.VEHICLES, "V1", replace(VEHICLE, **changes))])

    def ended(self) -> Playback:
        self.recorder.close()
        return Playback(self.url)


def barcode(playback: Playback, at: float) -> object:
    found = playback.state(at)
    return None if found is None else found.objects["vehicles"]["V1"]["barcode"]


def test_every_moment_between_two_whole_states_can_be_seen(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    for n in range(200):
        scene.show(1000.0 + n, barcode=str(n))
        if n % 3 == 2:
            scene.recorder.flush()
            scene.store.wait()
    playback = scene.ended()
    assert [barcode(playback, 1000.0 + n + 0.5) for n in range(3, 200)] == [str(n) for n in range(3, 200)]
    changes = list(playback.changes(1000, 1300))
    assert all(change[3] == {"barcode": change[3]["barcode"]} for _, change in changes)
    playback.close()


def test_what_looks_the_same_on_a_map_is_not_kept(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    scene.show(1000)
    scene.recorder.flush()
    for n in range(50):
        scene.show(1001.0 + n, dist=n, waiting=f"{n} s", seen=float(n))
    scene.show(1060, barcode="102", waiting="for V2")
    playback = scene.ended()
    assert [change[3] for _, change in playback.changes(1000, 2000)] == [{"barcode": "102", "waiting": "for V2"}]
    playback.close()


def test_a_hold_and_a_lockout_are_recorded_with_their_reason_and_since_when(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    scene.show(1000)
    scene.recorder.flush()
    scene.show(1001, hold=HoldView("F = 1 without a job", "look at it", 1001.0))
    scene.show(1002, hold=HoldView("F = 1 without a job", "look at it", 1001.0), dist=5)
    scene.show(1003, lockout=LockoutView("kim", "belt", 1003.0))
    playback = scene.ended()
    since = {"reason": "F = 1 without a job", "remedy": "look at it", "since": "1970-01-01T00:16:41.000Z"}
    locked = {"owner": "kim", "reason": "belt", "since": "1970-01-01T00:16:43.000Z", "releases": []}
    assert [change[3] for _, change in playback.changes(1000.5, 2000)] == [
        {"hold": since},
        {"hold": None, "lockout": locked},
    ]
    playback.close()


def test_a_drive_is_recorded_when_it_does_something_else_but_not_wherever_it_goes(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    drive = DriveView("X", "X axis", "L1", 1, "m1", online=True, mode="monitoring")
    seen = (drive, replace(drive, distance=500), replace(drive, distance=900, moving=True), replace(drive, error="hot"))
    for second, view in enumerate(seen):
        scene.now = 1000.0 + second
        scene.recorder.note([Update(Topic.DRIVES, "X", view)])
        scene.recorder.flush()
    playback = scene.ended()
    kept = [(change[0], change[3]["distance"], change[3]["error"]) for _, change in playback.changes(1000.5, 2000)]
    assert kept == [(1002.0, 900, ""), (1003.0, None, "hot")]
    playback.close()


def test_what_went_and_came_again_as_it_was_is_there_again(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    scene.show(1000)
    scene.recorder.flush()
    scene.now = 1001.0
    scene.recorder.note([Update(Topic.VEHICLES, "V1", None)])
    scene.show(1002)
    playback = scene.ended()
    assert barcode(playback, 1003) == "101"
    playback.close()


def test_objects_that_go_are_gone_and_topics_without_a_place_are_left_out(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    scene.show(1000)
    scene.recorder.flush()
    scene.now = 1001.0
    carrier = CarrierView("F1", "P1", "host", verified=True, at=1.0)
    scene.recorder.note([Update(Topic.CARRIERS, "F1", carrier), Update(Topic.EVENTS, "1", None)])
    scene.now = 1002.0
    scene.recorder.note([Update(Topic.CARRIERS, "F1", None)])
    playback = scene.ended()
    there, gone = playback.state(1001.5), playback.state(1003)
    assert there is not None
    assert gone is not None
    assert there.objects["carriers"]["F1"]["place"] == "P1"
    assert (gone.objects["carriers"], "events" in gone.objects) == ({}, False)
    playback.close()


def test_after_a_failure_a_whole_state_follows_so_that_nothing_is_shown_wrong(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    for at, failing, place in ((1000, False, "101"), (1001, True, "102"), (1002, True, "103"), (1003, False, "103")):
        scene.store.failing = failing
        scene.show(at, barcode=place, loaded=at == 1003)
        scene.recorder.flush()
        scene.store.wait()
    playback = scene.ended()
    assert barcode(playback, 1004) == "103"
    playback.close()


def test_a_slow_disk_never_lets_more_than_so_much_wait(tmp_path: Path) -> None:
    store = Watched(f"sqlite:///{tmp_path}/plant.db")
    store.held = threading.Event()
    scene = Scene(tmp_path, store)
    for n in range(WAITING * 3):
        scene.show(1000.0 + n, barcode=str(n))
        scene.recorder.flush()
    assert scene.recorder.waiting <= WAITING
    store.held.set()
    playback = scene.ended()
    assert barcode(playback, 2000) == str(WAITING * 3 - 1)
    playback.close()


def test_the_whole_state_is_kept_sooner_where_many_changes_have_come_since(tmp_path: Path) -> None:
    kept: list[str] = []

    class Naming(Watched):
        def append(self, some: Any) -> None:
            kept.extend(piece.kind for piece in some)
            super().append(some)

    scene = Scene(tmp_path, Naming(f"sqlite:///{tmp_path}/plant.db"))
    for second in range(20):
        for n in range(50):
            scene.show(1000.0 + second + n / 50, barcode=str(second * 50 + n))
        scene.recorder.flush()
        scene.store.wait()
    playback = scene.ended()
    assert 3 < kept.count("state") < 15
    assert [barcode(playback, 1000.5 + second) for second in range(1, 20)] == [
        str(second * 50 + 25) for second in range(1, 20)
    ]
    playback.close()


def test_pieces_are_small(tmp_path: Path) -> None:
    kept: list[Piece] = []

    class Counting(Watched):
        def append(self, some: Any) -> None:
            kept.extend(some)

    scene = Scene(tmp_path, Counting(f"sqlite:///{tmp_path}/plant.db"))
    scene.show(1000)
    scene.recorder.flush()
    for n in range(1000):
        scene.show(1001.0 + n / 1000, barcode=str(10_000 + n))
    scene.recorder.close()
    assert sum(len(piece.body) for piece in kept if piece.kind == "changes") < 20 * 1000


def test_pieces_are_given_so_many_at_a_time_and_go_on_after_the_last(tmp_path: Path) -> None:
    scene = Scene(tmp_path)
    for n in range(250):
        scene.show(1000.0 + n, barcode=str(n))
        scene.recorder.flush()
        scene.store.wait()
    playback = scene.ended()
    found, more = playback.pieces(1130, 1249)
    assert (found[0].kind, found[0].begin <= 1130 < found[0].begin + 62, more) == ("state", True, True)
    rest, more = playback.pieces(1130, 1249, found[-1].id)
    assert [one.id for one in (*found, *rest)] == list(range(found[0].id, rest[-1].id + 1))
    assert (rest[-1].end, more) == (1249.0, False)
    playback.close()
