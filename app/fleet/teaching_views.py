"""How teaching looks to people and hosts (``app.domain.view``)."""

from app.domain.layout import Axis
from app.domain.pulses import AxisPulses, missing, pulses_of
from app.domain.teaching import Proposal, TeachingSession
from app.domain.view import AxesView, ProposalView, TeachingSessionView


def axes_view(pulses: AxisPulses | None) -> AxesView | None:
    """Return pulses as people see them, null where an axis is not known."""
    return None if pulses is None else AxesView(pulses.of(Axis.SHFT), pulses.of(Axis.ROTA), pulses.of(Axis.LIFT))


def view_of_proposal(proposal: Proposal) -> ProposalView:
    """Return a set of teaching events with what would become of it."""
    raw = pulses_of({reading.axis: reading.position for reading in proposal.readings})
    return ProposalView(
        id=proposal.number,
        side=proposal.side.value,
        vehicle=proposal.vehicle,
        barcode=proposal.barcode,
        station=proposal.station,
        session=proposal.session,
        state=proposal.state.value,
        why=proposal.why,
        remedy=proposal.remedy,
        warnings=proposal.warnings,
        raw=AxesView(raw.of(Axis.SHFT), raw.of(Axis.ROTA), raw.of(Axis.LIFT)),
        missing=tuple(axis.value for axis in missing(raw)),
        events=tuple(sorted(number for reading in proposal.readings for number in reading.events)),
        asked=None if proposal.asked is None else f"{proposal.asked:016x}",
        asked_by=proposal.asked_by,
        opened=proposal.opened,
        at=proposal.at,
        result=axes_view(proposal.result),
        base=proposal.base,
        against_version=proposal.against_version,
        closed=proposal.closed,
        closed_by=proposal.closed_by,
        reason=proposal.reason,
        version=proposal.version,
        revision=proposal.revision,
    )


def view_of_session(session: TeachingSession) -> TeachingSessionView:
    """Return a teaching session."""
    return TeachingSessionView(
        id=session.number,
        station=session.station,
        vehicle=session.vehicle,
        actor=session.actor,
        note=session.note,
        state=session.state.value,
        opened=session.opened,
        ended=session.ended,
        ended_by=session.ended_by,
        reason=session.reason,
    )
