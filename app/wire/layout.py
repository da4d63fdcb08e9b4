"""Fixed layouts declared as rows of fields, compiled once to one ``struct.Struct`` each way."""

import operator
import struct
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any, Generic, Literal, TypeVar

ByteOrder = Literal["big", "little"]
T = TypeVar("T")
_PREFIX = {"big": ">", "little": "<"}


class FieldError(ValueError):
    """A field's value does not fit its place; the message names the field, the value and what fits."""


@dataclass(frozen=True, slots=True)
class Field:
    """One field: its attribute, its ``struct`` code, and how a value is changed on the way in and out.

    A field without a name is filler: zeros when written, ignored when read.
    """

    name: str
    code: str
    fits: str
    read: Callable[[Any], Any] | None = None
    write: Callable[[Any], Any] | None = None


def u8(name: str) -> Field:
    """Return an unsigned byte."""
    return Field(name, "B", "0..255")


def u16(name: str, *, write: Callable[[Any], Any] | None = None) -> Field:
    """Return an unsigned field of two bytes."""
    return Field(name, "H", "0..65535", write=write)


def u32(name: str, *, read: Callable[[Any], Any] | None = None, write: Callable[[Any], Any] | None = None) -> Field:
    """Return an unsigned field of four bytes."""
    return Field(name, "I", "0..4294967295", read, write)


def i32(name: str) -> Field:
    """Return a signed field of four bytes."""
    return Field(name, "i", "-2147483648..2147483647")


def wide(name: str, size: int, order: ByteOrder) -> Field:
    """Return an unsigned field of any number of bytes, such as six."""

    def write(value: int) -> bytes:
        return value.to_bytes(size, order)

    def read(data: bytes) -> int:
        return int.from_bytes(data, order)

    return Field(name, f"{size}s", f"0..{(1 << 8 * size) - 1}", read, write)


def text(name: str, size: int, pad: int) -> Field:
    """Return a left-justified text of single-byte characters, padded; reading strips zeros and blanks at the end."""
    filler = bytes([pad])

    def write(value: str) -> bytes:
        data = value.encode("latin-1")
        if len(data) > size:
            raise ValueError
        return data.ljust(size, filler)

    def read(data: bytes) -> str:
        return data.rstrip(b"\0 ").decode("latin-1")

    return Field(name, f"{size}s", f"a text of at most {size} characters", read, write)


def raw(name: str, size: int) -> Field:
    """Return a run of bytes kept as they are."""

    def write(value: bytes) -> bytes:
        if len(value) != size:
            raise ValueError
        return value

    return Field(name, f"{size}s", f"{size} bytes", None, write)


def filler(size: int) -> Field:
    """Return bytes that mean nothing."""
    return Field("", f"{size}x", "")


def word(order: ByteOrder, *fields: Field) -> tuple[Field, ...]:
    """Return the parts of one word, given most significant first, in the order in which they stand on the wire."""
    return fields if order == "big" else fields[::-1]


class Layout(Generic[T]):
    """Reads and writes records of one class; ``make`` takes the named fields by position.

    ``fields`` gives them in their order on the wire and ``arguments`` the names in ``make``'s order, if that differs.
    """

    __slots__ = ("_get", "_make", "_named", "_order", "_reads", "_shuffle", "_struct", "_writes", "names", "size")

    def __init__(
        self, order: ByteOrder, fields: Iterable[Field], make: Callable[..., T], arguments: Iterable[str] = ()
    ) -> None:
        rows = tuple(fields)
        self._order = order
        self._make = make
        self._named = tuple(row for row in rows if row.name)
        self._struct = struct.Struct(_PREFIX[order] + "".join(row.code for row in rows))
        self._reads = tuple((i, row.read) for i, row in enumerate(self._named) if row.read is not None)
        self._writes = tuple((i, row.write) for i, row in enumerate(self._named) if row.write is not None)
        self.names = tuple(row.name for row in self._named)
        wanted = tuple(arguments) or self.names
        self._shuffle = None if wanted == self.names else tuple(self.names.index(name) for name in wanted)
        self._get = operator.attrgetter(*self.names) if self.names else None
        self.size = self._struct.size

    def read(self, data: bytes, at: int = 0) -> T:
        """Return the record that stands at an offset; needs ``size`` bytes there and never fails on their content."""
        values: Any = self._struct.unpack_from(data, at)
        if self._reads:
            values = list(values)
            for i, read in self._reads:
                values[i] = read(values[i])
        if self._shuffle is not None:
            values = [values[i] for i in self._shuffle]
        return self._make(*values)

    def write(self, record: T) -> bytes:
        """Return the record's bytes. Raises: FieldError: a value does not fit."""
        values = self._values(record)
        try:
            for i, write in self._writes:
                values[i] = write(values[i])
            return self._struct.pack(*values)
        except (struct.error, ValueError, OverflowError, AttributeError, TypeError):
            raise self._complaint(record) from None

    def _values(self, record: T) -> list[Any]:
        if self._get is None:
            return []
        got = self._get(record)
        return list(got) if len(self.names) > 1 else [got]

    def _complaint(self, record: T) -> FieldError:
        for row, value in zip(self._named, self._values(record), strict=True):
            try:
                struct.pack(_PREFIX[self._order] + row.code, row.write(value) if row.write else value)
            except (struct.error, ValueError, OverflowError, AttributeError, TypeError) as wrong:
                why = wrong.args[0] if type(wrong) is ValueError and wrong.args else row.fits
                return FieldError(f"{row.name} {value!r} does not fit: {why}")
        raise AssertionError("each field fits alone, so the whole fits")
