"""Doors, buffers and chargers over REST, on the running controller, its database, and simulated devices on a socket."""

import asyncio
import time
from collections.abc import AsyncIterator, Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import httpx
import pytest

from app.api import application
from app.domain.layout import OnEmergency, Plant
from app.runtime.clock import Clock
from app.runtime.controller import Controller
from app.runtime.lines import Line
from app.runtime.transports import DeviceServer
from app.settings import Settings
from app.sim.halls import SimulatedHalls
from tests.e2e.processes import free_ports
from tests.fleet.hall_plants import HALL, ring

pytestmark = pytest.mark.anyio
KIM, LEE = {"X-Actor": "kim"}, {"X-Actor": "lee"}
GENEROUS = 60.0


def served(port: int, **more: Any) -> Plant:
    """Return the ring without hoists, its link at this port."""
    plant = ring(**more)
    return replace(plant, vehicles=(), carriers=(), links=(replace(plant.links[0], port=port),))


class Hall:
    """A client of a controller that has a hall of simulated devices."""

    def __init__(self, client: httpx.AsyncClient) -> None:
        self.client = client

    async def until(self, condition: Callable[[dict[str, Any]], bool], path: str) -> dict[str, Any]:
        """Read until it is so."""
        end = time.monotonic() + GENEROUS
        while True:
            found: dict[str, Any] = (await self.client.get(path)).json()
            if condition(found):
                return found
            assert time.monotonic() < end, found
            await asyncio.sleep(0.02)


@pytest.fixture
async def hall(tmp_path: Path) -> AsyncIterator[Hall]:
    (port,) = free_ports(1)
    plant = served(port, on_emergency=OnEmergency.OPEN)
    clock = Clock()
    floor = SimulatedHalls(plant, {}, clock.now())
    server = DeviceServer(Line(floor.lines[HALL], clock.now), "127.0.0.1", port)
    await server.start()
    controller = Controller(plant, f"sqlite:///{tmp_path}/plant.db")
    await controller.start()
    try:
        transport = httpx.ASGITransport(application(controller, Settings()))
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost/api/v1") as client:
            there = Hall(client)
            await there.until(lambda seen: bool(seen["items"]) and all(d["fresh"] for d in seen["items"]), "/devices")
            yield there
    finally:
        await controller.stop()
        await server.stop()


async def test_devices_are_listed_and_shown_one_by_one(hall: Hall) -> None:
    listed = (await hall.client.get("/devices")).json()["items"]
    assert [(d["id"], d["kind"]) for d in listed] == [
        ("DOOR1", "door"),
        ("BUFFER1", "buffer"),
        ("CHARGER1", "charger"),
    ]
    door = (await hall.client.get("/devices/DOOR1")).json()
    assert (door["state"], door["link"], door["number"], door["passages"]) == ("closed", "HALL", 30, [["106", "107"]])
    buffer = (await hall.client.get("/devices/BUFFER1")).json()
    assert (buffer["state"], buffer["station"], buffer["barcode"]) == ("no_cart", "P2", "109")
    assert (await hall.client.get("/stations/P2")).json()["provenance"] == "sensor"
    tag = (await hall.client.get("/devices/DOOR1")).headers["etag"]
    assert (await hall.client.get("/devices/DOOR1", headers={"If-None-Match": tag})).status_code == 304
    gone = await hall.client.get("/devices/DOOR9")
    assert (gone.status_code, gone.json()["remedy"]) == (404, "GET /api/v1/devices lists them.")


async def test_a_door_is_opened_and_closed_and_each_commands_outcome_is_seen(hall: Hall) -> None:
    for command, state in (("open", "open"), ("close", "closed")):
        taken = await hall.client.post("/devices/DOOR1/commands", json={"command": command}, headers=KIM)
        assert taken.status_code == 202, taken.text
        where = taken.headers["Location"].removeprefix("/api/v1")
        assert where == f"/devices/DOOR1/commands/{taken.json()['cmd_id']}"
        ended = await hall.until(lambda found: found["state"] == "done", where)
        assert (ended["kind"], ended["actor"], ended["outcome"]) == (command, "kim", "Status shows it")
        assert (await hall.client.get("/devices/DOOR1")).json()["state"] == state
    kinds = [row["kind"] for row in (await hall.client.get("/devices/DOOR1/commands")).json()["items"]]
    assert kinds == ["close", "open"]


async def test_a_buffer_is_locked_and_unlocked(hall: Hall) -> None:
    for command in ("lock", "unlock"):
        taken = await hall.client.post("/devices/BUFFER1/commands", json={"command": command}, headers=KIM)
        where = taken.headers["Location"].removeprefix("/api/v1")
        await hall.until(lambda found: found["state"] == "done", where)
        lock = (await hall.client.get("/devices/BUFFER1")).json()["lock"]
        assert (lock and (lock["owner"], lock["person"], lock["locked"])) == (
            ("kim", True, True) if command == "lock" else None
        )


@pytest.mark.parametrize(
    ("path", "body", "status", "field"),
    [
        ("/devices/DOOR1/commands", {"command": "lock"}, 422, "command"),
        ("/devices/DOOR1/commands", {"command": "explode"}, 422, "command"),
        ("/devices/DOOR1/commands", {}, 422, "command"),
        ("/devices/DOOR1/commands", {"command": "open", "hard": True}, 422, "hard"),
        ("/devices/CHARGER1/commands", {"command": "open"}, 422, "command"),
        ("/devices/DOOR9/commands", {"command": "open"}, 404, None),
        ("/devices/DOOR1/lockout", {"reason": ""}, 422, "reason"),
        ("/controller/emergency", {"kind": "flood", "reason": "wet"}, 422, "kind"),
        ("/controller/emergency", {"kind": "fire"}, 422, "reason"),
        ("/controller/emergency/release", {"kind": "fire", "reason": "over"}, 409, "kind"),
    ],
)
async def test_what_makes_no_sense_is_refused_with_the_reason(
    hall: Hall, path: str, body: dict[str, Any], status: int, field: str | None
) -> None:
    answer = await hall.client.post(path, json=body, headers=KIM)
    assert (answer.status_code, answer.json().get("field")) == (status, field), answer.text
    assert answer.headers["content-type"] == "application/problem+json"
    assert (await hall.client.get("/devices/DOOR1/commands")).json()["items"] == []


