"""WebSockets that send to many what was framed once."""

from typing import Any

from uvicorn.protocols.websockets.websockets_sansio_impl import WebSocketsSansIOProtocol
from websockets.protocol import State

WIRE = "hoistway.wire"
"""ASGI extension of a WebSocket: a call that writes a whole frame as it is, at once; False: it has to be sent as usual."""

WRITABLE = "hoistway.writable"
"""And a call that waits until the watcher takes bytes."""


class Stream(WebSocketsSansIOProtocol):
    """A WebSocket that takes ready frames: without extensions of the protocol they are the same for every watcher."""

    async def run_asgi(self) -> None:
        """Run the application, which may write frames past its messages."""
        extensions: dict[str, Any] = self.scope["extensions"]
        extensions[WIRE] = self.write_frame
        extensions[WRITABLE] = self.writable.wait
        await super().run_asgi()

    def write_frame(self, frame: bytes) -> bool:
        """Write a frame if the watcher is there and takes it; return whether it was."""
        if self.conn.state is not State.OPEN or self.close_sent or self.disconnected or self.conn.extensions:
            return False
        if not self.writable.is_set() or not self.handshake_complete:
            return False
        self.transport.write(frame)
        return True
