"""A simulated drive beyond the scenarios: keys, inputs, panel, and the line around it."""

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.domain.units import Seconds
from app.protocols.hi.codec import encode
from app.protocols.hi.dialects import DIALECTS
from app.protocols.hi.framing import Decoder
from app.protocols.hi.messages import NOTHING, Ack, Cmd, Frame, Inputs, Mode, Number, Refused, Role, Setting, Ssa
from app.protocols.hi.simulator import Options, SimulatedDrive, SimulatedLine, State
from tests.protocols.hi.rig import Script


def state(script: Script) -> State:
    return script.drive.state(script.now)


def due(line: SimulatedLine) -> Seconds | None:
    return line.deadline


@pytest.fixture
def script() -> Script:
    return Script()


def test_keys_choose_a_parameter_and_change_its_value(script: Script) -> None:
    script.drive.panel_mode(Mode.PARAMETER_SELECT, script.now)
    script.drive.set_value(0xFF, 9998)
    assert script.say(Cmd.DWN) == ("ACK", Ack(0))
    assert state(script).selected == 0xFF
    assert script.say(Cmd.DSK) == ("ACK", Ack(1))
    for _ in range(3):
        script.say(Cmd.UPP)
    assert state(script).shown == 9999
    assert script.say(Cmd.DSK) == ("ACK", Ack(0))
    assert state(script).values[0xFF] == 9999
    assert script.say(Cmd.UPP) == ("BSY", Refused())
    script.wait(0.3)
    assert script.say(Cmd.UPP) == ("ACK", Ack(0))
    assert state(script).selected == 0


def test_keys_that_mean_nothing_in_a_mode_are_acknowledged_and_do_nothing(script: Script) -> None:
    assert script.say(Cmd.UPP) == script.say(Cmd.DSK) == ("ACK", Ack(2))
    assert state(script) == State()


def test_run_goes_on_until_stop(script: Script) -> None:
    script.say(Cmd.RUN)
    script.wait(1.0)
    assert script.say(Cmd.SRK) == ("ACK", Ack(2))
    stopped_at = state(script).distance
    assert stopped_at >= 1000
    script.wait(1.0)
    assert state(script).distance == stopped_at


def test_the_distance_begins_anew_when_the_axis_turns_round(script: Script) -> None:
    script.drive.panel_mode(Mode.JOG, script.now)
    script.say(Cmd.UPP)
    script.wait(0.3)
    assert (state(script).direction, state(script).distance) == (0, 150)
    script.say(Cmd.DWN)
    script.wait(0.3)
    assert (state(script).direction, state(script).distance) == (1, 150)


def test_the_distance_has_six_digits(script: Script) -> None:
    script.drive.state(script.now).distance = 999_999
    script.say(Cmd.RUN)
    script.wait(0.1)
    answer = script.say(Cmd.SSQ)
    assert answer is not None
    assert isinstance(answer[1], Ssa)
    assert answer[1].distance_centi is not None
    assert answer[1].distance_centi < 1000


def test_inputs_run_choose_the_step_and_stop_at_a_limit(script: Script) -> None:
    assert script.say(Cmd.INP, Inputs(1, 0, 0, 0, 12)) == ("ACK", Ack(2))
    assert (state(script).running, state(script).step) == (True, 12)
    assert script.say(Cmd.INP, Inputs(1, 0, 1, 0, 1)) == ("BSY", Refused())
    assert script.say(Cmd.INP, Inputs(0, 0, 0, 1, 1)) == ("ACK", Ack(2))
    assert state(script).running
    assert script.say(Cmd.INP, Inputs(0, 0, 1, 0, 1)) == ("ACK", Ack(2))
    assert not state(script).running
    assert script.say(Cmd.RUN) == ("ACK", Ack(2))
    assert not state(script).running


def test_a_home_search_ends_at_distance_0(script: Script) -> None:
    script.say(Cmd.RUN)
    script.wait(0.5)
    script.say(Cmd.SRK)
    script.say(Cmd.INP, Inputs(0, 1, 0, 0, 0))
    assert state(script).running
    script.wait(2.0)
    assert (state(script).running, state(script).distance) == (False, 0)


def test_neither_run_nor_home_does_anything_in_error(script: Script) -> None:
    script.drive.fail(16, script.now)
    assert script.say(Cmd.INP, Inputs(1, 1, 0, 0, 0)) == ("ACK", Ack(4))
    assert not state(script).moving


def test_an_error_whose_cause_remains_is_not_cleared(script: Script) -> None:
    script.say(Cmd.RUN)
    script.drive.fail(3, script.now, cause_remains=True)
    assert not state(script).running
    assert script.say(Cmd.SRK) == ("ACK", Ack(4))
    script.drive.clear_cause()
    assert script.say(Cmd.SRK) == ("ACK", Ack(0))


def test_stop_acts_on_a_busy_drive(script: Script) -> None:
    script.say(Cmd.RUN)
    script.say(Cmd.SED, Setting(1, 1))
    assert script.say(Cmd.SRK) == ("ACK", Ack(2))
    assert not state(script).running


def test_operation_and_output_are_told(script: Script) -> None:
    script.drive.set_operation(5)
    script.drive.set_output(7)
    assert script.say(Cmd.SSQ) == ("SSA", Ssa(2, 7, 5, 0, 0))


def test_what_it_does_not_understand_gets_nak_and_the_worked_example_ack(script: Script) -> None:
    def raw(cmd: str, *data: str) -> object:
        return script.raw(encode(Frame(Role.MASTER, 1, cmd, data)))

    assert raw("ZZZ") == raw("SET", "1") == raw("RUN", "1") == raw("ACK", "1") == ("NAK", Refused())
    assert raw("PDT") == ("ACK", Ack(2))


