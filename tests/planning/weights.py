"""Weights of single edges, for tests of routes."""

from collections.abc import Mapping

import numpy as np

from app.domain.units import Barcode
from app.planning.arcs import EdgeKey
from app.planning.routing import Route, Router
from app.planning.track import Track


def weigh(router: Router, track: Track, seconds: Mapping[EdgeKey, float]) -> None:
    """Let these edges take so long from now on; the others as long as before."""
    free = np.array([track.graph.edges[edge]["time"] for edge in router.edges])
    factors = router.seconds / free
    for edge, time in seconds.items():
        number = router.edges[edge]
        factors[number] = time / free[number]
    router.slow(factors)


def quickest(router: Router, start: Barcode, goal: Barcode) -> Route:
    """Return the quickest route with its times."""
    return router.alternatives(start, goal, 1)[0]
