"""Serial ports that are not there: a simulated device behind a pseudo terminal, at a path like a serial port's."""

import asyncio
import errno
import os
import tty
from contextlib import suppress
from pathlib import Path
from typing import Any

from app.runtime.lines import Line

_AT_ONCE = 4096


class PtyPort:
    """Serves one line at ``path``, a link to the terminal; whoever opens it finds a serial port with the device behind.

    ``stop`` is like pulling the cable: who has it open loses it. ``start`` plugs it in again.
    """

    def __init__(self, line: Line, path: Path) -> None:
        self._line, self._path = line, path
        self._wire: _Wire | None = None

    async def start(self) -> None:
        """Make the port. Raises OSError: something else is at the path, or it cannot be made there."""
        if self._path.is_symlink() and str(self._path.readlink()).startswith("/dev/pts/"):
            self._path.unlink()
        ours, theirs = os.openpty()
        try:
            tty.setraw(theirs)
            os.set_blocking(ours, False)
            self._path.symlink_to(os.ttyname(theirs))
        except OSError as error:
            os.close(ours)
            os.close(theirs)
            raise OSError(error.errno, error.strerror, str(self._path)) from None
        self._wire = _Wire(self._line, ours, theirs)
        self._line.connection_made(self._wire)

    async def stop(self) -> None:
        """Take the port away."""
        if self._wire is not None:
            self._path.unlink(missing_ok=True)
            self._wire.abort()
            await self._line.disconnected()
            self._wire = None
        self._line.stop()


class _Wire(asyncio.Transport):
    """Our side of the terminal. The other is kept open too: a serial port is there whether somebody listens or not."""

    def __init__(self, line: Line, ours: int, theirs: int) -> None:
        super().__init__()
        self._line, self._ours, self._theirs = line, ours, theirs
        self._loop = asyncio.get_running_loop()
        self._closed = False
        self._loop.add_reader(ours, self._read)

    def get_extra_info(self, name: str, default: Any = None) -> Any:
        """There is no socket."""
        return default

    def set_write_buffer_limits(self, high: int | None = None, low: int | None = None) -> None:
        """Nothing is buffered."""

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send; what nobody takes is lost, as on a wire."""
        with suppress(BlockingIOError):
            if not self._closed:
                os.write(self._ours, data)

    def is_closing(self) -> bool:
        """Whether it is closed."""
        return self._closed

    def close(self) -> None:
        """Close at once."""
        self.abort()

    def abort(self) -> None:
        """Close at once."""
        if self._closed:
            return
        self._closed = True
        self._loop.remove_reader(self._ours)
        os.close(self._ours)
        os.close(self._theirs)
        self._loop.call_soon(self._line.connection_lost, None)

    def _read(self) -> None:
        try:
            data = os.read(self._ours, _AT_ONCE)
        except BlockingIOError:
            return
        except OSError as error:
            if error.errno != errno.EIO:
                raise
            return
        self._line.data_received(data)
