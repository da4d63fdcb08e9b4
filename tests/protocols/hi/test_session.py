"""The master of a drive line: repeats, alarms, keys that must not be pressed twice, order of turns."""

from itertools import pairwise

import pytest

from app.domain.drive import (
    AskStatus,
    DriveAddress,
    DriveDone,
    DriveEvent,
    DriveFailed,
    DriveId,
    DriveLineDown,
    DriveLineGarbled,
    DriveLineId,
    DriveLineUp,
    DriveMode,
    DriveOffline,
    DriveOnline,
    DriveReported,
    DriveRequest,
    DriveRequestId,
    DriveSpec,
    DriveStatus,
    DriveUnknown,
    Hundredths,
    JogEnd,
    Key,
    Parameter,
    ParameterRead,
    PressKey,
    RawValue,
    ReadParameter,
    SetInputs,
    Setting,
    Turn,
    WriteParameter,
)
from app.domain.units import Seconds
from app.protocols.hi.codec import encode
from app.protocols.hi.dialects import DIALECTS
from app.protocols.hi.messages import Cmd, Frame, Mode, Role
from app.protocols.hi.session import LineSession, Timing
from app.protocols.hi.session.scripts import was_taken
from app.wire.faults import Fault
from tests.protocols.hi.rig import Bench, End, strike

RUN, STOP, UP, SET_KEY = (PressKey(key) for key in (Key.RUN, Key.STOP_RESET, Key.UP, Key.DATA_SET))
P1 = Parameter(1)
READ = ReadParameter(P1)


@pytest.fixture
def bench() -> Bench:
    bench = Bench(2)
    bench.settle()
    return bench


def done(end: End) -> object:
    assert isinstance(end, DriveDone), end
    return end.result


def failed(end: End) -> str:
    assert isinstance(end, DriveFailed), end
    return end.reason


def unknown(end: End) -> DriveUnknown:
    assert isinstance(end, DriveUnknown), end
    return end


def mode(bench: Bench, wanted: Mode, drive: int = 1) -> None:
    bench.drives[drive].panel_mode(wanted, Seconds(bench.now))
    bench.run(2.0)
    bench.forget()


# Every drive's life


def test_a_new_line_asks_all_drives_for_their_status() -> None:
    bench = Bench(3)
    bench.run(0.3)
    assert bench.of(DriveLineUp, DriveOnline) == [
        DriveLineUp(DriveLineId("L1")),
        *(DriveOnline(DriveId(f"D{i}")) for i in (1, 2, 3)),
    ]
    assert {view.online for view in bench.session.drives.values()} == {True}


def test_a_status_is_told_only_when_it_is_another(bench: Bench) -> None:
    bench.run(5.0)
    assert bench.of(DriveReported) == []
    bench.drives[2].set_output(3)
    bench.run(1.5)
    (told,) = bench.of(DriveReported)
    status = DriveStatus(DriveMode.MONITORING, 3, 0, "normal", Turn.CW, Hundredths(0))
    assert told == DriveReported(DriveId("D2"), status)


def test_all_drives_are_polled_in_turn_each_second(bench: Bench) -> None:
    bench.run(10.0)
    for drive in (1, 2):
        times = bench.commands(Cmd.SSQ, drive)
        assert len(times) >= 9
        assert all(after - before < 1.2 for before, after in pairwise(times))


def test_reading_all_parameters_does_not_stop_the_polls(bench: Bench) -> None:
    requests = [bench.ask(ReadParameter(Parameter(number))) for number in range(256)]
    bench.until(lambda: bench.end(requests[-1]) is not None, within=60.0)
    assert len(bench.of(ParameterRead)) == 256
    for drive in (1, 2):
        assert all(after - before < 2.3 for before, after in pairwise([0.0, *bench.commands(Cmd.SSQ, drive)]))


def test_a_drive_that_was_never_there_is_an_alarm_once() -> None:
    bench = Bench(1, watch=[1, 7])
    bench.run(30.0)
    assert bench.of(DriveOffline) == [DriveOffline(DriveId("D7"), "no answer to SSQ in 5 transmissions")]
    assert bench.session.drives[DriveId("D7")].online is False


