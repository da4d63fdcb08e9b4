"""People, keys and sessions as they are kept, and the audit of all that is asked about them.

Written beside the ledger, by a connection of its own: the command line does so while the controller runs.
"""

from collections.abc import Callable, Iterator, Mapping
from contextlib import contextmanager
from dataclasses import replace
from datetime import UTC, datetime

import sqlalchemy as sa

from app.domain.access import Key, Known, Role, Session, User
from app.domain.errors import Refusal, StoreError
from app.domain.ids import Actor
from app.domain.records import AuditRow
from app.domain.units import Timestamp
from app.store import access_rows
from app.store.access_rows import roles_as
from app.store.chain import append
from app.store.engine import parsed, reading, told, writing
from app.store.tables import access, access_keys, access_sessions, users

SECRET_BYTES = 32
RESERVED = ("anonymous", "access-key", "hoistway", "system", "nobody")
"""How no name begins: the audit has these for others."""

Work = Callable[[sa.Connection], Refusal | None]


def listed(url: str) -> tuple[tuple[User, ...], tuple[Key, ...]]:
    """Return all people and all keys, from a database that need not be writable. The tables must be there. Raises StoreError."""
    engine = reading(parsed(url))
    try:
        with told("users and keys cannot be read"), engine.connect() as connection:
            return _people(connection), _keys(connection)
    finally:
        engine.dispose()


def _people(connection: sa.Connection) -> tuple[User, ...]:
    return tuple(map(access_rows.user, connection.execute(sa.select(users).order_by(users.c.name))))


def _keys(connection: sa.Connection) -> tuple[Key, ...]:
    return tuple(map(access_rows.key, connection.execute(sa.select(access_keys).order_by(access_keys.c.name))))


