"""What the tests of settlement and roll-call share: what people decide, and what is asked of the fleet afterwards."""

from app.domain.commands import Move
from app.domain.ids import Actor, VehicleId
from app.domain.requests import MoveVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode
from tests.fleet.script import V1, Script

KIM = Actor("kim")


def release(verdict: Verdict = Verdict.GO_ON, barcode: str | None = None, vehicle: VehicleId = V1) -> ReleaseVehicle:
    """Return the decision of a named person."""
    return ReleaseVehicle(KIM, vehicle, verdict, "looked at it", Barcode(barcode) if barcode else None)


def go(barcode: str, vehicle: VehicleId = V1) -> MoveVehicle:
    """Return the order to drive to a barcode."""
    return MoveVehicle(KIM, vehicle, Barcode(barcode))


def held(script: Script, vehicle: VehicleId = V1) -> str:
    """Return why a vehicle is on hold, empty if it is not."""
    hold = script.vehicle(vehicle).record.hold
    assert hold is None or hold.remedy
    return hold.reason if hold else ""


def track_of(script: Script, vehicle: VehicleId = V1) -> set[str]:
    """Return what a vehicle holds."""
    return set(script.fleet.books.traffic.held(vehicle))


def moved(script: Script, vehicle: VehicleId = V1) -> bool:
    """Whether a vehicle was told to move."""
    return any(isinstance(s.command, Move) and s.vehicle == vehicle for s in script.sends)


def picking(script: Script) -> Script:
    """V001 is at the pick-up of J1 at P1."""
    script.order("P1", "P3", vehicle=V1)
    script.run_to("acquiring")
    return script
