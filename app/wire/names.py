"""Finding the name that somebody probably meant."""

import re
from collections.abc import Collection, Iterable
from difflib import get_close_matches

FEW = 200
"""Among so many names at most a misspelt one is looked for by likeness: some milliseconds (our choice)."""
_UNHEARD = re.compile(r"[-_.:\s]+|(?<!\d)0+(?=\d)")
"""What people leave out of a name, or put into it: separators, zeros before a number."""


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the known name that looks most like the given one, or None if none comes near."""
    by_folded = {candidate.casefold(): candidate for candidate in known}
    found = get_close_matches(name.casefold(), by_folded, n=1, cutoff=0.5)
    return by_folded[found[0]] if found else None


def misspelt(name: str, known: Collection[str]) -> str | None:
    """Return the known name that was surely meant: the same but for case, separators and leading zeros, or nearly the same.

    Cheap among any number of names: the second is looked for among a few only. None: there is none, or several are the same.
    """
    wanted = _UNHEARD.sub("", name.casefold())
    last = wanted[-1:]  # nine of ten are passed over by it
    same = [one for one in known if one[-1:].casefold() == last and _UNHEARD.sub("", one.casefold()) == wanted]
    if len(same) == 1:
        return same[0]
    folded = [one for one in same if one.casefold() == name.casefold()]
    if same or len(known) > FEW:
        return folded[0] if len(folded) == 1 else None
    by_folded = {candidate.casefold(): candidate for candidate in known}
    found = get_close_matches(name.casefold(), by_folded, n=1, cutoff=0.8)
    return by_folded[found[0]] if found else None


def unknown(what: str, name: str, known: Iterable[str]) -> str:
    """Return a sentence that refuses an unknown name and gives the nearest known one, or else all of them."""
    names = sorted(known)
    close = nearest(name, names)
    remedy = f"did you mean {close!r}?" if close else f"known: {', '.join(names)}"
    return f"unknown {what} {name!r}; {remedy}"
