"""S41 to S50 with the real master, in virtual time on a 9600 baud line (PROTOCOLS section 8)."""

from itertools import pairwise

import pytest

from app.domain.drive import (
    DriveDone,
    DriveFailed,
    DriveMode,
    DriveOffline,
    DriveOnline,
    DriveReported,
    Hundredths,
    JogEnd,
    Key,
    Parameter,
    PressKey,
    RawValue,
    ReadParameter,
    Turn,
    WriteParameter,
)
from app.domain.units import Seconds
from app.protocols.hi.messages import Cmd, Mode
from app.protocols.hi.simulator import Options
from app.wire.faults import Fault
from tests.protocols.hi.rig import Bench, strike

RUN, STOP = PressKey(Key.RUN), PressKey(Key.STOP_RESET)


def ready(drives: int = 1, options: Options | None = None) -> Bench:
    bench = Bench(drives, options=options)
    bench.settle()
    return bench


def test_s41_run_is_done_in_monitoring() -> None:
    bench = ready()
    end = bench.do(RUN)
    assert isinstance(end, DriveDone)
    assert end.result is DriveMode.MONITORING
    assert bench.drives[1].state(Seconds(bench.now)).running


def test_s42_run_while_running_is_repeated_every_400_ms_at_most_ten_times() -> None:
    bench = ready()
    bench.do(RUN)
    bench.forget()
    end = bench.do(RUN)
    assert isinstance(end, DriveFailed)
    assert end.reason == "the drive is busy: BSY to RUN"
    times = bench.commands(Cmd.RUN)
    assert len(times) == 11
    assert all(0.4 <= after - before < 0.6 for before, after in pairwise(times))


def test_s43_parameters_and_status_are_read_while_it_runs() -> None:
    bench = ready()
    bench.do(RUN)
    assert isinstance(bench.do(ReadParameter(Parameter(1))), DriveDone)
    bench.run(4.0)
    distances = [event.status.distance for event in bench.of(DriveReported) if isinstance(event, DriveReported)]
    assert len(distances) >= 3
    assert distances == sorted(distances, key=lambda distance: distance or 0)


def test_s44_a_write_is_read_back_and_the_next_one_waits_until_the_first_is_stored() -> None:
    bench = ready()
    first = bench.ask(WriteParameter(Parameter(0x1C), RawValue(123)))
    second = bench.ask(WriteParameter(Parameter(0x1C), RawValue(124)))
    bench.until(lambda: bench.end(second) is not None)
    assert isinstance(bench.ended(first), DriveDone)
    assert isinstance(bench.ended(second), DriveDone)
    assert bench.drives[1].state(Seconds(bench.now)).values[0x1C] == 124
    assert len(bench.commands(Cmd.SED)) == 3, "the second met BSY once"
    assert len(bench.commands(Cmd.SET)) == 2


def test_s45_after_nak_it_is_sent_again_and_five_naks_are_an_alarm() -> None:
    bench = ready()
    strike(bench.out, Fault.CORRUPT, Cmd.SET)
    assert isinstance(bench.do(ReadParameter(Parameter(1))), DriveDone)
    bench.forget()
    bench.drives[1].mischief.naks = 5
    end = bench.do(ReadParameter(Parameter(1)))
    assert isinstance(end, DriveFailed)
    assert end.reason == "NAK to SET in 5 transmissions"
    assert bench.of(DriveOffline) == [DriveOffline(end.drive, end.reason)]  # type: ignore[arg-type]
    bench.until(lambda: bool(bench.of(DriveOnline)))


def test_s46_a_silent_drive_gets_five_transmissions_then_an_alarm_and_the_others_are_polled() -> None:
    bench = ready(3)
    bench.drives[2].mischief.silent = True
    bench.until(lambda: bool(bench.of(DriveOffline)))
    assert len(bench.commands(Cmd.SSQ, 2)) == 5
    assert len(bench.of(DriveOffline)) == 1
    bench.forget()
    bench.run(20.0)
    assert len(bench.commands(Cmd.SSQ, 1)) == pytest.approx(20, abs=2)
    assert len(bench.commands(Cmd.SSQ, 3)) == pytest.approx(20, abs=2)
    probes = bench.commands(Cmd.SSQ, 2)
    assert all(5.0 <= after - before < 5.5 for before, after in pairwise(probes))
    assert bench.of(DriveOffline) == []
    bench.drives[2].mischief.silent = False
    bench.until(lambda: bool(bench.of(DriveOnline)))


