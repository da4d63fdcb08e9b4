"""A recorded incident in place of a controller: it can be looked at, and takes no requests."""

import asyncio
from collections.abc import Iterator, Sequence
from dataclasses import asdict, replace
from pathlib import Path

from app.domain.drive_requests import Word
from app.domain.errors import Refusal
from app.domain.ids import LinkId, VehicleId
from app.domain.records import ControllerRecord, ControllerState
from app.domain.requests import Reply, Request
from app.domain.units import Barcode, Timestamp
from app.domain.view import LineView, Topic, Update
from app.domain.webhooks import Webhook, WebhookProgress, WebhookTry
from app.fleet.closure_preview import Survey
from app.fleet.views import view_of_controller
from app.planning.routing import Route, Router
from app.planning.track import Track
from app.protocols.itsc.session import LinkQuality
from app.runtime.heat import counted
from app.runtime.hub import Hub, ReadModel
from app.runtime.incident import Incident
from app.runtime.metrics import Figures
from app.runtime.playback import Playback, Source, apply
from app.runtime.reception import Reception
from app.runtime.recording import PIECE_SECONDS, STATE_SECONDS, Change, packed
from app.runtime.versions import Versions
from app.runtime.webhooks import Targets
from app.store.ledger import SqlLedger
from app.store.playback import CHANGES, STATE, Piece, PlaybackStore
from app.store.reading import Reader

RECORDING = Refusal("not-now", "This is a recording.", "Ask the controller of the plant itself.")


class Recorded:
    """What was recorded, in a database of its own in ``directory``; ``close`` it after use. Raises StoreError."""

    recording = True
    """What it does not have, nobody has here: problems say where to look instead."""

    def __init__(self, incident: Incident, directory: Path) -> None:
        url = f"sqlite:///{directory}/replay.db"
        self.incident, self.plant = incident, incident.plant
        self.trouble = ""
        self.figures = Figures(self.plant)
        self.backlog = (0, 0)
        self.reception: Reception | None = None
        self.versions: Versions | None = None
        self.version: int | None = None
        _fill(incident, url)
        self.reader, self.playback = Reader(url), Playback(url, Source(incident.actor, incident.made))
        self.model = ReadModel(last_event=max((event["seq"] for event in incident.events), default=0))
        self.hub = Hub(self.model)
        record = ControllerRecord(ControllerState.PAUSED, "a recording")
        view = view_of_controller(self.plant.name, record, 0, incident.made, ())  # type: ignore[arg-type]
        self.hub.publish([Update(Topic.CONTROLLER, self.plant.name, replace(view, recording=True))])
        self._track = Track(self.plant)
        self._router = Router(self._track)

    def close(self) -> None:
        """Let the database go."""
        self.reader.close()
        self.playback.close()

    def ask(self, _request: Request) -> "asyncio.Future[Reply]":
        """Refuse it: nothing can be changed any more."""
        future: asyncio.Future[Reply] = asyncio.get_running_loop().create_future()
        future.set_result(RECORDING)
        return future

    def tell(self, _word: Word) -> Reply:
        """Refuse it."""
        return RECORDING

    def routes(self, start: Barcode, goal: Barcode, most: int) -> Sequence[Route]:
        """Return the quickest routes on the empty track. Raises NoRoute."""
        return self._router.alternatives(start, goal, most)

    def survey(self) -> Survey:
        """Return the empty track: closures can be tried on it."""
        return Survey(self._track, self._router.edges, self._router.seconds, (), (), ())

    def utc(self) -> Timestamp:
        """Return the end of the recording."""
        return Timestamp(self.incident.end)

    def frames(self, _vehicle: VehicleId) -> Sequence[tuple[Timestamp, str, bytes]]:
        """Return none: frames are not recorded."""
        return ()

    def link_frames(self, _link: LinkId) -> Sequence[tuple[Timestamp, str, bytes]]:
        """Return none: frames are not recorded."""
        return ()

    def links(self) -> Sequence[LineView]:
        """Return none."""
        return ()

    @property
    def targets(self) -> Targets:
        """Nowhere."""
        return Targets(())

    def webhooks(self) -> Sequence[tuple[Webhook, WebhookProgress]]:
        """Return none."""
        return ()

    async def ping_webhook(self, _number: int) -> WebhookTry | None:
        """Say that there is none."""
        return None

    def waits(self) -> dict[str, int]:
        """Return none."""
        return {}

    def named_quality(self) -> Sequence[tuple[VehicleId, LinkQuality]]:
        """Return none."""
        return ()


def _fill(incident: Incident, url: str) -> None:
    """Put an incident into a new database, as its controller would have."""
    ledger = SqlLedger(url, incident.plant.name, "hoistway replay", lambda: incident.made)
    try:
        ledger.load()
        ledger.commit(incident.history())
    finally:
        ledger.close()
    store = PlaybackStore(url)
    vehicles = incident.state.get(Topic.VEHICLES, {})
    changes = (change for change in incident.changes if change[1] == Topic.VEHICLES)
    try:
        for pieces in _pieces(incident):
            store.append(pieces)
        for heat in counted(vehicles, changes, incident.begin, incident.end):
            store.keep_heat(heat.begin, heat.end, packed(asdict(heat)))
    finally:
        store.close()


def _pieces(incident: Incident) -> Iterator[list[Piece]]:
    """Give an incident as its controller had recorded it: the whole state now and then, so that every moment is near one."""
    state = {topic: dict(objects) for topic, objects in incident.state.items()}
    whole = incident.begin
    yield [Piece(STATE, whole, whole, 1, packed(state))]
    for some in _split(incident.changes):
        begin, made = some[0][0], []
        if begin >= whole + STATE_SECONDS:
            whole = begin
            made.append(Piece(STATE, begin, begin, 1, packed(state)))
        for change in some:
            apply(state, change)
        yield [*made, Piece(CHANGES, begin, some[-1][0], len(some), packed(some))]


def _split(changes: Sequence[Change]) -> list[list[Change]]:
    """Return changes in pieces of some seconds."""
    parts: list[list[Change]] = []
    for change in changes:
        if not parts or change[0] - parts[-1][0][0] > PIECE_SECONDS:
            parts.append([])
        parts[-1].append(change)
    return parts
