"""Every route answers bad input with a problem, never with a defect."""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest
from fastapi import FastAPI

from tests.api.scripted import Scripted
from tests.api.sockets import Socket

pytestmark = pytest.mark.anyio

DOCUMENT = json.loads((Path(__file__).parents[2] / "openapi/openapi.json").read_text(encoding="utf-8"))
SCHEMAS: dict[str, Any] = DOCUMENT["components"]["schemas"]
OPERATIONS = [
    (method.upper(), path, operation) for path, ops in DOCUMENT["paths"].items() for method, operation in ops.items()
]
WITH_BODY = [
    (method, path, op["requestBody"])
    for method, path, op in OPERATIONS
    if "requestBody" in op and not {"text/csv", "application/yaml"} & set(op["requestBody"]["content"])
]
KNOWN = {
    "job": "LOT-1",
    "vehicle": "V001",
    "station": "P1",
    "carrier": "F1",
    "command": "0000000000000001",
    "code": "invalid",
    "drive": "D1",
    "number": "1C",
    "watch": "mine",
    "backup": "1",
    "jog": "1",
    "operation": "1",
    "link": "AXES",
    "model": "demo",
    "session": "1",
    "proposal": "1",
    "other": "V002",
    "old": "1",
    "new": "2",
    "device": "DOOR1",
    "user": "kim",
    "key": "mes-1",
    "alarm": "1",
    "closure": "1",
    "walk": "1",
    "webhook": "1",
    "zone": "Z1",
    "table": "transfers",
    "kind": "csv",
    "version": "1",
}
EXAMPLES: dict[str, Any] = {
    "JobIn": {"source": "P1", "destination": "P2"},
    "JobChange": {"priority": 5},
    "JobEndIn": {"reason": "wrong lot"},
    "PlainCommand": {"command": "status"},
    "DisplayCommand": {"command": "display", "text": "A"},
    "MoveCommand": {"command": "move", "barcode": "1001"},
    "TransferCommand": {"command": "pickup", "station": "P1"},
    "AgvMoveManualCommand": {"command": "agv_move_manual", "direction": "forward"},
    "AgvMoveAutoCommand": {"command": "agv_move_auto"},
    "AgvMarkStopCommand": {"command": "agv_mark_stop"},
    "AgvSetCurrentCommand": {"command": "agv_set_current", "tag": "0042"},
    "AgvLiftCommand": {"command": "agv_lift", "action": "up"},
    "AgvChargeCommand": {"command": "agv_charge", "on": True},
    "AgvMoveAliasCommand": {"command": "agv_move_alias", "alias": "B1"},
    "RecoverIn": {},
    "ReasonIn": {"reason": "x"},
    "ReleaseIn": {"verdict": "go_on", "reason": "x"},
    "ServiceIn": {"in_service": True},
    "Target": {"shft": 1, "rota": 2, "lift": 3},
    "StationPut": {"present": True, "carrier": "", "reserved": "", "out_of_service": ""},
    "StationPatch": {"present": True},
    "CarrierPut": {"place": "P1"},
    "KeyIn": {"key": "run"},
    "InputsIn": {"step": 3},
    "ReadIn": {},
    "WriteIn": {"raw": 5},
    "BackupIn": {},
    "CompareIn": {"backup": 1},
    "RestoreIn": {"backup": 1},
    "JogIn": {"direction": "cw"},
    "WatchIn": {"parameters": ["1C"]},
    "SessionIn": {"station": "P1", "vehicle": "V001"},
    "StartIn": {"what": "dest"},
    "EndIn": {},
    "ApproveIn": {},
    "RejectIn": {"reason": "x"},
    "AssignIn": {"station": "P1"},
    "RollBackIn": {"version": 1, "reason": "x"},
    "DeviceCommandIn": {"command": "open"},
    "PinIn": {"position": "open", "reason": "x"},
    "EmergencyIn": {"kind": "fire", "reason": "x"},
    "LogInIn": {"name": "kim", "password": "correct horse 1"},
    "NewPasswordIn": {"old": "correct horse 1", "new": "another horse 3"},
    "UserIn": {"name": "lee", "roles": ["admin"], "password": "correct horse 1"},
    "UserChange": {"roles": ["admin"]},
    "ClosureIn": {"place": {"kind": "barcode", "barcodes": ["1001"]}, "reason": "x"},
    "PreviewIn": {"place": {"kind": "barcode", "barcodes": ["1001"]}},
    "OpenIn": {},
    "StageIn": {},
    "WalkIn": {"reason": "x"},
    "SightIn": {"present": True},
    "SightsIn": {"sights": [{"station": "P1", "present": True}]},
    "AcceptIn": {},
    "AbandonIn": {"reason": "x"},
    "NoteIn": {},
    "NotedAlarmsIn": {"alarms": [1]},
    "WebhookIn": {"url": "https://mes.example/events"},
    "WebhookChange": {"active": False},
    "SecretIn": {},
    "ReplayIn": {"after": 0},
    "ActivateIn": {"reason": "x"},
    "RejectVersionIn": {"reason": "x"},
    "MachineKeyIn": {"name": "mes-1", "roles": ["admin"]},
}
WRONG: list[Any] = [False, 0, -1, 1.5, "5", "", "a\x00b", "a\nb", "\ud800", "x" * 5000, None, [], {}, [None], 1 << 70]
RAW = [
    b"",
    b"{",
    b"null",
    b"[]",
    b'"a"',
    b"NaN",
    b'{"priority": NaN}',
    b"\xff\xfe",
    b"[" * 20000,
    b'{"priority": ' + b"9" * 5000 + b"}",
]


