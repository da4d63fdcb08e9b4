"""Pictures of plants."""

import io
import re
from dataclasses import replace
from itertools import combinations
from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from PIL import Image

from app.domain.layout import Plant, Point
from app.domain.units import Barcode, Millimetres
from app.plant import read
from app.plant.fab import SIZES, generate
from app.plant.picture import Look, compose, png, svg
from app.plant.picture.shapes import Area, Drawing, Line, Spot, Text, text_width
from app.plant.picture.track import arrows, chains_of

PLANTS = Path(__file__).parents[3] / "plants"


def plant(name: str) -> Plant:
    found, _ = read((PLANTS / f"{name}.yaml").read_text(encoding="utf-8"), name)
    return found


def texts(drawing: Drawing) -> list[Text]:
    return [shape for shape in drawing.shapes if isinstance(shape, Text)]


@pytest.mark.parametrize("name", ["small", "hall", "demo"])
def test_a_picture_is_well_formed_and_loads_nothing(name: str) -> None:
    text = svg(compose(plant(name)))
    root = ET.fromstring(text)
    assert root.tag == "{http://www.w3.org/2000/svg}svg"
    assert not re.search(r"href|url\(|<script|<image", text)


def test_every_station_and_barcode_of_a_small_plant_is_named() -> None:
    given = plant("small")
    named = {text.text for text in texts(compose(given))}
    assert {station.id for station in given.stations} <= named
    assert len(named & {point.barcode for point in given.points}) >= 8


@pytest.mark.parametrize("name", ["small", "hall", "demo"])
def test_vehicles_are_named_where_they_stand_at_first(name: str) -> None:
    given = plant(name)
    drawing = compose(given, Look(width=3000))
    standing = {vehicle.id for vehicle in given.vehicles if vehicle.start is not None}
    assert standing
    assert standing <= {text.text for text in texts(drawing)}
    assert not standing & {text.text for text in texts(compose(given, Look(labels=False)))}


def test_the_legend_names_what_there_is_and_nothing_else() -> None:
    small, hall = ({text.text for text in texts(compose(plant(name)))} for name in ("small", "hall"))
    assert {"port", "side buffer, left", "zone", "parking", "one-way track"} <= small
    assert {"AGV buffer", "door", "charger", "two-way track"} <= hall
    assert not {"door", "charger", "two-way track"} & small


@pytest.mark.parametrize("given", [plant("demo"), generate(SIZES["1k"], 1).plant], ids=["demo", "fab"])
def test_no_name_covers_another(given: Plant) -> None:
    boxes = []
    for text in texts(compose(given)):
        if text.text == "P":
            continue
        wide = text_width(text.text, text.size)
        left = text.spot[0] - {"start": 0.0, "middle": wide / 2, "end": wide}[text.anchor]
        boxes.append((left, text.spot[1] - text.size * 0.7, left + wide, text.spot[1]))
    assert len(boxes) > 10
    for one, other in combinations(boxes, 2):
        assert one[2] <= other[0] or other[2] <= one[0] or one[3] <= other[1] or other[3] <= one[1]


def test_a_whole_fab_is_thinned_out() -> None:
    given = generate(SIZES["1k"], 1).plant
    drawing = compose(given, Look(width=900))
    assert 3 < len(texts(drawing)) < len(given.points) / 2


def test_everything_lies_on_the_paper() -> None:
    drawing = compose(plant("demo"), Look(width=900, dark=True))
    for shape in drawing.shapes:
        spots: tuple[Spot, ...] = shape.spots if isinstance(shape, Line | Area) else ()
        for x, y in spots:
            assert 0 <= x <= drawing.width
            assert 0 <= y <= drawing.height


def test_the_scale_bar_is_as_long_as_it_says() -> None:
    given = plant("small")
    drawing = compose(given, Look(labels=False))
    bar = next(text for text in texts(drawing) if re.fullmatch(r"[0-9.]+ m", text.text))
    metres = float(bar.text.removesuffix(" m"))
    lines = [s for s in drawing.shapes if isinstance(s, Line) and s.width == 2.0 and s.spots[0][1] == s.spots[1][1]]
    long = lines[-1].spots[1][0] - lines[-1].spots[0][0]
    across = [x for s in drawing.shapes if isinstance(s, Line) and s.width == 4.0 for x, _ in s.spots]
    assert long / metres == pytest.approx((max(across) - min(across)) / 10, rel=0.02)


def test_arrows_point_the_way_that_is_driven() -> None:
    ((tip, *tail),) = list(arrows([(0.0, 0.0), (100.0, 0.0)], 95.0, 10.0))
    assert tip[0] > max(x for x, _ in tail)
    assert list(arrows([(0.0, 0.0), (5.0, 0.0)], 95.0, 10.0)) == []


def test_chains_hold_every_piece_of_track_once() -> None:
    for given in (plant("hall"), plant("demo")):
        drawn = [pair for chain in chains_of(given) for pair in zip(chain.barcodes, chain.barcodes[1:], strict=False)]
        both = [p for c in chains_of(given) if c.both for p in zip(c.barcodes, c.barcodes[1:], strict=False)]
        assert len(set(drawn)) == len(drawn)
        assert {*drawn, *((b, a) for a, b in both)} == {(edge.start, edge.end) for edge in given.edges}


def test_a_png_has_the_size_of_the_drawing_and_its_colours() -> None:
    drawing = compose(plant("hall"), Look(width=800))
    image = Image.open(io.BytesIO(png(drawing)))
    assert image.size == (drawing.width, drawing.height)
    assert image.getpixel((2, 2)) == (255, 255, 255)
    assert len(image.getcolors(1 << 24) or ()) > 50


def test_strange_names_break_no_picture() -> None:
    given = replace(plant("small"), name='</text><script>"한글"\x07')
    text = svg(compose(given))
    ET.fromstring(text)
    assert "<script>" not in text
    assert png(compose(given, Look(width=640)))


def test_one_lone_barcode_has_a_picture() -> None:
    lone = Plant("lone", (Point(Barcode("1"), Millimetres(5), Millimetres(5)),), (), (), ())
    ET.fromstring(svg(compose(lone)))
