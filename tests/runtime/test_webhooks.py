"""Webhooks: signatures, where they may lead, and the way of events to a receiver."""

import asyncio
import base64
import hmac
import json
import re
import socket
import ssl
from collections.abc import AsyncIterator, Callable, Sequence
from contextlib import asynccontextmanager
from dataclasses import replace
from typing import Any

import httpx
import pytest
import trustme

from app.domain.ids import Actor
from app.domain.records import HistoryEvent
from app.domain.units import Timestamp
from app.domain.webhooks import Webhook, WebhookProgress, WebhookState, WebhookTry
from app.runtime.webhooks import (
    Answer,
    Courier,
    Pace,
    Sender,
    Targets,
    TargetsError,
    Unreachable,
    drawn_secret,
    signature,
)
from app.texts import told
from tests.runtime.peers import run, until

SECRET = drawn_secret(b"x" * 32)
OTHER = drawn_secret(b"y" * 32)
QUICK = Pace(first=0.004, most=0.016, give_up=3600.0)
NOW = Timestamp(1_767_225_600.0)


# -- signatures ---------------------------------------------------------------------------------------------------------


def test_the_signature_is_that_of_the_specification_s_own_example() -> None:
    body = b'{"test": 2432232314}'
    found = signature(["whsec_MfKQ9r8GKYqrTwjUPD8ILPZIo2LaLaSw"], "msg_p5jXN8AQM9LWM0D4loKWxJek", 1614265330, body)
    assert found == "v1,g0hM9SsE+OTPJTGt/tmIKtSyZlE3uFJELVlNIOLJ1OE="


def test_two_secrets_sign_side_by_side() -> None:
    one, two = (signature([secret], "evt_1", 7, b"{}") for secret in (SECRET, OTHER))
    assert signature([SECRET, OTHER], "evt_1", 7, b"{}") == f"{one} {two}"
    assert one != two


# -- targets ------------------------------------------------------------------------------------------------------------


def leading(*addresses: str) -> Callable[[str, int], Any]:
    async def resolve(host: str, port: int) -> Sequence[str]:
        return addresses

    return resolve


@pytest.mark.parametrize(
    "url",
    ["https://mes.fab/x", "https://a.b.corp/x", "http://10.1.2.3:8080/", "https://host:8443/y", "http://[fd00::7]/"],
)
def test_what_the_settings_name_is_allowed(url: str) -> None:
    assert Targets(["mes.fab", "*.corp", "10.0.0.0/8", "host:8443", "fd00::/8"]).refusal(url) == ""


@pytest.mark.parametrize(
    ("url", "why"),
    [
        ("https://mes.fab.evil.example/x", "not among"),
        ("https://evilcorp/x", "not among"),
        ("https://corp/x", "not among"),
        ("http://11.1.2.3/", "not among"),
        ("http://169.254.169.254/latest/meta-data", "not among"),
        ("http://127.0.0.1/", "not among"),
        ("http://[::ffff:127.0.0.1]/", "not among"),
        ("https://host/y", "not among"),
        ("ftp://mes.fab/x", "no URL"),
        ("https://user:word@mes.fab/x", "logs"),
        ("https://mes.fab/x#y", "fragment"),
        ("https://mes.fab:99999/x", "no URL"),
        ("mes.fab", "no URL"),
    ],
)
def test_what_they_do_not_name_is_refused(url: str, why: str) -> None:
    assert why in Targets(["mes.fab", "*.corp", "10.0.0.0/8", "host:8443"]).refusal(url)


def test_without_targets_nothing_may_be_sent_anywhere() -> None:
    assert "nobody" in Targets([]).refusal("https://mes.fab/x")


@pytest.mark.parametrize("entry", ["http://mes.fab", "mes fab", "host:port", "10.0.0.0/40", "", "*"])
def test_a_target_that_cannot_be_read_is_refused_at_the_start(entry: str) -> None:
    with pytest.raises(TargetsError):
        Targets([entry])


