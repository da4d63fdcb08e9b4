"""``GET /metrics`` and ``/metrics/lines``: figures for Prometheus (``docs/metrics.md``)."""

import asyncio
import time
from collections.abc import Iterable, Iterator
from itertools import chain

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
SLICE = 0.002
"""Seconds of making families after which the loop has its turn. Our choice."""


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
    made = chain(families(controller, request.app.version, controller.utc()), counted.families())
    return await _written(request, await _gathered(made))


@router.get("/lines")
async def show_line_metrics(request: Request, controller: Ctl) -> Response:
    """Give the figures of each line to a vehicle or device."""
    return await _written(request, await _gathered(line_families(controller)))


async def _gathered(made: Iterable[Metric]) -> list[Metric]:
    """Return families that are made on the loop, which has its turn in between: vehicles are not kept waiting for figures."""
    found, since = [], time.perf_counter()
    for family in made:
        found.append(family)
        if time.perf_counter() - since > SLICE:
            await asyncio.sleep(0)
            since = time.perf_counter()
    return found


async def _written(request: Request, found: Iterable[Metric]) -> Response:
    registry = CollectorRegistry()
    registry.register(_Taken(found))
    encoder, kind = choose_encoder(request.headers.get("accept", ""))
    body = await run_in_threadpool(encoder, registry)
    return Response(body, headers={"Content-Type": kind, "Cache-Control": "no-store"})
