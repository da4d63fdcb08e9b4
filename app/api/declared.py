"""The OpenAPI document: answers are encoded views, so their schemas come from the views' own types."""

from typing import Any, get_args

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi
from pydantic import TypeAdapter
from starlette.responses import Response

from app.api.policy import API, OUTSIDE, ROUTES
from app.api.problems import CODES, MEDIA_TYPE, TYPE_PREFIX
from app.api.room_declared import ROOM
from app.api.teaching_declared import TEACHING
from app.api.version_declared import VERSIONS
from app.api.webhook_declared import WEBHOOKS
from app.domain.access import Scope, who_may
from app.domain.view import View
from app.runtime.showing import RENAMED, TIMES

Json = dict[str, Any]
REF = "#/components/schemas/"

DESCRIPTION = """Transfers, vehicles, stations and carriers of one plant, and all that happens to them.

* Times are ISO 8601 in UTC. Ids have 1 to 64 characters without blanks, slashes and `?#%`.
* Whoever changes something is kept in the audit: by the name they logged in with or that their key has. Where nobody has to
  log in, they name themselves in the header `X-Actor`; a machine says there on whose behalf it asks.
* `x-roles` of each operation says which roles may, where callers have to say who they are.
* An answer to a change means: durable. A problem (RFC 9457) says why not, and what would help.
* `POST /jobs` is safe to repeat under the same `job_id` or `Idempotency-Key`.
* The live stream is described in `asyncapi.yaml`.
"""


SECURITY: Json = {
    "key": {
        "type": "http",
        "scheme": "bearer",
        "description": "A machine's key, as `hoistway keys add` showed it once.",
    },
    "session": {"type": "http", "scheme": "bearer", "description": "The token that `POST /session` gave a person."},
}
"""One of these is wanted where callers have to say who they are (docs/access.md)."""


class Raw(Response):
    """An answer whose schema the route declares by :func:`gives`."""


def ref(name: str) -> Json:
    """Return a reference to a schema."""
    return {"$ref": REF + name}


def gives(name: str | None, status: int = 200, description: str = "The answer.", **others: int) -> Json:
    """Return a route's arguments that declare what it gives: a schema, a list of it (``Name[]``), or nothing (None).

    ``others``: schema name -> further status with that schema.
    """
    responses: dict[int | str, Json] = {status: _response(name, description)}
    for other, code in others.items():
        responses[code] = _response(other, description)
    return {"status_code": status, "response_class": Raw, "response_model": None, "responses": responses}


def _response(name: str | None, description: str) -> Json:
    if name is None:
        return {"description": description}
    schema = ref(name)
    if name.endswith("[]"):
        schema = _object({"items": {"type": "array", "items": ref(name[:-2])}, "next": _NEXT}, required=["items"])
    return {"description": description, "content": {"application/json": {"schema": schema}}}


_NEXT = {"anyOf": [{"type": "integer"}, {"type": "null"}], "description": "Send it as `after` for more; null: the end."}
_TEXT = {"type": "string"}
_TIME = {"type": "string", "format": "date-time"}
_WHOLE = {"type": "integer"}
_FLAG = {"type": "boolean"}


def _object(properties: Json, required: list[str] | None = None) -> Json:
    return {"type": "object", "properties": properties, "required": required or list(properties)}


def _list(item: Json) -> Json:
    return {"type": "array", "items": item}


def _nullable(schema: Json) -> Json:
    return {"anyOf": [schema, {"type": "null"}]}


_SPAN = _nullable({"type": "number"})