@pytest.mark.parametrize(
    ("entries", "found", "allowed"),
    [
        (["mes.fab"], ["192.168.1.5"], "192.168.1.5"),
        (["mes.fab"], ["127.0.0.1"], None),
        (["mes.fab"], ["::1"], None),
        (["mes.fab"], ["::ffff:127.0.0.1"], None),
        (["mes.fab"], ["169.254.169.254"], None),
        (["mes.fab"], ["0.0.0.0"], None),
        (["mes.fab"], ["127.0.0.1", "10.0.0.9"], "10.0.0.9"),
        (["mes.fab", "127.0.0.0/8"], ["127.0.0.1"], "127.0.0.1"),
        (["mes.fab"], [], None),
    ],
)
def test_a_name_that_leads_to_this_machine_is_not_followed(
    entries: list[str], found: list[str], allowed: str | None
) -> None:
    async def scenario() -> None:
        targets = Targets(entries, leading(*found))
        if allowed is None:
            with pytest.raises(OSError, match="not allowed"):
                await targets.address("https://mes.fab/x")
        else:
            assert await targets.address("https://mes.fab/x") == allowed

    run(scenario)


# -- a receiver over real sockets ---------------------------------------------------------------------------------------


class Receiver:
    """An HTTP server that answers as told; ``got`` are (head, body) of each request."""

    def __init__(self, answers: Sequence[bytes] = ()) -> None:
        self.answers = list(answers)
        self.got: list[tuple[str, bytes]] = []
        self._writers: list[asyncio.StreamWriter] = []

    @asynccontextmanager
    async def open(self) -> AsyncIterator[str]:
        server = await asyncio.start_server(self._serve, "127.0.0.1", 0)
        try:
            async with server:
                yield f"http://127.0.0.1:{server.sockets[0].getsockname()[1]}/hooks?a=1"
        finally:
            # A connection is gone only in a later turn of the loop, which would not come if the scenario ended here.
            for writer in self._writers:
                writer.close()
            await asyncio.gather(*(writer.wait_closed() for writer in self._writers), return_exceptions=True)

    async def _serve(self, reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        self._writers.append(writer)
        head = (await reader.readuntil(b"\r\n\r\n")).decode()
        length = next(int(line[15:]) for line in head.lower().splitlines() if line.startswith("content-length:"))
        self.got.append((head, await reader.readexactly(length)))
        status = self.answers.pop(0) if self.answers else b"204 No Content"
        more = b"" if b"\r\n\r\n" in status else b"\r\ncontent-length: 0\r\nconnection: close\r\n\r\n"
        writer.write(b"HTTP/1.1 " + status + more)
        await writer.drain()
        writer.close()


def test_a_delivery_names_the_host_and_does_not_follow_redirects() -> None:
    async def scenario() -> None:
        receiver = Receiver([b"302 Found\r\nlocation: http://127.0.0.1:1/", b"503 Busy\r\nretry-after: 7"])
        async with receiver.open() as url, Sender(Targets(["127.0.0.1"]), "1.2") as sender:
            assert await sender(url, {"webhook-id": "evt_1"}, b"{}") == Answer(302)
            assert await sender(url, {}, b"{}") == Answer(503, 7.0)
            assert await sender(url, {}, b"{}") == Answer(204)
        head, body = receiver.got[0]
        assert head.startswith("POST /hooks?a=1 HTTP/1.1")
        assert f"host: {url.split('/')[2]}" in head.lower()
        assert "webhook-id: evt_1" in head.lower()
        assert "hoistway/1.2" in head
        assert body == b"{}"

    run(scenario)


def test_a_refusal_is_told_with_how_the_answer_begins() -> None:
    answers = (
        (
            b"422 No\r\ncontent-type: text/plain\r\n\r\nno such\x07 lot\n\n" + b"x" * 500,
            "answered 422: no such lot xxx",
        ),
        (b"500 Error\r\ncontent-encoding: gzip\r\n\r\n\x1f\x8b", "answered 500"),
        (b"503 Busy", "answered 503"),
        (b"200 OK\r\n\r\nthank you", ""),
    )

    async def scenario() -> None:
        receiver = Receiver([answer for answer, _ in answers])
        async with receiver.open() as url, Sender(Targets(["127.0.0.1"]), "1.2") as sender:
            for _, told in answers:
                refusal = (await sender(url, {}, b"{}")).refusal
                assert refusal.startswith(told)
                assert len(refusal) < 230
                assert bool(told) == bool(refusal)

    run(scenario)


async def _cut(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    await reader.readuntil(b"\r\n\r\n")
    writer.close()


def test_what_cannot_be_delivered_says_why() -> None:
    async def unknown(host: str, _port: int) -> Sequence[str]:
        raise socket.gaierror(socket.EAI_NONAME, "Name or service not known")

    async def scenario() -> None:
        context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
        trustme.CA().issue_cert("127.0.0.1").configure_cert(context)
        silent = await asyncio.start_server(_cut, "127.0.0.1", 0)
        foreign = await asyncio.start_server(_cut, "127.0.0.1", 0, ssl=context)
        plain, tls = (server.sockets[0].getsockname()[1] for server in (silent, foreign))
        why = {
            "http://127.0.0.1:1/": "127.0.0.1:1 refuses the connection",
            "http://127.0.0.2/": "127.0.0.2 is not among the targets that are allowed; set HOISTWAY_WEBHOOK_TARGETS, .+",
            "http://mes.fab/": r"the name mes.fab is not found \(Name or service not known\)",
            f"http://127.0.0.1:{plain}/": "the connection ended without an answer",
            f"https://127.0.0.1:{tls}/": r"its certificate is not trusted \(.+\)",
            f"https://127.0.0.1:{plain}/": r"TLS is not agreed on \(.+\)|the connection ended without an answer",
        }
        async with silent, foreign, Sender(Targets(["127.0.0.1", "mes.fab"], unknown), "1.2") as sender:
            for url, words in why.items():
                with pytest.raises(Unreachable) as failed:
                    await sender(url, {}, b"{}")
                assert re.fullmatch(words, str(failed.value)), url
                assert told(str(failed.value), "ko") != str(failed.value), url

    run(scenario)


@pytest.mark.parametrize(
    ("wrong", "words"),
    [
        (httpx.ConnectTimeout(""), "no connection within 5 s"),
        (httpx.ReadTimeout(""), "no answer within 10 s"),
        (httpx.ReadError(""), "the connection ended without an answer"),
    ],
)
def test_what_a_connection_ended_in_is_said_in_words(
    monkeypatch: pytest.MonkeyPatch, wrong: httpx.TransportError, words: str
) -> None:
    async def fail(*_: object, **__: object) -> None:
        raise wrong

    async def scenario() -> None:
        monkeypatch.setattr(httpx.AsyncClient, "send", fail)
        async with Sender(Targets(["127.0.0.1"]), "1.2") as sender:
            with pytest.raises(Unreachable, match=f"^{words}$"):
                await sender("http://127.0.0.1:1/", {}, b"{}")

    run(scenario)


# -- the courier --------------------------------------------------------------------------------------------------------


class Desk:
    """Events and webhooks in memory. ``told`` are the calls that keep."""

    def __init__(self, events: int = 0, first: int = 1) -> None:
        self.events = [event(seq) for seq in range(first, first + events)]
        self.hooks: dict[int, tuple[Webhook, WebhookProgress]] = {}
        self.tries: list[WebhookTry] = []
        self.failures: list[str] = []
        self.now = float(NOW)

    def add(self, url: str = "http://10.0.0.1/", position: int = 0, **more: Any) -> None:
        made = Webhook(1, url, more.pop("events", ()), SECRET, Actor("mes"), NOW, **more)
        self.hooks[1] = made, WebhookProgress(1, position)

    def change(self, **changes: Any) -> None:
        self.hooks[1] = replace(self.hooks[1][0], **changes), self.hooks[1][1]

    def replay(self, after: int) -> None:
        webhook, progress = self.hooks[1]
        replays = webhook.replays + 1
        self.hooks[1] = replace(webhook, replays=replays), replace(progress, position=after, replays=replays)

    @property
    def progress(self) -> WebhookProgress:
        return self.hooks[1][1]

    def webhooks(self) -> Sequence[tuple[Webhook, WebhookProgress]]:
        return list(self.hooks.values())

    def webhook_told(self, progress: WebhookProgress, tries: Sequence[WebhookTry], failed: str = "") -> None:
        self.tries += tries
        webhook, _ = self.hooks[1]
        if progress.replays == webhook.replays:
            self.hooks[1] = webhook, progress
        if failed:
            self.failures.append(failed)
            self.change(state=WebhookState.FAILED, reason=failed)

    async def events_after(self, after: int, limit: int) -> Sequence[HistoryEvent]:
        await asyncio.sleep(0)
        return [one for one in self.events if one.seq > after][:limit]

    def utc(self) -> Timestamp:
        return Timestamp(self.now)


class Line:
    """Takes deliveries: ``answers`` are given first (a status, or why there is none), then 204. ``gate`` shut holds all."""

    def __init__(self, *answers: int | str | Answer) -> None:
        self.answers = list(answers)
        self.got: list[tuple[str, dict[str, str], dict[str, Any]]] = []
        self.gate = asyncio.Event()
        self.gate.set()
        self.entered = 0

    async def __call__(self, url: str, headers: dict[str, str], body: bytes) -> Answer:
        self.entered += 1
        await self.gate.wait()
        self.got.append((url, headers, json.loads(body)))
        answer = self.answers.pop(0) if self.answers else 204
        if isinstance(answer, str):
            raise Unreachable(answer)
        return answer if isinstance(answer, Answer) else Answer(answer)

    @property
    def seqs(self) -> list[int]:
        return [body["data"]["seq"] for _, _, body in self.got if body["type"] != "Ping"]


def event(seq: int) -> HistoryEvent:
    return HistoryEvent(seq, Timestamp(NOW + seq), "TransferCompleted" if seq % 2 else "VehicleAssigned", 7)


@asynccontextmanager
async def delivering(desk: Desk, line: Line, pace: Pace = QUICK) -> AsyncIterator[Courier]:
    courier = Courier(desk, line, pace, lambda: 0.5)
    courier.stir()
    try:
        yield courier
    finally:
        await courier.stop()


def test_every_event_is_delivered_once_and_in_order_and_the_position_is_kept() -> None:
    async def scenario() -> None:
        desk, line = Desk(250), Line()
        desk.add()
        async with delivering(desk, line) as courier:
            await until(lambda: desk.progress.position == 250)
            desk.events.append(event(251))
            courier.stir()
            await until(lambda: desk.progress.position == 251)
        assert line.seqs == list(range(1, 252))
        assert desk.progress.delivered == 251
        assert [one.number for one in desk.tries] == list(range(1, 252))

    run(scenario)


def test_a_message_is_signed_and_has_the_event_as_its_data() -> None:
    async def scenario() -> None:
        desk, line = Desk(1), Line()
        desk.add(old_secret=OTHER, old_until=Timestamp(NOW + 5))
        async with delivering(desk, line):
            await until(lambda: desk.progress.position == 1)
        _, headers, message = line.got[0]
        assert headers["webhook-id"] == f"evt_1_{int(NOW + 1) * 1000}"
        assert headers["webhook-timestamp"] == str(int(NOW))
        assert message["type"] == "TransferCompleted"
        assert message["data"]["seq"] == 1
        assert message["timestamp"] == message["data"]["ts"]
        signed = f"{headers['webhook-id']}.{headers['webhook-timestamp']}.".encode()
        body = json.dumps(message, separators=(",", ":")).encode()
        expected = [
            base64.b64encode(hmac.digest(letter * 32, signed + body, "sha256")).decode() for letter in (b"x", b"y")
        ]
        assert headers["webhook-signature"] == " ".join(f"v1,{one}" for one in expected)
        desk.now += 6
        desk.events.append(event(2))
        async with delivering(desk, line):
            await until(lambda: desk.progress.position == 2)
        assert len(line.got[1][1]["webhook-signature"].split()) == 1

    run(scenario)


def test_only_events_that_are_wanted_are_delivered_but_the_position_passes_all() -> None:
    async def scenario() -> None:
        desk, line = Desk(10), Line()
        desk.add(events=("TransferCompleted",))
        async with delivering(desk, line):
            await until(lambda: desk.progress.position == 10)
        assert line.seqs == [1, 3, 5, 7, 9]

    run(scenario)


def test_an_event_that_is_not_taken_is_tried_again_before_any_other() -> None:
    async def scenario() -> None:
        desk, line = Desk(3), Line(204, 500, "no route to host", Answer(503, 0.001), 204)
        desk.add()
        async with delivering(desk, line):
            await until(lambda: desk.progress.position == 3)
        assert line.seqs == [1, 2, 2, 2, 2, 3]
        assert [one.attempt for one in desk.tries] == [1, 1, 2, 3, 4, 1]
        assert [one.error for one in desk.tries[1:4]] == ["answered 500", "no route to host", "answered 503"]
        assert len({headers["webhook-id"] for _, headers, _ in line.got[1:5]}) == 1
        assert (desk.progress.failing, desk.progress.attempts, desk.progress.error) == (None, 0, "")

    run(scenario)


def test_pauses_double_up_to_a_bound_and_half_of_each_is_chance() -> None:
    pace = Pace(first=1.0, most=300.0)
    assert [pace.pause(attempt, 1.0) for attempt in (1, 2, 3, 9, 10, 500)] == [1, 2, 4, 256, 300, 300]
    assert pace.pause(3, 0.0) == 2.0


def test_after_days_of_failure_it_is_given_up_and_says_so() -> None:
    async def scenario() -> None:
        desk, line = Desk(2), Line(204, *([500] * 100))
        desk.add()
        async with delivering(desk, line):
            await until(lambda: len(line.got) > 3)
            assert desk.failures == []
            desk.now += QUICK.give_up
            await until(lambda: bool(desk.failures))
        assert desk.failures == ["has not taken event 2 for 1 h (answered 500)"]
        assert desk.progress.position == 1
        count = len(line.got)
        desk.change(state=WebhookState.ACTIVE)
        line.answers.clear()
        async with delivering(desk, line):
            await until(lambda: desk.progress.position == 2)
        assert line.seqs[count:] == [2]

    run(scenario)


def test_a_receiver_that_is_gone_for_good_is_given_up_at_once() -> None:
    async def scenario() -> None:
        desk, line = Desk(2), Line(410)
        desk.add()
        async with delivering(desk, line):
            await until(lambda: bool(desk.failures))
        assert "410" in desk.failures[0]
        assert line.seqs == [1]

    run(scenario)


def test_a_replay_goes_back_even_in_the_middle_of_a_delivery() -> None:
    async def scenario() -> None:
        desk, line = Desk(5), Line()
        desk.add(position=3)
        async with delivering(desk, line) as courier:
            await until(lambda: desk.progress.position == 5)
            desk.events.append(event(6))
            line.gate.clear()
            courier.stir()
            await until(lambda: line.entered == 3)
            desk.replay(1)
            courier.stir()
            line.gate.set()
            await until(lambda: desk.progress.position == 6)
        assert line.seqs == [4, 5, 6, 2, 3, 4, 5, 6]
        numbers = [one.number for one in desk.tries]
        assert numbers == sorted(set(numbers))

    run(scenario)


def test_while_paused_nothing_is_delivered_and_afterwards_it_goes_on_where_it_was() -> None:
    async def scenario() -> None:
        desk, line = Desk(2), Line()
        desk.add()
        async with delivering(desk, line) as courier:
            await until(lambda: desk.progress.position == 2)
            desk.change(state=WebhookState.PAUSED)
            desk.events.append(event(3))
            courier.stir()
            for _ in range(20):
                await asyncio.sleep(0)
            assert line.seqs == [1, 2]
            desk.change(state=WebhookState.ACTIVE)
            courier.stir()
            await until(lambda: desk.progress.position == 3)
        assert line.seqs == [1, 2, 3]

    run(scenario)


def test_another_url_is_tried_at_once_though_the_old_one_is_being_left_alone() -> None:
    async def scenario() -> None:
        desk, line = Desk(1), Line(500)
        desk.add()
        async with delivering(desk, line, Pace(first=1000.0, most=1000.0)) as courier:
            await until(lambda: desk.progress.attempts == 1)
            desk.change(url="http://10.0.0.2/")
            courier.stir()
            await until(lambda: desk.progress.position == 1)
        assert [url for url, _, _ in line.got] == ["http://10.0.0.1/", "http://10.0.0.2/"]
        assert desk.tries[-1].attempt == 1

    run(scenario)


def test_a_ping_goes_beside_the_events_and_is_in_the_log() -> None:
    async def scenario() -> None:
        desk, line = Desk(0), Line(204, 404)
        desk.add(state=WebhookState.PAUSED)
        async with delivering(desk, line) as courier:
            done = await courier.ping(1)
            assert done is not None
            assert (done.event, done.seq, done.status, done.error) == ("Ping", None, 204, "")
            again = await courier.ping(1)
            assert again is not None
            assert again.error == "answered 404"
            assert await courier.ping(2) is None
        assert [one.number for one in desk.tries] == [1, 2]
        assert line.got[0][2]["data"] == {"webhook": 1}

    run(scenario)


def test_events_that_are_no_longer_kept_are_told_of_in_the_log() -> None:
    async def scenario() -> None:
        desk, line = Desk(2, first=10), Line()
        desk.add(position=4)
        async with delivering(desk, line):
            await until(lambda: desk.progress.position == 11)
        assert line.seqs == [10, 11]
        assert desk.tries[0].error == "events 5 to 9 are no longer kept"

    run(scenario)


def test_a_stop_in_the_middle_keeps_what_was_delivered_and_no_more() -> None:
    async def scenario() -> None:
        desk, line = Desk(5), Line()
        desk.add()
        async with delivering(desk, line):
            line.gate.clear()
            await until(lambda: line.entered > 0)
        assert desk.progress.position == line.seqs[-1] if line.seqs else desk.progress.position == 0
        line.gate.set()
        async with delivering(desk, line):
            await until(lambda: desk.progress.position == 5)
        assert sorted(set(line.seqs)) == [1, 2, 3, 4, 5]

    run(scenario)
