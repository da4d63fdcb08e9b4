"""What ours is measured against over HTTP, each in a process of its own: ``python -m tests.bench.posts KIND DATABASE``."""

import asyncio
import queue
import socket
import sqlite3
import sys
import threading
from collections.abc import Callable
from typing import Any

import msgspec
import uvicorn
import uvloop

STATIONS = 20
TABLE = "CREATE TABLE jobs (id TEXT PRIMARY KEY, source TEXT, destination TEXT, priority INTEGER, state TEXT)"
INSERT = "INSERT INTO jobs VALUES (?, ?, ?, ?, 'queued')"


def plant() -> str:
    """Return the plant file of a ring with side buffers and one vehicle that is not there: jobs are accepted and wait."""
    ring = range(100, 100 + STATIONS)
    vehicle = 'dev_id: 1, address: "127.0.0.1:1"'
    lines = [
        "name: posts",
        "barcodes:",
        *(f"  {barcode}: [{2000 * n}, {1000 * (n % 2)}]" for n, barcode in enumerate(ring)),
        f"track: [{{through: [{', '.join(map(str, (*ring, ring[0])))}]}}]",
        "stations:",
        *(f"  B{n}: {{kind: sbfl, at: {barcode}}}" for n, barcode in enumerate(ring)),
        "vehicle_defaults:",
        "  limits: {shft: [-20000, 20000], rota: [-20000, 20000], lift: [0, 100000]}",
        f"vehicles: {{V1: {{{vehicle}}}}}",
    ]
    return "\n".join(lines)


class Commits:
    """Group commit at its barest: a thread, a connection, and whatever waits in one transaction."""

    def __init__(self, database: str, loop: asyncio.AbstractEventLoop) -> None:
        self._loop = loop
        self._queue: queue.SimpleQueue[tuple[tuple[Any, ...], asyncio.Future[None]]] = queue.SimpleQueue()
        self._database = database
        threading.Thread(target=self._run, daemon=True).start()

    def put(self, row: tuple[Any, ...]) -> asyncio.Future[None]:
        """Return what is done once the row is durable."""
        future = self._loop.create_future()
        self._queue.put((row, future))
        return future

    def _run(self) -> None:
        connection = sqlite3.connect(self._database, isolation_level=None)
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA synchronous=FULL")
        connection.execute(TABLE)
        while True:
            batch = [self._queue.get()]
            while not self._queue.empty():
                batch.append(self._queue.get())
            connection.execute("BEGIN")
            connection.executemany(INSERT, [row for row, _ in batch])
            connection.execute("COMMIT")
            self._loop.call_soon_threadsafe(_done, [future for _, future in batch])


def _done(futures: list[asyncio.Future[None]]) -> None:
    for future in futures:
        future.set_result(None)


class JobIn(msgspec.Struct):
    """The body, as the floor reads it."""

    job_id: str
    source: str
    destination: str
    priority: int = 50


def floor(database: str) -> None:
    """Serve nothing but this one call: raw ASGI in the same server, one row, group commit."""
    decode = msgspec.json.Decoder(JobIn).decode
    encode = msgspec.json.Encoder().encode
    commits: list[Commits] = []

    async def app(scope: Any, receive: Any, send: Any) -> None:
        body = decode((await receive())["body"])
        await commits[0].put((body.job_id, body.source, body.destination, body.priority))
        answer = encode(body)
        headers = [(b"content-type", b"application/json"), (b"content-length", str(len(answer)).encode())]
        await send({"type": "http.response.start", "status": 201, "headers": headers})
        await send({"type": "http.response.body", "body": answer})

    _serve(app, lambda: commits.append(Commits(database, asyncio.get_running_loop())))


def naive(database: str) -> None:
    """Serve what is written at first: FastAPI, a session per request in its thread pool, a commit per row."""
    import sqlalchemy as sa
    from fastapi import FastAPI
    from pydantic import BaseModel
    from sqlalchemy import orm

    class Base(orm.DeclarativeBase):
        pass

    class JobRow(Base):
        __tablename__ = "jobs"
        id: orm.Mapped[str] = orm.mapped_column(primary_key=True)
        source: orm.Mapped[str]
        destination: orm.Mapped[str]
        priority: orm.Mapped[int]
        state: orm.Mapped[str]

    class Body(BaseModel):
        job_id: str
        source: str
        destination: str
        priority: int = 50

    engine = sa.create_engine(f"sqlite:///{database}", pool_size=40, connect_args={"timeout": 30})

    @sa.event.listens_for(engine, "connect")
    def durable(connection: Any, _record: Any) -> None:
        connection.execute("PRAGMA journal_mode=WAL")
        connection.execute("PRAGMA synchronous=FULL")

    Base.metadata.create_all(engine)
    app = FastAPI()

    @app.post("/api/v1/jobs", status_code=201)
    def post(body: Body) -> Body:
        with orm.Session(engine) as session:
            row = body.model_dump()
            session.add(JobRow(id=row.pop("job_id"), state="queued", **row))
            session.commit()
        return body

    _serve(app, lambda: None)


def _serve(app: Any, begin: Callable[[], None]) -> None:
    listening = socket.create_server(("127.0.0.1", 0), backlog=2048)
    config = uvicorn.Config(app, loop="none", http="httptools", access_log=False, log_config=None, lifespan="off")

    async def run() -> None:
        begin()
        _say(listening.getsockname()[1])
        await uvicorn.Server(config).serve([listening])

    with asyncio.Runner(loop_factory=uvloop.new_event_loop) as runner:
        runner.run(run())


def _say(port: int) -> None:
    print(port, flush=True)


KINDS: dict[str, Callable[[str], None]] = {"floor": floor, "naive": naive}

if __name__ == "__main__":
    KINDS[sys.argv[1]](sys.argv[2])
