"""Where a simulated AGV is on its tape, and how it gets on (PROTOCOLS 5.3)."""

from collections.abc import Callable
from dataclasses import dataclass

from app.domain.layout import Edge
from app.domain.units import Barcode
from app.protocols.enig.simulator.tape import Tape, flipped

After = Callable[[float, Callable[[], None]], Callable[[], None]]
"""Enters a future act and gives what prevents it."""


@dataclass(slots=True)
class Piece:
    """A piece of tape under the AGV: how far along it, and whether it is driven with the AGV's back ahead."""

    edge: Edge
    done: float = 0.0
    backward: bool = False

    @property
    def left(self) -> float:
        """Millimetres to its end."""
        return self.edge.length - self.done

    def turned(self) -> "Piece":
        """Return the same place, to be driven the other way."""
        return Piece(flipped(self.edge), self.left, not self.backward)


@dataclass(slots=True)
class _Leg:
    began: float
    speed: float
    cancel: Callable[[], None]


class Drive:
    """Wheels: drive one piece of tape at a time at a constant speed.

    ``at`` is the tag last passed, ``came_from`` the one before it. ``piece`` lies under the AGV; None while it stands on ``at``.
    """

    def __init__(self, tape: Tape, start: Barcode, after: After) -> None:
        self.at = start
        self.came_from: Barcode | None = None
        self.piece: Piece | None = None
        self._tape = tape
        self._after = after
        self._leg: _Leg | None = None

    def place(self, now: float) -> tuple[Barcode, float, Barcode | None]:
        """Return the tag behind, millimetres from it, and the tag ahead; None standing on the first."""
        here = self._here(now)
        return (self.at, 0.0, None) if here is None else (here.edge.start, here.done, here.edge.end)

    def go(self, piece: Piece, speed: float, now: float, reached: Callable[[Barcode], None]) -> None:
        """Drive a piece to its end at so many mm/s, less what the piece limits, and say which tag is reached."""
        self.halt(now)
        self.piece = piece
        pace = speed * piece.edge.speed / 100

        def arrive() -> None:
            self._leg = self.piece = None
            self.at = piece.edge.end
            self.came_from = None if piece.backward else piece.edge.start
            reached(self.at)

        self._leg = _Leg(now, pace, self._after(piece.left / pace, arrive))

    def halt(self, now: float) -> None:
        """Stop where the AGV is."""
        if self._leg is not None:
            self.piece = self._here(now)
            self._leg.cancel()
            self._leg = None

    def put(self, tag: Barcode) -> None:
        """Put the AGV on a tag by hand."""
        self.piece, self.came_from, self.at = None, None, tag

    def route(self, goal: Barcode, now: float) -> tuple[Piece, ...] | None:
        """Return the shortest way along allowed tape from where the AGV is; empty on the goal, None if there is none."""
        here = self._here(now)
        if here is None:
            way = self._tape.route(self.at, goal)
            return None if way is None else tuple(Piece(edge) for edge in way)
        ways = []
        for first in (here, here.turned()):
            rest = self._tape.route(first.edge.end, goal)
            if rest is not None and self._tape.edge(first.edge.start, first.edge.end) is not None:
                ways.append((Piece(first.edge, first.done), *(Piece(edge) for edge in rest)))
        return min(ways, key=length_of, default=None)

    def onward(self, now: float, *, forward: bool, steering: int) -> Piece | None:
        """Return the piece that comes next along the tape, forwards or backwards; None at its end."""
        here = self._here(now)
        if here is not None:
            return here.turned() if here.backward is forward else here
        tape, at, came_from = self._tape, self.at, self.came_from
        edge = tape.onward(at, came_from, steering) if forward else tape.backward(at, came_from)
        return None if edge is None else Piece(edge, backward=not forward)

    def _here(self, now: float) -> Piece | None:
        piece, leg = self.piece, self._leg
        if piece is None or leg is None:
            return piece
        done = min(piece.done + (now - leg.began) * leg.speed, float(piece.edge.length))
        return Piece(piece.edge, done, piece.backward)


def length_of(way: tuple[Piece, ...]) -> float:
    """Return how far it is to the end of a way, mm."""
    return sum(piece.left for piece in way)
