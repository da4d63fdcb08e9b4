import pytest

from app.domain.devices import AgvMode, BufferState, CartState, DeviceNumber, DoorState, Steering
from app.domain.layout import Edge
from app.domain.units import Millimetres, Percent, Seconds
from app.protocols.enig.codec import Codec
from app.protocols.enig.dialects import DEFAULT, DIALECTS
from app.protocols.enig.messages import (
    AgvReport,
    BufferReport,
    Charge,
    Close,
    DoorReport,
    Frame,
    Lift,
    Lock,
    MarkStop,
    Move,
    MoveAlias,
    MoveAuto,
    MoveComplete,
    MoveManual,
    Open,
    Raw,
    Reset,
    SetCurrent,
    Stop,
    TagReceived,
    Toward,
    UnLock,
)
from app.protocols.enig.simulator import (
    Hall,
    SimulatedAgv,
    SimulatedBuffer,
    SimulatedDoor,
    SimulatedLink,
    Tape,
    both_ways,
)
from tests.protocols.enig.rig import AGV1, AGV2, BUFFER1, BUFFER2, DOOR, Host, agv, edge, small_tape, tag

ZERO = Seconds(0.0)


@pytest.fixture
def one() -> SimulatedAgv:
    """An AGV in auto at 0001, which it has not read."""
    made = agv()
    made.set_mode(AgvMode.AUTO, ZERO)
    return made


@pytest.fixture
def host(one: SimulatedAgv) -> Host:
    """A host on a link with that AGV alone, which knows its state."""
    return known(one)


def known(*devices: SimulatedAgv | SimulatedBuffer | SimulatedDoor) -> Host:
    """A host on a link with these devices, which knows their states."""
    made = Host(SimulatedLink(devices))
    made.wait(1.0)
    made.told()
    return made


# Reports


def test_a_device_reports_each_second_and_on_every_change() -> None:
    one = agv()
    host = Host(SimulatedLink([one]))
    host.wait(2.5)
    one.set_cart(CartState.PRESENT, host.now)
    host.wait(1.0)
    assert [(when, body) for when, _, body in host.heard] == [
        (1.0, AgvReport()),
        (2.0, AgvReport()),
        (2.5, AgvReport(cart=1)),
        (3.0, AgvReport(cart=1)),
    ]


def test_the_start_up_state_is_the_specification_s(host: Host) -> None:
    assert agv().report == AgvReport(0, 0, 0, 0, 0, 0, 0, "0000", 0)


def test_a_device_lives_on_without_a_connection_and_says_nothing_of_it_later(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Move("0002"))
    host.link.disconnected(host.now)
    host.wait(5.0)
    host.raw(b"\2")
    host.link.connected(host.now)
    host.told()
    host.wait(1.0)
    assert host.story() == ["SI 0002/1"]


def test_a_device_without_power_is_silent_and_comes_back_in_its_start_up_state(host: Host, one: SimulatedAgv) -> None:
    one.set_cart(CartState.PRESENT, host.now)
    host.send(AGV1, Move("0002"))
    host.wait(1.0)
    host.told()
    one.power_off(host.now)
    one.set_cart(CartState.NONE, host.now)
    host.send(AGV1, Stop())
    host.wait(3.0)
    assert host.told() == []
    assert one.place(host.now) == ("0001", 500.0, "0002")
    one.power_on(host.now)
    host.wait(1.0)
    assert host.told() == [AgvReport()]


# What is met with silence


def test_a_packet_that_is_broken_foreign_or_makes_no_sense_is_met_with_silence(host: Host, one: SimulatedAgv) -> None:
    codec = Codec()
    sound = codec.encode(codec.packet(AGV1, Move("0002")), Toward.DEVICE)
    for data in (
        sound[:-2] + bytes([sound[-2] ^ 1]) + sound[-1:],
        codec.encode(Frame(AGV1, 100, Raw(b"002")), Toward.DEVICE, strict=False),
        codec.encode(codec.packet(AGV1, Lift(3)), Toward.DEVICE, strict=False),
        codec.encode(Frame(AGV1, 100, Move("0002"), AGV2), Toward.DEVICE, strict=False),
        codec.encode(codec.packet(AGV2, Move("0002")), Toward.DEVICE),
        codec.encode(codec.packet(DeviceNumber(40), Move("0002")), Toward.DEVICE, strict=False),
        codec.encode(Frame(AGV1, 3, Raw(bytes(12))), Toward.DEVICE, strict=False),
    ):
        host.raw(data)
    host.wait(1.0)
    assert host.told() == []
    host.raw(sound[:5])
    host.wait(0.2)
    host.raw(sound)
    assert host.story() == ["R 0000/1"]


