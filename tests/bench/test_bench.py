"""The benchmarks measure what they say: their C programs speak the protocol. Nothing here looks at a clock."""

import socket

import pytest

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT
from app.protocols.itsc.messages import NOTHING, Code, Enq, Form
from tests.bench import __main__ as bench
from tests.bench.decoding import compiled_decoder, declared, packets
from tests.bench.measuring import Row, Skipped, child, compiled, table

PATIENCE = 20.0


def received(peer: socket.socket, size: int) -> bytes:
    data = b""
    while len(data) < size and (more := peer.recv(size - len(data))):
        data += more
    return data


def test_the_floor_asks_for_status_and_acknowledges_each_event() -> None:
    try:
        floor = compiled("floor")
    except Skipped as why:
        pytest.skip(str(why))
    codec = Codec(DEFAULT)
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(PATIENCE)
        with child(floor, str(listener.getsockname()[1]), "1", "20"):
            peer, _ = listener.accept()
            with peer:
                peer.settimeout(PATIENCE)
                assert received(peer, 33) == codec.encode(Enq(1, (1 << 32) + 1, Code.STATUS, NOTHING))
                event = packets(1)[0]
                mine = codec.encode(Enq(1, 1 << 63, Code.STATUS, codec.decode_body(Form.RESP2, event[15:31])))
                peer.sendall(mine)
                assert received(peer, 15) == codec.ack(1, 1 << 63)


def test_compiled_and_declared_decoders_read_what_ours_writes() -> None:
    try:
        decode = compiled_decoder()
    except Skipped as why:
        pytest.skip(str(why))
    packet = packets(3)[2]
    assert decode(packet) == (7, (1 << 63) + 2, Code.STATUS, 0x08111134, 0xEF002100, 100_002, 2)
    assert decode(packet[:-1] + b"\0") is None
    assert declared()(packet).body.value.barcode == 100_002


def test_the_table_says_which_goals_are_met() -> None:
    rows = [
        Row("a", 3.0, 2.0, None, "us", 1.8),
        Row("b", 3.0, 2.0, 9.0, "us", 1.2),
        Row("c", 9.0, 1.0, None, "1/s", 8.0, "higher"),
        Row("d", 9.0, 1.0, None, "1/s", None),
    ]
    assert [line.split(" | ")[-1].strip(" |") for line in table(rows).splitlines()[2:]] == ["yes", "no", "yes", "–"]


def test_an_unknown_benchmark_is_refused_by_name(capsys: pytest.CaptureFixture[str]) -> None:
    assert bench.main(["nothing"]) == 2
    assert "no benchmark nothing; there are session" in capsys.readouterr().err
