"""The hands at the simulated vehicles: what people do at a real one with its key and its hand controller, over HTTP.

GET  /hoists/V003                                     mode, barcode, pulses
POST /hoists/V003/key    {"mode": "mant"}             turn the key
POST /hoists/V003/jog    {"lift": 41000}              bring axes to positions, pulses; 0 is home
POST /hoists/V003/teach  {"what": "lift_dest"}        send one axis's position to the controller
POST /hoists/V003/alarm  {"alarm": 105}               let it have an alarm; with "stays": true its cause stays
POST /hoists/V003/rail   {"on": false}                take it off the rail; true puts it back where the plant file says
GET  /agvs/AGV1                                       mode, tag
POST /agvs/AGV1/key      {"mode": "manual"}           turn the key
"""

from __future__ import annotations

from collections.abc import Awaitable, Callable, Iterator, Mapping
from contextlib import contextmanager
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar

import msgspec
import uvicorn
from starlette.applications import Starlette
from starlette.responses import JSONResponse, Response
from starlette.routing import Route

from app.domain.devices import AgvMode
from app.domain.ids import VehicleId
from app.domain.layout import Axis
from app.domain.units import Pulses, Seconds
from app.protocols.itsc.messages import Code, Mode

if TYPE_CHECKING:
    from starlette.requests import Request

    from app.protocols.enig.simulator import SimulatedAgv
    from app.protocols.itsc.simulator import SimulatedVehicle
    from app.runtime.lines import Line

Position = Annotated[int, msgspec.Meta(ge=-(1 << 31), le=(1 << 31) - 1)]
Word = TypeVar("Word", bound=msgspec.Struct)
MOST = 1000
"""Longest body, bytes. Our choice."""


class Key(msgspec.Struct, forbid_unknown_fields=True):
    """Where the key is turned to."""

    mode: Literal["mant", "semi", "auto"]


class AgvKey(msgspec.Struct, forbid_unknown_fields=True):
    """Where an AGV's key is turned to: no command of ENIG does it (E21)."""

    mode: Literal["manual", "auto"]


class Rail(msgspec.Struct, forbid_unknown_fields=True):
    """Whether the hoist is on the rail."""

    on: bool


class Jog(msgspec.Struct, forbid_unknown_fields=True):
    """Positions of the axes that are moved by hand."""

    shft: Position | None = None
    rota: Position | None = None
    lift: Position | None = None


class TeachOne(msgspec.Struct, forbid_unknown_fields=True):
    """Which event the hand controller sends."""

    what: Literal["shft_dest", "rota_dest", "lift_dest", "shft_offset", "rota_offset", "lift_offset"]


class Trouble(msgspec.Struct, forbid_unknown_fields=True):
    """Which alarm it gets, and whether what caused it goes on."""

    alarm: Annotated[int, msgspec.Meta(ge=1, le=0xFFFF)]
    stays: bool = False


