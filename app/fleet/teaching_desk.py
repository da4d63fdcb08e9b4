"""What people decide in teaching: approve, reject, assign, roll back, import (DOMAIN section 3)."""

from collections.abc import Callable
from dataclasses import replace

from app.domain.errors import Refusal
from app.domain.ids import StationId, VehicleId
from app.domain.imports import Present, fates
from app.domain.job import JobEvent
from app.domain.layout import StationKind, VehicleKind
from app.domain.pulses import carried_over
from app.domain.records import StationDest, VehicleOffset
from app.domain.requests import Accepted, Reply
from app.domain.teaching import ACCEPTABLE, Fate, ImportRow, Proposal, ProposalState, Side
from app.domain.teaching_requests import (
    ApproveProposal,
    AssignProposal,
    EndTeaching,
    ImportTaught,
    OpenTeaching,
    RejectProposal,
    RollBackDest,
    RollBackOffset,
    StartTeaching,
    TeachingRequest,
)
from app.domain.view import Topic
from app.fleet.assessment import assessed, basis_of
from app.fleet.books import Books
from app.fleet.refusals import no_station, no_vehicle
from app.fleet.teaching import Teaching
from app.fleet.teaching_sessions import TeachingSessions


def stale(expected: int | None, now: int, what: str = "version") -> Refusal | None:
    """Refusal for a writer who has not seen the newest."""
    if expected is None or expected == now:
        return None
    return Refusal("stale", f"it is {what} {now} now, not {expected}", "read it again, then decide", "If-Match")


def reference_refusal(vehicle: str) -> Refusal:
    """Refusal to write an OFFSET that is zero by declaration."""
    return Refusal(
        "conflict",
        f"{vehicle} is a reference vehicle: its OFFSET is zero by the plant file",
        "take `reference` out of the plant file first",
        "vehicle",
    )


