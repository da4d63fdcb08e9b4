"""Files of taught values: safe for spreadsheets, and every mistake named by its line."""

import csv
import io
from dataclasses import replace

import pytest

from app.api.problems import Problem
from app.api.taught_tables import MAX_ROWS, exported, from_csv, from_json
from app.domain.ids import Actor, StationId
from app.domain.pulses import PartialPulses
from app.domain.records import StationDest
from app.domain.teaching import Side
from app.domain.units import Pulses
from tests.api.scripted import NOW, PULSES

DEST = StationDest(StationId("P1"), 3, PULSES, Actor("kim"), "teaching", NOW, reason="new tool")


def read(text: str) -> list[tuple[int, str, object]]:
    return [(row.line, row.name, row.pulses) for row in from_csv(Side.DEST, text.encode()).rows]


def wrong(text: str) -> list[tuple[int, str]]:
    return [(fate.line, fate.detail) for fate in from_csv(Side.DEST, text.encode()).wrong]


def test_what_is_exported_can_be_imported_again() -> None:
    partial = replace(DEST, station=StationId("P2"), pulses=PartialPulses(lift=Pulses(-5)))
    text = exported(Side.DEST, [("P1", DEST), ("P2", partial)])
    assert text.splitlines()[0] == "station,version,shft,rota,lift,actor,source,at,reason"
    found = from_csv(Side.DEST, text.encode())
    assert not found.wrong
    assert [(row.name, row.version, row.pulses) for row in found.rows] == [("P1", 3, PULSES), ("P2", 3, partial.pulses)]


@pytest.mark.parametrize("evil", ["=1+1", "+82", "-x", "@SUM(A1)", "\tx"])
def test_no_cell_of_an_export_is_a_formula(evil: str) -> None:
    text = exported(Side.DEST, [(evil, replace(DEST, actor=Actor(evil), reason=evil))])
    (_, row) = csv.reader(io.StringIO(text))
    assert row[0] == row[5] == row[8] == f"'{evil}"
    assert row[2] == "1"


def test_negative_pulses_stay_numbers() -> None:
    text = exported(Side.DEST, [("P1", replace(DEST, pulses=PartialPulses(shft=Pulses(-1520))))])
    assert text.splitlines()[1].startswith("P1,3,-1520,,,kim,")


def test_a_file_may_have_fewer_columns_in_any_order_a_mark_and_empty_lines() -> None:
    assert read("\ufefflift,Station\r\n 5 ,P1\r\n\r\n-6,P2\r\n") == [
        (2, "P1", PartialPulses(lift=Pulses(5))),
        (4, "P2", PartialPulses(lift=Pulses(-6))),
    ]


def test_a_name_that_was_made_safe_comes_back_as_it_was() -> None:
    assert read("station,lift\n'-A,5\n")[0][1] == "-A"


@pytest.mark.parametrize(
    ("row", "said"),
    [
        ("P1,x,2,3", "shft: 'x' is no whole number"),
        ("P1,1.5,2,3", "shft: '1.5' is no whole number"),
        ("P1,1,2,3000000000", "lift: Input should be less than or equal to 2147483647"),
        (",1,2,3", "station: String should have at least 1 character"),
        ("P1,\u0663,2,3", "shft: '\u0663' is no whole number"),
        ("P 1,1,2,3", "station: holds a character that is not allowed here"),
        ("P1,1,2,3,4", "there is no column 'too many' here"),
    ],
)
def test_a_wrong_row_is_named_by_its_line(row: str, said: str) -> None:
    ((line, detail),) = wrong(f"station,shft,rota,lift\nP0,1,2,3\n{row}\n")
    assert line == 3
    assert detail.startswith(said)


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (b"", "no column station"),
        (b"\xff\xfe", "not UTF-8"),
        (b"station;lift\nP1;5\n", "no column station"),
        (b"station,lfit\nP1,5\n", "did you mean 'lift'?"),
        (b"station,lift,lift\nP1,5,6\n", "stands twice"),
        (b'station,lift\n"P1,5\n', "is no CSV"),
    ],
)
def test_what_is_no_such_file_is_refused_as_a_whole(body: bytes, said: str) -> None:
    with pytest.raises(Problem) as caught:
        from_csv(Side.DEST, body)
    assert said in caught.value.detail
    assert caught.value.remedy or caught.value.field


def test_a_file_is_bounded() -> None:
    with pytest.raises(Problem) as caught:
        from_csv(Side.DEST, b"station,lift\n" + b"P1,5\n" * (MAX_ROWS + 1))
    assert caught.value.code == "too-large"


def test_json_is_read_as_exported_and_strictly() -> None:
    rows = {"items": [{"station": "P1", "lift": 5, "basis": [], "at": "x"}, {"station": "P2", "lift": "5"}]}
    found = from_json(Side.DEST, rows)
    assert [(row.line, row.name) for row in found.rows] == [(1, "P1"), (2, "P2")]
    odd = from_json(
        Side.DEST, [{"station": "P1", "lift": 5.5}, {"station": 7}, {"station": "P1", "lfit": 5}, {"lift": True}]
    )
    assert [fate.line for fate in odd.wrong] == [1, 2, 3, 4]
    for nothing in (None, {}, {"items": 5}, [5], "x"):
        with pytest.raises(Problem):
            from_json(Side.DEST, nothing)
