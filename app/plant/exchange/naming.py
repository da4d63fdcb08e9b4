"""Names that a plant file takes, made of the names that other systems give: barcodes, tags, ids."""

import re
from collections.abc import Callable, Iterable, Iterator
from itertools import count
from string import ascii_uppercase, digits

from app.domain.layout import VehicleKind
from app.plant.exchange.report import Report, shown
from app.plant.names import DISPLAY_BYTES, is_barcode, is_id
from app.protocols.enig.messages import TAG_SIZE, is_tag

MOST_TAGS = 10_000
_UINT = 1 << 48
"""Barcodes of the default dialect are numbers of six bytes (PROTOCOLS I7)."""
_ASCII = 6
_LONGEST_ID = 64


def barcodes_of(
    names: list[str], kind: VehicleKind, given: dict[str, str], report: Report
) -> tuple[dict[str, str], bool]:
    """Return the barcode for each name of a mark, and whether hoists need a dialect of text barcodes.

    ``given`` are a person's own. Names stay as they are where the wire takes them; otherwise they get the number that is in
    them, or the next free one.
    """
    if kind is VehicleKind.AGV:
        return _renamed(names, given, is_tag, _tags, report, "AGVs read tags of four characters"), False
    others = [name for name in names if name not in given]
    numbers = all(map(_is_number, others))
    text = not numbers and all(_is_text(name) for name in others)
    fits = _is_text if text else _is_number
    found = _renamed(names, given, fits, _numbers, report, "barcodes are numbers, or texts of six characters at most")
    return found, not all(map(_is_number, found.values()))


def _is_number(name: str) -> bool:
    return name.isascii() and name.isdecimal() and (name == "0" or name[0] != "0") and int(name[:16]) < _UINT


def _is_text(name: str) -> bool:
    return is_barcode(name) and len(name) <= _ASCII


def _renamed(
    names: list[str],
    given: dict[str, str],
    fits: Callable[[str], bool],
    spare: Callable[[], Iterator[str]],
    report: Report,
    why: str,
) -> dict[str, str]:
    found = {name: given[name] for name in names if name in given}
    taken = set(found.values())
    for name in names:
        if name not in found and fits(name) and name not in taken:
            found[name] = name
            taken.add(name)
    free = spare()
    for name in names:
        if name in found:
            continue
        own = _number_in(name, fits)
        barcode = own if own and own not in taken else next(mark for mark in free if mark not in taken)
        found[name] = barcode
        taken.add(barcode)
        report.repaired(f"{shown(name)} → {barcode}", f"renamed: {why} (give your own with --names)")
    return {name: found[name] for name in names}


def _number_in(name: str, fits: Callable[[str], bool]) -> str | None:
    """Return the last number in a name as it could be written on the wire."""
    match = re.search(r"([0-9]{1,12})[^0-9]*$", name)
    if match is None:
        return None
    number = str(int(match[1]))
    return next((text for text in (number, number.zfill(TAG_SIZE)) if fits(text)), None)


def _numbers() -> Iterator[str]:
    return map(str, count(1))


def _tags() -> Iterator[str]:
    """Give 0001 to 9999, then what begins with a letter."""
    yield from (f"{number:0{TAG_SIZE}d}" for number in range(1, MOST_TAGS))
    letters = digits + ascii_uppercase
    for number in range(10 * 36**3, 36**4):
        yield "".join(letters[number // 36**place % 36] for place in (3, 2, 1, 0))


def ids_of(
    names: Iterable[tuple[str, str]], taken: set[str], what: str, report: Report, *, titled: bool = False
) -> dict[str, str]:
    """Return an id for each (name, where), none of them twice or in ``taken``, which they are added to.

    ``titled``: the name itself is kept beside the id.
    """
    found: dict[str, str] = {}
    for name, where in names:
        if name in found:
            continue
        lost = any(letter.isalnum() and not letter.isascii() for letter in name)
        kept = _id_from(name) or str(len(found) + 1)
        wanted = name if is_id(name) else f"{what}-{kept}"[:_LONGEST_ID] if lost or not _id_from(name) else kept
        made, number = wanted, 2
        while made in taken:
            made, number = f"{wanted[: _LONGEST_ID - 6]}-{number}", number + 1
        if lost and not titled:
            report.wrong(
                f"{where}: {shown(name)} → {made}",
                "renamed, and its letters are lost: names are Latin letters, digits and . _ - : + @",
                "write the names into the list by which hosts are to order, and import it again",
            )
        elif made != name:
            report.repaired(
                f"{where}: {shown(name)} → {made}", "renamed: names are letters, digits and . _ - : + @, each used once"
            )
        found[name] = made
        taken.add(made)
    return found


def _id_from(name: str) -> str:
    return re.sub(r"[^A-Za-z0-9._:+@-]+", "-", name.strip()).strip("-._:+@")[:_LONGEST_ID]


def displays_of(names: Iterable[tuple[str, str]], report: Report) -> dict[str, str]:
    """Return for each (id, name for people) what vehicles show: at most 16 ASCII characters, each once where it was cut."""
    found: dict[str, str] = {}
    taken: set[str] = set()
    for name, wanted in names:
        text = wanted if _fits_display(wanted) else name
        if not _fits_display(text):
            text = text[-DISPLAY_BYTES:].lstrip("-._:+@ ")
            number = 1
            while text in taken:
                number += 1
                text = f"{name[: DISPLAY_BYTES - 5]}~{number}"
            report.repaired(f"{name} → {text}", f"shown on vehicles so: their displays hold {DISPLAY_BYTES} characters")
        found[name] = text
        taken.add(text)
    return found


def _fits_display(text: str) -> bool:
    return 0 < len(text) <= DISPLAY_BYTES and text.isascii() and text.isprintable()
