"""The layout of a plant with a hall and drives: all that the page draws and names is in it."""

from pathlib import Path

import httpx
import pytest

from app.plant import read
from tests.api.scripted import Scripted

pytestmark = pytest.mark.anyio
HALL = Path(__file__).parents[2] / "plants" / "hall.yaml"


async def test_the_layout_names_every_device_and_where_it_stands(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    controller.plant, _ = read(HALL.read_text(encoding="utf-8"), "hall")
    layout = (await client.get("/layout")).json()
    assert layout["doors"] == [
        {"id": "DOOR1", "link": "hall", "number": 30, "passages": [["0120", "0121"]], "normally_open": False}
    ]
    assert layout["buffers"][0] == {"id": "BUFFER1", "link": "hall", "number": 21}
    assert layout["chargers"] == [{"id": "CHARGER1", "barcode": "0131", "alias": "C1"}]
    assert layout["drives"] == [
        {"id": "AX1", "name": "Shutter of the clean room", "line": "axes", "address": 1, "model": "demo"}
    ]
    assert [(s["id"], s["buffer"]) for s in layout["stations"]] == [
        ("AB1", "BUFFER1"),
        ("AB2", "BUFFER2"),
        ("AB3", None),
    ]
    assert {(vehicle["kind"], vehicle["link"]) for vehicle in layout["vehicles"]} == {("agv", "hall")}
    assert layout["links"][0] == {"id": "hall", "protocol": "enig", "address": "127.0.0.1:17121"}


async def test_a_line_over_a_serial_port_is_named_by_its_device(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    text = HALL.read_text(encoding="utf-8").replace(
        'axes: {protocol: hi, address: "127.0.0.1:17131"}', "axes: {protocol: hi, serial: {device: /dev/ttyUSB0}}"
    )
    controller.plant, _ = read(text, "hall")
    layout = (await client.get("/layout")).json()
    assert layout["links"][1] == {"id": "axes", "protocol": "hi", "address": "/dev/ttyUSB0"}
