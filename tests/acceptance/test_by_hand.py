"""What the acceptance asks to be tried by hand, in virtual time."""

from pathlib import Path

import pytest

from app.domain.commands import Plain
from app.domain.errors import PlantHeld, Refusal
from app.domain.ids import CarrierId, JobId, StationId
from app.domain.job import JobState
from app.domain.requests import (
    Accepted,
    CancelJob,
    CommandVehicle,
    CreateJob,
    MoveVehicle,
    RecoverAlarm,
    ReleaseVehicle,
    Verdict,
    WriteCarrier,
)
from app.domain.units import Barcode, Timestamp
from app.protocols.itsc.messages import Code, Mode
from app.sim.world import World
from app.store.ledger import SqlLedger
from tests.acceptance.world import ANNA, V1, V2, Watched

MOVES = (Code.MOVE, Code.XMOVE)


def killed_with_the_lifter_down() -> Watched:
    """Return a world killed at the moment when V001's gripper has closed on the FOUP, far below the rail."""
    world = Watched()
    world.order("P1", "P3")
    device = world.floor.devices[V1]
    world.until(lambda: device.state.foup)
    assert not device.state.all_home
    world.told.clear()
    world.kill()
    return world


def test_killed_while_the_lifter_is_down_no_move_leaves_until_the_axes_are_home() -> None:
    world = killed_with_the_lifter_down()
    device = world.floor.devices[V1]
    while not device.state.all_home:
        world.pass_by(0.05)
        assert world.commands(V1, *MOVES) == []
    world.finish(120.0)
    assert world.commands(V1, *MOVES)
    assert world.commands(V1, Code.PICKUP_FROM_PORT) == []
    assert world.books.jobs["J1"] is JobState.COMPLETED
    assert (world.oracle.takes, world.oracle.puts, world.oracle.violations) == (1, 1, [])


def test_a_pickup_whose_lifter_never_comes_up_waits_for_a_person_and_says_what_is_wrong() -> None:
    world = killed_with_the_lifter_down()
    world.hand(V1).raise_alarm(300, world.now)
    world.pass_by(60.0)
    assert world.told == []
    held = world.control.fleet.books.vehicles[V1]
    assert held.record.hold is not None
    assert "alarm 300" in held.record.hold.reason
    unconfirmed = world.reply(RecoverAlarm(ANNA, V1))
    assert isinstance(unconfirmed, Refusal)
    assert "LIFT" in unconfirmed.reason
    assert isinstance(world.reply(RecoverAlarm(ANNA, V1, confirmed=True)), Accepted)
    assert world.finish(120.0)
    assert (world.oracle.takes, world.oracle.puts, world.oracle.violations) == (1, 1, [])


def pushed_and_switched_off() -> Watched:
    """Return a world in which V002 was pushed back three barcodes, to 113, and switched off while the controller was down.

    V001 is to bring a carrier from P1 (104) to P3 (114), through where V002 stands and where it stood (116).
    """
    world = Watched()
    world.pass_by(5.0)
    world.kill()
    vehicle = world.hand(V2)
    vehicle.panel_mode(Mode.MANT, world.now)
    vehicle.push_to(Barcode("113"), world.now)
    vehicle.power_off(world.now)
    world.until(lambda: world.alive)
    world.order("P1", "P3")
    return world


def test_nobody_moves_where_a_pushed_and_silent_vehicle_may_be_until_a_person_has_decided() -> None:
    world = pushed_and_switched_off()
    world.pass_by(120.0)
    assert world.told == []
    assert not world.oracle.violations
    first = world.control.fleet.books.vehicles[V1]
    assert world.control.fleet.motion.missing(first) == (V2,)


def test_a_vehicle_that_a_person_says_stands_there_keeps_its_stretch_and_the_rest_is_free() -> None:
    world = pushed_and_switched_off()
    world.pass_by(10.0)
    stands = ReleaseVehicle(ANNA, V2, Verdict.STANDS_AT, "seen at 113", Barcode("113"))
    assert isinstance(world.reply(stands), Accepted)
    world.pass_by(120.0)
    assert world.books.jobs["J1"] is JobState.TRANSFERRING
    assert world.floor.devices[V1].place(world.now)[0] in {"108", "109", "110", "111", "112"}
    books = world.control.fleet.books
    assert "V002" in (books.vehicles[V1].waiting or books.jobs[JobId("J1")].reason)
    assert not world.oracle.violations


def test_once_switched_on_and_recovered_it_gives_way_and_the_job_ends() -> None:
    world = pushed_and_switched_off()
    world.pass_by(10.0)
    world.reply(ReleaseVehicle(ANNA, V2, Verdict.STANDS_AT, "seen at 113", Barcode("113")))
    world.hand(V2).power_on(world.now)
    world.until(lambda: world.control.fleet.books.vehicles[V2].linked)
    assert isinstance(world.reply(RecoverAlarm(ANNA, V2, confirmed=True)), Accepted)
    assert world.finish(180.0)
    assert world.books.jobs["J1"] is JobState.COMPLETED
    assert not world.oracle.violations


