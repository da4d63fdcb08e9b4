"""What a person does to a simulated vehicle."""

import pytest

from app.domain.layout import Axis, StationKind
from app.domain.units import Barcode, Pulses, Seconds
from app.protocols.itsc.dialects import DIALECTS
from app.protocols.itsc.messages import (
    Ack,
    Code,
    Enq,
    Mode,
    Move,
)
from app.protocols.itsc.simulator import Places
from tests.scenarios.rig import PORT, Rig, make_rig, path, spec


@pytest.fixture
def rig() -> Rig:
    """A vehicle in AUTO at 1201."""
    return make_rig().ready()


def now(rig: Rig) -> Seconds:
    return Seconds(rig.now)


def test_the_key_changes_the_mode_which_is_reported_and_fails_a_running_job(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    rig.run(5)
    assert [event.status2.mode for event in rig.events()] == [Mode.MANT]
    assert rig.result(move) == 1


def test_a_vehicle_pushed_to_a_barcode_reads_it_with_servos_on(rig: Rig) -> None:
    rig.vehicle.push_to(Barcode("1204"), now(rig))
    rig.run(0.1)
    assert [event.barcode for event in rig.events()] == [1204]
    with pytest.raises(ValueError, match="no barcode"):
        rig.vehicle.push_to(Barcode("9"), now(rig))


def test_a_vehicle_pushed_without_servos_reads_its_barcode_at_servo_on() -> None:
    rig = make_rig()
    rig.vehicle.push_to(Barcode("1204"), now(rig))
    status = rig.status()
    assert (status.barcode, status.status2.at_barcode) == (0, False)
    rig.do(Code.SERVO_ON)
    assert rig.status().barcode == 1204


def test_a_vehicle_pushed_away_during_a_move_ends_in_alarm_101(rig: Rig) -> None:
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    rig.vehicle.push_to(Barcode("1301"), now(rig))
    rig.run(1)
    assert (rig.answer(move).result, rig.answer(move).status2.code) == (1, 101)


def test_a_lost_foup_is_alarm_202_and_fails_a_move(rig: Rig) -> None:
    rig.vehicle.insert_foup(now(rig))
    move = rig.move(1201, 1202, 1203)
    rig.run(0.5)
    assert rig.status().status1.foup
    rig.vehicle.lose_foup(now(rig))
    rig.run(5)
    assert (rig.answer(move).result, rig.answer(move).status2.code) == (1, 202)
    assert not rig.status().status1.foup
    rig.vehicle.insert_foup(now(rig))
    rig.vehicle.remove_foup(now(rig))
    assert not rig.status().status1.foup


def test_an_alarm_during_a_pickup_leaves_the_axes_where_they_are(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201))) == 0
    pickup = rig.send(Code.PICKUP_FROM_PORT, PORT)
    rig.run(2.255)
    rig.vehicle.raise_alarm(7, now(rig))
    rig.run(1)
    assert rig.result(pickup) == 1
    assert rig.status().status1.word == 0x01000113
    assert rig.vehicle.state.pulses[Axis.LIFT] == pytest.approx(585_000, abs=1)
    assert rig.do(Code.STOP) == 0
    assert rig.do(Code.ALARM_CLEAR) == 0
    assert rig.do(Code.AUTO) == 1
    assert rig.do(Code.GO_HOME) == 0
    assert rig.status().status1.word == 0x01111134
    assert rig.do(Code.AUTO) == 0


def test_a_vehicle_told_to_refuse_refuses_the_next_command_but_answers_status(rig: Rig) -> None:
    rig.vehicle.refuse_next()
    assert rig.status().status2.mode is Mode.AUTO
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 1
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 0


def test_a_single_teaching_event_needs_mant(rig: Rig) -> None:
    with pytest.raises(ValueError, match="MANT"):
        rig.vehicle.teach_single(Code.LIFT_DEST_TEACHING, now(rig))
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    with pytest.raises(ValueError, match="STATUS is no teaching event"):
        rig.vehicle.teach_single(Code.STATUS, now(rig))


