"""Users, keys and sessions to rows and back."""

from collections.abc import Iterable

from app.domain.access import Key, Role, Session, User
from app.store.columns import Found


def roles_as(roles: Iterable[Role]) -> list[str]:
    """Return roles as they are kept: in the order of :class:`Role`."""
    kept = set(roles)
    return [role.value for role in Role if role in kept]


def roles_of(kept: Iterable[str]) -> frozenset[Role]:
    """Undo :func:`roles_as`; what this program does not know gives nobody anything."""
    known = set(Role)
    return frozenset(Role(name) for name in kept if name in known)


def user_row(user: User) -> dict[str, object]:
    """Columns of ``users``."""
    return {
        "name": user.name,
        "roles": roles_as(user.roles),
        "password": user.password,
        "created": user.created,
        "created_by": user.created_by,
        "disabled": user.disabled,
        "logged_in": user.logged_in,
    }


def user(row: Found) -> User:
    """Undo :func:`user_row`."""
    return User(
        name=row.name,
        roles=roles_of(row.roles),
        password=row.password,
        created=row.created,
        created_by=row.created_by,
        disabled=row.disabled,
        logged_in=row.logged_in,
    )


def key_row(key: Key) -> dict[str, object]:
    """Columns of ``access_keys``."""
    return {
        "name": key.name,
        "roles": roles_as(key.roles),
        "digest": key.digest,
        "created": key.created,
        "created_by": key.created_by,
        "expires": key.expires,
        "revoked": key.revoked,
        "used": key.used,
    }


def key(row: Found) -> Key:
    """Undo :func:`key_row`."""
    return Key(
        name=row.name,
        roles=roles_of(row.roles),
        digest=row.digest,
        created=row.created,
        created_by=row.created_by,
        expires=row.expires,
        revoked=row.revoked,
        used=row.used,
    )


def session_row(session: Session) -> dict[str, object]:
    """Columns of ``access_sessions``."""
    return {
        "digest": session.digest,
        "log_in": session.log_in,
        "user": session.user,
        "started": session.started,
        "expires": session.expires,
        "address": session.address,
    }


def session(row: Found) -> Session:
    """Undo :func:`session_row`."""
    return Session(
        digest=row.digest,
        log_in=row.log_in,
        user=row.user,
        started=row.started,
        expires=row.expires,
        address=row.address,
    )
