"""The buffers of a track as TRAFFIC section 1 counts them: chains of barcodes between merges and diverges."""

from collections import Counter, defaultdict
from collections.abc import Sequence
from typing import TypeAlias

from app.domain.layout import Plant
from app.domain.units import Barcode

Chain: TypeAlias = tuple[Barcode, ...]


def degrees(plant: Plant) -> tuple[Counter[Barcode], Counter[Barcode]]:
    """Return how many edges lead to each barcode, and how many from it."""
    return Counter(edge.end for edge in plant.edges), Counter(edge.start for edge in plant.edges)


def chains(plant: Plant) -> list[Chain]:
    """Return every maximal chain, each barcode in exactly one.

    A chain begins at a barcode that other than one edge leads to, or that follows a barcode with other than one way on. A
    ring without any such barcode begins at the first of it in the plant's order.
    """
    into, out = degrees(plant)
    after: defaultdict[Barcode, list[Barcode]] = defaultdict(list)
    before: dict[Barcode, Barcode] = {}
    for edge in plant.edges:
        after[edge.start].append(edge.end)
        before[edge.end] = edge.start
    order = [point.barcode for point in plant.points]
    starts = {b: None for b in order if into[b] != 1 or out[before[b]] != 1}
    found = [_follow(b, after, starts) for b in starts]
    seen = {barcode for chain in found for barcode in chain}
    for barcode in order:
        if barcode not in seen:
            found.append(_follow(barcode, after, {**starts, barcode: None}))
            seen.update(found[-1])
    return found


def _follow(start: Barcode, after: dict[Barcode, list[Barcode]], starts: dict[Barcode, None]) -> Chain:
    chain = [start]
    ways: Sequence[Barcode] = after[start]
    while len(ways) == 1 and ways[0] not in starts:
        chain.append(ways[0])
        ways = after[ways[0]]
    return tuple(chain)