OTHERS: Json = {
    "Problem": {
        "type": "object",
        "description": "RFC 9457. `code` is stable; `remedy` says what would help and may be empty.",
        "properties": {
            "type": {"type": "string", "format": "uri-reference", "examples": [f"{TYPE_PREFIX}not-now"]},
            "title": _TEXT,
            "status": _WHOLE,
            "detail": _TEXT,
            "code": {"type": "string", "enum": list(CODES)},
            "remedy": _TEXT,
            "field": {"type": "string", "description": "The offending part of the request."},
            "errors": _list(
                _object(
                    {
                        "field": _TEXT,
                        "message": _TEXT,
                        "remedy": _TEXT,
                        "line": {"type": "integer", "description": "In a file that was sent; from 1."},
                        "column": _WHOLE,
                        "severity": {"type": "string", "enum": ["error", "warning"]},
                    },
                    required=["field", "message"],
                )
            ),
        },
        "required": ["type", "title", "status", "detail"],
    },
    "ProblemKind": _object({"code": _TEXT, "status": _WHOLE, "title": _TEXT}),
    "JobWithHistory": {"allOf": [ref("Job"), _object({"history": _list(ref("Event"))})]},
    "JobWhy": _object(
        {
            "job": _TEXT,
            "state": _TEXT,
            "reason": {"type": "string", "description": "What it waits for now; empty: for nothing."},
            "created": _TIME,
            "queued": _SPAN | {"description": "Seconds until it first got a vehicle."},
            "fetching": _SPAN | {"description": "Seconds from then until the pick-up."},
            "carrying": _SPAN | {"description": "Seconds from then until its end."},
            "assignments": _list(
                _object(
                    {
                        "at": _TIME,
                        "vehicle": _TEXT,
                        "seconds": {"type": "number", "description": "The vehicle's way to the source."},
                        "priority": _WHOLE,
                        "hot": _FLAG,
                        "waited": {"type": "number", "description": "What its waiting was worth, seconds of driving."},
                        "switch": {"type": "number", "description": "What a change had to save besides, seconds."},
                        "before": _nullable(_TEXT) | {"description": "The vehicle that had the job until then."},
                        "saved": _SPAN | {"description": "So many seconds is it nearer than that one."},
                        "candidates": _list(_object({"vehicle": _TEXT, "seconds": _SPAN, "why_not": _TEXT})),
                    }
                )
            ),
            "waits": _list(_object({"since": _TIME, "until": _nullable(_TIME), "seconds": _SPAN, "reason": _TEXT})),
            "left_out": {"type": "integer", "description": "Assignments and waits between the first and the latest."},
        }
    ),
    "Pulses": _object({"shft": _WHOLE, "rota": _WHOLE, "lift": _WHOLE}),
    "Frame": _object(
        {
            "at": _TIME,
            "direction": {"type": "string", "enum": ["in", "out"]},
            "hex": _TEXT,
            "frames": {"type": "array", "items": {"type": "object"}, "description": "What the bytes say."},
        }
    ),
    "Audit": _object(
        {
            "seq": _WHOLE,
            "at": _TIME,
            "actor": _TEXT,
            "action": _TEXT,
            "target": _TEXT,
            "detail": _TEXT,
            "accepted": _FLAG,
        }
    ),
    "Taken": {
        "description": "Under way. `cmd_id` null: the command follows when the vehicle has its track.",
        **_object({"vehicle": _TEXT, "cmd_id": _nullable(_TEXT)}),
    },
    "Jog": _object({"drive": _TEXT, "jog": _TEXT, "hold": {"type": "number", "description": "Seconds."}}),
    "Watch": _object({"watch": _TEXT, "drive": _TEXT, "parameters": _list(_TEXT), "seconds": {"type": "number"}}),
    "Backup": _object(
        {
            "id": _WHOLE,
            "drive": _TEXT,
            "model": _TEXT,
            "at": _TIME,
            "actor": _TEXT,
            "note": _TEXT,
            "parameters": {"type": "integer", "description": "How many it has."},
        }
    ),
    "BackupWithValues": {
        "allOf": [
            ref("Backup"),
            _object(
                {
                    "values": _list(
                        _object(
                            {
                                "parameter": _TEXT,
                                "raw": _WHOLE,
                                "name": _TEXT,
                                "value": _nullable({"type": "number"}),
                                "unit": _TEXT,
                            }
                        )
                    )
                }
            ),
        ]
    },
    "Catalogue": _object(
        {
            "model": _TEXT,
            "description": _TEXT,
            "parameters": _list(
                _object(
                    {
                        "number": _TEXT,
                        "name": _TEXT,
                        "unit": _TEXT,
                        "scale": {"type": "number"},
                        "lowest": {"type": "number"},
                        "highest": {"type": "number"},
                        "default": _nullable({"type": "number"}),
                        "read_only": _FLAG,
                        "while_running": _FLAG,
                        "description": _TEXT,
                        "choices": {"type": "object", "additionalProperties": _TEXT},
                    }
                )
            ),
        }
    ),
    "DeviceTaken": {
        "description": "Under way. `cmd_id` null: nothing had to be sent.",
        **_object({"device": _TEXT, "cmd_id": _nullable(_TEXT)}),
    },
    "AuditCheck": {
        "description": "`broken`: number of the first row that does not follow from the one before it; null: none.",
        **_object(
            {
                "rows": {"type": "integer", "description": "How many were looked at and follow."},
                "last": {
                    "type": "integer",
                    "description": "The last of them; note it elsewhere together with its hash.",
                },
                "hash": _TEXT,
                "broken": _nullable(_WHOLE),
                "reason": _TEXT,
                "next": _NEXT,
            }
        ),
    },
    "Session": {
        "description": "The token is shown once. It is good until `expires`, and can be renewed until `until`.",
        **_object({"token": _TEXT, "expires": _TIME, "until": _TIME, "name": _TEXT, "roles": _list(_TEXT)}),
    },
    "Caller": {
        "description": "Who calls. `open`: nobody has to say who they are; then the name is null, and all is allowed.",
        **_object(
            {"open": _FLAG, "name": _nullable(_TEXT), "person": _FLAG, "roles": _list(_TEXT), "scopes": _list(_TEXT)}
        ),
    },
    "Call": {
        "description": "Method and path under /api/v1, which roles may, and whether the caller may (all, where nobody has to "
        "say who they are).",
        **_object({"call": _TEXT, "roles": _list(_TEXT), "allowed": _FLAG}),
    },
    "User": _object(
        {
            "name": _TEXT,
            "roles": _list(_TEXT),
            "created": _TIME,
            "created_by": _TEXT,
            "disabled": _FLAG,
            "logged_in": _nullable(_TIME) | {"description": "When last."},
        }
    ),
    "Key": _object(
        {
            "name": _TEXT,
            "roles": _list(_TEXT),
            "created": _TIME,
            "created_by": _TEXT,
            "expires": _nullable(_TIME),
            "revoked": _nullable(_TIME),
            "used": _nullable(_TIME) | {"description": "When last, to the minute."},
            "state": {"type": "string", "enum": ["active", "expired", "revoked"]},
        }
    ),
    "NewKey": {
        "description": "The key itself is shown now and never again.",
        "allOf": [ref("Key"), _object({"key": _TEXT})],
    },
    "Ticket": _object({"ticket": _TEXT, "expires_in": {"type": "number", "description": "Seconds."}}),
    "Health": _object({"status": _TEXT}),
    "Readiness": _object({"ready": _FLAG, "reasons": _list(_TEXT)}),
    "RouteView": {
        "description": "Seconds of driving at the present delays, and on an empty track; length in mm; which version of the map.",
        **_object(
            {
                "barcodes": _list(_TEXT),
                "length": _WHOLE,
                "seconds": {"type": "number"},
                "free_flow_seconds": {"type": "number"},
                "version": _WHOLE,
            }
        ),
    },
    "Layout": _object(
        {
            "name": _TEXT,
            "version": _nullable(_WHOLE) | {"description": "Of the plant; null where no versions are kept."},
            "points": _list(_object({"barcode": _TEXT, "x": _WHOLE, "y": _WHOLE, "park": _FLAG})),
            "edges": _list(
                _object(
                    {
                        "start": _TEXT,
                        "end": _TEXT,
                        "length": _WHOLE,
                        "speed": _WHOLE,
                        "sensor": _WHOLE,
                        "curve": _FLAG,
                    }
                )
            ),
            "stations": _list(
                _object({"id": _TEXT, "kind": _TEXT, "barcode": _TEXT, "display": _TEXT, "buffer": _nullable(_TEXT)})
            ),
            "zones": _list(
                _object(
                    {
                        "id": _TEXT,
                        "name": _TEXT,
                        "barcodes": _list(_TEXT),
                        "capacity": _WHOLE,
                        "no_stop": _FLAG,
                        "soft": _nullable(_object({"share": {"type": "number"}, "patience": {"type": "number"}}))
                        | {"description": "No hard cap: a share of its slots is filled from outside, for so many s."},
                    }
                )
            ),
            "vehicles": _list(
                _object(
                    {
                        "id": _TEXT,
                        "kind": _TEXT,
                        "link": _nullable(_TEXT),
                        "length": _WHOLE,
                        "max_speed": _WHOLE,
                        "curve_speed": _WHOLE,
                    }
                )
            ),
            "links": _list(_object({"id": _TEXT, "protocol": _TEXT, "address": _TEXT})),
            "doors": _list(
                _object(
                    {
                        "id": _TEXT,
                        "link": _TEXT,
                        "number": _WHOLE,
                        "passages": _list(_list(_TEXT)),
                        "normally_open": _FLAG,
                    }
                )
            ),
            "buffers": _list(_object({"id": _TEXT, "link": _TEXT, "number": _WHOLE})),
            "chargers": _list(_object({"id": _TEXT, "barcode": _TEXT, "alias": _nullable(_TEXT)})),
            "drives": _list(_object({"id": _TEXT, "name": _TEXT, "line": _TEXT, "address": _WHOLE, "model": _TEXT})),
        }
    ),
}
"""Answers that are no views. Lengths and places in mm, speeds of edges in percent, of vehicles in mm/s."""


