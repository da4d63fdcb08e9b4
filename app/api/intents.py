"""Commands to vehicles and devices in answers: those of one, one by its number, one just taken."""

from collections.abc import Awaitable

from starlette.responses import Response

from app.api.calls import answer_of, answer_view, items, location, read
from app.api.port import Controller
from app.api.problems import Problem
from app.domain.ids import CmdId, VehicleId
from app.domain.requests import Accepted
from app.domain.view import CommandView, Topic
from app.fleet.views import view_of_intent
from app.runtime.showing import shown


async def commands_of(controller: Controller, name: str, limit: int) -> Response:
    """Return what a vehicle or device was asked and what became of it, newest first."""
    intents = await read(controller.reader.intents, VehicleId(name), limit)
    return items(shown(view_of_intent(intent)) for intent in intents)


async def command_of(controller: Controller, kind: str, name: str, command: str) -> Response:
    """Return one command of a vehicle or device (``kind``) by its 16 hex digits. Raises Problem: it has none such."""
    live = controller.model.get(Topic.COMMANDS, command.lower())
    if isinstance(live, CommandView) and live.vehicle == name:
        return answer_view(live)
    number = int(command, 16) if len(command) == 16 and set(command.lower()) <= set("0123456789abcdef") else 0
    intent = await read(controller.reader.intent, CmdId(number)) if number else None
    if intent is None or intent.vehicle != name:
        detail = f"{kind.capitalize()} {name} has no command {command}."
        raise Problem("not-found", detail, f"GET /api/v1/{kind}s/{name}/commands lists them.")
    return answer_view(view_of_intent(intent))


async def taken(kind: str, name: str, asked: Awaitable[Accepted]) -> Response:
    """Return that a command is under way, and where to look. Raises Problem: it was refused."""
    accepted = await asked
    cmd_id = f"{accepted.cmd_id:016x}" if accepted.cmd_id is not None else None
    where = location(f"{kind}s", name, "commands", *([cmd_id] if cmd_id else []))
    return answer_of({kind: name, "cmd_id": cmd_id}, 202, where)