def test_a_renumbered_teaching_code_is_used() -> None:
    rig = make_rig(dialect=type(DIALECTS["default"])(teach_shft_dest=0x20A0)).ready(Mode.MANT)
    assert rig.do(Code.PORT_DEST_TEACHING) == 0
    assert [code for code, _, _ in rig.taught()] == [0x20A0, 0x2072, 0x2074]


def test_a_power_cycle_loses_path_and_memory_but_neither_foup_nor_place(rig: Rig) -> None:
    rig.vehicle.insert_foup(now(rig))
    packet = rig.packet(Code.MOVE, Move(path(1201, 1202, 1203)))
    rig.raw(packet)
    rig.run(0.5)
    where = rig.vehicle.place(now(rig))
    rig.vehicle.power_cycle(now(rig))
    rig.run(0.01)
    assert rig.closed == 1
    rig.run(3)
    rig.connect()
    status = rig.status()
    assert (status.status1.word, status.status2.word, status.barcode) == (0x8B11BB34, 0, 0)
    assert rig.vehicle.place(now(rig)) == where
    rig.do(Code.SERVO_ON)
    assert not rig.status().status2.at_barcode
    assert rig.do(Code.PORT_DEST_TEACHING) == 1
    assert rig.do(Code.SEARCH_HOME) == 0
    assert rig.do(Code.AUTO) == 0
    assert rig.do(Code.MOVE, Move(path(1202, 1203))) == 0


def test_a_power_cycle_in_a_pickup_shows_axes_that_are_not_at_home(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201))) == 0
    rig.send(Code.PICKUP_FROM_PORT, PORT)
    rig.run(2.7)
    rig.vehicle.power_off(now(rig))
    assert not rig.vehicle.accepting
    rig.cut()
    rig.vehicle.power_on(now(rig))
    rig.run(4)
    rig.connect()
    assert rig.status().status1.word == 0x0B00BB03
    rig.do(Code.SERVO_ON)
    assert rig.status().status1.word == 0x00000103


def test_without_power_nothing_more_is_sent() -> None:
    vehicle = make_rig().vehicle
    vehicle.connected(Seconds(0))
    vehicle.make_ready(Seconds(0))
    vehicle.power_off(Seconds(0))
    assert vehicle.wants_close
    assert vehicle.outgoing() == b""


def test_a_restart_may_number_its_events_anew(rig: Rig) -> None:
    rig.vehicle.panel_mode(Mode.MANT, now(rig))
    rig.run(0.1)
    first = rig.heard[-1].frame
    rig.vehicle.power_cycle(now(rig))
    rig.run(4)
    rig.connect()
    rig.vehicle.panel_mode(Mode.AUTO, now(rig))
    rig.run(0.1)
    again = rig.heard[-1].frame
    assert isinstance(first, Enq)
    assert isinstance(again, Enq)
    assert again.cmd_id == 1 << 63 | 1


def test_answers_still_unacknowledged_are_lost_by_a_restart(rig: Rig) -> None:
    rig.acknowledges = lambda _: False
    asked = rig.send(Code.STATUS)
    rig.run(0.1)
    rig.vehicle.power_cycle(now(rig))
    rig.run(4)
    rig.connect()
    rig.run(5)
    assert len(rig.answers(asked)) == 1


def test_places_in_memory_know_what_was_taken_and_put() -> None:
    places = Places()
    there = Barcode("1"), StationKind.PORT
    assert places.full(*there) is None
    assert places.take(spec().id, *there, None)
    assert not places.take(spec().id, *there, None)
    assert places.put(spec().id, *there, None)
    assert places.full(*there) is True
    assert not places.put(spec().id, *there, None)


def test_the_path_is_there_until_a_stop(rig: Rig) -> None:
    assert rig.do(Code.MOVE, Move(path(1201, 1202))) == 0
    assert rig.vehicle.path == ("1201", "1202")
    assert rig.do(Code.STOP_BY_HOST) == 0
    assert not rig.vehicle.path


def test_axes_jogged_to_0_are_at_home(rig: Rig) -> None:
    rig.vehicle.jog(Axis.LIFT, Pulses(5), now(rig))
    assert not rig.status().status2.all_home
    rig.vehicle.jog(Axis.LIFT, Pulses(0), now(rig))
    assert rig.status().status2.all_home
    assert isinstance(rig.heard[0].frame, Ack)
