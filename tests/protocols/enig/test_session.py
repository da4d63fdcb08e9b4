import pytest

from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMode,
    AgvMove,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvSetCurrent,
    AgvSpeed,
    AliasName,
    BufferState,
    DeviceAct,
    DeviceBack,
    DeviceCommand,
    DeviceGarbled,
    DeviceId,
    DeviceKind,
    DeviceNumber,
    DeviceReported,
    DeviceSpec,
    DeviceStale,
    DoorState,
    LiftAction,
    LiftState,
    ManualDirection,
    MoveCompleted,
    Steering,
)
from app.domain.units import Seconds
from app.protocols.enig.codec import Codec
from app.protocols.enig.dialects import DEFAULT, DIALECTS, DialectError
from app.protocols.enig.messages import AgvReport, Body, BufferReport, DoorReport, Frame, MoveComplete, Raw, Toward
from app.protocols.enig.session import LinkSession, Timing
from tests.protocols.enig.rig import AGV1, BUFFER1, DOOR, World, specs, tag

CODEC = Codec()
FORWARD = AgvMoveManual(ManualDirection.FORWARD, AgvSpeed.NORMAL)
FOLLOW = AgvMoveAuto(forward=True, steering=Steering.STRAIGHT, speed=AgvSpeed.FAST)


@pytest.fixture
def world() -> World:
    """Everything connected and known, the AGVs in auto."""
    return World(latency=0.02).connect().auto()


class Mute(World):
    """A link on which a test speaks for the devices: they themselves are not on it."""

    def __init__(self, *, places: bool = True) -> None:
        super().__init__(places=places)
        for device in list(self.link.devices.values()):
            device.power_off(self.now)
        self.connect()

    def say(self, number: DeviceNumber, body: Body) -> None:
        """Let a device say something."""
        self.session.received(CODEC.encode(CODEC.packet(number, body), Toward.HOST, strict=False), self.now)
        self._pump()

    def stands(self, at: str = "0001", *, mode: int = 1, **changes: int) -> None:
        """Let AGV1 report that it stands in auto, or what else is said."""
        report = AgvReport(mode=mode, tag=at)
        for name, value in changes.items():
            setattr(report, name, value)
        self.say(AGV1, report)


@pytest.fixture
def mute() -> Mute:
    """A test's own words on the link, AGV1 standing in auto at 0001 to begin with."""
    made = Mute()
    made.stands()
    return made


# Life of the link and of the devices on it


def test_a_device_is_back_with_its_first_status_and_told_of_only_when_something_changes(world: World) -> None:
    assert [event.device for event in world.of(DeviceBack)] == ["AGV1", "AGV2", "BUF1", "DOOR"]
    before = len(world.of(DeviceReported))
    world.wait(5.0)
    assert len(world.of(DeviceReported)) == before
    assert world.session.fresh(DeviceId("AGV1"))
    assert world.session.status_at(DeviceId("AGV1")) == 6.02


def test_a_device_that_falls_silent_is_stale_after_five_seconds_and_what_it_was_asked_is_unknown(world: World) -> None:
    move = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(0.5)
    world.agv.power_off(world.now)
    world.wait(6.0)
    assert world.end(move) == "Unknown: the device reports no more"
    (stale,) = world.of(DeviceStale)
    assert stale == DeviceStale(DeviceId("AGV1"), "no Status for 5 s")
    assert not world.session.fresh(DeviceId("AGV1"))
    assert world.end(world.ask("AGV1", AgvMove(tag("0002")))) == "NotSent: it has not reported for a while"
    world.agv.power_on(world.now)
    world.wait(1.5)
    assert world.of(DeviceBack)[-1].device == "AGV1"
    assert world.status().mode is AgvMode.MANUAL


def test_a_device_that_never_reports_is_stale_once() -> None:
    world = World()
    world.agv2.power_off(world.now)
    world.connect(30.0)
    assert world.of(DeviceStale) == [DeviceStale(DeviceId("AGV2"), "no Status for 5 s")]