def test_two_drives_with_one_name_or_address_cannot_be_on_a_line() -> None:
    def spec(name: str, address: int) -> DriveSpec:
        return DriveSpec(DriveId(name), DriveAddress(address))

    for specs in ([spec("A", 1), spec("B", 1)], [spec("A", 1), spec("A", 2)], [spec("A", 0)], [spec("A", 16)]):
        with pytest.raises(ValueError, match="address"):
            LineSession(DriveLineId("L"), specs)


# Reading and writing


def test_a_value_is_read_and_written(bench: Bench) -> None:
    assert done(bench.do(WriteParameter(P1, RawValue(55)))) == Setting(P1, RawValue(55))
    assert done(bench.do(READ)) == Setting(P1, RawValue(55))
    assert bench.of(ParameterRead) == [ParameterRead(DriveId("D1"), P1, RawValue(55))] * 2
    assert isinstance(done(bench.do(AskStatus())), DriveStatus)


def test_a_write_that_the_drive_does_not_keep_is_a_failure(bench: Bench) -> None:
    request = bench.ask(WriteParameter(P1, RawValue(55)))
    bench.until(lambda: bool(bench.commands(Cmd.SET)))
    bench.drives[1].set_value(1, 54)
    bench.until(lambda: bench.end(request) is not None)
    assert failed(bench.ended(request)) == "parameter 01 reads back as 0054, not 0055"
    assert len(bench.commands(Cmd.SET)) == 2, "a difference is looked at twice"


def test_a_lost_acknowledgement_of_a_write_costs_a_repetition(bench: Bench) -> None:
    bench.drives[1].mischief.answers_lost = 1
    assert done(bench.do(WriteParameter(P1, RawValue(55)))) == Setting(P1, RawValue(55))
    assert len(bench.commands(Cmd.SED)) == 3, "lost, busy storing, taken"


def test_a_write_without_any_answer_is_unknown_and_the_drive_offline(bench: Bench) -> None:
    bench.drives[1].mischief.answers_lost = 99
    end = unknown(bench.do(WriteParameter(P1, RawValue(55))))
    assert end.reason == "no answer to SED in 5 transmissions"
    assert bench.of(DriveOffline) == [DriveOffline(DriveId("D1"), end.reason)]


def test_a_write_that_cannot_be_read_back_is_unknown(bench: Bench) -> None:
    request = bench.ask(WriteParameter(P1, RawValue(55)))
    bench.until(lambda: bool(bench.commands(Cmd.SET)))
    bench.drives[1].mischief.silent = True
    bench.until(lambda: bench.end(request) is not None)
    assert unknown(bench.ended(request)).reason.startswith("written, but not read back: no answer to SET")


def test_what_waits_for_a_drive_that_goes_offline_fails(bench: Bench) -> None:
    bench.drives[1].mischief.silent = True
    requests = [bench.ask(READ), bench.ask(WriteParameter(P1, RawValue(5))), bench.ask(RUN)]
    other = bench.ask(READ, drive=2)
    bench.until(lambda: all(bench.end(request) is not None for request in [*requests, other]))
    reasons = [failed(bench.ended(request)) for request in requests]
    assert "no answer to" in reasons[0]
    assert all(reason.startswith("the drive went offline") for reason in reasons[1:])
    assert done(bench.ended(other)) == Setting(P1, RawValue(0))
    assert failed(bench.do(READ)) == "the drive is offline"


def test_stop_is_sent_to_a_drive_that_is_offline(bench: Bench) -> None:
    bench.drives[1].mischief.silent = True
    bench.until(lambda: bool(bench.of(DriveOffline)))
    assert unknown(bench.do(STOP)).reason == "no answer to SRK in 5 transmissions"
    bench.drives[1].mischief.silent = False
    assert done(bench.do(STOP)) is DriveMode.MONITORING
    assert bench.of(DriveOnline) == [DriveOnline(DriveId("D1"))]


