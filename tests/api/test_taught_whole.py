"""Taught values on the running controller and its database: import, export, compare, roll back, drift, what would be sent."""

from pathlib import Path

import httpx
import pytest

from tests.api.test_whole import running

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}
CSV = KIM | {"Content-Type": "text/csv"}
FIRST = {"shft": 1, "rota": 2, "lift": 3}


async def put(client: httpx.AsyncClient, path: str, shft: int, rota: int, lift: int) -> None:
    answer = await client.put(path, json={"shft": shft, "rota": rota, "lift": lift}, headers=KIM)
    assert answer.status_code == 200, answer.text


async def test_what_would_be_sent_and_from_which_rows(tmp_path: Path) -> None:
    async with running(tmp_path / "plant.db") as client:
        unknown = (await client.get("/teaching/targets/P1/V001")).json()
        assert (unknown["refusal"], unknown["complete"]) == ("V001 has no OFFSET (SHFT, ROTA, LIFT)", False)
        assert (unknown["shft"], unknown["dest"]["source"], unknown["offset"]) == (None, "plant file", None)
        await put(client, "/vehicles/V001/offset", 10, 20, 30)
        shown = (await client.get("/teaching/targets/P1/V001")).json()
        assert [shown[axis] for axis in ("shft", "rota", "lift")] == [11, 22, 33]
        assert (shown["refusal"], shown["complete"], shown["reference"]) == ("", True, False)
        assert (shown["dest"]["version"], shown["offset"]["actor"]) == (1, "kim")
        assert (await client.get("/teaching/targets/L3/V001")).status_code == 422
        assert (await client.get("/teaching/targets/P9/V001")).status_code == 404
        assert (await client.get("/teaching/targets/P1/V9")).status_code == 404


async def test_an_import_is_tried_dry_then_done_whole_with_one_audit_row(tmp_path: Path) -> None:
    async with running(tmp_path / "plant.db") as client:
        text = (await client.get("/teaching/dests", params={"format": "csv"})).text
        assert text.splitlines()[1].startswith("P1,1,1,2,3,hoistway,plant file,")
        edited = text.replace("P1,1,1,2,3", "P1,1,1,2,99")
        dry = await client.post("/teaching/dests/import", content=edited, headers=CSV, params={"dry_run": True})
        assert dry.json()["counts"] == {"new": 0, "changed": 1, "same": 1, "error": 0}
        assert dry.json()["items"][0] == {
            "line": 2,
            "name": "P1",
            "fate": "changed",
            "detail": "LIFT 3 -> 99",
            "remedy": "",
            "version": 2,
        }
        assert len((await client.get("/stations/P1/dest")).json()["items"]) == 1
        done = (await client.post("/teaching/dests/import", content=edited, headers=CSV)).json()
        assert (done["dry_run"], done["counts"]["changed"]) == (False, 1)
        newest = (await client.get("/stations/P1/dest")).json()["items"][-1]
        assert (newest["lift"], newest["source"], newest["actor"]) == (99, "import", "kim")
        rows = (await client.get("/audit")).json()["items"]
        assert [row["detail"] for row in rows if row["action"] == "ImportTaught"] == ["2 rows of dest"]
        late = await client.post("/teaching/dests/import", content=edited, headers=CSV)
        assert (late.status_code, late.json()["field"]) == (422, "line 2")
        assert "P1 is at version 2 now, not 1" in late.json()["errors"][0]["message"]


async def test_a_wrong_row_imports_nothing_and_names_every_mistake(tmp_path: Path) -> None:
    async with running(tmp_path / "plant.db") as client:
        text = "station,shft,rota,lift\nP1,7,8,9\nP9,1,2,3\nP2,x,2,3\n"
        dry = (await client.post("/teaching/dests/import", content=text, headers=CSV, params={"dry_run": True})).json()
        assert [(item["line"], item["fate"]) for item in dry["items"]] == [(2, "changed"), (3, "error"), (4, "error")]
        refused = await client.post("/teaching/dests/import", content=text, headers=CSV)
        assert (refused.status_code, len(refused.json()["errors"])) == (422, 2)
        assert (await client.get("/teaching/targets/P1/V001")).json()["dest"]["version"] == 1
        odd = await client.post("/teaching/dests/import", content=text, headers=KIM | {"Content-Type": "text/plain"})
        assert odd.status_code == 415
        broken = await client.post(
            "/teaching/dests/import", content="{", headers=KIM | {"Content-Type": "application/json"}
        )
        assert broken.status_code == 400
        assert (await client.post("/teaching/dests/import", content=text)).status_code == 422


