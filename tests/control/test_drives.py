"""What people do with drives, through the whole controller: each ends in one visible, durable way."""

from dataclasses import replace

import pytest

from app.domain.device_requests import RaiseEmergency, ReleaseEmergency
from app.domain.drive import DriveId, Key, Parameter, RawValue, SetInputs
from app.domain.drive_requests import (
    AskDriveStatus,
    BackUpDrive,
    CancelDriveOperation,
    CompareDrive,
    DriveOrder,
    LockDrive,
    PressDriveKey,
    ReadDrive,
    RestoreDrive,
    SetDriveInputs,
    StopDriveLine,
    UnlockDrive,
    Values,
    WriteDrive,
)
from app.domain.errors import Refusal
from app.domain.ids import LinkId
from app.domain.records import EmergencyKind
from app.domain.requests import Accepted
from app.domain.units import Seconds
from app.protocols.hi.messages import Cmd, Mode
from app.protocols.hi.simulator import Options
from app.wire.faults import Fault
from tests.control.drive_bench import D1, D2, KIM, LEE, LINE, PAK, DriveBench, drive_plant
from tests.protocols.hi.rig import strike

P = Parameter
ALL = tuple(P(number) for number in range(256))


@pytest.fixture
def bench() -> DriveBench:
    return DriveBench()


def write(raw: int, number: int = 0x1C, **more: object) -> WriteDrive:
    return WriteDrive(KIM, D1, P(number), RawValue(raw), **more)  # type: ignore[arg-type]


# -- status, keys, inputs ----------------------------------------------------------------------------------------------


def test_the_status_of_a_drive_is_shown_with_what_its_error_means_and_what_helps(bench: DriveBench) -> None:
    bench.drives[D1].fail(7, bench.now)
    bench.until(lambda: bench.view().mode == "error")
    view = bench.view()
    assert (view.code, view.meaning, view.error) == (7, "OL1", "overload")
    assert "Stop/Reset" in view.remedy
    assert bench.events()[-1] == ("DriveErrorSet", f"07 OL1: {view.error}; {view.remedy}")
    assert bench.do(PressDriveKey(KIM, D1, Key.STOP_RESET)).state == "done"
    bench.until(lambda: bench.view().mode == "parameter_select")
    assert (bench.view().error, bench.view().remedy) == ("", "")
    assert bench.events()[-1] == ("DriveErrorCleared", "07")


def test_asking_for_the_status_gives_it(bench: DriveBench) -> None:
    done = bench.do(AskDriveStatus(KIM, D1))
    assert (done.state, done.result) == ("done", {"mode": "monitoring", "code": 0, "meaning": "normal"})


def test_a_drive_in_error_is_not_told_to_move(bench: DriveBench) -> None:
    bench.drives[D1].fail(3, bench.now)
    bench.until(lambda: bench.view().mode == "error")
    for request in (PressDriveKey(KIM, D1, Key.RUN), SetDriveInputs(KIM, D1, SetInputs(run=True))):
        refusal = bench.refuse(request)
        assert "03 OH: overheated" in refusal.reason
        assert "Stop/Reset" in refusal.remedy
    assert not bench.commands(Cmd.RUN)
    assert bench.do(SetDriveInputs(KIM, D1, SetInputs(left_limit=True))).state == "done"


def test_run_moves_the_axis_and_stop_ends_it_and_both_are_shown(bench: DriveBench) -> None:
    assert bench.view().moving is False
    done = bench.do(PressDriveKey(KIM, D1, Key.RUN))
    assert (done.state, done.result) == ("done", {"mode": "monitoring"})
    assert bench.view().moving is True
    bench.run(10.0)
    assert bench.view().moving is True
    bench.do(PressDriveKey(KIM, D1, Key.STOP_RESET))
    assert bench.view().moving is False
    bench.run(5.0)
    assert bench.view().moving is False


def test_an_axis_that_came_to_rest_by_itself_is_seen_to_stand(bench: DriveBench) -> None:
    bench.do(SetDriveInputs(KIM, D1, SetInputs(home=True)))
    assert bench.view().moving is True
    bench.until(lambda: bench.view().moving is False, within=10.0)


