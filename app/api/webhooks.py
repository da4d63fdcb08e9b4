"""Webhooks: who is told of events by HTTP (``docs/webhooks.md``)."""

import secrets
from typing import Annotated

from fastapi import APIRouter
from pydantic import AfterValidator, Field, StringConstraints
from starlette.responses import Response

from app.api.calls import Ctl, Who, answer_of, ask, items, location, missing, read
from app.api.declared import gives
from app.api.inputs import Limit, Older, Strict, Text
from app.api.port import Controller
from app.api.problems import Problem
from app.api.teaching_inputs import Number
from app.domain.job import JobEvent
from app.domain.webhooks import (
    AddWebhook,
    ChangeWebhook,
    RemoveWebhook,
    RenewWebhookSecret,
    ReplayWebhook,
    Webhook,
    WebhookProgress,
    WebhookTry,
)
from app.runtime.showing import iso
from app.runtime.webhooks import drawn_secret
from app.runtime.webhooks.signing import SECRET_BYTES
from app.wire.names import nearest

router = APIRouter(prefix="/webhooks", tags=["webhooks"])
KNOWN = frozenset(event.value for event in JobEvent)
LAST = (1 << 53) - 1
DAY = 86_400


def _known(name: str) -> str:
    if name not in KNOWN:
        close = nearest(name, KNOWN)
        raise ValueError(f"there is no event {name!r}" + (f"; did you mean {close}?" if close else ""))
    return name


Url = Annotated[str, StringConstraints(strict=True, min_length=8, max_length=500, pattern=r"^[\x21-\x7e]+$")]
Event = Annotated[str, StringConstraints(strict=True, max_length=64), AfterValidator(_known)]
Events = Annotated[list[Event], Field(max_length=len(KNOWN), description="Names of events; none: all.")]
Position = Annotated[int, Field(ge=0, le=LAST)]


class WebhookIn(Strict):
    """A subscription. ``after``: begin with the events above this number; left out: with the next one."""

    url: Url
    events: Events = Field(default_factory=list, json_schema_extra={"default": []})
    note: Text = ""
    after: Position | None = None


class WebhookChange(Strict):
    """What to change; a field that is left out stays. ``active`` true takes up again what is paused or has failed."""

    url: Url | None = None
    events: Events | None = None
    note: Text | None = None
    active: bool | None = None


class SecretIn(Strict):
    """For so many seconds the old secret signs beside the new one."""

    overlap: Annotated[int, Field(ge=0, le=7 * DAY)] = DAY


class ReplayIn(Strict):
    """Tell it all events above this number, again if it has had them."""

    after: Position


@router.get("", **gives("Webhook[]", description="All webhooks; never their secrets."))
async def list_webhooks(controller: Ctl) -> Response:
    """List webhooks, with how far each has been told."""
    return items(_view(controller, *pair) for pair in controller.webhooks())


@router.post("", **gives("WebhookWithSecret", 201, "Its secret is shown this once."))
async def add_webhook(body: WebhookIn, controller: Ctl, actor: Who) -> Response:
    """Subscribe a URL. Every event wanted is delivered in order, signed, until it is taken; nothing is lost by a crash."""
    _allowed(controller, body.url)
    secret = _drawn()
    accepted = await ask(controller, AddWebhook(actor, body.url, tuple(body.events), secret, body.note, body.after))
    shown = _view(controller, *_found(controller, int(accepted.key))) | {"secret": secret}
    return answer_of(shown, 201, location("webhooks", accepted.key))


@router.get("/{webhook}", **gives("Webhook"))
async def get_webhook(webhook: Number, controller: Ctl) -> Response:
    """Show one webhook."""
    return answer_of(_view(controller, *_found(controller, webhook)))


