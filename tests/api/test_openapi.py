"""The committed descriptions are up to date, and answers are what they say."""

import asyncio
import json
from pathlib import Path
from typing import Any, get_args

import httpx
import jsonschema
import pytest
import yaml
from fastapi import FastAPI
from referencing import Registry
from referencing.jsonschema import DRAFT202012
from typer import Typer
from typer.testing import CliRunner

from app.api.commands import COMMANDS
from app.cli.openapi import document, openapi, stream_document
from app.domain import requests as r
from app.domain.access import Role
from app.domain.view import SHOWN, LineView, Topic, View
from tests.api.kept_versions import kept_versions
from tests.api.receptions import reception, with_admin
from tests.api.recordings import recorded
from tests.api.scripted import ACTOR, NOW, Scripted
from tests.api.sockets import Socket
from tests.api.test_policy import MAY_SAY
from tests.api.test_problems import EXAMPLES

ROOT = Path(__file__).parents[2]
QUICK = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
"""Reads YAML ten times as quickly, where PyYAML was built with it: each worker reads this file twice."""
DOCUMENT: dict[str, Any] = json.loads((ROOT / "openapi/openapi.json").read_text(encoding="utf-8"))
ASYNC: dict[str, Any] = yaml.load((ROOT / "openapi/asyncapi.yaml").read_text(encoding="utf-8"), QUICK)
REGISTRY: Registry[Any] = Registry().with_resources(
    [
        (name, DRAFT202012.create_resource(contents))
        for name, contents in (("openapi.json", DOCUMENT), ("asyncapi.yaml", ASYNC))
    ]
)
CLOSE = {"place": {"kind": "zone", "zone": "Z1"}, "reason": "a rail is changed"}
BODIES: dict[str, Any] = {
    "vehicle.command": {"command": "move", "barcode": "1001"},
    "drive.write": {"parameter": "1C", "raw": 5},
    "drive.jog.keep": {"jog": 1},
    "drive.jog.release": {"jog": 1},
}
"""Bodies that no route has."""
ORDER = {"job_id": "LOT-1", "source": "P1", "destination": "P2", "carrier": "F1"}


def valid(instance: object, pointer: str) -> None:
    jsonschema.Draft202012Validator({"$ref": pointer}, registry=REGISTRY).validate(instance)


def test_the_committed_openapi_document_is_up_to_date() -> None:
    assert (ROOT / "openapi/openapi.json").read_text(encoding="utf-8") == document(), "run `hoistway openapi`"


def test_the_command_writes_and_checks_the_document(tmp_path: Path) -> None:
    app, runner, file = Typer(), CliRunner(), tmp_path / "api" / "openapi.json"
    app.command()(openapi)
    assert runner.invoke(app, [str(file), "--check"]).exit_code == 1
    assert runner.invoke(app, [str(file)]).exit_code == 0
    assert runner.invoke(app, [str(file), "--check"]).exit_code == 0
    file.with_name("asyncapi.yaml").write_text("asyncapi: 3.0.0\n")
    behind = runner.invoke(app, [str(file), "--check"])
    assert (behind.exit_code, "asyncapi.yaml is out of date" in behind.output) == (1, True)


def test_every_operation_is_named_described_and_declares_its_problems() -> None:
    operations = [op for path in DOCUMENT["paths"].values() for op in path.values()]
    names = [op["operationId"] for op in operations]
    assert len(set(names)) == len(names)
    for operation in operations:
        assert operation["description"]
        assert operation["responses"]["default"] == {"$ref": "#/components/responses/Problem"}
    assert DOCUMENT["openapi"].startswith("3.1")


def test_every_reference_of_the_descriptions_leads_somewhere() -> None:
    resolver = REGISTRY.resolver("openapi.json")
    for name in DOCUMENT["components"]["schemas"]:
        resolver.lookup(f"openapi.json#/components/schemas/{name}")
    for text in (json.dumps(DOCUMENT), json.dumps(ASYNC)):
        base = "openapi.json" if text.startswith('{"openapi') else "asyncapi.yaml"
        for reference in {part.partition('"')[0] for part in text.split('"$ref": "')[1:]}:
            resolver.lookup(base + reference if reference.startswith("#") else reference)


def test_the_committed_asyncapi_document_is_made_from_the_code() -> None:
    committed = (ROOT / "openapi/asyncapi.yaml").read_text(encoding="utf-8")
    assert committed == stream_document(), "run `hoistway openapi`"