def view_schemas() -> Json:
    """Return the schemas of all views as they are encoded: every field there, times as text."""
    adapters = [(kind.__name__, "serialization", TypeAdapter(kind)) for kind in get_args(View)]
    _, whole = TypeAdapter.json_schemas(adapters, ref_template=REF + "{model}")  # type: ignore[arg-type]
    schemas = {name.removesuffix("View"): _as_encoded(name, schema) for name, schema in whole["$defs"].items()}
    return {name: _renamed(schema) for name, schema in schemas.items()}


def _as_encoded(name: str, schema: Json) -> Json:
    labels = {(kind.__name__, old): new for (kind, old), new in RENAMED.items()}
    properties = {}
    for old, inner in schema["properties"].items():
        properties[labels.get((name, old), old)] = _timely(inner) if old in TIMES else inner
    return {**schema, "title": name.removesuffix("View"), "properties": properties, "required": list(properties)}


def _timely(schema: Json) -> Json:
    nullable = any(part.get("type") == "null" for part in schema.get("anyOf", []))
    return _nullable(_TIME) if nullable else dict(_TIME)


def _renamed(node: Any) -> Any:
    """Drop the word View, and defaults, which an answer does not have."""
    if isinstance(node, dict):
        return {
            key: value.removesuffix("View") if key == "$ref" else _renamed(value)
            for key, value in node.items()
            if key != "default" or isinstance(value, dict)
        }
    return [_renamed(part) for part in node] if isinstance(node, list) else node