@pytest.mark.parametrize(
    ("command", "drive", "reason"),
    [
        (WriteParameter(P1, RawValue(10000)), 1, "value 10000 is no whole number from 0 to 9999"),
        (ReadParameter(Parameter(256)), 1, "number 256"),
        (SetInputs(step=16), 1, "steps 16"),
        (READ, 9, "drive D9 is not on line L1"),
        (READ, None, "only one drive at a time can answer"),
        (AskStatus(), None, "only one drive at a time can answer"),
    ],
)
def test_what_cannot_be_asked_fails_at_once(
    bench: Bench, command: ReadParameter, drive: int | None, reason: str
) -> None:
    assert failed(bench.ended(bench.ask(command, drive))).startswith(reason)
    assert bench.sent == []


def test_three_digits_bound_a_value() -> None:
    bench = Bench(dialect=DIALECTS["value3"])
    assert failed(bench.ended(bench.ask(WriteParameter(P1, RawValue(1000))))).endswith("0 to 999")
    assert done(bench.do(WriteParameter(P1, RawValue(999)))) == Setting(P1, RawValue(999))


def test_inputs_are_set_and_those_that_move_look_first(bench: Bench) -> None:
    assert done(bench.do(SetInputs(left_limit=True, step=3))) is DriveMode.MONITORING
    assert bench.drives[1].state(Seconds(bench.now)).step == 3
    assert bench.commands(Cmd.SSQ) == []
    assert done(bench.do(SetInputs(run=True))) is DriveMode.MONITORING
    bench.drives[1].fail(2, Seconds(bench.now))
    assert failed(bench.do(SetInputs(home=True))) == "the drive is in error 02 OC"
    assert done(bench.do(SetInputs())) is DriveMode.ERROR


def test_inputs_without_an_answer_are_unknown(bench: Bench) -> None:
    strike(bench.back, Fault.DROP, Cmd.ACK, times=5)
    assert unknown(bench.do(SetInputs(step=1))).reason == "no answer to INP in 5 transmissions"
    bench = Bench()
    bench.settle()
    bench.drives[1].mischief.silent = True
    assert failed(bench.do(SetInputs(run=True))) == "no answer to SSQ in 5 transmissions"
    assert failed(bench.do(AskStatus())) == "the drive is offline"


def test_run_inputs_whose_answer_was_lost_meet_a_running_drive_and_end_unknown(bench: Bench) -> None:
    strike(bench.back, Fault.DROP, Cmd.ACK)
    assert unknown(bench.do(SetInputs(run=True))).reason == "the drive is busy: BSY to INP"


# Keys that must not be pressed twice by mistake


def test_a_key_after_a_lost_answer_is_not_sent_again_when_the_state_shows_that_it_was_taken(bench: Bench) -> None:
    mode(bench, Mode.PARAMETER_SELECT)
    strike(bench.back, Fault.DROP, Cmd.ACK)
    assert done(bench.do(SET_KEY)) is DriveMode.PARAMETER_VALUE
    assert len(bench.commands(Cmd.DSK)) == 1


def test_a_key_that_the_state_shows_not_taken_is_sent_again(bench: Bench) -> None:
    mode(bench, Mode.PARAMETER_SELECT)
    strike(bench.out, Fault.DROP, Cmd.DSK)
    assert done(bench.do(SET_KEY)) is DriveMode.PARAMETER_VALUE
    assert len(bench.commands(Cmd.DSK)) == 2
    mode(bench, Mode.PARAMETER_SELECT)
    strike(bench.out, Fault.DROP, Cmd.DSK, times=5)
    assert failed(bench.do(SET_KEY)) == "the drive did not take the key in 5 transmissions"
    assert bench.drives[1].state(Seconds(bench.now)).mode is Mode.PARAMETER_SELECT


def test_a_key_of_which_the_state_shows_nothing_is_left_to_a_person(bench: Bench) -> None:
    mode(bench, Mode.PARAMETER_VALUE)
    strike(bench.back, Fault.DROP, Cmd.ACK)
    end = unknown(bench.do(UP))
    assert end.status is not None
    assert end.status.mode is DriveMode.PARAMETER_VALUE
    assert "does not show" in end.reason
    assert len(bench.commands(Cmd.UPP)) == 1
    assert bench.drives[1].state(Seconds(bench.now)).shown == 1


