"""What was found, as one table: a row for each figure, with its goal and whether it was met."""

import re
from collections.abc import Mapping, Sequence
from json import JSONDecodeError, dumps, loads
from pathlib import Path
from typing import Any

from app.cli.plainly import CannotStart, said, text_of

ROW = re.compile(r"\[[\d\s.,]*\]")
"""Numbers in a row: they stand on one line of the file, hundreds of them."""
BEGIN, END = "<!-- hoistway bench traffic writes from here -->\n", "<!-- to here -->\n"
"""Between them stands the table in a file that has more than that."""


class Kept:
    """What is found, in a file (``json``) beside what was found there before, and as a table in others.

    Raises: CannotStart: one of them cannot be read or written, or has something else in it.
    """

    def __init__(self, json: Path | None, into: Sequence[Path]) -> None:
        self._json, self._into = json, into
        self.found: dict[str, Any] = _read(json) if json is not None and json.exists() else {}

    @property
    def table(self) -> str:
        """What is known by now."""
        return table(self.found)

    def keep(self) -> None:
        """Write what is known by now. Raises: CannotStart."""
        if self._json is not None:
            text = ROW.sub(lambda row: " ".join(row[0].split()), dumps(self.found, indent=1))
            _write(self._json, f"{text}\n")
        for file in self._into:
            before = text_of(file) if file.exists() else ""
            if before and BEGIN not in before and not before.startswith("| "):
                where = f"Put the lines {BEGIN.strip()} and {END.strip()} where it is to stand, or name another file."
                raise CannotStart(f"{file} has something else in it, and no place for the table. {where}")
            _write(file, placed(before, self.found))


def _read(file: Path) -> dict[str, Any]:
    try:
        found = loads(text_of(file))
    except JSONDecodeError as wrong:
        raise CannotStart(f"{file} has no JSON in it: {wrong}. Name another file, or remove it.") from None
    if not isinstance(found, dict):
        raise CannotStart(f"{file} has no findings of `bench traffic` in it. Name another file, or remove it.")
    return found


def _write(file: Path, text: str) -> None:
    try:
        file.write_text(text, encoding="utf-8")
    except OSError as wrong:
        raise CannotStart(f"{file} cannot be written: {said(wrong)}") from None


def table(found: Mapping[str, Any]) -> str:
    """Return what was found, part by part, as Markdown: the sweep's deliveries, then all goals, each met or not."""
    sweep = found.get("sweep", ())
    rows = [f"| {row['what']} | {row['found']} | {row['goal']} | {row['met']} |" for row in _goals(found)]
    blocks = [["| what | found | goal | met |", "|---|---|---|---|", *rows]] if rows else []
    if sweep:
        blocks.insert(0, _deliveries(sweep))
    return "\n\n".join("\n".join(block) for block in blocks)


def placed(text: str, found: Mapping[str, Any]) -> str:
    """Return a text with the table between its marks, or the table alone where the text has none."""
    before, begin, rest = text.partition(BEGIN)
    _, end, after = rest.partition(END)
    return f"{before}{BEGIN}{table(found)}\n{END}{after}" if begin and end else f"{table(found)}\n"


def _goals(found: Mapping[str, Any]) -> list[dict[str, str]]:
    return [
        goal | {"met": "yes" if goal["met"] else "no"} for goals in found.get("goals", {}).values() for goal in goals
    ]


def _deliveries(sweep: Sequence[Mapping[str, Any]]) -> list[str]:
    """Return the table of the sweep: modes by fleets, the mean of the seeds, and how many of them locked up."""
    fleets = sorted({row["vehicles"] for row in sweep})
    cells = {(row["mode"], row["vehicles"]): row for row in sweep}
    lines = [f"| deliveries an hour | {' | '.join(f'{vehicles:,} vehicles' for vehicles in fleets)} |"]
    lines.append("|---" * (len(fleets) + 1) + "|")
    for mode in dict.fromkeys(row["mode"] for row in sweep):
        some = [_cell(cells[mode, vehicles]) if (mode, vehicles) in cells else "–" for vehicles in fleets]
        lines.append(f"| {mode} | {' | '.join(some)} |")
    return lines


def _cell(row: Mapping[str, Any]) -> str:
    runs = row["runs"]
    wrong = {
        "locked up": sum(run["locked"] > 0 for run in runs),
        "at a standstill": sum(run["stalled"] for run in runs),
    }
    said = [f"{count} of {len(runs)} {word}" for word, count in wrong.items() if count]
    return ", ".join([f"{row['per_hour']:,.0f}", *said])
