"""Jogging and watching through the whole controller: an axis moves as long as somebody says so, and no longer."""

import pytest

from app.domain.device_requests import RaiseEmergency
from app.domain.drive import Key, Parameter, RawValue, Turn
from app.domain.drive_requests import (
    CancelDriveOperation,
    JogDrive,
    KeepDriveJog,
    LockDrive,
    PressDriveKey,
    ReadDrive,
    ReleaseDriveJog,
    StopDriveLine,
    UnwatchDrive,
    WatchDrive,
    WriteDrive,
)
from app.domain.errors import Refusal
from app.domain.records import EmergencyKind
from app.domain.requests import Accepted
from app.domain.units import Seconds
from app.protocols.hi.messages import Cmd
from tests.control.drive_bench import D1, D2, KIM, LEE, LINE, DriveBench

P = Parameter
ALL = tuple(P(number) for number in range(256))


@pytest.fixture
def bench() -> DriveBench:
    bench = DriveBench()
    bench.jog_mode(D1)
    bench.jog_mode(D2)
    return bench


def hold(bench: DriveBench, jog: int, seconds: float) -> None:
    """The caller says five times a second that the key is held."""
    for _ in range(round(seconds * 5)):
        assert isinstance(bench.tell(KeepDriveJog(jog)), Accepted)
        bench.run(0.2)


def test_an_axis_moves_while_the_key_is_held_and_stops_when_it_is_let_go(bench: DriveBench) -> None:
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    assert bench.operation(jog).result == {"hold": 0.5}
    hold(bench, jog, 3.0)
    assert bench.operation(jog).result["moving"] is True
    assert bench.view().moving is True
    assert len(bench.commands(Cmd.UPP, D1)) > 40
    assert isinstance(bench.tell(ReleaseDriveJog(jog)), Accepted)
    bench.until(lambda: bench.operation(jog).state == "done", within=0.3)
    assert bench.operation(jog).result["ended"] == "released"
    assert not bench.drives[D1].state(bench.now).jogging
    assert bench.view().moving is False
    assert bench.audits() == [("kim", "JogDrive", str(jog), True), ("kim", "JogEnd", "D1", True)]
    assert len(bench.operations(jog)) == 3


def test_an_axis_stops_by_itself_when_the_caller_goes_away(bench: DriveBench) -> None:
    jog = bench.begin(JogDrive(KIM, D1, Turn.CCW))
    hold(bench, jog, 1.0)
    gone = bench.now
    bench.run(2.0)
    assert max(bench.commands(Cmd.DWN, D1)) < gone + 0.5
    assert bench.operation(jog).result["ended"] == "caller gone"
    assert bench.commands(Cmd.SRK, D1)
    assert bench.audits()[-1] == ("hoistway", "JogEnd", "D1", True)
    late = bench.tell(KeepDriveJog(jog))
    assert isinstance(late, Refusal)
    assert late.reason == f"jog {jog} is over"


def test_keeping_a_jog_waits_for_no_disk_and_neither_does_letting_go(bench: DriveBench) -> None:
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    hold(bench, jog, 0.4)
    bench.durable = False
    hold(bench, jog, 2.0)
    assert bench.now - max(bench.commands(Cmd.UPP, D1)) < 0.1
    bench.tell(ReleaseDriveJog(jog))
    bench.run(0.3)
    assert not bench.drives[D1].state(bench.now).jogging
    assert bench.operation(jog).state == "running"
    bench.durable = True
    bench.run(0.1)
    assert bench.operation(jog).state == "done"


def test_a_jog_that_became_durable_too_late_never_moves(bench: DriveBench) -> None:
    bench.durable = False
    ticket = bench.control.ask(JogDrive(KIM, D1, Turn.CW), bench.now)
    bench.run(1.0)
    bench.durable = True
    bench.run(2.0)
    assert isinstance(bench.replies[ticket], Accepted)
    assert bench.commands(Cmd.UPP, D1) == []
    assert bench.operation(1).result["ended"] == "caller gone"


