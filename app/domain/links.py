"""What is sent over a line that carries several devices."""

from dataclasses import dataclass

from app.domain.devices import DeviceRequest
from app.domain.drive import DriveRequest, Jog, KeepJogging, ReleaseJog
from app.domain.ids import LinkId

LinkOrder = DeviceRequest | DriveRequest | Jog | KeepJogging | ReleaseJog


@dataclass(frozen=True, slots=True)
class LinkSend:
    """An order on its way to a link; what it needs to survive is durable already."""

    link: LinkId
    order: LinkOrder
