"""Barcode lists: CSV and workbooks, in English and Korean, as people write them."""

import io
import re
import zipfile
from dataclasses import replace
from pathlib import Path

import pytest

from app.domain.layout import PulseSet, StationKind
from app.domain.units import Pulses
from app.plant import read
from app.plant.exchange.importing import Imported, Wishes, import_layout
from app.plant.exchange.report import Kind, UnreadableLayout
from app.plant.exchange.settle import Options
from app.plant.exchange.sheets import letters
from app.plant.exchange.units import Reading
from tests.plant.exchange.layouts import RING, imported, said, workbook

EXAMPLES = Path(__file__).parents[3] / "examples" / "layouts"


def edges(made: Imported) -> dict[tuple[str, str], int]:
    return {(edge.start, edge.end): edge.length for edge in made.plant.edges}


def test_a_plain_list_becomes_a_plant_that_passes_the_check() -> None:
    made = imported(RING, "ring.csv")
    plant, findings = read(made.text, "ring")
    assert made.is_sound
    assert [f.message for f in findings] == ["the plant has no vehicle"]
    assert plant == made.plant
    assert edges(made) == {(str(i), str(i % 6 + 1)): 1000 for i in range(1, 7)}
    assert [(s.id, s.kind, s.barcode) for s in plant.stations] == [
        ("P1", StationKind.PORT, "2"),
        ("P2", StationKind.PORT, "4"),
        ("B1", StationKind.SBFL, "5"),
    ]


def test_the_korean_example_says_the_same_as_the_english_one() -> None:
    english = imported((EXAMPLES / "barcodes.csv").read_bytes())
    korean = imported((EXAMPLES / "barcodes-ko.csv").read_bytes())
    assert korean.report.source == "CSV, CP949, semicolon"
    assert korean.plant == english.plant
    assert english.is_sound
    assert korean.is_sound


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "utf-16", "utf-16-le", "cp949"])
def test_the_encoding_is_found_out(encoding: str) -> None:
    text = "바코드\tX좌표\tY좌표\t다음\t포트\n1\t0\t0\t2\tP1\n2\t1000\t0\t1\tP2\n"
    made = imported(text.encode(encoding))
    assert edges(made) == {("1", "2"): 1000, ("2", "1"): 1000}
    assert [station.id for station in made.plant.stations] == ["P1", "P2"]


def test_decimal_commas_and_metres_are_read() -> None:
    made = imported("barcode;x [m];y [m];next;length [m]\n1;0,0;1,5;2;2,25\n2;2,25;1,5;1;\n")
    assert [(p.x, p.y) for p in made.plant.points] == [(0, 1500), (2250, 1500)]
    assert edges(made) == {("1", "2"): 2250, ("2", "1"): 2250}


def test_thousands_are_read() -> None:
    made = imported('barcode,x,y,next\n1,"1,000",0,2\n2,"12,000",0,1\n')
    assert [p.x for p in made.plant.points] == [1000, 12000]


def test_metres_without_a_unit_are_assumed_and_said() -> None:
    made = imported("barcode,x,y,next\n1,0,0,2\n2,1.5,0,1\n")
    assert edges(made)["1", "2"] == 1500
    assert any("positions are in m:" in note for note in said(made, Kind.ASSUMED))


def test_a_person_names_the_unit_and_where_y_grows() -> None:
    wishes = Wishes(reading=Reading(unit="cm", y_up=True))
    made = imported("barcode,x,y,next\n1,0,10,2\n2,100,10,1\n", wishes=wishes)
    assert [(p.x, p.y) for p in made.plant.points] == [(0, -100), (1000, -100)]


def test_a_row_of_units_below_the_names_counts() -> None:
    made = imported("barcode,x,y,next\n,(m),(m),\n1,0,0,2\n2,3,0,1\n")
    assert edges(made)["1", "2"] == 3000


def test_titles_above_the_names_of_columns_are_passed_over() -> None:
    made = imported("Rail list rev 7,,,\n,,,\nno.,barcode,x,y,next\n1,11,0,0,12\n2,12,1000,0,11\n")
    assert [p.barcode for p in made.plant.points] == ["11", "12"]


def test_several_next_barcodes_stand_in_one_cell_or_in_columns_of_their_own() -> None:
    one = imported("barcode,x,y,next,length\n1,0,0,2/3,1000/1500\n2,1000,0,1,\n3,0,1000,1,\n")
    two = imported("barcode,x,y,next1,next2\n1,0,0,2,3\n2,1000,0,1,\n3,0,1000,1,\n")
    assert edges(one) == {("1", "2"): 1000, ("1", "3"): 1500, ("2", "1"): 1000, ("3", "1"): 1000}
    assert set(edges(two)) == set(edges(one))


