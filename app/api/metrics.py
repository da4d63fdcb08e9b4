"""``GET /metrics`` and ``/metrics/lines``: figures for Prometheus (``docs/metrics.md``)."""

from collections.abc import Iterable, Iterator

from fastapi import APIRouter
from fastapi.concurrency import run_in_threadpool
from prometheus_client import CollectorRegistry
from prometheus_client.exposition import choose_encoder
from prometheus_client.metrics_core import Metric
from prometheus_client.registry import Collector
from starlette.requests import Request
from starlette.responses import Response

from app.api.calls import Ctl
from app.api.calls_counted import CountedCalls
from app.runtime.metrics import families, line_families

router = APIRouter(prefix="/metrics", include_in_schema=False)


class _Taken(Collector):
    """Families that were made before, on the loop; writing them out is left to a thread."""

    def __init__(self, taken: Iterable[Metric]) -> None:
        self._taken = list(taken)

    def collect(self) -> Iterator[Metric]:
        """Give them."""
        return iter(self._taken)

    def describe(self) -> Iterator[Metric]:
        """Give none: a registry of one collector has no names to keep apart."""
        return iter(())


@router.get("")
async def show_metrics(request: Request, controller: Ctl) -> Response:
    """Give all figures that are not per line."""
    counted: CountedCalls = request.app.state.counted
    found = [*families(controller, request.app.version, controller.utc()), *counted.families()]
    return await _written(request, found)


@router.get("/lines")
async def show_line_metrics(request: Request, controller: Ctl) -> Response:
    """Give the figures of each line to a vehicle or device."""
    return await _written(request, line_families(controller))


async def _written(request: Request, found: Iterable[Metric]) -> Response:
    registry = CollectorRegistry()
    registry.register(_Taken(found))
    encoder, kind = choose_encoder(request.headers.get("accept", ""))
    body = await run_in_threadpool(encoder, registry)
    return Response(body, headers={"Content-Type": kind, "Cache-Control": "no-store"})
