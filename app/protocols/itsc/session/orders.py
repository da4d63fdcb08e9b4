"""The commands under way on one connection: sent, acknowledged, answered, or given up (PROTOCOLS 6.1, 6.2)."""

from dataclasses import dataclass

from app.domain.commands import Command, Move
from app.domain.ids import CmdId
from app.domain.units import Seconds
from app.protocols.itsc.messages import Code
from app.protocols.itsc.session.requests import MOTION, STOPS

LATE_KEPT = 64
"""Our choice: as many given-up commands keep their name for a late answer as CMD_IDs are remembered (I23)."""


@dataclass(slots=True)
class Order:
    """A command under way. ``due``: when its ACK (until ``acked``) or its answer must be here.

    ``packet`` is sent again byte for byte; ``resends`` is how often that may still be done; ``window`` how long the
    answer may take.
    """

    cmd_id: CmdId
    command: Command
    code: Code
    packet: bytes
    sent_at: Seconds
    due: Seconds
    resends: int
    window: Seconds
    acked: bool = False


class Orders:
    """Open orders in the order of sending, and those given up on this connection."""

    __slots__ = ("_late", "open")

    def __init__(self) -> None:
        self.open: dict[int, Order] = {}
        self._late: dict[int, Order] | None = None

    @property
    def due(self) -> Seconds | None:
        """When the next of them wants to be looked at."""
        return min((order.due for order in self.open.values()), default=None)

    def overdue(self, now: Seconds) -> list[Order]:
        """Return those whose time is up."""
        return [order for order in self.open.values() if order.due <= now]

    def close(self, order: Order) -> None:
        """Forget an order that ended."""
        self.open.pop(order.cmd_id, None)
        if self._late:
            self._late.pop(order.cmd_id, None)

    def give_up(self, order: Order) -> None:
        """Take an order as unanswered; an answer may still come."""
        del self.open[order.cmd_id]
        if self._late is None:
            self._late = {}
        self._late[order.cmd_id] = order
        if len(self._late) > LATE_KEPT:
            del self._late[next(iter(self._late))]

    def forget(self) -> list[Order]:
        """Return the open orders and forget all: the connection is gone."""
        lost = list(self.open.values())
        self.open.clear()
        self._late = None
        return lost

    def named(self, cmd_id: int) -> Order | None:
        """Return the order, open or given up, that has this CMD_ID."""
        return self.open.get(cmd_id) or (self._late.get(cmd_id) if self._late else None)

    def oldest(self, code: int) -> Order | None:
        """Return the oldest open order with this code: for answers that do not repeat the CMD_ID (I23)."""
        return next((order for order in self.open.values() if order.code == code), None)

    def in_the_way(self, code: Code) -> Order | None:
        """Return the open order that forbids sending this code now, or None.

        While the vehicle has a job or is being stopped, no other motion may be sent but an XMOVE to its MOVE.
        """
        if code not in MOTION:
            return None
        for order in self.open.values():
            if order.code in STOPS or (order.code in MOTION and (code, order.code) != (Code.XMOVE, Code.MOVE)):
                return order
        return None

    def move(self) -> Order | None:
        """Return the open MOVE, if there is one."""
        return next((order for order in self.open.values() if isinstance(order.command, Move)), None)