def test_a_vehicle_that_comes_back_elsewhere_is_held_until_a_person_vouches_for_its_place() -> None:
    world = pushed_and_switched_off()
    vehicle = world.hand(V2)
    vehicle.power_on(world.now)
    vehicle.push_to(Barcode("110"), world.now)
    world.until(lambda: world.control.fleet.books.vehicles[V2].linked)
    world.reply(RecoverAlarm(ANNA, V2, confirmed=True))
    world.pass_by(30.0)
    now = world.control.fleet.books.vehicles[V2]
    assert now.record.hold is not None
    assert "110" in now.record.hold.reason
    assert world.commands(V1, *MOVES) == []
    assert isinstance(world.reply(ReleaseVehicle(ANNA, V2, Verdict.GO_ON, "it stands at 110")), Accepted)
    assert world.finish(180.0)
    assert not world.oracle.violations


def test_a_vehicle_taken_off_the_rail_frees_the_track() -> None:
    world = pushed_and_switched_off()
    world.pass_by(10.0)
    assert isinstance(world.reply(ReleaseVehicle(ANNA, V2, Verdict.OFF_RAIL, "in the workshop")), Accepted)
    world.until(lambda: bool(world.commands(V1, Code.PLACE_TO_PORT)))
    assert world.control.fleet.books.traffic.held(V2) == ()


def test_a_second_controller_on_the_same_plant_is_refused_and_told_who_holds_it(tmp_path: Path) -> None:
    url = f"sqlite:///{tmp_path / 'plant.db'}"
    first = SqlLedger(url, "small", "first on host a, process 1", lambda: Timestamp(0.0))
    try:
        with pytest.raises(PlantHeld, match="first on host a, process 1"):
            SqlLedger(url, "small", "second on host b, process 2", lambda: Timestamp(0.0))
    finally:
        first.close()
    second = SqlLedger(url, "small", "second on host b, process 2", lambda: Timestamp(0.0))
    second.close()


def test_a_killed_controller_leaves_its_jobs_to_the_next_one_in_the_database(tmp_path: Path) -> None:
    ledger = SqlLedger(f"sqlite:///{tmp_path / 'plant.db'}", "small", "test", lambda: Timestamp(0.0))
    world = World(Watched().plant, 3, ledger)
    world.work(until=40.0, keep_open=2)
    for when in (15.0, 22.0, 31.0):
        world.agenda.at(when, world.kill)
    world.run(45.0)
    assert world.finish(300.0)
    assert world.result().violations == ()
    assert world.result().completed == world.result().takes == world.result().puts
    assert StationId("P1") in world.control.fleet.books.stations
    ledger.close()


@pytest.mark.parametrize("killed", [False, True])
def test_a_hoist_that_was_stopped_just_past_a_port_comes_round_to_it(killed: bool) -> None:
    world = Watched()
    world.pass_by(5.0)
    assert isinstance(world.reply(MoveVehicle(ANNA, V1, Barcode("104"))), Accepted)
    device = world.floor.devices[V1]
    world.until(lambda: device.place(world.now)[0] == "104" and not device.state.moving)
    world.pass_by(3.0)
    world.reply(WriteCarrier(ANNA, CarrierId("F9"), "P3"))
    away = CreateJob(ANNA, JobId("J0"), "P3", StationId("P2"), None, 50, "J0", vehicle=V1)
    assert isinstance(world.reply(away), Accepted)
    world.until(lambda: device.place(world.now)[1] > 0)
    assert isinstance(world.reply(CancelJob(ANNA, JobId("J0"))), Accepted)
    assert isinstance(world.reply(CommandVehicle(ANNA, V1, Plain.STOP_BY_HOST)), Accepted)
    world.until(lambda: not device.state.moving)
    at, past, _ = device.place(world.now)
    assert at == "104"
    assert past > 0, "it reports the port, and is past it"
    if killed:
        world.kill()
        world.until(lambda: world.alive)
    world.pass_by(5.0)
    assert isinstance(world.reply(ReleaseVehicle(ANNA, V1, Verdict.GO_ON, "it may go on")), Accepted)
    order = CreateJob(ANNA, JobId("J1"), "P1", StationId("P2"), None, 50, "J1", vehicle=V1)
    assert isinstance(world.reply(order), Accepted)
    world.until(lambda: world.books.jobs["J1"] is JobState.COMPLETED, 300.0)
    assert world.control.fleet.books.vehicles[V1].record.hold is None
    assert (world.oracle.takes, world.oracle.puts, world.oracle.violations) == (1, 1, [])
