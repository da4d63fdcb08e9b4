"""Playback over REST: a moment, a period, an incident as a file, and the file opened again."""

import gzip
import json
import zlib
from pathlib import Path

import httpx
import pytest
from fastapi import FastAPI
from typer.testing import CliRunner

from app.api.application import application
from app.api.problems import OF_A_RECORDING
from app.cli import app as commands
from app.runtime.incident import NoIncident, read
from app.runtime.recorded import Recorded
from app.runtime.showing import encode
from app.settings import Settings
from app.texts import said, told
from tests.api.recordings import HEAT, JOB, STATE_AT_START, recorded
from tests.api.scripted import NOW, PLANT, Scripted

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}


@pytest.fixture
def controller(tmp_path: Path) -> Scripted:
    controller = Scripted()
    controller.playback = recorded(tmp_path)
    controller.happen("VehicleDeparted", vehicle="V001")
    return controller


async def test_a_moment_is_the_state_before_it_with_what_changed_since(client: httpx.AsyncClient) -> None:
    async def at(moment: str) -> dict[str, object]:
        answer = await client.get("/history", params={"at": moment})
        assert answer.status_code == 200, answer.text
        found: dict[str, object] = answer.json()["objects"]
        return found

    assert await at("2025-12-31T23:59:05Z") == {
        "vehicles": {"V001": {"barcode": "1001", "activity": "idle", "job": None}}
    }
    moved = {"barcode": "1002", "activity": "moving", "job": None}
    assert (await at("2025-12-31T23:59:10Z"))["vehicles"] == {"V001": moved}
    assert (await at("2025-12-31T23:59:11Z"))["jobs"] == {"J1": JOB}
    assert (await at("2026-01-01T00:00:00Z")) == {"vehicles": {"V001": {**moved, "barcode": "1003"}}, "jobs": {}}
    early = await client.get("/history", params={"at": "2025-12-31T23:58:00Z"})
    assert (early.status_code, early.json()["detail"]) == (404, "Nothing was recorded by then.")


async def test_changes_of_a_period_come_in_pages(client: httpx.AsyncClient) -> None:
    asked: dict[str, str | int] = {"from": "2025-12-31T23:59:10Z", "to": "2025-12-31T23:59:20Z", "limit": 1}
    seen = []
    while True:
        page = (await client.get("/history/changes", params=asked)).json()
        seen += page["items"]
        if page["next"] is None:
            break
        asked["after"] = page["next"]
    assert [(one["topic"], one["value"]) for one in seen] == [
        ("jobs", JOB),
        ("vehicles", {"barcode": "1003"}),
    ]


async def test_the_span_says_from_when_to_when_there_is_playback(client: httpx.AsyncClient) -> None:
    span = (await client.get("/history/span")).json()
    assert (span["from"], span["to"]) == ("2025-12-31T23:59:00.000Z", "2025-12-31T23:59:21.000Z")
    assert span["bytes"] > 50


async def test_heat_is_that_of_the_period_and_says_from_when_to_when(client: httpx.AsyncClient) -> None:
    heat = (await client.get("/history/heat")).json()
    assert heat == {"from": "2025-12-31T23:59:00.000Z", "to": "2025-12-31T23:59:30.000Z", **HEAT}
    before = {"from": "2025-12-31T22:00:00Z", "to": "2025-12-31T23:00:00Z"}
    nothing = (await client.get("/history/heat", params=before)).json()
    assert nothing == {"from": None, "to": None, "waiting": {}, "traffic": {}}
    wrong = await client.get("/history/heat", params={"from": before["to"], "to": before["from"]})
    assert (wrong.status_code, wrong.json()["field"]) == (422, "from")


def pieces(body: bytes) -> tuple[list[tuple[str, object]], bool]:
    """Return kinds and contents of pieces, and whether there are more."""
    head, _, rest = body.partition(b"\n")
    found, told = [], json.loads(head)
    for item in told["items"]:
        found.append((item["kind"], json.loads(zlib.decompress(rest[: item["size"]]))))
        rest = rest[item["size"] :]
    assert rest == b""
    return found, told["more"]


