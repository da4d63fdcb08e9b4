"""Who is told of events by HTTP: answers requests about webhooks, and keeps how far each has been told."""

from collections.abc import Sequence
from dataclasses import replace

from app.domain.alarms import AlarmKind
from app.domain.errors import Refusal
from app.domain.job import JobEvent
from app.domain.requests import Accepted, Reply
from app.domain.units import Timestamp
from app.domain.webhooks import (
    AddWebhook,
    ChangeWebhook,
    RemoveWebhook,
    RenewWebhookSecret,
    ReplayWebhook,
    Webhook,
    WebhookProgress,
    WebhookRequest,
    WebhookState,
    WebhookTry,
)
from app.fleet.books import Books

MOST = 50
"""Webhooks at a time. Our choice."""
TOPIC = "webhooks"


class Webhooks:
    """All webhooks that are not removed. Delivering is the shell's; it tells how far it has come."""

    def __init__(
        self, books: Books, webhooks: Sequence[Webhook], progress: Sequence[WebhookProgress], first: int
    ) -> None:
        """``first`` is the first number not yet used."""
        self._books = books
        self.all = {one.number: one for one in webhooks if one.state is not WebhookState.REMOVED}
        self.progress = {one.webhook: one for one in progress if one.webhook in self.all}
        self._next = first

    def answer(self, request: WebhookRequest) -> Reply:
        """Carry a request out, or refuse it."""
        if isinstance(request, AddWebhook):
            return self._add(request)
        webhook = self.all.get(request.webhook)
        if webhook is None:
            return Refusal("not-found", f"there is no webhook {request.webhook}", "see GET /api/v1/webhooks")
        match request:
            case ChangeWebhook():
                self._change(webhook, request)
            case RemoveWebhook():
                self._remove(webhook)
            case RenewWebhookSecret():
                until = Timestamp(self._books.utc + request.overlap)
                old = webhook.secret if request.overlap > 0 else ""
                self._save(replace(webhook, secret=request.secret, old_secret=old, old_until=until if old else None))
            case ReplayWebhook():
                if request.after > self._books.last_event:
                    return Refusal("invalid", f"the last event is number {self._books.last_event}", "", "after")
                self._set_position(replace(webhook, replays=webhook.replays + 1), request.after)
        return Accepted(TOPIC, str(webhook.number))

    def told(self, progress: WebhookProgress, tries: Sequence[WebhookTry], failed: str = "") -> None:
        """Keep how far a webhook has been told; ``failed``: it is given up, and why.

        What counts from before somebody set the position or removed it is let go, but for the log.
        """
        webhook = self.all.get(progress.webhook)
        if webhook is None:
            return
        self._books.effects.records += tries
        known = self.progress[webhook.number]
        if progress.replays != webhook.replays:
            progress = replace(known, tries=max(progress.tries, known.tries))
        self._keep(progress)
        if failed and webhook.state is WebhookState.ACTIVE:
            self._save(replace(webhook, state=WebhookState.FAILED, reason=failed))
            remedy = f'mend the receiver, then PATCH /api/v1/webhooks/{webhook.number} {{"active": true}}'
            cause = f"{webhook.name} to {webhook.url} {failed}"
            self._books.alarms.begin(AlarmKind.PLANT, self._books.plant.name, _code(webhook), cause, remedy)
            self._books.event(JobEvent.ALARM_SET, source=_code(webhook), detail=f"{cause}; {remedy}")

    def _add(self, request: AddWebhook) -> Reply:
        if len(self.all) >= MOST:
            return Refusal("not-now", f"there are {MOST} webhooks", "remove one that nobody needs any more")
        last = self._books.last_event
        if request.after is not None and request.after > last:
            return Refusal(
                "invalid", f"the last event is number {last}", "leave after out to begin with the next", "after"
            )
        number, self._next = self._next, self._next + 1
        made = Webhook(
            number, request.url, request.events, request.secret, request.actor, self._books.utc, request.note
        )
        self._save(made)
        self._keep(WebhookProgress(number, last if request.after is None else request.after))
        return Accepted(TOPIC, str(number), created=True)

    def _change(self, webhook: Webhook, request: ChangeWebhook) -> None:
        changed = replace(
            webhook,
            url=webhook.url if request.url is None else request.url,
            events=webhook.events if request.events is None else request.events,
            note=webhook.note if request.note is None else request.note,
        )
        if request.active is not None:
            state = WebhookState.ACTIVE if request.active else WebhookState.PAUSED
            changed = replace(changed, state=state, reason="")
        self._save(changed)
        if request.active or request.url is not None:
            self._keep(replace(self.progress[webhook.number], failing=None, attempts=0, error=""))
        if webhook.state is WebhookState.FAILED and changed.state is not WebhookState.FAILED:
            self._well_again(webhook, f"{webhook.name} is {changed.state.value}: {request.actor}")

    def _remove(self, webhook: Webhook) -> None:
        if webhook.state is WebhookState.FAILED:
            self._well_again(webhook, f"{webhook.name} is removed")
        gone = replace(webhook, state=WebhookState.REMOVED, secret="", old_secret="", old_until=None)
        self._books.effects.records.append(gone)
        del self.all[webhook.number]
        self.progress.pop(webhook.number, None)

    def _set_position(self, webhook: Webhook, after: int) -> None:
        self._save(webhook)
        known = self.progress[webhook.number]
        self._keep(WebhookProgress(webhook.number, after, webhook.replays, known.tries, known.delivered, known.last))

    def _well_again(self, webhook: Webhook, why: str) -> None:
        self._books.alarms.end_one(AlarmKind.PLANT, self._books.plant.name, _code(webhook), why)
        self._books.event(JobEvent.ALARM_CLEARED, source=_code(webhook), detail=why)

    def _save(self, webhook: Webhook) -> None:
        self.all[webhook.number] = webhook
        self._books.effects.records.append(webhook)

    def _keep(self, progress: WebhookProgress) -> None:
        self.progress[progress.webhook] = progress
        self._books.effects.records.append(progress)


def _code(webhook: Webhook) -> str:
    """Return what an alarm about a webhook is counted by."""
    return f"webhook-{webhook.number}"
