"""What holds for the session whatever the line does."""

from collections import Counter
from random import Random

from hypothesis import given, settings
from hypothesis import strategies as st

from app.domain.commands import Command, Plain
from app.domain.events import Answered, Event, NotSent, Unanswered
from app.domain.ids import CmdId
from app.domain.units import Seconds
from app.protocols.itsc.dialects import DIALECTS
from app.protocols.itsc.messages import Ack, Code, Enq, Etb, Resp1, Resp2, status1, status2
from tests.protocols.itsc.session_peer import (
    AUTO_IDLE,
    DISPLAY,
    MANT_IDLE,
    MOVE,
    PICKUP,
    STANDING1,
    TOP,
    Bench,
    simple,
    xmove,
)

COMMANDS: tuple[Command, ...] = (
    MOVE,
    xmove(CmdId(1)),
    PICKUP,
    DISPLAY,
    simple(Plain.STOP),
    simple(Plain.STATUS),
    simple(Plain.SERVO_ON),
    simple(Plain.SYSTEM_RESET),
)


@given(st.lists(st.binary(max_size=80), max_size=20), st.sampled_from(sorted(DIALECTS)), st.randoms())
def test_no_bytes_make_it_raise(pieces: list[bytes], name: str, random: Random) -> None:
    bench = Bench(DIALECTS[name])
    bench.session.connected(bench.now)
    for piece in pieces:
        bench.session.received(piece, bench.now)
        bench.now = Seconds(bench.now + random.random())
        bench.session.tick(bench.now)
        bench.session.events()
        bench.session.outgoing()


@given(st.data(), st.sampled_from(sorted(DIALECTS)))
def test_no_well_framed_packet_makes_it_raise(data: st.DataObject, name: str) -> None:
    bench = Bench(DIALECTS[name])
    bench.session.connected(bench.now)
    codes = st.sampled_from([*(int(code) for code in Code), 0x1234])
    ids = st.sampled_from([1, (7 << 32) + 1, (6 << 32) + 1, TOP + 1, (1 << 64) - 1])
    checksum = bench.codec.checksum
    order = bench.codec.dialect.byte_order
    start = 0 if bench.codec.dialect.crc_covers_type else 1
    for _ in range(data.draw(st.integers(1, 8))):
        kind = data.draw(st.sampled_from([0x05, 0x06, 0x15]))
        body = bytes([kind]) + (12).to_bytes(4, order) + data.draw(ids).to_bytes(8, order)
        if kind == 0x05:
            body += data.draw(codes).to_bytes(2, order) + data.draw(st.binary(min_size=16, max_size=16))
        bench.session.received(body + checksum(body[start:]).to_bytes(2, order), bench.now)
        bench.session.events()
    assert bench.session.link.garbled >= 0


class Chaos:
    """A line that loses and repeats packets both ways, and a vehicle that answers what it gets, or does not."""

    def __init__(self, random: Random) -> None:
        self.random = random
        self.bench = Bench()
        self.sent: list[CmdId] = []
        self.ended: Counter[int] = Counter()
        self.unanswered: set[int] = set()
        self.connected = False
        self.delayed: list[bytes] = []

    def step(self) -> None:
        random, bench = self.random, self.bench
        bench.now = Seconds(bench.now + random.choice((0.0, 0.05, 0.3, 1.0, 2.5)))
        if not self.connected:
            bench.session.connected(bench.now)
            self.connected = True
        elif random.random() < 0.05 or bench.session.wants_close:
            bench.session.disconnected(bench.now, "gone")
            self.connected = False
            self.delayed.clear()
        elif random.random() < 0.4:
            self.sent.append(bench.send(random.choice(COMMANDS)))
        bench.session.tick(bench.now)
        self.vehicle()
        self.judge(bench.session.events())

    def vehicle(self) -> None:
        answers: list[bytes] = self.delayed
        self.delayed = []
        for frame in self.bench.heard():
            if isinstance(frame, Enq | Etb):
                answers += self.answers(frame)
        for data in answers:
            if self.random.random() < 0.2:
                continue
            if self.random.random() < 0.2:
                self.delayed.append(data)
            cut = self.random.randrange(len(data)) if self.random.random() < 0.2 else 0
            for piece in (data[:cut], data[cut:]):
                if piece:
                    self.bench.session.received(piece, self.bench.now)

    def answers(self, frame: Enq | Etb) -> list[bytes]:
        encode = self.bench.codec.encode
        mode = self.random.choice((AUTO_IDLE, MANT_IDLE))
        answers = [encode(Ack(12, frame.cmd_id))]
        if frame.code == Code.STATUS:
            body = Resp2(status1(STANDING1), status2(mode), 1201, self.random.randrange(5))
            answers.append(encode(Enq(12, frame.cmd_id, frame.code, body)))
        elif frame.code != Code.SYSTEM_RESET:
            result = Resp1(self.random.randrange(2), status2(mode), 1201, 0)
            answers.append(encode(Enq(12, frame.cmd_id, frame.code, result)))
        return answers

    def judge(self, events: list[Event]) -> None:
        for event in events:
            if isinstance(event, Unanswered | NotSent):
                self.ended[event.cmd_id] += 1
                assert event.cmd_id not in self.unanswered
                if isinstance(event, Unanswered):
                    self.unanswered.add(event.cmd_id)
            elif isinstance(event, Answered):
                if event.cmd_id in self.unanswered:
                    self.unanswered.remove(event.cmd_id)
                else:
                    self.ended[event.cmd_id] += 1


@settings(max_examples=60, deadline=None)
@given(st.integers(0, 1 << 32))
def test_every_command_ends_exactly_once_whatever_is_lost_or_repeated(seed: int) -> None:
    chaos = Chaos(Random(seed))
    for _ in range(60):
        chaos.step()
    chaos.bench.session.disconnected(chaos.bench.now, "over")
    chaos.judge(chaos.bench.session.events())
    assert chaos.ended == Counter(chaos.sent)
