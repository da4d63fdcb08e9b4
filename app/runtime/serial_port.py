"""Lines over a serial port of this machine (RS-485, RS-232), through pyserial."""

import asyncio
from dataclasses import dataclass

import serial_asyncio_fast

from app.domain.layout import SerialPort
from app.runtime.lines import Line


@dataclass(frozen=True, slots=True)
class Serial:
    """A peer behind a serial port, which is opened for us alone."""

    port: SerialPort

    def __str__(self) -> str:
        port = self.port
        return f"{port.device}, {port.baud} {port.data_bits}{port.parity}{port.stop_bits}"

    async def connect(self, line: Line) -> None:
        """Open the port. Raises OSError: it is not there, or somebody else has it."""
        port = self.port
        try:
            await serial_asyncio_fast.create_serial_connection(
                asyncio.get_running_loop(),
                lambda: line,
                port.device,
                baudrate=port.baud,
                bytesize=port.data_bits,
                parity=port.parity,
                stopbits=port.stop_bits,
                exclusive=True,
            )
        except ValueError as error:
            # pyserial's word for a figure that the port's driver does not know, such as its baud rate.
            raise OSError(str(error)) from error