def test_a_jog_let_go_before_it_was_durable_never_begins(bench: DriveBench) -> None:
    bench.durable = False
    bench.control.ask(JogDrive(KIM, D1, Turn.CW), bench.now)
    bench.tell(ReleaseDriveJog(1))
    bench.durable = True
    bench.run(1.0)
    assert bench.commands(Cmd.UPP, D1) == []
    assert bench.operation(1).reason == "the key was let go before it could begin"
    assert bench.audits()[-1][1] == "JogEnd"


def test_a_jog_behind_a_busy_line_does_not_start_after_its_caller_has_gone(bench: DriveBench) -> None:
    bench.drives[D2].mischief.silent = True
    bench.begin(ReadDrive(KIM, D2, (P(0),)))
    bench.run(0.05)
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    bench.drives[D1].mischief.silent = True
    bench.run(0.6)
    bench.drives[D1].mischief.silent = False
    bench.until(lambda: bench.operation(jog).state != "running")
    assert not bench.drives[D1].state(bench.now).jogging
    assert bench.drives[D1].state(bench.now).distance == 0


def test_a_jog_goes_before_a_long_reading_and_the_reading_goes_on_afterwards(bench: DriveBench) -> None:
    reading = bench.begin(ReadDrive(LEE, D2, ALL))
    bench.run(1.0)
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    hold(bench, jog, 2.0)
    assert bench.drives[D1].state(bench.now).distance > 1500
    bench.tell(ReleaseDriveJog(jog))
    bench.until(lambda: bench.operation(reading).state == "done")


def test_one_axis_of_a_line_is_jogged_at_a_time_and_nothing_else_is_done_to_it(bench: DriveBench) -> None:
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    assert "kim jogs D1" in bench.refuse(JogDrive(LEE, D2, Turn.CW)).reason
    assert bench.refuse(JogDrive(LEE, D1, Turn.CCW)).reason == "kim is at D1: jog"
    assert bench.refuse(WriteDrive(LEE, D1, P(0x1C), RawValue(150))).reason == "kim is at D1: jog"
    assert "released, not cancelled" in bench.refuse(CancelDriveOperation(LEE, jog)).reason
    bench.run(1.0)
    assert bench.begin(JogDrive(LEE, D2, Turn.CW)) > jog


def test_a_drive_that_is_not_in_jog_mode_is_not_jogged() -> None:
    bench = DriveBench()
    refusal = bench.refuse(JogDrive(KIM, D1, Turn.CW))
    assert refusal.reason == "D1 is in mode monitoring, not in jog"
    assert "panel" in refusal.remedy
    bench.drives[D1].fail(2, bench.now)
    bench.until(lambda: bench.view().mode == "error")
    assert "02 OC: over-current" in bench.refuse(JogDrive(KIM, D1, Turn.CW)).reason


def test_the_mode_is_asked_again_before_the_first_key(bench: DriveBench) -> None:
    bench.drives[D1].state(bench.now).mode = 0  # type: ignore[assignment]
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    bench.until(lambda: bench.operation(jog).state != "running")
    assert bench.operation(jog).state == "failed"
    assert "not in jog" in bench.operation(jog).reason
    assert bench.commands(Cmd.UPP, D1) == []


@pytest.mark.parametrize("ends", ["stop", "stop all", "lockout", "fire", "error", "unplugged"])
def test_a_jog_ends_with_whatever_stops_its_axis(bench: DriveBench, ends: str) -> None:
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    hold(bench, jog, 1.0)
    match ends:
        case "stop":
            bench.begin(PressDriveKey(LEE, D1, Key.STOP_RESET))
        case "stop all":
            bench.begin(StopDriveLine(LEE, LINE))
        case "lockout":
            bench.ask(LockDrive(LEE, D1, "belt"))
        case "fire":
            bench.ask(RaiseEmergency(LEE, EmergencyKind.FIRE, "smoke"))
        case "error":
            bench.drives[D1].fail(7, bench.now)
        case _:
            bench.cut()
    bench.until(lambda: bench.operation(jog).state != "running", within=1.0)
    bench.run(0.2)
    assert not bench.drives[D1].state(bench.now).jogging
    assert isinstance(bench.tell(KeepDriveJog(jog)), Refusal)
    assert isinstance(bench.tell(ReleaseDriveJog(jog)), Refusal)


