"""The typed part of the Python client, from the OpenAPI document: ``python -m tools.client`` writes it, ``--check`` compares."""

import json
import keyword
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "clients/python/hoistway_client"
Json = dict[str, Any]
HEAD = '"""Made by ``python -m tools.client`` from openapi/openapi.json: change that, not this."""\n\n'
PLAIN = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "null": "None"}
SET_BY_CLIENT = frozenset({"X-Actor", "Last-Event-ID"})
"""Headers that the client sends by itself."""
MODELS = '''from __future__ import annotations

from typing import Any, Generic, Literal, NotRequired, TypeAlias, TypedDict, TypeVar

T = TypeVar("T")


class Page(TypedDict, Generic[T]):
    """Objects, and what to send as ``after`` for more (None: the end)."""

    items: list[T]
    next: NotRequired[int | None]
'''
CALLS = """from __future__ import annotations

from typing import Any, Literal, cast

from hoistway_client import models as m
from hoistway_client.transport import Asynchronous, Synchronous, path

"""


def annotation(schema: Json, prefix: str = "") -> str:
    """Return a schema as a type; ``prefix`` stands before names of models."""
    if "$ref" in schema:
        return prefix + str(schema["$ref"]).rpartition("/")[2]
    if "const" in schema:
        return f"Literal[{schema['const']!r}]"
    if "enum" in schema:
        return f"Literal[{', '.join(map(repr, schema['enum']))}]"
    for word in ("anyOf", "oneOf"):
        if word in schema:
            return " | ".join(dict.fromkeys(annotation(one, prefix) for one in schema[word]))
    kind = schema.get("type")
    if isinstance(kind, list):
        return " | ".join(PLAIN.get(one, "Any") for one in kind)
    if kind == "array":
        if "prefixItems" in schema:
            return f"list[{' | '.join(dict.fromkeys(annotation(one, prefix) for one in schema['prefixItems']))}]"
        return f"list[{annotation(schema.get('items', {}), prefix)}]"
    if kind == "object":
        more = schema.get("additionalProperties")
        return f"dict[str, {annotation(more, prefix)}]" if isinstance(more, dict) else "dict[str, Any]"
    return PLAIN.get(str(kind), "Any")


def models(document: Json) -> str:
    """Return the module of all schemas as TypedDicts."""
    parts = [HEAD, MODELS]
    for name, schema in document["components"]["schemas"].items():
        parts.append("\n\n" + _model(name, schema))
    return "".join(parts)


def _model(name: str, schema: Json) -> str:
    bases, fields, required = ["TypedDict"], dict(schema.get("properties", {})), set(schema.get("required", ()))
    for part in schema.get("allOf", ()):
        if "$ref" in part:
            bases = [annotation(part)]
        fields |= part.get("properties", {})
        required |= set(part.get("required", ()))
    if not fields and "allOf" not in schema:
        return f'{name}: TypeAlias = "{annotation(schema)}"\n'
    if any(keyword.iskeyword(field) for field in fields):
        entries = (f"        {field!r}: {_field(kind, field in required)!r},\n" for field, kind in fields.items())
        return f'{name} = TypedDict(\n    "{name}",\n    {{\n' + "".join(entries) + "    },\n)\n"
    said = _said(schema.get("description", ""), 4)
    lines = [f"    {field}: {_field(kind, field in required)}\n" for field, kind in fields.items()]
    body = said + ("\n" if said and lines else "") + "".join(lines) or "    pass\n"
    return f"class {name}({', '.join(bases)}):\n{body}"


def _field(schema: Json, required: bool) -> str:
    kind = annotation(schema)
    return kind if required else f"NotRequired[{kind}]"


def _said(text: str, indent: int) -> str:
    """Return a description as a docstring in lines that are not too long."""
    words, lines, line = text.split(), [], ""
    for word in words:
        if line and len(line) + len(word) > 110:
            lines.append(line)
            line = word
        else:
            line = f"{line} {word}".strip()
    lines = [one.replace("\\", "\\\\") for one in [*lines, line] if one]
    if not lines:
        return ""
    pad = " " * indent
    if len(lines) == 1:
        return f'{pad}"""{lines[0]}"""\n'
    return f'{pad}"""{lines[0]}\n' + "".join(f"{pad}{one}\n" for one in lines[1:]) + f'{pad}"""\n'


