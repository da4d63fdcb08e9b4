"""The AsyncAPI document: the live stream and the stream of events, described from what the code takes and gives.

Words are those that :mod:`app.api.live` decodes, commands and their bodies the table of :mod:`app.api.commands`, topics and their
objects those of the read model. Objects refer to ``openapi.json`` beside it.
"""

from collections.abc import Iterable, Mapping
from typing import Any

import msgspec
from pydantic import TypeAdapter

from app.api.commands import COMMANDS
from app.api.live import DEFAULT, Words
from app.api.policy import COMMANDS as SCOPES
from app.api.spoken import Command
from app.domain.access import who_may
from app.domain.view import SHOWN, Topic
from app.texts import LANGUAGES

Json = dict[str, Any]
OBJECTS = "openapi.json#/components/schemas/"
ORDERED = ("id", "actor", "command")
"""What of :class:`Words` belongs to a command; the rest chooses what is watched."""

DESCRIPTION = """One WebSocket gives the state of the plant and everything that happens to it.

* The first frame is a `snapshot` under a number `seq`; each `change` after it has the next number. All frames are JSON text.
* Changes are gathered for 100 ms. Each carries whole objects; `value` null says that the object is gone. Ended jobs leave
  the stream's state (the REST API keeps them).
* Events are kept for a time (`history_days`). A watcher that asks for older ones gets `resync` in their place.
* A watcher that falls behind gets `resync`, then a fresh `snapshot`. A watcher that finds a gap in `seq` asks for it:
  `{"resync": true}`.
* `event` frames carry durable events in order. None is ever left out: reconnect with `after=` the number of the last one seen.
* Where callers have to say who they are, send the header `Authorization: Bearer KEY`, or get a ticket by
  `POST /api/v1/live/ticket` and connect with `?ticket=` within 30 s, once.
* Commands go the same way back: `{"id": 7, "command": {"name": "vehicle.hold", "target": "V001", "body": {"reason": "look"}},
  "actor": "kim"}` does what `POST /vehicles/V001/hold` does, and is answered by a `reply` or an `error` with the same id.
* `x-roles` of a command says which roles may give it, where callers have to say who they are; `x-named-person`: a person has
  to be named, by log-in or as `actor`.
* What is not understood is answered by an `error` frame; the stream goes on. A question that is wrong in the address
  gets an `error` frame, and is closed with 1008.
* Words are English: so are reasons, causes and remedies in all objects, here and over REST. Refusals are in the language of
  `?language=` (`en`, `ko`); the page tells all of them in its own by the catalogue that comes with it.
* Events alone come as Server-Sent Events too: the channel `events`.
"""
AFTER = """Give all events numbered above this first. Without it, or with a number that is no event's yet (another
database's), events start with the next one.
"""


def document(version: str) -> Json:
    """Return the AsyncAPI 3.0 document of this version of Hoistway."""
    bodies, parts = _bodies()
    return {
        "asyncapi": "3.0.0",
        "info": {"title": "Hoistway live stream", "version": version, "description": DESCRIPTION},
        "defaultContentType": "application/json",
        "servers": {
            "local": {"host": "localhost:8080", "protocol": "ws"},
            "plain": {"host": "localhost:8080", "protocol": "http"},
        },
        "channels": _channels(),
        "operations": _operations(),
        "components": {
            "messages": _messages(),
            "schemas": {_title(name): _command(name, given, bodies.get(name)) for name, given in COMMANDS.items()}
            | parts,
        },
    }


