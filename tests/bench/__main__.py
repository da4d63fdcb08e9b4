"""``python -m tests.bench [--keep] [ROW...]``: run all benchmarks, or those named.

All of them write ``bench/results.*`` and the table of the READMEs; with ``--keep`` those named do so too, in place of their rows
of the last time.
"""

import json
import os
import platform
import signal
import sys
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields

from tests.bench import (
    decoding,
    dispatching,
    granting,
    history,
    hoists,
    memory,
    page,
    posting,
    replanning,
    routing,
    session_path,
    showing,
)
from tests.bench.measuring import ROOT, Row, Skipped, table

BENCHES: dict[str, Callable[[], Iterator[Row]]] = {
    "session": session_path.rows,
    "decode": decoding.rows,
    "post": posting.rows,
    "history": history.rows,
    "show": showing.rows,
    "route": routing.rows,
    "grant": granting.rows,
    "replan": replanning.rows,
    "dispatch": dispatching.rows,
    "memory": memory.rows,
    "page": page.rows,
    "hoists": hoists.rows,
}
RESULTS = ROOT / "bench"
READMES = (ROOT / "README.md", ROOT / "README.ko.md")
BEGIN, END = "<!-- make bench writes from here -->\n", "<!-- to here -->\n"
"""Between them stands the table of the last run."""


def main(names: list[str]) -> int:
    """Run, print one table, and write it; return the exit code."""
    keep = "--keep" in names
    names = [name for name in names if name != "--keep"]
    unknown = [name for name in names if name not in BENCHES]
    if unknown:
        print(f"no benchmark {', '.join(unknown)}; there are {', '.join(BENCHES)}", file=sys.stderr)
        return 2
    found: dict[str, list[Row]] = {}
    for name in names or BENCHES:
        print(f"{name} …", file=sys.stderr, flush=True)
        try:
            found[name] = list(BENCHES[name]())
        except Skipped as why:
            print(f"{name} skipped: {why}", file=sys.stderr)
    print(table([row for rows in found.values() for row in rows]))
    if keep or not names:
        _write(merged(kept(), found) if names else found)
    return 0


def kept() -> dict[str, list[Row]]:
    """Return the rows of the last time, by benchmark."""
    found: dict[str, list[Row]] = {}
    for entry in json.loads((RESULTS / "results.json").read_text()):
        known = {field.name: entry[field.name] for field in fields(Row)}
        found.setdefault(entry["bench"], []).append(Row(**known))
    return found


def merged(before: dict[str, list[Row]], now: dict[str, list[Row]]) -> dict[str, list[Row]]:
    """Return the rows of before with those of now in their place, in the order of the benchmarks."""
    both = before | now
    return {name: both[name] for name in BENCHES if name in both}


def placed(text: str, rows: Sequence[Row]) -> str:
    """Return a text with the table between its marks. Raises ValueError: it has none."""
    before, begin, rest = text.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not (begin and end):
        raise ValueError(f"no {BEGIN.strip()} … {END.strip()}: there is no place for the table")
    return f"{before}{BEGIN}{table(rows)}\n{END}{after}"


def _write(found: dict[str, list[Row]]) -> None:
    RESULTS.mkdir(exist_ok=True)
    rows = [row for of_one in found.values() for row in of_one]
    entries = [
        {
            "bench": name,
            "row": row.row,
            "ours": row.ours,
            "floor": row.floor,
            "naive": row.naive,
            "unit": row.unit,
            "ratio": row.ratio,
            "goal": row.goal,
            "better": row.better,
            "note": row.note,
        }
        for name, of_one in found.items()
        for row in of_one
    ]
    (RESULTS / "results.json").write_text(json.dumps(entries, indent=2, ensure_ascii=False) + "\n")
    here = f"Python {platform.python_version()}, {os.cpu_count()} processors, {platform.system()} {platform.machine()}"
    notes = "\n".join(f"* {row.row}: {row.note}." for row in rows if row.note)
    text = f"""# Benchmarks

Written by `make bench`. Each figure stands against a floor measured in the same run; CPU time, not wall time, unless the unit
says otherwise. Absolute numbers are for orientation: neighbours on the machine change them, the ratios less.

{here}.

{table(rows)}

{notes}
"""
    (RESULTS / "results.md").write_text(text)
    for readme in READMES:
        readme.write_text(placed(readme.read_text(), rows))


if __name__ == "__main__":
    # A polite kill unwinds, so that no child stays behind.
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(143))
    sys.exit(main(sys.argv[1:]))
