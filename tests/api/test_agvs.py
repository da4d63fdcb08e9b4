"""AGVs over REST: commands in ENIG's own words, their refusals, and the packets on their link."""

from collections.abc import AsyncIterator
from dataclasses import replace
from pathlib import Path

import httpx
import pytest

from app.api import application
from app.api.frames import explained
from app.domain.units import Timestamp
from app.plant import read
from app.protocols.enig.codec import Codec
from app.protocols.enig.dialects import DEFAULT
from app.protocols.enig.messages import AgvReport, DoorReport, Lift, Toward
from app.runtime.controller import Controller
from app.settings import Settings

pytestmark = pytest.mark.anyio
READ, _ = read((Path(__file__).parents[2] / "plants" / "hall.yaml").read_text(encoding="utf-8"), "hall.yaml")
HALL = replace(READ, links=tuple(replace(link, host="127.0.0.1", port=1) for link in READ.links))
"""The hall, with nobody at the other end of its lines."""
AGV = next(vehicle for vehicle in HALL.vehicles if vehicle.kind.value == "agv")
KIM = {"X-Actor": "kim"}


@pytest.fixture
async def client(tmp_path: Path) -> AsyncIterator[httpx.AsyncClient]:
    controller = Controller(HALL, f"sqlite:///{tmp_path / 'plant.db'}")
    await controller.start()
    try:
        transport = httpx.ASGITransport(application(controller, Settings()))
        async with httpx.AsyncClient(transport=transport, base_url="http://localhost/api/v1") as client:
            yield client
    finally:
        await controller.stop()


@pytest.mark.parametrize(
    "command",
    [
        {"command": "agv_move_manual", "direction": "forward", "speed": "slow"},
        {"command": "agv_move_auto", "steering": "left"},
        {"command": "agv_mark_stop"},
        {"command": "agv_set_current", "tag": "0101"},
        {"command": "agv_lift", "action": "up"},
        {"command": "agv_charge", "on": True},
        {"command": "agv_move_alias", "alias": "B1"},
        {"command": "stop"},
    ],
)
async def test_a_command_to_an_agv_that_is_not_connected_says_so(
    client: httpx.AsyncClient, command: dict[str, object]
) -> None:
    answer = await client.post(f"/vehicles/{AGV.id}/commands", json=command, headers=KIM)
    assert answer.status_code == 409, answer.text
    assert "is not connected" in answer.json()["detail"]
    audit = (await client.get("/audit")).json()["items"]
    assert [row["accepted"] for row in audit] == [False]


async def test_what_enig_does_not_have_is_refused_by_name(client: httpx.AsyncClient) -> None:
    answer = await client.post(f"/vehicles/{AGV.id}/commands", json={"command": "servo_on"}, headers=KIM)
    assert answer.status_code == 422, answer.text
    assert answer.json()["detail"] == f"{AGV.id} is an AGV: servo_on is a hoist's command"


async def test_an_agv_is_shown_with_its_kind_and_link(client: httpx.AsyncClient) -> None:
    shown = (await client.get(f"/vehicles/{AGV.id}")).json()
    assert (shown["kind"], shown["agv"], shown["status1"]) == ("agv", None, None)
    assert shown["address"] == f"{AGV.link}, device {AGV.dev_id}"
    assert (await client.get(f"/vehicles/{AGV.id}/frames")).json()["items"] == []


def test_the_packets_of_one_agv_are_explained_and_no_others() -> None:
    codec = Codec(DEFAULT)
    sent = codec.encode(codec.packet(AGV.dev_id, Lift(1)), Toward.DEVICE)
    heard = codec.encode(codec.packet(AGV.dev_id, AgvReport(lift=2, tag="0101")), Toward.HOST)
    other = codec.encode(codec.packet(30, DoorReport(1)), Toward.HOST)
    frames = [(Timestamp(1.0), "out", sent), (Timestamp(2.0), "in", other), (Timestamp(3.0), "in", heard)]
    rows = explained(HALL, AGV, frames)
    assert [(row["direction"], row["frames"][0]["kind"]) for row in rows] == [("out", "lift"), ("in", "status")]  # type: ignore[index]
    fields = {field["name"]: field["meaning"] for field in rows[1]["frames"][0]["fields"]}  # type: ignore[index]
    assert fields["lift"] == "unknown"
