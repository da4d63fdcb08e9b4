"""Which version of the plant runs, and what takes its place: an edited plant file (SIGHUP), or a version asked for over REST."""

from __future__ import annotations

import asyncio
import os
import socket
from collections.abc import Callable, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Self

from structlog.typing import FilteringBoundLogger

from app.cli.catalogues import catalogue_texts
from app.cli.plainly import CannotStart, FileInError, text_of
from app.cli.running import reader_of
from app.domain.errors import HoistwayError, PlantHeld, Refusal, StoreError
from app.domain.ids import Actor
from app.domain.layout import Plant
from app.domain.units import Timestamp
from app.domain.versions import Origin, PlantVersion, Source, VersionState
from app.plant.difference import Broken, difference, obstruction
from app.plant.overruled import overruled
from app.plant.touched import listens_at, touched
from app.runtime.telemetry import logger
from app.runtime.versions import Versions, said
from app.store.lease import Lease
from app.store.opening import held, revision
from app.store.standing import standing
from app.store.versions import VersionStore

LOOK_EVERY = 1.0
"""Seconds between two looks whether a version that is waited for fits by now. Our choice."""
TRIES = 2
"""Starts with a new version that may end before it has run for a while; then the one before it goes on. Our choice: one may
be a power cut."""
FILE, START = Actor("plant file"), Actor("hoistway")
EDITED = "the plant file or a catalogue was edited"
NOT_TAKEN, NOT_CHANGED = "the plant file is not taken", "the plant is not changed"


def holder() -> str:
    """Return who holds the plant, for whoever comes second."""
    return f"{socket.gethostname()}, process {os.getpid()}"