def test_standing_still_is_seen_even_if_something_else_happens_at_that_very_moment(bench: DriveBench) -> None:
    bench.do(PressDriveKey(KIM, D1, Key.RUN))
    bench.drives[D1].state(bench.now).stop()
    bench.until(lambda: bench.now >= bench.control.fleet.drives.all[D1].moves_until - 0.05)
    bench.drives[D1].mischief.silent = bench.drives[D2].mischief.silent = True
    bench.now = Seconds(bench.control.fleet.drives.all[D1].moves_until + 0.001)
    bench.ask(AskDriveStatus(KIM, D2))
    bench.run(0.01)
    assert bench.view().moving is False


def test_of_a_drive_with_the_short_status_only_what_it_was_told_is_known() -> None:
    bench = DriveBench(options=Options(long_status=False))
    assert bench.view().moving is None
    bench.do(PressDriveKey(KIM, D1, Key.RUN))
    bench.run(20.0)
    assert bench.view().moving is True
    assert bench.refuse(write(150)).reason.startswith("D1 is running")
    bench.do(PressDriveKey(KIM, D1, Key.STOP_RESET))
    assert bench.view().moving is None
    assert bench.do(write(150)).state == "done"


def test_all_drives_of_a_line_are_stopped_at_once(bench: DriveBench) -> None:
    for drive in (D1, D2):
        bench.do(PressDriveKey(KIM, drive, Key.RUN))
    done = bench.do(StopDriveLine(KIM, LINE))
    assert (done.kind, done.state, done.drive, done.line) == ("stop_all", "done", None, LINE)
    assert not any(drive.state(bench.now).running for drive in bench.drives.values())
    assert [bench.view(drive).moving for drive in (D1, D2)] == [False, False]
    assert bench.refuse(StopDriveLine(KIM, LinkId("nope"))).code == "not-found"


# -- reading -----------------------------------------------------------------------------------------------------------


def test_one_parameter_is_read_kept_and_shown_with_its_unit(bench: DriveBench) -> None:
    assert (bench.parameter(0x1C).raw, bench.parameter(0x1C).name) == (None, "Acceleration")
    bench.drives[D1].set_value(0x1C, 150)
    done = bench.do(ReadDrive(KIM, D1, (P(0x1C),)))
    assert (done.state, done.result["values"]) == ("done", {"1C": 150})
    view = bench.parameter(0x1C)
    assert (view.raw, view.value, view.text, view.unit) == (150, 1.5, "1.50 s", "s")
    assert (view.lowest, view.highest, view.default) == (0.1, 60.0, 1.5)
    assert bench.durable_values()[D1, 0x1C] == 150
    bench.restart()
    assert bench.parameter(0x1C).raw == 150


def test_all_256_are_read_with_progress_that_people_see(bench: DriveBench) -> None:
    for number in range(256):
        bench.drives[D1].set_value(number, number * 3)
    number = bench.begin(ReadDrive(KIM, D1, ALL))
    seen = set()
    while bench.operation(number).state == "running":
        seen.add(bench.operation(number).done)
        bench.run(0.1)
    done = bench.operation(number)
    assert (done.done, done.total, done.body) == (256, 256, {"parameters": "all"})
    assert done.result["values"] == {f"{n:02X}": 3 * n for n in range(256)}
    assert len(seen) > 50
    assert len(bench.durable_values()) == 256
    assert len(bench.operations(number)) == 2


def test_all_256_are_read_over_a_line_with_noise_losses_and_doubled_bytes(bench: DriveBench) -> None:
    for number in range(256):
        bench.drives[D1].set_value(number, 1000 + number)
    bad = {Fault.DROP: 0.05, Fault.NOISE: 0.1, Fault.SPLIT: 0.2}
    bench.out.lane.rates, bench.back.lane.rates = bad, bad | {Fault.DUPLICATE: 0.1, Fault.MERGE: 0.05}
    bench.echo = True
    done = bench.do(ReadDrive(KIM, D1, ALL), within=400.0)
    assert done.state == "done", done.reason
    assert done.result["values"] == {f"{n:02X}": 1000 + n for n in range(256)}
    (line,) = bench.control.links()
    assert line.figures["garbled"] > 0
    assert line.figures["timeouts"] > 0
    assert line.figures["answered"] >= 256


