"""Who may call: roles, what each may do, and the caller that a request turned out to come from (QUALITY section 4)."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import StrEnum

from app.domain.ids import Actor
from app.domain.units import Timestamp


class Role(StrEnum):
    """What somebody is here for. A person or a key has one or more."""

    VIEWER = "viewer"
    OPERATOR = "operator"
    MAINTENANCE = "maintenance"
    MES = "mes"
    ADMIN = "admin"


class Scope(StrEnum):
    """What a route is about. Each route has one; a role has several."""

    PUBLIC = "public"
    """Asked by anybody, known or not: probes, the page's own files, logging in."""
    SELF = "self"
    """About the caller: who am I, log out, change my password."""
    READ = "read"
    READ_AUDIT = "read_audit"
    JOBS = "jobs"
    PLACES = "places"
    """What stands where: carriers, states of ports."""
    VEHICLES = "vehicles"
    """Commands to vehicles; hold, release, recover, take out of service."""
    CONTROL = "control"
    """The plant as a whole: pause, resume, release an emergency."""
    SIGNAL = "signal"
    """Tell of a fire or an earthquake."""
    CLOSURES = "closures"
    ALARMS = "alarms"
    """Acknowledge, comment."""
    DEVICES = "devices"
    """Open a door, lock a buffer."""
    UPKEEP = "upkeep"
    """Lockouts; keeping doors open or closed; taking devices out of service."""
    TEACHING = "teaching"
    DRIVES = "drives"
    STOP_DRIVES = "stop_drives"
    """Stop whatever turns on a line: whoever sees the danger."""
    LAYOUT = "layout"
    """Versions of the plant: stage, activate, reject."""
    WEBHOOKS = "webhooks"
    """Who is told of events by HTTP."""
    METRICS = "metrics"
    """Figures for Prometheus."""
    ADMIN = "admin"
    """Users, keys, settings."""


_EVERYBODY = frozenset({Scope.PUBLIC, Scope.SELF, Scope.READ, Scope.METRICS})
_AT_THE_PLANT = _EVERYBODY | {
    Scope.READ_AUDIT, Scope.VEHICLES, Scope.SIGNAL, Scope.CLOSURES, Scope.ALARMS, Scope.DEVICES, Scope.STOP_DRIVES
}  # fmt: skip

GRANTS: Mapping[Role, frozenset[Scope]] = {
    Role.VIEWER: _EVERYBODY,
    Role.MES: _EVERYBODY | {Scope.JOBS, Scope.PLACES, Scope.SIGNAL, Scope.WEBHOOKS},
    Role.OPERATOR: _AT_THE_PLANT | {Scope.JOBS, Scope.PLACES, Scope.CONTROL},
    Role.MAINTENANCE: _AT_THE_PLANT | {Scope.UPKEEP, Scope.TEACHING, Scope.DRIVES, Scope.LAYOUT},
    Role.ADMIN: frozenset(Scope),
}
"""Role -> what it may do. Our choice; an administrator may do everything."""


def who_may(scope: Scope) -> tuple[Role, ...]:
    """Return the roles that may do what is in a scope."""
    return tuple(role for role in Role if scope in GRANTS[role])


@dataclass(frozen=True, slots=True)
class Caller:
    """Somebody who has shown who they are. ``person``: they logged in with a password; else it is a machine with a key.

    ``held`` names what they showed (a session's or a key's number, ``""`` for the key of the settings): when that ends, so
    does what they hold open. ``besides``: what it may do besides what its roles may.
    """

    name: str
    roles: frozenset[Role]
    person: bool
    held: str = ""
    besides: frozenset[Scope] = frozenset()
    scopes: frozenset[Scope] = field(init=False)
    """All that it may do."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "scopes", self.besides.union(*(GRANTS[role] for role in self.roles)))

    def acting(self, on_behalf: str) -> Actor:
        """Return who asks, for the audit: the name that was shown, and beside it on whose behalf, which nobody has shown."""
        if not on_behalf or on_behalf == self.name:
            return Actor(self.name)
        return Actor(f"{self.name}{ON_BEHALF}{on_behalf})")


ON_BEHALF = " (for "
"""Between the name of a caller and whom it speaks for; no name of a user or key has a blank."""


def shown_name(actor: Actor) -> str:
    """Return the part of an actor's name that was shown by a key or a password, where any was wanted."""
    return actor.partition(ON_BEHALF)[0]


@dataclass(frozen=True, slots=True)
class User:
    """A person who may log in. ``password`` is its argon2id hash with its parameters. ``disabled``: not any more.

    Names are never used twice, by people and keys together: the audit is read for years.
    """

    name: str
    roles: frozenset[Role]
    password: str
    created: Timestamp
    created_by: Actor
    disabled: bool = False
    logged_in: Timestamp | None = None
    """When last."""


@dataclass(frozen=True, slots=True)
class Key:
    """A machine's key. ``digest`` is what is kept of it (HMAC-SHA-256 in hex); the key itself is shown once, when it is made."""

    name: str
    roles: frozenset[Role]
    digest: str
    created: Timestamp
    created_by: Actor
    expires: Timestamp | None = None
    revoked: Timestamp | None = None
    used: Timestamp | None = None
    """When last, to the minute."""


@dataclass(frozen=True, slots=True)
class Session:
    """What a person who logged in holds: a token, of which ``digest`` is kept. ``log_in`` stays the same when it is renewed."""

    digest: str
    log_in: str
    user: str
    started: Timestamp
    expires: Timestamp
    address: str


@dataclass(frozen=True, slots=True)
class Known:
    """Everybody who is known. ``revision`` rises with each change; ``secret`` is what digests are made with."""

    secret: bytes
    revision: int
    users: tuple[User, ...] = ()
    keys: tuple[Key, ...] = ()
    sessions: tuple[Session, ...] = ()
