"""``hoistway`` that kills itself, as kill -9 would, at one point: ``python -m tests.e2e.killed_at POINT WHEN WORDS…``.

POINT is ``module:Class.method``, WHEN ``before`` or ``after`` its call.
"""

import functools
import importlib
import os
import signal
import sys
from collections.abc import Callable
from inspect import iscoroutinefunction
from typing import Any

from app.cli import app


def deadly(method: Callable[..., Any], when: str) -> Callable[..., Any]:
    """Return the method with the death of its process before or after it."""

    def die() -> None:
        os.kill(os.getpid(), signal.SIGKILL)

    @functools.wraps(method)
    def called(*args: Any, **kwargs: Any) -> Any:
        if when == "before":
            die()
        value = method(*args, **kwargs)
        die()
        return value

    @functools.wraps(method)
    async def awaited(*args: Any, **kwargs: Any) -> Any:
        if when == "before":
            die()
        value = await method(*args, **kwargs)
        die()
        return value

    return awaited if iscoroutinefunction(method) else called


if __name__ == "__main__":
    point, when, *words = sys.argv[1:]
    module, _, name = point.partition(":")
    owner, _, attribute = name.partition(".")
    found = getattr(importlib.import_module(module), owner)
    setattr(found, attribute, deadly(getattr(found, attribute), when))
    app(words)
