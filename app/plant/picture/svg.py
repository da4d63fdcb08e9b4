"""A drawing as SVG."""

from xml.sax.saxutils import escape, quoteattr

from app.plant.picture.shapes import Area, Disc, Drawing, Line, Shape, Spot, Text

FONT = "system-ui, 'Segoe UI', Roboto, 'Noto Sans', 'Noto Sans KR', 'Malgun Gothic', sans-serif"


def svg(drawing: Drawing) -> str:
    """Return the picture as SVG: plain shapes and text, no script, nothing from outside."""
    w, h = drawing.width, drawing.height
    head = f'<svg xmlns="http://www.w3.org/2000/svg" width="{w}" height="{h}" viewBox="0 0 {w} {h}" role="img">'
    style = f"<style>text{{font-family:{FONT}}}polyline{{fill:none;stroke-linecap:round;stroke-linejoin:round}}</style>"
    paper = f'<rect width="{w}" height="{h}" fill="{drawing.background}"/>'
    lines = [
        head,
        f"<title>{escape(_text(drawing.title))}</title>",
        style,
        paper,
        *map(_shape, drawing.shapes),
        "</svg>",
    ]
    return "\n".join(lines) + "\n"


def _number(value: float) -> str:
    return f"{value:.1f}".removesuffix(".0")


def _spots(spots: tuple[Spot, ...]) -> str:
    return " ".join(f"{_number(x)},{_number(y)}" for x, y in spots)


def _text(text: str) -> str:
    """Return a text without what XML 1.0 cannot hold."""
    return "".join(letter if letter.isprintable() else "\ufffd" for letter in text)


def _edge(shape: Area | Disc) -> str:
    return f' stroke="{shape.edge}" stroke-width="{_number(shape.width)}"' if shape.edge else ""


def _shape(shape: Shape) -> str:
    match shape:
        case Line():
            width = _number(shape.width)
            return f'<polyline points="{_spots(shape.spots)}" stroke="{shape.colour}" stroke-width="{width}"/>'
        case Area():
            return f'<polygon points="{_spots(shape.spots)}" fill="{shape.colour}"{_edge(shape)}/>'
        case Disc():
            x, y = map(_number, shape.middle)
            return f'<circle cx="{x}" cy="{y}" r="{_number(shape.radius)}" fill="{shape.colour}"{_edge(shape)}/>'
        case Text():
            x, y = map(_number, shape.spot)
            anchor = f" text-anchor={quoteattr(shape.anchor)}" if shape.anchor != "start" else ""
            bold = ' font-weight="600"' if shape.bold else ""
            size = _number(shape.size)
            look = f'font-size="{size}" fill="{shape.colour}"{anchor}{bold}'
            return f'<text x="{x}" y="{y}" {look}>{escape(_text(shape.text))}</text>'
