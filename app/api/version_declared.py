"""Schemas of the versions of the plant."""

from typing import Any

from app.domain.versions import Origin, VersionState

Json = dict[str, Any]

_TEXT, _WHOLE, _FLAG = {"type": "string"}, {"type": "integer"}, {"type": "boolean"}
_TIME = {"type": "string", "format": "date-time"}


def _object(properties: Json, description: str = "") -> Json:
    schema: Json = {"type": "object", "properties": properties, "required": list(properties)}
    return {**schema, "description": description} if description else schema


def _list(item: Json, description: str = "") -> Json:
    schema: Json = {"type": "array", "items": item}
    return {**schema, "description": description} if description else schema


def _maybe(schema: Json, description: str = "") -> Json:
    made: Json = {"anyOf": [schema, {"type": "null"}]}
    return {**made, "description": description} if description else made


def _ref(name: str) -> Json:
    return {"$ref": f"#/components/schemas/{name}"}


VERSIONS: Json = {
    "PlantVersion": _object(
        {
            "number": _WHOLE,
            "digest": {**_TEXT, "description": "SHA-256 of its text, in hex."},
            "size": {**_WHOLE, "description": "Bytes."},
            "state": {"type": "string", "enum": [state.value for state in VersionState]},
            "origin": {"type": "string", "enum": [origin.value for origin in Origin]},
            "at": _TIME,
            "actor": {**_TEXT, "description": "Who staged it."},
            "reason": _TEXT,
            "activated": _maybe(_TIME, "When last."),
            "activated_by": _maybe(_TEXT),
            "why": {**_TEXT, "description": "Why it was activated last."},
            "before": _maybe(_WHOLE, "The version that was active until then: activate that to roll back."),
            "asked": _maybe(_TIME, "Since when it is awaited."),
            "asked_by": _maybe(_TEXT),
            "asked_why": _TEXT,
            "patient": {**_FLAG, "description": "Awaited until nothing stands in its way."},
            "note": {**_TEXT, "description": "Why the last wish to activate it came to nothing."},
        },
        "A version of the plant file. One is active at any time; at most one is awaited.",
    ),
    "PlantFinding": _object(
        {
            "line": _WHOLE,
            "column": _WHOLE,
            "severity": {"type": "string", "enum": ["error", "warning"]},
            "path": _TEXT,
            "message": _TEXT,
            "remedy": _TEXT,
        },
        "As `hoistway check` tells it. Lines and columns count from 1.",
    ),
    "StagedVersion": {
        "allOf": [
            _ref("PlantVersion"),
            _object({"findings": _list(_ref("PlantFinding"), "Warnings; with errors nothing is staged.")}),
        ]
    },
    "PlantChange": _object(
        {
            "what": {**_TEXT, "description": "barcode, track, station, zone, vehicle, …"},
            "how": {"type": "string", "enum": ["added", "removed", "changed", "moved", "renamed"]},
            "name": _TEXT,
            "text": _TEXT,
            "before": {"description": "As it was; null: it was not there."},
            "after": {"description": "As it is to be; null: it is to go."},
        }
    ),
    "PlantBreak": _object(
        {
            "what": _TEXT,
            "name": _TEXT,
            "text": _TEXT,
            "remedy": _TEXT,
            "touches": _list(_TEXT, "What may refer to it: jobs, carriers, teaching, …"),
        }
    ),
    "PlantDifference": _object(
        {
            "version": _WHOLE,
            "against": _WHOLE,
            "changes": _list(_ref("PlantChange")),
            "breaks": _list(_ref("PlantBreak"), "What a plant that has run may still refer to, whatever is under way."),
        },
        "As `hoistway layout diff` tells it, from `against` to `version`.",
    ),
    "PlantImpact": _object(
        {
            "version": _WHOLE,
            "ready": {**_FLAG, "description": "Nothing stands in its way now."},
            "in_the_way": _list(_ref("PlantBreak"), "What is under way, and has no place in this version."),
            "lost": _list(_ref("PlantBreak"), "What was learnt of the plant and serves nobody any more; no hindrance."),
        }
    ),
    "PlantActivation": _object(
        {
            "version": _ref("PlantVersion"),
            "in_the_way": _list(_ref("PlantBreak"), "What it waits for; empty: it becomes active within seconds."),
        }
    ),
}
