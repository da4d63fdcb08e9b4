"""Schemas of what the control room asks for that is no view."""

from app.api.schemas import FLAG, NUMBER, TEXT, TIME, WHOLE, Json, list_of, nullable, record
from app.domain.statistics import Phase

_MAYBE, _MAYBE_NUMBER = nullable(TEXT), nullable(NUMBER)

_MAYBE_FLAG = nullable(FLAG)

ROOM: Json = {
    "Times": record(
        {"count": WHOLE, "mean": _MAYBE_NUMBER, "p50": _MAYBE_NUMBER, "p95": _MAYBE_NUMBER, "longest": _MAYBE_NUMBER},
        "How long something took, seconds; null if it never happened.",
    ),
    "Statistics": record(
        {
            "from": TIME,
            "to": TIME,
            "jobs": {
                "type": "object",
                "additionalProperties": WHOLE,
                "description": "How many ended in each terminal state.",
            },
            "phases": {
                "type": "object",
                "additionalProperties": {"$ref": "#/components/schemas/Times"},
                "description": "Of completed jobs: queued, fetching, acquiring, carrying, depositing, total.",
            },
            "empty_share": {**_MAYBE_NUMBER, "description": "Of the time driven, that to sources, 0 to 1."},
            "intervals": list_of(
                record(
                    {
                        "begin": TIME,
                        "ordered": WHOLE,
                        "completed": WHOLE,
                        "unfinished": {**WHOLE, "description": "Failed, cancelled or aborted."},
                        "queue": {**NUMBER, "description": "Jobs without a vehicle, on the average."},
                        "delivery": {"$ref": "#/components/schemas/Times"},
                    }
                )
            ),
            "vehicles": list_of(
                {
                    "allOf": [
                        record(
                            {
                                "vehicle": TEXT,
                                "completed": WHOLE,
                                "fetching": {**NUMBER, "description": "Seconds empty to sources."},
                                "acquiring": NUMBER,
                                "carrying": {**NUMBER, "description": "Seconds loaded to destinations."},
                                "depositing": NUMBER,
                                "busy_share": {**NUMBER, "description": "Of the period, with jobs that ended in it."},
                            }
                        ),
                        {"$ref": "#/components/schemas/Reliability"},
                    ]
                }
            ),
            "waits": list_of(
                record(
                    {
                        "cause": {**TEXT, "description": "The reason, with … for each name in it."},
                        "times": WHOLE,
                        "seconds": NUMBER,
                    }
                ),
                "The longest altogether first.",
            ),
            "waits_of": {**WHOLE, "description": "Waits are those of so many jobs: all, or the newest."},
            "places": list_of(
                record(
                    {
                        "place": {**TEXT, "description": "The first station, or else vehicle, that a reason names."},
                        "jobs": WHOLE,
                        "seconds": NUMBER,
                        "cause": {**TEXT, "description": "What they waited for there the longest."},
                    }
                ),
                "Where jobs waited, the longest altogether first.",
            ),
            "late": list_of(
                record(
                    {
                        "job": TEXT,
                        "carrier": _MAYBE,
                        "source": TEXT,
                        "destination": TEXT,
                        "vehicle": _MAYBE,
                        "created": TIME,
                        "ended": TIME,
                        **{phase.value: _MAYBE_NUMBER for phase in Phase},
                        "waited": {**NUMBER, "description": "Seconds of its longest wait."},
                        "reason": {**TEXT, "description": "What that was for; empty: nothing is kept."},
                    }
                ),
                "The five completed jobs that took the longest, the longest first; phases in seconds.",
            ),
            "open": list_of(
                record(
                    {
                        "job": TEXT,
                        "carrier": _MAYBE,
                        "source": TEXT,
                        "destination": TEXT,
                        "priority": WHOLE,
                        "created": TIME,
                        "seconds": {**NUMBER, "description": "From then to the end of the period."},
                        "reason": {**TEXT, "description": "What it waited for at the end; empty: for nothing."},
                    }
                ),
                "Jobs that had not ended at the end of the period, the oldest first; 1,000 at most.",
            ),
        }
    ),
    "Moment": record(
        {
            "at": TIME,
            "objects": {
                "type": "object",
                "description": "Topic, then key, to object. Of vehicles what a map shows: barcode, state, activity, job ...",
                "additionalProperties": {"type": "object", "additionalProperties": {"type": "object"}},
            },
        },
        "The plant as it was.",
    ),
    "Span": record(
        {
            "from": nullable(TIME),
            "to": nullable(TIME),
            "bytes": WHOLE,
            "incident": {
                **nullable(record({"by": TEXT, "made": TIME})),
                "description": "Who exported it, and when: it is a file under `hoistway replay`; null: the plant itself.",
            },
        },
        "What playback there is.",
    ),
    "Heat": record(
        {
            "from": nullable(TIME),
            "to": nullable(TIME),
            "waiting": {
                "type": "object",
                "description": "Barcode to the seconds that vehicles waited there, all together.",
                "additionalProperties": {"type": "number"},
            },
            "traffic": {
                "type": "object",
                "description": "Barcode to how many vehicles came there.",
                "additionalProperties": WHOLE,
            },
        },
        "Where vehicles waited, and where many came by.",
    ),
    "PlaybackChange": record(
        {
            "at": TIME,
            "topic": TEXT,
            "key": TEXT,
            "value": {
                "type": ["object", "null"],
                "description": "The whole object, of a vehicle the fields that are other than before; null: it is gone.",
            },
        }
    ),
    "WalkPlace": record(
        {
            "station": TEXT,
            "believed": {**_MAYBE_FLAG, "description": "Whether something was there by the books when the walk began."},
            "believed_carrier": _MAYBE,
            "now": {**_MAYBE_FLAG, "description": "The same by the books of now."},
            "now_carrier": _MAYBE,
            "seen": {**_MAYBE_FLAG, "description": "What was entered; null: nothing yet."},
            "seen_carrier": _MAYBE,
            "by": _MAYBE,
            "at": nullable(TIME),
            "finding": {
                "type": "string",
                "enum": ["not_seen", "agrees", "differs", "moved"],
                "description": "Against the books of now, or as it was accepted; moved: they have changed since it was seen.",
            },
        },
        "A place of an audit walk. After the walk has ended `now` may be long past what was seen.",
    ),
    "AlarmAnswer": record(
        {
            "alarm": WHOLE,
            "acknowledged": {**FLAG, "description": "By this person, or by somebody before."},
            "code": {**_MAYBE, "description": "Of the problem; null: there is none."},
            "detail": TEXT,
        },
        "What became of one of several alarms that were acknowledged together.",
    ),
    "AlarmCount": record(
        {
            "kind": _MAYBE,
            "source": _MAYBE,
            "code": _MAYBE,
            "times": WHOLE,
            "minutes": {**NUMBER, "description": "Within the period, altogether."},
            "share": {**NUMBER, "description": "Of the minutes of all rows, 0 to 1."},
            "newest": TIME,
        },
        "How often and how long something was wrong; null: not told apart by that.",
    ),
    "Reliability": record(
        {
            "vehicle": TEXT,
            "failures": {**WHOLE, "description": "Alarms and holds for a doubt; those that overlap are one."},
            "down_minutes": NUMBER,
            "mtbf_hours": _MAYBE_NUMBER,
            "mttr_minutes": _MAYBE_NUMBER,
            "availability": {**NUMBER, "description": "Share of the period without a failure, 0 to 1."},
        }
    ),
    "Zone": record(
        {
            "id": TEXT,
            "name": TEXT,
            "capacity": WHOLE,
            "no_stop": FLAG,
            "state": {**TEXT, "enum": ["auto", "paused", "stopped"]},
            "pause": nullable({"$ref": "#/components/schemas/Pause"}),
            "vehicles": list_of(TEXT, "Those that hold track in it."),
        },
        "A zone of the plant.",
    ),
    "ClosurePreview": record(
        {
            "place": TEXT,
            "barcodes": list_of(TEXT),
            "stations": list_of(TEXT, "Stations that it closes."),
            "cut_off": list_of(TEXT, "Stations that could not be reached, or not be left, any more."),
            "inside": list_of(TEXT, "Vehicles that would have to drive out."),
            "shut_in": list_of(TEXT, "Vehicles that could not get out, or round, any more."),
            "jobs_touched": WHOLE,
            "jobs": list_of(record({"job": TEXT, "why": TEXT}), "The first of them."),
            "routes": record(
                {
                    "compared": {**WHOLE, "description": "Pairs of stations that were compared: all, or a sample."},
                    "longer": {**WHOLE, "description": "Pairs whose route would take longer."},
                    "lost": {**WHOLE, "description": "Pairs that would have no route any more."},
                    "mean_seconds": {**NUMBER, "description": "Of the pairs that stay connected, now."},
                    "mean_seconds_after": NUMBER,
                    "worst": list_of(record({"from": TEXT, "to": TEXT, "seconds": NUMBER, "seconds_after": NUMBER})),
                }
            ),
        },
        "What a closure would do.",
    ),
}
"""Times of driving in seconds."""
