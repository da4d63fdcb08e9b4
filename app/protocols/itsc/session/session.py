"""The session: one vehicle, seen from the controller, over any number of connections (PROTOCOLS 1.2, 6.1, 6.2)."""

from binascii import crc_hqx
from collections.abc import Callable, Container, Sequence

from app.domain.events import Answered, Event, LinkUp, Reported, Taught, TeachingKind
from app.domain.ids import CmdId, CmdIds
from app.domain.layout import VehicleSpec
from app.domain.units import Millimetres, Pulses, Seconds
from app.domain.vehicle import Oper, VehicleStatus
from app.protocols.itsc import framing
from app.protocols.itsc.condition import barcode_text, condition
from app.protocols.itsc.dialects import Dialect
from app.protocols.itsc.messages import Ack, Code, Enq, Etb, Frame, Nak, Resp1, Resp2, Teach
from app.protocols.itsc.session.exchange import Exchange
from app.protocols.itsc.session.identity import Origin, origin_of, teaching
from app.protocols.itsc.session.link import Link, Taped
from app.protocols.itsc.session.orders import Order
from app.protocols.itsc.session.quick import (
    BODY_AT,
    BODY_END,
    CODE_AT,
    ENQ_SIZE,
    ENTRY_SIZE,
    ID_AT,
    RING_KEPT,
    ack_of,
    content_of,
    pack_ack,
    status_reader,
    write_entry,
)
from app.protocols.itsc.session.refusals import off_the_map, why_failed
from app.protocols.itsc.session.timing import Timing

Told = Callable[[Sequence[Event], Seconds], None]

_made = tuple.__new__

UNSTORED_KEPT = 64
"""Our choice: teaching events that may wait for the store; further ones are left to the vehicle's repetition."""

_NOTHING_KNOWN = VehicleStatus(condition(0, 0), barcode_text(0), 0)


