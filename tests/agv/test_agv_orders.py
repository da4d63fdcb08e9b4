"""What people ask of an AGV: what it takes, what is refused and why, and who decides what came of it."""

from dataclasses import replace

import pytest

from app.domain.commands import Plain
from app.domain.device_requests import CommandDevice, RaiseEmergency
from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMode,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvRun,
    AgvSetCurrent,
    AgvSpeed,
    AliasName,
    CartState,
    DeviceAct,
    DeviceCommand,
    DeviceId,
    DeviceNumber,
    LiftAction,
    LiftState,
    ManualDirection,
    Steering,
)
from app.domain.errors import Refusal
from app.domain.ids import DevId, JobId, StationId, VehicleId
from app.domain.layout import DoorSpec, Edge, Plant, Point, Station, StationKind, StopAction, VehicleSpec
from app.domain.records import EmergencyKind
from app.domain.requests import (
    Accepted,
    CommandAgv,
    CommandVehicle,
    CreateJob,
    DisplayOnVehicle,
    HandleOnce,
    LockVehicle,
    MoveVehicle,
    PauseController,
    ReleaseVehicle,
    Verdict,
)
from app.domain.units import Barcode, Millimetres
from app.fleet.vehicle import Stage
from tests.agv.hall import A1, A2, ANNA, HALL, HOST, HallWorld, hall, line, tag

FORWARD = AgvMoveManual(ManualDirection.FORWARD, AgvSpeed.SLOW)
FOLLOW = AgvMoveAuto(forward=True, steering=Steering.STRAIGHT, speed=AgvSpeed.SLOW)


HOIST = VehicleId("H1")


def both() -> Plant:
    """Return the line of the hall with a rail beside it: a ring with one port and a hoist."""
    floor = line()
    ring = [Barcode(name) for name in ("701", "702", "703")]
    return replace(
        floor,
        points=(
            *floor.points,
            *(
                Point(b, Millimetres(900_000 + 5000 * i), Millimetres(900_000 + 4000 * (i % 2)))
                for i, b in enumerate(ring)
            ),
        ),
        edges=(*floor.edges, *(Edge(a, b, Millimetres(6000)) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True))),
        stations=(*floor.stations, Station(StationId("P1"), StationKind.PORT, ring[1])),
        vehicles=(*floor.vehicles, VehicleSpec(HOIST, DevId(1), start=ring[0])),
    )


def ready(plant: Plant | None = None) -> HallWorld:
    world = HallWorld(plant)
    world.ready()
    return world


def asked(world: HallWorld, command: DeviceCommand) -> Accepted | Refusal:
    return world.reply(CommandAgv(ANNA, A1, command))


def refused(world: HallWorld, command: DeviceCommand) -> Refusal:
    answer = asked(world, command)
    assert isinstance(answer, Refusal), answer
    return answer


def by_hand(world: HallWorld) -> HallWorld:
    """Turn the AGV to manual, and let the controller hear of it."""
    world.agv().set_mode(AgvMode.MANUAL, world.now)
    world.until(lambda: world.view().mode == "mant")
    world.pass_by(5.0)
    return world


@pytest.mark.parametrize("what", [Plain.SERVO_ON, Plain.SEARCH_HOME, Plain.AUTO, Plain.SYSTEM_RESET])
def test_a_hoists_command_is_refused_by_name(what: Plain) -> None:
    answer = ready().reply(CommandVehicle(ANNA, A1, what))
    assert isinstance(answer, Refusal)
    assert answer.reason == f"A1 is an AGV: {what.value} is a hoist's command"
    assert "changed at the AGV" in answer.remedy


def test_an_agv_has_no_display_and_one_kind_of_stop() -> None:
    world = ready()
    assert isinstance(world.reply(DisplayOnVehicle(ANNA, A1, "HELLO")), Refusal)
    answer = world.reply(MoveVehicle(ANNA, A1, tag(5), StopAction.PORT))
    assert isinstance(answer, Refusal)
    assert answer.field == "action"


