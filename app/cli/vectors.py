"""``hoistway vectors FILE``: does this build read and write the packets of a vector file (PROTOCOLS section 7)?"""

from __future__ import annotations

import json
import random
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from importlib import import_module
from itertools import pairwise
from pathlib import Path
from typing import Annotated, Any, Protocol

import typer

from app.cli.tongue import say, told_here
from app.domain.errors import EncodeError, HoistwayError
from app.wire.names import unknown

ADAPTERS = {
    "itsc": "app.protocols.itsc.vectors",
    "hi": "app.protocols.hi.vectors",
    "enig": "app.protocols.enig.vectors",
}
"""For each protocol the module whose ``Vectors`` class answers for it; a new protocol is one more line."""

_FRAMED = ("valid", "min", "max", "semantic", "concatenated", "chunked", "noise", "corrupt", "truncated")
_REENCODED = ("valid", "min", "max", "semantic", "concatenated", "chunked")
_RANDOM_CUTS = 5
_SHOWN = 300


class Adapter(Protocol):
    """One protocol's answers to one vector, in its dialect."""

    def __init__(self, dialect: Mapping[str, Any], vector: Mapping[str, Any]) -> None: ...
    def decode(self, pieces: Iterable[bytes]) -> list[dict[str, Any]]: ...
    def in_our_words(self, wanted: Mapping[str, Any], got: dict[str, Any]) -> dict[str, Any]: ...
    def encode(self, frame: Mapping[str, Any], *, strict: bool) -> bytes: ...
    def bits(self, layout: str, word: bytes) -> tuple[dict[str, Any], bytes]: ...
    def form(self, name: str, data: bytes) -> dict[str, Any]: ...
    def form_bytes(self, name: str, content: Mapping[str, Any]) -> bytes: ...
    def crc(self, algorithm: str, data: bytes) -> int: ...
    def detect(self, packets: Sequence[bytes]) -> Sequence[Sequence[str]]: ...


class Malformed(Exception):
    """The vector file is not one; the message says where."""


def vectors(file: Annotated[Path, typer.Argument(help="a vector file, JSON")]) -> None:
    """Run a file of test vectors and print each that fails, with what was expected and what came out.

    Leaves with 1 if this build fails a vector, with 2 if only the file is to blame.
    """
    try:
        contents = load(file)
    except Malformed as wrong:
        print(f"{file}: {told_here(str(wrong))}")
        raise typer.Exit(2) from None
    passed, failed, malformed, skipped = 0, 0, 0, Counter[str]()
    for vector in contents["vectors"]:
        if vector["protocol"] not in ADAPTERS:
            skipped[vector["protocol"]] += 1
            continue
        failures = list(check(vector, contents["dialects"]))
        passed += not failures
        failed += bool(failures)
        malformed += _defect(vector, contents["dialects"]) is not None
        for failure in failures:
            print(f"{vector['id']} ({vector['kind']}, {vector.get('dialect', 'default')}): {failure}")
    for protocol, number in sorted(skipped.items()):
        say(f"skipped {number} of protocol {protocol!r}: not in this build")
    say(f"{passed} passed, {failed} failed, {skipped.total()} skipped")
    if failed:
        raise typer.Exit(1 if failed > malformed else 2)


def load(file: Path) -> dict[str, Any]:
    """Return a vector file's content. Raises: Malformed: it cannot be read or lacks what every vector needs."""
    from app.plant.exchange.json_text import expected

    try:
        contents = json.loads(file.read_text(encoding="utf-8-sig"))
    except OSError as wrong:
        raise Malformed(f"cannot be read: {wrong.strerror}") from None
    except UnicodeDecodeError as wrong:
        raise Malformed(f"is not UTF-8: {wrong.reason} at byte {wrong.start}") from None
    except json.JSONDecodeError as wrong:
        raise Malformed(f"is not JSON: {expected(wrong)}, line {wrong.lineno} column {wrong.colno}") from None
    except RecursionError:
        raise Malformed("is nested too deeply") from None
    if not isinstance(contents, dict) or not isinstance(contents.get("vectors"), list):
        raise Malformed("has no list 'vectors'")
    if not isinstance(contents.setdefault("dialects", {}), dict):
        raise Malformed("'dialects' is no object")
    if contents.get("format", 1) != 1:
        raise Malformed(f"has format {contents['format']!r}; this build reads format 1")
    for number, vector in enumerate(contents["vectors"]):
        _check_shape(number, vector)
    return contents


def _check_shape(number: int, vector: object) -> None:
    if not isinstance(vector, dict):
        raise Malformed(f"vectors[{number}] is no object")
    for key in ("id", "protocol", "kind"):
        if not isinstance(vector.get(key), str):
            raise Malformed(f"vectors[{number}] has no text {key!r}")