class Hands:
    """Does at each hoist what it is told, and turns the keys of ``agvs``, which report by themselves.

    ``lines`` are woken after each act, so that what a hoist has to say leaves at once. ``rail`` takes a hoist off the rail
    or puts it back, and gives False where the plant has none of that name.
    """

    def __init__(
        self,
        devices: Mapping[VehicleId, SimulatedVehicle],
        lines: Mapping[VehicleId, Line],
        now: Callable[[], Seconds],
        agvs: Mapping[VehicleId, SimulatedAgv],
        rail: Callable[[VehicleId, bool], Awaitable[bool]],
    ) -> None:
        self._devices = devices
        self._lines = lines
        self._now = now
        self._agvs = agvs
        self._rail = rail

    def application(self) -> Starlette:
        """Return the ASGI application."""
        acts: Mapping[str, tuple[type[msgspec.Struct], Callable[[SimulatedVehicle, Any], None]]] = {
            "key": (Key, self._key),
            "jog": (Jog, self._jog),
            "teach": (TeachOne, self._teach),
            "alarm": (Trouble, self._alarm),
        }
        routes = [Route("/hoists/{name}", self._show)]
        routes += [
            Route(f"/hoists/{{name}}/{act}", self._doing(kind, do), methods=["POST"])
            for act, (kind, do) in acts.items()
        ]
        routes += [
            Route("/hoists/{name}/rail", self._lift_off, methods=["POST"]),
            Route("/agvs/{name}", self._agv),
            Route("/agvs/{name}/key", self._agv, methods=["POST"]),
        ]
        return Starlette(routes=routes)

    def _key(self, device: SimulatedVehicle, word: Key) -> None:
        device.panel_mode(Mode[word.mode.upper()], self._now())

    def _jog(self, device: SimulatedVehicle, word: Jog) -> None:
        for axis in Axis:
            position = getattr(word, axis.value)
            if position is not None:
                device.jog(axis, Pulses(position), self._now())

    def _teach(self, device: SimulatedVehicle, word: TeachOne) -> None:
        device.teach_single(Code[f"{word.what.upper()}_TEACHING"], self._now())

    def _alarm(self, device: SimulatedVehicle, word: Trouble) -> None:
        device.raise_alarm(word.alarm, self._now(), cause_remains=word.stays)

    async def _show(self, request: Request) -> Response:
        device = self._devices.get(VehicleId(request.path_params["name"]))
        return _none(request) if device is None else JSONResponse(_shown(device))

    async def _lift_off(self, request: Request) -> Response:
        """Take a hoist off the rail, or put it back."""
        name = VehicleId(request.path_params["name"])
        try:
            word = msgspec.json.decode((await request.body())[:MOST], type=Rail)
        except (msgspec.DecodeError, ValueError) as wrong:
            return JSONResponse({"detail": str(wrong)}, 422)
        return JSONResponse({"on": word.on}) if await self._rail(name, word.on) else _none(request)

    async def _agv(self, request: Request) -> Response:
        """Show an AGV; turn its key before, if that is what is wanted."""
        name = request.path_params["name"]
        agv = self._agvs.get(VehicleId(name))
        if agv is None:
            return JSONResponse({"detail": f"there is no simulated AGV {name}"}, 404)
        if request.method == "POST":
            try:
                word = msgspec.json.decode((await request.body())[:MOST], type=AgvKey)
            except (msgspec.DecodeError, ValueError) as wrong:
                return JSONResponse({"detail": str(wrong)}, 422)
            agv.set_mode(AgvMode[word.mode.upper()], self._now())
        return JSONResponse({"mode": AgvMode(agv.report.mode).name.lower(), "tag": agv.place(self._now())[0]})

    def _doing(
        self, kind: type[Word], do: Callable[[SimulatedVehicle, Word], None]
    ) -> Callable[[Request], Awaitable[Response]]:
        async def act(request: Request) -> Response:
            name = VehicleId(request.path_params["name"])
            device = self._devices.get(name)
            if device is None:
                return _none(request)
            try:
                body = await request.body()
                do(device, msgspec.json.decode(body[:MOST], type=kind))
            except (msgspec.DecodeError, ValueError) as wrong:
                return JSONResponse({"detail": str(wrong)}, 422)
            if name in self._lines:
                self._lines[name].flush()
            return JSONResponse(_shown(device))

        return act


def _none(request: Request) -> Response:
    return JSONResponse({"detail": f"there is no simulated hoist {request.path_params['name']}"}, 404)


def _shown(device: SimulatedVehicle) -> dict[str, object]:
    state = device.state
    return {
        "mode": state.mode.name.lower(),
        "barcode": state.barcode,
        **{axis.value: state.pulses[axis] for axis in Axis},
    }


class Bench(uvicorn.Server):
    """Serves the hands at one socket; leaves signals to its owner."""

    def __init__(self, hands: Hands) -> None:
        super().__init__(
            uvicorn.Config(
                hands.application(), loop="none", access_log=False, log_config=None, log_level="warning", lifespan="off"
            )
        )

    @contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Leave them."""
        yield