def test_a_packet_behind_a_false_head_is_heard_after_a_silence(host: Host) -> None:
    codec = Codec()
    host.raw(b"\2\xff" + codec.encode(codec.packet(AGV1, Move("0002")), Toward.DEVICE))
    assert host.story() == []
    host.wait(0.11)
    assert host.story() == ["R 0000/1"]


@pytest.mark.parametrize(("dialect", "sent", "heard"), [("target", "target", 1), ("target", "default", 0)])
def test_a_device_that_wants_its_target_byte_does_nothing_without(dialect: str, sent: str, heard: int) -> None:
    one = agv()
    one.set_mode(AgvMode.AUTO, ZERO)
    host = Host(SimulatedLink([one], DIALECTS[dialect], strict_target=True), DIALECTS[sent])
    host.send(AGV1, Move("0002"))
    assert one.report.run == heard
    host.send(AGV1, Stop())
    assert one.report.run == 0


def test_a_device_without_target_reads_one_anyway_unless_it_is_strict(one: SimulatedAgv) -> None:
    host = Host(SimulatedLink([one], DEFAULT, strict_target=True), DIALECTS["target"])
    host.send(AGV1, Move("0002"))
    assert one.report.run == 0
    Host(SimulatedLink([one], DEFAULT), DIALECTS["target"]).send(AGV1, Move("0002"))
    assert one.report.run == 1


def test_two_devices_of_one_number_cannot_share_a_link() -> None:
    with pytest.raises(ValueError, match="two devices have the number 11"):
        SimulatedLink([agv(), agv()])


def test_a_link_without_devices_has_nothing_to_do() -> None:
    link = SimulatedLink([])
    assert link.deadline is None
    assert not link.wants_close


# Moving


def test_a_move_to_the_present_tag_is_complete_at_once(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Move("0001"))
    assert host.story() == ["TagReceived 0001", "SI 0001/1", "MoveComplete 0001"]
    host.send(AGV1, Move("0001"))
    assert host.story() == ["SI 0001/2", "MoveComplete 0001"]


def test_an_agv_that_was_told_a_wrong_place_believes_it(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, SetCurrent("0003"))
    assert host.story() == ["S 0003/0"]
    host.send(AGV1, Move("0003"))
    assert host.story() == ["SI 0003/1", "MoveComplete 0003"]
    assert one.place(host.now) == ("0001", 0.0, None)


def test_a_new_destination_replaces_the_one_under_way(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Move("0002"))
    host.wait(1.0)
    host.send(AGV1, Move("0003"))
    host.wait(3.5)
    assert host.story() == [
        "R 0000/1",
        "R 0000/2",
        "TagReceived 0002",
        "R 0002/2",
        "TagReceived 0003",
        "SI 0003/2",
        "MoveComplete 0003",
    ]
    host.send(AGV1, SetCurrent("0003"))
    host.send(AGV1, Move("0004"))
    host.send(AGV1, SetCurrent("0009"))
    assert one.last_ignored == "it does not stand still"


def test_an_unknown_destination_leaves_an_agv_on_its_way(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Move("0002"))
    for nowhere in (Move("0077"), MoveAlias("E1")):
        host.send(AGV1, nowhere)
        assert one.last_ignored == "the destination is unknown"
    host.wait(2.0)
    assert host.story()[-1] == "MoveComplete 0002"


def test_an_agv_stopped_between_two_tags_goes_on_from_there(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Move("0002"))
    host.wait(1.0)
    host.send(AGV1, Stop())
    assert one.place(host.now) == ("0001", 500.0, "0002")
    host.send(AGV1, Move("0002"))
    host.wait(0.5)
    assert one.place(host.now) == ("0001", 750.0, "0002")
    host.wait(0.5)
    assert host.story()[-1] == "MoveComplete 0002"


def test_on_two_way_tape_an_agv_may_turn_back_between_two_tags() -> None:
    one = agv(tape=Tape(both_ways([edge("0001", "0002"), edge("0002", "0003")])))
    one.set_mode(AgvMode.AUTO, ZERO)
    host = known(one)
    host.send(AGV1, Move("0003"))
    host.wait(0.5)
    host.send(AGV1, Move("0001"))
    host.wait(0.6)
    assert host.story()[-2:] == ["SI 0001/2", "MoveComplete 0001"]


