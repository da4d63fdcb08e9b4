"""What ``hoistway demo`` invites to: a transfer that the plant can do."""

import asyncio
import json
import re
from pathlib import Path

import httpx
import pytest

from app.cli.demo import WATCHED, _ended, _invitation, counted
from app.cli.shown import Simulator
from app.domain.layout import Plant, VehicleKind
from app.planning.routing import Router
from app.planning.track import Track
from app.plant import read
from tests.e2e.processes import free_ports, quick_plant

PLANTS = Path(__file__).parents[2] / "plants"


def plant_of(name: str) -> Plant:
    return read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)[0]


@pytest.mark.parametrize("name", ["demo", "hall", "small"])
def test_the_invited_transfer_is_between_stations_that_one_vehicle_serves(name: str) -> None:
    plant = plant_of(name)
    body = re.search(r"-d '(.*)'", _invitation(plant, "http://127.0.0.1:8080"))
    assert body is not None
    ends = [plant.station(place) for place in json.loads(body[1]).values()]
    kinds = {end.kind for end in ends if end is not None}
    assert len(ends) == 2
    assert any(kinds <= kind.serves for kind in VehicleKind)


def test_the_readmes_transfer_is_the_one_that_is_invited_to() -> None:
    line = _invitation(plant_of("demo"), "http://127.0.0.1:8080").splitlines()[2]
    body = re.search(r"-d '(.*)'", line)
    assert body is not None
    assert body[1] in (PLANTS.parent / "README.md").read_text(encoding="utf-8")


def test_the_invited_transfer_is_soon_over_and_yet_to_be_seen() -> None:
    plant = plant_of("demo")
    body = re.search(r"-d '(.*)'", _invitation(plant, "http://127.0.0.1:8080"))
    assert body is not None
    source, destination = (plant.station(place) for place in json.loads(body[1]).values())
    assert source is not None
    assert destination is not None
    router = Router(Track(plant))
    free = {station for station in plant.stations if station.id not in {place for _, place in plant.carriers}}
    others = [router.time(source.barcode, place.barcode) for place in free if place.kind in VehicleKind.HOIST.serves]
    assert router.time(source.barcode, destination.barcode) == max(time for time in others if time <= WATCHED)


def test_everything_in_the_plant_is_counted() -> None:
    assert counted(plant_of("demo")) == "10 hoists, 2 AGVs, 1 door, 4 buffers, 1 charger, 3 drives"
    assert counted(plant_of("small")) == "2 hoists"


def test_the_simulated_plant_follows_a_change_of_the_plant(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    file = quick_plant("small", tmp_path)
    text, (port,) = file.read_text(encoding="utf-8"), free_ports(1)
    coming = f'  V003: {{dev_id: 3, address: "127.0.0.1:{port}", offset: {{shft: 0, rota: 0, lift: 0}}}}\n'
    more = text.replace("  V002: {", coming + "  V002: {")

    async def shown() -> None:
        simulator = Simulator(file, text, None)
        await simulator.start()
        try:
            with pytest.raises(ConnectionError):
                await asyncio.open_connection("127.0.0.1", port)
            await simulator.follow("name: small\nwords: that nobody understands\n")
            await simulator.follow(text.replace("dev_id: 2,", "dev_id: 7,"))
            await simulator.follow(more)
            _, writer = await asyncio.open_connection("127.0.0.1", port)
            writer.close()
        finally:
            await _ended(simulator.process)

    asyncio.run(shown())
    said = [line for line in capfd.readouterr().err.splitlines() if "hoistway sim" in line]
    assert len(said) == 2
    assert "the plant is not followed" in said[0]
    assert said[1].endswith("not followed until it is started again: vehicle V002 changed"), (
        "and back again is followed"
    )


def test_a_simulated_hoist_is_taken_off_its_rail_and_put_back(tmp_path: Path) -> None:
    file, (operator,) = quick_plant("small", tmp_path), free_ports(1)
    text = file.read_text(encoding="utf-8")
    port = next(spec.port for spec in read(text, "small")[0].vehicles if spec.id == "V002")

    async def shown() -> None:
        simulator = Simulator(file, text, operator)
        await simulator.start()
        try:
            async with httpx.AsyncClient(base_url=f"http://127.0.0.1:{operator}") as hands:

                async def rail(name: str, **word: object) -> int:
                    return (await hands.post(f"/hoists/{name}/rail", json=word)).status_code

                assert await rail("V002", on=False) == 200
                assert (await hands.get("/hoists/V002")).status_code == 404
                with pytest.raises(ConnectionError):
                    await asyncio.open_connection("127.0.0.1", port)
                await simulator.follow(text.replace("dev_id: 1,", "dev_id: 7,"))
                assert (await hands.get("/hoists/V002")).status_code == 404, "whatever plant is told"
                assert await rail("V002", on=True) == 200
                _, writer = await asyncio.open_connection("127.0.0.1", port)
                writer.close()
                assert (await hands.get("/hoists/V002")).json()["mode"] == "auto"
                assert [await rail("V009", on=False), await rail("V002", on=7), await rail("V002")] == [404, 422, 422]
        finally:
            await _ended(simulator.process)

    asyncio.run(shown())
