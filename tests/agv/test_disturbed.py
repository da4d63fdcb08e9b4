"""What goes wrong on an AGV's job, from the controller's side (S51-S60; COMMANDS sections 1 and 3)."""

from app.domain.commands import Plain
from app.domain.devices import AgvMode, AgvRun, LiftState
from app.domain.ids import JobId, StationId
from app.domain.job import JobState
from app.domain.requests import (
    Accepted,
    CommandVehicle,
    CreateJob,
    RecoverAlarm,
    ReleaseVehicle,
    Verdict,
    WriteStation,
)
from app.domain.units import Seconds
from app.fleet.vehicle import Stage
from tests.agv.hall import A1, A2, ANNA, HALL, HOST, HallWorld, hall, tag


def on_job() -> HallWorld:
    """Return a world whose AGV has just been given the job B1 to B5."""
    world = HallWorld()
    world.ready()
    world.order("B1", "B5")
    world.until(lambda: world.agv().report.run == AgvRun.RUN)
    return world


def came_through(world: HallWorld) -> None:
    """The job ends well: one cart taken, one put, nothing repeated."""
    assert world.ends() is JobState.COMPLETED
    result = world.result()
    assert result.violations == ()
    assert (result.takes, result.puts) == (1, 1)
    assert dict(world.floor.truth.at) == {StationId("B5"): "CART1"}


def lifting(world: HallWorld) -> bool:
    return world.agv().report.lift == LiftState.UNKNOWN


def test_a_link_cut_in_the_middle_of_a_move_is_settled_by_status() -> None:
    world = on_job()
    world.cut(HALL)
    world.until(lambda: world.now_of().stage is Stage.ABSENT)
    assert world.now_of().ahead
    came_through(world)


def test_a_link_cut_in_the_middle_of_a_lift_repeats_no_lift() -> None:
    world = on_job()
    world.until(lambda: lifting(world))
    world.cut(HALL)
    came_through(world)


def test_a_lost_move_complete_costs_nothing() -> None:
    """S54: Status with Inposition 1 and RunSt 0 says the same."""
    world = on_job()
    link = world.floor.lines[HALL]
    link.lose("MoveComplete", 100)  # type: ignore[attr-defined]
    came_through(world)


def test_lost_reports_of_tags_only_delay() -> None:
    world = on_job()
    link = world.floor.lines[HALL]
    link.lose("TagReceived", 100)  # type: ignore[attr-defined]
    link.lose("Status", 3)  # type: ignore[attr-defined]
    came_through(world)


def test_an_agv_turned_to_manual_waits_for_the_key() -> None:
    world = on_job()
    world.agv().set_mode(AgvMode.MANUAL, world.now)
    world.until(lambda: world.view().mode == "mant")
    world.pass_by(8.0)
    assert world.agv().report.run == AgvRun.STOP
    assert set(world.control.fleet.books.traffic.held(A1)) >= {tag(2), tag(3)}, "it may be driven there by hand"
    world.agv().set_mode(AgvMode.AUTO, world.now)
    came_through(world)


def test_an_agv_in_error_is_held_until_a_person_resets_it() -> None:
    """S55: what is sent in error is ignored; Reset clears it."""
    world = on_job()
    world.agv().raise_error(world.now)
    world.until(lambda: world.view().activity == "held")
    hold = world.view().hold
    assert hold is not None
    assert "recover" in hold.remedy
    assert isinstance(world.reply(RecoverAlarm(ANNA, A1)), Accepted)
    came_through(world)


def test_a_reset_by_command_leaves_the_release_to_a_person() -> None:
    world = on_job()
    world.agv().raise_error(world.now)
    world.until(lambda: world.view().activity == "held")
    world.reply(CommandVehicle(ANNA, A1, Plain.ALARM_CLEAR))
    world.until(lambda: world.agv().report.run == AgvRun.STOP)
    world.pass_by(5.0)
    assert world.view().activity == "held"
    world.reply(ReleaseVehicle(ANNA, A1, Verdict.GO_ON, "seen"))
    came_through(world)


def test_a_tag_misread_at_the_goal_is_an_error_that_is_held() -> None:
    world = on_job()
    world.until(lambda: world.now_of().barcode == tag(2))
    world.agv().misread_next(tag(4))
    world.until(lambda: world.view().activity == "held")
    world.pass_by(5.0)
    assert "0004" in world.view().hold.reason  # type: ignore[union-attr]
    assert world.oracle.takes == 0


