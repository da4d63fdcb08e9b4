"""Schemas of what teaching answers that is no view."""

from app.api.schemas import FLAG, TEXT, TIME, WHOLE, Json, list_of, nullable, record, ref

_SIDE = {"type": "string", "enum": ["dest", "offset"]}
_CHANGES = {**list_of(ref("TaughtChange")), "description": "Every port and vehicle whose pulses change."}

TEACHING: Json = {
    "PulsesVersion": {
        "allOf": [
            ref("Axes"),
            record(
                {
                    "version": WHOLE,
                    "actor": TEXT,
                    "source": {**TEXT, "description": "plant file, rest, teaching, roll-back or import."},
                    "at": TIME,
                    "basis": {**list_of(ref("Basis")), "description": "Empty where a person wrote the values."},
                    "proposal": nullable(WHOLE),
                    "restores": nullable(WHOLE),
                    "reason": TEXT,
                }
            ),
        ]
    },
    "Basis": {
        "description": "Where one axis comes from: value = raw - less, where less is of version `version` of `against`.",
        **record(
            {
                "axis": TEXT,
                "raw": WHOLE,
                "vehicle": TEXT,
                "barcode": TEXT,
                "events": list_of(WHOLE),
                "against": TEXT,
                "version": nullable(WHOLE),
                "less": WHOLE,
            }
        ),
    },
    "TaughtChange": {
        "description": "What one vehicle is sent at one port, before and after, in pulses.",
        **record({"station": TEXT, "vehicle": TEXT, "old": ref("Axes"), "new": ref("Axes"), "beyond": TEXT}),
    },
    "TeachingSessionDetail": {
        "allOf": [
            ref("TeachingSession"),
            record({"proposals": list_of(ref("Proposal")), "advice": {**TEXT, "description": "What to do next."}}),
        ]
    },
    "ProposalDetail": {
        "allOf": [
            ref("Proposal"),
            record({"present": nullable(ref("PulsesVersion")), "changes": _CHANGES, "drift": TEXT}),
        ]
    },
    "TeachingEvent": record(
        {
            "number": WHOLE,
            "at": TIME,
            "vehicle": TEXT,
            "barcode": TEXT,
            "code": TEXT,
            "axis": nullable(TEXT),
            "position": WHOLE,
            "cmd_id": TEXT,
            "connection": TEXT,
            "asked_by": nullable(TEXT),
        }
    ),
    "TaughtTarget": {
        "description": "What a vehicle would be sent at a port. `refusal`: why a job would be refused, empty if not.",
        "allOf": [
            ref("Axes"),
            record(
                {
                    "station": TEXT,
                    "vehicle": TEXT,
                    "complete": FLAG,
                    "refusal": TEXT,
                    "reference": FLAG,
                    "dest": nullable(ref("PulsesVersion")),
                    "offset": nullable(ref("PulsesVersion")),
                }
            ),
        ],
    },
    "TaughtComparison": record(
        {
            "old": ref("PulsesVersion"),
            "new": ref("PulsesVersion"),
            "differences": ref("Axes"),
            "changes": _CHANGES,
        }
    ),
    "VehicleComparison": record(
        {
            "one": {"allOf": [ref("Axes"), record({"vehicle": TEXT})]},
            "other": {"allOf": [ref("Axes"), record({"vehicle": TEXT})]},
            "differences": ref("Axes"),
            "stations": list_of(record({"station": TEXT, "one": ref("Axes"), "other": ref("Axes")})),
        }
    ),
    "DriftRow": record(
        {
            "side": _SIDE,
            "name": TEXT,
            "drift": TEXT,
            "old": ref("PulsesVersion"),
            "new": ref("PulsesVersion"),
        }
    ),
    "TaughtDest": {"allOf": [ref("PulsesVersion"), record({"station": TEXT})]},
    "TaughtOffset": {"allOf": [ref("PulsesVersion"), record({"vehicle": TEXT})]},
    "ImportReport": record(
        {
            "dry_run": FLAG,
            "counts": record(dict.fromkeys(("new", "changed", "same", "error"), WHOLE)),
            "items": list_of(
                record(
                    {
                        "line": WHOLE,
                        "name": TEXT,
                        "fate": {"type": "string", "enum": ["new", "changed", "same", "error"]},
                        "detail": TEXT,
                        "remedy": TEXT,
                        "version": nullable(WHOLE),
                    }
                )
            ),
        }
    ),
}
"""Pulses are whole numbers, null where an axis is not known."""
