"""The master and its drives over a bad line: every request ends once, and as the drive knows it (PROTOCOLS 2.3, 6.1)."""

from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.drive import (
    DriveDone,
    DriveFailed,
    DriveId,
    DriveRequestId,
    Key,
    Parameter,
    PressKey,
    RawValue,
    ReadParameter,
    Turn,
    WriteParameter,
)
from app.domain.units import Seconds
from app.protocols.hi.dialects import DIALECTS
from app.protocols.hi.messages import Cmd, Mode
from app.wire.faults import Fault
from tests.protocols.hi.rig import CHARACTER, Bench

BROKEN_OUT = [Fault.DROP, Fault.CORRUPT, Fault.NOISE, Fault.SPLIT]
"""A line that doubles or delays a request would press keys by itself; that is no fault of the master's."""
BROKEN_BACK = [*BROKEN_OUT, Fault.DUPLICATE, Fault.MERGE]
RATES = st.sampled_from([0.0, 0.02, 0.1, 0.3])


def bad(draw: st.DrawFn, bench: Bench) -> None:
    bench.out.lane.rates = {fault: draw(RATES) for fault in BROKEN_OUT}
    bench.back.lane.rates = {fault: draw(RATES) for fault in BROKEN_BACK}


@st.composite
def bad_lines(draw: st.DrawFn, drives: int) -> Bench:
    dialect = DIALECTS[draw(st.sampled_from(["default", "bcc-byte", "bcc-word", "bcc-raw"]))]
    bench = Bench(drives, dialect=dialect, seed=draw(st.integers(0, 1 << 32)))
    for drive in bench.drives.values():
        drive.panel_mode(Mode.PARAMETER_SELECT, Seconds(0.0))
    bench.settle()
    bad(draw, bench)
    return bench


def good_again(bench: Bench) -> None:
    bench.out.lane.rates = bench.back.lane.rates = {}
    bench.until(lambda: all(view.online for view in bench.session.drives.values()), within=30.0)


@settings(max_examples=40)
@given(bench=bad_lines(drives=3), data=st.data())
def test_over_a_bad_line_what_is_told_of_a_request_is_what_happened(bench: Bench, data: st.DataObject) -> None:
    writes: dict[DriveRequestId, tuple[int, int]] = {}
    ups: dict[int, list[DriveRequestId]] = {drive: [] for drive in bench.drives}
    reads = []
    for number in range(data.draw(st.integers(5, 25))):
        drive = data.draw(st.integers(1, 3))
        match data.draw(st.integers(0, 3)):
            case 0:
                writes[bench.ask(WriteParameter(Parameter(number), RawValue(number + 1000)), drive)] = drive, number
            case 1:
                ups[drive].append(bench.ask(PressKey(Key.UP), drive))
            case 2:
                reads.append(bench.ask(ReadParameter(Parameter(200)), drive))
            case _:
                bench.run(data.draw(st.floats(0.0, 0.5)))
    everything = [*writes, *reads, *(request for asked in ups.values() for request in asked)]
    bench.until(lambda: all(bench.end(request) is not None for request in everything), within=200.0)
    for request, (drive, number) in writes.items():
        if isinstance(bench.end(request), DriveDone):
            assert bench.drives[drive].state(Seconds(bench.now)).values[number] == number + 1000
    for drive, requests in ups.items():
        done = sum(isinstance(bench.end(request), DriveDone) for request in requests)
        failed = sum(isinstance(bench.end(request), DriveFailed) for request in requests)
        pressed = bench.drives[drive].state(Seconds(bench.now)).selected
        assert done <= pressed <= len(requests) - failed
    for request in reads:
        end = bench.end(request)
        assert not isinstance(end, DriveDone) or end.result.value == 0  # type: ignore[union-attr]
    good_again(bench)
    for (before, packet), (after, _) in pairwise(bench.sent):
        assert after - before >= len(packet) * CHARACTER, "the master speaks over itself"


@settings(max_examples=25)
@given(bench=bad_lines(drives=2), data=st.data())
def test_over_a_bad_line_a_jog_never_outlives_its_caller(bench: Bench, data: st.DataObject) -> None:
    bench.out.lane.rates, rates = {}, bench.out.lane.rates
    bench.drives[1].panel_mode(Mode.JOG, Seconds(bench.now))
    bench.out.lane.rates = rates
    lifetime = data.draw(st.floats(0.05, 2.0))
    until = bench.now + lifetime
    jog = bench.jog(data.draw(st.sampled_from(Turn)), until)
    bench.until(lambda: bench.end(jog) is not None, within=30.0)
    bench.run(0.2)
    keys = [*bench.commands(Cmd.UPP), *bench.commands(Cmd.DWN)]
    assert all(at < until for at in keys)
    assert not bench.drives[1].state(Seconds(bench.now)).jogging
    if isinstance(bench.end(jog), DriveDone):
        assert bench.commands(Cmd.SRK, 1)
    good_again(bench)


@settings(max_examples=25)
@given(bench=bad_lines(drives=2), data=st.data())
def test_over_a_bad_line_nothing_moves_once_stop_is_done(bench: Bench, data: st.DataObject) -> None:
    for _ in range(data.draw(st.integers(1, 4))):
        bench.ask(PressKey(Key.RUN), 1)
        bench.run(data.draw(st.floats(0.0, 0.6)))
    stop = bench.ask(PressKey(Key.STOP_RESET), 1)
    bench.until(lambda: bench.end(stop) is not None, within=30.0)
    if isinstance(bench.end(stop), DriveDone):
        bench.run(6.0)
        assert not bench.drives[1].state(Seconds(bench.now)).moving
    good_again(bench)


@settings(max_examples=25)
@given(
    seed=st.integers(0, 1 << 32), noise=st.lists(st.tuples(st.floats(0.0, 0.3), st.binary(max_size=30)), max_size=20)
)
def test_any_bytes_at_any_time_leave_the_line_working(seed: int, noise: list[tuple[float, bytes]]) -> None:
    bench = Bench(2, seed=seed)
    for gap, data in noise:
        bench.ask(ReadParameter(Parameter(1)), 1)
        bench.run(gap)
        bench.session.received(data, Seconds(bench.now))
    bench.until(lambda: bool(bench.session.drives[DriveId("D1")].online), within=30.0)
    bench.run(5.0)
    assert isinstance(bench.do(ReadParameter(Parameter(1))), DriveDone)


def test_the_same_seed_gives_the_same_line_to_the_byte() -> None:
    def life() -> list[tuple[float, bytes]]:
        bench = Bench(3, seed=7)
        bench.back.lane.rates = dict.fromkeys(BROKEN_BACK, 0.2)
        for number in range(10):
            bench.ask(WriteParameter(Parameter(number), RawValue(number)), 1 + number % 3)
        bench.run(60.0)
        return bench.sent

    assert life() == life()