async def test_a_player_reads_the_pieces_as_they_are_kept_from_the_state_before(client: httpx.AsyncClient) -> None:
    asked = {"from": "2025-12-31T23:59:15Z", "to": "2025-12-31T23:59:30Z"}
    answer = await client.get("/history/pieces", params=asked)
    (state, first, second), more = pieces(answer.content)
    assert state == ("state", STATE_AT_START)
    assert [first[0], second[0], more] == ["changes", "changes", False]
    assert [change[1:] for change in second[1]] == [["vehicles", "V001", {"barcode": "1003"}], ["jobs", "J1", None]]  # type: ignore[attr-defined]
    after = json.loads(answer.content.partition(b"\n")[0])["items"][1]["id"]
    rest, _ = pieces((await client.get("/history/pieces", params={**asked, "after": after})).content)
    assert rest == [second]


async def test_pieces_before_all_that_is_kept_begin_with_the_first_state(client: httpx.AsyncClient) -> None:
    asked = {"from": "2025-12-31T23:50:00Z", "to": "2025-12-31T23:59:05Z"}
    assert pieces((await client.get("/history/pieces", params=asked)).content) == ([("state", STATE_AT_START)], False)
    asked["to"] = "2025-12-31T23:58:00Z"
    assert pieces((await client.get("/history/pieces", params=asked)).content) == ([], False)


