"""How commands end when something outside the program is wrong: one clear line, no traceback."""

from __future__ import annotations

import math
import os
import ssl
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path
from typing import NoReturn

import typer

from app.cli.tongue import told_here
from app.domain.errors import HoistwayError


class CannotStart(HoistwayError):
    """Something outside the program prevents it from running; the message says what, in one line."""

    code = "cannot-start"


class FileInError(CannotStart):
    """The plant file, or a catalogue beside it, is there and has errors."""


TEXT_LIMIT = 64 << 20
"""Largest text that a person wrote, bytes: what is larger is another file. Our choice."""


LISTS = (".csv", ".xlsx", ".xls", ".ods")
IMPORTED = "make a plant file of it: hoistway layout import FILE -o plant.yaml"
"""What helps where a list of barcodes was given for a plant file."""


def said(error: OSError | UnicodeDecodeError) -> str:
    """Return the system's own word for an error, without the names of calls."""
    if isinstance(error, UnicodeDecodeError):
        return f"it is not UTF-8: {error.reason} at byte {error.start}"
    # A name that cannot be resolved has a number that is none of the system's.
    return os.strerror(error.errno) if error.errno and error.errno > 0 else error.strerror or str(error)


def why_not(trouble: Exception) -> str:
    """Return why a server could not be asked, from the exception of httpx, without the names of calls."""
    seen: BaseException | None = trouble
    while seen is not None:
        if isinstance(seen, ssl.SSLCertVerificationError):
            return f"its certificate is not trusted: {seen.verify_message}"
        if isinstance(seen, ssl.SSLError):
            return f"TLS: {seen.reason or seen}"
        if isinstance(seen, OSError) and (seen.errno or seen.strerror):
            return said(seen)
        seen = seen.__cause__ or seen.__context__
    name = type(trouble).__name__
    return "no answer in time" if name.endswith("Timeout") else str(trouble) or name


def text_of(file: Path) -> str:
    """Return the text of a file in UTF-8, with or without a mark. Raises CannotStart: it cannot be read."""
    try:
        with file.open("rb") as opened:
            data = opened.read(TEXT_LIMIT + 1)
        if len(data) > TEXT_LIMIT:
            raise CannotStart(f"{file} cannot be read: it is larger than {TEXT_LIMIT >> 20} MB")
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as wrong:
        remedy = IMPORTED if file.suffix.casefold() in LISTS else ""
        raise CannotStart(f"{file} cannot be read: {said(wrong)}", remedy=remedy) from None
    except OSError as wrong:
        raise CannotStart(f"{file} cannot be read: {said(wrong)}") from None


def spared(texts: Mapping[Path, str], *, force: bool) -> None:
    """See that nothing is lost by writing these files. Raises CannotStart: one says something else, and is not to be forced."""
    for file, text in {} if force else texts.items():
        try:
            # What is no file, such as /dev/stdout, loses nothing; nor does one that says the same.
            same = not file.is_file() or file.read_bytes() == text.encode()
        except OSError as wrong:
            raise CannotStart(f"{file} cannot be read: {said(wrong)}") from None
        if not same:
            raise CannotStart(
                f"{file} is there already, with something else in it",
                remedy="Write elsewhere, or over it with --force.",
            )


def positive(value: float | None) -> float | None:
    """Return an option's number, above 0 and finite. Raises typer.BadParameter."""
    if value is not None and not (math.isfinite(value) and value > 0):
        raise typer.BadParameter(f"{value} is no number above 0")
    return value


@contextmanager
def plainly() -> Iterator[None]:
    """Turn errors that the product raises on purpose into one line on standard error and exit code 1."""
    try:
        yield
    except HoistwayError as error:
        refuse(error.message, error.remedy)


def refuse(message: str, remedy: str = "") -> NoReturn:
    """Say what is wrong and what would help, and exit with 1."""
    text, remedy = told_here(message).rstrip("."), told_here(remedy)
    stop = "" if text.endswith("?") else "."
    print(f"hoistway: {text}{stop} {remedy}" if remedy else f"hoistway: {text}", file=sys.stderr)
    raise typer.Exit(1)