def test_a_key_lost_by_a_drive_that_falls_silent_is_unknown(bench: Bench) -> None:
    request = bench.ask(RUN)
    bench.until(lambda: bool(bench.commands(Cmd.RUN)))
    bench.drives[1].mischief.silent = True
    bench.until(lambda: bench.end(request) is not None)
    assert (
        "no answer to RUN in 1 transmission; then no answer to SSQ in 5 transmissions"
        in unknown(bench.ended(request)).reason
    )


def test_a_key_that_meets_nak_is_sent_again(bench: Bench) -> None:
    request = bench.ask(RUN)
    bench.until(lambda: bool(bench.commands(Cmd.SSQ)))
    bench.run(0.04)
    bench.drives[1].mischief.naks = 1
    bench.until(lambda: bench.end(request) is not None)
    assert done(bench.ended(request)) is DriveMode.MONITORING
    assert len(bench.commands(Cmd.RUN)) == 2


def test_a_key_whose_drive_gets_an_error_meanwhile_has_failed(bench: Bench) -> None:
    request = bench.ask(RUN)
    bench.until(lambda: bool(bench.commands(Cmd.RUN)))
    bench.drives[1].fail(9, Seconds(bench.now))
    bench.until(lambda: bench.end(request) is not None)
    assert "mode error" in failed(bench.ended(request))
    bench.drives[1].fail(9, Seconds(bench.now), cause_remains=True)
    assert failed(bench.do(STOP)) == "the drive is still in error after Stop/Reset"


def test_a_key_is_not_pressed_on_a_drive_that_does_not_tell_its_state(bench: Bench) -> None:
    bench.drives[1].mischief.silent = True
    assert failed(bench.do(RUN)) == "no answer to SSQ in 5 transmissions"
    assert bench.commands(Cmd.RUN) == []


@pytest.mark.parametrize(
    ("key", "before", "after", "taken"),
    [
        (Key.DATA_SET, 0, 1, True),
        (Key.DATA_SET, 1, 1, False),
        (Key.DATA_SET, 2, 2, None),
        (Key.RUN, 0, 2, True),
        (Key.RUN, 0, 0, False),
        (Key.RUN, 0, 3, None),
        (Key.RUN, 2, 2, None),
        (Key.RUN, 2, 4, True),
        (Key.UP, 0, 0, None),
    ],
)
def test_what_the_modes_before_and_after_show_of_a_key(key: Key, before: int, after: int, taken: bool | None) -> None:
    assert was_taken(key, DriveMode(before), DriveMode(after)) is taken


# Stop


def test_stop_goes_before_all_that_waits(bench: Bench) -> None:
    reads = [bench.ask(READ, drive) for drive in (1, 2) for _ in range(5)]
    stop = bench.ask(STOP, 2)
    bench.until(lambda: bench.end(stop) is not None)
    assert sum(bench.end(read) is not None for read in reads) <= 1


def test_stop_goes_between_the_repetitions_of_another_request(bench: Bench) -> None:
    bench.drives[1].mischief.silent = True
    bench.ask(READ)
    stop = bench.ask(STOP, 2)
    bench.until(lambda: bench.end(stop) is not None)
    assert len(bench.commands(Cmd.SET)) <= 1


def test_stop_withdraws_what_would_make_its_drive_move_afterwards(bench: Bench) -> None:
    bench.do(RUN)
    waiting = bench.ask(RUN)
    bench.until(lambda: len(bench.commands(Cmd.RUN)) == 3)
    bench.run(0.1)
    behind, other, reading = bench.ask(UP), bench.ask(RUN, 2), bench.ask(READ)
    assert done(bench.do(STOP)) is DriveMode.MONITORING
    bench.until(lambda: all(bench.end(request) is not None for request in (waiting, behind, other, reading)))
    assert failed(bench.ended(waiting)) == failed(bench.ended(behind)) == "Stop/Reset was pressed"
    assert done(bench.ended(other)) is DriveMode.MONITORING
    assert done(bench.ended(reading)) == Setting(P1, RawValue(0))
    bench.run(5.0)
    assert not bench.drives[1].state(Seconds(bench.now)).running


