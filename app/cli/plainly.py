"""How commands end when something outside the program is wrong: one clear line, no traceback."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import NoReturn

import typer

from app.domain.errors import HoistwayError


class CannotStart(HoistwayError):
    """Something outside the program prevents it from running; the message says what, in one line."""

    code = "cannot-start"


def said(error: OSError | UnicodeDecodeError) -> str:
    """Return the system's own word for an error, without the names of calls."""
    return os.strerror(error.errno) if isinstance(error, OSError) and error.errno else str(error)


@contextmanager
def plainly() -> Iterator[None]:
    """Turn errors that the product raises on purpose into one line on standard error and exit code 1."""
    try:
        yield
    except HoistwayError as error:
        refuse(error.message, error.remedy)


def refuse(message: str, remedy: str = "") -> NoReturn:
    """Say what is wrong and what would help, and exit with 1."""
    text = message.rstrip(".")
    stop = "" if text.endswith("?") else "."
    print(f"hoistway: {text}{stop} {remedy}" if remedy else f"hoistway: {text}", file=sys.stderr)
    raise typer.Exit(1)