def test_a_barcode_may_have_several_rows_for_its_ways_on() -> None:
    made = imported("barcode,x,y,next\n1,0,0,2\n1,0,0,3\n2,1000,0,1\n3,0,1000,1\n")
    assert made.is_sound
    assert {end for start, end in edges(made) if start == "1"} == {"2", "3"}


def test_nodes_and_edges_come_in_two_files() -> None:
    nodes = b"barcode,x,y,station\n1,0,0,P1\n2,1000,0,\n3,2000,0,P2\n"
    track = "시작,끝,길이(mm),속도(%),통행방향\n1,2,1000,50,양방향\n2,3,1100,100,two-way\n".encode()
    made = import_layout([("nodes.csv", nodes), ("edges.csv", track)], Wishes())
    assert edges(made) == {("1", "2"): 1000, ("2", "1"): 1000, ("2", "3"): 1100, ("3", "2"): 1100}
    assert {edge.speed for edge in made.plant.edges if edge.length == 1000} == {50}


def test_a_workbook_has_sheets_for_everything_and_numbers_stay_barcodes() -> None:
    book = workbook(
        {
            "바코드": [["바코드", "X", "Y", "대기"], [1001, 0, 0, ""], [1002, 1000.0, 0, "예"], [1003, 1000, 900, ""]],
            "구간": [["시작", "끝", "거리"], [1001, 1002, 1000], [1002, 1003, 900], [1003, 1001, 1345]],
            "포트": [["포트명", "바코드", "구분"], ["P1", 1001, "포트"], ["L1", 1003, "좌버퍼"]],
            "차량": [["호기", "장치번호", "IP주소", "포트번호", "시작"], ["V1", 7, "10.0.0.7", 9000, 1002]],
            "메모": [["아무 말"], ["무엇"]],
        }
    )
    made = imported(book, "site.xlsx")
    assert made.is_sound
    assert edges(made) == {("1001", "1002"): 1000, ("1002", "1003"): 900, ("1003", "1001"): 1345}
    assert [(s.id, s.kind.value, s.barcode) for s in made.plant.stations] == [
        ("P1", "port", "1001"),
        ("L1", "sbfl", "1003"),
    ]
    (vehicle,) = made.plant.vehicles
    assert (vehicle.id, vehicle.dev_id, vehicle.host, vehicle.port, vehicle.start) == (
        "V1",
        7,
        "10.0.0.7",
        9000,
        "1002",
    )
    assert [p.barcode for p in made.plant.points if p.park] == ["1002"]
    assert said(made, Kind.LEFT_OUT) == ["sheet 메모: no row names columns that are known"]


def test_without_a_next_column_the_order_of_rows_is_asked_for_not_guessed() -> None:
    text = "barcode,x,y\n1,0,0\n2,1000,0\n3,500,800\n"
    made = imported(text)
    assert not made.is_sound
    assert "no column says which barcode comes next" in said(made, Kind.WRONG)[0]
    ring = imported(text, wishes=Wishes(reading=Reading(in_order=True, loop=True)))
    assert list(edges(ring)) == [("1", "2"), ("2", "3"), ("3", "1")]


def test_speeds_in_mm_per_second_become_percent_of_the_vehicles_own() -> None:
    made = imported("barcode,x,y,next,speed (m/s)\n1,0,0,2,2\n2,5000,0,1,1\n")
    assert [edge.speed for edge in made.plant.edges] == [100, 50]
    slower = imported(
        "barcode,x,y,next,speed (m/s)\n1,0,0,2,2\n2,5000,0,1,1\n", wishes=Wishes(options=Options(velocity=4000))
    )
    assert [edge.speed for edge in slower.plant.edges] == [50, 25]


def test_target_pulses_come_along() -> None:
    made = imported("barcode,x,y,next,port,shft,rota,lift\n1,0,0,2,P1,1200,-300,41000\n2,1000,0,1,P2,5,,\n")
    assert [s.dest for s in made.plant.stations] == [PulseSet(Pulses(1200), Pulses(-300), Pulses(41000)), None]
    assert said(made, Kind.WRONG) == ["row 3: only some of shft, rota and lift are given: left out"]


def test_what_is_wrong_is_said_with_its_row() -> None:
    text = "barcode,x,y,next\n1,0,0,2\n2,1000,0,99\n2,1000,500,1\n,5,5,\n4,abc,0,\n5,nan,0,\n6,1,,\n7,0,0,7\n"
    made = imported(text)
    assert not made.is_sound
    told = "\n".join(said(made, Kind.WRONG))
    assert "row 3: leads to 99, which is nowhere given" in told
    assert "row 4: 2 is given twice, at different places: kept is the first (row 3)" in told
    assert "row 5: the row has no barcode" in told
    assert "row 6 ('abc'), row 7 ('nan'): column B (x): no number" in told
    assert "row 8: the barcode has no position" in told
    assert "row 9: leads from a mark to itself" in "\n".join(said(made, Kind.LEFT_OUT))


