"""The servers under test, each in a process of its own: ``python -m tests.bench.serving KIND PORT CONNECTIONS POLL``."""

import asyncio
import gc
import sys
import tempfile
from collections.abc import Callable, Coroutine, Iterable
from typing import Any

import uvloop

from app.control.lines import VehicleLine
from app.domain.events import Event
from app.domain.ids import CmdIds, DevId, Epoch, VehicleId
from app.domain.layout import Edge, Plant, Point, VehicleSpec
from app.domain.units import Barcode, Millimetres, Seconds
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.dialects import DEFAULT
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import NOTHING, Code, Enq, Resp2, Toward
from app.protocols.itsc.session import Timing
from app.runtime.clock import Clock
from app.runtime.controller import Controller
from app.runtime.lines import Line
from app.runtime.sockets import Sockets
from app.runtime.telemetry import set_up

HOST = "127.0.0.1"


def spec_of(number: int, port: int = 0) -> VehicleSpec:
    """Return the vehicle with this DEV_ID; all are dialled at one address, and the load learns who it is from the first poll."""
    return VehicleSpec(VehicleId(f"V{number:04}"), DevId(number), HOST, port, start=Barcode(str(10 * number + 1)))


def islands(count: int, port: int) -> Plant:
    """Return a plant in which each vehicle stands on a ring of its own, of three barcodes."""
    points, edges = [], []
    for number in range(1, count + 1):
        ring = [Barcode(str(10 * number + at)) for at in (1, 2, 3)]
        x = Millimetres(10_000 * number)
        points += [Point(barcode, x, Millimetres(2000 * i)) for i, barcode in enumerate(ring)]
        edges += [Edge(a, b, Millimetres(2000)) for a, b in zip(ring, [*ring[1:], ring[0]], strict=True)]
    vehicles = tuple(spec_of(number, port) for number in range(1, count + 1))
    return Plant("bench", tuple(points), tuple(edges), (), vehicles)


async def sessions(port: int, count: int, poll: float) -> None:
    """Serve lines and sessions; in place of the fleet, the newest event of each vehicle is kept."""
    loop, ids = asyncio.get_running_loop(), CmdIds(Epoch(1))
    newest: dict[VehicleId, Event] = {}
    # A vehicle that is asked seldom is not silent before it is asked: it may take longer than usual until all are connected.
    timing, sockets = Timing(poll=Seconds(poll), silence=Seconds(poll + 2.5)), Sockets()

    def told(events: Iterable[Event], _now: Seconds) -> None:
        for event in events:
            newest[event.vehicle] = event

    for number in range(1, count + 1):
        line = Line(VehicleLine(told, spec_of(number), DEFAULT, ids, timing), Clock().now, sockets=sockets)
        await loop.create_connection(lambda line=line: line, HOST, port)  # type: ignore[misc]
    await _for_ever()


async def controller(port: int, count: int, _poll: float) -> None:
    """Serve the whole controller with its database, as ``hoistway serve`` does, without the API."""
    set_up(as_json=True, level="error")
    with tempfile.TemporaryDirectory() as place:
        whole = Controller(islands(count, port), f"sqlite:///{place}/bench.db")
        await whole.start()
        await _for_ever()


async def streams(port: int, count: int, poll: float) -> None:
    """Serve what is written at first: a task that reads frames into a queue, and one that waits for each with a deadline."""
    ids, codec = CmdIds(Epoch(1)), Codec(DEFAULT)
    state: dict[int, Resp2] = {}

    async def read(reader: asyncio.StreamReader, queue: asyncio.Queue[Enq]) -> None:
        decoder = Decoder(codec, Toward.CONTROLLER)
        while data := await reader.read(4096):
            for item in decoder.feed(data):
                if isinstance(item, Enq):
                    await queue.put(item)

    async def serve(number: int, queue: asyncio.Queue[Enq], writer: asyncio.StreamWriter) -> None:
        while True:
            writer.write(codec.encode(Enq(number, ids.next(), int(Code.STATUS), NOTHING)))
            poll_at = asyncio.get_running_loop().time() + poll
            while (left := poll_at - asyncio.get_running_loop().time()) > 0:
                try:
                    frame = await asyncio.wait_for(queue.get(), left)
                except TimeoutError:
                    break
                if isinstance(frame.body, Resp2):
                    state[number] = frame.body
                writer.write(codec.ack(frame.dev_id, frame.cmd_id))
                await writer.drain()

    tasks = []
    for number in range(1, count + 1):
        reader, writer = await asyncio.open_connection(HOST, port)
        queue: asyncio.Queue[Enq] = asyncio.Queue()
        tasks += [asyncio.create_task(read(reader, queue)), asyncio.create_task(serve(number, queue, writer))]
    await _for_ever()


async def _for_ever() -> None:
    gc.collect()
    gc.freeze()
    await asyncio.Event().wait()


KINDS: dict[str, Callable[[int, int, float], Coroutine[Any, Any, None]]] = {
    "sessions": sessions,
    "controller": controller,
    "streams": streams,
}


if __name__ == "__main__":
    kind, port, count, poll = sys.argv[1:]
    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        runner.run(KINDS[kind](int(port), int(count), float(poll)))
