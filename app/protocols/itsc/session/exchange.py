"""The sending half of a session: polls, commands with their ACK and resends, and the life of the link (PROTOCOLS 6.1)."""

from collections.abc import Iterator

from app.domain.commands import Move, Send, Xmove
from app.domain.errors import EncodeError
from app.domain.events import Acknowledged, Event, Garbled, LinkDown, NotSent, Unanswered, Unknown
from app.domain.ids import CmdIds
from app.domain.layout import VehicleSpec
from app.domain.units import Seconds
from app.domain.vehicle import VehicleStatus
from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.framing import Decoder
from app.protocols.itsc.messages import Code, Toward
from app.protocols.itsc.session.link import FRAMES_KEPT, Kept, Link, LinkQuality, Polls, Seen, Tape, Taped, Way
from app.protocols.itsc.session.orders import Order, Orders
from app.protocols.itsc.session.quick import (
    ABOVE_ALL_IDS,
    NOTHING_BELOW,
    RING_KEPT,
    ack_crc,
    ack_of,
    codec_of,
    content_of,
    entries,
    new_ring,
    packet_of,
    quick_crc,
)
from app.protocols.itsc.session.refusals import Refused, refusal
from app.protocols.itsc.session.requests import code_of, frame_of
from app.protocols.itsc.session.timing import Timing


class _Quick:
    """What the quick way touches, side by side in memory: slots stand in the order of the alphabet, a base's first."""

    __slots__ = (
        "_after_ack", "_at", "_ceiling", "_crc_init", "_heard", "_laps", "_name", "_newest", "_ordered", "_pass_on", "_read",
        "_ring", "_told", "status", "status_at",
    )  # fmt: skip


