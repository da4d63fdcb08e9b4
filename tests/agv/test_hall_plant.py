"""The example hall under load: a door that is driven through both ways, buffers that are locked, a charger, two AGVs."""

from pathlib import Path

from app.domain.devices import AgvRun
from app.domain.units import Barcode
from app.plant import read
from tests.agv.hall import HallWorld

HALL = Path(__file__).parents[2] / "plants" / "hall.yaml"


def test_a_quarter_of_an_hour_in_the_hall_ends_every_job_and_no_agv_meets_a_closed_door() -> None:
    plant, _ = read(HALL.read_text(encoding="utf-8"), HALL.name)
    world = HallWorld(plant, 1)
    world.work(until=900.0, keep_open=2)
    world.run(900.0)
    assert world.finish(600.0), world.said()
    result = world.result()
    assert result.violations == ()
    assert result.completed == result.ended > 20
    assert all(agv.report.run != AgvRun.ERROR for agv in world.floor.halls.agvs.values())
    assert any(agv.report.charge for agv in world.floor.halls.agvs.values())


def test_a_door_named_one_way_stands_across_the_way_back_too() -> None:
    plant, _ = read(HALL.read_text(encoding="utf-8"), HALL.name)
    passages = HallWorld(plant, 1).control.fleet.motion.passages
    there, back = (Barcode("0120"), Barcode("0121")), (Barcode("0121"), Barcode("0120"))
    door = passages.door_at(*there)
    assert door is not None
    assert passages.door_at(*back) is door
    assert passages.doors[door] == (there, back)
