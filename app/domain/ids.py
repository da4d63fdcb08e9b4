"""Identities, and the allocation of CMD_IDs (COMMANDS.md section 2)."""

from typing import NewType

VehicleId = NewType("VehicleId", str)
StationId = NewType("StationId", str)
ZoneId = NewType("ZoneId", str)
LinkId = NewType("LinkId", str)
"""A line that carries several devices; no vehicle has the same name."""
JobId = NewType("JobId", str)
CarrierId = NewType("CarrierId", str)
DevId = NewType("DevId", int)
"""Vehicle identity on the wire, unsigned 32 bit (PROTOCOLS I22)."""
CmdId = NewType("CmdId", int)
"""Command identity on the wire, 64 bit; the controller's have the top bit clear (PROTOCOLS I23)."""
Epoch = NewType("Epoch", int)
"""Raised durably at every start of a controller, 1 to 2^31-1."""
Actor = NewType("Actor", str)
"""Who asked: a person's or a host's name, kept in the audit."""

COUNTER_BITS = 32
MAX_EPOCH = (1 << 31) - 1


class CmdIds:
    """Gives CMD_IDs that no earlier process life gave: the epoch above, a counter below.

    The top bit stays clear, because vehicles set it in theirs (PROTOCOLS I23). A counter that runs out raises
    OverflowError instead of wrapping: 2^32 commands in one process life is over a month at 1,500 a second.
    """

    __slots__ = ("_last", "epoch")

    def __init__(self, epoch: Epoch) -> None:
        if not 1 <= epoch <= MAX_EPOCH:
            raise ValueError(f"epoch {epoch} is outside 1..{MAX_EPOCH}")
        self.epoch = epoch
        self._last = 0

    def next(self) -> CmdId:
        """Return a CMD_ID never given before."""
        self._last += 1
        if self._last >> COUNTER_BITS:
            raise OverflowError("the CMD_ID counter of this epoch is used up: restart the controller")
        return CmdId((self.epoch << COUNTER_BITS) | self._last)


def epoch_of(cmd_id: CmdId) -> Epoch:
    """Return the epoch in which a controller gave this CMD_ID."""
    return Epoch((cmd_id >> COUNTER_BITS) & MAX_EPOCH)
