"""What the heat on the map shows: counted from changes alone, kept by the five minutes, added up for a period."""

from dataclasses import replace
from pathlib import Path

from app.domain.units import Timestamp
from app.domain.view import LinkView, Topic, Update, VehicleView
from app.runtime.heat import HEAT_SECONDS, KEPT_EVERY, Counts, Heat, together
from app.runtime.playback import Playback
from app.runtime.recording import Limits, Recorder
from app.runtime.telemetry import logger
from tests.runtime.test_recording import Watched

VEHICLE = VehicleView("V1", 1, "default", "a", "not_assigned", "idle", "in_service", LinkView(up=True, since=0.0))


def test_a_wait_counts_from_one_change_to_the_next_and_up_to_the_moment_that_is_asked_for() -> None:
    counts = Counts(100.0)
    counts.take("V1", "101", 100.0, waits=True)
    counts.take("V1", "101", 130.0, waits=False)
    counts.take("V2", "101", 110.0, waits=True)
    assert counts.until(150.0) == Heat(100.0, 150.0, {"101": 70.0}, {})
    assert counts.until(160.0).waiting == {"101": 80.0}, "nothing is counted twice"


def test_who_comes_counts_once_and_who_is_seen_first_or_stays_does_not() -> None:
    counts = Counts(0.0)
    for at, barcode in enumerate(["101", "102", "102", "103", None, "104", "105"]):
        counts.take("V1", barcode, float(at), waits=False)
    assert counts.until(10.0).traffic == {"102": 1, "103": 1, "105": 1}


def test_counting_anew_goes_on_with_the_vehicles_where_they_are() -> None:
    counts = Counts(0.0)
    counts.take("V1", "101", 0.0, waits=True)
    counts.until(300.0)
    counts.begin_anew(300.0)
    counts.take("V1", "102", 310.0, waits=False)
    assert counts.until(600.0) == Heat(300.0, 600.0, {"101": 10.0}, {"102": 1})


def test_several_are_added_up() -> None:
    some = [Heat(0.0, 300.0, {"101": 1.5}, {"102": 2}), Heat(300.0, 600.0, {"101": 2.0, "103": 1.0}, {"102": 1})]
    assert together(some) == Heat(0.0, 600.0, {"101": 3.5, "103": 1.0}, {"102": 3})
    assert together([]) is None


def test_a_recorder_keeps_it_for_as_long_as_playback_and_finds_it_by_the_period(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path}/plant.db"
    now = 0.0
    store = Watched(url)
    recorder = Recorder(store, Limits(4 * HEAT_SECONDS, 10**9), lambda: Timestamp(now), logger(part="test"))
    for n in range(int(10 * HEAT_SECONDS / KEPT_EVERY)):
        now = n * KEPT_EVERY
        activity = "waiting" if n % 2 else "moving"
        recorder.note([Update(Topic.VEHICLES, "V1", replace(VEHICLE, barcode=str(100 + n), activity=activity))])
        recorder.flush()
        store.wait()
    recorder.close()
    playback = Playback(url)
    last = playback.heat(now - 2 * HEAT_SECONDS, now)
    assert last is not None
    assert last.begin <= now - 2 * HEAT_SECONDS
    assert last.end == now
    assert set(last.waiting.values()) == {KEPT_EVERY}
    assert all(int(barcode) % 2 for barcode in last.waiting)
    assert len(last.traffic) * KEPT_EVERY == last.end - last.begin
    whole = playback.heat(0.0, now)
    assert whole is not None
    assert now - 6 * HEAT_SECONDS < whole.begin <= now - 4 * HEAT_SECONDS, "older ones are gone"
    assert playback.heat(now + 1.0, now + 2.0) is None
    playback.close()
