"""Routes about drives, on a controller that answers at once: what they ask, and how they answer."""

import asyncio
import csv
import io

import httpx
import pytest

from app.domain import drive_requests as d
from app.domain.drive import Key, Parameter, SetInputs, Turn
from app.domain.drive_records import OperationState
from app.domain.ids import Actor
from tests.api.scripted import NOW, Scripted
from tests.api.scripted_drives import D1, D2

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}


def asked(controller: Scripted) -> d.DriveOrder:
    request = controller.seen[-1]
    assert isinstance(request, d.DriveOrder)
    return request


async def test_drives_are_listed_and_shown(client: httpx.AsyncClient) -> None:
    listed = (await client.get("/drives")).json()["items"]
    assert [(drive["id"], drive["line"], drive["address"]) for drive in listed] == [
        ("D1", "AXES", 1),
        ("D2", "AXES", 2),
    ]
    one = await client.get("/drives/D1")
    assert (one.json()["online"], one.json()["model"]) == (True, "HI-1")
    assert (await client.get("/drives/D1", headers={"If-None-Match": one.headers["etag"]})).status_code == 304
    missing = await client.get("/drives/D9")
    assert (missing.status_code, missing.json()["remedy"]) == (404, "GET /api/v1/drives lists them.")


@pytest.mark.parametrize(
    ("method", "path", "body", "request_"),
    [
        ("POST", "/drives/D1/status", None, d.AskDriveStatus(Actor("kim"), D1)),
        ("POST", "/drives/D1/keys", {"key": "stop_reset"}, d.PressDriveKey(Actor("kim"), D1, Key.STOP_RESET)),
        (
            "PUT",
            "/drives/D1/inputs",
            {"home": True, "step": 12},
            d.SetDriveInputs(Actor("kim"), D1, SetInputs(home=True, step=12)),
        ),
        ("POST", "/drives/D1/parameters/1c/read", None, d.ReadDrive(Actor("kim"), D1, (Parameter(0x1C),))),
        (
            "POST",
            "/drives/D1/read",
            {"parameters": ["01", "ff", "01"]},
            d.ReadDrive(Actor("kim"), D1, (Parameter(1), Parameter(255))),
        ),
        (
            "POST",
            "/drives/D1/read",
            {},
            d.ReadDrive(Actor("kim"), D1, tuple(Parameter(n) for n in range(256))),
        ),
        ("PUT", "/drives/D1/parameters/1C", {"value": 1.5}, d.WriteDrive(Actor("kim"), D1, Parameter(28), value=1.5)),
        ("POST", "/drives/D1/backups", {"note": "x"}, d.BackUpDrive(Actor("kim"), D1, "x")),
        ("POST", "/drives/D1/compare", {"drive": "D2"}, d.CompareDrive(Actor("kim"), D1, "drive D2", other=D2)),
        ("POST", "/links/AXES/stop", None, d.StopDriveLine(Actor("kim"), "AXES")),  # type: ignore[arg-type]
    ],
)
async def test_what_is_asked_becomes_an_operation_that_can_be_looked_up(
    client: httpx.AsyncClient, controller: Scripted, method: str, path: str, body: object, request_: d.DriveOrder
) -> None:
    answer = await client.request(method, path, json=body, headers=KIM)
    assert answer.status_code == 202, answer.text
    assert asked(controller) == request_
    assert answer.json()["state"] == "running"
    where = answer.headers["location"]
    assert where == "/api/v1/operations/1"
    found = await client.get(f"http://localhost{where}")
    assert found.json() == answer.json()
    controller.hub.publish([controller.drives.end(1)])
    assert (await client.get(f"http://localhost{where}")).json()["state"] == "done"


async def test_a_caller_can_wait_for_the_end(client: httpx.AsyncClient, controller: Scripted) -> None:
    waiting = asyncio.ensure_future(client.post("/drives/D1/status", params={"wait": 30}, headers=KIM))
    while not controller.drives.operations:
        await asyncio.sleep(0)
    assert not waiting.done()
    controller.hub.publish([controller.drives.end(1)])
    answer = await waiting
    assert (answer.status_code, answer.json()["state"]) == (200, "done")
    assert answer.headers["location"] == "/api/v1/operations/1"
    late = await client.post("/drives/D1/status", params={"wait": 0.01}, headers=KIM)
    assert (late.status_code, late.json()["state"]) == (202, "running")
    again = await client.get("/operations/2", params={"wait": 0.01})
    assert (again.status_code, again.json()["state"]) == (200, "running")
    assert (await client.get("/operations/2", params={"wait": 100})).status_code == 422