async def test_events_of_note_of_a_period_are_listed_apart(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.happen("AlarmSet", vehicle="V001")
    controller.happen("VehicleArrived", vehicle="V001")
    asked = {"from": "2025-12-31T23:00:00Z", "to": "2026-01-01T00:01:00Z"}

    async def names(**more: str) -> list[str]:
        answer = await client.get("/history/events", params={**asked, **more})
        return [event["event"] for event in answer.json()["items"]]

    assert await names() == ["VehicleDeparted", "AlarmSet", "VehicleArrived"]
    assert await names(of_note="true") == ["AlarmSet"]
    assert await names(newest="true", limit="1") == ["VehicleArrived"]
    assert await names(limit="1") == ["VehicleDeparted"]


async def test_without_a_recording_that_is_said(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.playback = None
    answer = await client.get("/history/span")
    assert (answer.status_code, answer.json()["detail"]) == (409, "Nothing is recorded for playback.")


async def test_an_exported_incident_is_opened_elsewhere_and_shows_the_same(
    client: httpx.AsyncClient, tmp_path: Path
) -> None:
    asked = {"from": "2025-12-31T23:58:00Z", "to": "2026-01-01T00:00:01Z"}
    answer = await client.get("/history/export", params=asked, headers=KIM)
    assert answer.headers["content-type"] == "application/gzip"
    assert answer.headers["content-disposition"].endswith('2025-12-31T235800Z.hoistway.gz"')
    incident = read(answer.content)
    assert incident.plant == PLANT
    assert (incident.actor, len(incident.changes), len(incident.events)) == ("kim", 4, 1)
    directory = tmp_path / "elsewhere"
    directory.mkdir()
    replayed = Recorded(incident, directory)
    app = application(replayed, Settings())
    try:
        await compare(client, app)
    finally:
        replayed.close()


async def compare(client: httpx.AsyncClient, app: FastAPI) -> None:
    transport = httpx.ASGITransport(app, raise_app_exceptions=False)
    async with httpx.AsyncClient(transport=transport, base_url="http://localhost/api/v1") as other:
        for path in ("/history?at=2025-12-31T23:59:11Z", "/layout", "/history/changes?from=2025-12-31T23:00:00Z"):
            assert (await other.get(path)).json() == (await client.get(path)).json(), path
        assert (await client.get("/history/span")).json()["incident"] is None
        assert (await other.get("/history/span")).json()["incident"]["by"] == "kim"
        heat = (await other.get("/history/heat")).json()
        assert heat["from"] is not None, "it is counted anew from what was recorded"
        (event,) = (await other.get("/events")).json()["items"]
        assert (event["event"], event["vehicle"]) == ("VehicleDeparted", "V001")
        refused = await other.post("/controller/pause", json={"reason": "x"})
        assert (refused.status_code, refused.json()["detail"]) == (409, "This is a recording.")
        for path, status in (("/jobs/J1", 404), ("/vehicles/V001", 404), ("/layout/versions", 409)):
            asked = await other.get(path, headers={"Accept-Language": "ko"})
            assert (asked.status_code, asked.json()["remedy"]) == (status, told(OF_A_RECORDING, "ko"))
        assert "GET /api/v1/history/span" in (await other.get("/history?at=2020-01-01T00:00:00Z")).json()["remedy"]


def head(**changed: object) -> bytes:
    """The first line of an incident's file."""
    usual = {"hoistway": 1, "from": NOW - 60, "to": NOW, "made": "2026-01-01T00:00:00Z", "by": "kim", "plant": PLANT}
    return encode({**usual, **changed})


STATE = b'{"state": {"vehicles": {"V001": {"barcode": "1001"}}}}'


@pytest.mark.parametrize(
    ("body", "why"),
    [
        (b"", "it is empty"),
        (b"PK", "it is not packed by gzip"),
        (b"\x1f\x8b", "it ends too soon"),
        (b"\x1f\x8b\x08\x00" + b"\xff" * 40, "it is damaged: its bytes do not fit their checksum"),
        (gzip.compress(b""), "its line 1 cannot be understood"),
        (gzip.compress(b"[1]\n"), "its first line does not say what it is"),
        (gzip.compress(b"{}\n"), "its first line does not say what it is"),
        (gzip.compress(head()), "it has no state of the plant"),
        (gzip.compress(head(**{"from": {}}) + b"\n" + STATE), "its line 1 cannot be understood"),
        (gzip.compress(head(to=1e308) + b"\n" + STATE), "its line 1 cannot be understood"),
        (gzip.compress(head() + b"\n" + STATE)[:-9], "it ends too soon"),
        (gzip.compress(head() + b"\n" + STATE + b"\n7\n"), "its line 3 cannot be understood"),
    ],
    ids=["nothing", "zip", "cut", "damaged", "empty", "list", "object", "head", "from", "to", "end", "row"],
)
def test_a_file_that_is_no_incident_is_said_to_be_none(body: bytes, why: str, tmp_path: Path) -> None:
    with pytest.raises(NoIncident) as none:
        read(body)
    assert none.value.message == f"this is no recorded incident: {why}"
    assert said(none.value.message, "ko").startswith("기록 파일이 아님: ")
    (tmp_path / "it.incident").write_bytes(body)
    shown = CliRunner().invoke(commands, ["replay", str(tmp_path / "it.incident")])
    assert shown.exit_code == 1
    assert f"it.incident: this is no recorded incident: {why}" in shown.output


def test_a_file_that_is_not_there_is_said_to_be_away(tmp_path: Path) -> None:
    shown = CliRunner().invoke(commands, ["replay", str(tmp_path / "none.incident")])
    assert (shown.exit_code, "none.incident cannot be read: No such file or directory" in shown.output) == (1, True)


def test_a_file_that_would_fill_the_memory_is_not_unpacked(monkeypatch: pytest.MonkeyPatch) -> None:
    whole = gzip.compress(head() + b"\n" + STATE)
    assert read(whole).actor == "kim"
    monkeypatch.setattr("app.runtime.incident.LARGEST", 100)
    with pytest.raises(NoIncident, match="unpacks to more than 0 MB"):
        read(whole)


@pytest.mark.parametrize("moment", ["9999-12-31T23:59:59-23:59", "0001-01-01T00:00:00Z", "1969-12-31T23:59:59Z"])
@pytest.mark.parametrize(
    ("path", "name"),
    [("/history", "at"), ("/history/export", "to"), ("/statistics", "to"), ("/statistics/report", "to")],
)
async def test_a_moment_at_the_edge_of_the_calendar_is_refused(
    client: httpx.AsyncClient, path: str, name: str, moment: str
) -> None:
    answer = await client.get(path, params={name: moment}, headers=KIM)
    assert (answer.status_code, answer.json()["detail"]) == (422, f"{name}: lies outside 1970 to 9000")
