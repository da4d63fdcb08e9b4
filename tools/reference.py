"""The reference as pages: every route, every schema, the live stream, every command of the command line."""

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import typer
import yaml

from app.cli import app as cli

ROOT = Path(__file__).parents[1]
Json = Mapping[str, Any]


def pages() -> dict[str, str]:
    """Return the pages of the reference by their names, without ``.md``."""
    rest: Json = json.loads((ROOT / "openapi/openapi.json").read_text(encoding="utf-8"))
    live: Json = yaml.safe_load((ROOT / "openapi/asyncapi.yaml").read_text(encoding="utf-8"))
    found = {f"rest-{tag}": "\n".join(_routes(rest, tag)) for tag in tags(rest)}
    found["schemas"] = "\n".join(_schemas("Schemas of the REST API", rest["components"]["schemas"]))
    found["live"] = "\n".join(_live(live))
    found["command-line"] = "\n".join(_commands())
    return found


def tags(rest: Json) -> list[str]:
    """Return the groups of routes, in order of their names."""
    return sorted({tag for path in rest["paths"].values() for one in path.values() for tag in one["tags"]})


def _routes(rest: Json, tag: str) -> Iterator[str]:
    yield f"# REST: {tag}\n"
    for path, operations in rest["paths"].items():
        for method, operation in operations.items():
            if tag in operation["tags"]:
                yield from _route(f"{method.upper()} {path}", operation)


def _route(name: str, operation: Json) -> Iterator[str]:
    yield f"## `{name}`\n\n{operation['description']}\n"
    if roles := operation.get("x-roles"):
        yield f"Roles, where callers have to say who they are: {', '.join(roles)}.\n"
    rows = [
        (f"`{one['name']}`", one["in"], _kind(one["schema"]), one.get("description", ""))
        for one in operation.get("parameters", ())
    ]
    if rows:
        yield _table(("Parameter", "In", "What it is", ""), rows)
    for content, body in operation.get("requestBody", {}).get("content", {}).items():
        yield f"Body ({content}): {_kind(body['schema'])}\n"
    answers = [(status, _answer(answer), answer.get("description", "")) for status, answer in _answers(operation)]
    yield _table(("Status", "Answer", ""), answers)


def _answers(operation: Json) -> Iterator[tuple[str, Json]]:
    for status, answer in operation["responses"].items():
        if status != "default":
            yield status, answer
    yield (
        "others",
        {"content": {"application/problem+json": {"schema": {"$ref": "/Problem"}}}, "description": "Why not."},
    )


def _answer(answer: Json) -> str:
    kinds = [
        _kind(body["schema"]) if "schema" in body else content for content, body in answer.get("content", {}).items()
    ]
    return "; ".join(kinds) or "–"


def _schemas(title: str, schemas: Json, *, under: str = "#") -> Iterator[str]:
    yield f"{under} {title}\n"
    for name, schema in schemas.items():
        yield from _schema(name, schema, f"{under}#")


def _schema(name: str, schema: Json, mark: str) -> Iterator[str]:
    yield f"{mark} {name}\n\n{schema.get('description', '')}\n"
    if "properties" not in schema:
        yield f"{_kind(schema)}\n"
        return
    needed = schema.get("required", ())
    rows = [
        (f"`{field}`" + ("" if field in needed else " (optional)"), _kind(kind), kind.get("description", ""))
        for field, kind in schema["properties"].items()
    ]
    yield _table(("Field", "What it is", ""), rows)


