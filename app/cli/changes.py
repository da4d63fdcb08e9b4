"""A plant file that changes while its controller runs: read again on request, and taken only if it breaks nothing under way."""

from __future__ import annotations

import asyncio
from pathlib import Path

from structlog.typing import FilteringBoundLogger

from app.cli.plainly import CannotStart
from app.cli.running import plant_of
from app.domain.errors import HoistwayError
from app.domain.layout import Plant
from app.runtime.telemetry import logger


class Changes:
    """Looks at a plant file again whenever it is asked to (SIGHUP). ``last`` is the plant that the controller runs with."""

    def __init__(self, file: Path, database: str, asked: asyncio.Event) -> None:
        self.last: Plant | None = None
        self._file, self._database, self._asked = file, database, asked

    async def next(self, plant: Plant) -> Plant:
        """Wait until the file holds another plant that can take this one's place, and return it."""
        log = logger(plant=plant.name)
        while True:
            await self._asked.wait()
            self._asked.clear()
            try:
                found = await asyncio.to_thread(plant_of, self._file)
            except CannotStart as wrong:
                _refused(log, wrong)
                continue
            if found.name != plant.name:
                log.error("the plant file is not taken", reason=f"it is of another plant: {found.name}")
            elif found == plant:
                log.info("the plant file says nothing new")
            elif await self.fits(plant, found):
                log.warning("the plant changes", differences=await asyncio.to_thread(_counted, plant, found))
                return found

    async def fits(self, plant: Plant, found: Plant) -> bool:
        """Whether everything under way has its place in the plant that was found; what has none is logged."""
        from app.plant.touched import touched
        from app.store.standing import standing

        log = logger(plant=plant.name)
        try:
            kept = await asyncio.to_thread(standing, self._database)
        except HoistwayError as wrong:
            _refused(log, wrong)
            return False
        broken = await asyncio.to_thread(touched, plant, found, kept)
        for one in broken:
            log.error(
                "the plant file is not taken", breaks=f"{one.what} {one.name}", reason=one.text, remedy=one.remedy
            )
        return not broken


def _refused(log: FilteringBoundLogger, wrong: HoistwayError) -> None:
    log.error("the plant file is not taken", reason=wrong.message, remedy=wrong.remedy)


def _counted(old: Plant, new: Plant) -> int:
    from app.plant.difference import difference

    return len(difference(old, new).changes)
