"""The OpenAPI document: answers are encoded views, so their schemas come from the views' own types."""

from collections.abc import Iterable
from typing import Any, get_args

from fastapi import FastAPI
from fastapi.openapi.utils import get_openapi
from pydantic import TypeAdapter
from starlette.responses import Response

from app.api.policy import API, OUTSIDE, ROUTES
from app.api.problems import CODES, MEDIA_TYPE, TYPE_PREFIX
from app.api.room_declared import ROOM
from app.api.schemas import FLAG, REF, TEXT, TIME, WHOLE, Json, list_of, nullable, record, ref
from app.api.teaching_declared import TEACHING
from app.api.version_declared import VERSIONS
from app.api.webhook_declared import WEBHOOKS
from app.domain.access import Scope, who_may
from app.domain.alarms import AlarmKind
from app.domain.devices import DeviceKind
from app.domain.job import JobEvent, JobState, Leg
from app.domain.layout import StationKind, VehicleKind
from app.domain.records import ControllerState, IntentState, Provenance
from app.domain.vehicle import Activity, Mode, Oper, VehicleState
from app.domain.view import View
from app.runtime.showing import RENAMED, TIMES

DESCRIPTION = """Transfers, vehicles, stations and carriers of one plant, and all that happens to them.

* Times are ISO 8601 in UTC. Ids have 1 to 64 characters without blanks, slashes and `?#%`.
* Whoever changes something is kept in the audit: by the name they logged in with or that their key has. Where nobody has to
  log in, they name themselves in the header `X-Actor`; a machine says there on whose behalf it asks.
* `x-roles` of each operation says which roles may, where callers have to say who they are.
* An answer to a change means: durable. A problem (RFC 9457) says why not, and what would help.
* `POST /jobs` is safe to repeat under the same `job_id` or `Idempotency-Key`.
* The live stream is described in `asyncapi.yaml`.
"""


SERVICE = ("in_service", "out_of_service")
ONE_OF: dict[tuple[str, str], Iterable[str]] = {
    ("JobView", "state"): JobState,
    ("JobView", "leg"): Leg,
    ("EventView", "event"): JobEvent,
    ("CommandView", "state"): IntentState,
    ("ControllerView", "state"): ControllerState,
    ("AlarmView", "kind"): AlarmKind,
    ("VehicleView", "state"): VehicleState,
    ("VehicleView", "activity"): get_args(Activity),
    ("VehicleView", "kind"): VehicleKind,
    ("VehicleView", "service"): SERVICE,
    ("VehicleView", "mode"): [mode.name.lower() for mode in Mode],
    ("VehicleView", "oper"): [oper.name.lower() for oper in Oper],
    ("StationView", "kind"): StationKind,
    ("StationView", "provenance"): Provenance,
    ("CarrierView", "provenance"): Provenance,
    ("DeviceView", "kind"): DeviceKind,
    ("DeviceView", "service"): SERVICE,
}
"""Fields of views that are one of a few words: a typed client wants to know them. (View, field) -> the words."""


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
        schema = record({"items": {"type": "array", "items": ref(name[:-2])}, "next": _NEXT}, required=["items"])
    return {"description": description, "content": {"application/json": {"schema": schema}}}


_NEXT = {"anyOf": [{"type": "integer"}, {"type": "null"}], "description": "Send it as `after` for more; null: the end."}


_SPAN = nullable({"type": "number"})

