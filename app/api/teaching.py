"""Teaching sessions and what they propose: open, start, watch, approve, reject (DOMAIN section 3)."""

from typing import Annotated, Literal

from fastapi import APIRouter, Query
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl, Person, answer_of, ask, items, location, missing, read, version_expected
from app.api.declared import gives
from app.api.inputs import After as Above
from app.api.inputs import Limit, QueryId
from app.api.intents import taken
from app.api.port import Controller
from app.api.problems import Problem
from app.api.teaching_answers import detail_of, event_row
from app.api.teaching_inputs import (
    After,
    ApproveIn,
    AssignIn,
    Drift,
    EndIn,
    Number,
    QueryNumber,
    RejectIn,
    SessionIn,
    StartIn,
    most,
)
from app.domain import teaching_requests as requests
from app.domain.ids import StationId, VehicleId
from app.domain.requests import Accepted
from app.domain.teaching import DRIFT, Proposal, ProposalState, SessionState, TeachingSession
from app.domain.view import Topic, VehicleView
from app.fleet.teaching_views import view_of_proposal, view_of_session
from app.runtime.showing import shown

router = APIRouter(prefix="/teaching", tags=["teaching"])
States = Annotated[ProposalState | None, Query()]
SessionStates = Annotated[Literal["open", "closed", "abandoned"] | None, Query()]


# -- sessions ---------------------------------------------------------------------------------------------------------------


@router.get("/sessions", **gives("TeachingSession[]", description="Sessions, newest first."))
async def list_teaching_sessions(
    controller: Ctl,
    state: SessionStates = None,
    station: QueryId = None,
    vehicle: QueryId = None,
    after: After = None,
    limit: Limit = 100,
) -> Response:
    """List teaching sessions; go on with ``after`` = ``next``."""
    found = await read(
        controller.reader.sessions, state=state, station=station, vehicle=vehicle, after=after, limit=limit
    )
    last = found[-1].number if len(found) == limit else None
    return items((shown(view_of_session(session)) for session in found), last)


@router.post("/sessions", **gives("TeachingSessionDetail", 201, "Open; its port is closed to jobs."))
async def open_teaching_session(body: SessionIn, controller: Ctl, actor: Person) -> Response:
    """Open a session: a named person teaches a port with a vehicle. Jobs that need the port wait and say so."""
    asked = requests.OpenTeaching(actor, StationId(body.station), VehicleId(body.vehicle), body.note)
    number = _number(await ask(controller, asked))
    return await _session(controller, number, 201, location("teaching", "sessions", str(number)))


@router.get("/sessions/{session}", **gives("TeachingSessionDetail"))
async def get_teaching_session(session: Number, controller: Ctl) -> Response:
    """Show a session, its proposals, and what to do next."""
    return await _session(controller, session)


@router.post("/sessions/{session}/start", **gives("Taken", 202, "Under way; Location says where to look."))
async def start_teaching(session: Number, body: StartIn, controller: Ctl, actor: Person) -> Response:
    """Ask the vehicle, which stands at the port in MANT, for SHFT, ROTA and LIFT."""
    found = await read(controller.reader.session, session)
    asked = ask(controller, requests.StartTeaching(actor, session, body.side()))
    return await taken("vehicle", found.vehicle if found else "", asked)


@router.post("/sessions/{session}/close", **gives("TeachingSessionDetail"))
async def close_teaching_session(session: Number, body: EndIn, controller: Ctl, actor: Person) -> Response:
    """Close a session: its port is open to jobs again; what it has taught waits for approval unless it is abandoned."""
    await ask(controller, requests.EndTeaching(actor, session, body.reason, body.abandon))
    return await _session(controller, session)


async def _session(
    controller: Controller, number: int, status: int = 200, headers: dict[str, str] | None = None
) -> Response:
    session = await read(controller.reader.session, number)
    if session is None:
        raise Problem(
            "not-found", f"There is no teaching session {number}.", "GET /api/v1/teaching/sessions lists them."
        )
    proposals = await read(controller.reader.proposals, session=number, limit=1000)
    views = [shown(view_of_proposal(proposal)) for proposal in proposals]
    advice = _advice(controller, session, proposals[0] if proposals else None)
    return answer_of({**shown(view_of_session(session)), "proposals": views, "advice": advice}, status, headers)


