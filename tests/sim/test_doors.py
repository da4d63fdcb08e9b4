"""Doors and a buffer in the virtual world: real bytes on a link with delays, hoists that pass, killed controllers, cut lines."""

from dataclasses import replace
from random import Random

import pytest

from app.domain.devices import BufferState, DeviceId
from app.domain.ids import StationId
from app.domain.layout import Plant
from app.domain.records import Intent
from app.domain.units import Millimetres
from app.sim.world import World
from tests.fleet.hall_plants import BUFFER1, DOOR1, HALL, ring
from tests.shares import shared

QUICK = 3000


def busy_ring() -> Plant:
    """Return the ring with vehicles at their usual speed; P2 has its buffer and no fall-back, so that jobs wait for it."""
    plant = ring()
    return replace(
        plant,
        vehicles=tuple(replace(v, max_speed=Millimetres(QUICK)) for v in plant.vehicles),
        stations=tuple(replace(s, fallbacks=()) for s in plant.stations),
    )


def begun(seed: int) -> World:
    """Return a world in which the buffer's own sensor sees what the hoists do at its station."""
    world = World(busy_ring(), seed)
    buffer, station = world.floor.halls.buffers[BUFFER1], StationId("P2")
    world.acted = lambda act: buffer.set_cart(world.now, cart=station in world.floor.truth.at)
    return world


def asked(world: World, device: DeviceId) -> list[str]:
    ledger = world.ledger
    intents: dict[int, Intent] = ledger._intents  # type: ignore[attr-defined]
    return [intent.kind for intent in intents.values() if str(intent.vehicle) == device]


@pytest.mark.parametrize("seconds", shared([900.0, 3600.0], 1))
def test_jobs_through_a_door_and_a_buffer_break_no_rule(seconds: float) -> None:
    world = begun(1)
    world.work(until=seconds, keep_open=2)
    world.run(seconds)
    assert world.finish(900.0)
    result = world.result()
    assert result.violations == ()
    assert result.completed > seconds / 60
    assert asked(world, DOOR1).count("open") > seconds / 180
    assert asked(world, BUFFER1).count("lock") == asked(world, BUFFER1).count("unlock") > seconds / 180


@pytest.mark.parametrize("seed", shared([*range(4)], 2))
def test_killed_controllers_and_cut_lines_close_no_door_on_anybody_and_lose_no_job(seed: int) -> None:
    world = begun(seed)
    dice = Random(seed)
    world.work(until=600.0, keep_open=2)
    for _ in range(6):
        world.agenda.at(dice.uniform(20.0, 600.0), world.kill)
        world.agenda.at(dice.uniform(20.0, 600.0), lambda: world.cut(HALL))
    world.run(600.0)
    assert world.finish(900.0)
    assert world.result().violations == ()
    world.run(world.now + 30.0)
    assert not world.floor.halls.buffers[BUFFER1].locked
    assert not world.floor.halls.doors[DOOR1].is_open


@pytest.mark.parametrize("seed", shared([*range(4)], 2))
def test_doors_and_buffers_that_fail_are_waited_for_and_nobody_is_caught(seed: int) -> None:
    world = begun(seed)
    dice = Random(seed)
    halls = world.floor.halls
    door, buffer = halls.doors[DOOR1], halls.buffers[BUFFER1]
    world.work(until=900.0, keep_open=2)
    for moment in sorted(dice.uniform(20.0, 880.0) for _ in range(8)):
        fail, mend = dice.choice(
            [
                (lambda: door.obstruct(world.now), lambda: door.clear(world.now)),
                (lambda: door.power_off(world.now), lambda: door.power_on(world.now)),
                (lambda: buffer.power_off(world.now), lambda: buffer.power_on(world.now)),
                (lambda: buffer.set_state(BufferState.ERROR, world.now), lambda: shown(world)),
            ]
        )
        world.agenda.at(moment, fail)
        world.agenda.at(moment + dice.uniform(1.0, 40.0), mend)
    world.run(900.0)
    assert world.finish(900.0)
    assert world.result().violations == ()
    assert world.result().completed > 10


def shown(world: World) -> None:
    """Let the buffer see again what stands there."""
    buffer = world.floor.halls.buffers[BUFFER1]
    buffer.set_state(BufferState.CART if buffer.cart else BufferState.NO_CART, world.now)


def test_a_world_with_doors_is_the_same_to_the_byte_each_time() -> None:
    def traced() -> str:
        world = begun(5)
        world.work(until=120.0, keep_open=2)
        world.run(120.0)
        return world.trace

    assert traced() == traced()
