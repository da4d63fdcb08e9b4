"""A YAML text as a tree in which every value knows its line and column.

Read is the part of YAML that JSON also has: mappings with text keys, lists, text, whole and decimal numbers, true, false,
null, and hexadecimal numbers (``0x2100``). So ``no`` is text, ``0100`` is text and ``12:30`` is text, unlike in YAML 1.1.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import NoReturn

import yaml

from app.plant.broken import wanted
from app.plant.findings import Finding, Severity

MAX_DEPTH = 20
"""Deepest nesting that is read. Our choice: the format itself needs 5."""

MAX_VALUES = 1_000_000
"""Most values that are read. Our choice: a plant of 100,000 barcodes has a third of it."""
MAX_TEXT = 200
"""Longest text, characters. Our choice."""

_LOADER: type = getattr(yaml, "CSafeLoader", yaml.SafeLoader)
_INT = re.compile(r"-?(0|[1-9][0-9]{0,18})")
_HEX = re.compile(r"0x[0-9a-fA-F]{1,16}")
_FLOAT = re.compile(r"-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]{1,3})?")
_WORDS = {"true": True, "false": False, "null": None, "": None, "~": None}

Path = tuple[str | int, ...]
"""Way into a file: keys of mappings and positions in lists."""

NO_YAML = "write YAML: plants/small.yaml shows how"

Plain = bool | int | float | str | list["Plain"] | dict[str, "Plain"] | None


@dataclass(frozen=True, slots=True)
class Scalar:
    """One value; ``value`` is what it means, ``text`` what was written."""

    line: int
    column: int
    value: bool | int | float | str | None
    text: str


@dataclass(frozen=True, slots=True)
class Sequence:
    """A list."""

    line: int
    column: int
    items: list["Node"] = field(default_factory=list)


@dataclass(frozen=True, slots=True)
class Mapping:
    """A mapping; ``keys`` holds where each key stands."""

    line: int
    column: int
    items: dict[str, "Node"] = field(default_factory=dict)
    keys: dict[str, Scalar] = field(default_factory=dict)


Node = Scalar | Sequence | Mapping


def plain(node: Node) -> Plain:
    """Return the value without its places."""
    match node:
        case Scalar():
            return node.value
        case Sequence():
            return [plain(item) for item in node.items]
        case Mapping():
            return {key: plain(item) for key, item in node.items.items()}


def path_text(path: Path) -> str:
    """Return a path as people write it: ``vehicles.V001.limits.lift[1]``."""
    text = ""
    for step in path:
        text += f"[{step}]" if isinstance(step, int) else f".{step}" if text else step
    return text


class Unreadable(Exception):
    """The text is no YAML that we read; ``findings`` says why."""

    def __init__(self, findings: list[Finding]) -> None:
        super().__init__(*findings)
        self.findings = findings


class Document:
    """One file's tree and the findings about it; ``what`` is the file for people.

    ``dropped`` are the items of lists that could not be read. Raises: Unreadable: no tree can be made of the text.
    """

    def __init__(self, text: str, what: str = "the plant file") -> None:
        self.what = what
        self.findings: list[Finding] = []
        self.dropped: set[Path] = set()
        self._values = 0
        self._events: Iterator[yaml.Event] = iter(yaml.parse(text, Loader=_LOADER))
        try:
            self.root = self._document()
        except yaml.MarkedYAMLError as wrong:
            mark = wrong.problem_mark
            line, column = (mark.line + 1, mark.column + 1) if mark else (1, 1)
            self._fail(line, column, f"this is no YAML: {wanted(str(wrong.problem))}", NO_YAML)
        except yaml.reader.ReaderError as wrong:
            line = text.count("\n", 0, wrong.position) + 1
            column = wrong.position - (text.rfind("\n", 0, wrong.position) + 1) + 1
            self._fail(line, column, f"this is no YAML: {wanted(wrong.reason)}", NO_YAML)

    def error(self, path: Path, message: str, remedy: str = "", *, key: bool = False) -> None:
        """Note an error at the deepest place on the path that the file has; with ``key`` at the key, not the value."""
        self._note(Severity.ERROR, path, message, remedy, key)

    def warn(self, path: Path, message: str, remedy: str = "", *, key: bool = False) -> None:
        """Note a warning, placed like an error."""
        self._note(Severity.WARNING, path, message, remedy, key)

    @property
    def has_errors(self) -> bool:
        """Whether an error is noted."""
        return any(finding.is_error for finding in self.findings)

    def is_sound(self, *sections: str) -> bool:
        """Whether these top-level sections have no error."""
        roots = [finding.path.partition(".")[0].partition("[")[0] for finding in self.findings if finding.is_error]
        return not any(root in sections for root in roots)

    def section(self, name: str) -> dict[str, Node]:
        """Return a top-level mapping's items, none if it is not there or no mapping."""
        node = self.root.items.get(name) if isinstance(self.root, Mapping) else None
        return node.items if isinstance(node, Mapping) else {}

    def place(self, path: Path, *, key: bool = False) -> tuple[int, int]:
        """Return line and column, from 1, of the deepest place on the path that the file has."""
        node: Node = self.root
        at: Node = node
        for step in path:
            if isinstance(node, Mapping) and step in node.items:
                at = node.keys[str(step)]
                node = node.items[str(step)]
            elif isinstance(node, Sequence) and isinstance(step, int) and step < len(node.items):
                at = node = node.items[step]
            else:
                key = True
                break
        found = at if key else node
        return found.line, found.column

    def _note(self, severity: Severity, path: Path, message: str, remedy: str, key: bool) -> None:
        line, column = self.place(path, key=key)
        self.findings.append(Finding(line, column, severity, path_text(path), message, remedy))

    def _fail(self, line: int, column: int, message: str, remedy: str = "", path: Path = ()) -> NoReturn:
        self.findings.append(Finding(line, column, Severity.ERROR, path_text(path), message, remedy))
        raise Unreadable(self.findings)

    def _document(self) -> Node:
        next(self._events)
        event = next(self._events)
        if isinstance(event, yaml.StreamEndEvent):
            self._fail(1, 1, "the file is empty", NO_YAML)
        root = self._node(next(self._events), ())
        next(self._events)
        event = next(self._events)
        if not isinstance(event, yaml.StreamEndEvent):
            self._fail(*_start(event), "a second document starts here", "one file holds one plant")
        return root

    def _node(self, event: yaml.Event, path: Path) -> Node:
        line, column = _start(event)
        if isinstance(event, yaml.AliasEvent):
            self._fail(line, column, f"an alias (*{event.anchor}) cannot be used here", "write the value again", path)
        if len(path) > MAX_DEPTH:
            self._fail(line, column, f"this is nested more than {MAX_DEPTH} levels deep", path=path[:4])
        if (tag := getattr(event, "tag", None)) is not None:
            self._fail(line, column, f"a tag ({tag}) cannot be used here", "leave it out", path)
        self._values += 1
        if self._values > MAX_VALUES:
            self._fail(
                line, column, f"the file has more than {MAX_VALUES} values", "write barcodes as ranges", path[:4]
            )
        if isinstance(event, yaml.ScalarEvent):
            self._check_text(event, path)
            return Scalar(line, column, _value(event), event.value)
        if isinstance(event, yaml.SequenceStartEvent):
            return self._sequence(Sequence(line, column), path)
        return self._mapping(Mapping(line, column), path)

    def _check_text(self, event: yaml.ScalarEvent, path: Path) -> None:
        """Refuse what would fill a screen, or steer the terminal that shows it."""
        if len(event.value) > MAX_TEXT:
            self._fail(*_start(event), f"a text is longer than {MAX_TEXT} characters", "shorten it", path)
        if not event.value.isprintable():
            self._fail(*_start(event), f"{event.value!r} has a character that cannot be shown", "leave it out", path)

    def _sequence(self, sequence: Sequence, path: Path) -> Sequence:
        while not isinstance(event := next(self._events), yaml.SequenceEndEvent):
            sequence.items.append(self._node(event, (*path, len(sequence.items))))
        return sequence

    def _mapping(self, mapping: Mapping, path: Path) -> Mapping:
        while not isinstance(event := next(self._events), yaml.MappingEndEvent):
            line, column = _start(event)
            if not isinstance(event, yaml.ScalarEvent):
                self._fail(
                    line, column, "a key must be text or a number", "quote it if it begins with [ { * or &", path
                )
            key = event.value
            self._check_text(event, path)
            value = self._node(next(self._events), (*path, key))
            if key in mapping.items:
                first = mapping.keys[key].line
                message = f"{path_text((*path, key))} is given twice: the first time on line {first}"
                self.findings.append(
                    Finding(line, column, Severity.ERROR, path_text((*path, key)), message, "keep one")
                )
                continue
            mapping.items[key] = value
            mapping.keys[key] = Scalar(line, column, key, key)
        return mapping


def _start(event: yaml.Event) -> tuple[int, int]:
    mark = event.start_mark
    return (mark.line + 1, mark.column + 1) if mark else (1, 1)


def _value(event: yaml.ScalarEvent) -> bool | int | float | str | None:
    text: str = event.value
    if not event.implicit[0]:
        return text
    if text in _WORDS:
        return _WORDS[text]
    if _INT.fullmatch(text):
        return int(text)
    if _HEX.fullmatch(text):
        return int(text, 16)
    if _FLOAT.fullmatch(text):
        return float(text)
    return text
