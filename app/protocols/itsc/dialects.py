"""What differs from one iTSC device to the next: one frozen set of switches, and named presets (PROTOCOLS 4.1)."""

from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from enum import StrEnum
from types import MappingProxyType
from typing import Any, ClassVar, Literal

from app.domain.errors import HoistwayError
from app.wire.crc import NAMED, Crc16
from app.wire.names import unknown

PREFIX = "itsc."
"""What stands before a preset's name where dialects of several protocols are listed together."""

Order = Literal["big", "little"]


class DialectError(HoistwayError):
    """A dialect was asked for that does not exist or cannot be."""

    code = "dialect"


class EtbLayout(StrEnum):
    """Where the sub packet and its CRC stand (I5)."""

    HEAD_CRC_SUB_CRC = "head+crc+sub+crc"
    HEAD_CRC_SUB = "head+crc+sub"
    HEAD_SUB_CRC = "head+sub+crc"


@dataclass(frozen=True, slots=True)
class Dialect:
    """Every switch of a device's iTSC; the defaults are document B with our conventions.

    ``crc`` is a name of :data:`app.wire.crc.NAMED` or a :class:`Crc16`. ``max_sub`` bounds the sub data of an ETB packet
    in bytes, on receiving and on sending. The ``teach_`` fields are the codes of the four teaching messages that the
    source does not number (I12); the ``_code`` fields give a code to the formats that no message uses (I32), None
    leaves them without. Raises: DialectError: a value that cannot be, in a sentence.
    """

    byte_order: Order = "big"
    crc: str | Crc16 = "ccitt-false"
    crc_order: Order = "big"
    crc_covers_type: bool = True
    etb: EtbLayout = EtbLayout.HEAD_CRC_SUB_CRC
    barcode_bytes: int = 6
    barcode_format: Literal["uint", "ascii"] = "uint"
    pad: int = 0
    max_sub: int = 6208
    dev_id_format: Literal["uint", "text"] = "uint"
    ack_answers: bool = True
    teach_shft_dest: int = 0x2070
    teach_shft_offset: int = 0x2071
    teach_rota_dest: int = 0x2072
    teach_rota_offset: int = 0x2073
    req_code: int | None = None
    mzone_code: int | None = None
    stid_code: int | None = None
    jog_code: int | None = None
    infr_code: int | None = None

    CHOICES: ClassVar[Mapping[str, tuple[object, ...]]] = MappingProxyType(
        {
            "byte_order": ("big", "little"),
            "crc_order": ("big", "little"),
            "crc_covers_type": (True, False),
            "etb": tuple(layout.value for layout in EtbLayout),
            "barcode_bytes": (4, 6),
            "barcode_format": ("uint", "ascii"),
            "pad": (0, 0x20),
            "dev_id_format": ("uint", "text"),
            "ack_answers": (True, False),
        }
    )

    def __post_init__(self) -> None:
        for name, allowed in self.CHOICES.items():
            value = getattr(self, name)
            if not any(value == choice and isinstance(value, type(choice)) for choice in allowed):
                raise DialectError(f"{name} {value!r} is none of {', '.join(repr(choice) for choice in allowed)}")
        object.__setattr__(self, "etb", EtbLayout(self.etb))
        if not isinstance(self.crc, Crc16 | str):
            raise DialectError(f"crc {self.crc!r} is no name")
        _ = self.crc_parameters
        if not _is_number(self.max_sub, 1, (1 << 24) - 1):
            raise DialectError(f"max_sub {self.max_sub!r} is no number of bytes from 1 to 16777215")
        self._check_codes()

    def _check_codes(self) -> None:
        seen: dict[int, str] = {}
        for field in fields(self):
            code = getattr(self, field.name)
            if not (field.name.startswith("teach_") or field.name.endswith("_code")) or code is None:
                continue
            if not _is_number(code, 0, 0xFFFF):
                raise DialectError(f"{field.name} {code!r} is no command code from 0x0000 to 0xFFFF")
            if code in seen:
                raise DialectError(f"{field.name} and {seen[code]} are both {code:#06x}")
            seen[code] = field.name

    @property
    def crc_parameters(self) -> Crc16:
        """The CRC itself. Raises: DialectError: no CRC has this name."""
        if isinstance(self.crc, Crc16):
            return self.crc
        if self.crc not in NAMED:
            raise DialectError(unknown("crc", str(self.crc), NAMED))
        return NAMED[self.crc]

    @property
    def has_dist(self) -> bool:
        """Whether answers carry DIST and path elements DIST_ACT and DIST_NEXT: document A only (I8, I9)."""
        return self.barcode_bytes == 4

    def show_dev_id(self, dev_id: int) -> str:
        """Return a DEV_ID as people write it: a number, or its four characters (I22)."""
        if self.dev_id_format == "uint":
            return str(dev_id)
        characters = dev_id.to_bytes(4, self.byte_order).rstrip(b"\0 ")
        return characters.decode("latin-1") if characters.isascii() else f"0x{dev_id:08X}"

    @classmethod
    def from_mapping(cls, mapping: Mapping[str, Any], base: "Dialect | None" = None) -> "Dialect":
        """Return the base (the default dialect) overlaid with the mapping's entries.

        ``crc`` may be a name or a mapping of Rocksoft parameters (``poly``, ``init``, ``refin``, ``refout``, ``xorout``).
        Raises: DialectError: an unknown key or name, with the nearest known one, or a value that cannot be.
        """
        known = {field.name for field in fields(cls)}
        for key in mapping:
            if key not in known:
                raise DialectError(unknown("dialect field", str(key), known))
        changes = dict(mapping)
        if isinstance(changes.get("crc"), Mapping):
            changes["crc"] = _crc_from_mapping(changes["crc"])
        return replace(base or cls(), **changes)


