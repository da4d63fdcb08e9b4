"""The simulated vehicle from its start-up to AUTO."""

import pytest

from app.domain.units import Seconds
from app.protocols.itsc.messages import (
    Code,
    Mode,
    Oper,
)
from app.protocols.itsc.simulator import Options
from tests.scenarios.rig import Rig, make_rig


@pytest.fixture
def rig() -> Rig:
    """A vehicle in AUTO at 1201."""
    return make_rig().ready()


def now(rig: Rig) -> Seconds:
    return Seconds(rig.now)


def test_the_first_status_answer_is_the_source_s_example_byte_for_byte() -> None:
    rig = make_rig()
    rig.vehicle.received(rig.packet(Code.STATUS), Seconds(0))
    rig.vehicle.tick(Seconds(0.005))
    assert rig.vehicle.outgoing().hex() == "06000000010000000000000001" + "5c65"
    assert rig.vehicle.outgoing().hex() == (
        "05000000010000000000000001" + "7030" + "0b11bb34" + "00000000" * 3 + "0e63"
    )
    assert rig.vehicle.outgoing() == b""


def test_from_start_up_to_driving_in_the_source_s_own_words() -> None:
    rig = make_rig()
    assert rig.do(Code.SERVO_ON) == 0
    assert [(event.barcode, event.status2.at_barcode) for event in rig.events()] == [(1201, True)]
    assert rig.status().status1.word == 0x00111134
    search = rig.send(Code.SEARCH_HOME)
    rig.run(1)
    status = rig.status()
    assert (status.status1.word, status.status2.oper, status.status2.all_home) == (0x00888834, Oper.RUN, False)
    rig.until(lambda: rig.result(search) == 0)
    assert rig.do(Code.AUTO) == 0
    rig.move(1201, 1202)
    rig.run(0.3)
    status = rig.status()
    assert (status.status1.word, status.status2.word) == (0x08111134, 0xEF002100)


def test_servo_on_takes_half_a_second_search_home_two_and_go_home_one() -> None:
    rig = make_rig()
    for code, seconds in ((Code.SERVO_ON, 0.5), (Code.SEARCH_HOME, 2.0), (Code.GO_HOME, 1.0)):
        begun = rig.now
        assert rig.do(code) == 0
        assert rig.now - begun == pytest.approx(0.005 + seconds)


def test_servo_off_shows_servos_not_ready_and_keeps_what_is_known(rig: Rig) -> None:
    rig.ready(Mode.MANT)
    assert rig.do(Code.SERVO_OFF) == 0
    status = rig.status()
    assert status.status1.word == 0x0B11BB34
    assert (status.status2.servos_on, status.status2.home_known, status.status2.all_home) == (False, True, False)
    for code in (Code.SEARCH_HOME, Code.GO_HOME, Code.AUTO):
        assert rig.do(code) == 1


def test_firmware_of_document_b_shows_rota_not_ready_without_servos() -> None:
    assert make_rig(options=Options(rota_servo_codes=True)).status().status1.word == 0x0B1BBB34


def test_servo_on_in_alarm_is_refused_and_an_alarm_meanwhile_fails_it() -> None:
    rig = make_rig()
    servo = rig.send(Code.SERVO_ON)
    rig.run(0.1)
    rig.vehicle.raise_alarm(9, now(rig))
    rig.run(1)
    assert rig.result(servo) == 1
    assert rig.do(Code.SERVO_ON) == 1
    assert not rig.status().status2.servos_on


def test_servo_off_or_another_servo_on_meanwhile_fails_a_servo_on() -> None:
    rig = make_rig()
    first = rig.send(Code.SERVO_ON)
    rig.run(0.1)
    second = rig.send(Code.SERVO_ON)
    rig.run(0.1)
    assert (rig.result(first), rig.result(second)) == (1, None)
    assert rig.do(Code.SERVO_OFF) == 0
    rig.run(2)
    assert rig.result(second) == 1
    assert not rig.status().status2.servos_on


def test_servo_on_with_servos_on_reads_no_barcode_again(rig: Rig) -> None:
    rig.ready(Mode.MANT)
    assert rig.do(Code.SERVO_ON) == 0
    assert not rig.events()


def test_go_home_needs_a_known_home_and_alarms_forbid_homing() -> None:
    rig = make_rig()
    rig.do(Code.SERVO_ON)
    assert rig.do(Code.GO_HOME) == 1
    assert rig.do(Code.AUTO) == 1
    rig.vehicle.raise_alarm(9, now(rig))
    assert rig.do(Code.SEARCH_HOME) == 1


def test_stop_ends_a_homing_where_the_axes_are() -> None:
    rig = make_rig()
    rig.do(Code.SERVO_ON)
    home = rig.send(Code.SEARCH_HOME)
    rig.run(1)
    rig.heard.clear()
    stop = rig.send(Code.STOP)
    rig.run(1)
    assert rig.order() == [f"ack {stop}", f"answer {home}", f"answer {stop}"]
    assert (rig.result(home), rig.result(stop)) == (1, 0)
    status = rig.status()
    assert (status.status1.word, status.status2.home_known, status.status2.oper) == (0x00000034, False, Oper.IDLE)


def test_everything_but_the_allowed_commands_is_refused_while_busy() -> None:
    rig = make_rig()
    rig.do(Code.SERVO_ON)
    rig.send(Code.SEARCH_HOME)
    rig.run(0.1)
    for code in (Code.SERVO_OFF, Code.ALARM_CLEAR, Code.AUTO, Code.GO_HOME, Code.PORT_DEST_TEACHING):
        assert rig.do(code, within=0.1) == 1
        assert "busy" in rig.vehicle.last_refusal
    reset = rig.send(Code.SYSTEM_RESET)
    rig.run(0.1)
    assert (len(rig.answers(reset)), rig.closed) == (1, 0)
    assert rig.vehicle.working is Code.SEARCH_HOME


def test_stop_by_host_of_a_standing_vehicle_only_answers(rig: Rig) -> None:
    stop = rig.send(Code.STOP_BY_HOST)
    rig.run(1)
    assert rig.order() == [f"ack {stop}", f"answer {stop}"]