def test_reading_gives_up_on_a_drive_that_has_gone_and_says_so(bench: DriveBench) -> None:
    number = bench.begin(ReadDrive(KIM, D1, ALL))
    bench.until(lambda: bench.operation(number).done >= 10)
    bench.drives[D1].mischief.silent = True
    bench.until(lambda: bench.operation(number).state == "failed")
    done = bench.operation(number)
    assert done.reason == "D1 went offline: no answer to SET in 5 transmissions"
    assert done.remedy
    assert ("DriveOffline", "no answer to SET in 5 transmissions") in bench.events()
    assert bench.view().online is False
    assert bench.refuse(ReadDrive(KIM, D1, (P(0),))).reason.startswith("D1 is offline: no answer")
    bench.drives[D1].mischief.silent = False
    bench.until(lambda: bench.view().online is True, within=20.0)
    assert bench.events()[-1] == ("DriveOnline", "D1 answers again")
    assert bench.do(ReadDrive(KIM, D1, (P(0),))).state == "done"


def test_nothing_can_be_asked_of_a_line_that_is_not_connected_and_the_refusal_says_where_to_look() -> None:
    bench = DriveBench(connect=False)
    refusal = bench.refuse(AskDriveStatus(KIM, D1))
    assert refusal.reason == "line AXES of D1 is not connected: not connected yet"
    assert "links/AXES" in refusal.remedy
    (line,) = bench.control.links()
    assert (line.id, line.up, line.since, line.devices) == ("AXES", False, None, ("D1", "D2"))
    bench.connect()
    bench.run(1.0)
    bench.cut()
    (line,) = bench.control.links()
    assert (line.up, line.reason, line.since) == (False, "unplugged", 1_000_000_001.0)
    assert bench.view().online is None
    assert "unplugged" in bench.view().reason


def test_an_operation_of_a_line_that_is_unplugged_ends_and_another_goes_on_when_it_is_back(bench: DriveBench) -> None:
    number = bench.begin(ReadDrive(KIM, D1, ALL))
    bench.run(1.0)
    bench.cut()
    assert bench.operation(number).state == "failed"
    assert "the line is down: unplugged" in bench.operation(number).reason
    bench.run(3.0)
    bench.connect()
    bench.until(lambda: bench.view().online is True)
    assert bench.do(ReadDrive(KIM, D1, ALL)).state == "done"


def test_unknown_drives_are_not_found(bench: DriveBench) -> None:
    assert bench.refuse(ReadDrive(KIM, DriveId("D9"), (P(0),))) == Refusal(
        "not-found", "there is no drive D9", "see GET /api/v1/drives"
    )


def test_only_so_many_operations_of_a_drive_are_under_way(bench: DriveBench) -> None:
    for _ in range(8):
        bench.begin(ReadDrive(KIM, D1, ALL))
    assert "8 operations of D1 are under way" in bench.refuse(ReadDrive(KIM, D1, (P(0),))).reason
    assert bench.do(ReadDrive(KIM, D2, (P(0),))).state == "done"


def test_an_operation_can_be_cancelled(bench: DriveBench) -> None:
    number = bench.begin(ReadDrive(KIM, D1, ALL))
    bench.run(1.0)
    assert isinstance(bench.ask(CancelDriveOperation(LEE, number)), Accepted)
    bench.until(lambda: bench.operation(number).state == "failed", within=1.0)
    assert bench.operation(number).reason == "cancelled by lee"
    assert 0 < bench.operation(number).done < 60
    assert bench.refuse(CancelDriveOperation(LEE, number)).code == "not-now"


# -- writing -----------------------------------------------------------------------------------------------------------


def test_a_write_is_read_back_and_what_was_before_is_in_the_history(bench: DriveBench) -> None:
    bench.drives[D1].set_value(0x1C, 100)
    done = bench.do(write(150))
    assert (done.state, done.result) == ("done", {"before": 100, "after": 150})
    assert done.body == {"parameter": "1C", "name": "Acceleration", "raw": 150, "value": 1.5}
    assert bench.values()[0x1C] == 150
    assert ("DriveParameterWritten", "1C (Acceleration): 0100 (1.00 s) -> 0150 (1.50 s), by kim") in bench.events()
    assert ("kim", "WriteDrive", str(done.id), True) in bench.audits()
    assert bench.durable_values()[D1, 0x1C] == 150


