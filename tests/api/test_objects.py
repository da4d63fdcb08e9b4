"""Vehicles, stations, carriers, the controller, the layout and the audit over REST."""

import httpx
import pytest

from app.domain import requests as r
from app.domain.commands import Plain
from app.domain.errors import Refusal
from app.domain.ids import StationId
from app.domain.layout import StopAction
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Toward
from tests.api.scripted import NOW, PULSES, Scripted

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}


@pytest.mark.parametrize(("path", "count"), [("/vehicles", 2), ("/stations", 3), ("/carriers", 0)])
async def test_live_lists_have_an_etag(client: httpx.AsyncClient, path: str, count: int) -> None:
    answer = await client.get(path)
    assert len(answer.json()["items"]) == count
    again = await client.get(path, headers={"If-None-Match": answer.headers["etag"]})
    assert (again.status_code, again.content) == (304, b"")
    assert (await client.get(path, headers={"If-None-Match": '"other"'})).status_code == 200


async def test_one_vehicle_is_shown_with_its_bits(client: httpx.AsyncClient) -> None:
    answer = await client.get("/vehicles/V001")
    assert answer.json()["bits"][1] == {"name": "F", "value": 0, "meaning": "no FOUP"}
    assert answer.json()["link"]["since"] == "2026-01-01T00:00:00.000Z"
    again = await client.get("/vehicles/V001", headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304
    for path in ("/vehicles/V9", "/vehicles/V9/commands", "/vehicles/V9/frames", "/vehicles/V9/offset"):
        missing = await client.get(path)
        assert (missing.status_code, missing.json()["code"]) == (404, "not-found")


@pytest.mark.parametrize(
    ("body", "request_made"),
    [
        ({"command": "servo_on"}, r.CommandVehicle),
        ({"command": "display", "text": "HELLO", "alarm": 0x8001}, r.DisplayOnVehicle),
        ({"command": "pickup", "station": "P1"}, r.HandleOnce),
        ({"command": "place", "station": "P1", "target": {"shft": 1, "rota": 2, "lift": 3}}, r.HandleOnce),
    ],
)
async def test_a_command_is_taken_and_can_be_looked_up(
    client: httpx.AsyncClient, controller: Scripted, body: dict[str, object], request_made: type
) -> None:
    answer = await client.post("/vehicles/V001/commands", json=body, headers=KIM)
    assert answer.status_code == 202
    assert isinstance(controller.seen[0], request_made)
    where = answer.headers["location"].removeprefix("/api/v1")
    live = (await client.get(where)).json()
    assert (live["cmd_id"], live["state"], live["actor"]) == (answer.json()["cmd_id"], "open", "kim")
    controller.forget_commands()
    assert (await client.get(where)).json() == live
    assert (await client.get("/vehicles/V001/commands")).json()["items"] == [live]


async def test_words_of_a_command_reach_the_controller(client: httpx.AsyncClient, controller: Scripted) -> None:
    await client.post("/vehicles/V001/commands", json={"command": "stop_by_host"})
    moved = await client.post("/vehicles/V001/commands", json={"command": "move", "barcode": "1003", "action": "sbfl"})
    await client.post(
        "/vehicles/V001/commands",
        json={"command": "place", "station": "P1", "target": {"shft": 1, "rota": 2, "lift": 3}},
    )
    plain, move, place = controller.seen
    assert isinstance(plain, r.CommandVehicle)
    assert plain.what is Plain.STOP_BY_HOST
    assert isinstance(move, r.MoveVehicle)
    assert move.action is StopAction.SBFL
    assert moved.json() == {"vehicle": "V001", "cmd_id": None}
    assert moved.headers["location"] == "/api/v1/vehicles/V001/commands"
    assert isinstance(place, r.HandleOnce)
    assert (place.pickup, place.target) == (False, PULSES)


@pytest.mark.parametrize("command", ["0", "zz", "ffffffffffffffff", "0000000000000000", "V001"])
async def test_an_unknown_command_is_not_found(client: httpx.AsyncClient, command: str) -> None:
    answer = await client.get(f"/vehicles/V001/commands/{command}")
    assert (answer.status_code, answer.json()["code"]) == (404, "not-found")


async def test_a_command_is_not_shown_under_another_vehicle(client: httpx.AsyncClient, controller: Scripted) -> None:
    taken = (await client.post("/vehicles/V001/commands", json={"command": "status"})).json()
    other = f"/vehicles/V002/commands/{taken['cmd_id']}"
    assert (await client.get(other)).status_code == 404
    controller.forget_commands()
    assert (await client.get(other)).status_code == 404


@pytest.mark.parametrize(
    ("method", "path", "body", "request_made"),
    [
        ("POST", "hold", {"reason": "look"}, r.HoldVehicle),
        ("POST", "release", {"verdict": "go_on", "reason": "seen"}, r.ReleaseVehicle),
        ("POST", "release", {"verdict": "stands_at", "reason": "seen", "barcode": "1002"}, r.ReleaseVehicle),
        ("POST", "lockout", {"reason": "belt"}, r.LockVehicle),
        ("DELETE", "lockout", None, r.UnlockVehicle),
        ("PUT", "service", {"in_service": False, "reason": "wash"}, r.SetService),
        ("PUT", "service", {"in_service": True}, r.SetService),
        ("PUT", "offset", {"shft": 1, "rota": 2, "lift": 3}, r.WriteOffset),
    ],
)
async def test_people_decide_about_a_vehicle(
    client: httpx.AsyncClient, controller: Scripted, method: str, path: str, body: object, request_made: type
) -> None:
    answer = await client.request(method, f"/vehicles/V001/{path}", json=body, headers=KIM)
    assert answer.status_code == 200
    assert answer.json()["id"] == "V001"
    assert isinstance(controller.seen[0], request_made)
    assert controller.seen[0].actor == "kim"


@pytest.mark.parametrize(
    ("method", "path", "body"),
    [
        ("POST", "release", {"verdict": "off_rail", "reason": "seen"}),
        ("POST", "lockout", {"reason": "belt"}),
        ("DELETE", "lockout", None),
    ],
)
@pytest.mark.parametrize("name", [None, " ", "a" * 65, "a\u202eb".encode()])
async def test_some_decisions_need_a_named_person(
    client: httpx.AsyncClient, controller: Scripted, method: str, path: str, body: object, name: str | bytes | None
) -> None:
    raw = name.encode() if isinstance(name, str) else name
    headers = [(b"X-Actor", raw)] if raw is not None else []
    answer = await client.request(method, f"/vehicles/V001/{path}", json=body, headers=headers)
    assert answer.status_code == 422
    assert answer.json()["field"] == "X-Actor"
    assert not controller.seen


@pytest.mark.parametrize(
    ("path", "body", "field"),
    [
        ("release", {"verdict": "stands_at", "reason": "x"}, "barcode"),
        ("release", {"verdict": "go_on", "reason": "x", "barcode": "1001"}, "barcode"),
        ("service", {"in_service": False}, "reason"),
        ("service", {"in_service": True, "reason": "x"}, "reason"),
    ],
)
async def test_parts_that_contradict_each_other_are_refused(
    client: httpx.AsyncClient, path: str, body: object, field: str
) -> None:
    method = "PUT" if path == "service" else "POST"
    answer = await client.request(method, f"/vehicles/V001/{path}", json=body, headers=KIM)
    assert (answer.status_code, answer.json()["field"]) == (422, field)


async def test_an_alarm_is_recovered_by_one_call(client: httpx.AsyncClient, controller: Scripted) -> None:
    answer = await client.post("/vehicles/V001/recover", json={"confirmed": True})
    assert answer.status_code == 202
    request = controller.seen[0]
    assert isinstance(request, r.RecoverAlarm)
    assert request.confirmed


async def test_the_last_frames_are_explained(client: httpx.AsyncClient, controller: Scripted) -> None:
    data = bytes.fromhex("06000000010000000100000001")
    assert not Decoder(Codec(), Toward.CONTROLLER).feed(b"")
    controller.traffic = [(NOW, "out", data), (NOW, "in", b"\x99")]
    first, second = (await client.get("/vehicles/V001/frames", params={"lang": "ko"})).json()["items"]
    assert (first["at"], first["direction"], first["hex"]) == ("2026-01-01T00:00:00.000Z", "out", data.hex())
    assert first["frames"][0]["fields"]
    assert second["frames"][0]["kind"] == "garbled"


async def test_a_host_writes_the_state_of_a_station(client: httpx.AsyncClient, controller: Scripted) -> None:
    whole = {"present": True, "carrier": "F1", "reserved": "", "out_of_service": ""}
    answer = await client.put("/stations/P1", json=whole)
    assert (answer.status_code, answer.json()["carrier"], answer.json()["verified"]) == (200, "F1", True)
    await client.patch("/stations/P1", json={"carrier": "", "by_person": True})
    assert controller.seen[1] == r.WriteStation(
        controller.seen[1].actor, controller.plant.stations[0].id, carrier="", by_person=True
    )
    assert (await client.patch("/stations/P1", json={"present": None})).json()["present"] is None
    assert controller.seen[2] == r.WriteStation(controller.seen[1].actor, StationId("P1"), forgotten=True)
    nowhere = await client.patch("/stations/P1", json={"present": None, "carrier": "F1"})
    assert (nowhere.status_code, nowhere.json()["field"]) == (422, "carrier")
    assert (await client.patch("/stations/P1", json={"by_person": True})).status_code == 422
    assert (await client.patch("/stations/P9", json={"present": False})).status_code == 404
    assert (await client.get("/stations/P1")).json()["id"] == "P1"
    assert (await client.get("/stations/P9")).status_code == 404


async def test_two_people_do_not_overwrite_each_others_pulses(client: httpx.AsyncClient, controller: Scripted) -> None:
    pulses = {"shft": 1, "rota": 2, "lift": 3}
    for place in ("/stations/P1/dest", "/vehicles/V001/offset"):
        nobody = await client.put(place, json=pulses)
        assert (nobody.status_code, nobody.json()["field"]) == (422, "X-Actor"), "pulses are a named person's"
    none = await client.get("/stations/P1/dest")
    assert (none.headers["etag"], none.json()["items"]) == ('"0"', [])
    first = await client.put("/stations/P1/dest", json=pulses, headers={"X-Actor": "kim", "If-Match": '"0"'})
    assert first.status_code == 200
    late = await client.put("/stations/P1/dest", json=pulses, headers={"X-Actor": "kim", "If-Match": '"0"'})
    assert (late.status_code, late.json()["code"]) == (412, "stale")
    assert (await client.put("/stations/P1/dest", json=pulses, headers={"X-Actor": "kim"})).status_code == 200
    assert (
        await client.put("/stations/P1/dest", json=pulses, headers={"X-Actor": "kim", "If-Match": "*"})
    ).status_code == 200
    wrong = await client.put("/stations/P1/dest", json=pulses, headers={"X-Actor": "kim", "If-Match": '"x"'})
    assert (wrong.status_code, wrong.json()["field"]) == (422, "If-Match")
    history = await client.get("/stations/P1/dest")
    assert [row["version"] for row in history.json()["items"]] == [1, 2, 3]
    assert history.headers["etag"] == '"3"'
    assert (await client.get("/stations/P9/dest")).status_code == 404
    await client.put("/vehicles/V001/offset", json=pulses, headers={"X-Actor": "kim"})
    assert (await client.get("/vehicles/V001/offset")).json()["items"][0]["lift"] == 3


async def test_a_carrier_is_installed_located_and_removed(client: httpx.AsyncClient) -> None:
    assert (await client.put("/carriers/F1", json={"place": "P1"})).status_code == 201
    assert (await client.put("/carriers/F1", json={"place": "P2"})).status_code == 200
    assert (await client.get("/carriers/F1")).json()["place"] == "P2"
    assert (await client.delete("/carriers/F1")).status_code == 204
    assert (await client.delete("/carriers/F1")).status_code == 404
    assert (await client.get("/carriers/F1")).status_code == 404


async def test_the_controller_is_paused_and_resumed(client: httpx.AsyncClient) -> None:
    assert (await client.get("/controller")).json()["state"] == "auto"
    assert (await client.post("/controller/pause", json={"reason": "quake"})).json()["reason"] == "quake"
    assert (await client.post("/controller/resume")).json()["state"] == "auto"


async def test_the_layout_is_given_for_drawing(client: httpx.AsyncClient) -> None:
    answer = await client.get("/layout")
    layout = answer.json()
    assert layout["points"][0] == {"barcode": "1001", "x": 10010, "y": 0, "park": False}
    assert layout["edges"][2]["curve"] is True
    assert layout["zones"][0]["barcodes"] == ["1002", "1003"]
    assert layout["zones"][0]["soft"] is None
    assert [s["kind"] for s in layout["stations"]] == ["port", "port", "sbfl"]
    again = await client.get("/layout", headers={"If-None-Match": answer.headers["etag"]})
    assert again.status_code == 304


async def test_the_audit_is_asked_about_a_period_and_about_what_was_refused(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    controller.refusal = Refusal("not-now", "The plant is stopped.", "Resume it.")
    await client.post("/jobs", json={"source": "P1", "destination": "P2"})
    await client.post("/jobs", json={"source": "P1", "destination": "P2"})

    async def found(**query: str) -> list[int]:
        answer = await client.get("/audit", params=query)
        assert answer.status_code == 200, answer.text
        return [row["seq"] for row in answer.json()["items"]]

    assert await found(accepted="false") == [1]
    assert await found(accepted="true") == [2]
    assert await found(**{"from": "2026-01-01T00:00:00Z", "to": "2026-01-01T00:00:01Z"}) == [2, 1]
    assert await found(**{"from": "2026-01-01T00:00:01Z"}) == []
    assert await found(to="2026-01-01T00:00:00Z") == []


async def test_the_audit_tells_who_asked_for_what(client: httpx.AsyncClient) -> None:
    await client.post("/controller/resume", headers=KIM)
    await client.delete("/carriers/F7", headers=KIM)
    rows = (await client.get("/audit", params={"limit": 2})).json()
    assert [(row["seq"], row["actor"], row["accepted"]) for row in rows["items"]] == [
        (1, "kim", True),
        (2, "kim", False),
    ]
    assert rows["next"] == 2
    assert (await client.get("/audit", params={"after": 2})).json() == {"items": [], "next": None}


async def test_a_problems_type_leads_to_its_kind(client: httpx.AsyncClient) -> None:
    kinds = (await client.get("/problems")).json()["items"]
    assert {"code": "not-now", "status": 409, "title": "Not possible in the present state"} in kinds
    problem = (await client.get("/jobs/nope")).json()
    assert (await client.get(problem["type"].removeprefix("/api/v1"))).json()["code"] == "not-found"
    assert (await client.get("/problems/nope")).status_code == 404


async def test_readiness_says_why_not(client: httpx.AsyncClient, controller: Scripted) -> None:
    url = "http://localhost/readyz"
    assert (await client.get(url)).json() == {"ready": True, "reasons": []}
    controller.trouble = "The disk is full."
    answer = await client.get(url)
    assert (answer.status_code, answer.json()["reasons"]) == (503, ["The disk is full."])
    assert (await client.get("http://localhost/healthz")).json() == {"status": "ok"}
