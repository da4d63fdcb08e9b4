"""What is wrong with a plant file, and where."""

from dataclasses import dataclass
from enum import StrEnum

from app.domain.errors import PlantError
from app.domain.layout import Plant


class Severity(StrEnum):
    """``error``: the file describes no usable plant. ``warning``: it does, but probably not the one that was meant."""

    ERROR = "error"
    WARNING = "warning"


@dataclass(frozen=True, slots=True)
class Finding:
    """One mistake: ``line`` and ``column`` count from 1, ``path`` names the place in the file (``stations.P1.at``).

    ``message`` is a sentence without its full stop; ``remedy`` says what would help and may be empty.
    """

    line: int
    column: int
    severity: Severity
    path: str
    message: str
    remedy: str = ""

    @property
    def is_error(self) -> bool:
        """Whether it makes the file unusable."""
        return self.severity is Severity.ERROR

    def __str__(self) -> str:
        return f"{self.line}:{self.column}: {self.severity}: {self.message}"


class UnusablePlant(PlantError):
    """The plant file has errors; ``findings`` holds all of them, and the warnings, in the order of the file.

    ``understood`` is what could be made of the rest, to look at and for nothing else: its parts may name what it does not have.
    """

    def __init__(self, name: str, findings: list[Finding], understood: Plant | None = None) -> None:
        errors = [finding for finding in findings if finding.is_error]
        more = f" (and {len(errors) - 1} more)" if len(errors) > 1 else ""
        super().__init__(f"{name}:{errors[0]}{more}", remedy=errors[0].remedy)
        self.name = name
        self.findings = findings
        self.understood = understood
