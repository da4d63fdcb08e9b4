"""Jobs over REST."""

import asyncio
from collections.abc import Sequence
from dataclasses import replace

import httpx
import pytest

from app.domain import requests as r
from app.domain.errors import PlantHeld, Refusal, StoreError
from app.domain.ids import JobId, VehicleId
from app.domain.job import Job, JobState
from app.domain.records import HistoryEvent
from app.domain.statistics import Phase, Transfer
from app.domain.units import Timestamp
from app.domain.why import Candidate, Choice, Why
from tests.api.scripted import Scripted

pytestmark = pytest.mark.anyio
ORDER = {"job_id": "LOT-1", "source": "P1", "destination": "P2", "carrier": "F1"}


async def test_a_new_job_is_answered_201_with_its_place(client: httpx.AsyncClient, controller: Scripted) -> None:
    answer = await client.post("/jobs", json=ORDER, headers={"X-Actor": "mes"})
    assert answer.status_code == 201
    assert answer.headers["location"] == "/api/v1/jobs/LOT-1"
    job = answer.json()
    assert (job["id"], job["state"], job["priority"], job["actor"]) == ("LOT-1", "queued", 50, "mes")
    assert job["created"] == "2026-01-01T00:00:00.000Z"
    request = controller.seen[0]
    assert isinstance(request, r.CreateJob)
    assert request.carrier == "F1"


