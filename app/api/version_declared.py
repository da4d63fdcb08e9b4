"""Schemas of the versions of the plant."""

from app.api.schemas import FLAG, TEXT, TIME, WHOLE, Json, list_of, nullable, record, ref
from app.domain.versions import Origin, VersionState

VERSIONS: Json = {
    "PlantVersion": record(
        {
            "number": WHOLE,
            "digest": {
                **TEXT,
                "description": "What tells it from others: SHA-256 of its text, and of its catalogues if any.",
            },
            "models": {
                "type": "object",
                "additionalProperties": TEXT,
                "description": "The catalogues of its drives, kept with it: SHA-256 by model.",
            },
            "size": {**WHOLE, "description": "Bytes."},
            "state": {"type": "string", "enum": [state.value for state in VersionState]},
            "origin": {"type": "string", "enum": [origin.value for origin in Origin]},
            "at": TIME,
            "actor": {**TEXT, "description": "Who staged it."},
            "reason": TEXT,
            "activated": nullable(TIME, "When last."),
            "activated_by": nullable(TEXT),
            "why": {**TEXT, "description": "Why it was activated last."},
            "before": nullable(WHOLE, "The version that was active until then: activate that to roll back."),
            "asked": nullable(TIME, "Since when it is awaited."),
            "asked_by": nullable(TEXT),
            "asked_why": TEXT,
            "patient": {**FLAG, "description": "Awaited until nothing stands in its way."},
            "note": {**TEXT, "description": "Why the last wish to activate it came to nothing."},
            "ran": nullable(TIME, "When a controller first ran with it."),
            "tries": nullable(WHOLE, "Active, but not run with yet: so many starts with it were begun. Null: it runs."),
            "rejected": nullable(TIME),
            "pruned": nullable(TIME, "When its text was thrown away: it is rejected, and others were after it."),
        },
        "A version of the plant file. One is active at any time; at most one is awaited.",
    ),
    "PlantFinding": record(
        {
            "line": WHOLE,
            "column": WHOLE,
            "severity": {"type": "string", "enum": ["error", "warning"]},
            "path": TEXT,
            "message": TEXT,
            "remedy": TEXT,
        },
        "As `hoistway check` tells it. Lines and columns count from 1.",
    ),
    "StagedVersion": {
        "allOf": [
            ref("PlantVersion"),
            record({"findings": list_of(ref("PlantFinding"), "Warnings; with errors nothing is staged.")}),
        ]
    },
    "PlantChange": record(
        {
            "what": {**TEXT, "description": "barcode, track, station, zone, vehicle, …"},
            "how": {"type": "string", "enum": ["added", "removed", "changed", "moved", "renamed"]},
            "name": TEXT,
            "text": TEXT,
            "before": {"description": "As it was; null: it was not there."},
            "after": {"description": "As it is to be; null: it is to go."},
        }
    ),
    "PlantBreak": record(
        {
            "what": TEXT,
            "name": TEXT,
            "text": TEXT,
            "remedy": TEXT,
            "touches": list_of(TEXT, "What may refer to it: jobs, carriers, teaching, …"),
        }
    ),
    "PlantDifference": record(
        {
            "version": WHOLE,
            "against": WHOLE,
            "changes": list_of(ref("PlantChange")),
            "breaks": list_of(
                ref("PlantBreak"), "What a plant that has run may still refer to, whatever is under way."
            ),
        },
        "As `hoistway layout diff` tells it, from `against` to `version`.",
    ),
    "PlantImpact": record(
        {
            "version": WHOLE,
            "ready": {**FLAG, "description": "Nothing stands in its way now."},
            "in_the_way": list_of(ref("PlantBreak"), "What is under way, and has no place in this version."),
            "lost": list_of(
                ref("PlantBreak"), "What was learnt of the plant and serves nobody any more; no hindrance."
            ),
            "lacking": list_of(
                ref("PlantBreak"),
                "New ports and hoists whose pulses are not known: to be taught afterwards; no hindrance.",
            ),
        }
    ),
    "PlantActivation": record(
        {
            "version": ref("PlantVersion"),
            "in_the_way": list_of(ref("PlantBreak"), "What it waits for; empty: it becomes active within seconds."),
        }
    ),
}