def test_stop_during_the_look_before_a_key_withdraws_the_key(bench: Bench) -> None:
    run = bench.ask(RUN)
    assert done(bench.do(STOP)) is DriveMode.MONITORING
    assert failed(bench.ended(run)) == "Stop/Reset was pressed"
    assert bench.commands(Cmd.RUN) == []


@pytest.mark.parametrize("fault", ["busy", "silent", "lost"])
def test_stop_during_a_key_keeps_it_from_being_repeated(bench: Bench, fault: str) -> None:
    run = bench.ask(RUN)
    if fault == "busy":
        bench.drives[1].mischief.busies = 1
    bench.until(lambda: bool(bench.commands(Cmd.RUN)))
    if fault != "busy":
        strike(bench.back, Fault.DROP, Cmd.ACK)
    stop = bench.ask(STOP)
    bench.until(lambda: bench.end(stop) is not None and bench.end(run) is not None)
    assert isinstance(bench.ended(run), DriveFailed if fault == "busy" else DriveUnknown)
    bench.run(3.0)
    assert len(bench.commands(Cmd.RUN)) == 1
    assert not bench.drives[1].state(Seconds(bench.now)).running


def test_all_drives_are_stopped_at_once_and_everything_that_moves_withdrawn(bench: Bench) -> None:
    assert done(bench.do(RUN, drive=None)) is None
    assert all(drive.state(Seconds(bench.now)).running for drive in bench.drives.values())
    waiting = [bench.ask(RUN, 1), bench.ask(RUN, 2), bench.ask(RUN, None)]
    assert done(bench.do(STOP, drive=None)) is None
    assert not any(drive.state(Seconds(bench.now)).running for drive in bench.drives.values())
    assert {failed(bench.ended(request)) for request in waiting} == {"Stop/Reset was pressed"}


def test_all_drives_are_not_told_to_move_while_one_is_in_error(bench: Bench) -> None:
    bench.drives[2].fail(5, Seconds(bench.now))
    bench.run(2.0)
    assert failed(bench.do(RUN, drive=None)) == "in error: D2"
    assert done(bench.do(WriteParameter(P1, RawValue(3)), drive=None)) is None


def test_a_write_to_all_names_the_drives_that_did_not_keep_it(bench: Bench) -> None:
    bench.drives[2].mischief.silent = True
    end = bench.do(WriteParameter(P1, RawValue(3)), drive=None)
    assert failed(end) == "D2: written, but not read back: no answer to SET in 5 transmissions"


def test_requests_wait_for_one_to_all_drives_and_it_for_them(bench: Bench) -> None:
    bench.ask(WriteParameter(P1, RawValue(1)))
    bench.ask(WriteParameter(P1, RawValue(2)))
    bench.ask(WriteParameter(P1, RawValue(3)), None)
    last = bench.ask(WriteParameter(P1, RawValue(4)), 2)
    bench.until(lambda: bench.end(last) is not None)
    assert [bench.drives[i].state(Seconds(bench.now)).values[1] for i in (1, 2)] == [3, 4]


# Jogging


def jogging(drives: int = 2) -> Bench:
    bench = Bench(drives)
    bench.settle()
    mode(bench, Mode.JOG)
    return bench


def test_a_drive_that_is_not_in_jog_gets_no_key(bench: Bench) -> None:
    jog = bench.jog(Turn.CW, bench.now + 1.0)
    bench.run(2.0)
    assert failed(bench.ended(jog)) == "the drive is in mode 2, not in jog"
    assert not bench.began(jog)
    bench.drives[1].fail(7, Seconds(bench.now))
    jog = bench.jog(Turn.CW, bench.now + 1.0)
    bench.run(2.0)
    assert failed(bench.ended(jog)) == "the drive is in error 07 OL1"
    bench.drives[1].mischief.silent = True
    jog = bench.jog(Turn.CW, bench.now + 1.0)
    bench.run(2.0)
    assert "no answer to SSQ" in failed(bench.ended(jog))
    assert bench.commands(Cmd.UPP) == []
    jog = bench.jog(Turn.CW, bench.now + 1.0)
    assert failed(bench.ended(jog)) == "the drive is offline"