def _channels() -> Json:
    left_out = ", ".join(f"`{topic.value}`" for topic in Topic if topic not in DEFAULT)
    topics = {
        "type": "string",
        "description": f"Comma-separated, of {', '.join(Topic)}; none means all but {left_out}.",
        "examples": ["vehicles,jobs,events"],
    }
    after = {"type": "integer", "minimum": 0, "description": AFTER}
    language = {"enum": list(LANGUAGES), "default": "en", "description": "Of the words of refusals."}
    query = {"topics": topics, "after": after, "ticket": {"type": "string"}, "language": language}
    return {
        "live": {
            "address": "/api/v1/live",
            "servers": [{"$ref": "#/servers/local"}],
            "bindings": {"ws": {"query": {"type": "object", "properties": query}}},
            "messages": {name: _message(name) for name in (*GIVEN, *TAKEN)},
        },
        "events": {
            "address": "/api/v1/events/stream",
            "description": "Server-Sent Events: `id` is the number, `event` the name, `data` the event. `Last-Event-ID`, or "
            "`?after=`, is the number of the last one seen.",
            "servers": [{"$ref": "#/servers/plain"}],
            "messages": {"happened": _message("happened")},
        },
    }


def _operations() -> Json:
    live, events = ({"$ref": f"#/channels/{name}"} for name in ("live", "events"))

    def of(*names: str) -> list[Json]:
        return [{"$ref": f"#/channels/live/messages/{name}"} for name in names]

    answered = {"channel": live, "messages": of("reply", "error")}
    return {
        "watch": {"action": "send", "channel": live, "messages": of(*GIVEN)},
        "choose": {"action": "receive", "channel": live, "messages": of("words")},
        "order": {"action": "receive", "channel": live, "messages": of("command"), "reply": answered},
        "follow": {"action": "send", "channel": events, "messages": [{"$ref": "#/channels/events/messages/happened"}]},
    }


GIVEN = ("snapshot", "change", "event", "resync", "error", "reply")
TAKEN = ("words", "command")


def _messages() -> Json:
    words, given = _words()
    return {
        "snapshot": _said("The whole state of the topics chosen.", "snapshot", _SNAPSHOT),
        "change": _said("What has changed since the frame before.", "change", _CHANGE),
        "event": _said("Durable events, in order.", "event", {"events": _several(_object_of("Event"))}),
        "resync": _said("Changes were left out; a snapshot follows.", "resync", {}),
        "error": _said("What the watcher said, or asked for, is not understood.", "error", _ERROR, optional=("id",)),
        "reply": _said("A command is carried out, or under way, and durable.", "reply", _REPLY),
        "words": {"summary": "What a watcher may ask of the stream.", "payload": words},
        "command": {
            "summary": "A command; what is jogged or watched over a socket is let go at once when the socket closes.",
            "correlationId": {"location": "$message.payload#/id"},
            "payload": given,
        },
        "happened": {"summary": "A durable event.", "payload": _object_of("Event")},
    }


def _words() -> tuple[Json, Json]:
    """Return the schemas of what is chosen, and of a command with its id and actor: all fields that the server decodes.

    Raises KeyError: it decodes one that is not described here.
    """
    described: Json = {
        "resync": {"type": "boolean", "description": "true: give a fresh snapshot."},
        "topics": {"type": "array", "items": {"enum": [topic.value for topic in Topic]}},
        "id": {**_NUMBER, "description": "Comes back with the reply to the command, or with its error."},
        "actor": {"type": "string", "description": "Who asks; without it, the header X-Actor of the handshake."},
        "command": {"oneOf": [{"$ref": f"#/components/schemas/{_title(name)}"} for name in COMMANDS]},
    }
    names = [field.name for field in msgspec.structs.fields(Words)]
    chosen = {name: described[name] for name in names if name not in ORDERED}
    return _whole(chosen, ()), _whole({name: described[name] for name in names if name in ORDERED}, ("command",))


def _command(name: str, command: Command, body: Json | None) -> Json:
    """Return the schema of a command by name: its target and body, and who may give it."""
    target: Json = {"type": "string", "description": "The id of the object, such as V001."}
    fields: Json = {"name": {"const": name}, "target": target if command.aimed else {"const": ""}}
    needed = ["name", "target"] if command.aimed else ["name"]
    if body is not None:
        fields["body"] = body
        if command.adapter.json_schema().get("required"):
            needed.append("body")
    more: Json = {"x-roles": [role.value for role in who_may(SCOPES[name])]}
    if command.person:
        more["x-named-person"] = True
    return _whole(fields, needed) | more


