"""Schemas of webhooks."""

from typing import Any

Json = dict[str, Any]
_TEXT, _WHOLE, _FLAG = {"type": "string"}, {"type": "integer"}, {"type": "boolean"}
_TIME = {"type": "string", "format": "date-time"}


def _object(properties: Json, description: str = "") -> Json:
    schema: Json = {"type": "object", "properties": properties, "required": list(properties)}
    return {**schema, "description": description} if description else schema


def _nullable(schema: Json, description: str) -> Json:
    return {"anyOf": [schema, {"type": "null"}], "description": description}


WEBHOOKS: Json = {
    "Webhook": _object(
        {
            "id": _WHOLE,
            "url": _TEXT,
            "events": {"type": "array", "items": _TEXT, "description": "Names; none: all."},
            "note": _TEXT,
            "state": {"type": "string", "enum": ["active", "paused", "failed"]},
            "reason": {"type": "string", "description": "Why it has failed."},
            "actor": _TEXT,
            "created": _TIME,
            "position": {"type": "integer", "description": "Events up to this number are delivered, or not wanted."},
            "behind": {"type": "integer", "description": "Events above it."},
            "delivered": _WHOLE,
            "last": _nullable(_TIME, "When an event was last taken."),
            "failing": _nullable(_TIME, "Since when the present event is not taken."),
            "attempts": {"type": "integer", "description": "How often the present event has been tried."},
            "error": {"type": "string", "description": "Why it was not taken."},
        }
    ),
    "WebhookWithSecret": {
        "allOf": [
            {"$ref": "#/components/schemas/Webhook"},
            _object({"secret": {"type": "string", "description": "`whsec_` and base64. It is not shown again."}}),
        ]
    },
    "WebhookDelivery": _object(
        {
            "number": _WHOLE,
            "at": _TIME,
            "event": _TEXT,
            "seq": _nullable(_WHOLE, "The event's number; null for a ping."),
            "attempt": _WHOLE,
            "status": _nullable(_WHOLE, "The answer's; null if there was none."),
            "seconds": {"type": "number"},
            "taken": _FLAG,
            "error": _TEXT,
        }
    ),
    "WebhookMessage": _object(
        {
            "type": {"type": "string", "description": "The event's name, or Ping."},
            "timestamp": _TIME,
            "data": {"anyOf": [{"$ref": "#/components/schemas/Event"}, _object({"webhook": _WHOLE})]},
        },
        "What a receiver gets (headers webhook-id, webhook-timestamp, webhook-signature: Standard Webhooks).",
    ),
}
