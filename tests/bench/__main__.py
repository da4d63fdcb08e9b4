"""``python -m tests.bench [ROW...]``: run all benchmarks, or those named; all of them write ``bench/results.*``."""

import json
import os
import platform
import signal
import sys
from collections.abc import Callable, Iterator, Sequence

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
    unknown = [name for name in names if name not in BENCHES]
    if unknown:
        print(f"no benchmark {', '.join(unknown)}; there are {', '.join(BENCHES)}", file=sys.stderr)
        return 2
    found: list[Row] = []
    for name in names or BENCHES:
        print(f"{name} …", file=sys.stderr, flush=True)
        try:
            found += BENCHES[name]()
        except Skipped as why:
            print(f"{name} skipped: {why}", file=sys.stderr)
    print(table(found))
    if not names:
        _write(found)
    return 0


def placed(text: str, rows: Sequence[Row]) -> str:
    """Return a text with the table between its marks. Raises ValueError: it has none."""
    before, begin, rest = text.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not (begin and end):
        raise ValueError(f"no {BEGIN.strip()} … {END.strip()}: there is no place for the table")
    return f"{before}{BEGIN}{table(rows)}\n{END}{after}"


def _write(rows: list[Row]) -> None:
    RESULTS.mkdir(exist_ok=True)
    kept = [
        {
            "row": row.row,
            "ours": row.ours,
            "floor": row.floor,
            "naive": row.naive,
            "unit": row.unit,
            "ratio": row.ratio,
            "goal": row.goal,
            "better": row.better,
        }
        for row in rows
    ]
    (RESULTS / "results.json").write_text(json.dumps(kept, indent=2, ensure_ascii=False) + "\n")
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
