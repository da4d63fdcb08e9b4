"""What is wrong with settings, in words: which setting, what it is for, what would do."""

import ast
import inspect
import re
import tomllib
from collections.abc import Mapping
from functools import lru_cache
from ipaddress import ip_address
from math import isfinite
from textwrap import dedent
from typing import Any
from urllib.parse import urlsplit

import yaml
from pydantic import BaseModel, SecretStr, ValidationError

NO_SETTINGS = "Write a name and a value on each line: port = 8080 in TOML, port: 8080 in YAML."
EXAMPLES = {
    "plant": "plants/demo.yaml",
    "access_key": "$(openssl rand -hex 24)",
    "metrics_key": "$(openssl rand -hex 24)",
    "tls_certificate": "/etc/hoistway/fullchain.pem",
    "tls_key": "/etc/hoistway/key.pem",
    "allowed_hosts": "tc.fab.example",
    "allowed_origins": "https://mes.example",
    "webhook_targets": "mes.fab.example, 10.1.0.0/16",
    "webhook_authorities": "/etc/hoistway/ca.pem",
}
"""For settings whose default shows no value."""
_NAME = re.compile(r"[A-Za-z0-9_]([A-Za-z0-9_-]*[A-Za-z0-9_])?(\.[A-Za-z0-9_]([A-Za-z0-9_-]*[A-Za-z0-9_])?)*\.?")
_AT = re.compile(r"\(at line (\d+), column (\d+)\)$")
_SHOWN = 80


def no_host(text: str) -> str:
    """Return why a text is no name of a host as callers write it; empty: it is one."""
    if _is_address(text.strip("[]")) or (_NAME.fullmatch(text) and len(text) <= 253):
        return ""
    return f"{_shown(text)} is no name of a host: no scheme, port, path or * belongs to it"


def no_origin(text: str) -> str:
    """Return why a text is no origin, as a browser names a page: scheme, host, port if it is not the usual one."""
    try:
        parts = urlsplit(text)
        whole = f"{parts.scheme}://{parts.netloc}"
        fits = parts.scheme in {"http", "https"} and parts.hostname and not no_host(parts.hostname)
        fits = fits and parts.username is None and (parts.port is None or parts.port > 0)
    except ValueError:
        fits, whole = False, ""
    return "" if fits and text.rstrip("/").lower() == whole.lower() else f"{_shown(text)} is no origin"


def _is_address(text: str) -> bool:
    try:
        ip_address(text)
    except ValueError:
        return False
    return True


def wrong_in(error: ValidationError, settings: type[BaseModel]) -> tuple[str, str]:
    """Return what is wrong with the first setting that cannot be, and what that setting is, with an example."""
    first = error.errors(include_url=False)[0]
    if not first["loc"]:
        return str(first["msg"]).removeprefix("Value error, "), ""
    name = str(first["loc"][0])
    return f"setting {name}: {_reason(first, name, settings)}", _meant(name, settings)


def _reason(error: Mapping[str, Any], name: str, settings: type[BaseModel]) -> str:
    kind, limits = str(error["type"]), error.get("ctx") or {}
    given = _shown(error["input"])
    if kind == "value_error":
        return str(error["msg"]).removeprefix("Value error, ")
    if kind == "too_short":
        return f"needs {limits['min_length']} characters or more, and has {limits['actual_length']}"
    if kind == "finite_number" or (kind in _LIMITS and not _is_finite(error["input"])):
        return f"{given} is no finite number"
    if kind.startswith("bool"):
        return f"{given} is neither true nor false"
    if kind in _LIMITS:
        return f"{given} is not {_LIMITS[kind]} {_plain(next(iter(limits.values())))}"
    if kind == "literal_error":
        return f"{given} is none of {str(limits['expected']).replace(' or ', ', ')}"
    field = settings.model_fields[name].annotation
    if SecretStr in (field, *getattr(field, "__args__", ())):
        return "it is no text"  # what was given may be the key
    return f"{given} is no {next((what for sign, what in _KINDS.items() if kind.startswith(sign)), 'value of it')}"


_LIMITS = {
    "greater_than": "above",
    "greater_than_equal": "at least",
    "less_than": "below",
    "less_than_equal": "at most",
}
_KINDS = {
    "float": "number",
    "int": "whole number",
    "tuple": "list",
    "path": "name of a file",
    "string": "text",
}
"""What pydantic's kinds of error ask for."""


def _is_finite(given: object) -> bool:
    return isfinite(float(given)) if isinstance(given, int | float | str) else True


def _plain(limit: object) -> str:
    return f"{limit:g}" if isinstance(limit, float) else str(limit)


def _meant(name: str, settings: type[BaseModel]) -> str:
    """Return what a setting is, with an example of it."""
    default = settings.model_fields[name].default
    example = EXAMPLES.get(name) or (str(default).lower() if isinstance(default, bool) else _plain(default))
    return f"{name} is: {described(settings)[name]} Example: {example}"


@lru_cache
def described(settings: type[BaseModel]) -> Mapping[str, str]:
    """Return what stands below each setting in the code; read there when something is wrong, since starting needs none of it."""
    (body,) = ast.parse(dedent(inspect.getsource(settings))).body
    assert isinstance(body, ast.ClassDef)
    found = {}
    for field, below in zip(body.body, body.body[1:], strict=False):
        if isinstance(field, ast.AnnAssign) and isinstance(field.target, ast.Name) and isinstance(below, ast.Expr):
            text = ast.literal_eval(below.value)
            found[field.target.id] = " ".join(str(text).replace("``", "").split())
    return found


def broken(error: Exception) -> str:
    """Return where a file of settings breaks its grammar."""
    from app.plant.broken import wanted

    if isinstance(error, yaml.MarkedYAMLError) and error.problem_mark is not None:
        mark, problem = error.problem_mark, str(error.problem)
        said = problem if problem.endswith(" is given twice") else wanted(problem)
        return f"line {mark.line + 1}, column {mark.column + 1}: {said}"
    at = _AT.search(str(error))
    if isinstance(error, tomllib.TOMLDecodeError):
        return f"line {at[1]}, column {at[2]}: this is no TOML" if at else "the file ends in the middle"
    return "a value in it cannot be read"


def _shown(given: object) -> str:
    text = repr(given) if isinstance(given, str) else str(given)
    return text if len(text) <= _SHOWN else f"{text[:_SHOWN]}…"
