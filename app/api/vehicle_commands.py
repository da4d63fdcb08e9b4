"""Commands to vehicles: those of every kind, and ENIG's own for AGVs (PROTOCOLS 3.3)."""

from typing import Annotated, Literal

from pydantic import Field, StringConstraints

from app.api.inputs import DisplayCommand, MoveCommand, PlainCommand, Strict, TransferCommand
from app.domain.devices import (
    AgvCharge,
    AgvLift,
    AgvMoveAlias,
    AgvMoveAuto,
    AgvMoveManual,
    AgvSetCurrent,
    AgvSpeed,
    AliasName,
    DeviceAct,
    DeviceCommand,
    LiftAction,
    ManualDirection,
    Steering,
)
from app.domain.units import Barcode

Tag = Annotated[str, StringConstraints(strict=True, pattern=r"^[\x21-\x7e]{4}$")]
Alias = Annotated[str, StringConstraints(strict=True, min_length=1, max_length=16, pattern=r"^[\x21-\x7e]+$")]
Pace = Literal["slow", "normal", "fast"]


class AgvMoveManualCommand(Strict):
    """104 MoveManual, in manual: drive until stopped. Never sent twice; what became of it a person decides."""

    command: Literal["agv_move_manual"]
    direction: Literal["backward", "forward", "turn_left", "turn_right"]
    speed: Pace = "slow"

    def worded(self) -> DeviceCommand:
        """Return it in the words of the business."""
        return AgvMoveManual(ManualDirection[self.direction.upper()], AgvSpeed[self.speed.upper()])


class AgvMoveAutoCommand(Strict):
    """108 MoveAuto, in auto: follow the tape until stopped, where no other AGV may be on the same floor."""

    command: Literal["agv_move_auto"]
    direction: Literal["backward", "forward"] = "forward"
    steering: Literal["straight", "left", "right"] = "straight"
    speed: Pace = "slow"

    def worded(self) -> DeviceCommand:
        """Return it in the words of the business."""
        return AgvMoveAuto(self.direction == "forward", Steering[self.steering.upper()], AgvSpeed[self.speed.upper()])


class AgvMarkStopCommand(Strict):
    """105 MarkStop: stop at the next mark."""

    command: Literal["agv_mark_stop"]

    def worded(self) -> DeviceCommand:
        """Return it in the words of the business."""
        return DeviceAct.MARK_STOP


class AgvSetCurrentCommand(Strict):
    """103 SetCurrent: tell a standing AGV which tag it is at."""

    command: Literal["agv_set_current"]
    tag: Tag

    def worded(self) -> DeviceCommand:
        """Return it in the words of the business."""
        return AgvSetCurrent(Barcode(self.tag))


class AgvLiftCommand(Strict):
    """106 Lift."""

    command: Literal["agv_lift"]
    action: Literal["stop", "up", "down"]

    def worded(self) -> DeviceCommand:
        """Return it in the words of the business."""
        return AgvLift(LiftAction[self.action.upper()])


class AgvChargeCommand(Strict):
    """109 Charge. On: only where the AGV stands at a charger, since it would drive to one on a way of its own."""

    command: Literal["agv_charge"]
    on: bool

    def worded(self) -> DeviceCommand:
        """Return it in the words of the business."""
        return AgvCharge(self.on)


class AgvMoveAliasCommand(Strict):
    """107 Move to a destination by its name, if the whole way there is free and certainly the AGV's own."""

    command: Literal["agv_move_alias"]
    alias: Alias

    def worded(self) -> DeviceCommand:
        """Return it in the words of the business."""
        return AgvMoveAlias(AliasName(self.alias))


AgvCommandIn = (
    AgvMoveManualCommand
    | AgvMoveAutoCommand
    | AgvMarkStopCommand
    | AgvSetCurrentCommand
    | AgvLiftCommand
    | AgvChargeCommand
    | AgvMoveAliasCommand
)

VehicleCommand = PlainCommand | DisplayCommand | MoveCommand | TransferCommand | AgvCommandIn
CommandIn = Annotated[VehicleCommand, Field(discriminator="command")]
