"""Lines with several devices in the virtual world: what doors, buffers and drives say is seen in the read model."""

from pathlib import Path

from app.domain.view import DeviceView, DriveView, Topic, View
from app.plant import read
from app.sim.world import World

HALL = Path(__file__).parents[2] / "plants" / "hall.yaml"


def hall(seed: int = 1) -> World:
    plant, _ = read(HALL.read_text(encoding="utf-8"), HALL.name)
    return World(plant, seed)


def seen(world: World, topic: Topic) -> dict[str, View]:
    return {u.key: u.value for u in world.control.snapshot() if u.topic is topic and u.value is not None}


def device(world: World, name: str) -> DeviceView:
    view = seen(world, Topic.DEVICES)[name]
    assert isinstance(view, DeviceView)
    return view


def drive(world: World, name: str) -> DriveView:
    view = seen(world, Topic.DRIVES)[name]
    assert isinstance(view, DriveView)
    return view


def test_doors_and_buffers_report_and_are_shown_in_the_specifications_words() -> None:
    world = hall()
    world.run(3.0)
    shown = {name: (device(world, name).fresh, device(world, name).state) for name in seen(world, Topic.DEVICES)}
    assert shown["DOOR1"] == (True, "closed")
    assert shown["BUFFER1"] == (True, "cart")
    assert shown["BUFFER2"] == (True, "cart")


def test_a_link_that_is_cut_leaves_its_devices_unknown_until_they_report_again() -> None:
    world = hall()
    world.run(3.0)
    world.cut("hall")
    assert (device(world, "DOOR1").fresh, device(world, "DOOR1").state) == (False, "closed")
    world.run(6.0)
    assert device(world, "DOOR1").fresh


def test_drives_are_polled_and_shown() -> None:
    world = hall()
    world.run(3.0)
    assert (drive(world, "AX1").online, drive(world, "AX1").mode) == (True, "monitoring")
    world.cut("axes")
    assert drive(world, "AX1").online is None
    assert drive(world, "AX1").reason == "the line is down: cut"
    world.run(6.0)
    assert drive(world, "AX1").online


def test_an_error_of_a_drive_is_shown_with_its_meaning() -> None:
    world = hall()
    world.run(3.0)
    next(iter(world.floor.halls.drives.values())).fail(4, world.now)
    world.run(6.0)
    shown = drive(world, "AX1")
    assert (shown.mode, shown.code, shown.meaning) == ("error", 4, "OV")


def test_a_world_with_halls_is_the_same_to_the_byte_each_time() -> None:
    def traced() -> str:
        world = hall(seed=7)
        world.run(30.0)
        return world.trace

    assert traced() == traced()
