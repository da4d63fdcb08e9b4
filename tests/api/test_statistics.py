"""Statistics over REST: JSON, files, and the report of a shift."""

import csv
import io
from datetime import datetime
from importlib import import_module
from importlib.util import find_spec
from zoneinfo import ZoneInfoNotFoundError

import httpx
import pytest

from app.api import periods
from app.api.statistics_report import WORDS, _cell
from app.api.statistics_tables import COUNTS, MOMENTS, NAMES, TEXTS
from app.domain.statistics import Transfer
from tests.api.scripted import NOW, Scripted

pytestmark = pytest.mark.anyio
ODD = "=1+1"


@pytest.fixture
def controller() -> Scripted:
    controller = Scripted()
    marks = (NOW - 590, NOW - 560, NOW - 550, NOW - 510, NOW - 500)
    row = Transfer("LOT-1", "completed", ODD, "P1", "P2", 50, "V001", NOW - 600, *marks, NOW - 500)
    controller.reader.done.append(row)
    return controller


async def test_a_period_is_shown_in_intervals_with_every_vehicle(client: httpx.AsyncClient) -> None:
    asked: dict[str, str | int] = {"from": "2025-12-31T22:00:00Z", "to": "2026-01-01T00:00:00Z", "interval": 1800}
    found = (await client.get("/statistics", params=asked)).json()
    assert (found["from"], found["jobs"]["completed"]) == ("2025-12-31T22:00:00.000Z", 1)
    assert found["phases"]["total"] == {"count": 1, "mean": 100.0, "p50": 100.0, "p95": 100.0, "longest": 100.0}
    assert [one["completed"] for one in found["intervals"]] == [0, 0, 0, 1]
    assert [one["vehicle"] for one in found["vehicles"]] == ["V001", "V002"]
    assert found["vehicles"][0]["failures"] == 1
    assert found["waits"] == [{"cause": "… is occupied by …", "times": 1, "seconds": 60.0}]


@pytest.mark.parametrize("table", NAMES)
async def test_every_table_is_a_csv_file_with_a_head(client: httpx.AsyncClient, table: str) -> None:
    answer = await client.get(f"/statistics/{table}.csv")
    assert answer.headers["content-type"] == "text/csv; charset=utf-8"
    assert answer.headers["content-disposition"] == f'attachment; filename="{table}-2025-12-31.csv"'
    head, *rows = csv.reader(io.StringIO(answer.text))
    assert rows
    assert {len(row) for row in rows} == {len(head)}


async def test_text_that_a_spreadsheet_would_reckon_is_made_harmless(client: httpx.AsyncClient) -> None:
    head, row = csv.reader(io.StringIO((await client.get("/statistics/transfers.csv")).text))
    assert dict(zip(head, row, strict=True))["carrier"] == "'=1+1"
    assert dict(zip(head, row, strict=True))["carrying"] == "40.0"


async def test_a_parquet_file_is_written_where_its_writer_is_installed(client: httpx.AsyncClient) -> None:
    answer = await client.get("/statistics/transfers.parquet")
    if find_spec("pyarrow") is None:
        assert (answer.status_code, answer.json()["detail"]) == (409, "Parquet needs pyarrow.")
    else:
        assert answer.content[:4] == answer.content[-4:] == b"PAR1"


@pytest.mark.skipif(find_spec("pyarrow") is None, reason="pyarrow is not installed")
async def test_the_columns_of_a_parquet_file_are_of_the_same_kind_whatever_is_in_them(
    client: httpx.AsyncClient,
) -> None:
    parquet = import_module("pyarrow.parquet")
    for table in NAMES:
        full, empty = [
            parquet.read_table(io.BytesIO((await client.get(f"/statistics/{table}.parquet{asked}")).content)).schema
            for asked in ("", "?from=2020-01-01T00:00:00Z&to=2020-01-01T08:00:00Z")
        ]
        assert full == empty
        assert "null" not in {str(field.type) for field in full}


async def test_every_column_holds_what_its_name_says(client: httpx.AsyncClient) -> None:
    for table in NAMES:
        head, *rows = csv.reader((await client.get(f"/statistics/{table}.csv")).text.splitlines())
        for name, cell in ((name, cell) for row in rows for name, cell in zip(head, row, strict=True) if cell):
            if name in MOMENTS:
                assert datetime.fromisoformat(cell).tzinfo is not None
            elif name not in TEXTS:
                assert (int if name in COUNTS else float)(cell) >= 0


async def test_a_cause_is_spelt_in_a_file_as_everywhere_and_no_spreadsheet_takes_it_for_a_formula(
    client: httpx.AsyncClient,
) -> None:
    _, row = csv.reader(io.StringIO((await client.get("/statistics/waits.csv")).text))
    assert row[0] == "… is occupied by …"
    assert "… is occupied by …" in (await client.get("/statistics/report")).text


async def test_columns_of_a_file_have_the_names_and_units_of_the_json(client: httpx.AsyncClient) -> None:
    shown = (await client.get("/statistics")).json()["vehicles"]
    head, *rows = csv.reader(io.StringIO((await client.get("/statistics/vehicles.csv")).text))
    assert head == list(shown[0])
    for one, row in zip(shown, rows, strict=True):
        told = dict(zip(head, row, strict=True))
        assert told.pop("vehicle") == one.pop("vehicle")
        assert {name: float(cell) if cell else None for name, cell in told.items()} == one


