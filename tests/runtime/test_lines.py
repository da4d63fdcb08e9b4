import asyncio
import time

from app.domain.units import Seconds
from app.runtime.lines import FLOOD, UNSENT_LIMIT, Line
from tests.runtime.peers import Echo, run, until


def now() -> Seconds:
    return Seconds(time.monotonic())


class Wire:
    """A line served on a port of its own."""

    def __init__(self) -> None:
        self.echo = Echo()
        self.inputs = 0
        self.line = Line(self.echo, now, self._input)

    def _input(self) -> None:
        self.inputs += 1

    async def dial(self) -> tuple[asyncio.StreamReader, asyncio.StreamWriter]:
        loop = asyncio.get_running_loop()
        self.server = await loop.create_server(lambda: self.line, "127.0.0.1", 0)
        return await asyncio.open_connection(*self.server.sockets[0].getsockname())

    async def close(self, writer: asyncio.StreamWriter) -> None:
        writer.close()
        self.line.stop()
        await self.line.disconnected()
        self.server.close()
        await self.server.wait_closed()


def test_bytes_go_in_and_what_the_endpoint_says_goes_out() -> None:
    async def scenario() -> None:
        wire = Wire()
        reader, writer = await wire.dial()
        writer.write(b"abc")
        assert await reader.readexactly(3) == b"ABC"
        assert wire.line.up
        assert wire.line.heard
        await wire.close(writer)
        assert wire.echo.notes == ["connected", "abc", "disconnected"]
        assert wire.inputs == 3
        assert not wire.line.up

    run(scenario)


def test_an_endpoint_that_wants_to_close_sends_its_last_bytes_first() -> None:
    async def scenario() -> None:
        wire = Wire()
        reader, writer = await wire.dial()
        writer.write(b"bye")
        assert await reader.read() == b"BYE"
        await wire.line.disconnected()
        await wire.close(writer)

    run(scenario)


def test_the_endpoint_is_ticked_at_its_deadline_with_or_without_a_connection() -> None:
    async def scenario() -> None:
        echo = Echo()
        line = Line(echo, now)
        echo.deadline = Seconds(now() + 0.03)
        line.flush()
        await until(lambda: echo.notes == ["tick"])
        line.stop()

    run(scenario)


def test_a_deadline_that_moves_back_is_kept_without_a_tick_at_the_old_one() -> None:
    async def scenario() -> None:
        echo = Echo()
        line = Line(echo, now)
        echo.deadline = Seconds(now() + 0.01)
        line.flush()
        echo.deadline = Seconds(now() + 0.05)
        line.flush()
        await until(lambda: bool(echo.notes))
        line.stop()

    run(scenario)


def test_a_deadline_that_comes_nearer_is_kept() -> None:
    async def scenario() -> None:
        echo = Echo()
        line = Line(echo, now)
        echo.deadline = Seconds(now() + 3600)
        line.flush()
        echo.deadline = Seconds(now() + 0.01)
        line.flush()
        await until(lambda: echo.notes == ["tick"])
        line.stop()

    run(scenario)


def test_a_stopped_line_ticks_no_more() -> None:
    async def scenario() -> None:
        echo = Echo()
        line = Line(echo, now)
        echo.deadline = Seconds(now() + 0.01)
        line.flush()
        line.stop()
        await asyncio.sleep(0.03)
        assert echo.notes == []

    run(scenario)


def test_a_peer_that_takes_no_bytes_is_cut_off() -> None:
    async def scenario() -> None:
        wire = Wire()
        _, writer = await wire.dial()
        await until(lambda: wire.line.up)
        while wire.line.up:
            wire.echo.out.append(bytes(UNSENT_LIMIT))
            wire.line.flush()
            await asyncio.sleep(0)
        await wire.close(writer)
        assert wire.echo.notes[-1] == "disconnected"

    run(scenario)


def test_a_line_serves_one_connection_after_another() -> None:
    async def scenario() -> None:
        wire = Wire()
        reader, writer = await wire.dial()
        writer.close()
        await until(lambda: "disconnected" in wire.echo.notes)
        reader, writer = await asyncio.open_connection(*wire.server.sockets[0].getsockname())
        writer.write(b"again")
        assert await reader.readexactly(5) == b"AGAIN"
        await wire.close(writer)

    run(scenario)


class Still(asyncio.Transport):
    """A connection in the test's own time."""

    def __init__(self) -> None:
        super().__init__()
        self.cuts = 0

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        pass

    def write(self, data: bytes | bytearray | memoryview) -> None:
        pass

    def abort(self) -> None:
        self.cuts += 1


def test_a_peer_that_floods_the_line_is_cut_off_and_no_byte_too_many_is_looked_at() -> None:
    async def scenario() -> None:
        clock = 100.0
        echo = Echo()
        line = Line(echo, lambda: Seconds(clock))
        for _ in range(3):
            clock += 5.0
            line.connection_made(still := Still())
            for _ in range(3):
                line.data_received(b"a" * FLOOD)
                clock += 0.4
            assert still.cuts
            assert line.flooded
            line.connection_lost(None)
        heard = sum(len(note) for note in echo.notes if note.startswith("a"))
        assert heard <= 3 * 2 * FLOOD

    run(scenario)


def test_a_peer_that_sends_much_but_not_at_once_is_heard() -> None:
    async def scenario() -> None:
        clock = 100.0
        line = Line(Echo(), lambda: Seconds(clock))
        line.connection_made(still := Still())
        for _ in range(20):
            line.data_received(b"a" * FLOOD)
            clock += 1.0
        assert still.cuts == 0
        line.data_received(b"a" * (FLOOD + 1))
        assert still.cuts == 1
        line.connection_lost(None)

    run(scenario)