def test_a_value_is_written_in_the_unit_of_the_catalogue(bench: DriveBench) -> None:
    assert bench.do(WriteDrive(KIM, D1, P(0x1C), value=2.35)).state == "done"
    assert bench.values()[0x1C] == 235


def test_what_a_write_will_do_is_durable_before_it_leaves(bench: DriveBench) -> None:
    number = bench.begin(write(150))
    bench.until(lambda: bool(bench.operations(number)[-1].result))
    assert bench.operations(number)[-1].result == {"before": 0}
    bench.durable = False
    before = len(bench.commands(Cmd.SED))
    bench.run(1.0)
    assert before <= 1
    other = DriveBench()
    number = other.begin(write(150))
    other.durable = False
    other.run(2.0)
    assert other.commands(Cmd.SED) == []
    assert other.values()[0x1C] == 0
    other.durable = True
    other.until(lambda: other.operation(number).state == "done")
    assert other.values()[0x1C] == 150


@pytest.mark.parametrize(
    ("request_", "says", "field"),
    [
        (write(5), "1C (Acceleration) is 0.10 s to 60.00 s (raw 10 to 6000), not 0.05 s (raw 5)", "raw"),
        (WriteDrive(KIM, D1, P(0x1C), value=99.0), "is 0.10 s to 60.00 s", "value"),
        (WriteDrive(KIM, D1, P(0x1C), value=1.505), "goes in steps of 0.01 s: 1.505 is none of them", "value"),
        (write(1, 0xF0), "F0 (Version) is read-only", "parameter"),
        (write(1, 0x99), "99 of D1 is not in catalogue HI-1", "raw_access"),
        (write(1, 0x99, raw_access=True, value=None), "", ""),
        (WriteDrive(KIM, D1, P(0x99), value=1.0, raw_access=True), "it has a raw value alone", "value"),
    ],
)
def test_a_write_that_cannot_be_is_refused_with_range_and_unit(
    bench: DriveBench, request_: DriveOrder, says: str, field: str
) -> None:
    reply = bench.ask(request_)
    if not says:
        assert isinstance(reply, Accepted)
        return
    assert isinstance(reply, Refusal)
    assert says in reply.reason
    assert (reply.code, reply.field) == ("invalid", field)
    assert reply.remedy
    bench.run(1.0)
    assert bench.commands(Cmd.SED) == []


def test_without_a_catalogue_there_is_raw_access_alone() -> None:
    bench = DriveBench(drive_plant(model=""))
    assert "D1 is in no catalogue" in bench.refuse(write(1)).reason
    assert bench.do(write(9999, raw_access=True)).state == "done"
    assert bench.values()[0x1C] == 9999
    assert bench.parameter(0x1C).named is False


def test_a_running_drive_is_not_written_unless_its_catalogue_allows_it(bench: DriveBench) -> None:
    bench.do(PressDriveKey(KIM, D1, Key.RUN))
    refusal = bench.refuse(write(150))
    assert refusal.reason == "D1 is running, and parameter 1C (Acceleration) may not be written while it runs"
    assert "stop_reset" in refusal.remedy
    assert bench.do(write(50, 0x1D)).state == "done"
    bench.do(PressDriveKey(KIM, D1, Key.STOP_RESET))
    assert bench.do(write(150)).state == "done"


def test_a_drive_that_somebody_starts_at_its_panel_is_seen_to_run_before_it_is_written(bench: DriveBench) -> None:
    bench.run(3.0)
    assert bench.view().moving is False
    bench.drives[D1].state(bench.now).start(0, jog=False)
    done = bench.do(write(150))
    assert done.state == "failed"
    assert "D1 is running" in done.reason
    assert bench.values()[0x1C] == 0


def test_a_write_is_refused_if_the_value_is_not_what_the_writer_saw(bench: DriveBench) -> None:
    bench.do(ReadDrive(KIM, D1, (P(0x1C),)))
    assert bench.refuse(write(150, expected=RawValue(7))).code == "stale"
    bench.drives[D1].set_value(0x1C, 44)
    done = bench.do(write(150, expected=RawValue(0)))
    assert done.state == "failed"
    assert "is 0044 (0.44 s), not 0000 as you saw it" in done.reason
    assert bench.values()[0x1C] == 44
    assert bench.do(write(150, expected=RawValue(44))).state == "done"


