"""S51 to S60 with the real session at one end of the link and simulated devices at the other, in virtual time."""

import pytest

from app.domain.devices import (
    AgvMode,
    AgvMove,
    AgvMoveAlias,
    AgvRun,
    AliasName,
    BufferState,
    DeviceAct,
    DeviceId,
    DeviceReported,
    DoorState,
    MoveCompleted,
    TagRead,
)
from tests.protocols.enig.rig import World, tag


@pytest.fixture
def world() -> World:
    """Everything connected and known, the AGVs in auto."""
    return World(latency=0.02).connect().auto()


def to(alias: str) -> AgvMoveAlias:
    """A move to a named place."""
    return AgvMoveAlias(AliasName(alias))


def open_door(world: World) -> None:
    """Open the door and wait for it."""
    request = world.ask("DOOR", DeviceAct.OPEN)
    world.wait(3.0)
    assert world.end(request) == "Done"


@pytest.mark.parametrize("places", [True, False])
def test_s51_a_move_to_an_alias_is_taken_told_of_and_done(places: bool) -> None:
    world = World(latency=0.02, places=places).connect().auto()
    open_door(world)
    request = world.ask("AGV1", to("B1"))
    world.wait(6.0)
    assert [name for _, name in world.about(request)] == ["Taken", "Done"]
    assert [event.tag for event in world.of(TagRead)] == ["0002", "0003"]
    assert [event.tag for event in world.of(MoveCompleted)] == ["0003"]
    assert world.status().arrived


def test_s52_a_move_that_meets_an_agv_in_manual_is_not_accepted_after_two_seconds(world: World) -> None:
    begun = world.now
    world.link.lose("Status")
    world.agv.set_mode(AgvMode.MANUAL, world.now)
    request = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(10.0)
    assert world.end(request) == "NotAccepted: the AGV is in manual"
    assert world.about(request) == [(round(begun + 2.0, 1), "NotAccepted")]
    assert len(world.transmissions((11, 100))) == 1


def test_s52_a_move_to_an_agv_that_is_known_to_be_in_manual_is_not_even_sent(world: World) -> None:
    world.agv.set_mode(AgvMode.MANUAL, world.now)
    world.wait(0.1)
    request = world.ask("AGV1", AgvMove(tag("0002")))
    assert world.end(request) == "NotSent: the AGV is in manual"
    assert world.transmissions((11, 100)) == []


def test_s53_a_stop_is_done_and_the_move_it_stopped_has_failed(world: World) -> None:
    move = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(1.0)
    stop = world.ask("AGV1", DeviceAct.STOP)
    world.wait(10.0)
    assert world.end(stop) == "Done"
    assert world.end(move) == "Failed: overtaken by Stop"
    assert world.of(MoveCompleted) == []
    assert not world.status().in_position


def test_s54_a_status_in_position_ends_a_move_whose_move_complete_is_lost(world: World) -> None:
    world.link.lose("MoveComplete")
    request = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(4.0)
    assert world.end(request) == "Done"
    assert world.of(MoveCompleted) == []


def test_s54_a_move_complete_ends_a_move_whose_status_is_lost(world: World) -> None:
    request = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(1.99)
    world.link.lose("Status", 3)
    world.wait(0.5)
    assert world.end(request) == "Done"


def test_s55_an_error_is_reset_before_the_agv_moves(world: World) -> None:
    world.agv.raise_error(world.now)
    world.wait(0.1)
    ignored = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(3.0)
    assert world.end(ignored) == "NotAccepted: the AGV is in error"
    reset = world.ask("AGV1", DeviceAct.RESET)
    world.wait(0.1)
    assert world.end(reset) == "Done"
    move = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(3.0)
    assert world.end(move) == "Done"


def test_s56_the_agv_passes_once_the_door_says_that_it_is_open(world: World) -> None:
    opening = world.ask("DOOR", DeviceAct.OPEN)
    world.wait(1.0)
    assert world.session.status(DeviceId("DOOR")) is DoorState.BUSY
    assert world.about(opening)[-1][1] == "Taken"
    world.wait(2.0)
    assert world.end(opening) == "Done"
    move = world.ask("AGV1", to("B1"))
    world.wait(6.0)
    assert world.end(move) == "Done"
    closing = world.ask("DOOR", DeviceAct.CLOSE)
    world.wait(3.0)
    assert world.end(closing) == "Done"


def test_s56_an_agv_sent_against_a_closed_door_ends_in_error(world: World) -> None:
    move = world.ask("AGV1", to("B1"))
    world.wait(6.0)
    assert world.end(move) == "Failed: the AGV reports an error, last tag 0002"


def test_s57_a_lock_is_done_when_the_buffer_is_busy_no_more(world: World) -> None:
    world.buffer.set_cart(world.now, cart=False)
    world.wait(0.1)
    request = world.ask("BUF1", DeviceAct.LOCK)
    world.wait(0.5)
    assert world.session.status(DeviceId("BUF1")) is BufferState.BUSY
    world.wait(1.0)
    assert [name for _, name in world.about(request)] == ["Taken", "Done"]
    assert world.session.status(DeviceId("BUF1")) is BufferState.NO_CART
    assert world.buffer.locked


def test_s58_each_device_s_status_is_its_own(world: World) -> None:
    kinds = {event.device: type(event.status).__name__ for event in world.of(DeviceReported)}
    assert kinds == {"AGV1": "AgvStatus", "AGV2": "AgvStatus", "BUF1": "BufferState", "DOOR": "DoorState"}


def test_s59_a_command_moves_only_the_agv_that_it_is_for(world: World) -> None:
    request = world.ask("AGV2", AgvMove(tag("0001")))
    world.wait(1.0)
    assert world.about(request)[-1][1] == "Taken"
    assert world.status("AGV2").run is AgvRun.RUN
    assert world.status("AGV1").run is AgvRun.STOP


def test_s60_a_path_that_begins_again_at_1_is_the_next_one(world: World) -> None:
    world.agv.report.path = 255
    world.wait(1.0)
    request = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(3.0)
    assert world.status().path == 1
    assert world.end(request) == "Done"
