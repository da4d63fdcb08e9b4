"""The controller under measurement, as ``hoistway serve`` runs it: ``python -m app.cli.hoists.controller PLANT DATABASE``."""

import asyncio
import sys
import time

from app.cli import hosting
from app.cli.hoists.child import Figures, obey, plant_in, tell
from app.cli.hoists.sampling import Lateness, Sampler, cpu_by_thread, less, usage, waited
from app.cli.running import bound, on_loop, stop_signal
from app.runtime.controller import Controller
from app.runtime.telemetry import set_up
from app.settings import load


class Measured:
    """The figures of the controller's process between ``begin`` and ``end``."""

    def __init__(self) -> None:
        self._controllers: list[Controller] = []
        self._sampler = Sampler()

    def take(self, controller: Controller) -> None:
        """Note whose lines to count."""
        self._controllers.append(controller)

    def begin(self) -> None:
        """Count from now on."""
        self._lines, self._usage, self._threads = self._counted(), usage(), cpu_by_thread()
        self._began, self._waited = time.monotonic(), waited()
        self._late = Lateness()
        self._sampler.start()

    def end(self) -> Figures:
        """Return what was counted."""
        self._sampler.stop()
        self._late.stop()
        now = usage()
        return {
            "seconds": time.monotonic() - self._began,
            "process": less(now, self._usage) | {"rss": now["rss"]},
            "threads": less(cpu_by_thread(), self._threads),
            "parts": dict(self._sampler.parts),
            "late": self._late.figures(),
            "late_own": self._late.own_figures(),
            "waited": waited() - self._waited,
            "lines": less(self._counted(), self._lines),
        }

    def _counted(self) -> dict[str, float]:
        found: dict[str, float] = {}
        for quality in self._controllers[0].line_quality():
            for name in ("connections", "frames_in", "frames_out", "garbled", "resends", "duplicates", "lost_polls"):
                found[name] = found.get(name, 0) + getattr(quality, name)
        return found


def main(file: str, database: str) -> int:
    """Serve until the parent has its figures."""
    set_up(as_json=True, level="error")
    plant = plant_in(file)
    settings = load(database=database, host="127.0.0.1", port=0, log_level="error")
    listening = bound(settings.host, settings.port)
    measured = Measured()

    async def run() -> int:
        stop = stop_signal()
        tasks: list[asyncio.Task[None]] = []

        async def measure() -> None:
            await obey(measured.begin, measured.end)
            stop.set()

        def ready(url: str) -> None:
            tasks.append(asyncio.create_task(measure()))
            tell({"url": url})

        return await hosting.serve(plant, settings, listening, stop, ready, seen=measured.take)

    return on_loop(run())


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
