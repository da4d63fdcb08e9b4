"""Compiles the fast plant where numba is installed; without it the same functions run as they stand."""

from collections.abc import Callable
from typing import Any, TypeVar

from app.planning import admission

try:
    from numba import njit
    from numba.extending import register_jitable
except ImportError:
    njit = None

Function = TypeVar("Function", bound=Callable[..., Any])
COMPILED = njit is not None
"""Whether the fast plant is compiled."""

if COMPILED:
    for rule in (admission.comes_back, admission.admits, admission.may_want, admission.leave, admission.enter):
        register_jitable(rule)


def compiled(function: Function) -> Function:
    """Return the function compiled when it is first called, or as it is where numba is not installed."""
    return function if njit is None else njit(function)
