"""Commands over the live stream: the same routes, bodies, refusals and audit as REST, by name.

A watcher sends ``{"id": 7, "command": {"name": "vehicle.hold", "target": "V001", "body": {"reason": "look"}}, "actor": "kim"}``
and gets ``{"type": "reply", "id": 7, "status": 200, ...}``. To add a command, add a line to a table.
"""

import asyncio
from collections.abc import Awaitable, Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any

import msgspec
from pydantic import TypeAdapter, ValidationError
from starlette.responses import Response

from app.api.callers import Callers
from app.api.calls import actor_named, is_person
from app.api.policy import COMMANDS
from app.api.port import Controller
from app.api.problems import Problem, ours, problem_of
from app.domain.access import Caller
from app.domain.drive_requests import Word
from app.domain.errors import HoistwayError
from app.domain.ids import Actor
from app.runtime.showing import encode
from app.texts import Language
from app.wire.names import nearest

MOST_AT_ONCE = 16
"""Commands of one watcher under way at a time. Our choice."""


@dataclass(eq=False)
class Speaker:
    """A watcher that gives commands. ``letting_go``: what is told to the controller when it goes, by what it is about."""

    controller: Controller
    name: str
    letting_go: dict[str, Word] = field(default_factory=dict)
    gone: bool = False

    def until_gone(self, about: str, word: Word) -> None:
        """Let this be told when the watcher goes; at once if it has gone already."""
        if self.gone:
            self.controller.tell(word)
        else:
            self.letting_go[about] = word

    def go(self) -> None:
        """The watcher goes: what it holds is let go at once."""
        self.gone = True
        for word in self.letting_go.values():
            self.controller.tell(word)
        self.letting_go.clear()


@dataclass(frozen=True, slots=True)
class Said:
    """A command as given: by whom (``actor``), about what (``target``), with which ``body``."""

    speaker: Speaker
    actor: Actor
    target: str
    body: Any

    @property
    def controller(self) -> Controller:
        """The controller that it is for."""
        return self.speaker.controller


@dataclass(frozen=True)
class Command:
    """A command by name: what its body is (None: none), what carries it out, and whether a named person has to decide it.

    ``aimed``: it is about one object, its target.
    """

    body: Any
    carry_out: Callable[[Said], Awaitable[Response]]
    person: bool = False
    aimed: bool = True

    @cached_property
    def adapter(self) -> TypeAdapter[Any]:
        """What reads the body."""
        return TypeAdapter(self.body)


Table = Mapping[str, Command]


class Order(msgspec.Struct, forbid_unknown_fields=True):
    """What is to be done."""

    name: str
    target: str = ""
    body: msgspec.Raw = msgspec.Raw(b"")


def route(call: Callable[..., Awaitable[Response]], body: Any = None, *, person: bool = False) -> Command:
    """Return the command that does what a route does: ``call(target, [body,] controller=, actor=)``."""

    async def carry_out(said: Said) -> Response:
        given = () if body is None else (said.body,)
        return await call(said.target, *given, controller=said.controller, actor=said.actor)

    return Command(body, carry_out, person)


@dataclass(frozen=True, slots=True)
class Voice:
    """Who speaks: who has shown who they are (None: nobody has to), the header X-Actor, the address."""

    callers: Callers
    caller: Caller | None
    header: str | None
    address: str

    def refusal(self, name: str) -> Problem | None:
        """Return why this one may not give a command of that name."""
        about = COMMANDS[name]
        if self.caller is None or about in self.caller.scopes:
            return None
        return self.callers.forbidden(self.caller, about, name, asked=True)


class Spoken:
    """Carries out what one watcher says. ``reply`` sends a text to it; ``language``: of refusals."""

    def __init__(
        self,
        table: Table,
        speaker: Speaker,
        voice: Voice,
        reply: Callable[[str], Awaitable[None]],
        language: Language = "en",
    ) -> None:
        self._table, self._speaker, self._voice, self._reply = table, speaker, voice, reply
        self._language = language
        self._tasks: set[asyncio.Task[None]] = set()

    def take(self, number: int | str | None, order: Order, actor: str | None) -> Problem | None:
        """Begin to carry a command out; return why not."""
        if len(self._tasks) >= MOST_AT_ONCE:
            return Problem("too-many", f"{MOST_AT_ONCE} commands of yours are under way.", "Wait for their replies.")
        try:
            command, said = self._understood(order, actor)
        except Problem as problem:
            return problem
        task = asyncio.create_task(self._carry_out(number, command, said))
        self._tasks.add(task)
        task.add_done_callback(self._tasks.discard)
        return None

    async def close(self) -> None:
        """The watcher has gone: let go what it held, and wait for nothing."""
        self._speaker.go()
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)

    def _understood(self, order: Order, actor: str | None) -> tuple[Command, Said]:
        command = self._table.get(order.name)
        if command is None:
            close = nearest(order.name, self._table)
            remedy = f"Did you mean {close}?" if close else f"There are {', '.join(self._table)}."
            raise Problem("invalid", f"There is no command {order.name[:40]!r}.", remedy, "command.name")
        voice = self._voice
        if problem := voice.refusal(order.name):
            raise problem
        given = voice.header if actor is None else actor.encode().decode("latin-1")
        if command.person and not is_person(voice.caller, given):
            raise Problem("invalid", "A named person has to decide this.", 'Send "actor": "NAME".', "actor")
        if command.aimed and not order.target:
            raise Problem("invalid", "This command is about one object.", 'Send its id as "target".', "command.target")
        who = actor_named(given, voice.address, voice.caller)
        return command, Said(self._speaker, who, order.target, _body(command, bytes(order.body)))

    async def _carry_out(self, number: int | str | None, command: Command, said: Said) -> None:
        try:
            response = await command.carry_out(said)
        except Problem as problem:
            await self._reply(error(problem, number, self._language))
            return
        except HoistwayError as wrong:
            await self._reply(error(ours(wrong), number, self._language))
            return
        frame = {
            "type": "reply",
            "id": number,
            "status": response.status_code,
            "location": response.headers.get("location"),
            "body": msgspec.Raw(bytes(response.body) or b"null"),
        }
        await self._reply(encode(frame).decode())


def _body(command: Command, raw: bytes) -> Any:
    if command.body is None:
        if raw not in (b"", b"null", b"{}"):
            raise Problem("invalid", "This command has no body.", "Leave it out.", "command.body")
        return None
    try:
        return command.adapter.validate_json(raw or b"{}")
    except ValidationError as wrong:
        found = [{**e, "loc": ("body", *e["loc"])} for e in wrong.errors(include_url=False)]
        raise problem_of(found, "application/json") from None


def error(problem: Problem, number: int | str | None = None, language: Language = "en") -> str:
    """Return a problem as a frame; ``number`` is the command's that it answers."""
    frame: dict[str, object] = {"type": "error", "problem": problem.body(language)}
    if number is not None:
        frame["id"] = number
    return encode(frame).decode()
