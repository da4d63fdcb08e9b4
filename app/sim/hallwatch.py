"""Judges what is sent to AGVs: nothing moves without a durable intent, and in auto only (QUALITY 2, items 6 and 7)."""

from app.domain.ids import VehicleId
from app.domain.layout import LinkSpec, Plant
from app.plant.dialects import hall_dialect_of
from app.protocols.enig.codec import Codec
from app.protocols.enig.framing import Decoder, Garbled
from app.protocols.enig.messages import (
    AgvReport,
    Body,
    Charge,
    Frame,
    Lift,
    Move,
    MoveAlias,
    MoveAuto,
    MoveManual,
    SetCurrent,
    Toward,
)
from app.sim.oracle import Books, Oracle

KNOWN_AFTER = 0.1
"""Seconds after which the controller must know a mode that the AGV has reported. Our choice: longer than any link here."""
_KINDS: dict[type[Body], frozenset[str]] = {
    Move: frozenset({"move", "xmove"}),
    MoveAlias: frozenset({"agv_move_alias"}),
    MoveAuto: frozenset({"agv_move_auto"}),
    MoveManual: frozenset({"agv_move_manual"}),
    Lift: frozenset({"pickup", "place", "move", "agv_lift"}),
    SetCurrent: frozenset({"agv_set_current"}),
    Charge: frozenset({"agv_charge", "move", "agv_move_alias"}),
}
"""Which intents each command may belong to; a Move ends charging and puts the lift right before it drives."""


class HallWatch:
    """Reads the bytes on one ENIG link, both ways."""

    def __init__(self, plant: Plant, link: LinkSpec, books: Books, oracle: Oracle) -> None:
        codec = Codec(hall_dialect_of(link))
        self._agvs: dict[int, VehicleId] = {spec.dev_id: spec.id for spec in plant.agvs_on(link.id)}
        self._books, self._oracle = books, oracle
        self._sent = Decoder(codec, Toward.DEVICE)
        self._heard = Decoder(codec, Toward.HOST)
        self._modes: dict[VehicleId, tuple[int, float]] = {}

    def passed(self, direction: str, data: bytes, now: float) -> None:
        """Judge what was put on the wire."""
        for item in (self._sent if direction == ">" else self._heard).feed(data):
            if isinstance(item, Garbled) or item.device not in self._agvs:
                continue
            vehicle = self._agvs[item.device]
            if direction == ">":
                self._judge(vehicle, item, now)
            elif isinstance(item.body, AgvReport) and self._modes.get(vehicle, (None,))[0] != item.body.mode:
                self._modes[vehicle] = (item.body.mode, now)

    def _judge(self, vehicle: VehicleId, frame: Frame, now: float) -> None:
        body = frame.body
        kinds = _KINDS.get(type(body))
        if kinds is None:
            return
        intents = [i for i in self._books.open_intents.get(vehicle, {}).values() if i.kind in kinds]
        if isinstance(body, Move):
            intents = [intent for intent in intents if body.tag in intent.path]
        if not intents:
            self._oracle.note(f"{vehicle} was sent {body} without a durable intent", now)
        mode, since = self._modes.get(vehicle, (None, now))
        wrong = 1 if isinstance(body, MoveManual) else 0
        if isinstance(body, Move | MoveAlias | MoveAuto | MoveManual) and mode == wrong and now > since + KNOWN_AFTER:
            self._oracle.note(f"{vehicle} was sent {body} in mode {mode}", now)
