"""The real application around a scripted controller, served to a browser from a thread."""

import asyncio
import socket
import threading
from collections.abc import Callable, Coroutine, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from typing import TypeVar

import uvicorn

from app.api import application
from app.domain.view import Topic, Update, VehicleView
from app.settings import Settings
from tests.api.scripted import Scripted

T = TypeVar("T")


class Served:
    """A server under way; ``do`` runs something in its loop, where the controller lives."""

    def __init__(self, port: int, settings: Settings, controller: Scripted | None = None) -> None:
        self.controller = controller or Scripted()
        self._loop = asyncio.new_event_loop()
        self._listening = socket.socket()
        self._listening.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
        self._listening.bind(("127.0.0.1", port))
        self._listening.listen()
        config = uvicorn.Config(
            application(self.controller, settings),
            loop="none",
            ws="websockets-sansio",
            lifespan="off",
            log_config=None,
            log_level="critical",
            timeout_graceful_shutdown=1,
        )
        self._server = uvicorn.Server(config)
        self._thread = threading.Thread(target=self._run)
        self._thread.start()

    @property
    def port(self) -> int:
        """Where it listens."""
        port: int = self._listening.getsockname()[1]
        return port

    @property
    def url(self) -> str:
        """The page's address."""
        return f"http://127.0.0.1:{self.port}/"

    def do(self, action: Callable[[], object]) -> None:
        """Run an action in the server's loop and wait for it."""

        async def run() -> None:
            action()

        self.wait(run())

    def wait(self, work: Coroutine[object, object, T]) -> T:
        """Await something in the server's loop; return what it gives."""
        return asyncio.run_coroutine_threadsafe(work, self._loop).result(60)

    def place(self, vehicle: str, barcode: str, **more: object) -> None:
        """Let a vehicle report a barcode."""
        now = self.controller.model.get(Topic.VEHICLES, vehicle)
        assert isinstance(now, VehicleView)
        view = replace(now, barcode=barcode, dist=0, **more)  # type: ignore[arg-type]
        self.show([Update(Topic.VEHICLES, vehicle, view)])

    def show(self, updates: Sequence[Update]) -> None:
        """Let the read model change."""
        self.do(lambda: self.controller.hub.publish(updates))

    def stop(self) -> None:
        """End it."""
        self._server.should_exit = True
        self._thread.join(20)
        self._loop.close()
        self._listening.close()

    def _run(self) -> None:
        asyncio.set_event_loop(self._loop)
        self._loop.run_until_complete(self._serve())

    async def _serve(self) -> None:
        await self._server.serve(sockets=[self._listening])
        # What has not ended in its time to end, on a busy machine, is cut: nothing may be left to whoever runs next.
        for connection in list(self._server.server_state.connections):
            transport = getattr(connection, "transport", None)
            if transport is not None:
                transport.abort()
        await asyncio.sleep(0)


@contextmanager
def served(port: int = 0, controller: Scripted | None = None, **settings: object) -> Iterator[Served]:
    """Serve until the block ends."""
    server = Served(port, Settings.model_validate(settings), controller)
    try:
        yield server
    finally:
        server.stop()
