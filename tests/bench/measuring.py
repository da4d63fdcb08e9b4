"""What the benchmarks share: CPU time of a process, C programs compiled at run time, children that never outlive us."""

import dataclasses
import shutil
import statistics
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from functools import lru_cache
from pathlib import Path
from typing import IO, Any, Literal

HERE = Path(__file__).parent
ROOT = HERE.parent.parent
PATIENCE = 60.0
"""Seconds after which a child that says nothing is given up."""


class Skipped(Exception):
    """A row cannot be measured here; the message says why."""


@dataclasses.dataclass(frozen=True, slots=True)
class Row:
    """One line of the table. ``ratio`` is ours to floor; ``better`` says which way the goal lies; ``note`` is for people."""

    row: str
    ours: float
    floor: float
    naive: float | None
    unit: str
    goal: float | None
    better: Literal["lower", "higher"] = "lower"
    note: str = ""

    @property
    def ratio(self) -> float:
        """Ours to floor."""
        return self.ours / self.floor

    @property
    def met(self) -> bool | None:
        """Whether the goal is reached; None without a goal."""
        if self.goal is None:
            return None
        return self.ratio <= self.goal if self.better == "lower" else self.ratio >= self.goal


def cpu_of(pid: int) -> float:
    """Return the seconds that the threads of a process have run (schedstat: nanoseconds on a processor)."""
    tasks = Path(f"/proc/{pid}/task").iterdir()
    return sum(int((task / "schedstat").read_text().split()[0]) for task in tasks) / 1e9


@lru_cache
def compiled(name: str, *flags: str) -> Path:
    """Return a C program of this folder, compiled. Raises Skipped without a compiler."""
    compiler = shutil.which("gcc") or shutil.which("cc")
    if compiler is None:
        raise Skipped("no C compiler: the floor cannot be measured")
    made = _workshop() / name
    subprocess.run([compiler, "-O2", *flags, "-o", str(made), str(HERE / f"{name}.c")], check=True, timeout=PATIENCE)
    return made


@lru_cache
def _workshop() -> Path:
    place = tempfile.TemporaryDirectory(prefix="hoistway-bench-")
    _kept.append(place)
    return Path(place.name)


_kept: list[tempfile.TemporaryDirectory[str]] = []


@contextmanager
def child(*command: str | Path, **options: Any) -> Iterator[subprocess.Popen[str]]:
    """Run a program beside us and end it afterwards, whatever happens."""
    process = subprocess.Popen([str(word) for word in command], text=True, cwd=ROOT, **options)
    try:
        yield process
    finally:
        process.kill()
        process.wait()
        for pipe in (process.stdin, process.stdout, process.stderr):
            if pipe is not None:
                pipe.close()


def line_of(stream: IO[str] | None) -> str:
    """Return a line that a child says. Raises RuntimeError if it ended instead."""
    line = stream.readline() if stream is not None else ""
    if not line:
        raise RuntimeError("a child of the benchmark ended without a word")
    return line


def module(name: str, *words: object) -> list[str]:
    """Return the command that runs a module of this package with our interpreter."""
    return [sys.executable, "-m", f"tests.bench.{name}", *(str(word) for word in words)]


def in_turn(rounds: int, *measures: Callable[[], float]) -> list[float]:
    """Measure each once per round, one after the other, and return the median of each: neighbours disturb all alike."""
    found: list[list[float]] = [[] for _ in measures]
    for _ in range(rounds):
        for measure, values in zip(measures, found, strict=True):
            values.append(measure())
    return [statistics.median(values) for values in found]


def shown(value: float | None) -> str:
    """Return a figure with three significant digits, or a dash."""
    if value is None:
        return "–"
    return f"{value:,.0f}" if abs(value) >= 1000 else f"{value:.3g}"


def table(rows: Sequence[Row]) -> str:
    """Return the rows as a Markdown table."""
    lines = [
        "| path | floor | ours | naive | unit | ours / floor | goal | met |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        sign = "≤" if row.better == "lower" else "≥"
        goal = "–" if row.goal is None else f"{sign} {row.goal:g}"
        met = {True: "yes", False: "no", None: "–"}[row.met]
        figures = f"{shown(row.floor)} | {shown(row.ours)} | {shown(row.naive)} | {row.unit} | {shown(row.ratio)}"
        lines.append(f"| {row.row} | {figures} | {goal} | {met} |")
    return "\n".join(lines)
