"""``hoistway audit``: whether the audit is as it was written."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from app.cli.accounts import Config, Database, url_of
from app.cli.plainly import plainly, refuse
from app.cli.tongue import say

if TYPE_CHECKING:
    from app.store.reading import Reader

commands = typer.Typer(help="The audit: who asked for what.", no_args_is_help=True)
PAGE = 100_000


@commands.callback()
def _several() -> None:
    """Keep the command's name: there will be more than one."""


@commands.command()
def verify(
    database: Database = None,
    config: Config = None,
    head: Annotated[
        str | None, typer.Option(metavar="NUMBER:HASH", help="what an earlier verify printed; it must still be there")
    ] = None,
) -> None:
    """Look whether each row follows from the one before it; name the first that does not. Exit code 1 if one does not."""
    from app.store.engine import parsed
    from app.store.reading import Reader

    with plainly():
        url = url_of(database, config)
        made = parsed(url)
        if made.get_backend_name() == "sqlite" and made.database and not Path(made.database).is_file():
            refuse(f"there is no database {made.database}", "Name that of the plant with --database.")
        reader = Reader(url)
        try:
            if head is not None:
                _same(reader, head)
            rows, last, mark = _followed(reader)
        finally:
            reader.close()
    say(f"{rows} rows follow from one another. Note the last one elsewhere: {last}:{mark}")


def _same(reader: Reader, head: str) -> None:
    number, _, mark = head.partition(":")
    if not (number.isdecimal() and len(number) < len(str(1 << 63)) and mark):
        refuse(f"{head!r} is no number and hash", "Write them as an earlier verify printed them, NUMBER:HASH.")
    if reader.audit_hash(int(number)) != mark:
        refuse(f"audit row {number} is not what it was when its hash was noted", "Compare with a backup.")


def _followed(reader: Reader) -> tuple[int, int, str]:
    rows, last, mark = 0, 0, ""
    while True:
        checked = reader.audit_checked(last, PAGE)
        if checked.broken is not None:
            refuse(
                f"the audit is broken: {checked.reason}",
                f"The rows up to {checked.last} follow. Compare with a backup.",
            )
        rows += checked.rows
        last, mark = (checked.last, checked.hash) if checked.rows else (last, mark)
        if checked.rows < PAGE:
            return rows, last, mark