def test_a_person_sends_an_agv_to_a_tag_and_has_it_lift() -> None:
    world = ready()
    world.reply(MoveVehicle(ANNA, A1, tag(1)))
    world.until(lambda: world.view().barcode == tag(1) and world.view().agv.in_position)  # type: ignore[union-attr]
    world.pass_by(2.0)
    assert isinstance(world.reply(HandleOnce(ANNA, A1, StationId("B1"), pickup=True)), Accepted)
    world.until(lambda: world.view().carrier == "CART1")
    view = world.view()
    assert view.agv is not None
    assert (view.kind, view.agv.cart, view.agv.lift, view.loaded) == ("agv", "present", "up", True)
    assert (view.status1, view.status2, view.seq, view.code) == (None, None, None, None)
    assert {bit.name for bit in view.bits} >= {"lift", "cart", "last_tag"}
    assert view.address == "HALL, device 11"


def test_a_manual_move_is_for_manual_and_is_followed_by_its_tags() -> None:
    world = ready()
    assert "in auto" in refused(world, FORWARD).reason
    by_hand(world)
    answer = asked(world, FORWARD)
    assert isinstance(answer, Accepted)
    world.until(lambda: world.now_of().barcode in {tag(2), tag(4)})
    assert isinstance(asked(world, DeviceAct.MARK_STOP), Accepted)
    world.until(lambda: world.agv().report.run == AgvRun.STOP)
    assert world.result().violations == ()


def test_a_manual_move_that_leaves_what_the_agv_may_reach_is_stopped() -> None:
    world = ready(hall(one_way=["1-2-3-4-5-6-1"], stations=[2, 5], starts=[1, 3], carts=1))
    by_hand(world)
    assert isinstance(asked(world, FORWARD), Accepted)
    world.until(lambda: world.view().hold is not None)
    assert "could not be moved to" in world.view().hold.reason  # type: ignore[union-attr]
    world.until(lambda: world.agv().report.run == AgvRun.STOP)


def test_what_became_of_a_manual_move_on_a_lost_link_a_person_decides() -> None:
    world = by_hand(ready())
    world.agv()._obey = lambda body: None  # type: ignore[method-assign]
    asked(world, FORWARD)
    world.pass_by(0.5)
    world.cut(HALL)
    world.until(lambda: world.view().hold is not None)
    assert "not known what became of agv_move_manual" in world.view().hold.reason  # type: ignore[union-attr]


def test_following_the_tape_needs_the_floor_for_itself_and_a_person_at_its_end() -> None:
    two = HallWorld(hall(one_way=["1-2-3-4-5-6-1"], stations=[2, 5], starts=[1, 4], carts=1))
    two.ready(A1, A2)
    assert "A2 may be on the same floor" in refused(two, FOLLOW).reason
    world = ready(hall(one_way=["1-2-3-4-5-6-1"], stations=[2, 5], starts=[1], carts=1))
    assert isinstance(asked(world, FOLLOW), Accepted)
    assert set(world.control.fleet.books.traffic.held(A1)) == {tag(n) for n in range(1, 7)}
    world.pass_by(12.0)
    world.reply(CommandVehicle(ANNA, A1, Plain.STOP))
    world.until(lambda: world.agv().report.run == AgvRun.STOP)
    world.pass_by(4.0)
    assert world.view().activity == "held"
    world.reply(ReleaseVehicle(ANNA, A1, Verdict.GO_ON, "it stands"))
    world.until(lambda: world.now_of().fit)
    assert len(world.control.fleet.books.traffic.held(A1)) <= 2
    assert world.result().violations == ()


def test_charging_is_refused_away_from_a_charger() -> None:
    world = ready(hall(two_way=["1-2-3-4-5"], stations=[1, 5], starts=[3], carts=1, chargers=[4]))
    assert "stands at no charger" in refused(world, AgvCharge(on=True)).reason
    world.reply(MoveVehicle(ANNA, A1, tag(4)))
    world.until(lambda: world.view().barcode == tag(4) and world.now_of().at_rest)
    assert isinstance(asked(world, AgvCharge(on=True)), Accepted)
    world.until(lambda: world.view().activity == "charging")
    assert isinstance(asked(world, AgvCharge(on=False)), Accepted)
    world.until(lambda: world.view().activity == "idle")
    assert world.result().violations == ()


def test_an_alias_is_driven_to_over_track_that_is_granted_whole() -> None:
    """S51: Status Inposition 0, RunSt 1; a tag for each on the way; Inposition 1."""
    two = hall(two_way=["1-2-3-4-5", "2-6"], stations=[1, 5], starts=[3, 6], carts=1, chargers=[1])
    world = HallWorld(two)
    world.ready(A1, A2)
    assert refused(world, AgvMoveAlias(AliasName("C9"))).field == "alias"
    answer = asked(world, AgvMoveAlias(AliasName("C1")))
    assert isinstance(answer, Accepted)
    assert set(world.control.fleet.books.traffic.held(A1)) >= {tag(3), tag(2), tag(1)}
    world.until(lambda: world.view().barcode == tag(1) and world.now_of().at_rest)
    assert world.result().violations == ()