class Exchange(_Quick):
    """What goes out to one vehicle, and what is still expected back. See Session, which adds what comes in."""

    __slots__ = (
        "_codec", "_connections", "_decoder", "_duplicates", "_events", "_flush_at", "_frames", "_frames_in", "_frames_out",
        "_garbled", "_has_quick", "_ids", "_last_move", "_link", "_orders", "_out", "_polls", "_prefix", "_quicks_before",
        "_resends", "_seen", "deadline", "dialect", "timing", "vehicle", "wants_close",
    )  # fmt: skip

    def __init__(self, vehicle: VehicleSpec, dialect: Dialect, cmd_ids: CmdIds, timing: Timing) -> None:
        self.vehicle, self.dialect, self.timing = vehicle, dialect, timing
        self.status: VehicleStatus | None = None
        self.status_at: Seconds | None = None
        self.deadline: Seconds | None = None
        """When ``tick`` is due; may be too early by what has been received since, never too late."""
        self.wants_close = False
        """Whether the line is silent and should be closed."""
        self._frames = Tape()
        self._ids = cmd_ids
        self._codec = codec_of(dialect)
        self._decoder = Decoder(self._codec, Toward.CONTROLLER)
        init = quick_crc(dialect)
        self._has_quick, self._crc_init = init is not None, init or 0
        self._after_ack = ack_crc(self._crc_init)
        self._events: list[Event] = []
        self._out = b""
        self._link = Link.DOWN
        self._heard = Seconds(0.0)
        self._flush_at: Seconds | None = None
        self._prefix = b"\x05" + vehicle.dev_id.to_bytes(4, "big")
        self._newest = self._before_first
        self._ceiling = NOTHING_BELOW
        self._ring, self._at, self._laps, self._quicks_before = new_ring(), 0, 0, 0
        self._orders, self._polls, self._seen = Orders(), Polls(), Seen()
        self._ordered = False
        self._last_move = 0
        self._connections = self._frames_in = self._frames_out = self._garbled = self._resends = self._duplicates = 0

    @property
    def up(self) -> bool:
        """Whether the vehicle is connected and has answered STATUS since."""
        return self._link is Link.UP

    @property
    def _quicks(self) -> int:
        """How many packets have come the quick way."""
        return self._laps * RING_KEPT + self._at

    @property
    def _quick(self) -> bool:
        """Whether there is a quick way now."""
        return self._ceiling is not NOTHING_BELOW

    @property
    def _before_first(self) -> bytes:
        """What, as bytes are compared, comes before every event of the vehicle: they have the top bit of the CMD_ID set (I23)."""
        return self._prefix + b"\x80"

    def _known(self, packet: bytes) -> bool:
        """Whether this packet has been taken before on this connection (I23)."""
        if packet in self._seen:
            return True
        content, here = content_of(packet), self._quicks - self._quicks_before
        if not content or not self._before_first < packet <= self._newest:
            return False
        return any(content == kept for _, _, kept in entries(self._ring, self._quicks, here))

    def _remember(self, packet: bytes) -> None:
        self._seen.add(packet)
        self._newest = max(self._newest, packet)

    @property
    def last_frames(self) -> list[tuple[Seconds, Way, bytes]]:
        """The last packets of the line, oldest first: when, ``in`` or ``out``, bytes."""
        quick: list[Kept] = []
        for number, when, content in entries(self._ring, self._quicks, FRAMES_KEPT):
            packet = packet_of(self._prefix, content, self._crc_init)
            quick += [(number + 1, when, "in", packet), (number + 1, when, "out", ack_of(packet, self._after_ack))]
        # A packet of the long way carries the number of quick ones before it, so it stands before the next of those.
        frames = sorted([*quick, *self._taped()], key=lambda frame: frame[0])
        return [frame[1:] for frame in frames[-FRAMES_KEPT:]]

    def _taped(self) -> Iterator[Kept]:
        for number, when, kind, content in self._frames.packets(self._quicks):
            if kind is Taped.ASKED:
                yield number, when, "out", self._codec.bare(self.vehicle.dev_id, int.from_bytes(content), Code.STATUS)
            elif kind is Taped.ANSWERED:
                packet = packet_of(self._prefix, content, self._crc_init)
                yield number, when, "in", packet
                yield number, when, "out", ack_of(packet, self._after_ack)
            else:
                yield number, when, "in" if kind is Taped.IN else "out", content

    @property
    def link(self) -> LinkQuality:
        """Figures of the line."""
        return LinkQuality(
            connections=self._connections,
            frames_in=self._frames_in + self._quicks,
            frames_out=self._frames_out + self._quicks,
            garbled=self._garbled,
            resends=self._resends,
            duplicates=self._duplicates,
            polls=self._polls.sent,
            lost_polls=self._polls.lost,
            round_trip_last=self._polls.round_trip_last,
            round_trip_mean=self._polls.round_trip_mean,
        )

    def events(self) -> list[Event]:
        """Return and forget what has happened, in order."""
        events, self._events = self._events, []
        return events

    def outgoing(self) -> bytes:
        """Return and forget the bytes to send."""
        out, self._out = self._out, b""
        return out

    def send(self, send: Send, now: Seconds) -> None:
        """Send a command whose intent is durable, or say why not (NotSent: nothing has been sent)."""
        code = code_of(send.command)
        refused = self._refusal(send, code, now)
        packet = b""
        if refused is None:
            try:
                packet = self._codec.encode(frame_of(send, self.vehicle.dev_id, self.dialect))
            except EncodeError as wrong:
                refused = Refused(wrong.message, wrong.remedy)
        if refused is not None:
            self._events.append(NotSent(self.vehicle.id, send.cmd_id, send.command, refused.reason, refused.remedy))
            return
        self._open(send, code, packet, now)
        self._plan()

    def _refusal(self, send: Send, code: Code, now: Seconds) -> Refused | None:
        known = None
        if self.status is not None and self.status_at is not None:
            known = (self.status.condition.mode, Seconds(now - self.status_at))
        in_the_way = self._orders.in_the_way(code)
        return refusal(self.vehicle, send.command, code, self._link, known, self.timing.stale, in_the_way)

    def _open(self, send: Send, code: Code, packet: bytes, now: Seconds) -> None:
        timing, command = self.timing, send.command
        asks = code is Code.STATUS
        self._orders.open[send.cmd_id] = Order(
            send.cmd_id,
            command,
            code,
            packet,
            sent_at=now,
            due=Seconds(now + (timing.status if asks else timing.ack)),
            resends=0 if asks else timing.resends,
            window=timing.answer(command),
        )
        if isinstance(command, Move):
            self._last_move = send.cmd_id
        elif isinstance(command, Xmove) and (move := self._orders.move()) is not None:
            move.window = timing.drive(command.planned)
            if move.acked:
                move.due = max(move.due, Seconds(now + move.window))
        self._emit(packet, now)

    def _emit(self, packet: bytes, now: Seconds) -> None:
        self._out += packet
        self._frames_out += 1
        self._frames.append(self._quicks, now, Taped.OUT, packet)

    def ask(self, now: Seconds) -> None:
        """Ask STATUS now instead of at the next turn; does nothing while the vehicle is not up."""
        if self.up:
            self._poll(now)
            self._plan()

    def _poll(self, now: Seconds) -> None:
        cmd_id = self._ids.next()
        self._polls.asked(cmd_id, now, self.timing.status)
        self._out += self._codec.bare(self.vehicle.dev_id, cmd_id, Code.STATUS)
        self._frames_out += 1
        self._frames.append(self._quicks, now, Taped.ASKED, cmd_id.to_bytes(8))

    def _tick_orders(self, now: Seconds) -> None:
        for order in self._orders.overdue(now):
            if order.acked or order.code is Code.STATUS:
                self._give_up(order, Unknown.NO_ANSWER)
            else:
                self._send_again(order, now)

    def _send_again(self, order: Order, now: Seconds) -> None:
        if not order.resends:
            self._give_up(order, Unknown.NO_ACK)
            return
        order.resends -= 1
        order.due = Seconds(now + self.timing.ack)
        self._resends += 1
        self._emit(order.packet, now)

    def _give_up(self, order: Order, why: Unknown) -> None:
        self._orders.give_up(order)
        self._events.append(Unanswered(self.vehicle.id, order.cmd_id, order.command, why))

    def _acknowledge(self, order: Order, now: Seconds) -> None:
        if not order.acked:
            order.acked = True
            order.due = Seconds(now + order.window)
            self._events.append(Acknowledged(self.vehicle.id, order.cmd_id))

    def _progress(self, *, rising: bool, now: Seconds) -> None:
        """Give the MOVE under way its time again: its SEQ rises, or it pauses (PROTOCOLS 6.1, I54)."""
        move = self._orders.move()
        if rising and move is not None and move.acked:
            move.due = max(move.due, Seconds(now + move.window))

    def _complain(self, reason: str, detail: str) -> None:
        self._garbled += 1
        self._events.append(Garbled(self.vehicle.id, reason, detail))

    def _lose(self, reason: str) -> None:
        for order in self._orders.forget():
            self._events.append(Unanswered(self.vehicle.id, order.cmd_id, order.command, Unknown.LINK_LOST))
        if self._link is Link.UP:
            self._events.append(LinkDown(self.vehicle.id, reason))
        self._decoder.flush()
        self._seen.clear()
        self._newest, self._quicks_before = self._before_first, self._quicks
        self._polls.forget()
        self._out = b""
        self._flush_at = None
        self._last_move = 0

    def _plan(self) -> None:
        self._ordered = bool(self._orders.open)
        if not self._link.alive:
            self.deadline, self._ceiling = None, NOTHING_BELOW
            return
        quick = self._link is Link.UP and self._flush_at is None and self._has_quick
        self._ceiling = self._prefix + ABOVE_ALL_IDS if quick else NOTHING_BELOW
        due = min(self._polls.due, Seconds(self._heard + self.timing.silence))
        for other in (self._flush_at, self._orders.due):
            if other is not None and other < due:
                due = other
        self.deadline = due