def test_bad_grammar_a_foreign_id_and_a_slave_get_silence(script: Script) -> None:
    assert script.raw(bytes.fromhex("024d3152554e41233603")) is None
    assert script.say(Cmd.RUN, drive=2) is None
    assert script.raw(encode(Frame(Role.SLAVE, 1, "ACK", ("2",)))) is None


def test_a_packet_whose_end_is_lost_is_given_up_after_silence(script: Script) -> None:
    packet = encode(Frame(Role.MASTER, 1, "RUN"))
    assert script.raw(packet[:6]) is None
    assert script.raw(packet) == ("ACK", Ack(2))
    # A broken head with a whole packet in its wake, seen only once the line is silent.
    raw = Script(dialect=DIALECTS["bcc-word"])
    whole = encode(Frame(Role.MASTER, 1, "SRK"), DIALECTS["bcc-word"])
    assert raw.raw(b"\x02M1ZZZ@#" + whole[:3]) is None


def test_faults_of_a_drive(script: Script) -> None:
    mischief = script.drive.mischief
    mischief.naks, mischief.busies = 1, 1
    assert script.say(Cmd.RUN) == ("NAK", Refused())
    assert script.say(Cmd.RUN) == ("BSY", Refused())
    assert not state(script).running
    mischief.answers_lost = 1
    assert script.say(Cmd.RUN) is None
    assert script.say(Cmd.SRK) == ("ACK", Ack(2))
    mischief.late = Seconds(0.05)
    before = script.now
    script.say(Cmd.SSQ)
    assert script.now == pytest.approx(before + 0.055)


def test_a_continued_packet_is_answered_after_its_last_part(script: Script) -> None:
    assert script.raw(encode(Frame(Role.MASTER, 1, "SED", ("01",), more=True))) is None
    assert script.raw(encode(Frame(Role.MASTER, 1, "SED", ("0007",)))) == ("ACK", Ack(2))
    assert state(script).values[1] == 7


@pytest.mark.parametrize(
    "wrong",
    [
        lambda drive: drive.panel_mode(Mode.ERROR, 0.0),
        lambda drive: drive.fail(17, 0.0),
        lambda drive: drive.set_operation(6),
        lambda drive: drive.set_output(8),
        lambda drive: drive.set_value(256, 0),
        lambda drive: drive.set_value(0, 10000),
        lambda _: SimulatedDrive(0),
        lambda _: SimulatedDrive(16),
        lambda drive: SimulatedLine([drive, drive]),
    ],
)
def test_what_cannot_be_is_refused(wrong: object) -> None:
    with pytest.raises(ValueError):
        wrong(SimulatedDrive(1))  # type: ignore[operator]


def test_a_cut_line_forgets_what_was_under_way_and_the_drive_goes_on() -> None:
    drive = SimulatedDrive(1)
    line = SimulatedLine([drive])
    run = encode(Frame(Role.MASTER, 1, "RUN"))
    line.received(run, Seconds(0.0))
    assert due(line) is None
    line.connected(Seconds(0.0))
    line.received(run + b"\x02M", Seconds(1.0))
    assert due(line) == 1.005
    line.disconnected(Seconds(1.001), "cut")
    assert due(line) is None
    line.connected(Seconds(2.0))
    line.tick(Seconds(3.0))
    assert line.outgoing() == b""
    assert line.drives[1].state(Seconds(3.0)).distance == 2000
    assert not line.wants_close


PACKETS = st.sampled_from(
    [encode(Frame(Role.MASTER, drive, cmd, data)) for drive in (0, 1, 2) for cmd, data in (
        ("RUN", ()), ("SRK", ()), ("UPP", ()), ("DWN", ()), ("DSK", ()), ("SSQ", ()), ("SET", ("01",)), ("SED", ("01", "0009")),
        ("INP", ("1", "1", "1", "0", "3")), ("ZZZ", ("x",)),
    )]
)  # fmt: skip


@given(
    pieces=st.lists(st.tuples(st.floats(0, 0.4), st.one_of(PACKETS, PACKETS, st.binary(max_size=12)))),
    mode=st.sampled_from([Mode.JOG, Mode.PARAMETER_SELECT, Mode.PARAMETER_VALUE, Mode.MONITORING]),
    long_status=st.booleans(),
)
def test_whatever_it_hears_a_drive_answers_in_packets_and_stays_sound(
    pieces: list[tuple[float, bytes]], mode: Mode, long_status: bool
) -> None:
    drive = SimulatedDrive(1, options=Options(long_status=long_status))
    line = SimulatedLine([drive])
    line.connected(Seconds(0.0))
    drive.panel_mode(mode, Seconds(0.0))
    now = 0.0
    for gap, piece in pieces:
        now += gap
        line.received(piece, Seconds(now))
        line.tick(Seconds(now + 0.005))
        while packet := line.outgoing():
            (frame,) = Decoder().feed(packet)
            assert isinstance(frame, Frame)
            assert (frame.role, frame.id) == (Role.SLAVE, 1)
        found = drive.state(Seconds(now + 0.005))
        assert 0 <= found.distance < 1_000_000
        assert not (found.running and found.jogging)
        assert (found.mode is Mode.ERROR) == (found.error > 0)
        assert all(0 <= value <= 9999 for value in found.values)


def test_reading_and_writing_every_parameter(script: Script) -> None:
    for number in range(256):
        assert script.say(Cmd.SED, Setting(number, number * 39)) == ("ACK", Ack(2))
        script.wait(0.3)
    for number in range(256):
        assert script.say(Cmd.SET, Number(number)) == ("SET", Setting(number, number * 39))
    assert script.say(Cmd.SSQ, NOTHING) == ("SSA", Ssa(2, 0, 0, 0, 0))