def test_a_lost_link_leaves_every_command_unknown_and_every_device_stale(world: World) -> None:
    move = world.ask("AGV1", AgvMove(tag("0002")))
    opening = world.ask("DOOR", DeviceAct.OPEN)
    world.wait(0.1)
    world.cut()
    assert world.end(move) == world.end(opening) == "Unknown: the link was lost"
    assert [event.reason for event in world.of(DeviceStale)] == ["cut"] * 4
    assert world.end(world.ask("DOOR", DeviceAct.OPEN)) == "NotSent: the link is down"
    world.wait(5.0)
    assert world.session.deadline is None
    world.connect()
    assert world.session.link.connections == 2
    assert world.status().arrived


def test_a_line_without_any_valid_packet_is_closed() -> None:
    world = World()
    for device in world.link.devices.values():
        device.power_off(world.now)
    world.connect(14.0)
    assert not world.closing()
    world.wait(1.0)
    assert world.closing()
    assert world.session.deadline is None
    world.session.received(b"\2", world.now)
    world.session.tick(world.now)
    assert world.end(world.ask("DOOR", DeviceAct.OPEN)) == "NotSent: the link is down"
    world.cut()
    assert not world.closing()


def test_a_new_connection_forgets_what_was_half_sent_on_the_old_one(mute: Mute) -> None:
    mute.session.received(b"\2\5", mute.now)
    mute.session.connected(mute.now)
    mute.stands("0002")
    assert mute.status().tag == "0002"
    assert mute.of(DeviceStale)[-1].reason == "connected anew"


def test_half_a_packet_is_given_up_after_a_tenth_of_a_second(mute: Mute) -> None:
    mute.session.received(b"\2\xff\1", mute.now)
    mute.wait(0.11)
    mute.stands("0002")
    (garbled,) = mute.of(DeviceGarbled)
    assert (garbled.device, garbled.reason) == (None, "truncated")
    assert mute.status().tag == "0002"


def test_what_does_not_fit_is_told_and_believed_by_nobody(mute: Mute) -> None:
    mute.say(AGV1, AgvReport(mode=7, tag="0003"))
    mute.say(BUFFER1, BufferReport(9))
    for _ in range(3):
        mute.session.received(CODEC.encode(CODEC.packet(14, MoveComplete("0001")), Toward.HOST), mute.now)
    mute.session.received(CODEC.encode(Frame(AGV1, 99, Raw(b"x")), Toward.HOST, strict=False), mute.now)
    mute.session.received(b"noise", mute.now)
    mute.wait(0.0)
    assert [(event.device, event.reason) for event in mute.of(DeviceGarbled)] == [
        ("AGV1", "unfit packet"),
        ("BUF1", "unfit packet"),
        (None, "foreign device"),
        ("AGV1", "unfit packet"),
        (None, "noise"),
    ]
    assert mute.status().tag == "0001"
    assert mute.session.link.garbled == 5
    assert mute.session.last_frames[-1][1] == "in"


def test_without_a_connection_nothing_is_heard() -> None:
    session = LinkSession(specs(), DEFAULT)
    session.received(b"\2\1", Seconds(0.0))
    session.tick(Seconds(100.0))
    assert session.events() == []
    assert session.deadline is None
    assert not session.up


@pytest.mark.parametrize(
    ("devices", "complaint"),
    [
        ([("X", 21, DeviceKind.AGV)], "X: number 21 is no agv's"),
        ([("X", 40, DeviceKind.DOOR)], "X: number 40 is no door's"),
        ([("X", 11, DeviceKind.AGV), ("Y", 11, DeviceKind.AGV)], "Y: two devices"),
        ([("X", 11, DeviceKind.AGV), ("X", 12, DeviceKind.AGV)], "X: two devices"),
    ],
)
def test_devices_that_do_not_fit_the_dialect_are_refused(
    devices: list[tuple[str, int, DeviceKind]], complaint: str
) -> None:
    with pytest.raises(DialectError, match=complaint):
        LinkSession([DeviceSpec(DeviceId(a), DeviceNumber(b), c) for a, b, c in devices], DEFAULT)