async def test_operations_are_listed_in_pages_and_cancelled(client: httpx.AsyncClient, controller: Scripted) -> None:
    for drive in ("D1", "D2", "D1"):
        await client.post(f"/drives/{drive}/status")
    page = (await client.get("/operations", params={"limit": 2})).json()
    assert ([row["id"] for row in page["items"]], page["next"]) == (["3", "2"], 2)
    rest = (await client.get("/operations", params={"after": 2})).json()
    assert ([row["id"] for row in rest["items"]], rest["next"]) == (["1"], None)
    mine = (await client.get("/drives/D1/operations")).json()["items"]
    assert [row["id"] for row in mine] == ["3", "1"]
    cancelled = await client.post("/operations/3/cancel", headers=KIM)
    assert (cancelled.status_code, asked(controller)) == (200, d.CancelDriveOperation(Actor("kim"), 3))
    assert (await client.post("/operations/9/cancel")).status_code == 404
    assert (await client.get("/operations/9")).status_code == 404


async def test_parameters_are_shown_raw_and_in_their_unit(client: httpx.AsyncClient) -> None:
    listed = (await client.get("/drives/D1/parameters")).json()["items"]
    assert [(row["number"], row["raw"], row["value"], row["unit"]) for row in listed] == [
        ("1C", 123, 1.23, "s"),
        ("1D", None, None, ""),
    ]
    one = await client.get("/drives/D1/parameters/1c")
    assert (one.headers["etag"], one.json()["text"], one.json()["at"]) == (
        '"123"',
        "1.23 s",
        "2026-01-01T00:00:00.000Z",
    )
    unread = await client.get("/drives/D1/parameters/1D")
    assert (unread.json()["name"], unread.json()["raw"]) == ("Direction", None)
    assert "etag" not in unread.headers
    raw = (await client.get("/drives/D2/parameters/44")).json()
    assert (raw["named"], raw["raw"], raw["number"]) == (False, None, "44")
    catalogue = (await client.get("/drives/D1/catalogue")).json()
    assert (catalogue["model"], catalogue["parameters"][1]["choices"]) == ("HI-1", {"0": "CW", "1": "CCW"})
    assert (await client.get("/drives/D2/catalogue")).json()["parameters"] == []


async def test_if_match_says_what_the_writer_saw(client: httpx.AsyncClient, controller: Scripted) -> None:
    headers = KIM | {"If-Match": '"123"'}
    await client.put("/drives/D1/parameters/1C", json={"raw": 150}, headers=headers)
    assert asked(controller) == d.WriteDrive(Actor("kim"), D1, Parameter(0x1C), 150, expected=123)  # type: ignore[arg-type]
    await client.put("/drives/D1/parameters/1C", json={"raw": 150, "raw_access": True}, headers=KIM)
    assert asked(controller) == d.WriteDrive(Actor("kim"), D1, Parameter(0x1C), 150, raw_access=True)  # type: ignore[arg-type]


@pytest.mark.parametrize("body", [{}, {"raw": 1, "value": 1.0}, {"raw": 10000}, {"raw": -1}, {"raw": 1.5}])
async def test_a_write_has_either_raw_or_value(client: httpx.AsyncClient, body: object) -> None:
    answer = await client.put("/drives/D1/parameters/1C", json=body)
    assert (answer.status_code, answer.json()["code"]) == (422, "invalid")


async def test_backups_are_listed_shown_and_downloaded(client: httpx.AsyncClient, controller: Scripted) -> None:
    for _ in range(3):
        controller.drives.keep_backup()
    page = (await client.get("/drives/D1/backups", params={"limit": 2})).json()
    assert ([row["id"] for row in page["items"]], page["next"]) == ([3, 2], 2)
    assert page["items"][0] == {
        "id": 3,
        "drive": "D1",
        "model": "HI-1",
        "at": "2026-01-01T00:00:00.000Z",
        "actor": "kim",
        "note": "a note",
        "parameters": 255,
    }
    one = await client.get("/drives/D1/backups/2")
    assert one.json()["values"][0x1C] == {
        "parameter": "1C",
        "raw": 28,
        "name": "Acceleration",
        "value": 0.28,
        "unit": "s",
    }
    assert "D1-2.json" in one.headers["content-disposition"]
    as_csv = await client.get("/drives/D1/backups/2", params={"format": "csv"})
    assert as_csv.headers["content-type"].startswith("text/csv")
    rows = list(csv.DictReader(io.StringIO(as_csv.text)))
    assert (len(rows), rows[28]) == (
        255,
        {"parameter": "1C", "raw": "28", "name": "Acceleration", "value": "0.28", "unit": "s"},
    )
    assert (await client.get("/drives/D1/backups/9")).status_code == 404
    assert "is of drive D1" in (await client.get("/drives/D2/backups/2")).json()["detail"]