@pytest.mark.parametrize(
    ("method", "path", "body"),
    [
        ("PUT", "/devices/DOOR1/pin", {"position": "open", "reason": "air"}),
        ("DELETE", "/devices/DOOR1/pin", None),
        ("POST", "/devices/DOOR1/lockout", {"reason": "motor"}),
        ("DELETE", "/devices/DOOR1/lockout", None),
        ("POST", "/controller/emergency", {"kind": "fire", "reason": "smoke"}),
        ("POST", "/controller/emergency/release", {"kind": "fire", "reason": "over"}),
    ],
)
async def test_what_protects_people_needs_a_name(
    hall: Hall, method: str, path: str, body: dict[str, Any] | None
) -> None:
    answer = await hall.client.request(method, path, json=body)
    assert (answer.status_code, answer.json()["field"]) == (422, "X-Actor")


async def test_a_door_is_kept_open_and_given_back(hall: Hall) -> None:
    kept = await hall.client.put("/devices/DOOR1/pin", json={"position": "open", "reason": "air"}, headers=KIM)
    assert kept.json()["pin"] | {"since": None} == {"position": "open", "owner": "kim", "reason": "air", "since": None}
    await hall.until(lambda door: door["state"] == "open", "/devices/DOOR1")
    refused = await hall.client.post("/devices/DOOR1/commands", json={"command": "close"}, headers=LEE)
    assert (refused.status_code, refused.json()["detail"]) == (409, "DOOR1 is kept open by kim: air")
    assert (await hall.client.delete("/devices/DOOR1/pin", headers=LEE)).json()["pin"] is None
    await hall.until(lambda door: door["state"] == "closed", "/devices/DOOR1")


async def test_a_lockout_is_its_owners_to_lift(hall: Hall) -> None:
    locked = await hall.client.post("/devices/DOOR1/lockout", json={"reason": "motor"}, headers=KIM)
    assert locked.json()["lockout"]["owner"] == "kim"
    refused = await hall.client.post("/devices/DOOR1/commands", json={"command": "open"}, headers=LEE)
    assert refused.json()["detail"] == "DOOR1 is locked out by kim: motor"
    assert (await hall.client.delete("/devices/DOOR1/lockout", headers=LEE)).status_code == 409
    lifted = await hall.client.delete("/devices/DOOR1/lockout", headers=KIM)
    assert lifted.json()["lockout"] is None


async def test_a_charger_is_taken_out_of_service_and_put_back(hall: Hall) -> None:
    off = {"in_service": False, "reason": "no current"}
    assert (await hall.client.put("/devices/CHARGER1/service", json=off)).json()["service"] == "out_of_service"
    bad = await hall.client.put("/devices/CHARGER1/service", json={"in_service": False})
    assert (bad.status_code, bad.json()["field"]) == (422, "reason")
    on = await hall.client.put("/devices/CHARGER1/service", json={"in_service": True})
    assert (on.json()["service"], on.json()["out_of_service"]) == ("in_service", "")


async def test_the_last_packets_of_a_devices_link_are_explained(hall: Hall) -> None:
    frames = (await hall.client.get("/devices/DOOR1/frames")).json()["items"]
    words = {field["value"] for frame in frames for part in frame["frames"] for field in part["fields"]}
    assert {"30", "21"} <= words
    korean = (await hall.client.get("/devices/DOOR1/frames", params={"lang": "ko"})).json()["items"]
    assert korean[0]["hex"] == frames[0]["hex"]
    assert (await hall.client.get("/devices/CHARGER1/frames")).json()["items"] == []


async def test_a_command_of_another_device_is_not_found(hall: Hall) -> None:
    taken = await hall.client.post("/devices/DOOR1/commands", json={"command": "open"}, headers=KIM)
    cmd_id = taken.json()["cmd_id"]
    assert (await hall.client.get(f"/devices/BUFFER1/commands/{cmd_id}")).status_code == 404
    assert (await hall.client.get("/devices/DOOR1/commands/zz")).status_code == 404


async def test_a_fire_stops_the_plant_opens_its_door_and_is_released_by_name(hall: Hall) -> None:
    fire = {"kind": "fire", "reason": "smoke"}
    told = (await hall.client.post("/controller/emergency", json=fire, headers={"X-Actor": "fire-panel"})).json()
    assert (told["state"], told["emergencies"]) == ("paused", ["fire: smoke (fire-panel)"])
    await hall.until(lambda door: door["state"] == "open", "/devices/DOOR1")
    early = await hall.client.post("/controller/resume", headers=KIM)
    assert (early.status_code, early.json()["code"]) == (409, "not-now")
    over = await hall.client.post("/controller/emergency/release", json=fire | {"reason": "drill"}, headers=KIM)
    assert (over.json()["state"], over.json()["emergencies"]) == ("paused", [])
    assert (await hall.client.post("/controller/resume", headers=KIM)).json()["state"] == "auto"
    events = [event["event"] for event in (await hall.client.get("/events")).json()["items"]]
    assert {"EmergencySet", "EmergencyReleased"} <= set(events)
