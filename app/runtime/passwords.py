"""Passwords: kept as argon2id, with parameters that may become dearer over the years."""

import asyncio

from argon2 import PasswordHasher
from argon2.exceptions import InvalidHashError, VerificationError

SHORTEST, LONGEST = 10, 200
"""Characters that a password may have. Our choice."""
AT_ONCE = 2
"""Passwords looked at at a time: each takes 64 MiB and some 50 ms of a core, on purpose. Our choice."""


def trouble_with(password: str, name: str) -> str:
    """Return why somebody of that name cannot have this password; empty: they can."""
    if not SHORTEST <= len(password) <= LONGEST:
        return f"A password has {SHORTEST} to {LONGEST} characters."
    if name.casefold() in password.casefold() or len(set(password)) < 5:
        return "A password must not hold the name, and has at least five different characters."
    return ""


class Passwords:
    """Makes hashes and compares with them, beside the event loop. The parameters are argon2-cffi's (RFC 9106, second choice)."""

    def __init__(self, hasher: PasswordHasher | None = None) -> None:
        self._hasher = hasher or PasswordHasher()
        self._nobody = ""
        self._room = asyncio.Semaphore(AT_ONCE)

    def hashed(self, password: str) -> str:
        """Return what is kept of a password. Blocks."""
        return self._hasher.hash(password)

    def same(self, kept: str | None, password: str) -> bool:
        """Return whether it is the password; None (nobody) takes as long as somebody. Blocks."""
        if not self._nobody:
            self._nobody = self._hasher.hash("nobody has this password")
        try:
            self._hasher.verify(kept or self._nobody, password)
        except (VerificationError, InvalidHashError):
            return False
        return kept is not None

    def stale(self, kept: str) -> bool:
        """Return whether a hash should be made anew, with the parameters of today."""
        return self._hasher.check_needs_rehash(kept)

    async def hash_soon(self, password: str) -> str:
        """Return what is kept of a password."""
        async with self._room:
            return await asyncio.to_thread(self.hashed, password)

    async def same_soon(self, kept: str | None, password: str) -> bool:
        """Return whether it is the password."""
        async with self._room:
            return await asyncio.to_thread(self.same, kept, password)