OTHERS: Json = {
    "Problem": {
        "type": "object",
        "description": "RFC 9457. `code` is stable; `remedy` says what would help and may be empty.",
        "properties": {
            "type": {"type": "string", "format": "uri-reference", "examples": [f"{TYPE_PREFIX}not-now"]},
            "title": TEXT,
            "status": WHOLE,
            "detail": TEXT,
            "code": {"type": "string", "enum": list(CODES)},
            "remedy": TEXT,
            "field": {"type": "string", "description": "The offending part of the request."},
            "errors": list_of(
                record(
                    {
                        "field": TEXT,
                        "message": TEXT,
                        "remedy": TEXT,
                        "line": {"type": "integer", "description": "In a file that was sent; from 1."},
                        "column": WHOLE,
                        "severity": {"type": "string", "enum": ["error", "warning"]},
                    },
                    required=["field", "message"],
                )
            ),
        },
        "required": ["type", "title", "status", "detail"],
    },
    "ProblemKind": record({"code": TEXT, "status": WHOLE, "title": TEXT}),
    "JobWithHistory": {"allOf": [ref("Job"), record({"history": list_of(ref("Event"))})]},
    "JobWhy": record(
        {
            "job": TEXT,
            "state": TEXT,
            "reason": {"type": "string", "description": "What it waits for now; empty: for nothing."},
            "created": TIME,
            "queued": _SPAN | {"description": "Seconds until it got the vehicle that it has or had last."},
            "fetching": _SPAN | {"description": "Seconds from then until the pick-up began."},
            "acquiring": _SPAN | {"description": "Seconds of the pick-up."},
            "carrying": _SPAN | {"description": "Seconds from the pick-up to the beginning of the put-down."},
            "depositing": _SPAN | {"description": "Seconds of the put-down."},
            "total": _SPAN | {"description": "Seconds from its acceptance to its end."},
            "assignments": list_of(
                record(
                    {
                        "at": TIME,
                        "vehicle": TEXT,
                        "seconds": {"type": "number", "description": "The vehicle's way to the source."},
                        "priority": WHOLE,
                        "hot": FLAG,
                        "waited": {"type": "number", "description": "What its waiting was worth, seconds of driving."},
                        "switch": {"type": "number", "description": "What a change had to save besides, seconds."},
                        "before": nullable(TEXT) | {"description": "The vehicle that had the job until then."},
                        "saved": _SPAN | {"description": "So many seconds is it nearer than that one."},
                        "candidates": list_of(record({"vehicle": TEXT, "seconds": _SPAN, "why_not": TEXT})),
                    }
                )
            ),
            "waits": list_of(record({"since": TIME, "until": nullable(TIME), "seconds": _SPAN, "reason": TEXT})),
            "left_out": {"type": "integer", "description": "Assignments and waits between the first and the latest."},
        }
    ),
    "Pulses": record({"shft": WHOLE, "rota": WHOLE, "lift": WHOLE}),
    "Frame": record(
        {
            "at": TIME,
            "direction": {"type": "string", "enum": ["in", "out"]},
            "hex": TEXT,
            "frames": {"type": "array", "items": {"type": "object"}, "description": "What the bytes say."},
        }
    ),
    "Audit": record(
        {
            "seq": WHOLE,
            "at": TIME,
            "actor": TEXT,
            "action": TEXT,
            "target": TEXT,
            "detail": TEXT,
            "accepted": FLAG,
        }
    ),
    "Taken": {
        "description": "Under way. `cmd_id` null: the command follows when the vehicle has its track.",
        **record({"vehicle": TEXT, "cmd_id": nullable(TEXT)}),
    },
    "Jog": record({"drive": TEXT, "jog": TEXT, "hold": {"type": "number", "description": "Seconds."}}),
    "Watch": record({"watch": TEXT, "drive": TEXT, "parameters": list_of(TEXT), "seconds": {"type": "number"}}),
    "Backup": record(
        {
            "id": WHOLE,
            "drive": TEXT,
            "model": TEXT,
            "at": TIME,
            "actor": TEXT,
            "note": TEXT,
            "parameters": {"type": "integer", "description": "How many it has."},
        }
    ),
    "BackupWithValues": {
        "allOf": [
            ref("Backup"),
            record(
                {
                    "values": list_of(
                        record(
                            {
                                "parameter": TEXT,
                                "raw": WHOLE,
                                "name": TEXT,
                                "value": nullable({"type": "number"}),
                                "unit": TEXT,
                            }
                        )
                    )
                }
            ),
        ]
    },
    "Catalogue": record(
        {
            "model": TEXT,
            "description": TEXT,
            "parameters": list_of(
                record(
                    {
                        "number": TEXT,
                        "name": TEXT,
                        "unit": TEXT,
                        "scale": {"type": "number"},
                        "lowest": {"type": "number"},
                        "highest": {"type": "number"},
                        "default": nullable({"type": "number"}),
                        "read_only": FLAG,
                        "while_running": FLAG,
                        "description": TEXT,
                        "choices": {"type": "object", "additionalProperties": TEXT},
                    }
                )
            ),
        }
    ),
    "DeviceTaken": {
        "description": "Under way. `cmd_id` null: nothing had to be sent.",
        **record({"device": TEXT, "cmd_id": nullable(TEXT)}),
    },
    "AuditCheck": {
        "description": "`broken`: number of the first row that does not follow from the one before it; null: none.",
        **record(
            {
                "rows": {"type": "integer", "description": "How many were looked at and follow."},
                "last": {
                    "type": "integer",
                    "description": "The last of them; note it elsewhere together with its hash.",
                },
                "hash": TEXT,
                "broken": nullable(WHOLE),
                "reason": TEXT,
                "next": _NEXT,
            }
        ),
    },
    "Session": {
        "description": "The token is shown once. It is good until `expires`, and can be renewed until `until`.",
        **record({"token": TEXT, "expires": TIME, "until": TIME, "name": TEXT, "roles": list_of(TEXT)}),
    },
    "Caller": {
        "description": "Who calls. `open`: nobody has to say who they are; then the name is null, and all is allowed.",
        **record(
            {"open": FLAG, "name": nullable(TEXT), "person": FLAG, "roles": list_of(TEXT), "scopes": list_of(TEXT)}
        ),
    },
    "Required": {
        "description": "Whether callers have to say who they are.",
        **record({"required": FLAG}),
    },
    "Call": {
        "description": "Method and path under /api/v1, which roles may, and whether the caller may (all, where nobody has to "
        "say who they are).",
        **record({"call": TEXT, "roles": list_of(TEXT), "allowed": FLAG}),
    },
    "User": record(
        {
            "name": TEXT,
            "roles": list_of(TEXT),
            "created": TIME,
            "created_by": TEXT,
            "disabled": FLAG,
            "logged_in": nullable(TIME) | {"description": "When last."},
        }
    ),
    "Key": record(
        {
            "name": TEXT,
            "roles": list_of(TEXT),
            "created": TIME,
            "created_by": TEXT,
            "expires": nullable(TIME),
            "revoked": nullable(TIME),
            "used": nullable(TIME) | {"description": "When last, to the minute."},
            "state": {"type": "string", "enum": ["active", "expired", "revoked"]},
        }
    ),
    "NewKey": {
        "description": "The key itself is shown now and never again.",
        "allOf": [ref("Key"), record({"key": TEXT})],
    },
    "Ticket": record({"ticket": TEXT, "expires_in": {"type": "number", "description": "Seconds."}}),
    "Health": record({"status": TEXT}),
    "Readiness": record({"ready": FLAG, "reasons": list_of(TEXT)}),
    "RouteView": {
        "description": "Seconds of driving at the present delays, and on an empty track; length in mm; which version of the map.",
        **record(
            {
                "barcodes": list_of(TEXT),
                "length": WHOLE,
                "seconds": {"type": "number"},
                "free_flow_seconds": {"type": "number"},
                "version": WHOLE,
            }
        ),
    },
    "Layout": record(
        {
            "name": TEXT,
            "version": nullable(WHOLE) | {"description": "Of the plant; null where no versions are kept."},
            "points": list_of(record({"barcode": TEXT, "x": WHOLE, "y": WHOLE, "park": FLAG})),
            "edges": list_of(
                record(
                    {
                        "start": TEXT,
                        "end": TEXT,
                        "length": WHOLE,
                        "speed": WHOLE,
                        "sensor": WHOLE,
                        "curve": FLAG,
                    }
                )
            ),
            "stations": list_of(
                record({"id": TEXT, "kind": TEXT, "barcode": TEXT, "display": TEXT, "buffer": nullable(TEXT)})
            ),
            "zones": list_of(
                record(
                    {
                        "id": TEXT,
                        "name": TEXT,
                        "barcodes": list_of(TEXT),
                        "capacity": WHOLE,
                        "no_stop": FLAG,
                        "soft": nullable(record({"share": {"type": "number"}, "patience": {"type": "number"}}))
                        | {"description": "No hard cap: a share of its slots is filled from outside, for so many s."},
                    }
                )
            ),
            "vehicles": list_of(
                record(
                    {
                        "id": TEXT,
                        "kind": TEXT,
                        "link": nullable(TEXT),
                        "length": WHOLE,
                        "max_speed": WHOLE,
                        "curve_speed": WHOLE,
                    }
                )
            ),
            "links": list_of(record({"id": TEXT, "protocol": TEXT, "address": TEXT})),
            "doors": list_of(
                record(
                    {
                        "id": TEXT,
                        "link": TEXT,
                        "number": WHOLE,
                        "passages": list_of(list_of(TEXT)),
                        "normally_open": FLAG,
                    }
                )
            ),
            "buffers": list_of(record({"id": TEXT, "link": TEXT, "number": WHOLE})),
            "chargers": list_of(record({"id": TEXT, "barcode": TEXT, "alias": nullable(TEXT)})),
            "drives": list_of(record({"id": TEXT, "name": TEXT, "line": TEXT, "address": WHOLE, "model": TEXT})),
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
        words = ONE_OF.get((name, old))
        said = _worded(inner, words) if words else inner
        properties[labels.get((name, old), old)] = _timely(inner) if old in TIMES else said
    return {**schema, "title": name.removesuffix("View"), "properties": properties, "required": list(properties)}


def _worded(schema: Json, words: Iterable[str]) -> Json:
    """Say which words a text is one of."""
    if "anyOf" in schema:
        return {
            **schema,
            "anyOf": [_worded(part, words) if part["type"] == "string" else part for part in schema["anyOf"]],
        }
    return {**schema, "enum": [str(word) for word in words]}


def _timely(schema: Json) -> Json:
    may_be_null = any(part.get("type") == "null" for part in schema.get("anyOf", []))
    return nullable(TIME) if may_be_null else dict(TIME)


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
