"""Names on a plan, only where they cover nothing."""

from collections.abc import Iterator, Sequence
from itertools import pairwise

from app.plant.picture.shapes import Drawing, Spot, Text, text_width

CELL = 6.0
"""Pixels of the grid in which room is counted."""


class Labels:
    """Which cells of a picture are taken, and the texts that found room."""

    def __init__(self, drawing: Drawing, top: float, bottom: float) -> None:
        self._drawing, self._top, self._bottom = drawing, top, bottom
        self._taken: set[tuple[int, int]] = set()
        self._near: dict[tuple[int, int], list[Spot]] = {}
        self._known: set[tuple[Spot, str]] = set()

    def block(self, left: float, top: float, right: float, bottom: float) -> None:
        """Keep names off a box."""
        self._taken.update(_cells(left, top, right, bottom))

    def block_line(self, line: Sequence[Spot], width: float) -> None:
        """Keep names off a line."""
        r = width / 2 + 1
        for a, b in pairwise(line):
            steps = max(1, int(max(abs(b[0] - a[0]), abs(b[1] - a[1])) / CELL))
            for i in range(steps + 1):
                x, y = a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps
                self.block(x - r, y - r, x + r, y + r)

    def place(self, spot: Spot, text: str, colour: str, size: float, gap: float, apart: float = 0.0) -> bool:
        """Write a name near a spot if there is room: above, below, right, left. ``apart``: so far from others of its kind."""
        if (spot, text) in self._known or (apart and self._is_near(spot, apart)):
            return False
        wide = text_width(text, size)
        for x, y, anchor in _around(spot, gap, size):
            left = x - {"start": 0.0, "middle": wide / 2, "end": wide}[anchor]
            box = (left - 1, y - size * 0.8, left + wide + 1, y + size * 0.2)
            if self._is_free(*box):
                self._known.add((spot, text))
                self.block(*box)
                self._drawing.shapes.append(Text((x, y), text, colour, size, anchor))
                if apart:
                    self._near.setdefault((int(spot[0] / apart), int(spot[1] / apart)), []).append(spot)
                return True
        return False

    def _is_near(self, spot: Spot, apart: float) -> bool:
        column, row = int(spot[0] / apart), int(spot[1] / apart)
        others = [o for i in (-1, 0, 1) for j in (-1, 0, 1) for o in self._near.get((column + i, row + j), ())]
        return any(abs(spot[0] - x) < apart and abs(spot[1] - y) < apart for x, y in others)

    def _is_free(self, left: float, top: float, right: float, bottom: float) -> bool:
        inside = left >= 2 and right <= self._drawing.width - 2 and top >= self._top and bottom <= self._bottom
        return inside and not any(cell in self._taken for cell in _cells(left, top, right, bottom))


def _around(spot: Spot, gap: float, size: float) -> Iterator[tuple[float, float, str]]:
    x, y = spot
    yield x, y - gap - 1, "middle"
    yield x, y + gap + size * 0.85, "middle"
    yield x + gap + 2, y + size * 0.33, "start"
    yield x - gap - 2, y + size * 0.33, "end"
    yield x + gap, y - gap, "start"
    yield x - gap, y - gap, "end"
    yield x + gap, y + gap + size * 0.7, "start"
    yield x - gap, y + gap + size * 0.7, "end"


def _cells(left: float, top: float, right: float, bottom: float) -> Iterator[tuple[int, int]]:
    for column in range(int(left // CELL), int(right // CELL) + 1):
        for row in range(int(top // CELL), int(bottom // CELL) + 1):
            yield column, row
