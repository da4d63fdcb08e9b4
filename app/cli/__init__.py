"""The ``hoistway`` command. What a command needs is imported when it runs, so that ``--help`` answers at once."""

from __future__ import annotations

import gc
from importlib import metadata
from typing import Annotated

import typer

from app.cli import (
    accounts,
    audit,
    bench,
    check,
    db,
    decode,
    demo,
    detect,
    doctor,
    fab,
    fuzz,
    layout,
    openapi,
    replay,
    schema,
    serve,
    sim,
    simulate,
    vectors,
    workload,
)
from app.cli.running import COLLECTED
from app.texts import LANGUAGES


def _language(asked: str | None) -> None:
    if asked is not None and asked not in LANGUAGES:
        raise typer.BadParameter(f"{asked} is no language that Hoistway speaks: {', '.join(LANGUAGES)}")


def _version(wanted: bool) -> None:
    if wanted:
        print(f"hoistway {metadata.version('hoistway')}")
        raise typer.Exit


app = typer.Typer(
    name="hoistway",
    no_args_is_help=True,
    rich_markup_mode=None,
    pretty_exceptions_enable=False,
)


@app.callback()
def _whole(
    *,
    version: Annotated[
        bool, typer.Option("--version", callback=_version, is_eager=True, help="print the version, and end")
    ] = False,
    lang: Annotated[
        str | None,
        typer.Option(callback=_language, is_eager=True, help="en or ko; without it HOISTWAY_LANG, or the locale"),
    ] = None,
) -> None:
    """An open fleet transport controller for overhead hoists, AGVs and their equipment."""
    gc.set_threshold(*COLLECTED)


for command in (
    serve.serve,
    sim.sim,
    demo.demo,
    workload.workload,
    simulate.simulate,
    fuzz.fuzz,
    check.check,
    doctor.doctor,
    fab.fab,
    schema.schema,
    decode.decode,
    detect.detect,
    vectors.vectors,
    replay.replay,
    openapi.openapi,
):
    app.command()(command)
app.add_typer(layout.commands, name="layout")
app.add_typer(db.commands, name="db")
app.add_typer(bench.commands, name="bench")
app.add_typer(accounts.users, name="users")
app.add_typer(accounts.keys, name="keys")
app.add_typer(audit.commands, name="audit")
