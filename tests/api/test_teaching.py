"""Teaching over REST: what is asked of the controller, and what is answered."""

import httpx
import pytest

from app.domain import teaching_requests as t
from app.domain.errors import Refusal
from app.domain.ids import Actor, StationId, VehicleId
from app.domain.teaching import ProposalState, Side
from tests.api.scripted import Scripted

pytestmark = pytest.mark.anyio
KIM = {"X-Actor": "kim"}
WHO = Actor("kim")


async def test_a_session_is_opened_by_a_named_person_alone(client: httpx.AsyncClient, controller: Scripted) -> None:
    body = {"station": "P1", "vehicle": "V001", "note": "new tool"}
    nobody = await client.post("/teaching/sessions", json=body)
    assert (nobody.status_code, nobody.json()["field"]) == (422, "X-Actor")
    answer = await client.post("/teaching/sessions", json=body, headers=KIM)
    assert (answer.status_code, answer.headers["location"]) == (201, "/api/v1/teaching/sessions/1")
    assert controller.seen == [t.OpenTeaching(WHO, StationId("P1"), VehicleId("V001"), "new tool")]
    assert answer.json()["state"] == "open"


async def test_the_session_says_what_to_do_next(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.teach()
    shown = (await client.get("/teaching/sessions/1")).json()
    assert [proposal["id"] for proposal in shown["proposals"]] == [1]
    assert shown["advice"].startswith("proposal 1 is ready")
    controller.reader.proposed = {}
    assert "bring V001 to barcode 1001" in (await client.get("/teaching/sessions/1")).json()["advice"]
    assert (await client.get("/teaching/sessions/9")).status_code == 404
    assert (await client.get("/teaching/sessions/x")).status_code == 422


async def test_starting_gives_the_command_to_look_at(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.teach()
    answer = await client.post("/teaching/sessions/1/start", json={"what": "offset"}, headers=KIM)
    assert answer.status_code == 202
    assert answer.headers["location"].startswith("/api/v1/vehicles/V001/commands/")
    assert controller.seen == [t.StartTeaching(WHO, 1, Side.OFFSET)]
    closed = await client.post("/teaching/sessions/1/close", json={"abandon": True, "reason": "x"}, headers=KIM)
    assert closed.status_code == 200
    assert controller.seen[-1] == t.EndTeaching(WHO, 1, "x", abandon=True)


async def test_a_proposal_shows_what_it_changes_and_how_far_that_is(
    client: httpx.AsyncClient, controller: Scripted
) -> None:
    for lift in (3, 1000):
        await client.put("/stations/P1/dest", json={"shft": 1, "rota": 2, "lift": lift}, headers={"X-Actor": "kim"})
    await client.put("/vehicles/V001/offset", json={"shft": 0, "rota": 0, "lift": 10}, headers={"X-Actor": "kim"})
    controller.teach()
    answer = await client.get("/teaching/proposals/1", params={"lift": 1000})
    shown = answer.json()
    assert answer.headers["etag"] == '"1"'
    assert shown["result"] == {"shft": 1, "rota": 2, "lift": 4}
    assert [(c["station"], c["vehicle"], c["old"]["lift"], c["new"]["lift"]) for c in shown["changes"]] == [
        ("P1", "V001", 1010, 14)
    ]
    assert (shown["present"]["version"], shown["drift"]) == (2, "")
    assert (await client.get("/teaching/proposals/1")).json()["drift"] == "LIFT by -996"
    assert (await client.get("/teaching/proposals/9")).status_code == 404


async def test_decisions_carry_the_revision_that_was_seen(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.teach()
    seen = KIM | {"If-Match": '"4"'}
    body = {"accept": ["incomplete"], "reason": "ok"}
    assert (await client.post("/teaching/proposals/1/approve", json=body, headers=seen)).status_code == 200
    await client.post("/teaching/proposals/1/reject", json={"reason": "askew"}, headers=seen)
    await client.post("/teaching/proposals/1/assign", json={"station": "P2"}, headers=KIM)
    assert controller.seen == [
        t.ApproveProposal(WHO, 1, frozenset({ProposalState.INCOMPLETE}), "ok", 4),
        t.RejectProposal(WHO, 1, "askew", 4),
        t.AssignProposal(WHO, 1, StationId("P2"), None),
    ]
    controller.refusal = Refusal("stale", "it is revision 5 now, not 4", "read it again, then decide", "If-Match")
    stale = await client.post("/teaching/proposals/1/approve", json={}, headers=seen)
    assert (stale.status_code, stale.json()["code"]) == (412, "stale")
    assert (await client.post("/teaching/proposals/1/approve", json={})).status_code == 422


async def test_lists_filter_and_raw_events_are_there_for_ever(client: httpx.AsyncClient, controller: Scripted) -> None:
    controller.teach()
    assert (await client.get("/teaching/proposals", params={"state": "ready"})).json()["items"][0]["id"] == 1
    assert (await client.get("/teaching/proposals", params={"state": "odd"})).status_code == 422
    assert (await client.get("/teaching/sessions", params={"limit": 1})).json()["next"] == 1
    events = (await client.get("/teaching/events", params={"limit": 1})).json()
    assert (events["items"][0]["code"], events["items"][0]["axis"], events["next"]) == ("2074", "lift", 1)
    rest = (await client.get("/teaching/events", params={"after": 1})).json()
    assert (rest["items"][0]["axis"], rest["next"]) == (None, None)
    assert (await client.get("/teaching/events", params={"vehicle": "V9"})).status_code == 404
