"""What differs from one HI drive to the next: one frozen set of switches, and named presets (PROTOCOLS 4.2)."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from types import MappingProxyType
from typing import Any, ClassVar

from app.domain.errors import HoistwayError
from app.wire.names import unknown

PREFIX = "hi."
"""What stands before a preset's name where dialects of several protocols are listed together."""


class DialectError(HoistwayError):
    """A dialect was asked for that does not exist or cannot be."""

    code = "dialect"


class Bcc(StrEnum):
    """How the sum over a packet is sent (H1): its low digit, its low byte or all of it as hexadecimal digits, or one byte."""

    NIBBLE = "nibble"
    BYTE = "byte"
    WORD = "word"
    RAW = "raw"

    @property
    def size(self) -> int:
        """How many bytes it takes on the wire."""
        return {Bcc.NIBBLE: 1, Bcc.BYTE: 2, Bcc.WORD: 4, Bcc.RAW: 1}[self]


class Steps(StrEnum):
    """How the four step-select inputs of INP are sent (H15): one hexadecimal digit, or four digits 0 and 1, IN3 first."""

    HEX = "hex"
    BITS = "bits"


@dataclass(frozen=True, slots=True)
class Dialect:
    """Every switch of a drive; the defaults are the worked example with our conventions.

    ``value_digits`` is how many digits of a parameter's value are sent (H4); three and four are read. Raises:
    DialectError: a value that cannot be, in a sentence.
    """

    bcc: Bcc = Bcc.NIBBLE
    value_digits: int = 4
    input_steps: Steps = Steps.HEX

    CHOICES: ClassVar[Mapping[str, tuple[object, ...]]] = MappingProxyType(
        {
            "bcc": tuple(form.value for form in Bcc),
            "value_digits": (3, 4),
            "input_steps": tuple(form.value for form in Steps),
        }
    )

    def __post_init__(self) -> None:
        for name, allowed in self.CHOICES.items():
            value = getattr(self, name)
            if not any(value == choice and isinstance(value, type(choice)) for choice in allowed):
                raise DialectError(f"{name} {value!r} is none of {', '.join(repr(choice) for choice in allowed)}")
        object.__setattr__(self, "bcc", Bcc(self.bcc))
        object.__setattr__(self, "input_steps", Steps(self.input_steps))

    @property
    def highest_value(self) -> int:
        """The highest parameter value that can be sent."""
        return int("9" * self.value_digits)

    @classmethod
    def from_mapping(cls, mapping: Mapping[str, Any], base: "Dialect | None" = None) -> "Dialect":
        """Return the base (the default dialect) overlaid with the mapping's entries.

        Raises: DialectError: an unknown key, with the nearest known one, or a value that cannot be.
        """
        known = {field.name for field in fields(cls)}
        for key in mapping:
            if key not in known:
                raise DialectError(unknown("dialect field", str(key), known))
        return replace(base or cls(), **mapping)


DEFAULT = Dialect()
"""The worked example with our conventions."""

DIALECTS: Mapping[str, Dialect] = MappingProxyType(
    {
        "default": DEFAULT,
        "bcc-byte": Dialect(bcc=Bcc.BYTE),
        "bcc-word": Dialect(bcc=Bcc.WORD),
        "bcc-raw": Dialect(bcc=Bcc.RAW),
        "value3": Dialect(value_digits=3),
        "input-bits": Dialect(input_steps=Steps.BITS),
    }
)
"""The named presets: one for each switch that a drive may turn."""


def dialect_named(name: str) -> Dialect:
    """Return a preset, with or without the prefix ``hi.``. Raises: DialectError: with the nearest known name."""
    found = DIALECTS.get(name.removeprefix(PREFIX))
    if found is None:
        raise DialectError(unknown("HI dialect", name, DIALECTS))
    return found
