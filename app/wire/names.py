"""Finding the name that somebody probably meant."""

from collections.abc import Iterable
from difflib import get_close_matches


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the known name that looks most like the given one, or None if none comes near."""
    by_folded = {candidate.casefold(): candidate for candidate in known}
    found = get_close_matches(name.casefold(), by_folded, n=1, cutoff=0.5)
    return by_folded[found[0]] if found else None


def unknown(what: str, name: str, known: Iterable[str]) -> str:
    """Return a sentence that refuses an unknown name and gives the nearest known one, or else all of them."""
    names = sorted(known)
    close = nearest(name, names)
    remedy = f"did you mean {close!r}?" if close else f"known: {', '.join(names)}"
    return f"unknown {what} {name!r}; {remedy}"
