"""Whatever a bad line does to the packets: every command ends once, and what is called done has been done."""

from collections.abc import Callable
from dataclasses import replace
from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMode,
    AgvMove,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvRun,
    AgvSetCurrent,
    AgvSpeed,
    AliasName,
    DeviceAct,
    DeviceCommand,
    DeviceDone,
    DeviceRequestId,
    DoorState,
    LiftAction,
    LiftState,
    ManualDirection,
    Steering,
)
from app.domain.units import Seconds
from app.protocols.enig.codec import Codec
from app.protocols.enig.dialects import DEFAULT
from app.protocols.enig.framing import Decoder
from app.protocols.enig.messages import AgvReport, Body, Toward
from app.protocols.enig.session import LinkSession
from app.protocols.itsc.simulator.faults import Faulty
from app.wire.faults import Fault, Lane
from tests.protocols.enig.rig import World, specs, tag

TAGS = st.sampled_from(["0001", "0002", "0003", "0004", "0009"]).map(tag)
AGV_COMMANDS: st.SearchStrategy[DeviceCommand] = st.one_of(
    st.builds(AgvMove, TAGS),
    st.sampled_from(["B1", "B2", "C1"]).map(lambda name: AgvMoveAlias(AliasName(name))),
    st.builds(AgvLift, st.sampled_from(LiftAction)),
    st.builds(AgvCharge, st.booleans()),
    st.just(AgvMoveManual(ManualDirection.FORWARD, AgvSpeed.FAST)),
    st.just(AgvMoveAuto(forward=True, steering=Steering.STRAIGHT, speed=AgvSpeed.NORMAL)),
    st.builds(AgvSetCurrent, TAGS),
    st.sampled_from([DeviceAct.STOP, DeviceAct.RESET, DeviceAct.MARK_STOP]),
)
STEPS = st.lists(
    st.tuples(
        st.one_of(
            st.tuples(st.just("AGV1"), AGV_COMMANDS),
            st.tuples(st.just("BUF1"), st.sampled_from([DeviceAct.LOCK, DeviceAct.UNLOCK])),
            st.tuples(st.just("DOOR"), st.sampled_from([DeviceAct.OPEN, DeviceAct.CLOSE])),
            st.just(("key", DeviceAct.STOP)),
            st.just(("cut", DeviceAct.STOP)),
            st.just(("error", DeviceAct.STOP)),
        ),
        st.sampled_from([0.0, 0.1, 1.0, 3.0]),
    ),
    max_size=12,
)
RATES = {
    Fault.DROP: 0.1,
    Fault.CORRUPT: 0.05,
    Fault.NOISE: 0.05,
    Fault.SPLIT: 0.1,
    Fault.MERGE: 0.05,
    Fault.DELAY: 0.1,
}


class Witness(World):
    """Watches what the devices really do."""

    def __init__(self, seed: int) -> None:
        super().__init__(latency=0.01)
        lanes = [Lane(Random(seed + i), RATES, delay=(0.01, 0.2)) for i in (0, 1)]
        self.line = Faulty(self.link, *lanes)
        self.seen: list[tuple[float, AgvReport, DoorState]] = []
        said = "_say"
        for device in (self.agv, self.door):
            setattr(device, said, self._spy(getattr(device, said)))

    def _spy(self, say: Callable[[Body], None]) -> Callable[[Body], None]:
        """Note what is so whenever a device reports, also what is so for an instant."""

        def spied(body: Body) -> None:
            self.seen.append((self.now, replace(self.agv.report), self.door.state))
            say(body)

        return spied