def test_a_write_that_the_drive_does_not_take_fails_with_what_it_has_still(bench: DriveBench) -> None:
    drive = bench.drives[D1]
    number = bench.begin(write(150))
    bench.until(lambda: bool(bench.commands(Cmd.SED)))
    bench.until(lambda: drive.state(bench.now).values[0x1C] == 150)
    drive.set_value(0x1C, 0)
    bench.until(lambda: bench.operation(number).state != "running")
    done = bench.operation(number)
    assert done.state == "failed"
    assert "has still 0000 (0.00 s)" in done.reason
    assert done.remedy


def test_answers_to_a_write_may_be_lost_and_what_the_drive_says_decides(bench: DriveBench) -> None:
    for _ in range(4):
        strike(bench.back, Fault.DROP, Cmd.ACK)
    done = bench.do(write(150))
    assert (done.state, done.result["after"]) == ("done", 150)
    strike(bench.back, Fault.DROP, Cmd.ACK, times=5)
    number = bench.begin(write(160))
    bench.until(lambda: bench.view().online is False)
    assert bench.operation(number).state == "running"
    bench.until(lambda: bench.operation(number).state != "running")
    assert (bench.operation(number).state, bench.operation(number).result["after"]) == ("done", 160)
    assert bench.events()[-2][0] == "DriveOnline"


def test_a_write_in_which_the_cable_is_pulled_is_settled_by_reading_when_it_is_back(bench: DriveBench) -> None:
    number = bench.begin(write(160))
    bench.until(lambda: bool(bench.commands(Cmd.SED)))
    bench.run(0.02)
    bench.cut()
    bench.run(5.0)
    assert bench.operation(number).state == "running"
    bench.connect()
    bench.until(lambda: bench.operation(number).state != "running")
    assert (bench.operation(number).state, bench.operation(number).result["after"]) == ("done", 160)
    assert len(bench.commands(Cmd.SED)) == 1


def test_a_drive_that_refuses_a_number_it_does_not_have_is_read_on(bench: DriveBench) -> None:
    for number in (2, 3):
        bench.hole(number)
    done = bench.do(ReadDrive(KIM, D1, tuple(P(number) for number in range(6))))
    assert done.state == "failed"
    assert done.reason == "2 of 6 parameters gave no value: 02, 03"
    assert sorted(done.result["values"]) == ["00", "01", "04", "05"]  # type: ignore[call-overload]
    backup = bench.do(BackUpDrive(KIM, D1))
    assert backup.state == "done"
    assert bench.backups()[-1].values[:5] == (0, 0, None, None, 0)


def test_a_reading_that_waits_for_its_drive_can_be_cancelled(bench: DriveBench) -> None:
    number = bench.begin(ReadDrive(KIM, D1, ALL))
    bench.drives[D1].mischief.silent = True
    bench.until(lambda: bench.view().online is False)
    bench.ask(CancelDriveOperation(LEE, number))
    assert bench.operation(number).reason == "cancelled by lee"
    bench.drives[D1].mischief.silent = False
    bench.run(10.0)
    assert bench.operation(number).state == "failed"


def test_a_write_of_which_nothing_is_heard_again_is_unknown_not_failed(bench: DriveBench) -> None:
    number = bench.begin(write(150))
    bench.until(lambda: bool(bench.commands(Cmd.SED)))
    bench.drives[D1].mischief.silent = True
    bench.until(lambda: bench.operation(number).state != "running")
    assert bench.operation(number).state == "unknown"
    assert bench.operations(number)[-1].state.value == "unknown"


def test_the_same_value_again_is_not_written(bench: DriveBench) -> None:
    bench.drives[D1].set_value(0x1C, 150)
    done = bench.do(write(150))
    assert (done.state, done.result) == ("done", {"before": 150, "after": 150})
    assert bench.commands(Cmd.SED) == []
    assert "DriveParameterWritten" not in [name for name, _ in bench.events()]