def test_a_line_has_one_jog_at_a_time() -> None:
    bench = jogging()
    first = bench.jog(Turn.CW, bench.now + 1.0)
    second = bench.jog(Turn.CW, bench.now + 1.0, drive=2)
    assert failed(bench.ended(second)) == "another jog has the line"
    assert not bench.session.keep_jogging(second, Seconds(9.0))
    bench.session.release_jog(second, Seconds(bench.now))
    bench.run(0.5)
    assert bench.end(first) is None
    third = bench.jog(Turn.CW, bench.now + 1.0, drive=9)
    assert failed(bench.ended(third)) == "drive D9 is not on line L1"


def test_requests_wait_until_the_jog_is_over() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 1.0)
    read = bench.ask(READ, 2)
    bench.run(0.9)
    assert bench.end(read) is None
    bench.until(lambda: bench.end(read) is not None)
    assert done(bench.ended(jog)) is JogEnd.CALLER_GONE


def test_stop_ends_a_jog_and_another_drives_stop_does_not() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 60.0)
    bench.run(0.5)
    assert done(bench.do(STOP, 2)) is DriveMode.MONITORING
    bench.run(0.5)
    assert bench.end(jog) is None
    keys = len(bench.commands(Cmd.UPP))
    assert done(bench.do(STOP, 1)) is DriveMode.JOG
    bench.run(0.5)
    assert done(bench.ended(jog)) is JogEnd.RELEASED
    assert len(bench.commands(Cmd.UPP)) <= keys + 1


def test_a_jog_released_before_its_first_key_sends_none() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 60.0)
    bench.session.release_jog(jog, Seconds(bench.now))
    bench.run(0.5)
    assert done(bench.ended(jog)) is JogEnd.RELEASED
    assert bench.commands(Cmd.UPP) == []


def test_a_jog_key_whose_answer_is_lost_is_followed_by_a_look_at_the_mode() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 2.0)
    bench.run(0.3)
    strike(bench.back, Fault.DROP, Cmd.ACK)
    looks = len(bench.commands(Cmd.SSQ))
    bench.run(0.5)
    assert len(bench.commands(Cmd.SSQ)) == looks + 1
    assert bench.end(jog) is None
    bench.run(2.0)
    assert done(bench.ended(jog)) is JogEnd.CALLER_GONE


def test_a_jog_ends_when_the_drive_leaves_its_mode_or_fails() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 9.0)
    bench.run(0.3)
    bench.drives[1].panel_mode(Mode.PARAMETER_VALUE, Seconds(bench.now))
    bench.run(1.0)
    assert failed(bench.ended(jog)) == "the drive went to mode 1 while jogging"
    assert bench.drives[1].state(Seconds(bench.now)).shown <= 1
    mode(bench, Mode.JOG)
    jog = bench.jog(Turn.CW, bench.now + 9.0)
    bench.run(0.3)
    strike(bench.back, Fault.DROP, Cmd.ACK)
    timeouts = bench.session.figures.timeouts
    bench.until(lambda: bench.session.figures.timeouts > timeouts)
    bench.drives[1].fail(7, Seconds(bench.now))
    bench.run(1.0)
    assert failed(bench.ended(jog)) == "the drive is in error 07 OL1"


def test_a_jog_of_a_drive_that_falls_silent_ends_unknown_after_its_stops() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 60.0)
    bench.run(0.3)
    bench.drives[1].mischief.silent = True
    bench.run(3.0)
    assert unknown(bench.ended(jog)).reason == "the jog has ended, but no answer to SRK in 5 transmissions"
    assert len(bench.commands(Cmd.SRK)) == 5
    assert not bench.drives[1].state(Seconds(bench.now)).jogging