class AccessStore:
    """Those who may log in. Blocking, from any thread. Every method raises StoreError if the database cannot be used.

    A change and its audit row are one transaction; what is refused is written into the audit too. The tables must be there.
    """

    def __init__(self, url: str, draw: Callable[[int], bytes]) -> None:
        """``draw`` gives so many random bytes."""
        made = parsed(url)
        if made.database == ":memory:":
            raise StoreError("a database in memory keeps nobody who may log in", remedy="Keep the plant in a file.")
        self._draw = draw
        self._engine = writing(made)

    def close(self) -> None:
        """Close all connections."""
        self._engine.dispose()

    def load(self) -> Known:
        """Return everybody; the first time, the secret of digests is made."""
        with self._transaction("users and keys cannot be read") as connection:
            one = connection.execute(sa.select(access)).one_or_none()
            if one is None:
                row = {"one": 1, "secret": self._draw(SECRET_BYTES).hex(), "revision": 1}
                connection.execute(access.insert(), row)
                one = connection.execute(sa.select(access)).one()
            return Known(
                secret=bytes.fromhex(one.secret),
                revision=one.revision,
                users=_people(connection),
                keys=_keys(connection),
                sessions=tuple(map(access_rows.session, connection.execute(sa.select(access_sessions)))),
            )

    def revision(self) -> int:
        """Return how often anything has changed."""
        with told("users and keys cannot be read"), self._engine.connect() as connection:
            return connection.execute(sa.select(access.c.revision)).scalar() or 0

    # -- people -------------------------------------------------------------------------------------------------------

    def add_user(self, user: User) -> Refusal | None:
        """Add a person."""

        def work(connection: sa.Connection) -> Refusal | None:
            if refusal := self._taken(connection, user.name):
                return refusal
            connection.execute(users.insert(), access_rows.user_row(user))
            return None

        said = f"roles {', '.join(roles_as(user.roles))}"
        return self._asked(AuditRow(user.created, user.created_by, "AddUser", user.name, said, accepted=True), work)

    def change_user(
        self,
        name: str,
        by: Actor,
        now: Timestamp,
        *,
        roles: frozenset[Role] | None = None,
        disabled: bool | None = None,
        password: str | None = None,
    ) -> Refusal | None:
        """Change a person; None leaves as is. Whoever is disabled or gets a new password is logged out."""
        said = [f"roles {', '.join(roles_as(roles))}"] if roles is not None else []
        said += [] if disabled is None else ["disabled" if disabled else "enabled"]
        said += [] if password is None else ["a new password"]

        def work(connection: sa.Connection) -> Refusal | None:
            found = self._user(connection, name)
            if found is None:
                return _no("user", name)
            changed = replace(
                found,
                roles=found.roles if roles is None else roles,
                disabled=found.disabled if disabled is None else disabled,
                password=password or found.password,
            )
            if _is_admin(found) and not _is_admin(changed) and not self._other_admin(connection, name):
                return _last_admin(name)
            connection.execute(users.update().where(users.c.name == name), access_rows.user_row(changed))
            if changed.disabled or password is not None:
                connection.execute(access_sessions.delete().where(access_sessions.c.user == name))
            return None

        return self._asked(AuditRow(now, by, "ChangeUser", name, ", ".join(said), accepted=True), work)

    def change_own_password(self, name: str, password: str, now: Timestamp, *, keep: str) -> Refusal | None:
        """Let a person have a new password; other sessions than ``keep`` (a log-in) end."""

        def work(connection: sa.Connection) -> Refusal | None:
            if self._user(connection, name) is None:
                return _no("user", name)
            connection.execute(users.update().where(users.c.name == name), {"password": password})
            other = sa.and_(access_sessions.c.user == name, access_sessions.c.log_in != keep)
            connection.execute(access_sessions.delete().where(other))
            return None

        return self._asked(AuditRow(now, Actor(name), "ChangePassword", name, "", accepted=True), work)

    def rehash(self, name: str, before: str, password: str) -> None:
        """Keep a person's password under another hash, if it is still the one that was looked at. Nobody asked for it."""
        with self._transaction("a password cannot be kept") as connection:
            same = sa.and_(users.c.name == name, users.c.password == before)
            connection.execute(users.update().where(same), {"password": password})
            self._count(connection)

    # -- sessions -----------------------------------------------------------------------------------------------------

    def log_in(self, session: Session) -> Refusal | None:
        """Open a session of a person who has shown the password."""

        def work(connection: sa.Connection) -> Refusal | None:
            found = self._user(connection, session.user)
            if found is None or found.disabled:
                return _no("user", session.user)
            over = access_sessions.c.expires < session.started
            connection.execute(access_sessions.delete().where(over))
            connection.execute(access_sessions.insert(), access_rows.session_row(session))
            when = users.update().where(users.c.name == session.user)
            connection.execute(when, {"logged_in": session.started})
            return None

        who = Actor(session.user)
        return self._asked(AuditRow(session.started, who, "LogIn", who, f"from {session.address}", accepted=True), work)

    def renew(self, session: Session, old: str, until: Timestamp) -> bool:
        """Put a new session beside an old one, which ends at ``until``; False: the old one has ended meanwhile."""
        with self._transaction("the session cannot be renewed") as connection:
            ends = access_sessions.update().where(access_sessions.c.digest == old)
            if connection.execute(ends, {"expires": until}).rowcount == 0:
                return False
            connection.execute(access_sessions.insert(), access_rows.session_row(session))
            self._count(connection)
            return True

    def log_out(self, user: str, log_in: str, now: Timestamp) -> Refusal | None:
        """End what one log-in opened."""

        def work(connection: sa.Connection) -> Refusal | None:
            connection.execute(access_sessions.delete().where(access_sessions.c.log_in == log_in))
            return None

        return self._asked(AuditRow(now, Actor(user), "LogOut", user, "", accepted=True), work)

    # -- keys ---------------------------------------------------------------------------------------------------------

    def add_key(self, key: Key) -> Refusal | None:
        """Add a machine's key."""

        def work(connection: sa.Connection) -> Refusal | None:
            if refusal := self._taken(connection, key.name):
                return refusal
            connection.execute(access_keys.insert(), access_rows.key_row(key))
            return None

        until = (
            "for ever"
            if key.expires is None
            else f"until {datetime.fromtimestamp(key.expires, UTC):%Y-%m-%dT%H:%M:%SZ}"
        )
        said = f"roles {', '.join(roles_as(key.roles))}; {until}"
        return self._asked(AuditRow(key.created, key.created_by, "AddKey", key.name, said, accepted=True), work)

    def revoke_key(self, name: str, by: Actor, now: Timestamp) -> Refusal | None:
        """End a key for ever."""

        def work(connection: sa.Connection) -> Refusal | None:
            found = connection.execute(sa.select(access_keys).where(access_keys.c.name == name)).one_or_none()
            if found is None:
                return _no("key", name)
            if found.revoked is not None:
                return Refusal("conflict", f"Key {name} is revoked already.", "Nothing more has to be done.")
            if Role.ADMIN.value in found.roles and not self._other_admin(connection, name):
                return _last_admin(name)
            connection.execute(access_keys.update().where(access_keys.c.name == name), {"revoked": now})
            return None

        return self._asked(AuditRow(now, by, "RevokeKey", name, "", accepted=True), work)

    def note_used(self, used: Mapping[str, Timestamp]) -> None:
        """Write down when keys were last used."""
        with self._transaction("the use of keys cannot be kept") as connection:
            for name, at in sorted(used.items()):
                connection.execute(access_keys.update().where(access_keys.c.name == name), {"used": at})

    # -- the audit ----------------------------------------------------------------------------------------------------

    def note(self, row: AuditRow) -> None:
        """Write down what was asked for and came to nothing here: a log-in that failed, a call that is forbidden."""
        with self._transaction("the audit cannot be written") as connection:
            append(connection, row)

    def _asked(self, row: AuditRow, work: Work) -> Refusal | None:
        """Carry something out and write it into the audit, or that it was refused; return why it was."""
        with self._transaction("the change cannot be kept") as connection:
            refusal = work(connection)
            if refusal is not None:
                row = replace(row, detail=f"refused: {refusal.reason}", accepted=False)
            append(connection, row)
            if refusal is None:
                self._count(connection)
            return refusal

    def _count(self, connection: sa.Connection) -> None:
        connection.execute(access.update().values(revision=access.c.revision + 1))

    @contextmanager
    def _transaction(self, what: str) -> Iterator[sa.Connection]:
        with told(what), self._engine.begin() as connection:
            # On PostgreSQL, changes of several programs come one after the other, as they do on SQLite.
            connection.execute(sa.select(access.c.one).with_for_update())
            yield connection

    def _user(self, connection: sa.Connection, name: str) -> User | None:
        found = connection.execute(sa.select(users).where(users.c.name == name)).one_or_none()
        return None if found is None else access_rows.user(found)

    def _taken(self, connection: sa.Connection, name: str) -> Refusal | None:
        """Return why a name is not free: letters that differ in case only look alike in the audit."""
        if name.casefold().startswith(RESERVED):
            return Refusal(
                "conflict", f"{name} would look like somebody else in the audit.", "Choose another name.", "name"
            )
        for kind, table in (("user", users), ("key", access_keys)):
            for other in connection.execute(sa.select(table.c.name)).scalars():
                if other.casefold() == name.casefold():
                    remedy = "Choose another name: none is used twice, so that the audit can be read for years."
                    return Refusal("conflict", f"There is a {kind} {other} already.", remedy, "name")
        return None

    def _other_admin(self, connection: sa.Connection, name: str) -> bool:
        """Return whether anybody but ``name`` may manage users and keys."""
        people = map(access_rows.user, connection.execute(sa.select(users).where(users.c.name != name)))
        live = sa.and_(access_keys.c.name != name, access_keys.c.revoked.is_(None), access_keys.c.expires.is_(None))
        machines = map(access_rows.key, connection.execute(sa.select(access_keys).where(live)))
        return any(map(_is_admin, people)) or any(Role.ADMIN in key.roles for key in machines)


def _is_admin(user: User) -> bool:
    return Role.ADMIN in user.roles and not user.disabled


def _no(kind: str, name: str) -> Refusal:
    return Refusal("not-found", f"There is no {kind} {name}.", f"GET /api/v1/{kind}s lists them.")


def _last_admin(name: str) -> Refusal:
    remedy = "Make somebody else an administrator first: hoistway users add NAME --role admin."
    return Refusal("conflict", f"{name} is the last administrator.", remedy)
