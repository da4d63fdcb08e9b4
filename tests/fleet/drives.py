"""What the tests of motion share: a vehicle sent somewhere, read by read, by hand."""

from collections.abc import Sequence

from app.domain.commands import Move, Send, Xmove
from app.domain.ids import Actor, VehicleId
from app.domain.layout import StopAction
from app.domain.records import IntentState
from app.domain.requests import MoveVehicle
from app.domain.route import PathElement
from app.domain.units import Barcode
from tests.fleet.script import V1, V2, Script, words

KIM = Actor("kim")
RUN = words(oper=2, trav=8)


def go(ready: Script, barcode: str, vehicle: VehicleId = V1, action: StopAction = StopAction.STOP) -> None:
    """Send a vehicle somewhere."""
    ready.accept(MoveVehicle(KIM, vehicle, Barcode(barcode), action))


def path_of(send: Send) -> tuple[PathElement, ...]:
    """Return the path of a MOVE or XMOVE."""
    assert isinstance(send.command, Move | Xmove)
    return send.command.path


def names(path: Sequence[PathElement]) -> list[str]:
    """Return the barcodes of a path."""
    return [element.barcode for element in path]


def motions(script: Script, vehicle: VehicleId = V1) -> list[Send]:
    """Return the MOVEs and XMOVEs to a vehicle."""
    return [s for s in script.sends if s.vehicle == vehicle and isinstance(s.command, Move | Xmove)]


def last_intent(script: Script, send: Send) -> IntentState:
    """Return the state of a command's intent as last kept."""
    return next(i.state for i in reversed(script.kept_intents()) if i.cmd_id == send.cmd_id)


def driving(ready: Script, goal: str = "116") -> Send:
    """V001 has its MOVE and nobody obeys by itself any more; V002 is out of the way."""
    ready.toys[V2].linked = False
    ready.stand(V2, "117", link=False)
    ready.toys[V1].linked = False
    go(ready, goal)
    move = ready.last(Move, V1)
    ready.acknowledge(move)
    return move


def drive_on(ready: Script, elements: Sequence[PathElement]) -> None:
    """V001 reads these barcodes, one a second."""
    for element in elements:
        ready.wait(1)
        ready.report(V1, element.barcode, RUN, seq=element.seq, polled=False)


def extended(ready: Script, goal: str = "116") -> tuple[Send, Send]:
    """V001 has driven until it was sent an XMOVE; return MOVE and XMOVE."""
    move = driving(ready, goal)
    for element in path_of(move)[1:]:
        drive_on(ready, [element])
        if motions(ready)[-1] is not move:
            break
    return move, ready.last(Xmove, V1)