def test_speed_limits_and_distances_make_the_time_of_a_trip() -> None:
    slow = Edge(tag("0001"), tag("0002"), Millimetres(1000), speed=Percent(50))
    one = agv(tape=Tape([slow]))
    one.set_mode(AgvMode.AUTO, ZERO)
    host = known(one)
    host.send(AGV1, Move("0002"))
    host.wait(3.9)
    assert host.story() == ["R 0000/1"]
    host.wait(0.2)
    assert host.story()[-1] == "MoveComplete 0002"


def test_a_mark_stop_ends_a_drive_at_the_next_mark(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, MarkStop())
    assert one.last_ignored == "it does not run"
    host.send(AGV1, Move("0003"))
    host.wait(1.0)
    host.send(AGV1, MarkStop())
    host.wait(3.0)
    assert host.told()[-2:] == [
        TagReceived("0002"),
        AgvReport(mode=1, run=0, direction=Steering.MARK_STOP, tag="0002", path=1),
    ]


def test_a_mark_stop_at_the_destination_is_an_arrival(host: Host) -> None:
    host.send(AGV1, Move("0002"))
    host.send(AGV1, MarkStop())
    host.wait(3.0)
    assert host.story()[-2:] == ["SI 0002/1", "MoveComplete 0002"]


def test_an_agv_that_does_not_find_its_destination_stops_in_error(host: Host, one: SimulatedAgv) -> None:
    one.misread_next(tag("0077"))
    host.send(AGV1, Move("0002"))
    host.wait(3.0)
    assert host.story()[-2:] == ["TagReceived 0077", "E 0077/1"]
    host.send(AGV1, Reset())
    one.miss_next()
    host.send(AGV1, Move("0004"))
    host.wait(2.0)
    assert "TagReceived 0003" not in host.story()
    host.wait(2.0)
    assert host.story()[-1] == "MoveComplete 0004"


def test_a_person_at_the_agv_stops_it_by_the_key_by_an_error_or_by_pushing_it(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Move("0003"))
    one.set_mode(AgvMode.MANUAL, host.now)
    one.set_mode(AgvMode.MANUAL, host.now)
    host.wait(0.0)
    assert host.story() == ["R 0000/1", "S 0000/1"]
    one.raise_error(host.now)
    host.send(AGV1, Stop())
    host.send(AGV1, MoveManual(1, 1))
    assert one.last_ignored == "it is in error"
    assert one.report.run == 2
    host.send(AGV1, Reset())
    host.send(AGV1, Reset())
    assert one.last_ignored == "there is no error"
    one.push_to(tag("0004"), host.now)
    assert one.place(host.now) == ("0004", 0.0, None)
    with pytest.raises(ValueError, match="0077 is no tag"):
        one.push_to(tag("0077"), host.now)


def test_a_manual_drive_goes_on_until_it_is_stopped_and_can_turn_back(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, MoveManual(1, 1))
    assert one.last_ignored == "it is not in manual"
    one.set_mode(AgvMode.MANUAL, host.now)
    host.send(AGV1, MoveManual(1, 2))
    host.wait(1.5)
    assert one.place(host.now) == ("0002", 500.0, "0003")
    host.send(AGV1, MoveManual(0, 0))
    host.wait(1.0)
    assert one.place(host.now) == ("0003", 700.0, "0002")
    host.wait(2.0)
    assert one.place(host.now)[0] == "0002"
    assert one.place(host.now)[2] == "0001"
    host.send(AGV1, MoveManual(3, 0))
    host.send(AGV1, MarkStop())
    host.wait(5.0)
    assert (one.report.run, one.report.direction) == (1, 3)
    host.send(AGV1, Stop())
    assert one.report.run == 0


def test_a_move_from_where_it_was_driven_backwards_goes_forwards_again(host: Host, one: SimulatedAgv) -> None:
    one.push_to(tag("0003"), host.now)
    one.set_mode(AgvMode.MANUAL, host.now)
    host.send(AGV1, MoveManual(0, 1))
    host.wait(1.0)
    one.set_mode(AgvMode.AUTO, host.now)
    host.send(AGV1, Move("0003"))
    host.wait(1.1)
    assert host.story()[-1] == "MoveComplete 0003"


def test_the_tape_s_end_stops_a_person_s_drive_and_is_an_error_for_an_automatic_one() -> None:
    tape = Tape([edge("0001", "0002")])
    one = agv(tape=tape)
    host = known(one)
    host.send(AGV1, MoveManual(1, 2))
    host.wait(2.0)
    assert host.story()[-2:] == ["TagReceived 0002", "S 0002/0"]
    one.set_mode(AgvMode.AUTO, host.now)
    host.send(AGV1, MoveAuto(1, 0, 0))
    assert host.story()[-1] == "E 0002/0"
    host.send(AGV1, Reset())
    host.send(AGV1, MoveAuto(0, 0, 2))
    host.wait(2.0)
    assert host.story()[-1] == "E 0001/0"


