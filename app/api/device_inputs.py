"""Bodies about doors, buffers, chargers and emergencies."""

from typing import Literal

from app.api.inputs import Reason, Strict
from app.domain.devices import DeviceAct
from app.domain.records import DoorPosition, EmergencyKind


class DeviceCommandIn(Strict):
    """Doors open and close, buffers lock and unlock."""

    command: Literal["open", "close", "lock", "unlock"]

    def act(self) -> DeviceAct:
        """Return it in the words of the business."""
        return DeviceAct(self.command)


class PinIn(Strict):
    """How the door is to stay until the pin is taken off, and why."""

    position: Literal["open", "closed"]
    reason: Reason

    def kept(self) -> DoorPosition:
        """Return the position in the words of the business."""
        return DoorPosition(self.position)


class EmergencyIn(Strict):
    """What is told, or over, and how that is known."""

    kind: Literal["fire", "earthquake"]
    reason: Reason

    def emergency(self) -> EmergencyKind:
        """Return the kind in the words of the business."""
        return EmergencyKind(self.kind)
