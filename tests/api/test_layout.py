"""The layout of a plant with a hall and drives: all that the page draws and names is in it."""

from dataclasses import replace
from pathlib import Path

import httpx
import pytest

from app.domain.layout import Edge
from app.domain.units import Barcode, Millimetres
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


async def test_routes_between_stations_and_barcodes_come_with_alternatives_and_times(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    shortcut = Edge(Barcode("1001"), Barcode("1003"), Millimetres(2500))
    controller.plant = replace(controller.plant, edges=(*controller.plant.edges, shortcut))
    found = (await client.get("/layout/routes", params={"from": "P1", "to": "1003", "k": 3})).json()
    routes = found["items"]
    assert [(route["barcodes"], route["length"]) for route in routes] == [
        (["1001", "1002", "1003"], 2000),
        (["1001", "1003"], 2500),
    ]
    assert [route["seconds"] for route in routes] == [pytest.approx(2 / 3, abs=1e-3), pytest.approx(2.5 / 3, abs=1e-3)]
    assert all(route["free_flow_seconds"] == route["seconds"] and route["version"] == 1 for route in routes)
    quickest = (await client.get("/layout/routes", params={"from": "P1", "to": "1003"})).json()
    assert quickest == {"items": routes[:1], "next": None}


async def test_where_no_route_leads_the_problem_says_so(client: httpx.AsyncClient) -> None:
    answer = await client.get("/layout/routes", params={"from": "nowhere", "to": "0101"})
    assert answer.status_code == 422
    assert answer.json()["detail"] == "no route from nowhere to 0101: nowhere is not on the track"