def test_an_alias_is_refused_where_another_stands_in_the_way() -> None:
    plant = hall(two_way=["1-2-3-4-5", "2-6"], stations=[1, 5], starts=[3, 1], carts=1, chargers=[1])
    world = HallWorld(plant)
    world.ready(A1, A2)
    assert "not free: 0001 (A2)" in refused(world, AgvMoveAlias(AliasName("C1"))).reason


def test_setting_the_tag_needs_one_of_the_floor_and_is_vouched_for() -> None:
    world = ready()
    assert refused(world, AgvSetCurrent(Barcode("9999"))).field == "tag"
    asked(world, AgvSetCurrent(tag(5)))
    world.until(lambda: world.view().activity == "held")
    world.reply(ReleaseVehicle(ANNA, A1, Verdict.GO_ON, "I put it there"))
    world.until(lambda: world.now_of().fit)
    assert world.now_of().barcode == tag(5)


def test_an_agv_on_a_job_takes_no_lift_command() -> None:
    world = ready()
    world.order("B1", "B5")
    world.until(lambda: world.now_of().job is not None)
    assert "is on job J1" in refused(world, AgvLift(LiftAction.UP)).reason


def test_a_lockout_lets_only_through_what_ends_something() -> None:
    world = ready()
    world.reply(LockVehicle(ANNA, A1, "wheels"))
    assert "locked out by anna" in refused(world, AgvLift(LiftAction.UP)).reason
    assert isinstance(asked(world, AgvLift(LiftAction.STOP)), Accepted)
    assert isinstance(world.reply(CommandVehicle(ANNA, A1, Plain.STOP)), Accepted)


def test_a_cart_that_somebody_put_on_is_called_a_cart_when_it_holds_the_agv() -> None:
    world = ready()
    world.agv().set_cart(CartState.PRESENT, world.now)
    world.run(world.now + 10.0)
    assert "it carries a cart that no job or record accounts for" in world.view().waiting


def test_a_cart_that_it_does_not_know_of_is_settled_before_anything_else() -> None:
    world = ready()
    world.agv().set_cart(CartState.UNKNOWN, world.now)
    world.until(lambda: world.now_of().stage is Stage.SETTLING)
    world.pass_by(5.0)
    assert "does not know whether a cart is on it" in world.view().waiting
    world.agv().set_cart(CartState.NONE, world.now)
    world.until(lambda: world.now_of().fit)


def test_a_lift_stopped_on_its_way_is_named_and_sent_on_by_a_person() -> None:
    world = ready()
    asked(world, AgvLift(LiftAction.UP))
    world.pass_by(1.0)
    asked(world, AgvLift(LiftAction.STOP))
    world.pass_by(6.0)
    assert "lift neither up nor down" in world.view().waiting
    asked(world, AgvLift(LiftAction.DOWN))
    world.until(lambda: world.now_of().fit)
    assert world.agv().report.lift == LiftState.DOWN


def test_a_job_between_a_port_and_a_buffer_is_refused_at_once() -> None:
    world = HallWorld(both())
    world.ready()
    answer = world.order("B1", "P1")
    assert isinstance(answer, Refusal)
    assert answer.reason == "no vehicle serves both B1 (agv_buffer) and P1 (port)"
    wished = world.reply(CreateJob(HOST, JobId("J2"), "B1", StationId("B5"), None, 50, "J2", vehicle=HOIST))
    assert isinstance(wished, Refusal)
    assert "H1 is a hoist" in wished.reason
    handled = world.reply(HandleOnce(ANNA, A1, StationId("P1"), pickup=True))
    assert isinstance(handled, Refusal)
    assert "A1 is an AGV, and does not serve P1" in handled.reason


def test_a_silent_hoist_does_not_keep_agvs_from_moving_nor_an_agv_hoists() -> None:
    world = HallWorld(both())
    world.cut("H1")
    world._cables["H1"].unplug()
    world.ready()
    world.order("B1", "B5")
    world.ends()
    assert world.result().violations == ()