def test_one_change_at_a_time_on_a_drive(bench: DriveBench) -> None:
    number = bench.begin(write(150))
    refusal = bench.refuse(replace(write(160), actor=LEE))
    assert (refusal.reason, refusal.remedy) == ("kim is at D1: write", f"wait for operation {number}, or cancel it")
    assert bench.view().operation == str(number)
    bench.until(lambda: bench.operation(number).state == "done")
    assert bench.view().operation is None


# -- backups -----------------------------------------------------------------------------------------------------------


def values_of(bench: DriveBench) -> Values:
    found = bench.backups()[-1].values
    return tuple((P(number), value) for number, value in enumerate(found) if value is not None)


def backed_up(bench: DriveBench) -> Values:
    for number in range(256):
        bench.drives[D1].set_value(number, 100 + number % 50)
    done = bench.do(BackUpDrive(KIM, D1, "before tuning"))
    assert (done.state, done.result["backup"]) == ("done", int(done.id))
    backup = bench.backups()[-1]
    assert (backup.drive, backup.model, backup.note, backup.actor) == (D1, "HI-1", "before tuning", KIM)
    assert backup.values == tuple(100 + number % 50 for number in range(256))
    return values_of(bench)


def test_a_backup_is_compared_and_restored(bench: DriveBench) -> None:
    values = backed_up(bench)
    bench.drives[D1].set_value(0x1C, 777)
    bench.drives[D1].set_value(0x88, 1)
    compared = bench.do(CompareDrive(LEE, D1, "backup 1", values))
    assert compared.state == "done"
    rows = compared.result["differences"]
    assert isinstance(rows, list)
    assert [(row["parameter"], row["here"], row["there"]) for row in rows] == [("1C", 777, 128), ("88", 1, 136)]
    assert (rows[0]["name"], rows[0]["here_text"]) == ("Acceleration", "0777 (7.77 s)")

    dry = bench.do(RestoreDrive(LEE, D1, "backup 1", "HI-1", values, dry_run=True))
    assert dry.state == "done"
    assert [row["fate"] for row in dry.result["rows"]] == ["write", "write"]  # type: ignore[attr-defined]
    assert bench.values()[0x1C] == 777

    real = bench.do(RestoreDrive(LEE, D1, "backup 1", "HI-1", values))
    assert real.state == "done", real.reason
    assert [row["fate"] for row in real.result["rows"]] == ["written", "written"]  # type: ignore[attr-defined]
    assert (bench.values()[0x1C], bench.values()[0x88]) == (128, 136)
    assert (real.done, real.total) == (258, 258)
    again = bench.do(CompareDrive(LEE, D1, "backup 1", values))
    assert again.result["differences"] == []
    written = [detail for name, detail in bench.events() if name == "DriveParameterWritten"]
    assert len(written) == 2
    assert written[1] == "88: 0001 -> 0136, by lee"


def test_a_restore_skips_what_is_read_only_or_out_of_range_and_says_so(bench: DriveBench) -> None:
    values = ((P(0x1C), RawValue(5)), (P(0x1D), RawValue(7)), (P(0xF0), RawValue(9)))
    done = bench.do(RestoreDrive(KIM, D1, "a file", "HI-1", values))
    fates = {row["parameter"]: row["fate"] for row in done.result["rows"]}  # type: ignore[attr-defined]
    assert fates == {
        "1C": "skip: not 0.10 s to 60.00 s (raw 10 to 6000)",
        "1D": "written",
        "F0": "skip: read-only",
    }
    assert (bench.values()[0x1C], bench.values()[0x1D], bench.values()[0xF0]) == (0, 7, 0)


def test_a_restore_over_a_bad_line_leaves_the_drive_as_the_backup_says(bench: DriveBench) -> None:
    values = backed_up(bench)
    for number in range(20):
        bench.drives[D1].set_value(number, 1)
    bad = {Fault.DROP: 0.04, Fault.NOISE: 0.05, Fault.SPLIT: 0.1}
    bench.out.lane.rates, bench.back.lane.rates = bad, bad | {Fault.DUPLICATE: 0.05}
    done = bench.do(RestoreDrive(KIM, D1, "backup", "HI-1", values), within=900.0)
    assert done.state == "done", done.reason
    assert bench.values() == [value for _, value in values]


