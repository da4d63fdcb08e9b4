"""The simulated vehicle on its rail: paths, obstacles, stops, changed paths."""

import pytest

from app.domain.units import Barcode, Seconds
from app.protocols.itsc.messages import (
    Action,
    Code,
    Element,
    Move,
    Oper,
    Xmove,
)
from app.protocols.itsc.simulator import SimulatedVehicle, Track
from tests.scenarios.rig import Rig, edge, make_rig, path, small_track, spec


@pytest.fixture
def rig() -> Rig:
    """A vehicle in AUTO at 1201."""
    return make_rig().ready()


def now(rig: Rig) -> Seconds:
    return Seconds(rig.now)


def test_a_path_may_begin_at_the_next_barcode(rig: Rig) -> None:
    move = rig.move(1202, 1203)
    rig.until(lambda: rig.result(move) == 0)
    assert [(event.seq, event.barcode) for event in rig.events()] == [(0, 1202), (1, 1203)]


def test_a_path_that_begins_elsewhere_is_refused(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1203, 1204))) == 1


def test_a_path_of_one_element_at_the_present_barcode_is_done_at_once(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201))) == 0
    assert rig.status().status1.trav == 1
    assert not rig.events()


def test_a_path_longer_than_the_vehicle_allows_is_refused() -> None:
    vehicle = SimulatedVehicle(spec(max_count=2), small_track(), start=Barcode("1201"))
    rig = Rig(vehicle).ready()
    assert rig.do(Code.MOVE, Move(path(1201, 1202, 1203))) == 1
    move = rig.move(1201, 1202)
    rig.run(0.1)
    xmove = rig.xmove(1, 1202, 1203, 1204)
    rig.until(lambda: rig.result(move) == 0)
    assert rig.result(xmove) == 1


def between_marks(rig: Rig) -> Rig:
    """Stop between 1201 and 1202."""
    rig.move(1201, 1202, 1203)
    rig.run(0.5)
    assert rig.do(Code.STOP_BY_HOST) == 0
    place = rig.vehicle.place(now(rig))
    assert place[0] == "1201"
    assert 200 < place[1] < 600
    assert place[2] == "1202"
    return rig


@pytest.mark.parametrize(
    ("barcodes", "result"), [((1201, 1202), 0), ((1202, 1203), 0), ((1201,), 1), ((1201, 1301), 1)]
)
def test_from_between_two_barcodes_only_the_way_ahead_is_open(rig: Rig, barcodes: tuple[int, ...], result: int) -> None:
    between_marks(rig)
    assert rig.do(Code.MOVE, Move(path(*barcodes))) == result


def test_one_barcode_named_twice_counts_twice_in_one_event(rig: Rig) -> None:
    elements = [*path(1201, 1202), *path(1202, 1203, first=2)]
    elements[1] = Element(1202, 1, 3, Action.RUN, 80)
    move = rig.send(Code.MOVE, Move(elements))
    rig.until(lambda: rig.result(move) == 0)
    assert [(event.seq, event.barcode) for event in rig.events()] == [(2, 1202), (3, 1203)]


def test_a_stop_in_the_middle_of_a_path_is_a_short_stand(rig: Rig) -> None:
    elements = path(1201, 1202, 1203)
    elements[1] = Element(1202, 1, 3, Action.STOP, 80)
    begun = rig.now
    assert rig.do(Code.MOVE, Move(path(1201, 1202, 1203))) == 0
    smooth = rig.now - begun
    rig.vehicle.push_to(Barcode("1201"), now(rig))
    begun = rig.now
    assert rig.do(Code.MOVE, Move(elements)) == 0
    assert rig.now - begun > smooth + 0.5
    assert rig.status().seq == 2


def test_curves_are_taken_at_one_metre_a_second(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1302, 1303, speed=100)
    rig.until(lambda: len(rig.events()) == 1)
    early = rig.vehicle.place(now(rig))
    rig.run(1)
    late = rig.vehicle.place(now(rig))
    assert late[1] - early[1] == pytest.approx(1000)
    rig.until(lambda: rig.result(move) == 0)


def test_a_path_that_leaves_the_rail_ends_in_alarm_101_at_the_wrong_barcode(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1204)
    rig.until(lambda: rig.result(move) == 1)
    status = rig.status()
    assert (status.status2.oper, status.status2.code, status.barcode) == (Oper.ALARM, 101, 1203)
    barcode, past, ahead = rig.vehicle.place(now(rig))
    assert (barcode, ahead) == ("1203", "1204")
    assert past > 0


def test_a_path_beyond_the_end_of_the_rail_ends_in_alarm_101_there(rig: Rig) -> None:
    rig.vehicle.push_to(Barcode("1205"), now(rig))
    move = rig.move(1205, 1206, 1201)
    rig.until(lambda: rig.result(move) == 1)
    assert rig.vehicle.place(now(rig)) == ("1206", 0, None)
    assert rig.status().status2.code == 101


def test_a_vehicle_that_reads_a_wrong_barcode_at_the_end_of_the_rail_rolls_no_farther() -> None:
    rig = make_rig(track=Track([edge("1201", "1202", 3000), edge("1202", "1203", 100)])).ready()
    move = rig.move(1201, 1202, 9999, speed=100)
    rig.until(lambda: rig.result(move) == 1)
    assert rig.vehicle.place(now(rig))[0] == "1203"