def check(vector: Mapping[str, Any], dialects: Mapping[str, Any]) -> Iterator[str]:
    """Give what is wrong with this build's answers to a vector of a known protocol; nothing if all is right."""
    if complaint := _defect(vector, dialects):
        yield complaint
        return
    name = _dialect_name(vector)
    adapter = import_module(ADAPTERS[vector["protocol"]]).Vectors
    try:
        yield from _CHECKS[vector["kind"]](adapter(dialects.get(name, {}), vector), vector)
    except KeyError as missing:
        yield f"malformed vector: no {missing.args[0]!r}"
    except (HoistwayError, ValueError, TypeError, AttributeError) as wrong:
        yield f"malformed vector, or refused: {wrong}"


def _dialect_name(vector: Mapping[str, Any]) -> Any:
    return vector.get("dialect", f"{vector['protocol']}.default")


def _defect(vector: Mapping[str, Any], dialects: Mapping[str, Any]) -> str | None:
    """Return why a vector asks nothing that any build could answer, or None."""
    kind, name = vector["kind"], _dialect_name(vector)
    if kind not in _CHECKS:
        return unknown("kind", kind, _CHECKS)
    if not isinstance(name, str) or not isinstance(dialects.get(name, {}), dict):
        return f"malformed vector: dialect {name!r} is no name of an object"
    if name not in dialects and not name.endswith(".default"):
        return unknown("dialect", name, dialects)
    for key, kinds in _KEYS[_CHECKS[kind]].items():
        if key not in vector:
            return f"malformed vector: no {key!r}"
        if not isinstance(vector[key], kinds):
            return f"malformed vector: {key!r} is {_short(vector[key])}"
    return _hex_defect(vector) or _frames_defect(vector)


def _hex_defect(vector: Mapping[str, Any]) -> str | None:
    for text in [vector.get("hex", ""), *vector.get("frames_hex", ())]:
        try:
            bytes.fromhex(text)
        except (TypeError, ValueError):
            return f"malformed vector: {_short(text)} is no hexadecimal text"
    return None


def _frames_defect(vector: Mapping[str, Any]) -> str | None:
    for i, frame in enumerate(vector.get("frames", ())):
        if not isinstance(frame, dict) or not isinstance(frame.get("problems") or [], list):
            return f"malformed vector: frames[{i}] is {_short(frame)}"
    return None


def _check_framed(adapter: Adapter, vector: Mapping[str, Any]) -> Iterator[str]:
    data = bytes.fromhex(vector["hex"])
    wanted = list(vector["frames"])
    for how, pieces in _cuts(vector["id"], data):
        got = adapter.decode(pieces)
        wanted[: len(got)] = [adapter.in_our_words(*pair) for pair in zip(wanted, got, strict=False)]
        if differences := list(_differences("frames", wanted, got)):
            yield f"fed {how}: {'; '.join(differences)}"
            return
    if vector["kind"] in _REENCODED and vector.get("roundtrip", True):
        yield from _check_written(adapter, vector["kind"], data, wanted, "")
        yield from _check_written(adapter, vector["kind"], data, adapter.decode([data]), "read ")


def _cuts(seed: str, data: bytes) -> Iterator[tuple[str, list[bytes]]]:
    yield "whole", [data]
    yield "byte by byte", [data[i : i + 1] for i in range(len(data))]
    chance = random.Random(seed)
    for _ in range(_RANDOM_CUTS):
        cuts = sorted({0, len(data), *(chance.randrange(len(data) + 1) for _ in range(chance.randrange(1, 9)))})
        yield f"cut at {cuts[1:-1]}", [data[a:b] for a, b in pairwise(cuts)]


def _check_written(
    adapter: Adapter, kind: str, data: bytes, frames: Sequence[Mapping[str, Any]], which: str
) -> Iterator[str]:
    at = 0
    for i, frame in enumerate(frames):
        written = adapter.encode(frame, strict=not frame.get("problems"))
        found = data.find(written, at)
        # Between the frames of a concatenation there may be rubbish; everywhere else they are all there is.
        if found < 0 or (kind != "concatenated" and found != at):
            yield f"{which}frames[{i}] written again: expected {data[at:].hex()}, got {written.hex()}"
            return
        at = found + len(written)
    if kind != "concatenated" and at != len(data):
        yield f"{which}frames written again: {len(data) - at} bytes are missing at the end"


def _check_refused(adapter: Adapter, vector: Mapping[str, Any]) -> Iterator[str]:
    try:
        written = adapter.encode(vector["object"], strict=True)
    except EncodeError:
        return
    yield f"expected a refusal to send, got {written.hex()}"


