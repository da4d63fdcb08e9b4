"""The plant file: read, checked, with every mistake named by line and remedy."""

from app.domain.layout import Plant
from app.plant.build import build
from app.plant.checks import check
from app.plant.convert import FAILED, convert
from app.plant.dialects import dialect_of
from app.plant.document import Document, Unreadable
from app.plant.findings import Finding, Severity, UnusablePlant
from app.plant.foreign import foreign
from app.plant.format import PlantFile, schema, schema_text

__all__ = ["Finding", "Severity", "UnusablePlant", "dialect_of", "read", "schema", "schema_text"]


def read(text: str, name: str) -> tuple[Plant, list[Finding]]:
    """Return the plant that a plant file's text describes, and the warnings about it, in the order of the file.

    ``name`` is the file's, for messages; without directory and ending it is also the plant's unless the file gives one.
    Raises: UnusablePlant: the file has errors; it holds all findings, and what was understood.
    """
    try:
        document = Document(text)
    except Unreadable as wrong:
        raise UnusablePlant(name, foreign(text) or wrong.findings) from None
    plant = _plant(document, name)
    findings = sorted(document.findings, key=lambda finding: (finding.line, finding.column))
    if plant is None or document.has_errors:
        raise UnusablePlant(name, foreign(text) or findings, plant)
    return plant, findings


def _plant(document: Document, name: str) -> Plant | None:
    file = convert(document, document.root, PlantFile)
    if file is FAILED:
        return None
    plant, places = build(document, file, name.replace("\\", "/").rpartition("/")[2].partition(".")[0])
    check(document, plant, places)
    return plant