def test_commands_are_sent_in_the_dialect_s_way() -> None:
    for name in ("target", "acs-id", "crc-data-be"):
        world = World(dialect=DIALECTS[name]).connect().auto()
        move = world.ask("AGV1", AgvMove(tag("0002")))
        world.wait(3.0)
        assert world.end(move) == "Done"


def test_what_a_device_cannot_do_is_not_sent(world: World) -> None:
    assert world.end(world.ask("DOOR", AgvMove(tag("0002")))).startswith("NotSent: device 30, CMD 100: unknown command")
    assert world.end(world.ask("AGV1", AgvMove(tag("42")))).startswith("NotSent: device 11, CMD 100: tag")
    assert world.end(world.ask("AGV9", DeviceAct.STOP)) == "NotSent: AGV9 is not on this link"
    assert world.sent == []


# Confirming by Status


def test_a_lost_command_is_sent_again_twice_at_most_and_then_not_accepted(mute: Mute) -> None:
    begun = mute.now
    request = mute.ask("AGV1", AgvMove(tag("0002")))
    for _ in range(8):
        mute.wait(1.0)
        mute.stands()
    assert mute.transmissions((11, 100)) == [begun, begun + 2, begun + 4]
    assert mute.about(request) == [(begun + 6, "NotAccepted")]
    assert mute.end(request) == "NotAccepted: Status shows no effect"
    assert mute.session.link.resends == 2


@pytest.mark.parametrize(
    ("device", "command", "times"),
    [
        ("AGV1", AgvMove(tag("0002")), 3),
        ("AGV1", AgvMoveAlias(AliasName("B1")), 3),
        ("AGV1", AgvSetCurrent(tag("0004")), 3),
        ("AGV1", AgvLift(LiftAction.UP), 3),
        ("AGV1", AgvCharge(on=True), 1),
        ("AGV1", FOLLOW, 1),
        ("DOOR", DeviceAct.OPEN, 3),
        ("DOOR", DeviceAct.CLOSE, 3),
        ("BUF1", DeviceAct.LOCK, 3),
        ("BUF1", DeviceAct.UNLOCK, 3),
    ],
)
def test_only_commands_that_do_no_harm_twice_are_sent_again(
    mute: Mute, device: str, command: DeviceCommand, times: int
) -> None:
    door = DoorState.OPEN if command is DeviceAct.CLOSE else DoorState.CLOSED
    mute.say(DOOR, DoorReport(int(door)))
    mute.say(BUFFER1, BufferReport(0))
    request = mute.ask(device, command)
    for _ in range(8):
        mute.wait(1.0)
        mute.stands()
        mute.say(DOOR, DoorReport(int(door)))
        mute.say(BUFFER1, BufferReport(0))
    assert len(mute.sent) == times
    assert mute.end(request) == "NotAccepted: Status shows no effect"


@pytest.mark.parametrize(
    ("report", "command", "times"),
    [
        (AgvReport(mode=1, run=1, path=1), DeviceAct.STOP, 3),
        (AgvReport(mode=1, run=2), DeviceAct.RESET, 3),
        (AgvReport(mode=1, run=1, path=1), DeviceAct.MARK_STOP, 1),
        (AgvReport(mode=0), FORWARD, 1),
        (AgvReport(mode=1, charge=1), AgvCharge(on=False), 1),
    ],
)
def test_what_stops_or_resets_is_repeated_only_where_twice_is_once(
    mute: Mute, report: AgvReport, command: DeviceCommand, times: int
) -> None:
    mute.say(AGV1, report)
    request = mute.ask("AGV1", command)
    for _ in range(8):
        mute.wait(1.0)
        mute.say(AGV1, report)
    assert len(mute.sent) == times
    assert mute.end(request) == "NotAccepted: Status shows no effect"


def test_a_status_already_on_its_way_confirms_nothing_that_was_so_before(mute: Mute) -> None:
    stop = mute.ask("AGV1", DeviceAct.STOP)
    mute.wait(0.1)
    mute.stands()
    assert mute.end(stop) == ""
    mute.wait(0.3)
    mute.stands()
    assert mute.end(stop) == "Done"


