"""One AGV does jobs between AGV buffers, over its own wire, in virtual time."""

from app.domain.ids import StationId
from app.domain.job import JobState
from tests.agv.hall import HallWorld


def test_an_agv_brings_a_cart_from_one_buffer_to_another() -> None:
    world = HallWorld()
    world.ready()
    world.order("B1", "B5")
    assert world.ends() is JobState.COMPLETED
    assert world.result().violations == ()
    assert dict(world.floor.truth.at) == {StationId("B5"): "CART1"}
    assert (world.oracle.takes, world.oracle.puts) == (1, 1)
