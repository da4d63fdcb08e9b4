"""Schemas of webhooks."""

from app.api.schemas import FLAG, TEXT, TIME, WHOLE, Json, nullable, record

WEBHOOKS: Json = {
    "Webhook": record(
        {
            "id": WHOLE,
            "url": TEXT,
            "events": {"type": "array", "items": TEXT, "description": "Names; none: all."},
            "note": TEXT,
            "state": {"type": "string", "enum": ["active", "paused", "failed"]},
            "reason": {"type": "string", "description": "Why it has failed."},
            "actor": TEXT,
            "created": TIME,
            "position": {"type": "integer", "description": "Events up to this number are delivered, or not wanted."},
            "behind": {"type": "integer", "description": "Events above it."},
            "delivered": WHOLE,
            "last": nullable(TIME, "When an event was last taken."),
            "failing": nullable(TIME, "Since when the present event is not taken."),
            "attempts": {"type": "integer", "description": "How often the present event has been tried."},
            "error": {"type": "string", "description": "Why it was not taken."},
        }
    ),
    "WebhookWithSecret": {
        "allOf": [
            {"$ref": "#/components/schemas/Webhook"},
            record({"secret": {"type": "string", "description": "`whsec_` and base64. It is not shown again."}}),
        ]
    },
    "WebhookDelivery": record(
        {
            "number": WHOLE,
            "at": TIME,
            "event": TEXT,
            "seq": nullable(WHOLE, "The event's number; null for a ping."),
            "attempt": WHOLE,
            "status": nullable(WHOLE, "The answer's; null if there was none."),
            "seconds": {"type": "number"},
            "taken": FLAG,
            "error": TEXT,
        }
    ),
    "WebhookMessage": record(
        {
            "type": {"type": "string", "description": "The event's name, or Ping."},
            "timestamp": TIME,
            "data": {"anyOf": [{"$ref": "#/components/schemas/Event"}, record({"webhook": WHOLE})]},
        },
        "What a receiver gets (headers webhook-id, webhook-timestamp, webhook-signature: Standard Webhooks).",
    ),
}