def test_the_asyncapi_document_is_one_of_version_3_0_0() -> None:
    schema = json.loads((ROOT / "tests/api/schemas/asyncapi-3.0.0.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft7Validator(schema)
    validator.validate(ASYNC)
    wrong = {**ASYNC, "operations": {"watch": {"action": "shout", "channel": {"$ref": "#/channels/live"}}}}
    assert not validator.is_valid(wrong)


def test_the_live_description_names_every_topic_with_what_its_objects_are() -> None:
    messages = ASYNC["components"]["messages"]
    assert set(messages["words"]["payload"]["properties"]["topics"]["items"]["enum"]) == set(Topic)
    objects = messages["snapshot"]["payload"]["properties"]["objects"]["properties"]
    changes = messages["change"]["payload"]["properties"]["changes"]["items"]["oneOf"]
    changed = [one["properties"]["topic"]["const"] for one in changes]
    assert list(objects) == changed == [topic for topic in Topic if topic is not Topic.EVENTS]
    shown = {kind for kinds in SHOWN.values() for kind in kinds}
    assert shown == set(get_args(View)) - {LineView}, "a view belongs to a topic; a line is asked for over REST alone"


def test_the_live_description_names_every_command_and_every_frame() -> None:
    one_of = ASYNC["components"]["messages"]["command"]["payload"]["properties"]["command"]["oneOf"]
    schemas = [ASYNC["components"]["schemas"][ref["$ref"].rpartition("/")[2]] for ref in one_of]
    assert [schema["properties"]["name"]["const"] for schema in schemas] == list(COMMANDS)
    for name, schema in zip(COMMANDS, schemas, strict=True):
        assert set(schema["x-roles"]) == set(MAY_SAY[name].split())
    told = {name for channel in ASYNC["channels"].values() for name in channel["messages"]}
    assert told == set(ASYNC["components"]["messages"])
    operations = [ref["$ref"] for one in ASYNC["operations"].values() for ref in one["messages"]]
    assert {ref.rpartition("/")[2] for ref in operations} == told


@pytest.mark.parametrize("name", COMMANDS)
def test_a_command_is_described_as_the_server_takes_it(name: str) -> None:
    command, where = COMMANDS[name], "asyncapi.yaml#/components/messages/command/payload"
    said: dict[str, Any] = {"name": name, "target": "V001" if command.aimed else ""}
    if command.body is not None:
        said["body"] = body = BODIES.get(name) or EXAMPLES[command.body.__name__]
        command.adapter.validate_json(json.dumps(body))
        with pytest.raises(jsonschema.ValidationError):
            valid({"id": 1, "command": {**said, "body": {**body, "surprise": 1}}}, where)
    valid({"id": 1, "actor": "kim", "command": said}, where)
    with pytest.raises(jsonschema.ValidationError):
        valid({"id": 1, "command": {**said, "name": f"{name}.no"}}, where)


@pytest.mark.anyio
async def test_every_answer_is_what_the_description_says(
    client: httpx.AsyncClient, controller: Scripted, tmp_path: Path
) -> None:
    controller.playback = recorded(tmp_path)
    with kept_versions(tmp_path) as kept:
        controller.versions, controller.version = kept.versions, 1
        await _whole(client, controller, tmp_path)


async def _whole(client: httpx.AsyncClient, controller: Scripted, tmp_path: Path) -> None:
    async with reception(tmp_path) as controller.reception:
        await with_admin(controller.reception)
        await controller.reception.add_key("mes-1", frozenset({Role.MES}), None, ACTOR)
        await _every_answer_is_described(client, controller)


async def _every_answer_is_described(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.traffic = [(NOW, "in", b"\x06")]
    pulses = {"shft": 1, "rota": 2, "lift": 3}
    await client.post("/jobs", json=ORDER)
    command = (await client.post("/vehicles/V001/commands", json={"command": "status"})).json()["cmd_id"]
    opened = (await client.post("/devices/DOOR1/commands", json={"command": "open"})).json()["cmd_id"]
    await client.put("/carriers/F1", json={"place": "P1"})
    await client.put("/stations/P1/dest", json=pulses, headers={"X-Actor": "kim"})
    await client.put("/vehicles/V001/offset", json=pulses, headers={"X-Actor": "kim"})
    await client.post("/drives/D1/jog", json={"direction": "cw"})
    controller.drives.keep_backup()
    controller.drives.traffic = [(NOW, "out", b"\x02M1SSQ@#8\x03"), (NOW, "in", b"\x06")]
    known = {"job": "LOT-1", "vehicle": "V001", "station": "P1", "carrier": "F1", "command": command, "code": "invalid"}
    known |= {
        "drive": "D1",
        "operation": "1",
        "backup": "1",
        "jog": "1",
        "number": "1C",
        "link": "AXES",
    }
    await client.put("/stations/P1/dest", json=pulses, headers={"X-Actor": "kim"})
    await client.put("/vehicles/V001/offset", json=pulses, headers={"X-Actor": "kim"})
    controller.teach()
    await client.post("/zones/Z1/pause", json={"reason": "look"})
    await client.post("/closures", json=CLOSE, headers={"X-Actor": "kim"})
    known |= {"closure": "1", "zone": "Z1", "alarm": "1", "walk": "1", "user": "kim", "key": "mes-1"}
    controller.alarm()
    await client.post("/walks", json={"reason": "after the outage"}, headers={"X-Actor": "kim"})
    known |= {"session": "1", "proposal": "1", "other": "V002", "old": "1", "new": "2"}
    await client.post("/webhooks", json={"url": "https://mes.fab/hooks"})
    known |= {"webhook": "1", "version": "1"}
    seen = 0
    for path, operations in DOCUMENT["paths"].items():
        if "get" not in operations or path.endswith(
            ("/stream", "/report", "{kind}", "/export", "/pieces", "/file", "{model}")
        ):
            continue
        named = known | ({"device": "DOOR1", "command": opened} if "{device}" in path else {})
        asked = {"from": "P1", "to": "P2"} if path.endswith("/routes") else {}
        asked |= {"at": "2026-01-01T00:00:00Z"} if path == "/api/v1/history" else {}
        answer = await client.get("http://localhost" + path.format(**named), params=asked)
        assert answer.status_code == 200, path
        pointer = path.replace("~", "~0").replace("/", "~1").replace("{", "%7B").replace("}", "%7D")
        where = f"openapi.json#/paths/{pointer}/get/responses/200/content/application~1json/schema"
        valid(answer.json(), where)
        seen += 1
    assert seen > 20
    valid((await client.get("/jobs/nope")).json(), "openapi.json#/components/schemas/Problem")


@pytest.mark.anyio
async def test_every_live_frame_is_what_the_description_says(served: FastAPI, controller: Scripted) -> None:
    async with Socket(served, query="topics=" + ",".join(Topic)) as socket:
        await socket.accepted()
        frames = [await socket.frame()]
        await controller.ask(r.PauseController(ACTOR, "x"))
        controller.happen("ControllerPausing")
        controller.hub.flush()
        await asyncio.sleep(0)
        frames += [await socket.frame(), await socket.frame()]
        socket.say("?")
        socket.say('{"resync": true}')
        frames += [await socket.frame() for _ in range(3)]
        socket.say('{"id": 7, "command": {"name": "vehicle.hold", "target": "V001", "body": {"reason": "look"}}}')
        socket.say('{"id": "x", "command": {"name": "vehicle.hold", "target": "V009", "body": {"reason": "look"}}}')
        frames += [await socket.frame() for _ in range(2)]
    assert {frame["type"] for frame in frames} == {"snapshot", "change", "event", "error", "resync", "reply"}
    assert [(frame["type"], frame["id"]) for frame in frames[-2:]] == [("reply", 7), ("error", "x")]
    for frame in frames:
        valid(frame, f"asyncapi.yaml#/components/messages/{frame['type']}/payload")


@pytest.mark.anyio
async def test_the_docs_need_nothing_from_elsewhere(client: httpx.AsyncClient) -> None:
    shorter = await client.get("http://localhost/docs")
    assert (shorter.status_code, shorter.headers["location"]) == (307, "/api/docs")
    page = await client.get("http://localhost/api/docs")
    assert page.status_code == 200
    sources = [part.partition('"')[0] for marker in ('src="', 'href="') for part in page.text.split(marker)[1:]]
    assert len(sources) == 3
    for source in sources:
        assert source.startswith("/api/docs/files/")
        assert (await client.get(f"http://localhost{source}")).status_code == 200
