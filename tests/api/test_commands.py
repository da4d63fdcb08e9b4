"""Commands over the live stream: the same as over REST, by name."""

import asyncio
import json

import pytest
from fastapi import FastAPI

from app.api import application, spoken
from app.api.commands import COMMANDS
from app.domain import device_requests as h
from app.domain import drive_requests as d
from app.domain import requests as r
from app.domain.commands import Plain
from app.domain.devices import DeviceAct, DeviceId
from app.domain.drive import Parameter
from app.domain.errors import Refusal
from app.domain.ids import Actor, VehicleId
from app.domain.records import DoorPosition, EmergencyKind
from app.settings import Settings
from tests.api.scripted import Scripted
from tests.api.scripted_drives import D1
from tests.api.sockets import Socket

pytestmark = pytest.mark.anyio
KIM, DOOR1 = Actor("kim"), DeviceId("DOOR1")


@pytest.fixture
def app(controller: Scripted) -> FastAPI:
    return application(controller, Settings())


async def opened(socket: Socket) -> Socket:
    await socket.accepted()
    await socket.frame()
    return socket


def say(socket: Socket, name: str, target: str = "", body: object = None, **more: object) -> None:
    command: dict[str, object] = {"name": name, "target": target}
    if body is not None:
        command["body"] = body
    socket.say(json.dumps({"id": 1, "command": command, "actor": "kim"} | more))