def test_a_misread_barcode_ends_a_move_in_alarm_101(rig: Rig) -> None:
    rig.vehicle.misread_next(Barcode("777"))
    move = rig.move(1201, 1202, 1203)
    rig.until(lambda: rig.result(move) == 1)
    assert (rig.answer(move).barcode, rig.answer(move).status2.code) == (777, 101)
    assert rig.vehicle.place(now(rig))[0] == "1202"
    with pytest.raises(ValueError, match="does not fit"):
        rig.vehicle.misread_next(Barcode("x"))


def test_an_obstacle_pauses_a_move_and_its_going_resumes_it(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.vehicle.block_sensor(now(rig))
    rig.run(5)
    status = rig.status()
    assert (status.status2.oper, status.status1.trav) == (Oper.PAUSE, 0)
    xmove = rig.xmove(2, 1203, 1204)
    rig.run(1)
    assert rig.result(xmove) == 1
    rig.vehicle.unblock_sensor(now(rig))
    rig.run(0.1)
    assert rig.status().status1.trav == 8
    rig.until(lambda: rig.result(move) == 0)
    assert rig.status().barcode == 1203


def test_an_obstacle_that_goes_while_braking_costs_only_speed(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.8)
    rig.vehicle.block_sensor(now(rig))
    rig.run(0.2)
    rig.vehicle.unblock_sensor(now(rig))
    rig.until(lambda: rig.result(move) == 0)


def test_an_obstacle_before_a_standing_vehicle_pauses_the_next_move_at_its_place(rig: Rig) -> None:
    rig.vehicle.block_sensor(now(rig))
    move = rig.move(1201, 1202)
    rig.run(5)
    assert rig.status().status2.oper is Oper.PAUSE
    assert rig.vehicle.place(now(rig)) == ("1201", 0, None)
    assert rig.do(Code.STOP_BY_HOST) == 0
    assert rig.result(move) == 1
    rig.vehicle.unblock_sensor(now(rig))
    assert rig.status().status2.oper is Oper.IDLE


def test_an_obstacle_seen_while_a_stop_is_under_way_changes_nothing(rig: Rig) -> None:
    rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.send(Code.STOP_BY_HOST)
    rig.run(0.05)
    rig.vehicle.block_sensor(now(rig))
    rig.vehicle.unblock_sensor(now(rig))
    rig.until(lambda: rig.result(rig.last_id) == 0)


def test_two_stops_are_answered_in_order_after_the_move(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.heard.clear()
    by_host = rig.send(Code.STOP_BY_HOST)
    rig.run(0.05)
    stop = rig.send(Code.STOP)
    xmove = rig.xmove(1, 1202, 1203)
    rig.run(5)
    assert rig.order() == [
        f"ack {by_host}",
        f"ack {stop}",
        f"ack {xmove}",
        f"answer {xmove}",
        f"answer {move}",
        f"answer {by_host}",
        f"answer {stop}",
        "event",
    ]
    assert (rig.result(xmove), rig.result(move)) == (1, 1)


@pytest.mark.parametrize(
    ("first", "barcodes"),
    [(1, (1205, 1206)), (0, (1201,)), (5, (1206,)), (1, (1301, 1302)), (2, (1205, 1206))],
    ids=["not ahead", "nothing new", "gap", "branch passed", "too far"],
)
def test_an_xmove_that_does_not_lead_on_is_refused_and_the_old_path_stays(
    rig: Rig, first: int, barcodes: tuple[int, ...]
) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.9)
    assert rig.vehicle.place(now(rig))[1] > 500
    xmove = rig.xmove(first, *barcodes)
    rig.run(10)
    if (first, barcodes[0]) == (2, 1205):
        assert rig.result(xmove) == 0
        assert rig.answer(move).status2.code == 101
    else:
        assert rig.result(xmove) == 1
        assert (rig.answer(move).result, rig.answer(move).barcode) == (0, 1203)


def test_an_xmove_that_says_the_vehicle_is_elsewhere_is_refused(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.until(lambda: len(rig.events()) == 1)
    xmove = rig.xmove(0, 1201, 1301, 1302, 1303)
    rig.until(lambda: rig.result(move) == 0)
    assert rig.result(xmove) == 1
    assert rig.status().barcode == 1203


def test_an_xmove_may_append_behind_the_stop_which_is_then_a_short_stand(rig: Rig) -> None:
    move = rig.move(1201, 1202)
    rig.run(0.3)
    xmove = rig.xmove(2, 1203)
    rig.until(lambda: rig.result(move) == 0)
    assert rig.result(xmove) == 0
    assert rig.status().barcode == 1203


def test_an_xmove_to_a_stop_nearer_than_the_braking_distance_is_refused(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    while rig.vehicle.place(now(rig))[1] < 1500:
        rig.run(0.01)
    xmove = rig.xmove(1, 1202)
    rig.until(lambda: rig.result(move) is not None)
    assert (rig.result(xmove), rig.result(move)) == (1, 0)


def test_an_xmove_without_a_move_is_refused(rig: Rig) -> None:
    assert rig.do(Code.XMOVE, Xmove(path(1202, first=1))) == 1