# -- watching ----------------------------------------------------------------------------------------------------------


def test_watched_parameters_are_polled_while_somebody_watches(bench: DriveBench) -> None:
    word = WatchDrive("page", D1, (P(0x1C), P(0x40)))
    assert isinstance(bench.tell(word), Accepted)
    assert bench.parameter(0x1C).watched is True
    bench.drives[D1].set_value(0x40, 7)
    bench.until(lambda: bench.parameter(0x40).raw == 7, within=1.0)
    bench.drives[D1].set_value(0x40, 8)
    bench.until(lambda: bench.parameter(0x40).raw == 8, within=1.0)
    assert bench.durable_values() == {}
    assert isinstance(bench.tell(UnwatchDrive("page")), Accepted)
    bench.run(0.3)
    assert bench.parameter(0x40).watched is False
    before = len(bench.commands(Cmd.SET))
    bench.run(5.0)
    assert len(bench.commands(Cmd.SET)) == before
    assert isinstance(bench.tell(UnwatchDrive("page")), Refusal)


def test_a_watch_with_a_time_ends_by_itself(bench: DriveBench) -> None:
    bench.tell(WatchDrive("curl", D1, (P(1),), Seconds(2.0)))
    bench.run(3.0)
    last = max(bench.commands(Cmd.SET))
    bench.run(5.0)
    assert max(bench.commands(Cmd.SET)) == last
    assert bench.parameter(1).watched is False


def test_watching_comes_after_what_people_ask_and_after_a_jog(bench: DriveBench) -> None:
    bench.tell(WatchDrive("page", D2, tuple(P(number) for number in range(16))))
    start = bench.now
    bench.do(ReadDrive(KIM, D1, ALL))
    assert len(bench.commands(Cmd.SET, D2)) <= (bench.now - start) * 1.5 + 20
    jog = bench.begin(JogDrive(KIM, D1, Turn.CW))
    bench.run(0.2)
    before = len(bench.commands(Cmd.SET))
    hold(bench, jog, 2.0)
    assert len(bench.commands(Cmd.SET)) == before


def test_every_watched_parameter_has_its_turn_on_a_line_that_is_polled_too(bench: DriveBench) -> None:
    numbers = tuple(P(number) for number in range(16))
    bench.tell(WatchDrive("a", D1, numbers))
    bench.tell(WatchDrive("b", D2, numbers[:4]))
    bench.run(4.0)
    assert all(bench.parameter(number, D1).raw is not None for number in numbers)
    assert all(bench.parameter(number, D2).raw is not None for number in numbers[:4])
    assert len(bench.commands(Cmd.SSQ, D1)) >= 3


def test_a_watch_waits_for_a_drive_that_is_offline(bench: DriveBench) -> None:
    bench.drives[D1].mischief.silent = True
    bench.until(lambda: bench.view().online is False)
    bench.tell(WatchDrive("a", D1, (P(3),)))
    before = len(bench.commands(Cmd.SET))
    bench.run(4.0)
    assert len(bench.commands(Cmd.SET)) == before
    bench.drives[D1].mischief.silent = False
    bench.until(lambda: bench.parameter(3).raw == 0, within=20.0)


def test_what_cannot_be_watched_is_refused(bench: DriveBench) -> None:
    for word in (WatchDrive("a", D1, ()), WatchDrive("a", D1, ALL[:17])):
        reply = bench.tell(word)
        assert isinstance(reply, Refusal)
        assert reply.field == "parameters"
    missing = bench.tell(WatchDrive("a", type(D1)("D9"), (P(1),)))
    assert isinstance(missing, Refusal)
    assert missing.code == "not-found"
    for number in range(64):
        assert isinstance(bench.tell(WatchDrive(str(number), D1, (P(1),))), Accepted)
    assert isinstance(bench.tell(WatchDrive("64", D1, (P(1),))), Refusal)
