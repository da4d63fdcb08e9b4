"""What an import of taught values does with each row; the same for a dry run and for the real one (DOMAIN section 3)."""

from collections.abc import Collection, Iterator, Mapping, Sequence

from app.domain.pulses import AxisPulses, carried_over, drifts, known, missing, named
from app.domain.teaching import DRIFT, Fate, ImportRow, RowFate, Side

Present = Mapping[str, tuple[int, AxisPulses]]
"""Version and pulses of each station or vehicle that has any."""


def fates(side: Side, rows: Sequence[ImportRow], names: Collection[str], present: Present) -> list[RowFate]:
    """Return what becomes of each row. ``names`` are the ports or hoists that may be written."""
    first: dict[str, int] = {}
    return [_fate(side, row, names, present, first.setdefault(row.name, row.line)) for row in rows]


def _fate(side: Side, row: ImportRow, names: Collection[str], present: Present, first: int) -> RowFate:
    kind = "port" if side is Side.DEST else "hoist"
    version, before = present.get(row.name, (0, None))
    if row.name not in names:
        where = "stations" if side is Side.DEST else "vehicles"
        return _wrong(row, f"there is no {kind} {row.name} to write", f"see GET /api/v1/{where}")
    if first != row.line:
        return _wrong(row, f"{row.name} is on line {first} already", "keep one of them")
    if row.version is not None and row.version != version:
        return _wrong(row, f"{row.name} is at version {version} now, not {row.version}", "export again, then edit")
    if not known(row.pulses):
        return _wrong(row, f"{row.name} has no value", "give shft, rota and lift, or those that change")
    after = carried_over(before, row.pulses)
    if before is None:
        lacking = missing(after)
        detail = f"{named(lacking)} stay unknown: jobs stay refused" if lacking else ""
        return RowFate(row.line, row.name, Fate.NEW, detail, version=1)
    if after == before:
        return RowFate(row.line, row.name, Fate.SAME, version=version)
    far = drifts(before, after, DRIFT)
    warning = f"; far from version {version}: {far}" if far else ""
    detail = ", ".join(_differences(before, after)) + warning
    return RowFate(row.line, row.name, Fate.CHANGED, detail, version=version + 1)


def _wrong(row: ImportRow, detail: str, remedy: str) -> RowFate:
    return RowFate(row.line, row.name, Fate.ERROR, detail, remedy)


def _differences(before: AxisPulses, after: AxisPulses) -> Iterator[str]:
    old = known(before)
    for axis, value in known(after).items():
        if old.get(axis) != value:
            yield f"{axis.name} {old.get(axis, 'unknown')} -> {value}"