class TeachingDesk:
    """Answers every request about teaching."""

    def __init__(self, books: Books, teaching: Teaching, sessions: TeachingSessions) -> None:
        self._books = books
        self._teaching = teaching
        self._sessions = sessions

    def answer(self, request: TeachingRequest) -> Reply:
        """Carry a request out, or refuse it."""
        match request:
            case OpenTeaching():
                return self._sessions.open(request)
            case StartTeaching():
                return self._sessions.start(request)
            case EndTeaching():
                return self._sessions.end(request)
            case ApproveProposal():
                return self._found(request, lambda proposal: self._approve(request, proposal))
            case RejectProposal():
                return self._found(request, lambda proposal: self._reject(request, proposal))
            case AssignProposal():
                return self._found(request, lambda proposal: self._assign(request, proposal))
            case RollBackDest():
                return self._roll_back_dest(request)
            case RollBackOffset():
                return self._roll_back_offset(request)
            case ImportTaught():
                return self._import(request)

    # -- proposals ----------------------------------------------------------------------------------------------------

    def _found(
        self, request: ApproveProposal | RejectProposal | AssignProposal, decide: Callable[[Proposal], Reply]
    ) -> Reply:
        proposal = self._books.teaching.proposals.get(request.proposal)
        if proposal is None:
            return Refusal(
                "conflict",
                f"there is no proposal {request.proposal} that waits for a decision",
                "see GET /api/v1/teaching/proposals",
            )
        return stale(request.expected, proposal.revision, "revision") or decide(proposal)

    def _approve(self, request: ApproveProposal, proposal: Proposal) -> Reply:
        """Make the version that the proposal shows, frozen with what it was derived from (I40)."""
        if odd := request.accept - ACCEPTABLE:
            names = ", ".join(sorted(ACCEPTABLE))
            return Refusal("invalid", f"{min(odd)} cannot be accepted", f"these can: {names}", "accept")
        now = assessed(self._books, proposal, request.accept)
        if now.state is not ProposalState.READY or now.result is None:
            remedy = now.remedy
            if now.state in ACCEPTABLE:
                remedy += f'; or approve with {{"accept": ["{now.state.value}"]}}'
            return Refusal("not-now", f"proposal {now.number} is {now.state.value}: {now.why}", remedy)
        version = self._write(now, request)
        self._teaching.close(now, ProposalState.APPROVED, request.actor, request.reason, version)
        self._books.event(
            JobEvent.TEACHING_APPROVED,
            vehicle=now.vehicle,
            destination=now.station,
            detail=f"proposal {now.number} by {request.actor}: {now.side.value} version {version}",
        )
        return Accepted(Topic.TEACHING, f"proposal-{now.number}")

    def _write(self, now: Proposal, request: ApproveProposal) -> int:
        books, version = self._books, now.base + 1
        if now.result is None or now.station is None:
            raise ValueError(f"proposal {now.number} is not derivable")
        kept = {"basis": basis_of(books, now), "proposal": now.number, "reason": request.reason}
        if now.side is Side.DEST:
            dest = StationDest(now.station, version, now.result, request.actor, "teaching", books.utc)
            books.keep_dest(replace(dest, **kept))  # type: ignore[arg-type]
        else:
            offset = VehicleOffset(now.vehicle, version, now.result, request.actor, "teaching", books.utc)
            books.keep_offset(replace(offset, **kept))  # type: ignore[arg-type]
        return version

    def _reject(self, request: RejectProposal, proposal: Proposal) -> Reply:
        self._teaching.close(proposal, ProposalState.REJECTED, request.actor, request.reason)
        self._books.event(
            JobEvent.TEACHING_REJECTED,
            vehicle=proposal.vehicle,
            destination=proposal.station,
            detail=f"proposal {proposal.number} by {request.actor}: {request.reason}",
        )
        return Accepted(Topic.TEACHING, f"proposal-{proposal.number}")

    def _assign(self, request: AssignProposal, proposal: Proposal) -> Reply:
        ports = [port.id for port in self._books.teaching.ports_at(proposal.barcode)]
        if request.station not in ports:
            there = ", ".join(ports) or "none"
            return Refusal(
                "invalid",
                f"{request.station} is no port at barcode {proposal.barcode}",
                f"ports there: {there}",
                "station",
            )
        self._teaching.assign(replace(proposal, station=request.station))
        return Accepted(Topic.TEACHING, f"proposal-{proposal.number}")

    # -- roll-back ----------------------------------------------------------------------------------------------------

    def _roll_back_dest(self, request: RollBackDest) -> Reply:
        books, now = self._books, self._books.dests.get(request.station)
        if request.station not in books.specs:
            return no_station(request.station)
        version = now.version if now else 0
        if refusal := stale(request.expected, version) or self._no_way_back(request.to.version, version):
            return refusal
        changes = {"version": version + 1, "actor": request.actor, "at": books.utc, "reason": request.reason}
        books.keep_dest(replace(request.to, source="roll-back", restores=request.to.version, **changes))  # type: ignore[arg-type]
        self._note_roll_back(request.summary, request.actor, destination=request.station)
        return Accepted(Topic.STATIONS, request.station)

    def _roll_back_offset(self, request: RollBackOffset) -> Reply:
        books, now = self._books, self._books.offsets.get(request.vehicle)
        if request.vehicle not in books.vehicles:
            return no_vehicle(request.vehicle)
        if books.teaching.is_reference(request.vehicle):
            return reference_refusal(request.vehicle)
        version = now.version if now else 0
        if refusal := stale(request.expected, version) or self._no_way_back(request.to.version, version):
            return refusal
        changes = {"version": version + 1, "actor": request.actor, "at": books.utc, "reason": request.reason}
        books.keep_offset(replace(request.to, source="roll-back", restores=request.to.version, **changes))  # type: ignore[arg-type]
        books.event(
            JobEvent.TEACHING_ROLLED_BACK, vehicle=request.vehicle, detail=f"{request.actor}: {request.summary}"
        )
        return Accepted(Topic.VEHICLES, request.vehicle)

    def _no_way_back(self, to: int, version: int) -> Refusal | None:
        if to < version:
            return None
        return Refusal("invalid", f"version {to} is the present one", "name an older version", "version")

    def _note_roll_back(self, summary: str, actor: str, *, destination: str) -> None:
        self._books.event(JobEvent.TEACHING_ROLLED_BACK, destination=destination, detail=f"{actor}: {summary}")

    # -- import -------------------------------------------------------------------------------------------------------

    def _import(self, request: ImportTaught) -> Reply:
        """All rows, or none: the first that cannot be taken over is the refusal."""
        names, present = self._writable(request.side)
        found = fates(request.side, request.rows, names, present)
        wrong = next((fate for fate in found if fate.fate is Fate.ERROR), None)
        if wrong:
            return Refusal("invalid", f"line {wrong.line}: {wrong.detail}", wrong.remedy, f"line {wrong.line}")
        changed = 0
        for row, fate in zip(request.rows, found, strict=True):
            if fate.fate is not Fate.SAME and fate.version:
                changed += 1
                self._import_row(request, row, fate.version)
        detail = f"{request.actor}: {changed} of {len(found)} rows of {request.side.value} are new versions"
        self._books.event(JobEvent.TEACHING_IMPORTED, detail=detail)
        return Accepted(Topic.TEACHING, f"import of {request.side.value}", fates=tuple(found))

    def _writable(self, side: Side) -> tuple[set[str], Present]:
        books = self._books
        if side is Side.DEST:
            ports: set[str] = {s.id for s in books.plant.stations if s.kind is StationKind.PORT}
            return ports, {d.station: (d.version, d.pulses) for d in books.dests.values()}
        hoists: set[str] = {
            v.id for v in books.plant.vehicles if v.kind is VehicleKind.HOIST and not books.teaching.is_reference(v.id)
        }
        return hoists, {o.vehicle: (o.version, o.pulses) for o in books.offsets.values()}

    def _import_row(self, request: ImportTaught, row: ImportRow, version: int) -> None:
        """Write one row; an axis that it leaves out keeps its value, and what that was derived from."""
        books = self._books
        station, vehicle = StationId(row.name), VehicleId(row.name)
        before = books.dests.get(station) if request.side is Side.DEST else books.offsets.get(vehicle)
        pulses = carried_over(before.pulses if before else None, row.pulses)
        basis = tuple(b for b in before.basis if pulses.of(b.axis) == before.pulses.of(b.axis)) if before else ()
        if request.side is Side.DEST:
            books.keep_dest(StationDest(station, version, pulses, request.actor, "import", books.utc, basis))
        else:
            books.keep_offset(VehicleOffset(vehicle, version, pulses, request.actor, "import", books.utc, basis))