def _is_number(value: object, low: int, high: int) -> bool:
    return isinstance(value, int) and not isinstance(value, bool) and low <= value <= high


def _crc_from_mapping(mapping: Mapping[str, Any]) -> Crc16:
    known = {field.name for field in fields(Crc16)} | {"width", "check", "name"}
    for key in mapping:
        if key not in known:
            raise DialectError(unknown("crc parameter", str(key), known))
    if mapping.get("width", 16) != 16:
        raise DialectError(f"crc width {mapping['width']!r}: iTSC's CRC field has 16 bits")
    try:
        return Crc16(**{key: value for key, value in mapping.items() if key not in ("width", "check", "name")})
    except (TypeError, ValueError) as wrong:
        raise DialectError(f"crc: {wrong}") from None


DEFAULT = Dialect()
"""Document B with our conventions."""

DIALECTS: Mapping[str, Dialect] = MappingProxyType(
    {
        "default": DEFAULT,
        "slides": Dialect(barcode_bytes=4),
        "little": Dialect(byte_order="little", crc_order="little"),
        "crc-xmodem": Dialect(crc="xmodem"),
        "crc-kermit": Dialect(crc="kermit", crc_order="little"),
        "crc-x25": Dialect(crc="x25", crc_order="little"),
        "crc-arc": Dialect(crc="arc", crc_order="little"),
        "crc-modbus": Dialect(crc="modbus", crc_order="little"),
        "crc-swapped": Dialect(crc_order="little"),
        "crc-no-type": Dialect(crc_covers_type=False),
        "etb-no-sub-crc": Dialect(etb=EtbLayout.HEAD_CRC_SUB),
        "etb-one-crc": Dialect(etb=EtbLayout.HEAD_SUB_CRC),
        "ascii-barcode": Dialect(barcode_format="ascii"),
        "space-pad": Dialect(pad=0x20),
    }
)
"""The named presets: document B, document A's slides, and one for each switch that a device may turn."""


def dialect_named(name: str) -> Dialect:
    """Return a preset, with or without the prefix ``itsc.``. Raises: DialectError: with the nearest known name."""
    found = DIALECTS.get(name.removeprefix(PREFIX))
    if found is None:
        raise DialectError(unknown("iTSC dialect", name, DIALECTS))
    return found
