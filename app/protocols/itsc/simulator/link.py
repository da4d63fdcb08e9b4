"""A simulated vehicle's end of the line: packets, acknowledgements, repetitions (PROTOCOLS 5.1, "Receiving")."""

from collections import OrderedDict, deque
from collections.abc import Callable
from dataclasses import dataclass, field

from app.domain.ids import DevId
from app.protocols.itsc.codec import Codec
from app.protocols.itsc.framing import Decoder, Garbled, Reason
from app.protocols.itsc.messages import Ack, Body, Enq, Etb, Frame, Nak, Toward
from app.protocols.itsc.simulator.agenda import Agenda, Due
from app.protocols.itsc.simulator.options import Options

VEHICLES_BIT = 1 << 63
"""Set in the CMD_IDs that a vehicle gives (I23)."""


def _nothing() -> None:
    return None


@dataclass(slots=True)
class _Sent:
    """A packet that waits for its ACK."""

    packet: bytes
    sends: int
    acked: Callable[[], None]
    lost: Callable[[], None]
    again: Due = field(init=False)


class Link:
    """Sends packets one by one, again without an ACK, and remembers what it was asked and what it answered.

    ``obey`` is called for each command of our DEV_ID, ``ack_delay`` after it came, acknowledged already and new. ``deaf``:
    nothing more is taken from this connection.
    """

    def __init__(self, codec: Codec, dev_id: DevId, agenda: Agenda, options: Options) -> None:
        self.obey: Callable[[Enq | Etb], None] = lambda _: None
        self.up = False
        self.wants_close = False
        self.deaf = False
        self._codec = codec
        self._dev_id = int(dev_id)
        self._agenda = agenda
        self._options = options
        self._decoder = Decoder(codec, Toward.VEHICLE)
        self._flush: Due | None = None
        self._out: deque[bytes] = deque()
        self._sent: dict[int, _Sent] = {}
        self._answers: OrderedDict[int, bytes | None] = OrderedDict()
        self._events = 0
        self._connection = 0

    def open(self) -> None:
        """The line is up; nothing of an earlier connection is sent on it."""
        self.close()
        self.up = True
        self.deaf = False
        self._connection += 1

    def close(self) -> None:
        """The line is down: what waits for an ACK is lost."""
        self.up = False
        self.wants_close = False
        self._decoder = Decoder(self._codec, Toward.VEHICLE)
        self._out.clear()
        if self._flush is not None:
            self._flush.cancel()
        for cmd_id in list(self._sent):
            self._settle(cmd_id).lost()

    def hang_up(self) -> None:
        """Ask the owner to close the connection; nothing more is received on it or entered for sending."""
        self.wants_close = self.up
        self.up = False

    def break_off(self) -> None:
        """The same without what is entered for sending: the power is gone."""
        self._out.clear()
        self.hang_up()

    def forget(self) -> None:
        """Lose the memory of commands and answers, as a restart does; the events' CMD_IDs begin again."""
        self._answers.clear()
        self._events = 0
        for sent in self._sent.values():
            sent.again.cancel()
        self._sent.clear()

    def outgoing(self) -> bytes:
        """Return the next packet, one at a call; empty if there is none."""
        return self._out.popleft() if self._out else b""

    def feed(self, data: bytes) -> None:
        """Take bytes as they come."""
        if not self.up or self.deaf:
            return
        for frame in self._decoder.feed(data):
            self._take(frame, data)
        if self._flush is not None:
            self._flush.cancel()
            self._flush = None
        if self._decoder.pending:
            self._flush = self._agenda.after(self._options.flush_after, self._silence)

    def ask(
        self, code: int, body: Body, acked: Callable[[], None] = _nothing, lost: Callable[[], None] = _nothing
    ) -> None:
        """Send an event under a new CMD_ID; ``lost`` is called if it stays without an ACK, at once without a connection."""
        if not self.up:
            lost()
            return
        self._events += 1
        cmd_id = VEHICLES_BIT | self._events
        self._send(cmd_id, self._codec.encode(Enq(self._dev_id, cmd_id, code, body), strict=False), acked, lost)

    def answer(self, cmd_id: int, code: int, body: Body) -> None:
        """Send a command's answer, and remember it for whoever asks again."""
        packet = self._codec.encode(Enq(self._dev_id, cmd_id, code, body), strict=False)
        if cmd_id in self._answers:
            self._answers[cmd_id] = packet
        if self.up:
            self._send(cmd_id, packet)

    def _take(self, frame: Frame | Garbled, data: bytes) -> None:
        if isinstance(frame, Garbled):
            if self._options.send_nak and frame.reason is Reason.CRC:
                self._complain(data)
        elif frame.dev_id != self._dev_id:
            return
        elif isinstance(frame, Ack):
            if frame.cmd_id in self._sent:
                self._settle(frame.cmd_id).acked()
        elif isinstance(frame, Nak):
            if frame.cmd_id in self._sent:
                self._again(frame.cmd_id)
        else:
            connection = self._connection
            self._agenda.after(self._options.ack_delay, lambda: self._command(frame, connection))

    def _complain(self, data: bytes) -> None:
        """Send NAK with the ids as received, if they can be read and are for us."""
        order = self._codec.dialect.byte_order
        if len(data) >= 13 and int.from_bytes(data[1:5], order) == self._dev_id:
            self._out.append(self._codec.encode(Nak(self._dev_id, int.from_bytes(data[5:13], order))))

    def _command(self, frame: Enq | Etb, connection: int) -> None:
        if self.up and connection == self._connection:
            self._out.append(self._codec.ack(frame.dev_id, frame.cmd_id))
        if frame.cmd_id in self._answers:
            answered = self._answers[frame.cmd_id]
            if answered is not None and self.up:
                self._send(frame.cmd_id, answered)
            return
        self._answers[frame.cmd_id] = None
        if len(self._answers) > self._options.remembered:
            self._answers.popitem(last=False)
        self.obey(frame)

    def _send(
        self, cmd_id: int, packet: bytes, acked: Callable[[], None] = _nothing, lost: Callable[[], None] = _nothing
    ) -> None:
        if cmd_id in self._sent:
            self._settle(cmd_id)
        self._sent[cmd_id] = sent = _Sent(packet, 0, acked, lost)
        sent.again = self._agenda.after(0.0, _nothing)
        self._again(cmd_id)

    def _again(self, cmd_id: int) -> None:
        sent = self._sent[cmd_id]
        sent.again.cancel()
        if sent.sends > self._options.resends:
            self._settle(cmd_id).lost()
            return
        sent.sends += 1
        self._out.append(sent.packet)
        sent.again = self._agenda.after(self._options.resend_after, lambda: self._again(cmd_id))

    def _settle(self, cmd_id: int) -> _Sent:
        sent = self._sent.pop(cmd_id)
        sent.again.cancel()
        return sent

    def _silence(self) -> None:
        for frame in self._decoder.flush():
            self._take(frame, b"")
