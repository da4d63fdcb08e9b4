"""The hands at the simulated hoists."""

from collections.abc import AsyncIterator

import httpx
import pytest

from app.cli.operator import Hands
from app.domain.ids import VehicleId
from app.domain.layout import Axis
from app.domain.units import Seconds
from app.sim.plantworld import SimulatedPlant
from tests.agv.hall import hall
from tests.fleet.script import small

pytestmark = pytest.mark.anyio
V1 = VehicleId("V001")


async def no_rail(_name: VehicleId, _on: bool) -> bool:
    """There is no such hoist."""
    return False


@pytest.fixture
def anyio_backend() -> str:
    return "asyncio"


@pytest.fixture
def floor() -> SimulatedPlant:
    return SimulatedPlant(small())


@pytest.fixture
async def client(floor: SimulatedPlant) -> AsyncIterator[httpx.AsyncClient]:
    hands = Hands(floor.devices, {}, lambda: Seconds(0.0), floor.halls.agvs, no_rail)
    async with httpx.AsyncClient(transport=httpx.ASGITransport(hands.application()), base_url="http://sim") as client:
        yield client


async def test_a_hoist_shows_its_key_and_its_axes_and_is_jogged(
    client: httpx.AsyncClient, floor: SimulatedPlant
) -> None:
    assert (await client.get("/hoists/V001")).json() == {
        "mode": "auto",
        "barcode": "103",
        "shft": 0,
        "rota": 0,
        "lift": 0,
    }
    turned = await client.post("/hoists/V001/key", json={"mode": "mant"})
    assert turned.json()["mode"] == "mant"
    assert (await client.post("/hoists/V001/jog", json={"lift": 41000, "rota": -5})).json()["lift"] == 41000
    assert floor.devices[V1].state.pulses == {Axis.SHFT: 0, Axis.ROTA: -5, Axis.LIFT: 41000}


async def test_its_hand_controller_teaches_in_mant_only(client: httpx.AsyncClient) -> None:
    refused = await client.post("/hoists/V001/teach", json={"what": "lift_dest"})
    assert (refused.status_code, "not in MANT" in refused.json()["detail"]) == (422, True)
    await client.post("/hoists/V001/key", json={"mode": "mant"})
    assert (await client.post("/hoists/V001/teach", json={"what": "lift_dest"})).status_code == 200


@pytest.mark.parametrize(
    ("path", "body"),
    [
        ("key", {"mode": "fly"}),
        ("key", {}),
        ("jog", {"lift": 1 << 40}),
        ("jog", {"slid": 1}),
        ("teach", {"what": "all"}),
    ],
)
async def test_what_is_not_understood_is_refused(client: httpx.AsyncClient, path: str, body: dict[str, object]) -> None:
    answer = await client.post(f"/hoists/V001/{path}", json=body)
    assert (answer.status_code, bool(answer.json()["detail"])) == (422, True)
    assert (await client.post(f"/hoists/V9/{path}", json=body)).status_code == 404
    assert (await client.get("/hoists/V9")).status_code == 404


async def test_an_agvs_key_is_turned_at_the_agv_alone() -> None:
    floor = SimulatedPlant(hall(two_way=["1-2-3-4-5"], stations=[1, 5], starts=[3], carts=1))
    hands = Hands({}, {}, lambda: Seconds(0.0), floor.halls.agvs, no_rail)
    async with httpx.AsyncClient(transport=httpx.ASGITransport(hands.application()), base_url="http://sim") as client:
        assert (await client.get("/agvs/A1")).json() == {"mode": "auto", "tag": "0003"}
        assert (await client.post("/agvs/A1/key", json={"mode": "manual"})).json()["mode"] == "manual"
        assert (await client.get("/agvs/A1")).json()["mode"] == "manual"
        assert (await client.post("/agvs/A1/key", json={"mode": "mant"})).status_code == 422
        assert (await client.post("/agvs/A9/key", json={"mode": "auto"})).status_code == 404
