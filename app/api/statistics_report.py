"""The printable report of a shift: one HTML page that needs nothing else, in English or Korean."""

from collections.abc import Mapping, Sequence
from html import escape

from app.api.statistics_tables import Cell, Table, table_of
from app.domain.alarms import AlarmCount
from app.fleet.statistics import Statistics
from app.runtime.showing import iso

WORDS: Mapping[str, Mapping[str, str]] = {
    "en": {
        "title": "Shift report",
        "summary": "Jobs that ended",
        "phases": "Delivery time by phase, seconds",
        "intervals": "Throughput and queue",
        "vehicles": "Vehicles",
        "waits": "What jobs waited for",
        "alarms": "Alarms, the longest first",
        "empty": "Driven empty",
        "waits_of": "of the newest {} jobs that waited or were assigned",
        "none": "none",
        "made": "made",
    },
    "ko": {
        "title": "교대 보고서",
        "summary": "종료된 작업",
        "phases": "단계별 반송 시간 (초)",
        "intervals": "처리량과 대기열",
        "vehicles": "차량",
        "waits": "작업이 기다린 이유",
        "alarms": "알람 (오래 지속된 순)",
        "empty": "공차 주행 비율",
        "waits_of": "대기했거나 배차된 최근 작업 {}건 기준",
        "none": "없음",
        "made": "작성",
    },
}
STYLE = (
    "body{font:13px/1.4 system-ui,sans-serif;margin:2em auto;max-width:60em;color:#111;background:#fff}"
    "h1{font-size:1.5em;margin:0}h2{font-size:1.1em;margin:1.6em 0 .4em}table{border-collapse:collapse;width:100%}"
    "th,td{border-bottom:1px solid #bbb;padding:.2em .5em;text-align:right}"
    "th:first-child,td:first-child{text-align:left}tr{break-inside:avoid}@media print{body{margin:0}}"
)


def report(plant: str, found: Statistics, alarms: Sequence[AlarmCount], made: float, lang: str) -> bytes:
    """Return the report as HTML."""
    words = WORDS[lang]
    empty = words["none"] if found.empty is None else f"{found.empty:.1%}"
    summary = Table(tuple(found.states), [tuple(found.states.values())])
    counted = Table(
        ("kind", "source", "code", "times", "minutes"),
        [
            (*(row.about[n] for n in ("kind", "source", "code")), row.times, round(row.seconds / 60, 1))
            for row in alarms
        ],
    )
    parts = [
        f"<h1>{escape(words['title'])}: {escape(plant)}</h1>",
        f"<p>{iso(found.begin)} – {iso(found.end)} ({words['made']} {iso(made)})</p>",
        _section(words["summary"], summary, words),
        f"<p>{escape(words['empty'])}: {empty}</p>",
        *(_section(words[name], table_of(name, found, ()), words) for name in ("phases", "intervals", "vehicles")),
        _section(words["waits"], table_of("waits", found, ()), words),
        f"<p>{escape(words['waits_of'].format(found.waits_of))}</p>",
        _section(words["alarms"], counted, words),
    ]
    head = f'<meta charset="utf-8"><title>{escape(words["title"])}: {escape(plant)}</title><style>{STYLE}</style>'
    return f'<!doctype html><html lang="{lang}"><head>{head}</head><body>{"".join(parts)}</body></html>'.encode()


def _section(title: str, table: Table, words: Mapping[str, str]) -> str:
    if not table.rows:
        return f"<h2>{escape(title)}</h2><p>{escape(words['none'])}</p>"
    head = "".join(f"<th>{escape(column)}</th>" for column in table.columns)
    rows = "".join("<tr>" + "".join(f"<td>{_cell(cell)}</td>" for cell in row) + "</tr>" for row in table.rows)
    return f"<h2>{escape(title)}</h2><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def _cell(cell: Cell) -> str:
    if cell is None:
        return ""
    return f"{cell:,.1f}" if isinstance(cell, float) else escape(str(cell))
