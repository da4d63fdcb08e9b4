"""A recording of some seconds: V001 drives from 1001 to 1003, and a job comes and goes."""

from pathlib import Path

from app.runtime.playback import Playback
from app.runtime.recording import packed
from app.store.playback import CHANGES, STATE, Piece, PlaybackStore
from tests.api.scripted import NOW

JOB = {
    "id": "J1",
    "order": 1,
    "state": "queued",
    "leg": "none",
    "source": "P1",
    "destination": "P2",
    "priority": 50,
    "carrier": None,
    "vehicle": None,
    "reason": "no vehicle is free",
    "actor": "mes",
    "created": "2025-12-31T23:59:11.000Z",
    "ended": None,
}
HEAT = {"waiting": {"1003": 9.5}, "traffic": {"1002": 1, "1003": 1}}
STATE_AT_START = {"vehicles": {"V001": {"barcode": "1001", "activity": "idle", "job": None}}}


def recorded(directory: Path) -> Playback:
    """Return the playback of a plant whose database lies in a directory."""
    url = f"sqlite:///{directory}/plant.db"
    store = PlaybackStore(url)
    first = [
        [NOW - 50, "vehicles", "V001", {"barcode": "1002", "activity": "moving"}],
        [NOW - 49, "jobs", "J1", JOB],
    ]
    second = [[NOW - 40, "vehicles", "V001", {"barcode": "1003"}], [NOW - 39, "jobs", "J1", None]]
    store.append([Piece(STATE, NOW - 60, NOW - 60, 1, packed(STATE_AT_START))])
    store.append([Piece(CHANGES, NOW - 50, NOW - 49, 2, packed(first))])
    store.append([Piece(CHANGES, NOW - 40, NOW - 39, 2, packed(second))])
    store.keep_heat(NOW - 60, NOW - 30, packed({"begin": NOW - 60, "end": NOW - 30, **HEAT}))
    store.close()
    return Playback(url)
