"""From the tree to typed structs, noting every mistake instead of stopping at the first."""

import types
from enum import StrEnum
from functools import cache
from typing import Annotated, Any, Final, Union, get_args, get_origin

import msgspec
from msgspec import Meta, UnsetType

from app.plant.document import NO_YAML, Document, Mapping, Node, Path, Scalar, Sequence, path_text, plain
from app.wire.names import nearest


class Failed:
    """Stands for a value that could not be read; its finding is noted."""


FAILED: Final = Failed()


def convert(document: Document, node: Node, wanted: Any, path: Path = ()) -> Any:
    """Return the node as the wanted type, or FAILED if a mistake in it leaves nothing to go on with.

    Mappings of names and lists of structs come back without the items that failed; a struct fails when one of its fields
    does, but for the file as a whole. ``wanted`` is a type of ``app.plant.format``.
    """
    for choice in _choices(wanted):
        bare, meta = _stripped(choice)
        match node:
            case Mapping() if _is_struct(bare):
                return _struct(document, node, bare, path)
            case Mapping() if get_origin(bare) is dict and get_args(bare)[1] is not Any:
                return _items(document, node, get_args(bare)[1], path)
            case Sequence() if get_origin(bare) is list:
                return _list(document, node, get_args(bare)[0], meta, path)
            case Sequence() if get_origin(bare) is tuple and len(get_args(bare)) == len(node.items):
                return _tuple(document, node, get_args(bare), path)
    return _leaf(document, node, wanted, path)


def _struct(document: Document, node: Mapping, wanted: Any, path: Path) -> Any:
    fields = _fields(wanted)
    failed = False
    values = {}
    for key, item in node.items.items():
        if key not in fields:
            failed = True
            _unknown_key(document, key, fields, path)
            continue
        value = convert(document, item, fields[key].type, (*path, key))
        failed |= value is FAILED
        values[fields[key].name] = value
    for key, field in fields.items():
        if field.required and key not in node.items:
            failed = True
            what = path_text(path) or document.what
            document.error(path, f"{what} has no {key}", f"add {key}: {expected(field.type)}", key=True)
    if failed and path:
        return FAILED
    # The file as a whole never fails: what could be read of it is still worth checking.
    kept = {name: value for name, value in values.items() if value is not FAILED}
    for field in fields.values():
        if field.required and field.name not in kept:
            kept[field.name] = get_origin(_stripped(field.type)[0])()
    return wanted(**kept)


@cache
def _fields(wanted: Any) -> dict[str, Any]:
    return {field.encode_name: field for field in msgspec.structs.fields(wanted)}


def _unknown_key(document: Document, key: str, known: Any, path: Path) -> None:
    close = nearest(key, known)
    remedy = f"did you mean {close}?" if close else f"known here: {', '.join(known)}"
    where = f" in {path_text(path)}" if path else ""
    document.error((*path, key), f"unknown key {key!r}{where}", remedy, key=True)


def _items(document: Document, node: Mapping, wanted: Any, path: Path) -> dict[str, Any]:
    found = ((key, convert(document, item, wanted, (*path, key))) for key, item in node.items.items())
    return {key: value for key, value in found if value is not FAILED}


def _list(document: Document, node: Sequence, wanted: Any, meta: Meta | None, path: Path) -> Any:
    if meta is not None and len(node.items) < (meta.min_length or 0):
        document.error(path, f"{path_text(path)} is empty", f"give at least {meta.min_length}")
        return FAILED
    found = [convert(document, item, wanted, (*path, position)) for position, item in enumerate(node.items)]
    if FAILED in found and not _is_struct(_stripped(wanted)[0]):
        return FAILED
    document.dropped.update((*path, position) for position, value in enumerate(found) if value is FAILED)
    return [value for value in found if value is not FAILED]


def _tuple(document: Document, node: Sequence, wanted: tuple[Any, ...], path: Path) -> Any:
    pairs = enumerate(zip(node.items, wanted, strict=True))
    found = tuple(convert(document, item, choice, (*path, position)) for position, (item, choice) in pairs)
    return FAILED if FAILED in found else found


def _leaf(document: Document, node: Node, wanted: Any, path: Path) -> Any:
    try:
        return msgspec.convert(plain(node), wanted)
    except msgspec.ValidationError:
        message = f"{path_text(path) or document.what}: expected {expected(wanted)}, got {_shown(node)}"
        document.error(path, message, _remedy(node, wanted) if path else NO_YAML)
        return FAILED


def _remedy(node: Node, wanted: Any) -> str:
    bare, meta = _stripped(wanted)
    if isinstance(bare, type) and issubclass(bare, StrEnum) and isinstance(node, Scalar):
        close = nearest(node.text, [member.value for member in bare])
        return f"did you mean {close}?" if close else ""
    if bare is str and isinstance(node, Scalar) and node.value is not None:
        return "write it in quotes"
    unit = (meta.extra or {}).get("unit") if meta is not None else None
    if unit and isinstance(node, Scalar) and not isinstance(node.value, int):
        return f"write the number alone: a whole number of {unit}"
    return ""


def expected(wanted: Any) -> str:
    """Return in words what may stand where this type is wanted."""
    bare, meta = _stripped(wanted)
    origin = get_origin(bare)
    if origin in (Union, types.UnionType):
        parts = (part for part in get_args(bare) if part is not UnsetType)
        return " or ".join(dict.fromkeys(expected(part) for part in parts))
    if origin is tuple:
        return f"[{', '.join(expected(part) for part in get_args(bare))}]"
    if origin is list:
        return "a list"
    if origin is dict or _is_struct(bare):
        return "a mapping"
    if issubclass(bare, StrEnum):
        return " or ".join(member.value for member in bare)
    return {bool: "true or false", str: "text", int: _range_text(meta), float: _range_text(meta, "a number")}[bare]


def _range_text(meta: Meta | None, what: str = "a whole number") -> str:
    if meta is None or meta.ge is None:
        return what
    unit = (meta.extra or {}).get("unit")
    return f"{what}{f' of {unit}' if unit else ''} from {meta.ge} to {meta.le}"


def _shown(node: Node) -> str:
    match node:
        case Sequence():
            return "a list" if not node.items else f"a list of {len(node.items)}"
        case Mapping():
            return "a mapping"
        case Scalar(value=None):
            return "nothing"
        case Scalar(value=str()):
            return f"text {node.text[:40]!r}"
        case Scalar():
            return node.text


@cache
def _stripped(wanted: Any) -> tuple[Any, Meta | None]:
    """Return the type without UNSET and annotations, and its Meta."""
    if get_origin(wanted) in (Union, types.UnionType):
        parts = [part for part in get_args(wanted) if part is not UnsetType]
        return _stripped(parts[0]) if len(parts) == 1 else (wanted, None)
    if get_origin(wanted) is Annotated:
        bare, meta = get_args(wanted)[:2]
        return bare, meta
    return wanted, None


@cache
def _choices(wanted: Any) -> tuple[Any, ...]:
    """Return the types of a union, or the type alone."""
    bare = _stripped(wanted)[0]
    return get_args(bare) if get_origin(bare) in (Union, types.UnionType) else (wanted,)


@cache
def _is_struct(bare: Any) -> bool:
    return isinstance(bare, type) and issubclass(bare, msgspec.Struct)
