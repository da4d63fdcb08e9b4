"""``hoistway db``: the schema of a plant's database."""

import os
import platform
import time
from typing import Annotated, NoReturn

import typer

from app.domain.errors import HoistwayError, StoreError
from app.domain.units import Timestamp

commands = typer.Typer(help="The schema of a plant's database.", no_args_is_help=True)

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
        found = revision(url) or "empty"
    except StoreError as error:
        _fail(error)
    print(found if found == newest() else f"{found} (newest: {newest()})")


@commands.command()
def upgrade(url: Url) -> None:
    """Bring the database to the newest schema. Refused while a controller runs on it; a starting controller does it too."""
    from app.store.opening import bring_up_to_date

    holder = f"hoistway db upgrade on {platform.node()}, process {os.getpid()}"
    try:
        print(bring_up_to_date(url, holder, Timestamp(time.time())))
    except StoreError as error:
        _fail(error)


def _fail(error: HoistwayError) -> NoReturn:
    typer.echo(f"{error.message}. {error.remedy}".rstrip(), err=True)
    raise typer.Exit(1) from error
