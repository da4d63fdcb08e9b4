"""What people and administrators do about access: log in and out, passwords, users, keys. Each is in the audit once."""

import secrets
from dataclasses import dataclass

from app.domain.access import Caller, Key, Role, Session, User
from app.domain.errors import Refusal
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.domain.units import Timestamp
from app.runtime.access import KEY_PREFIX, TOKEN_PREFIX, Access, digest_of, drawn
from app.runtime.passwords import Passwords
from app.runtime.throttle import Throttle

TOKEN_LIFE = 1800.0
"""Seconds that a token is good; it is renewed before. Our choice."""
LOG_IN_LIFE = 12 * 3600.0
"""Seconds after which a person logs in again, however often the token was renewed: a shift. Our choice."""
OVERLAP = 30.0
"""Seconds that an old token is still good beside the new one: requests under way have it. Our choice."""


@dataclass(frozen=True, slots=True)
class Given:
    """A token, shown once, and what is known of it."""

    token: str
    session: Session
    roles: frozenset[Role]

    @property
    def until(self) -> Timestamp:
        """When the person has to log in again."""
        return Timestamp(self.session.started + LOG_IN_LIFE)


@dataclass(frozen=True, slots=True)
class Wait:
    """Too many attempts: the next one is looked at after so many seconds."""

    seconds: float


class Reception:
    """Serves people and administrators of one plant. Every method raises StoreError if the database cannot be used."""

    def __init__(self, access: Access, passwords: Passwords | None = None, throttle: Throttle | None = None) -> None:
        self.access = access
        self._passwords = passwords or Passwords()
        self._throttle = throttle or Throttle()

    # -- sessions -----------------------------------------------------------------------------------------------------

    async def log_in(self, name: str, password: str, address: str) -> Given | Refusal | Wait:
        """Give a token for name and password. That there is no such name is not told: it takes as long, and says the same."""
        access, now = self.access, self.access.clock.utc()
        if wait := self._throttle.begin(name, address, access.clock.now()):
            return Wait(wait)
        user = self.user(name)
        known = user if user is not None and not user.disabled else None
        if not await self._passwords.same_soon(known.password if known else None, password) or known is None:
            nobody = Actor(f"anonymous@{address}")
            await access.note(AuditRow(now, nobody, "LogIn", name, "refused: wrong name or password", accepted=False))
            return Refusal("unauthorised", "There is nobody of that name with that password.", "Try again.")
        self._throttle.good(name, address)
        given = self._given(known, secrets.token_hex(8), now, address)
        if refusal := await access.change(lambda: access.store.log_in(given.session)):
            return refusal
        if self._passwords.stale(known.password):
            anew = await self._passwords.hash_soon(password)
            await access.change(lambda: access.store.rehash(name, known.password, anew))
        return given

    async def renew(self, caller: Caller, token: bytes, address: str) -> Given | Refusal:
        """Give a new token for one that is still good, until the log-in has become old."""
        access, now = self.access, self.access.clock.utc()
        digest = digest_of(access.known.secret, token)
        old = next((one for one in access.known.sessions if one.digest == digest), None)
        user = self.user(caller.name)
        if old is None or user is None:
            return Refusal("conflict", f"{caller.name} is no person who logged in.", "A key is good until it expires.")
        given = self._given(user, old.log_in, now, address, old.started)
        if given.session.expires <= now:
            return Refusal("unauthorised", "You logged in too long ago.", "Log in again.")
        until = Timestamp(min(old.expires, now + OVERLAP))
        renewed = False

        def work() -> None:
            nonlocal renewed
            renewed = access.store.renew(given.session, digest, until)

        await access.change(work)
        return given if renewed else Refusal("unauthorised", "The session has ended.", "Log in again.")

    async def log_out(self, caller: Caller) -> Refusal | None:
        """End what one log-in opened; a key is not ended like this."""
        if not caller.person:
            return Refusal(
                "conflict", f"{caller.name} is no person who logged in.", "DELETE /api/v1/keys/NAME ends a key."
            )
        access = self.access
        return await access.change(lambda: access.store.log_out(caller.name, caller.held, access.clock.utc()))

    async def change_password(self, caller: Caller, old: str, new: str, address: str) -> Refusal | Wait | None:
        """Let a person who knows the old password have a new one; their other sessions end."""
        access, now = self.access, self.access.clock.utc()
        user = self.user(caller.name) if caller.person else None
        if user is None:
            return Refusal("conflict", f"{caller.name} is no person who logged in.", "Log in with name and password.")
        if wait := self._throttle.begin(user.name, address, access.clock.now()):
            return Wait(wait)
        if not await self._passwords.same_soon(user.password, old):
            said = "refused: that is not the old password"
            await access.note(AuditRow(now, Actor(user.name), "ChangePassword", user.name, said, accepted=False))
            return Refusal(
                "invalid", "That is not the old password.", "An administrator can give you a new one.", "old"
            )
        self._throttle.good(user.name, address)
        hashed = await self._passwords.hash_soon(new)
        return await access.change(lambda: access.store.change_own_password(user.name, hashed, now, keep=caller.held))

    def _given(self, user: User, log_in: str, now: Timestamp, address: str, started: Timestamp | None = None) -> Given:
        began = now if started is None else started
        token = drawn(TOKEN_PREFIX)
        expires = Timestamp(min(now + TOKEN_LIFE, began + LOG_IN_LIFE))
        digest = digest_of(self.access.known.secret, token.encode())
        return Given(token, Session(digest, log_in, user.name, began, expires, address), user.roles)

    # -- users --------------------------------------------------------------------------------------------------------

    @property
    def users(self) -> tuple[User, ...]:
        """All people, by name."""
        return self.access.known.users

    def user(self, name: str) -> User | None:
        """Return a person."""
        return next((user for user in self.users if user.name == name), None)

    async def add_user(self, name: str, roles: frozenset[Role], password: str, by: Actor) -> Refusal | None:
        """Add a person who may log in."""
        access = self.access
        hashed = await self._passwords.hash_soon(password)
        user = User(name, roles, hashed, access.clock.utc(), by)
        return await access.change(lambda: access.store.add_user(user))

    async def change_user(
        self,
        name: str,
        by: Actor,
        *,
        roles: frozenset[Role] | None = None,
        disabled: bool | None = None,
        password: str | None = None,
    ) -> Refusal | None:
        """Change a person; None leaves as is. Who is disabled or gets a new password is logged out."""
        access, now = self.access, self.access.clock.utc()
        hashed = None if password is None else await self._passwords.hash_soon(password)
        return await access.change(
            lambda: access.store.change_user(name, by, now, roles=roles, disabled=disabled, password=hashed)
        )

    # -- keys ---------------------------------------------------------------------------------------------------------

    @property
    def keys(self) -> tuple[Key, ...]:
        """All machines' keys, by name, those that have ended too."""
        return self.access.known.keys

    def key(self, name: str) -> Key | None:
        """Return a key, as it is known."""
        return next((key for key in self.keys if key.name == name), None)

    async def add_key(self, name: str, roles: frozenset[Role], expires: Timestamp | None, by: Actor) -> str | Refusal:
        """Make a key and return it; nobody can show it again."""
        access, shown = self.access, drawn(KEY_PREFIX)
        digest = digest_of(access.known.secret, shown.encode())
        key = Key(name, roles, digest, access.clock.utc(), by, expires)
        return await access.change(lambda: access.store.add_key(key)) or shown

    async def revoke_key(self, name: str, by: Actor) -> Refusal | None:
        """End a key for ever."""
        access = self.access
        return await access.change(lambda: access.store.revoke_key(name, by, access.clock.utc()))
