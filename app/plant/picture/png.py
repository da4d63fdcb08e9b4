"""A drawing as PNG, painted with Pillow: it is small, well kept, and brings a font of its own, so that no system needs one."""

import io
from functools import cache
from typing import Any

from app.plant.picture.shapes import Area, Disc, Drawing, Line, Shape, Spot, Text

FINER = 3
"""Painted so many times larger and then reduced: that smooths edges."""
MOST_PIXELS = 60_000_000
"""Largest painting before it is reduced. Our choice: 180 MB."""
WIDE_FONTS = (
    "NotoSansCJK-Regular.ttc",
    "NotoSansKR-Regular.otf",
    "NanumGothic.ttf",
    "malgun.ttf",
    "AppleSDGothicNeo.ttc",
)
"""Fonts of systems that have Korean letters, the first of which is taken; Pillow's own has none."""
_ANCHORS = {"start": "ls", "middle": "ms", "end": "rs"}


def png(drawing: Drawing) -> bytes:
    """Return the picture as PNG."""
    from PIL import Image, ImageDraw

    finer = FINER
    while finer > 1 and drawing.width * drawing.height * finer**2 > MOST_PIXELS:
        finer -= 1
    size = (drawing.width * finer, drawing.height * finer)
    image = Image.new("RGB", size, drawing.background)
    brush = ImageDraw.Draw(image)
    for shape in drawing.shapes:
        _paint(brush, shape, finer)
    if finer > 1:
        image = image.resize((drawing.width, drawing.height), Image.Resampling.LANCZOS)
    made = io.BytesIO()
    image.save(made, "PNG", optimize=True)
    return made.getvalue()


def _paint(brush: Any, shape: Shape, finer: int) -> None:
    match shape:
        case Line():
            _line(brush, shape, finer)
        case Area():
            spots = _scaled(shape.spots, finer)
            brush.polygon(spots, fill=shape.colour)
            if shape.edge:
                width = max(1, round(shape.width * finer))
                brush.line([*spots, spots[0], spots[1]], fill=shape.edge, width=width, joint="curve")
        case Disc():
            x, y, r = shape.middle[0] * finer, shape.middle[1] * finer, shape.radius * finer
            width = max(1, round(shape.width * finer)) if shape.edge else 0
            brush.ellipse((x - r, y - r, x + r, y + r), fill=shape.colour, outline=shape.edge or None, width=width)
        case Text():
            spot = (shape.spot[0] * finer, shape.spot[1] * finer)
            font = _font(round(shape.size * finer), wide=not shape.text.isascii())
            heavier = finer // 2 if shape.bold else 0
            text = "".join(letter if letter.isprintable() else "?" for letter in shape.text)
            brush.text(
                spot, text, fill=shape.colour, font=font, anchor=_ANCHORS[shape.anchor], stroke_width=heavier,
                stroke_fill=shape.colour,
            )  # fmt: skip


def _scaled(spots: tuple[Spot, ...], finer: int) -> list[Spot]:
    return [(x * finer, y * finer) for x, y in spots]


def _line(brush: Any, shape: Line, finer: int) -> None:
    spots, width = _scaled(shape.spots, finer), max(1, round(shape.width * finer))
    brush.line(spots, fill=shape.colour, width=width, joint="curve")
    if width > 2:
        r = width / 2 - 0.5
        for x, y in (spots[0], spots[-1]):
            brush.ellipse((x - r, y - r, x + r, y + r), fill=shape.colour)


def has_wide_letters() -> bool:
    """Whether Korean can be written on a PNG here: a font of the system has to have its letters."""
    return _wide_font(12) is not None


@cache
def _font(size: int, *, wide: bool) -> Any:
    from PIL import ImageFont

    return (_wide_font(size) if wide else None) or ImageFont.load_default(size)


def _wide_font(size: int) -> Any:
    from PIL import ImageFont

    for name in WIDE_FONTS:
        try:
            return ImageFont.truetype(name, size)
        except OSError:
            continue
    return None
