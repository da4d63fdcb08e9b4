"""The versions of a running plant: taken in, compared, asked for. What changes the plant over is woken when one is awaited."""

import asyncio
from collections import OrderedDict
from collections.abc import Callable, Sequence
from dataclasses import dataclass

from app.domain.errors import HoistwayError, Refusal
from app.domain.ids import Actor
from app.domain.layout import Plant
from app.domain.units import Timestamp
from app.domain.versions import Origin, PlantVersion, digest_of
from app.plant import Finding
from app.plant.difference import Broken, Difference, difference, obstruction
from app.plant.lost import lost
from app.plant.touched import touched
from app.store.standing import standing
from app.store.versions import VersionStore

REMEMBERED = 4
"""Plants of versions that are kept in memory, read. Our choice: a fab takes seconds to read, and some tens of megabytes."""

Read = Callable[[str], tuple[Plant, Sequence[Finding]]]
"""Returns the plant of a text and the warnings about it. Raises UnusablePlant, or CannotStart for a catalogue with errors."""


@dataclass(frozen=True, slots=True)
class Staged:
    """A version that was taken in, and the warnings about it."""

    version: PlantVersion
    findings: Sequence[Finding]


@dataclass(frozen=True, slots=True)
class Impact:
    """What a version would meet if it became active now: ``in_the_way`` keeps it back, ``lost`` does not."""

    in_the_way: Sequence[Broken]
    lost: Sequence[Broken]


class Versions:
    """The versions of one plant; reads and compares in threads. Every method raises StoreError, or UnusablePlant for a version
    whose text this program does not understand (it was staged by another one).
    """

    def __init__(self, store: VersionStore, database: str, read: Read, utc: Callable[[], Timestamp]) -> None:
        self.store = store
        self.wanted = asyncio.Event()
        """Set when a version is awaited that was not before."""
        self._database, self._read, self._utc = database, read, utc
        self._plants: OrderedDict[str, tuple[Plant, Sequence[Finding]]] = OrderedDict()
        self._reading = asyncio.Lock()

    async def stage(self, running: Plant, text: str, actor: Actor, reason: str) -> Staged | Refusal:
        """Keep a text as a version that can be activated. Raises UnusablePlant: it has errors; nothing is kept."""
        plant, findings = await self.read(text)
        if plant.name != running.name:
            detail = f"It is a file of the plant {plant.name}, and this is {running.name}."
            return Refusal("invalid", detail, f"Write name: {running.name} into it, if it is meant for this plant.")
        made = await asyncio.to_thread(self.store.stage, text, Origin.UPLOAD, actor, reason, self._utc())
        return made if isinstance(made, Refusal) else Staged(made, findings)

    async def read(self, text: str) -> tuple[Plant, Sequence[Finding]]:
        """Return the plant of a text, and the warnings about it."""
        digest = digest_of(text)
        # One at a time: reading holds the interpreter, and a controller shares it.
        async with self._reading:
            found = self._plants.get(digest)
            if found is None:
                found = await asyncio.to_thread(self._read, text)
                self._plants[digest] = found
                if len(self._plants) > REMEMBERED:
                    self._plants.popitem(last=False)
            self._plants.move_to_end(digest)
            return found

    async def plant(self, number: int) -> Plant | None:
        """Return the plant of a version; None: there is no such version."""
        text = await asyncio.to_thread(self.store.text, number)
        return None if text is None else (await self.read(text))[0]

    async def findings(self, number: int) -> Sequence[Finding]:
        """Return the warnings about a version."""
        text = await asyncio.to_thread(self.store.text, number)
        return () if text is None else (await self.read(text))[1]

    async def difference(self, old: Plant, new: Plant) -> Difference:
        """Return what is different in the new plant, and what that breaks in a plant that has run."""
        return await asyncio.to_thread(difference, old, new)

    async def impact(self, running: Plant, new: Plant) -> Impact:
        """Return what the new plant would meet now."""

        def look() -> Impact:
            kept = standing(self._database)
            return Impact(touched(running, new, kept), lost(new, kept))

        return await asyncio.to_thread(look)

    async def ask(
        self, number: int, actor: Actor, why: str, *, patient: bool, in_the_way: Sequence[Broken]
    ) -> PlantVersion | Refusal:
        """Let a version be awaited, unless something stands in its way and nobody is ready to wait for that."""
        refused = in_the_way and not patient
        refusal = Refusal("not-now", f"{obstruction(in_the_way)}.") if refused else None
        made = await asyncio.to_thread(
            lambda: self.store.ask(number, actor, why, self._utc(), patient=patient, refusal=refusal)
        )
        if isinstance(made, PlantVersion):
            self.wanted.set()
        return made

    async def reject(self, number: int, actor: Actor, reason: str) -> PlantVersion | Refusal:
        """Let a version not become active."""
        return await asyncio.to_thread(self.store.reject, number, actor, reason, self._utc())


def said(error: HoistwayError) -> str:
    """Return an error as a note for people."""
    return f"{error.message}. {error.remedy}".rstrip(". ")
