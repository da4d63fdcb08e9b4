"""Path elements of a MOVE or XMOVE, in the words of the business (PROTOCOLS 1.6)."""

from dataclasses import dataclass

from app.domain.layout import StopAction
from app.domain.units import Barcode, Millimetres, Percent

MAX_SEQ = 65_535


@dataclass(frozen=True, slots=True)
class PathElement:
    """A barcode to pass, and how to drive on from it.

    ``seq`` rises by one per element from 0. ``sensor`` 0-15 and ``speed`` govern the way on from this barcode (I56).
    ``to_next`` is the distance to the next element's barcode in mm, 0 for the last (slides dialect, I9).
    """

    barcode: Barcode
    seq: int
    action: StopAction
    speed: Percent
    sensor: int
    to_next: Millimetres