def _live(live: Json) -> Iterator[str]:
    yield f"# The live stream\n\n{live['info']['description']}"
    for name, channel in live["channels"].items():
        query = channel.get("bindings", {}).get("ws", {}).get("query", {}).get("properties", {})
        yield f"## Channel {name}: `{channel['address']}`\n\n{channel.get('description', '')}\n"
        if query:
            rows = [(f"`{field}`", _kind(kind), kind.get("description", "")) for field, kind in query.items()]
            yield _table(("Parameter", "What it is", ""), rows)
    yield "## Messages\n"
    for name, message in live["components"]["messages"].items():
        yield f"### Message {name}\n\n{message['summary']}\n"
        if "properties" in message["payload"]:
            fields = message["payload"]["properties"].items()
            yield _table(
                ("Field", "What it is", ""), [(f"`{f}`", _kind(k), k.get("description", "")) for f, k in fields]
            )
    schemas: Json = live["components"]["schemas"]
    commands = [one for one in schemas.values() if "const" in one.get("properties", {}).get("name", {})]
    yield "## Commands\n\nA named person: by log-in, or as `actor`.\n"
    yield _table(("Name", "Body", "Roles", "A named person"), [_command(one) for one in commands])
    yield from _schemas("Bodies of commands", {n: s for n, s in schemas.items() if s not in commands}, under="##")


def _command(schema: Json) -> tuple[str, ...]:
    fields = schema["properties"]
    person = "yes" if schema.get("x-named-person") else ""
    body = _kind(fields["body"], "live") if "body" in fields else "–"
    return f"`{fields['name']['const']}`", body, ", ".join(schema["x-roles"]), person


def _commands() -> Iterator[str]:
    yield "# The command line\n\nWhat `hoistway COMMAND --help` says.\n"
    main: Any = typer.main.get_command(cli)
    yield from _help(main, typer.Context(main, info_name="hoistway"))


def _help(command: Any, context: typer.Context) -> Iterator[str]:
    # A width of its own, so that the page does not depend on whose terminal builds it.
    context.terminal_width, context.max_content_width = 100, 100
    yield f"## `{context.command_path}`\n\n```text\n{command.get_help(context)}\n```\n"
    for name, inner in sorted(getattr(command, "commands", {}).items()):
        yield from _help(inner, typer.Context(inner, info_name=name, parent=context))


def _kind(schema: Json, page: str = "schemas") -> str:
    """Return what a schema is in a few words, with links to those that have names."""
    match schema:
        case {"$ref": str(ref)}:
            name = ref.rpartition("/")[2]
            where = page if ref.startswith("#/components/schemas/") else "schemas"
            return f"[{name}]({where}.md#{name.lower()})"
        case {"anyOf": parts} | {"oneOf": parts}:
            return "a command" if len(parts) > MANY else " or ".join(dict.fromkeys(_kind(part, page) for part in parts))
        case {"allOf": parts}:
            return " and ".join(_kind(part, page) for part in parts)
        case {"enum": values}:
            return ", ".join(f"`{value}`" for value in values)
        case {"const": value}:
            return f"`{json.dumps(value)}`"
        case {"type": "array"}:
            return f"list of {_kind(schema.get('items', {}), page)}"
        case {"type": list(types)}:
            return " or ".join(types)
        case _:
            return _plain(schema, page)


MANY = 30
"""Kinds that are not worth a list in a cell."""


def _plain(schema: Json, page: str) -> str:
    more = schema.get("additionalProperties")
    if isinstance(more, dict) and more:
        return f"for each key {_kind(more, page)}"
    if "properties" in schema:
        fields = (f"`{name}`: {_kind(kind, page)}" for name, kind in schema["properties"].items())
        return f"object with {'; '.join(fields)}"
    lowest, highest = schema.get("minimum"), schema.get("maximum")
    name = str(schema.get("format") or schema.get("type", "anything"))
    if lowest is None and highest is None:
        return name
    return f"{name} {'' if lowest is None else lowest}…{'' if highest is None else highest}"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    cells = [[re.sub(r"\s+", " ", cell).replace("|", "\\|") for cell in row] for row in [head, *rows]]
    lines = ["| " + " | ".join(row) + " |" for row in cells]
    return "\n".join([lines[0], "|" + "---|" * len(head), *lines[1:], ""])
