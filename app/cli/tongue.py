"""In which language the command line speaks: ``--lang`` before the command, else HOISTWAY_LANG, else the locale."""

from __future__ import annotations

import os
import re
import sys
from collections.abc import Iterator, Mapping, Sequence
from typing import Any

import typer

from app.texts import LANGUAGES, Language, language_of, said

OPTION, VARIABLE = "--lang", "HOISTWAY_LANG"
LOCALES = ("LC_ALL", "LC_MESSAGES", "LANG")
"""What POSIX asks, in order; an empty one is as good as none."""


def wished(arguments: Sequence[str], environ: Mapping[str, str]) -> str:
    """Return the language that is asked for, as it is written there; empty: none is."""
    for place, argument in enumerate(arguments):
        if argument.startswith(f"{OPTION}="):
            return argument.partition("=")[2]
        if argument == OPTION:
            return arguments[place + 1] if place + 1 < len(arguments) else ""
        if not argument.startswith("-"):
            break  # what follows belongs to a command
    names = (VARIABLE, *LOCALES)
    return next((environ[name] for name in names if environ.get(name)), "")


def language() -> Language:
    """Return the language of this process and of those that it starts."""
    return language_of(wished((), os.environ))


def told_here(text: str) -> str:
    """Return a text of ours in the language of this process, line by line; one that the catalogue has not as it is."""
    here = language()
    return "\n".join(said(line, here) for line in text.split("\n"))


def say(text: str, *, wrong: bool = False) -> None:
    """Print a text in the language of this process, at once; ``wrong``: on standard error."""
    print(told_here(text), file=sys.stderr if wrong else sys.stdout, flush=True)


def counted_here(number: float, what: str) -> str:
    """Return a number of things in the language of this process; ``what`` in the English plural: ``1 edge``, ``2 edges``."""
    if language() != LANGUAGES[0]:
        return told_here(f"{number} {what}")
    return f"{number} {counted_word(what) if number == 1 else what}"


def counted_word(what: str) -> str:
    """Return the singular of an English plural of ours: ``pieces of track`` are ``piece of track``."""
    first, *rest = what.split(" of ")
    return " of ".join((first.removesuffix("s"), *rest))


def table_of(figures: Mapping[str, object]) -> Iterator[str]:
    """Give the lines of a table: what is counted, in the language of this process, and its figure."""
    from rich.cells import cell_len

    names = {name: told_here(name) for name in figures}
    wide = max(map(cell_len, names.values()), default=0) + 2
    for name, value in figures.items():
        blanks = " " * (wide - cell_len(names[name]))
        yield f"{names[name]}{blanks}{value:,}" if isinstance(value, int) else f"{names[name]}{blanks}{value}"


_Plain: Any = typer.Context.formatter_class
"""Typer gives its formatter no public name of its own."""


class _Formatter(_Plain):  # type: ignore[misc]
    """Writes help with headings in the language of this process."""

    def write_usage(self, prog: str, args: str = "", prefix: str | None = None) -> None:
        """Write how a command is called."""
        args = re.sub(r"\[OPTIONS\]|COMMAND \[ARGS\]\.\.\.", _word, args)
        super().write_usage(prog, args, f"{told_here('Usage:')} " if prefix is None else prefix)

    def write_heading(self, heading: str) -> None:
        """Write a heading."""
        super().write_heading(said(heading, language()))

    def write_dl(self, rows: Sequence[tuple[str, str]], col_max: int = 30, col_spacing: int = 2) -> None:
        """Write options, arguments or commands with what they are."""
        super().write_dl([(name, _explained(text)) for name, text in rows], col_max, col_spacing)


class _Context(typer.Context):
    """A context whose help is in the language of this process."""

    formatter_class = _Formatter


def _explained(text: str) -> str:
    """Return an explanation with its remarks, such as ``[default: 8080]``."""
    found = re.fullmatch(r"(.*?)(\s*\[(?:default|required|env var|[^ ]*<).*\])?", text, re.DOTALL)
    assert found is not None
    remarks = re.sub(r"\b(default|required|env var)\b", _word, found[2] or "")
    return said(found[1], language()) + remarks


def _word(match: re.Match[str]) -> str:
    return said(match[0], language())


def in_our_language(command: Any) -> None:
    """Let a command, its options and all below it explain themselves in the language of this process."""
    here = language()
    for one in _all(command):
        one.context_class = _Context
        one.help = one.help and _paragraphs(one.help)
        for parameter in one.params:
            if getattr(parameter, "help", None):
                parameter.help = said(" ".join(parameter.help.split()), here)


def _paragraphs(text: str) -> str:
    parts = [" ".join(part.split()) for part in text.split("\n\n")]
    return "\n\n".join(said(part, language()) for part in parts)


def _all(command: Any) -> Iterator[Any]:
    yield command
    for inner in getattr(command, "commands", {}).values():
        yield from _all(inner)


def run(app: typer.Typer) -> None:
    """Run the command line in the language that is asked for; an error of usage is told in it, with exit code 2."""
    chosen = wished(sys.argv[1:], os.environ)
    # So that processes which this one starts speak alike.
    os.environ[VARIABLE] = language_of(chosen)
    if language() == LANGUAGES[0]:
        app()
        return
    command: Any = typer.main.get_command(app)
    in_our_language(command)
    try:
        code = command.main(prog_name="hoistway", standalone_mode=False)
    except typer.Abort:
        say("Aborted!", wrong=True)
        sys.exit(1)
    except typer.exceptions.TyperException as wrong:
        sys.exit(_misused(wrong))
    sys.exit(code if isinstance(code, int) else 0)


def _misused(wrong: Any) -> int:
    """Say how a command was called wrongly; return the exit code."""
    context = getattr(wrong, "ctx", None)
    if context is not None:
        print(context.get_usage(), file=sys.stderr)
        say(f"Try '{context.command_path} --help' for help.", wrong=True)
    print(f"{told_here('Error')}: {told_here(wrong.format_message())}", file=sys.stderr)
    return int(wrong.exit_code)