def declare(app: FastAPI) -> None:
    """Give the application its OpenAPI document."""

    def openapi() -> Json:
        if app.openapi_schema is None:
            app.openapi_schema = _document(app)
        return app.openapi_schema

    app.openapi = openapi  # type: ignore[method-assign]


def _document(app: FastAPI) -> Json:
    document = get_openapi(
        title=app.title, version=app.version, description=DESCRIPTION, routes=app.routes, tags=app.openapi_tags
    )
    components = document.setdefault("components", {})
    schemas = components.setdefault("schemas", {})
    for name in ("HTTPValidationError", "ValidationError"):
        schemas.pop(name, None)
    schemas.update(view_schemas() | OTHERS | TEACHING | WEBHOOKS | ROOM | VERSIONS)
    components["schemas"] = {name: _plain(schema) for name, schema in sorted(schemas.items())}
    components["securitySchemes"] = SECURITY
    components["responses"] = {
        "Problem": {"description": "Why not.", "content": {MEDIA_TYPE: {"schema": ref("Problem")}}}
    }
    document["security"] = [{}, *({name: []} for name in SECURITY)]
    for where, path in document["paths"].items():
        for method, operation in path.items():
            responses = operation["responses"]
            responses.pop("422", None)
            responses["default"] = {"$ref": "#/components/responses/Problem"}
            _say_who_may(operation, f"{method.upper()} {where}")
    return document


def _plain(schema: Any) -> Any:
    """Return a schema in which a list of so many of the same kind is said as that, not each of them by itself: most tools that
    make clients or calls of the document know only the first."""
    if isinstance(schema, list):
        return [_plain(part) for part in schema]
    if not isinstance(schema, dict):
        return schema
    parts = {name: _plain(part) for name, part in schema.items() if name != "prefixItems"}
    each = _plain(schema.get("prefixItems", []))
    if each and "items" not in parts and all(one == each[0] for one in each):
        return parts | {"items": each[0]}
    return parts | ({"prefixItems": each} if each else {})


def _say_who_may(operation: Json, name: str) -> None:
    """Write into an operation which roles it is for."""
    method, _, path = name.partition(" ")
    inside = path.startswith(API + "/")
    scope = ROUTES[f"{method} {path.removeprefix(API)}"] if inside else OUTSIDE[name]
    if scope is Scope.PUBLIC:
        operation["security"] = []
    else:
        operation["x-roles"] = [role.value for role in who_may(scope)]
