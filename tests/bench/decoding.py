"""STATUS packets from bytes to records, CRC checked: compiled, ours, and with a declarative library."""

import importlib.util
import sysconfig
import time
from binascii import crc_hqx
from collections.abc import Callable, Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Code, Enq, Resp2, Toward, status1, status2
from tests.bench.measuring import Row, Skipped, compiled, in_turn

PACKETS = 5_000
ROUNDS = 7


def packets(count: int) -> list[bytes]:
    """Return STATUS events of a driving vehicle, each with another place."""
    codec = Codec(DEFAULT)
    word1, word2 = status1(0x08111134), status2(0xEF002100)
    return [
        codec.encode(Enq(7, (1 << 63) + i, Code.STATUS, Resp2(word1, word2, 100_000 + i % 3000, i)))
        for i in range(count)
    ]


def compiled_decoder() -> Callable[[bytes], Any]:
    """Return the compiled floor. Raises Skipped without a compiler or the interpreter's headers."""
    headers = sysconfig.get_paths()["include"]
    if not (Path(headers) / "Python.h").is_file():
        raise Skipped("no Python.h: the compiled decoder cannot be built")
    made = compiled("cdecode", "-shared", "-fPIC", f"-I{headers}")
    spec = importlib.util.spec_from_file_location("cdecode", made, loader=_loader(made))
    assert spec is not None
    module = importlib.util.module_from_spec(spec)
    assert spec.loader is not None
    spec.loader.exec_module(module)
    decode: Callable[[bytes], Any] = module.decode
    return decode


def _loader(made: Path) -> Any:
    from importlib.machinery import ExtensionFileLoader

    return ExtensionFileLoader("cdecode", str(made))


def declared() -> Callable[[bytes], Any]:
    """Return the naive counterpart: the packet declared with ``construct``, its CRC as a checksum field."""
    import construct as c

    body = c.Struct(
        "type" / c.Const(5, c.Int8ub),
        "dev_id" / c.Int32ub,
        "cmd_id" / c.Int64ub,
        "code" / c.Int16ub,
        "status1" / c.BitStruct("foup" / c.Flag, "rsv" / c.BitsInteger(3), "axes" / c.Array(7, c.Nibble)),
        "status2" / c.BitStruct(
            "mode" / c.BitsInteger(2), "oper" / c.BitsInteger(2), "flags" / c.Array(4, c.Flag),
            "rsv" / c.BitsInteger(8), "code" / c.BitsInteger(16),
        ),
        "barcode" / c.BytesInteger(6),
        "seq" / c.Int16ub,
    )  # fmt: skip
    packet = c.Struct(
        "body" / c.RawCopy(body),
        "crc" / c.Checksum(c.Int16ub, lambda data: crc_hqx(data, 0xFFFF), lambda context: context.body.data),
    )
    parse: Callable[[bytes], Any] = packet.parse
    return parse


def per_packet(decode: Callable[[bytes], Any], given: Sequence[bytes]) -> float:
    """Return the microseconds of CPU for each packet."""
    began = time.thread_time_ns()
    for packet in given:
        decode(packet)
    return (time.thread_time_ns() - began) / len(given) / 1000


def rows() -> Iterator[Row]:
    """Measure the decoder of a line, from bytes to records."""
    given = packets(PACKETS)
    feed = Decoder(Codec(DEFAULT), Toward.CONTROLLER).feed
    floor, ours, naive = in_turn(
        ROUNDS,
        partial(per_packet, compiled_decoder(), given),
        partial(per_packet, feed, given),
        partial(per_packet, declared(), given[:300]),
    )
    yield Row(
        "iTSC decode of a STATUS packet with CRC",
        ours, floor, naive, "µs CPU/packet", 4.0,
        note="floor: a C extension that gives a tuple of the seven numbers; ours: Decoder.feed to records; naive: construct",
    )  # fmt: skip
