"""Which format a file has, told from what is in it."""

from enum import StrEnum
from typing import Any

from app.plant.exchange.report import UnreadableLayout
from app.plant.exchange.xml_text import Element, local


class Format(StrEnum):
    """A format that layouts are read from."""

    CSV = "csv"
    XLSX = "xlsx"
    LIF = "lif"
    OPENTCS = "opentcs"
    NODE_LINK = "node-link"
    GRAPHML = "graphml"


_ZIP, _OLE = b"PK\x03\x04", b"\xd0\xcf\x11\xe0"
JSON_FORMATS = frozenset({Format.LIF, Format.NODE_LINK})
XML_FORMATS = frozenset({Format.OPENTCS, Format.GRAPHML})


def family(data: bytes) -> str:
    """Return ``workbook``, ``xml``, ``json`` or ``text``, by the first bytes.

    Raises: UnreadableLayout: it is a plant file, or empty.
    """
    if not data.strip(b" \t\r\n\0"):
        raise UnreadableLayout("the file is empty")
    if data.startswith((_ZIP, _OLE)):
        return "workbook"
    start = data[:2000].replace(b"\0", b"").lstrip(b"\xef\xbb\xbf\xff\xfe \t\r\n")
    if start.startswith(b"<"):
        return "xml"
    if start.startswith((b"{", b"[")):
        return "json"
    head = data[:200_000].splitlines()
    if any(line.startswith(b"barcodes:") for line in head) and any(line.startswith(b"track:") for line in head):
        raise UnreadableLayout("this is a plant file already", remedy="see what is wrong with it: hoistway check FILE")
    return "text"


def of_json(data: Any) -> Format:
    """Return the format of what a JSON file holds. Raises: UnreadableLayout: none that is read."""
    keys = {str(key).casefold() for key in data} if isinstance(data, dict) else set()
    first = data[0] if isinstance(data, list) and data and isinstance(data[0], dict) else {}
    if "layouts" in keys or "metainformation" in keys or "nodes" in first:
        return Format.LIF
    if "features" in keys:
        raise UnreadableLayout("GeoJSON is written, not read: it does not say which mark comes next")
    if "nodes" in keys:
        edges = data.get("edges", data.get("links")) or [{}]
        nodes = data.get("nodes") or [{}]
        samples = [item[0] for item in (nodes, edges) if isinstance(item, list) and item and isinstance(item[0], dict)]
        is_lif = any("nodeId" in sample or "startNodeId" in sample for sample in samples)
        return Format.LIF if is_lif else Format.NODE_LINK
    known = "a LIF file has layouts, a node-link graph has nodes and links"
    raise UnreadableLayout("this JSON is no layout that is known", remedy=known)


def of_xml(root: Element) -> Format:
    """Return the format of an XML file. Raises: UnreadableLayout: none that is read."""
    if (found := {"model": Format.OPENTCS, "graphml": Format.GRAPHML}.get(local(root))) is not None:
        return found
    known = "openTCS begins with <model>, GraphML with <graphml>"
    raise UnreadableLayout(f"this XML is no layout that is known: it begins with <{local(root)}>", remedy=known)
