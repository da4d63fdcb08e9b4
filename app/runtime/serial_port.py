"""Lines over a serial port of this machine (RS-485, RS-232), through pyserial."""

import asyncio
from dataclasses import dataclass
from functools import partial

import serial
from serial_asyncio_fast import SerialTransport

from app.domain.layout import SerialPort
from app.runtime.lines import Line


class Wire(SerialTransport):
    """A transport that ends once, however often it is closed and aborted: the library would begin to end it each time."""

    _ending = False

    async def _call_connection_lost(self, exc: Exception | None, *, flush: bool) -> None:
        if not self._ending:
            self._ending = True
            await super()._call_connection_lost(exc, flush=flush)


@dataclass(frozen=True, slots=True)
class Serial:
    """A peer behind a serial port, which is opened for us alone."""

    port: SerialPort

    def __str__(self) -> str:
        port = self.port
        return f"{port.device}, {port.baud} {port.data_bits}{port.parity}{port.stop_bits}"

    async def connect(self, line: Line) -> None:
        """Open the port. Raises OSError: it is not there, or somebody else has it."""
        port, loop = self.port, asyncio.get_running_loop()
        opened = partial(
            serial.serial_for_url,
            port.device,
            baudrate=port.baud,
            bytesize=port.data_bits,
            parity=port.parity,
            stopbits=port.stop_bits,
            exclusive=True,
        )
        try:
            Wire(loop, line, await loop.run_in_executor(None, opened))
        except ValueError as error:
            # pyserial's word for a figure that the port's driver does not know, such as its baud rate.
            raise OSError(str(error)) from error