def test_stop_holds_the_agv_and_it_goes_on_from_between_two_tags_once_released() -> None:
    """S53: RunSt 0, no Move Complete, Inposition 0; it stands somewhere before the next tag, which stays its own."""
    world = on_job()
    world.pass_by(1.0)
    world.reply(CommandVehicle(ANNA, A1, Plain.STOP))
    world.until(lambda: world.agv().report.run == AgvRun.STOP)
    world.pass_by(5.0)
    assert world.view().mode == "auto"
    assert world.now_of().toward == tag(2)
    assert set(world.control.fleet.books.traffic.held(A1)) == {tag(3), tag(2)}
    world.reply(ReleaseVehicle(ANNA, A1, Verdict.GO_ON, "free"))
    came_through(world)


def test_an_agv_stopped_between_two_tags_comes_to_the_next_before_it_turns() -> None:
    world = on_job()
    world.pass_by(1.0)
    world.reply(CommandVehicle(ANNA, A1, Plain.STOP_BY_HOST))
    world.pass_by(5.0)
    world.reply(WriteStation(HOST, StationId("B1"), out_of_service="cleaning"))
    world.reply(ReleaseVehicle(ANNA, A1, Verdict.GO_ON, "free"))
    world.until(lambda: world.now_of().fit)
    world.reply(CreateJob(HOST, JobId("J2"), "B5", StationId("B1"), None, 50, "J2"))
    world.until(lambda: world.now_of().barcode in {tag(2), tag(4)} or world.now_of().job is None)
    world.pass_by(20.0)
    assert world.result().violations == ()


def test_an_agv_pushed_by_hand_while_the_server_is_down_is_held_when_it_reads_where_it_is() -> None:
    world = HallWorld(hall(two_way=["1-2-3-4-5-6-7-8-9"], stations=[1, 9], starts=[3], carts=1))
    world.ready()
    world.kill()
    world.agv().push_to(tag(7), world.now)
    world.until(lambda: world.alive)
    world.ready()
    world.order("B1", "B9")
    world.until(lambda: world.view().activity == "held")
    assert "0006" in world.view().hold.reason  # type: ignore[union-attr]
    world.until(lambda: world.agv().report.run != AgvRun.RUN)
    world.pass_by(5.0)
    world.reply(ReleaseVehicle(ANNA, A1, Verdict.GO_ON, "it is there"))
    assert world.ends() is JobState.COMPLETED


def test_an_empty_buffer_fails_the_job_after_the_lift_is_down_again() -> None:
    world = on_job()
    world.floor.truth.remove(StationId("B1"))
    assert world.ends() is JobState.FAILED
    assert world.agv().report.lift == LiftState.DOWN
    assert world.oracle.puts == 0


def test_a_full_destination_lifts_the_cart_again_and_waits_for_a_person() -> None:
    world = on_job()
    world.until(lambda: world.oracle.takes == 1)
    world.floor.truth.install("STRAY", StationId("B5"))  # type: ignore[arg-type]
    world.until(lambda: world.view().activity == "held")
    assert world.agv().report.lift == LiftState.UP
    assert world.view().loaded


def test_power_lost_on_the_way_ends_in_a_known_state() -> None:
    """After power-up an AGV is in manual, at tag 0000: people bring it back (PROTOCOLS 5.3)."""
    world = on_job()
    world.agv().power_off(world.now)
    world.until(lambda: world.now_of().stage is Stage.ABSENT)
    world.agv().power_on(world.now)
    world.until(lambda: world.now_of().linked)
    world.pass_by(5.0)
    assert "reads no barcode" in world.view().waiting


def test_two_agvs_on_one_link_hear_their_own_commands_only() -> None:
    """S59."""
    world = HallWorld(hall(one_way=["1-2-3-4-5-6-1"], stations=[2, 5], starts=[1, 4], carts=1))
    world.ready(A1, A2)
    world.order("B2", "B5", vehicle="A1")
    assert world.ends() is JobState.COMPLETED
    assert world.result().violations == ()


def test_path_255_is_followed_by_1() -> None:
    """S60: the count going round confuses nobody."""
    world = HallWorld()
    world.agv().report.path = 254
    world.ready()
    world.order("B1", "B5")
    came_through(world)
    assert world.agv().report.path < 10


def test_an_agv_that_ignores_what_it_is_told_is_held_for_a_person() -> None:
    """S52, E9: Status without effect is not accepted after its repetitions, and never taken for done."""
    world = HallWorld()
    world.ready()
    world.agv()._obey = lambda body: None  # type: ignore[method-assign]
    world.order("B1", "B5")
    world.until(lambda: world.view().hold is not None, 120.0)
    assert "MOVE" in world.view().hold.reason  # type: ignore[union-attr]


def test_status_a_second_is_enough_to_be_settled() -> None:
    world = HallWorld()
    world.ready()
    assert world.now < Seconds(6.0)
