"""``hoistway sim --from URL``: a simulated plant that becomes whatever version of the plant its controller activates."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable

from app.cli.layout_versions import VERSIONS, connected
from app.cli.tongue import say
from app.domain.errors import HoistwayError

ASK_EVERY, WITHIN = 1.0, 5.0
"""Seconds between two questions which version is active, and for an answer. Our choice."""


async def follow_controller(url: str, follow: Callable[[str], Awaitable[None]]) -> None:
    """Follow the versions that a controller activates, for ever; while it does not answer, what was followed last goes on."""
    number, told = 0, ""
    while True:
        try:
            active, text = await asyncio.to_thread(newer_than, number, url)
        except HoistwayError as wrong:
            if wrong.message != told:
                say(f"hoistway sim: goes on as it is: {wrong.message}", wrong=True)
            told = wrong.message
        else:
            told = ""
            if text is not None:
                await follow(text)
                say(f"hoistway sim: follows version {active} of the plant")
            number = active
        await asyncio.sleep(ASK_EVERY)


def newer_than(number: int, url: str) -> tuple[int, str | None]:
    """Return which version of the plant is active at a controller, and its text if it is not ``number``.

    Raises Refused, CannotStart: nobody answers there.
    """
    with connected(url, WITHIN) as server:
        active = int(server.active()["number"])
        return active, None if active == number else server.ask("GET", f"{VERSIONS}/{active}/file").text


def is_url(url: str) -> None:
    """See that a URL is one. Raises CannotStart."""
    with connected(url):
        return