def test_a_stop_behind_an_unseen_move_believes_no_status_of_before(mute: Mute) -> None:
    mute.stands(run=1, path=5)
    move = mute.ask("AGV1", AgvMove(tag("0003")))
    stop = mute.ask("AGV1", DeviceAct.STOP)
    assert mute.end(move) == "Unknown: another command was sent before this one showed its effect"
    mute.stands(path=5, inposition=1)
    assert mute.end(stop) == ""
    mute.wait(0.5)
    mute.stands(path=6)
    assert mute.end(stop) == "Done"
    mute.wait(10.0)
    assert len(mute.transmissions((11, 100))) == 1


def test_a_move_is_not_sent_while_another_or_a_stop_has_not_shown_its_effect(mute: Mute) -> None:
    mute.ask("AGV1", AgvMove(tag("0003")))
    assert mute.end(mute.ask("AGV1", AgvMove(tag("0004")))) == "NotSent: Move is under way"
    mute.ask("AGV1", DeviceAct.STOP)
    assert mute.end(mute.ask("AGV1", AgvMove(tag("0004")))) == "NotSent: Stop is under way"


def test_a_move_without_a_status_since_waits_for_one(mute: Mute) -> None:
    request = mute.ask("AGV1", AgvCharge(on=True))
    mute.wait(4.5)
    assert mute.end(request) == ""
    mute.stands(run=1, path=1)
    assert mute.about(request)[-1][1] == "Taken"


def test_a_charge_without_a_status_since_is_judged_by_the_next_one(mute: Mute) -> None:
    request = mute.ask("AGV1", AgvCharge(on=True))
    mute.wait(3.0)
    mute.stands()
    assert mute.end(request) == "NotAccepted: Status shows no effect"


# Moves


def test_a_running_agv_takes_a_further_goal_and_the_first_move_is_overtaken(mute: Mute) -> None:
    first = mute.ask("AGV1", AgvMove(tag("0002")))
    mute.stands(run=1, path=1)
    second = mute.ask("AGV1", AgvMove(tag("0003")))
    mute.stands(run=1, path=1)
    assert mute.about(second) == []
    mute.stands(run=1, path=2)
    assert mute.end(first) == "Failed: overtaken by Move"
    mute.stands("0002", run=1, path=2)
    mute.stands("0003", inposition=1, path=2)
    assert mute.end(second) == "Done"


def test_a_further_goal_that_is_not_taken_leaves_the_first_move_running(mute: Mute) -> None:
    first = mute.ask("AGV1", AgvMove(tag("0002")))
    mute.stands(run=1, path=1)
    second = mute.ask("AGV1", AgvMove(tag("0003")))
    mute.wait(1.0)
    mute.stands("0002", inposition=1, path=1)
    assert mute.end(first) == "Done"
    assert mute.end(second) == ""
    mute.wait(1.0)
    mute.stands("0002", run=1, path=2)
    mute.stands("0003", inposition=1, path=2)
    assert mute.end(second) == "Done"


def test_an_agv_that_does_not_count_its_paths_is_believed_after_the_transit_time(mute: Mute) -> None:
    mute.stands(run=1)
    request = mute.ask("AGV1", AgvMove(tag("0003")))
    mute.stands("0002", run=1)
    assert mute.about(request) == []
    mute.wait(0.5)
    mute.stands("0002", run=1)
    assert mute.about(request)[-1][1] == "Taken"
    mute.stands("0003", inposition=1)
    assert mute.end(request) == "Done"


def test_a_move_that_ends_at_another_tag_has_failed(mute: Mute) -> None:
    request = mute.ask("AGV1", AgvMoveAlias(AliasName("B1")))
    mute.stands(run=1, path=1)
    mute.stands("0004", inposition=1, path=1)
    assert mute.end(request) == "Failed: it reports to be in position at tag 0004, not 0003"


def test_a_trip_of_which_only_the_end_was_seen_is_known_by_the_path(mute: Mute) -> None:
    unnamed = Mute(places=False)
    unnamed.stands()
    for world, ending in ((mute, "Failed: it reports to be in position at tag 0004, not 0003"), (unnamed, "Done")):
        request = world.ask("AGV1", AgvMoveAlias(AliasName("B1")))
        world.stands("0004", inposition=1, path=1)
        assert world.end(request) == ending


