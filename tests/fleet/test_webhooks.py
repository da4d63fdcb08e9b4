"""Requests about webhooks, and how far each has been told."""

import pytest

from app.domain.alarms import AlarmKind
from app.domain.errors import Refusal
from app.domain.ids import Actor
from app.domain.job import JobEvent
from app.domain.records import AuditRow, HistoryEvent, Record
from app.domain.requests import Accepted
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
from app.fleet import Effects
from app.fleet.webhooks import MOST, Webhooks
from tests.fleet.script import Script

WHO = Actor("mes")
ADD = AddWebhook(WHO, "https://mes.fab/hooks", (), "whsec_secret")


class Office:
    """The desk of a small plant."""

    def __init__(self) -> None:
        self.fleet = Script().fleet
        self.fleet.take()
        self.effects = Effects()

    @property
    def hooks(self) -> Webhooks:
        return self.fleet.webhooks

    def ask(self, request: WebhookRequest) -> Accepted | Refusal:
        self.fleet.ask(request, 1, self.fleet.books.now)
        self.effects = self.fleet.take()
        return self.effects.replies[0][1]

    def kept(self, kind: type[Record]) -> list[Record]:
        return [record for record in self.effects.records if isinstance(record, kind)]

    def told(self, progress: WebhookProgress, *tries: WebhookTry, failed: str = "") -> None:
        self.hooks.told(progress, tries, failed)
        self.effects = self.fleet.take()


@pytest.fixture
def office() -> Office:
    return Office()


def test_a_webhook_begins_with_the_next_event_and_its_secret_is_not_in_the_audit(office: Office) -> None:
    assert office.ask(ADD) == Accepted("webhooks", "1", created=True)
    assert office.kept(WebhookProgress) == [WebhookProgress(1, office.fleet.books.last_event)]
    (row,) = office.kept(AuditRow)
    assert isinstance(row, AuditRow)
    assert (row.actor, row.action, row.target) == (WHO, "AddWebhook", "1")
    assert "secret" not in row.detail
    assert "secret" not in repr(office.hooks.all[1])


def test_a_webhook_may_begin_with_older_events_but_not_with_later_ones(office: Office) -> None:
    last = office.fleet.books.last_event
    refusal = office.ask(AddWebhook(WHO, "https://mes.fab/", (), "s", after=last + 1))
    assert isinstance(refusal, Refusal)
    assert refusal.field == "after"
    office.ask(AddWebhook(WHO, "https://mes.fab/", (), "s", after=0))
    assert office.hooks.progress[1].position == 0


def test_there_is_a_bound(office: Office) -> None:
    for _ in range(MOST):
        office.ask(ADD)
    assert isinstance(office.ask(ADD), Refusal)


def test_what_does_not_exist_cannot_be_changed(office: Office) -> None:
    requests = (
        ChangeWebhook(WHO, 7),
        RemoveWebhook(WHO, 7),
        ReplayWebhook(WHO, 7, 0),
        RenewWebhookSecret(WHO, 7, "x", 0.0),
    )
    for request in requests:
        refusal = office.ask(request)
        assert isinstance(refusal, Refusal)
        assert refusal.code == "not-found"


def test_progress_is_kept_and_that_of_before_a_replay_is_not(office: Office) -> None:
    office.ask(AddWebhook(WHO, "https://mes.fab/", (), "s", after=0))
    done = WebhookTry(1, 1, Timestamp(5.0), 1, "X", 1, 204, 0.1, "")
    office.told(WebhookProgress(1, 1, tries=1, delivered=1), done)
    assert office.kept(WebhookTry) == [done]
    assert office.hooks.progress[1].position == 1
    office.fleet.books.event(JobEvent.CONTROLLER_AUTO)
    office.ask(ReplayWebhook(WHO, 1, 0))
    assert office.hooks.progress[1] == WebhookProgress(1, 0, 1, 1, 1)
    office.told(WebhookProgress(1, 1, tries=2, delivered=2))
    assert office.hooks.progress[1] == WebhookProgress(1, 0, 1, 2, 1)


def test_a_replay_from_beyond_the_last_event_is_refused(office: Office) -> None:
    office.ask(ADD)
    assert isinstance(office.ask(ReplayWebhook(WHO, 1, office.fleet.books.last_event + 1)), Refusal)


def test_a_failure_is_an_alarm_and_taking_it_up_again_clears_it(office: Office) -> None:
    office.ask(AddWebhook(WHO, "https://mes.fab/", (), "s", after=0))
    office.told(WebhookProgress(1, 0, failing=Timestamp(1.0), attempts=9, error="x"), failed="has not taken event 1")
    (alarm,) = office.kept(HistoryEvent)
    assert isinstance(alarm, HistoryEvent)
    assert (alarm.event, alarm.source) == ("AlarmSet", "webhook-1")
    assert "has not taken event 1" in alarm.detail
    assert "PATCH /api/v1/webhooks/1" in alarm.detail
    assert office.hooks.all[1].state is WebhookState.FAILED
    (shown,) = office.fleet.books.alarms.live.values()
    assert (shown.kind, shown.code) == (AlarmKind.PLANT, "webhook-1")
    office.ask(ChangeWebhook(WHO, 1, active=True))
    (cleared,) = office.kept(HistoryEvent)
    assert isinstance(cleared, HistoryEvent)
    assert cleared.event == "AlarmCleared"
    assert not office.fleet.books.alarms.live
    assert (office.hooks.all[1].state, office.hooks.all[1].reason) == (WebhookState.ACTIVE, "")
    assert office.hooks.progress[1] == WebhookProgress(1, 0)


def test_a_removed_webhook_is_kept_without_its_secrets_and_told_nothing(office: Office) -> None:
    office.ask(ADD)
    office.ask(RemoveWebhook(WHO, 1))
    (gone,) = office.kept(Webhook)
    assert isinstance(gone, Webhook)
    assert (gone.state, gone.secret, gone.old_secret) == (WebhookState.REMOVED, "", "")
    office.told(WebhookProgress(1, 9))
    assert office.effects.records == []
    assert office.ask(ADD) == Accepted("webhooks", "2", created=True)


def test_a_new_secret_leaves_the_old_one_for_a_while(office: Office) -> None:
    office.ask(ADD)
    office.ask(RenewWebhookSecret(WHO, 1, "new", 60.0))
    webhook = office.hooks.all[1]
    assert (webhook.secret, webhook.old_secret) == ("new", "whsec_secret")
    assert webhook.old_until == office.fleet.books.utc + 60.0
    office.ask(RenewWebhookSecret(WHO, 1, "newer", 0.0))
    assert (office.hooks.all[1].old_secret, office.hooks.all[1].old_until) == ("", None)
