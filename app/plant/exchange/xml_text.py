"""XML that others wrote: read without entities, document types or anything from outside the file."""

import re
from collections.abc import Iterator
from typing import Any

from app.plant.exchange.numbers import WANTED, number
from app.plant.exchange.report import Report, UnreadableLayout, shown

_ENTITY = re.compile(rb"<!\s*(ENTITY|DOCTYPE)", re.IGNORECASE)
_DEEPEST = 64
Element = Any


def parsed(data: bytes, name: str) -> Element:
    """Return the root of an XML file. Raises: UnreadableLayout: it is none, with line and column, or it declares entities."""
    from lxml import etree

    if _ENTITY.search(data) or _ENTITY.search(data.replace(b"\0", b"")):
        what = f"{name} declares a document type or entities, which layouts have no need of: refused"
        raise UnreadableLayout(what, remedy="export it anew without a DOCTYPE")
    parser = etree.XMLParser(
        resolve_entities=False,
        no_network=True,
        load_dtd=False,
        dtd_validation=False,
        huge_tree=False,
        remove_comments=True,
    )
    try:
        return etree.fromstring(data, parser)
    except etree.XMLSyntaxError as wrong:
        line, column = wrong.position
        cut = "premature end" in str(wrong.msg).casefold() or "EndTag" in str(wrong.msg)
        remedy = "the file ends in the middle: was it copied whole?" if cut else "correct it there"
        raise UnreadableLayout(
            f"{name} is no XML: line {line}, column {column}: {_expected(wrong)}", remedy=remedy
        ) from None
    except (ValueError, LookupError):
        raise UnreadableLayout(
            f"{name} is no XML that can be read: its encoding is not the one that it names", remedy="save it as UTF-8"
        ) from None


_EXPECTED = {
    "ERR_DOCUMENT_EMPTY": "an element is expected here",
    "ERR_DOCUMENT_END": "the outermost element has ended before this",
    "ERR_TAG_NAME_MISMATCH": "the end of another element is expected here: elements must not overlap",
    "ERR_TAG_NOT_FINISHED": "an element that has begun is not ended",
    "ERR_GT_REQUIRED": "the tag has no >",
    "ERR_SPACE_REQUIRED": "a blank is expected here",
    "ERR_NAME_REQUIRED": "a name is expected here: < and & in a text are written &lt; and &amp;",
    "ERR_LT_IN_ATTRIBUTE": "in an attribute < is written &lt;",
    "ERR_ATTRIBUTE_NOT_STARTED": "the value of an attribute is written in quotation marks",
    "ERR_ATTRIBUTE_NOT_FINISHED": "the value of an attribute has no closing quotation mark",
    "ERR_ATTRIBUTE_WITHOUT_VALUE": "the attribute has no value",
    "ERR_ATTRIBUTE_REDEFINED": "the element has this attribute already",
    "ERR_UNDECLARED_ENTITY": "this entity is none of XML's own: & is written &amp;",
    "ERR_ENTITYREF_SEMICOL_MISSING": "an entity ends in a semicolon: & is written &amp;",
    "ERR_INVALID_CHAR": "this character is none that XML may have",
    "ERR_INVALID_ENCODING": "these bytes are none of the encoding that the file names",
    "ERR_UNSUPPORTED_ENCODING": "the encoding that the file names is not known",
    "NS_ERR_UNDEFINED_NAMESPACE": "the prefix before the colon is declared nowhere",
}


def _expected(wrong: Any) -> str:
    """Return what XML wants where it is broken, in our words."""
    from lxml import etree

    said = next((ours for kind, ours in _EXPECTED.items() if getattr(etree.ErrorTypes, kind) == wrong.code), "")
    return said or f"this cannot stand here ({shown(str(wrong.msg).partition(', line ')[0])})"


def local(element: Element) -> str:
    """Return an element's name without its namespace; empty for what is no element."""
    return element.tag.rpartition("}")[2] if isinstance(element.tag, str) else ""


def children(element: Element, name: str) -> Iterator[Element]:
    """Give the children of this name, whatever their namespace."""
    return (child for child in element if local(child) == name)


def child(element: Element, name: str) -> Element | None:
    """Return the first child of this name."""
    return next(children(element, name), None)


def place(element: Element, name: str) -> str:
    """Return where an element stands: its kind, its name, its line."""
    return f"{local(element)} {shown(name)} (line {element.sourceline})"


def numeral(element: Element, names: tuple[str, ...], where: str, report: Report) -> float | None:
    """Return the first of these attributes as a number; None if there is none, or NaN, or with a note if it is no number."""
    given = next((element.get(name) for name in names if element.get(name) is not None), None)
    if given is None or not given.strip():
        return None
    try:
        return number(given)
    except ValueError:
        report.wrong(where, f"{names[0]}: no number", WANTED, was=given)
        return None
