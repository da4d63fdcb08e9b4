"""Names, ranges of barcodes and addresses, as they are written in a plant file."""

import re

MAX_RANGE = 100_000
"""Most barcodes in one range. Our choice."""

DISPLAY_BYTES = 16
"""Room for a name on the vehicle (PROTOCOLS 1.6: FOUP ID, SOURCE, DESTINATION)."""

ID_RULE = "letters, digits and . _ - : + @ only, at most 64, beginning with a letter or digit"
_ID = re.compile(r"[A-Za-z0-9][A-Za-z0-9._:+@-]{0,63}")
_BARCODE = re.compile(r"[!-~]{1,16}")
_RANGE = re.compile(r"(?P<prefix>[!-~]*?)(?P<first>[0-9]{1,12})\.\.(?P=prefix)(?P<last>[0-9]{1,12})")
_ADDRESS = re.compile(r"(?P<host>\[[0-9A-Fa-f:.]+\]|[A-Za-z0-9._-]+)(:(?P<port>[0-9]{1,5}))?")


def is_id(text: str) -> bool:
    """Whether the text can name a station, vehicle, zone or carrier: it stands in addresses of the REST interface."""
    return _ID.fullmatch(text) is not None


def is_barcode(text: str) -> bool:
    """Whether the text can name a barcode: 1 to 16 visible ASCII characters."""
    return _BARCODE.fullmatch(text) is not None and ".." not in text


def is_range(text: str) -> bool:
    """Whether the text means a range of barcodes, well written or not."""
    return ".." in text


def expand(text: str) -> tuple[str, ...]:
    """Return the barcodes of ``1001..1020``, ``A01..A20`` or, downwards, ``1020..1001``.

    Numbers keep their leading zeros if both ends are written with as many digits. Raises: ValueError: no range, or one
    longer than MAX_RANGE, in a sentence.
    """
    match = _RANGE.fullmatch(text)
    if match is None:
        raise ValueError(f"{text!r} is no range of barcodes: write it as 1001..1020 or A01..A20")
    first, last, prefix = match["first"], match["last"], match["prefix"]
    if len(first) != len(last) and (first.startswith("0") or last.startswith("0")):
        raise ValueError(f"the ends of {text} have different numbers of digits")
    step = 1 if int(last) >= int(first) else -1
    if abs(int(last) - int(first)) >= MAX_RANGE:
        raise ValueError(f"{text} has more than {MAX_RANGE} barcodes")
    width = len(first) if len(first) == len(last) else 0
    return tuple(f"{prefix}{number:0{width}d}" for number in range(int(first), int(last) + step, step))


def address(text: str) -> tuple[str, int]:
    """Return host and port, port 0 if none is given. Raises: ValueError: no address, in a sentence."""
    match = _ADDRESS.fullmatch(text)
    if match is None:
        raise ValueError(f"{text!r} is no address: write HOST:PORT, such as 10.0.0.17:9000")
    port = int(match["port"]) if match["port"] else 0
    if match["port"] and not 1 <= port <= 65_535:
        raise ValueError(f"port {match['port']} is outside 1..65535")
    return match["host"].strip("[]"), port
