"""Tables out of files: CSV with whatever encoding and delimiter, XLSX, XLS and ODS."""

import codecs
import csv
import io
import re
import zipfile
import zlib
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from app.plant.exchange.columns import Column, columns_of, fold, unit_in
from app.plant.exchange.report import Report, UnreadableLayout, listed, shown

ENCODINGS = ("utf-8", "cp949", "shift_jis", "gb18030", "cp1252")
"""Tried in this order; the first in which most columns are understood counts."""
DELIMITERS = ",;\t|"
HEADER_WITHIN = 30
"""Rows in which the names of the columns are looked for. Our choice."""
MOST_ROWS = 500_000
UNPACKED_LIMIT = 512 << 20
"""Largest size of a workbook's parts together, bytes: a small file may unpack to fill the memory. Our choice."""
MOST_CELLS = 20_000_000
"""Cells of one sheet, empty ones between others included. Our choice."""
_CELL = re.compile(rb'<(?:\w+:)?c\b[^>]*?\br=[\'"]([A-Z]{1,8})(\d{1,12})[\'"]')
_BOMS = (
    (codecs.BOM_UTF8, "utf-8-sig"),
    (codecs.BOM_UTF32_LE, "utf-32"),  # before UTF-16, whose mark it begins with
    (codecs.BOM_UTF32_BE, "utf-32"),
    (codecs.BOM_UTF16_LE, "utf-16"),
    (codecs.BOM_UTF16_BE, "utf-16"),
)
Cell = object
Row = Sequence[Cell]


@dataclass(frozen=True, slots=True)
class Table:
    """Rows of one sheet with the columns that are understood; each row with its number in the file, from 1."""

    name: str
    columns: list[Column]
    rows: list[tuple[int, Row]]
    unknown: list[str]

    def where(self, row: int) -> str:
        """Return the place of a row for people."""
        return f"{self.name} row {row}" if self.name else f"row {row}"

    def has(self, *roles: str) -> bool:
        """Whether all of these are columns."""
        return set(roles) <= {column.role for column in self.columns}


def tables_of_text(data: bytes, name: str, encoding: str, report: Report) -> list[Table]:
    """Return the table of a CSV file. ``encoding``: a person's word, empty: found out. Raises: UnreadableLayout."""
    chosen, text = _decoded(data, encoding)
    delimiter = _delimiter(text)
    rows = list(_csv_rows(text, delimiter))
    table = _table("", rows)
    if table is None:
        raise UnreadableLayout(f"{name}: no row names columns that are known", remedy=_known_columns(rows))
    named = {",": "comma", ";": "semicolon", "\t": "tab", "|": "bar"}[delimiter]
    report.source = f"CSV, {chosen.upper()}, {named}"
    return [table]


def _decoded(data: bytes, encoding: str) -> tuple[str, str]:
    encoding = encoding or next((name for mark, name in _BOMS if data.startswith(mark)), "")
    if not encoding and b"\0" in data[:4096]:
        encoding = _wide(data[:4096])
    names = (encoding,) if encoding else ENCODINGS
    found = [(name, text) for name in names if (text := _try(data, name)) is not None]
    if not found:
        raise UnreadableLayout(f"this is no text in {listed(names)}", remedy="name its encoding with --encoding")
    best = max(found, key=lambda pair: _understood(pair[1]))
    return best[0].removesuffix("-sig"), best[1]


def _wide(head: bytes) -> str:
    """Return the encoding of text with zero bytes: two or four bytes a letter. Raises UnreadableLayout: it is no text."""
    zeros = [head[place::4].count(0) for place in range(4)]
    often = len(head) // 6
    if zeros[1] > often and zeros[2] > often:
        return "utf-32-le" if zeros[3] > zeros[0] else "utf-32-be"
    even, odd = zeros[0] + zeros[2], zeros[1] + zeros[3]
    if max(even, odd) * 3 < len(head):
        raise UnreadableLayout("this is no text: it holds zero bytes", remedy="give CSV, XLSX, JSON or XML")
    return "utf-16-le" if odd > even else "utf-16-be"


def _try(data: bytes, encoding: str) -> str | None:
    try:
        return data.decode(encoding)
    except UnicodeDecodeError:
        return None
    except LookupError:
        raise UnreadableLayout(f"unknown encoding {encoding!r}", remedy=f"known: {listed(ENCODINGS)}, utf-16") from None


def _head(text: str) -> list[str]:
    return text[:20_000].splitlines()[:HEADER_WITHIN]


def _understood(text: str) -> int:
    return max((_score(line, delimiter) for line in _head(text) for delimiter in DELIMITERS), default=0)


def _score(line: str, delimiter: str) -> int:
    return len(columns_of([cell.strip().strip('"') for cell in line.split(delimiter)]))


def _delimiter(text: str) -> str:
    return max(DELIMITERS, key=lambda delimiter: max((_score(line, delimiter) for line in _head(text)), default=0))


def _csv_rows(text: str, delimiter: str) -> Iterator[tuple[int, Row]]:
    lines = list(io.StringIO(text, newline=""))
    reader, first = csv.reader(lines, delimiter=delimiter), 1
    try:
        for row in reader:
            if reader.line_num > MOST_ROWS:
                raise UnreadableLayout(f"more than {MOST_ROWS} rows", remedy="split the layout")
            if first < reader.line_num == len(lines) and _left_open(lines[first - 1 :], delimiter):
                raise UnreadableLayout(f"row {first}: a quotation mark is left open", remedy="close it, or take it out")
            if any(cell.strip() for cell in row):
                yield reader.line_num, row
            first = reader.line_num + 1
    except csv.Error:
        longest = f"row {reader.line_num + 1}: a cell is longer than {csv.field_size_limit()} characters"
        raise UnreadableLayout(longest, remedy="is a quotation mark left open?") from None


