"""A simulated device at a pseudo terminal."""

import asyncio
import os
from pathlib import Path

import pytest

from app.runtime.clock import Clock
from app.runtime.lines import Line
from app.runtime.pty import PtyPort
from tests.runtime.peers import Echo, run, until


def test_bytes_pass_both_ways_and_what_nobody_takes_is_lost(tmp_path: Path) -> None:
    async def scenario() -> None:
        echo, path = Echo(), tmp_path / "port"
        port = PtyPort(Line(echo, Clock().now), path)
        await port.start()
        file = os.open(path, os.O_RDWR | os.O_NOCTTY | os.O_NONBLOCK)
        os.write(file, b"hello")
        await until(lambda: "hello" in "".join(echo.notes))
        got = b""
        while got != b"HELLO":
            try:
                got += os.read(file, 100)
            except BlockingIOError:
                await asyncio.sleep(0)
        for _ in range(200):
            echo.out.append(b"x" * 500)
        os.write(file, b"more")
        await until(lambda: not echo.out)
        await port.stop()
        assert echo.notes[-1] == "disconnected"
        assert not path.is_symlink()
        os.close(file)

    run(scenario)


def test_a_port_left_by_a_killed_simulator_is_taken_over_and_anything_else_is_not(tmp_path: Path) -> None:
    async def scenario() -> None:
        path = tmp_path / "port"
        path.unlink(missing_ok=True)
        path.symlink_to("/dev/pts/99999")
        port = PtyPort(Line(Echo(), Clock().now), path)
        await port.start()
        await port.stop()
        path.write_text("a file", encoding="ascii")
        with pytest.raises(OSError, match="exists") as refused:
            await port.start()
        assert refused.value.filename == str(path)
        path.unlink()

    run(scenario)
