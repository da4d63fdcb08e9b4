"""How the lines to vehicles and devices are doing: by wire, and line by line."""

from collections import defaultdict
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from prometheus_client.metrics_core import Metric

from app.domain.ids import VehicleId
from app.domain.view import LineView, Topic, VehicleView
from app.protocols.itsc.session import LinkQuality
from app.runtime.hub import ReadModel
from app.runtime.metrics.shapes import counters, gauges

HOISTS = "itsc"


@dataclass(frozen=True, slots=True)
class Quality:
    """The figures of one line, under the same names for every wire; 0 where a wire does not have one."""

    line: str
    wire: str
    up: bool
    connections: int
    frames_in: int
    frames_out: int
    garbled: int
    retries: int
    silences: int
    duplicates: int
    round_trip: float | None


COUNTS: tuple[tuple[str, str, Callable[[Quality], float]], ...] = (
    ("connections", "How often lines came up.", lambda one: one.connections),
    ("garbled", "Bytes that were no packet, and packets that did not fit.", lambda one: one.garbled),
    ("retries", "Packets that were sent again.", lambda one: one.retries),
    ("silences", "Questions that got no answer in time.", lambda one: one.silences),
    ("duplicates_refused", "Packets that came a second time, and were not taken again.", lambda one: one.duplicates),
)


def qualities(
    model: ReadModel, hoists: Sequence[tuple[VehicleId, LinkQuality]], links: Sequence[LineView]
) -> list[Quality]:
    """Return the figures of every line."""
    up = {view.id: view.link.up for view in model.all(Topic.VEHICLES) if isinstance(view, VehicleView)}
    found = [_of_hoist(str(name), quality, up=up.get(str(name), False)) for name, quality in hoists]
    return found + [_of_link(link) for link in links]


def _of_hoist(name: str, quality: LinkQuality, *, up: bool) -> Quality:
    last = quality.round_trip_last
    return Quality(
        name,
        HOISTS,
        up,
        quality.connections,
        quality.frames_in,
        quality.frames_out,
        quality.garbled,
        quality.resends,
        quality.lost_polls,
        quality.duplicates,
        None if last is None else last / 1000,
    )


def _of_link(link: LineView) -> Quality:
    figures = link.figures
    return Quality(
        link.id,
        link.wire,
        link.up,
        figures.get("connections", 0),
        figures.get("frames_in", figures.get("answered", 0)),
        figures.get("frames_out", figures.get("sent", 0)),
        figures.get("garbled", 0) + figures.get("strays", 0),
        figures.get("resends", 0) + figures.get("naks", 0),
        figures.get("timeouts", 0),
        0,
        None,
    )


def by_wire(lines: Sequence[Quality]) -> Iterator[Metric]:
    """Give the figures of all lines together, by wire."""
    wires = sorted({one.wire for one in lines})
    of = {wire: [one for one in lines if one.wire == wire] for wire in wires}
    yield gauges("links", "Lines.", ["wire"], {(wire,): len(of[wire]) for wire in wires})
    yield gauges("links_up", "Lines that are up.", ["wire"], {(w,): sum(one.up for one in of[w]) for w in wires})
    frames = {(wire, "in"): float(sum(one.frames_in for one in of[wire])) for wire in wires}
    frames |= {(wire, "out"): float(sum(one.frames_out for one in of[wire])) for wire in wires}
    yield counters("link_frames", "Packets on lines.", ["wire", "direction"], frames)
    for name, what, figure in COUNTS:
        yield counters(f"link_{name}", what, ["wire"], {(wire,): sum(map(figure, of[wire])) for wire in wires})
    trips: dict[str, list[float]] = defaultdict(list)
    for one in lines:
        if one.round_trip is not None:
            trips[one.wire].append(one.round_trip)
    shown = {(wire, "mean"): sum(seen) / len(seen) for wire, seen in trips.items()}
    shown |= {(wire, "worst"): max(seen) for wire, seen in trips.items()}
    yield gauges("link_round_trip_seconds", "Round trip of the last poll, over all lines.", ["wire", "of"], shown)


def by_line(lines: Sequence[Quality]) -> Iterator[Metric]:
    """Give the figures of each line; as many series as the plant has lines, times nine."""
    keys = [(one.line, one.wire) for one in lines]
    labels = ["line", "wire"]
    pairs = list(zip(keys, lines, strict=True))
    yield gauges("line_up", "1 while the line is up.", labels, {key: one.up for key, one in pairs})
    frames = {(*key, "in"): float(one.frames_in) for key, one in pairs}
    frames |= {(*key, "out"): float(one.frames_out) for key, one in pairs}
    yield counters("line_frames", "Packets on the line.", [*labels, "direction"], frames)
    for name, what, figure in COUNTS:
        yield counters(f"line_{name}", what, labels, {key: figure(one) for key, one in pairs})
    trips = {key: one.round_trip for key, one in pairs if one.round_trip is not None}
    yield gauges("line_round_trip_seconds", "Round trip of the last poll.", labels, trips)