def test_a_jog_whose_stop_is_refused_five_times_has_failed() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 0.3)
    bench.run(0.31)
    bench.drives[1].mischief.naks = 5
    bench.run(2.0)
    assert failed(bench.ended(jog)) == "NAK to SRK in 5 transmissions"


def test_a_jog_of_a_drive_that_stays_busy_ends() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 60.0)
    bench.run(0.3)
    bench.drives[1].mischief.busies = 5
    bench.run(1.0)
    assert bench.end(jog) is None
    bench.drives[1].mischief.busies = 99
    bench.run(3.0)
    assert failed(bench.ended(jog)) == "the drive did not take 11 jog keys on end"


# The wire


def test_a_late_answer_to_a_repeated_question_is_not_taken_for_the_next_one() -> None:
    bench = Bench(1)
    bench.settle()
    bench.drives[1].mischief.late = Seconds(0.16)
    stop = bench.ask(STOP)
    bench.until(lambda: len(bench.commands(Cmd.SRK)) == 2)
    bench.drives[1].mischief.late = Seconds(0.0)
    bench.until(lambda: bench.end(stop) is not None)
    read = bench.do(SetInputs(step=2))
    assert done(read) is DriveMode.MONITORING
    assert bench.drives[1].state(Seconds(bench.now)).step == 2


def test_an_answer_that_comes_twice_answers_once(bench: Bench) -> None:
    strike(bench.back, Fault.DUPLICATE, Cmd.ACK)
    strike(bench.out, Fault.DROP, Cmd.SRK)
    inputs, stop = bench.ask(SetInputs(step=2)), bench.ask(STOP)
    bench.until(lambda: bench.end(inputs) is not None and bench.end(stop) is not None)
    assert len(bench.commands(Cmd.SRK)) == 2
    assert bench.session.figures.strays == 1


def test_our_own_echo_is_no_answer_and_no_complaint() -> None:
    bench = Bench(1)
    bench.echo = True
    bench.settle()
    assert done(bench.do(WriteParameter(P1, RawValue(7)))) == Setting(P1, RawValue(7))
    assert bench.of(DriveLineGarbled) == []


def feed(bench: Bench, frame: Frame) -> list[DriveEvent]:
    bench.events += [(bench.now, event) for event in bench.session.events()]
    bench.session.received(encode(frame), Seconds(bench.now))
    return bench.session.events()


def test_what_answers_nothing_that_was_asked_is_named(bench: Bench) -> None:
    (stray,) = feed(bench, Frame(Role.SLAVE, 1, "ACK", ("2",)))
    assert stray == DriveLineGarbled(DriveLineId("L1"), "stray packet", "S1 ACK 2: it answers nothing that was asked")
    (stray,) = feed(bench, Frame(Role.MASTER, 1, "RUN"))
    assert stray == DriveLineGarbled(DriveLineId("L1"), "stray packet", "M1 RUN: another master is on the line")
    bench.ask(READ)
    for unfit in (("02", "0001"), ("01", "1")):
        assert len(feed(bench, Frame(Role.SLAVE, 1, "SET", unfit))) == 1
    assert len(feed(bench, Frame(Role.SLAVE, 2, "SET", ("01", "0001")))) == 1
    assert len(feed(bench, Frame(Role.SLAVE, 1, "ACK", ("2",)))) == 1
    assert len(feed(bench, Frame(Role.SLAVE, 1, "SSA", ("2", "0", "00")))) == 1


def test_an_answer_in_continued_packets_is_put_together(bench: Bench) -> None:
    request = bench.ask(READ)
    bench.session.received(encode(Frame(Role.SLAVE, 1, "SET", ("01",), more=True)), Seconds(bench.now))
    bench.session.received(encode(Frame(Role.SLAVE, 1, "SET", ("0042",))), Seconds(bench.now))
    bench.run(0.0)
    bench.events += [(bench.now, event) for event in bench.session.events()]
    assert done(bench.ended(request)) == Setting(P1, RawValue(42))


