from functools import partial
from pathlib import Path

import pytest

from app.domain.commands import Plain
from app.domain.ids import Actor, VehicleId
from app.domain.layout import Plant
from app.domain.requests import Accepted, CommandVehicle, PauseController, ReleaseVehicle, Verdict
from app.domain.units import Barcode, Timestamp
from app.planning.routing import Router
from app.plant import read
from app.sim.truth import Act, Deed
from app.sim.world import World
from app.store.ledger import SqlLedger

V1 = VehicleId("V001")
ACTOR = Actor("test")


def plant_of(name: str) -> Plant:
    file = Path(__file__).parents[2] / "plants" / f"{name}.yaml"
    plant, _ = read(file.read_text(encoding="utf-8"), file.name)
    return plant


def small() -> Plant:
    return plant_of("small")


def behind(plant: Plant, barcode: Barcode, steps: int) -> Barcode:
    """Return a barcode so many steps back."""
    for _ in range(steps):
        barcode = next(edge.start for edge in plant.edges if edge.end == barcode)
    return barcode


def settled(world: World) -> World:
    """Let the roll-call end."""
    world.run(world.now + 5.0)
    return world


def test_requests_are_answered_once_they_are_durable() -> None:
    world = settled(World(small(), 1))
    ticket = world.ask(PauseController(ACTOR, "lunch"))
    assert ticket not in world.replies
    world.run(world.now + 0.1)
    assert isinstance(world.replies[ticket], Accepted)


def test_what_a_database_keeps_is_enough_for_the_same_work() -> None:
    ledger = SqlLedger("sqlite://", "small", "test", lambda: Timestamp(1_767_225_600.0))
    world = World(small(), 1, ledger)
    world.work(until=60.0, keep_open=2)
    world.agenda.at(30.0, world.kill)
    world.run(60.0)
    assert world.finish(300.0)
    result = world.result()
    assert result.violations == ()
    assert result.completed == result.takes == result.puts > 0


def test_lines_that_are_cut_again_and_again_delay_jobs_and_lose_none() -> None:
    world = World(small(), 2)
    world.work(until=120.0, keep_open=2)
    for moment in range(10, 120, 7):
        vehicle = world.plant.vehicles[moment % 2].id
        world.agenda.at(float(moment), lambda vehicle=vehicle: world.cut(vehicle))  # type: ignore[misc]
    world.run(120.0)
    assert world.finish(600.0)
    assert world.result().violations == ()
    assert world.result().completed > 0


def test_a_vehicle_that_restarts_is_dialled_until_it_accepts_again() -> None:
    world = settled(World(small(), 3))
    world.floor.devices[V1].power_cycle(world.now)
    world.run(world.now + 1.0)
    assert world.floor.refuses(V1)
    world.run(world.now + 30.0)
    assert not world.floor.refuses(V1)
    assert world.control.endpoint(V1).deadline is not None
    ticket = world.ask(CommandVehicle(ACTOR, V1, Plain.STATUS))
    world.run(world.now + 1.0)
    assert isinstance(world.replies[ticket], Accepted)


def test_a_killed_controller_answers_nothing_until_it_is_back() -> None:
    world = settled(World(small(), 4))
    world.kill()
    world.kill()
    assert not world.alive
    with pytest.raises(LookupError):
        world.ask(PauseController(ACTOR, "lunch"))
    world.run(world.now + 5.0)
    assert world.alive


def test_a_kill_while_records_are_being_written_keeps_them_or_not_and_never_half() -> None:
    kept = set()
    for seed in range(12):
        world = settled(World(small(), seed))
        ticket = world.ask(PauseController(ACTOR, "lunch"))
        world.kill()
        world.run(world.now + 10.0)
        assert ticket not in world.replies
        assert world.result().violations == ()
        kept.add(world.control.fleet.books.controller.state.value)
    assert kept == {"auto", "paused"}


def test_updates_are_seen_as_they_are_published() -> None:
    world = World(small(), 5)
    seen: list[str] = []
    world.seen = lambda update: seen.append(update.topic)
    settled(world)
    assert "vehicles" in seen


def test_killed_while_the_lifter_is_down_and_f_has_just_become_1_it_sends_no_move_until_the_axes_are_home() -> None:
    world = World(small(), 6)
    killed: list[Act] = []

    def kill(act: Act) -> None:
        if act.deed is Deed.TAKE and not killed:
            killed.append(act)
            world.kill()

    world.acted = kill
    world.work(until=30.0, keep_open=1)
    world.run(30.0)
    assert killed
    assert world.finish(300.0)
    assert world.result().violations == ()
    assert world.result().takes == world.result().completed


def test_killed_while_the_gripper_has_just_opened_it_places_nothing_twice() -> None:
    world = World(small(), 7)
    kills = 0

    def kill(act: Act) -> None:
        nonlocal kills
        if act.deed is Deed.PUT:
            kills += 1
            world.kill()

    world.acted = kill
    world.work(until=60.0, keep_open=1)
    world.run(60.0)
    assert world.finish(300.0)
    assert kills == world.result().puts == world.result().completed > 1
    assert world.result().violations == ()


def hoists_of(world: World) -> dict[VehicleId, object]:
    """Return where the hoists are in truth."""
    hoists = {hoist.id for hoist in world.plant.hoists}
    return {name: place for name, place in world.floor.places(world.now).items() if name in hoists}


def test_nobody_enters_where_a_vehicle_was_pushed_and_switched_off_until_a_person_says_where_it_stands() -> None:
    world = settled(World(plant_of("demo"), 8))
    pushed = world.floor.devices[V1]
    world.kill()
    back = behind(world.plant, pushed.place(world.now)[0], 3)
    pushed.push_to(back, world.now)
    pushed.power_off(world.now)
    world.work(until=90.0, keep_open=6)
    places, takes = hoists_of(world), world.oracle.takes
    world.run(60.0)
    assert hoists_of(world) == places, "the AGVs on their floor may go on"
    ticket = world.ask(ReleaseVehicle(ACTOR, V1, Verdict.STANDS_AT, "I have seen it", back))
    world.run(61.0)
    assert isinstance(world.replies[ticket], Accepted), world.replies[ticket]
    world.run(300.0)
    assert world.oracle.takes > takes
    assert hoists_of(world) != places
    assert world.result().violations == ()


def test_closures_that_are_replanned_beside_the_controller_give_the_same_run_each_time(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("app.fleet.books.Router", partial(Router, inline=-1))

    def ran() -> tuple[str, int, tuple[str, ...]]:
        world = settled(World(plant_of("demo"), 3))
        router = world.control.fleet.books.router
        world.work(until=40.0, keep_open=3)
        somewhere = next(b for b in world.plant.points if not world.control.fleet.books.track.stations_at(b.barcode))
        world.agenda.at(10.0, lambda: router.close(somewhere.barcode))
        world.agenda.at(25.0, lambda: router.open(somewhere.barcode))
        world.run(40.0)
        return world.trace, router.version, world.result().violations

    first = ran()
    assert ran() == first
    assert first[1:] == (3, ())