async def test_offsets_go_out_and_in_as_json_with_their_history(tmp_path: Path) -> None:
    async with running(tmp_path / "plant.db") as client:
        rows = {"items": [{"vehicle": "V001", **FIRST}, {"vehicle": "V002", "lift": 5}]}
        done = (await client.post("/teaching/offsets/import", json=rows, headers=KIM)).json()
        assert done["counts"]["new"] == 2
        assert done["items"][1]["detail"] == "SHFT, ROTA stay unknown: jobs stay refused"
        out = (await client.get("/teaching/offsets")).json()["items"]
        assert [(row["vehicle"], row["lift"], row["shft"]) for row in out] == [("V001", 3, 1), ("V002", 5, None)]
        rows["items"][0]["lift"] = 4
        await client.post("/teaching/offsets/import", json=rows, headers=KIM)
        history = (await client.get("/teaching/offsets", params={"history": True})).json()["items"]
        assert [(row["vehicle"], row["version"]) for row in history] == [("V001", 1), ("V001", 2), ("V002", 1)]
        table = (await client.get("/teaching/offsets", params={"history": True, "format": "csv"})).text
        assert len(table.splitlines()) == 4
        assert (await client.get("/teaching/targets/P1/V002")).json()["refusal"] == "V002 has no OFFSET (SHFT, ROTA)"


async def test_versions_and_vehicles_are_compared_with_what_each_would_be_sent(tmp_path: Path) -> None:
    async with running(tmp_path / "plant.db") as client:
        await put(client, "/vehicles/V001/offset", 40, 40, 40)
        await put(client, "/vehicles/V002/offset", -20, -20, -20)
        await put(client, "/stations/P1/dest", 1, 2, 500)
        shown = (await client.get("/teaching/compare/stations/P1/1/2")).json()
        assert shown["differences"] == {"shft": 0, "rota": 0, "lift": 497}
        assert [(c["vehicle"], c["old"]["lift"], c["new"]["lift"]) for c in shown["changes"]] == [
            ("V001", 43, 540),
            ("V002", -17, 480),
        ]
        two = (await client.get("/teaching/compare/offsets/V001/V002", params={"station": "P1"})).json()
        assert two["differences"] == {"shft": -60, "rota": -60, "lift": -60}
        assert [(row["one"]["lift"], row["other"]["lift"]) for row in two["stations"]] == [(540, 480)]
        await put(client, "/vehicles/V001/offset", 41, 40, 40)
        ports = (await client.get("/teaching/compare/vehicles/V001/1/2")).json()["changes"]
        assert [(c["station"], c["new"]["shft"] - c["old"]["shft"]) for c in ports] == [("P1", 1), ("P2", 1)]
        missing = await client.get("/teaching/compare/stations/P1/1/7")
        assert (missing.status_code, missing.json()["remedy"]) == (404, "It has versions 1 to 2.")


async def test_roll_back_shows_before_and_after_and_drift_is_pointed_out(tmp_path: Path) -> None:
    async with running(tmp_path / "plant.db") as client:
        await put(client, "/vehicles/V001/offset", 0, 0, 0)
        await put(client, "/stations/P1/dest", 1, 2, 500)
        drift = (await client.get("/teaching/drift")).json()["items"]
        assert [(row["side"], row["name"], row["drift"]) for row in drift] == [("dest", "P1", "LIFT by +497")]
        assert (await client.get("/teaching/drift", params={"lift": 500})).json()["items"] == []
        body = {"version": 1, "reason": "bent"}
        stale = await client.post("/stations/P1/dest/rollback", json=body, headers=KIM | {"If-Match": '"1"'})
        assert (stale.status_code, stale.json()["code"]) == (412, "stale")
        done = await client.post("/stations/P1/dest/rollback", json=body, headers=KIM | {"If-Match": '"2"'})
        shown = done.json()
        assert (shown["new"]["version"], shown["new"]["restores"], shown["new"]["lift"]) == (3, 1, 3)
        assert [(c["vehicle"], c["old"]["lift"], c["new"]["lift"]) for c in shown["changes"]] == [("V001", 500, 3)]
        await put(client, "/vehicles/V001/offset", 9, 9, 9)
        back = await client.post("/vehicles/V001/offset/rollback", json=body, headers=KIM)
        assert (back.json()["new"]["restores"], back.json()["differences"]["shft"]) == (1, -9)
        assert (await client.post("/vehicles/V001/offset/rollback", json=body)).status_code == 422


async def test_a_session_closes_its_port_shows_itself_live_and_survives_a_restart(tmp_path: Path) -> None:
    database = tmp_path / "plant.db"
    async with running(database) as client:
        opened = await client.post("/teaching/sessions", json={"station": "P1", "vehicle": "V001"}, headers=KIM)
        assert (opened.status_code, opened.json()["id"]) == (201, 1)
        assert (await client.get("/stations/P1")).json()["teaching"] == 1
        start = await client.post("/teaching/sessions/1/start", json={"what": "dest"}, headers=KIM)
        assert (start.status_code, "not connected" in start.json()["detail"]) == (409, True)
        again = await client.post("/teaching/sessions", json={"station": "P1", "vehicle": "V002"}, headers=KIM)
        assert (again.status_code, "session 1" in again.json()["detail"]) == (409, True)
    async with running(database) as client:
        assert (await client.get("/stations/P1")).json()["teaching"] == 1
        closed = await client.post("/teaching/sessions/1/close", json={"reason": "later"}, headers=KIM)
        assert (closed.json()["state"], closed.json()["ended_by"]) == ("closed", "kim")
        listed = (await client.get("/teaching/sessions", params={"station": "P1"})).json()["items"]
        assert [session["id"] for session in listed] == [1]
        assert (await client.get("/stations/P1")).json()["teaching"] is None
