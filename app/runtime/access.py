"""Who is known here, in memory: keys and sessions looked up with each request, changes kept at once, others' seen soon."""

import asyncio
import hmac
import secrets
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, replace
from hashlib import sha256
from math import inf

from app.domain.access import Caller, Known
from app.domain.errors import Refusal, StoreError
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.runtime.clock import Clock
from app.runtime.telemetry import logger
from app.store.access import AccessStore

KEY_PREFIX, TOKEN_PREFIX = "hwk_", "hws_"
"""Keys and tokens are known for what they are, also where they should not be: in a log, in a repository."""
SECRET_BYTES = 32
LOOK_EVERY = 1.0
"""Seconds between looks at what the command line has changed. Our choice."""
USED_EVERY = 60.0
"""Seconds between notes of which keys were used. Our choice."""
MOST_NOTES = 1000
"""Forbidden calls that wait to be written into the audit; more are refused without a note. Our choice."""
MOST_SEEN = 4096
"""Keys and tokens whose digest is remembered. Our choice."""


@dataclass(slots=True)
class Entry:
    """Somebody who may call, until when, and when they last did (by the second look)."""

    caller: Caller
    until: float
    used: bool = False


def digest_of(secret: bytes, credential: bytes) -> str:
    """Return what is kept of a key or token."""
    return hmac.digest(secret, credential, "sha256").hex()


def drawn(prefix: str) -> str:
    """Return a key or token that nobody has: 256 random bits."""
    return prefix + secrets.token_urlsafe(SECRET_BYTES)


class Access:
    """People, keys and sessions of one plant. ``start`` reads them; ``on_look`` is called after changes, and once a second."""

    def __init__(self, store: AccessStore, clock: Clock) -> None:
        self.known = Known(b"", 0)
        """Everybody, as last read."""
        self.store = store
        self.clock = clock
        self.on_look: Callable[[], None] = _nothing
        self._log = logger()
        self._entries: dict[str, Entry] = {}
        self._held: dict[str, Entry] = {}
        self._seen: dict[bytes, Entry] = {}
        self._notes: deque[AuditRow] = deque()
        self._noting: asyncio.Task[None] | None = None
        self._looking: asyncio.Task[None] | None = None
        self._noted = clock.now()

    async def start(self) -> None:
        """Read who is known, and look for changes from now on. Raises StoreError."""
        self._take(await asyncio.to_thread(self.store.load))
        self._looking = asyncio.create_task(self._look_again())

    async def stop(self) -> None:
        """Write what is still to be noted, and close."""
        if self._looking is not None:
            self._looking.cancel()
            await asyncio.gather(self._looking, return_exceptions=True)
        if self._noting is not None:
            await self._noting
        await self._note_used()
        await asyncio.to_thread(self.store.close)

    # -- with each request --------------------------------------------------------------------------------------------

    @property
    def closed(self) -> bool:
        """Whether anybody was ever added, so that all have to say who they are."""
        return bool(self.known.users or self.known.keys)

    def caller(self, credential: bytes) -> Caller | None:
        """Return whose key or token it is; None: nobody's, or not any more."""
        mark = sha256(credential).digest()
        entry = self._seen.get(mark)
        if entry is None:
            entry = self._entries.get(digest_of(self.known.secret, credential))
            if entry is None:
                return None
            if len(self._seen) >= MOST_SEEN:
                self._seen.clear()
            self._seen[mark] = entry
        if self.clock.utc() >= entry.until:
            return None
        entry.used = True
        return entry.caller

    def still(self, caller: Caller) -> bool:
        """Return whether what a caller showed is still good, and still means the same."""
        entry = self._held.get(caller.held)
        return entry is not None and entry.caller == caller and self.clock.utc() < entry.until

    def forbid(self, caller: Caller, what: str) -> None:
        """Note that somebody asked for what their roles do not allow."""
        if len(self._notes) < MOST_NOTES:
            self._notes.append(AuditRow(self.clock.utc(), Actor(caller.name), "Forbidden", what, "", accepted=False))
            if self._noting is None or self._noting.done():
                self._noting = asyncio.create_task(self._write_notes())

    # -- changes ------------------------------------------------------------------------------------------------------

    async def change(self, work: Callable[[], Refusal | None]) -> Refusal | None:
        """Carry a change of the store out, and know of it before it is answered. Raises StoreError."""
        refusal = await asyncio.to_thread(work)
        if refusal is None:
            await self.read()
        return refusal

    async def read(self) -> None:
        """Read everybody anew. Raises StoreError."""
        self._take(await asyncio.to_thread(self.store.load))
        self.on_look()

    async def note(self, row: AuditRow) -> None:
        """Write something into the audit that came to nothing. Raises StoreError."""
        await asyncio.to_thread(self.store.note, row)

    def _take(self, known: Known) -> None:
        """Know everybody as they are kept; what was remembered of keys looked at is looked up again."""
        used = {name for name, entry in self._held.items() if entry.used}
        self.known = known
        self._entries, self._held, self._seen = {}, {}, {}
        for key in known.keys:
            if key.revoked is None:
                held = f"key {key.name}"
                caller = Caller(key.name, key.roles, person=False, held=held)
                self._enter(key.digest, Entry(caller, key.expires or inf, held in used))
        roles = {user.name: user.roles for user in known.users if not user.disabled}
        for session in known.sessions:
            if session.user in roles:
                caller = Caller(session.user, roles[session.user], person=True, held=session.log_in)
                self._enter(session.digest, Entry(caller, session.expires))

    def _enter(self, digest: str, entry: Entry) -> None:
        self._entries[digest] = entry
        longest = self._held.get(entry.caller.held)
        if longest is None or longest.until < entry.until:
            self._held[entry.caller.held] = entry

    async def _look_again(self) -> None:
        """See what others have changed, and write down which keys were used."""
        while True:
            await asyncio.sleep(LOOK_EVERY)
            try:
                if await asyncio.to_thread(self.store.revision) != self.known.revision:
                    await self.read()
                if self.clock.now() - self._noted >= USED_EVERY:
                    await self._note_used()
            except StoreError as trouble:
                self._log.warning("users and keys cannot be read", trouble=trouble.message)
            self.on_look()

    async def _note_used(self) -> None:
        """Write down when keys were last used; it changes nothing that anybody else looks for."""
        self._noted, now = self.clock.now(), self.clock.utc()
        used = {entry.caller.name: now for entry in self._held.values() if entry.used and not entry.caller.person}
        for entry in self._held.values():
            entry.used = False
        if used:
            await asyncio.to_thread(self.store.note_used, used)
            self.known = replace(
                self.known, keys=tuple(replace(key, used=used.get(key.name, key.used)) for key in self.known.keys)
            )

    async def _write_notes(self) -> None:
        while self._notes:
            try:
                await self.note(self._notes[0])
            except StoreError as trouble:
                self._log.warning("the audit cannot be written", trouble=trouble.message)
            self._notes.popleft()


def _nothing() -> None:
    pass