def test_following_the_tape_steers_as_it_is_told(one: SimulatedAgv, host: Host) -> None:
    host.send(AGV1, MoveAuto(1, 0, 2))
    host.wait(3.5)
    assert one.place(host.now)[2] == "0001"
    tape = Tape(
        [edge("0001", "0002"), edge("0002", "0003"), edge("0002", "0004")],
        turns={(tag("0002"), tag("0003")): Steering.LEFT, (tag("0002"), tag("0004")): Steering.RIGHT},
    )
    for magnet, ahead in ((1, "0003"), (2, "0004"), (0, "0003")):
        two = agv(tape=tape)
        two.set_mode(AgvMode.AUTO, ZERO)
        other = known(two)
        other.send(AGV1, MoveAuto(1, magnet, 1))
        assert two.report.direction == magnet
        other.wait(2.5)
        assert two.place(other.now)[2] == ahead
    host.send(AGV1, MoveAuto(1, 0, 1))
    one.set_mode(AgvMode.MANUAL, host.now)
    host.send(AGV1, MoveAuto(1, 0, 1))
    assert one.last_ignored == "it is not in auto"


@pytest.mark.parametrize("start", ["0077", "12345"])
def test_an_agv_stands_on_a_tag_of_its_tape_and_all_are_four_characters(start: str) -> None:
    tape = Tape([edge("0001", "12345")])
    with pytest.raises(ValueError, match="is no tag"):
        SimulatedAgv(AGV1, small_tape(), tag(start))
    with pytest.raises(ValueError, match="is no TagID"):
        SimulatedAgv(AGV1, tape, tag("0001"))


# Lift, charge, carts


def test_a_lift_says_unknown_while_it_moves_and_where_it_was_stopped(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Lift(1))
    host.wait(1.0)
    host.send(AGV1, Lift(1))
    host.wait(0.5)
    assert one.report.lift == 2
    host.wait(0.5)
    assert one.report.lift == 1
    host.send(AGV1, Lift(1))
    assert one.report.lift == 1
    host.send(AGV1, Lift(2))
    host.wait(1.0)
    host.send(AGV1, Lift(0))
    host.wait(5.0)
    assert one.report.lift == 2
    host.send(AGV1, Lift(0))
    host.send(AGV1, Lift(2))
    host.wait(1.0)
    host.send(AGV1, Lift(1))
    host.wait(2.0)
    assert one.report.lift == 1


def test_a_charge_drives_to_the_nearest_charger_and_a_move_ends_it(host: Host, one: SimulatedAgv) -> None:
    host.send(AGV1, Charge(1))
    host.send(AGV1, Charge(1))
    assert one.last_ignored == "it does not stand still"
    host.wait(5.0)
    assert host.story()[-3:] == ["SI 0009/1", "MoveComplete 0009", "SI 0009/1"]
    assert one.report.charge == 1
    host.send(AGV1, Move("0002"))
    assert [body.charge for body in host.told() if isinstance(body, AgvReport)] == [0, 0]
    host.wait(2.0)
    host.send(AGV1, Charge(1))
    host.send(AGV1, Charge(0))
    host.wait(3.0)
    assert (one.report.tag, one.report.charge) == ("0009", 0)
    host.send(AGV1, Charge(0))


def test_without_a_charger_in_reach_or_in_manual_a_charge_is_ignored() -> None:
    one = agv(tape=Tape([edge("0001", "0002")], chargers=[tag("0077")]))
    host = known(one)
    host.send(AGV1, Charge(1))
    assert one.last_ignored == "it is not in auto"
    one.set_mode(AgvMode.AUTO, host.now)
    host.send(AGV1, Charge(1))
    assert one.last_ignored == "the destination is unknown"
    one.take(Lock(), host.now)
    assert one.last_ignored == "an AGV does not do this"


def test_a_lift_takes_a_cart_out_of_one_buffer_and_leaves_it_in_another() -> None:
    here, there = SimulatedBuffer(BUFFER1, cart=True), SimulatedBuffer(BUFFER2)
    one = agv(hall=Hall(buffers={tag("0001"): here, tag("0003"): there}))
    one.set_mode(AgvMode.AUTO, ZERO)
    host = known(one, here, there)
    host.send(AGV1, Lift(1))
    host.wait(2.5)
    assert (one.report.cart, here.cart) == (1, False)
    assert BufferReport(0) in host.told()
    host.send(AGV1, Move("0003"))
    host.send(AGV1, Lift(2))
    host.wait(2.5)
    assert one.report.cart == 1
    host.wait(2.0)
    for action, cart, left in ((1, 1, False), (2, 0, True)):
        host.send(AGV1, Lift(action))
        host.wait(2.5)
        assert (one.report.cart, there.cart) == (cart, left)
    host.send(AGV1, Move("0004"))
    host.wait(3.0)
    for action in (1, 2):
        host.send(AGV1, Lift(action))
        host.wait(2.5)
        assert one.report.cart == 0


