"""Teaching events into sets, and sets into proposals that a person decides about (DOMAIN section 3, PROTOCOLS I39-I41).

Every event is kept raw before it is acknowledged. Each one but those of an unknown code joins a set, and each set ends in a
state that people see: see :class:`app.domain.teaching.ProposalState`.
"""

from dataclasses import replace

from app.domain.events import Taught, TeachingKind
from app.domain.ids import Actor, CmdId
from app.domain.job import JobEvent
from app.domain.layout import Axis
from app.domain.pulses import known, missing
from app.domain.records import Intent, TeachingEvent
from app.domain.teaching import WINDOW, Proposal, ProposalState, Reading, Side
from app.domain.vehicle import Mode
from app.fleet.assessment import assessed, raw_of
from app.fleet.books import SYSTEM, Books
from app.fleet.vehicle import VehicleNow

SIDES = {Side.DEST.command.value: Side.DEST, Side.OFFSET.command.value: Side.OFFSET}
"""Kinds of intents that ask a vehicle for its axes."""
_AXES = {"shft": Axis.SHFT, "rota": Axis.ROTA, "lift": Axis.LIFT}


class Teaching:
    """Takes teaching events as they come."""

    def __init__(self, books: Books) -> None:
        self._books = books
        self._taught = -1

    # -- events -------------------------------------------------------------------------------------------------------

    def take(self, vehicle: VehicleNow, event: Taught) -> None:
        """Keep an event raw, and put it into its set. A repetition is only acknowledged again."""
        books = self._books
        books.effects.stored.append((vehicle.id, event.receipt))
        side, axis = (None, None) if event.kind is None else _meaning(event.kind)
        asked = self._asked(vehicle, side)
        session = books.teaching.session_of(vehicle.id)
        by = asked.actor if asked else session.actor if session else None
        record = TeachingEvent(
            vehicle=vehicle.id,
            connection=f"{books.epoch}/{event.connection}",
            cmd_id=event.cmd_id,
            code=event.code,
            axis=axis,
            position=event.position,
            barcode=event.barcode,
            at=books.utc,
            number=0,
            asked_by=by,
        )
        if books.teaching.seen(record):
            return
        record = replace(record, number=books.teaching.number("event"))
        books.effects.records.append(record)
        if side is None or axis is None:
            detail = f"code {event.code:04X}, position {event.position}, barcode {event.barcode}: no code of teaching"
            books.event(JobEvent.TEACHING_UNKNOWN, vehicle=vehicle.id, detail=detail)
            return
        self._join(vehicle, side, axis, record, asked)

    def _asked(self, vehicle: VehicleNow, side: Side | None) -> Intent | None:
        """Return the open command that asks for events of this side."""
        found = (i for i in vehicle.opened.values() if SIDES.get(i.kind) is side)
        return next(found, None) if side else None

    def _join(self, vehicle: VehicleNow, side: Side, axis: Axis, event: TeachingEvent, asked: Intent | None) -> None:
        proposal = self._set_for(side, axis, event, asked) or self._new_set(side, event, asked)
        mode = "" if vehicle.mode is None or vehicle.mode is Mode.MANT else vehicle.mode.name
        joined = replace(
            proposal,
            readings=_with(proposal.readings, axis, event),
            at=event.at,
            mode=proposal.mode or mode,
        )
        whole = not missing(raw_of(joined))
        if joined.collecting and whole:
            self._end_set(joined, "")
            return
        kept = self._keep(replace(joined, broken="" if whole else joined.broken))
        if not kept.collecting:
            self._supersede(kept)

    def _set_for(self, side: Side, axis: Axis, event: TeachingEvent, asked: Intent | None) -> Proposal | None:
        """Return the set that this event belongs to, None if it begins one."""
        cmd_id = asked.cmd_id if asked else None
        for proposal in reversed(self._books.teaching.proposals.values()):
            if (proposal.side, proposal.vehicle, proposal.barcode) != (side, event.vehicle, event.barcode):
                continue
            within = event.at - proposal.opened <= WINDOW
            there = next((r for r in proposal.readings if r.axis is axis), None)
            if within and there and (there.cmd_id, there.position) == (event.cmd_id, event.position):
                return proposal
            if cmd_id is None or proposal.asked == cmd_id:
                open_ = proposal.collecting if cmd_id else proposal.collecting and within
                return proposal if open_ or (within and there is None) else None
        return None

    def _new_set(self, side: Side, event: TeachingEvent, asked: Intent | None) -> Proposal:
        teaching = self._books.teaching
        ports = [port.id for port in teaching.ports_at(event.barcode)]
        session = teaching.session_of(event.vehicle)
        if session and session.station not in ports:
            session = None
        station = session.station if session else ports[0] if len(ports) == 1 else None
        return Proposal(
            number=teaching.number("proposal"),
            side=side,
            vehicle=event.vehicle,
            barcode=event.barcode,
            opened=event.at,
            at=event.at,
            station=station,
            session=session.number if session else None,
            asked=asked.cmd_id if asked else None,
            asked_by=event.asked_by,
            revision=0,
        )

    # -- ends of sets -------------------------------------------------------------------------------------------------

    def tick(self) -> None:
        """End the sets whose time is over. One that was asked for all axes is broken off if it lacks some."""
        books = self._books
        for proposal in list(books.teaching.proposals.values()):
            if proposal.collecting and books.utc - proposal.opened > WINDOW and not self._under_way(proposal):
                self._end_set(proposal, "" if proposal.asked is None else f"they did not come within {WINDOW:.0f} s")

    def _under_way(self, proposal: Proposal) -> bool:
        """Whether the command that asked for the set is not answered yet: its events come as quickly as we store them."""
        vehicle = self._books.vehicles.get(proposal.vehicle)
        return vehicle is not None and vehicle.linked and proposal.asked in vehicle.opened

    def answered(self, vehicle: VehicleNow, cmd_id: CmdId, why: str) -> None:
        """A PORT DEST or PORT OFFSET TEACHING is over: no more events come of it. ``why`` is empty where it ended well."""
        for proposal in list(self._books.teaching.proposals.values()):
            if proposal.vehicle == vehicle.id and proposal.collecting and proposal.asked == cmd_id:
                self._end_set(proposal, why or f"{vehicle.id} answered without sending them")

    def lost(self, vehicle: VehicleNow, why: str) -> None:
        """The vehicle is silent: what it was teaching is broken off."""
        for proposal in list(self._books.teaching.proposals.values()):
            if proposal.vehicle == vehicle.id and proposal.collecting:
                self._end_set(proposal, f"{vehicle.id} was lost: {why}")

    def end_sets_of(self, session: int) -> None:
        """The person is done: nothing more is waited for."""
        for proposal in list(self._books.teaching.proposals.values()):
            if proposal.session == session and proposal.collecting:
                self._end_set(proposal, "")

    def _end_set(self, proposal: Proposal, broken: str) -> None:
        ended = replace(proposal, collecting=False, broken=broken if missing(raw_of(proposal)) else "")
        ended = self._keep(ended)
        what = ", ".join(f"{axis.name} {value}" for axis, value in known(raw_of(ended)).items())
        self._books.event(
            JobEvent.TEACHING_TAKEN,
            vehicle=ended.vehicle,
            destination=ended.station,
            result=ended.state.value,
            detail=f"proposal {ended.number}: {ended.side.value} {what} at {ended.barcode}. {ended.why}".rstrip(". "),
        )
        self._supersede(ended)

    def _supersede(self, newer: Proposal) -> None:
        """Older sets about the same port or vehicle with no other axes need no decision, once this one can be decided."""
        if newer.state not in {ProposalState.READY, ProposalState.PENDING}:
            return
        axes = set(known(raw_of(newer)))
        for older in list(self._books.teaching.proposals.values()):
            same = older.vehicle == newer.vehicle if newer.side is Side.OFFSET else older.station == newer.station
            if older.number >= newer.number or older.side is not newer.side or not same or older.collecting:
                continue
            if set(known(raw_of(older))) <= axes:
                self.close(older, ProposalState.SUPERSEDED, SYSTEM, f"by proposal {newer.number}")

    # -- what becomes of them -----------------------------------------------------------------------------------------

    def _keep(self, proposal: Proposal) -> Proposal:
        """Assess and keep a set, if it is not as it was kept last."""
        seen = self._books.teaching.proposals.get(proposal.number)
        now = assessed(self._books, proposal)
        if now == seen:
            return now
        return self._books.save_proposal(replace(now, revision=now.revision + 1))

    def reassess(self) -> None:
        """A DEST or an OFFSET has changed: what could not be derived before may be derivable now."""
        if self._taught != self._books.taught:
            self._taught = self._books.taught
            for proposal in list(self._books.teaching.proposals.values()):
                self._keep(proposal)

    def assign(self, changes: Proposal) -> Proposal:
        """Keep what a person has said of a set."""
        kept = self._keep(changes)
        self._supersede(kept)
        return kept

    def close(
        self, proposal: Proposal, state: ProposalState, actor: Actor, reason: str, version: int | None = None
    ) -> Proposal:
        """Write down how a set ended."""
        return self._books.save_proposal(
            replace(
                proposal,
                state=state,
                collecting=False,
                why="",
                remedy="",
                closed=self._books.utc,
                closed_by=actor,
                reason=reason,
                version=version,
                revision=proposal.revision + 1,
            )
        )


def _meaning(kind: TeachingKind) -> tuple[Side, Axis]:
    """Return what an event is about (I12)."""
    axis, _, side = kind.value.partition("_")
    return Side(side), _AXES[axis]


def _with(readings: tuple[Reading, ...], axis: Axis, event: TeachingEvent) -> tuple[Reading, ...]:
    """Return the readings with this event's: the last position of an axis counts, every event stays named."""
    before = next((r for r in readings if r.axis is axis), None)
    events = (*before.events, event.number) if before else (event.number,)
    found = {r.axis: r for r in readings} | {axis: Reading(axis, event.position, event.cmd_id, events)}
    return tuple(found[one] for one in Axis if one in found)
