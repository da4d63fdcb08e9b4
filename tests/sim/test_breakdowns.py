"""Hoists that break down in the demo plant: the others go round them, what is cut off is named, and every job ends."""

import pytest

from app.domain.ids import Actor, VehicleId
from app.domain.requests import HoldVehicle, RecoverAlarm, ReleaseVehicle, Verdict
from app.domain.view import ControllerView, Update
from app.sim.world import Result, World
from tests.sim.test_whole_plant import plant_of

KIM = Actor("kim")
BREAKS_AT, MENDED_AT = 60.0, 240.0


class Plant:
    """The demo plant at work, with what its controller's view has said."""

    def __init__(self, seed: int) -> None:
        self.world = World(plant_of("demo"), seed)
        self.said: list[ControllerView] = []
        self.world.seen = self._seen
        self.world.work(until=MENDED_AT, keep_open=8)

    def _seen(self, update: Update) -> None:
        if isinstance(update.value, ControllerView):
            self.said.append(update.value)

    def in_the_lower_lane(self) -> VehicleId:
        """Let time pass until a hoist comes to the end of bay A's lower lane, which can be driven round; return which."""
        while True:
            for vehicle in self.world.control.fleet.books.vehicles.values():
                if vehicle.barcode in {"2034", "2035"}:
                    return vehicle.id
            self.world.run(self.world.now + 0.5)

    def finish(self) -> Result:
        assert self.world.finish(1800.0)
        return self.world.result()


@pytest.mark.parametrize("alarm", [False, True], ids=["held", "in alarm"])
def test_while_a_hoist_stands_the_others_work_on_and_once_it_is_mended_all_jobs_end(alarm: bool) -> None:
    plant = Plant(1)
    world = plant.world
    world.run(BREAKS_AT)
    name = plant.in_the_lower_lane()
    if alarm:
        world.floor.devices[name].raise_alarm(101, world.now)
    else:
        world.ask(HoldVehicle(KIM, name, "it rattles"))
    world.run(world.now + 30.0)
    assert any(name in line for line in plant.said[-1].kept_off)
    before = world.result().completed
    world.run(MENDED_AT)
    assert world.result().completed > before + 5, "hardly anything was done while it stood"
    asked = RecoverAlarm(KIM, name, confirmed=True) if alarm else ReleaseVehicle(KIM, name, Verdict.GO_ON, "looked at")
    world.ask(asked)
    result = plant.finish()
    assert result.violations == ()
    assert result.open == ()
    assert result.takes == result.puts == result.completed
    assert plant.said[-1].kept_off == plant.said[-1].cut_off == ()
