"""Stop one vehicle where it is: it keeps AUTO, and goes on when it is told to (DOMAIN section 7)."""

from app.domain.commands import Plain, Simple
from app.domain.devices import DeviceAct, DeviceId, DeviceRequest, DeviceRequestId
from app.domain.ids import Actor
from app.domain.layout import VehicleKind
from app.domain.links import LinkSend
from app.domain.records import Intent, IntentState
from app.domain.vehicle import Mode
from app.fleet.books import Books
from app.fleet.vehicle import VehicleNow


def halt(books: Books, vehicle: VehicleNow, actor: Actor, why: str) -> Intent | None:
    """Send STOP BY HOST (an AGV: Stop); None if the vehicle is where it cannot be told: silent, or driven by people."""
    if not vehicle.linked:
        return None
    if vehicle.spec.kind is VehicleKind.AGV:
        return _stop_agv(books, vehicle, actor, why)
    if vehicle.mode not in {Mode.AUTO, Mode.SEMI}:
        return None
    stop = Plain.STOP_BY_HOST
    return books.open_intent(vehicle, stop.value, Simple(stop), actor, body={"why": why})


def _stop_agv(books: Books, vehicle: VehicleNow, actor: Actor, why: str) -> Intent | None:
    if vehicle.spec.link is None:
        return None
    act = DeviceAct.STOP
    intent = Intent(books.cmd_ids.next(), vehicle.id, act.value, IntentState.OPEN, books.utc, actor, body={"why": why})
    books.keep_intent(vehicle, intent)
    request = DeviceRequest(DeviceRequestId(intent.cmd_id), DeviceId(vehicle.id), act)
    books.effects.link_sends.append(LinkSend(vehicle.spec.link, request))
    return intent
