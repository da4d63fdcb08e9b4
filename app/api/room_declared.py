"""Schemas of what the control room asks for that is no view."""

from typing import Any

Json = dict[str, Any]


def _object(properties: Json, description: str = "") -> Json:
    schema: Json = {"type": "object", "properties": properties, "required": list(properties)}
    return {**schema, "description": description} if description else schema


def _list(item: Json, description: str = "") -> Json:
    schema: Json = {"type": "array", "items": item}
    return {**schema, "description": description} if description else schema


def _nullable(schema: Json) -> Json:
    return {"anyOf": [schema, {"type": "null"}]}


_FLAG = {"type": "boolean"}
_TEXT, _WHOLE, _NUMBER = {"type": "string"}, {"type": "integer"}, {"type": "number"}

ROOM: Json = {
    "Zone": _object(
        {
            "id": _TEXT,
            "name": _TEXT,
            "capacity": _WHOLE,
            "no_stop": _FLAG,
            "state": {**_TEXT, "enum": ["auto", "paused", "stopped"]},
            "pause": _nullable({"$ref": "#/components/schemas/Pause"}),
            "vehicles": _list(_TEXT, "Those that hold track in it."),
        },
        "A zone of the plant.",
    ),
    "ClosurePreview": _object(
        {
            "place": _TEXT,
            "barcodes": _list(_TEXT),
            "stations": _list(_TEXT, "Stations that it closes."),
            "cut_off": _list(_TEXT, "Stations that could not be reached, or not be left, any more."),
            "inside": _list(_TEXT, "Vehicles that would have to drive out."),
            "shut_in": _list(_TEXT, "Vehicles that could not get out, or round, any more."),
            "jobs_touched": _WHOLE,
            "jobs": _list(_object({"job": _TEXT, "why": _TEXT}), "The first of them."),
            "routes": _object(
                {
                    "compared": {**_WHOLE, "description": "Pairs of stations that were compared: all, or a sample."},
                    "longer": {**_WHOLE, "description": "Pairs whose route would take longer."},
                    "lost": {**_WHOLE, "description": "Pairs that would have no route any more."},
                    "mean_seconds": {**_NUMBER, "description": "Of the pairs that stay connected, now."},
                    "mean_seconds_after": _NUMBER,
                    "worst": _list(_object({"from": _TEXT, "to": _TEXT, "seconds": _NUMBER, "seconds_after": _NUMBER})),
                }
            ),
        },
        "What a closure would do.",
    ),
}
"""Times of driving in seconds."""
