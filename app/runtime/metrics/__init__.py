"""Figures of a running controller for Prometheus: counted where things happen, put together when somebody asks.

Nothing here is on a hot path but an addition or two; families are built from the read model at scrape time. Labels are bounded:
by enumerations, by the routes of the API, by the kinds of devices; what is per line has a path of its own (``docs/metrics.md``).
"""

from app.runtime.metrics.families import families, line_families
from app.runtime.metrics.figures import Figures, Measured
from app.runtime.metrics.spread import Spread

__all__ = ["Figures", "Measured", "Spread", "families", "line_families"]