def filled(path: str, **others: str) -> str:
    return "http://localhost" + path.format(**(KNOWN | others))


def bodies(request_body: dict[str, Any]) -> Iterator[str]:
    schema = request_body["content"]["application/json"]["schema"]
    for part in schema.get("oneOf", [schema]):
        yield part["$ref"].rpartition("/")[2]


def check(answer: httpx.Response) -> None:
    """A problem, or what was asked for; never a defect."""
    assert answer.status_code < 500, answer.text
    if answer.status_code >= 400:
        assert answer.headers["content-type"] == "application/problem+json"
        problem = answer.json()
        assert problem["status"] == answer.status_code
        assert problem["detail"]
        assert problem["title"]
        assert problem["remedy"]


@pytest.mark.parametrize(("method", "path", "body"), WITH_BODY, ids=[f"{m} {p}" for m, p, _ in WITH_BODY])
async def test_each_field_of_each_body_refuses_what_it_cannot_be(
    client: httpx.AsyncClient, controller: Scripted, method: str, path: str, body: dict[str, Any]
) -> None:
    for name in bodies(body):
        for field in SCHEMAS[name]["properties"]:
            for wrong in WRONG:
                sent = json.dumps(EXAMPLES[name] | {field: wrong}).encode()
                headers = {"Content-Type": "application/json", "X-Actor": "kim"}
                answer = await client.request(method, filled(path), content=sent, headers=headers)
                check(answer)
                if isinstance(wrong, str) and wrong[:1] in {"a", "x", "\ud800"}:
                    assert answer.status_code == (400 if wrong == "\ud800" and name == "JobIn" else 422), (field, wrong)
                    assert not controller.seen
                controller.seen.clear()


@pytest.mark.parametrize(("method", "path", "body"), WITH_BODY, ids=[f"{m} {p}" for m, p, _ in WITH_BODY])
async def test_a_body_with_a_field_too_many_or_too_few_is_refused(
    client: httpx.AsyncClient, controller: Scripted, method: str, path: str, body: dict[str, Any]
) -> None:
    for name in bodies(body):
        more = await client.request(
            method, filled(path), json=EXAMPLES[name] | {"surprise": 1}, headers={"X-Actor": "k"}
        )
        assert (more.status_code, more.json()["detail"]) == (422, more.json()["field"] + ": there is no such field")
        for field in SCHEMAS[name].get("required", []):
            less = {key: value for key, value in EXAMPLES[name].items() if key != field}
            answer = await client.request(method, filled(path), json=less, headers={"X-Actor": "k"})
            assert answer.status_code == 422
    assert not controller.seen


