"""Webhooks to rows and back."""

from app.domain.webhooks import TRIES_KEPT, Webhook, WebhookProgress, WebhookState, WebhookTry
from app.store.columns import Found, Row, as_names


def webhook_row(webhook: Webhook) -> Row:
    """Columns of ``webhooks``."""
    return (
        webhook.number,
        webhook.url,
        as_names(webhook.events),
        webhook.secret,
        webhook.actor,
        webhook.created,
        webhook.note,
        webhook.state.value,
        webhook.reason,
        webhook.replays,
        webhook.old_secret,
        webhook.old_until,
    )


def webhook(row: Found) -> Webhook:
    """Undo :func:`webhook_row`."""
    return Webhook(
        number=row.number,
        url=row.url,
        events=tuple(row.events),
        secret=row.secret,
        actor=row.actor,
        created=row.created,
        note=row.note,
        state=WebhookState(row.state),
        reason=row.reason,
        replays=row.replays,
        old_secret=row.old_secret,
        old_until=row.old_until,
    )


def progress_row(progress: WebhookProgress) -> Row:
    """Columns of ``webhook_progress``."""
    return (
        progress.webhook,
        progress.position,
        progress.replays,
        progress.tries,
        progress.delivered,
        progress.last,
        progress.failing,
        progress.attempts,
        progress.error,
    )


def progress(row: Found) -> WebhookProgress:
    """Undo :func:`progress_row`."""
    return WebhookProgress(
        webhook=row.webhook,
        position=row.position,
        replays=row.replays,
        tries=row.tries,
        delivered=row.delivered,
        last=row.last,
        failing=row.failing,
        attempts=row.attempts,
        error=row.error,
    )


def try_row(one: WebhookTry) -> Row:
    """Columns of ``webhook_tries``: a new one takes the place of the oldest of its webhook."""
    return (
        one.webhook,
        one.number % TRIES_KEPT,
        one.number,
        one.at,
        one.seq,
        one.event,
        one.attempt,
        one.status,
        one.seconds,
        one.error,
    )


def made_try(row: Found) -> WebhookTry:
    """Undo :func:`try_row`."""
    return WebhookTry(
        webhook=row.webhook,
        number=row.number,
        at=row.at,
        seq=row.seq,
        event=row.event,
        attempt=row.attempt,
        status=row.status,
        seconds=row.seconds,
        error=row.error,
    )
