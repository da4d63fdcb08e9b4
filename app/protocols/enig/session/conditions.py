"""Wire contents as the domain's words (PROTOCOLS 3.3)."""

from app.domain.devices import (
    AgvMode,
    AgvRun,
    AgvStatus,
    BufferState,
    CartState,
    DeviceStatus,
    DoorState,
    LiftState,
    Steering,
)
from app.domain.units import Barcode
from app.protocols.enig.messages import AgvReport, BufferReport, DoorReport


def status_of(report: AgvReport | BufferReport | DoorReport) -> DeviceStatus:
    """Return a Status in the domain's words; the report must be without problems."""
    match report:
        case BufferReport():
            return BufferState(report.state)
        case DoorReport():
            return DoorState(report.state)
        case _:
            return AgvStatus(
                AgvMode(report.mode),
                AgvRun(report.run),
                Steering(report.direction),
                bool(report.inposition),
                bool(report.charge),
                CartState(report.cart),
                LiftState(report.lift),
                Barcode(report.tag),
                report.path,
            )