def test_a_move_to_the_present_tag_is_done_at_once_by_its_path_or_later_by_a_fresh_status(mute: Mute) -> None:
    mute.stands(inposition=1, path=3)
    request = mute.ask("AGV1", AgvMove(tag("0001")))
    mute.stands(inposition=1, path=3)
    assert mute.end(request) == ""
    mute.wait(0.5)
    mute.stands(inposition=1, path=3)
    assert mute.end(request) == "Done"
    request = mute.ask("AGV1", AgvMove(tag("0001")))
    mute.stands(inposition=1, path=4)
    assert mute.end(request) == "Done"


def test_a_move_complete_of_an_earlier_move_ends_no_later_one() -> None:
    mute = Mute(places=False)
    mute.stands(run=1, path=1)
    named = mute.ask("AGV1", AgvMoveAlias(AliasName("B1")))
    mute.say(AGV1, MoveComplete("0003"))
    assert mute.end(named) == ""
    mute.stands(run=1, path=2)
    mute.say(AGV1, MoveComplete("0003"))
    assert mute.end(named) == "Done"
    mute.stands("0003", inposition=1, path=2)
    tagged = mute.ask("AGV1", AgvMove(tag("0004")))
    mute.say(AGV1, MoveComplete("0003"))
    mute.say(AGV1, MoveComplete("0004"))
    assert mute.end(tagged) == ""
    mute.wait(0.5)
    mute.say(AGV1, MoveComplete("0004"))
    assert mute.end(tagged) == "Done"
    lift = mute.ask("AGV1", AgvLift(LiftAction.UP))
    mute.say(AGV1, MoveComplete("0004"))
    assert mute.end(lift) == ""
    assert len(mute.of(MoveCompleted)) == 6


def test_an_agv_that_stands_for_two_seconds_out_of_position_will_not_arrive(mute: Mute) -> None:
    request = mute.ask("AGV1", AgvMove(tag("0003")))
    mute.stands(run=1, path=1)
    mute.stands(path=1)
    mute.wait(1.0)
    mute.stands(run=1, path=1)
    mute.stands(path=1)
    mute.wait(1.5)
    mute.stands(path=1)
    assert mute.end(request) == ""
    mute.wait(0.5)
    mute.stands(path=1)
    assert mute.end(request) == "Failed: it stands, last tag 0001"


def test_an_agv_that_is_turned_to_manual_or_breaks_down_on_its_way_has_failed(world: World) -> None:
    move = world.ask("AGV1", AgvMove(tag("0002")))
    world.wait(1.0)
    world.agv.set_mode(AgvMode.MANUAL, world.now)
    world.wait(0.1)
    assert world.end(move) == "Failed: the AGV was turned to manual, last tag 0000"
    move = world.ask("AGV2", AgvMove(tag("0001")))
    world.wait(1.0)
    world.agv2.raise_error(world.now)
    world.wait(0.1)
    assert world.end(move) == "Failed: the AGV reports an error, last tag 0000"


# Other commands of an AGV


def test_manual_driving_is_done_when_the_agv_runs_and_ended_by_a_stop(world: World) -> None:
    assert world.end(world.ask("AGV1", FORWARD)) == "NotSent: the AGV is in auto"
    world.agv.set_mode(AgvMode.MANUAL, world.now)
    world.wait(0.1)
    assert world.end(world.ask("AGV1", FOLLOW)) == "NotSent: the AGV is in manual"
    assert world.end(world.ask("AGV1", AgvCharge(on=True))) == "NotSent: the AGV is in manual"
    request = world.ask("AGV1", FORWARD)
    world.wait(0.1)
    assert world.end(request) == "Done"
    stop = world.ask("AGV1", DeviceAct.STOP)
    world.wait(0.1)
    assert world.end(stop) == "Done"


