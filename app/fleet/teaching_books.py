"""What is open in teaching: sessions and proposals, and the numbers not yet given."""

from app.domain.ids import StationId, VehicleId
from app.domain.layout import NO_OFFSET, Plant, Station, StationKind
from app.domain.pulses import AxisPulses
from app.domain.records import Kept, TeachingEvent, VehicleOffset
from app.domain.teaching import Proposal, SessionState, TeachingSession
from app.domain.units import Barcode

REMEMBERED = 1000
"""So many teaching events of one connection are told from repetitions (our choice; a set has three)."""


class TeachingBooks:
    """Sessions that are open, proposals that are not over. Changed through ``Books`` alone, which keeps and shows them."""

    def __init__(self, plant: Plant, kept: Kept) -> None:
        self.proposals: dict[int, Proposal] = {p.number: p for p in kept.proposals}
        self.sessions: dict[int, TeachingSession] = {s.number: s for s in kept.sessions}
        self._reference = plant.reference_vehicles
        self._ports: dict[Barcode, list[Station]] = {}
        for station in plant.stations:
            if station.kind is StationKind.PORT:
                self._ports.setdefault(station.barcode, []).append(station)
        self._seen: dict[VehicleId, dict[tuple[object, ...], None]] = {}
        self._next = {"event": kept.next_taught, "proposal": kept.next_proposal, "session": kept.next_session}

    def number(self, what: str) -> int:
        """Return the next number of an ``event``, a ``proposal`` or a ``session``."""
        self._next[what] += 1
        return self._next[what] - 1

    def note_proposal(self, proposal: Proposal) -> None:
        """Take a proposal over as it is now."""
        if proposal.state.over:
            self.proposals.pop(proposal.number, None)
        else:
            self.proposals[proposal.number] = proposal

    def note_session(self, session: TeachingSession) -> None:
        """Take a session over as it is now."""
        if session.state is SessionState.OPEN:
            self.sessions[session.number] = session
        else:
            self.sessions.pop(session.number, None)

    def seen(self, event: TeachingEvent) -> bool:
        """Whether the same event came before on this connection (PROTOCOLS 6.2); from now on it has."""
        known = self._seen.setdefault(event.vehicle, {})
        key = (event.connection, event.cmd_id, event.code, event.position, event.barcode)
        if key in known:
            return True
        if len(known) >= REMEMBERED:
            del known[next(iter(known))]
        known[key] = None
        return False

    def closing(self, station: StationId) -> TeachingSession | None:
        """Return the open session that closes a station to jobs."""
        return next((s for s in self.sessions.values() if s.station == station), None)

    def session_of(self, vehicle: VehicleId) -> TeachingSession | None:
        """Return the open session of a vehicle."""
        return next((s for s in self.sessions.values() if s.vehicle == vehicle), None)

    def ports_at(self, barcode: Barcode) -> list[Station]:
        """Return the ports that are reached from a barcode, in the order of the plant file."""
        return self._ports.get(barcode, [])

    def is_reference(self, vehicle: VehicleId) -> bool:
        """Whether a vehicle's OFFSET is zero by declaration."""
        return vehicle in self._reference

    def offset_of(self, vehicle: VehicleId, taught: VehicleOffset | None) -> AxisPulses | None:
        """Return a vehicle's OFFSET: what was taught, or zero by declaration."""
        if vehicle in self._reference:
            return NO_OFFSET
        return taught.pulses if taught else None
