import asyncio
import time
from collections.abc import AsyncIterator
from contextlib import asynccontextmanager

from app.domain.units import Seconds
from app.runtime.lines import Line
from app.runtime.transports import DeviceServer, Dialler, Tcp
from tests.e2e.processes import free_ports
from tests.runtime.peers import Echo, run, until


def now() -> Seconds:
    return Seconds(time.monotonic())


@asynccontextmanager
async def served(echo: Echo, port: int = 0) -> AsyncIterator[DeviceServer]:
    server = DeviceServer(Line(echo, now), "127.0.0.1", port)
    await server.start()
    try:
        yield server
    finally:
        await server.stop()


def test_a_dialler_connects_and_connects_again_after_a_loss() -> None:
    async def scenario() -> None:
        ours, theirs = Echo(), Echo()
        async with served(theirs) as server:
            dialler = Dialler(Line(ours, now), Tcp("127.0.0.1", server.port), "V1")
            dialler.start()
            await until(lambda: "connected" in theirs.notes)
            theirs.wants_close = True
            server._line.flush()
            await until(lambda: theirs.notes.count("connected") >= 2)
            await dialler.stop()

    run(scenario)


def test_a_dialler_waits_for_a_peer_that_is_not_there_yet() -> None:
    async def scenario() -> None:
        (port,) = free_ports(1)
        ours, theirs = Echo(), Echo()
        dialler = Dialler(Line(ours, now), Tcp("127.0.0.1", port), "V1")
        dialler.start()
        await asyncio.sleep(0.05)
        async with served(theirs, port):
            await until(lambda: "connected" in ours.notes)
            await dialler.stop()

    run(scenario)


def test_a_dialler_stops_at_any_moment_of_an_attempt() -> None:
    async def scenario() -> None:
        (port,) = free_ports(1)
        for rounds in range(40):
            dialler = Dialler(Line(Echo(), now), Tcp("127.0.0.1", port), "V1")
            dialler.start()
            for _ in range(rounds % 10):
                await asyncio.sleep(0)
            await dialler.stop()

    run(scenario)


def test_a_line_is_cut_at_any_moment_of_an_attempt_that_succeeds() -> None:
    async def scenario() -> None:
        async with served(Echo()) as server:
            for rounds in range(40):
                ours = Echo()
                line = Line(ours, now)
                dialler = Dialler(line, Tcp("127.0.0.1", server.port), "V1")
                dialler.start()
                for _ in range(rounds % 10):
                    await asyncio.sleep(0)
                await dialler.stop()
                await line.disconnected()
                assert ours.notes in ([], ["connected", "disconnected"])

    run(scenario)


def test_what_a_peer_says_at_once_is_heard() -> None:
    async def scenario() -> None:
        ours = Echo()

        async def greet(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
            writer.write(b"hello")
            await reader.read()
            writer.close()

        server = await asyncio.start_server(greet, "127.0.0.1", 0)
        dialler = Dialler(Line(ours, now), Tcp("127.0.0.1", server.sockets[0].getsockname()[1]), "V1")
        dialler.start()
        await until(lambda: "hello" in ours.notes)
        await dialler.stop()
        server.close()

    run(scenario)


def test_a_device_serves_one_controller_at_a_time() -> None:
    async def scenario() -> None:
        echo = Echo()
        async with served(echo) as server:
            first_in, first_out = await asyncio.open_connection("127.0.0.1", server.port)
            await until(lambda: echo.notes == ["connected"])
            second_in, second_out = await asyncio.open_connection("127.0.0.1", server.port)
            assert await _ended(second_in)
            first_out.write(b"x")
            assert await first_in.readexactly(1) == b"X"
            for writer in (first_out, second_out):
                writer.close()
            await until(lambda: echo.notes[-1] == "disconnected")

    run(scenario)


def test_two_controllers_at_the_same_moment_do_not_both_get_the_device() -> None:
    async def scenario() -> None:
        echo = Echo()
        async with served(echo) as server:
            pairs = await asyncio.gather(*(asyncio.open_connection("127.0.0.1", server.port) for _ in range(5)))
            await until(lambda: bool(echo.notes))
            for _, writer in pairs:
                writer.write(b"x")
            answers = await asyncio.gather(*(_answer(reader) for reader, _ in pairs))
            assert sorted(answers) == [b"", b"", b"", b"", b"X"]
            for _, writer in pairs:
                writer.close()
            await until(lambda: echo.notes[-1] == "disconnected")

    run(scenario)


def test_a_device_that_refuses_is_not_listening() -> None:
    async def scenario() -> None:
        refuses = False
        echo = Echo()
        server = DeviceServer(Line(echo, now), "127.0.0.1", 0, lambda: refuses)
        await server.start()
        refuses = True
        while await _can_connect(server.port):
            await asyncio.sleep(0.01)
        refuses = False
        while not await _can_connect(server.port):
            await asyncio.sleep(0.01)
        await server.stop()

    run(scenario)


async def _can_connect(port: int) -> bool:
    try:
        reader, writer = await asyncio.open_connection("127.0.0.1", port)
    except ConnectionError:
        return False
    writer.close()
    await _ended(reader)
    return True


async def _ended(reader: asyncio.StreamReader) -> bool:
    return await _answer(reader) == b""


async def _answer(reader: asyncio.StreamReader) -> bytes:
    try:
        return await reader.read(1)
    except ConnectionError:
        return b""
