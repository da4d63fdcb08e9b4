"""PROTOCOLS section 8, S20 to S26: PICKUP and PLACE, every axis at each step."""

import pytest

from app.domain.layout import Axis, StationKind
from app.domain.units import Barcode, Seconds
from app.protocols.itsc.messages import Action, Body, Code, Oper, Sbuf, Status1
from app.protocols.itsc.simulator import Places
from tests.scenarios.rig import PORT, Rig

AXES = ("foup", "shft", "rota", "lift", "slid", "grip", "sftb")


def at_stop(rig: Rig, action: Action) -> Rig:
    """Bring the vehicle to a stop of a kind at 1202."""
    move = rig.move(1201, 1202, stop=action)
    rig.until(lambda: rig.result(move) == 0)
    rig.heard.clear()
    return rig


def watch(rig: Rig, code: Code, body: Body, steps: int) -> tuple[int | None, list[str], list[bool]]:
    """Carry out a transfer, asking STATUS in the middle of each step and after it; return RESULT, axes and H."""
    cmd_id = rig.send(code, body)
    seen, home = [], []
    rig.run(0.005)
    begun = rig.now
    for step in range(steps):
        rig.run(begun + 0.5 * step + 0.25 - rig.now)
        answer = rig.status()
        seen.append(show(answer.status1))
        home.append(answer.status2.all_home)
        assert answer.status2.oper is Oper.RUN
    rig.run(1)
    seen.append(show(rig.status().status1))
    home.append(rig.status().status2.all_home)
    return rig.result(cmd_id), seen, home


def show(status: Status1) -> str:
    """F, SHFT, ROTA, LIFT, SLID, GRIP, SFTB as digits."""
    return "".join(str(int(getattr(status, axis))) for axis in AXES)


def test_s20_pickup_from_a_port_drives_each_axis_in_turn_and_ends_loaded(rig: Rig) -> None:
    at_stop(rig, Action.STOP_PORT)
    result, seen, home = watch(rig, Code.PICKUP_FROM_PORT, PORT, 10)
    assert result == 0
    assert seen == [
        "0111138",
        "0811133",
        "0081133",
        "0001183",
        "0008113",
        "0000183",
        "1008133",
        "1081133",
        "1811133",
        "1111138",
        "1111134",
    ]
    assert home == [True] + [False] * 8 + [True, True]


def test_pickup_brings_the_axes_to_the_target_pulses(rig: Rig) -> None:
    at_stop(rig, Action.STOP_PORT)
    rig.send(Code.PICKUP_FROM_PORT, PORT)
    rig.run(3)
    assert rig.vehicle.state.pulses == {Axis.SHFT: -1520, Axis.ROTA: 900, Axis.LIFT: 1_170_000}
    rig.run(3)
    assert set(rig.vehicle.state.pulses.values()) == {0}


def test_s21_pickup_with_a_foup_aboard_is_refused_and_nothing_moves(rig: Rig) -> None:
    at_stop(rig, Action.STOP_PORT).vehicle.insert_foup(Seconds(rig.now))
    assert rig.do(Code.PICKUP_FROM_PORT, PORT) == 1
    rig.run(5)
    assert show(rig.status().status1) == "1111134"


def test_s22_place_to_a_port_ends_empty_with_the_gripper_closed(rig: Rig) -> None:
    at_stop(rig, Action.STOP_PORT).vehicle.insert_foup(Seconds(rig.now))
    result, seen, home = watch(rig, Code.PLACE_TO_PORT, PORT, 10)
    assert result == 0
    assert seen == [
        "1111138",
        "1811133",
        "1081133",
        "1008133",
        "1000183",
        "0008113",
        "0001183",
        "0081133",
        "0811133",
        "0111138",
        "0111134",
    ]
    assert home == [True] + [False] * 8 + [True, True]


def test_s23_place_without_a_foup_is_refused(rig: Rig) -> None:
    at_stop(rig, Action.STOP_PORT)
    assert rig.do(Code.PLACE_TO_PORT, PORT) == 1


@pytest.mark.parametrize("stop", [Action.STOP, Action.STOP_SBFL, Action.STOP_SBFR])
def test_s24_pickup_from_a_port_anywhere_but_at_a_port_stop_is_refused(rig: Rig, stop: Action) -> None:
    assert rig.do(Code.PICKUP_FROM_PORT, PORT) == 1
    at_stop(rig, stop)
    assert rig.do(Code.PICKUP_FROM_PORT, PORT) == 1


def test_s25_pickup_from_the_left_side_buffer_slides_left_and_back(rig: Rig) -> None:
    at_stop(rig, Action.STOP_SBFL)
    result, seen, home = watch(rig, Code.PICKUP_FROM_SBFL, Sbuf(50), 8)
    assert result == 0
    assert seen == ["0111138", "0111833", "0111583", "0118513", "0110583", "1118533", "1111833", "1111138", "1111134"]
    assert home == [True] + [False] * 6 + [True, True]


def test_place_to_the_right_side_buffer_slides_right_and_back(rig: Rig) -> None:
    at_stop(rig, Action.STOP_SBFR).vehicle.insert_foup(Seconds(rig.now))
    result, seen, _ = watch(rig, Code.PLACE_TO_SBFR, Sbuf(50), 8)
    assert result == 0
    assert seen == ["1111138", "1111833", "1118633", "1110683", "0118613", "0111683", "0111833", "0111138", "0111134"]


def test_s26_pickup_from_the_other_side_is_refused(rig: Rig) -> None:
    at_stop(rig, Action.STOP_SBFL)
    assert rig.do(Code.PICKUP_FROM_SBFR, Sbuf(50)) == 1


def test_a_pickup_that_finds_no_foup_goes_home_and_ends_in_alarm_201(rig: Rig, places: Places) -> None:
    places.empty(Barcode("1202"), StationKind.PORT)
    at_stop(rig, Action.STOP_PORT)
    result, seen, _ = watch(rig, Code.PICKUP_FROM_PORT, PORT, 10)
    assert result == 1
    assert seen[-1] == "0111134"
    status = rig.status().status2
    assert (status.oper, status.code) == (Oper.ALARM, 201)


def test_a_place_that_is_taken_keeps_the_foup_aboard_and_ends_in_alarm_203(rig: Rig, places: Places) -> None:
    places.fill(Barcode("1202"), StationKind.PORT)
    at_stop(rig, Action.STOP_PORT).vehicle.insert_foup(Seconds(rig.now))
    assert rig.do(Code.PLACE_TO_PORT, PORT) == 1
    status = rig.status()
    assert (status.status1.foup, status.status2.oper, status.status2.code) == (True, Oper.ALARM, 203)
    assert show(status.status1) == "1111134"


def test_h_stays_0_during_a_pickup_whose_targets_are_all_0(rig: Rig) -> None:
    at_stop(rig, Action.STOP_PORT)
    body = type(PORT)(shft=0, rota=0, lift=0, lkdn=0, spd=1)
    result, seen, home = watch(rig, Code.PICKUP_FROM_PORT, body, 10)
    assert (result, seen[3], seen[5]) == (0, "0111183", "0111183")
    assert home == [True] + [False] * 8 + [True, True]
