"""What the heat on the map shows: counted from changes alone, kept by the five minutes, added up for a period."""

from dataclasses import replace
from pathlib import Path

from app.domain.units import Timestamp
from app.domain.view import LinkView, Topic, Update, VehicleView
from app.runtime.heat import HEAT_SECONDS, KEPT_EVERY, Counts, Heat, counted, together
from app.runtime.playback import Playback
from app.runtime.recording import Change, Limits, Recorder
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
    assert (len(last.traffic) - 1) * KEPT_EVERY == last.end - last.begin, "who came at its begin and its end counts"
    whole = playback.heat(0.0, now)
    assert whole is not None
    assert now - 6 * HEAT_SECONDS < whole.begin <= now - 4 * HEAT_SECONDS, "older ones are gone"
    assert playback.heat(now + 1.0, now + 2.0) is None
    playback.close()


def test_a_stretch_without_any_change_is_kept_by_the_five_minutes_and_beyond_a_day_as_one() -> None:
    counts = Counts(0.0)
    counts.take("V1", "101", 0.0, waits=True)
    assert list(counts.over(HEAT_SECONDS - 1)) == []
    hour = list(counts.over(3600.0 + 1))
    assert [(heat.begin, heat.end, heat.waiting) for heat in hour] == [
        (n * HEAT_SECONDS, (n + 1) * HEAT_SECONDS, {"101": HEAT_SECONDS}) for n in range(12)
    ]
    whole = together([*hour, *counts.over(7 * 86400.0)])
    assert whole is not None
    assert (whole.end, whole.waiting) == (7 * 86400.0, {"101": 7 * 86400.0})


def test_what_was_recorded_is_counted_as_it_was_while_it_was_recorded() -> None:
    vehicles = {"V1": {"barcode": "101", "activity": "waiting"}, "V2": {"barcode": "201", "activity": "moving"}}
    changes: list[Change] = [
        (60.0, "vehicles", "V1", {"activity": "moving", "barcode": "102"}),
        (90.0, "vehicles", "V2", {"activity": "waiting"}),
        (HEAT_SECONDS + 50.0, "vehicles", "V2", None),
        (HEAT_SECONDS + 60.0, "vehicles", "V3", {"activity": "waiting", "barcode": "103"}),
    ]
    assert list(counted(vehicles, changes, 0.0, HEAT_SECONDS + 100.0)) == [
        Heat(0.0, HEAT_SECONDS, {"101": 60.0, "201": HEAT_SECONDS - 90.0}, {"102": 1}),
        Heat(HEAT_SECONDS, HEAT_SECONDS + 100.0, {"201": 50.0, "103": 40.0}, {}),
    ]
