"""The sockets of many lines, read together: one question to the kernel for all that came, and no transport between."""

import asyncio
import os
import select
import socket
import time

READ = 1024
"""Bytes read at once. Our choice: some thirty packets; what is more comes with the next turn."""
MOST = 4096
"""Sockets asked for at a time."""
SLICE = 0.004
"""Seconds after which the loop has its turn, before the rest of them is read: nothing may hold it longer than 5 ms."""
_LOOKED_UP_EACH = 16
"""So many are read between two looks at the clock."""
_IN = 0x001
_OUT = 0x004
"""EPOLLIN and EPOLLOUT, which ``select`` has on Linux only."""


class Sockets:
    """Takes connections over from the loop's transports, for protocols that get small packets and answer at once.

    They are read in the order of their numbers, which is that in which they were opened: so what belongs to them is visited in
    the order in which it lies in memory, where a thousand connections would put each other out of the cache. Where there is no
    epoll nothing is taken over.
    """

    def __init__(self, slice_of: float = SLICE) -> None:
        self._slice = slice_of
        self._ready: list[tuple[int, int]] = []
        self._loop = asyncio.get_running_loop()
        self._epoll = select.epoll() if hasattr(select, "epoll") else None
        self._heirs: dict[int, asyncio.Protocol] = {}
        self._open: dict[int, Connection] = {}
        if self._epoll is not None:
            self._loop.add_reader(self._epoll.fileno(), self._look)

    def close(self) -> None:
        """Cut all connections and take no more."""
        for connection in tuple(self._open.values()):
            connection.abort()
        if self._epoll is not None:
            self._loop.remove_reader(self._epoll.fileno())
            self._epoll.close()
            self._epoll = None

    def take(self, transport: asyncio.Transport, protocol: asyncio.Protocol, limit: int) -> asyncio.Transport:
        """Return what the protocol writes to from now on, in place of the transport: the transport itself if it is no TCP.

        More than ``limit`` bytes that the peer does not take are told by ``pause_writing``.
        """
        sock = transport.get_extra_info("socket")
        if self._epoll is None or sock is None or sock.family not in {socket.AF_INET, socket.AF_INET6}:
            return transport
        # A number of our own for the same connection, since the transport closes the one that it has.
        fd = os.dup(sock.fileno())
        transport.set_protocol(asyncio.Protocol())
        transport.abort()
        self._heirs[fd] = protocol
        connection = self._open[fd] = Connection(self, fd, protocol, limit)
        self._epoll.register(fd, _IN)
        return connection

    def watch(self, fd: int, events: int) -> None:
        """Look for bytes, or for room to send."""
        if self._epoll is not None:
            self._epoll.modify(fd, events)

    def forget(self, fd: int) -> None:
        """Close a connection that has ended."""
        if self._epoll is not None:
            self._epoll.unregister(fd)
        del self._heirs[fd], self._open[fd]
        os.close(fd)

    def _look(self) -> None:
        """Read once from each where something came; those that are left have their turn when the loop looks again."""
        if self._epoll is None:
            return
        heirs, read, ready = self._heirs, os.read, self._ready
        if not ready:
            ready += self._epoll.poll(0, MOST)
            ready.sort(reverse=True)
        until, done = time.monotonic() + self._slice, 0
        while ready:
            if done == _LOOKED_UP_EACH:
                if time.monotonic() > until:
                    return
                done = 0
            done += 1
            fd, what = ready.pop()
            if what != _IN or (heir := heirs.get(fd)) is None:
                self._see(fd, what)
                continue
            try:
                data = read(fd, READ)
            except OSError as error:
                self._open[fd].failed(error)
                continue
            if not data:
                self._open[fd].end(None)
                continue
            try:
                heir.data_received(data)
            except BaseException:
                # As the loop's transports do: half a packet taken is no connection to go on with.
                if (connection := self._open.get(fd)) is not None:
                    connection.abort()
                raise

    def _see(self, fd: int, what: int) -> None:
        """Send what waits; where the connection is done for, read the reason."""
        connection = self._open.get(fd)
        if connection is None:
            return
        if what & _OUT:
            connection.send_rest()
        if what & ~_OUT and fd in self._open:
            connection.receive()


class Connection(asyncio.Transport):
    """One connection that was taken over: writes at once, or keeps what the peer does not take yet."""

    __slots__ = ("_closing", "_fd", "_limit", "_over", "_protocol", "_sockets", "_unsent")

    def __init__(self, sockets: Sockets, fd: int, protocol: asyncio.Protocol, limit: int) -> None:
        self._sockets, self._fd, self._protocol, self._limit = sockets, fd, protocol, limit
        self._unsent = b""
        self._over = self._closing = False

    def write(self, data: bytes | bytearray | memoryview) -> None:
        """Send bytes, or keep those that there is no room for."""
        if self._over or self._closing:
            return
        sent = 0
        if not self._unsent:
            try:
                sent = os.write(self._fd, data)
            except OSError as error:
                if not self.failed(error):
                    return
            if sent == len(data):
                return
            self._sockets.watch(self._fd, _IN | _OUT)
        self._unsent += data[sent:]
        if len(self._unsent) > self._limit:
            self._protocol.pause_writing()

    def close(self) -> None:
        """Close once everything is sent; nothing more is read."""
        if self._over or self._closing:
            return
        self._closing = True
        if self._unsent:
            self._sockets.watch(self._fd, _OUT)
        else:
            self.end(None)

    def abort(self) -> None:
        """Close at once; the protocol hears of it in the loop's next turn."""
        self.end(None)

    def is_closing(self) -> bool:
        """Whether it is closed, or about to be."""
        return self._over or self._closing

    def get_write_buffer_size(self) -> int:
        """Return how many bytes wait for room."""
        return len(self._unsent)

    def send_rest(self) -> None:
        """Send what has waited for room."""
        try:
            self._unsent = self._unsent[os.write(self._fd, self._unsent) :]
        except OSError as error:
            self.failed(error)
            return
        if self._unsent:
            return
        if self._closing:
            self.end(None)
        else:
            self._sockets.watch(self._fd, _IN)

    def receive(self) -> None:
        """Read once."""
        try:
            data = b"" if self._closing else os.read(self._fd, READ)
        except OSError as error:
            self.failed(error)
            return
        if data:
            self._protocol.data_received(data)
        else:
            self.end(None)

    def failed(self, error: OSError) -> bool:
        """End, unless there was only nothing to read or no room; return whether it goes on."""
        if isinstance(error, BlockingIOError):
            return True
        self.end(error)
        return False

    def end(self, error: OSError | None) -> None:
        """Close and tell the protocol, in the loop's next turn."""
        if not self._over:
            self._over = True
            self._unsent = b""
            self._sockets.forget(self._fd)
            asyncio.get_running_loop().call_soon(self._protocol.connection_lost, error)
