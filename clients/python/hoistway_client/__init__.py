"""Hoistway from Python: every call of the API with its types, events that go on where they were, and the live stream.

>>> with Hoistway("http://127.0.0.1:8080", actor="mes") as hoistway:  # doctest: +SKIP
...     job = hoistway.create_job({"job_id": "LOT-1", "source": "ETCH01-P1", "destination": "SBB-R4"})
"""

from hoistway_client.client import AsyncHoistway, Hoistway
from hoistway_client.live import Changed, Happened, Live
from hoistway_client.transport import NoController, NotConnected, Problem, TimedOut, Unreachable, Untrusted

__all__ = [
    "AsyncHoistway",
    "Changed",
    "Happened",
    "Hoistway",
    "Live",
    "NoController",
    "NotConnected",
    "Problem",
    "TimedOut",
    "Unreachable",
    "Untrusted",
]