def test_a_restore_that_is_cut_off_ends_visibly_and_what_was_written_is_known(bench: DriveBench) -> None:
    values = backed_up(bench)
    for number in range(20):
        bench.drives[D1].set_value(number, 1)
    number = bench.begin(RestoreDrive(KIM, D1, "backup", "HI-1", values))
    bench.until(lambda: bench.operation(number).done > 260)
    bench.ask(CancelDriveOperation(LEE, number))
    bench.until(lambda: bench.operation(number).state == "failed")
    fates = [row["fate"] for row in bench.operation(number).result["rows"]]  # type: ignore[attr-defined]
    wrote = sum(before != 1 for before in bench.values()[:20])
    assert fates.count("written") == wrote
    assert 0 < wrote < 19


def test_a_restart_in_the_middle_of_a_restore_is_unknown_and_of_a_reading_failed(bench: DriveBench) -> None:
    values = backed_up(bench)
    bench.drives[D1].set_value(9, 1)
    restore = bench.begin(RestoreDrive(KIM, D1, "backup", "HI-1", values))
    bench.until(lambda: bool(bench.commands(Cmd.SED)))
    reading = bench.begin(ReadDrive(KIM, D2, ALL))
    bench.restart()
    assert (bench.operation(restore).state, bench.operation(reading).state) == ("unknown", "failed")
    assert "started again" in bench.operation(restore).reason
    assert bench.operation(restore).remedy
    assert bench.begin(ReadDrive(KIM, D2, (P(0),))) > reading


def test_after_a_restart_in_the_middle_of_a_write_the_drive_itself_is_asked(bench: DriveBench) -> None:
    early = bench.begin(write(150))
    bench.restart()
    assert bench.operation(early).state == "failed"
    assert "before anything was written" in bench.operation(early).reason
    bench.until(lambda: bench.view().online is True)
    number = bench.begin(write(150))
    bench.until(lambda: bool(bench.commands(Cmd.SED)))
    bench.run(0.02)
    bench.restart()
    assert bench.operation(number).state == "unknown"
    bench.until(lambda: bench.parameter(0x1C).raw == 150)
    looked = bench.operation(number + 1)
    assert (looked.kind, looked.actor, looked.result["values"]) == ("read", "hoistway", {"1C": 150})
    assert len(bench.commands(Cmd.SED)) == 1


def test_two_drives_are_compared(bench: DriveBench) -> None:
    bench.drives[D2].set_value(0x1C, 9)
    done = bench.do(CompareDrive(KIM, D1, "D2", other=D2))
    rows = done.result["differences"]
    assert isinstance(rows, list)
    assert [(row["parameter"], row["here"], row["there"]) for row in rows] == [("1C", 0, 9)]
    assert (done.done, done.total) == (512, 512)
    assert bench.refuse(CompareDrive(KIM, D1, "D1", other=D1)).field == "drive"
    assert bench.refuse(CompareDrive(KIM, D1, "D9", other=DriveId("D9"))).code == "not-found"


def test_a_backup_of_another_model_is_not_restored(bench: DriveBench) -> None:
    refusal = bench.refuse(RestoreDrive(KIM, D1, "backup 4", "HI-2", ((P(0), RawValue(1)),)))
    assert refusal.reason == "backup 4 is of HI-2, D1 is HI-1"


# -- lockouts ----------------------------------------------------------------------------------------------------------


def test_a_lockout_lets_through_status_and_stop_alone_and_stops_a_running_axis(bench: DriveBench) -> None:
    bench.do(PressDriveKey(KIM, D1, Key.RUN))
    assert isinstance(bench.ask(LockDrive(LEE, D1, "belt")), Accepted)
    bench.until(lambda: not bench.drives[D1].state(bench.now).running, within=1.0)
    lock = bench.view().lockout
    assert lock is not None
    assert (lock.owner, lock.reason) == ("lee", "belt")
    for request in (
        PressDriveKey(KIM, D1, Key.RUN),
        write(150),
        SetDriveInputs(KIM, D1, SetInputs(run=True)),
        ReadDrive(KIM, D1, (P(0),)),
        BackUpDrive(KIM, D1),
    ):
        assert bench.refuse(request).reason == "D1 is locked out by lee: belt"
    assert bench.do(AskDriveStatus(KIM, D1)).state == "done"
    assert bench.do(PressDriveKey(KIM, D1, Key.STOP_RESET)).state == "done"
    bench.restart()
    assert bench.view().lockout is not None
    assert bench.refuse(LockDrive(KIM, D1, "x")).code == "conflict"


