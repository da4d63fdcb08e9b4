"""Catalogue files: the parameters of a drive model, read and checked like a plant file (PROTOCOLS H23)."""

import re
from decimal import Decimal
from typing import Annotated

from msgspec import UNSET, Meta, UnsetType

from app.domain.catalogue import HIGHEST_RAW, Catalogue, ParameterSpec
from app.domain.drive import Parameter, RawValue
from app.plant.convert import FAILED, convert
from app.plant.document import Document, Path, Unreadable
from app.plant.findings import Finding, UnusablePlant
from app.plant.format import Strict

Value = Annotated[float, Meta(description="A value in the parameter's unit")]
Scale = Annotated[float, Meta(description="One raw step in the parameter's unit")]
_NUMBER = re.compile(r"[0-9A-F]{2}")


class ParameterIn(Strict, frozen=True):
    """A parameter. ``min``, ``max`` and ``default`` are values in the unit, ``choices`` words for raw values."""

    name: str
    min: Value
    max: Value
    unit: str = ""
    scale: Scale = 1.0
    default: Value | UnsetType = UNSET
    read_only: bool = False
    while_running: bool = False
    description: str = ""
    choices: dict[str, str] = {}


class CatalogueFile(Strict, frozen=True):
    """The file as a whole."""

    parameters: dict[str, ParameterIn]
    description: str = ""


def read_catalogue(text: str, model: str) -> tuple[Catalogue, list[Finding]]:
    """Return the catalogue that a file's text describes, and the warnings about it, in the order of the file.

    Raises: UnusablePlant: the file has errors; it holds all findings.
    """
    try:
        document = Document(text, "the catalogue")
    except Unreadable as wrong:
        raise UnusablePlant(model, wrong.findings) from None
    file = convert(document, document.root, CatalogueFile)
    parameters: dict[Parameter, ParameterSpec] = {}
    names: dict[str, str] = {}
    for key, given in () if file is FAILED else file.parameters.items():
        spec = _parameter(document, key, given)
        if given.name in names:
            message = f"{key} and {names[given.name]} are both called {given.name}"
            document.warn(("parameters", key, "name"), message, "people will take one for the other")
        names.setdefault(given.name, key)
        if spec is not None:
            parameters[spec.number] = spec
    findings = sorted(document.findings, key=lambda finding: (finding.line, finding.column))
    if file is FAILED or document.has_errors:
        raise UnusablePlant(model, findings)
    return Catalogue(model, file.description, parameters), findings


def _parameter(document: Document, key: str, given: ParameterIn) -> ParameterSpec | None:
    path: Path = ("parameters", key)
    if not _NUMBER.fullmatch(key):
        message = f"{key!r} is no parameter number"
        document.error(path, message, 'write two hexadecimal digits in quotes, such as "1C"', key=True)
        return None
    if given.scale <= 0:
        document.error((*path, "scale"), f"the scale of {key} is not above 0", "it is what one raw step is worth")
        return None
    lowest = _raw(document, path, "min", given.min, given.scale)
    highest = _raw(document, path, "max", given.max, given.scale)
    default = None if given.default is UNSET else _raw(document, path, "default", given.default, given.scale)
    if lowest is None or highest is None:
        return None
    if lowest > highest:
        document.error((*path, "min"), f"min {given.min:g} of {key} is above its max {given.max:g}", "swap them")
    if default is not None and not lowest <= default <= highest:
        document.error((*path, "default"), f"the default of {key} is not from {given.min:g} to {given.max:g}")
    if given.read_only and given.while_running:
        document.error((*path, "while_running"), f"{key} is read-only, so it is not written while running", "keep one")
    return ParameterSpec(
        number=Parameter(int(key, 16)),
        name=given.name,
        unit=given.unit,
        scale=given.scale,
        decimals=_decimals(given.scale),
        lowest=lowest,
        highest=highest,
        default=default,
        read_only=given.read_only,
        while_running=given.while_running,
        description=given.description,
        choices=_choices(document, path, given, lowest, highest),
    )


def _raw(document: Document, path: Path, field: str, value: float, scale: float) -> RawValue | None:
    raw = round(value / scale)
    if abs(raw * scale - value) > scale / 1000:
        message = f"{field} {value:g} lies between two steps of {scale:g}"
        document.error((*path, field), message, f"write {round(raw * scale, _decimals(scale)):g}, or another scale")
        return None
    if not 0 <= raw <= HIGHEST_RAW:
        message = f"{field} {value:g} is {raw} on the wire, which carries 0 to {HIGHEST_RAW}"
        document.error((*path, field), message, "check the value and the scale")
        return None
    return RawValue(raw)


def _decimals(scale: float) -> int:
    exponent = Decimal(str(scale)).normalize().as_tuple().exponent
    return max(0, -exponent) if isinstance(exponent, int) else 0


def _choices(document: Document, path: Path, given: ParameterIn, lowest: int, highest: int) -> dict[int, str]:
    found = {}
    for key, word in given.choices.items():
        if key.isascii() and key.isdigit() and len(key) <= 4 and lowest <= int(key) <= highest:
            found[int(key)] = word
        else:
            message = f"choice {key!r} is no raw value from {lowest} to {highest}"
            document.error((*path, "choices", key), message, "choices are named by raw values", key=True)
    return found
