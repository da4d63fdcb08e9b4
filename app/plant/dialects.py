"""The dialects that a plant's vehicles speak: presets, and the plant file's overlays of them."""

from app.domain.layout import LinkSpec, Plant
from app.plant.document import Document
from app.protocols.enig import dialects as enig
from app.protocols.hi import dialects as hi
from app.protocols.itsc.dialects import DIALECTS, Dialect, DialectError
from app.wire.names import nearest

Overlays = dict[str, dict[str, object]]


def dialect_of(plant: Plant, name: str) -> Dialect:
    """Return the dialect that a vehicle of this plant names. Raises: DialectError: no such name."""
    return resolve(plant.dialects, name)


def hall_dialect_of(link: LinkSpec) -> enig.Dialect:
    """Return the dialect of an ENIG link. Raises enig.DialectError: a field or preset that cannot be."""
    overlay = dict(link.dialect)
    preset = enig.dialect_named(str(overlay.pop("preset", "default")))
    return enig.Dialect.from_mapping(overlay, preset)


def drive_dialect_of(link: LinkSpec) -> hi.Dialect:
    """Return the dialect of an HI line. Raises hi.DialectError: a field or preset that cannot be."""
    overlay = dict(link.dialect)
    preset = hi.dialect_named(str(overlay.pop("preset", "default")))
    return hi.Dialect.from_mapping(overlay, preset)


def resolve(overlays: Overlays, name: str) -> Dialect:
    """Return a preset, or an overlay's dialect. Raises: DialectError: neither has this name, or a value cannot be."""
    if name in overlays:
        overlay = dict(overlays[name])
        preset = str(overlay.pop("preset", "default"))
        return Dialect.from_mapping(overlay, DIALECTS[preset])
    if name not in DIALECTS:
        close = nearest(name, [*DIALECTS, *overlays])
        raise DialectError(f"unknown dialect {name!r}", remedy=f"did you mean {close}?" if close else "")
    return DIALECTS[name]


def check_overlays(document: Document, overlays: Overlays) -> Overlays:
    """Return the overlays that make a dialect; the others' mistakes are noted, each at its key."""
    return {name: overlay for name, overlay in overlays.items() if _is_sound(document, name, overlay)}


def _is_sound(document: Document, name: str, overlay: dict[str, object]) -> bool:
    path = ("dialects", name)
    if name in DIALECTS:
        document.error(path, f"{name} is the name of a preset", "choose another name for your dialect", key=True)
        return False
    preset = overlay.get("preset", "default")
    if preset not in DIALECTS:
        close = nearest(str(preset), DIALECTS)
        remedy = f"did you mean {close}?" if close else f"presets: {', '.join(DIALECTS)}"
        document.error((*path, "preset"), f"unknown preset {preset!r}", remedy)
        return False
    fields = {key: value for key, value in overlay.items() if key != "preset"}
    wrong = [key for key, value in fields.items() if not _fits(document, name, key, value)]
    if wrong:
        return False
    try:
        Dialect.from_mapping(fields, DIALECTS[str(preset)])
    except DialectError as error:
        document.error(path, f"dialect {name}: {error.message}", error.remedy, key=True)
        return False
    return True


def _fits(document: Document, name: str, key: str, value: object) -> bool:
    try:
        Dialect.from_mapping({key: value})
    except DialectError as error:
        # A clash with another field's default may be lifted by the rest of the overlay, so it is judged as a whole.
        if " are both " in error.message:
            return True
        unknown_key = error.message.startswith("unknown dialect field")
        document.error(("dialects", name, key), error.message, error.remedy, key=unknown_key)
        return False
    return True