def _check_bits(adapter: Adapter, vector: Mapping[str, Any]) -> Iterator[str]:
    word = bytes.fromhex(vector["hex"])
    fields, again = adapter.bits(vector["layout"], word)
    yield from _differences("fields", vector["fields"], fields)
    if again != word and vector.get("roundtrip", True):
        yield f"written again: expected {word.hex()}, got {again.hex()}"


def _check_form(adapter: Adapter, vector: Mapping[str, Any]) -> Iterator[str]:
    data = bytes.fromhex(vector["hex"])
    yield from _differences("fields", vector["fields"], adapter.form(vector["form"], data))
    again = adapter.form_bytes(vector["form"], vector["fields"])
    if again != data and vector.get("roundtrip", True):
        yield f"written again: expected {data.hex()}, got {again.hex()}"


def _check_crc(adapter: Adapter, vector: Mapping[str, Any]) -> Iterator[str]:
    got = adapter.crc(vector["algorithm"], bytes.fromhex(vector["hex"]))
    if got != int(vector["value"], 16):
        yield f"expected {vector['value']}, got {got:04x}"


def _check_detect(adapter: Adapter, vector: Mapping[str, Any]) -> Iterator[str]:
    got = adapter.detect([bytes.fromhex(packet) for packet in vector["frames_hex"]])
    wanted = [_words(entry) for entry in vector["answer"]]
    # An answer may name fewer things than ours does: it need not say which CRC where only one is known.
    same = len(wanted) == len(got) and all(any(entry <= _words(ours) for ours in got) for entry in wanted)
    if not same:
        yield f"expected {vector['answer']}, got {[list(ours) for ours in got]}"


def _words(entry: Any) -> set[str]:
    values = entry.values() if isinstance(entry, Mapping) else [entry] if isinstance(entry, str) else entry
    return {_COVERAGE.get(str(value).lower(), str(value).lower()) for value in values}


_COVERAGE = {"true": "type", "false": "dev_id"}

_CHECKS: Mapping[str, Callable[[Adapter, Mapping[str, Any]], Iterator[str]]] = {
    **dict.fromkeys(_FRAMED, _check_framed),
    "encode-error": _check_refused,
    "bits": _check_bits,
    "form": _check_form,
    "crc": _check_crc,
    "detect": _check_detect,
}

_KEYS: Mapping[Callable[[Adapter, Mapping[str, Any]], Iterator[str]], Mapping[str, type | tuple[type, ...]]] = {
    _check_framed: {"hex": str, "frames": list},
    _check_refused: {"object": dict},
    _check_bits: {"hex": str, "layout": str, "fields": dict},
    _check_form: {"hex": str, "form": str, "fields": dict},
    _check_crc: {"hex": str, "algorithm": str, "value": str},
    _check_detect: {"frames_hex": list, "answer": list},
}
"""What a vector must have for each check."""


def _differences(where: str, wanted: Any, got: Any) -> Iterator[str]:
    """Give the places in which two values differ; of ``problems`` only whether there are any counts."""
    if isinstance(wanted, Mapping) and isinstance(got, Mapping):
        for key in [*wanted, *(key for key in got if key not in wanted)]:
            inside = f"{where}.{key}"
            if key == "problems":
                yield from _problem_differences(inside, wanted.get(key) or [], got.get(key) or [])
            else:
                yield from _differences(inside, wanted.get(key, _ABSENT), got.get(key, _ABSENT))
    elif isinstance(wanted, list) and isinstance(got, list):
        if len(wanted) != len(got):
            yield f"{where}: expected {len(wanted)}, got {len(got)}: {_short(got)}"
        for i, (one, other) in enumerate(zip(wanted, got, strict=False)):
            yield from _differences(f"{where}[{i}]", one, other)
    elif _folded(where, wanted) != _folded(where, got):
        yield f"{where}: expected {_short(wanted)}, got {_short(got)}"


def _problem_differences(where: str, wanted: Sequence[str], got: Sequence[str]) -> Iterator[str]:
    if bool(wanted) != bool(got):
        yield f"{where}: expected {_short(list(wanted))}, got {_short(list(got))}"


_ABSENT = "(nothing)"


def _folded(where: str, value: Any) -> Any:
    """Return a value that is the same for all spellings of a number that section 7 gives as hexadecimal text."""
    if not isinstance(value, str):
        return value
    if where.endswith((".cmd_id", ".code")):
        try:
            return int(value, 16)
        except ValueError:
            return value
    return value.lower() if where.endswith(".data") else value


def _short(value: Any) -> str:
    text = value if value is _ABSENT else json.dumps(value, ensure_ascii=False)
    return text if len(text) <= _SHOWN else text[: _SHOWN - 1] + "…"