def test_an_answer_behind_a_broken_head_is_found_when_the_time_is_up(bench: Bench) -> None:
    request = bench.ask(READ)
    bench.drives[1].mischief.silent = True
    bench.session.received(b"\x02S1ZZZ@" + encode(Frame(Role.SLAVE, 1, "SET", ("01", "0042"))), Seconds(bench.now))
    bench.events += [(bench.now, event) for event in bench.session.events()]
    assert done(bench.ended(request)) == Setting(P1, RawValue(42))
    raw = Bench(1, dialect=DIALECTS["bcc-word"])
    raw.settle()
    request = raw.ask(READ)
    raw.drives[1].mischief.silent = True
    answer = encode(Frame(Role.SLAVE, 1, "ACK", ("2",)), raw.dialect)
    raw.session.received(b"\x02S1ZZZ@#" + answer[:4], Seconds(raw.now))
    raw.until(lambda: raw.end(request) is not None)
    assert raw.of(DriveLineGarbled)


def test_a_lost_line_ends_every_request_and_forgets_the_drives(bench: Bench) -> None:
    run = bench.ask(RUN)
    bench.until(lambda: bool(bench.commands(Cmd.RUN)))
    waiting = bench.ask(READ)
    bench.cut()
    bench.session.disconnected(Seconds(bench.now), "again")
    assert unknown(bench.ended(run)).reason == "the line is down: unplugged"
    assert failed(bench.ended(waiting)) == "the line is down: unplugged"
    assert bench.of(DriveLineDown) == [DriveLineDown(DriveLineId("L1"), "unplugged")]
    assert {view.online for view in bench.session.drives.values()} == {None}
    assert bench.session.deadline is None
    assert failed(bench.do(READ)) == "line L1 is down"
    bench.session.received(b"\x02", Seconds(bench.now))
    bench.session.tick(Seconds(bench.now))
    assert bench.session.outgoing() == b""
    bench.connect()
    bench.settle()
    assert done(bench.do(READ)) == Setting(P1, RawValue(0))


def test_a_jog_on_a_lost_line_is_unknown() -> None:
    bench = jogging()
    jog = bench.jog(Turn.CW, bench.now + 60.0)
    bench.run(0.5)
    bench.cut()
    assert unknown(bench.ended(jog)).reason == "the line is down: unplugged"
    bench.connect()
    bench.run(1.0)
    assert bench.session.drives[DriveId("D1")].online is True


def test_the_line_shows_its_last_packets_and_figures(bench: Bench) -> None:
    bench.do(READ)
    (_, first, question), (_, second, answer) = bench.session.last_frames[-2:]
    assert (first, question) == ("out", encode(Frame(Role.MASTER, 1, "SET", ("01",))))
    assert (second, answer) == ("in", encode(Frame(Role.SLAVE, 1, "SET", ("01", "0000"))))
    assert bench.session.figures.sent == bench.session.figures.answered
    assert not bench.session.wants_close


def test_the_limits_of_time_are_those_of_the_specification() -> None:
    timing = Timing()
    assert timing.answer(10) == pytest.approx(0.1 + 10 * 0.00105 + 26 * 0.00105 + 0.01)
    dead = 5 * timing.answer(10)
    assert dead == pytest.approx(0.68, abs=0.07)


def test_an_unknown_request_identity_changes_nothing(bench: Bench) -> None:
    assert not bench.session.keep_jogging(DriveRequestId(99), Seconds(1.0))
    bench.session.release_jog(DriveRequestId(99), Seconds(bench.now))
    bench.session.request(DriveRequest(DriveRequestId(99), DriveId("D1"), READ), Seconds(bench.now))
    bench.run(0.5)
    assert done(bench.ended(DriveRequestId(99))) == Setting(P1, RawValue(0))


def test_a_line_without_drives_waits_for_nothing() -> None:
    session = LineSession(DriveLineId("L"), [])
    session.connected(Seconds(0.0))
    assert session.deadline is None
    session.tick(Seconds(1.0))
    assert session.outgoing() == b""
