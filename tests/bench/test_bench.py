"""The benchmarks measure what they say: their C programs speak the protocol. Nothing here looks at a clock."""

import json
import os
import socket
import subprocess

import pytest

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT
from app.protocols.itsc.messages import NOTHING, Code, Enq, Form
from tests.bench import __main__ as bench
from tests.bench import session_path
from tests.bench.decoding import compiled_decoder, declared, packets
from tests.bench.measuring import Row, Skipped, child, compiled, line_of, table

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


def test_both_readmes_have_a_place_for_the_table_and_keep_all_around_it() -> None:
    row = Row("a path", 3.0, 2.0, None, "us", 1.8)
    for readme in bench.READMES:
        text = readme.read_text()
        before, after = text.split(bench.BEGIN)[0], text.split(bench.END, 1)[1]
        assert bench.placed(text, [row]) == f"{before}{bench.BEGIN}{table([row])}\n{bench.END}{after}"


def test_rows_of_one_benchmark_take_the_place_of_those_of_the_last_time() -> None:
    old, new = Row("old", 3.0, 2.0, None, "us", 1.8), Row("new", 2.0, 2.0, None, "us", 1.8)
    before = {"decode": [old], "route": [old, old], "hoists": [old]}
    assert bench.merged(before, {"route": [new]}) == {"decode": [old], "route": [new], "hoists": [old]}
    assert list(bench.merged({"hoists": [old]}, {"session": [new]})) == ["session", "hoists"]


def test_the_rows_of_the_last_time_are_read_back() -> None:
    rows = [row for of_one in bench.kept().values() for row in of_one]
    assert f"{table(rows)}\n" in (bench.RESULTS / "results.md").read_text()


def test_a_text_without_marks_is_refused() -> None:
    with pytest.raises(ValueError, match="no place for the table"):
        bench.placed("nothing here", [])


@pytest.mark.parametrize("rate", ["0", "200"])
def test_the_load_sends_events_in_a_closed_and_in_an_open_loop_and_counts_what_is_acknowledged(rate: str) -> None:
    try:
        floor, load = compiled("floor"), compiled("vehicles")
    except Skipped as why:
        pytest.skip(str(why))
    words = ["3", "0", "0.05", "0.05", "0.3", "0", rate]
    with child(load, *words, stdin=subprocess.PIPE, stdout=subprocess.PIPE) as vehicles:
        port = line_of(vehicles.stdout).strip()
        with child(floor, port, "3", "20") as server:
            assert vehicles.stdin is not None
            vehicles.stdin.write(f"{server.pid}\n")
            vehicles.stdin.close()
            told = json.loads(line_of(vehicles.stdout))
    assert told["packets"] > 0
    if rate == "0":
        assert told["waiting"] == 3
    else:
        assert told["waiting"] >= 0


def test_a_server_and_its_load_run_where_a_place_says() -> None:
    for place in session_path.places():
        assert (place.load is None) == (place.server is None)
    with session_path._on(min(os.sched_getaffinity(0))):
        assert os.sched_getaffinity(0) == {min(os.sched_getaffinity(0))}
    assert len(os.sched_getaffinity(0)) >= len(session_path.places())
