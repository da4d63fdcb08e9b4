"""Schemas of what teaching answers that is no view."""

from typing import Any

Json = dict[str, Any]


def _ref(name: str) -> Json:
    return {"$ref": f"#/components/schemas/{name}"}


def _object(properties: Json) -> Json:
    return {"type": "object", "properties": properties, "required": list(properties)}


def _nullable(schema: Json) -> Json:
    return {"anyOf": [schema, {"type": "null"}]}


def _list(item: Json) -> Json:
    return {"type": "array", "items": item}


_TEXT, _WHOLE, _FLAG = {"type": "string"}, {"type": "integer"}, {"type": "boolean"}
_TIME = {"type": "string", "format": "date-time"}
_SIDE = {"type": "string", "enum": ["dest", "offset"]}
_CHANGES = {**_list(_ref("TaughtChange")), "description": "Every port and vehicle whose pulses change."}

TEACHING: Json = {
    "PulsesVersion": {
        "allOf": [
            _ref("Axes"),
            _object(
                {
                    "version": _WHOLE,
                    "actor": _TEXT,
                    "source": {**_TEXT, "description": "plant file, rest, teaching, roll-back or import."},
                    "at": _TIME,
                    "basis": {**_list(_ref("Basis")), "description": "Empty where a person wrote the values."},
                    "proposal": _nullable(_WHOLE),
                    "restores": _nullable(_WHOLE),
                    "reason": _TEXT,
                }
            ),
        ]
    },
    "Basis": {
        "description": "Where one axis comes from: value = raw - less, where less is of version `version` of `against`.",
        **_object(
            {
                "axis": _TEXT,
                "raw": _WHOLE,
                "vehicle": _TEXT,
                "barcode": _TEXT,
                "events": _list(_WHOLE),
                "against": _TEXT,
                "version": _nullable(_WHOLE),
                "less": _WHOLE,
            }
        ),
    },
    "TaughtChange": {
        "description": "What one vehicle is sent at one port, before and after, in pulses.",
        **_object({"station": _TEXT, "vehicle": _TEXT, "old": _ref("Axes"), "new": _ref("Axes"), "beyond": _TEXT}),
    },
    "TeachingSessionDetail": {
        "allOf": [
            _ref("TeachingSession"),
            _object({"proposals": _list(_ref("Proposal")), "advice": {**_TEXT, "description": "What to do next."}}),
        ]
    },
    "ProposalDetail": {
        "allOf": [
            _ref("Proposal"),
            _object({"present": _nullable(_ref("PulsesVersion")), "changes": _CHANGES, "drift": _TEXT}),
        ]
    },
    "TeachingEvent": _object(
        {
            "number": _WHOLE,
            "at": _TIME,
            "vehicle": _TEXT,
            "barcode": _TEXT,
            "code": _TEXT,
            "axis": _nullable(_TEXT),
            "position": _WHOLE,
            "cmd_id": _TEXT,
            "connection": _TEXT,
            "asked_by": _nullable(_TEXT),
        }
    ),
    "TaughtTarget": {
        "description": "What a vehicle would be sent at a port. `refusal`: why a job would be refused, empty if not.",
        "allOf": [
            _ref("Axes"),
            _object(
                {
                    "station": _TEXT,
                    "vehicle": _TEXT,
                    "complete": _FLAG,
                    "refusal": _TEXT,
                    "reference": _FLAG,
                    "dest": _nullable(_ref("PulsesVersion")),
                    "offset": _nullable(_ref("PulsesVersion")),
                }
            ),
        ],
    },
    "TaughtComparison": _object(
        {
            "old": _ref("PulsesVersion"),
            "new": _ref("PulsesVersion"),
            "differences": _ref("Axes"),
            "changes": _CHANGES,
        }
    ),
    "VehicleComparison": _object(
        {
            "one": {"allOf": [_ref("Axes"), _object({"vehicle": _TEXT})]},
            "other": {"allOf": [_ref("Axes"), _object({"vehicle": _TEXT})]},
            "differences": _ref("Axes"),
            "stations": _list(_object({"station": _TEXT, "one": _ref("Axes"), "other": _ref("Axes")})),
        }
    ),
    "DriftRow": _object(
        {
            "side": _SIDE,
            "name": _TEXT,
            "drift": _TEXT,
            "old": _ref("PulsesVersion"),
            "new": _ref("PulsesVersion"),
        }
    ),
    "TaughtDest": {"allOf": [_ref("PulsesVersion"), _object({"station": _TEXT})]},
    "TaughtOffset": {"allOf": [_ref("PulsesVersion"), _object({"vehicle": _TEXT})]},
    "ImportReport": _object(
        {
            "dry_run": _FLAG,
            "counts": _object(dict.fromkeys(("new", "changed", "same", "error"), _WHOLE)),
            "items": _list(
                _object(
                    {
                        "line": _WHOLE,
                        "name": _TEXT,
                        "fate": {"type": "string", "enum": ["new", "changed", "same", "error"]},
                        "detail": _TEXT,
                        "remedy": _TEXT,
                        "version": _nullable(_WHOLE),
                    }
                )
            ),
        }
    ),
}
"""Pulses are whole numbers, null where an axis is not known."""
