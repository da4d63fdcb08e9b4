"""``hoistway db``: the schema of a plant's database, and its backups."""

from __future__ import annotations

import os
import platform
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NoReturn

import typer

from app.cli.tongue import say, told_here
from app.domain.errors import HoistwayError, StoreError
from app.domain.units import Timestamp

if TYPE_CHECKING:
    from app.store.backup import Stock

commands = typer.Typer(help="The schema of a plant's database, and its backups.", no_args_is_help=True)

Url = Annotated[
    str,
    typer.Option(
        "--url",
        envvar=["HOISTWAY_DATABASE_URL", "HOISTWAY_DATABASE"],
        help="sqlite:///var/plant.db or postgresql://user@host/database.",
    ),
]


@commands.command()
def current(url: Url) -> None:
    """Print the schema that the database has, and the newest that this program knows."""
    from app.store.opening import revision
    from app.store.schema import newest

    try:
        found = revision(url) or told_here("empty")
    except StoreError as error:
        _fail(error)
    print(found if found == newest() else f"{found} ({told_here(f'newest: {newest()}')})")


@commands.command()
def upgrade(url: Url) -> None:
    """Bring the database to the newest schema. Refused while a controller runs on it; a starting controller does it too."""
    from app.store.opening import bring_up_to_date

    holder = f"hoistway db upgrade on {platform.node()}, process {os.getpid()}"
    try:
        print(bring_up_to_date(url, holder, Timestamp(time.time())))
    except StoreError as error:
        _fail(error)


@commands.command()
def backup(
    file: Annotated[Path, typer.Argument(help="where to; it must not exist yet")],
    url: Url,
) -> None:
    """Write the database to a file as it is at one moment, also while a controller runs on it; print what it holds."""
    from app.store.backup import back_up

    try:
        stock = back_up(url, file)
    except StoreError as error:
        _fail(error)
    print(f"{file}: {told_here(_told(stock))}")


@commands.command()
def restore(
    file: Annotated[Path, typer.Argument(help="a backup that hoistway db backup has written")],
    url: Url,
) -> None:
    """Put a backup back. What was there is backed up beside it; the next start holds every vehicle until a person has looked.

    Refused while a controller runs on the database. A backup of an SQLite database may be put back on PostgreSQL and the
    other way round.
    """
    from app.store.backup import put_back

    holder = f"hoistway db restore on {platform.node()}, process {os.getpid()}"
    try:
        stock, before = put_back(file, url, holder, Timestamp(time.time()))
    except StoreError as error:
        _fail(error)
    say(f"put back: {_told(stock)}")
    if before is not None:
        say(f"what was there before: {before}")
    say("The next start holds every vehicle until a named person has compared it with the plant (docs/operations.md).")


def _told(stock: Stock) -> str:
    number, mark = stock.audit
    head = f"; its audit ends with {number}:{mark}" if number else ""
    return f"plant {stock.plant}, schema {stock.schema}, {stock.jobs} jobs after {stock.commits} commits{head}"


def _fail(error: HoistwayError) -> NoReturn:
    typer.echo(f"{told_here(error.message)}. {told_here(error.remedy)}".rstrip(), err=True)
    raise typer.Exit(1) from error
