"""Catalogues: what the parameters of a drive model are called, mean and may be (PROTOCOLS H23; DOMAIN section 7)."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from app.domain.drive import Parameter, RawValue

HIGHEST_RAW = RawValue(9999)
"""Most that a parameter can hold in any dialect (PROTOCOLS H4)."""


@dataclass(frozen=True, slots=True)
class ParameterSpec:
    """A parameter of a model. ``lowest``, ``highest`` and ``default`` are raw; ``value = raw * scale`` in ``unit``.

    ``decimals`` are those of the scale; ``choices`` gives words to raw values that stand for something.
    """

    number: Parameter
    name: str
    unit: str = ""
    scale: float = 1.0
    decimals: int = 0
    lowest: RawValue = RawValue(0)
    highest: RawValue = HIGHEST_RAW
    default: RawValue | None = None
    read_only: bool = False
    while_running: bool = False
    description: str = ""
    choices: Mapping[int, str] = field(default_factory=dict)

    def scaled(self, raw: int) -> float:
        """Return a raw value in the parameter's unit."""
        return round(raw * self.scale, self.decimals)

    def raw(self, value: float) -> RawValue | None:
        """Return a value of the parameter's unit as the drive has it; None if it lies between two of its steps."""
        raw = round(value / self.scale)
        return RawValue(raw) if abs(raw * self.scale - value) < self.scale / 1000 else None

    def shown(self, raw: int) -> str:
        """Return a raw value for people, such as ``1.50 s`` or ``on``."""
        if raw in self.choices:
            return self.choices[raw]
        return f"{raw * self.scale:.{self.decimals}f} {self.unit}".rstrip()

    @property
    def range(self) -> str:
        """The range for people, such as ``0.10 s to 60.00 s (raw 10 to 6000)``."""
        return f"{self.shown(self.lowest)} to {self.shown(self.highest)} (raw {self.lowest} to {self.highest})"


@dataclass(frozen=True, slots=True)
class Catalogue:
    """The parameters of a drive model; numbers that it does not name are accessible raw only."""

    model: str
    description: str = ""
    parameters: Mapping[Parameter, ParameterSpec] = field(default_factory=dict)

    def get(self, number: int) -> ParameterSpec | None:
        """Return a parameter, None if the catalogue does not name it."""
        return self.parameters.get(Parameter(number))


UNKNOWN_MODEL = Catalogue("")
"""For a drive without a catalogue: raw access only."""