async def test_the_same_body_again_gives_the_same_job_also_after_its_end(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    await client.post("/jobs", json=ORDER)
    again = await client.post("/jobs", json=ORDER | {"priority": 50})
    assert (again.status_code, again.json()["state"]) == (200, "queued")
    controller.end("LOT-1")
    late = await client.post("/jobs", json=ORDER)
    assert (late.status_code, late.json()["state"]) == (200, "completed")
    assert len(controller.seen) == 1


async def test_another_body_under_the_same_id_is_refused(client: httpx.AsyncClient) -> None:
    await client.post("/jobs", json=ORDER)
    answer = await client.post("/jobs", json=ORDER | {"destination": "L3"})
    assert answer.status_code == 409
    assert answer.headers["content-type"] == "application/problem+json"
    assert answer.json()["code"] == "conflict"
    assert answer.json()["remedy"]


async def test_an_idempotency_key_serves_where_the_body_has_no_id(client: httpx.AsyncClient) -> None:
    order = {"source": "P1", "destination": "P2"}
    first = await client.post("/jobs", json=order, headers={"Idempotency-Key": "k1"})
    again = await client.post("/jobs", json=order, headers={"Idempotency-Key": "k1"})
    other = await client.post("/jobs", json=order | {"priority": 3}, headers={"Idempotency-Key": "k1"})
    fresh = await client.post("/jobs", json=order)
    assert [a.status_code for a in (first, again, other, fresh)] == [201, 200, 409, 201]
    assert first.json()["id"] == again.json()["id"] != fresh.json()["id"]


async def test_a_refusal_says_why_where_and_what_would_help(client: httpx.AsyncClient) -> None:
    answer = await client.post("/jobs", json=ORDER | {"destination": "P9"})
    assert answer.status_code == 422
    assert answer.json() == {
        "type": "/api/v1/problems/invalid",
        "title": "The request says something that cannot be",
        "status": 422,
        "detail": "There is no station P9.",
        "code": "invalid",
        "remedy": "GET /stations",
        "field": "destination",
    }


@pytest.mark.parametrize(
    ("code", "status"),
    [("not-found", 404), ("conflict", 409), ("stale", 412), ("not-now", 409), ("no-route", 422), ("??", 422)],
)
async def test_each_refusal_has_its_status(
    client: httpx.AsyncClient, controller: Scripted, code: str, status: int
) -> None:
    controller.refusal = Refusal(code, "Because.")
    assert (await client.post("/jobs", json=ORDER)).status_code == status


async def test_a_lost_plant_is_a_503_with_its_message(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.refusal = PlantHeld("Another controller holds it.", remedy="Stop one.")
    answer = await client.post("/jobs", json=ORDER)
    assert answer.status_code == 503
    assert (answer.json()["code"], answer.json()["remedy"]) == ("plant-held", "Stop one.")


async def test_a_defect_is_a_500_without_its_insides(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.refusal = RuntimeError("secret")
    answer = await client.post("/jobs", json=ORDER)
    assert answer.status_code == 500
    assert "secret" not in answer.text
    assert answer.json()["code"] == "internal"


async def test_jobs_are_listed_newest_first_in_pages(client: httpx.AsyncClient) -> None:
    for number in range(5):
        await client.post("/jobs", json=ORDER | {"job_id": f"L{number}", "carrier": f"F{number % 2}"})
    first = (await client.get("/jobs", params={"limit": 2})).json()
    assert [job["id"] for job in first["items"]] == ["L4", "L3"]
    rest = (await client.get("/jobs", params={"limit": 9, "after": first["next"]})).json()
    assert [job["id"] for job in rest["items"]] == ["L2", "L1", "L0"]
    assert rest["next"] is None
    some = (await client.get("/jobs", params={"carrier": "F1", "state": "queued"})).json()
    assert [job["id"] for job in some["items"]] == ["L3", "L1"]


async def test_one_job_is_shown_with_its_history_live_or_ended(client: httpx.AsyncClient, controller: Scripted) -> None:
    await client.post("/jobs", json=ORDER)
    controller.happen("VehicleAssigned", "other")
    live = (await client.get("/jobs/LOT-1")).json()
    assert [(e["seq"], e["event"]) for e in live["history"]] == [(1, "TransferInitiated")]
    assert live["history"][0]["ts"] == "2026-01-01T00:00:00.000Z"
    controller.end("LOT-1")
    assert (await client.get("/jobs/LOT-1")).json()["state"] == "completed"
    missing = await client.get("/jobs/LOT-2")
    assert (missing.status_code, missing.json()["code"]) == (404, "not-found")


async def test_a_job_is_changed_aborted_and_cancelled(client: httpx.AsyncClient, controller: Scripted) -> None:
    await client.post("/jobs", json=ORDER)
    assert (await client.patch("/jobs/LOT-1", json={"priority": 90})).json()["priority"] == 90
    assert (await client.patch("/jobs/LOT-1", json={})).status_code == 422
    assert (await client.patch("/jobs/LOT-1", json={"vehicle": None})).status_code == 200
    assert (await client.post("/jobs/LOT-1/abort")).json()["state"] == "aborting"
    wrong = await client.post("/jobs/LOT-1/cancel", json={"why": "wrong lot"})
    assert (wrong.status_code, wrong.json()["field"]) == (422, "why"), "nothing said is dropped"
    cancelled = await client.post("/jobs/LOT-1/cancel", json={"reason": "wrong lot "})
    assert cancelled.json()["state"] == "cancelled"
    late = await client.post("/jobs/LOT-1/cancel")
    assert (late.status_code, late.json()["code"]) == (409, "not-now")
    assert isinstance(controller.seen[1], r.ChangeJob)
    actor = controller.seen[1].actor
    assert controller.seen[2:5] == [
        r.ChangeJob(actor, JobId("LOT-1"), any_vehicle=True),
        r.AbortJob(actor, JobId("LOT-1")),
        r.CancelJob(actor, JobId("LOT-1"), "wrong lot"),
    ]


async def test_the_caller_without_a_name_is_known_by_address(client: httpx.AsyncClient, controller: Scripted) -> None:
    await client.post("/jobs", json=ORDER)
    named = await client.post("/jobs", json=ORDER | {"job_id": "B"}, headers={b"X-Actor": "김철수".encode()})
    assert named.json()["actor"] == "김철수"
    assert [request.actor for request in controller.seen] == ["anonymous@127.0.0.1", "김철수"]


def unread(_after: int, _limit: int) -> Sequence[tuple[int, str]]:
    raise StoreError("The names cannot be read.")


async def test_a_job_is_looked_up_unless_its_name_alone_says_that_it_is_new(
    client: httpx.AsyncClient, controller: Scripted, monkeypatch: pytest.MonkeyPatch
) -> None:
    looked: list[JobId] = []
    lookup = controller.reader.jobs_named

    def noted(names: Sequence[JobId]) -> Sequence[Job]:
        looked.extend(names)
        return lookup(names)

    monkeypatch.setattr(controller.reader, "jobs_named", noted)
    for n in range(100):
        assert (await client.post("/jobs", json=ORDER | {"job_id": f"L{n}"})).status_code == 201
    assert 0 < len(looked) < 50
    looked.clear()
    controller.end("L7")
    again = await client.post("/jobs", json=ORDER | {"job_id": "L7"})
    assert (again.status_code, again.json()["state"], looked) == (200, "completed", ["L7"])


async def test_many_orders_at_once_are_looked_up_together(
    client: httpx.AsyncClient, controller: Scripted, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[int] = []
    lookup = controller.reader.jobs_named

    def counted(names: Sequence[JobId]) -> Sequence[Job]:
        asked.append(len(names))
        return lookup(names)

    monkeypatch.setattr(controller.reader, "jobs_named", counted)
    monkeypatch.setattr(controller.reader, "job_names", unread)
    answers = await asyncio.gather(*(client.post("/jobs", json=ORDER | {"job_id": f"L{n}"}) for n in range(20)))
    assert [answer.status_code for answer in answers] == [201] * 20
    assert sum(asked) == 20
    assert len(asked) < 20


async def test_a_store_that_cannot_be_read_is_a_503(
    client: httpx.AsyncClient, controller: Scripted, monkeypatch: pytest.MonkeyPatch
) -> None:
    def broken(_names: Sequence[JobId]) -> Sequence[Job]:
        raise StoreError("The disk has gone.")

    monkeypatch.setattr(controller.reader, "jobs_named", broken)
    monkeypatch.setattr(controller.reader, "job_names", unread)
    answer = await client.post("/jobs", json=ORDER)
    assert (answer.status_code, answer.json()["detail"]) == (503, "The disk has gone.")
    assert not controller.seen


async def test_a_controller_that_has_stopped_is_a_503_not_a_conflict(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    controller.refusal = Refusal("not-now", "It has stopped.", "Start it.")
    controller.trouble = "The lease ran out."
    answer = await client.post("/jobs", json=ORDER)
    assert (answer.status_code, answer.json()["code"]) == (503, "unavailable")


async def test_no_answer_in_time_is_a_503_that_says_how_to_go_on(
    client: httpx.AsyncClient, controller: Scripted, monkeypatch: pytest.MonkeyPatch
) -> None:
    async def never(_request: r.Request) -> r.Reply:
        raise TimeoutError

    monkeypatch.setattr(controller, "ask", never)
    answer = await client.post("/jobs", json=ORDER)
    assert answer.status_code == 503
    assert "same id or key" in answer.json()["remedy"]


@pytest.mark.parametrize("key", ["a" * 129, "a b", "\x7f", ""])
async def test_an_idempotency_key_is_bounded(client: httpx.AsyncClient, key: str) -> None:
    answer = await client.post("/jobs", json=ORDER, headers={"Idempotency-Key": key})
    assert (answer.status_code, answer.json()["field"]) == (422, "Idempotency-Key")


@pytest.mark.parametrize("name", ["\U0001f600", "로트-1", "LÖT"])
async def test_the_place_of_a_job_is_written_as_a_url(
    client: httpx.AsyncClient, controller: Scripted, name: str
) -> None:
    answer = await client.post("/jobs", json=ORDER | {"job_id": name})
    assert answer.status_code == 201
    assert answer.headers["location"].isascii()
    assert (await client.get(answer.headers["location"].removeprefix("/api/v1"))).json()["id"] == name
    assert (await client.post("/jobs", json=ORDER | {"job_id": name})).headers["location"].isascii()


@pytest.mark.parametrize("name", [".", "..", ".x", "LOT\u202e1", "LOT\u200b1", "LOT\u30001", "LOT\xa01"])
async def test_an_id_has_no_hidden_letters_and_no_first_dot(
    client: httpx.AsyncClient, controller: Scripted, name: str
) -> None:
    answer = await client.post("/jobs", json=ORDER | {"job_id": name})
    assert (answer.status_code, answer.json()["field"]) == (422, "job_id")
    assert not controller.seen


LIFE = (
    ("VehicleAssigned", 10.0),
    ("VehicleUnassigned", 40.0),
    ("VehicleAssigned", 60.0),
    ("VehicleAcquireStarted", 90.0),
    ("VehicleAcquireCompleted", 95.0),
    ("VehicleDepositStarted", 135.0),
    ("VehicleDepositCompleted", 142.0),
    ("TransferCompleted", 143.0),
)
"""A job that got another vehicle, seconds after its acceptance."""


async def test_the_phases_of_a_job_are_those_of_the_statistics_and_begin_with_its_last_vehicle(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    await client.post("/jobs", json=ORDER)
    reader = controller.reader
    begun = reader.kept["LOT-1"].created
    happened = [
        HistoryEvent(seq, Timestamp(begun + after), event, 0, JobId("LOT-1"))
        for seq, (event, after) in enumerate(LIFE, 1)
    ]
    names = ("queued", "fetching", "acquiring", "carrying", "depositing", "total")

    async def phases(state: JobState, events: int, ended: float | None = None) -> list[float | None]:
        over = None if ended is None else Timestamp(begun + ended)
        reader.kept["LOT-1"] = replace(reader.kept["LOT-1"], state=state, ended=over)
        reader.past[:] = happened[:events]
        told = (await client.get("/jobs/LOT-1/why")).json()
        return [told[name] for name in names]

    assert await phases(JobState.QUEUED, 2) == [None] * 6
    assert await phases(JobState.TRANSFERRING, 5) == [60.0, 30.0, 5.0, None, None, None]
    assert await phases(JobState.COMPLETED, 8, ended=143.0) == [60.0, 30.0, 5.0, 40.0, 7.0, 143.0]
    marks = (begun + 60, begun + 90, begun + 95, begun + 135, begun + 142)
    same = Transfer("LOT-1", "completed", None, "P1", "P2", 50, "V1", begun, *marks, begun + 143)
    assert [same.seconds(Phase(name)) for name in names] == [60.0, 30.0, 5.0, 40.0, 7.0, 143.0]


async def test_why_a_job_went_as_it_did_is_told_with_its_vehicles_and_waits(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    await client.post("/jobs", json=ORDER)
    nothing = await client.get("/jobs/LOT-1/why")
    assert (nothing.status_code, nothing.json()["assignments"], nothing.json()["waits"]) == (200, [], [])
    other = Candidate(VehicleId("V2"), 9.5, "is farther")
    choice = Choice(Timestamp(20.0), VehicleId("V1"), 3.5, 50, hot=False, waited=1.2, switch=0.0, candidates=(other,))
    why = (
        Why(1, JobId("LOT-1"))
        .waiting("no vehicle is free", Timestamp(10.0))
        .chosen(choice)
        .waiting("", Timestamp(20.0))
    )
    controller.reader.whys[controller.reader.kept["LOT-1"].order] = why
    told = (await client.get("/jobs/LOT-1/why")).json()
    assert told["waits"] == [
        {
            "since": "1970-01-01T00:00:10.000Z",
            "until": "1970-01-01T00:00:20.000Z",
            "seconds": 10.0,
            "reason": "no vehicle is free",
        }
    ]
    (assignment,) = told["assignments"]
    assert (assignment["vehicle"], assignment["seconds"], assignment["saved"]) == ("V1", 3.5, None)
    assert assignment["candidates"] == [{"vehicle": "V2", "seconds": 9.5, "why_not": "is farther"}]
    assert (await client.get("/jobs/nobody/why")).status_code == 404
