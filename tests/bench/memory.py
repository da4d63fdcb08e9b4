"""Python memory of a vehicle's session, without its socket."""

import asyncio
import gc
import tracemalloc
from collections.abc import Callable, Iterator, Sequence
from typing import Any, cast

from app.control.lines import VehicleLine
from app.domain.events import Event
from app.domain.ids import CmdIds, Epoch
from app.domain.layout import VehicleSpec
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
EVENTS = POLLS = 100
"""STATUS events that each session has seen and polls that were answered, so that all it remembers is full."""


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


def session(number: int, spec: VehicleSpec, socket: Nowhere, codec: Codec, ids: CmdIds) -> object:
    """Return a line and its session in use; the vehicle's row of the plant file is there without it."""
    endpoint = VehicleLine(_told, spec, DEFAULT, ids, TIMING)
    line = Line(endpoint, _now)
    line.connection_made(socket)
    body = Resp2(status1(0x08111110), status2(0xEF000000), 1203, 7)
    for n in range(EVENTS):
        body.barcode, body.seq = 1000 + n, n
        line.data_received(codec.encode(Enq(number, ids.epoch << 32 | ids._last, Code.STATUS, body)))
        line.data_received(codec.encode(Enq(number, (1 << 63) + n, Code.STATUS, body)))
        endpoint.ask(_now())  # what the timer does each second
        line.flush()
    assert endpoint.link.polls == POLLS + 1
    return line


def streams(socket: Nowhere, codec: Codec) -> object:
    """Return what the usual design keeps: reader, writer, queue, decoder and two tasks."""
    loop = asyncio.get_running_loop()
    reader = asyncio.StreamReader()
    writer = asyncio.StreamWriter(socket, asyncio.StreamReaderProtocol(reader), reader, loop)
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
    codec, ids, socket = Codec(DEFAULT), CmdIds(Epoch(1)), Nowhere()
    specs = [spec_of(n + 1) for n in range(COUNT + 1)]
    floor = asyncio.run(_each(lambda _: bare()))
    ours = asyncio.run(_each(lambda n: session(n + 1, specs[n], socket, codec, ids)))
    naive = asyncio.run(_each(lambda _: streams(socket, codec)))
    yield Row(
        "memory per vehicle session, without the socket; floor: a bare task",
        ours, floor, naive, "bytes", 3.0,
        note="ours: with 100 STATUS events and 100 answers to polls taken, 64 of each kept as duplicates and the last 32 packets "
        "for people; naive keeps none",
    )  # fmt: skip