async def test_comparing_and_restoring_take_the_values_of_the_backup(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    controller.drives.keep_backup()
    await client.post("/drives/D1/compare", json={"backup": 1})
    compared = asked(controller)
    assert isinstance(compared, d.CompareDrive)
    assert (compared.what, len(compared.values), compared.values[-1]) == ("backup 1 of D1", 255, (254, 254))
    await client.post("/drives/D1/restore", json={"backup": 1, "dry_run": True})
    restored = asked(controller)
    assert isinstance(restored, d.RestoreDrive)
    assert (restored.model, restored.dry_run, len(restored.values)) == ("HI-1", True, 255)
    assert (await client.post("/drives/D1/restore", json={"backup": 7})).status_code == 404
    both = await client.post("/drives/D1/compare", json={"backup": 1, "drive": "D2"})
    assert both.status_code == 422


async def test_a_jog_is_begun_kept_and_let_go(client: httpx.AsyncClient, controller: Scripted) -> None:
    begun = await client.post("/drives/D1/jog", json={"direction": "ccw"}, headers=KIM)
    assert (begun.status_code, begun.json()) == (202, {"drive": "D1", "jog": "1", "hold": 0.5})
    assert asked(controller) == d.JogDrive(Actor("kim"), D1, Turn.CCW)
    where = f"http://localhost{begun.headers['location']}"
    assert (await client.post(where)).json()["hold"] == 0.5
    assert (await client.get(where)).json()["kind"] == "jog"
    other = (await client.post("/drives/D2/jog/1")).json()
    assert (other["code"], other["detail"]) == ("not-found", "D2 has no jog 1.")
    released = await client.delete(where)
    assert released.status_code == 202
    assert controller.drives.words == [d.KeepDriveJog(1), d.ReleaseDriveJog(1)]
    assert len(controller.seen) == 1
    controller.hub.publish([controller.drives.end(1)])
    over = await client.post(where)
    assert (over.status_code, over.json()["code"]) == (409, "not-now")
    assert (await client.get("/drives/D2/jog/1")).status_code == 404


async def test_parameters_are_watched_for_a_while(client: httpx.AsyncClient, controller: Scripted) -> None:
    answer = await client.put("/drives/D1/watches/mine", json={"parameters": ["1c", "1D"], "seconds": 5})
    assert answer.json() == {"watch": "mine", "drive": "D1", "parameters": ["1C", "1D"], "seconds": 5.0}
    assert controller.drives.words[-1] == d.WatchDrive("rest/D1/mine", D1, (Parameter(28), Parameter(29)), 5.0)  # type: ignore[arg-type]
    assert (await client.delete("/drives/D1/watches/mine")).status_code == 204
    assert (await client.delete("/drives/D1/watches/other")).status_code == 404
    assert (await client.put("/drives/D9/watches/x", json={"parameters": ["1C"]})).status_code == 404


async def test_links_are_listed_with_their_figures_and_frames_explained(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    (link,) = (await client.get("/links")).json()["items"]
    assert (link["id"], link["wire"], link["up"], link["devices"], link["figures"]) == (
        "AXES",
        "hi",
        True,
        ["D1", "D2"],
        {"sent": 1},
    )
    assert (await client.get("/links/AXES")).json() == link
    assert (await client.get("/links/NOPE")).status_code == 404
    controller.drives.traffic = [(NOW, "out", b"\x02M1SSQ@#8\x03"), (NOW, "in", b"\x02S1SSA@4&0&07#5\x03?")]
    frames = (await client.get("/links/AXES/frames")).json()["items"]
    assert (frames[0]["direction"], frames[0]["frames"][0]["kind"]) == ("out", "SSQ")
    assert {"name": "CCC", "value": "SSQ", "meaning": "ask for the status", "depth": 0} in frames[0]["frames"][0][
        "fields"
    ]
    assert [piece["kind"] for piece in frames[1]["frames"]] == ["SSA", "garbled"]
    assert (await client.get("/drives/D1/frames", params={"lang": "ko"})).status_code == 200
    assert (await client.get("/links/NOPE/frames")).status_code == 404


async def test_a_lockout_needs_a_name(client: httpx.AsyncClient, controller: Scripted) -> None:
    assert (await client.post("/drives/D1/lockout", json={"reason": "belt"})).status_code == 422
    locked = await client.post("/drives/D1/lockout", json={"reason": "belt"}, headers=KIM)
    assert (locked.status_code, asked(controller)) == (200, d.LockDrive(Actor("kim"), D1, "belt"))
    assert (await client.delete("/drives/D1/lockout", headers=KIM)).status_code == 200
    assert OperationState.RUNNING not in {one.state for one in controller.drives.operations.values()}