def test_a_mistake_in_a_hundred_rows_is_one_note_with_what_stands_in_each() -> None:
    rows = "".join(f"{n},{n * 1000},{'?' * (n > 1)}{n},{n % 100 + 1}\n" for n in range(1, 101))
    made = imported("barcode,x,y,next\n" + rows + "101,0,5000,101\n")
    note = next(note for note in made.report.notes if "column C (y)" in note.what)
    assert (note.what, note.times, note.where[0]) == ("column C (y): no number", 99, "row 3 ('?2')")
    assert str(note) == "row 3 ('?2'), row 4 ('?3'), row 5 ('?4') and 96 more: column C (y): no number"
    assert note.remedy == "write a number, such as 12500 or 12.5"


@pytest.mark.parametrize("given", ["inf", "-Infinity", "nan", "1e999", "１２", "0x10", "--5"])
@pytest.mark.parametrize("column", ["x", "length"])
def test_what_is_no_finite_number_is_no_position_and_no_length(column: str, given: str) -> None:
    row = {"x": "1000", "length": "1000"} | {column: given}
    made = imported(f"barcode,x,y,next,length\n1,0,0,2,1000\n2,{row['x']},0,1,{row['length']}\n3,0,900,1,\n")
    where = {"x": "column B (x)", "length": "column E (length)"}[column]
    assert f"row 3 ({given!r}): {where}: no number" in said(made, Kind.WRONG)
    assert not made.is_sound


def test_a_barcode_that_reads_like_a_number_stays_a_name() -> None:
    made = imported("barcode,x,y,next\ninf,0,0,1e5\n1e5,1000,0,inf\n")
    assert [point.barcode for point in made.plant.points] == ["inf", "1e5"]
    plant, _ = read(made.text, "plant.yaml")
    assert [point.barcode for point in plant.points] == ["inf", "1e5"]


def test_columns_are_named_as_spreadsheets_name_them() -> None:
    assert [letters(index) for index in (0, 25, 26, 51, 52, 701, 702)] == ["A", "Z", "AA", "AZ", "BA", "ZZ", "AAA"]


@pytest.mark.parametrize("encoding", ["utf-32", "utf-32-le", "utf-32-be", "utf-16-le", "utf-16-be"])
def test_wide_letters_are_found_out(encoding: str) -> None:
    made = imported("바코드,X,Y,다음\n1,0,0,2\n2,1000,0,1\n".encode(encoding))
    assert edges(made) == {("1", "2"): 1000, ("2", "1"): 1000}


def test_inches_in_a_cell_are_no_quotation_mark_left_open() -> None:
    made = imported('barcode,x,y,next,display\n1,0,0,2,12" port\n2,1000,0,1,"two\nlines"\n')
    assert len(made.plant.points) == 2


def test_two_barcodes_at_one_place_need_a_length_between_them() -> None:
    made = imported("barcode,x,y,next\n1,0,0,2\n2,0,0,1\n")
    assert "both ends lie at one place and no length is given" in said(made, Kind.WRONG)[0]
    assert imported("barcode,x,y,next,length\n1,0,0,2,700\n2,0,0,1,700\n").is_sound


def test_columns_that_nobody_knows_are_named() -> None:
    made = imported("barcode,x,y,next,Bemerkung\n1,0,0,2,\n2,1000,0,1,\n")
    assert said(made, Kind.LEFT_OUT) == ["Bemerkung: a column that is not understood"]


def test_text_barcodes_bring_their_dialect() -> None:
    made = imported("barcode,x,y,next\nA1,0,0,A2\nA2,5000,0,A1\n", wishes=Wishes(options=Options(vehicles=1)))
    assert made.plant.vehicles[0].dialect == "text-barcodes"
    assert made.is_sound


def test_barcodes_too_long_for_the_wire_get_numbers_that_are_written_beside_them() -> None:
    made = imported(
        "barcode,x,y,next\nRAIL-WEST-0000017,0,0,RAIL-WEST-0000018\nRAIL-WEST-0000018,5000,0,RAIL-WEST-0000017\n"
    )
    assert [p.barcode for p in made.plant.points] == ["17", "18"]
    assert "  17: [0, 0]  # RAIL-WEST-0000017\n" in made.text


def test_a_persons_own_barcodes_go_first() -> None:
    wishes = Wishes(options=Options(names={"1": "501", "8": "502"}))
    made = imported(RING, wishes=wishes)
    assert [p.barcode for p in made.plant.points][:2] == ["501", "2"]
    assert said(made, Kind.WRONG) == ["names: 8: the layout has no such mark"]


