"""What a picture consists of, in pixels from the top left corner; later shapes cover earlier ones."""

from dataclasses import dataclass, field
from typing import TypeAlias

Spot: TypeAlias = tuple[float, float]


@dataclass(frozen=True, slots=True)
class Line:
    """A line through spots, with round joints."""

    spots: tuple[Spot, ...]
    colour: str
    width: float


@dataclass(frozen=True, slots=True)
class Area:
    """A filled polygon, with an edge where ``edge`` is a colour."""

    spots: tuple[Spot, ...]
    colour: str
    edge: str = ""
    width: float = 1.0


@dataclass(frozen=True, slots=True)
class Disc:
    """A filled circle, with an edge where ``edge`` is a colour."""

    middle: Spot
    radius: float
    colour: str
    edge: str = ""
    width: float = 1.0


@dataclass(frozen=True, slots=True)
class Text:
    """A line of text; ``spot`` is the left, middle or right end of its base line."""

    spot: Spot
    text: str
    colour: str
    size: float
    anchor: str = "start"
    bold: bool = False


Shape: TypeAlias = Line | Area | Disc | Text


@dataclass(slots=True)
class Drawing:
    """A picture of ``width`` by ``height`` pixels."""

    width: int
    height: int
    background: str
    title: str = ""
    shapes: list[Shape] = field(default_factory=list)


def text_width(text: str, size: float) -> float:
    """Return about how wide a text is: Latin letters 0.56 of their size, wide ones the whole."""
    return sum(size if ord(letter) > 0x2E7F else size * 0.56 for letter in text)
