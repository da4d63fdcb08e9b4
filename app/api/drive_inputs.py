"""Bodies and parameters about drives that we accept."""

from typing import Annotated, Literal, Self

from fastapi import Path, Query
from pydantic import Field, StringConstraints, model_validator

from app.api.inputs import Id, Strict, Text
from app.domain.drive import Key, Parameter, SetInputs, Turn

NUMBER_PATTERN = r"^[0-9A-Fa-f]*$"
Number = Annotated[str, StringConstraints(strict=True, min_length=2, max_length=2, pattern=NUMBER_PATTERN)]
PathNumber = Annotated[
    str, Path(min_length=2, max_length=2, pattern=NUMBER_PATTERN, description="Number of a parameter, 00 to FF.")
]
PathCount = Annotated[int, Path(ge=1, le=(1 << 53) - 1)]
RawIn = Annotated[int, Field(ge=0, le=9999)]
Count = Annotated[int, Field(ge=1, le=(1 << 53) - 1)]
LONGEST_WAIT = 60.0
Wait = Annotated[
    float,
    Query(ge=0, le=LONGEST_WAIT, description="Seconds to wait for the end of the operation before answering."),
]
Before = Annotated[int | None, Query(ge=0, le=(1 << 53) - 1, description="Only what is numbered below this.")]


def parameter(number: str) -> Parameter:
    """Return a parameter by its number in hexadecimal."""
    return Parameter(int(number, 16))


class KeyIn(Strict):
    """A key of the drive's panel. ``stop_reset`` stops whatever moves, and clears an error whose cause is gone."""

    key: Literal["run", "stop_reset", "up", "down", "data_set"]

    def pressed(self) -> Key:
        """Return it in the words of the business."""
        return Key(self.key)


class InputsIn(Strict):
    """The drive's inputs; ``run`` and ``home`` make it move. What is left out is off."""

    run: bool = False
    home: bool = False
    right_limit: bool = False
    left_limit: bool = False
    step: Annotated[int, Field(ge=0, le=15)] = 0

    def inputs(self) -> SetInputs:
        """Return them in the words of the business."""
        return SetInputs(self.run, self.home, self.right_limit, self.left_limit, self.step)


class ReadIn(Strict):
    """Which parameters to read, in hexadecimal; left out: all 256."""

    parameters: Annotated[list[Number], Field(min_length=1, max_length=256)] | None = None

    def numbers(self) -> tuple[Parameter, ...]:
        """Return them without repetitions."""
        if self.parameters is None:
            return tuple(Parameter(number) for number in range(256))
        return tuple(dict.fromkeys(parameter(number) for number in self.parameters))


class WriteIn(Strict):
    """What to write: ``value`` in the catalogue's unit, or ``raw`` as the drive has it. ``raw_access`` says that a parameter
    without a catalogue is meant.
    """

    raw: RawIn | None = None
    value: Annotated[float, Field(ge=-1e9, le=1e9, allow_inf_nan=False)] | None = None
    raw_access: bool = False

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if (self.raw is None) == (self.value is None):
            raise ValueError("send either raw or value")
        return self


class NamedWriteIn(WriteIn):
    """As above, with the parameter's number."""

    parameter: Number


class BackupIn(Strict):
    """A note for those who look for the backup later."""

    note: Text = ""


class CompareIn(Strict):
    """Compare with a backup (of this or another drive), or with another drive."""

    backup: Count | None = None
    drive: Id | None = None

    @model_validator(mode="after")
    def _one_of_both(self) -> Self:
        if (self.backup is None) == (self.drive is None):
            raise ValueError("send either backup or drive")
        return self


class RestoreIn(Strict):
    """Which backup to write back. ``dry_run``: only say what would be written."""

    backup: Count
    dry_run: bool = False


class JogIn(Strict):
    """Which way."""

    direction: Literal["cw", "ccw"]

    def turn(self) -> Turn:
        """Return it in the words of the business."""
        return Turn[self.direction.upper()]


class JogHeld(Strict):
    """Which jog."""

    jog: Count


class WatchIn(Strict):
    """Which parameters to poll, and for how many seconds."""

    parameters: Annotated[list[Number], Field(min_length=1, max_length=16)]
    seconds: Annotated[float, Field(ge=1, le=3600)] = 60.0

    def numbers(self) -> tuple[Parameter, ...]:
        """Return them without repetitions."""
        return tuple(dict.fromkeys(parameter(number) for number in self.parameters))