@router.patch("/{webhook}", **gives("Webhook"))
async def change_webhook(webhook: Number, body: WebhookChange, controller: Ctl, actor: Who) -> Response:
    """Change a webhook, pause it, or take it up again where it was."""
    if body.url is not None:
        _allowed(controller, body.url)
    events = None if body.events is None else tuple(body.events)
    await ask(controller, ChangeWebhook(actor, webhook, body.url, events, body.active, body.note))
    return answer_of(_view(controller, *_found(controller, webhook)))


@router.delete("/{webhook}", **gives(None, 204, "It is told nothing more."))
async def remove_webhook(webhook: Number, controller: Ctl, actor: Who) -> Response:
    """Remove a webhook for ever."""
    await ask(controller, RemoveWebhook(actor, webhook))
    return Response(status_code=204)


@router.post("/{webhook}/secret", **gives("WebhookWithSecret", description="The new secret is shown this once."))
async def renew_webhook_secret(webhook: Number, body: SecretIn, controller: Ctl, actor: Who) -> Response:
    """Sign with a new secret; for a while with the old one too."""
    secret = _drawn()
    await ask(controller, RenewWebhookSecret(actor, webhook, secret, float(body.overlap)))
    return answer_of(_view(controller, *_found(controller, webhook)) | {"secret": secret})


@router.post("/{webhook}/replay", **gives("Webhook"))
async def replay_webhook(webhook: Number, body: ReplayIn, controller: Ctl, actor: Who) -> Response:
    """Tell it all events above a number, as far as they are kept, before it goes on."""
    await ask(controller, ReplayWebhook(actor, webhook, body.after))
    return answer_of(_view(controller, *_found(controller, webhook)))


@router.post("/{webhook}/ping", **gives("WebhookDelivery", description="What became of it."))
async def ping_webhook(webhook: Number, controller: Ctl) -> Response:
    """Deliver a test event at once, and say what became of it."""
    done = await controller.ping_webhook(webhook)
    return missing("webhook", str(webhook)) if done is None else answer_of(_shown(done))


@router.get("/{webhook}/deliveries", **gives("WebhookDelivery[]", description="The newest first."))
async def list_webhook_deliveries(
    webhook: Number, controller: Ctl, after: Older = None, limit: Limit = 100
) -> Response:
    """List the deliveries that were tried; the last 200 are kept. Go on with ``after`` = ``next``."""
    _found(controller, webhook)
    tries = await read(controller.reader.webhook_tries, webhook, after, limit)
    return items(map(_shown, tries), tries[-1].number if len(tries) == limit else None)


def _drawn() -> str:
    return drawn_secret(secrets.token_bytes(SECRET_BYTES))


def _allowed(controller: Controller, url: str) -> None:
    """Raise Problem for a URL that nothing may be sent to."""
    if why := controller.targets.refusal(url):
        raise Problem("invalid", f"Nothing may be sent there: {why}.", controller.targets.remedy(url), "url")


def _found(controller: Controller, number: int) -> tuple[Webhook, WebhookProgress]:
    pair = next((pair for pair in controller.webhooks() if pair[0].number == number), None)
    return missing("webhook", str(number)) if pair is None else pair


def _view(controller: Controller, webhook: Webhook, progress: WebhookProgress) -> dict[str, object]:
    return {
        "id": webhook.number,
        "url": webhook.url,
        "events": webhook.events,
        "note": webhook.note,
        "state": webhook.state.value,
        "reason": webhook.reason,
        "actor": webhook.actor,
        "created": iso(webhook.created),
        "position": progress.position,
        "behind": max(controller.model.last_event - progress.position, 0),
        "delivered": progress.delivered,
        "last": None if progress.last is None else iso(progress.last),
        "failing": None if progress.failing is None else iso(progress.failing),
        "attempts": progress.attempts,
        "error": progress.error,
    }


def _shown(done: WebhookTry) -> dict[str, object]:
    return {
        "number": done.number,
        "at": iso(done.at),
        "event": done.event,
        "seq": done.seq,
        "attempt": done.attempt,
        "status": done.status,
        "seconds": done.seconds,
        "taken": not done.error,
        "error": done.error,
    }