async def test_a_command_does_what_its_route_does_and_says_who_asked(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=events", headers={"x-actor": "lee"}) as socket:
        await opened(socket)
        say(socket, "vehicle.command", "V001", {"command": "status"})
        reply = await socket.frame()
        assert (reply["type"], reply["id"], reply["status"]) == ("reply", 1, 202)
        assert reply["location"].startswith("/api/v1/vehicles/V001/commands/")
        assert reply["body"]["vehicle"] == "V001"
        assert controller.seen == [r.CommandVehicle(Actor("kim"), VehicleId("V001"), Plain.STATUS)]
        say(socket, "controller.pause", body={"reason": "tea"}, actor=None, id="a")
        reply = await socket.frame()
        assert (reply["id"], reply["body"]["state"]) == ("a", "pausing")
        assert controller.seen[-1] == r.PauseController(Actor("lee"), "tea")
        say(socket, "controller.resume", actor="김")
        assert (await socket.frame())["status"] == 200
        assert controller.seen[-1].actor == "김"


@pytest.mark.parametrize(
    ("name", "body", "asked"),
    [
        ("device.command", {"command": "open"}, h.CommandDevice(KIM, DOOR1, DeviceAct.OPEN)),
        ("device.pin", {"position": "closed", "reason": "x"}, h.PinDoor(KIM, DOOR1, DoorPosition.CLOSED, "x")),
        ("device.unpin", None, h.UnpinDoor(KIM, DOOR1)),
        ("device.lockout", {"reason": "x"}, h.LockOutDevice(KIM, DOOR1, "x")),
        ("device.unlock", None, h.LiftDeviceLockout(KIM, DOOR1)),
        ("device.service", {"in_service": True}, h.SetDeviceService(KIM, DOOR1, "")),
        ("controller.emergency", {"kind": "fire", "reason": "x"}, h.RaiseEmergency(KIM, EmergencyKind.FIRE, "x")),
        (
            "controller.emergency.release",
            {"kind": "fire", "reason": "x"},
            h.ReleaseEmergency(KIM, EmergencyKind.FIRE, "x"),
        ),
    ],
)
async def test_devices_and_emergencies_are_commanded_too(
    app: FastAPI, controller: Scripted, name: str, body: object, asked: object
) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        say(socket, name, "" if name.startswith("controller") else DOOR1, body)
        assert (await socket.frame())["type"] == "reply"
        assert controller.seen == [asked]


async def test_a_refusal_is_the_same_problem_under_the_id_of_the_command(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        controller.refusal = Refusal("not-now", "V001 is in MANUAL", "switch it to AUTO")
        say(socket, "vehicle.hold", "V001", {"reason": "look"})
        error = await socket.frame()
        assert (error["type"], error["id"]) == ("error", 1)
        assert (error["problem"]["status"], error["problem"]["detail"]) == (409, "V001 is in MANUAL")
        assert error["problem"]["remedy"] == "switch it to AUTO"


@pytest.mark.parametrize(
    ("name", "body", "more", "field"),
    [
        ("vehicle.fly", None, {}, "command.name"),
        ("vehicle.hold", {}, {}, "reason"),
        ("vehicle.hold", {"reason": "x", "surprise": 1}, {}, "surprise"),
        ("vehicle.command", {"command": "fly"}, {}, "command"),
        ("vehicle.release", {"verdict": "go_on", "reason": "x"}, {"actor": None}, "actor"),
        ("vehicle.hold", {"reason": "x"}, {"actor": "a\u200b"}, "X-Actor"),
        ("drive.status", {"x": 1}, {}, "command.body"),
        ("drive.write", {"raw": 1}, {}, "parameter"),
    ],
)
async def test_what_is_wrong_with_a_command_is_said_and_the_stream_goes_on(
    app: FastAPI, controller: Scripted, name: str, body: object, more: dict[str, object], field: str
) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        say(socket, name, "V001", body, **more)
        error = await socket.frame()
        assert (error["type"], error["id"], error["problem"]["field"]) == ("error", 1, field)
        assert not controller.seen
        say(socket, "controller.resume")
        assert (await socket.frame())["type"] == "reply"


@pytest.mark.parametrize("body", ["[" * 1900 + "]" * 1900, "[" * 3900, '{"a":' * 600 + "1" + "}" * 600])
async def test_a_command_nested_without_end_is_refused_and_the_stream_goes_on(app: FastAPI, body: str) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        socket.say(f'{{"id": 1, "command": {{"name": "device.command", "target": "DOOR1", "body": {body}}}}}')
        assert (await socket.frame())["type"] == "error"
        say(socket, "controller.resume")
        assert (await socket.frame())["type"] == "reply"


async def test_every_command_refuses_an_unknown_target_or_an_empty_body(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        for name in COMMANDS:
            say(socket, name, "nope")
            frame = await socket.frame()
            optional = (
                "controller.",
                "link.",
                "station.stage",
            )  # all of their body is; the scripted plant takes any name
            assert frame["type"] == "error" or name.startswith(optional), frame


async def test_a_jog_is_let_go_at_once_when_its_socket_closes(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        say(socket, "drive.jog", "D1", {"direction": "cw"})
        begun = await socket.frame()
        assert (begun["status"], begun["body"]) == (202, {"drive": "D1", "jog": "1", "hold": 0.5})
        say(socket, "drive.jog.keep", "D1", {"jog": 1})
        assert (await socket.frame())["type"] == "reply"
    assert controller.drives.words == [d.KeepDriveJog(1), d.ReleaseDriveJog(1)]


async def test_a_jog_that_was_let_go_is_not_let_go_again(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        say(socket, "drive.jog", "D1", {"direction": "cw"})
        await socket.frame()
        say(socket, "drive.jog.release", "D1", {"jog": 1})
        assert (await socket.frame())["type"] == "reply"
    assert controller.drives.words == [d.ReleaseDriveJog(1)]


class Slow(Scripted):
    """Answers only when told to: its database stalls."""

    def __init__(self) -> None:
        super().__init__()
        self.go_on = asyncio.Event()

    async def ask(self, request: r.Request) -> r.Reply:
        await self.go_on.wait()
        return await super().ask(request)


async def test_a_jog_whose_socket_closed_before_it_began_is_let_go_when_it_begins() -> None:
    controller = Slow()
    async with Socket(application(controller, Settings()), query="topics=events") as socket:
        await opened(socket)
        say(socket, "drive.jog", "D1", {"direction": "cw"})
        for _ in range(10):
            await asyncio.sleep(0)
    controller.go_on.set()
    while not controller.drives.words:
        await asyncio.sleep(0)
    assert controller.drives.words == [d.ReleaseDriveJog(1)]


async def test_keeping_a_jog_does_not_wait_behind_a_command_that_takes_its_time() -> None:
    controller = Slow()
    async with Socket(application(controller, Settings()), query="topics=events") as socket:
        await opened(socket)
        controller.go_on.set()
        say(socket, "drive.jog", "D1", {"direction": "cw"})
        await socket.frame()
        controller.go_on.clear()
        say(socket, "drive.read", "D2", {})
        say(socket, "drive.jog.keep", "D1", {"jog": 1}, id=2)
        assert (await socket.frame())["id"] == 2
        controller.go_on.set()
        assert (await socket.frame())["id"] == 1


async def test_only_so_many_commands_of_one_watcher_are_under_way() -> None:
    controller = Slow()
    async with Socket(application(controller, Settings()), query="topics=events") as socket:
        await opened(socket)
        for number in range(spoken.MOST_AT_ONCE + 1):
            say(socket, "drive.status", "D1", id=number)
        error = await socket.frame()
        assert (error["id"], error["problem"]["code"]) == (spoken.MOST_AT_ONCE, "too-many")
        controller.go_on.set()


async def test_parameters_are_watched_until_the_socket_closes(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=parameters") as socket:
        await socket.accepted()
        snapshot = await socket.frame()
        assert "D1/1C" in snapshot["objects"]["parameters"]
        say(socket, "drive.watch", "D1", {"parameters": ["1C"]})
        assert (await socket.frame())["body"] == {"drive": "D1", "parameters": ["1C"]}
        (watch,) = controller.drives.words
        assert isinstance(watch, d.WatchDrive)
        assert (watch.drive, watch.parameters, watch.seconds) == (D1, (Parameter(0x1C),), None)
    assert controller.drives.words[1:] == [d.UnwatchDrive(watch.watch)]


async def test_a_watch_can_be_ended_before(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        say(socket, "drive.watch", "D1", {"parameters": ["1C"]})
        await socket.frame()
        say(socket, "drive.unwatch", "D1")
        assert (await socket.frame())["type"] == "reply"
        say(socket, "drive.unwatch", "D2")
        assert (await socket.frame())["type"] == "error"
    assert len(controller.drives.words) == 3


async def test_a_write_over_the_stream_names_its_parameter(app: FastAPI, controller: Scripted) -> None:
    async with Socket(app, query="topics=events") as socket:
        await opened(socket)
        say(socket, "drive.write", "D1", {"parameter": "1c", "value": 1.5})
        assert (await socket.frame())["body"]["kind"] == "write"
        assert controller.seen == [d.WriteDrive(Actor("kim"), D1, Parameter(0x1C), value=1.5)]