class Changes:
    """Knows which version runs. ``begin`` says with which plant to start; ``next`` gives the plant that is to follow, and
    ``settle`` makes it the active one once the controller has stopped. ``look`` has the plant file read again.

    To be left (``with``) when the program ends: one that ends in order before it ran has not tried the version.
    """

    def __init__(self, file: Path, database: str, utc: Callable[[], Timestamp]) -> None:
        self.number = 0
        """The version that runs."""
        self._file, self._database, self._utc = file, database, utc
        self._read = reader_of(file)
        self._store = VersionStore(database)
        self.versions = Versions(self._store, database, self._read, utc)
        self._again = self._waiting = self._trying = False
        self._told: list[Broken] = []

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, *_: object) -> None:
        orderly = kind is None or issubclass(kind, HoistwayError | KeyboardInterrupt)
        if self._trying and orderly:
            with suppress(StoreError):
                self._note_trial(-1)
        self._store.close()

    def look(self) -> None:
        """Read the plant file again, soon."""
        self._again = True
        self.versions.wanted.set()

    # -- at the start -------------------------------------------------------------------------------------------------

    def begin(self, plant: Plant, text: str) -> Plant:
        """Return the plant to start with: of the plant file if it was edited since it was last taken, else the active version.

        ``plant`` and ``text`` are the plant file's. Raises PlantHeld, StoreError; CannotStart: the active version cannot be read.
        """
        source = self._source(plant, text)
        with held(self._database, plant.name, holder(), self._utc()) as lease:
            if self._store.plant_name() not in {None, plant.name}:
                return plant  # The ledger refuses it, and says why.
            active = self._store.active()
            if active is None:
                self.number = self._store.begin(source, FILE, self._utc()).number
                return plant
            active = self._on_trial(active, lease)
            self.number = active.number
            if source.digest == active.digest:
                self._store.take_file(source, self._utc())
                return plant
            edited = source.digest != self._store.file_taken()
            try:
                running = self._plant_of(active)
            except CannotStart as unreadable:
                if edited:
                    return self._instead_of_unreadable(active, plant, source, unreadable, lease)
                before = self._fall_back(active, unreadable.message, lease)
                if before is None:
                    raise
                return self._plant_of(before)
            if running.name != plant.name:
                raise StoreError(
                    f"the database keeps plant {running.name}, not {plant.name}",
                    remedy="Give each plant a database of its own, or write the plant's old name into the plant file.",
                )
            if plant == running:
                self._store.take_file(source, self._utc())
                return plant
            if edited:
                return self._edited(active, running, plant, source, lease)
            logger(plant=plant.name).warning(
                "the plant file is not what runs",
                runs=f"version {active.number} ({active.why})",
                file="not edited since it was last taken",
                remedy=f"hoistway layout versions; write the active one over it: {self._get(active)}",
            )
            return running

    def instead(self, wrong: FileInError) -> Plant:
        """Return the active version to start with, since the plant file has errors: a slip in it must not keep a plant down.

        Raises what is ``wrong``: there is none, or it cannot be read; PlantHeld, StoreError.
        """
        active = None if revision(self._database) is None else self._store.active()
        if active is None:
            raise wrong
        try:
            running = self._plant_of(active)
            with held(self._database, running.name, holder(), self._utc()) as lease:
                active = self._on_trial(active, lease)
            running = self._plant_of(active)
        except CannotStart:
            raise wrong from None
        self.number = active.number
        logger(plant=running.name).error(
            NOT_TAKEN,
            reason=wrong.message,
            goes_on=f"version {active.number} ({active.why})",
            remedy=f"{wrong.remedy}; mend it and start again, or write what runs over it: {self._get(active)}",
        )
        return running

    def _get(self, version: PlantVersion) -> str:
        """Return the command that writes a version over the plant file."""
        return f"hoistway layout get {version.number} -o {self._file} --force"

    def _on_trial(self, active: PlantVersion, lease: Lease) -> PlantVersion:
        """Return the version to start with: the active one, or the one before it if that never came to run, try after try.

        A start that ends in a way which can be told (:meth:`fall_back`) needs no second try.
        """
        if active.tries is None:
            return active
        if active.tries >= TRIES:
            note = f"{active.tries} starts with it ended before it ran"
            before = self._fall_back(active, note, lease)
            if before is not None:
                return before
        self._store.tried(active.number, active.tries + 1, self._utc())
        self._trying = True
        return active

    def _fall_back(self, active: PlantVersion, note: str, lease: Lease) -> PlantVersion | None:
        before = self._store.fall_back(active.number, note, self._utc(), lease)
        if before is not None:
            self.number = before.number
            remedy = "mend it and stage it again; a plant file is taken again once it is edited"
            logger(version=str(active.number)).error(
                NOT_CHANGED, reason=note, goes_on=f"version {before.number}", remedy=remedy
            )
        return before

    def _plant_of(self, version: PlantVersion) -> Plant:
        try:
            return self._read(self._store.source(version.number) or Source("")).plant
        except HoistwayError as wrong:
            raise CannotStart(
                f"version {version.number} of the plant, the active one, cannot be read: {wrong.message}",
                remedy="Write a plant file that this program understands, and start with it.",
            ) from None

    def _source(self, plant: Plant, text: str) -> Source:
        """Return the plant file as it is now, with the catalogues that are there now."""
        return Source(text, catalogue_texts(plant, self._file))

    def _edited(self, active: PlantVersion, running: Plant, plant: Plant, source: Source, lease: Lease) -> Plant:
        """Take a plant file that was edited while no controller ran, unless it breaks something under way."""
        log = logger(plant=plant.name)
        broken = touched(running, plant, standing(self._database), listening=False)
        version = self._staged(source, f"{EDITED} before a start")
        if broken:
            _log_all(log, broken)
            self._told = list(broken)  # the same version may be awaited already
            log.error(NOT_TAKEN, goes_on=f"version {active.number}", staged=f"version {version.number}")
            return running
        self._take_edited(version, lease)
        log.warning("the plant has changed", version=version.number, differences=_counted(running, plant))
        self._say_overruled(running, plant, log)
        return plant

    def _say_overruled(self, old: Plant, new: Plant, log: FilteringBoundLogger) -> None:
        """Say whose pulses were edited and do not count, since others hold."""
        for one in overruled(old, new, standing(self._database)):
            log.warning(
                "pulses of the plant file do not count",
                about=f"{one.what} {one.name}",
                reason=one.text,
                remedy=one.remedy,
            )

    def _instead_of_unreadable(
        self, active: PlantVersion, plant: Plant, source: Source, unreadable: CannotStart, lease: Lease
    ) -> Plant:
        """Take the edited file where nobody can read the active version any more (another program staged it): nothing can be
        compared, and the start itself refuses a plant that lacks a vehicle on the rail."""
        version = self._staged(source, f"version {active.number} cannot be read any more")
        self._take_edited(version, lease)
        logger(plant=plant.name).warning(
            "the plant has changed", version=version.number, reason=unreadable.message, compared="nothing"
        )
        return plant

    def _take_edited(self, version: PlantVersion, lease: Lease) -> None:
        """Make a version of the edited file the active one, before any controller runs."""
        other = self._store.awaited()
        if other is not None and other.number != version.number:
            self._store.give_up(other.number, "the plant file was edited meanwhile", self._utc())
        if other is None or other.number != version.number:
            self._store.ask(version.number, FILE, f"{EDITED} before a start", self._utc(), patient=False)
        self._store.activate(version.number, self._utc(), lease, file=True)
        self.number, self._trying = version.number, True

    def _staged(self, source: Source, reason: str) -> PlantVersion:
        """Return the version made of this; it is made if there is none that could become active."""
        known = self._store.with_source(source)
        if known is not None and known.state is not VersionState.ACTIVE:
            return known
        made = self._store.stage(source, Origin.FILE, FILE, reason, self._utc(), again=True)
        assert isinstance(made, PlantVersion)
        return made

    # -- while the controller runs ------------------------------------------------------------------------------------

    async def next(self, plant: Plant) -> Plant:
        """Wait until a version is awaited that can take the plant's place, and return its plant."""
        log = logger(plant=plant.name)
        self.versions.wanted.set()  # One that was awaited before a crash is awaited still.
        trouble_told = ""
        while True:
            await self._woken()
            try:
                if self._again:
                    self._again = False
                    await self._file_again(plant, log)
                if (following := await self._due(plant, log)) is not None:
                    return following
                trouble_told = ""
            except StoreError as trouble:
                if trouble.message != trouble_told:
                    _refused(log, "versions of the plant cannot be looked at", trouble)
                trouble_told, self._waiting = trouble.message, True

    async def _woken(self) -> None:
        try:
            async with asyncio.timeout(LOOK_EVERY if self._waiting else None):
                await self.versions.wanted.wait()
        except TimeoutError:
            return
        self.versions.wanted.clear()

    async def _file_again(self, plant: Plant, log: FilteringBoundLogger) -> None:
        """Let the plant file be awaited, if it says something new."""
        try:
            text = await asyncio.to_thread(text_of, self._file)
            understood = await asyncio.to_thread(self._read, Source(text))
        except HoistwayError as wrong:
            _refused(log, NOT_TAKEN, wrong)
            return
        found, source = understood.plant, understood.source
        if found.name != plant.name:
            log.error(NOT_TAKEN, reason=f"it is of another plant: {found.name}")
        elif found == plant:
            await asyncio.to_thread(self._store.take_file, source, self._utc())
            log.info("the plant file says nothing new")
        else:
            asked = await asyncio.to_thread(self._ask_for_file, source)
            if isinstance(asked, Refusal):
                log.error(NOT_TAKEN, reason=asked.reason, remedy=asked.remedy)

    def _ask_for_file(self, source: Source) -> PlantVersion | Refusal:
        version = self._staged(source, EDITED)
        if version.state is VersionState.AWAITED:
            return version
        return self._store.ask(version.number, FILE, EDITED, self._utc(), patient=False)

    async def _due(self, plant: Plant, log: FilteringBoundLogger) -> Plant | None:
        """Return the plant of the version that is awaited, if nothing stands in its way; who does not wait is told why not."""
        awaited = await asyncio.to_thread(self._store.awaited)
        self._waiting = awaited is not None
        if awaited is None:
            self._told = []
            await self.versions.announce(plant)
            return None
        try:
            following = await self.versions.plant(awaited.number) or plant
            await self.versions.announce(plant)
        except HoistwayError as wrong:
            await asyncio.to_thread(self._store.give_up, awaited.number, said(wrong), self._utc())
            _refused(log, NOT_CHANGED, wrong)
            return None
        broken = (await self.versions.impact(plant, following)).in_the_way
        if not broken:
            log.warning(
                "the plant changes", version=awaited.number, differences=await self._differences(plant, following)
            )
            return following
        await asyncio.to_thread(self._kept_back, awaited, broken)
        return None

    async def _differences(self, old: Plant, new: Plant) -> int:
        return await asyncio.to_thread(_counted, old, new)

    def _kept_back(self, version: PlantVersion, broken: Sequence[Broken]) -> None:
        """Say what keeps a version back, each thing once; it waits, or the wish is over."""
        _log_all(logger(version=str(version.number)), [one for one in broken if one not in self._told])
        self._told = list(broken)
        if not version.patient:
            self._store.give_up(version.number, obstruction(broken), self._utc())

    # -- between two controllers --------------------------------------------------------------------------------------

    async def settle(self, plant: Plant) -> Plant:
        """Make the awaited version the active one, if everything still fits, and return the plant to go on with.

        The lease is held meanwhile. Raises PlantHeld: another controller has taken the plant.
        """
        return await asyncio.to_thread(self._settle, plant)

    def _settle(self, plant: Plant) -> Plant:
        log = logger(plant=plant.name)
        try:
            with held(self._database, plant.name, holder(), self._utc()) as lease:
                awaited = self._store.awaited()
                if awaited is None:
                    return plant
                following = self._plant_of(awaited)
                # What came between the look and the stop counts too: then everything stays as it was.
                if broken := touched(plant, following, standing(self._database)):
                    self._kept_back(awaited, broken)
                    return plant
                self._store.activate(awaited.number, self._utc(), lease, file=self._is_file(awaited, following))
                self._say_overruled(plant, following, log)
        except PlantHeld:
            raise
        except (StoreError, CannotStart) as trouble:
            _refused(log, NOT_CHANGED, trouble)
            if isinstance(trouble, CannotStart):
                self._let_go(trouble)
            return plant
        self.number, self._trying = awaited.number, True
        return following

    def _let_go(self, trouble: CannotStart) -> None:
        """What cannot be read is not waited for: the controller would stop for it again and again."""
        awaited = self._store.awaited()
        if awaited is not None:
            self._store.give_up(awaited.number, said(trouble), self._utc())

    def _is_file(self, version: PlantVersion, plant: Plant) -> bool:
        try:
            return self._source(plant, text_of(self._file)).digest == version.digest
        except CannotStart:
            return False

    async def started(self) -> None:
        """Note that a controller runs well with the version: it is no longer on trial."""
        try:
            await asyncio.to_thread(self._note_trial, None)
        except StoreError as trouble:  # The next start tries it once more.
            _refused(logger(version=str(self.number)), "it cannot be noted that the version runs", trouble)

    def _note_trial(self, more: int | None) -> None:
        """Note that the active version, if it is on trial, was tried so many times more; None: that it runs."""
        active = self._store.active()
        if active is not None and active.number == self.number and active.tries is not None:
            self._store.tried(active.number, None if more is None else active.tries + more, self._utc())
        self._trying = False

    async def fall_back(self, plant: Plant, why: str, *, listening: bool = False) -> Plant | None:
        """Return the plant to go on with when the controller could not start with this one; None: it is not to blame.

        It is to blame if no controller has run well with it since it became active, be it before a crash; where it could not be
        listened for vehicles (``listening``), only if the one before would not want the same address.
        Raises PlantHeld, StoreError; CannotStart: the one before cannot be read.
        """
        return await asyncio.to_thread(self._back, plant, why, listening=listening)

    def _back(self, plant: Plant, why: str, *, listening: bool) -> Plant | None:
        active = self._store.active()
        before = None if active is None or active.before is None else self._store.version(active.before)
        if active is None or before is None or active.tries is None:
            return None
        old = self._plant_of(before)
        if listening and listens_at(old) == listens_at(plant):
            return None
        with held(self._database, plant.name, holder(), self._utc()) as lease:
            return None if self._fall_back(active, why, lease) is None else old


def _log_all(log: FilteringBoundLogger, broken: Sequence[Broken]) -> None:
    for one in broken:
        log.error(NOT_CHANGED, breaks=f"{one.what} {one.name}", reason=one.text, remedy=one.remedy)


def _refused(log: FilteringBoundLogger, what: str, wrong: HoistwayError) -> None:
    log.error(what, reason=wrong.message, remedy=wrong.remedy)


def _counted(old: Plant, new: Plant) -> int:
    return len(difference(old, new).changes)