def _advice(controller: Controller, session: TeachingSession, newest: Proposal | None) -> str:
    """Return what to do next, in one sentence."""
    if newest and not newest.state.over:
        todo = f"proposal {newest.number} is {newest.state.value}"
        return f"{todo}: {newest.why}; {newest.remedy}" if newest.why else f"{todo}: {newest.remedy}"
    if session.state is not SessionState.OPEN:
        return "nothing: the session is over"
    station = controller.plant.station(session.station)
    vehicle = controller.model.get(Topic.VEHICLES, session.vehicle)
    if station is None or not isinstance(vehicle, VehicleView):
        return "close it: its port or vehicle is not in the plant any more"
    if not vehicle.link.up:
        return f"{vehicle.id} is not connected: {vehicle.link.reason}"
    if vehicle.barcode != station.barcode:
        return f"bring {vehicle.id} to barcode {station.barcode}: send it the command move with action port"
    if vehicle.mode != "mant":
        return f"send {vehicle.id} the command stop: it brings it to MANT"
    return "align the hoist over the port, then POST start with dest or offset; or send single axes from the vehicle"


def _number(accepted: Accepted) -> int:
    """Return the number in a key such as ``session-7``."""
    return int(accepted.key.rpartition("-")[2])


# -- proposals --------------------------------------------------------------------------------------------------------------


@router.get("/proposals", **gives("Proposal[]", description="Proposals, newest first."))
async def list_proposals(
    controller: Ctl,
    state: States = None,
    station: QueryId = None,
    vehicle: QueryId = None,
    session: QueryNumber = None,
    after: After = None,
    limit: Limit = 100,
) -> Response:
    """List sets of teaching events and what became of them; go on with ``after`` = ``next``."""
    found = await read(
        controller.reader.proposals,
        state=state,
        station=station,
        vehicle=vehicle,
        session=session,
        after=after,
        limit=limit,
    )
    last = found[-1].number if len(found) == limit else None
    return items((shown(view_of_proposal(proposal)) for proposal in found), last)


@router.get("/proposals/{proposal}", **gives("ProposalDetail", description="ETag: its revision."))
async def get_proposal(
    proposal: Number, controller: Ctl, shft: Drift = DRIFT.shft, rota: Drift = DRIFT.rota, lift: Drift = DRIFT.lift
) -> Response:
    """Show a proposal with every port and vehicle whose pulses it changes, old and new, and whether it is far off."""
    return await _proposal(controller, proposal, shft, rota, lift)


@router.post("/proposals/{proposal}/approve", **gives("ProposalDetail"))
async def approve_proposal(
    proposal: Number, body: ApproveIn, request: Request, controller: Ctl, actor: Person
) -> Response:
    """Make the version that the proposal shows; with If-Match only if nothing has changed since it was looked at."""
    expected = version_expected(request)
    await ask(controller, requests.ApproveProposal(actor, proposal, body.accepted(), body.reason, expected))
    return await _proposal(controller, proposal)


@router.post("/proposals/{proposal}/reject", **gives("ProposalDetail"))
async def reject_proposal(
    proposal: Number, body: RejectIn, request: Request, controller: Ctl, actor: Person
) -> Response:
    """Make nothing of a proposal; its raw events stay."""
    expected = version_expected(request)
    await ask(controller, requests.RejectProposal(actor, proposal, body.reason, expected))
    return await _proposal(controller, proposal)


@router.post("/proposals/{proposal}/assign", **gives("ProposalDetail"))
async def assign_proposal(
    proposal: Number, body: AssignIn, request: Request, controller: Ctl, actor: Person
) -> Response:
    """Say which of several ports at one barcode was taught."""
    expected = version_expected(request)
    await ask(controller, requests.AssignProposal(actor, proposal, StationId(body.station), expected))
    return await _proposal(controller, proposal)


async def _proposal(
    controller: Controller, number: int, shft: int = DRIFT.shft, rota: int = DRIFT.rota, lift: int = DRIFT.lift
) -> Response:
    found = await read(controller.reader.proposal, number)
    if found is None:
        raise Problem("not-found", f"There is no proposal {number}.", "GET /api/v1/teaching/proposals lists them.")
    body = await detail_of(controller, found, most(shft, rota, lift))
    return answer_of(body, headers={"ETag": f'"{found.revision}"'})


# -- raw events -------------------------------------------------------------------------------------------------------------


@router.get("/events", **gives("TeachingEvent[]", description="Raw teaching events, oldest first."))
async def list_teaching_events(
    controller: Ctl, vehicle: QueryId = None, barcode: QueryId = None, after: Above = 0, limit: Limit = 100
) -> Response:
    """List what vehicles sent, as they sent it; go on with ``after`` = ``next``."""
    if vehicle is not None and controller.plant.vehicle(VehicleId(vehicle)) is None:
        missing("vehicle", vehicle)
    found = await read(controller.reader.taught, after, limit, vehicle=vehicle, barcode=barcode)
    last = found[-1].number if len(found) == limit else None
    return items((event_row(event) for event in found), last)
