"""The simulated vehicle under anything that can come: it never raises, never leaves its path, never loses a FOUP by itself."""

from collections.abc import Callable, Sequence
from itertools import pairwise

from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.layout import Axis
from app.domain.units import Barcode, Pulses, Seconds
from app.protocols.itsc.dialects import DIALECTS
from app.protocols.itsc.messages import NOTHING, Action, Code, Disp, Mode, Move, Sbuf, Xmove
from app.protocols.itsc.simulator.transfer import TRANSFERS
from tests.scenarios.rig import PORT, Rig, make_rig, path, small_track

Act = Callable[[Rig], None]

WAYS = (
    (1201, 1202, 1203),
    (1201, 1301, 1302, 1303),
    (1202, 1203, 1204),
    (1203, 1204, 1205, 1206),
    (1202, 1302, 1303),
    (1202,),
)
PLAIN = [code for code in Code if code not in TRANSFERS and code not in (Code.MOVE, Code.XMOVE, Code.SYSTEM_RESET)]
STOPS = [Action.STOP, Action.STOP_PORT, Action.STOP_SBFL, Action.STOP_SBFR, Action.STOP_PORT_UNPREPARED]


def _now(rig: Rig) -> Seconds:
    return Seconds(rig.now)


def _reconnect(rig: Rig) -> None:
    if rig.up:
        rig.cut()
    else:
        rig.connect()


def _ask(code: Code) -> Act:
    body = (
        Disp(1, 1, "X")
        if code is Code.DISPLAY_BY_HOST
        else PORT
        if "PORT" in code.name and code in TRANSFERS
        else NOTHING
    )
    return lambda rig: _sending(rig, lambda: rig.send(code, Sbuf(50) if "SBF" in code.name else body))


def _sending(rig: Rig, send: Callable[[], int]) -> None:
    if rig.up:
        send()


def _move(way: tuple[int, ...], stop: Action, speed: int) -> Act:
    return lambda rig: _sending(rig, lambda: rig.send(Code.MOVE, Move(path(*way, stop=stop, speed=speed))))


def _xmove(first: int, way: tuple[int, ...], stop: Action) -> Act:
    return lambda rig: _sending(rig, lambda: rig.send(Code.XMOVE, Xmove(path(*way, stop=stop, first=first))))


commands = st.one_of(
    st.builds(_ask, st.sampled_from(PLAIN)),
    st.builds(_ask, st.sampled_from(sorted(TRANSFERS))),
    st.builds(_move, st.sampled_from(WAYS), st.sampled_from(STOPS), st.integers(1, 100)),
    st.builds(_xmove, st.integers(0, 4), st.sampled_from(WAYS), st.sampled_from(STOPS)),
)
waits = st.floats(0.01, 4).map(lambda seconds: lambda rig: rig.run(seconds))
operator = st.sampled_from(
    [
        lambda rig: rig.vehicle.block_sensor(_now(rig)),
        lambda rig: rig.vehicle.unblock_sensor(_now(rig)),
        lambda rig: rig.vehicle.raise_alarm(9, _now(rig)),
        lambda rig: rig.vehicle.panel_mode(Mode.MANT, _now(rig)),
        lambda rig: rig.vehicle.panel_mode(Mode.AUTO, _now(rig)),
        lambda rig: rig.vehicle.jog(Axis.ROTA, Pulses(7), _now(rig)),
        lambda rig: rig.vehicle.power_cycle(_now(rig)),
        lambda rig: rig.ready() if rig.vehicle.working is None else None,
        lambda rig: rig.vehicle.misread_next(Barcode("1")),
        _reconnect,
    ]
)


def _check(rig: Rig, before: tuple[bool, bool]) -> None:
    """On the rail, and F changed only by PICKUP or PLACE."""
    barcode, past, ahead = rig.vehicle.place(_now(rig))
    if ahead is None:
        assert past == 0
    else:
        edge = small_track().edge(barcode, ahead)
        assert edge is not None
        assert -1e-6 <= past <= edge.length + 1e-6
    foup, handling = before
    assert rig.vehicle.state.foup == foup or handling or rig.vehicle.working in TRANSFERS


@given(st.lists(st.one_of(commands, commands, waits, operator), max_size=25))
@settings(max_examples=150)
def test_whatever_is_asked_the_vehicle_stays_on_its_rail_and_keeps_its_foup(acts: list[Act]) -> None:
    rig = make_rig().ready()
    transferred = [False]

    def note(rig: Rig) -> bool:
        transferred[0] |= rig.vehicle.working in TRANSFERS
        return False

    # Looked at whenever time passes in the vehicle: a handling may begin and end within one wait.
    tick = rig.vehicle.tick

    def ticking(now: Seconds) -> None:
        note(rig)
        tick(now)
        note(rig)

    rig.vehicle.tick = ticking  # type: ignore[method-assign]
    for act in acts:
        before = rig.vehicle.state.foup
        transferred[0] = False
        note(rig)
        act(rig)
        rig._live(rig.now + 0.2, lambda: note(rig))
        _check(rig, (before, transferred[0]))
    if not rig.up and rig.vehicle.accepting:
        rig.connect()
    rig.vehicle.unblock_sensor(_now(rig))
    # The slowest MOVE takes 200 s.
    rig.run(300)
    assert rig.vehicle.working is None


@given(
    st.sampled_from(WAYS), st.lists(st.tuples(st.floats(0, 1.5), st.integers(0, 4), st.sampled_from(WAYS)), max_size=5)
)
def test_a_vehicle_runs_only_along_paths_that_it_was_given(
    way: tuple[int, ...], changes: list[tuple[float, int, tuple[int, ...]]]
) -> None:
    rig = make_rig().ready()
    rig.move(*way)
    rig.run(0.01)
    allowed = {("1201", "1202"), ("1201", "1301")} & {("1201", str(way[0])), ("1201", str(way[1 % len(way)]))}
    allowed |= set(_pairs(way))
    for seconds, first, other in changes:
        _stay(rig, seconds, allowed)
        spliced = [*rig.vehicle.path[:first], *map(str, other)]
        if all(b in small_track().ahead(Barcode(a)) for a, b in _pairs(spliced)):
            rig.xmove(first, *other)
            rig.run(0.005)
            allowed |= set(_pairs(rig.vehicle.path))
    _stay(rig, 30, allowed)
    assert rig.vehicle.working is None


def _pairs(way: Sequence[int | str]) -> list[tuple[str, str]]:
    return [(str(a), str(b)) for a, b in pairwise(way)]


def _stay(rig: Rig, seconds: float, allowed: set[tuple[str, str]]) -> None:
    end = rig.now + seconds
    while rig.now < end:
        rig.run(min(0.25, end - rig.now))
        barcode, _, ahead = rig.vehicle.place(_now(rig))
        if ahead is not None and rig.vehicle.state.alarm == 0:
            assert (barcode, ahead) in allowed


@given(st.sampled_from(sorted(DIALECTS)), st.lists(st.one_of(st.binary(max_size=200), st.integers(0, 40)), max_size=20))
def test_no_bytes_make_it_raise(name: str, chunks: list[bytes | int]) -> None:
    rig = make_rig(dialect=DIALECTS[name]).ready()
    packet = rig.packet(Code.MOVE, Move([]))
    for chunk in chunks:
        rig.raw(chunk if isinstance(chunk, bytes) else packet[chunk:] + packet[:chunk])
        rig.run(0.1)
    rig.run(5)
    rig.status()
