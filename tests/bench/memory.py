"""Python memory of a vehicle's session, without its socket."""

import asyncio
import gc
import tracemalloc
from collections.abc import Callable, Iterator, Sequence
from typing import Any, cast

from app.control.lines import VehicleLine
from app.domain.events import Event
from app.domain.ids import CmdIds, Epoch
from app.domain.units import Seconds
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Code, Enq, Resp2, Toward, status1, status2
from app.protocols.itsc.session import Timing
from app.runtime.lines import Line
from tests.bench.measuring import Row
from tests.bench.serving import spec_of

COUNT = 500
EVENTS = 100
"""STATUS events that each session has seen, so that all it remembers is full."""


class Nowhere(asyncio.Transport):
    """A transport that drops what it is given."""

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Drop it."""

    def is_closing(self) -> bool:
        """It never does."""
        return False

    def close(self) -> None:
        """Nothing to close."""

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        """Nothing waits."""


TIMING = Timing()


def _told(_events: Sequence[Event], _now: Seconds) -> None:
    """Forget. One for all sessions, as in the controller."""


def _now() -> Seconds:
    return Seconds(1.0)


def bare() -> object:
    """Return a task that waits."""
    return asyncio.get_running_loop().create_task(asyncio.Event().wait())


def session(number: int, codec: Codec, ids: CmdIds) -> object:
    """Return a line and its session in use."""
    line = Line(VehicleLine(_told, spec_of(number), DEFAULT, ids, TIMING), _now)
    line.connection_made(Nowhere())
    poll = ids.epoch << 32 | ids._last
    body = Resp2(status1(0x08111110), status2(0xEF000000), 1203, 7)
    line.data_received(codec.encode(Enq(number, poll, Code.STATUS, body)))
    for n in range(EVENTS):
        body.barcode, body.seq = 1000 + n, n
        line.data_received(codec.encode(Enq(number, (1 << 63) + n, Code.STATUS, body)))
    return line


def streams(codec: Codec) -> object:
    """Return what the usual design keeps: reader, writer, queue, decoder and two tasks."""
    loop = asyncio.get_running_loop()
    reader = asyncio.StreamReader()
    writer = asyncio.StreamWriter(Nowhere(), asyncio.StreamReaderProtocol(reader), reader, loop)
    queue: asyncio.Queue[bytes] = asyncio.Queue()
    waits = asyncio.wait_for(queue.get(), 1000.0)
    tasks = [loop.create_task(cast(Any, waiting)) for waiting in (reader.read(4096), waits)]
    return reader, writer, queue, Decoder(codec, Toward.CONTROLLER), tasks


async def _each(make: Callable[[int], object]) -> float:
    """Return the bytes that each of many takes."""
    kept = [make(0)]
    await asyncio.sleep(0)
    gc.collect()
    tracemalloc.start()
    kept += [make(n) for n in range(1, COUNT + 1)]
    await asyncio.sleep(0)
    gc.collect()
    size, _ = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    for task in asyncio.all_tasks() - {asyncio.current_task()}:
        task.cancel()
    await asyncio.sleep(0)
    return size / COUNT


def rows() -> Iterator[Row]:
    """Measure each in a loop of its own."""
    codec, ids = Codec(DEFAULT), CmdIds(Epoch(1))
    floor = asyncio.run(_each(lambda _: bare()))
    ours = asyncio.run(_each(lambda n: session(n + 1, codec, ids)))
    naive = asyncio.run(_each(lambda _: streams(codec)))
    yield Row(
        "memory per vehicle session, without the socket; floor: a bare task",
        ours, floor, naive, "bytes", 3.0,
        note="ours: with 100 STATUS seen, 64 of them kept for duplicates and people, and a poll; naive keeps none",
    )  # fmt: skip
