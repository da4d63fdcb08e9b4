"""A ring with a short and a long branch, and three hoists: what one of them bars can be driven round, or not.

    101 - 102 - 103 - 121..128 - 104 - 105 - 106 - 107 - 110 - 111 - 112 - 113 - 101
                                     \\- 201 - 202 - 203 - 204 - 205 - 206 -/

Ports: P1 at 102, P2 at 106 on the short branch, P3 at 112; a dead end 301, 302 from 111 on with port P4 at 302.
"""

from app.domain.ids import Actor, VehicleId
from app.domain.requests import HoldVehicle, MoveVehicle, ReleaseVehicle, Verdict
from app.domain.units import Barcode
from app.domain.view import ControllerView, Topic
from app.plant import read
from tests.fleet.script import Script

KIM = Actor("kim")
V1, V2, V3 = (VehicleId(f"V00{n}") for n in (1, 2, 3))
PLANT = """
name: branching
barcodes:
  101..103: {from: [0, 0], to: [4000, 0]}
  121..128: {from: [6000, 0], to: [20000, 0]}
  104: [22000, 0]
  105..107: {from: [24000, 0], to: [28000, 0]}
  201..206: {from: [23000, 3000], to: [29000, 3000]}
  110..113: {from: [30000, 0], to: [30000, 9000]}
  301..302: {from: [33000, 6000], to: [35000, 6000]}
track:
  - {through: [101..103, 121..128, 104..107, 110..113]}
  - {through: [113, 101], length: 9000}
  - {through: [104, 201..206, 110], length: 3000}
  - {through: [111, 301, 302], length: 3000}
  - {through: [302, 113], length: 3000}
stations:
  P1: {kind: port, at: 102, dest: {shft: 0, rota: 0, lift: 40000}}
  P2: {kind: port, at: 106, dest: {shft: 0, rota: 0, lift: 40000}}
  P3: {kind: port, at: 112, dest: {shft: 0, rota: 0, lift: 40000}}
  P4: {kind: port, at: 302, dest: {shft: 0, rota: 0, lift: 40000}}
vehicle_defaults: {length: 1100, max_count: 100, max_speed: 3000}
vehicles:
  V001: {dev_id: 1, address: "127.0.0.1:17101", start: 106, offset: {shft: 0, rota: 0, lift: 0}}
  V002: {dev_id: 2, address: "127.0.0.1:17102", start: 101, offset: {shft: 0, rota: 0, lift: 0}}
  V003: {dev_id: 3, address: "127.0.0.1:17103", start: 113, offset: {shft: 0, rota: 0, lift: 0}}
"""


def branching(text: str = PLANT) -> Script:
    """Return the plant with all three connected and idle: V001 on the short branch, V002 at 101, V003 at 113."""
    plant, _ = read(text, "branching.yaml")
    script = Script(plant).obey()
    script.forget()
    return script


def hold(vehicle: VehicleId = V1) -> HoldVehicle:
    return HoldVehicle(KIM, vehicle, "it rattles")


def go_on(vehicle: VehicleId = V1) -> ReleaseVehicle:
    return ReleaseVehicle(KIM, vehicle, Verdict.GO_ON, "looked at")


def go(barcode: str, vehicle: VehicleId = V2) -> MoveVehicle:
    return MoveVehicle(KIM, vehicle, Barcode(barcode))


def controller(script: Script) -> ControllerView:
    view = script.model[Topic.CONTROLLER]["branching"]
    assert isinstance(view, ControllerView)
    return view


def driven(script: Script, vehicle: VehicleId = V2) -> set[str]:
    """Return every barcode that a vehicle was told to drive over since ``forget``."""
    return {barcode for intent in script.kept_intents() if intent.vehicle == vehicle for barcode in intent.path}
