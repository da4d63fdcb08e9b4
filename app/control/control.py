"""The controller without its shell: bytes, requests and time in; transactions, bytes, updates and replies out.

Rule kept here: what a decision needs to survive is committed *before* its command reaches a session, its reply a caller,
its update a screen. A session's own packets (ACK, STATUS) need no commit and leave at once.
"""

from collections import deque
from collections.abc import Iterable, Sequence
from dataclasses import dataclass

from app.control.agv import Agv
from app.control.lines import VehicleLine
from app.control.links import DriveLine, HallLink
from app.domain.devices import DeviceEvent, DeviceNotSent, DeviceRequest
from app.domain.drive import DriveEvent, DriveFailed, DriveRequest, Jog
from app.domain.drive_requests import Word
from app.domain.events import Event, NotSent
from app.domain.ids import CmdIds, LinkId, VehicleId
from app.domain.layout import LinkSpec, Plant, VehicleKind, Wire
from app.domain.links import LinkSend
from app.domain.ports import Endpoint
from app.domain.records import Kept, Record
from app.domain.requests import Reply, Request
from app.domain.units import Seconds, Timestamp
from app.domain.versions import Leaving
from app.domain.view import LineView, LinkView, Topic, Update, View
from app.domain.webhooks import Webhook, WebhookProgress, WebhookTry
from app.fleet import Effects, Fleet
from app.fleet.vehicle import VehicleNow
from app.fleet.waits import waits
from app.planning.tables import Tables, Task
from app.planning.ways import Ways
from app.plant import dialect_of
from app.protocols.itsc.session import LinkQuality, Timing


@dataclass(frozen=True, slots=True)
class Transaction:
    """Records to be made durable together. Numbers rise by one; commit in that order. There may be none to write."""

    number: int
    records: tuple[Record, ...]


