"""Doors and buffers for the fleet's tests: real sessions and simulated devices on lines without delay; the toys drive past."""

from collections.abc import Iterator
from typing import TYPE_CHECKING

from app.control.links import devices_on
from app.domain.devices import DeviceEvent, DeviceId, DeviceNotSent, DeviceRequest
from app.domain.ids import LinkId, VehicleId
from app.domain.layout import LinkSpec, Wire
from app.domain.links import LinkSend
from app.domain.units import Barcode
from app.plant.dialects import hall_dialect_of
from app.protocols.enig.session import LinkSession
from app.protocols.enig.simulator import SimulatedBuffer, SimulatedDoor
from app.sim.halls import SimulatedHalls

if TYPE_CHECKING:
    from tests.fleet.script import Script


class ToyHall:
    """The links of a plant. ``violations``: who was on a piece of track whose door was not open, by physical truth."""

    def __init__(self, script: "Script") -> None:
        self.script = script
        self.violations: list[str] = []
        self.heard: list[DeviceEvent] = []
        self._specs = {link.id: link for link in script.plant.links if link.wire is Wire.ENIG}
        self._far = SimulatedHalls(script.plant, {}, script.now)
        self._near: dict[LinkId, LinkSession] = {}
        self._up: set[LinkId] = set()
        self._last: dict[VehicleId, tuple[Barcode, Barcode]] = {}
        self.restart()

    # -- what the tests take hold of ----------------------------------------------------------------------------------

    def door(self, name: str = "DOOR1") -> SimulatedDoor:
        """Return a simulated door."""
        return self._far.doors[DeviceId(name)]

    def buffer(self, name: str = "BUFFER1") -> SimulatedBuffer:
        """Return a simulated buffer."""
        return self._far.buffers[DeviceId(name)]

    def connect(self) -> None:
        """Plug all links in."""
        for link in self._specs:
            self.plug_in(link)

    def plug_in(self, link: LinkId) -> None:
        """Plug one link in."""
        self._up.add(link)
        self._far.lines[link].connected(self.script.now)
        self._near[link].connected(self.script.now)
        self._exchange(link)

    def cut(self, link: str = "HALL") -> None:
        """Cut a link; what its devices do goes on."""
        name = LinkId(link)
        self._up.discard(name)
        self._far.lines[name].disconnected(self.script.now, "cut")
        self._near[name].disconnected(self.script.now, "cut")
        self._tell(name)

    def restart(self) -> None:
        """Another controller has new sessions; the devices live on."""
        for name in self._up:
            self._far.lines[name].disconnected(self.script.now, "killed")
        self._up.clear()
        plant = self.script.plant
        for name, link in self._specs.items():
            self._near[name] = self._session(link)
        assert plant.links

    def _session(self, link: LinkSpec) -> LinkSession:
        plant = self.script.plant
        return LinkSession(devices_on(plant, link), hall_dialect_of(link), places=plant.aliases)

    # -- time and bytes -----------------------------------------------------------------------------------------------

    def take(self, send: LinkSend) -> None:
        """Take a durable command, as ``Control`` does."""
        now, order = self.script.now, send.order
        assert isinstance(order, DeviceRequest)
        if objection := self.script.fleet.device_objection(order):
            self.script.hear_device(DeviceNotSent(order.device, order.id, objection))
            return
        self._near[send.link].send(order, now)
        self._exchange(send.link)

    def step(self) -> None:
        """A moment has passed: devices move, report, and see who drives by."""
        now = self.script.now
        for name, buffer in self._far.buffers.items():
            station = next((s.id for s in self.script.plant.stations if s.buffer == name), None)
            if station is not None and buffer.cart is not (station in self.script.world):
                buffer.set_cart(now, cart=station in self.script.world)
        for link in self._specs:
            self._far.lines[link].tick(now)
            self._exchange(link)
            near = self._near[link]
            if near.deadline is not None and near.deadline <= now:
                near.tick(now)
                self._exchange(link)
        for text in self._looked():
            self.violations.append(f"{now}: {text}")

    def _exchange(self, link: LinkId) -> None:
        near, far, now = self._near[link], self._far.lines[link], self.script.now
        while True:
            out, back = near.outgoing(), far.outgoing()
            if not out and not back:
                break
            if link in self._up:
                far.received(out, now)
                near.received(back, now)
        self._tell(link)

    def _tell(self, link: LinkId) -> None:
        for event in self._near[link].events():
            self.heard.append(event)
            self.script.hear_device(event)

    def _looked(self) -> Iterator[str]:
        """Give who is in a door that is not open: on its way through, or with its length still in it."""
        doors = {passage: self.door(door.id) for door in self.script.plant.doors for passage in door.passages}
        for name, toy in self.script.toys.items():
            before = self._last.get(name)
            if before is None or before[1] != toy.barcode:
                self._last[name] = (before[1] if before else toy.barcode, toy.barcode)
            driven = self._last[name]
            following = next((e.barcode for e in toy.path if e.seq > toy.seq), None) if toy.moving else None
            onto = (toy.barcode, following) if following else None
            for edge in (driven if toy.spec.length else None, onto):
                if edge is not None and (door := doors.get(edge)) is not None and not door.is_open:
                    yield f"{name} is on {edge[0]}-{edge[1]}, where the door is {door.state.name}"
