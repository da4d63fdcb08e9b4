"""From files of other systems to a plant file, with a report of what was done to them."""

from collections.abc import Sequence
from dataclasses import dataclass, field

from app.domain.layout import Plant
from app.plant import UnusablePlant, read
from app.plant.exchange import detect, graphs, lif, lists, opentcs, sheets
from app.plant.exchange.detect import JSON_FORMATS, XML_FORMATS, Format
from app.plant.exchange.draft import Draft
from app.plant.exchange.json_text import parsed as parsed_json
from app.plant.exchange.report import Kind, Report, UnreadableLayout, shown
from app.plant.exchange.settle import Options, settle
from app.plant.exchange.units import Reading
from app.plant.exchange.xml_text import parsed as parsed_xml
from app.plant.findings import Finding
from app.plant.writing import write

MOST_MARKS = 100_000
"""Most marks, and four times as many pieces of track. Our choice: what a plant file can hold (MAX_VALUES)."""
_TABLES = frozenset({Format.CSV, Format.XLSX})


@dataclass(frozen=True, slots=True)
class Wishes:
    """All that a person may say about an import; ``format`` None: found out."""

    format: Format | None = None
    encoding: str = ""
    layout: str = ""
    vehicle_type: str = ""
    keep_locked: bool = False
    reading: Reading = Reading()
    options: Options = field(default_factory=Options)


@dataclass(frozen=True, slots=True)
class Imported:
    """The plant file's text and plant, the report, and what the checker finds in the text.

    ``is_sound``: the source contradicted itself nowhere and the checker accepts the plant file.
    """

    text: str
    plant: Plant
    report: Report
    findings: list[Finding]

    @property
    def is_sound(self) -> bool:
        """Whether the plant file can be used as it is."""
        return self.report.is_sound and not any(finding.is_error for finding in self.findings)


def import_layout(sources: Sequence[tuple[str, bytes]], wishes: Wishes) -> Imported:
    """Return the plant file that one foreign layout makes; several files only where they are tables of one.

    ``sources`` are names and contents. Raises: UnreadableLayout: nothing can be made of them.
    """
    report = Report()
    draft = _draft(sources, wishes, report)
    if not draft.spots:
        raise _nowhere(sources[0][0], report)
    if len(draft.spots) > MOST_MARKS or len(draft.ways) > 4 * MOST_MARKS:
        size = f"{len(draft.spots)} marks and {len(draft.ways)} pieces of track"
        raise UnreadableLayout(f"{sources[0][0]}: {size} are more than a plant file holds", remedy="split the layout")
    settled = settle(draft, wishes.options, report)
    if not settled.plant.points:
        raise _nowhere(sources[0][0], report)
    text = write(settled.plant, _head([name for name, _ in sources], report), settled.notes, settled.stations)
    try:
        _, findings = read(text, f"{settled.plant.name}.yaml")
    except UnusablePlant as unusable:
        findings = unusable.findings
    return Imported(text, settled.plant, report, findings)


def _nowhere(name: str, report: Report) -> UnreadableLayout:
    """Return that no mark of a file has a position that can be taken, with the mistake that is most often to blame."""
    what = f"{name}: there is no mark with a position in it"
    wrong = max((note for note in report.notes if note.kind is Kind.WRONG), key=lambda note: note.times, default=None)
    if wrong is None:
        return UnreadableLayout(what)
    place = f"{wrong.where[0]}: " if wrong.where else ""
    return UnreadableLayout(f"{what}: {place}{wrong.what}", remedy=wrong.remedy)


def _draft(sources: Sequence[tuple[str, bytes]], wishes: Wishes, report: Report) -> Draft:
    families = [_family(data, wishes.format) for _, data in sources]
    if families == ["json"]:
        return _of_json(*sources[0], wishes, report)
    if families == ["xml"]:
        return _of_xml(*sources[0], wishes, report)
    if not all(kind in ("text", "workbook") for kind in families):
        raise UnreadableLayout("several files make one layout only where all are tables: CSV or workbooks")
    tables: list[sheets.Table] = []
    for (name, data), kind in zip(sources, families, strict=True):
        if kind == "workbook":
            found = sheets.tables_of_workbook(data, name, report)
        else:
            found = sheets.tables_of_text(data, name, wishes.encoding, report)
        if len(sources) > 1:
            found = [sheets.Table(f"{shown(name)} {t.name}".strip(), t.columns, t.rows, t.unknown) for t in found]
        tables += found
    return lists.draft_of(tables, wishes.reading, report)


def _family(data: bytes, wanted: Format | None) -> str:
    found = detect.family(data)
    if wanted is None:
        return found
    needed = "json" if wanted in JSON_FORMATS else "xml" if wanted in XML_FORMATS else "workbook"
    if wanted is Format.CSV:
        needed = "text"
    if found not in (needed, "text") and wanted is not Format.CSV:
        raise UnreadableLayout(f"this is no {wanted.value}: it looks like {found}", remedy="leave --format out")
    return needed


def _of_json(name: str, data: bytes, wishes: Wishes, report: Report) -> Draft:
    found = parsed_json(data, name, report)
    if (wishes.format or detect.of_json(found)) is Format.LIF:
        return lif.draft_of(found, report, wishes.layout, wishes.vehicle_type)
    return graphs.draft_of_json(found, wishes.reading, report)


def _of_xml(name: str, data: bytes, wishes: Wishes, report: Report) -> Draft:
    root = parsed_xml(data, name)
    if (wishes.format or detect.of_xml(root)) is Format.OPENTCS:
        return opentcs.draft_of(root, report, keep_locked=wishes.keep_locked)
    return graphs.draft_of_graphml(root, wishes.reading, report)


def _head(names: Sequence[str], report: Report) -> list[str]:
    lines = [f"Imported by hoistway layout import from {', '.join(names)}: {report.source}."]
    for kind, title in ((Kind.WRONG, "Wrong in the source"), (Kind.NEEDED, "To supply"), (Kind.ASSUMED, "Assumed")):
        found = [note for note in report.notes if note.kind is kind]
        lines += [f"{title}:"] if found else []
        lines += [f"  {note}" + (f" ({note.remedy})" if note.remedy else "") for note in found[:20]]
    return lines