def test_a_lockout_is_lifted_by_its_owner_or_by_two_others_together(bench: DriveBench) -> None:
    bench.ask(LockDrive(LEE, D1, "belt"))
    assert "your wish to lift it is noted" in bench.refuse(UnlockDrive(KIM, D1)).reason
    assert bench.refuse(UnlockDrive(KIM, D1)).code == "not-now"
    assert isinstance(bench.ask(UnlockDrive(PAK, D1)), Accepted)
    assert bench.view().lockout is None
    bench.ask(LockDrive(LEE, D1, "belt"))
    assert isinstance(bench.ask(UnlockDrive(LEE, D1)), Accepted)
    assert bench.refuse(UnlockDrive(LEE, D1)).code == "conflict"


def test_a_lockout_ends_a_restore_before_its_next_write(bench: DriveBench) -> None:
    values = backed_up(bench)
    for number in range(20):
        bench.drives[D1].set_value(number, 1)
    number = bench.begin(RestoreDrive(KIM, D1, "backup", "HI-1", values))
    bench.until(lambda: bench.operation(number).done > 258)
    bench.ask(LockDrive(LEE, D1, "belt"))
    wrote = bench.values().copy()
    bench.until(lambda: bench.operation(number).state != "running")
    assert bench.operation(number).reason == "D1 was locked out by lee"
    bench.run(5.0)
    assert sum(one != other for one, other in zip(wrote, bench.values(), strict=True)) <= 1


def test_a_fire_stops_a_running_axis_and_none_is_set_moving_before_it_is_released(bench: DriveBench) -> None:
    bench.do(PressDriveKey(KIM, D1, Key.RUN))
    assert isinstance(bench.ask(RaiseEmergency(LEE, EmergencyKind.FIRE, "smoke")), Accepted)
    bench.until(lambda: not bench.drives[D1].state(bench.now).running, within=1.0)
    bench.run(0.5)
    for request in (PressDriveKey(KIM, D1, Key.RUN), SetDriveInputs(KIM, D1, SetInputs(run=True))):
        assert bench.refuse(request).reason == "nothing moves: fire"
    assert bench.do(ReadDrive(KIM, D1, (P(0),))).state == "done"
    bench.ask(ReleaseEmergency(LEE, EmergencyKind.FIRE, "over"))
    assert bench.do(PressDriveKey(KIM, D1, Key.RUN)).state == "done"


def test_every_change_asked_for_has_one_audit_row_and_refusals_too(bench: DriveBench) -> None:
    bench.do(write(150))
    bench.refuse(write(1))
    assert [(actor, action, accepted) for actor, action, _, accepted in bench.audits()] == [
        ("kim", "WriteDrive", True),
        ("kim", "WriteDrive", False),
    ]


def test_a_stop_goes_before_what_waits_and_ends_what_is_being_done(bench: DriveBench) -> None:
    values = backed_up(bench)
    for number in range(20):
        bench.drives[D1].set_value(number, 1)
    number = bench.begin(RestoreDrive(KIM, D1, "backup", "HI-1", values))
    bench.until(lambda: bench.operation(number).done > 258)
    stop = bench.begin(PressDriveKey(LEE, D1, Key.STOP_RESET))
    bench.until(lambda: bench.operation(stop).state == "done", within=1.0)
    bench.until(lambda: bench.operation(number).state != "running")
    assert bench.operation(number).reason == "lee pressed stop"


def test_the_mode_of_a_drive_shown_is_its_panels(bench: DriveBench) -> None:
    bench.drives[D1].panel_mode(Mode.PARAMETER_VALUE, bench.now)
    bench.until(lambda: bench.view().mode == "parameter_value")
    done = bench.do(PressDriveKey(KIM, D1, Key.DATA_SET))
    assert done.result == {"mode": "parameter_select"}