class Session(Exchange):
    """Our end of one vehicle's line; an ``app.domain.ports.Endpoint``. Gives what it learns as ``events()``.

    Each ``send`` ends in exactly one of NotSent, Answered and Unanswered; after an Unanswered on the same connection an
    Answered may still follow. ``status`` is the newest known state, complete at ``status_at``; between two STATUS an
    answer's STATUS2, barcode and SEQ are merged into it. It is kept when the link goes down: see ``up``. ``hint`` is
    not empty if the vehicle reported a barcode that is not in ``barcodes`` at first contact, and says which dialect
    would fit. ``told``, if given, is called instead of keeping events, by ``at_once`` alone.
    ``last_frames`` are (when, "in" or "out", bytes), newest last.
    """

    __slots__ = ("_barcodes", "_epoch", "_receipt", "_unstored", "hint")

    def __init__(
        self,
        vehicle: VehicleSpec,
        dialect: Dialect,
        cmd_ids: CmdIds,
        timing: Timing = Timing(),  # noqa: B008  (frozen)
        barcodes: Container[str] | None = None,
        told: Told | None = None,
    ) -> None:
        super().__init__(vehicle, dialect, cmd_ids, timing)
        self.hint = ""
        self._pass_on, self._name = told, vehicle.id
        self._barcodes, self._epoch = barcodes, cmd_ids.epoch
        self._read = status_reader(dialect)
        self._told = b""
        self._receipt = 0
        self._unstored: dict[int, tuple[bytes, Enq]] | None = None

    def connected(self, now: Seconds) -> None:
        """The line is up: ask STATUS at once, and nothing else until it is answered (PROTOCOLS 6.2)."""
        self._leave("connected anew", Link.ASKING)
        self._connections += 1
        self._heard = now
        self._poll(now)
        self._plan()

    def disconnected(self, now: Seconds, reason: str) -> None:
        """The line is down: commands under way are unknown, each said so."""
        self._leave(reason, Link.DOWN)
        self._plan()

    def received(self, data: bytes, now: Seconds) -> None:
        """Take bytes. Never raises, whatever they are."""
        ack = self.at_once(data, now, tell=False)
        if ack:
            self._out += ack
        elif not self._took_asked(data, now):
            self._take_all(data, now)

    def at_once(self, data: bytes, now: Seconds, *, tell: bool = True) -> bytes:
        """Take a STATUS event that came in one piece and return its ACK; empty if the bytes are something else, not taken.

        It is new since its CMD_ID is above all so far. What the long way does, in one step; ``deadline`` and
        ``wants_close`` stay as they were. With ``tell`` the owner hears of it at once.
        """
        if not self._newest < data < self._ceiling or len(data) != ENQ_SIZE or crc_hqx(data, self._crc_init):
            return b""
        body, status = data[CODE_AT:BODY_END], None
        if body != self._told[CODE_AT:BODY_END]:
            status = self._read(body)
            if status is None:
                return b""
        self._heard = self.status_at = now
        self._newest = data
        at = self._at
        write_entry(self._ring, at * ENTRY_SIZE, now, data[ID_AT:CODE_AT], data[BODY_AT:BODY_END])
        if at == RING_KEPT - 1:
            self._laps += 1
            at = -1
        self._at = at + 1
        if status is not None:
            self._told = data
            if self._ordered:
                self._moved_on(status, now)
            self.status = status
            event = _made(Reported, (self._name, status, False, now))
            if tell and self._pass_on is not None:
                self._pass_on((event,), now)
            else:
                self._events.append(event)
        ids = data[1:13]
        return pack_ack(6, ids, crc_hqx(ids, self._after_ack))

    def _took_asked(self, data: bytes, now: Seconds) -> bool:
        """Take the answer to a poll that came in one piece likewise in one step; return whether it was one."""
        if not self._quick or len(data) != ENQ_SIZE or not data.startswith(self._prefix):
            return False
        cmd_id = int.from_bytes(data[ID_AT:CODE_AT], "big")
        if cmd_id not in self._polls or crc_hqx(data, self._crc_init):
            return False
        status = self._read(data[CODE_AT:BODY_END])
        if status is None:
            return False
        self._heard = now
        self._frames_in += 1
        self._frames.append(self._quicks, now, Taped.ANSWERED, content_of(data))
        self._seen.add(data)
        self._out += ack_of(data, self._after_ack)
        self._frames_out += 1
        self._learn(status, data, now, self._polls.answered(cmd_id, now, self.timing.poll))
        self._plan()
        return True

    def tick(self, now: Seconds) -> None:
        """Do what is due: give up half packets, a silent line, overdue commands; poll."""
        if not self._link.alive:
            return
        if self._flush_at is not None and now >= self._flush_at:
            self._flush_at = None
            for item in self._decoder.flush():
                self._take(item, now)
        if now >= self._heard + self.timing.silence:
            self._leave(f"no valid packet for {self.timing.silence} s", Link.CLOSING)
        else:
            self._tick_orders(now)
            if now >= self._polls.due:
                self._poll(now)
        self._plan()

    def stored(self, receipt: int, now: Seconds) -> None:
        """Acknowledge the teaching event that was given with this receipt: it is durable. An old receipt does nothing."""
        packet, frame = (self._unstored or {}).pop(receipt, (b"", None))
        if frame is not None:
            self._remember(packet)
            self._ack(frame, now)

    def _leave(self, reason: str, link: Link) -> None:
        self._lose(reason)
        self._unstored = None
        self._told = b""
        self._link, self.wants_close = link, link is Link.CLOSING

    def _take_all(self, data: bytes, now: Seconds) -> None:
        if not self._link.alive:
            return
        if self._quick and len(data) > ENQ_SIZE and len(data) % ENQ_SIZE == 0:
            # Several packets in one piece, most likely: each has its chance of the quick way.
            for at in range(0, len(data), ENQ_SIZE):
                Session.received(self, data[at : at + ENQ_SIZE], now)
            return
        for item in self._decoder.feed(data):
            self._take(item, now)
        self._flush_at = Seconds(now + self.timing.flush) if self._decoder.pending else None
        self._plan()

    def _take(self, item: Frame | framing.Garbled, now: Seconds) -> None:
        if isinstance(item, framing.Garbled):
            self._complain(item.reason.value, f"{item.detail}; {item.dropped} bytes dropped")
            return
        if item.dev_id != self.vehicle.dev_id:
            ours, theirs = self.dialect.show_dev_id(self.vehicle.dev_id), self.dialect.show_dev_id(item.dev_id)
            self._complain("foreign DEV_ID", f"the vehicle has DEV_ID {ours}, the packet {theirs}")
            return
        self._heard = now
        self._frames_in += 1
        if isinstance(item, Etb):
            self._complain("unfit packet", "a vehicle sends no ETB packet")
            return
        packet = self._codec.encode(item, strict=False)
        self._frames.append(self._quicks, now, Taped.IN, packet)
        match item:
            case Ack():
                self._take_ack(item, now)
            case Nak():
                self._take_nak(item, now)
            case Enq():
                self._take_enq(item, packet, now)

    def _take_ack(self, ack: Ack, now: Seconds) -> None:
        order = self._orders.open.get(ack.cmd_id)
        if order is None:
            return
        self._acknowledge(order, now)
        if order.code is Code.SYSTEM_RESET:
            # It has no answer: the ACK is all (I34).
            self._answered(order, self.status or _NOTHING_KNOWN, result=0)

    def _take_nak(self, nak: Nak, now: Seconds) -> None:
        order = self._orders.open.get(nak.cmd_id)
        if nak.cmd_id in self._polls:
            self._polls.refused(nak.cmd_id, self.timing.poll)
        elif order is not None and not order.acked and order.code is not Code.STATUS:
            self._send_again(order, now)

    def _take_enq(self, frame: Enq, packet: bytes, now: Seconds) -> None:
        if self._known(packet):
            self._duplicates += 1
            self._ack(frame, now)
            return
        taught = teaching(frame, self._codec)
        if taught is not None:
            self._take_teaching(frame, packet, *taught)
            return
        self._remember(packet)
        self._ack(frame, now)
        origin = origin_of(frame.cmd_id, self._epoch)
        if origin is Origin.OTHER_EPOCH:
            self._complain("another epoch", f"CMD_ID 0x{frame.cmd_id:016X} was given by another life of the controller")
        elif isinstance(frame.body, Resp2):
            self._take_status(frame, frame.body, packet, origin, now)
        elif isinstance(frame.body, Resp1):
            self._take_answer(frame, frame.body, origin, now)
        else:
            self._complain("unfit packet", f"code 0x{frame.code:04X} is no answer and no event that is known")

    def _ack(self, frame: Enq, now: Seconds) -> None:
        if self.dialect.ack_answers:
            self._emit(self._codec.ack(frame.dev_id, frame.cmd_id), now)

    def _take_teaching(self, frame: Enq, packet: bytes, content: Teach, kind: TeachingKind | None) -> None:
        if self._unstored is None:
            self._unstored = {}
        waiting = [known for known, _ in self._unstored.values()]
        if packet in waiting or len(waiting) >= UNSTORED_KEPT:
            self._duplicates += packet in waiting
            return
        self._receipt += 1
        self._unstored[self._receipt] = (packet, frame)
        self._events.append(
            Taught(
                self.vehicle.id,
                kind,
                frame.code,
                Pulses(content.pos),
                barcode_text(content.barcode),
                CmdId(frame.cmd_id),
                self._receipt,
                self._connections,
            )
        )

    def _take_status(self, frame: Enq, body: Resp2, packet: bytes, origin: Origin, now: Seconds) -> None:
        dist = None if body.dist is None else Millimetres(body.dist)
        state = condition(body.status1.word, body.status2.word)
        status = VehicleStatus(state, barcode_text(body.barcode), body.seq, dist)
        order = self._orders.named(frame.cmd_id)
        poll = frame.cmd_id
        if origin is Origin.ODD and poll not in self._polls:
            # A vehicle that does not repeat our CMD_ID: the oldest question (I23).
            poll = self._polls.oldest(poll)
        if poll in self._polls:
            asked = self._polls.answered(poll, now, self.timing.poll)
            self._first_contact(status, packet)
            self._learn(status, packet, now, asked)
        elif order is not None and order.code is Code.STATUS:
            self._learn(status, packet, now, order.sent_at)
            self._acknowledge(order, now)
            self._answered(order, status, result=0)
        elif origin is not Origin.OURS or order is not None or frame.cmd_id == self._last_move:
            if order is not None and order.cmd_id in self._orders.open:
                # STATUS under the CMD_ID of a command: the vehicle has it (I20).
                self._acknowledge(order, now)
            self._learn(status, packet, now, None)
        else:
            self._complain("unasked answer", f"STATUS answers CMD_ID 0x{frame.cmd_id:016X}, which is not under way")

    def _first_contact(self, status: VehicleStatus, packet: bytes) -> None:
        if self._link is Link.UP:
            return
        self._link = Link.UP
        self._events.append(LinkUp(self.vehicle.id))
        if self._barcodes is not None and status.condition.recognised:
            self.hint = off_the_map(status.barcode, packet[BODY_AT:BODY_END], self.dialect, self._barcodes)

    def _learn(self, status: VehicleStatus, packet: bytes, now: Seconds, asked: Seconds | None) -> None:
        """Take a whole STATUS; ``asked`` is when we asked for it, None for an event."""
        if asked is not None:
            self._events.append(Reported(self.vehicle.id, status, polled=True, asked_at=asked))
        elif packet[CODE_AT:BODY_END] != self._told[CODE_AT:BODY_END]:
            self._events.append(Reported(self.vehicle.id, status, polled=False, asked_at=now))
        self._moved_on(status, now)
        self._told = packet
        self.status, self.status_at = status, now

    def _moved_on(self, status: VehicleStatus, now: Seconds) -> None:
        risen = self.status is not None and status.seq > self.status.seq
        self._progress(rising=risen or status.condition.oper is Oper.PAUSE, now=now)

    def _take_answer(self, frame: Enq, body: Resp1, origin: Origin, now: Seconds) -> None:
        order = self._orders.named(frame.cmd_id)
        if order is None and origin is not Origin.OURS:
            order = self._orders.oldest(frame.code)
        if order is None:
            self._complain(
                "unasked answer", f"CMD_ID 0x{frame.cmd_id:016X} with code 0x{frame.code:04X} is not under way"
            )
            return
        wrong = self._codec.problems(frame)
        if order.code != frame.code:
            wrong = (f"code 0x{frame.code:04X} answers code 0x{order.code:04X}", *wrong)
        if wrong:
            self._complain("unfit answer", "; ".join(wrong))
            return
        if order.cmd_id in self._orders.open:
            self._acknowledge(order, now)
        before = self.status or _NOTHING_KNOWN
        state = condition(before.condition.status1, body.status2.word)
        dist = None if body.dist is None else Millimetres(body.dist)
        status = VehicleStatus(state, barcode_text(body.barcode), body.seq, dist)
        self._moved_on(status, now)
        self.status = status
        # The next event is told even if it equals the last one: this answer may have changed the picture in between.
        self._told = b""
        self._answered(order, status, body.result)
        if order.code is not Code.DISPLAY_BY_HOST:
            # RESP1 lacks STATUS1, which the outcome is judged by (F, the axes). Our choice: ask at once.
            self._poll(now)

    def _answered(self, order: Order, status: VehicleStatus, result: int) -> None:
        self._orders.close(order)
        reason = why_failed(status.condition) if result else ""
        self._events.append(
            Answered(
                self.vehicle.id,
                order.cmd_id,
                order.command,
                not result,
                reason,
                status.condition,
                status.barcode,
                status.seq,
            )
        )
