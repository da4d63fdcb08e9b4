"""Which jobs the store has: asked before each order, since a host may repeat one that ended long ago."""

import asyncio
from collections.abc import Sequence

from app.api.port import Reader
from app.domain.errors import HoistwayError, StoreError
from app.domain.ids import JobId
from app.domain.job import Job
from app.fleet.jobs import OUR_NAMES
from app.store.names import Names

BATCH = 500
"""Most jobs looked up by one statement."""
PAGE = 5_000
"""So many names are read at a time. Our choice."""
ROOM = 200_000
"""Room for so many names at least (half a megabyte); otherwise for twice those that there are. Our choice."""


class KnownJobs:
    """Finds jobs that the store has; most orders are new, which their name alone says once all names have been read.

    Those that look known are looked up, with one statement for all that are asked for while the last one runs.
    """

    def __init__(self, reader: Reader) -> None:
        self.reader = reader
        self._names: Names | None = None
        self._noted: list[str] = []
        self._reading: asyncio.Task[None] | None = None
        self._waiting: list[tuple[JobId, asyncio.Future[Job | None]]] = []
        self._running: asyncio.Task[None] | None = None

    def surely_not(self, job: str) -> bool:
        """Return True if the store has no job of that name; False says nothing. All names are read when it is first asked."""
        if self._names is None:
            if self._reading is None:
                self._reading = asyncio.create_task(self._read())
            return False
        return self._names.surely_not(job) and not job.startswith(OUR_NAMES)

    def note(self, job: str) -> None:
        """The store may have a job of that name from now on. Say so before it is asked for: no answer is no refusal."""
        if self._names is None:
            self._noted.append(job)
        else:
            self._names.add(job)

    async def job(self, job: JobId) -> Job | None:
        """Return the job, ended or not. Raises StoreError."""
        future: asyncio.Future[Job | None] = asyncio.get_running_loop().create_future()
        self._waiting.append((job, future))
        if self._running is None:
            self._running = asyncio.create_task(self._run())
        return await future

    async def _read(self) -> None:
        """Read all names, and add those that were ordered meanwhile."""
        run = asyncio.get_running_loop().run_in_executor
        try:
            names, last = Names(max(ROOM, 2 * await run(None, self.reader.job_count))), 0
            while page := await run(None, self.reader.job_names, last, PAGE):
                last = page[-1][0]
                names.add_all(name for _, name in page)
        except StoreError:
            return  # each order is looked up meanwhile, and the next one tries again
        finally:
            self._reading = None
        for name in self._noted:
            names.add(name)
        self._names, self._noted = names, []

    async def _run(self) -> None:
        batch: list[tuple[JobId, asyncio.Future[Job | None]]] = []
        try:
            while self._waiting:
                batch, self._waiting = self._waiting[:BATCH], self._waiting[BATCH:]
                await self._answer(batch)
        finally:
            self._running = None
            for _, future in batch:
                future.cancel()

    async def _answer(self, batch: Sequence[tuple[JobId, asyncio.Future[Job | None]]]) -> None:
        names = [name for name, _ in batch]
        try:
            found = await asyncio.get_running_loop().run_in_executor(None, self.reader.jobs_named, names)
        except HoistwayError as error:
            for _, future in batch:
                if not future.done():
                    future.set_exception(error)
            return
        jobs = {job.id: job for job in found}
        for name, future in batch:
            if not future.done():
                future.set_result(jobs.get(name))
