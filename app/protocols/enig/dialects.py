"""What differs from one ENIG site to the next: one frozen set of switches, and named presets (PROTOCOLS 4.3)."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from types import MappingProxyType
from typing import Any, ClassVar, Literal

from app.domain.errors import HoistwayError
from app.wire.names import unknown

PREFIX = "enig."
"""What stands before a preset's name where dialects of several protocols are listed together."""

ACS = 0
"""The host's own DeviceType (3.2)."""
MAX_TARGET = 0x1F
"""A Target byte is below 0x20, the first character of a tag or alias is not (E3)."""

Order = Literal["big", "little"]


class DialectError(HoistwayError):
    """A dialect was asked for that does not exist or cannot be."""

    code = "dialect"


class CrcFrom(StrEnum):
    """The first field that the CRC covers; it always ends with the last byte of DATA (E1)."""

    STX = "stx"
    LEN = "len"
    ID = "id"
    CMD = "cmd"
    DATA = "data"

    @property
    def offset(self) -> int:
        """Where this field stands in a packet (3.1)."""
        return _OFFSETS[self]


_OFFSETS = {CrcFrom.STX: 0, CrcFrom.LEN: 1, CrcFrom.ID: 2, CrcFrom.CMD: 3, CrcFrom.DATA: 4}

ALIASES: Mapping[str, int] = MappingProxyType(
    {
        **{f"B{i}": 20 + i for i in range(1, 6)},
        **{f"C{i}": 40 + i for i in range(1, 5)},
        **{f"E{i}": 90 + i for i in range(1, 4)},
    }
)
"""DeviceAlias (3.2): buffers, chargers and machines as destinations."""


@dataclass(frozen=True, slots=True)
class Dialect:
    """Every switch of a site's ENIG; the defaults are the source with our conventions.

    ``target``: whether commands that list a Target byte are sent with it; both are read (E3). ``host_id``: whether the ID
    of a packet to a device is the device's, or the host's own 0 wherever a Target names the device (E4). ``max_len``
    bounds LEN on receiving and on sending (E16); 64 is enough for every listed packet. ``agv_ids``, ``buffer_ids`` and
    ``door_ids`` are the DeviceTypes of each class (E22), ``aliases`` the destinations' names and numbers (E6, E24).
    Raises: DialectError: a value that cannot be, in a sentence.
    """

    crc_from: CrcFrom = CrcFrom.LEN
    crc_order: Order = "little"
    target: Literal["omit", "include"] = "omit"
    host_id: Literal["device", "acs"] = "device"
    max_len: int = 255
    agv_ids: tuple[int, ...] = tuple(range(11, 20))
    buffer_ids: tuple[int, ...] = tuple(range(21, 30))
    door_ids: tuple[int, ...] = (30,)
    aliases: tuple[tuple[str, int], ...] = tuple(ALIASES.items())

    CHOICES: ClassVar[Mapping[str, tuple[str, ...]]] = MappingProxyType(
        {
            "crc_from": tuple(field.value for field in CrcFrom),
            "crc_order": ("big", "little"),
            "target": ("omit", "include"),
            "host_id": ("device", "acs"),
        }
    )

    def __post_init__(self) -> None:
        for name, allowed in self.CHOICES.items():
            value = getattr(self, name)
            if not isinstance(value, str) or value not in allowed:
                raise DialectError(f"{name} {value!r} is none of {', '.join(allowed)}")
        object.__setattr__(self, "crc_from", CrcFrom(self.crc_from))
        if self.host_id == "acs" and self.target == "omit":
            raise DialectError("host_id acs needs target include: nothing else would name the device")
        if not _is_number(self.max_len, 1, 255):
            raise DialectError(f"max_len {self.max_len!r} is no number of bytes from 1 to 255")
        self._check_ids()
        for name, _ in self.aliases:
            if not (name.isascii() and name.isprintable() and name):
                raise DialectError(f"alias {name!r} is no text of printable ASCII characters")

    def _check_ids(self) -> None:
        seen: dict[int, str] = {}
        for name in ("agv_ids", "buffer_ids", "door_ids"):
            for number in getattr(self, name):
                if not _is_number(number, 1, 255):
                    raise DialectError(f"{name} {number!r} is no DeviceType from 1 to 255")
                if number in seen:
                    raise DialectError(f"{name} {number} is given to {seen[number]} already")
                if self.target == "include" and number > MAX_TARGET:
                    raise DialectError(f"{name} {number} cannot be a Target, which is below 0x20: use target omit")
                seen[number] = name

    @classmethod
    def from_mapping(cls, mapping: Mapping[str, Any], base: "Dialect | None" = None) -> "Dialect":
        """Return the base (the default dialect) overlaid with the mapping's entries.

        Ids may be given as a list, ``aliases`` as a mapping of names to numbers. Raises: DialectError: an unknown key,
        with the nearest known one, or a value that cannot be.
        """
        known = {field.name for field in fields(cls)}
        for key in mapping:
            if key not in known:
                raise DialectError(unknown("dialect field", str(key), known))
        changes = dict(mapping)
        for key in changes.keys() & _READERS.keys():
            try:
                changes[key] = _READERS[key](changes[key])
            except (TypeError, ValueError) as wrong:
                raise DialectError(f"{key} {changes[key]!r}: {wrong}") from None
        return replace(base or cls(), **changes)


def _pairs(aliases: Mapping[str, int] | Iterable[tuple[str, int]]) -> tuple[tuple[str, int], ...]:
    pairs = aliases.items() if isinstance(aliases, Mapping) else aliases
    return tuple((str(name), int(number)) for name, number in pairs)


_READERS: Mapping[str, Callable[[Any], tuple[Any, ...]]] = MappingProxyType(
    {"agv_ids": tuple, "buffer_ids": tuple, "door_ids": tuple, "aliases": _pairs}
)


def _is_number(value: object, low: int, high: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and low <= value <= high


DEFAULT = Dialect()
"""The source's packets with our conventions."""

_CRCS: dict[str, Dialect] = {
    f"crc-{start.value}{'-be' if order == 'big' else ''}": Dialect(crc_from=start, crc_order=order)
    for start in (CrcFrom.STX, CrcFrom.ID, CrcFrom.CMD, CrcFrom.DATA)
    for order in ("little", "big")
}

DIALECTS: Mapping[str, Dialect] = MappingProxyType(
    {
        "default": DEFAULT,
        "crc-be": Dialect(crc_order="big"),
        **_CRCS,
        "target": Dialect(target="include"),
        "acs-id": Dialect(target="include", host_id="acs"),
        "max64": Dialect(max_len=64),
    }
)
"""The named presets: one for each switch that a site may turn; ``max64`` is the default for production (E16)."""


def dialect_named(name: str) -> Dialect:
    """Return a preset, with or without the prefix ``enig.``. Raises: DialectError: with the nearest known name."""
    found = DIALECTS.get(name.removeprefix(PREFIX))
    if found is None:
        raise DialectError(unknown("ENIG dialect", name, DIALECTS))
    return found
