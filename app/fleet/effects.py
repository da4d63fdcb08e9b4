"""What the fleet has decided since it was last asked: to be kept first, then told (ARCHITECTURE section 1)."""

from dataclasses import dataclass, field

from app.domain.commands import Send
from app.domain.ids import VehicleId
from app.domain.links import LinkSend
from app.domain.records import Record
from app.domain.requests import Reply
from app.domain.view import Update


@dataclass(slots=True)
class Effects:
    """What was decided: to be kept first, then told (ARCHITECTURE section 1)."""

    records: list[Record] = field(default_factory=list)
    sends: list[Send] = field(default_factory=list)
    link_sends: list[LinkSend] = field(default_factory=list)
    polls: list[VehicleId] = field(default_factory=list)
    stored: list[tuple[VehicleId, int]] = field(default_factory=list)
    updates: list[Update] = field(default_factory=list)
    replies: list[tuple[int, Reply]] = field(default_factory=list)

    @property
    def empty(self) -> bool:
        """Whether nothing was decided."""
        told = self.updates or self.replies
        return not (self.records or self.sends or self.link_sends or self.polls or self.stored or told)