@settings(max_examples=50)
@given(STEPS, st.integers(0, 1 << 32))
def test_on_a_bad_line_every_command_ends_once_and_what_is_done_was_done(
    steps: list[tuple[tuple[str, DeviceCommand], float]], seed: int
) -> None:
    world = Witness(seed)
    world.connect()
    world.auto()
    asked: dict[DeviceRequestId, tuple[str, DeviceCommand, float]] = {}
    for (device, command), pause in steps:
        if device == "key":
            world.agv.set_mode(AgvMode(1 - world.agv.report.mode), world.now)
        elif device == "error":
            world.agv.raise_error(world.now)
        elif device == "cut":
            world.cut()
            world.connect(0.5)
        else:
            begun = float(world.now)
            asked[world.ask(device, command)] = (device, command, begun)
        world.wait(pause)
    world.wait(20.0)
    world.cut()
    for request, (_, command, begun) in asked.items():
        assert world.end(request)
        if world.end(request) == "Done":
            done_at = next(t for t, e in world.log if isinstance(e, DeviceDone) and e.request == request)
            assert was_done(world, command, begun, done_at), command
    check_transmissions(world, [command for _, command, _ in asked.values()])


def was_done(world: Witness, command: DeviceCommand, begun: float, ended: float) -> bool:
    """Whether what a command asks for was so at some time before it was called done."""
    # A report on its way may say what was so a little before; and what the last one before that said is so until then.
    since = max((when for when, _, _ in world.seen if when <= begun - 0.5), default=0.0)
    seen = [(report, door) for when, report, door in world.seen if since <= when <= ended]
    goal = {AliasName("B1"): "0003", AliasName("B2"): "0004", AliasName("C1"): "0009"}
    match command:
        case DeviceAct.STOP | DeviceAct.MARK_STOP:
            return any(report.run != AgvRun.RUN for report, _ in seen)
        case DeviceAct.RESET:
            return any(report.run != AgvRun.ERROR for report, _ in seen)
        case DeviceAct.OPEN | DeviceAct.CLOSE:
            wanted = DoorState.OPEN if command is DeviceAct.OPEN else DoorState.CLOSED
            return any(door is wanted for _, door in seen)
        case DeviceAct():
            return True
        case AgvMove() | AgvMoveAlias():
            tag_there = command.tag if isinstance(command, AgvMove) else goal[command.alias]
            return any(report.inposition and report.tag == tag_there for report, _ in seen)
        case AgvSetCurrent():
            return any(report.tag == command.tag for report, _ in seen)
        case AgvMoveManual() | AgvMoveAuto():
            return any(report.run == AgvRun.RUN for report, _ in seen)
        case AgvCharge():
            return any(report.charge == command.on for report, _ in seen)
        case AgvLift():
            # Where a lift was stopped is no end, and where it is at an end it need not be stopped.
            end = {LiftAction.UP: LiftState.UP, LiftAction.DOWN: LiftState.DOWN}.get(command.action)
            return end is None or any(report.lift == end for report, _ in seen)


def check_transmissions(world: World, commands: list[DeviceCommand]) -> None:
    """Manual drives, tape following, charging and mark stops go out once for each time they are asked for, at most."""
    once = {104: AgvMoveManual, 108: AgvMoveAuto, 109: AgvCharge}
    for cmd, kind in once.items():
        assert len(world.transmissions((11, cmd))) <= sum(isinstance(command, kind) for command in commands)
    marks = sum(command is DeviceAct.MARK_STOP for command in commands)
    assert len(world.transmissions((11, 105))) <= marks
    assert len(world.sent) <= 3 * len(commands)


@given(st.lists(st.binary(max_size=40), max_size=8), st.integers(0, 1 << 32))
def test_no_bytes_make_the_session_or_a_device_raise(pieces: list[bytes], seed: int) -> None:
    session, world = LinkSession(specs(), DEFAULT), World()
    session.connected(Seconds(0.0))
    world.link.connected(Seconds(0.0))
    chance = Random(seed)
    codec = Codec()
    decoder = Decoder(codec, Toward.HOST)
    for number, piece in enumerate(pieces):
        now = Seconds(number * chance.random())
        for end in (session, world.link):
            end.received(piece, now)
            end.tick(now)
        while packet := world.link.outgoing():
            assert decoder.feed(packet)
    assert session.outgoing() == b""