def test_agv_commands_are_not_for_hoists() -> None:
    world = HallWorld(both())
    world.ready()
    answer = world.reply(CommandAgv(ANNA, HOIST, AgvLift(LiftAction.UP)))
    assert isinstance(answer, Refusal)
    assert "is a hoist" in answer.reason


def aliased() -> Plant:
    """Return the line of the hall with a charger ``C1`` at its end, and a door on the way there."""
    plant = hall(two_way=["1-2-3-4-5"], stations=[5], starts=[3], carts=1, chargers=[1])
    door = DoorSpec(DeviceId("DOOR1"), HALL, DeviceNumber(30), frozenset({(tag(2), tag(1))}))
    return replace(plant, doors=(door,))


def test_an_alias_is_refused_while_a_door_on_the_way_is_not_open() -> None:
    world = ready(aliased())
    answer = refused(world, AgvMoveAlias(AliasName("C1")))
    assert answer.reason == "the way to C1 is not free: DOOR1 is closed"
    world.reply(CommandDevice(ANNA, DeviceId("DOOR1"), DeviceAct.OPEN))
    world.pass_by(5.0)
    assert isinstance(asked(world, AgvMoveAlias(AliasName("C1"))), Accepted)
    world.until(lambda: world.view().barcode == tag(1) and world.now_of().at_rest)
    assert world.result().violations == ()


def test_an_alias_is_refused_while_the_controller_is_paused() -> None:
    world = ready(aliased())
    world.reply(PauseController(ANNA, "shift change"))
    assert "paused" in refused(world, AgvMoveAlias(AliasName("C1"))).reason


def test_a_stop_ends_what_was_to_be_driven_after_the_lift() -> None:
    world = ready(hall(two_way=["1-2-3-4-5"], stations=[5], starts=[3], carts=1, chargers=[1]))
    asked(world, AgvLift(LiftAction.UP))
    world.until(lambda: world.agv().report.lift == LiftState.UP and world.now_of().fit)
    assert isinstance(asked(world, AgvMoveAlias(AliasName("C1"))), Accepted)
    world.pass_by(1.0)
    world.reply(CommandVehicle(ANNA, A1, Plain.STOP))
    world.pass_by(30.0)
    assert world.agv().report.tag == tag(3)
    assert world.agv().report.run == AgvRun.STOP


def test_a_stop_ends_a_move_before_the_lift_has_made_it_ready() -> None:
    world = ready(hall(two_way=["1-2-3-4-5"], stations=[5], starts=[3], carts=1))
    asked(world, AgvLift(LiftAction.UP))
    world.until(lambda: world.agv().report.lift == LiftState.UP and world.now_of().fit)
    world.reply(MoveVehicle(ANNA, A1, tag(1)))
    world.pass_by(1.0)
    world.reply(CommandVehicle(ANNA, A1, Plain.STOP))
    world.pass_by(30.0)
    assert world.agv().report.tag == tag(3)
    assert world.view().activity == "held"
    world.reply(ReleaseVehicle(ANNA, A1, Verdict.GO_ON, "seen"))
    world.until(lambda: world.now_of().fit)


def test_a_lockout_stops_an_agv_that_follows_the_tape() -> None:
    world = ready(hall(one_way=["1-2-3-4-5-6-1"], stations=[2, 5], starts=[1], carts=1))
    asked(world, FOLLOW)
    world.until(lambda: world.agv().report.run == AgvRun.RUN)
    world.pass_by(2.0)
    world.reply(LockVehicle(ANNA, A1, "wheels"))
    world.until(lambda: world.agv().report.run == AgvRun.STOP, at_most=5.0)


def test_a_lockout_stops_an_agv_that_is_moved_by_hand() -> None:
    world = by_hand(ready())
    asked(world, FORWARD)
    world.until(lambda: world.agv().report.run == AgvRun.RUN)
    world.pass_by(1.5)
    world.reply(LockVehicle(ANNA, A1, "wheels"))
    world.until(lambda: world.agv().report.run == AgvRun.STOP, at_most=5.0)


def test_in_an_emergency_an_agv_takes_only_what_ends_something() -> None:
    world = ready()
    world.reply(RaiseEmergency(ANNA, EmergencyKind.FIRE, "smoke"))
    assert refused(world, AgvLift(LiftAction.UP)).reason == "nothing moves: fire"
    assert isinstance(asked(world, AgvLift(LiftAction.STOP)), Accepted)
    assert isinstance(world.reply(CommandVehicle(ANNA, A1, Plain.STOP)), Accepted)