@pytest.mark.parametrize(("command", "delay"), [(STOP, 0.1), (WriteParameter(Parameter(1), RawValue(2)), 0.5)])
def test_s47_all_drives_at_once_are_not_awaited_but_given_time(
    command: PressKey | WriteParameter, delay: float
) -> None:
    bench = ready(2)
    end = bench.do(command, drive=None)
    assert isinstance(end, DriveDone)
    bench.run(0.1)
    first, second = bench.sent[:2]
    assert first[1][2:3] == b"0"
    assert second[0] - first[0] >= delay + len(first[1]) * 0.00104
    if isinstance(command, WriteParameter):
        assert [drive.state(Seconds(bench.now)).values[1] for drive in bench.drives.values()] == [2, 2]
        assert len(bench.commands(Cmd.SET)) == 2


def test_s48_a_jog_sends_the_key_every_50_ms_and_stops_when_the_caller_lets_go() -> None:
    bench = ready(2)
    bench.drives[1].panel_mode(Mode.JOG, Seconds(bench.now))
    jog = bench.jog(Turn.CW, bench.now + 60.0)
    bench.run(1.0)
    keys = bench.commands(Cmd.UPP)
    assert all(after - before == pytest.approx(0.05) for before, after in pairwise(keys))
    assert bench.commands(Cmd.SSQ, 2) == [], "while one drive jogs, no other can be polled"
    bench.session.release_jog(jog, Seconds(bench.now))
    bench.run(0.15)
    end = bench.ended(jog)
    assert isinstance(end, DriveDone)
    assert end.result is JogEnd.RELEASED
    assert len(bench.commands(Cmd.SRK)) == 1
    state = bench.drives[1].state(Seconds(bench.now))
    assert not state.jogging
    assert 900 <= state.distance <= 1100


def test_s48_a_jog_whose_caller_goes_away_ends_at_its_deadline() -> None:
    bench = ready()
    bench.drives[1].panel_mode(Mode.JOG, Seconds(bench.now))
    jog = bench.jog(Turn.CCW, bench.now + 0.3)
    bench.run(0.2)
    assert bench.session.keep_jogging(jog, Seconds(bench.now + 0.3))
    until = bench.now + 0.3
    bench.run(1.0)
    end = bench.ended(jog)
    assert isinstance(end, DriveDone)
    assert end.result is JogEnd.CALLER_GONE
    assert max(bench.commands(Cmd.DWN)) < until
    assert not bench.session.keep_jogging(jog, Seconds(bench.now + 0.3))


def test_s49_run_is_refused_in_error_and_stop_clears_it() -> None:
    bench = ready()
    bench.drives[1].fail(7, Seconds(bench.now))
    end = bench.do(RUN)
    assert isinstance(end, DriveFailed)
    assert end.reason == "the drive is in error 07 OL1"
    assert end.remedy == "press Stop/Reset once its cause is gone"
    assert bench.commands(Cmd.RUN) == [], "the status is looked at before anything moves"
    told = [event.status for event in bench.of(DriveReported) if isinstance(event, DriveReported)]
    assert (told[-1].mode, told[-1].code, told[-1].meaning) == (DriveMode.ERROR, 7, "OL1")
    cleared = bench.do(STOP)
    assert isinstance(cleared, DriveDone)
    assert cleared.result is DriveMode.PARAMETER_SELECT


@pytest.mark.parametrize("long_status", [True, False])
def test_s50_long_and_short_status_give_the_same_type(long_status: bool) -> None:
    bench = ready(options=Options(long_status=long_status))
    (view,) = bench.session.drives.values()
    assert view.status is not None
    assert view.status.mode is DriveMode.MONITORING
    assert view.status.distance == (Hundredths(0) if long_status else None)
    assert view.status.turn is (Turn.CW if long_status else None)