class Control:
    """The whole controller of one plant, in one thread.

    After every input the owner takes ``transactions``, writes what ``dirty`` endpoints have to send, delivers ``updates``,
    ``replies`` and ``replan``, and arranges for ``tick`` at ``deadline`` and each endpoint's own. ``utc`` is UTC at ``now``.
    """

    def __init__(
        self,
        plant: Plant,
        kept: Kept,
        now: Seconds,
        utc: Timestamp,
        timing: Timing = Timing(),  # noqa: B008  (frozen)
    ) -> None:
        self._cmd_ids = CmdIds(kept.epoch)
        self._barcodes = frozenset(point.barcode for point in plant.points)
        self.fleet = Fleet(plant, kept, self._cmd_ids, now, utc, self._link)
        self._lines: dict[VehicleId, VehicleLine] = {}
        for spec in plant.hoists:
            dialect = dialect_of(plant, spec.dialect)
            self._lines[spec.id] = VehicleLine(self._told, spec, dialect, self._cmd_ids, timing, self._barcodes)
        ways = Ways(self.fleet.books.track)
        agvs = (spec for spec in plant.vehicles if spec.kind is VehicleKind.AGV and spec.link is not None)
        self._agvs: dict[VehicleId, Agv] = {spec.id: Agv(spec.id, ways, self._cmd_ids) for spec in agvs}
        self._on_link = {spec.id: spec.link for spec in plant.vehicles if spec.link is not None}
        self._halls = {link.id: self._hall(plant, link) for link in plant.links if link.wire is not Wire.HI}
        drives = {link.id: DriveLine(plant, link, self._drives_told) for link in plant.links if link.wire is Wire.HI}
        self._links: dict[LinkId, HallLink | DriveLine] = {**self._halls, **drives}
        self._ends: dict[str, Endpoint] = {str(name): end for name, end in (*self._lines.items(), *self._links.items())}
        self._dirty: dict[str, None] = {}
        self._tickets = 0
        self._number = 0
        self._new: list[Transaction] = []
        self._uncommitted: deque[tuple[int, Effects]] = deque()
        self._updates: list[Update] = []
        self._replies: list[tuple[int, Reply]] = []
        self._model: dict[Topic, dict[str, View]] = {topic: {} for topic in Topic}
        self._decide()

    # -- lines --------------------------------------------------------------------------------------------------------

    @property
    def lines(self) -> tuple[str, ...]:
        """The names of all lines: hoists by their own, other devices by their link's."""
        return tuple(self._ends)

    def endpoint(self, line: str) -> Endpoint:
        """Return our end of a line."""
        return self._ends[line]

    def dirty(self) -> list[str]:
        """Return and forget the lines to whose endpoint something was given to send other than by an input to it.

        After an input to an endpoint itself its owner asks it for bytes anyway.
        """
        names, self._dirty = list(self._dirty), {}
        return names

    def _hall(self, plant: Plant, link: LinkSpec) -> HallLink:
        agvs = [self._agvs[spec.id] for spec in plant.agvs_on(link.id)]
        return HallLink(plant, link, self._devices_told, agvs, self._told)

    def frames(self, vehicle: VehicleId) -> list[tuple[Timestamp, str, bytes]]:
        """Return the last packets on a vehicle's line, oldest first: when (UTC), ``in`` or ``out``, bytes.

        An AGV's line is its link: the packets of all devices on it.
        """
        session = self._halls[self._on_link[vehicle]] if vehicle in self._agvs else self._lines[vehicle]
        return [(self.fleet.books.utc_at(when), way, packet) for when, way, packet in session.last_frames]

    def link_frames(self, link: LinkId) -> list[tuple[Timestamp, str, bytes]]:
        """Return the last packets on a link, oldest first: when (UTC), ``in`` or ``out``, bytes."""
        utc_at = self.fleet.books.utc_at
        return [(utc_at(when), way, packet) for when, way, packet in self._links[link].last_frames]

    def links(self) -> list[LineView]:
        """Return how all links are doing."""
        return [self._line_view(name, link) for name, link in self._links.items()]

    def _line_view(self, name: LinkId, link: HallLink | DriveLine) -> LineView:
        books, state = self.fleet.books, link.connection
        spec = books.plant.link(name)
        assert spec is not None
        plant = books.plant
        devices: list[str] = [agv.id for agv in plant.agvs_on(name)] + [drive.id for drive in plant.drives_on(name)]
        devices += [door.id for door in plant.doors if door.link == name]
        devices += [buffer.id for buffer in plant.buffers if buffer.link == name]
        return LineView(
            id=name,
            wire=spec.wire.value,
            address=spec.serial.device if spec.serial else f"{spec.host}:{spec.port}",
            up=state.up,
            since=None if state.since is None else books.utc_at(state.since),
            reason=state.reason,
            devices=tuple(devices),
            figures=link.counts,
        )

    def line_quality(self) -> list[LinkQuality]:
        """Return the figures of every hoist's line."""
        return [line.link for line in self._lines.values()]

    def named_quality(self) -> list[tuple[VehicleId, LinkQuality]]:
        """Return the figures of every hoist's line, by the hoist's name."""
        return [(name, line.link) for name, line in self._lines.items()]

    def waits(self) -> dict[str, int]:
        """Return how many vehicles wait for what, by cause."""
        return waits(self.fleet.books)

    def hint(self, vehicle: VehicleId) -> str:
        """Return what looks wrong with the vehicle's dialect, empty if nothing does."""
        return self._lines[vehicle].hint if vehicle in self._lines else ""

    def _link(self, vehicle: VehicleId) -> LinkView:
        now, session = self.fleet.books.vehicles[vehicle], self._lines.get(vehicle)
        if session is None:
            return self._shared_link(now)
        quality = session.link
        return LinkView(
            up=now.linked,
            since=self.fleet.books.utc_at(now.link_since),
            reason=session.hint or now.link_reason,
            frames_in=quality.frames_in,
            frames_out=quality.frames_out,
            garbled=quality.garbled,
            resends=quality.resends,
            duplicates=quality.duplicates,
            round_trip_ms=None if quality.round_trip_last is None else round(quality.round_trip_last, 2),
        )

    def _shared_link(self, vehicle: VehicleNow) -> LinkView:
        """Return the quality of the line that an AGV shares with others."""
        link = None if vehicle.spec.link is None else self._links[vehicle.spec.link]
        utc_at = self.fleet.books.utc_at
        if not isinstance(link, HallLink):
            return LinkView(up=vehicle.linked, since=utc_at(vehicle.link_since), reason=vehicle.link_reason)
        quality = link.link
        return LinkView(
            up=vehicle.linked,
            since=utc_at(vehicle.link_since),
            reason=vehicle.link_reason,
            frames_in=quality.frames_in,
            frames_out=quality.frames_out,
            garbled=quality.garbled,
            resends=quality.resends,
        )

    def _told(self, events: Iterable[Event], now: Seconds) -> None:
        """A session tells of its vehicle after an input."""
        for event in events:
            self.fleet.handle(event, now)
        self._decide()

    def _devices_told(self, events: Iterable[DeviceEvent], now: Seconds) -> None:
        """An ENIG link tells of its devices after an input."""
        for event in events:
            self.fleet.handle_device(event, now)
        self._decide()

    def _drives_told(self, events: Iterable[DriveEvent], now: Seconds) -> None:
        """A drive line tells after an input."""
        for event in events:
            self.fleet.handle_drive(event, now)
        self._decide()

    # -- people, hosts and time ---------------------------------------------------------------------------------------

    def ask(self, request: Request, now: Seconds) -> int:
        """Take a request; its reply comes under the returned ticket, once it is durable."""
        self._tickets += 1
        self.fleet.ask(request, self._tickets, now)
        self._decide()
        return self._tickets

    def tell(self, word: Word, now: Seconds) -> Reply:
        """Take a word that changes nothing that is kept: it takes effect at once, and is answered at once."""
        reply, orders = self.fleet.tell(word, now)
        for send in orders:
            self._links[send.link].order(send.order, now)
            self._dirty[send.link] = None
        self._decide()
        return reply

    def leave(self, leaving: Leaving | None) -> None:
        """From now on no new job may need what goes with the plant that is to come; None: everything stays."""
        self.fleet.books.leaving = leaving

    @property
    def deadline(self) -> Seconds:
        """When ``tick`` wants to be called next."""
        return self.fleet.deadline

    def tick(self, now: Seconds) -> None:
        """The fleet's deadline has passed."""
        self.fleet.tick(now)
        self._decide()

    def stranger(self, reason: str, now: Seconds) -> None:
        """Somebody who wanted to be a vehicle was refused by the shell, and why."""
        self.fleet.tick(now)
        self.fleet.watch.refused(reason)
        self._decide()

    def unreachable(self, line: str, reason: str, now: Seconds) -> None:
        """The shell could not connect a line, and why: what was never heard on it says so."""
        self.fleet.tick(now)
        link = self._links.get(LinkId(line))
        if link is not None:
            link.connection.failed(reason)
        vehicles = self.fleet.books.vehicles
        on_it = [line] if link is None else [agv.id for agv in self.fleet.books.plant.agvs_on(LinkId(line))]
        for name in on_it:
            self.fleet.recovery.unreachable(vehicles[VehicleId(name)], reason)
        self._decide()

    # -- webhooks -----------------------------------------------------------------------------------------------------

    def webhooks(self) -> list[tuple[Webhook, WebhookProgress]]:
        """Return all webhooks, and how far each has been told."""
        known = self.fleet.webhooks
        return [(webhook, known.progress[number]) for number, webhook in known.all.items()]

    def webhook_told(self, progress: WebhookProgress, tries: Sequence[WebhookTry], failed: str = "") -> None:
        """The shell has told a webhook of events, or tried to; ``failed``: it gives up, and why."""
        self.fleet.webhooks.told(progress, tries, failed)
        self._decide()

    # -- routes -------------------------------------------------------------------------------------------------------

    def replan(self) -> Task | None:
        """Return the routing tables that are wanted, once: to be computed beside the controller and given to ``replanned``.

        The owner asks after every input; None: those that there are will do, or are being computed.
        """
        return self.fleet.books.router.replan()

    def replanned(self, tables: Tables, now: Seconds) -> None:
        """Tables that were wanted have been computed."""
        self.fleet.replanned(tables, now)
        self._decide()

    # -- keep before you tell -----------------------------------------------------------------------------------------

    def _decide(self) -> None:
        """Make a transaction of what the fleet has decided."""
        effects = self.fleet.take()
        if effects.empty:
            return
        self._number += 1
        self._uncommitted.append((self._number, effects))
        self._new.append(Transaction(self._number, tuple(effects.records)))

    def transactions(self) -> list[Transaction]:
        """Return what is to be made durable since the last call, in order."""
        new, self._new = self._new, []
        return new

    def committed(self, number: int, now: Seconds) -> None:
        """All transactions up to this one are durable: carry their effects out."""
        while self._uncommitted and self._uncommitted[0][0] <= number:
            _, effects = self._uncommitted.popleft()
            self._carry_out(effects, now)
        for name in list(self._dirty):
            if name in self._lines:
                self._tell(self._lines[VehicleId(name)], now)
            else:
                self._links[LinkId(name)].tell(now)
        self._decide()

    def _carry_out(self, effects: Effects, now: Seconds) -> None:
        for name, receipt in effects.stored:
            self._lines[name].stored(receipt, now)
            self._dirty[name] = None
        for send in effects.sends:
            self._dirty[self._on_link.get(send.vehicle, send.vehicle)] = None
            if objection := self.fleet.objection(send):
                self.fleet.handle(NotSent(send.vehicle, send.cmd_id, send.command, objection), now)
            elif send.vehicle in self._agvs:
                self._agvs[send.vehicle].send(send, now)
            else:
                self._lines[send.vehicle].send(send, now)
        for link_send in effects.link_sends:
            self._send_to_link(link_send, now)
        for name in effects.polls:
            if name in self._lines:  # AGVs report by themselves
                self._lines[name].ask(now)
                self._dirty[name] = None
        self._publish(effects.updates)
        self._replies += effects.replies

    def _send_to_link(self, send: LinkSend, now: Seconds) -> None:
        """Give a link what it has to send, unless something came between."""
        order = send.order
        self._dirty[send.link] = None
        objection = self.fleet.link_objection(send)
        if objection and isinstance(order, DriveRequest | Jog):
            self.fleet.handle_drive(DriveFailed(order.drive, order.id, objection), now)
        elif objection and isinstance(order, DeviceRequest):
            self.fleet.handle_device(DeviceNotSent(order.device, order.id, objection), now)
        else:
            self._links[send.link].order(order, now)

    def _tell(self, line: VehicleLine, now: Seconds) -> None:
        """Hand what a session said while sending (NotSent) to the fleet."""
        for event in line.events():
            self.fleet.handle(event, now)

    def _publish(self, updates: Iterable[Update]) -> None:
        for update in updates:
            self._updates.append(update)
            if update.topic is Topic.EVENTS:
                continue
            if update.value is None:
                self._model[update.topic].pop(update.key, None)
            else:
                self._model[update.topic][update.key] = update.value

    def updates(self) -> list[Update]:
        """Return and forget the changes of the read model that are durable now."""
        updates, self._updates = self._updates, []
        return updates

    def replies(self) -> list[tuple[int, Reply]]:
        """Return and forget the replies that are durable now, by ticket."""
        replies, self._replies = self._replies, []
        return replies

    def snapshot(self) -> list[Update]:
        """Return the whole read model as published so far."""
        return [Update(topic, key, value) for topic, objects in self._model.items() for key, value in objects.items()]