def test_station_names_that_no_plant_takes_are_written_otherwise() -> None:
    text = RING.replace("P1", "에치 1호기").replace("P2", "A-VERY-LONG-NAME-OF-A-PORT")
    made = imported(text)
    first, second, _ = made.plant.stations
    assert (first.id, first.barcode) == ("ST-1", "2")
    assert len(second.display) <= 16
    (lost,) = [what for what in said(made, Kind.WRONG) if "에치" in what]
    assert "에치 1호기 → ST-1" in lost
    assert re.search(r"  ST-1: {.*}  # 에치 1호기\n", made.text), "the whole name is kept"
    latin = imported(RING.replace("P1", "ETCH 1"))
    assert latin.is_sound
    assert latin.plant.stations[0].id == "ETCH-1"
    assert "  # ETCH 1\n" in latin.text


@pytest.mark.parametrize(
    ("data", "message"),
    [
        (b"", "the file is empty"),
        (b"\x89PNG\r\n\x1a\n" + bytes(range(256)) * 4 + b"\0\0\1", "this is no text"),
        (b"a,b,c\n1,2,3\n", "no row names columns that are known"),
        (b"barcode,next\n1,2\n", "no column is understood as x, y"),
        (b'barcode,x,y,next\n1,"0,0,2\n' + b"x" * 140_000, "row 4: a cell is longer than 131072 characters"),
        (b"PK\x03\x04" + b"\1" * 300, "is a damaged workbook"),
        (b"\xd0\xcf\x11\xe0" + b"\1" * 600, "is no workbook that can be read"),
        (b"barcodes:\n  1: [0, 0]\ntrack:\n", "this is a plant file already"),
        (b"barcode,x,y,next\n1,a,0,2\n2,b,0,1\n", r"position in it: row 2 \('a'\): column B \(x\): no number"),
        (
            b"barcode,x,y,next\n1,1e12,0,2\n2,2e12,0,1\n",
            "position in it: row 2: the position is more than 1000 km away",
        ),
        (b'barcode,x,y,next\n1,0,0,"2\n2,1000,0,1\n', "row 2: a quotation mark is left open"),
        (b"barcode,x,y\n1,,\n", "there is no mark with a position in it: row 2: the barcode has no position"),
    ],
)
def test_what_is_no_list_is_refused_in_a_sentence(data: bytes, message: str) -> None:
    with pytest.raises(UnreadableLayout, match=message):
        imported(data)


def test_a_cell_far_from_all_others_does_not_fill_the_memory() -> None:
    book = io.BytesIO(workbook({"track": [["barcode", "x", "y", "next"], [1, 0, 0, 2]]}))
    far = io.BytesIO()
    with zipfile.ZipFile(book) as parts, zipfile.ZipFile(far, "w") as made:
        for part in parts.namelist():
            data = parts.read(part)
            if part.startswith("xl/worksheets/"):
                data = data.replace(
                    b"</sheetData>", b'<row r="1048576"><c r="XFD1048576"><v>1</v></c></row></sheetData>'
                )
                assert b"XFD" in data
            made.writestr(part, data)
    with pytest.raises(UnreadableLayout, match="a sheet reaches to row 1048576, column 16384"):
        imported(far.getvalue(), "far.xlsx")


def test_an_unknown_encoding_is_named() -> None:
    with pytest.raises(UnreadableLayout, match="unknown encoding 'klingon'"):
        imported(RING, wishes=replace(Wishes(), encoding="klingon"))


def test_simulated_vehicles_start_apart_from_one_another() -> None:
    made = imported((EXAMPLES / "barcodes.csv").read_bytes(), wishes=Wishes(options=Options(vehicles=6)))
    assert made.is_sound
    assert len({vehicle.start for vehicle in made.plant.vehicles}) == 6
    assert any("an address at this machine" in note for note in said(made, Kind.NEEDED))


def test_carriers_stand_where_the_list_says() -> None:
    text = "barcode,x,y,next,station,FOUP\n1,0,0,2,P1,F1\n2,1000,0,3,P2,F1\n3,2000,0,1,P3,bad name\n"
    made = imported(text)
    assert made.plant.carriers == (("F1", "P1"),)
    assert [note.partition(":")[0] for note in said(made, Kind.WRONG)] == ["row 3", "row 4"]


def test_a_carrier_of_a_station_that_is_left_out_stands_nowhere_and_is_named() -> None:
    text = "barcode,x,y,next,station,type,carrier\n1,0,0,2,P1,port,\n2,2000,0,3,,,\n3,4000,0,1,P1,port,FOUP-X\n"
    made = imported(text, "ring.csv")
    assert made.plant.carriers == ()
    assert [line for line in said(made, Kind.WRONG) if "and carrier FOUP-X with it" in line]
