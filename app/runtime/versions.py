"""The versions of a running plant: taken in, compared, asked for. What changes the plant over is woken when one is awaited."""

import asyncio
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from app.domain.errors import HoistwayError, Refusal
from app.domain.ids import Actor
from app.domain.layout import Plant
from app.domain.units import Timestamp
from app.domain.versions import Leaving, Origin, PlantVersion, Source
from app.plant import Finding
from app.plant.difference import Broken, Difference, difference, obstruction
from app.plant.lacking import lacking
from app.plant.lost import lost
from app.plant.overruled import overruled
from app.plant.touched import leaving, touched
from app.plant.understood import Understood
from app.store.standing import standing
from app.store.versions import VersionStore

REMEMBERED = 4
"""Plants of versions that are kept in memory, read. Our choice: a fab takes seconds to read, and some tens of megabytes."""

Read = Callable[[Source], Understood]
"""Reads a source. Raises UnusablePlant, for a catalogue with errors too; CannotStart for one that cannot be read."""


@dataclass(frozen=True, slots=True)
class Staged:
    """A version that was taken in, and the warnings about it."""

    version: PlantVersion
    findings: Sequence[Finding]


@dataclass(frozen=True, slots=True)
class Impact:
    """What a version would meet if it became active now: ``in_the_way`` keeps it back; what is ``lost``, or is to be taught
    afterwards (``lacking``), does not.
    """

    in_the_way: Sequence[Broken]
    lost: Sequence[Broken]
    lacking: Sequence[Broken]


class Versions:
    """The versions of one plant; reads and compares in threads. Every method raises StoreError, or UnusablePlant for a version
    whose text this program does not understand (it was staged by another one).
    """

    def __init__(self, store: VersionStore, database: str, read: Read, utc: Callable[[], Timestamp]) -> None:
        self.store = store
        self.wanted = asyncio.Event()
        """Set when a version is awaited that was not before."""
        self._announcing = asyncio.Lock()
        self._announced: int | None = None
        self._leaves: Callable[[Leaving | None], None] = _nobody
        self._database, self._read, self._utc = database, read, utc
        self._known: OrderedDict[str, Understood] = OrderedDict()
        self._reading = asyncio.Lock()

    async def stage(self, running: Plant, text: str, actor: Actor, reason: str) -> Staged | Refusal:
        """Keep a text, with the catalogues that there are now, as a version that can be activated.

        Raises UnusablePlant: it has errors; nothing is kept.
        """
        found = await self.read(Source(text))
        plant = found.plant
        if plant.name != running.name:
            detail = f"It is a file of the plant {plant.name}, and this is {running.name}."
            return Refusal("invalid", detail, f"Write name: {running.name} into it, if it is meant for this plant.")
        made = await asyncio.to_thread(self.store.stage, found.source, Origin.UPLOAD, actor, reason, self._utc())
        return made if isinstance(made, Refusal) else Staged(made, found.findings)

    async def read(self, source: Source) -> Understood:
        """Return what is said by a source; one that does not bring its catalogues is read again each time."""
        # One at a time: reading holds the interpreter, and a controller shares it.
        async with self._reading:
            found = None if source.catalogues is None else self._known.get(source.digest)
            if found is None:
                found = await asyncio.to_thread(self._read, source)
                self._known[found.source.digest] = found
                if len(self._known) > REMEMBERED:
                    self._known.popitem(last=False)
            self._known.move_to_end(found.source.digest)
            return found

    async def plant(self, number: int) -> Plant | None:
        """Return the plant of a version; None: there is no such version, or its text is not kept."""
        source = await asyncio.to_thread(self.store.source, number)
        return None if source is None else (await self.read(source)).plant

    async def findings(self, number: int) -> Sequence[Finding]:
        """Return the warnings about a version."""
        source = await asyncio.to_thread(self.store.source, number)
        return () if source is None else (await self.read(source)).findings

    async def difference(self, old: Plant, new: Plant) -> Difference:
        """Return what is different in the new plant, and what that breaks in a plant that has run."""
        return await asyncio.to_thread(difference, old, new)

    async def impact(self, running: Plant, new: Plant) -> Impact:
        """Return what the new plant would meet now."""

        def look() -> Impact:
            kept = standing(self._database)
            without_effect = [*lost(new, kept), *overruled(running, new, kept)]
            return Impact(touched(running, new, kept), without_effect, lacking(running, new, kept))

        return await asyncio.to_thread(look)

    async def ask(
        self, running: Plant, number: int, actor: Actor, why: str, *, patient: bool, in_the_way: Sequence[Broken]
    ) -> PlantVersion | Refusal:
        """Let a version be awaited, unless something stands in its way and nobody is ready to wait for that."""
        refused = in_the_way and not patient
        refusal = Refusal("not-now", f"{obstruction(in_the_way)}.") if refused else None
        made = await asyncio.to_thread(
            lambda: self.store.ask(number, actor, why, self._utc(), patient=patient, refusal=refusal)
        )
        if isinstance(made, PlantVersion):
            self.wanted.set()
            await self.announce(running)
        return made

    async def reject(self, running: Plant, number: int, actor: Actor, reason: str) -> PlantVersion | Refusal:
        """Let a version not become active."""
        made = await asyncio.to_thread(self.store.reject, number, actor, reason, self._utc())
        if isinstance(made, PlantVersion):
            await self.announce(running)
        return made

    async def announce(self, running: Plant) -> None:
        """Let the controller know, if it does not, what goes with the version that is awaited just now."""
        async with self._announcing:
            awaited = await asyncio.to_thread(self.store.awaited)
            number = None if awaited is None else awaited.number
            if number == self._announced:
                return
            new = None if number is None else await self.plant(number)
            goes = None
            if new is not None and number is not None:
                goes = await asyncio.to_thread(leaving, running, new, number)
            self._announced = number
            self._leaves(goes)

    def attach(self, leaves: Callable[[Leaving | None], None]) -> None:
        """Let a controller be told from now on what goes with the version that is awaited; None: none is, as it thinks now."""
        self._leaves, self._announced = leaves, None


def _nobody(_goes: Leaving | None) -> None:
    """Tell nobody: no controller runs."""


def said(error: HoistwayError) -> str:
    """Return an error as a note for people."""
    return f"{error.message}. {error.remedy}".rstrip(". ")