def test_following_the_tape_is_done_when_it_runs_and_a_mark_stop_when_it_stands(world: World) -> None:
    request = world.ask("AGV1", FOLLOW)
    world.wait(0.1)
    assert world.end(request) == "Done"
    stop = world.ask("AGV1", DeviceAct.MARK_STOP)
    world.wait(0.1)
    assert world.about(stop)[-1][1] == "Taken"
    world.wait(2.0)
    assert world.end(stop) == "Done"
    assert world.status().steering is Steering.MARK_STOP
    again = world.ask("AGV1", DeviceAct.MARK_STOP)
    world.wait(2.0)
    assert world.end(again) == "Done"


def test_the_present_position_can_be_set_where_the_agv_stands(world: World) -> None:
    request = world.ask("AGV1", AgvSetCurrent(tag("0001")))
    world.wait(0.1)
    assert world.end(request) == "Done"
    world.ask("AGV1", AgvMove(tag("0003")))
    world.wait(0.1)
    request = world.ask("AGV1", AgvSetCurrent(tag("0009")))
    world.wait(5.0)
    assert world.end(request) == "NotAccepted: the AGV does not stand still"


def test_a_lift_is_taken_while_it_moves_and_done_at_the_end(world: World) -> None:
    request = world.ask("AGV1", AgvLift(LiftAction.UP))
    world.wait(0.1)
    assert world.about(request)[-1][1] == "Taken"
    assert world.status().lift is LiftState.UNKNOWN
    world.wait(2.0)
    assert world.end(request) == "Done"
    again = world.ask("AGV1", AgvLift(LiftAction.UP))
    world.wait(1.5)
    assert world.end(again) == "Done"


def test_a_lift_that_is_stopped_says_so_by_staying_where_it_is(world: World) -> None:
    up = world.ask("AGV1", AgvLift(LiftAction.UP))
    world.wait(0.5)
    stop = world.ask("AGV1", AgvLift(LiftAction.STOP))
    assert world.end(up) == "Unknown: another command was sent before this one showed its effect"
    world.wait(4.0)
    assert world.end(stop) == "Done"
    assert world.status().lift is LiftState.UNKNOWN
    down = world.ask("AGV1", AgvLift(LiftAction.DOWN))
    world.wait(3.0)
    assert world.end(down) == "Done"
    stop = world.ask("AGV1", AgvLift(LiftAction.STOP))
    world.wait(1.5)
    assert world.end(stop) == "Done"


def test_a_lift_that_comes_back_or_never_ends_has_failed(mute: Mute) -> None:
    request = mute.ask("AGV1", AgvLift(LiftAction.UP))
    mute.stands(lift=2)
    mute.stands(lift=0)
    assert mute.end(request) == "Failed: the lift is down again"
    request = mute.ask("AGV1", AgvLift(LiftAction.UP))
    for _ in range(32):
        mute.stands(lift=2)
        mute.wait(1.0)
    assert mute.end(request) == "Failed: it has not ended within 30 s"


def test_a_lift_that_was_somewhere_before_is_waited_for(mute: Mute) -> None:
    mute.stands(lift=2)
    request = mute.ask("AGV1", AgvLift(LiftAction.UP))
    for _ in range(7):
        mute.wait(1.0)
        mute.stands(lift=2)
    assert mute.about(request)[-1][1] == "Taken"
    mute.stands(lift=1)
    assert mute.end(request) == "Done"


def test_charging_is_taken_on_the_way_and_done_at_the_charger(world: World) -> None:
    request = world.ask("AGV1", AgvCharge(on=True))
    world.wait(0.1)
    assert world.about(request)[-1][1] == "Taken"
    world.wait(5.0)
    assert world.end(request) == "Done"
    assert world.status().charging
    off = world.ask("AGV1", AgvCharge(on=False))
    world.wait(0.1)
    assert world.end(off) == "Done"
    assert not world.status().charging


def test_an_agv_that_breaks_down_or_never_charges_has_failed_to(mute: Mute) -> None:
    request = mute.ask("AGV1", AgvCharge(on=True))
    mute.stands(run=1, path=1)
    mute.stands(run=2, path=1)
    assert mute.end(request) == "Failed: the AGV reports an error"
    mute.stands(path=1)
    request = mute.ask("AGV1", AgvCharge(on=True))
    mute.stands(run=1, path=2)
    for _ in range(11):
        mute.stands("0009", inposition=1, path=2)
        mute.wait(1.0)
    assert mute.end(request) == "Failed: it stands, last tag 0009"


