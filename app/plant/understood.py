"""What was read of a plant, and of what."""

from collections.abc import Sequence
from dataclasses import dataclass

from app.domain.layout import Plant
from app.domain.versions import Source
from app.plant.findings import Finding


@dataclass(frozen=True, slots=True)
class Understood:
    """The plant of a source and the warnings about it; ``source`` has the catalogues that were found."""

    plant: Plant
    findings: Sequence[Finding]
    source: Source
