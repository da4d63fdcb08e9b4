"""``hoistway users`` and ``hoistway keys``: who may call, written straight into the database, also while the server runs."""

from __future__ import annotations

import getpass
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import UTC, datetime
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.plainly import plainly, refuse
from app.cli.tongue import say, told_here
from app.domain.access import Role
from app.domain.ids import Actor
from app.domain.units import Timestamp

if TYPE_CHECKING:
    from app.domain.access import Key, User
    from app.domain.errors import Refusal
    from app.store.access import AccessStore

users = typer.Typer(help="People who may log in.", no_args_is_help=True)
keys = typer.Typer(help="Keys of machines: an MES, a script.", no_args_is_help=True)

DAY = 86_400.0
Database = Annotated[
    str | None, typer.Option("--database", help="SQLAlchemy URL; without it, as hoistway serve takes it")
]
Config = Annotated[Path | None, typer.Option("--config", help="settings file, TOML or YAML")]
Roles = Annotated[list[Role], typer.Option("--role", help="what for; may be given several times")]
Stdin = Annotated[bool, typer.Option("--password-stdin", help="read the password from standard input")]
SEEN = "A running server knows within two seconds."


def url_of(database: str | None, config: Path | None) -> str:
    """Return the database that ``hoistway serve`` would take. Raises SettingsError."""
    from app.settings import load

    return load(config, database=database, host="127.0.0.1").database


@contextmanager
def _opened(database: str | None, config: Path | None) -> Iterator[AccessStore]:
    """Give the store of a plant; its tables are made or brought up to date if nobody runs on it."""
    import secrets

    from app.store.access import AccessStore

    with plainly():
        store = AccessStore(_ready(database, config), secrets.token_bytes)
        try:
            yield store
        finally:
            store.close()


def _ready(database: str | None, config: Path | None) -> str:
    """Return the URL of a database whose tables are there and new. Raises SettingsError, StoreError."""
    from app.store.opening import bring_up_to_date, revision
    from app.store.schema import newest

    url = url_of(database, config)
    if revision(url) != newest():
        bring_up_to_date(url, f"hoistway users or keys by {getpass.getuser()}", _now())
    return url


def _listed(database: str | None, config: Path | None) -> tuple[tuple[User, ...], tuple[Key, ...]]:
    """Return all people and all keys; the database may be one that may not be written."""
    from app.store.access import listed

    with plainly():
        return listed(_ready(database, config))


def _now() -> Timestamp:
    return Timestamp(time.time())


def _me() -> Actor:
    return Actor(f"hoistway command line ({getpass.getuser()})")


def _done(refusal: Refusal | None, said: str) -> None:
    if refusal is not None:
        refuse(refusal.reason, refusal.remedy)
    print(f"{told_here(said)} {told_here(SEEN)}")


def _named(name: str) -> str:
    """Return a name that the API takes too."""
    from pydantic import TypeAdapter, ValidationError

    from app.api.access_inputs import Name

    try:
        return TypeAdapter[str](Name).validate_python(name)
    except ValidationError:
        refuse(f"{name!r} is no name", "It has 1 to 32 letters without blanks, slashes and ?#%.")


def _password(name: str, *, stdin: bool) -> str:
    """Return the hash of a password that was asked for twice, or read from standard input."""
    from app.runtime.passwords import Passwords, trouble_with

    if stdin:
        password = sys.stdin.readline().rstrip("\r\n")
    else:
        password = typer.prompt(told_here(f"Password for {name}"), hide_input=True, confirmation_prompt=True)
    if trouble := trouble_with(password, name):
        refuse(trouble, "Choose another one.")
    return Passwords().hashed(password)


def _date(at: float | None, none: str = "-") -> str:
    return none if at is None else f"{datetime.fromtimestamp(at, UTC):%Y-%m-%d %H:%M}Z"


@users.command("add")
def add_user(
    name: str, role: Roles, database: Database = None, config: Config = None, *, password_stdin: Stdin = False
) -> None:
    """Add a person. From the first user or key on, everybody has to say who they are."""
    from app.domain.access import User

    with _opened(database, config) as store:
        user = User(_named(name), frozenset(role), _password(name, stdin=password_stdin), _now(), _me())
        _done(store.add_user(user), f"{name} may log in.")


@users.command("list")
def list_users(database: Database = None, config: Config = None) -> None:
    """Show all people: name, roles, when they last logged in."""
    people, _ = _listed(database, config)
    for user in people:
        roles = ",".join(sorted(user.roles))
        may = told_here("disabled") if user.disabled else roles
        print(f"{user.name:<32} {may:<32} {_date(user.logged_in, told_here('never'))}")


@users.command("change")
def change_user(
    name: str,
    database: Database = None,
    config: Config = None,
    role: Annotated[list[Role] | None, typer.Option("--role", help="the roles from now on")] = None,
    *,
    disable: Annotated[bool | None, typer.Option("--disable/--enable", help="whether they may not log in")] = None,
) -> None:
    """Give a person other roles, disable or enable them."""
    if not role and disable is None:
        refuse("nothing to change was named", "Say --role, --disable or --enable.")
    with _opened(database, config) as store:
        roles = frozenset(role) if role else None
        _done(store.change_user(name, _me(), _now(), roles=roles, disabled=disable), f"{name} is changed.")


@users.command("password")
def new_password(name: str, database: Database = None, config: Config = None, *, password_stdin: Stdin = False) -> None:
    """Give a person a new password; they are logged out."""
    with _opened(database, config) as store:
        hashed = _password(name, stdin=password_stdin)
        _done(store.change_user(name, _me(), _now(), password=hashed), f"{name} has a new password.")


@keys.command("add")
def add_key(
    name: str,
    role: Roles,
    database: Database = None,
    config: Config = None,
    days: Annotated[
        float | None, typer.Option(min=0.001, max=3660, help="how long it is good; without it, for ever")
    ] = None,
) -> None:
    """Make a key and print it, once. From the first user or key on, everybody has to say who they are."""
    from app.domain.access import Key
    from app.runtime.access import KEY_PREFIX, digest_of, drawn

    with _opened(database, config) as store:
        shown, now = drawn(KEY_PREFIX), _now()
        digest = digest_of(store.load().secret, shown.encode())
        expires = None if days is None else Timestamp(now + days * DAY)
        refusal = store.add_key(Key(_named(name), frozenset(role), digest, now, _me(), expires))
        if refusal is not None:
            refuse(refusal.reason, refusal.remedy)
        print(shown)
        say(f"This is shown once; good until {_date(expires, told_here('it is revoked'))}.\n{SEEN}", wrong=True)


@keys.command("list")
def list_keys(database: Database = None, config: Config = None) -> None:
    """Show all keys: name, roles, until when they are good, when they were last used."""
    _, all_keys = _listed(database, config)
    for key in all_keys:
        until = told_here("revoked") if key.revoked is not None else _date(key.expires, told_here("for ever"))
        used = _date(key.used, told_here("never used"))
        print(f"{key.name:<32} {','.join(sorted(key.roles)):<32} {until:<18} {used}")


@keys.command("revoke")
def revoke_key(name: str, database: Database = None, config: Config = None) -> None:
    """End a key for ever."""
    with _opened(database, config) as store:
        _done(store.revoke_key(name, _me(), _now()), f"{name} is revoked.")
