"""A line over a serial port of this machine."""

import asyncio
from pathlib import Path

import pytest

from app.domain.layout import SerialPort
from app.runtime.clock import Clock
from app.runtime.lines import Line
from app.runtime.pty import PtyPort
from app.runtime.serial_port import Serial
from tests.runtime.peers import Echo, run, until


def test_a_port_that_is_closed_and_cut_again_and_again_ends_once(tmp_path: Path) -> None:
    async def scenario() -> None:
        ours, theirs = Echo(), PtyPort(Line(Echo(), Clock().now), tmp_path / "port")
        await theirs.start()
        line = Line(ours, Clock().now)
        await Serial(SerialPort(str(tmp_path / "port"))).connect(line)
        await until(lambda: line.up)
        wire = line._transport
        assert wire is not None
        wire.close()
        wire.abort()
        wire.abort()
        await asyncio.gather(*(task for task in asyncio.all_tasks() if "connection_lost" in repr(task.get_coro())))
        assert ours.notes == ["connected", "disconnected"]
        await theirs.stop()

    run(scenario)


def test_a_port_that_is_not_there_is_an_error_of_the_system(tmp_path: Path) -> None:
    async def scenario() -> None:
        with pytest.raises(OSError, match="no-port"):
            await Serial(SerialPort(str(tmp_path / "no-port"))).connect(Line(Echo(), Clock().now))

    run(scenario)