async def test_a_request_without_its_body_or_command_says_what_is_missing(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    pause = await client.post(filled("/api/v1/controller/pause"))
    assert (pause.status_code, pause.json()["detail"]) == (422, "a body in JSON is required")
    bodies: tuple[object, ...] = (None, [], "tea")
    for body in bodies:
        other = await client.post(filled("/api/v1/controller/pause"), json=body)
        assert other.json()["detail"] in {"a body in JSON is required", "the body has to be a JSON object"}
    commands = filled("/api/v1/vehicles/{vehicle}/commands")
    nothing = await client.post(commands, json={})
    assert (nothing.json()["detail"], nothing.json()["field"]) == ("command: is required", "command")
    fly = await client.post(commands, json={"command": "fly"})
    assert fly.json()["field"] == "command"
    assert fly.json()["detail"].startswith("command: is none of 'status', 'stop', ")
    assert not controller.seen


@pytest.mark.parametrize(("method", "path", "body"), WITH_BODY, ids=[f"{m} {p}" for m, p, _ in WITH_BODY])
async def test_what_is_not_json_is_refused(
    client: httpx.AsyncClient, method: str, path: str, body: dict[str, Any]
) -> None:
    for raw in RAW if body.get("required") else RAW[1:]:
        headers = {"Content-Type": "application/json", "X-Actor": "kim"}
        answer = await client.request(method, filled(path), content=raw, headers=headers)
        check(answer)
        assert answer.status_code in {400, 422}, raw
    form = {"Content-Type": "application/x-www-form-urlencoded", "X-Actor": "kim"}
    answer = await client.request(method, filled(path), content=b"{}", headers=form)
    assert (answer.status_code, answer.json()["code"]) == (415, "media-type")


@pytest.mark.parametrize(("method", "path", "_op"), OPERATIONS, ids=[f"{m} {p}" for m, p, _ in OPERATIONS])
async def test_odd_names_in_paths_and_questions_are_refused(
    client: httpx.AsyncClient, method: str, path: str, _op: object
) -> None:
    if path.endswith("/stream"):
        return
    for odd in ("%00", "%0a", "x" * 65, "%ff", "a%2Fb", "..", "%E2%80%AE", "%20"):
        if "{" in path:
            url = path.format(**dict.fromkeys(KNOWN, odd))
            check(await client.request(method, f"http://localhost{url}", json={}, headers={"X-Actor": "kim"}))
    for query in ("limit=0", "limit=x", "after=-1", f"after={1 << 70}", "state=nope", "job=%00", "lang=xx", "vehicle="):
        check(await client.request(method, f"{filled(path)}?{query}", headers={"X-Actor": "kim"}))


def methods_at(url: str) -> set[str]:
    """Return the methods of every path that the URL fits: one name may also stand where another path has a parameter."""
    place = httpx.URL(url).path
    fits = (path for path in DOCUMENT["paths"] if re.fullmatch(re.sub(r"\{[^}]+\}", "[^/]+", path), place))
    return {method.upper() for path in fits for method in DOCUMENT["paths"][path]}


@pytest.mark.parametrize("path", sorted(DOCUMENT["paths"]))
async def test_a_method_that_a_path_does_not_have_is_405(client: httpx.AsyncClient, path: str) -> None:
    answer = await client.request("TRACE", filled(path))
    check(answer)
    assert answer.status_code == 405
    has = ", ".join(sorted(methods_at(filled(path))))
    assert (answer.headers["allow"], answer.json()["remedy"]) == (has, f"It has {has}.")


@pytest.mark.parametrize(
    "path", ["/api/v1/nope", "/nope", "/api/v1/jobs/", "/api/v1/vehicles/V001/nope", "//", "/api/v2"]
)
async def test_a_path_that_is_not_there_is_a_404_problem(client: httpx.AsyncClient, path: str) -> None:
    answer = await client.get(f"http://localhost{path}")
    check(answer)
    assert answer.status_code == 404


async def test_every_code_of_a_refusal_has_a_status(client: httpx.AsyncClient) -> None:
    codes = {item["code"] for item in (await client.get("/problems")).json()["items"]}
    assert {"not-found", "conflict", "not-now", "invalid", "no-route"} <= codes


async def test_a_file_is_only_read(client: httpx.AsyncClient) -> None:
    answer = await client.post("http://localhost/assets/index.js")
    check(answer)
    assert (answer.status_code, answer.headers["allow"]) == (405, "GET, HEAD")
    assert (await client.post("http://localhost/")).headers["allow"] == "GET, HEAD"


async def test_a_websocket_where_there_is_none_is_a_404_problem(served: FastAPI) -> None:
    async with Socket(served, "/api/v1/nope") as socket:
        refusal = await socket.message()
    assert refusal["type"] == "websocket.close"
    async with Socket(served, "/api/v1/nope", answers=True) as socket:
        start, body = await socket.message(), await socket.message()
    assert (start["type"], start["status"]) == ("websocket.http.response.start", 404)
    problem = json.loads(body["body"])
    assert problem["detail"] == "There is no stream at /api/v1/nope."
    assert problem["remedy"] == "The live stream is at /api/v1/live."


async def test_a_problem_is_told_in_the_callers_language_and_its_code_stays(client: httpx.AsyncClient) -> None:
    asked = {"source": "P1", "destination": "P1", "job_id": "L/1"}
    for path, body, title in (
        ("/jobs/none/why", None, "대상을 찾을 수 없습니다"),
        ("/jobs", asked, "요청 값이 올바르지 않습니다"),
    ):
        method = "POST" if body else "GET"
        korean = await client.request(method, path, json=body, headers={"Accept-Language": "ko-KR,ko;q=0.9,en;q=0.8"})
        english = await client.request(method, path, json=body)
        assert korean.json()["title"] == title
        assert (korean.headers["content-language"], english.headers["content-language"]) == ("ko", "en")
        assert korean.json()["code"] == english.json()["code"]
        assert english.json()["title"].isascii()


async def test_each_of_several_errors_is_told_in_the_callers_language(client: httpx.AsyncClient) -> None:
    body = {"place": 7, "purpose": "fun", "more": 1}
    answer = (await client.post("/closures", json=body, headers={"Accept-Language": "ko", "X-Actor": "kim"})).json()
    assert len(answer["errors"]) > 2
    assert not [error for error in answer["errors"] if error["message"].isascii()]
