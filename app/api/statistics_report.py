"""The printable report of a shift: one HTML page that needs nothing else, in English or Korean."""

from collections.abc import Mapping, Sequence
from datetime import UTC, datetime, tzinfo
from html import escape

from app.api.statistics_tables import MOMENTS, Cell, Table, table_of
from app.domain.alarms import AlarmCount
from app.fleet.statistics import Statistics
from app.texts import Language, catalogue, told

WORDS: Mapping[str, Mapping[str, str]] = {
    "en": {
        "title": "Shift report",
        "summary": "Jobs that ended",
        "phases": "Delivery time by phase, seconds",
        "intervals": "Throughput and queue",
        "vehicles": "Vehicles",
        "waits": "What jobs waited for",
        "places": "Where jobs waited",
        "late": "The latest lots",
        "open": "Still open at the end",
        "alarms": "Alarms, the longest first",
        "empty": "Driven empty",
        "waits_of": "of the newest {} jobs that waited or were assigned",
        "none": "none",
        "made": "made",
        "phase": "phase",
        "count": "count",
        "mean": "mean, s",
        "p50": "half within, s",
        "p95": "95 % within, s",
        "longest": "longest, s",
        "begin": "from",
        "ordered": "ordered",
        "completed": "completed",
        "unfinished": "ended otherwise",
        "queue": "queue",
        "vehicle": "vehicle",
        "fetching": "to the source, s",
        "acquiring": "picking up, s",
        "carrying": "carrying, s",
        "depositing": "putting down, s",
        "busy_share": "at work",
        "failures": "failures",
        "down_minutes": "down, min",
        "mtbf_hours": "MTBF, h",
        "mttr_minutes": "MTTR, min",
        "availability": "available",
        "cause": "cause",
        "times": "times",
        "seconds": "seconds",
        "place": "station or vehicle",
        "jobs": "jobs",
        "job": "job",
        "carrier": "carrier",
        "destination": "destination",
        "priority": "priority",
        "created": "accepted",
        "ended": "ended",
        "queued": "queued, s",
        "total": "total, s",
        "waited": "longest wait, s",
        "reason": "what it waited for",
        "kind": "of",
        "source": "source",
        "machine": "machine",
        "code": "code",
        "minutes": "minutes",
    },
    "ko": {
        "title": "교대 보고서",
        "summary": "종료된 작업",
        "phases": "단계별 반송 시간 (초)",
        "intervals": "처리량과 대기열",
        "vehicles": "차량",
        "waits": "작업이 기다린 이유",
        "places": "작업이 기다린 장소",
        "late": "가장 늦은 작업",
        "open": "종료 시점에 미완료인 작업",
        "alarms": "알람 (오래 지속된 순)",
        "empty": "공차 주행 비율",
        "waits_of": "대기했거나 배차된 최근 작업 {}건 기준",
        "none": "없음",
        "made": "작성",
        "phase": "단계",
        "count": "건수",
        "mean": "평균(초)",
        "p50": "중앙값(초)",
        "p95": "95 %(초)",
        "longest": "최장(초)",
        "begin": "시작",
        "ordered": "접수",
        "completed": "완료",
        "unfinished": "미완료 종료",
        "queue": "대기열",
        "vehicle": "차량",
        "fetching": "출발지 이동(초)",
        "acquiring": "적재(초)",
        "carrying": "운반(초)",
        "depositing": "하역(초)",
        "busy_share": "가동률",
        "failures": "고장",
        "down_minutes": "정지(분)",
        "mtbf_hours": "MTBF(시간)",
        "mttr_minutes": "MTTR(분)",
        "availability": "가용률",
        "cause": "원인",
        "times": "횟수",
        "seconds": "초",
        "place": "스테이션 또는 차량",
        "jobs": "작업 수",
        "job": "작업",
        "carrier": "캐리어",
        "destination": "목적지",
        "priority": "우선순위",
        "created": "접수",
        "ended": "종료",
        "queued": "대기(초)",
        "total": "전체(초)",
        "waited": "최장 대기(초)",
        "reason": "대기 이유",
        "kind": "구분",
        "source": "출발지",
        "machine": "설비",
        "code": "코드",
        "minutes": "분",
    },
}
STYLE = (
    "body{font:13px/1.4 system-ui,sans-serif;margin:2em auto;max-width:60em;color:#111;background:#fff}"
    "h1{font-size:1.5em;margin:0}h2{font-size:1.1em;margin:1.6em 0 .4em}table{border-collapse:collapse;width:100%}"
    "th,td{border-bottom:1px solid #bbb;padding:.2em .5em;text-align:right}"
    "th:first-child,td:first-child{text-align:left}tr{break-inside:avoid}@media print{body{margin:0}}"
)