# Buffers and doors


def test_a_lock_waits_for_the_one_before_and_a_busy_buffer_proves_nothing(mute: Mute) -> None:
    mute.say(BUFFER1, BufferReport(2))
    first = mute.ask("BUF1", DeviceAct.LOCK)
    mute.say(BUFFER1, BufferReport(2))
    assert mute.about(first) == []
    assert mute.end(mute.ask("BUF1", DeviceAct.UNLOCK)) == "NotSent: Lock is under way"
    mute.say(BUFFER1, BufferReport(1))
    mute.say(BUFFER1, BufferReport(2))
    assert mute.about(first)[-1][1] == "Taken"
    mute.say(BUFFER1, BufferReport(3))
    assert mute.end(first) == ""
    mute.say(BUFFER1, BufferReport(255))
    assert mute.end(first) == "Failed: the buffer reports an error"


def test_a_buffer_in_error_takes_no_lock(world: World) -> None:
    world.buffer.set_state(BufferState.ERROR, world.now)
    world.wait(0.1)
    request = world.ask("BUF1", DeviceAct.LOCK)
    world.wait(3.0)
    assert world.end(request) == "NotAccepted: it reports an error"


def test_an_obstructed_door_has_failed_to_close(world: World) -> None:
    world.ask("DOOR", DeviceAct.OPEN)
    world.wait(3.0)
    request = world.ask("DOOR", DeviceAct.CLOSE)
    world.wait(1.0)
    world.door.obstruct(world.now)
    world.wait(0.1)
    assert world.end(request) == "Failed: the door reports error"


def test_a_door_that_goes_back_has_failed_to_open(mute: Mute) -> None:
    mute.say(DOOR, DoorReport(0))
    request = mute.ask("DOOR", DeviceAct.OPEN)
    mute.say(DOOR, DoorReport(2))
    mute.say(DOOR, DoorReport(0))
    assert mute.end(request) == "Failed: the door reports closed"


def test_a_closing_door_that_is_to_open_again_is_busy_with_either(mute: Mute) -> None:
    mute.say(DOOR, DoorReport(1))
    closing = mute.ask("DOOR", DeviceAct.CLOSE)
    mute.say(DOOR, DoorReport(2))
    opening = mute.ask("DOOR", DeviceAct.OPEN)
    assert mute.end(closing) == "Unknown: another command was sent before this one showed its effect"
    for _ in range(7):
        mute.wait(1.0)
        mute.say(DOOR, DoorReport(2))
    assert mute.about(opening)[-1][1] == "Taken"
    mute.say(DOOR, DoorReport(1))
    assert mute.end(opening) == "Done"


@pytest.mark.parametrize(("device", "command"), [("AGV1", DeviceAct.STOP), ("DOOR", DeviceAct.OPEN)])
def test_a_stop_and_an_opening_are_sent_even_where_nothing_is_known(device: str, command: DeviceAct) -> None:
    mute = Mute()
    mute.wait(6.0)
    begun = mute.now
    request = mute.ask(device, command)
    assert mute.end(mute.ask("DOOR", DeviceAct.CLOSE)) == "NotSent: it has not reported for a while"
    mute.wait(7.0)
    assert [when - begun for when, _ in mute.sent] == [0.0, 2.0, 4.0]
    assert mute.end(request) == "Unknown: the device reports no more"
    request = mute.ask(device, command)
    mute.say(DOOR, DoorReport(2))
    mute.wait(0.5)
    mute.stands()
    mute.say(DOOR, DoorReport(1))
    assert mute.end(request) == "Done"


def test_the_figures_can_be_set() -> None:
    session = LinkSession(specs("DOOR"), DEFAULT, Timing(silence=Seconds(3.0), stale=Seconds(9.0)))
    session.connected(Seconds(0.0))
    assert session.deadline == 3.0
    session.tick(Seconds(3.0))
    assert session.wants_close