def test_a_full_buffer_takes_no_second_cart() -> None:
    full = SimulatedBuffer(BUFFER1, cart=True)
    one = agv(hall=Hall(buffers={tag("0001"): full}))
    one.set_cart(CartState.PRESENT, ZERO)
    host = known(one, full)
    for action in (1, 2):
        host.send(AGV1, Lift(action))
        host.wait(2.5)
        assert (one.report.cart, full.cart) == (1, True)


def test_a_closed_door_stops_an_agv_in_error_before_it(one: SimulatedAgv) -> None:
    door = SimulatedDoor(DOOR)
    two = agv(hall=Hall({(tag("0003"), tag("0002")): door}))
    two.set_mode(AgvMode.AUTO, ZERO)
    host = known(two, door)
    host.send(AGV1, Move("0003"))
    host.wait(5.0)
    assert (two.report.run, two.report.tag) == (2, "0002")


# Buffers and doors


def test_a_buffer_shows_its_cart_unless_it_is_busy_or_in_error() -> None:
    buffer = SimulatedBuffer(BUFFER1)
    host = known(buffer)
    buffer.set_cart(host.now, cart=True)
    host.wait(0.0)
    assert host.told() == [BufferReport(1)]
    host.send(BUFFER1, Lock())
    buffer.set_cart(host.now, cart=False)
    host.send(BUFFER1, UnLock())
    host.wait(1.0)
    assert host.told() == [BufferReport(2), BufferReport(0)]
    assert not buffer.locked
    host.send(BUFFER1, Lock())
    buffer.set_state(BufferState.ERROR, host.now)
    host.send(BUFFER1, Lock())
    host.wait(3.0)
    assert host.told() == [BufferReport(2), BufferReport(255)]
    buffer.set_cart(host.now, cart=True)
    buffer.set_state(BufferState.CART, host.now)
    host.wait(0.0)
    assert host.told() == [BufferReport(1)]
    host.send(BUFFER1, Lock())
    buffer.power_off(host.now)
    buffer.power_on(host.now)
    host.wait(2.0)
    assert host.told() == [BufferReport(2), BufferReport(1)]
    buffer.take(Stop(), host.now)
    assert buffer.state is BufferState.CART


def test_a_door_is_busy_both_ways_and_in_error_while_something_is_in_its_way() -> None:
    door = SimulatedDoor(DOOR)
    host = known(door)
    host.send(DOOR, Open())
    host.wait(1.5)
    host.send(DOOR, Open())
    host.wait(0.5)
    assert host.told() == [DoorReport(2), DoorReport(1)]
    host.send(DOOR, Close())
    host.wait(1.0)
    host.send(DOOR, Open())
    host.wait(1.5)
    assert host.told() == [DoorReport(2)]
    host.wait(0.5)
    assert door.is_open
    host.send(DOOR, Close())
    door.obstruct(host.now)
    host.wait(3.0)
    assert host.told()[-1] == DoorReport(255)
    host.send(DOOR, Close())
    host.wait(2.0)
    assert host.told() == [DoorReport(2), DoorReport(255)]
    door.clear(host.now)
    host.send(DOOR, Close())
    host.wait(2.0)
    assert host.told() == [DoorReport(2), DoorReport(0)]
    door.take(Stop(), host.now)
    assert door.state is DoorState.CLOSED


def test_a_door_that_lost_its_power_on_the_way_does_not_know_where_it_is() -> None:
    door = SimulatedDoor(DOOR)
    host = known(door)
    door.power_off(host.now)
    door.power_on(host.now)
    assert door.state is DoorState.CLOSED
    host.send(DOOR, Open())
    door.power_off(host.now)
    door.power_on(host.now)
    host.wait(1.0)
    assert host.told()[-1] == DoorReport(3)


def test_lost_packets_are_lost_and_no_more(host: Host) -> None:
    host.link.lose("MoveComplete")
    host.send(AGV1, Move("0001"))
    host.send(AGV1, Move("0001"))
    assert [body for body in host.told() if isinstance(body, MoveComplete)] == [MoveComplete("0001")]
