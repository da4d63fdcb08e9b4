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

_TIME = {"type": "string", "format": "date-time"}
_MAYBE, _MAYBE_NUMBER = _nullable(_TEXT), _nullable(_NUMBER)

_MAYBE_FLAG = _nullable(_FLAG)

ROOM: Json = {
    "Times": _object(
        {"count": _WHOLE, "mean": _MAYBE_NUMBER, "p50": _MAYBE_NUMBER, "p95": _MAYBE_NUMBER, "longest": _MAYBE_NUMBER},
        "How long something took, seconds; null if it never happened.",
    ),
    "Statistics": _object(
        {
            "from": _TIME,
            "to": _TIME,
            "jobs": {
                "type": "object",
                "additionalProperties": _WHOLE,
                "description": "How many ended in each terminal state.",
            },
            "phases": {
                "type": "object",
                "additionalProperties": {"$ref": "#/components/schemas/Times"},
                "description": "Of completed jobs: queued, fetching, acquiring, carrying, depositing, total.",
            },
            "empty_share": {**_MAYBE_NUMBER, "description": "Of the time driven, that to sources, 0 to 1."},
            "intervals": _list(
                _object(
                    {
                        "begin": _TIME,
                        "ordered": _WHOLE,
                        "completed": _WHOLE,
                        "unfinished": {**_WHOLE, "description": "Failed, cancelled or aborted."},
                        "queue": {**_NUMBER, "description": "Jobs without a vehicle, on the average."},
                        "delivery": {"$ref": "#/components/schemas/Times"},
                    }
                )
            ),
            "vehicles": _list(
                {
                    "allOf": [
                        _object(
                            {
                                "vehicle": _TEXT,
                                "completed": _WHOLE,
                                "fetching": {**_NUMBER, "description": "Seconds empty to sources."},
                                "acquiring": _NUMBER,
                                "carrying": {**_NUMBER, "description": "Seconds loaded to destinations."},
                                "depositing": _NUMBER,
                                "busy_share": {**_NUMBER, "description": "Of the period, with jobs that ended in it."},
                            }
                        ),
                        {"$ref": "#/components/schemas/Reliability"},
                    ]
                }
            ),
            "waits": _list(
                _object(
                    {
                        "cause": {**_TEXT, "description": "The reason, each name in it a dash."},
                        "times": _WHOLE,
                        "seconds": _NUMBER,
                    }
                ),
                "The longest altogether first.",
            ),
            "waits_of": {**_WHOLE, "description": "Waits are those of so many jobs: all, or the newest."},
        }
    ),
    "Moment": _object(
        {
            "at": _TIME,
            "objects": {
                "type": "object",
                "description": "Topic, then key, to object. Of vehicles what a map shows: barcode, state, activity, job ...",
                "additionalProperties": {"type": "object", "additionalProperties": {"type": "object"}},
            },
        },
        "The plant as it was.",
    ),
    "Span": _object(
        {
            "from": _nullable(_TIME),
            "to": _nullable(_TIME),
            "bytes": _WHOLE,
            "incident": {
                **_nullable(_object({"by": _TEXT, "made": _TIME})),
                "description": "Who exported it, and when: it is a file under `hoistway replay`; null: the plant itself.",
            },
        },
        "What playback there is.",
    ),
    "PlaybackChange": _object(
        {
            "at": _TIME,
            "topic": _TEXT,
            "key": _TEXT,
            "value": {
                "type": ["object", "null"],
                "description": "The whole object, of a vehicle the fields that are other than before; null: it is gone.",
            },
        }
    ),
    "WalkPlace": _object(
        {
            "station": _TEXT,
            "believed": {**_MAYBE_FLAG, "description": "Whether something was there by the books when the walk began."},
            "believed_carrier": _MAYBE,
            "now": {**_MAYBE_FLAG, "description": "The same by the books of now."},
            "now_carrier": _MAYBE,
            "seen": {**_MAYBE_FLAG, "description": "What was entered; null: nothing yet."},
            "seen_carrier": _MAYBE,
            "by": _MAYBE,
            "at": _nullable(_TIME),
            "finding": {
                "type": "string",
                "enum": ["not_seen", "agrees", "differs", "moved"],
                "description": "Against the books of now; moved: they have changed since it was seen.",
            },
        },
        "A place of an audit walk. After the walk has ended `now` may be long past what was seen.",
    ),
    "AlarmCount": _object(
        {
            "kind": _MAYBE,
            "source": _MAYBE,
            "code": _MAYBE,
            "times": _WHOLE,
            "minutes": {**_NUMBER, "description": "Within the period, altogether."},
            "share": {**_NUMBER, "description": "Of the minutes of all rows, 0 to 1."},
            "newest": _TIME,
        },
        "How often and how long something was wrong; null: not told apart by that.",
    ),
    "Reliability": _object(
        {
            "vehicle": _TEXT,
            "failures": {**_WHOLE, "description": "Alarms and holds for a doubt; those that overlap are one."},
            "down_minutes": _NUMBER,
            "mtbf_hours": _MAYBE_NUMBER,
            "mttr_minutes": _MAYBE_NUMBER,
            "availability": {**_NUMBER, "description": "Share of the period without a failure, 0 to 1."},
        }
    ),
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