SHARES = frozenset({"busy_share", "availability"})
"""Columns that are shown in per cent."""
SENTENCES = frozenset({"cause", "reason"})
"""Columns whose cells are sentences of the controller."""
NAMED = frozenset({"phase", "kind"})
"""Columns whose cells are words of the page's catalogue."""


def report(
    plant: str,
    found: Statistics,
    alarms: Sequence[AlarmCount],
    made: float,
    lang: Language,
    zone: tzinfo | None = None,
) -> bytes:
    """Return the report as HTML. Moments are in a time zone, which it says; None: that of this machine."""
    words = WORDS[lang]
    empty = words["none"] if found.empty is None else f"{found.empty:.1%}"
    summary = Table(tuple(found.states), [tuple(found.states.values())])
    counted = Table(
        ("kind", "machine", "code", "times", "minutes"),
        [
            (*(row.about[n] for n in ("kind", "source", "code")), row.times, round(row.seconds / 60, 1))
            for row in alarms
        ],
    )
    when = f"{_local(found.begin, zone)} – {_local(found.end, zone)} {escape(_named(found.end, zone))}"
    parts = [
        f"<h1>{escape(words['title'])}: {escape(plant)}</h1>",
        f"<p>{when} ({escape(words['made'])} {_local(made, zone)})</p>",
        _section(words["summary"], summary, words, lang, zone),
        f"<p>{escape(words['empty'])}: {empty}</p>",
        *(
            _section(words[name], table_of(name, found, ()), words, lang, zone)
            for name in ("phases", "intervals", "vehicles")
        ),
        _section(words["waits"], table_of("waits", found, ()), words, lang, zone),
        f"<p>{escape(words['waits_of'].format(found.waits_of))}</p>",
        *(_section(words[name], table_of(name, found, ()), words, lang, zone) for name in ("places", "late", "open")),
        _section(words["alarms"], counted, words, lang, zone),
    ]
    head = f'<meta charset="utf-8"><title>{escape(words["title"])}: {escape(plant)}</title><style>{STYLE}</style>'
    return f'<!doctype html><html lang="{lang}"><head>{head}</head><body>{"".join(parts)}</body></html>'.encode()


def said(word: str, lang: Language) -> str:
    """Return a word of the page's catalogue; as it is, if it has none."""
    return catalogue(lang)["page"].get(word, word)


def _local(moment: float, zone: tzinfo | None) -> str:
    return datetime.fromtimestamp(moment, UTC).astimezone(zone).strftime("%Y-%m-%d %H:%M")


def _named(moment: float, zone: tzinfo | None) -> str:
    """Return the zone by its name and its offset, as 'Asia/Seoul, UTC+09:00'."""
    there = datetime.fromtimestamp(moment, UTC).astimezone(zone)
    name = there.tzname() if zone is None else str(zone)
    return "UTC" if name in {"UTC", None} else f"{name}, UTC{there.isoformat()[-6:]}"


def _section(title: str, table: Table, words: Mapping[str, str], lang: Language, zone: tzinfo | None) -> str:
    if not table.rows:
        return f"<h2>{escape(title)}</h2><p>{escape(words['none'])}</p>"
    head = "".join(f"<th>{escape(words.get(column) or said(column, lang))}</th>" for column in table.columns)
    rows = "".join(
        "<tr>"
        + "".join(f"<td>{_cell(*cell, lang, zone)}</td>" for cell in zip(table.columns, row, strict=True))
        + "</tr>"
        for row in table.rows
    )
    return f"<h2>{escape(title)}</h2><table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def _cell(column: str, cell: Cell, lang: Language, zone: tzinfo | None = None) -> str:
    """Return a cell as people read it."""
    if cell is None:
        return ""
    if isinstance(cell, str):
        if column in MOMENTS:
            return _local(datetime.fromisoformat(cell).timestamp(), zone)
        if column in NAMED:
            return escape(said(f"phase_{cell}" if column == "phase" else cell, lang))
        return escape(told(cell, lang) if column in SENTENCES else cell)
    if column in SHARES:
        return f"{cell:.1%}"
    return f"{cell:,.1f}" if isinstance(cell, float) else escape(str(cell))
