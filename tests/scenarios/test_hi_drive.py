"""S41 to S50 at the drive's side: what a master hears, byte for byte (PROTOCOLS section 8)."""

import pytest

from app.domain.units import Seconds
from app.protocols.hi.messages import Ack, Cmd, Mode, Number, Refused, Setting, Ssa
from app.protocols.hi.simulator import Options
from tests.protocols.hi.rig import Script

BUSY = ("BSY", Refused())


@pytest.fixture
def script() -> Script:
    return Script(2)


def test_s41_run_when_idle_is_acknowledged_in_monitoring_within_t2(script: Script) -> None:
    assert script.say(Cmd.RUN) == ("ACK", Ack(2))
    assert script.now <= 0.1
    assert script.drive.state(script.now).running


def test_s42_run_while_running_meets_busy(script: Script) -> None:
    script.say(Cmd.RUN)
    assert script.say(Cmd.RUN) == BUSY
    assert script.say(Cmd.UPP) == BUSY


def test_s43_a_running_drive_answers_questions(script: Script) -> None:
    script.say(Cmd.RUN)
    assert script.say(Cmd.SET, Number(1)) == ("SET", Setting(1, 0))
    answer = script.say(Cmd.SSQ)
    assert answer is not None
    assert isinstance(answer[1], Ssa)


def test_s44_a_written_value_can_be_read_while_it_is_stored_and_a_second_write_cannot(script: Script) -> None:
    assert script.say(Cmd.SED, Setting(0x1C, 123)) == ("ACK", Ack(2))
    assert script.say(Cmd.SET, Number(0x1C)) == ("SET", Setting(0x1C, 123))
    assert script.say(Cmd.SED, Setting(0x1C, 124)) == BUSY
    script.wait(0.3)
    assert script.say(Cmd.SED, Setting(0x1C, 124)) == ("ACK", Ack(2))
    assert script.say(Cmd.SET, Number(0x1C)) == ("SET", Setting(0x1C, 124))


def test_s45_a_wrong_sum_gets_nak_from_the_drive_it_is_for_alone(script: Script) -> None:
    assert script.raw(bytes.fromhex("024d3152554e40233703")) == ("NAK", Refused())
    assert script.raw(bytes.fromhex("024d3052554e40233703")) is None
    assert script.raw(bytes.fromhex("02533152554e40233703")) is None
    assert script.raw(bytes.fromhex("024d3952554e40233703")) is None


def test_s46_a_silent_drive_says_nothing_and_the_others_do(script: Script) -> None:
    script.drive.mischief.silent = True
    assert script.say(Cmd.SSQ) is None
    assert script.raw(bytes.fromhex("024d3152554e40233703")) is None
    assert script.say(Cmd.SSQ, drive=2) is not None


def test_s47_all_drives_obey_id_0_and_none_answers(script: Script) -> None:
    assert script.say(Cmd.RUN, drive=0) is None
    assert [drive.state(script.now).running for drive in script.drives.values()] == [True, True]
    assert script.say(Cmd.SRK, drive=0) is None
    assert script.say(Cmd.SSQ, drive=0) is None
    assert [drive.state(script.now).running for drive in script.drives.values()] == [False, False]


def test_s48_a_jog_goes_on_while_keys_come_and_150_ms_longer(script: Script) -> None:
    script.drive.panel_mode(Mode.JOG, script.now)
    start = script.now
    for i in range(10):
        script.wait(max(0.0, start + 0.05 * i - script.now))
        assert script.say(Cmd.UPP) == ("ACK", Ack(3))
    key_at = start + 0.45
    assert script.drive.state(Seconds(key_at + 0.149)).jogging
    state = script.drive.state(Seconds(key_at + 1.0))
    assert not state.jogging
    assert state.distance == round(1000 * (0.45 + 0.15))
    assert state.direction == 0


def test_s49_an_error_is_told_stops_run_and_is_cleared_by_stop(script: Script) -> None:
    script.drive.fail(7, script.now)
    told = script.say(Cmd.SSQ)
    assert told is not None
    assert isinstance(told[1], Ssa)
    assert (told[1].mode, told[1].status, told[1].meaning) == (4, 7, "OL1")
    assert script.say(Cmd.RUN) == ("ACK", Ack(4))
    assert not script.drive.state(script.now).running
    assert script.say(Cmd.SRK) == ("ACK", Ack(0))
    assert script.say(Cmd.SRK) == ("ACK", Ack(0))


def test_s50_the_status_comes_long_or_short() -> None:
    assert Script().say(Cmd.SSQ) == ("SSA", Ssa(2, 0, 0, 0, 0))
    assert Script(options=Options(long_status=False)).say(Cmd.SSQ) == ("SSA", Ssa(2, 0, 0))
