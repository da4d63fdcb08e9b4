"""Pieces of JSON schema, for answers that are described by hand."""

from collections.abc import Sequence
from typing import Any

Json = dict[str, Any]
REF = "#/components/schemas/"

TEXT: Json = {"type": "string"}
TIME: Json = {"type": "string", "format": "date-time"}
WHOLE: Json = {"type": "integer"}
NUMBER: Json = {"type": "number"}
FLAG: Json = {"type": "boolean"}


def ref(name: str) -> Json:
    """Return a reference to a schema of the OpenAPI document."""
    return {"$ref": REF + name}


def record(properties: Json, description: str = "", required: Sequence[str] | None = None) -> Json:
    """Return an object with these properties, all of them ``required`` unless some are named."""
    needed = list(properties if required is None else required)
    return described({"type": "object", "properties": properties, "required": needed}, description)


def list_of(item: Json, description: str = "") -> Json:
    """Return a list."""
    return described({"type": "array", "items": item}, description)


def nullable(schema: Json, description: str = "") -> Json:
    """Return a schema that may be null."""
    return described({"anyOf": [schema, {"type": "null"}]}, description)


def described(schema: Json, description: str) -> Json:
    """Return the schema with a description, if there is one."""
    return {**schema, "description": description} if description else schema