def calls(document: Json) -> str:
    """Return the module of all operations: one class that waits, and one for asyncio."""
    found = [one for one in _operations(document) if one is not None]
    parts = [HEAD, CALLS]
    for name, base, word, wait in (
        ("Calls", "Synchronous", "def", ""),
        ("AsyncCalls", "Asynchronous", "async def", "await "),
    ):
        parts.append(f'\nclass {name}({base}):\n    """Every operation of the API."""\n')
        parts += [_method(operation, word, wait) for operation in found]
        parts.append("\n")
    return "".join(parts).rstrip() + "\n"


def _operations(document: Json) -> Iterator[tuple[str, str, Json, str] | None]:
    """Give (method, path, operation, type of the answer) of those whose answer is JSON or none."""
    for where, methods in document["paths"].items():
        for method, operation in methods.items():
            good: Json = next((r for code, r in operation["responses"].items() if code.startswith("2")), {})
            content = good.get("content", {})
            if content and "application/json" not in content:
                continue
            yield method, where, operation, _answer(content.get("application/json", {}).get("schema"))


def _answer(schema: Json | None) -> str:
    if schema is None:
        return "None"
    items = schema.get("properties", {}).get("items")
    if items is not None and "next" in schema["properties"]:
        return f"m.Page[{annotation(items['items'], 'm.')}]"
    return annotation(schema, "m.")


def _method(found: tuple[str, str, Json, str], word: str, wait: str) -> str:
    method, where, operation, answer = found
    given, url = ["self"], where
    query: list[tuple[str, str, str]] = []
    headers: list[tuple[str, str, str]] = []
    for parameter in operation.get("parameters", ()):
        name, kind = parameter["name"], parameter["in"]
        python = name.replace("-", "_").lower() + ("_" if keyword.iskeyword(name) else "")
        if kind == "path":
            given.append(f"{python}: {annotation(parameter['schema'])}")
            url = url.replace("{" + name + "}", "{path(" + python + ")}")
        elif name not in SET_BY_CLIENT:
            (query if kind == "query" else headers).append((name, python, annotation(parameter["schema"], "m.")))
    request = operation.get("requestBody", {})
    body = request.get("content", {}).get("application/json", {}).get("schema")
    if body is not None:
        given.append(f"body: {annotation(body, 'm.')}" + ("" if request.get("required") else " | None = None"))
    if query or headers:
        given.append("*")
    given += [
        f"{python}: {kind}" + ("" if kind.endswith("None") else " | None") + " = None"
        for _, python, kind in (*query, *headers)
    ]
    sent = [f'"{method.upper()}"', f'f"{url}"' if "{" in url else f'"{url}"']
    sent += ["body=body"] if body is not None else []
    sent += ["params={" + ", ".join(f'"{name}": {python}' for name, python, _ in query) + "}"] if query else []
    sent += ["headers={" + ", ".join(f'"{name}": {python}' for name, python, _ in headers) + "}"] if headers else []
    call = f"{wait}self._call({', '.join(sent)})"
    done = f"        {call}\n" if answer == "None" else f'        return cast("{answer}", {call})\n'
    head = f"\n    {word} {operation['operationId']}({', '.join(given)}) -> {answer}:\n"
    return head + (_said(operation.get("description", ""), 8) or "") + done


def texts() -> dict[str, str]:
    """Return what each file should hold."""
    document = json.loads((ROOT / "openapi/openapi.json").read_text(encoding="utf-8"))
    return {"models.py": models(document), "calls.py": calls(document)}


def main() -> int:
    """Write the files, or compare them; return 1 if they are out of date."""
    stale = 0
    for name, text in texts().items():
        file = FOLDER / name
        if "--check" not in sys.argv:
            file.write_text(text, encoding="utf-8")
            sys.stdout.write(f"wrote {file}\n")
        elif not file.is_file() or file.read_text(encoding="utf-8") != text:
            stale = 1
            sys.stdout.write(f"{file} is out of date: run python -m tools.client\n")
    return stale


if __name__ == "__main__":
    sys.exit(main())