def _bodies() -> tuple[Mapping[str, Json], Json]:
    """Return the schema of each command's body by the command's name, and those of all that they are made of."""
    adapters: list[Any] = [(name, "validation", given.adapter) for name, given in COMMANDS.items() if given.body]
    bodies, whole = TypeAdapter.json_schemas(adapters, ref_template="#/components/schemas/{model}")
    parts = _plainly(dict(sorted(whole.get("$defs", {}).items())))
    return {str(name): _plainly(schema) for (name, _), schema in bodies.items()}, parts


def _plainly(node: Any) -> Any:
    """Return a schema as AsyncAPI has it: a discriminator is the name of a field there."""
    if isinstance(node, dict):
        named = node.get("discriminator")
        plain = {key: _plainly(value) for key, value in node.items()}
        return plain | ({"discriminator": named["propertyName"]} if isinstance(named, dict) else {})
    return [_plainly(part) for part in node] if isinstance(node, list) else node


def _title(name: str) -> str:
    """Return the name of a command's schema: ``vehicle.hold`` is ``VehicleHoldCommand``."""
    return "".join(part.capitalize() for part in name.split(".")) + "Command"


def _message(name: str) -> Json:
    return {"$ref": f"#/components/messages/{name}"}


def _object_of(name: str) -> Json:
    return {"$ref": OBJECTS + name}


def _whole(properties: Mapping[str, Any], required: Iterable[str]) -> Json:
    found: Json = {"type": "object", "additionalProperties": False, "properties": dict(properties)}
    return found | ({"required": needed} if (needed := list(required)) else {})


def _several(item: Json) -> Json:
    return {"type": "array", "minItems": 1, "items": item}


def _said(summary: str, kind: str, fields: Json, optional: Iterable[str] = ()) -> Json:
    """Return a frame of this ``type`` with these fields."""
    properties = {"type": {"const": kind}, **fields}
    return {"summary": summary, "payload": _whole(properties, [name for name in properties if name not in optional])}


def _of_topic(topic: Topic) -> Json:
    kinds = [_object_of(kind.__name__.removesuffix("View")) for kind in SHOWN[topic]]
    return kinds[0] if len(kinds) == 1 else {"anyOf": kinds}


_NUMBER: Json = {"type": ["integer", "string", "null"]}
_TOPICS = [topic for topic in Topic if topic is not Topic.EVENTS]
_SNAPSHOT: Json = {
    "seq": {"type": "integer"},
    "last_event": {"type": "integer", "description": "The number of the last event so far."},
    "objects": {
        **_whole({t.value: {"type": "object", "additionalProperties": _of_topic(t)} for t in _TOPICS}, ()),
        "description": "Topic, then key, to object (of `teaching`: `session-ID`, `proposal-ID`). Events are no objects.",
    },
}
_VALUE = "The whole object; null where it is gone."
_CHANGE: Json = {
    "seq": {"type": "integer"},
    "changes": _several(
        {
            "oneOf": [
                _whole(
                    {
                        "topic": {"const": topic.value},
                        "key": {"type": "string"},
                        "value": {"anyOf": [_of_topic(topic), {"type": "null"}], "description": _VALUE},
                    },
                    ("topic", "key", "value"),
                )
                for topic in _TOPICS
            ]
        }
    ),
}
_ERROR: Json = {
    "id": {"type": ["integer", "string"], "description": "The id of the command that is refused, if it is one."},
    "problem": _object_of("Problem"),
}
_REPLY: Json = {
    "id": {**_NUMBER, "description": "The command's."},
    "status": {"type": "integer", "description": "What the same command over REST would have as its status."},
    "location": {"type": ["string", "null"], "description": "Where to look for what comes of it."},
    "body": {"type": ["object", "null"], "description": "What the same command over REST would answer."},
}
