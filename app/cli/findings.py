"""Findings about a file as the command line shows them: one line with the place, and what would help below it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING

from app.cli.tongue import told_here

if TYPE_CHECKING:
    from app.plant.findings import Finding


def lines_of(file: Path | str, finding: Finding) -> Iterator[str]:
    """Give the lines of a finding in the language of this process."""
    place = f"{file}:{finding.line}:{finding.column}"
    yield f"{place}: {told_here(finding.severity.value)}: {told_here(finding.message)}"
    if finding.remedy:
        yield f"    {told_here(finding.remedy)}"
