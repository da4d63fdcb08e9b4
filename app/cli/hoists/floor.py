"""Simulated hoists in a process of their own: ``python -m app.cli.hoists.floor PLANT SHARE OF``."""

import asyncio
import gc
import sys
from dataclasses import replace

from app.cli.hoists.child import Figures, obey, plant_in, tell
from app.cli.hoists.sampling import Lateness, less, usage
from app.cli.running import on_loop, stop_signal
from app.domain.ids import VehicleId
from app.domain.layout import PulseSet, StationKind
from app.domain.units import Barcode
from app.runtime.clock import Clock
from app.runtime.lines import Line
from app.runtime.transports import DeviceServer
from app.sim.oracle import Oracle
from app.sim.plantworld import SimulatedPlant, starts
from app.sim.truth import Act

LOOK_EVERY = 1.0
"""Seconds between two looks at the rails. Our choice."""


class Obliging:
    """Surroundings without a memory: what one comes for is there. For a share of the hoists, since others move carriers too."""

    def take(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """Give a carrier."""
        return True

    def put(self, vehicle: VehicleId, barcode: Barcode, kind: StationKind, target: PulseSet | None) -> bool:
        """Take the carrier."""
        return True


class Floor:
    """Every ``of``-th hoist of a plant on sockets; where it is the whole plant, the oracle looks on."""

    def __init__(self, file: str, share: int, of: int) -> None:
        plant = plant_in(file)
        placed = starts(plant)
        mine = tuple(replace(v, start=placed[v.id]) for n, v in enumerate(plant.hoists) if n % of == share)
        self._whole = of == 1
        self._clock = Clock().now
        self._plant = SimulatedPlant(
            replace(plant, vehicles=mine),
            self._act,
            now=self._clock(),
            surroundings=None if self._whole else Obliging(),
        )
        self._oracle = Oracle(plant, self._plant.truth) if self._whole else None
        self._servers: list[DeviceServer] = []
        self._before = usage()
        self._late: Lateness | None = None

    def _act(self, act: Act) -> None:
        if self._oracle is not None:
            self._oracle.act(act, self._clock())

    async def serve(self) -> None:
        """Listen for the controller, one port a hoist. Raises OSError."""
        for spec in self._plant.plant.hoists:
            device = self._plant.devices[spec.id]
            line = Line(device, self._clock)
            server = DeviceServer(line, spec.host, spec.port, lambda device=device: not device.accepting)  # type: ignore[misc]
            self._servers.append(server)
            await server.start()

    async def watch(self) -> None:
        """Have the oracle look at the rails now and then."""
        while self._oracle is not None:
            now = self._clock()
            for device in self._plant.devices.values():
                device.tick(now)
            self._oracle.look(self._plant.places(now), self._plant.loaded(), now)
            await asyncio.sleep(LOOK_EVERY)

    def begin(self) -> None:
        """Count from now on."""
        self._before, self._late = usage(), Lateness()

    def end(self) -> Figures:
        """Return CPU, lateness and memory since ``begin``, and what the oracle has seen."""
        now = usage()
        figures: Figures = {**less(now, self._before), "rss": now["rss"]}
        if self._late is not None:
            self._late.stop()
            figures["late"] = self._late.figures()
        if self._oracle is not None:
            figures |= {"violations": self._oracle.violations, "takes": self._oracle.takes, "puts": self._oracle.puts}
        return figures


def main(file: str, share: str, of: str) -> int:
    """Simulate until the parent has its figures."""
    floor = Floor(file, int(share), int(of))

    async def run() -> int:
        stop_signal()
        await floor.serve()
        watching = asyncio.create_task(floor.watch())
        gc.collect()
        gc.freeze()
        tell({"ready": True})
        await obey(floor.begin, floor.end)
        watching.cancel()
        return 0

    return on_loop(run())


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
