"""Faults on a line, each alone, and repeated from a seed."""

from random import Random

import pytest

from app.domain.units import Seconds
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.framing import Decoder, Garbled
from app.protocols.itsc.messages import NOTHING, Ack, Code, Enq, Frame, Toward
from app.protocols.itsc.simulator.faults import Faulty, foreign_dev_id
from app.wire.faults import Fault, Lane
from tests.scenarios.rig import DEV_ID, make_rig

CODEC = Codec()
FIRST, SECOND = CODEC.ack(DEV_ID, 1), CODEC.ack(DEV_ID, 2)


def lane(*faults: Fault) -> Lane:
    """A lane whose next packets meet these faults, one each."""
    lane = Lane(Random(1), delay=(0.5, 0.5), forge=foreign_dev_id(CODEC))
    for fault in faults:
        lane.strike(fault)
    return lane


def out(lane: Lane, now: float) -> list[bytes]:
    """All pieces that are out by now."""
    pieces = []
    while piece := lane.take(now):
        pieces.append(piece)
    return pieces


def read(data: bytes) -> list[Frame | Garbled]:
    """What a controller makes of bytes."""
    decoder = Decoder(CODEC, Toward.CONTROLLER)
    return [*decoder.feed(data), *decoder.flush()]


def test_without_faults_packets_pass_at_once_and_unchanged() -> None:
    line = lane()
    line.put(FIRST, 1.0)
    line.put(SECOND, 1.0)
    assert out(line, 1.0) == [FIRST, SECOND]
    assert line.deadline is None


def test_drop_duplicate_and_split() -> None:
    line = lane(Fault.DROP, Fault.DUPLICATE, Fault.SPLIT)
    line.put(FIRST, 0)
    assert out(line, 0) == []
    line.put(FIRST, 0)
    assert out(line, 0) == [FIRST, FIRST]
    line.put(FIRST, 0)
    assert out(line, 0) == [FIRST[i : i + 1] for i in range(len(FIRST))]


def test_a_delayed_packet_holds_back_those_behind_it() -> None:
    line = lane(Fault.DELAY)
    line.put(FIRST, 0)
    line.put(SECOND, 0.1)
    assert out(line, 0.4) == []
    assert line.deadline == 0.5
    assert out(line, 0.5) == [FIRST, SECOND]


def test_a_merged_packet_waits_shortly_for_the_next() -> None:
    line = lane(Fault.MERGE, Fault.MERGE)
    line.put(FIRST, 0)
    assert out(line, 0.01) == []
    line.put(SECOND, 0.02)
    assert line.deadline == 0.02 + 0.05
    assert out(line, 0.1) == [FIRST + SECOND]
    line.put(SECOND, 1)
    assert out(line, 1) == [SECOND]


def test_a_merged_packet_goes_alone_if_nothing_follows() -> None:
    line = lane(Fault.MERGE)
    line.put(FIRST, 0)
    assert out(line, 0.05) == [FIRST]


def test_corruption_flips_one_bit() -> None:
    line = lane(Fault.CORRUPT)
    line.put(FIRST, 0)
    (piece,) = out(line, 0)
    assert (int.from_bytes(piece, "big") ^ int.from_bytes(FIRST, "big")).bit_count() == 1


def test_noise_comes_before_its_packet_in_one_piece() -> None:
    line = lane(Fault.NOISE)
    line.put(FIRST, 0)
    (piece,) = out(line, 0)
    assert piece.endswith(FIRST)
    assert 1 <= len(piece) - len(FIRST) <= 8


def test_a_stale_packet_comes_again_before_a_newer_one() -> None:
    line = lane()
    line.strike(Fault.STALE, lambda packet: packet == SECOND)
    line.put(FIRST, 0)
    line.put(SECOND, 0)
    line.put(SECOND, 0)
    assert out(line, 0) == [FIRST, FIRST, SECOND, SECOND]
    alone = lane(Fault.STALE)
    alone.put(FIRST, 0)
    assert out(alone, 0) == [FIRST]


def test_a_forged_packet_is_sound_but_from_another_device() -> None:
    line = lane(Fault.WRONG_ID, Fault.WRONG_ID)
    line.put(FIRST, 0)
    assert read(b"".join(out(line, 0))) == [Ack(DEV_ID + 1, 1)]
    line.put(b"\0\0", 0)
    assert out(line, 0) == [b"\0\0"]


def test_the_same_seed_gives_the_same_faults() -> None:
    rates = dict.fromkeys(Fault, 0.2)
    lanes = [Lane(Random(seed), rates, forge=foreign_dev_id(CODEC)) for seed in (7, 7, 8)]
    for each in lanes:
        for n in range(100):
            each.put(CODEC.ack(DEV_ID, n), float(n))
    first, again, other = ([each.take(1e9) for _ in range(500)] for each in lanes)
    assert first == again != other


def bad_line(*, out_lane: Lane | None = None, in_lane: Lane | None = None) -> Faulty:
    """A vehicle behind a line, connected."""
    faulty = Faulty(make_rig().vehicle, out_lane or lane(), in_lane or lane())
    faulty.connected(Seconds(0))
    return faulty


def sent(faulty: Faulty) -> bytes:
    """Everything the endpoint sends now."""
    data = b""
    while piece := faulty.outgoing():
        data += piece
    return data


STATUS = CODEC.encode(Enq(DEV_ID, 1, Code.STATUS, NOTHING))


def test_a_command_and_its_answer_pass_a_good_line() -> None:
    faulty = bad_line()
    faulty.received(STATUS, Seconds(0))
    assert faulty.deadline == 0.005
    faulty.tick(Seconds(0.005))
    assert [type(frame) for frame in read(sent(faulty))] == [Ack, Enq]


def test_a_delayed_command_is_obeyed_when_it_comes() -> None:
    faulty = bad_line(in_lane=lane(Fault.DELAY))
    faulty.received(STATUS, Seconds(0))
    assert faulty.deadline == 0.5
    faulty.tick(Seconds(0.505))
    assert len(read(sent(faulty))) == 2


def test_ack_and_answer_can_come_in_one_write() -> None:
    faulty = bad_line(out_lane=lane(Fault.MERGE))
    faulty.received(STATUS, Seconds(0))
    faulty.tick(Seconds(0.005))
    assert len(faulty.outgoing()) == 15 + 33


def test_a_silent_line_swallows_both_ways() -> None:
    faulty = bad_line()
    faulty.received(STATUS, Seconds(0))
    faulty.silent = True
    faulty.tick(Seconds(0.005))
    faulty.received(STATUS, Seconds(0.01))
    faulty.tick(Seconds(0.1))
    assert sent(faulty) == b""
    faulty.silent = False
    faulty.tick(Seconds(1.005))
    assert len(read(sent(faulty))) == 1


@pytest.mark.parametrize("reset", [False, True])
def test_a_closed_line_lets_out_what_was_sent_and_a_reset_one_does_not(reset: bool) -> None:
    faulty = bad_line()
    faulty.received(STATUS, Seconds(0))
    faulty.inner.tick(Seconds(0.005))
    faulty.reset() if reset else faulty.close()
    closing = [faulty.wants_close]
    assert len(read(sent(faulty))) == (0 if reset else 2)
    faulty.disconnected(Seconds(1), "closed")
    faulty.tick(Seconds(10))
    closing.append(faulty.wants_close)
    assert closing == [True, False]
    assert faulty.deadline is None