def _left_open(lines: list[str], delimiter: str) -> bool:
    """Whether the last row, of these lines, has a cell whose quotation mark nothing closes: all below it is in that cell."""
    try:
        list(csv.reader(lines, delimiter=delimiter, strict=True))
    except csv.Error as wrong:
        return "unexpected end of data" in str(wrong)
    return False


def tables_of_workbook(data: bytes, name: str, report: Report) -> list[Table]:
    """Return the tables of a workbook's sheets that have known columns. Raises: UnreadableLayout."""
    from python_calamine import CalamineError, CalamineWorkbook

    _check_size(data, name)
    try:
        book = CalamineWorkbook.from_filelike(io.BytesIO(data))
        sheets = {sheet: book.get_sheet_by_name(sheet).to_python(skip_empty_area=False) for sheet in book.sheet_names}
    except (CalamineError, OSError, ValueError, zipfile.BadZipFile) as wrong:
        remedy = "save it anew as XLSX without a password, or as CSV"
        raise UnreadableLayout(f"{name} is no workbook that can be read: {shown(wrong)}", remedy=remedy) from None
    found = []
    for sheet, cells in sheets.items():
        rows: list[tuple[int, Row]] = [(i, row) for i, row in enumerate(cells, 1) if any(str(c).strip() for c in row)]
        table = _table(f"sheet {shown(sheet)}", rows[:MOST_ROWS])
        if table is not None:
            found.append(table)
        elif rows:
            report.left_out(f"sheet {shown(sheet)}", "no row names columns that are known")
    if not found:
        remedy = _known_columns([row for cells in sheets.values() for row in enumerate(cells, 1)])
        raise UnreadableLayout(f"{name}: no sheet has columns that are known", remedy=remedy)
    report.source = f"workbook, sheets {listed(table.name.removeprefix('sheet ') for table in found)}"
    return found


def _check_size(data: bytes, name: str) -> None:
    if not data.startswith(b"PK"):
        return
    try:
        size = sum(part.file_size for part in zipfile.ZipFile(io.BytesIO(data)).infolist())
    except (zipfile.BadZipFile, ValueError, OSError) as wrong:
        raise UnreadableLayout(f"{name} is a damaged workbook: {shown(wrong)}", remedy="save it anew") from None
    if size > UNPACKED_LIMIT:
        raise UnreadableLayout(f"{name} unpacks to {size >> 20} MB: that is no list of barcodes")
    _check_extent(data, name)


def _check_extent(data: bytes, name: str) -> None:
    """A cell far from all others makes a table of everything between."""
    with zipfile.ZipFile(io.BytesIO(data)) as parts:
        for part in (part for part in parts.namelist() if part.startswith("xl/worksheets/")):
            try:
                cells = [(_number(letters), int(row)) for letters, row in _CELL.findall(parts.read(part))]
            except (zipfile.BadZipFile, OSError, EOFError, NotImplementedError, RuntimeError, zlib.error) as wrong:
                raise UnreadableLayout(f"{name} is a damaged workbook: {shown(wrong)}", remedy="save it anew") from None
            columns, rows = (max((cell[axis] for cell in cells), default=0) for axis in (0, 1))
            if rows > 2 * MOST_ROWS or columns * rows > MOST_CELLS:
                remedy = "delete what stands far from the list, and save it anew"
                raise UnreadableLayout(f"{name}: a sheet reaches to row {rows}, column {columns}", remedy=remedy)


def _number(letters: bytes) -> int:
    """Return the number of a column from its letters: A is 1, AA is 27."""
    return sum((letter - 64) * 26**place for place, letter in enumerate(reversed(letters[:8])))


def letters(index: int) -> str:
    """Return what a spreadsheet calls a column, counted from 0: A, B … Z, AA."""
    more, last = divmod(index, 26)
    return (letters(more - 1) if more else "") + chr(ord("A") + last)


def _table(name: str, rows: list[tuple[int, Row]]) -> Table | None:
    """Return the table that begins at the row with the most known columns; two must be known."""
    scores = [(len(columns_of(row)), -i) for i, (_, row) in enumerate(rows[:HEADER_WITHIN])]
    best, at = max(scores, default=(0, 0))
    if best < 2:
        return None
    header, rest = rows[-at][1], rows[-at + 1 :]
    columns = columns_of(header)
    if rest and (units := _units(rest[0][1])):
        columns = [Column(c.role, c.index, c.name, c.unit or units.get(c.index, "")) for c in columns]
        rest = rest[1:]
    known = {column.index for column in columns}
    unknown = [str(cell).strip() for i, cell in enumerate(header) if i not in known and str(cell).strip()]
    return Table(name, columns, rest, unknown)


def _units(row: Row) -> dict[int, str]:
    """Return the units by column if a row holds nothing else, as rows below the names often do."""
    cells = {i: str(cell).strip() for i, cell in enumerate(row) if str(cell).strip()}
    units = {i: unit_in(text if text[0] in "([" else f"({text})")[1] for i, text in cells.items()}
    return units if units and all(units.values()) else {}


def _known_columns(rows: Sequence[tuple[int, Row]]) -> str:
    seen = listed((str(cell) for _, row in rows[:1] for cell in row), 6)
    asked = "needed are at least a barcode (바코드), x, y and the next barcode (다음 바코드), or from and to"
    return f"{asked}; the first row has: {seen}" if fold(seen) else asked