async def test_why_lots_were_late_is_answered_by_place_by_lot_and_by_what_is_still_open(
    client: httpx.AsyncClient,
) -> None:
    asked = {"from": "2025-12-31T22:00:00Z", "to": "2026-01-01T00:00:00Z"}
    found = (await client.get("/statistics", params=asked)).json()
    assert found["places"] == [{"place": "P2", "jobs": 1, "seconds": 60.0, "cause": "… is occupied by …"}]
    (late,) = found["late"]
    assert (late["job"], late["total"], late["carrying"]) == ("LOT-1", 100.0, 40.0)
    assert (late["waited"], late["reason"]) == (15.0, "P2 is occupied by F1")
    (still,) = found["open"]
    assert (still["job"], still["seconds"], still["reason"]) == ("LOT-9", 90.0, "no vehicle is free")
    korean = (await client.get("/statistics/report", params={**asked, "lang": "ko"})).text
    assert "P2에 F1이 있음" in korean


async def test_the_report_of_a_shift_is_one_page_in_two_languages(client: httpx.AsyncClient) -> None:
    answer = await client.get("/statistics/report")
    assert answer.headers["content-type"] == "text/html; charset=utf-8"
    assert "Shift report: tiny" in answer.text
    assert "<td>V001</td>" in answer.text
    for title in ("Where jobs waited", "The latest lots", "Still open at the end"):
        assert f"<h2>{title}</h2><table>" in answer.text
    assert "http" not in answer.text
    assert "교대 보고서" in (await client.get("/statistics/report", params={"lang": "ko"})).text


async def test_what_would_take_too_long_is_refused(client: httpx.AsyncClient, controller: Scripted) -> None:
    asked: dict[str, str | int] = {"from": "2025-01-01T00:00:00Z", "interval": 60}
    assert (await client.get("/statistics", params=asked)).json()["field"] == "interval"
    controller.reader.events_between = 4_000_000
    assert (await client.get("/statistics")).json()["field"] == "from"
    assert (await client.get("/statistics/other.csv")).status_code == 422


async def test_a_long_period_is_counted_by_the_day_unless_an_interval_is_asked_for(client: httpx.AsyncClient) -> None:
    half_a_year = {"from": "2025-07-01T00:00:00Z", "to": "2026-01-01T00:00:00Z"}
    found = (await client.get("/statistics", params=half_a_year)).json()
    assert len(found["intervals"]) == 184
    refused = await client.get("/statistics", params={**half_a_year, "interval": "3600"})
    assert (refused.status_code, refused.json()["field"]) == (422, "interval")


async def test_the_report_of_a_shift_has_words_and_units_for_its_columns_and_its_causes_in_its_language() -> None:
    found = _cell("cause", "… is occupied by …", "en"), _cell("cause", "… is occupied by …", "ko")
    assert found == ("… is occupied by …", "…에 …이(가) 있음")
    assert _cell("busy_share", 0.125, "ko") == "12.5%"
    assert _cell("mtbf_hours", 1.5, "en") == "1.5"
    assert _cell("phase", "depositing", "ko") == "하역"
    assert WORDS["en"].keys() == WORDS["ko"].keys()


async def test_the_report_is_in_the_zone_that_is_asked_for_and_says_it(client: httpx.AsyncClient) -> None:
    asked = {"from": "2025-12-31T21:00:00Z", "to": "2026-01-01T00:00:00Z", "interval": "3600"}
    seoul = (await client.get("/statistics/report", params={**asked, "tz": "Asia/Seoul"})).text
    assert "2026-01-01 06:00 – 2026-01-01 09:00 Asia/Seoul, UTC+09:00" in seoul
    assert "<td>2026-01-01 07:00</td>" in seoul
    utc = (await client.get("/statistics/report", params={**asked, "tz": "UTC"})).text
    assert "2025-12-31 21:00 – 2026-01-01 00:00 UTC (" in utc


@pytest.mark.parametrize("name", ["Asia/Nowhere", "../etc/passwd", "/etc/passwd", "Asia", "", "x" * 64])
async def test_a_zone_that_there_is_not_is_refused(client: httpx.AsyncClient, name: str) -> None:
    answer = await client.get("/statistics/report", params={"tz": name})
    assert (answer.status_code, answer.json()["field"]) == (422, "tz")
    assert answer.json()["detail"] == f"There is no time zone {name!r}."
    assert answer.json()["remedy"] == "Such as Asia/Seoul, Europe/Berlin or UTC."


async def test_a_machine_without_zones_says_so_and_what_would_help(
    client: httpx.AsyncClient, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(periods, "ZoneInfo", _no_zones)
    monkeypatch.setattr(periods, "available_timezones", set)
    answer = await client.get("/statistics/report", params={"tz": "Asia/Seoul"})
    assert (answer.status_code, answer.json()["detail"]) == (409, "This machine has no time zones.")
    assert answer.json()["remedy"] == "pip install tzdata, or leave tz out."
    assert (await client.get("/statistics/report")).status_code == 200


def _no_zones(name: str) -> None:
    raise ZoneInfoNotFoundError(name)
